//! The shapes of links: `<visual>` and `<collision>`. They enter no mechanics, so that nothing here is an error.

use crate::limits::LARGEST_SHAPE;
use crate::numbers::parse;
use crate::survey::{child, children};
use nalgebra::{Vector3, Vector4};
use percuss_spatial::{Transform, rotation_from_quaternion, rotation_from_rpy};
use roxmltree::Node;

/// What a shape is declared for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Purpose {
    /// `<collision>`.
    Collision,
    /// `<visual>`.
    Visual,
}

impl Purpose {
    /// The element's name.
    pub fn name(self) -> &'static str {
        match self {
            Purpose::Collision => "collision",
            Purpose::Visual => "visual",
        }
    }
}

/// A body in its own frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// A box about the origin: its edges, m.
    Box {
        /// Along x, y and z.
        size: [f64; 3],
    },
    /// A sphere about the origin, m.
    Sphere {
        /// Its radius.
        radius: f64,
    },
    /// A cylinder about the z axis, its middle at the origin, m.
    Cylinder {
        /// Its radius.
        radius: f64,
        /// From end to end.
        length: f64,
    },
    /// A cylinder about the z axis with hemispheres at its ends, m.
    Capsule {
        /// Its radius.
        radius: f64,
        /// Of the cylinder, without the hemispheres.
        length: f64,
    },
    /// A triangle mesh.
    Mesh {
        /// Its file, as the URDF names it.
        file: String,
        /// The factors of its coordinates.
        scale: [f64; 3],
    },
}

/// A shape of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// What it is declared for.
    pub purpose: Purpose,
    /// The body in its own frame.
    pub solid: Solid,
    /// Its frame in the link's.
    pub frame: Transform<f64>,
}

/// The shapes of a link, in the order of the file. Those with numbers that cannot be used are left out: the reader has warned
/// of these.
pub(crate) fn shapes<'a, 'i: 'a>(link: Node<'a, 'i>) -> Vec<Shape> {
    let mut found = Vec::new();
    for (name, purpose) in [("collision", Purpose::Collision), ("visual", Purpose::Visual)] {
        for holder in children(link, name) {
            let Some(geometry) = child(holder, "geometry") else { continue };
            let Some(frame) = frame(holder) else { continue };
            let solids = geometry.children().filter(Node::is_element).filter_map(solid);
            found.extend(solids.map(|solid| Shape { purpose, solid, frame }));
        }
    }
    found
}

fn numbers<const N: usize>(node: Node<'_, '_>, attribute: &str) -> Option<[f64; N]> {
    let values = parse::<N>(node.attribute(attribute)?).ok()?;
    values.iter().all(|v| v.abs() <= LARGEST_SHAPE).then_some(values)
}

/// Numbers where there are any, else others; none where they cannot be used.
fn numbers_or<const N: usize>(node: Node<'_, '_>, attribute: &str, otherwise: [f64; N]) -> Option<[f64; N]> {
    node.attribute(attribute).map_or(Some(otherwise), |_| numbers(node, attribute))
}

fn solid(shape: Node<'_, '_>) -> Option<Solid> {
    let round = || Some((numbers::<1>(shape, "radius")?[0].abs(), numbers::<1>(shape, "length")?[0].abs()));
    Some(match shape.tag_name().name() {
        "box" => Solid::Box { size: numbers(shape, "size")?.map(f64::abs) },
        "sphere" => Solid::Sphere { radius: numbers::<1>(shape, "radius")?[0].abs() },
        "cylinder" => round().map(|(radius, length)| Solid::Cylinder { radius, length })?,
        "capsule" => round().map(|(radius, length)| Solid::Capsule { radius, length })?,
        "mesh" => Solid::Mesh {
            file: shape.attribute("filename")?.trim().to_owned(),
            scale: match shape.attribute("scale").map(parse::<1>) {
                // One factor for all is in use.
                Some(Ok([all])) => [all; 3],
                _ => numbers_or(shape, "scale", [1.0; 3])?,
            },
        },
        _ => return None,
    })
}

/// `<origin xyz rpy quat_xyzw>` of a shape.
fn frame<'a, 'i: 'a>(holder: Node<'a, 'i>) -> Option<Transform<f64>> {
    let Some(origin) = child(holder, "origin") else { return Some(Transform::identity()) };
    let place = Vector3::from(numbers_or(origin, "xyz", [0.0; 3])?);
    if let Some([x, y, z, w]) = numbers::<4>(origin, "quat_xyzw") {
        let norm = Vector4::new(x, y, z, w).norm();
        let unit = [w, x, y, z].map(|c| c / norm);
        return (norm > 0.5).then(|| Transform::new(rotation_from_quaternion(unit), place));
    }
    Some(Transform::new(rotation_from_rpy(numbers_or(origin, "rpy", [0.0; 3])?), place))
}
