//! Loaded model: mechanism, findings, and the source files with their hashes.

use crate::model::changes::Changes;
use crate::model::record::DiagnosticRecord;
use crate::model::sheet::Sheet;
use nalgebra::Vector3;
use percuss_formats::{
    DEFAULT_MAX_SIZE, FileKind, FileStore, FileSystem, LoadError, LoadOptions, Loaded, MeshFolders,
    NamedPose, OpenFile, Shape, SharedFiles, Source, load,
};
use percuss_mechanism::{BushDescription, ClosureDescription, Mechanism};
use percuss_suspension::{ImportOptions, Imported, LengthUnit, Understood, VehicleAxes};
use schemars::JsonSchema;
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Source file of a result.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Input {
    /// Path as given by the user.
    pub path: String,
    /// SHA-256 of the bytes, in hexadecimal.
    pub sha256: String,
}

impl Input {
    /// Input of a source in memory.
    pub fn from_source(source: &Source) -> Self {
        Self { path: source.file().to_owned(), sha256: hexadecimal(&Sha256::digest(&source.bytes)) }
    }

    /// Input for a file in a store; `None` if the file is unreadable.
    pub(crate) fn from_file(files: &dyn FileStore, path: &Path) -> Option<Self> {
        let mut digest = Sha256::new();
        let OpenFile { mut reader, .. } = files.open(path).ok()?;
        std::io::copy(&mut reader, &mut digest).ok()?;
        Some(Self { path: path.to_string_lossy().into_owned(), sha256: hexadecimal(&digest.finalize()) })
    }
}

/// Error message for a study in the place of a model.
const A_STUDY: &str = "this is a study, which contains the path of its model: use percuss run or percuss \
    compare; give a model or a suspension sheet here";

/// Bytes in hexadecimal.
pub(crate) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Mechanism read from a file.
#[derive(Clone, Debug)]
pub struct Model {
    /// The mechanism.
    pub mechanism: Arc<Mechanism>,
    /// Source files: the model file, and the study file if the study adds parts.
    pub inputs: Vec<Input>,
    /// The shapes of every link, in link order.
    pub shapes: Arc<Vec<Vec<Shape>>>,
    /// Poses that the file names: keyframes of MJCF.
    pub poses: Arc<Vec<NamedPose>>,
    /// Warnings and notes found while reading.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// Origin of the model, for building design variants.
    pub origin: Origin,
}

/// Origin of a model, for building design variants.
#[derive(Clone, Debug, Default)]
pub struct Origin {
    /// Sheet of the suspension before any moves; `None` for a URDF, MJCF or SDF.
    pub(crate) sheet: Option<Arc<OriginSheet>>,
    /// Changes applied.
    pub(crate) changes: Changes,
    /// Loops added by a study.
    pub(crate) closures: Vec<ClosureDescription>,
    /// Bushes added to the model of the file.
    pub(crate) bushes: Vec<BushDescription>,
    /// Store of the model file and of the files that it names.
    pub(crate) files: SharedFiles,
    /// Findings about parts of the file that are no part of a mechanism, in the order of the file.
    pub(crate) unread: Arc<Vec<DiagnosticRecord>>,
}

/// Sheet of a model, with the summary of its import.
#[derive(Debug)]
pub(crate) struct OriginSheet {
    pub sheet: Sheet,
    /// Hardpoints with all moves, unit and axes, lines of the picture, steering axis and forces.
    pub understood: Understood,
}

/// Point in the unit and the axes of a suspension sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetPoint {
    /// Coordinates in the unit.
    pub point: [f64; 3],
    /// Unit normal in the axes of the sheet, if the point is a contact.
    pub normal: Option<[f64; 3]>,
    /// Unit of the sheet.
    pub unit: LengthUnit,
    /// Axes of the sheet.
    pub axes: VehicleAxes,
}

impl Model {
    /// A point of the world (m) in the unit and the axes of the model's suspension sheet; `None` for a URDF.
    pub fn point_in_sheet(&self, point_world: &[f64; 3]) -> Option<SheetPoint> {
        let Understood { unit, axes, .. } = self.origin.sheet.as_deref()?.understood;
        let point = axes.from_iso(Vector3::from(*point_world)).map(|x| unit.of_metres(x));
        Some(SheetPoint { point: point.into(), normal: None, unit, axes })
    }

