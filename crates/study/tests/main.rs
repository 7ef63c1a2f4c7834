//! Studies.

mod drift;
mod generated;
mod stops;
