//! Workers that stand by until somebody has work for them: where none does, one is made.

use std::sync::Mutex;

/// Workers that nobody uses now: at most as many as were ever used at once.
#[derive(Debug)]
pub(crate) struct Idle<W>(Mutex<Vec<Box<W>>>);

impl<W: Clone> Idle<W> {
    /// Does work by a worker that stands by, or by a copy of `model`; waits for nobody. One that panics is not used again.
    pub fn with<A>(&self, model: &W, work: impl FnOnce(&mut W) -> A) -> A {
        let waiting = self.0.try_lock().ok().and_then(|mut idle| idle.pop());
        let mut worker = waiting.unwrap_or_else(|| Box::new(model.clone()));
        let answer = work(&mut worker);
        if let Ok(mut idle) = self.0.try_lock() {
            idle.push(worker);
        }
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
