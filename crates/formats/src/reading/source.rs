//! Input of a model's bytes, and check for text.

use crate::LoadError;
use crate::reading::encoding::{Decoded, decode};
use crate::reading::files::{FileKind, FileStore, SharedFiles};
use crate::reading::limits::LONGEST_NAME;
use crate::reading::report::{Place, Report, shortened};
use std::borrow::Cow;
use std::io::{self, Read};
use std::path::Path;

/// Default size limit of a model file: 32 MiB.
pub const DEFAULT_MAX_SIZE: u64 = 32 << 20;

/// Bytes of a model and their origin.
#[derive(Clone, Debug)]
pub struct Source {
    /// File name as the user gave it; `<stdin>` for `-`.
    pub name: String,
    /// Contents.
    pub bytes: Vec<u8>,
    /// Store of the further files that the model names.
    pub files: SharedFiles,
}

impl Source {
    /// Source of bytes in memory. Further files are read from the file system.
    pub fn new(name: impl Into<String>, bytes: Vec<u8>) -> Source {
        Source { name: name.into(), bytes, files: SharedFiles::default() }
    }

    /// Reads a file, or the standard input for `-`. Reads at most `max_size` + 1 bytes. `FILE#MODEL` reads the file, and `-#MODEL` the
    /// standard input; the name keeps the model.
    ///
    /// # Errors
    /// [`LoadError`] if the file does not exist, cannot be read, is a directory, or is too large.
    pub fn read(path: &str, max_size: u64) -> Result<Source, LoadError> {
        Self::read_from(&SharedFiles::default(), path, max_size)
    }

    /// Reads a file from a store, otherwise as [`read`](Self::read); `-` is the standard input here too.
    ///
    /// # Errors
    /// As for [`read`](Self::read).
    pub fn read_from(files: &SharedFiles, path: &str, max_size: u64) -> Result<Source, LoadError> {
        let stdin_model = path.strip_prefix('-').filter(|rest| rest.is_empty() || rest.starts_with('#'));
        let stdin_name = stdin_model.map(|model| format!("<stdin>{model}"));
        let name = stdin_name.as_deref().unwrap_or(path);
        let bytes = match stdin_model {
            Some(_) => read_bounded(io::stdin().lock(), max_size),
            None => read_file(&**files, Path::new(split_model(&**files, path).0), max_size),
        };
        let refuse = |code, message: String| Err(LoadError::of_file(name, code, message));
        match bytes {
            Ok(bytes) if bytes.len() as u64 > max_size => {
                refuse("too-large-file", format!("larger than the limit of {max_size} bytes"))
            }
            Ok(bytes) => Ok(Source { name: name.to_owned(), bytes, files: files.clone() }),
            Err(error) => match error.kind() {
                io::ErrorKind::NotFound => refuse("no-such-file", "no such file".to_owned()),
                io::ErrorKind::IsADirectory => {
                    refuse("directory", "this is a directory; name the URDF file in it".to_owned())
                }
                io::ErrorKind::PermissionDenied => {
                    refuse("unreadable", "it may not be read: permission denied".to_owned())
                }
                // Other kinds of errors of the operating system.
                _ => refuse("unreadable", format!("cannot be read: {error}")),
            },
        }
    }

    /// File of the name: without the model of `FILE#MODEL`.
    pub fn file(&self) -> &str {
        split_model(&*self.files, &self.name).0
    }

    /// Model of `FILE#MODEL`; also of a text in memory with such a name.
    pub fn model(&self) -> Option<&str> {
        split_model(&*self.files, &self.name).1
    }

    /// Reports an error if the name selects a model of a file in a format with one model per file. The name of a text in memory is free.
    pub(crate) fn refuse_model(&self, format: &str, report: &mut Report) {
        let is_input = self.file() == "<stdin>" || self.files.is_file(Path::new(self.file()));
        if let Some(model) = self.model().filter(|_| is_input) {
            report.error("unknown-model", Place::File, || {
                format!(
                    "\"#{}\" selects one of several models of an SDFormat file; {format} holds one model: give the name of the file \
                     without it",
                    shortened(model)
                )
            });
        }
    }

