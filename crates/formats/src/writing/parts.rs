//! What the writers write: a mechanism, the shapes of its links, and its named poses.

use crate::urdf::elements::shapes::shape::{Shape, Solid};
use crate::writing::state::MechanismState;
use percuss_mechanism::Mechanism;
use std::path::PathBuf;

/// Mesh file that a written model refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshFile {
    /// Name in the written model.
    pub name: String,
    /// The file itself, if it was found.
    pub path: Option<PathBuf>,
}

/// Mesh file for the name that the source of a model uses, or the reason for its loss.
pub type FindMesh<'a> = &'a dyn Fn(&str) -> Result<MeshFile, String>;

/// Model to be written. `From<&Mechanism>` gives a model without shapes and poses.
#[derive(Clone, Copy)]
pub struct ModelParts<'a> {
    /// Mechanism.
    pub mechanism: &'a Mechanism,
    /// Shapes of each link, in link order; links beyond the end have none.
    pub shapes: &'a [Vec<Shape>],
    /// Names of mesh files in the written model.
    pub find_mesh: FindMesh<'a>,
    /// Named poses. Only MJCF has these.
    pub poses: &'a [(String, MechanismState)],
}

impl<'a> From<&'a Mechanism> for ModelParts<'a> {
    fn from(mechanism: &'a Mechanism) -> Self {
        Self { mechanism, shapes: &[], find_mesh: &keep_name, poses: &[] }
    }
}

/// The name as it is in the source.
fn keep_name(name: &str) -> Result<MeshFile, String> {
    Ok(MeshFile { name: name.to_owned(), path: None })
}

/// True if no length of a solid and no scale factor of a mesh is 0.
pub(crate) fn has_extent(solid: &Solid) -> bool {
    match solid {
        Solid::Box { size } => size.iter().all(|edge| *edge > 0.0),
        Solid::Sphere { radius } => *radius > 0.0,
        Solid::Cylinder { radius, length } | Solid::Capsule { radius, length } => {
            *radius > 0.0 && *length > 0.0
        }
        Solid::Mesh { scale, .. } => scale.iter().all(|factor| *factor != 0.0),
    }
}
