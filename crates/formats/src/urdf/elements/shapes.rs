//! Shapes of links, `<visual>` and `<collision>`, and their extent. The mechanics do not depend on them, so no finding here is an error.

use crate::reading::limits::MAX_SHAPE_SIZE;
use crate::reading::report::{Place, Report, quoted, shortened};
use crate::reading::xml::Node;
use crate::shape::{Purpose, Shape, Solid};
use crate::urdf::elements::numbers::parse_numbers;
use crate::urdf::elements::origin::{ZERO_QUATERNION, rotation_from_any_quaternion};
use crate::urdf::elements::survey::{child, children, has_xacro_substitution};
use percuss_mechanism::{Geometry, Severity};
use percuss_spatial::{Transform, rotation_from_rpy};

/// Shapes of a link, collision shapes first, then visual shapes, each in the order of the file; and the radius (m) of a sphere about the
/// link's origin around all of them, not of the smallest one. Shapes with invalid numbers are left out, with a warning.
pub(crate) fn read_shapes(link: Node<'_>, report: &mut Report) -> (Vec<Shape>, Geometry) {
    let (mut shapes, mut extent) = (Vec::new(), Geometry::None);
    for (tag, purpose) in [("visual", Purpose::Visual), ("collision", Purpose::Collision)] {
        for holder in children(link, tag) {
            let Some(geometry) = child(holder, "geometry") else { continue };
            for element in geometry.children().filter(Node::is_element) {
                let read = read_solid(element, report);
                // Unlike a mesh, an invalid solid does not hide the findings about its frame.
                let is_mesh = element.tag_name().name() == "mesh";
                let frame = if is_mesh && read.is_none() { None } else { read_frame(holder, report) };
                let (Some((solid, radius)), Some(frame)) = (read, frame) else { continue };
                extent = match (extent, radius) {
                    (Geometry::Mesh, _) | (_, None) => Geometry::Mesh,
                    (Geometry::None, Some(radius)) => Geometry::Within(distance(&frame) + radius),
                    (Geometry::Within(other), Some(radius)) => {
                        Geometry::Within(other.max(distance(&frame) + radius))
                    }
                };
                if !is_mesh || element.has_attribute("filename") {
                    shapes.push(Shape { purpose, solid, frame });
                }
            }
        }
    }
    // Stable sort: shapes of one purpose keep the order of the file.
    shapes.sort_by_key(|shape| shape.purpose);
    (shapes, extent)
}

/// Distance of the origin of a shape from that of the link, m.
fn distance(frame: &Transform<f64>) -> f64 {
    let p = &frame.translation;
    p.x.hypot(p.y).hypot(p.z)
}

/// Solid in its own frame, and the radius of a sphere around it, m, `None` for a mesh; `None`, with a warning, if the solid is invalid.
fn read_solid(shape: Node<'_>, report: &mut Report) -> Option<(Solid, Option<f64>)> {
    let mut radius_and_length = || {
        let [radius] = shape_numbers(shape, "radius", report)?;
        let [length] = shape_numbers(shape, "length", report)?;
        Some((radius, length))
    };
    let (solid, radius): (Solid, f64) = match shape.tag_name().name() {
        "mesh" => {
            let scale = match shape.attribute("scale").map(parse_numbers::<1>) {
                None => [1.0; 3],
                // A single factor for all axes is in use.
                Some(Ok([all])) => [all; 3],
                Some(Err(_)) => shape_numbers(shape, "scale", report)?,
            };
            let file = shape.attribute("filename").unwrap_or_default().trim().to_owned();
            return Some((Solid::Mesh { file, scale }, None));
        }
        "box" => {
            let size @ [x, y, z] = shape_numbers(shape, "size", report)?;
            (Solid::Box { size: size.map(f64::abs) }, x.hypot(y).hypot(z) / 2.0)
        }
        "sphere" => {
            let [radius] = shape_numbers(shape, "radius", report)?;
            (Solid::Sphere { radius: radius.abs() }, radius)
        }
        "cylinder" => {
            let (radius, length) = radius_and_length()?;
            let solid = Solid::Cylinder { radius: radius.abs(), length: length.abs() };
            (solid, radius.hypot(length / 2.0))
        }
        "capsule" => {
            let (radius, length) = radius_and_length()?;
            let solid = Solid::Capsule { radius: radius.abs(), length: length.abs() };
            (solid, radius + length / 2.0)
        }
        name => {
            let name = shortened(name);
            report.add_once(Severity::Warning, "unknown-shape", name.clone(), Place::Element(shape), || {
                format!("unknown shape <{name}> is ignored")
            });
            return None;
        }
    };
    Some((solid, Some(radius.abs())))
}

/// Pose of a shape in the link frame; identity if absent, `None`, with a warning, if invalid.
fn read_frame(holder: Node<'_>, report: &mut Report) -> Option<Transform<f64>> {
    let Some(origin) = child(holder, "origin") else { return Some(Transform::identity()) };
    let rotation = if origin.has_attribute("quat_xyzw") {
        let Some((rotation, _)) = rotation_from_any_quaternion(shape_numbers(origin, "quat_xyzw", report)?)
        else {
            report.warning("bad-shape", Place::Attribute(origin, "quat_xyzw"), || {
                format!("quat_xyzw: {ZERO_QUATERNION}; the shape is ignored")
            });
            return None;
        };
        rotation
    } else {
        let has_angles = origin.has_attribute("rpy");
        rotation_from_rpy(if has_angles { shape_numbers(origin, "rpy", report)? } else { [0.0; 3] })
    };
    let translation =
        if origin.has_attribute("xyz") { shape_numbers(origin, "xyz", report)? } else { [0.0; 3] };
    Some(Transform::new(rotation, translation.into()))
}

/// N numbers of an attribute, at most `MAX_SHAPE_SIZE`; `None`, with a warning, for anything else.
fn shape_numbers<const N: usize>(
    node: Node<'_>,
    attribute: &'static str,
    report: &mut Report,
) -> Option<[f64; N]> {
    let Some(text) = node.attribute(attribute) else {
        report.warning("bad-shape", Place::Element(node), || {
            format!("no attribute \"{attribute}\"; the shape is ignored")
        });
        return None;
    };
    let place = Place::Attribute(node, attribute);
    if has_xacro_substitution(text) {
        report.add_xacro_error(place, &format!("{attribute}={}", quoted(text)));
        return None;
    }
    let defect = match parse_numbers::<N>(text) {
        Ok(values) if values.iter().all(|v| v.abs() <= MAX_SHAPE_SIZE) => return Some(values),
        Ok(_) => format!("more than {MAX_SHAPE_SIZE:e} m is no shape"),
        Err(defect) => defect,
    };
    report.warning("bad-shape", place, || {
        format!("{attribute}={}: {defect}; the shape is ignored", quoted(text))
    });
    None
}
