//! Sweeps: rows of configurations, their evaluation along a branch, reports.

pub(crate) mod continuation;
pub(crate) mod pipeline;
pub(crate) mod plain_rows;
pub(crate) mod row_blocks;
pub(crate) mod row_gradient;
pub(crate) mod row_layout;
pub(crate) mod sweep_context;
pub(crate) mod sweep_report;
pub(crate) mod sweep_rows;
