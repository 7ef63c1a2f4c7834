//! Accelerations of a mechanism with constraints under a force at a contact.
//!
//! ```text
//! M u̇ + h + jᵀF = Q + Aᵀλ,   A u̇ = −Ȧ u
//! ```
//!
//! h has the terms that are quadratic in the rates u; Q has the weight and the forces of springs and dampers at joints. With the basis N of
//! ker A and any u_p with A u_p = −Ȧ u, the accelerations are u̇ = u_p + N a with NᵀMN a = −Nᵀ(h + jᵀF − Q + M u_p). Redundant rows do not
//! matter. Source: Featherstone 2008, §3.2 and §8.

use crate::group_rows::GroupRows;
use crate::mobility::semidefinite::{SemidefiniteSolver, unit_diagonal_scale};
use crate::motion::driver_rates::{kernel, lengths};
use crate::motion::joint_rates::JointRates;
use crate::numerics::pivoted_qr::PivotedQr;
use crate::reactions::force_elements::SpringForces;
use crate::reactions::tree_frames::TreeFrames;
use crate::tolerances::MASSLESS_ENERGY;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_dynamics::{ConstraintGroup, LocatedContact, Pose};
use percuss_spatial::{Transform, Twist, rotation_from_quaternion};

/// Equations of motion of a system at many poses; the buffers are reused.
pub(crate) struct MotionEquations {
    tree: TreeFrames,
    /// Length scale of every coordinate: speed (m/s) of a point at the characteristic length at unit rate.
    lengths: Vec<f64>,
    groups: Vec<EquationGroup>,
    /// Coordinates without constraints.
    unbound: Vec<usize>,
    /// Basis of ker A, column by column: all coordinate rates of the first motion, then of the next.
    basis: Vec<f64>,
    /// Velocities of all joints, and their accelerations of the particular solution u_p.
    velocities: Vec<f64>,
    bias: Vec<f64>,
    springs: SpringForces,
}

/// Rows of a group of constraints.
struct EquationGroup {
    coordinates: Vec<usize>,
    lengths: Vec<f64>,
    rows: Vec<f64>,
    qr: PivotedQr,
}

impl MotionEquations {
    /// Equations for the system of a pose, with springs and dampers.
    pub fn new(pose: &Pose, springs: SpringForces) -> Self {
        let of_group = |group: ConstraintGroup| EquationGroup {
            coordinates: group.coordinates,
            lengths: group.lengths,
            rows: Vec::new(),
            qr: PivotedQr::default(),
        };
        let groups: Vec<EquationGroup> = pose.constraint_groups().into_iter().map(of_group).collect();
        let lengths = lengths(pose, &pose.coordinate_joints());
        let is_unbound = |c: &usize| !groups.iter().any(|group| group.coordinates.contains(c));
        Self {
            tree: TreeFrames::new(pose),
            unbound: (0..lengths.len()).filter(is_unbound).collect(),
            lengths,
            groups,
            basis: Vec::new(),
            velocities: Vec::new(),
            bias: Vec::new(),
            springs,
        }
    }

