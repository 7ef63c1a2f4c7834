//! Import of hardpoint sheets: TOML, a table (CSV or XLSX), or TOML with a table, to a mechanism.
//!
//! The templates are data files in `templates`, which `catalogue` reads. `read` reads the entries of a sheet according
//! to the template, `build` builds its corner, and `write` writes the sheet to fill in and the tables of the
//! documentation.

mod build;
mod catalogue;
mod entries;
mod foreign;
mod names;
mod point_table;
mod read;
mod sections;
mod table;
mod template;
mod toml_text;
mod write;

pub(super) use build::{apply_moves, build, check_moves};
pub(super) use entries::{Place, WrittenPoint};
pub(super) use foreign::is_foreign;
pub(super) use point_table::Files;
pub(super) use read::{Sheet, read};
pub(super) use table::{changed_workbook, is_workbook};
pub use write::{
    TABLE_COLUMNS, TemplateOptions, template_keys, template_names, template_rows, template_sheet,
};
