//! Workers that stand by until somebody has work for them: where none does, one is made.

use std::sync::{Mutex, PoisonError};

/// Workers that nobody uses now: at most as many as were ever used at once.
#[derive(Debug)]
pub(crate) struct Idle<W>(Mutex<Vec<Box<W>>>);

impl<W: Clone> Idle<W> {
    /// Does work by a worker that stands by, or by a copy of `model`. One that panics is not used again.
    pub fn with<A>(&self, model: &W, work: impl FnOnce(&mut W) -> A) -> A {
        let idle = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let waiting = idle().pop();
        let mut worker = waiting.unwrap_or_else(|| Box::new(model.clone()));
        let answer = work(&mut worker);
        idle().push(worker);
        answer
    }
}

impl<W> Default for Idle<W> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

/// For a copy, nobody stands by yet.
impl<W> Clone for Idle<W> {
    fn clone(&self) -> Self {
        Self::default()
    }
}
