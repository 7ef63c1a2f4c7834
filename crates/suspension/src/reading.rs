//! Reading of a suspension file, apart from the building of its mechanism.

use crate::findings::{Findings, Spot};
use crate::options::{ImportOptions, Wheel};
use crate::sheet;
use percuss_formats::reading::encoding::{self, Decoded};
use percuss_formats::reading::{Place, Report};
use percuss_formats::{LoadError, Source};

/// Suspension file that has been read, for imports with different moved points: each takes about half the time of [`import`](crate::import).
#[derive(Clone, Debug)]
pub struct ReadFile {
    pub(super) source: Source,
    pub(super) options: ImportOptions,
    /// Content of a sheet or table; `None` for a file of Chrono::Vehicle, which is read again by each import.
    pub(super) sheet: Option<ReadSheet>,
}

/// Content of a sheet before moves, with its findings and files.
#[derive(Clone, Debug)]
pub(super) struct ReadSheet {
    /// `None` after an error in the findings.
    pub sheet: Option<sheet::Sheet>,
    pub findings: Findings,
    pub files: sheet::Files,
}

impl ReadFile {
    /// Reads a file as [`import`](crate::import).
    ///
    /// # Errors
    /// [`LoadError`]: a format of another program, or bytes that are no text. Errors in a sheet are those of [`import`](Self::import).
    pub fn new(source: &Source, options: &ImportOptions) -> Result<Self, LoadError> {
        if !sheet::is_foreign(&source.name, &String::from_utf8_lossy(&source.bytes))
            && let Some(error) = percuss_formats::foreign_format(source)
        {
            return Err(error);
        }
        let read = |sheet| Self { source: source.clone(), options: options.clone(), sheet };
        if sheet::is_workbook(&source.bytes) {
            return Ok(read(Some(read_sheet(source, "", None, options))));
        }
        let mut report = Report::default();
        let Some(Decoded { text, note }) = decode(source, &mut report) else {
            return Err(LoadError { diagnostics: report.finish(&source.name, "") });
        };
        let is_sheet = !is_json(source, &text);
        Ok(read(is_sheet.then(|| read_sheet(source, &text, note, options))))
    }
}

/// True for JSON: it begins with a brace, or with a comment in Chrono's files. The JSON reader reports XML as such.
pub(crate) fn is_json(source: &Source, text: &str) -> bool {
    let begins_as_json = text.trim_ascii_start().starts_with(['{', '/', '<']);
    begins_as_json && !sheet::is_foreign(&source.name, text) || source.name.ends_with(".json")
}

/// Reads a sheet; `encoding_note`: note about the encoding of the text.
fn read_sheet(
    source: &Source,
    text: &str,
    encoding_note: Option<String>,
    options: &ImportOptions,
) -> ReadSheet {
    let (mut findings, mut files) = (Findings::default(), sheet::Files::new());
    if let Some(note) = encoding_note {
        findings.note("windows-1252", &Spot::default(), note);
    }
    check_options(&mut findings, options);
    let sheet = sheet::read(source, text, options, &mut findings, &mut files);
    ReadSheet { sheet, findings, files }
}

/// Decodes the bytes as text; `None` after an error. Empty and binary files get messages that name the formats of suspensions.
pub(crate) fn decode<'s>(source: &'s Source, report: &mut Report) -> Option<Decoded<'s>> {
    let is_utf16 = [&b"\xFF\xFE"[..], b"\xFE\xFF"].iter().any(|mark| source.bytes.starts_with(mark));
    if source.bytes.trim_ascii().is_empty() {
        report.error("empty-file", Place::File, || {
            "the file is empty; a sheet (TOML), a table or JSON is expected".to_owned()
        });
        None
    } else if source.bytes.contains(&0) && !is_utf16 {
        report.error("binary", Place::File, || {
            "this is not a text file (it has zero bytes); a sheet (TOML), a table or JSON in UTF-8 is expected".to_owned()
        });
        None
    } else if is_utf16 {
        source.text(report).map(|text| Decoded { text, note: None })
    } else {
        Some(encoding::decode(&source.bytes))
    }
}

/// Checks the radius of the wheel.
pub(super) fn check_options(findings: &mut Findings, options: &ImportOptions) {
    if let Some(Wheel { radius: Some(radius), .. }) = options.wheel
        && !(radius.is_finite() && radius > 0.0)
    {
        let message = format!("the wheel's radius is {radius} m; more than 0 is expected");
        findings.error("bad-radius", &Spot::default(), message);
    }
}
