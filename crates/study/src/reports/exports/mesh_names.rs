//! Names of mesh files in a written model.

use crate::model::loading::Model;
use crate::question::tables::exports::ModelFormat;
use percuss_formats::{MeshFile, MeshFolders};
use std::path::{Path, PathBuf};

/// Finder of the names by which the written model refers to the mesh files of its source.
pub(super) struct MeshNames {
    folders: MeshFolders,
    /// Folder of the written model.
    written: PathBuf,
    format: ModelFormat,
}

impl MeshNames {
    /// Creates the finder for a model and the output file `written`; `-`, the standard output, counts as a file in the current folder.
    pub fn new(model: &Model, written: &str, format: ModelFormat) -> Self {
        let written = Path::new(written).parent().unwrap_or(Path::new("")).to_owned();
        Self { folders: model.mesh_folders(Vec::new()), written, format }
    }

    /// Returns the name of the mesh file `name` in the written model. MJCF: path of the file relative to the written model, because MuJoCo
    /// has no packages. URDF, SDFormat: names in packages become `package://…` and `model://…`; other relative names become relative to
    /// the written model; absolute paths and other URIs are unchanged.
    ///
    /// # Errors
    /// MJCF: no such file.
    pub fn find(&self, name: &str) -> Result<MeshFile, String> {
        if self.format == ModelFormat::Mjcf {
            let path = self.folders.find(name).map_err(|error| error.to_string())?;
            return Ok(MeshFile { name: self.relative(&path), path: Some(path) });
        }
        let in_package = |scheme: &str| name.strip_prefix(scheme);
        let name = match (in_package("package://").or(in_package("model://")), self.format) {
            (Some(rest), ModelFormat::Sdf) => format!("model://{rest}"),
            (Some(rest), _) => format!("package://{rest}"),
            (None, _) if name.contains("://") || Path::new(name).is_absolute() => name.to_owned(),
            (None, _) => self.relative(&self.folders.model.join(name)),
        };
        Ok(MeshFile { name, path: None })
    }

    /// Path relative to the folder of the written model, or `path` if no relative path exists (another drive).
    fn relative(&self, path: &Path) -> String {
        let relative = canonical(path)
            .zip(canonical(&self.written.join("model")))
            .and_then(|(path, model)| pathdiff::diff_paths(path, model.parent()?));
        let text = relative.as_deref().unwrap_or(path).to_string_lossy().into_owned();
        if cfg!(windows) { text.replace('\\', "/") } else { text }
    }
}

/// Absolute path without `..`: the folder that exists, and the rest of the path.
fn canonical(path: &Path) -> Option<PathBuf> {
    let mut rest = Vec::new();
    let mut folder = path;
    loop {
        rest.push(folder.file_name()?);
        folder = folder.parent()?;
        let known = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        if let Ok(found) = dunce::canonicalize(known) {
            return Some(rest.iter().rev().fold(found, |path, part| path.join(part)));
        }
    }
}
