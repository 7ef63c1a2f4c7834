//! Derivatives of one contact at many configurations: the gradient of m̄, and the inverse operational inertia.
//!
//! Trees whose joints are hinges, slides, balls and free joints are computed in SIMD lanes. A lane with a small pivot, or of which m̄
//! differs from that of the batch, is computed again at its pose, as are all configurations of other mechanisms.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::batch::contact_map::ContactStatus;
use crate::batch::error::BatchError;
use crate::batch::pool::WorkerPool;
use crate::batch::row_columns::{BatchRows, RowColumns};
use crate::batch::row_contacts::RowContacts;
use crate::batch::rows::{BLOCK, Batch, BatchPositions};
use crate::kernels::{kernel_contact, mechanism};
use crate::kinematics::contact::Contact;
use crate::kinematics::frames::Kinematics;
use crate::model::input::{is_number, normalise_quaternion, quaternion_of};
use crate::tolerances::{DERIVATIVE_AGREEMENT, LARGEST_DERIVATIVE_LOSS, WARNED_RELATIVE_ERROR};
use percuss_kernel::derivatives::{Derivative, DerivativeColumns, DerivativeKernel, INERTIA_NUMBERS};
use percuss_kernel::{Aligned, LaneContacts, PositionColumns};
use percuss_spatial::Transform;
use std::sync::Arc;

/// One contact, ready for derivatives at many configurations. See [`Batch::derivatives`].
#[derive(Clone, Debug)]
pub struct BatchDerivatives {
    batch: Batch,
    worker: Worker,
    pool: WorkerPool<Worker>,
    /// Positions of blocks.
    buffers: WorkerPool<Vec<f64>>,
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
fn velocity_count(assembly: &Assembly) -> usize {
    assembly.model().mechanism.joints().iter().map(|joint| joint.kind().dofs()).sum()
}

impl Batch {
    /// Prepares the gradient of m̄ and the inverse operational inertia of the contact, at many configurations.
    pub fn derivatives(self) -> BatchDerivatives {
        let (assembly, contact) = (self.assembly(), self.contacts_of(None).contact);
        let model = assembly.model();
        // Loops, couplings and mimics are left to the pose.
        let is_tree = model.groups.is_empty() && !model.has_active_mimics;
        let kernel = is_tree
            .then(|| mechanism(model))
            .zip(kernel_contact(model, contact))
            .and_then(|(bodies, contact)| DerivativeKernel::compile(&bodies, &contact));
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
        BatchDerivatives { batch: self, worker, pool: WorkerPool::default(), buffers: WorkerPool::default() }
    }
}

/// Rows of a run.
#[derive(Clone, Copy)]
struct Rows<'a> {
    positions: BatchPositions<'a>,
    contacts: RowContacts<'a>,
    count: usize,
}

impl BatchDerivatives {
    /// The batch of m̄ alone.
    pub fn batch(&self) -> &Batch {
        &self.batch
    }

    /// True if the configurations are computed in SIMD lanes.
    pub fn has_lanes(&self) -> bool {
        self.worker.kernel.is_some()
    }

    /// Number of velocities per configuration: those of all joints, in joint order.
    pub fn velocities(&self) -> usize {
        velocity_count(self.batch.assembly())
    }

