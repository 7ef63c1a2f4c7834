//! Parser of `<link>`: mass, inertia, and extent of the shape.

use crate::reading::limits::LONGEST_NAME;
use crate::reading::report::{Place, Report, shortened};
use crate::urdf::elements::numbers::{optional_numbers, required_numbers};
use crate::urdf::elements::origin::{self, Origin};
use crate::urdf::elements::shapes::geometry;
use crate::urdf::elements::survey::child;
use percuss_mechanism::{Geometry, Problem};
use roxmltree::Node;

/// Checked `<link>`: every number is valid.
pub(crate) struct LinkText<'a> {
    pub name: &'a str,
    pub inertial: Option<InertialText<'a>>,
    pub geometry: Geometry,
}

/// Checked `<inertial>`.
pub(crate) struct InertialText<'a> {
    pub origin: Origin<'a>,
    /// One valid number, kg.
    pub mass: &'a str,
    /// Moments ixx, ixy, ixz, iyy, iyz, izz: one valid number each, kg·m².
    pub moments: [&'a str; 6],
}

/// Attributes of `<inertia>`; `true` marks the optional ones.
const MOMENTS: [(&str, bool); 6] =
    [("ixx", false), ("ixy", true), ("ixz", true), ("iyy", false), ("iyz", true), ("izz", false)];

pub(crate) fn read_link<'a, 'i: 'a>(node: Node<'a, 'i>, report: &mut Report) -> LinkText<'a> {
    LinkText {
        name: read_name(node, report),
        inertial: child(node, "inertial").map(|n| read_inertial(n, report)),
        geometry: geometry::enclosing_sphere(node, report),
    }
}

/// Attribute `name`; an absent, empty or too long name is an error.
pub(crate) fn read_name<'a>(node: Node<'a, '_>, report: &mut Report) -> &'a str {
    let name = node.attribute("name");
    let Some(name) = name else {
        crate::urdf::elements::numbers::report_missing_attribute(node, "name", report);
        return "";
    };
    if name.is_empty() {
        let problem = Problem::EmptyName;
        report.add(problem.severity(), problem.code(), Place::Element(node), || problem.to_string());
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

/// An absent mass or inertia is 0, with a note.
fn read_inertial<'a, 'i: 'a>(node: Node<'a, 'i>, report: &mut Report) -> InertialText<'a> {
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
    InertialText {
        origin: origin::read_origin(node, report),
        mass: mass.map_or("0", |n| required_numbers::<1>(n, "value", "0", report)),
        moments: inertia.map_or(["0"; 6], |n| read_moments(n, report)),
    }
}

/// Six entries of `<inertia>`, kg·m²; absent products are 0, with a warning.
fn read_moments<'a>(node: Node<'a, '_>, report: &mut Report) -> [&'a str; 6] {
    let absent: Vec<&str> = MOMENTS
        .iter()
        .filter(|(name, is_optional)| *is_optional && node.attribute(*name).is_none())
        .map(|(n, _)| *n)
        .collect();
    if !absent.is_empty() {
        report.warning("missing-product", Place::Element(node), || {
            format!("<inertia> has no {}: taken as 0", absent.join(", "))
        });
    }
    MOMENTS.map(|(name, is_optional)| {
        if is_optional {
            optional_numbers::<1>(node, name, "0", report)
        } else {
            required_numbers::<1>(node, name, "0", report)
        }
    })
}
