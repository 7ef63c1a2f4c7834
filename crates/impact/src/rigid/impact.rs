//! Rigid impact at one contact.

use crate::error::ImpactError;
use crate::friction::impulse::{Friction, FrictionLaw, frictional_impulse};
use crate::motion::joint_rates::JointRates;
use crate::motion::undetermined::undetermined_joints;
use crate::reactions::reaction::Reactions;
use crate::reactions::reaction_map::{ReactionError, ReactionMap};
use percuss_dynamics::{ContactResponse, EffectiveMass, LocatedContact, Pose};
use percuss_mechanism::JointId;
use percuss_spatial::Twist;

/// Rigid impact at one contact, frictionless unless [`with_friction`](Self::with_friction).
///
/// | quantity       | equation                  | unit       |
/// |----------------|---------------------------|------------|
/// | impulse        | p = (1+e) m̄ c             | N·s        |
/// | rates after    | q̇⁺ = q̇⁻ − (1+e) c v*      | rad/s, m/s |
/// | energy loss    | ½ m̄ (1−e²) c²             | J          |
///
/// The equations are exact for every mechanism with ideal joints. Sources: Wittenburg 2008, §6; Zheng and Hemami 1985.
#[derive(Clone, Debug)]
pub struct RigidImpact {
    /// e: separation speed divided by closing speed.
    pub restitution: f64,
    /// c: closing speed before the impact, m/s.
    pub closing_speed: f64,
    /// p: impulse between the two sides, N·s. −p n̂ acts on the contact link.
    pub impulse: f64,
    /// Lost kinetic energy, J.
    pub energy_loss: f64,
    /// Rates before the impact. If none were given: v* c, the motion of least energy with this closing speed.
    pub before: JointRates,
    /// Rates after the impact.
    pub after: JointRates,
    /// Joints whose rates after the impact are not determined: a motion without mass moves them.
    pub undetermined: Vec<JointId>,
    /// Friction; `None` for a frictionless impact.
    pub friction: Option<Friction>,
    /// Reactions to the impulse.
    pub reactions: Reactions,
}

impl RigidImpact {
    /// Empty impact, without allocated memory, as the output of [`ImpactsAtPose::impact_into`](crate::ImpactsAtPose::impact_into).
    pub fn none() -> Self {
        let at_rest = JointRates { joints: Vec::new(), base: Twist::zero() };
        Self {
            restitution: 0.0,
            closing_speed: 0.0,
            impulse: 0.0,
            energy_loss: 0.0,
            before: at_rest.clone(),
            after: at_rest,
            undetermined: Vec::new(),
            friction: None,
            reactions: Reactions::none(),
        }
    }

    /// Impact with the closing speed `closing_speed` (m/s) and the coefficient of restitution `restitution`.
    ///
    /// `before`: rates before the impact; `None` for the motion v* c. Other motions with the same closing speed have
    /// the same impulse and the same reactions.
    ///
    /// # Errors
    /// [`ImpactError`]: values out of range; an immovable or massless contact.
    pub fn new(
        pose: &Pose,
        response: &ContactResponse,
        closing_speed: f64,
        restitution: f64,
        before: Option<JointRates>,
    ) -> Result<Self, ImpactError> {
        Self::with_reaction_map(pose, &ReactionMap::new(pose), response, closing_speed, restitution, before)
    }

    /// Impact as by [`new`](Self::new), with the reaction map of the pose: for several contacts or speeds at one pose.
    ///
    /// # Errors
    /// [`ImpactError`]: as for [`new`](Self::new).
    pub fn with_reaction_map(
        pose: &Pose,
        map: &ReactionMap,
        response: &ContactResponse,
        closing_speed: f64,
        restitution: f64,
        before: Option<JointRates>,
    ) -> Result<Self, ImpactError> {
        let mass = checked_mass(response.effective_mass, closing_speed, restitution)?;
        let impulse = (1.0 + restitution) * mass * closing_speed;
        let reactions = map.reactions(response, impulse)?;
        let (star, base) = (&response.joint_velocities, response.base_velocity);
        let before = before.unwrap_or_else(|| JointRates::scaled(star, base, closing_speed));
        let after = before.plus_scaled_motion(star, base, -(1.0 + restitution) * closing_speed);
        Ok(Self {
            restitution,
            closing_speed,
            impulse,
            energy_loss: 0.5 * mass * (1.0 - restitution * restitution) * closing_speed * closing_speed,
            before,
            after,
            undetermined: undetermined_joints(pose, response),
            friction: None,
            reactions,
        })
    }
}

