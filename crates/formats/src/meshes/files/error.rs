//! Errors of reading a mesh.

use crate::reading::report::shortened;
use std::path::PathBuf;

/// Reason for failing to read a mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The file does not exist.
    #[error("mesh \"{file}\" was not found; looked for {}{}", list_paths(tried), package_remedy(file))]
    NotFound {
        /// File name in the URDF.
        file: String,
        /// Paths that were tried.
        tried: Vec<PathBuf>,
    },
    /// The file cannot be read.
    #[error("{}: cannot be read: {message}", path.display())]
    Unreadable {
        /// File.
        path: PathBuf,
        /// Message of the operating system.
        message: String,
    },
    /// The file is too large.
    #[error("{}: larger than the limit of {limit} bytes for meshes (--max-mesh-size)", path.display())]
    TooLarge {
        /// File.
        path: PathBuf,
        /// Limit, bytes.
        limit: u64,
    },
    /// The format is not supported.
    #[error(
        "{}: not a mesh that is read: expected STL, OBJ, COLLADA or MSH (.stl, .obj, .dae, .msh); convert it, e.g. with Blender or assimp",
        path.display()
    )]
    Format {
        /// File.
        path: PathBuf,
    },
    /// The contents violate the format.
    #[error("{}: not a good {format} file: {message}", path.display())]
    Malformed {
        /// File.
        path: PathBuf,
        /// Format name.
        format: &'static str,
        /// Defect.
        message: String,
    },
}

/// The first four paths, separated by commas, and the number of the others.
fn list_paths(tried: &[PathBuf]) -> String {
    let shown: Vec<String> = tried.iter().take(4).map(|p| p.display().to_string()).collect();
    match tried.len() {
        0 => "it nowhere".to_owned(),
        n if n > 4 => format!("{} and {} more places", shown.join(", "), n - 4),
        _ => shown.join(", "),
    }
}

/// Remedy for a mesh of a package that was not found; empty for other file names.
fn package_remedy(file: &str) -> &'static str {
    if file.starts_with("package://") || file.starts_with("model://") {
        "; name the package's folder (--package NAME=FOLDER), or set ROS_PACKAGE_PATH"
    } else {
        ""
    }
}

/// Shortened line or word of a mesh file for a message.
pub(super) fn excerpt(bytes: &[u8]) -> String {
    shortened(&String::from_utf8_lossy(&bytes[..bytes.len().min(1000)]))
}
