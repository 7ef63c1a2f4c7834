//! m̄ of one contact at many configurations, with SIMD lanes and threads.
//!
//! Two kinds of mechanisms have a SIMD kernel: trees (on the ground or floating), and linkages of few
//! degrees of freedom. A lane with an uncertain result (massless, immovable, close to either, or with too much
//! rounding) is computed again by [`Workspace`]. For all other mechanisms, [`Workspace`] computes every
//! configuration. Every result equals that of [`Batch::effective_mass`] at the same configuration, bit for bit.

use crate::analysis::assembly::Assembly;
use crate::batch::derivatives::{BatchDerivatives, velocity_count};
use crate::batch::error::BatchError;
use crate::batch::pool::WorkerPool;
use crate::batch::row_inputs::{BLOCK, BatchPositions, BatchRows, RowBlock};
use crate::batch::row_remarks::RowGap;
use crate::batch::row_results::{BatchAnswer, ContactStatus, RowColumns};
use crate::batch::workspace::Workspace;
use crate::kernels::kernel_contact;
use crate::kinematics::contact::Contact;
use crate::kinematics::outcome::ResponseError;
use crate::kinematics::remarks::RemarkFlags;
use crate::model::interruption;
use crate::model::velocities::{StateSizeError, check_positions};
use percuss_kernel::derivatives::{Derivative, INERTIA_NUMBERS};
use percuss_kernel::{Aligned, CertifiedMass, Kernel, LaneContacts, MassColumns, PositionColumns};
use percuss_spatial::Transform;
use percuss_spatial::lanes::Instructions;
use std::sync::{Arc, OnceLock};

/// One contact, ready for many configurations.
#[derive(Clone, Debug)]
pub struct Batch {
    assembly: Arc<Assembly>,
    contact: Contact,
    /// Pose of the root link in the world, for normals given in the world.
    base_of_normal: Option<Transform<f64>>,
    instructions: Instructions,
    worker: Worker,
    pool: WorkerPool<Worker>,
    /// Prepared for the first derivative.
    derivatives: OnceLock<BatchDerivatives>,
}

/// Workspace of one thread.
#[derive(Clone, Debug)]
struct Worker {
    kernel: Option<Kernel>,
    /// Indices of the positions that the SIMD kernel reads.
    read: Vec<usize>,
    /// Positions of a block by columns, [`BLOCK`] apart.
    columns: Aligned,
    /// Positions of one configuration.
    row: Vec<f64>,
    /// Positions of a block of rows that give some positions only.
    given: Vec<f64>,
    workspace: Workspace,
    /// Findings that hold at every configuration, and those of each result of the kernel.
    row_remarks: RemarkFlags,
    remarks: RemarkFlags,
    /// Gap of the contact of the batch, if it is a named contact with a gap.
    gap: Option<RowGap>,
}

impl Assembly {
    /// Prepares m̄ of one contact at many configurations of this assembly. For normals given in the world, the root
    /// link is at the world's origin; [`Workspace::batch`] uses another base pose.
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact.
    pub fn batch(self: &Arc<Self>, contact: &Contact) -> Result<Batch, ResponseError> {
        self.workspace().batch(contact)
    }
}

impl Workspace {
    /// Prepares m̄ of one contact at many configurations, with the assembly and the base pose of this workspace.
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact.
    pub fn batch(&self, contact: &Contact) -> Result<Batch, ResponseError> {
        let assembly = Arc::clone(self.assembly());
        let model = assembly.model();
        model.check_contact(contact)?;
        let base_of_normal = self.base_of_normal(contact);
        let gap = RowGap::of(model, contact);
        let (contact, remarks) = self.contact_in_root(contact);
        let contact = &contact;
        let mut workspace = self.clone();
        let in_lanes = workspace
            .take_kernel()
            .and_then(|mut lanes| lanes.set_contact(&kernel_contact(model, contact)).then_some(lanes));
        let own = in_lanes.as_ref().map_or(RemarkFlags::NONE, |_| assembly.kernel_remarks());
        let worker = Worker {
            read: in_lanes.iter().flat_map(Kernel::read_positions).collect(),
            columns: Aligned::zeros(match in_lanes {
                Some(_) => (model.positions + LaneContacts::COUNT) * BLOCK,
                None => 0,
            }),
            row: vec![0.0; model.positions],
            given: Vec::new(),
            workspace,
            kernel: in_lanes,
            row_remarks: remarks,
            remarks: remarks | own,
            gap,
        };
        let instructions = Instructions::best();
        Ok(Batch {
            assembly: Arc::clone(&assembly),
            contact: *contact,
            base_of_normal,
            instructions,
            worker,
            pool: WorkerPool::default(),
            derivatives: OnceLock::new(),
        })
    }
}

impl Batch {
    /// Instruction set of the SIMD kernel.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// Selects another instruction set; the baseline if this processor does not support `set`.
    pub fn with_instructions(mut self, set: Instructions) -> Self {
        self.instructions = if set.is_available() { set } else { Instructions::Baseline };
        if let Some(lanes) = &mut self.worker.kernel {
            lanes.set_instructions(self.instructions);
        }
        self.pool = WorkerPool::default();
        self
    }

