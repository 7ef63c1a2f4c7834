//! Joints whose rates after the impact are not determined, because of a motion without mass.

use crate::group_rows::GroupRows;
use crate::motion::driver_rates::{kernel, lengths};
use crate::tolerances::{MASSLESS_ENERGY, UNDETERMINED};
use faer::{Mat, Side};
use percuss_dynamics::{ContactResponse, Pose, Remark};
use percuss_mechanism::JointId;

/// Joints that move in an admissible motion without kinetic energy: their rates after the impact are not determined.
/// Empty unless the response reports an undetermined motion.
pub fn undetermined_joints(pose: &Pose, response: &ContactResponse) -> Vec<JointId> {
    if !response.remarks.contains(&Remark::UndeterminedMotion) {
        return Vec::new();
    }
    let coordinates = pose.coordinate_joints();
    let lengths = lengths(pose, &coordinates);
    let groups: Vec<GroupRows> = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
    let kernel = kernel(&groups, &lengths);
    let (n, mass) = (coordinates.len(), pose.mass_matrix());
    let scaled = Mat::from_fn(n, n, |r, c| mass[(r, c)] / (lengths[r] * lengths[c]));
    let reduced = kernel.transpose() * scaled * &kernel;
    let Ok(decomposition) = reduced.self_adjoint_eigen(Side::Lower) else { return Vec::new() };
    let energies = decomposition.S().column_vector().to_owned();
    let largest = energies.iter().fold(0.0, |most: f64, e| most.max(e.abs()));
    let massless: Vec<usize> =
        (0..energies.nrows()).filter(|&k| energies[k].abs() <= MASSLESS_ENERGY * largest).collect();
    let motions = &kernel * decomposition.U();
    let moves = |c: usize| massless.iter().any(|&k| motions[(c, k)].abs() > UNDETERMINED);
    let moving = (0..n).filter(|&c| moves(c)).filter_map(|c| coordinates[c].0);
    let masters: Vec<JointId> = moving.collect();
    let mechanism = pose.mechanism();
    let follows = |joint: &JointId| {
        let master = mechanism.joint(*joint).mimic().map_or(*joint, |m| m.master);
        masters.contains(&master) && !pose.is_locked(*joint)
    };
    mechanism.joint_ids().filter(follows).collect()
}
