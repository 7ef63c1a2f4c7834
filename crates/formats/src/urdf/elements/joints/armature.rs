//! Rotor inertia reflected to a joint (armature), in the notations in use.
//!
//! - `<dynamics armature="A"/>` in the joint: one value, or one value per joint velocity;
//! - Drake's `<drake:rotor_inertia value="I"/>` and `<drake:gear_ratio value="r"/>`, A = I r², in the joint, in an
//!   `<actuator>` of the joint, or in the `<actuator>` of a `<transmission>` that names the joint.

use crate::reading::limits::ARMATURE_TOLERANCE;
use crate::reading::report::{Place, Report};
use crate::reading::xml::Node;
use crate::urdf::elements::numbers::{parse_numbers, report_bad_number, required_number};
use crate::urdf::elements::survey::{child, children};
use percuss_mechanism::Severity;

/// Armature given inside a `<joint>`, kg·m² or kg: empty, one value, or one value per velocity.
pub(crate) fn read_joint_armature(node: Node<'_>, report: &mut Report) -> Vec<f64> {
    let mut armature = child(node, "dynamics").map(|n| armature_attribute(n, report)).unwrap_or_default();
    for holder in std::iter::once(node).chain(children(node, "actuator")) {
        if let Some(value) = reflected_inertia(holder, report) {
            merge_armature(&mut armature, value, holder, report);
        }
    }
    armature
}

/// Values of the attribute `armature`, kg·m² or kg; empty if absent or invalid.
fn armature_attribute(node: Node<'_>, report: &mut Report) -> Vec<f64> {
    let Some(text) = node.attribute("armature") else { return Vec::new() };
    let parsed = match text.split_ascii_whitespace().take(7).count() {
        3 => parse_numbers::<3>(text).map(Vec::from),
        6 => parse_numbers::<6>(text).map(Vec::from),
        _ => parse_numbers::<1>(text).map(Vec::from),
    };
    parsed.unwrap_or_else(|defect| {
        report_bad_number(node, "armature", text, &defect, report);
        Vec::new()
    })
}

/// Reflected inertia I r² (kg·m² or kg) from Drake's elements in `parent`. The ratio defaults to 1, with a note.
pub(crate) fn reflected_inertia(parent: Node<'_>, report: &mut Report) -> Option<f64> {
    let inertia = required_number(child(parent, "drake:rotor_inertia")?, "value", report)?;
    let ratio = match child(parent, "drake:gear_ratio") {
        Some(node) => required_number(node, "value", report)?,
        None => {
            report.add_once(Severity::Note, "default-gear", String::new(), Place::Element(parent), || {
                "a rotor inertia without <drake:gear_ratio>: the ratio is taken as 1, as in Drake".to_owned()
            });
            1.0
        }
    };
    Some(inertia * ratio * ratio)
}

/// Sets the armature, or compares a second value with the first. A difference beyond the tolerance is an error.
pub(crate) fn merge_armature(armature: &mut Vec<f64>, value: f64, place: Node<'_>, report: &mut Report) {
    match armature[..] {
        [] => armature.push(value),
        [given] if (given - value).abs() <= ARMATURE_TOLERANCE * given.abs().max(value.abs()) => {}
        _ => report.error("two-armatures", Place::Element(place), || {
            format!("the joint's armature is given twice, with different values: {armature:?} and {value}")
        }),
    }
}
