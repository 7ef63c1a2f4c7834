//! Interruption of long computations from outside.
//!
//! A program that reacts to the user (Ctrl-C) runs a computation on threads of its own and marks them with a flag. While the flag is
//! set, the next pose or response that such a thread computes unwinds with [`Interrupted`]. Other threads are not affected.

use std::cell::Cell;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};

/// Payload of the unwinding of an interrupted computation, for [`std::panic::catch_unwind`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupted;

thread_local! {
    static STOP: Cell<Option<&'static AtomicBool>> = const { Cell::new(None) };
}

/// Marks the current thread: its computations stop while `flag` is true.
pub fn stop_this_thread_by(flag: &'static AtomicBool) {
    STOP.with(|stop| stop.set(Some(flag)));
}

/// True if the flag of the current thread is set. Loops over many short tasks skip the rest: every task of rayon that unwinds costs some
/// time.
#[inline]
pub fn is_requested() -> bool {
    STOP.with(|stop| stop.get().is_some_and(|flag| flag.load(Ordering::Relaxed)))
}

/// Unwinds with [`Interrupted`] if the flag of the current thread is set. Called once per pose and response.
#[inline]
pub fn check() {
    if is_requested() {
        // No message: the panic hook is not called.
        resume_unwind(Box::new(Interrupted));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::catch_unwind;

    #[test]
    fn a_marked_thread_stops_while_its_flag_is_set() {
        static FLAG: AtomicBool = AtomicBool::new(true);
        check();
        let marked = std::thread::spawn(|| {
            stop_this_thread_by(&FLAG);
            let stopped = catch_unwind(check).is_err_and(|payload| payload.is::<Interrupted>());
            FLAG.store(false, Ordering::Relaxed);
            (stopped, catch_unwind(check).is_ok())
        });
        assert_eq!(marked.join().ok(), Some((true, true)));
    }
}
