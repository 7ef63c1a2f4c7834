//! From a compiled system to an assembly, a pose and a response.

pub(crate) mod assembly;
pub(crate) mod certificate;
pub(crate) mod compliance;
pub(crate) mod pose;
pub(crate) mod posing;
pub(crate) mod response;
pub(crate) mod rigid_loops;
pub(crate) mod routes;
pub(crate) mod system;
pub(crate) mod velocity_products;
