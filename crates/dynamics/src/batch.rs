//! m̄ of one contact at many configurations: in lanes, by threads.
//!
//! Trees without mimics, on the ground or floating, and linkages of few freedoms go in as many lanes as the processor
//! has. A lane that is not sure (massless, immovable, near either, too much rounding) is asked again by itself,
//! by [`Workspace`], and so is every configuration of other mechanisms: the answers are the same, one by one.

use crate::aligned::Aligned;
use crate::answered::{Answered, Answers, Columns};
use crate::assembly::Assembly;
use crate::contact::Contact;
use crate::idle::Idle;
use crate::in_lanes::InLanes;
use crate::outcome::{EffectiveMass, ResponseError};
use crate::remarks::RemarkFlags;
use crate::velocities::{VelocityError, check_positions};
use crate::workspace::Workspace;
use percuss_spatial::lanes::Instructions;
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// How many configurations a thread takes at once.
const PORTION: usize = 512;
/// How many of them go through lanes in one call: a multiple of every instruction set's lanes.
const BLOCK: usize = 64;

/// Configurations: the positions of all joints one after another, in joint order, for each.
#[derive(Clone, Copy, Debug)]
pub enum BatchPositions<'a> {
    /// Configuration `c` begins at `c · stride`.
    Rows {
        /// The positions.
        values: &'a [f64],
        /// How far configurations are apart.
        stride: usize,
    },
    /// Position `q` of configuration `c` stands at `q · stride + c`: the fastest.
    Columns {
        /// The positions.
        values: &'a [f64],
        /// How far positions are apart.
        stride: usize,
    },
}

/// What one configuration is answered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BatchAnswer {
    /// None: there is no answer: `remarks` has the reason, [`Workspace::effective_mass`] at that configuration states it.
    pub mass: Option<EffectiveMass>,
    /// The error by rounding, kg; `None` if it was not counted. Of a massless contact: the largest m̄ that it may have, if it
    /// is massless to rounding only ([`Remark::MasslessToRounding`](crate::Remark::MasslessToRounding) of a pose).
    pub error: Option<f64>,
    /// The findings about the answer, or why there is none. Limits of joints are not looked at.
    pub remarks: RemarkFlags,
}

impl BatchAnswer {
    /// No answer yet.
    pub const NONE: Self = Self { mass: None, error: None, remarks: RemarkFlags::NONE };

    /// True if the contact is massless to rounding only: masses left out in sums of larger ones may be there.
    pub fn is_massless_to_rounding(&self) -> bool {
        self.mass == Some(EffectiveMass::Massless) && self.error.is_some()
    }
}

/// Why a batch does not run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchError {
    /// Fewer numbers than the configurations need.
    #[error(
        "{got} numbers are given; {configurations} configurations of {positions} positions, {stride} apart, need {needed}"
    )]
    Short {
        /// How many are given.
        got: usize,
        /// How many are needed.
        needed: usize,
        /// How many configurations are asked for.
        configurations: usize,
        /// How many positions each has.
        positions: usize,
        /// The stride.
        stride: usize,
    },
    /// The stride lets configurations overlap.
    #[error("the stride is {stride}; expected at least {least}")]
    Stride {
        /// What was given.
        stride: usize,
        /// The least.
        least: usize,
    },
    /// Columns of different lengths.
    #[error("there is room for {masses} masses and {errors} errors; expected as many of both")]
    Columns {
        /// How many masses there is room for.
        masses: usize,
        /// How many errors.
        errors: usize,
    },
    /// The caller stopped it.
    #[error("stopped after {done} configurations")]
    Stopped {
        /// How many are answered.
        done: usize,
    },
}

/// One contact, ready for many configurations.
#[derive(Clone, Debug)]
pub struct Batch {
    assembly: Arc<Assembly>,
    contact: Contact,
    instructions: Instructions,
    worker: Worker,
    idle: Idle<Worker>,
}

/// What a thread works with.
#[derive(Clone, Debug)]
struct Worker {
    in_lanes: Option<InLanes>,
    /// Which positions lanes read.
    read: Vec<usize>,
    /// Positions of a block by columns, [`BLOCK`] apart.
    columns: Aligned,
    /// Positions of one configuration.
    row: Vec<f64>,
    workspace: Workspace,
    /// The findings that hold at every configuration.
    remarks: RemarkFlags,
}

impl Assembly {
    /// Room to ask for m̄ of one contact at many configurations of this assembly. Normals in the world are taken with the root
    /// link at the world's origin; [`Workspace::batch`] has another base.
    ///
    /// # Errors
    /// [`ResponseError`]: a contact that means nothing.
    pub fn batch(self: &Arc<Self>, contact: &Contact) -> Result<Batch, ResponseError> {
        self.workspace().batch(contact)
    }
}

