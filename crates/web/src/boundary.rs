//! The three functions of the module. A WebAssembly module has one thread; other callers are serialised by a mutex.

use crate::session::Session;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Session with the bytes of its request and of its reply.
struct Exchange {
    session: Session,
    request: Vec<u8>,
    reply: Vec<u8>,
}

static EXCHANGE: Mutex<Exchange> =
    Mutex::new(Exchange { session: Session::new(), request: Vec::new(), reply: Vec::new() });

/// Locks the exchange, even after a panic of an earlier call.
fn exchange() -> MutexGuard<'static, Exchange> {
    EXCHANGE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Memory for a request of `length` bytes, valid until the next call of a function of this module. The caller fills all of
/// it before [`percuss_answer`].
// SAFETY: no other function of the module has this name.
#[unsafe(no_mangle)]
pub extern "C" fn percuss_request(length: usize) -> *mut u8 {
    let mut exchange = exchange();
    exchange.request = vec![0; length];
    exchange.request.as_mut_ptr()
}

/// Answers the request and returns the number of bytes of the reply.
// SAFETY: no other function of the module has this name.
#[unsafe(no_mangle)]
pub extern "C" fn percuss_answer() -> usize {
    let exchange = &mut *exchange();
    let request = std::mem::take(&mut exchange.request);
    exchange.reply = exchange.session.answer(&request);
    exchange.reply.len()
}

/// Bytes of the reply, valid until the next call of a function of this module.
// SAFETY: no other function of the module has this name.
#[unsafe(no_mangle)]
pub extern "C" fn percuss_reply() -> *const u8 {
    exchange().reply.as_ptr()
}
