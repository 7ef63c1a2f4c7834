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

mod arrays;
mod batch;
mod conditions;
mod configuration;
mod contact;
mod dense;
mod floating_point;
mod handle;
mod laws;
mod model;
mod names;
mod pose;
mod response;
mod status;
mod system;
mod version;
mod workspace;

pub use batch::*;
pub use conditions::*;
pub use configuration::*;
pub use contact::*;
pub use dense::*;
pub use laws::*;
pub use model::*;
pub use pose::*;
pub use response::*;
pub use status::*;
pub use system::*;
pub use version::*;
pub use workspace::*;
