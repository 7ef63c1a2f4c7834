//! Coulomb friction at a contact whose two sides have one relative motion: closed form.

use crate::friction::phases::RestitutionLaw;
use crate::tolerances::{NO_SLIDING, ONE_MOTION, WEDGED};
use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{ContactResponse, EffectiveMass, PointVelocity, Pose};

/// Contact of one relative motion, such as the stop of a suspension.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OneMotion {
    /// m̄, kg.
    pub mass: f64,
    /// t: sliding speed of the contact point per closing speed.
    pub slope: f64,
    /// Direction of the sliding while the gap closes, in the link's axes; zero without sliding.
    pub direction: Vector3<f64>,
}

/// Impulses and restitution of a contact of one relative motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OneMotionImpact {
    /// Normal impulses of compression and expansion, N·s.
    pub impulses: [f64; 2],
    /// Friction along the sliding direction of compression and expansion, N·s; both opposite to the sliding.
    pub frictions: [f64; 2],
    /// Separation speed divided by closing speed.
    pub kinematic_restitution: f64,
    pub is_wedged: bool,
}

impl OneMotion {
    /// `None` if the two sides have several relative motions, or if the other side is a free body.
    pub fn new(pose: &Pose, response: &ContactResponse) -> Option<Self> {
        let contact = &response.contact;
        let EffectiveMass::Finite(mass) = response.effective_mass else { return None };
        let has_other = response.contributions.as_ref().is_some_and(|c| c.other_mass.is_some());
        let velocity = match pose.point_velocity(response, contact.link, &contact.point_link) {
            Some(PointVelocity::Known(velocity)) if !has_other => velocity,
            _ => return None,
        };
        if !is_one_motion(pose, response, &velocity, mass) {
            return None;
        }
        let frame = pose.link_in_root(contact.link);
        let normal = contact.normal_link;
        let along = frame.inverse_vector(&velocity);
        let sliding = along - normal * normal.dot(&along);
        let slope = sliding.norm();
        let (slope, direction) = match slope > NO_SLIDING * along.norm() {
            true => (slope, sliding / slope),
            false => (0.0, Vector3::zeros()),
        };
        Some(Self { mass, slope, direction })
    }

    /// Impact at the closing speed `speed`, m/s. The point slides in compression and slides back in expansion; it sticks only if it stops.
    pub fn impact(
        &self,
        speed: f64,
        restitution: f64,
        friction: f64,
        law: RestitutionLaw,
    ) -> OneMotionImpact {
        // A point that does not slide needs no friction.
        let friction = if self.slope > 0.0 { friction } else { 0.0 };
        let product = friction * self.slope;
        let is_wedged = product >= 1.0 - WEDGED;
        let compression = self.mass * speed / (1.0 + product);
        if law == RestitutionLaw::Algebraic {
            // Full friction against the first sliding, also in expansion.
            let expansion = restitution * compression;
            return OneMotionImpact {
                impulses: [compression, expansion],
                frictions: [-friction * compression, -friction * expansion],
                kinematic_restitution: restitution,
                is_wedged: false,
            };
        }
        let (expansion, kinematic_restitution) = match law {
            _ if is_wedged => (0.0, 0.0),
            RestitutionLaw::Poisson => {
                (restitution * compression, restitution * ((1.0 - product) / (1.0 + product)))
            }
            RestitutionLaw::Newton => (self.mass * speed * restitution / (1.0 - product), restitution),
            RestitutionLaw::Energetic | RestitutionLaw::Algebraic => {
                let root = ((1.0 - product) * (1.0 + product)).sqrt();
                let reached = restitution * ((1.0 - product) / (1.0 + product)).sqrt();
                (self.mass * speed * restitution / root, reached)
            }
        };
        OneMotionImpact {
            impulses: [compression, expansion],
            // The sliding reverses between both phases.
            frictions: [-friction * compression, friction * expansion],
            kinematic_restitution,
            is_wedged,
        }
    }
}

/// True if the two sides have one relative motion at the contact point: W = v vᵀ/m̄, of rank one.
fn is_one_motion(pose: &Pose, response: &ContactResponse, velocity: &Vector3<f64>, mass: f64) -> bool {
    let Ok(inertia) = pose.inverse_operational_inertia(&response.contact) else { return false };
    let block = |r: usize, c: usize| inertia.matrix().fixed_view::<3, 3>(r, c).into_owned();
    let mobility: Matrix3<f64> = block(3, 3) - block(3, 9) - block(9, 3) + block(9, 9);
    let expected = velocity * velocity.transpose() / mass;
    (mobility - expected).norm() <= ONE_MOTION * mobility.norm()
}
