//! What the file of a contact law holds.

/// What a law's file says about it.
pub(super) struct Facts {
    pub name: &'static str,
    pub title: &'static str,
    pub formula: &'static str,
    pub source: &'static str,
    /// The dissipation number a = d v that it takes for the restitution e; none where the law is solved exactly.
    pub approximation: Option<fn(f64) -> f64>,
}
