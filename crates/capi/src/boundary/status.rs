//! Status of a call, and the message of a failure.

use crate::boundary::floating_point::DefaultEnvironment;
use std::cell::RefCell;
use std::ffi::{CString, c_char};
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Status of a call: PERCUSS_OK, or one of the errors.
pub type percuss_status = i32;

/// Success.
pub const PERCUSS_OK: percuss_status = 0;
/// A pointer is null, or not aligned.
pub const PERCUSS_ERROR_NULL: percuss_status = 1;
/// A handle has another type. A freed handle is detected only while its memory is not reused.
pub const PERCUSS_ERROR_HANDLE: percuss_status = 2;
/// An array has a wrong length, or a matrix a wrong shape or leading dimension.
pub const PERCUSS_ERROR_LENGTH: percuss_status = 3;
/// A number is out of range, NaN or infinite without permission, or not a value of its enumeration.
pub const PERCUSS_ERROR_ARGUMENT: percuss_status = 4;
/// A text is not UTF-8.
pub const PERCUSS_ERROR_TEXT: percuss_status = 5;
/// No link, joint, law or other item has this name or number.
pub const PERCUSS_ERROR_NAME: percuss_status = 6;
/// A model cannot be read; the message lists every error with file and line.
pub const PERCUSS_ERROR_LOAD: percuss_status = 7;
/// Conditions do not fit the mechanism, or a joint cannot be set to these values.
pub const PERCUSS_ERROR_CONDITIONS: percuss_status = 8;
/// Loops do not close, or drivers cannot reach their positions.
pub const PERCUSS_ERROR_ASSEMBLY: percuss_status = 9;
/// A contact is invalid, or has no answer.
pub const PERCUSS_ERROR_CONTACT: percuss_status = 10;
/// Matrices are invalid: not symmetric, indefinite, too large.
pub const PERCUSS_ERROR_MATRIX: percuss_status = 11;
/// A contact law cannot provide the requested damper or impact.
pub const PERCUSS_ERROR_LAW: percuss_status = 12;
/// Another thread is using this object.
pub const PERCUSS_ERROR_BUSY: percuss_status = 13;
/// The caller stopped the work.
pub const PERCUSS_ERROR_STOPPED: percuss_status = 14;
/// Output arrays or values overlap each other or an input.
pub const PERCUSS_ERROR_OVERLAP: percuss_status = 15;
/// A defect of percuss. The object in use may only be freed.
pub const PERCUSS_ERROR_INTERNAL: percuss_status = 99;

/// Reason of a failed call.
#[derive(Debug)]
pub(crate) struct Failure {
    pub status: percuss_status,
    pub message: String,
}

impl Failure {
    pub fn new(status: percuss_status, message: impl Display) -> Self {
        Self { status, message: message.to_string() }
    }

    /// Conversion for `map_err`: this status with the error's own message.
    pub fn with_status<E: Display>(status: percuss_status) -> impl Fn(E) -> Self {
        move |error| Self::new(status, error)
    }
}

thread_local! {
    static MESSAGE: RefCell<CString> = RefCell::default();
}

/// Runs a call in the default floating-point environment and keeps the message of a failure for this thread. A panic,
/// which is a defect, does not unwind into C.
#[inline]
pub(crate) fn guard_call(call: impl FnOnce() -> Result<(), Failure>) -> percuss_status {
    let _environment = DefaultEnvironment::enter();
    match catch_unwind(AssertUnwindSafe(call)) {
        Ok(Ok(())) => PERCUSS_OK,
        Ok(Err(failure)) => record_failure(failure),
        Err(_) => {
            record_failure(Failure::new(PERCUSS_ERROR_INTERNAL, "a defect of percuss; please report it"))
        }
    }
}

/// Keeps the message for this thread and returns the status.
#[cold]
fn record_failure(failure: Failure) -> percuss_status {
    let message = CString::new(failure.message.replace('\0', "\u{fffd}")).unwrap_or_default();
    // Fails at the end of a thread, when its storage is gone.
    let _ = MESSAGE.try_with(|kept| kept.replace(message));
    failure.status
}

/// The message of the last failed call on this thread: location, received value, expected value; UTF-8, "" without a
/// failure. Valid until the next failed call on this thread.
#[unsafe(no_mangle)]
pub extern "C" fn percuss_error_message() -> *const c_char {
    MESSAGE.try_with(|kept| kept.borrow().as_ptr()).unwrap_or(c"".as_ptr())
}
