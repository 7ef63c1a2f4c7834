//! Study files (TOML): keys, tables, schema.

pub(crate) mod additions;
pub(crate) mod answer;
pub(crate) mod closure;
pub(crate) mod contacts;
pub(crate) mod file;
pub(crate) mod keys;
pub(crate) mod report;
pub(crate) mod request;
pub(crate) mod schema;
pub(crate) mod starter;
pub(crate) mod tables_of_page;
pub(crate) mod text;
pub(crate) mod variant;
