//! Every element that makes the mechanism, checked by itself.

use crate::joint::JointText;
use crate::link::LinkText;
use crate::nodes::Nodes;
use crate::report::Report;
use crate::{closure, joint, link};
use percuss_mechanism::{ClosureDescription, CouplingDescription};

/// What the file says, in the order of [`Nodes`]. Where the report has no error every number in it is good; whether the
/// names lead somewhere, [`consistency::check`](crate::consistency::check) finds out.
pub(crate) struct Texts<'a> {
    pub links: Vec<LinkText<'a>>,
    pub joints: Vec<JointText<'a>>,
    pub closures: Vec<ClosureDescription>,
    pub couplings: Vec<CouplingDescription>,
}

impl<'a> Texts<'a> {
    /// Reads every element.
    pub fn read<'i: 'a>(nodes: &Nodes<'a, 'i>, report: &mut Report) -> Self {
        Texts {
            links: nodes.links.iter().map(|n| link::check(*n, report)).collect(),
            joints: nodes.joints.iter().map(|n| joint::check(*n, report)).collect(),
            closures: nodes.closures.iter().map(|n| closure::check(*n, report)).collect(),
            couplings: nodes.couplings.iter().map(|n| closure::check_coupling(*n, report)).collect(),
        }
    }
}
