//! Assembler of loops for tests: simple, slow and independent of the library.

use super::residual::{residual, residuals};
use crate::limits;
use crate::positions::follow;
use faer::Mat;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use std::fmt;

/// Error: the loops do not close from the start position.
#[derive(Clone, Debug)]
pub struct NotClosed {
    /// Best position found.
    pub positions: Vec<Vec<f64>>,
    /// [`residual`] of this position, m.
    pub residual: f64,
}

impl fmt::Display for NotClosed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the loops stay open by {:e} m", self.residual)
    }
}

impl std::error::Error for NotClosed {}

/// Moves the joints `free`, with their mimics, until the residual is 1e-13 of the characteristic length.
///
/// Levenberg–Marquardt method on [`residuals`], from `positions`, with finite differences for the Jacobian and
/// a singular value decomposition for the step. Redundant closures and more free joints than needed are
/// allowed: the step has minimum norm.
///
/// # Errors
/// [`NotClosed`] with the final, open position; the least-squares position if the loops contradict each other.
///
/// # Panics
/// If the positions do not match the joints, or `free` contains a mimic.
pub fn close(
    mechanism: &Mechanism,
    positions: &[Vec<f64>],
    free: &[JointId],
) -> Result<Vec<Vec<f64>>, NotClosed> {
    let (positions, residual) = close_as_far_as_possible(mechanism, positions, free);
    let closed = residual <= limits::CLOSED * mechanism.characteristic_length();
    if closed { Ok(positions) } else { Err(NotClosed { positions, residual }) }
}

/// As [`close`], but accepts a minimum of the squared residuals: rounded files have no closed position.
///
/// # Panics
/// If the positions do not match the joints, or `free` contains a mimic.
pub fn close_as_far_as_possible(
    mechanism: &Mechanism,
    positions: &[Vec<f64>],
    free: &[JointId],
) -> (Vec<Vec<f64>>, f64) {
    assert!(free.iter().all(|&id| mechanism.joint(id).mimic().is_none()), "a mimic is never free");
    let unknowns: Vec<(JointId, usize)> =
        free.iter().flat_map(|&id| (0..mechanism.joint(id).kind().dofs()).map(move |i| (id, i))).collect();
    let mut current = positions.to_vec();
    follow(mechanism, &mut current);
    let mut residuals = stacked_residuals(mechanism, &current);
    let mut damping = limits::FIRST_DAMPING;
    for _ in 0..limits::MAX_STEPS {
        if norm(&residuals) == 0.0 || unknowns.is_empty() {
            break;
        }
        let steps = LeastSquaresStep::new(mechanism, &current, &unknowns, &residuals);
        // Rejected steps are repeated with more damping. Without damping the last digits converge in one or two
        // rounds.
        let better = (0..limits::MAX_ATTEMPTS).find_map(|_| {
            let moved_positions = advanced(mechanism, &current, &unknowns, &steps.step(damping));
            let residual = stacked_residuals(mechanism, &moved_positions);
            let accepted = norm(&residual) < norm(&residuals);
            damping = if accepted { damping / 30.0 } else { (damping * 10.0).max(limits::MIN_DAMPING) };
            accepted.then_some((moved_positions, residual))
        });
        let Some(better) = better else { break };
        (current, residuals) = better;
        if damping < limits::NO_DAMPING {
            damping = 0.0;
        }
    }
    let residual = residual(mechanism, &current);
    (current, residual)
}

/// Residuals of all loops in one list.
fn stacked_residuals(mechanism: &Mechanism, positions: &[Vec<f64>]) -> Vec<f64> {
    residuals(mechanism, positions).concat()
}

/// Euclidean norm without overflow of squares.
fn norm(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum: f64, value| sum.hypot(*value))
}

/// Length per unit of a joint velocity: 1 for translations, the characteristic length for rotations.
fn length_per_unknown(mechanism: &Mechanism, (joint, i): (JointId, usize)) -> f64 {
    let slides = match mechanism.joint(joint).kind() {
        JointKind::Fixed | JointKind::Revolute | JointKind::Continuous | JointKind::Spherical => false,
        JointKind::Prismatic => true,
        JointKind::Planar => i < 2,
        JointKind::Floating => i >= 3,
    };
    if slides { 1.0 } else { 1.0 / mechanism.characteristic_length() }
}

