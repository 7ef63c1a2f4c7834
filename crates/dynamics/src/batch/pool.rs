//! Pool of idle workers; clones a new worker if the pool is empty.

use std::sync::Mutex;

/// Idle workers: at most the largest number of workers used at the same time.
#[derive(Debug)]
pub(crate) struct WorkerPool<W>(Mutex<Vec<Box<W>>>);

impl<W: Clone> WorkerPool<W> {
    /// Runs `work` with a worker from the pool, or with a clone of `model`; never waits. A worker is dropped if
    /// `work` panics.
    pub fn with_worker<A>(&self, model: &W, work: impl FnOnce(&mut W) -> A) -> A {
        let waiting = self.0.try_lock().ok().and_then(|mut workers| workers.pop());
        let mut worker = waiting.unwrap_or_else(|| Box::new(model.clone()));
        let answer = work(&mut worker);
        if let Ok(mut workers) = self.0.try_lock() {
            workers.push(worker);
        }
        answer
    }
}

impl<W> Default for WorkerPool<W> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

/// A clone starts with an empty pool.
impl<W> Clone for WorkerPool<W> {
    fn clone(&self) -> Self {
        Self::default()
    }
}
