//! Batches: one contact at many configurations, with SIMD lanes and threads.

use crate::boundary::arrays::{ByteRange, input_slice, optional_output_slice, output_slice, refuse_overlaps};
use crate::boundary::handle::{
    Handle, clear_handle, free_handle, lock_object, object_of, read_argument, write_handle,
};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_HANDLE, PERCUSS_ERROR_INTERNAL,
    PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_STOPPED, guard_call, percuss_status,
};
use crate::evaluation::contact::{percuss_contact, percuss_outcome};
use crate::evaluation::pose::{PERCUSS_COLUMN_MAJOR, PERCUSS_ROW_MAJOR, percuss_layout};
use crate::evaluation::workspace::percuss_workspace;
use crate::setup::system::percuss_assembly;
use percuss::{Batch, BatchError, BatchPositions, BatchRows, RowColumns};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::ffi::c_void;

/// One contact, prepared for many configurations. Immutable, so that threads can share it.
pub struct percuss_batch {
    _opaque: [u8; 0],
}

/// Batch with its thread pool and the id of the process that started the pool; `None` without a pool.
pub(crate) struct ThreadedBatch {
    pub batch: Batch,
    positions: usize,
    pool: Option<(u32, ThreadPool)>,
}

impl Handle for percuss_batch {
    type Object = ThreadedBatch;
    const TAG: u64 = 0x7063_5f62_6174_6368;
    const NAME: &'static str = "percuss_batch";
}

/// Number of configurations between two calls of the watch function: some milliseconds for a small mechanism.
const PORTION: usize = 1 << 14;
/// Configurations per task of a thread.
const TASK: usize = 256;
/// Limit of the number of threads.
const MAX_THREADS: usize = 1024;

/// Watch function, called periodically on the calling thread with the number of configurations done. Returns 0 to
/// continue; another value stops the work. It must not use the batch and must not throw.
pub type percuss_watch = Option<unsafe extern "C" fn(done: usize, user: *mut c_void) -> i32>;

/// Prepares m̄ of one contact at many configurations of an assembly. threads: number of threads (at most 1024), which
/// belong to the batch; 1: the calling thread alone; 0: one per processor of the machine. For normals in the world, the
/// root link is at the world's origin; percuss_workspace_batch uses another base. Free it with percuss_batch_free.
///
/// Errors: PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_ARGUMENT.
///
/// # Safety
/// assembly is a handle; contact is null or points to a contact; batch is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_batch_new(
    assembly: *const percuss_assembly,
    contact: *const percuss_contact,
    threads: usize,
    batch: *mut *mut percuss_batch,
) -> percuss_status {
    guard_call(|| {
        clear_handle(batch)?;
        let assembled = object_of(assembly)?;
        let contact = read_argument(contact, "contact")?.resolve(&assembled.model)?;
        let ready =
            assembled.assembly.batch(&contact).map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?;
        write_handle(ThreadedBatch::new(ready, assembled.model.positions, threads)?, batch)
    })
}

/// Like percuss_batch_new, with the assembly and the base of a workspace (percuss_workspace_set_base), for normals in
/// the world. The workspace may be used or freed afterwards.
///
/// Errors: as percuss_batch_new; PERCUSS_ERROR_BUSY.
///
/// # Safety
/// workspace is a handle; contact is null or points to a contact; batch is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_batch(
    workspace: *mut percuss_workspace,
    contact: *const percuss_contact,
    threads: usize,
    batch: *mut *mut percuss_batch,
) -> percuss_status {
    guard_call(|| {
        clear_handle(batch)?;
        let workspace_guard = lock_object(object_of(workspace)?, "percuss_workspace")?;
        let contact = read_argument(contact, "contact")?.resolve(&workspace_guard.model)?;
        let ready =
            workspace_guard.workspace.batch(&contact).map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?;
        write_handle(ThreadedBatch::new(ready, workspace_guard.model.positions, threads)?, batch)
    })
}

impl ThreadedBatch {
    /// Batch with its own threads; `positions` is the number of joint positions of a configuration.
    fn new(batch: Batch, positions: usize, threads: usize) -> Result<Self, Failure> {
        if threads > MAX_THREADS {
            let message = format_args!("threads is {threads}; expected at most {MAX_THREADS}");
            return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
        }
        let pool = match threads {
            1 => None,
            _ => {
                let pool = ThreadPoolBuilder::new().num_threads(threads).build();
                Some((std::process::id(), pool.map_err(Failure::with_status(PERCUSS_ERROR_INTERNAL))?))
            }
        };
        Ok(Self { batch, positions, pool })
    }
}

/// Ends the threads of a batch, frees it and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// batch is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_batch_free(batch: *mut *mut percuss_batch) -> percuss_status {
    guard_call(|| free_handle(batch))
}