    /// m̄ at rows, with the derivatives for which there are columns, on the threads of rayon's pool. A thread takes `block` rows at
    /// once; all rows if there are fewer, on the calling thread. The results depend on the rows only.
    ///
    /// ```text
    /// gradient          g = ∂m̄/∂q along admissible motions:  dm̄/dt = g · q̇   for every q̇ with A q̇ = 0
    /// inverse inertia   Φ = J M_c⁻¹ Jᵀ;   1/m̄ = wᵀ Φ w with w = (0, n̂), for contacts with the ground
    /// ```
    ///
    /// Gradients: [`velocities`](Self::velocities) numbers per row, kg/rad or kg/m, as [`Pose::effective_mass_gradient`]; NaN unless m̄
    /// is finite with an error of at most 1e-6 m̄. Points and normals of the rows are fixed in their frames. Relative accuracy: that of
    /// m̄, for the size of the terms.
    ///
    /// Inverse operational inertias: 36 numbers per row (1/(kg·m²), 1/(kg·m), 1/kg by blocks), the upper left 6×6 block of
    /// [`Pose::inverse_operational_inertia`], in root axes, row by row. NaN if a motion without mass responds, or if the row has no result.
    ///
    /// # Errors
    /// [`BatchError`]: as for [`Batch::run_columns`]; [`BatchError::DerivativeCount`]: a wrong number of derivatives;
    /// [`BatchError::NotFinite`], [`BatchError::GivenPositions`]: invalid rows.
    pub fn run<'a, S: From<ContactStatus> + Clone + Send>(
        &self,
        rows: impl Into<BatchRows<'a>>,
        columns: RowColumns<'_, S>,
        block: usize,
    ) -> Result<(), BatchError> {
        let configurations = columns.masses.len();
        let others = [columns.errors.len(), columns.statuses.len()];
        let others = others.into_iter().chain(columns.remarks.as_ref().map(|remarks| remarks.len()));
        if let Some(errors) = others.into_iter().find(|length| *length != configurations) {
            return Err(BatchError::Columns { masses: configurations, errors });
        }
        let derivatives =
            [(&columns.gradients, self.velocities()), (&columns.inverse_inertias, INERTIA_NUMBERS)];
        for (values, width) in derivatives {
            let got = values.as_ref().map(|values| values.len());
            if let Some(got) = got.filter(|got| configurations.checked_mul(width) != Some(*got)) {
                return Err(BatchError::DerivativeCount { got, width, configurations });
            }
        }
        let rows = rows.into();
        rows.check(self.batch.assembly().model().positions, configurations)?;
        self.run_blocks(rows, columns, block.max(1))
    }

    /// Computes rows in blocks; each half of several blocks may run on another thread.
    fn run_blocks<S: From<ContactStatus> + Clone + Send>(
        &self,
        rows: BatchRows<'_>,
        columns: RowColumns<'_, S>,
        block: usize,
    ) -> Result<(), BatchError> {
        let count = columns.masses.len();
        if count <= block {
            let empty = Vec::new();
            return self.buffers.with_worker(&empty, |buffer| self.run_block(rows, columns, buffer));
        }
        let middle = count.div_ceil(block).div_ceil(2) * block;
        let (before, after) = columns.split_at(middle);
        let (first, second) = rayon::join(
            || self.run_blocks(rows.part(0..middle), before, block),
            || self.run_blocks(rows.part(middle..count), after, block),
        );
        first.and_then(|()| second.map_err(|error| error.in_rows_from(middle)))
    }

    fn run_block<S: From<ContactStatus> + Clone>(
        &self,
        rows: BatchRows<'_>,
        columns: RowColumns<'_, S>,
        buffer: &mut Vec<f64>,
    ) -> Result<(), BatchError> {
        let RowColumns { masses, errors, statuses, mut remarks, gradients, inverse_inertias } = columns;
        let (batch, count) = (&self.batch, masses.len());
        let positions = rows.all_positions(batch.assembly().model().positions, count, buffer)?;
        statuses.fill(ContactStatus::Finite.into());
        if let Some(remarks) = &mut remarks {
            remarks.fill(batch.remarks().bits());
        }
        batch.run_columns(positions, rows.contacts, masses, errors, |at, answer| {
            statuses[at] = answer.status().into();
            if let Some(remarks) = &mut remarks {
                remarks[at] = answer.remarks.bits();
            }
        })?;
        let rows = Rows { positions, contacts: batch.contacts_of(rows.contacts), count };
        let derivatives = [(Derivative::Gradient, gradients), (Derivative::InverseInertia, inverse_inertias)];
        for (derivative, values) in derivatives.into_iter().filter_map(|(d, values)| Some((d, values?))) {
            let results = (&*masses, &*errors);
            self.pool.with_worker(&self.worker, |worker| {
                worker.compute(batch.assembly(), batch.instructions(), derivative, rows, results, values);
            });
        }
        Ok(())
    }
}

impl Worker {
    /// Computes a derivative at all rows, with the masses of the rows.
    fn compute(
        &mut self,
        assembly: &Arc<Assembly>,
        instructions: percuss_spatial::lanes::Instructions,
        derivative: Derivative,
        rows: Rows<'_>,
        (masses, errors): (&[f64], &[f64]),
        values: &mut [f64],
    ) {
        let width = values.len().checked_div(rows.count).unwrap_or(0);
        let [mut responses, mut losses] = [[f64::NAN; BLOCK]; 2];
        // The kernel does not write the entries of joints that do not respond.
        self.values.fill(0.0);
        for start in (0..rows.count).step_by(BLOCK) {
            let here = BLOCK.min(rows.count - start);
            let to = &mut values[start * width..][..here * width];
            responses.fill(f64::NAN);
            if self.kernel.is_some() {
                let padded = here.next_multiple_of(instructions.width());
                let Self { kernel: Some(kernel), read, columns, values } = self else { return };
                let (from, conversion) = ((rows.positions, &read[..]), kernel.conversion());
                rows.contacts.fill_lanes(columns, from, Some(&conversion), start, (here, padded));
                let contact_column = assembly.model().positions;
                let contacts = rows.contacts.contacts.map(|_| LaneContacts { first_column: contact_column });
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
    rows: &Rows<'_>,
    row: usize,
    to: &mut [f64],
) {
    to.fill(f64::NAN);
    let Some(pose) = pose_of_row(assembly, rows, row) else { return };
    let contact = rows.contacts.at(row);
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
fn pose_of_row(assembly: &Arc<Assembly>, rows: &Rows<'_>, row: usize) -> Option<Pose> {
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
