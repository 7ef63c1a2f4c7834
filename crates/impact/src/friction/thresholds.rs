//! Coefficients of friction at which the behaviour of a contact changes.

use crate::error::ImpactError;
use crate::friction::collision::{jamming_threshold, sticking_threshold};
use crate::friction::one_motion::OneMotion;
use crate::mobility::delassus::Delassus;
use nalgebra::Matrix3;
use percuss_dynamics::{ContactResponse, EffectiveMass, Pose};

/// Coefficients of friction at which the behaviour of a contact changes. They do not depend on the velocities before the impact.
///
/// | threshold | several relative motions         | one relative motion               |
/// |-----------|----------------------------------|-----------------------------------|
/// | sticking  | µ_s = |A_tt⁻¹ a_tn|              | none                              |
/// | jamming   | µ_j = a_nn/|a_tn|                | 1/t: the contact wedges           |
///
/// a_nn, a_tn and A_tt are the blocks of the mobility of the contact point; t = |J_t v*| is the sliding speed per closing speed. With one
/// relative motion, the contact point can stick only if the whole motion stops: the contact then wedges.
/// Sources: Routh 1905; Stronge 2000, ch. 5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionThresholds {
    /// t: sliding speed per closing speed of a contact with one relative motion; `None` for other contacts.
    pub slope: Option<f64>,
    /// Coefficient of friction from which the contact can stick; `None` for one relative motion, and if no friction suffices.
    pub sticking: Option<f64>,
    /// Coefficient of friction from which sliding can jam; for one relative motion, from which the contact wedges. `None` if no friction
    /// suffices.
    pub jamming: Option<f64>,
}

impl FrictionThresholds {
    /// Thresholds of a contact of one relative motion.
    pub(crate) fn of_one_motion(motion: &OneMotion) -> Self {
        let jamming = (motion.slope > 0.0).then(|| 1.0 / motion.slope);
        Self { slope: Some(motion.slope), sticking: None, jamming }
    }

    /// Thresholds of a contact with the mobility W.
    pub(crate) fn of_mobility(mobility: &Matrix3<f64>) -> Self {
        Self { slope: None, sticking: sticking_threshold(mobility), jamming: jamming_threshold(mobility) }
    }
}

/// Thresholds of friction of a contact point with a finite effective mass.
///
/// # Errors
/// [`ImpactError`]: a moment about an axis; an immovable or massless contact; a motion without mass that moves the contact point in the
/// tangent plane.
pub fn friction_thresholds(
    pose: &Pose,
    response: &ContactResponse,
) -> Result<FrictionThresholds, ImpactError> {
    check_contact_point(response)?;
    Ok(match OneMotion::new(pose, response) {
        Some(motion) => FrictionThresholds::of_one_motion(&motion),
        None => FrictionThresholds::of_mobility(&contact_mobility(pose, response)?.block(0)),
    })
}

/// Refuses a contact without tangential friction: a moment, and a contact without a finite effective mass.
pub(crate) fn check_contact_point(response: &ContactResponse) -> Result<(), ImpactError> {
    if response.contact.is_moment {
        return Err(ImpactError::FrictionOfMoment);
    }
    match response.effective_mass {
        EffectiveMass::Finite(_) => Ok(()),
        _ => Err(ImpactError::Immovable),
    }
}

/// Mobility of the contact point, including a free body on the other side.
pub(crate) fn contact_mobility(pose: &Pose, response: &ContactResponse) -> Result<Delassus, ImpactError> {
    let mut delassus = Delassus::new(pose, std::slice::from_ref(&response.contact))?;
    let share = response.contributions.as_ref().and_then(|c| c.other_mass);
    if let (Some(share), EffectiveMass::Finite(mass)) = (share, response.effective_mass) {
        // The share of a free body of mass M is m̄/M.
        delassus.add_free_body(0, mass / share);
    }
    Ok(delassus)
}
