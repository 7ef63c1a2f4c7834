//! Command `percuss generate`.

use crate::args::GenerateArgs;
use crate::files::output::{check_writable, record_input, write_file};
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_text};
use crate::terminal::text::shell_quoted;
use crate::terminal::wrap::fact_line;
use percuss_study::{CodeError, CodeReport, LanguageName, generate_code};
use std::path::Path;

/// Runs the command.
pub fn run(args: &GenerateArgs) -> Result<(), Failure> {
    args.writing.apply();
    let code = args.code.checked(Path::new(""))?;
    let question = args.contact.question()?;
    let model = args.model.load()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    write_diagnostics(&model.diagnostics, args.model.reading.strict)?;
    let folder = code.output.as_deref().unwrap_or_default();
    make_folder(folder)?;
    let report = generate_code(&model, &question, &code)?;
    let of_pose = report.diagnostics.get(model.diagnostics.len()..).unwrap_or_default();
    write_diagnostics(of_pose, args.model.reading.strict)?;
    write_files(&report, folder)?;
    write_text(&summary(&report, folder))
}

/// Makes the folder of the files, if it does not exist.
fn make_folder(folder: &str) -> Result<(), Failure> {
    if Path::new(folder).is_dir() {
        return Ok(());
    }
    std::fs::create_dir_all(folder).map_err(|error| Failure::output(folder, error.to_string()))
}

/// Path of a file in the folder.
fn path_of(folder: &str, file: &str) -> String {
    Path::new(folder).join(file).to_string_lossy().into_owned()
}

/// Paths of the files of a report.
pub fn paths(report: &CodeReport, folder: &str) -> Vec<String> {
    report.files.iter().map(|file| path_of(folder, &file.name)).collect()
}

/// Writes the files of a report, after a check of all of them.
pub fn write_files(report: &CodeReport, folder: &str) -> Result<(), Failure> {
    make_folder(folder)?;
    let paths = paths(report, folder);
    paths.iter().try_for_each(|path| check_writable(path))?;
    report.files.iter().zip(&paths).try_for_each(|(file, path)| write_file(path, file.text.as_bytes()))
}

/// Files, size of the function, and the command of the self-test.
pub fn summary(report: &CodeReport, folder: &str) -> String {
    let CodeReport { name, positions, operations, angles, references, .. } = report;
    let path = |file: String| shell_quoted(&path_of(folder, &file));
    let mut out = fact_line("written", &line(&paths(report, folder).join(", ")));
    let size = format!("{positions} positions, {operations} operations, {angles} sines and cosines");
    out += &fact_line("function", &format!("{name}_mass: {size}"));
    let test = match report.language {
        LanguageName::C => {
            format!("cc -O2 {} {} -lm && ./a.out", path(format!("{name}.c")), path(format!("{name}_test.c")))
        }
        LanguageName::Rust => {
            let file = path(format!("{name}.rs"));
            format!("rustc --edition 2021 --test -O {file} -o {name}_test && ./{name}_test")
        }
    };
    out += &fact_line("self-test", &format!("{references} configurations: {}", line(&test)));
    out
}

impl From<CodeError> for Failure {
    fn from(error: CodeError) -> Self {
        match error {
            CodeError::Question(error) => error.into(),
            CodeError::Generate(error) => Failure::bad_input(error.to_string()),
        }
    }
}
