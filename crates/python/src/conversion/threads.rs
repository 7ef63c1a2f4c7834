//! Thread pools of sweeps, maps and reports, and Ctrl-C.
//!
//! A forked process (Python's multiprocessing on Linux) has none of its parent's threads and would wait for them forever; it therefore
//! starts its own pools. Signals reach the main thread only: while a report of the main thread is computed on a pool, the main thread
//! checks for Ctrl-C and then stops the threads of this pool.

use crate::conversion::errors::input;
use percuss::interruption::{self, Interrupted};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::process;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::Duration;

/// Id of the process that loaded this module; it uses rayon's global pool.
static LOADING_PROCESS: OnceLock<u32> = OnceLock::new();
/// Pools of this process and of its ancestors. Never dropped: in a fork, dropping would wait for threads that do not exist.
static POOLS: Mutex<Vec<(PoolKind, &'static ThreadPool)>> = Mutex::new(Vec::new());
/// Number of threads of all calls; 0: one per processor.
static LIMIT: AtomicUsize = AtomicUsize::new(0);
/// True while the computation of the main thread is to stop.
static STOP: AtomicBool = AtomicBool::new(false);
/// Largest number of threads.
const MOST_THREADS: usize = 1024;
/// Time between two checks for Ctrl-C: a tenth of the 0.2 s in which a call stops; the rest is for the reaction of the threads.
const CHECK_INTERVAL: Duration = Duration::from_millis(20);

/// Number of coordinates, contacts or configurations from which a call may take 0.1 s and runs on a pool, so that Ctrl-C can stop it. One
/// dense solution of 100 coordinates, or one contact or configuration by the dense route, takes at most some milliseconds.
const LARGE: usize = 64;

/// Process and threads of a pool.
#[derive(Clone, Copy, PartialEq)]
struct PoolKind {
    process: u32,
    threads: usize,
    /// True for computations of the main thread, which Ctrl-C stops.
    is_stoppable: bool,
}

/// Number of threads of a call; 0: one per processor.
#[derive(Clone, Copy, Default)]
pub struct Threads(usize);

impl Threads {
    /// Number of threads as given, else that of [`set_threads`].
    pub fn of(given: Option<usize>) -> PyResult<Self> {
        match given {
            None => Ok(Self(LIMIT.load(Ordering::Relaxed))),
            Some(threads) if (1..=MOST_THREADS).contains(&threads) => Ok(Self(threads)),
            Some(threads) => {
                Err(input(format_args!("threads is {threads}; expected 1 to {MOST_THREADS}, or None")))
            }
        }
    }

    /// Pool of this process; `None` for rayon's global pool.
    fn pool(self, is_stoppable: bool) -> PyResult<Option<&'static ThreadPool>> {
        let process = process::id();
        if self.0 == 0 && !is_stoppable && *LOADING_PROCESS.get_or_init(|| process) == process {
            return Ok(None);
        }
        let kind = PoolKind { process, threads: self.0, is_stoppable };
        let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, pool)) = pools.iter().find(|(known, _)| *known == kind) {
            return Ok(Some(pool));
        }
        let pool: &'static ThreadPool = Box::leak(Box::new(kind.start().map_err(cannot_start)?));
        pools.push((kind, pool));
        Ok(Some(pool))
    }
}

impl PoolKind {
    fn start(self) -> Result<ThreadPool, ThreadPoolBuildError> {
        let mut pool = ThreadPoolBuilder::new().num_threads(self.threads);
        if self.is_stoppable {
            pool = pool.start_handler(|_| interruption::stop_this_thread_by(&STOP));
        }
        pool.build()
    }
}

fn cannot_start(error: ThreadPoolBuildError) -> PyErr {
    let own = process::id();
    let is_fork = *LOADING_PROCESS.get_or_init(|| own) != own;
    PyRuntimeError::new_err(format!(
        "this process {}cannot start threads of its own: {error}; raise its limits of memory and processes, or set fewer \
         threads",
        if is_fork { "was forked and " } else { "" }
    ))
}

/// Number of threads of every call from now on, 1 to 1024; None: one per processor (or RAYON_NUM_THREADS). Results do not depend on it.
///
///     >>> percuss.set_threads(4)
#[pyfunction]
#[pyo3(signature = (threads=None))]
pub fn set_threads(threads: Option<usize>) -> PyResult<()> {
    let Threads(limit) = match threads {
        Some(_) => Threads::of(threads)?,
        None => Threads(0),
    };
    LIMIT.store(limit, Ordering::Relaxed);
    Ok(())
}

/// Records the id of the loading process.
pub fn record_process() {
    LOADING_PROCESS.get_or_init(process::id);
}

/// Runs `work` without the interpreter, on a pool of this process. The caller checks for Ctrl-C.
///
/// # Errors
/// RuntimeError: threads cannot be started.
pub fn detached<T: Send>(py: Python<'_>, threads: Threads, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let pool = threads.pool(false)?;
    Ok(py.detach(|| match pool {
        None => work(),
        Some(pool) => pool.install(work),
    }))
}

