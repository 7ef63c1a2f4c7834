//! Tables of positions in files.

pub(crate) mod columns;
pub(crate) mod records;
pub(crate) mod trajectory;
