//! Derivatives of one contact at many configurations: the gradient of m̄, and the inverse operational inertia.
//!
//! Trees whose joints are hinges, slides, balls and free joints are computed in SIMD lanes, with most mimic joints. A lane with a small pivot, or of which m̄
//! differs from that of the batch, is computed again at its pose, as are all configurations of other mechanisms.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::batch::pool::WorkerPool;
use crate::batch::row_inputs::{BLOCK, RowBlock};
use crate::kernels::{kernel_contact, mechanism};
use crate::kinematics::contact::Contact;
use crate::kinematics::frames::Kinematics;
use crate::model::input::{is_number, normalise_quaternion, quaternion_of};
use crate::tolerances::{DERIVATIVE_AGREEMENT, LARGEST_DERIVATIVE_LOSS, WARNED_RELATIVE_ERROR};
use percuss_kernel::derivatives::{Derivative, DerivativeColumns, DerivativeKernel, INERTIA_NUMBERS};
use percuss_kernel::{Aligned, LaneContacts, PositionColumns};
use percuss_spatial::Transform;
use percuss_spatial::lanes::Instructions;
use std::sync::Arc;

/// Workspaces for the derivatives of a contact.
#[derive(Clone, Debug)]
pub(super) struct BatchDerivatives {
    worker: Worker,
    pool: WorkerPool<Worker>,
}

/// Workspace of one thread.
#[derive(Clone, Debug)]
struct Worker {
    kernel: Option<DerivativeKernel>,
    /// Indices of all positions.
    read: Vec<usize>,
    /// Positions, points and normals of a block by columns, [`BLOCK`] apart.
    columns: Aligned,
    /// Results of a block by columns, [`BLOCK`] apart.
    values: Aligned,
}

/// Number of velocities of all joints, in joint order.
pub(super) fn velocity_count(assembly: &Assembly) -> usize {
    assembly.model().mechanism.joints().iter().map(|joint| joint.kind().dofs()).sum()
}

impl BatchDerivatives {
    /// Prepares the derivatives of a contact.
    pub fn new(assembly: &Assembly, contact: &Contact) -> Self {
        let model = assembly.model();
        // Loops and couplings are left to the pose.
        let is_tree = model.groups.is_empty();
        let kernel = is_tree
            .then(|| mechanism(model))
            .and_then(|bodies| DerivativeKernel::compile(&bodies, &kernel_contact(model, contact)));
        let (columns, values) = match &kernel {
            Some(_) => (model.positions + LaneContacts::COUNT, velocity_count(assembly).max(INERTIA_NUMBERS)),
            None => (0, 0),
        };
        let worker = Worker {
            kernel,
            read: (0..model.positions).collect(),
            columns: Aligned::zeros(columns * BLOCK),
            values: Aligned::zeros(values * BLOCK),
        };
        Self { worker, pool: WorkerPool::default() }
    }

    /// True if the rows are computed in SIMD lanes.
    pub fn has_lanes(&self) -> bool {
        self.worker.kernel.is_some()
    }

    /// Computes a derivative at all rows, with the masses of the rows and their errors.
    pub fn compute(
        &self,
        assembly: &Arc<Assembly>,
        instructions: Instructions,
        derivative: Derivative,
        rows: RowBlock<'_>,
        masses: (&[f64], &[f64]),
        values: &mut [f64],
    ) {
        self.pool.with_worker(&self.worker, |worker| {
            worker.compute(assembly, instructions, derivative, rows, masses, values);
        });
    }
}

