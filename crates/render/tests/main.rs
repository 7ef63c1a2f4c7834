//! Pictures.

mod degenerate;
mod drawings;
mod pictures;
mod skins;
