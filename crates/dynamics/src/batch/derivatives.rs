//! Derivatives of one contact at many configurations: the gradient of m̄, and the inverse operational inertia.
//!
//! Trees whose joints are hinges, slides, balls and free joints are computed in SIMD lanes. A lane with a small pivot, or of which m̄
//! differs from that of the batch, is computed again at its pose, as are all configurations of other mechanisms.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::batch::error::BatchError;
use crate::batch::pool::WorkerPool;
use crate::batch::row_contacts::{BatchContacts, RowContacts, in_root_axes};
use crate::batch::rows::{BLOCK, Batch, BatchAnswer, BatchPositions};
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
}

/// Workspace of one thread.
#[derive(Clone, Debug)]
struct Worker {
    kernel: Option<DerivativeKernel>,
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
        let (assembly, contact) = (self.assembly(), self.contact());
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
            columns: Aligned::zeros(columns * BLOCK),
            values: Aligned::zeros(values * BLOCK),
        };
        BatchDerivatives { batch: self, worker, pool: WorkerPool::default() }
    }
}

/// Rows of a run.
#[derive(Clone, Copy)]
struct Rows<'a> {
    positions: BatchPositions<'a>,
    contacts: RowContacts<'a>,
    base: Option<&'a Transform<f64>>,
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

    /// m̄ as [`Batch::run_columns`] gives it (`contacts`: as [`Batch::run_contacts`]), and its gradient:
    ///
    /// ```text
    /// g = ∂m̄/∂q along admissible motions:  dm̄/dt = g · q̇   for every q̇ with A q̇ = 0
    /// ```
    ///
    /// `gradients[c · n ..][.. n]`, n = [`velocities`](Self::velocities): configuration c, kg/rad or kg/m, as
    /// [`Pose::effective_mass_gradient`]; NaN unless m̄ is finite with an error of at most 1e-6 m̄. Points and normals of the rows are fixed in their frames.
    ///
    /// On the calling thread. Relative accuracy: that of m̄, for the size of the terms.
    ///
    /// # Errors
    /// [`BatchError`]: as for [`Batch::run_contacts`]; [`BatchError::DerivativeCount`]: a wrong number of gradients.
    pub fn gradients(
        &self,
        positions: BatchPositions<'_>,
        contacts: Option<BatchContacts<'_>>,
        (masses, errors): (&mut [f64], &mut [f64]),
        gradients: &mut [f64],
        other: impl FnMut(usize, BatchAnswer),
    ) -> Result<(), BatchError> {
        self.run(Derivative::Gradient, positions, contacts, (masses, errors), gradients, other)
    }

    /// m̄ as [`gradients`](Self::gradients) gives it, and the inverse operational inertia of the contact link at the contact point:
    /// the upper left 6×6 block of [`Pose::inverse_operational_inertia`], in root axes.
    ///
    /// ```text
    /// Φ = J M_c⁻¹ Jᵀ;   1/m̄ = wᵀ Φ w with w = (0, n̂), for contacts with the ground
    /// ```
    ///
    /// `inverses[36 c ..][.. 36]`: rows of Φ at configuration c (1/(kg·m²), 1/(kg·m), 1/kg by blocks). NaN if a motion without mass
    /// responds, or if the configuration has no result.
    ///
    /// # Errors
    /// As for [`gradients`](Self::gradients).
    pub fn inverse_operational_inertias(
        &self,
        positions: BatchPositions<'_>,
        contacts: Option<BatchContacts<'_>>,
        (masses, errors): (&mut [f64], &mut [f64]),
        inverses: &mut [f64],
        other: impl FnMut(usize, BatchAnswer),
    ) -> Result<(), BatchError> {
        self.run(Derivative::InverseInertia, positions, contacts, (masses, errors), inverses, other)
    }

    fn run(
        &self,
        derivative: Derivative,
        positions: BatchPositions<'_>,
        contacts: Option<BatchContacts<'_>>,
        (masses, errors): (&mut [f64], &mut [f64]),
        values: &mut [f64],
        other: impl FnMut(usize, BatchAnswer),
    ) -> Result<(), BatchError> {
        let width = match derivative {
            Derivative::Gradient => self.velocities(),
            Derivative::InverseInertia => INERTIA_NUMBERS,
        };
        if masses.len().checked_mul(width) != Some(values.len()) {
            let (got, configurations) = (values.len(), masses.len());
            return Err(BatchError::DerivativeCount { got, width, configurations });
        }
        match contacts {
            None => self.batch.run_columns(positions, masses, errors, other)?,
            Some(contacts) => self.batch.run_contacts(positions, contacts, masses, errors, other)?,
        }
        let rows = Rows {
            positions,
            contacts: RowContacts { contact: self.batch.contact(), contacts },
            base: self.batch.base_of_normal(),
            count: masses.len(),
        };
        self.pool.with_worker(&self.worker, |worker| {
            worker.compute(
                self.batch.assembly(),
                self.batch.instructions(),
                derivative,
                rows,
                (masses, errors),
                values,
            )
        });
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
                self.fill_columns(assembly, &rows, start, (here, padded));
                let Self { kernel: Some(kernel), columns, values } = self else { return };
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

    /// Copies the positions, points and normals of a block; unused lanes repeat the last configuration.
    fn fill_columns(
        &mut self,
        assembly: &Assembly,
        rows: &Rows<'_>,
        start: usize,
        (here, padded): (usize, usize),
    ) {
        let count = assembly.model().positions;
        let Some(conversion) = self.kernel.as_ref().map(DerivativeKernel::conversion) else { return };
        for lane in 0..padded {
            let configuration = start + lane.min(here - 1);
            for q in 0..count {
                self.columns[q * BLOCK + lane] = rows.positions.at(configuration, q);
            }
            if let Some(contacts) = rows.contacts.contacts {
                let [point, normal] = contacts.at(configuration);
                let [point, normal] = conversion.convert(&point, &in_root_axes(normal, rows.base));
                let numbers = point.iter().chain(&normal).enumerate();
                numbers.for_each(|(k, x)| self.columns[(count + k) * BLOCK + lane] = *x);
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
    let contact = rows.contacts.at(row, rows.base);
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
