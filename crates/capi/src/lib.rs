//! The C interface of percuss: `include/percuss.h` is made from this crate, `include/percuss.hpp` wraps it for C++17.
//!
//! Every function but a few that cannot fail gives a status, 0 where all is well; the message of the last failure is kept for each
//! thread. Nothing is global. Handles are opaque; an object that cannot be changed may be shared between threads,
//! one that can gives an error where two threads use it at once. docs/C.md says how to use it.
//!
//! Every pointer that is given must be null, or point to as many values as the function says: null is an error, the
//! rest cannot be checked.

// The names are those of the header.
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
