//! Request for an export, and its options.

use super::ExportError;
use crate::error::{LawParameter, not_negative, positive, unit_interval};
use crate::limits;
use crate::{CompliantContact, ContactLawError};

/// Contact and required restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request<'a> {
    /// Effective mass and stiffness.
    pub contact: CompliantContact<'a>,
    /// Coefficient of restitution e, 0 to 1.
    pub restitution: f64,
    /// Approach speed, m/s, above 0; required by tools with parameters that depend on the speed.
    pub speed: Option<f64>,
    /// Options of some tools.
    pub options: Options,
}

/// Options of some tools.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Permitted error of the restitution: above 0, at most 0.1.
    pub accuracy: f64,
    /// Time step, s; `None` for the step that the accuracy requires.
    pub time_step: Option<f64>,
    /// Mass of the contact body, kg, without links on joints: Chrono divides by it.
    pub own_mass: Option<f64>,
    /// Mass of the other body, kg. Chrono gives a fixed body without a mass 1 kg.
    pub other_own_mass: Option<f64>,
    /// Â m̄, ratio of MuJoCo's estimate of the inverse mass to the inverse effective mass: Â is the sum of
    /// `body_invweight0[0]` of the two bodies.
    pub diagonal_ratio: Option<f64>,
    /// Stop of a joint instead of a contact between bodies. For a revolute joint the mass is an inertia in kg·m², the
    /// stiffness is in N·m/rad and the speed in rad/s.
    pub stop: Option<StopMotion>,
    /// True if simulators enforce parts of the mechanism by constraints: closed loops, mimics, locks, held points.
    pub constrained: bool,
    /// True if the mechanism has closed loops.
    pub closed_loops: bool,
    /// True if a mass is given without a mechanism, so that closed loops are possible. MuJoCo's parameters of equality
    /// constraints are exported too; without loops they have no effect.
    pub loops_unknown: bool,
    /// Effective mass at the contact of the two bodies without joints, kg. Its ratio to m̄ determines the convergence
    /// of iterative solvers; it is equal to m̄ if no joint takes part in the impact.
    pub free_mass: Option<f64>,
    /// Curvature of the motion of the impact, 1/m: acceleration of the contact point plus the largest acceleration of
    /// a centre of mass, at constant joint rates and a closing speed of 1 m/s. For one hinge 1/l + r/l², l the
    /// distance from the hinge to the contact, r that to the centre of mass. `None` means 10/m.
    pub motion_curvature: Option<f64>,
    /// Number of moving rigid bodies of the mechanism.
    pub moving_bodies: Option<usize>,
    /// Change of m̄ during the impact.
    pub drift: Option<MassDrift>,
}

/// Change of the effective mass during an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassDrift {
    /// m̄ at the penetration over m̄ at the first touch, less 1.
    pub relative: f64,
    /// Penetration, m; rad for the stop of a revolute joint.
    pub penetration: f64,
}

/// Motion of a joint into its stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum StopMotion {
    /// Rotation.
    Turn,
    /// Translation.
    Slide,
}

/// Units of the parameters of a stop.
pub(super) struct StopUnits {
    pub(super) stiffness: &'static str,
    pub(super) damping: &'static str,
    /// Unit of 1/(stiffness · time).
    pub(super) softness: &'static str,
    pub(super) coordinate: &'static str,
}

impl StopMotion {
    /// Units of the parameters of a rotational or a translational stop.
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
            loops_unknown: false,
            free_mass: None,
            motion_curvature: None,
            moving_bodies: None,
            drift: None,
        }
    }
}

impl<'a> Request<'a> {
    /// Request with default options and without a speed.
    pub fn new(contact: CompliantContact<'a>, restitution: f64) -> Self {
        Self { contact, restitution, speed: None, options: Options::default() }
    }

    /// Request with an approach speed, m/s.
    pub fn at(self, speed: f64) -> Self {
        Self { speed: Some(speed), ..self }
    }

    /// k (N/mᵖ) and p of the spring. A force curve is replaced by a spring before a tool reads them.
    pub(super) fn power_law(&self) -> (f64, f64) {
        self.contact.power_law().unwrap_or((f64::NAN, f64::NAN))
    }

    /// True if joints take part in the impact: m̄ differs from the effective mass without joints. `None` if unknown.
    pub(super) fn is_jointed(&self) -> Option<bool> {
        let free = self.options.free_mass?;
        Some((self.contact.mass() / free - 1.0).abs() > limits::SAME_MASS)
    }

    /// Checks the range of every number.
    ///
    /// # Errors
    /// [`ExportError::Contact`]: a number out of range.
    pub fn check(&self) -> Result<(), ExportError> {
        unit_interval(LawParameter::Restitution, self.restitution)?;
        let accuracy = self.options.accuracy;
        if !limits::ACCURACIES.contains(&accuracy) {
            let (what, valid) = (LawParameter::Accuracy, "a number from 1e-9 to 0.1");
            return Err(ContactLawError::OutOfRange { what, got: accuracy, valid }.into());
        }
        let optional = [
            (LawParameter::Speed, self.speed),
            (LawParameter::TimeStep, self.options.time_step),
            (LawParameter::OwnMass, self.options.own_mass),
            (LawParameter::OtherOwnMass, self.options.other_own_mass),
            (LawParameter::DiagonalRatio, self.options.diagonal_ratio),
            ("effective mass of the bodies without joints, kg".into(), self.options.free_mass),
        ];
        for (what, value) in optional {
            value.map(|value| positive(what, value)).transpose()?;
        }
        let curvature = self.options.motion_curvature;
        curvature.map(|value| not_negative("curvature of the motion, 1/m", value)).transpose()?;
        Ok(())
    }
}
