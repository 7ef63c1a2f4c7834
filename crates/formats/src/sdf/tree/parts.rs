//! Parts of the mechanism with their elements, for findings.

use crate::reading::document::element_tree::ElementId;
use percuss_mechanism::{ClosureDescription, CouplingDescription, JointDescription, LinkDescription};

/// Links, joints, closures and couplings of a model, each with its element.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    pub links: Vec<(LinkDescription, LinkOrigin)>,
    pub joints: Vec<(JointDescription, ElementId)>,
    pub closures: Vec<(ClosureDescription, ElementId)>,
    pub couplings: Vec<(CouplingDescription, ElementId)>,
}

/// Origin of a link of the mechanism.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkOrigin {
    pub element: ElementId,
    /// Index of the link in the model; `None` for the ground, frames and links within a chain of joints.
    pub link: Option<usize>,
    /// True if the inertia has default values of the format.
    pub has_default_inertia: bool,
}
