//! Evaluation of one contact at one pose.

pub(crate) mod certificate;
pub(crate) mod contact_point;
pub(crate) mod estimate;
pub(crate) mod friction_thresholds;
pub(crate) mod joint_ranges;
pub(crate) mod motion_ratio;
pub(crate) mod named_contact;
pub(crate) mod nearby_masses;
pub(crate) mod passed_stops;
pub(crate) mod prepared_question;
pub(crate) mod random_rows;
pub(crate) mod status;
pub(crate) mod stop_not_reached;
