//! Readers of triangle meshes: STL (binary and ASCII), OBJ, COLLADA, MSH. Only positions are read, in metres.
//!
//! The crate `mesh-loader` (0.1.13) is not used: it has single precision, and panics or allocates without bound for indices and
//! offsets out of range in COLLADA.

mod dae;
mod error;
mod msh;
mod obj;
mod path;
mod stl;
mod triangles;

pub use error::MeshError;
pub use path::MeshFolders;
pub(crate) use stl::binary_stl_facets;
pub use triangles::Triangles;

use crate::reading::files::{FileKind, FileStore};
use std::path::Path;

/// Default size limit of a mesh file, bytes: 256 MiB.
pub const DEFAULT_MAX_MESH_SIZE: u64 = 256 << 20;

/// Reads a mesh file of at most `max_size` bytes from a store. The format follows from the content, then from the file name.
///
/// In COLLADA files, node transforms and the unit of length are applied; `up_axis` is ignored, as in RViz. Polygons in COLLADA
/// and OBJ files are split into fans of triangles.
///
/// # Errors
/// [`MeshError`]: a file that is unreadable, too large or invalid, numbers that are not finite, or no triangle.
pub fn read_mesh(files: &dyn FileStore, path: &Path, max_size: u64) -> Result<Triangles, MeshError> {
    read_mesh_file(files, path, max_size).map(|file| file.triangles)
}

/// Contents of a mesh file.
pub(crate) struct MeshContents {
    pub triangles: Triangles,
    /// Number of triangles in the first object or group of an OBJ file; of all triangles in other files.
    pub in_first_shape: usize,
    /// Size of the file, bytes.
    pub size: u64,
}

/// As [`read_mesh`], with the size of the file and of its first object.
pub(crate) fn read_mesh_file(
    files: &dyn FileStore,
    path: &Path,
    max_size: u64,
) -> Result<MeshContents, MeshError> {
    let unreadable =
        |error: std::io::Error| MeshError::Unreadable { path: path.to_owned(), message: error.to_string() };
    // A pipe would wait for its other end.
    if files.kind(path).map_err(unreadable)? != FileKind::File {
        return Err(MeshError::Unreadable { path: path.to_owned(), message: "this is no file".to_owned() });
    }
    let bytes = files.read(path, max_size).map_err(unreadable)?;
    if bytes.len() as u64 > max_size {
        return Err(MeshError::TooLarge { path: path.to_owned(), limit: max_size });
    }
    let whole = |triangles: Triangles| {
        let count = triangles.len();
        (triangles, count)
    };
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    let (format, read) = match ending.as_str() {
        "stl" | "stla" | "stlb" => ("STL", stl::read_stl(&bytes).map(whole)),
        "obj" => ("OBJ", obj::read_obj(&bytes)),
        "msh" => ("MSH", msh::read_msh(&bytes).map(whole)),
        "dae" => ("COLLADA", dae::read_collada(&bytes).map(whole)),
        _ => return Err(MeshError::Format { path: path.to_owned() }),
    };
    let malformed = |message: String| MeshError::Malformed { path: path.to_owned(), format, message };
    let (triangles, in_first_shape) = read.map_err(malformed)?;
    if triangles.is_empty() {
        return Err(malformed("it has no triangle".to_owned()));
    }
    let out_of_range = triangles.iter().flatten().flatten().find(|x| !(x.is_finite() && x.abs() <= 1e30));
    if let Some(x) = out_of_range {
        return Err(malformed(format!("a coordinate is {x}; a finite number below 1e30 is expected")));
    }
    Ok(MeshContents { triangles, in_first_shape, size: bytes.len() as u64 })
}
