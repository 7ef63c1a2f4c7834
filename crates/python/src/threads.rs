//! The threads that sweeps, maps and reports share work out to. A process that was forked, as Python's multiprocessing does on Linux, has
//! none of those of its parent, and would wait for them for ever: it makes its own.

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The process that loaded this module: its threads are rayon's own.
static FIRST: OnceLock<u32> = OnceLock::new();

/// The threads of a process that was forked from another. Never ended: those of a parent are not there to be waited for.
static FORKED: Mutex<Option<(u32, &'static ThreadPool)>> = Mutex::new(None);

/// Remembers which process this is.
pub fn begin() {
    FIRST.get_or_init(process::id);
}

/// Works without the interpreter, with threads to share the work out to.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    py.detach(|| match forked() {
        None => work(),
        Some(pool) => pool.install(work),
    })
}

fn forked() -> Option<&'static ThreadPool> {
    let own = process::id();
    if *FIRST.get_or_init(|| own) == own {
        return None;
    }
    let mut kept = FORKED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, pool)) = kept.filter(|(process, _)| *process == own) {
        return Some(pool);
    }
    let pool: &'static ThreadPool = Box::leak(Box::new(ThreadPoolBuilder::new().build().ok()?));
    *kept = Some((own, pool));
    Some(pool)
}
