//! Sweeps: rows of configurations, their evaluation along a branch, reports.

pub(crate) mod context;
pub(crate) mod continuation;
pub(crate) mod lanes;
pub(crate) mod path_follower;
pub(crate) mod pipeline;
pub(crate) mod row_blocks;
pub(crate) mod row_layout;
pub(crate) mod sweep_report;
pub(crate) mod sweep_rows;
