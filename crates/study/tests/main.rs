//! Studies.

mod drift;
mod generated;
mod nearby;
mod requests;
mod stops;
