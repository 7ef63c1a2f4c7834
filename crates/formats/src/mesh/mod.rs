//! Triangle meshes: STL (binary and ASCII), OBJ, COLLADA. Positions alone are read, in metres.

mod dae;
mod obj;
mod path;
mod stl;

pub use path::MeshFolders;

use crate::limits::MOST_TRIANGLES;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// A mesh file may have this many bytes, 256 MiB, unless the user says otherwise.
pub const DEFAULT_MAX_MESH_SIZE: u64 = 256 << 20;

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

/// Triangles: corners in metres, in the mesh's own frame.
pub type Triangles = Vec<[[f64; 3]; 3]>;

/// Reads a mesh file of at most `max_size` bytes. What it is follows from what it holds, then from its name.
///
/// COLLADA: the transforms of nodes and the unit of length are applied; `up_axis` is not, as RViz does it. Polygons are split
/// into fans. OBJ: polygons too.
///
/// # Errors
/// [`MeshError`]: it cannot be read, is too large, breaks its format, has numbers that are not finite or no triangle.
pub fn read_mesh(path: &Path, max_size: u64) -> Result<Triangles, MeshError> {
    let unreadable =
        |error: std::io::Error| MeshError::Unreadable { path: path.to_owned(), message: error.to_string() };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(unreadable)?;
    file.take(max_size.saturating_add(1)).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > max_size {
        return Err(MeshError::TooLarge { path: path.to_owned(), limit: max_size });
    }
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    let (format, read) = match ending.as_str() {
        "stl" | "stla" | "stlb" => ("STL", stl::read(&bytes)),
        "obj" => ("OBJ", obj::read(&bytes)),
        "dae" => ("COLLADA", dae::read(&bytes)),
        _ => return Err(MeshError::Format { path: path.to_owned() }),
    };
    let malformed = |message: String| MeshError::Malformed { path: path.to_owned(), format, message };
    let triangles = read.map_err(malformed)?;
    if triangles.is_empty() {
        return Err(malformed("it has no triangle".to_owned()));
    }
    let wrong = triangles.iter().flatten().flatten().find(|x| !(x.is_finite() && x.abs() <= 1e30));
    if let Some(x) = wrong {
        return Err(malformed(format!("a coordinate is {x}; a finite number below 1e30 is expected")));
    }
    Ok(triangles)
}

/// Refuses more triangles than are read.
fn bounded(count: usize) -> Result<(), String> {
    if count > MOST_TRIANGLES {
        return Err(format!("more than {MOST_TRIANGLES} triangles; simplify the mesh"));
    }
    Ok(())
}
