//! Import of suspension files of Chrono::Vehicle.
//!
//! Each template is a data file in `templates`: the sections of the file in the order of reading, their points, the
//! axes of their inertias, and the construction steps. They follow `Construct` and `InitializeSide` of Chrono's
//! classes of the same names; `docs/reference/SUSPENSIONS.md` has the table.

mod corner_reader;
mod json;
mod reader;
mod sections;
mod template;

pub(super) use corner_reader::read_corner;
pub(super) use reader::{Reader, Section};
pub(super) use sections::read_spindle;
pub(super) use template::{ChronoTemplate, templates};
