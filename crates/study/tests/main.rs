//! Studies.

mod drift;
mod requests;
mod stops;