    /// Accelerations u̇ of the coordinates at the rates `u`, under the force `force` (N, −n̂ on the contact link) and the gravity
    /// `gravity` (m/s², root axes). `None` if the rates do not fit the pose.
    pub fn accelerations(
        &mut self,
        pose: &Pose,
        contact: &LocatedContact,
        u: &[f64],
        force: f64,
        gravity: &Vector3<f64>,
    ) -> Option<Vec<f64>> {
        let n = u.len();
        self.tree.update(pose);
        self.tree.joint_velocities(u, &mut self.velocities);
        let base = self.tree.base_twist(u);
        self.tree.apply_springs(pose, &self.springs, &self.velocities, base);
        let mut accelerations = vec![0.0; n];
        self.solve_constraints(pose, &base, &mut accelerations)?;
        self.tree.joint_velocities(&accelerations, &mut self.bias);
        let (rates, bias) =
            ((&self.velocities[..], base), (&self.bias[..], self.tree.base_twist(&accelerations)));
        let loads = self.tree.motion_loads(pose, contact, force, rates, bias, gravity);
        let mut forces = Vec::new();
        self.tree.generalised_loads(&loads, &self.bias, &mut forces);
        let mass = pose.mass_matrix();
        let d = self.basis.len().checked_div(n).unwrap_or(0);
        let basis = DMatrix::from_column_slice(n, d, &self.basis);
        let reduced = basis.tr_mul(&(&mass * &basis));
        let right = -basis.tr_mul(&DVector::from_vec(forces.clone()));
        let motion = match solve_definite(&reduced, &right) {
            Some(weights) => basis * weights,
            None => least_motion(pose, &mass, &self.lengths, forces),
        };
        accelerations.iter_mut().zip(motion.iter()).for_each(|(sum, a)| *sum += a);
        Some(accelerations)
    }

    /// Power (W) of gravity, springs and dampers at the rates `u`, at the pose of the last accelerations.
    pub fn applied_power(
        &self,
        pose: &Pose,
        contact: &LocatedContact,
        u: &[f64],
        gravity: &Vector3<f64>,
    ) -> f64 {
        let (zero, rest) = (Twist::zero(), vec![0.0; self.velocities.len()]);
        let loads = self.tree.motion_loads(pose, contact, 0.0, (&rest, zero), (&rest, zero), gravity);
        let mut forces = Vec::new();
        self.tree.generalised_loads(&loads, &rest, &mut forces);
        -forces.iter().zip(u).map(|(force, rate)| force * rate).sum::<f64>()
    }

    /// Rates of the positions of all joints (layout of [`Pose::positions`]) and twist of the root link, at the rates `u` and the pose of
    /// the last accelerations.
    pub fn position_rates(&self, pose: &Pose, u: &[f64]) -> Option<(Vec<f64>, Twist<f64>)> {
        let of_joints: Vec<&[f64]> = self.of_joints();
        Some((pose.position_rates(&of_joints).ok()?, self.tree.base_twist(u)))
    }

    /// Velocities, joint by joint.
    fn of_joints(&self) -> Vec<&[f64]> {
        self.tree.mechanism.joint_ids().map(|joint| self.tree.of_joint(joint, &self.velocities)).collect()
    }

    /// Computes u_p with A u_p = −Ȧ u, which is zero except at the pivot coordinates, and the basis of ker A, one motion per other
    /// coordinate. `None` if the rates do not fit the pose.
    fn solve_constraints(&mut self, pose: &Pose, base: &Twist<f64>, particular: &mut [f64]) -> Option<()> {
        let n = particular.len();
        self.basis.clear();
        for &c in &self.unbound {
            let first = self.basis.len();
            self.basis.resize(first + n, 0.0);
            self.basis[first + c] = 1.0 / self.lengths[c];
        }
        if self.groups.is_empty() {
            return Some(());
        }
        let bias = pose.constraint_bias(&self.of_joints(), base).ok()?;
        let mut z = Vec::new();
        for (number, group) in self.groups.iter_mut().enumerate() {
            let columns = group.coordinates.len();
            let rank = pose.constraint_rows(number, &mut group.rows);
            let rows = group.rows.len().checked_div(columns).unwrap_or(0);
            let (values, lengths) = (&group.rows, &group.lengths);
            group.qr.decompose(rows, columns, |r, c| values[r * columns + c] / lengths[c]);
            let qr = &group.qr;
            let rank = if rank > 0 && qr.r(0, 0) == 0.0 { 0 } else { rank };
            // Back substitution: R₁ z = right, from the last pivot to the first.
            let back = |z: &mut [f64]| {
                for k in (0..rank).rev() {
                    let known: f64 = (k + 1..rank).map(|i| qr.r(k, i) * z[i]).sum();
                    z[k] = (z[k] - known) / qr.r(k, k);
                }
            };
            let coordinate = |k: usize| (group.coordinates[qr.order()[k]], lengths[qr.order()[k]]);
            z.clear();
            z.extend(
                (0..rank).map(|k| -qr.q_column(k).iter().zip(&bias[number]).map(|(q, b)| q * b).sum::<f64>()),
            );
            back(&mut z);
            for (k, z) in z.iter().enumerate() {
                let (c, length) = coordinate(k);
                particular[c] = z / length;
            }
            for free in rank..columns {
                z.clear();
                z.extend((0..rank).map(|k| -qr.r(k, free)));
                back(&mut z);
                let first = self.basis.len();
                self.basis.resize(first + n, 0.0);
                for (k, z) in z.iter().copied().enumerate().chain([(free, 1.0)]) {
                    let (c, length) = coordinate(k);
                    self.basis[first + c] = z / length;
                }
            }
        }
        Some(())
    }
}

