//! Records of impacts, what is known about them, and the result of an identification.

use nalgebra::DVector;
use serde::Serialize;

/// Fewest samples of a record.
pub const LEAST_SAMPLES: usize = 20;
/// Most samples of all signals and records together, around the impacts.
pub const MOST_SAMPLES: usize = 200_000;
/// Part of the largest value, and of the duration, above which residuals contradict the law.
const CONTRADICTION: f64 = 0.02;
/// Exponents of the spring that are searched.
pub const EXPONENTS: std::ops::RangeInclusive<f64> = 0.5..=8.0;

/// Measured quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Measured {
    /// Contact force, N.
    Force,
    /// Acceleration of the mass, m/s². An offset, such as that of gravity, is identified.
    Acceleration,
    /// Closing speed, m/s.
    Velocity,
    /// Displacement in the direction of the penetration, m, from any origin.
    Displacement,
}

impl Measured {
    /// All quantities.
    pub const ALL: [Self; 4] = [Self::Force, Self::Acceleration, Self::Velocity, Self::Displacement];

    /// Name, and the unit of its values.
    pub fn name_and_unit(self) -> (&'static str, &'static str) {
        match self {
            Self::Force => ("force", "N"),
            Self::Acceleration => ("acceleration", "m/s²"),
            Self::Velocity => ("velocity", "m/s"),
            Self::Displacement => ("displacement", "m"),
        }
    }
}

/// Signal of a record, SI units, in either direction: the identification finds which.
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    /// Quantity.
    pub quantity: Measured,
    /// Value at each time.
    pub values: Vec<f64>,
}

/// Record of one impact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Times, s, increasing.
    pub times: Vec<f64>,
    /// Signals, each of another quantity.
    pub signals: Vec<Signal>,
    /// Known approach speed, m/s; `None`: it is identified.
    pub speed: Option<f64>,
}

/// Form of the damper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum DamperForm {
    /// c δ^((p−1)/2) δ̇.
    KelvinVoigt,
    /// d k δᵖ δ̇.
    HuntCrossley,
}

/// What is known beside the records.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Known {
    /// Effective mass, kg: used where the records do not determine it.
    pub mass: Option<f64>,
    /// Acceleration of gravity along the motion, m/s².
    pub gravity: f64,
    /// Exponent of the spring.
    pub exponent: Option<f64>,
    /// Form of the damper; `None`: the form with the smaller residuals.
    pub damper: Option<DamperForm>,
    /// Channel frequency class of the filter that the signals have passed (SAE J211-1: phaseless Butterworth filter of fourth order), Hz.
    pub filter_class: Option<f64>,
}

/// Identified value with its standard uncertainty.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Estimate {
    /// Value.
    pub value: f64,
    /// Standard uncertainty; 0 for a known value. The true value lies within two standard uncertainties in 95 of 100 cases.
    pub uncertainty: f64,
}

/// Use of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SampleUse {
    /// Used.
    Used,
    /// At the limit of the sensor, or so near that its noise is cut off.
    AtLimit,
    /// Outlier.
    Outlier,
    /// At a jump of the force at the touch, which no sensor follows.
    AtTouch,
}

impl SampleUse {
    /// Name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Used => "used",
            Self::AtLimit => "at the limit",
            Self::Outlier => "outlier",
            Self::AtTouch => "at the touch",
        }
    }
}

/// Signal of a record after the identification.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IdentifiedSignal {
    /// Quantity.
    pub quantity: Measured,
    /// True if the values fall where a pushing force, the deceleration, the closing speed or the penetration grows.
    pub is_reversed: bool,
    /// Value of the sensor without force or penetration, at the touch; null for a velocity.
    pub offset: Option<Estimate>,
    /// Change of the offset, per second; null for a velocity and a displacement.
    pub drift: Option<Estimate>,
    /// Root mean square of the residuals.
    pub residual: f64,
    /// Residual relative to the largest value.
    pub relative_residual: f64,
    /// Time over which residuals are correlated, s; 0 if neighbours are independent.
    pub correlation_time: f64,
    /// Root mean square of the residuals during the contact divided by that before and after it, by which the uncertainties are larger; null if the residuals are independent, or not
    /// significantly larger during the contact.
    pub excess: Option<f64>,
    /// Number of samples at the limit of the sensor, which are not used.
    pub clipped: usize,
    /// Times of outliers, s, which are not used.
    pub outliers: Vec<f64>,
    /// Number of samples beside a jump of the force at the touch, which are not used.
    pub at_touch: usize,
    /// Use of each sample at the used times.
    #[serde(skip)]
    pub uses: Vec<SampleUse>,
    /// Values of the identified contact at the used times, with offset and drift, in the direction of the signal.
    #[serde(skip)]
    pub fitted: Vec<f64>,
}

