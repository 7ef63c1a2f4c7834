//! Output of all commands: results to stdout, diagnostics to stderr.

use crate::terminal::console::{self, write_line};
use crate::terminal::diagnostics::lines;
use crate::terminal::escape::{self, Terminal};
use crate::terminal::failure::Failure;
use percuss_formats::KNOWN_WARNING;
use percuss_mechanism::Severity;
use percuss_study::{DiagnosticRecord, Model};
use std::cell::Cell;
use std::io::Write;

thread_local! {
    /// True if the run on this thread shows notes, false if it only counts them.
    static NOTES_SHOWN: Cell<bool> = const { Cell::new(false) };
    /// True if the run on this thread shows the details of a result.
    static DETAILS_SHOWN: Cell<bool> = const { Cell::new(false) };
}

/// Selects the details of results: points, axes, joints, method.
pub fn show_details(shown: bool) {
    DETAILS_SHOWN.set(shown);
}

/// True if the details of results are shown.
pub fn details_are_shown() -> bool {
    DETAILS_SHOWN.get()
}

/// Selects the output of notes: every note, or the number of notes.
pub fn show_notes(shown: bool) {
    NOTES_SHOWN.set(shown);
}

/// True if all notes are shown.
pub fn notes_are_shown() -> bool {
    NOTES_SHOWN.get()
}

/// Writes a table for programs to stdout, with escapes for unsafe characters.
pub fn write_out(text: &str) -> Result<(), Failure> {
    write_bytes(escape::lines(text).as_bytes())
}

/// Writes a text for people to stdout, with the styles of the terminal.
pub fn write_text(text: &str) -> Result<(), Failure> {
    write_bytes(console::between_styles(text, |part| escape::lines(part).into_owned()).as_bytes())
}

fn write_bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = console::stdout();
    stdout.write_all(bytes)?;
    stdout.flush()?;
    Ok(())
}

/// Writes a result for another program to stdout, with unchanged names; on a terminal, with escapes for control
/// characters and marks of direction.
pub fn write_unescaped(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = console::stdout();
    if stdout.is_terminal() {
        Terminal::new(&mut stdout).write_all(bytes)?;
    } else {
        stdout.write_all(bytes)?;
    }
    stdout.flush()?;
    Ok(())
}

/// Writes a result to stdout as indented JSON.
pub fn write_json(result: &impl serde::Serialize) -> Result<(), Failure> {
    match serde_json::to_string_pretty(result) {
        Ok(text) => write_unescaped((escape::json(&text) + "\n").as_bytes()),
        Err(error) => Err(Failure::NoAnswer(format!("the result has no JSON form: {error}"))),
    }
}

/// Writes a note about the command itself to stderr. A closed stderr changes nothing.
pub fn note(message: &str) {
    write_message("note", message);
}

/// Writes a warning about the command to stderr. A closed stderr changes nothing.
pub fn warn(message: &str) {
    write_message("warning", message);
}

/// Writes `severity: message` to stderr.
fn write_message(severity: &str, message: &str) {
    write_line(&format!("{severity}: {message}"));
}

/// Returns the result of a question. After an error, the findings about the model are written first, because they may be its cause.
pub fn with_findings<T, E: Into<Failure>>(result: Result<T, E>, model: &Model) -> Result<T, Failure> {
    result.map_err(|error| {
        let warnings = model.diagnostics.iter().filter(|d| d.severity == Severity::Warning).cloned();
        // Without `strict` there is no error.
        let _ = write_diagnostics(&warnings.collect::<Vec<_>>(), false);
        error.into()
    })
}

/// Writes diagnostics to stderr.
///
/// # Errors
/// Any warning if `strict`; the error then contains the diagnostics.
pub fn write_diagnostics(diagnostics: &[DiagnosticRecord], strict: bool) -> Result<(), Failure> {
    let mut lines = lines(diagnostics, NOTES_SHOWN.get());
    // A warning that the model file marks as known becomes a note; under --strict this note counts as a warning.
    let is_warning = |d: &&DiagnosticRecord| {
        d.severity == Severity::Warning || d.severity == Severity::Note && d.code == KNOWN_WARNING
    };
    let warnings = diagnostics.iter().filter(is_warning).count();
    if strict && warnings > 0 {
        lines.push(format!("error: {warnings} warning(s); --strict treats warnings as errors"));
        return Err(Failure::BadInput(lines));
    }
    lines.iter().for_each(|line| write_line(line));
    Ok(())
}
