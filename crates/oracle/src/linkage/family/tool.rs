//! What the coupler of a linkage may bear.

/// Whether the coupler bears one more link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// No.
    None,
    /// Held by a fixed joint.
    Fixed,
    /// On a hinge of its own, about any axis: one more freedom.
    Hinged,
}
