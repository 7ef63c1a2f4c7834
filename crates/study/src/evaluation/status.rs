//! Kind of a result: finite, immovable, massless.

use percuss_dynamics::EffectiveMass;
use schemars::JsonSchema;
use serde::Serialize;

/// Kind of result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// m̄ is finite.
    Finite,
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without kinetic energy closes the gap.
    Massless,
}

impl Status {
    /// Kind of an effective mass, and m̄ (kg) if finite.
    pub(crate) fn classify(mass: EffectiveMass) -> (Self, Option<f64>) {
        match mass {
            EffectiveMass::Finite(m) => (Status::Finite, Some(m)),
            EffectiveMass::Immovable => (Status::Immovable, None),
            EffectiveMass::Massless => (Status::Massless, None),
        }
    }

    /// Name in JSON and CSV.
    pub fn name(self) -> &'static str {
        match self {
            Status::Finite => "finite",
            Status::Immovable => "immovable",
            Status::Massless => "massless",
        }
    }
}

/// Unit of the effective mass of a contact. `is_moment`: the contact is a moment about an axis, and the effective mass is an inertia.
pub(crate) fn mass_unit(is_moment: bool) -> &'static str {
    if is_moment { "kg·m²" } else { "kg" }
}