impl RigidImpact {
    /// Impact as by [`new`](Self::new), with friction; see [`Friction`]. The sliding velocity before the impact is that of
    /// `before`; without rates, that of the motion v* c.
    ///
    /// # Errors
    /// [`ImpactError`]: as for [`new`](Self::new); an impact without an end.
    pub fn with_friction(
        pose: &Pose,
        response: &ContactResponse,
        closing_speed: f64,
        restitution: f64,
        friction: FrictionLaw,
        before: Option<JointRates>,
    ) -> Result<Self, ImpactError> {
        let map = ReactionMap::new(pose);
        let smooth = Self::with_reaction_map(pose, &map, response, closing_speed, restitution, before)?;
        let found =
            frictional_impulse(pose, &map, response, closing_speed, restitution, friction, &smooth.before)?;
        Ok(Self {
            impulse: found.normal,
            energy_loss: found.energy_loss,
            after: smooth.before.plus_scaled(&found.change, 1.0),
            friction: Some(found.friction),
            reactions: map.reactions(&found.response, found.total)?,
            ..smooth
        })
    }
}

/// Mass of a finite m̄, kg. Refuses an immovable or massless contact, and a closing speed or a restitution out of range.
pub(crate) fn checked_mass(
    mass: EffectiveMass,
    closing_speed: f64,
    restitution: f64,
) -> Result<f64, ImpactError> {
    if !(0.0..=1.0).contains(&restitution) {
        return Err(ImpactError::Restitution { got: restitution });
    }
    if !(closing_speed.is_finite() && closing_speed > 0.0) {
        return Err(ImpactError::ClosingSpeed { got: closing_speed });
    }
    match mass {
        EffectiveMass::Finite(mass) => Ok(mass),
        EffectiveMass::Immovable => Err(ImpactError::Immovable),
        EffectiveMass::Massless => Err(ReactionError::Massless.into()),
    }
}

/// Closing speed c = j q̇ of a contact at given rates, m/s; negative if the gap opens.
pub fn closing_speed(pose: &Pose, contact: &LocatedContact, rates: &JointRates) -> f64 {
    let row = pose.contact_row(contact);
    row.iter().zip(rates.coordinates(pose)).map(|(j, u)| j * u).sum()
}

/// Greatest closing speed, m/s, at which the jump of no joint rate exceeds its limit, min limit / ((1+e) |v*|), with the
/// joint that limits it. `None` if the impact changes no limited rate.
///
/// `limits`: joint, velocity index within the joint, and largest permitted jump, rad/s or m/s. Source: Walker 1994.
pub fn greatest_closing_speed(
    response: &ContactResponse,
    restitution: f64,
    limits: &[(JointId, usize, f64)],
) -> Option<(f64, JointId)> {
    let speed = |&(joint, k, limit): &(JointId, usize, f64)| {
        let rate = response.joint_velocities.get(joint.index())?.get(k)?.abs();
        (rate > 0.0).then_some((limit / ((1.0 + restitution) * rate), joint))
    };
    limits.iter().filter_map(speed).min_by(|(a, _), (b, _)| a.total_cmp(b))
}

/// Greatest closing speed, m/s, at which the impulse in no gear exceeds its limit, min limit / ((1+e) armature |v*|), with the joint
/// that limits it. `None` if the impact changes the rate of no limited rotor.
///
/// `limits`: joint, velocity index within the joint, and largest permitted impulse between rotor and joint, N·m·s or N·s. Source: Walker
/// 1994 for rates, applied to the impulses armature · Δq̇.
pub fn greatest_closing_speed_of_gears(
    pose: &Pose,
    response: &ContactResponse,
    restitution: f64,
    limits: &[(JointId, usize, f64)],
) -> Option<(f64, JointId)> {
    let armature = |joint, k: usize| pose.armature(joint).get(k).copied().unwrap_or(0.0);
    // An impulse limit divided by the armature is a limit of the jump of the rate. A joint without armature has no gear.
    let with_gear = limits.iter().filter(|&&(joint, k, _)| armature(joint, k) > 0.0);
    let rates: Vec<_> = with_gear.map(|&(joint, k, limit)| (joint, k, limit / armature(joint, k))).collect();
    greatest_closing_speed(response, restitution, &rates)
}