/// Like [`interruptible_on`], on the threads of [`set_threads`].
///
/// # Errors
/// As [`interruptible_on`].
pub fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    interruptible_on(py, Threads::of(None)?, work)
}

/// Runs `work` on this thread with the interpreter released; in a forked process on its own pool, because rayon's global pool has no threads there.
fn detached_here<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let process = process::id();
    if *LOADING_PROCESS.get_or_init(|| process) == process {
        return Ok(py.detach(work));
    }
    detached(py, Threads::of(None)?, work)
}

/// Like [`interruptible`] from `LARGE` on; smaller work runs on this thread with the interpreter released. `size`: number of coordinates,
/// contacts or configurations.
///
/// # Errors
/// As [`interruptible_on`].
pub fn interruptible_if_large<T: Send>(
    py: Python<'_>,
    size: usize,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    if size >= LARGE { interruptible(py, work) } else { detached_here(py, work) }
}

/// Stop flags of [`abandonable`] that the next calls reuse. The flag of an interrupted call is leaked: its thread may still read it.
static FLAGS: Mutex<Vec<&'static AtomicBool>> = Mutex::new(Vec::new());

/// Runs `work` on a thread of its own if it is large. Ctrl-C returns at once; the thread stops at its next pose, response or element of a
/// file, and drops its result. For work whose single steps are too long to wait for after Ctrl-C.
///
/// # Errors
/// RuntimeError: a thread cannot be started. KeyboardInterrupt, or the exception of another signal handler.
pub fn abandonable<T: Send + 'static>(
    py: Python<'_>,
    is_large: bool,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    if !is_large || !is_main_thread(py)? {
        return detached_here(py, work);
    }
    let pool = Threads::of(None)?.pool(false)?;
    let work = move || match pool {
        None => work(),
        Some(pool) => pool.install(work),
    };
    let (sender, receiver) = channel();
    let kept = FLAGS.lock().unwrap_or_else(PoisonError::into_inner).pop();
    let stop: &'static AtomicBool = kept.unwrap_or_else(|| Box::leak(Box::default()));
    let run = move || {
        interruption::stop_this_thread_by(stop);
        // After an interruption nobody receives the result.
        let _ = sender.send(catch_unwind(AssertUnwindSafe(work)));
    };
    let started = std::thread::Builder::new().spawn(run);
    started.map_err(|error| PyRuntimeError::new_err(format!("a thread cannot be started: {error}")))?;
    let found = py.detach(move || {
        loop {
            match receiver.recv_timeout(CHECK_INTERVAL) {
                Ok(found) => {
                    FLAGS.lock().unwrap_or_else(PoisonError::into_inner).push(stop);
                    return Ok(found);
                }
                Err(RecvTimeoutError::Timeout) => {
                    Python::attach(|py| py.check_signals())
                        .inspect_err(|_| stop.store(true, Ordering::Relaxed))?;
                }
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("the computation ended without a result"));
                }
            }
        }
    })?;
    found.map_or_else(|payload| resume_unwind(payload), Ok)
}

/// Like [`detached`]. Ctrl-C stops the work at its next configuration.
///
/// # Errors
/// As [`detached`]; KeyboardInterrupt, or the exception of another signal handler.
pub fn interruptible_on<T: Send>(
    py: Python<'_>,
    threads: Threads,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    if !is_main_thread(py)? {
        return detached(py, threads, work);
    }
    let Some(pool) = threads.pool(true)? else { return detached(py, threads, work) };
    STOP.store(false, Ordering::Relaxed);
    let (mut found, mut interrupt) = (None, None);
    py.detach(|| {
        let (sender, receiver) = channel();
        pool.in_place_scope(|scope| {
            let found = &mut found;
            scope.spawn(move |_| {
                *found = Some(catch_unwind(AssertUnwindSafe(work)));
                // The main thread waits for it.
                let _ = sender.send(());
            });
            while let Err(RecvTimeoutError::Timeout) = receiver.recv_timeout(CHECK_INTERVAL) {
                if let (None, Err(raised)) = (&interrupt, Python::attach(|py| py.check_signals())) {
                    interrupt = Some(raised);
                    STOP.store(true, Ordering::Relaxed);
                }
            }
        });
    });
    STOP.store(false, Ordering::Relaxed);
    match (interrupt, found) {
        (Some(interrupt), _) => Err(interrupt),
        (None, Some(Ok(found))) => Ok(found),
        (None, Some(Err(payload))) if !payload.is::<Interrupted>() => resume_unwind(payload),
        (None, _) => Err(PyRuntimeError::new_err("the computation was stopped")),
    }
}

/// True in the thread that receives signals.
fn is_main_thread(py: Python<'_>) -> PyResult<bool> {
    let threading = py.import("threading")?;
    let main: u64 = threading.call_method0("main_thread")?.getattr("ident")?.extract()?;
    Ok(main == threading.call_method0("get_ident")?.extract::<u64>()?)
}
