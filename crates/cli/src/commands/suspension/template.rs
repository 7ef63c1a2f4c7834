//! Command `percuss template`.

use crate::args::TemplateArgs;
use crate::commands::suspension::import::unit;
use crate::files::contents::Contents;
use crate::files::csv::Cell;
use crate::files::output::{allow_replacement, ending_of, write_file};
use crate::terminal::failure::Failure;
use crate::terminal::report::write_out;
use crate::terminal::wrap::wrap_hanging;
use percuss_mechanism::near_names;
use percuss_suspension::{TABLE_COLUMNS, TemplateOptions, template_names, template_rows, template_sheet};
use std::path::Path;

/// Runs the command.
pub fn run(args: &TemplateArgs) -> Result<(), Failure> {
    let Some(name) = &args.name else {
        if !args.list {
            let names = template_names();
            let known: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
            return Err(Failure::bad_input(format!(
                "the name of a template is expected: {}; percuss template --list describes them",
                known.join(", ")
            )));
        }
        let row = |(name, title)| wrap_hanging(&format!("{name:<24} {title}"), 25) + "\n";
        let rows = template_names().into_iter().map(row);
        return write_out(&rows.collect::<String>());
    };
    let options = TemplateOptions { unit: unit(args.unit), axes: args.axes };
    let Some(sheet) = template_sheet(name, &options) else {
        let names = template_names();
        let near = near_names(name, names.iter().map(|(name, _)| *name));
        let near = near.first().map_or_else(|| ".".to_owned(), |n| format!("; did you mean {n}?"));
        let known: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
        return Err(Failure::bad_input(format!(
            "no template is named \"{}\"{near} There are: {}",
            name.escape_debug(),
            known.join(", ")
        )));
    };
    let Some(path) = &args.output else { return write_out(&sheet) };
    // A template does not overwrite an existing file unless forced.
    if Path::new(path).is_file() && !args.force {
        return Err(Failure::bad_input(format!("{path} exists; --force replaces it")));
    }
    allow_replacement(args.force);
    let is_table =
        Path::new(path).extension().is_some() && ending_of(path, &["toml", "csv", "xlsx"])? != "toml";
    if !is_table {
        return write_file(path, sheet.as_bytes());
    }
    let cell = |text: &String| text.parse().map_or_else(|_| Cell::Text(text.clone().into()), Cell::Number);
    let table = || {
        let rows = template_rows(name, &options).unwrap_or_default();
        (
            TABLE_COLUMNS.map(str::to_owned).to_vec(),
            rows.iter().map(|row| row.iter().map(cell).collect()).collect(),
        )
    };
    Contents { name: "suspension", table: Some(&table), ..Contents::default() }.write(path)
}