/// m̄ at count configurations. A configuration holds the positions of all joints (p numbers, the positions of
/// percuss_model_counts) with closed loops.
///
/// positions: length numbers; PERCUSS_ROW_MAJOR: configuration c begins at c · stride, stride ≥ p;
/// PERCUSS_COLUMN_MAJOR: position q of configuration c is at q · stride + c, stride ≥ count: the fastest layout.
/// outcomes and effective_masses: count values each, as for percuss_workspace_effective_mass; PERCUSS_NO_ANSWER for a
/// row without an answer, PERCUSS_MASSLESS_TO_ROUNDING if rounding may hide a mass. errors: null, or count numbers of
/// output: the error by rounding, kg; NaN if not computed; for a contact that is massless to rounding only, its largest
/// possible m̄. remarks: null, or count numbers of output: PERCUSS_REMARK_… added together, with the reason for a row
/// without an answer. watch: null, or a function that is called periodically with user, in the default floating-point
/// environment. Output arrays must not overlap each other or the positions.
///
/// Errors: PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_OVERLAP; PERCUSS_ERROR_STOPPED: finished results are kept, the other
/// rows are PERCUSS_NO_ANSWER. PERCUSS_ERROR_HANDLE: the process was forked after percuss_batch_new, and the threads
/// belong to the parent process.
///
/// # Safety
/// batch is a handle; every array has the stated number of values; watch may be called with user.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_batch_run(
    batch: *const percuss_batch,
    positions: *const f64,
    length: usize,
    layout: percuss_layout,
    stride: usize,
    count: usize,
    outcomes: *mut percuss_outcome,
    effective_masses: *mut f64,
    errors: *mut f64,
    remarks: *mut u32,
    watch: percuss_watch,
    user: *mut c_void,
) -> percuss_status {
    guard_call(|| {
        let threaded = object_of(batch)?;
        let written = [
            ByteRange::of_array(outcomes, count, "outcomes"),
            ByteRange::of_array(effective_masses, count, "effective_masses"),
            ByteRange::of_array(errors, count, "errors"),
            ByteRange::of_array(remarks, count, "remarks"),
        ];
        refuse_overlaps(&written, &[ByteRange::of_array(positions, length, "positions")])?;
        let values = input_slice(positions, length, "positions")?;
        let mut unread = Vec::new();
        let errors = optional_output_slice(errors, count, "errors")?;
        let mut columns = RowColumns {
            statuses: output_slice(outcomes, count, "outcomes")?,
            masses: output_slice(effective_masses, count, "effective_masses")?,
            errors: errors.unwrap_or_else(|| {
                unread.resize(count, f64::NAN);
                &mut unread
            }),
            remarks: optional_output_slice(remarks, count, "remarks")?,
            gradients: None,
            inverse_inertias: None,
        };
        let rows = BatchRows::from(threaded.positions(values, layout, stride, count)?);
        threaded.thread_pool()?;
        columns.clear();
        let mut done = 0;
        while done < count {
            let portion = done..count.min(done + PORTION);
            done = portion.end;
            threaded.run(rows.part(portion.clone()), columns.part(portion))?;
            let Some(watch) = watch else { continue };
            // SAFETY: the caller promises that `watch` may be called with `user`.
            if unsafe { watch(done, user) } != 0 && done < count {
                let message = format_args!("stopped after {done} of {count} configurations");
                return Err(Failure::new(PERCUSS_ERROR_STOPPED, message));
            }
        }
        Ok(())
    })
}

impl ThreadedBatch {
    /// Thread pool; `None` for the calling thread. A forked process has none of its parent's threads and would wait forever.
    fn thread_pool(&self) -> Result<Option<&ThreadPool>, Failure> {
        let Some((process, pool)) = &self.pool else { return Ok(None) };
        if *process == std::process::id() {
            return Ok(Some(pool));
        }
        let message =
            "this percuss_batch has threads of the process that this one was forked from; make it after fork";
        Err(Failure::new(PERCUSS_ERROR_HANDLE, message))
    }

    /// Positions of `count` configurations. Refuses too few values, and an unknown layout.
    pub fn positions<'a>(
        &self,
        values: &'a [f64],
        layout: percuss_layout,
        stride: usize,
        count: usize,
    ) -> Result<BatchPositions<'a>, Failure> {
        let positions = match layout {
            PERCUSS_ROW_MAJOR => BatchPositions::Rows { values, stride },
            PERCUSS_COLUMN_MAJOR => BatchPositions::Columns { values, stride },
            _ => {
                let message =
                    format_args!("layout is {layout}; expected PERCUSS_ROW_MAJOR or PERCUSS_COLUMN_MAJOR");
                return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
            }
        };
        let checked = positions.check(self.positions, count);
        checked.map_err(Failure::with_status(PERCUSS_ERROR_LENGTH))?;
        Ok(positions)
    }

    /// Computes rows on the threads of the batch.
    pub fn run(&self, rows: BatchRows<'_>, columns: RowColumns<'_, percuss_outcome>) -> Result<(), Failure> {
        let done = match self.thread_pool()? {
            None => self.batch.run(rows, columns, usize::MAX),
            Some(pool) => pool.install(|| self.batch.run(rows, columns, TASK)),
        };
        done.map_err(|error| {
            let is_contact = matches!(error, BatchError::Contact { .. } | BatchError::NormalAlongLine);
            Failure::new(if is_contact { PERCUSS_ERROR_CONTACT } else { PERCUSS_ERROR_LENGTH }, error)
        })
    }
}