    /// True if the mechanism has a SIMD kernel; otherwise each configuration is computed separately.
    pub fn has_lanes(&self) -> bool {
        self.worker.kernel.is_some()
    }

    /// Findings about each result of the kernel.
    pub fn remarks(&self) -> RemarkFlags {
        self.worker.remarks
    }

    /// m̄ at one configuration: the positions of all joints one after another. Bitwise equal to the result of
    /// [`run`](Self::run). Allocates nothing if the result is not in doubt.
    ///
    /// # Errors
    /// [`StateSizeError::PositionCount`]: a wrong number of positions.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Result<BatchAnswer, StateSizeError> {
        check_positions(positions.len(), self.assembly.model().positions)?;
        let Worker { row_remarks, remarks, .. } = self.worker;
        let clear = self.worker.kernel.as_mut().and_then(|lanes| lanes.effective_mass(positions));
        let mut answer = match clear {
            Some(clear) => BatchAnswer::finite(clear.mass, clear.error, remarks),
            None => evaluate_row(&mut self.worker.workspace, &self.contact, positions, row_remarks),
        };
        answer.remarks |= self.worker.workspace.limits.flags(|q| positions[q]);
        if let Some(gap) = &mut self.worker.gap {
            answer.remarks |= gap.flags(self.assembly.model(), |q| positions[q]);
        }
        Ok(answer)
    }

    /// m̄ and its error at one configuration by the compiled kernel alone, kg. `None` if no kernel supports the contact, or if the result is
    /// in doubt; [`effective_mass`](Self::effective_mass) then uses the recursion.
    ///
    /// # Errors
    /// [`StateSizeError::PositionCount`]: a wrong number of positions.
    pub fn kernel_mass(&mut self, positions: &[f64]) -> Result<Option<(f64, f64)>, StateSizeError> {
        check_positions(positions.len(), self.assembly.model().positions)?;
        let clear = self.worker.kernel.as_mut().and_then(|lanes| lanes.effective_mass(positions));
        Ok(clear.map(|clear| (clear.mass, clear.error)))
    }

    /// True if gradients and inverse inertias are computed in SIMD lanes.
    pub fn has_derivative_lanes(&self) -> bool {
        self.derivatives().has_lanes()
    }

    /// Number of velocities of a gradient: those of all joints, in joint order.
    pub fn velocities(&self) -> usize {
        velocity_count(&self.assembly)
    }

    fn derivatives(&self) -> &BatchDerivatives {
        self.derivatives.get_or_init(|| BatchDerivatives::new(&self.assembly, &self.contact))
    }

    /// m̄ at rows, with the derivatives for which there are columns. A thread of rayon's pool takes `block` rows at once; up to this
    /// number of rows are computed on the calling thread. The results depend on the rows only. Allocates nothing after the first call
    /// with one block, if no result is in doubt.
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
    /// [`BatchError`]: columns, positions or contacts that do not fit. The results of some rows may then be stored.
    ///
    /// [`Pose::effective_mass_gradient`]: crate::Pose::effective_mass_gradient
    /// [`Pose::inverse_operational_inertia`]: crate::Pose::inverse_operational_inertia
    pub fn run<'a, S: From<ContactStatus> + Clone + Send>(
        &self,
        rows: impl Into<BatchRows<'a>>,
        columns: RowColumns<'_, S>,
        block: usize,
    ) -> Result<(), BatchError> {
        let configurations = columns.masses.len();
        let others = [columns.errors.len(), columns.statuses.len()];
        let others = others.into_iter().chain(columns.remarks.as_ref().map(|remarks| remarks.len()));
        if let Some(other) = others.into_iter().find(|length| *length != configurations) {
            return Err(BatchError::Columns { masses: configurations, other });
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
        rows.check(self.assembly.model().positions, configurations)?;
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
            return self.pool.with_worker(&self.worker, |worker| self.run_block(worker, rows, columns));
        }
        let middle = count.div_ceil(block).div_ceil(2) * block;
        let (before, after) = columns.split_at(middle);
        let (first, second) = rayon::join(
            || self.run_blocks(rows.part(0..middle), before, block),
            || self.run_blocks(rows.part(middle..count), after, block),
        );
        first.and_then(|()| second.map_err(|error| error.in_rows_from(middle)))
    }

    /// Computes the rows of a block with a worker.
    fn run_block<S: From<ContactStatus> + Clone>(
        &self,
        worker: &mut Worker,
        rows: BatchRows<'_>,
        mut columns: RowColumns<'_, S>,
    ) -> Result<(), BatchError> {
        let model = self.assembly.model();
        if let Some(contacts) = rows.contacts {
            contacts.check(model, &self.contact, columns.masses.len())?;
        }
        let mut buffer = std::mem::take(&mut worker.given);
        let positions = rows.all_positions(model.positions, columns.masses.len(), &mut buffer)?;
        let base = self.base_of_normal.as_ref();
        let block = RowBlock { positions, contact: &self.contact, contacts: rows.contacts, base };
        worker.compute(block, &mut columns);
        let RowColumns { masses, errors, gradients, inverse_inertias, .. } = columns;
        let derivatives = [(Derivative::Gradient, gradients), (Derivative::InverseInertia, inverse_inertias)];
        for (derivative, values) in derivatives.into_iter().filter_map(|(d, values)| Some((d, values?))) {
            let masses = (&*masses, &*errors);
            self.derivatives().compute(&self.assembly, self.instructions, derivative, block, masses, values);
        }
        worker.given = buffer;
        Ok(())
    }
}

