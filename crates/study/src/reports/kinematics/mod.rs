//! Kinematics of a suspension over its travel: angles of the wheels, steering axis, roll centre, motion ratios, wheel rates.

pub(crate) mod changed_sheet;
pub(crate) mod column_names;
pub(crate) mod errors;
pub(crate) mod force_element;
pub(crate) mod linkage_motion;
pub(crate) mod movable;
pub(crate) mod report;
pub(crate) mod row_values;
pub(crate) mod suspension_kinematics;
pub(crate) mod target_search;
pub(crate) mod values;
pub(crate) mod wheel;
