//! Generated code, compiled by the C compiler of the system, against the library.

mod families;
mod support;
