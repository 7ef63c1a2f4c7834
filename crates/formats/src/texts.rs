//! Every element that makes the mechanism, checked.

use crate::joint::JointText;
use crate::link::LinkText;
use crate::loops::{Loops, second_parents};
use crate::nodes::Nodes;
use crate::references::{self, Guesses};
use crate::report::Report;
use crate::{armature, closure, joint, link};
use percuss_mechanism::{ClosureDescription, CouplingDescription};
use roxmltree::Node;

/// What the file says, in the order of [`Nodes`]. Where the report has no error every number in it is good, and
/// every name leads somewhere.
pub(crate) struct Texts<'a> {
    pub links: Vec<LinkText<'a>>,
    pub joints: Vec<JointText<'a>>,
    /// Loops are not plain URDF: there is no other reader that would turn them into values.
    pub closures: Vec<ClosureDescription>,
    pub couplings: Vec<CouplingDescription>,
}

impl<'a> Texts<'a> {
    /// Checks every element, and then what they say of one another.
    pub fn check<'i: 'a>(robot: Node<'a, 'i>, nodes: &Nodes<'a, 'i>, report: &mut Report) -> Self {
        let mut texts = Texts {
            links: nodes.links.iter().map(|n| link::check(*n, report)).collect(),
            joints: nodes.joints.iter().map(|n| joint::check(*n, report)).collect(),
            closures: nodes.closures.iter().map(|n| closure::check(*n, report)).collect(),
            couplings: nodes.couplings.iter().map(|n| closure::check_coupling(*n, report)).collect(),
        };
        let joints = &mut texts.joints;
        let joint_index = references::index(joints.iter().map(|j| j.name));
        armature::of_transmissions(robot, joints, &joint_index, report);
        for (joint, node) in joints.iter_mut().zip(&nodes.joints) {
            armature::drop_from_fixed(joint, *node, report);
        }
        let mut guesses = Guesses::new();
        references::check(&texts.links, joints, &nodes.joints, &joint_index, &mut guesses, report);
        let second = second_parents(&texts.joints);
        Loops { texts: &texts, nodes, second: &second }.check(&mut guesses, report);
        if texts.closures.is_empty() && texts.couplings.is_empty() && !second.contains(&true) {
            let joints = texts.joints.iter().zip(&nodes.joints);
            joints.for_each(|(joint, node)| joint::unbound(joint, *node, report));
        }
        texts
    }
}
