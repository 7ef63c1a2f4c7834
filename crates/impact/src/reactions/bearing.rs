//! Bearing: joint, closure or ground in which a reaction acts.

use crate::reactions::reaction::{Reaction, Reactions};
use percuss_mechanism::{JointId, Mechanism};

/// Joint, closure or ground in which a reaction acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bearing {
    /// Joint of the tree.
    Joint(JointId),
    /// Index into [`Mechanism::closures`](percuss_mechanism::Mechanism::closures).
    Closure(usize),
    /// The ground under the root link; it has no reaction if the base floats.
    Ground,
}

impl From<JointId> for Bearing {
    fn from(joint: JointId) -> Self {
        Self::Joint(joint)
    }
}

impl Bearing {
    /// Reaction in the bearing; `None` for the ground of a floating base, and for a bearing of another mechanism.
    pub fn reaction(self, reactions: &Reactions) -> Option<&Reaction> {
        match self {
            Self::Joint(joint) => reactions.joints.get(joint.index()).map(|joint| &joint.reaction),
            Self::Closure(closure) => reactions.closures.get(closure),
            Self::Ground => reactions.ground.as_ref(),
        }
    }

    /// Kind and name, for messages.
    pub(crate) fn describe(self, mechanism: &Mechanism) -> String {
        match self {
            Self::Joint(joint) => format!("joint \"{}\"", mechanism.joint(joint).name()),
            Self::Closure(closure) => match mechanism.closures().get(closure) {
                Some(closure) => format!("closure \"{}\"", closure.name()),
                None => format!("closure number {closure}"),
            },
            Self::Ground => format!("the ground under \"{}\"", mechanism.link(mechanism.root()).name()),
        }
    }
}
