//! Where a mesh that a URDF names is to be found.

use super::error::MeshError;
use std::path::{Path, PathBuf};

/// Folders in which meshes are looked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshFolders {
    /// The folder of the URDF: relative names count from here.
    pub model: PathBuf,
    /// Folders of packages by name.
    pub packages: Vec<(String, PathBuf)>,
    /// Folders that hold packages: those of ROS_PACKAGE_PATH, and `share` of those of AMENT_PREFIX_PATH.
    pub holders: Vec<PathBuf>,
}

impl MeshFolders {
    /// Those of a URDF file, with the packages that the environment names.
    pub fn of_model(path: &Path, packages: Vec<(String, PathBuf)>) -> Self {
        let model = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned();
        let paths = |name: &str| {
            std::env::var_os(name).map(|value| std::env::split_paths(&value).collect()).unwrap_or_default()
        };
        let mut holders: Vec<PathBuf> = paths("ROS_PACKAGE_PATH");
        let prefixes: Vec<PathBuf> = paths("AMENT_PREFIX_PATH");
        holders.extend(prefixes.into_iter().map(|prefix| prefix.join("share")));
        holders.retain(|folder| !folder.as_os_str().is_empty());
        Self { model, packages, holders }
    }

    /// The file of a mesh: `package://NAME/…` and `model://NAME/…` in the package's folder, looked for where it is given, in the
    /// holders, then upwards from the URDF's folder; `file://…`; else relative to the URDF's folder.
    ///
    /// # Errors
    /// [`MeshError::NotFound`] with all places that were tried.
    pub fn find(&self, file: &str) -> Result<PathBuf, MeshError> {
        let mut tried = Vec::new();
        for path in self.places(file) {
            if path.is_file() {
                return Ok(path);
            }
            tried.push(path);
        }
        Err(MeshError::NotFound { file: file.to_owned(), tried })
    }

    fn places(&self, file: &str) -> Vec<PathBuf> {
        let packaged = file.strip_prefix("package://").or_else(|| file.strip_prefix("model://"));
        let Some(rest) = packaged else {
            let plain =
                file.strip_prefix("file://").map(|rest| rest.strip_prefix("localhost").unwrap_or(rest));
            return vec![self.model.join(plain.map_or(file, without_root_of_drive))];
        };
        let (name, within) = rest.split_once('/').unwrap_or((rest, ""));
        let mut places: Vec<PathBuf> = self
            .packages
            .iter()
            .filter(|(given, _)| given == name)
            .map(|(_, folder)| folder.join(within))
            .collect();
        let named = |folder: &Path| folder.file_name().is_some_and(|own| own == name);
        for holder in &self.holders {
            if named(holder) {
                places.push(holder.join(within));
            }
            places.push(holder.join(name).join(within));
        }
        // On Windows without `\\?\`, since places that were tried are shown.
        let model = dunce::canonicalize(&self.model).unwrap_or_else(|_| self.model.clone());
        for folder in model.ancestors() {
            if named(folder) {
                places.push(folder.join(within));
            }
            places.push(folder.join(name).join(within));
        }
        places
    }
}

/// The path of a `file://` name: on Windows `/C:/…` is `C:/…`.
fn without_root_of_drive(path: &str) -> &str {
    match path.as_bytes() {
        [b'/', letter, b':', ..] if cfg!(windows) && letter.is_ascii_alphabetic() => &path[1..],
        _ => path,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_places() {
        let folders = MeshFolders { model: PathBuf::from("models"), ..MeshFolders::default() };
        let place = |name: &str| folders.places(name).remove(0);
        assert_eq!(place("meshes/tip.stl"), Path::new("models/meshes/tip.stl"));
        for name in ["file:///meshes/tip.stl", "file://localhost/meshes/tip.stl"] {
            assert_eq!(place(name), Path::new("/meshes/tip.stl"), "{name}");
        }
    }
}
