//! Studies.

mod drift;
mod stops;
