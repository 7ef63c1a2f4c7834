//! A model in another form: source code of m̄, another format, an impact for a simulator.

mod balanced;
pub(crate) mod change_record;
pub(crate) mod code;
pub(crate) mod conversion;
pub(crate) mod impact;
pub(crate) mod impact_report;
mod mesh_names;
mod named_states;
