//! Stores of files: the file system, or files in memory.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::fs::{self, File};
use std::io::{self, Read};
use std::ops::{Bound, Deref};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Kind of the entry at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// Regular file.
    File,
    /// Folder.
    Folder,
    /// Pipe, device, or another entry.
    Other,
}

/// File opened for reading.
pub struct OpenFile<'a> {
    /// Reader of the bytes.
    pub reader: Box<dyn Read + 'a>,
    /// Length, bytes; 0 if unknown.
    pub length: u64,
}

/// Store of files, which are read by their paths.
pub trait FileStore: Debug + Send + Sync {
    /// Kind of the entry at a path, after resolving symbolic links.
    ///
    /// # Errors
    /// [`io::Error`]: no such entry, or no permission to search a folder of the path.
    fn kind(&self, path: &Path) -> io::Result<FileKind>;

    /// Opens a file.
    ///
    /// # Errors
    /// [`io::Error`]: no such file, or no permission.
    fn open(&self, path: &Path) -> io::Result<OpenFile<'_>>;

    /// Canonical path: the same for all paths to one entry.
    ///
    /// # Errors
    /// [`io::Error`]: no such entry; files in memory cause no error.
    fn canonical(&self, path: &Path) -> io::Result<PathBuf>;

    /// Folders of the store that may be the package `name`, the most probable first; empty for the file system, which is not searched.
    fn package_folders(&self, name: &str) -> Vec<PathBuf> {
        let _ = name;
        Vec::new()
    }

    /// True if a regular file exists at the path.
    fn is_file(&self, path: &Path) -> bool {
        self.kind(path).is_ok_and(|kind| kind == FileKind::File)
    }

    /// True if a folder exists at the path.
    fn is_folder(&self, path: &Path) -> bool {
        self.kind(path).is_ok_and(|kind| kind == FileKind::Folder)
    }

    /// Reads at most `max_size` + 1 bytes of a file: more than `max_size` bytes mean that the file is too large.
    ///
    /// # Errors
    /// [`io::Error`]: as for [`open`](Self::open), or a failure while reading.
    fn read(&self, path: &Path, max_size: u64) -> io::Result<Vec<u8>> {
        let OpenFile { reader, length } = self.open(path)?;
        // Memory for a file of known length is allocated at once: a growing vector takes up to twice as much.
        let length = length.min(max_size).saturating_add(1);
        let mut bytes = Vec::with_capacity(usize::try_from(length).unwrap_or(0));
        reader.take(max_size.saturating_add(1)).read_to_end(&mut bytes)?;
        Ok(bytes)
    }
}

/// The file system. Relative paths refer to the current folder.
#[derive(Clone, Copy, Debug, Default)]
pub struct FileSystem;

impl FileStore for FileSystem {
    fn kind(&self, path: &Path) -> io::Result<FileKind> {
        let found = fs::metadata(path)?;
        Ok(match (found.is_file(), found.is_dir()) {
            (true, _) => FileKind::File,
            (_, true) => FileKind::Folder,
            _ => FileKind::Other,
        })
    }

    fn open(&self, path: &Path) -> io::Result<OpenFile<'_>> {
        let file = File::open(path)?;
        let length = file.metadata().map_or(0, |found| found.len());
        Ok(OpenFile { reader: Box::new(file), length })
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        fs::canonicalize(path)
    }
}

