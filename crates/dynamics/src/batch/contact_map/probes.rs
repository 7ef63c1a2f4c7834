//! Calibration of the errors of a map, by the errors of the pose's own responses at some contacts.
//!
//! Every term of an error of 1/m̄ is the product of a motion and a transmitted wrench, or of two motions (see
//! `error_budget`). Both are linear in w. Motions are bounded by a multiple of |R w|, transmitted wrenches by a
//! multiple of |w|. The relative error is therefore at most C |w|/|R w|. C is calibrated with contacts at nine points
//! of the region, along the three stationary directions of m̄ and one fixed direction at each point. The largest C
//! found is multiplied by [`MAP_SAFETY`].

use super::ContactMap;
use crate::batch::row_results::ContactStatus;
use crate::kinematics::contact::Contact;
use crate::kinematics::outcome::EffectiveMass;
use crate::tolerances::{GOLDEN, MAP_OWN_ROUNDINGS, MAP_SAFETY, MAP_TRUSTED_ERROR};
use nalgebra::{SymmetricEigen, Vector3};

impl ContactMap<'_> {
    /// Calibrates the error coefficient. Returns true if Φ agrees with the pose's own responses.
    pub(super) fn calibrate_errors(&mut self) -> bool {
        let (centre, reach) = (self.constants.centre(), self.constants.reach());
        let mut coefficient = MAP_OWN_ROUNDINGS * f64::EPSILON;
        self.constants.set_coefficient(coefficient);
        let mut probes = Vec::new();
        for corner in 0..9_usize {
            let side = |axis: usize| if corner >> axis & 1 == 0 { -1.0 } else { 1.0 };
            let aside = Vector3::new(side(0), side(1), side(2)) * (reach / 3.0_f64.sqrt());
            let arm = if corner == 8 { Vector3::zeros() } else { aside };
            let forces = self.constants.project_forces(&arm);
            let eigen = SymmetricEigen::new(forces.transpose() * forces);
            (0..3).for_each(|i| probes.push((arm, eigen.eigenvectors.column(i).into_owned())));
            probes.push((arm, probe_direction(corner)));
        }
        for (arm, normal) in probes {
            let contact = Contact { against: self.against, ..Contact::new(self.link, centre + arm, normal) };
            let Ok(response) = self.pose.respond(&contact) else { return false };
            let own = self.status_from_inertia(&arm, &normal);
            match response.effective_mass {
                EffectiveMass::Finite(m) if own == Some(ContactStatus::Finite) => {
                    let Some(error) = response.effective_mass_error() else { return false };
                    let root_of_inverse = (self.constants.project_forces(&arm) * normal).norm_squared();
                    let differs = (1.0 / root_of_inverse / m - 1.0).abs();
                    let relative = (error / m).max(differs);
                    coefficient =
                        coefficient.max(MAP_SAFETY * relative / self.constants.stiffness(&arm, &normal));
                }
                // The map leaves this contact undecided, and computes it separately at every call.
                EffectiveMass::Finite(_) if own.is_none() => {}
                EffectiveMass::Immovable if own != Some(ContactStatus::Finite) => {}
                EffectiveMass::Massless if matches!(own, None | Some(ContactStatus::Massless)) => {}
                EffectiveMass::Finite(_) | EffectiveMass::Immovable | EffectiveMass::Massless => {
                    return false;
                }
            }
        }
        self.constants.set_coefficient(coefficient);
        coefficient <= MAP_TRUSTED_ERROR
    }

    /// Status of a contact if Φ decides the status reliably.
    fn status_from_inertia(&self, arm: &Vector3<f64>, normal: &Vector3<f64>) -> Option<ContactStatus> {
        let point = self.constants.centre() + arm;
        let contacts = super::ContactColumns {
            points: [&[point.x], &[point.y], &[point.z]],
            normals: [&[normal.x], &[normal.y], &[normal.z]],
        };
        let error = self.constants.coefficient() * self.constants.stiffness(arm, normal);
        self.known_status(contacts, 0, error)
    }
}

/// Fixed direction number `number`, from a golden spiral on the sphere.
fn probe_direction(number: usize) -> Vector3<f64> {
    let turn = std::f64::consts::TAU * (number as f64 * GOLDEN).fract();
    let z = 1.0 - (2.0 * number as f64 + 1.0) / 9.0;
    let radius = (1.0 - z * z).sqrt();
    Vector3::new(radius * turn.cos(), radius * turn.sin(), z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_unit_vectors_and_differ() {
        let all: Vec<Vector3<f64>> = (0..9).map(probe_direction).collect();
        for (i, a) in all.iter().enumerate() {
            assert!((a.norm() - 1.0).abs() < 1e-15);
            assert!(all[..i].iter().all(|b| (a - b).norm() > 0.3), "{i}");
        }
    }
}
