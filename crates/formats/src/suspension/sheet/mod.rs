//! Sheets of one's own hardpoints: TOML, with a table (CSV or XLSX) beside it or instead of it, to a mechanism.
//!
//! `catalogue` has every template as data; `read` takes a sheet's entries by it, `build` makes links, joints and loops
//! of it, `write` the sheet to fill in and the tables of the documentation.

mod axles;
mod build;
mod catalogue;
mod entries;
mod independent;
mod parts;
mod point_table;
mod read;
mod table;
mod toml_text;
mod trailing;
mod workbook;
mod write;

pub(super) use build::build;
pub(super) use point_table::Files;
pub(super) use read::read;
pub(super) use table::is_workbook;
pub use write::{TemplateOptions, template_keys, template_names, template_sheet};
