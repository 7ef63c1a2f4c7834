//! Inertia of a link from its shapes.

use crate::hull::collision_shapes;
use crate::meshes::files::{MeshError, MeshFolders, read_mesh_file};
use crate::mjcf::bodies::inertia::{sum, turn};
use crate::mjcf::bodies::mesh::hull_of;
use crate::mjcf::bodies::mesh_inertia::{MeshRule, mesh_inertia};
use crate::mjcf::bodies::solids::unit_inertia;
use crate::reading::limits::MAX_HULL_WORK;
use crate::shape::{Shape, Solid};
use percuss_mechanism::Inertial;
use percuss_spatial::{Matrix3, Vector3};

/// Inertia of the collision shapes of a link, or of its visual shapes if it has no others, in the link frame. Each shape is a solid of the
/// density (kg/m³), a mesh its convex hull; shapes that overlap count twice. `None` without a shape that has a volume. `max_size`: bytes
/// of meshes that are still read.
///
/// # Errors
/// [`MeshError`]: a mesh that is missing, unreadable, invalid, or beyond `max_size`.
pub fn inertia_of_shapes(
    shapes: &[Shape],
    density: f64,
    folders: &MeshFolders,
    max_size: &mut u64,
) -> Result<Option<Inertial>, MeshError> {
    let (mut parts, mut hull_work) = (Vec::new(), MAX_HULL_WORK);
    for shape in collision_shapes(shapes) {
        let frame = &shape.frame;
        if let Some(unit) = unit_inertia(&shape.solid, false) {
            let mass = density * unit.volume;
            let tensor = Matrix3::from_diagonal(&Vector3::from(unit.moments)) * mass;
            parts.push(Inertial { mass, com: frame.translation, about_com: turn(&frame.rotation, &tensor) });
        } else if let Solid::Mesh { file, scale } = &shape.solid {
            let mesh = read_mesh_file(&*folders.files, &folders.find(file)?, *max_size)?;
            *max_size = max_size.saturating_sub(mesh.size);
            let scaled = |corner: [f64; 3]| [0, 1, 2].map(|k| corner[k] * scale[k]);
            let triangles = mesh.triangles.into_iter().map(|corners| corners.map(scaled)).collect();
            // A flat mesh has no hull.
            let Ok(hull) = hull_of(&triangles, &mut hull_work) else { continue };
            let solid = mesh_inertia(&hull, MeshRule::Convex);
            parts.push(Inertial {
                mass: density * solid.volume,
                com: frame.point(&solid.com),
                about_com: turn(&frame.rotation, &(solid.about_com * density)),
            });
        }
    }
    parts.retain(|part| part.mass > 0.0 && part.mass.is_finite());
    Ok(if parts.is_empty() { None } else { Some(sum(&parts)) })
}
