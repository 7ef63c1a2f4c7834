//! A model that was read: the mechanism, what was found, and which bytes it came from.

use crate::changes::Changes;
use crate::record::DiagnosticRecord;
use crate::sheet::Sheet;
use percuss_formats::suspension::Imported;
use percuss_formats::{DEFAULT_MAX_SIZE, LoadError, LoadOptions, Shape, Source, load};
use percuss_mechanism::{ClosureDescription, Mechanism};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::path::Path;
use std::sync::Arc;

/// Which bytes an answer stands on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Input {
    /// The file as the user named it.
    pub path: String,
    /// SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
}

impl Input {
    /// Names a source and its bytes.
    pub fn of(source: &Source) -> Self {
        Self { path: source.name.clone(), sha256: hexadecimal(&Sha256::digest(&source.bytes)) }
    }

    /// Names a file and its bytes; none where it cannot be read.
    pub(crate) fn of_file(path: &Path) -> Option<Self> {
        let mut digest = Sha256::new();
        std::io::copy(&mut std::fs::File::open(path).ok()?, &mut digest).ok()?;
        Some(Self { path: path.to_string_lossy().into_owned(), sha256: hexadecimal(&digest.finalize()) })
    }
}

/// What is said of a study in the place of a model.
const A_STUDY: &str = "this is a study, which names a model of its own: percuss run and percuss compare take it; give the model or \
                       the suspension's sheet here";

/// Bytes in hexadecimal.
pub(crate) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A mechanism read from a file.
#[derive(Clone, Debug)]
pub struct Model {
    /// The mechanism.
    pub mechanism: Arc<Mechanism>,
    /// The files it came from: the model's, and the study's that adds to it.
    pub inputs: Vec<Input>,
    /// The shapes of every link, in link order.
    pub shapes: Arc<Vec<Vec<Shape>>>,
    /// Warnings and notes found while reading.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// What it was made of, to make it again with something changed.
    pub origin: Origin,
}

/// What a model was made of, to make it again with something changed.
#[derive(Clone, Debug, Default)]
pub struct Origin {
    /// The suspension's sheet in memory, without points moved, and the names of its hardpoints; none for a URDF.
    pub(crate) sheet: Option<Arc<(Sheet, Vec<String>)>>,
    /// What was changed.
    pub(crate) changes: Changes,
    /// Loops that a study adds.
    pub(crate) closures: Vec<ClosureDescription>,
}

impl Model {
    /// Reads a URDF file, or a suspension's sheet, table or JSON as `percuss import` does, by the ending of its name; `-` is
    /// the standard input, a URDF. At most `max_size` bytes.
    ///
    /// # Errors
    /// [`LoadError`] with everything that was found, errors with their places.
    pub fn load(path: &str, max_size: u64, options: &LoadOptions) -> Result<Self, LoadError> {
        Self::of(&Source::read(path, max_size)?, options)
    }

    /// Reads a URDF, or the sheet of a suspension, that is at hand already.
    ///
    /// # Errors
    /// [`LoadError`], as for [`load`](Self::load).
    pub fn of(source: &Source, options: &LoadOptions) -> Result<Self, LoadError> {
        let input = Input::of(source);
        if let Some(sheet) = Sheet::of(source, options.accept) {
            if sheet.is_study() {
                return Err(LoadError::of_file(&source.name, "study", A_STUDY));
            }
            let (mut model, tables) = Self::imported(&sheet, &[], vec![input])?;
            for table in tables.iter().filter(|table| **table != source.name) {
                // It was read a moment ago.
                model.inputs.push(Input::of(&Source::read(table, DEFAULT_MAX_SIZE)?));
            }
            return Ok(model);
        }
        let loaded = load(source, options)?;
        Ok(Self {
            mechanism: Arc::new(loaded.mechanism),
            inputs: vec![input],
            shapes: Arc::new(loaded.shapes),
            diagnostics: loaded.diagnostics.into_iter().map(Into::into).collect(),
            origin: Origin::default(),
        })
    }

    /// What is made of a sheet with points moved. It has no shapes.
    pub(crate) fn of_sheet(
        sheet: &Sheet,
        moves: &[(String, [f64; 3])],
        inputs: Vec<Input>,
    ) -> Result<Self, LoadError> {
        Self::imported(sheet, moves, inputs).map(|(model, _)| model)
    }

    /// The same with the names of all files that were read.
    fn imported(
        sheet: &Sheet,
        moves: &[(String, [f64; 3])],
        inputs: Vec<Input>,
    ) -> Result<(Self, Vec<String>), LoadError> {
        let Imported { mechanism, understood, diagnostics, inputs: files, .. } = sheet.import(moves)?;
        let sheet = Some(Arc::new((sheet.clone(), understood.points)));
        let model = Self {
            shapes: Arc::new(vec![Vec::new(); mechanism.links().len()]),
            mechanism: Arc::new(mechanism),
            inputs,
            diagnostics: diagnostics.into_iter().map(Into::into).collect(),
            origin: Origin { sheet, ..Origin::default() },
        };
        Ok((model, files))
    }
}
