//! Reports: m̄ with shares, sensitivities, tolerances and drawing; safe speed; comparison of designs.

pub(crate) mod answer_mass;
pub(crate) mod assumptions;
pub(crate) mod compare;
pub(crate) mod contact_list;
pub(crate) mod drawing;
pub(crate) mod explain;
pub(crate) mod exports;
pub(crate) mod impact;
pub(crate) mod kinematics;
pub(crate) mod mass_report;
pub(crate) mod pose_at_stop;
pub(crate) mod safe_speed;
pub(crate) mod tolerance;