/// Files in memory, such as those of a folder that a browser opens. Paths are normalised before they are compared: `.` is removed, and `..`
/// is removed together with the preceding folder.
#[derive(Clone, Debug, Default)]
pub struct MemoryFiles {
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl MemoryFiles {
    /// Store of the given files: path and bytes of each.
    pub fn new(files: impl IntoIterator<Item = (String, Vec<u8>)>) -> Self {
        let files = files.into_iter().map(|(path, bytes)| (normalized(Path::new(&path)), bytes));
        Self { files: files.collect() }
    }

    /// Bytes of a file.
    fn find(&self, path: &Path) -> io::Result<&Vec<u8>> {
        self.files.get(&normalized(path)).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

impl FileStore for MemoryFiles {
    fn kind(&self, path: &Path) -> io::Result<FileKind> {
        let path = normalized(path);
        if self.files.contains_key(&path) {
            return Ok(FileKind::File);
        }
        // Paths are sorted by their components: the paths below a folder directly follow the path of the folder.
        let mut after = self.files.range::<Path, _>((Bound::Included(&*path), Bound::Unbounded));
        match after.next() {
            Some((first, _)) if first.starts_with(&path) => Ok(FileKind::Folder),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    }

    fn open(&self, path: &Path) -> io::Result<OpenFile<'_>> {
        let bytes = self.find(path)?;
        Ok(OpenFile { reader: Box::new(&bytes[..]), length: bytes.len() as u64 })
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        Ok(normalized(path))
    }

    /// Folders with the name of the package; then the top-level folders, because the folder of an unpacked repository can have another
    /// name, such as one with a version.
    fn package_folders(&self, name: &str) -> Vec<PathBuf> {
        let (mut named, mut uppermost) = (Vec::new(), Vec::new());
        for file in self.files.keys() {
            let folders = file.ancestors().skip(1);
            named.extend(folders.filter(|folder| folder.ends_with(name)).map(Path::to_owned));
            let first = file.components().next().map(|first| PathBuf::from(first.as_os_str()));
            uppermost.extend(first.filter(|first| first != file));
        }
        for folders in [&mut named, &mut uppermost] {
            folders.sort();
            folders.dedup();
        }
        named.extend(uppermost);
        named
    }
}

/// Path without `.`, and without each `..` that follows a folder name or the root.
fn normalized(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for component in path.components() {
        match (component, out.components().next_back()) {
            (Component::CurDir, _) | (Component::ParentDir, Some(Component::RootDir)) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => {
                out.pop();
            }
            _ => out.push(component),
        }
    }
    out
}

/// Shared handle of a store; by default the file system.
#[derive(Clone, Debug)]
pub struct SharedFiles(Arc<dyn FileStore>);

impl Default for SharedFiles {
    fn default() -> Self {
        Self(Arc::new(FileSystem))
    }
}

impl From<MemoryFiles> for SharedFiles {
    fn from(files: MemoryFiles) -> Self {
        Self(Arc::new(files))
    }
}

impl Deref for SharedFiles {
    type Target = dyn FileStore;

    fn deref(&self) -> &Self::Target {
        &*self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn store(paths: &[&str]) -> MemoryFiles {
        MemoryFiles::new(paths.iter().map(|path| ((*path).to_owned(), path.as_bytes().to_vec())))
    }

    #[test]
    fn paths_of_an_entry_are_the_same() {
        let files = store(&["robot/urdf/arm.urdf", "robot/urdf-old/arm.urdf", "../up/tip.stl", "/root.stl"]);
        for path in
            ["robot/urdf/arm.urdf", "./robot/urdf/../urdf/./arm.urdf", "robot/meshes/../urdf/arm.urdf"]
        {
            assert_eq!(files.read(Path::new(path), 100).unwrap(), b"robot/urdf/arm.urdf", "{path}");
        }
        for (path, kind) in [
            ("robot", Some(FileKind::Folder)),
            ("robot/urdf", Some(FileKind::Folder)),
            ("", Some(FileKind::Folder)),
            ("robot/urdf/arm.urdf", Some(FileKind::File)),
            ("../up/./tip.stl", Some(FileKind::File)),
            ("/../root.stl", Some(FileKind::File)),
            ("rob", None),
            ("robot/urdf/arm", None),
            ("tip.stl", None),
        ] {
            assert_eq!(files.kind(Path::new(path)).ok(), kind, "{path}");
        }
        assert_eq!(files.read(Path::new("robot/urdf/arm.urdf"), 4).unwrap(), b"robot", "4 bytes and one");
        assert_eq!(files.open(Path::new("robot")).err().unwrap().kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn packages_are_folders_of_their_name_or_the_uppermost() {
        let files =
            store(&["ws-1.2/arm/meshes/tip.stl", "ws-1.2/arm/urdf/arm.urdf", "ws-1.2/old/arm/tip.stl"]);
        let folders = files.package_folders("arm");
        assert_eq!(folders, ["ws-1.2/arm", "ws-1.2/old/arm", "ws-1.2"].map(PathBuf::from));
        assert!(FileSystem.package_folders("arm").is_empty());
    }
}
