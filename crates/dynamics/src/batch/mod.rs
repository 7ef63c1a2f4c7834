//! Many configurations or contacts: workspaces, batches, paths of drivers, contact maps.

pub(crate) mod contact_map;
pub(crate) mod derivatives;
pub(crate) mod driven_path;
pub(crate) mod error;
pub(crate) mod pool;
pub(crate) mod row_inputs;
pub(crate) mod row_path;
mod row_remarks;
pub(crate) mod row_results;
pub(crate) mod rows;
pub(crate) mod workspace;
