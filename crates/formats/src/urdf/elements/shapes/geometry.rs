//! Extent of the declared shape of a link. No result depends on the extent, so no finding here is an error.

use crate::reading::limits::MAX_SHAPE_SIZE;
use crate::reading::report::{Place, Report, quoted, shortened};
use crate::urdf::elements::numbers::parse_numbers;
use crate::urdf::elements::origin::{ZERO_QUATERNION, rotation_from_any_quaternion};
use crate::urdf::elements::survey::{child, children, has_xacro_substitution};
use percuss_mechanism::Geometry;
use roxmltree::Node;

/// Radius (m) of a sphere about the link's origin around every `<visual>` and `<collision>`; not the smallest one.
pub(crate) fn enclosing_sphere<'a, 'i: 'a>(link: Node<'a, 'i>, report: &mut Report) -> Geometry {
    let mut extent = Geometry::None;
    for holder in children(link, "visual").chain(children(link, "collision")) {
        let Some(geometry) = child(holder, "geometry") else { continue };
        for shape in geometry.children().filter(Node::is_element) {
            extent = combine_extents(extent, shape_enclosing_sphere(holder, shape, report));
        }
    }
    extent
}

/// Extent of two shapes together: the larger radius; a mesh has an unknown extent and prevails.
fn combine_extents(a: Geometry, b: Geometry) -> Geometry {
    match (a, b) {
        (Geometry::Mesh, _) | (_, Geometry::Mesh) => Geometry::Mesh,
        (Geometry::None, other) | (other, Geometry::None) => other,
        (Geometry::Within(a), Geometry::Within(b)) => Geometry::Within(a.max(b)),
    }
}

/// Radius (m) of a sphere about the link's origin around one shape; `Geometry::None`, with a warning, if invalid.
fn shape_enclosing_sphere<'a, 'i: 'a>(
    holder: Node<'a, 'i>,
    shape: Node<'a, 'i>,
    report: &mut Report,
) -> Geometry {
    let radius = match shape.tag_name().name() {
        "mesh" => {
            let is_valid = is_scale_valid(shape, report) && shape_position(holder, report).is_some();
            return if is_valid { Geometry::Mesh } else { Geometry::None };
        }
        "box" => shape_numbers::<3>(shape, "size", report).map(|[x, y, z]| x.hypot(y).hypot(z) / 2.0),
        "sphere" => shape_numbers::<1>(shape, "radius", report).map(|[r]| r),
        "cylinder" => radius_and_length(shape, report).map(|(r, length)| r.hypot(length / 2.0)),
        "capsule" => radius_and_length(shape, report).map(|(r, length)| r + length / 2.0),
        name => {
            report.add_once(
                percuss_mechanism::Severity::Warning,
                "unknown-shape",
                shortened(name),
                Place::Element(shape),
                || format!("unknown shape <{}> is ignored", shortened(name)),
            );
            None
        }
    };
    match (radius, shape_position(holder, report)) {
        (Some(radius), Some([x, y, z])) => Geometry::Within(x.hypot(y).hypot(z) + radius.abs()),
        (Some(_) | None, _) => Geometry::None,
    }
}

/// Position of a shape in the link frame, m; `None`, with a warning, if invalid.
fn shape_position<'a, 'i: 'a>(holder: Node<'a, 'i>, report: &mut Report) -> Option<[f64; 3]> {
    let Some(origin) = child(holder, "origin") else { return Some([0.0; 3]) };
    if origin.has_attribute("quat_xyzw") {
        let quaternion = shape_numbers::<4>(origin, "quat_xyzw", report)?;
        if rotation_from_any_quaternion(quaternion).is_none() {
            report.warning("bad-shape", Place::Attribute(origin, "quat_xyzw"), || {
                format!("quat_xyzw: {ZERO_QUATERNION}; the shape is ignored")
            });
            return None;
        }
    } else if origin.has_attribute("rpy") {
        shape_numbers::<3>(origin, "rpy", report)?;
    }
    if origin.has_attribute("xyz") { shape_numbers(origin, "xyz", report) } else { Some([0.0; 3]) }
}

/// True if a mesh has no scale, one factor, or three.
fn is_scale_valid(shape: Node<'_, '_>, report: &mut Report) -> bool {
    match shape.attribute("scale").map(parse_numbers::<1>) {
        None | Some(Ok(_)) => true,
        Some(Err(_)) => shape_numbers::<3>(shape, "scale", report).is_some(),
    }
}

/// Radius and length of a cylinder or capsule, m.
fn radius_and_length(shape: Node<'_, '_>, report: &mut Report) -> Option<(f64, f64)> {
    let [radius] = shape_numbers::<1>(shape, "radius", report)?;
    let [length] = shape_numbers::<1>(shape, "length", report)?;
    Some((radius, length))
}

/// N numbers of an attribute, at most `MAX_SHAPE_SIZE`; `None`, with a warning, for anything else.
fn shape_numbers<const N: usize>(
    node: Node<'_, '_>,
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
