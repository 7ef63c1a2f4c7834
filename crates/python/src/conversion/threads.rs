//! Thread pools of sweeps, maps and reports. A forked process (Python's multiprocessing on Linux) has none of its
//! parent's threads and would wait for them forever; it therefore starts its own pool.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::process;
use std::sync::{Mutex, OnceLock, PoisonError};

/// Id of the process that loaded this module; it uses rayon's global pool.
static LOADING_PROCESS: OnceLock<u32> = OnceLock::new();

/// Pool of a forked process, with the process id. Never dropped: in another fork, dropping would wait for threads that
/// do not exist.
static FORKED_POOL: Mutex<Option<(u32, &'static ThreadPool)>> = Mutex::new(None);

/// Records the id of the loading process.
pub fn record_process() {
    LOADING_PROCESS.get_or_init(process::id);
}

/// Runs `work` without the interpreter, on the thread pool of this process.
///
/// # Errors
/// RuntimeError: a forked process cannot start threads. `work` would wait for the threads of the parent process.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    py.detach(|| match forked_pool() {
        Ok(None) => Ok(work()),
        Ok(Some(pool)) => Ok(pool.install(work)),
        Err(error) => Err(PyRuntimeError::new_err(format!(
            "this process was forked and cannot start threads of its own: {error}; raise its limits of memory and \
             processes"
        ))),
    })
}

/// Pool of a forked process; `None` in the process that loaded this module.
fn forked_pool() -> Result<Option<&'static ThreadPool>, ThreadPoolBuildError> {
    let own = process::id();
    if *LOADING_PROCESS.get_or_init(|| own) == own {
        return Ok(None);
    }
    let mut kept = FORKED_POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, pool)) = kept.filter(|(process, _)| *process == own) {
        return Ok(Some(pool));
    }
    let pool: &'static ThreadPool = Box::leak(Box::new(ThreadPoolBuilder::new().build()?));
    *kept = Some((own, pool));
    Ok(Some(pool))
}
