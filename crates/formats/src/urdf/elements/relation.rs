//! Parser of `<relation>`: a relation between joint positions.

use crate::reading::report::Report;
use crate::reading::xml::Node;
use crate::urdf::elements::link::read_name;
use crate::urdf::elements::numbers::{optional_numbers, required_number, required_numbers};
use crate::urdf::elements::survey::{child, children};
use percuss_mechanism::{CurveDescription, RelationDescription};

/// Description of a `<relation>`: Σ factor · q = constant + curve.
pub(crate) fn read_relation(node: Node<'_>, report: &mut Report) -> RelationDescription {
    let constant = child(node, "constant").and_then(|element| required_number(element, "value", report));
    let curve = child(node, "curve").map(|curve| {
        let coefficients = required_numbers(curve, "coefficients", [0.0; 3], report);
        let terms = read_terms(curve, report);
        let [offset] = optional_numbers(curve, "offset", [0.0], report);
        CurveDescription { terms, offset, coefficients }
    });
    RelationDescription {
        name: read_name(node, report).to_owned(),
        terms: read_terms(node, report),
        constant: constant.unwrap_or(0.0),
        curve,
    }
}

/// Joints with their factors.
fn read_terms(node: Node<'_>, report: &mut Report) -> Vec<(String, f64)> {
    let mut terms = Vec::new();
    for joint in children(node, "joint") {
        let factor = required_number(joint, "factor", report);
        terms.push((read_name(joint, report).to_owned(), factor.unwrap_or(1.0)));
    }
    terms
}
