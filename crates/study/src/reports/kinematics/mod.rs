//! Kinematics of a suspension over its travel: angles of the wheels, steering axis, roll centre, motion ratios, wheel rates.

pub(crate) mod changed_sheet;
pub(crate) mod column_names;
mod contact_values;
pub(crate) mod errors;
pub(crate) mod load_cases;
pub(crate) mod report;
pub(crate) mod suspension_kinematics;
pub(crate) mod target_question;
pub(crate) mod target_search;