impl Workspace {
    /// Room to ask for m̄ of one contact at many configurations, with the assembly and the base of this workspace.
    ///
    /// # Errors
    /// [`ResponseError`]: a contact that means nothing.
    pub fn batch(&self, contact: &Contact) -> Result<Batch, ResponseError> {
        let assembly = Arc::clone(self.assembly());
        let model = assembly.model();
        model.check_contact(contact)?;
        let (contact, remarks) = self.prepare(contact);
        let contact = &contact;
        let mut workspace = self.clone();
        let in_lanes =
            workspace.take_lanes().and_then(|mut lanes| lanes.aim(model, contact).then_some(lanes));
        let worker = Worker {
            read: in_lanes.iter().flat_map(InLanes::read).collect(),
            columns: Aligned::zeros(if in_lanes.is_some() { model.positions.max(1) * BLOCK } else { 0 }),
            row: vec![0.0; model.positions],
            workspace,
            in_lanes,
            remarks,
        };
        let instructions = Instructions::best();
        Ok(Batch {
            assembly: Arc::clone(&assembly),
            contact: *contact,
            instructions,
            worker,
            idle: Idle::default(),
        })
    }
}

impl Batch {
    /// The instruction set that lanes take.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// Takes another instruction set; the baseline where this processor has not that one.
    pub fn with_instructions(mut self, set: Instructions) -> Self {
        self.instructions = if set.is_available() { set } else { Instructions::Baseline };
        if let Some(lanes) = &mut self.worker.in_lanes {
            lanes.set_instructions(self.instructions);
        }
        self.idle = Idle::default();
        self
    }

    /// Whether configurations go through lanes; else each is asked by itself.
    pub fn has_lanes(&self) -> bool {
        self.worker.in_lanes.is_some()
    }

    /// m̄ at one configuration: the positions of all joints one after another. Equal to the last bit to that of
    /// [`run`](Self::run). Allocates nothing where nothing is in doubt.
    ///
    /// # Errors
    /// [`VelocityError::Positions`]: not as many as the mechanism has.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Result<BatchAnswer, VelocityError> {
        check_positions(positions.len(), self.assembly.model().positions)?;
        if let Some(clear) = self.worker.in_lanes.as_mut().and_then(|lanes| lanes.one(positions)) {
            let mass = Some(EffectiveMass::Finite(clear.mass));
            return Ok(BatchAnswer { mass, error: Some(clear.error), remarks: self.worker.remarks });
        }
        Ok(by_itself(&mut self.worker.workspace, &self.contact, positions, self.worker.remarks))
    }

    /// m̄ at as many configurations as there are answers, by all threads of rayon's pool. The order of the work has no
    /// influence on any answer.
    ///
    /// # Errors
    /// [`BatchError`]: too few numbers, a stride that is too small.
    pub fn run(&self, positions: BatchPositions<'_>, answers: &mut [BatchAnswer]) -> Result<(), BatchError> {
        self.run_watched(positions, answers, |_| ControlFlow::Continue(()))
    }

    /// As [`run`](Self::run), by the calling thread alone. Allocates nothing after the first time, where nothing is in doubt.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_here(
        &self,
        positions: BatchPositions<'_>,
        answers: &mut [BatchAnswer],
    ) -> Result<(), BatchError> {
        self.check(positions, answers.len())?;
        self.idle.with(&self.worker, |worker| worker.portion(&self.contact, positions, 0, answers));
        Ok(())
    }

    /// As [`run_here`](Self::run_here), into columns: m̄, kg, NaN unless finite, and what rounding may amount
    /// to, kg, NaN where it was not counted, for as many configurations as they are long. A configuration that lanes leave in doubt is
    /// asked by itself, and `other` gets its number and its answer: all that are not finite are among them.
    ///
    /// # Errors
    /// As [`run`](Self::run); `errors` is not as long as `masses`.
    pub fn run_columns(
        &self,
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
        self.idle.with(&self.worker, |worker| worker.portion(&self.contact, positions, 0, &mut columns));
        Ok(())
    }

    /// As [`run`](Self::run); tells how many are done, now and then and from any thread, and stops when it is told to.
    ///
    /// # Errors
    /// As [`run`](Self::run); [`BatchError::Stopped`]: stopped. What was answered until then stands in `answers`.
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
            self.idle.with(&self.worker, |worker| worker.portion(&self.contact, positions, first, portion));
            let done = done.fetch_add(portion.len(), Ordering::Relaxed) + portion.len();
            if watch(done).is_break() {
                stopped.store(true, Ordering::Relaxed);
            }
        });
        let done = done.into_inner();
        if done < answers.len() { Err(BatchError::Stopped { done }) } else { Ok(()) }
    }

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

/// Where answers go.
trait Places {
    fn count(&self) -> usize;

    /// What lanes answer from a configuration on, in doubt or not.
    fn put(&mut self, first: usize, masses: &[f64], errors: &[f64], remarks: RemarkFlags);