impl Worker {
    /// Computes a derivative at all rows, with the masses of the rows.
    fn compute(
        &mut self,
        assembly: &Arc<Assembly>,
        instructions: Instructions,
        derivative: Derivative,
        rows: RowBlock<'_>,
        (masses, errors): (&[f64], &[f64]),
        values: &mut [f64],
    ) {
        let count = masses.len();
        let width = values.len().checked_div(count).unwrap_or(0);
        let [mut responses, mut losses] = [[f64::NAN; BLOCK]; 2];
        // The kernel does not write the entries of joints that do not respond.
        self.values.fill(0.0);
        for start in (0..count).step_by(BLOCK) {
            let here = BLOCK.min(count - start);
            let to = &mut values[start * width..][..here * width];
            responses.fill(f64::NAN);
            if self.kernel.is_some() {
                let padded = here.next_multiple_of(instructions.width());
                let Self { kernel: Some(kernel), read, columns, values } = self else { return };
                rows.fill_lanes(columns, read, Some(&kernel.conversion()), start, (here, padded));
                let contact_column = assembly.model().positions;
                let contacts = rows.contacts.map(|_| LaneContacts { first_column: contact_column });
                let results = DerivativeColumns {
                    responses: &mut responses[..padded],
                    losses: &mut losses[..padded],
                    values,
                    stride: BLOCK,
                };
                let columns = PositionColumns { values: columns, stride: BLOCK };
                kernel.run(instructions, derivative, columns, contacts, results);
                for (lane, row) in to.chunks_exact_mut(width.max(1)).enumerate() {
                    row.iter_mut().enumerate().for_each(|(v, x)| *x = values[v * BLOCK + lane]);
                }
            }
            for (lane, row) in to.chunks_exact_mut(width.max(1)).enumerate() {
                let mass = masses[start + lane];
                let is_clear = (responses[lane] * mass - 1.0).abs() <= DERIVATIVE_AGREEMENT
                    && errors[start + lane] <= WARNED_RELATIVE_ERROR * mass
                    && losses[lane] <= LARGEST_DERIVATIVE_LOSS;
                if !is_clear {
                    compute_at_pose(assembly, derivative, &rows, start + lane, row);
                }
            }
        }
    }
}

/// Computes a derivative at the pose of a row; NaN without a result.
fn compute_at_pose(
    assembly: &Arc<Assembly>,
    derivative: Derivative,
    rows: &RowBlock<'_>,
    row: usize,
    to: &mut [f64],
) {
    to.fill(f64::NAN);
    let Some(pose) = pose_of_row(assembly, rows, row) else { return };
    let contact = rows.contact_at(row);
    match derivative {
        Derivative::Gradient => {
            let Ok(Some(gradient)) = pose.effective_mass_gradient(&contact) else { return };
            gradient.joints.iter().flatten().zip(to).for_each(|(x, to)| *to = *x);
        }
        Derivative::InverseInertia => {
            let Some(found) = inverse_inertia(&pose, &contact) else { return };
            to.iter_mut().enumerate().for_each(|(k, to)| *to = found[(k / 6, k % 6)]);
        }
    }
}

/// Φ of a contact at a pose.
fn inverse_inertia(pose: &Pose, contact: &Contact) -> Option<nalgebra::SMatrix<f64, 12, 12>> {
    let located = pose.locate(contact).ok()?;
    pose.inverse_operational_inertia(&located).ok().map(|found| *found.matrix())
}

/// Pose at the positions of a row, with the root link at the world's origin. `None`: numbers that are not finite, quaternions not of
/// unit length, open loops.
fn pose_of_row(assembly: &Arc<Assembly>, rows: &RowBlock<'_>, row: usize) -> Option<Pose> {
    let model = assembly.pose_model();
    let mut kinematics = Kinematics::new(model);
    kinematics.q.iter_mut().enumerate().for_each(|(q, to)| *to = rows.positions.at(row, q));
    for id in model.mechanism.joint_ids() {
        let range = model.joint_q[id.index()].clone();
        if let Some(own) = quaternion_of(model.mechanism.joint(id).kind()) {
            let place = range.start + own.start..range.start + own.end;
            normalise_quaternion(&mut kinematics.q[place]).ok()?;
        }
    }
    kinematics.refill(model);
    if kinematics.q.iter().any(|q| !is_number(*q)) {
        return None;
    }
    assembly.refuse_open_loops(&kinematics, &mut Vec::new()).ok()?;
    Some(Pose::new(Arc::clone(assembly), kinematics, Transform::identity(), None))
}
