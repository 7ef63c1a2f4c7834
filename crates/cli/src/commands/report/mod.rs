//! Report of a study: one HTML page, accompanied by the result as JSON and the sweep as CSV. The report of a study
//! without a contact shows the mechanism, its contents, and the other questions of the study.

mod answers;
mod bands;
mod contact;
mod findings;
mod first_page;
mod mechanism;
mod outputs;
mod page;
mod results;
mod sweep;

use crate::args::RunArgs;
use crate::commands::exports::{explore::study_page, generate};
use crate::commands::mass::{check_expected, headline};
use crate::files::output::{record_input, write_file};
use crate::terminal::escape;
use crate::terminal::failure::Failure;
use crate::terminal::report::{warn, write_diagnostics, write_text};
use percuss_study::StudyFile;
use results::StudyResults;
use std::path::Path;

/// File beside a page, with the same name and another ending.
fn accompanying_file(path: &str, ending: &str) -> String {
    Path::new(path).with_extension(ending).to_string_lossy().into_owned()
}

/// The page with its JSON, and the table of a sweep.
pub fn files_of_page(study: &StudyFile, path: &str) -> Vec<String> {
    let mut files = vec![path.to_owned(), accompanying_file(path, "json")];
    if study.tables.sweep.is_some() {
        files.push(accompanying_file(path, "csv"));
    }
    files
}

/// Writes the report of a study.
pub fn write(study: &StudyFile, args: &RunArgs, path: &str) -> Result<(), Failure> {
    let mut files = files_of_page(study, path);
    files.extend(args.explorer.clone());
    // The names of generated files follow from the model; their folder is no file.
    files.extend(study.outputs().filter(|(key, _)| *key != "generate.output").map(|(_, file)| file));
    // The page refuses a study before the computation.
    let explorer = match &args.explorer {
        Some(_) => Some(study_page(study, args.max_size, args.strict)?),
        None => None,
    };
    let answers = StudyResults::from_study(study)?;
    let inputs = answers.inputs();
    inputs.iter().for_each(|input| record_input(&input.path));
    let diagnostics = answers.diagnostics();
    write_diagnostics(&diagnostics, args.strict)?;
    for contact in answers.report.contacts.iter().flat_map(|listed| &listed.contacts) {
        if let Some(problem) = &contact.problem {
            warn(&format!("{}: {problem}", contact.name));
        }
    }
    let page = page::text(&answers, study, args, path, &inputs)?;
    // The same as with --format json.
    let json = answers.report.main_json().unwrap_or_default() + "\n";
    write_file(&accompanying_file(path, "json"), json.as_bytes())?;
    if let Some(sweep) = &answers.sweep {
        write_file(&accompanying_file(path, "csv"), sweep.csv.as_bytes())?;
    }
    outputs::write(study, &answers)?;
    if let (Some(path), Some(text)) = (&args.explorer, &explorer) {
        write_file(path, text.as_bytes())?;
    }
    write_file(path, page.as_bytes())?;
    if let (Some(requested), Some(report)) = (&study.tables.generate, &answers.report.generate) {
        files.extend(generate::paths(report, requested.output.as_deref().unwrap_or_default()));
    }
    let headline =
        answers.report.mass.as_ref().map(|mass| format!("{:<20} {}\n", "effective mass", headline(mass)));
    let written = format!("{:<20} {}\n", "written", escape::line(&files.join(", ")));
    write_text(&(headline.unwrap_or_default() + &written))?;
    answers.report.mass.map_or(Ok(()), |mass| check_expected(&mass, &study.mass))
}
