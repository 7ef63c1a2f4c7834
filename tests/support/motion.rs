//! Velocities that satisfy the conditions.

use nalgebra::{DVector, Vector3};
use percuss_dynamics::{Base, ContactResponse, System};
use percuss_spatial::Twist;
use rand::{Rng, rngs::StdRng};

/// Velocities of all joints, and the twist of the root link in its own axes.
#[derive(Clone, Debug)]
pub struct Motion {
    /// One list per joint.
    pub joints: Vec<Vec<f64>>,
    /// Twist of the root link.
    pub base: Twist<f64>,
}

impl Motion {
    /// v* of a response.
    pub fn of(response: &ContactResponse) -> Self {
        Self { joints: response.joint_velocities.clone(), base: response.base_velocity }
    }

    /// Random motion: locked joints and a fixed base are at rest, mimics follow.
    pub fn random(rng: &mut StdRng, system: &System) -> Self {
        let mechanism = system.mechanism();
        let mut number = || rng.random_range(-1.0..1.0);
        let mut joints: Vec<Vec<f64>> = Vec::new();
        for id in mechanism.joint_ids() {
            let still = system.is_locked(id);
            let dofs = mechanism.joint(id).kind().dofs();
            joints.push((0..dofs).map(|_| if still { 0.0 } else { number() }).collect());
        }
        for id in mechanism.joint_ids() {
            if let Some(mimic) = mechanism.joint(id).mimic() {
                joints[id.index()] = vec![mimic.multiplier * joints[mimic.master.index()][0]];
            }
        }
        let base = match system.base() {
            Base::Fixed => Twist::zero(),
            Base::Floating => {
                let mut vector = || Vector3::from_fn(|_, _| number());
                Twist::new(vector(), vector())
            }
        };
        Self { joints, base }
    }

    /// Velocities in the order of the system's coordinates: the floating base, then every joint that is neither locked
    /// nor a mimic, in tree order.
    pub fn coordinates(&self, system: &System) -> DVector<f64> {
        let mechanism = system.mechanism();
        let mut u = Vec::new();
        if system.base() == Base::Floating {
            u.extend(self.base.angular.iter().chain(&self.base.linear));
        }
        for id in mechanism.order().iter().filter_map(|&link| mechanism.parent_joint(link)) {
            if !system.is_locked(id) && mechanism.joint(id).mimic().is_none() {
                u.extend(&self.joints[id.index()]);
            }
        }
        DVector::from_vec(u)
    }

    /// Motion with these coordinates; mimics follow.
    pub fn from_coordinates(system: &System, u: &DVector<f64>) -> Self {
        let mechanism = system.mechanism();
        let kinds = mechanism.joints().iter().map(|joint| joint.kind().dofs());
        let mut motion = Self { joints: kinds.map(|dofs| vec![0.0; dofs]).collect(), base: Twist::zero() };
        for ((joint, component), value) in system.coordinate_joints().into_iter().zip(u.iter()) {
            match joint {
                Some(id) => motion.joints[id.index()][component] = *value,
                None if component < 3 => motion.base.angular[component] = *value,
                None => motion.base.linear[component - 3] = *value,
            }
        }
        // A mimic's master may itself be a mimic of a later joint.
        for _ in mechanism.joints() {
            for id in mechanism.joint_ids() {
                if let Some(mimic) = mechanism.joint(id).mimic() {
                    motion.joints[id.index()] =
                        vec![mimic.multiplier * motion.joints[mimic.master.index()][0]];
                }
            }
        }
        motion
    }

    /// Sum of all rates: an upper bound of a link's angular velocity.
    pub fn size(&self) -> f64 {
        let base = self.base.angular.abs().sum() + self.base.linear.abs().sum();
        base + self.joints.iter().flatten().map(|v| v.abs()).sum::<f64>()
    }
}
