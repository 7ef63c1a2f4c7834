//! m̄ of one contact at many configurations, with SIMD lanes and threads.
//!
//! Two kinds of mechanisms have a SIMD kernel: trees (on the ground or floating), and linkages of few
//! degrees of freedom. A lane with an uncertain result (massless, immovable, close to either, or with too much
//! rounding) is computed again by [`Workspace`]. For all other mechanisms, [`Workspace`] computes every
//! configuration. Every result equals that of [`Batch::effective_mass`] at the same configuration, bit for bit.

use crate::analysis::assembly::Assembly;
use crate::analysis::response::ContactResponse;
use crate::batch::contact_map::ContactStatus;
use crate::batch::error::BatchError;
use crate::batch::pool::WorkerPool;
use crate::batch::row_contacts::{BatchContacts, RowContacts};
use crate::batch::row_remarks::{PositionLimits, RowGap};
use crate::batch::workspace::Workspace;
use crate::kernels::kernel_contact;
use crate::kinematics::contact::Contact;
use crate::kinematics::outcome::{EffectiveMass, Remark, ResponseError};
use crate::kinematics::remarks::RemarkFlags;
use crate::model::interruption;
use crate::model::velocities::{StateSizeError, check_positions};
use percuss_kernel::{Aligned, CertifiedMass, Kernel, LaneContacts, MassColumns, PositionColumns};
use percuss_spatial::Transform;
use percuss_spatial::lanes::Instructions;
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Number of configurations per task of a thread.
const PORTION: usize = 512;
/// Number of configurations per call of the SIMD kernel: a multiple of the lane count of every instruction set.
pub(super) const BLOCK: usize = 64;

/// Positions of many configurations. Each configuration holds the positions of all joints one after another, in joint
/// order.
#[derive(Clone, Copy, Debug)]
pub enum BatchPositions<'a> {
    /// Configuration `c` begins at index `c · stride`.
    Rows {
        /// The positions.
        values: &'a [f64],
        /// Distance between consecutive configurations.
        stride: usize,
    },
    /// Position `q` of configuration `c` has index `q · stride + c`. The fastest layout.
    Columns {
        /// The positions.
        values: &'a [f64],
        /// Distance between consecutive positions.
        stride: usize,
    },
}

/// Result for one configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BatchAnswer {
    /// m̄; `None` if there is no result. `remarks` contains the reason, and [`Workspace::effective_mass`] at the
    /// configuration returns the error.
    pub mass: Option<EffectiveMass>,
    /// Error, kg; `None` unless m̄ is finite, if the error is above m̄, and for a mechanism with loops without SIMD lanes for the contact
    /// ([`RemarkFlags::UNKNOWN_ERROR`]). For a massless contact: upper limit of m̄, if the contact is
    /// massless only within rounding ([`Remark::MasslessToRounding`](crate::Remark::MasslessToRounding) of a pose).
    pub error: Option<f64>,
    /// Findings about the result, or the reason for a missing result. Limits of mimics are not checked.
    pub remarks: RemarkFlags,
}

impl BatchAnswer {
    /// Initial value: no result yet.
    pub const NONE: Self = Self { mass: None, error: None, remarks: RemarkFlags::NONE };
    /// Result of a row without a pose.
    pub const UNREACHED: Self = Self { remarks: RemarkFlags::NO_ANSWER, ..Self::NONE };

    /// Finite m̄, kg, with its error.
    pub fn finite(mass: f64, error: f64, remarks: RemarkFlags) -> Self {
        Self { mass: Some(EffectiveMass::Finite(mass)), error: Some(error), remarks }
    }

    /// Status of the contact.
    pub fn status(&self) -> ContactStatus {
        match self.mass {
            Some(EffectiveMass::Finite(_)) => ContactStatus::Finite,
            Some(EffectiveMass::Immovable) => ContactStatus::Immovable,
            Some(EffectiveMass::Massless) if self.error.is_some() => ContactStatus::MasslessToRounding,
            Some(EffectiveMass::Massless) => ContactStatus::Massless,
            None => ContactStatus::Unanswered,
        }
    }
}

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
    workspace: Workspace,
    /// Findings that hold at every configuration.
    remarks: RemarkFlags,
    limits: PositionLimits,
    /// Gap of the contact of the batch, if it is a named contact with a gap.
    gap: Option<RowGap>,
}