    /// A direction of the world in the axes of the model's suspension sheet; `None` for a URDF.
    pub fn direction_in_sheet(&self, direction_world: &[f64; 3]) -> Option<[f64; 3]> {
        let axes = self.origin.sheet.as_deref()?.understood.axes;
        Some(axes.from_iso(Vector3::from(*direction_world)).into())
    }

    /// A point of the world (m) and a direction in the unit and the axes of the model's suspension sheet.
    pub fn contact_in_sheet(&self, point_world: &[f64; 3], normal_world: &[f64; 3]) -> Option<SheetPoint> {
        let normal = self.direction_in_sheet(normal_world)?;
        Some(SheetPoint { normal: Some(normal), ..self.point_in_sheet(point_world)? })
    }

    /// Unit of lengths in texts about results: inches for a sheet in inches, otherwise millimetres.
    pub fn length_unit(&self) -> LengthUnit {
        self.origin.sheet.as_ref().map_or(LengthUnit::Millimetre, |sheet| sheet.understood.unit.of_results())
    }

    /// Folders of the model's meshes, with those of packages by name.
    pub(crate) fn mesh_folders(&self, packages: Vec<(String, PathBuf)>) -> MeshFolders {
        let path = self.inputs.first().map_or("", |input| &input.path);
        MeshFolders { files: self.origin.files.clone(), ..MeshFolders::of_model(Path::new(path), packages) }
    }

    /// True for a model read from a suspension's sheet, table or JSON.
    pub fn has_sheet(&self) -> bool {
        self.origin.sheet.is_some()
    }

    /// Reads a URDF, MJCF or SDF file, or a suspension's sheet, table or JSON as in `percuss import`. The file extension
    /// selects a suspension's file, the content URDF, MJCF or SDF; `-` is one of these on the standard input. `max_size`: largest file size,
    /// bytes.
    ///
    /// # Errors
    /// [`LoadError`] with all findings; errors have their file positions.
    pub fn load(path: &str, max_size: u64, options: &LoadOptions) -> Result<Self, LoadError> {
        Self::load_worksheet(path, max_size, options, None)
    }

    /// Reads a file as [`load`](Self::load); `worksheet`: worksheet of a workbook, the first one if `None`.
    ///
    /// # Errors
    /// [`LoadError`], as for [`load`](Self::load); a worksheet for a file that is no workbook.
    pub fn load_worksheet(
        path: &str,
        max_size: u64,
        options: &LoadOptions,
        worksheet: Option<&str>,
    ) -> Result<Self, LoadError> {
        Self::read_source(&Source::read(path, max_size)?, options, worksheet, false)
    }

    /// Reads a file as [`load_worksheet`](Self::load_worksheet) for kinematics: masses, centres of mass and inertias of a sheet may be
    /// missing; they are zero.
    ///
    /// # Errors
    /// [`LoadError`], as for [`load_worksheet`](Self::load_worksheet).
    pub fn load_for_kinematics(
        path: &str,
        max_size: u64,
        options: &LoadOptions,
        worksheet: Option<&str>,
    ) -> Result<Self, LoadError> {
        Self::read_source(&Source::read(path, max_size)?, options, worksheet, true)
    }

    /// Reads a file that another file names, as [`load_worksheet`](Self::load_worksheet), or as
    /// [`load_for_kinematics`](Self::load_for_kinematics) if masses are optional.
    ///
    /// # Errors
    /// [`LoadError`], as for these; a pipe.
    pub(crate) fn load_named(
        path: &str,
        max_size: u64,
        options: &LoadOptions,
        worksheet: Option<&str>,
        masses_optional: bool,
    ) -> Result<Self, LoadError> {
        refuse_pipe(path)?;
        path.rsplit_once('#').map_or(Ok(()), |(file, _)| refuse_pipe(file))?;
        Self::read_source(&Source::read(path, max_size)?, options, worksheet, masses_optional)
    }

    /// Reads a URDF, an MJCF, an SDF or a suspension's sheet from memory.
    ///
    /// # Errors
    /// [`LoadError`], as for [`load`](Self::load).
    pub fn from_source(source: &Source, options: &LoadOptions) -> Result<Self, LoadError> {
        Self::read_source(source, options, None, false)
    }

