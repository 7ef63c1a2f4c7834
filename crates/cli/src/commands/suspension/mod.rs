//! Subcommands about suspension sheets.

pub(crate) mod import;
pub(crate) mod kinematics;
pub(crate) mod template;
