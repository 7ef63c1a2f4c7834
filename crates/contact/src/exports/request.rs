//! What is asked of a tool.

use super::ExportError;
use crate::error::{positive, unit_interval};
use crate::limits;
use crate::{CompliantContact, ContactLawError};

/// A contact, and the required restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The effective mass and the spring.
    pub contact: CompliantContact,
    /// The coefficient of restitution e, from 0 to 1.
    pub restitution: f64,
    /// The approach speed in m/s, above 0, for the tools whose numbers depend on it.
    pub speed: Option<f64>,
    /// What only some tools need.
    pub options: Options,
}

/// What only some tools need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// How far the measured restitution may be from the one asked for: above 0, at most 0.1.
    pub accuracy: f64,
    /// The tool's time step in s, where it is given; else the one that holds the accuracy.
    pub time_step: Option<f64>,
    /// The struck body's own mass in kg, without the links attached by joints: Chrono divides by it.
    pub own_mass: Option<f64>,
    /// The same of the other body, in kg. Chrono gives a fixed body without a mass 1 kg.
    pub other_own_mass: Option<f64>,
    /// MuJoCo's Â m̄, how much its estimate of the contact's inverse mass is off: Â is the sum of `body_invweight0[0]`
    /// of the two bodies.
    pub diagonal_ratio: Option<f64>,
    /// The stop of a joint, and not a contact between bodies. Of a joint that turns, the contact's mass is an inertia in
    /// kg·m², its stiffness in N·m/rad, and the speed in rad/s.
    pub stop: Option<StopMotion>,
    /// The mechanism has what simulators hold by constraints: closed loops, mimics, locks, held points.
    pub constrained: bool,
    /// Of these, closed loops.
    pub closed_loops: bool,
    /// Effective mass at the contact of the two bodies without their joints, in kg: iterative solvers converge by its
    /// ratio to m̄. Equal to m̄ where no joint takes part in the impact.
    pub free_mass: Option<f64>,
    /// Number of rigid bodies of the mechanism that move.
    pub moving_bodies: Option<usize>,
    /// Change of m̄ during the impact.
    pub drift: Option<MassDrift>,
}

/// Change of the effective mass during an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassDrift {
    /// m̄ at the penetration over m̄ at the first touch, less 1.
    pub relative: f64,
    /// The penetration, in m; in rad for a stop that turns.
    pub penetration: f64,
}

/// How a joint moves into its stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum StopMotion {
    /// It turns.
    Turn,
    /// It slides.
    Slide,
}

/// The units of a stop's numbers.
pub(super) struct StopUnits {
    pub(super) stiffness: &'static str,
    pub(super) damping: &'static str,
    /// Of the reciprocal of stiffness times time.
    pub(super) softness: &'static str,
    pub(super) coordinate: &'static str,
}

impl StopMotion {
    pub(super) fn units(self) -> StopUnits {
        match self {
            Self::Turn => StopUnits {
                stiffness: "N·m/rad",
                damping: "N·m·s/rad",
                softness: "rad/(N·m·s)",
                coordinate: "rad",
            },
            Self::Slide => {
                StopUnits { stiffness: "N/m", damping: "N·s/m", softness: "m/(N·s)", coordinate: "m" }
            }
        }
    }
}

impl Options {
    /// The own mass of the struck body, as [`ExportError::Missing`] names it.
    pub const OWN_MASS: &str = "the struck body's own mass, kg";
}

impl Default for Options {
    fn default() -> Self {
        Self {
            accuracy: limits::DEFAULT_ACCURACY,
            time_step: None,
            own_mass: None,
            other_own_mass: None,
            diagonal_ratio: None,
            stop: None,
            constrained: false,
            closed_loops: false,
            free_mass: None,
            moving_bodies: None,
            drift: None,
        }
    }
}

impl Request {
    /// A request with the default options and no speed.
    pub fn new(contact: CompliantContact, restitution: f64) -> Self {
        Self { contact, restitution, speed: None, options: Options::default() }
    }

    /// The same at an approach speed in m/s.
    pub fn at(self, speed: f64) -> Self {
        Self { speed: Some(speed), ..self }
    }

    /// True if joints take part in the impact: m̄ differs from that of the bodies without joints. `None` if that is unknown.
    pub(super) fn jointed(&self) -> Option<bool> {
        let free = self.options.free_mass?;
        Some((self.contact.mass() / free - 1.0).abs() > limits::SAME_MASS)
    }

    /// Whether every number is in its range.
    pub(super) fn check(&self) -> Result<(), ExportError> {
        unit_interval("restitution", self.restitution)?;
        let accuracy = self.options.accuracy;
        if !limits::ACCURACIES.contains(&accuracy) {
            let (what, valid) = ("accuracy of the restitution", "a number from 1e-9 to 0.1");
            return Err(ContactLawError::OutOfRange { what, got: accuracy, valid }.into());
        }
        let optional = [
            ("approach speed, m/s", self.speed),
            ("time step, s", self.options.time_step),
            ("struck body's own mass, kg", self.options.own_mass),
            ("other body's own mass, kg", self.options.other_own_mass),
            ("MuJoCo's diagonal ratio", self.options.diagonal_ratio),
            ("effective mass of the bodies without joints, kg", self.options.free_mass),
        ];
        for (what, value) in optional {
            value.map(|value| positive(what, value)).transpose()?;
        }
        Ok(())
    }
}
