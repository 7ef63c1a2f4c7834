//! Study files (TOML): keys, tables, schema.

pub(crate) mod closure;
pub(crate) mod damping;
pub(crate) mod file;
pub(crate) mod keys;
pub(crate) mod map;
pub(crate) mod mass;
pub(crate) mod safe_speed;
pub(crate) mod schema;
pub(crate) mod starter;
pub(crate) mod sweep;
pub(crate) mod text;
pub(crate) mod variant;
