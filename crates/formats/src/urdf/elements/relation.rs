//! Parser of `<relation>`: a relation between joint positions.

use crate::reading::report::Report;
use crate::urdf::elements::link::read_name;
use crate::urdf::elements::numbers::{optional_numbers, parse_numbers, required_number, required_numbers};
use crate::urdf::elements::survey::{child, children};
use percuss_mechanism::{CurveDescription, RelationDescription};
use roxmltree::Node;

/// Description of a `<relation>`: Σ factor · q = constant + curve.
pub(crate) fn read_relation<'a, 'i: 'a>(node: Node<'a, 'i>, report: &mut Report) -> RelationDescription {
    let constant = child(node, "constant").and_then(|element| required_number(element, "value", report));
    let curve = child(node, "curve").map(|curve| {
        let number = |text: &str| parse_numbers::<1>(text).map_or(0.0, |[value]| value);
        let coefficients = required_numbers::<3>(curve, "coefficients", "0 0 0", report);
        CurveDescription {
            terms: read_terms(curve, report),
            offset: number(optional_numbers::<1>(curve, "offset", "0", report)),
            coefficients: parse_numbers::<3>(coefficients).unwrap_or_default(),
        }
    });
    RelationDescription {
        name: read_name(node, report).to_owned(),
        terms: read_terms(node, report),
        constant: constant.unwrap_or(0.0),
        curve,
    }
}

/// Joints with their factors.
fn read_terms<'a, 'i: 'a>(node: Node<'a, 'i>, report: &mut Report) -> Vec<(String, f64)> {
    let mut terms = Vec::new();
    for joint in children(node, "joint") {
        let factor = required_number(joint, "factor", report);
        terms.push((read_name(joint, report).to_owned(), factor.unwrap_or(1.0)));
    }
    terms
}
