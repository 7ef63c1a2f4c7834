//! m̄ of one contact at many configurations, with SIMD lanes and threads.
//!
//! Two kinds of mechanisms have a SIMD kernel: trees (on the ground or floating), and linkages of few
//! degrees of freedom. A lane with an uncertain result (massless, immovable, close to either, or with too much
//! rounding) is computed again by [`Workspace`]. For all other mechanisms, [`Workspace`] computes every
//! configuration. Every result equals that of [`Batch::effective_mass`] at the same configuration, bit for bit.

use crate::analysis::assembly::Assembly;
use crate::batch::error::BatchError;
use crate::batch::pool::WorkerPool;
use crate::batch::row_contacts::{BatchContacts, RowContacts, in_root_axes};
use crate::batch::row_remarks::{PositionLimits, RowGap};
use crate::batch::workspace::Workspace;
use crate::kernels::kernel_contact;
use crate::kinematics::contact::Contact;
use crate::kinematics::outcome::{EffectiveMass, ResponseError};
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
    /// Error, kg; `None` unless m̄ is finite, and if the error is above m̄ ([`RemarkFlags::UNKNOWN_ERROR`]). For a massless contact: upper limit of m̄, if the contact is
    /// massless only within rounding ([`Remark::MasslessToRounding`](crate::Remark::MasslessToRounding) of a pose).
    pub error: Option<f64>,
    /// Findings about the result, or the reason for a missing result. Limits of mimics are not checked.
    pub remarks: RemarkFlags,
}

impl BatchAnswer {
    /// Initial value: no result yet.
    pub const NONE: Self = Self { mass: None, error: None, remarks: RemarkFlags::NONE };

    /// Finite m̄, kg, with its error.
    fn finite(mass: f64, error: f64, remarks: RemarkFlags) -> Self {
        Self { mass: Some(EffectiveMass::Finite(mass)), error: Some(error), remarks }
    }

    /// True if the contact is massless only within rounding. Masses lost in sums with larger masses may be present.
    pub fn is_massless_to_rounding(&self) -> bool {
        self.mass == Some(EffectiveMass::Massless) && self.error.is_some()
    }
}

