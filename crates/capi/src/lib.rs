//! The C interface of percuss. `include/percuss.h` is generated from this crate; `include/percuss.hpp` wraps it for
//! C++17.
//!
//! Functions return a status, 0 on success, except for a few functions that cannot fail. The message of the last
//! failure is kept per thread. There is no other global state. Handles are opaque. Immutable objects may be shared
//! between threads; concurrent use of a mutable object is an error. User guide: docs/howto/C.md.
//!
//! Every pointer argument must be null or point to the stated number of values. Null is reported as an error; other
//! violations cannot be checked.

// Names follow the header.
#![allow(non_camel_case_types)]

#[cfg(feature = "suspensions")]
mod ask;
mod boundary;
mod dense;
mod evaluation;
mod laws;
mod setup;
#[cfg(feature = "suspensions")]
mod suspension;
mod version;

#[cfg(feature = "suspensions")]
pub use ask::*;
pub use boundary::status::*;
pub use dense::*;
pub use evaluation::batch::*;
pub use evaluation::contact::*;
pub use evaluation::contact_map::*;
pub use evaluation::impact::*;
pub use evaluation::path::*;
pub use evaluation::pose::*;
pub use evaluation::response::*;
#[cfg(feature = "suspensions")]
pub use evaluation::touch::*;
pub use evaluation::workspace::*;
pub use laws::*;
pub use setup::builder::*;
pub use setup::conditions::*;
pub use setup::configuration::*;
pub use setup::model::*;
pub use setup::system::*;
#[cfg(feature = "suspensions")]
pub use suspension::*;
pub use version::*;
