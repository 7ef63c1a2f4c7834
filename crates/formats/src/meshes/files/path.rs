//! Search for the mesh files named by a URDF.

use super::error::MeshError;
use crate::reading::files::SharedFiles;
use std::path::{Path, PathBuf};

/// Folders that are searched for the mesh files of a URDF.
#[derive(Clone, Debug, Default)]
pub struct MeshFolders {
    /// Folder of the URDF; base of relative names.
    pub model: PathBuf,
    /// Package names and their folders.
    pub packages: Vec<(String, PathBuf)>,
    /// Folders that contain packages and models: the entries of ROS_PACKAGE_PATH, `share` in the entries of AMENT_PREFIX_PATH, and
    /// the entries of GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, GAZEBO_MODEL_PATH and SDF_PATH.
    pub holders: Vec<PathBuf>,
    /// Store of files in which the folders are searched.
    pub files: SharedFiles,
}

impl MeshFolders {
    /// Creates the folders for the URDF file `path`, with the given packages (names and folders) and those of the environment
    /// variables.
    pub fn of_model(path: &Path, packages: Vec<(String, PathBuf)>) -> Self {
        let model = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned();
        let folders_in = |name: &str| -> Vec<PathBuf> {
            std::env::var_os(name).map(|value| std::env::split_paths(&value).collect()).unwrap_or_default()
        };
        let mut holders: Vec<PathBuf> = folders_in("ROS_PACKAGE_PATH");
        let prefixes: Vec<PathBuf> = folders_in("AMENT_PREFIX_PATH");
        holders.extend(prefixes.into_iter().map(|prefix| prefix.join("share")));
        for name in ["GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH", "SDF_PATH"] {
            holders.extend(folders_in(name));
        }
        holders.retain(|folder| !folder.as_os_str().is_empty());
        Self { model, packages, holders, files: SharedFiles::default() }
    }

    /// Finds the file of a mesh. `package://NAME/…` and `model://NAME/…` are searched in the given folder of the
    /// package, then in the holders, then upwards from the folder of the URDF, then in the
    /// [package folders](crate::FileStore::package_folders) of the store. `file://…` names a file directly. Other names are relative to
    /// the folder of the URDF.
    ///
    /// # Errors
    /// [`MeshError::NotFound`] with all paths that were tried.
    pub fn find(&self, file: &str) -> Result<PathBuf, MeshError> {
        let mut tried = Vec::new();
        for path in self.candidate_paths(file) {
            if self.files.is_file(&path) {
                return Ok(path);
            }
            tried.push(path);
        }
        Err(MeshError::NotFound { file: file.to_owned(), tried })
    }

    /// Paths at which a file may be, in the order of the search.
    pub(crate) fn candidate_paths(&self, file: &str) -> Vec<PathBuf> {
        let packaged = file.strip_prefix("package://").or_else(|| file.strip_prefix("model://"));
        let Some(rest) = packaged else {
            let plain =
                file.strip_prefix("file://").map(|rest| rest.strip_prefix("localhost").unwrap_or(rest));
            return vec![self.model.join(plain.map_or(file, strip_slash_before_drive))];
        };
        let (name, within) = rest.split_once('/').unwrap_or((rest, ""));
        let mut paths: Vec<PathBuf> = self
            .packages
            .iter()
            .filter(|(given, _)| given == name)
            .map(|(_, folder)| folder.join(within))
            .collect();
        let is_package = |folder: &Path| folder.file_name().is_some_and(|folder_name| folder_name == name);
        for holder in &self.holders {
            if is_package(holder) {
                paths.push(holder.join(within));
            }
            paths.push(holder.join(name).join(within));
        }
        // `dunce` avoids the prefix `\\?\` on Windows, because error messages show the paths.
        let model = self.files.canonical(&self.model).unwrap_or_else(|_| self.model.clone());
        for folder in dunce::simplified(&model).ancestors() {
            if is_package(folder) {
                paths.push(folder.join(within));
            }
            paths.push(folder.join(name).join(within));
        }
        paths.extend(self.files.package_folders(name).into_iter().map(|folder| folder.join(within)));
        paths
    }
}

/// Path of a `file://` name; on Windows, `/C:/…` becomes `C:/…`.
fn strip_slash_before_drive(path: &str) -> &str {
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
        let place = |name: &str| folders.candidate_paths(name).remove(0);
        assert_eq!(place("meshes/tip.stl"), Path::new("models/meshes/tip.stl"));
        for name in ["file:///meshes/tip.stl", "file://localhost/meshes/tip.stl"] {
            assert_eq!(place(name), Path::new("/meshes/tip.stl"), "{name}");
        }
    }
}
