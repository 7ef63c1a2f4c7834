//! Maps of m̄ over surfaces and directions.

pub(crate) mod contact_findings;
pub(crate) mod given_contacts;
pub(crate) mod map_report;
pub(crate) mod point_map;
pub(crate) mod surface_map;
