//! Rigid impact at a contact: impulse, rates, reactions, reflected inertias, centres of percussion.

pub(crate) mod additions;
pub(crate) mod errors;
pub(crate) mod extremes;
pub(crate) mod friction;
pub(crate) mod further_contacts;
pub(crate) mod identification;
pub(crate) mod in_time;
pub(crate) mod masses;
pub(crate) mod reactions;
pub(crate) mod reflected;
pub(crate) mod report;
pub(crate) mod simultaneous;
