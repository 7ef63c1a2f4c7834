//! Objects that describe an analysis: model, conditions, configuration, system and assembly.

pub(crate) mod builder;
pub(crate) mod conditions;
pub(crate) mod configuration;
pub(crate) mod model;
pub(crate) mod system;
