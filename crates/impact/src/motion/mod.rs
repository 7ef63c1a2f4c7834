//! Rates of the joints before and after an impact.

pub(crate) mod driver_rates;
pub(crate) mod joint_rates;
pub(crate) mod reachable_speed;
pub(crate) mod undetermined;