/// Rates of all joints at the rates of the coordinates.
pub(crate) fn rates_of(pose: &Pose, u: &[f64]) -> JointRates {
    let (joints, base) = pose.joint_velocities(u);
    JointRates { joints, base }
}

/// Acceleration N a of least norm over scaled coordinates with NᵀMN a = −Nᵀ forces, for a singular NᵀMN: some motion has no mass.
fn least_motion(pose: &Pose, mass: &DMatrix<f64>, lengths: &[f64], forces: Vec<f64>) -> DVector<f64> {
    let groups: Vec<GroupRows> = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
    let basis = kernel(&groups, lengths);
    let basis = DMatrix::from_fn(lengths.len(), basis.ncols(), |c, k| basis[(c, k)] / lengths[c]);
    let reduced = basis.tr_mul(&(mass * &basis));
    let weights = solve(reduced, -basis.tr_mul(&DVector::from_vec(forces)));
    basis * weights
}

/// Solution of K a = b for a positive definite K, by a Cholesky decomposition after scaling to a unit diagonal; `None` if a pivot
/// is rounding of zero.
fn solve_definite(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let d = right.len();
    let scale = unit_diagonal_scale(matrix.diagonal().as_slice());
    let even = DMatrix::from_fn(d, d, |r, c| scale[r] * scale[c] * 0.5 * (matrix[(r, c)] + matrix[(c, r)]));
    let scaled = DVector::from_fn(d, |k, _| scale[k] * right[k]);
    let factor = even.cholesky()?;
    if !(0..d).all(|k| factor.l_dirty()[(k, k)].powi(2) > MASSLESS_ENERGY) {
        return None;
    }
    let solution = factor.solve(&scaled);
    Some(DVector::from_fn(d, |k, _| scale[k] * solution[k]))
}

/// Solution of K a = b for a symmetric positive semi-definite K, of least norm.
fn solve(matrix: DMatrix<f64>, right: DVector<f64>) -> DVector<f64> {
    let d = right.len();
    let scale = unit_diagonal_scale(matrix.diagonal().as_slice());
    let even = DMatrix::from_fn(d, d, |r, c| scale[r] * scale[c] * 0.5 * (matrix[(r, c)] + matrix[(c, r)]));
    let scaled = DVector::from_fn(d, |k, _| scale[k] * right[k]);
    let solution = SemidefiniteSolver::new(even).solve(&scaled);
    DVector::from_fn(d, |k, _| scale[k] * solution[k])
}

/// Motion of the base since the touch from its scaled displacement and quaternion without 1; `size`: unit of both.
pub(crate) fn base_motion(scaled: &[f64], size: f64) -> Transform<f64> {
    let mut q = [1.0 + size * scaled[3], size * scaled[4], size * scaled[5], size * scaled[6]];
    let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.iter_mut().for_each(|x| *x /= norm);
    let slide = Vector3::new(scaled[0], scaled[1], scaled[2]) * size;
    Transform::new(rotation_from_quaternion(q), slide)
}