impl Worker {
    /// Computes m̄ of the rows.
    fn compute<S: From<ContactStatus> + Clone>(
        &mut self,
        rows: RowBlock<'_>,
        results: &mut RowColumns<'_, S>,
    ) {
        let Worker { kernel: in_lanes, read, columns, row, workspace, gap, .. } = self;
        let (row_remarks, remarks) = (self.row_remarks, self.remarks);
        let (count, positions, of_rows) = (results.masses.len(), rows.positions, rows.contacts);
        results.statuses.fill(ContactStatus::Finite.into());
        if let Some(bits) = &mut results.remarks {
            bits.fill(remarks.bits());
        }
        let (mut conversion, mut limit) = (None, 0.0);
        if let Some(lanes) = in_lanes {
            limit = lanes.trusted_error();
            lanes.set_lane_contacts(of_rows.map(|_| LaneContacts { first_column: row.len() }));
            conversion = lanes.conversion();
        }
        for start in (0..count).step_by(BLOCK) {
            interruption::check();
            let here = BLOCK.min(count - start);
            let [mut masses, mut errors] = [[f64::NAN; BLOCK]; 2];
            if let Some(lanes) = in_lanes {
                let width = lanes.width();
                let mut ask = |columns, first, from: usize, count: usize| {
                    let (masses, errors) = (&mut masses[from..][..count], &mut errors[from..][..count]);
                    lanes.effective_masses(columns, first, MassColumns { masses, errors });
                };
                let mut done = 0;
                if let (BatchPositions::Columns { values, stride }, None) = (positions, of_rows) {
                    done = here - here % width;
                    ask(PositionColumns { values, stride }, start, 0, done);
                }
                if done < here {
                    let left = here - done;
                    let padded = left.next_multiple_of(width);
                    rows.fill_lanes(columns, read, conversion.as_ref(), start + done, (left, padded));
                    ask(PositionColumns { values: columns, stride: BLOCK }, 0, done, padded);
                }
            }
            let (masses, errors) = (&masses[..here], &errors[..here]);
            results.masses[start..][..here].copy_from_slice(masses);
            results.errors[start..][..here].copy_from_slice(errors);
            let clear =
                |lane: usize| CertifiedMass { mass: masses[lane], error: errors[lane] }.is_clear(limit);
            let mut own = [RemarkFlags::NONE; BLOCK];
            let mut is_plain = true;
            for (lane, own) in own[..here].iter_mut().enumerate() {
                *own = workspace.limits.flags(|q| positions.at(start + lane, q));
                if let (Some(gap), None) = (gap.as_mut(), of_rows) {
                    *own |= gap.flags(workspace.assembly().model(), |q| positions.at(start + lane, q));
                }
                is_plain &= clear(lane) & own.is_empty();
            }
            if is_plain {
                continue;
            }
            for (lane, own) in own[..here].iter().enumerate() {
                let mut answer = match clear(lane) {
                    true if own.is_empty() => continue,
                    true => BatchAnswer::finite(masses[lane], errors[lane], remarks),
                    false => {
                        row.iter_mut().enumerate().for_each(|(q, to)| *to = positions.at(start + lane, q));
                        let contact = rows.contact_at(start + lane);
                        let alternative = in_lanes.as_mut().filter(|_| of_rows.is_some());
                        let model = workspace.assembly().model();
                        match alternative
                            .and_then(|k| k.alternative_mass(&kernel_contact(model, &contact), row))
                        {
                            Some(clear) => BatchAnswer::finite(clear.mass, clear.error, remarks),
                            None => evaluate_row(workspace, &contact, row, row_remarks),
                        }
                    }
                };
                answer.remarks |= *own;
                results.set(start + lane, &answer);
            }
        }
    }
}

/// Computes one configuration by the workspace. `remarks`: findings that hold at every configuration.
fn evaluate_row(
    workspace: &mut Workspace,
    contact: &Contact,
    positions: &[f64],
    remarks: RemarkFlags,
) -> BatchAnswer {
    if workspace.set_positions(positions).is_err() {
        return BatchAnswer::UNREACHED;
    }
    match workspace.evaluate(contact) {
        Ok((mass, error, own)) => BatchAnswer { mass: Some(mass), error, remarks: remarks | own },
        Err(error) => BatchAnswer { remarks: RemarkFlags::from(&error), ..BatchAnswer::NONE },
    }
}
