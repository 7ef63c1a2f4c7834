//! Optional tool on the coupler of a linkage.

/// Attachment of one additional link to the coupler.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// No tool.
    None,
    /// Fixed joint.
    Fixed,
    /// Hinge about a general axis: one more degree of freedom.
    Hinged,
}
