//! Coulomb friction at a contact whose two sides have one relative motion: closed form.

use crate::error::ImpactError;
use crate::tolerances::ONE_MOTION;
use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{Contact, ContactResponse, Direction, EffectiveMass, Frame, PointVelocity, Pose};

/// Friction at a contact of one relative motion, such as the stop of a suspension.
///
/// The contact point moves along one direction only: at unit closing speed it slides with t = |J_t v*|. It sticks only
/// by stopping. Stronge's energetic coefficient of restitution e defines the rebound.
///
/// | quantity               | equation                                        | unit |
/// |------------------------|-------------------------------------------------|------|
/// | normal impulse         | p = m̄ c [1/(1+µt) + e/√(1−µ²t²)]                | N·s  |
/// | kinematic restitution  | e √((1−µt)/(1+µt)); 0 if wedged                 | 1    |
/// | wedging                | µt ≥ 1: no rebound, p = m̄ c/(1+µt)              | –    |
///
/// Derived from the energetic restitution of Stronge 1990 for a mobility matrix of rank one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// µ: coefficient of friction.
    pub coefficient: f64,
    /// t: sliding speed of the contact point per closing speed.
    pub slope: f64,
    /// µt ≥ 1: the contact does not rebound.
    pub is_wedged: bool,
    /// Separation speed divided by closing speed.
    pub kinematic_restitution: f64,
    /// Impulse of the friction on the contact link, N·s, in the link's axes.
    pub tangential_impulse: Vector3<f64>,
}

/// Impulse of an impact with friction, and its direction.
pub(crate) struct FrictionalImpulse {
    pub friction: Friction,
    /// Normal impulse, N·s.
    pub normal: f64,
    /// Magnitude of the whole impulse, N·s.
    pub total: f64,
    /// Response of the contact along the whole impulse.
    pub response: ContactResponse,
}

/// Impulse of an impact with friction at the closing speed `speed` (m/s).
///
/// # Errors
/// [`ImpactError`]: a coefficient of friction out of range; a contact with several relative motions.
pub(crate) fn frictional_impulse(
    pose: &Pose,
    response: &ContactResponse,
    speed: f64,
    restitution: f64,
    coefficient: f64,
) -> Result<FrictionalImpulse, ImpactError> {
    if !(coefficient.is_finite() && coefficient >= 0.0) {
        return Err(ImpactError::Friction { got: coefficient });
    }
    let contact = &response.contact;
    let EffectiveMass::Finite(mass) = response.effective_mass else { return Err(ImpactError::Immovable) };
    let has_other = response.contributions.as_ref().is_some_and(|c| c.other_mass.is_some());
    let velocity = match pose.point_velocity(response, contact.link, &contact.point_link) {
        Some(PointVelocity::Known(velocity)) if !has_other => velocity,
        _ => return Err(ImpactError::SeveralMotions),
    };
    if !is_one_motion(pose, response, &velocity, mass) {
        return Err(ImpactError::SeveralMotions);
    }
    let frame = pose.link_in_root(contact.link);
    let normal = contact.normal_link;
    let along = frame.inverse_vector(&velocity);
    let sliding = along - normal * normal.dot(&along);
    let slope = sliding.norm();
    let direction = if slope > 0.0 { sliding / slope } else { Vector3::zeros() };
    let product = coefficient * slope;
    let is_wedged = product >= 1.0;
    let compression = mass * speed / (1.0 + product);
    let (expansion, kinematic_restitution) = if is_wedged {
        (0.0, 0.0)
    } else {
        let root = ((1.0 - product) * (1.0 + product)).sqrt();
        (mass * speed * restitution / root, restitution * ((1.0 - product) / (1.0 + product)).sqrt())
    };
    // Friction opposes the sliding, which reverses between both phases.
    let tangential_impulse = direction * (-coefficient * (compression - expansion));
    let impulse = normal * (compression + expansion) - tangential_impulse;
    let whole = Contact {
        link: contact.link,
        against: contact.against,
        point: contact.point_link,
        normal: Direction::Along(impulse, Frame::Link),
    };
    let friction = Friction { coefficient, slope, is_wedged, kinematic_restitution, tangential_impulse };
    Ok(FrictionalImpulse {
        friction,
        normal: compression + expansion,
        total: impulse.norm(),
        response: pose.respond(&whole).map_err(|_| ImpactError::SeveralMotions)?,
    })
}

/// True if the two sides have one relative motion at the contact point: W = v vᵀ/m̄, of rank one.
fn is_one_motion(pose: &Pose, response: &ContactResponse, velocity: &Vector3<f64>, mass: f64) -> bool {
    let Ok(inertia) = pose.inverse_operational_inertia(&response.contact) else { return false };
    let block = |r: usize, c: usize| inertia.matrix().fixed_view::<3, 3>(r, c).into_owned();
    let mobility: Matrix3<f64> = block(3, 3) - block(3, 9) - block(9, 3) + block(9, 9);
    let expected = velocity * velocity.transpose() / mass;
    (mobility - expected).norm() <= ONE_MOTION * mobility.norm()
}
