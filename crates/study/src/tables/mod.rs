//! Tables of positions in files.

pub(crate) mod columns;
pub(crate) mod records;
pub(crate) mod text_layout;
pub(crate) mod trajectory;
