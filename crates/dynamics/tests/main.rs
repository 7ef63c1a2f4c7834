//! Poses and workspaces.

mod four_bar;
mod inputs;
