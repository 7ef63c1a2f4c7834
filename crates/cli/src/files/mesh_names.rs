//! Names of mesh files in a written model.

use crate::args::ModelFormat;
use percuss_formats::{MeshFile, MeshFolders};
use std::path::{Path, PathBuf};

/// Mesh files of a model, as a model in another folder and format refers to them.
pub struct MeshNames {
    folders: MeshFolders,
    /// Folder of the written model.
    written: PathBuf,
    format: ModelFormat,
}

impl MeshNames {
    /// Names for the meshes of the model file `model` in the file `written`. `-`: the current folder.
    pub fn new(model: &str, written: &str, format: ModelFormat) -> Self {
        let written = Path::new(written).parent().unwrap_or(Path::new("")).to_owned();
        Self { folders: MeshFolders::of_model(Path::new(model), Vec::new()), written, format }
    }

    /// Name of a mesh in the written model: MuJoCo needs the path of a file, relative to the folder of the model; the other formats keep
    /// names in packages.
    pub fn find(&self, name: &str) -> Result<MeshFile, String> {
        if self.format == ModelFormat::Mjcf {
            let path = self.folders.find(name).map_err(|_| format!("{name}: the file was not found"))?;
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

    /// A path relative to the folder of the written model; the path itself if there is no relative one.
    fn relative(&self, path: &Path) -> String {
        let absolute = |path: &Path| std::path::absolute(path).ok();
        let relative = absolute(path)
            .zip(absolute(&self.written.join(".")))
            .and_then(|(path, folder)| pathdiff::diff_paths(path, folder));
        let text = relative.as_deref().unwrap_or(path).to_string_lossy().into_owned();
        if cfg!(windows) { text.replace('\\', "/") } else { text }
    }
}
