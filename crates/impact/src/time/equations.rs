//! Accelerations of a mechanism with constraints under a force at a contact.
//!
//! ```text
//! M u̇ + h + jᵀF = Q + Aᵀλ,   A u̇ = −Ȧ u
//! ```
//!
//! h has the terms that are quadratic in the rates u, Q is the weight. With the basis N of ker A and any u_p with
//! A u_p = −Ȧ u, the accelerations are u̇ = u_p + N a with NᵀMN a = −Nᵀ(h + jᵀF − Q + M u_p). Redundant rows do not matter.
//! Source: Featherstone 2008, §3.2 and §8.

use crate::group_rows::GroupRows;
use crate::mobility::semidefinite::{SemidefiniteSolver, unit_diagonal_scale};
use crate::motion::driver_rates::{kernel, lengths};
use crate::motion::joint_rates::JointRates;
use crate::reactions::reaction_map::ReactionMap;
use crate::tolerances::MASSLESS_ENERGY;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_dynamics::{LocatedContact, Pose};

/// Accelerations u̇ of the coordinates at the rates `u`, under the force `force` (N, −n̂ on the contact link) and the gravity
/// `gravity` (m/s², root axes). `None` if the rates do not fit the pose.
pub(crate) fn accelerations(
    pose: &Pose,
    contact: &LocatedContact,
    u: &[f64],
    force: f64,
    gravity: &Vector3<f64>,
) -> Option<Vec<f64>> {
    let n = u.len();
    let rates = rates_of(pose, u);
    let still = JointRates::at_rest(pose.mechanism());
    let map = ReactionMap::new(pose);
    let loads = map.tree().motion_loads(pose, contact, force, &rates, &still, gravity);
    let forces = map.generalised_loads(&loads, &still.joints, 1.0);
    let lengths = lengths(pose, &pose.coordinate_joints());
    let bias = pose.constraint_bias(&rates.joints, &rates.base).ok()?;
    let groups: Vec<GroupRows> = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
    let mut particular = vec![0.0; n];
    for (group, bias) in groups.iter().zip(&bias) {
        let right: Vec<f64> = bias.iter().map(|b| -b).collect();
        group.particular_rates(&right).into_iter().for_each(|(c, rate)| particular[c] = rate);
    }
    let basis = kernel(&groups, &lengths);
    let basis = DMatrix::from_fn(n, basis.ncols(), |c, k| basis[(c, k)] / lengths[c]);
    let mass = pose.mass_matrix();
    let mut accelerations = DVector::from_vec(particular);
    let loads = DVector::from_vec(forces) + &mass * &accelerations;
    let reduced = basis.transpose() * &mass * &basis;
    accelerations += &basis * solve(reduced, -(basis.transpose() * loads));
    Some(accelerations.as_slice().to_vec())
}

/// Rates of all joints at the rates of the coordinates.
pub(crate) fn rates_of(pose: &Pose, u: &[f64]) -> JointRates {
    let (joints, base) = pose.joint_velocities(u);
    JointRates { joints, base }
}

/// Solution of K a = b for a symmetric positive semi-definite K; of least norm if a motion has no mass.
fn solve(matrix: DMatrix<f64>, right: DVector<f64>) -> DVector<f64> {
    let d = right.len();
    let scale = unit_diagonal_scale(matrix.diagonal().as_slice());
    let even = DMatrix::from_fn(d, d, |r, c| scale[r] * scale[c] * 0.5 * (matrix[(r, c)] + matrix[(c, r)]));
    let scaled = DVector::from_fn(d, |k, _| scale[k] * right[k]);
    let solution = match even.clone().cholesky() {
        Some(factor) if (0..d).all(|k| factor.l_dirty()[(k, k)].powi(2) > MASSLESS_ENERGY) => {
            factor.solve(&scaled)
        }
        _ => SemidefiniteSolver::new(even).solve(&scaled),
    };
    DVector::from_fn(d, |k, _| scale[k] * solution[k])
}
