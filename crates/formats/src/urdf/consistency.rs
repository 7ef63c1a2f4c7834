//! Checks between elements: transmissions of joints, references by name, loops.

use crate::reading::report::Report;
use crate::reading::xml::Node;
use crate::urdf::elements::joints::{joint, simulator_couplings, transmission};
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::loops::{LoopChecks, find_loop_closing_joints};
use crate::urdf::references::{self, Suggestions};
use crate::urdf::texts::Texts;

/// Adds the armatures of transmissions to their joints and checks every reference. If the report has no error
/// afterwards, every name refers to an existing element.
pub(crate) fn resolve_references<'a>(
    robot: Node<'a>,
    nodes: &Nodes<'a>,
    texts: &mut Texts<'a>,
    report: &mut Report,
) {
    let mut suggestions = Suggestions::new();
    let joint_index = references::index_by_name(texts.joints.iter().map(|j| j.name));
    let joints = &mut texts.joints;
    transmission::add_transmission_armatures(
        robot,
        joints,
        &nodes.joints,
        &joint_index,
        &mut suggestions,
        report,
    );
    for (joint, node) in joints.iter_mut().zip(&nodes.joints) {
        transmission::drop_fixed_joint_armature(joint, *node, report);
    }
    let closes_loop = find_loop_closing_joints(joints);
    let has_loops = texts.has_closures() || closes_loop.contains(&true);
    simulator_couplings::read_couplings(robot, texts, &joint_index, has_loops, report);
    references::check_joint_references(
        &texts.links,
        &mut texts.joints,
        &nodes.joints,
        &joint_index,
        &mut suggestions,
        report,
    );
    LoopChecks { texts, nodes, closes_loop: &closes_loop }.check_all(&mut suggestions, report);
    if !texts.has_closures()
        && texts.couplings.is_empty()
        && texts.relations.is_empty()
        && !closes_loop.contains(&true)
    {
        let joints = texts.joints.iter().zip(&nodes.joints);
        joints.for_each(|(joint, node)| joint::warn_if_dependence_is_ignored(joint, *node, report));
    }
}
