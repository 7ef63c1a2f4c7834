//! Why a mesh cannot be read.

use std::path::PathBuf;

/// Why a mesh cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// There is no such file.
    #[error("mesh \"{file}\" was not found; looked for {}{}", listed(tried), mend(file))]
    NotFound {
        /// As the URDF names it.
        file: String,
        /// Where it was looked for.
        tried: Vec<PathBuf>,
    },
    /// The file cannot be read.
    #[error("{}: cannot be read: {message}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        message: String,
    },
    /// The file is too large.
    #[error("{}: larger than the limit of {limit} bytes for meshes (--max-mesh-size)", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The limit, bytes.
        limit: u64,
    },
    /// No format that is read.
    #[error(
        "{}: not a mesh that is read: expected STL, OBJ or COLLADA (.stl, .obj, .dae); convert it, e.g. with Blender or assimp",
        path.display()
    )]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// The file breaks its format.
    #[error("{}: not a good {format} file: {message}", path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// Its format.
        format: &'static str,
        /// What is wrong.
        message: String,
    },
}

fn listed(tried: &[PathBuf]) -> String {
    let shown: Vec<String> = tried.iter().take(4).map(|p| p.display().to_string()).collect();
    match tried.len() {
        0 => "it nowhere".to_owned(),
        n if n > 4 => format!("{} and {} more places", shown.join(", "), n - 4),
        _ => shown.join(", "),
    }
}

fn mend(file: &str) -> &'static str {
    if file.starts_with("package://") || file.starts_with("model://") {
        "; name the package's folder (--package NAME=FOLDER), or set ROS_PACKAGE_PATH"
    } else {
        ""
    }
}