    fn read_source(
        source: &Source,
        options: &LoadOptions,
        worksheet: Option<&str>,
        masses_optional: bool,
    ) -> Result<Self, LoadError> {
        let input = Input::from_source(source);
        let import = ImportOptions {
            accept: options.accept,
            worksheet: worksheet.map(str::to_owned),
            masses_optional,
            ..ImportOptions::default()
        };
        if Sheet::is_sheet(source) {
            let sheet = Sheet::with_options(source, &import);
            if sheet.is_study() {
                return Err(LoadError::of_file(&source.name, "study", A_STUDY));
            }
            let (mut model, tables) = Self::import_sheet(&sheet, &[], vec![input])?;
            for table in tables.iter().filter(|table| **table != source.name) {
                // The importer has read the same file before.
                model.inputs.push(Input::from_source(&Source::read_from(
                    &source.files,
                    table,
                    DEFAULT_MAX_SIZE,
                )?));
            }
            return Ok(model);
        }
        if let Some(worksheet) = worksheet {
            let message = format!("the worksheet \"{worksheet}\" is given, and the file is no workbook");
            return Err(LoadError::of_file(&source.name, "conflict", &message));
        }
        Ok(Self::from_loaded(load(source, options)?, source))
    }

    /// Model of a source that has been read.
    pub fn from_loaded(loaded: Loaded, source: &Source) -> Self {
        let files = loaded.files.iter().filter_map(|file| Input::from_file(&*source.files, file));
        Self {
            mechanism: Arc::new(loaded.mechanism),
            inputs: [Input::from_source(source)].into_iter().chain(files).collect(),
            shapes: Arc::new(loaded.shapes),
            poses: Arc::new(loaded.poses),
            diagnostics: loaded.diagnostics.into_iter().map(Into::into).collect(),
            origin: Origin {
                files: source.files.clone(),
                unread: Arc::new(loaded.unread.into_iter().map(Into::into).collect()),
                ..Origin::default()
            },
        }
    }

    /// Model of a mechanism without a file.
    pub fn from_mechanism(mechanism: Arc<Mechanism>) -> Self {
        Self {
            mechanism,
            inputs: Vec::new(),
            shapes: Arc::default(),
            poses: Arc::default(),
            diagnostics: Vec::new(),
            origin: Origin::default(),
        }
    }

    /// Model of a suspension file with import options: a sheet, a table of hardpoints, or a file of Chrono::Vehicle.
    ///
    /// # Errors
    /// [`LoadError`]: an invalid file.
    pub fn from_suspension(source: &Source, options: &ImportOptions) -> Result<Self, LoadError> {
        Self::from_sheet(&Sheet::with_options(source, options), &[], vec![Input::from_source(source)])
    }

    /// Model of a sheet with moved hardpoints, without shapes.
    pub(crate) fn from_sheet(
        sheet: &Sheet,
        moves: &[(String, [f64; 3])],
        inputs: Vec<Input>,
    ) -> Result<Self, LoadError> {
        Self::import_sheet(sheet, moves, inputs).map(|(model, _)| model)
    }

    /// Model of a sheet with moved hardpoints, and the names of all files read.
    fn import_sheet(
        sheet: &Sheet,
        moves: &[(String, [f64; 3])],
        inputs: Vec<Input>,
    ) -> Result<(Self, Vec<String>), LoadError> {
        let Imported { mechanism, understood, diagnostics, inputs: names, .. } = sheet.import(moves)?;
        let files = sheet.files().clone();
        let sheet = Some(Arc::new(OriginSheet { sheet: sheet.clone(), understood }));
        let model = Self {
            poses: Arc::default(),
            shapes: Arc::new(vec![Vec::new(); mechanism.links().len()]),
            mechanism: Arc::new(mechanism),
            inputs,
            diagnostics: diagnostics.into_iter().map(Into::into).collect(),
            origin: Origin { sheet, files, ..Origin::default() },
        };
        Ok((model, names))
    }
}

/// Refuses a named pipe or a device, which could wait for its other end. A stream that the process has open, such as /dev/stdin, is read.
pub(crate) fn refuse_pipe(path: &str) -> Result<(), LoadError> {
    let is_open = ["/dev/stdin", "/dev/fd/", "/proc/self/fd/"].iter().any(|open| path.starts_with(open));
    if !is_open && FileSystem.kind(Path::new(path)).is_ok_and(|kind| kind == FileKind::Other) {
        let message = "this is no file, but a pipe or a device; name a file";
        return Err(LoadError::of_file(path, "no-file", message));
    }
    Ok(())
}