/// One contact, ready for many configurations.
#[derive(Clone, Debug)]
pub struct Batch {
    assembly: Arc<Assembly>,
    contact: Contact,
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
    /// Findings that hold at every configuration, and those of each result of the kernel.
    remarks: RemarkFlags,
    lane_remarks: RemarkFlags,
    /// Pose of the root link in the world, for normals given in the world.
    base_of_normal: Option<Transform<f64>>,
    limits: PositionLimits,
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
            .zip(kernel_contact(model, contact))
            .and_then(|(mut lanes, contact)| lanes.set_contact(&contact).then_some(lanes));
        let own = in_lanes.as_ref().map_or(RemarkFlags::NONE, |_| assembly.kernel_remarks());
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
            lane_remarks: remarks | own,
            base_of_normal,
            limits: PositionLimits::of(model, false),
            gap,
        };
        let instructions = Instructions::best();
        Ok(Batch {
            assembly: Arc::clone(&assembly),
            contact: *contact,
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

    /// The contact; a normal given in the world is in the axes of the root link.
    pub(super) fn contact(&self) -> &Contact {
        &self.contact
    }

    /// Pose of the root link in the world by which normals of rows are converted; `None`: they are not converted.
    pub(super) fn base_of_normal(&self) -> Option<&Transform<f64>> {
        self.worker.base_of_normal.as_ref()
    }

    /// True if the mechanism has a SIMD kernel; otherwise each configuration is computed separately.
    pub fn has_lanes(&self) -> bool {
        self.worker.kernel.is_some()
    }

    /// Findings about each result that [`run_columns`](Self::run_columns) does not pass to `other`.
    pub fn remarks(&self) -> RemarkFlags {
        self.worker.lane_remarks
    }

    /// m̄ at one configuration: the positions of all joints one after another. Bitwise equal to the result of
    /// [`run`](Self::run). Allocates nothing if the result is not in doubt.
    ///
    /// # Errors
    /// [`StateSizeError::PositionCount`]: a wrong number of positions.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Result<BatchAnswer, StateSizeError> {
        check_positions(positions.len(), self.assembly.model().positions)?;
        let Worker { remarks, lane_remarks, .. } = self.worker;
        let clear = self.worker.kernel.as_mut().and_then(|lanes| lanes.effective_mass(positions));
        let mut answer = match clear {
            Some(clear) => BatchAnswer::finite(clear.mass, clear.error, lane_remarks),
            None => evaluate_row(&mut self.worker.workspace, &self.contact, positions, remarks),
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
        self.pool
            .with_worker(&self.worker, |worker| worker.compute_portion(self.fixed(), positions, 0, answers));
        Ok(())
    }

    /// Like [`run_here`](Self::run_here), with results in columns. `masses` receives m̄, kg (NaN unless finite).
    /// `errors` receives the error, kg (NaN for `None`). The length of the columns is the number of
    /// configurations. Configurations with an uncertain lane are computed separately; `other` is called with the
    /// index and the result of each of them, and of each configuration outside joint limits. All results that are not finite are among these.
    ///
    /// # Errors
    /// As for [`run`](Self::run); `errors` and `masses` differ in length.
    pub fn run_columns(
        &self,
        positions: BatchPositions<'_>,
        masses: &mut [f64],
        errors: &mut [f64],
        other: impl FnMut(usize, BatchAnswer),
    ) -> Result<(), BatchError> {
        self.run_columns_of(None, positions, masses, errors, other)
    }

    /// Like [`run_columns`](Self::run_columns), with another contact point and normal at each configuration: m̄ of the point
    /// `contacts.points[3c..3c + 3]` on the contact link along `contacts.normals[3c..3c + 3]`, at configuration c. The link, the
    /// other side and the frame of the normal are those of the contact of the batch.
    ///
    /// # Errors
    /// As for [`run_columns`](Self::run_columns); [`BatchError::ContactCount`]: too few or too many points or normals;
    /// [`BatchError::Contact`]: numbers that are not finite, or a normal of length zero; [`BatchError::NormalAlongLine`].
    pub fn run_contacts(
        &self,
        positions: BatchPositions<'_>,
        contacts: BatchContacts<'_>,
        masses: &mut [f64],
        errors: &mut [f64],
        other: impl FnMut(usize, BatchAnswer),
    ) -> Result<(), BatchError> {
        contacts.check(self.assembly.model(), &self.contact, masses.len())?;
        self.run_columns_of(Some(contacts), positions, masses, errors, other)
    }

    /// Computes m̄ at the configurations, for the contact of the batch or for one contact at each configuration.
    fn run_columns_of(
        &self,
        contacts: Option<BatchContacts<'_>>,
        positions: BatchPositions<'_>,
        masses: &mut [f64],
        errors: &mut [f64],
        other: impl FnMut(usize, BatchAnswer),
    ) -> Result<(), BatchError> {
        if errors.len() != masses.len() {
            return Err(BatchError::Columns { masses: masses.len(), errors: errors.len() });
        }
        self.check(positions, masses.len())?;
        let mut columns = AnswerColumns { masses, errors, other };
        let contacts = RowContacts { contacts, ..self.fixed() };
        self.pool
            .with_worker(&self.worker, |worker| worker.compute_portion(contacts, positions, 0, &mut columns));
        Ok(())
    }

    /// The contact of the batch at every configuration.
    fn fixed(&self) -> RowContacts<'_> {
        RowContacts { contact: &self.contact, contacts: None }
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
                worker.compute_portion(self.fixed(), positions, first, portion)
            });
            let done = done.fetch_add(portion.len(), Ordering::Relaxed) + portion.len();
            if watch(done).is_break() {
                stopped.store(true, Ordering::Relaxed);
            }
        });
        let done = done.into_inner();
        if done < answers.len() { Err(BatchError::Stopped { done }) } else { Ok(()) }
    }

    /// Checks the stride and the number of positions.
    fn check(&self, positions: BatchPositions<'_>, configurations: usize) -> Result<(), BatchError> {
        let count = self.assembly.model().positions;
        let (got, stride, least, outer, inner) = match positions {
            BatchPositions::Rows { values, stride } => (values.len(), stride, count, configurations, count),
            BatchPositions::Columns { values, stride } => {
                (values.len(), stride, configurations, count, configurations)
            }
        };
        if stride < least {
            return Err(BatchError::Stride { stride, least });
        }
        let needed = outer.checked_sub(1).and_then(|o| o.checked_mul(stride)?.checked_add(inner));
        match needed {
            None if outer == 0 => Ok(()),
            Some(needed) if needed <= got || inner == 0 => Ok(()),
            _ => {
                let needed = needed.unwrap_or(usize::MAX);
                Err(BatchError::Short { got, needed, configurations, positions: count, stride })
            }
        }
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
        let Worker { kernel: in_lanes, read, columns, row, workspace, base_of_normal, limits, gap, .. } =
            self;
        let (remarks, lane_remarks) = (self.remarks, self.lane_remarks);
        let count = places.count();
        let of_rows = contacts.contacts;
        let contact_column = row.len();
        let (mut conversion, mut limit) = (None, 0.0);
        if let Some(lanes) = in_lanes {
            limit = lanes.trusted_error();
            lanes.set_lane_contacts(of_rows.map(|_| LaneContacts { first_column: contact_column }));
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
                    // Unused lanes repeat the last configuration.
                    for lane in 0..padded {
                        let configuration = start + done + lane.min(left - 1);
                        positions.copy_to_columns(configuration, read, &mut columns[lane..]);
                        if let (Some(contacts), Some(conversion)) = (of_rows, &conversion) {
                            let [point, normal] = contacts.at(configuration);
                            let normal = in_root_axes(normal, base_of_normal.as_ref());
                            let [point, normal] = conversion.convert(&point, &normal);
                            let numbers = point.iter().chain(&normal).enumerate();
                            numbers.for_each(|(k, x)| columns[(contact_column + k) * BLOCK + lane] = *x);
                        }
                    }
                    ask(PositionColumns { values: columns, stride: BLOCK }, 0, done, padded);
                }
            }
            let (masses, errors) = (&masses[..here], &errors[..here]);
            places.store_lanes(block, masses, errors, lane_remarks);
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
                    true => BatchAnswer::finite(masses[lane], errors[lane], lane_remarks),
                    false => {
                        row.iter_mut().enumerate().for_each(|(q, to)| *to = positions.at(start + lane, q));
                        let contact = contacts.at(start + lane, base_of_normal.as_ref());
                        evaluate_row(workspace, &contact, row, remarks)
                    }
                };
                answer.remarks |= *own;
                places.store_one(block + lane, answer);
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
        return BatchAnswer { remarks: RemarkFlags::NO_ANSWER, ..BatchAnswer::NONE };
    }
    match workspace.evaluate(contact) {
        Ok((mass, error, own)) => BatchAnswer { mass: Some(mass), error, remarks: remarks | own },
        Err(error) => BatchAnswer { remarks: RemarkFlags::from(&error), ..BatchAnswer::NONE },
    }
}

impl BatchPositions<'_> {
    /// Position `q` of a configuration.
    #[inline]
    pub(super) fn at(&self, configuration: usize, q: usize) -> f64 {
        match self {
            BatchPositions::Rows { values, stride } => values[configuration * stride + q],
            BatchPositions::Columns { values, stride } => values[q * stride + configuration],
        }
    }

    /// Writes the positions with indices `read` of a configuration to `to`, [`BLOCK`] apart.
    fn copy_to_columns(&self, configuration: usize, read: &[usize], to: &mut [f64]) {
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
