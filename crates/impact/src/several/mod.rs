//! Several simultaneous contacts: laws of Newton and Poisson and energetic law without friction, plastic impacts with sticking
//! points.

pub(crate) mod complementarity;
pub(crate) mod energetic;
pub(crate) mod laws;
pub(crate) mod least_friction;
pub(crate) mod state_impact;
pub(crate) mod sticking;
