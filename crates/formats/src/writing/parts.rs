//! Input of the writers: a mechanism, the shapes of its links, and its named poses.

use crate::shape::{Shape, Solid};
use crate::writing::state::MechanismState;
use percuss_mechanism::Mechanism;
use std::path::PathBuf;

/// Mesh file that a written model refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshFile {
    /// Name in the written model.
    pub name: String,
    /// Path at which the file was found; `None` if the file was not searched.
    pub path: Option<PathBuf>,
}

/// Function that finds the mesh file for a file name in the source of the model. The error is the reason why the shape is lost.
pub type FindMesh<'a> = &'a dyn Fn(&str) -> Result<MeshFile, String>;

/// Model to be written. `From<&Mechanism>` gives a model without shapes and poses.
#[derive(Clone, Copy)]
pub struct ModelParts<'a> {
    /// Mechanism.
    pub mechanism: &'a Mechanism,
    /// Shapes of each link, in link order; links beyond the end have none.
    pub shapes: &'a [Vec<Shape>],
    /// Finds the mesh files and their names in the written model.
    pub find_mesh: FindMesh<'a>,
    /// Named poses as states. Only the writer of MJCF writes poses; the others report these as lost.
    pub poses: &'a [(String, MechanismState)],
}

impl<'a> From<&'a Mechanism> for ModelParts<'a> {
    fn from(mechanism: &'a Mechanism) -> Self {
        Self { mechanism, shapes: &[], find_mesh: &keep_name, poses: &[] }
    }
}

/// Keeps the name of the source; the file is not searched.
fn keep_name(name: &str) -> Result<MeshFile, String> {
    Ok(MeshFile { name: name.to_owned(), path: None })
}

/// True if all dimensions of a solid are positive and all scale factors of a mesh differ from 0.
pub(crate) fn has_positive_size(solid: &Solid) -> bool {
    match solid {
        Solid::Box { size } => size.iter().all(|edge| *edge > 0.0),
        Solid::Sphere { radius } => *radius > 0.0,
        Solid::Cylinder { radius, length } | Solid::Capsule { radius, length } => {
            *radius > 0.0 && *length > 0.0
        }
        Solid::Mesh { scale, .. } => scale.iter().all(|factor| *factor != 0.0),
    }
}
