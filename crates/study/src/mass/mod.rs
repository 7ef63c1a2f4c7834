//! Report of one contact: m̄, shares, sensitivities, tolerances, drawing.

pub(crate) mod answer_mass;
pub(crate) mod assumptions;
pub(crate) mod contact_list;
pub(crate) mod drawing;
pub(crate) mod explain;
pub(crate) mod mass_report;
pub(crate) mod motion_ratio;
pub(crate) mod named_contact;
pub(crate) mod tolerance;