    /// What one that was asked by itself is answered.
    fn put_one(&mut self, at: usize, answer: BatchAnswer);
}

impl Places for [BatchAnswer] {
    fn count(&self) -> usize {
        self.len()
    }

    #[inline]
    fn put(&mut self, first: usize, masses: &[f64], errors: &[f64], remarks: RemarkFlags) {
        for ((answer, mass), error) in self[first..].iter_mut().zip(masses).zip(errors) {
            *answer = BatchAnswer { mass: Some(EffectiveMass::Finite(*mass)), error: Some(*error), remarks };
        }
    }

    fn put_one(&mut self, at: usize, answer: BatchAnswer) {
        self[at] = answer;
    }
}

struct AnswerColumns<'a, F> {
    masses: &'a mut [f64],
    errors: &'a mut [f64],
    other: F,
}

impl<F: FnMut(usize, BatchAnswer)> Places for AnswerColumns<'_, F> {
    fn count(&self) -> usize {
        self.masses.len()
    }

    #[inline]
    fn put(&mut self, first: usize, masses: &[f64], errors: &[f64], _: RemarkFlags) {
        self.masses[first..][..masses.len()].copy_from_slice(masses);
        self.errors[first..][..errors.len()].copy_from_slice(errors);
    }

    fn put_one(&mut self, at: usize, answer: BatchAnswer) {
        let finite = |mass| if let EffectiveMass::Finite(m) = mass { m } else { f64::NAN };
        self.masses[at] = answer.mass.map_or(f64::NAN, finite);
        self.errors[at] = answer.error.unwrap_or(f64::NAN);
        (self.other)(at, answer);
    }
}

impl Worker {
    /// As many configurations as there are places, `first` and those after it.
    fn portion(
        &mut self,
        contact: &Contact,
        positions: BatchPositions<'_>,
        first: usize,
        places: &mut (impl Places + ?Sized),
    ) {
        let Worker { in_lanes, read, columns, row, workspace, remarks } = self;
        let count = places.count();
        for block in (0..count).step_by(BLOCK) {
            let (start, here) = (first + block, BLOCK.min(count - block));
            let [mut masses, mut errors] = [[f64::NAN; BLOCK]; 2];
            if let Some(lanes) = in_lanes {
                let width = lanes.width();
                let mut ask = |columns, first, from: usize, count: usize| {
                    let (masses, errors) = (&mut masses[from..][..count], &mut errors[from..][..count]);
                    lanes.lanes(columns, first, Answers { masses, errors });
                };
                let mut done = 0;
                if let BatchPositions::Columns { values, stride } = positions {
                    done = here - here % width;
                    ask(Columns { values, stride }, start, 0, done);
                }
                if done < here {
                    let left = here - done;
                    let padded = left.next_multiple_of(width);
                    // The last lanes repeat the last configuration.
                    for lane in 0..padded {
                        positions.put(start + done + lane.min(left - 1), read, &mut columns[lane..]);
                    }
                    ask(Columns { values: columns, stride: BLOCK }, 0, done, padded);
                }
            }
            let (masses, errors) = (&masses[..here], &errors[..here]);
            places.put(block, masses, errors, *remarks);
            let clear = |lane: usize| Answered { mass: masses[lane], error: errors[lane] }.is_clear();
            if (0..here).fold(true, |all, lane| all & clear(lane)) {
                continue;
            }
            for lane in (0..here).filter(|lane| !clear(*lane)) {
                row.iter_mut().enumerate().for_each(|(q, to)| *to = positions.at(start + lane, q));
                places.put_one(block + lane, by_itself(workspace, contact, row, *remarks));
            }
        }
    }
}

impl BatchPositions<'_> {
    #[inline]
    fn at(&self, configuration: usize, q: usize) -> f64 {
        match self {
            BatchPositions::Rows { values, stride } => values[configuration * stride + q],
            BatchPositions::Columns { values, stride } => values[q * stride + configuration],
        }
    }

    /// Writes some positions of a configuration, [`BLOCK`] apart.
    fn put(&self, configuration: usize, read: &[usize], to: &mut [f64]) {
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

/// The answer of a workspace.
fn by_itself(
    workspace: &mut Workspace,
    contact: &Contact,
    positions: &[f64],
    remarks: RemarkFlags,
) -> BatchAnswer {
    if workspace.set_positions(positions).is_err() {
        return BatchAnswer { remarks: RemarkFlags::NO_ANSWER, ..BatchAnswer::NONE };
    }
    match workspace.by_recursion_with(contact, remarks) {
        Ok(mass) => {
            let error = if mass == EffectiveMass::Massless { workspace.massless_to() } else { None };
            BatchAnswer { mass: Some(mass), error, remarks: workspace.remarks() }
        }
        Err(error) => BatchAnswer { remarks: RemarkFlags::from(&error), ..BatchAnswer::NONE },
    }
}
