//! Shapes of links: `<visual>` and `<collision>`. The mechanics do not depend on them, so no finding here is an
//! error.

use crate::reading::limits::MAX_SHAPE_SIZE;
use crate::shape::{Purpose, Shape, Solid};
use crate::urdf::elements::numbers::parse_numbers;
use crate::urdf::elements::origin::rotation_from_any_quaternion;
use crate::urdf::elements::survey::{child, children};
use nalgebra::Vector3;
use percuss_spatial::{Transform, rotation_from_rpy};
use roxmltree::Node;

/// Shapes of a link: collision shapes first, then visual shapes, each in the order of the file. Shapes with invalid
/// numbers are left out; `geometry.rs` warns about them.
pub(crate) fn link_shapes<'a, 'i: 'a>(link: Node<'a, 'i>) -> Vec<Shape> {
    let mut found = Vec::new();
    for (name, purpose) in [("collision", Purpose::Collision), ("visual", Purpose::Visual)] {
        for holder in children(link, name) {
            let Some(geometry) = child(holder, "geometry") else { continue };
            let Some(frame) = shape_frame(holder) else { continue };
            let solids = geometry.children().filter(Node::is_element).filter_map(read_solid);
            found.extend(solids.map(|solid| Shape { purpose, solid, frame }));
        }
    }
    found
}

/// N numbers of an attribute, at most `MAX_SHAPE_SIZE`; `None` if absent or invalid.
fn bounded_numbers<const N: usize>(node: Node<'_, '_>, attribute: &str) -> Option<[f64; N]> {
    let values = parse_numbers::<N>(node.attribute(attribute)?).ok()?;
    values.iter().all(|v| v.abs() <= MAX_SHAPE_SIZE).then_some(values)
}

/// As [`bounded_numbers`], but `default` if the attribute is absent.
fn bounded_numbers_or<const N: usize>(
    node: Node<'_, '_>,
    attribute: &str,
    default: [f64; N],
) -> Option<[f64; N]> {
    node.attribute(attribute).map_or(Some(default), |_| bounded_numbers(node, attribute))
}

/// Solid in its own frame; `None` if invalid or of an unknown kind.
fn read_solid(shape: Node<'_, '_>) -> Option<Solid> {
    let radius_and_length = || {
        Some((
            bounded_numbers::<1>(shape, "radius")?[0].abs(),
            bounded_numbers::<1>(shape, "length")?[0].abs(),
        ))
    };
    Some(match shape.tag_name().name() {
        "box" => Solid::Box { size: bounded_numbers(shape, "size")?.map(f64::abs) },
        "sphere" => Solid::Sphere { radius: bounded_numbers::<1>(shape, "radius")?[0].abs() },
        "cylinder" => radius_and_length().map(|(radius, length)| Solid::Cylinder { radius, length })?,
        "capsule" => radius_and_length().map(|(radius, length)| Solid::Capsule { radius, length })?,
        "mesh" => Solid::Mesh {
            file: shape.attribute("filename")?.trim().to_owned(),
            scale: match shape.attribute("scale").map(parse_numbers::<1>) {
                // A single factor for all axes is in use.
                Some(Ok([all])) => [all; 3],
                _ => bounded_numbers_or(shape, "scale", [1.0; 3])?,
            },
        },
        _ => return None,
    })
}

/// Pose of a shape in the link frame; identity if absent, `None` if invalid.
fn shape_frame<'a, 'i: 'a>(parent: Node<'a, 'i>) -> Option<Transform<f64>> {
    let Some(origin) = child(parent, "origin") else { return Some(Transform::identity()) };
    let translation = Vector3::from(bounded_numbers_or(origin, "xyz", [0.0; 3])?);
    let rotation = if origin.has_attribute("quat_xyzw") {
        rotation_from_any_quaternion(bounded_numbers(origin, "quat_xyzw")?)?.0
    } else {
        rotation_from_rpy(bounded_numbers_or(origin, "rpy", [0.0; 3])?)
    };
    Some(Transform::new(rotation, translation))
}