    /// Creates a source from text.
    pub fn from_text(name: impl Into<String>, text: impl Into<String>) -> Source {
        Source::new(name, text.into().into_bytes())
    }

    /// Returns the bytes as text, without a byte order mark; `None`, with an error in the report, if they are not UTF-8 text. XML with other
    /// bytes is read as Windows-1252 with a note, unless it declares another encoding.
    pub fn text(&self, report: &mut Report) -> Option<Cow<'_, str>> {
        let bytes = self.bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(&self.bytes);
        let utf16 =
            [&b"\xFF\xFE"[..], b"\xFE\xFF", b"<\0", b"\0<"].iter().any(|mark| bytes.starts_with(mark));
        if utf16 {
            report.error("utf-16", Place::File, || {
                "the file is in UTF-16; UTF-8 is expected: run \"iconv -f UTF-16 -t UTF-8 FILE\" and load the result"
                    .to_owned()
            });
            return None;
        }
        if bytes.contains(&0) {
            report.error("binary", Place::File, || {
                "this is not a text file (it has zero bytes); a URDF is XML text in UTF-8".to_owned()
            });
            return None;
        }
        let text = match std::str::from_utf8(bytes) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) if is_western_xml(bytes) => {
                let Decoded { text, note } = decode(bytes);
                note.into_iter().for_each(|note| report.note("windows-1252", Place::File, || note));
                text
            }
            Err(error) => {
                let good = &bytes[..error.valid_up_to()];
                let line = 1 + good.iter().filter(|b| **b == b'\n').count();
                report.error("not-utf-8", Place::File, || {
                    format!(
                        "not UTF-8 text (byte 0x{:02x} in line {line}): either no text at all, or in another \
                         encoding; \"iconv -f ISO-8859-1 -t UTF-8 FILE\" converts the commonest",
                        bytes[error.valid_up_to()]
                    )
                });
                return None;
            }
        };
        if text.trim_ascii().is_empty() {
            report.error("empty-file", Place::File, || {
                "the file is empty; a URDF has a <robot> element".to_owned()
            });
            return None;
        }
        Some(text)
    }
}

/// Encodings whose characters Windows-1252 contains, in lower case; UTF-8 for files that declare it by mistake.
const WESTERN: [&str; 7] = ["utf-8", "utf8", "iso-8859-1", "latin1", "latin-1", "windows-1252", "us-ascii"];

/// True for XML that declares no encoding, UTF-8, or one that Windows-1252 contains.
fn is_western_xml(bytes: &[u8]) -> bool {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(LONGEST_NAME)]).to_ascii_lowercase();
    let declaration = head.split_once("?>").map_or("", |(declaration, _)| declaration);
    let encoding = declaration.split_once("encoding").map(|(_, rest)| {
        rest.trim_matches(|c: char| !c.is_ascii_alphanumeric()).split(['"', '\'']).next().unwrap_or_default()
    });
    head.trim_ascii_start().starts_with('<') && encoding.is_none_or(|name| WESTERN.contains(&name))
}

/// File and model of `FILE#MODEL`. A file whose own name has a `#` is taken as it is.
fn split_model<'a>(files: &dyn FileStore, name: &'a str) -> (&'a str, Option<&'a str>) {
    match name.rsplit_once('#') {
        Some((file, model)) if !model.is_empty() && !files.is_file(Path::new(name)) => (file, Some(model)),
        _ => (name, None),
    }
}

/// Reads at most `max_size` + 1 bytes of a file; a directory is an error on every operating system.
fn read_file(files: &dyn FileStore, path: &Path, max_size: u64) -> io::Result<Vec<u8>> {
    // Opening a directory fails on Windows; on other systems only reading fails.
    match files.kind(path) {
        Ok(FileKind::Folder) => Err(io::ErrorKind::IsADirectory.into()),
        _ => files.read(path, max_size),
    }
}

/// Reads at most `max_size` + 1 bytes: the last byte shows that the limit is exceeded.
fn read_bounded(reader: impl Read, max_size: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(max_size.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
}
