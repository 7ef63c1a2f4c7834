//! Rotor inertia reflected to a joint, in the spellings in use.
//!
//! - `<dynamics armature="A"/>` in the joint: one value, or one a velocity;
//! - Drake's `<drake:rotor_inertia value="I"/>` and `<drake:gear_ratio value="r"/>`, A = I r², in the joint, in an
//!   `<actuator>` of the joint, or in the `<actuator>` of a `<transmission>` that names the joint.

use crate::joint::{JointText, number};
use crate::numbers::{bad, parse};
use crate::report::{Place, Report, quoted};
use crate::survey::{child, children};
use percuss_mechanism::{JointKind, Severity};
use roxmltree::Node;
use std::collections::HashMap;

/// Two spellings of one armature may differ by so much, relatively, through rounding.
const SPELLING_SLACK: f64 = 1e-9;

/// The armature given inside a `<joint>`.
pub(crate) fn of_joint<'a, 'i: 'a>(node: Node<'a, 'i>, report: &mut Report) -> Vec<f64> {
    let mut armature = child(node, "dynamics").map(|n| listed(n, report)).unwrap_or_default();
    for holder in std::iter::once(node).chain(children(node, "actuator")) {
        if let Some(value) = reflected(holder, report) {
            add(&mut armature, value, holder, report);
        }
    }
    armature
}

/// The armatures given in `<transmission>`s, put to their joints.
pub(crate) fn of_transmissions<'a, 'i: 'a>(
    robot: Node<'a, 'i>,
    joints: &mut [JointText<'a>],
    index: &HashMap<&'a str, usize>,
    report: &mut Report,
) {
    for transmission in children(robot, "transmission") {
        let joint = child(transmission, "joint").and_then(|n| n.attribute("name")).unwrap_or_default();
        for actuator in children(transmission, "actuator") {
            let Some(value) = reflected(actuator, report) else { continue };
            match index.get(joint) {
                Some(&i) => add(&mut joints[i].armature, value, actuator, report),
                None => report.warning("dangling-armature", Place::Element(actuator), || {
                    format!("the rotor inertia is for joint {}, which does not exist; ignored", quoted(joint))
                }),
            }
        }
    }
}

/// A joint that does not move has no use for a rotor.
pub(crate) fn drop_from_fixed(joint: &mut JointText<'_>, node: Node<'_, '_>, report: &mut Report) {
    if joint.kind == JointKind::Fixed && !joint.armature.is_empty() {
        if joint.armature.iter().any(|a| *a != 0.0) {
            report.warning("fixed-armature", Place::Element(node), || {
                "the joint is fixed; its armature is ignored".to_owned()
            });
        }
        joint.armature.clear();
    }
}

fn listed(node: Node<'_, '_>, report: &mut Report) -> Vec<f64> {
    let Some(text) = node.attribute("armature") else { return Vec::new() };
    let parsed = match text.split_ascii_whitespace().take(7).count() {
        3 => parse::<3>(text).map(Vec::from),
        6 => parse::<6>(text).map(Vec::from),
        _ => parse::<1>(text).map(Vec::from),
    };
    parsed.unwrap_or_else(|trouble| {
        bad(node, "armature", text, &trouble, report);
        Vec::new()
    })
}

/// I r² of Drake's elements in this holder.
fn reflected<'a, 'i: 'a>(holder: Node<'a, 'i>, report: &mut Report) -> Option<f64> {
    let inertia = number(child(holder, "drake:rotor_inertia")?, "value", report)?;
    let ratio = match child(holder, "drake:gear_ratio") {
        Some(node) => number(node, "value", report)?,
        None => {
            report.fold(Severity::Note, "default-gear", String::new(), Place::Element(holder), || {
                "a rotor inertia without <drake:gear_ratio>: the ratio is taken as 1, as in Drake".to_owned()
            });
            1.0
        }
    };
    Some(inertia * ratio * ratio)
}

fn add(armature: &mut Vec<f64>, value: f64, place: Node<'_, '_>, report: &mut Report) {
    match armature[..] {
        [] => armature.push(value),
        [given] if (given - value).abs() <= SPELLING_SLACK * given.abs().max(value.abs()) => {}
        _ => report.error("two-armatures", Place::Element(place), || {
            format!("the joint's armature is given twice, and not alike: {armature:?} and {value}")
        }),
    }
}
