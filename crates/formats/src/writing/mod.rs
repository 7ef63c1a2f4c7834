//! Code shared by the writers of all formats.

pub(crate) mod changes;
pub(crate) mod parts;
pub(crate) mod state;
pub(crate) mod structure;
pub(crate) mod xml_text;
