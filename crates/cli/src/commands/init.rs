//! Commands `percuss init` and `percuss schema`: initial studies, and the schema of studies.

use crate::args::{InitArgs, SchemaFormat};
use crate::files::output::{record_input, write_file};
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_text, write_unescaped};
use crate::terminal::text::shell_quoted;
use percuss_study::{report_schema, starting_study, study_key_page, study_schema};
use std::path::Path;

/// Writes a study of a model.
pub fn run(args: &InitArgs) -> Result<(), Failure> {
    args.writing.apply();
    if args.model.model == "-" {
        return Err(Failure::bad_input(
            "MODEL -: a study contains the path of its model; give the file of the model",
        ));
    }
    if !args.model.reading.changes().is_empty() {
        return Err(Failure::bad_input(
            "--link-mass, --link-com, --link-inertia and --move: write them into the study, as model.link_mass, model.link_com, \
             model.link_inertia and model.move",
        ));
    }
    let model = args.model.load()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    write_diagnostics(&model.diagnostics, args.model.reading.strict)?;
    let output = args.output.as_ref().filter(|output| *output != "-");
    let path = match output {
        Some(output) => relative_model_path(output, &args.model.model),
        None => args.model.model.clone(),
    };
    let study = starting_study(&model, &path)?;
    match output {
        None => write_unescaped(study.as_bytes()),
        Some(output) => {
            write_file(output, study.as_bytes())?;
            write_text(&format!(
                "{:<20} {output}; run it with: percuss run {}\n",
                "written",
                shell_quoted(output)
            ))
        }
    }
}

/// Prints the JSON schema of studies or of reports, or the page of the keys of studies.
pub fn schema(format: SchemaFormat) -> Result<(), Failure> {
    let text = match format {
        SchemaFormat::Json => serde_json::to_string_pretty(study_schema()),
        SchemaFormat::Report => serde_json::to_string_pretty(&report_schema()),
        SchemaFormat::Markdown => return write_unescaped(study_key_page().as_bytes()),
    };
    let text = text.map_err(|error| Failure::NoAnswer(format!("the schema has no JSON form: {error}")))?;
    write_unescaped((text + "\n").as_bytes())
}

/// Path of the model as written in the study: relative to the folder of the study if both exist and are on one drive.
fn relative_model_path(study: &str, model: &str) -> String {
    let folder = Path::new(study).parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = dunce::canonicalize(folder.unwrap_or(Path::new(".")));
    let relative = match (folder, dunce::canonicalize(model)) {
        (Ok(folder), Ok(model)) => pathdiff::diff_paths(model, folder),
        _ => None,
    };
    let path = relative.map_or_else(|| model.to_owned(), |path| path.to_string_lossy().into_owned());
    // Slashes make the study portable. Windows accepts slashes too, except in a path that begins with \\?\.
    if cfg!(windows) && !path.starts_with(r"\\?\") { path.replace('\\', "/") } else { path }
}
