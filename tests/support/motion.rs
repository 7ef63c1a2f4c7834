//! Velocities that conditions admit.

use nalgebra::{DVector, Vector3};
use percuss_dynamics::{Base, Strike, System};
use percuss_spatial::Twist;
use rand::{Rng, rngs::StdRng};

/// Velocities of all joints, and the twist of the root link in its own axes.
#[derive(Clone, Debug)]
pub struct Motion {
    /// One list a joint.
    pub joints: Vec<Vec<f64>>,
    /// Of the root link.
    pub base: Twist<f64>,
}

impl Motion {
    /// v* of a strike.
    pub fn of(strike: &Strike) -> Self {
        Self { joints: strike.joint_velocities.clone(), base: strike.base_velocity }
    }

    /// A random motion: locked joints and a fixed base stand still, mimics follow.
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

    /// As the system's coordinates: of the floating base, then of every joint that is neither locked nor a mimic, in
    /// tree order.
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

    /// The sum of all rates: no link turns faster.
    pub fn size(&self) -> f64 {
        let base = self.base.angular.abs().sum() + self.base.linear.abs().sum();
        base + self.joints.iter().flatten().map(|v| v.abs()).sum::<f64>()
    }
}