/// Positions after a step of the unknowns (joint, velocity component); mimics follow.
fn advanced(
    mechanism: &Mechanism,
    positions: &[Vec<f64>],
    unknowns: &[(JointId, usize)],
    step: &[f64],
) -> Vec<Vec<f64>> {
    let mut moved_positions = positions.to_vec();
    for (&(joint, i), by) in unknowns.iter().zip(step) {
        integrate_velocity(
            mechanism,
            &mut moved_positions,
            joint,
            i,
            by * length_per_unknown(mechanism, (joint, i)),
        );
    }
    follow(mechanism, &mut moved_positions);
    moved_positions
}

/// Singular value decomposition of the Jacobian of the residuals.
struct LeastSquaresStep {
    left: Mat<f64>,
    values: Vec<f64>,
    right: Mat<f64>,
    residuals: Vec<f64>,
}

impl LeastSquaresStep {
    fn new(
        mechanism: &Mechanism,
        current: &[Vec<f64>],
        unknowns: &[(JointId, usize)],
        residuals: &[f64],
    ) -> Self {
        // Central differences of functions of the order of the size.
        let h = limits::DIFFERENCE_STEP * mechanism.characteristic_length();
        let mut jacobian = Mat::zeros(residuals.len(), unknowns.len());
        for (k, &unknown) in unknowns.iter().enumerate() {
            let [plus, minus] = [h, -h]
                .map(|h| stacked_residuals(mechanism, &advanced(mechanism, current, &[unknown], &[h])));
            for i in 0..residuals.len() {
                jacobian[(i, k)] = (plus[i] - minus[i]) / (2.0 * h);
            }
        }
        let svd = jacobian.thin_svd().expect("finite residuals");
        let values = svd.S().column_vector().iter().copied().collect();
        Self { left: svd.U().to_owned(), values, right: svd.V().to_owned(), residuals: residuals.to_vec() }
    }

    /// −(JᵀJ + (damping · σ_max)²)⁻¹ Jᵀ r, without the singular values that are errors of the differences.
    fn step(&self, damping: f64) -> Vec<f64> {
        let largest = self.values[0];
        let mut step = vec![0.0; self.right.nrows()];
        for (k, &value) in
            self.values.iter().enumerate().filter(|(_, value)| **value > limits::DIFFERENCE_NOISE * largest)
        {
            let along: f64 = self.residuals.iter().enumerate().map(|(i, r)| self.left[(i, k)] * r).sum();
            let factor = -along * value / (value * value + (damping * largest).powi(2));
            step.iter_mut().enumerate().for_each(|(i, x)| *x += factor * self.right[(i, k)]);
        }
        step
    }
}

/// Positions after a motion with velocity component `i` of a joint (in the order of [`JointKind`]'s table) for
/// the time `h`; mimics follow.
pub fn moved(
    mechanism: &Mechanism,
    positions: &[Vec<f64>],
    joint: JointId,
    i: usize,
    h: f64,
) -> Vec<Vec<f64>> {
    let mut moved = positions.to_vec();
    integrate_velocity(mechanism, &mut moved, joint, i, h);
    follow(mechanism, &mut moved);
    moved
}

/// Moves one joint with unit velocity component `i` for the time `h`, without its mimics.
fn integrate_velocity(mechanism: &Mechanism, positions: &mut [Vec<f64>], joint: JointId, i: usize, h: f64) {
    let q = &mut positions[joint.index()];
    match mechanism.joint(joint).kind() {
        JointKind::Fixed => unreachable!("it has no velocity"),
        JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Planar => q[i] += h,
        JointKind::Spherical => rotate_quaternion(q, i, h),
        JointKind::Floating if i < 3 => rotate_quaternion(&mut q[3..], i, h),
        JointKind::Floating => {
            let along = quaternion(&q[3..]) * Vector3::ith(i - 3, h);
            (0..3).for_each(|k| q[k] += along[k]);
        }
    }
}

/// Unit quaternion from w, x, y, z.
fn quaternion(q: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3]))
}

/// Rotates the quaternion w,x,y,z about axis `i` of its own frame.
fn rotate_quaternion(q: &mut [f64], i: usize, h: f64) {
    let turned = quaternion(q) * UnitQuaternion::from_scaled_axis(Vector3::ith(i, h));
    q.copy_from_slice(&[turned.w, turned.i, turned.j, turned.k]);
}
