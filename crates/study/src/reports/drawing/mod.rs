//! Drawing of a mechanism: at the pose of a result, and as a scene whose links move.

pub mod drawn_mechanism;
mod link_lines;
pub mod scene;
mod shape_reader;
