//! Checks between elements: transmissions of joints, references by name, loops.

use crate::reading::report::Report;
use crate::urdf::elements::joint;
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::elements::transmission;
use crate::urdf::loops::{Loops, second_parents};
use crate::urdf::references::{self, Suggestions};
use crate::urdf::texts::Texts;
use roxmltree::Node;

/// Adds the armatures of transmissions to their joints and checks every reference. If the report has no error
/// afterwards, every name refers to an existing element.
pub(crate) fn check<'a, 'i: 'a>(
    robot: Node<'a, 'i>,
    nodes: &Nodes<'a, 'i>,
    texts: &mut Texts<'a>,
    report: &mut Report,
) {
    let joints = &mut texts.joints;
    let joint_index = references::index_by_name(joints.iter().map(|j| j.name));
    transmission::add_transmission_armatures(robot, joints, &joint_index, report);
    for (joint, node) in joints.iter_mut().zip(&nodes.joints) {
        transmission::drop_fixed_joint_armature(joint, *node, report);
    }
    let mut suggestions = Suggestions::new();
    references::check(&texts.links, joints, &nodes.joints, &joint_index, &mut suggestions, report);
    let second = second_parents(&texts.joints);
    Loops { texts, nodes, is_second_parent: &second }.check(&mut suggestions, report);
    if texts.closures.is_empty() && texts.couplings.is_empty() && !second.contains(&true) {
        let joints = texts.joints.iter().zip(&nodes.joints);
        joints.for_each(|(joint, node)| joint::warn_if_unbound(joint, *node, report));
    }
}
