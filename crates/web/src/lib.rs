//! WebAssembly module of percuss without imports: requests and replies are JSON in the memory of the module.
//!
//! A caller writes a request of `n` bytes at [`percuss_request`]`(n)`, calls [`percuss_answer`], and reads as many bytes as it
//! returns at [`percuss_reply`]. [`Session::answer`] is the same function for Rust.

mod boundary;
mod request;
mod session;

pub use boundary::{percuss_answer, percuss_reply, percuss_request};
pub use session::Session;