impl From<&ContactResponse> for BatchAnswer {
    fn from(response: &ContactResponse) -> Self {
        let limit = response.remarks.iter().find_map(|remark| match remark {
            Remark::MasslessToRounding { up_to } => Some(*up_to),
            _ => None,
        });
        let error = match response.effective_mass {
            EffectiveMass::Finite(_) => response.effective_mass_error(),
            EffectiveMass::Immovable | EffectiveMass::Massless => limit,
        };
        Self { mass: Some(response.effective_mass), error, remarks: response.remark_flags() }
    }
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
            .zip(kernel_contact(model, contact))
            .and_then(|(mut lanes, contact)| lanes.set_contact(&contact).then_some(lanes));
        let worker = Worker {
            read: in_lanes.iter().flat_map(Kernel::read_positions).collect(),
            columns: Aligned::zeros(match in_lanes {
                Some(_) => (model.positions + LaneContacts::COUNT) * BLOCK,
                None => 0,
            }),
            row: vec![0.0; model.positions],
            workspace,
            kernel: in_lanes,
            remarks,
            limits: PositionLimits::of(model, false),
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

    /// The assembly of the batch.
    pub(super) fn assembly(&self) -> &Arc<Assembly> {
        &self.assembly
    }

    /// Contacts of rows; `None`: the contact of the batch at every row.
    pub(super) fn contacts_of<'a>(&'a self, contacts: Option<BatchContacts<'a>>) -> RowContacts<'a> {
        RowContacts { contact: &self.contact, contacts, base: self.base_of_normal.as_ref() }
    }

    /// True if the mechanism has a SIMD kernel; otherwise each configuration is computed separately.
    pub fn has_lanes(&self) -> bool {
        self.worker.kernel.is_some()
    }

    /// Findings that hold at every configuration. The findings of a single result include these.
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
        let remarks = self.worker.remarks;
        let clear = self.worker.kernel.as_mut().and_then(|lanes| lanes.effective_mass(positions));
        let mut answer = match clear {
            Some(clear) => BatchAnswer::finite(clear.mass, clear.error, remarks),
            None => {
                let with_closing = self.worker.kernel.is_some();
                evaluate_row(&mut self.worker.workspace, &self.contact, positions, with_closing, remarks)
            }
        };
        answer.remarks |= self.worker.limits.flags(|q| positions[q]);
        if let Some(gap) = &mut self.worker.gap {
            answer.remarks |= gap.flags(self.assembly.model(), |q| positions[q]);
        }
        Ok(answer)
    }

    /// Computes m̄ at `answers.len()` configurations on all threads of rayon's pool. The results do not depend on the
    /// order of the work.
    ///
    /// # Errors
    /// [`BatchError`]: too few numbers, a stride that is too small.
    pub fn run(&self, positions: BatchPositions<'_>, answers: &mut [BatchAnswer]) -> Result<(), BatchError> {
        self.run_watched(positions, answers, |_| ControlFlow::Continue(()))
    }

