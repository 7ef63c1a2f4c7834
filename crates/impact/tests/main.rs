//! Tests of rigid impacts: against maximal coordinates, closed forms, and properties.

mod cases;
mod closed_forms;
mod maximal_coordinates;
mod properties;
