//! What the file of a contact law holds.

/// The name, formula and source of a law, and its approximation.
pub(super) struct Facts {
    pub name: &'static str,
    pub title: &'static str,
    pub formula: &'static str,
    pub source: &'static str,
    /// The dissipation number a = d v that it takes for the restitution e; none where the law is solved exactly.
    pub approximation: Option<fn(f64) -> f64>,
}
