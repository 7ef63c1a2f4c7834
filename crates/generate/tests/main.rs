//! Generated code, compiled by the C compiler of the system, against the library.

mod additions;
mod families;
mod support;