impl IdentifiedSignal {
    /// True if the contact has another law: the residuals are larger during the contact than beside it, or they are above 2 % of the largest
    /// value and correlated over 2 % of the duration of the contact, s.
    pub fn contradicts(&self, duration: f64) -> bool {
        let is_correlated = self.correlation_time > CONTRADICTION * duration;
        is_correlated && (self.relative_residual > CONTRADICTION || self.excess.is_some())
    }
}

/// Record after the identification.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IdentifiedRecord {
    /// Approach speed, m/s.
    pub speed: Estimate,
    /// Rebound speed divided by approach speed.
    pub restitution: Estimate,
    /// Largest contact force, N.
    pub peak_force: Estimate,
    /// Largest penetration, m.
    pub max_penetration: Estimate,
    /// Duration of the contact, s.
    pub contact_duration: Estimate,
    /// Time of the touch, s.
    pub touch: Estimate,
    /// First and last used time, s.
    pub used: [f64; 2],
    /// Number of samples outside these times.
    pub unused_samples: usize,
    /// Index of the first used sample.
    #[serde(skip)]
    pub first: usize,
    /// Signals.
    pub signals: Vec<IdentifiedSignal>,
}

/// Result of another model of the contact: the values of the first record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OtherModel {
    /// Mean square of the residuals of the other model divided by that of the result.
    pub ratio: f64,
    /// m̄, kg.
    pub mass: f64,
    /// Approach speed, m/s.
    pub speed: f64,
    /// Restitution.
    pub restitution: f64,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// Duration, s.
    pub contact_duration: f64,
}

impl OtherModel {
    /// Values from the quantities of a result.
    pub(super) fn new(ratio: f64, figures: &DVector<f64>) -> Self {
        let [speed, restitution, _, max_penetration, contact_duration] = [4, 5, 6, 7, 8].map(|k| figures[k]);
        Self { ratio, mass: figures[0], speed, restitution, max_penetration, contact_duration }
    }
}

/// Identified contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Identification {
    /// Form of the damper.
    pub damper: DamperForm,
    /// Mean square of the residuals with the other form, divided by that with this form; `None` if the form is known, or has no motion.
    pub other_form: Option<f64>,
    /// Coefficient c (N/m^q) and exponent q of a second term c x^q of the spring; `None` if one term suffices.
    pub second_term: Option<(Estimate, f64)>,
    /// The result with one term of the spring in place of two, or with two in place of the one with the given exponent; `None` if two terms are
    /// not significantly better. With a given exponent the uncertainties of the mass and of the records include the difference.
    pub other_spring: Option<OtherModel>,
    /// The result with the weight, or without a given weight, if the residuals do not exclude it and it differs by more than two standard
    /// uncertainties; true if the residuals are significantly smaller with it.
    pub other_weight: Option<(bool, OtherModel)>,
    /// m̄, kg; a known mass that the records do not determine has the uncertainty 0.
    pub mass: Estimate,
    /// True if the records determine the mass.
    pub finds_mass: bool,
    /// k, N/mᵖ.
    pub stiffness: Estimate,
    /// p, with the uncertainty 0 at an end of [`EXPONENTS`].
    pub exponent: Estimate,
    /// c, N·s/m^((p+1)/2), or d, s/m.
    pub damping: Estimate,
    /// Correlation of mass, stiffness, exponent and damping; 0 for a known value.
    pub correlation: [[f64; 4]; 4],
    /// Records.
    pub records: Vec<IdentifiedRecord>,
}

/// True if a record has a signal of this quantity.
pub(super) fn has(record: &Record, quantity: Measured) -> bool {
    record.signals.iter().any(|signal| signal.quantity == quantity)
}

/// True if a record determines the mass.
pub(super) fn finds_mass(record: &Record) -> bool {
    has(record, Measured::Force) && (record.signals.len() > 1 || record.speed.is_some())
}
