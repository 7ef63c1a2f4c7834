//! Poses, workspaces and paths of rows.

mod compliance;
mod four_bar;
mod geometric_stiffness;
mod inputs;
mod row_path;