    /// Like [`run`](Self::run), on the calling thread only. Allocates nothing after the first call, if no result is
    /// in doubt.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn run_here(
        &self,
        positions: BatchPositions<'_>,
        answers: &mut [BatchAnswer],
    ) -> Result<(), BatchError> {
        self.check(positions, answers.len())?;
        self.pool.with_worker(&self.worker, |worker| {
            worker.compute_portion(self.contacts_of(None), positions, 0, answers)
        });
        Ok(())
    }

    /// Like [`run_here`](Self::run_here), with results in columns. `masses` receives m̄, kg (NaN unless finite).
    /// `errors` receives the error, kg (NaN for `None`). The length of the columns is the number of
    /// configurations. Configurations with an uncertain lane are computed separately; `other` is called with the
    /// index and the result of each of them, and of each configuration outside joint limits. All results that are not finite are among these.
    ///
    /// `contacts`: another contact point and normal at each configuration; the link, the other side and the frame of the normal are
    /// those of the contact of the batch.
    ///
    /// # Errors
    /// As for [`run`](Self::run); `errors` and `masses` differ in length; [`BatchError::ContactCount`], [`BatchError::Contact`],
    /// [`BatchError::NormalAlongLine`]: invalid `contacts`.
    pub fn run_columns(
        &self,
        positions: BatchPositions<'_>,
        contacts: Option<BatchContacts<'_>>,
        masses: &mut [f64],
        errors: &mut [f64],
        other: impl FnMut(usize, BatchAnswer),
    ) -> Result<(), BatchError> {
        if let Some(contacts) = contacts {
            contacts.check(self.assembly.model(), &self.contact, masses.len())?;
        }
        if errors.len() != masses.len() {
            return Err(BatchError::Columns { masses: masses.len(), errors: errors.len() });
        }
        self.check(positions, masses.len())?;
        let mut columns = AnswerColumns { masses, errors, other };
        let contacts = self.contacts_of(contacts);
        self.pool
            .with_worker(&self.worker, |worker| worker.compute_portion(contacts, positions, 0, &mut columns));
        Ok(())
    }

    /// Checks the number of positions.
    fn check(&self, positions: BatchPositions<'_>, configurations: usize) -> Result<(), BatchError> {
        positions.check(self.assembly.model().positions, configurations)
    }

    /// Like [`run`](Self::run), with progress reports. `watch` receives the number of finished configurations from
    /// time to time, from any thread, and may stop the run.
    ///
    /// # Errors
    /// As for [`run`](Self::run); [`BatchError::Stopped`]: stopped by `watch`. `answers` contains the results up to
    /// that point.
    pub fn run_watched(
        &self,
        positions: BatchPositions<'_>,
        answers: &mut [BatchAnswer],
        watch: impl Fn(usize) -> ControlFlow<()> + Sync,
    ) -> Result<(), BatchError> {
        self.check(positions, answers.len())?;
        let (done, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
        answers.par_chunks_mut(PORTION).enumerate().for_each(|(number, portion)| {
            if stopped.load(Ordering::Relaxed) {
                return;
            }
            let first = number * PORTION;
            self.pool.with_worker(&self.worker, |worker| {
                worker.compute_portion(self.contacts_of(None), positions, first, portion)
            });
            let done = done.fetch_add(portion.len(), Ordering::Relaxed) + portion.len();
            if watch(done).is_break() {
                stopped.store(true, Ordering::Relaxed);
            }
        });
        let done = done.into_inner();
        if done < answers.len() { Err(BatchError::Stopped { done }) } else { Ok(()) }
    }
}

/// Destination of the results.
trait ResultSink {
    /// Number of results.
    fn count(&self) -> usize;

    /// Stores the lane results from index `first` on, certain or not.
    fn store_lanes(&mut self, first: usize, masses: &[f64], errors: &[f64], remarks: RemarkFlags);

    /// Stores the result of a configuration computed separately.
    fn store_one(&mut self, at: usize, answer: BatchAnswer);
}

impl ResultSink for [BatchAnswer] {
    fn count(&self) -> usize {
        self.len()
    }

    #[inline]
    fn store_lanes(&mut self, first: usize, masses: &[f64], errors: &[f64], remarks: RemarkFlags) {
        for ((answer, mass), error) in self[first..].iter_mut().zip(masses).zip(errors) {
            *answer = BatchAnswer::finite(*mass, *error, remarks);
        }
    }

    fn store_one(&mut self, at: usize, answer: BatchAnswer) {
        self[at] = answer;
    }
}

/// Results in columns; `other` receives results that need a separate computation.
struct AnswerColumns<'a, F> {
    masses: &'a mut [f64],
    errors: &'a mut [f64],
    other: F,
}

