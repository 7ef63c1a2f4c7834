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
    let mut here = positions.to_vec();
    follow(mechanism, &mut here);
    let mut open = stacked(mechanism, &here);
    let mut damping = limits::FIRST_DAMPING;
    for _ in 0..limits::MOST_ROUNDS {
        if norm(&open) == 0.0 || unknowns.is_empty() {
            break;
        }
        let steps = Steps::new(mechanism, &here, &unknowns, &open);
        // Rejected steps are repeated with more damping. Without damping the last digits converge in one or two
        // rounds.
        let better = (0..limits::MOST_ATTEMPTS).find_map(|_| {
            let there = advanced(mechanism, &here, &unknowns, &steps.step(damping));
            let residual = stacked(mechanism, &there);
            let accepted = norm(&residual) < norm(&open);
            damping = if accepted { damping / 30.0 } else { (damping * 10.0).max(limits::LEAST_DAMPING) };
            accepted.then_some((there, residual))
        });
        let Some(better) = better else { break };
        (here, open) = better;
        if damping < limits::NO_DAMPING {
            damping = 0.0;
        }
    }
    let residual = residual(mechanism, &here);
    (here, residual)
}

fn stacked(mechanism: &Mechanism, positions: &[Vec<f64>]) -> Vec<f64> {
    residuals(mechanism, positions).concat()
}

fn norm(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum: f64, value| sum.hypot(*value))
}

/// Displacement per unit of an unknown: unknowns are lengths and angles times the characteristic length.
fn unit(mechanism: &Mechanism, (joint, i): (JointId, usize)) -> f64 {
    let slides = match mechanism.joint(joint).kind() {
        JointKind::Fixed | JointKind::Revolute | JointKind::Continuous | JointKind::Spherical => false,
        JointKind::Prismatic => true,
        JointKind::Planar => i < 2,
        JointKind::Floating => i >= 3,
    };
    if slides { 1.0 } else { 1.0 / mechanism.characteristic_length() }
}

fn advanced(
    mechanism: &Mechanism,
    positions: &[Vec<f64>],
    unknowns: &[(JointId, usize)],
    step: &[f64],
) -> Vec<Vec<f64>> {
    let mut there = positions.to_vec();
    for (&(joint, i), by) in unknowns.iter().zip(step) {
        run(mechanism, &mut there, joint, i, by * unit(mechanism, (joint, i)));
    }
    follow(mechanism, &mut there);
    there
}

/// Singular value decomposition of the Jacobian of the residuals.
struct Steps {
    left: Mat<f64>,
    values: Vec<f64>,
    right: Mat<f64>,
    open: Vec<f64>,
}

impl Steps {
    fn new(mechanism: &Mechanism, here: &[Vec<f64>], unknowns: &[(JointId, usize)], open: &[f64]) -> Self {
        // Central differences of functions of the order of the size.
        let h = limits::DIFFERENCE_STEP * mechanism.characteristic_length();
        let mut jacobian = Mat::zeros(open.len(), unknowns.len());
        for (k, &unknown) in unknowns.iter().enumerate() {
            let [plus, minus] =
                [h, -h].map(|h| stacked(mechanism, &advanced(mechanism, here, &[unknown], &[h])));
            for i in 0..open.len() {
                jacobian[(i, k)] = (plus[i] - minus[i]) / (2.0 * h);
            }
        }
        let svd = jacobian.thin_svd().expect("finite residuals");
        let values = svd.S().column_vector().iter().copied().collect();
        Self { left: svd.U().to_owned(), values, right: svd.V().to_owned(), open: open.to_vec() }
    }

    /// −(JᵀJ + (damping · σ_max)²)⁻¹ Jᵀ r, without the singular values that are errors of the differences.
    fn step(&self, damping: f64) -> Vec<f64> {
        let largest = self.values[0];
        let mut step = vec![0.0; self.right.nrows()];
        for (k, &value) in
            self.values.iter().enumerate().filter(|(_, value)| **value > limits::DIFFERENCE_NOISE * largest)
        {
            let along: f64 = self.open.iter().enumerate().map(|(i, r)| self.left[(i, k)] * r).sum();
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
    run(mechanism, &mut moved, joint, i, h);
    follow(mechanism, &mut moved);
    moved
}

fn run(mechanism: &Mechanism, positions: &mut [Vec<f64>], joint: JointId, i: usize, h: f64) {
    let q = &mut positions[joint.index()];
    match mechanism.joint(joint).kind() {
        JointKind::Fixed => unreachable!("it has no velocity"),
        JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Planar => q[i] += h,
        JointKind::Spherical => turn(q, i, h),
        JointKind::Floating if i < 3 => turn(&mut q[3..], i, h),
        JointKind::Floating => {
            let along = quaternion(&q[3..]) * Vector3::ith(i - 3, h);
            (0..3).for_each(|k| q[k] += along[k]);
        }
    }
}

fn quaternion(q: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3]))
}

/// Rotates the quaternion w,x,y,z about axis `i` of its own frame.
fn turn(q: &mut [f64], i: usize, h: f64) {
    let turned = quaternion(q) * UnitQuaternion::from_scaled_axis(Vector3::ith(i, h));
    q.copy_from_slice(&[turned.w, turned.i, turned.j, turned.k]);
}
