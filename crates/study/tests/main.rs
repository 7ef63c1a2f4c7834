//! Studies.

mod drift;
mod generated;
mod requests;
mod stops;
