//! Friction of an impact as a record.

use crate::evaluation::friction_thresholds::FrictionThresholdsRecord;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use percuss_impact::RigidImpact;
use percuss_spatial::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

/// Coulomb friction at the contact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FrictionRecord {
    /// Coefficient of friction µ.
    pub coefficient: f64,
    /// Meaning of the coefficient of restitution: `energetic`, `poisson`, `newton` or `algebraic`.
    pub law: &'static str,
    /// Sliding speed per closing speed, t, of a contact of one relative motion; null for others.
    pub slope: Option<f64>,
    /// True if the contact sticks and does not rebound: µt ≥ 1 for one relative motion.
    pub wedged: bool,
    /// Separation speed divided by closing speed.
    pub kinematic_restitution: f64,
    /// Impulse of the friction on the contact link, N·s, world axes.
    pub tangential_impulse_world: [f64; 3],
    /// Sliding velocity of the contact link against the other side before the impact, m/s, world axes.
    pub sliding_before_world: [f64; 3],
    /// Sliding velocity after the impact.
    pub sliding_after_world: [f64; 3],
    /// Phases of the impact in order; empty for the algebraic form.
    pub phases: Vec<PhaseRecord>,
    /// Coefficient of friction above which the contact can stick; null for one relative motion.
    pub sticking_threshold: Option<f64>,
    /// Coefficient of friction above which sliding can jam; for one relative motion above which the contact wedges; null without one.
    pub jamming_threshold: Option<f64>,
    /// Results of all laws of restitution with the same coefficients.
    pub laws: Vec<LawRecord>,
}

impl FrictionRecord {
    /// Coefficients of friction at which the behaviour of the contact changes.
    pub fn thresholds(&self) -> FrictionThresholdsRecord {
        FrictionThresholdsRecord {
            slope: self.slope,
            sticking: self.sticking_threshold,
            jamming: self.jamming_threshold,
        }
    }
}

/// Phase of an impact with friction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PhaseRecord {
    /// `slip`, `jam`, `stick` or `reverse slip`.
    pub kind: &'static str,
    /// `compression` or `expansion`.
    pub stage: &'static str,
    /// Normal impulse of the phase, N·s.
    pub normal_impulse: f64,
}

/// Result of one law of restitution; null if the law has no solution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LawRecord {
    /// Law.
    pub law: &'static str,
    /// Normal impulse, N·s.
    pub normal_impulse: Option<f64>,
    /// Magnitude of the friction, N·s.
    pub tangential_impulse: Option<f64>,
    /// Separation speed, m/s.
    pub separation_speed: Option<f64>,
    /// Lost kinetic energy, J.
    pub energy_loss: Option<f64>,
    /// True if the law creates energy: its result is not valid.
    pub creates_energy: bool,
}

/// Friction with its vectors in world axes.
pub(crate) fn friction_record(evaluated: &EvaluatedQuestion, rigid: &RigidImpact) -> Option<FrictionRecord> {
    let friction = rigid.friction.as_ref()?;
    let x_wl = evaluated.pose.link(evaluated.contact.link);
    let world = |v: &Vector3<f64>| x_wl.vector(v).into();
    let phase = |phase: &percuss_impact::Phase| PhaseRecord {
        kind: phase.kind.name(),
        stage: if phase.is_expansion { "expansion" } else { "compression" },
        normal_impulse: phase.normal_impulse,
    };
    let known = |value: f64| value.is_finite().then_some(value);
    let law = |result: &percuss_impact::LawResult| LawRecord {
        law: result.law.name(),
        normal_impulse: known(result.normal_impulse),
        tangential_impulse: known(result.tangential_impulse),
        separation_speed: known(result.separation_speed),
        energy_loss: known(result.energy_loss),
        creates_energy: result.creates_energy,
    };
    Some(FrictionRecord {
        coefficient: friction.coefficient,
        law: friction.law.name(),
        slope: friction.thresholds.slope,
        wedged: friction.is_wedged,
        kinematic_restitution: friction.kinematic_restitution,
        tangential_impulse_world: world(&friction.tangential_impulse),
        sliding_before_world: world(&friction.sliding_before),
        sliding_after_world: world(&friction.sliding_after),
        phases: friction.phases.iter().map(phase).collect(),
        sticking_threshold: friction.thresholds.sticking,
        jamming_threshold: friction.thresholds.jamming,
        laws: friction.laws.iter().map(law).collect(),
    })
}
