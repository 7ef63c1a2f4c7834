//! Parser of `<link>`: mass, inertia, and extent of the shape.

use crate::reading::limits::LONGEST_NAME;
use crate::reading::report::{Place, Report, shortened};
use crate::reading::xml::Node;
use crate::shape::Shape;
use crate::urdf::elements::numbers::{optional_numbers, required_numbers};
use crate::urdf::elements::origin::read_origin;
use crate::urdf::elements::shapes::read_shapes;
use crate::urdf::elements::survey::child;
use percuss_mechanism::{Geometry, Inertial, LinkDescription, Problem};
use percuss_spatial::{Matrix3, Transform};

/// Checked `<link>`: every number is valid.
pub(crate) struct LinkText<'a> {
    pub name: &'a str,
    pub inertial: Option<Inertial>,
    pub geometry: Geometry,
    pub shapes: Vec<Shape>,
}

impl LinkText<'_> {
    /// Description for the builder.
    pub fn description(&self) -> LinkDescription {
        LinkDescription { name: self.name.to_owned(), inertial: self.inertial, geometry: self.geometry }
    }
}

/// Attributes of `<inertia>`; `true` marks the optional ones.
const MOMENTS: [(&str, bool); 6] =
    [("ixx", false), ("ixy", true), ("ixz", true), ("iyy", false), ("iyz", true), ("izz", false)];

pub(crate) fn read_link<'a>(node: Node<'a>, report: &mut Report) -> LinkText<'a> {
    let name = read_name(node, report);
    let inertial = child(node, "inertial").map(|n| read_inertial(n, report));
    let (shapes, geometry) = read_shapes(node, report);
    LinkText { name, inertial, geometry, shapes }
}

/// Attribute `name`; an absent, empty or too long name is an error.
pub(crate) fn read_name<'a>(node: Node<'a>, report: &mut Report) -> &'a str {
    let name = node.attribute("name");
    let Some(name) = name else {
        crate::urdf::elements::numbers::report_missing_attribute(node, "name", report);
        return "";
    };
    if name.is_empty() {
        let problem = Problem::EmptyName;
        report.add_problem(Place::Element(node), &problem);
    } else if name.len() > LONGEST_NAME {
        report.error("long-name", Place::Element(node), || {
            format!("the name is {} bytes long; at most {LONGEST_NAME} are read", name.len())
        });
    } else if name.trim_ascii() != name {
        report.warning("spaced-name", Place::Element(node), || {
            format!("the name \"{}\" begins or ends with white space, which is part of it", shortened(name))
        });
    }
    name
}

/// Mass, centre of mass and inertia about the centre, in the axes of the link. An absent mass or inertia is 0, with a note.
fn read_inertial(node: Node<'_>, report: &mut Report) -> Inertial {
    let mass = child(node, "mass");
    let inertia = child(node, "inertia");
    let absent = match (mass, inertia) {
        (Some(_), Some(_)) => None,
        (Some(_), None) => Some("no <inertia>: a point mass"),
        (None, Some(_)) => Some("no <mass>: the mass is 0"),
        (None, None) => Some("neither <mass> nor <inertia>: the link is massless"),
    };
    if let Some(absent) = absent {
        report.note("partial-inertial", Place::Element(node), || absent.to_owned());
    }
    let Transform { rotation, translation: com } = read_origin(node, report).transform;
    let [mass] = mass.map_or([0.0], |n| required_numbers(n, "value", [0.0], report));
    let [ixx, ixy, ixz, iyy, iyz, izz] = inertia.map_or([0.0; 6], |n| read_moments(n, report));
    let turned = rotation * Matrix3::new(ixx, ixy, ixz, ixy, iyy, iyz, ixz, iyz, izz) * rotation.transpose();
    // Makes the tensor exactly symmetric. Halving first avoids overflow.
    Inertial { mass, com, about_com: turned * 0.5 + turned.transpose() * 0.5 }
}

/// Six entries of `<inertia>`, kg·m²; absent products are 0, with a warning.
fn read_moments(node: Node<'_>, report: &mut Report) -> [f64; 6] {
    let is_absent = |(name, is_optional): &&(&str, bool)| *is_optional && node.attribute(*name).is_none();
    let absent: Vec<&str> = MOMENTS.iter().filter(is_absent).map(|(name, _)| *name).collect();
    if !absent.is_empty() {
        report.warning("missing-product", Place::Element(node), || {
            format!("<inertia> has no {}: taken as 0", absent.join(", "))
        });
    }
    MOMENTS.map(|(name, is_optional)| {
        let read = if is_optional { optional_numbers::<1> } else { required_numbers::<1> };
        let [value] = read(node, name, [0.0], report);
        value
    })
}
