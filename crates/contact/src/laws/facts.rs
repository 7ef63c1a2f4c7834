//! Contents of the file of a contact law.

/// Name, formula and source of a law, and its approximation.
pub(super) struct Facts {
    pub name: &'static str,
    pub title: &'static str,
    pub formula: &'static str,
    pub source: &'static str,
    /// Dissipation number a = d v of the law for the restitution e; `None` if the law is solved exactly.
    pub approximation: Option<fn(f64) -> f64>,
}
