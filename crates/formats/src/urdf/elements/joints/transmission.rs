//! Armatures of joints given in a `<transmission>`; removal of armatures from fixed joints.

use crate::reading::report::{Place, Report, quoted};
use crate::urdf::elements::joints::armature;
use crate::urdf::elements::joints::joint::JointText;
use crate::urdf::elements::survey::{child, children};
use percuss_mechanism::JointKind;
use roxmltree::Node;
use std::collections::HashMap;

/// Adds the armatures given in `<transmission>`s to their joints.
pub(crate) fn add_transmission_armatures<'a, 'i: 'a>(
    robot: Node<'a, 'i>,
    joints: &mut [JointText<'a>],
    index: &HashMap<&'a str, usize>,
    report: &mut Report,
) {
    for transmission in children(robot, "transmission") {
        let joint = child(transmission, "joint").and_then(|n| n.attribute("name")).unwrap_or_default();
        for actuator in children(transmission, "actuator") {
            let Some(value) = armature::reflected_inertia(actuator, report) else { continue };
            match index.get(joint) {
                Some(&i) => armature::merge_armature(&mut joints[i].armature, value, actuator, report),
                None => report.warning("dangling-armature", Place::Element(actuator), || {
                    format!("the rotor inertia is for joint {}, which does not exist; ignored", quoted(joint))
                }),
            }
        }
    }
}

/// Drops the armature of a fixed joint, which has no velocity.
pub(crate) fn drop_fixed_joint_armature(joint: &mut JointText<'_>, node: Node<'_, '_>, report: &mut Report) {
    if joint.kind == JointKind::Fixed && !joint.armature.is_empty() {
        if joint.armature.iter().any(|a| *a != 0.0) {
            report.warning("fixed-armature", Place::Element(node), || {
                "the joint is fixed; its armature is ignored".to_owned()
            });
        }
        joint.armature.clear();
    }
}