impl<F: FnMut(usize, BatchAnswer)> ResultSink for AnswerColumns<'_, F> {
    fn count(&self) -> usize {
        self.masses.len()
    }

    #[inline]
    fn store_lanes(&mut self, first: usize, masses: &[f64], errors: &[f64], _: RemarkFlags) {
        self.masses[first..][..masses.len()].copy_from_slice(masses);
        self.errors[first..][..errors.len()].copy_from_slice(errors);
    }

    fn store_one(&mut self, at: usize, answer: BatchAnswer) {
        let finite = |mass| if let EffectiveMass::Finite(m) = mass { m } else { f64::NAN };
        self.masses[at] = answer.mass.map_or(f64::NAN, finite);
        self.errors[at] = answer.error.unwrap_or(f64::NAN);
        (self.other)(at, answer);
    }
}

impl Worker {
    /// Computes `places.count()` configurations, starting at configuration `first`.
    fn compute_portion(
        &mut self,
        contacts: RowContacts<'_>,
        positions: BatchPositions<'_>,
        first: usize,
        places: &mut (impl ResultSink + ?Sized),
    ) {
        let Worker { kernel: in_lanes, read, columns, row, workspace, remarks, limits, gap } = self;
        let count = places.count();
        let of_rows = contacts.contacts;
        let (mut conversion, mut limit) = (None, 0.0);
        if let Some(lanes) = in_lanes {
            limit = lanes.trusted_error();
            lanes.set_lane_contacts(of_rows.map(|_| LaneContacts { first_column: row.len() }));
            conversion = lanes.conversion();
        }
        for block in (0..count).step_by(BLOCK) {
            interruption::check();
            let (start, here) = (first + block, BLOCK.min(count - block));
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
                    let from = (positions, &read[..]);
                    contacts.fill_lanes(columns, from, conversion.as_ref(), start + done, (left, padded));
                    ask(PositionColumns { values: columns, stride: BLOCK }, 0, done, padded);
                }
            }
            let (masses, errors) = (&masses[..here], &errors[..here]);
            places.store_lanes(block, masses, errors, *remarks);
            let clear =
                |lane: usize| CertifiedMass { mass: masses[lane], error: errors[lane] }.is_clear(limit);
            let mut own = [RemarkFlags::NONE; BLOCK];
            let mut is_plain = true;
            for (lane, own) in own[..here].iter_mut().enumerate() {
                *own = limits.flags(|q| positions.at(start + lane, q));
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
                    true => BatchAnswer::finite(masses[lane], errors[lane], *remarks),
                    false => {
                        row.iter_mut().enumerate().for_each(|(q, to)| *to = positions.at(start + lane, q));
                        let contact = contacts.at(start + lane);
                        evaluate_row(workspace, &contact, row, in_lanes.is_some(), *remarks)
                    }
                };
                answer.remarks |= *own;
                places.store_one(block + lane, answer);
            }
        }
    }
}

/// Computes one configuration by the workspace. `with_closing`: true if the lanes did not certify this configuration, so that its error has
/// the part of the closing; false without lanes. `remarks`: findings that hold at every configuration.
fn evaluate_row(
    workspace: &mut Workspace,
    contact: &Contact,
    positions: &[f64],
    with_closing: bool,
    remarks: RemarkFlags,
) -> BatchAnswer {
    if workspace.set_positions(positions).is_err() {
        return BatchAnswer::UNREACHED;
    }
    match workspace.evaluate(contact, with_closing) {
        Ok((mass, error, own)) => BatchAnswer { mass: Some(mass), error, remarks: remarks | own },
        Err(error) => BatchAnswer { remarks: RemarkFlags::from(&error), ..BatchAnswer::NONE },
    }
}

impl BatchPositions<'_> {
    /// Writes the positions with indices `read` of a configuration to `to`, [`BLOCK`] apart.
    pub(super) fn copy_to_columns(&self, configuration: usize, read: &[usize], to: &mut [f64]) {
        match self {
            BatchPositions::Rows { values, stride } => {
                let row = &values[configuration * stride..];
                read.iter().for_each(|&q| to[q * BLOCK] = row[q]);
            }
            BatchPositions::Columns { .. } => {
                read.iter().for_each(|&q| to[q * BLOCK] = self.at(configuration, q));
            }
        }
    }
}
