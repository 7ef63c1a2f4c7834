//! Tests of rigid impacts: against maximal coordinates, closed forms, and properties.

mod bearings_and_locks;
mod cases;
mod closed_forms;
mod friction;
mod in_time;
mod kept_points_and_paths;
mod maximal_coordinates;
mod mobility;
mod properties;
mod ranges;
mod several;
mod sticking;
mod sticking_friction;
