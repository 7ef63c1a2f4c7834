//! Standard output and standard error of the run on this thread: the streams of the process, or texts in memory.

use crate::terminal::escape;
use crate::terminal::number::true_minus;
use crate::terminal::wrap;
use std::cell::{Cell, RefCell};
use std::io::{self, IsTerminal, Write};
use std::sync::{Arc, Mutex, PoisonError};

/// Text in memory that an output on another thread can also write.
type Text = Arc<Mutex<Vec<u8>>>;

/// Codes of terminals: end of all styles, bold, dim, yellow, red.
const STYLES: [&str; 5] = ["\u{1b}[0m", "\u{1b}[1m", "\u{1b}[2m", "\u{1b}[33m", "\u{1b}[31m"];

thread_local! {
    /// True if standard output and standard error of the run on this thread have styles.
    static STYLED: Cell<[bool; 2]> = const { Cell::new([false; 2]) };
    /// Texts of standard output and standard error; `None`: the streams of the process.
    static CAPTURED: RefCell<Option<[Text; 2]>> = const { RefCell::new(None) };
}

/// Prepares both streams for a run: styles only on a terminal and without `NO_COLOR`, lines as wide as the terminal.
pub fn begin_run() {
    let is_wanted = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|value| value != "dumb");
    STYLED.set([stdout(), stderr()].map(|stream| is_wanted && stream.is_terminal()));
    let size = stdout().is_terminal().then(terminal_size::terminal_size).flatten();
    wrap::use_columns(size.map(|(terminal_size::Width(columns), _)| columns.into()));
}

/// Text in bold on standard output.
pub fn bold(text: &str) -> String {
    styled(0, 1, text)
}

/// Dim text on standard output.
pub fn dim(text: &str) -> String {
    styled(0, 2, text)
}

/// Writes a line of a message to standard error with its severity in yellow or red. Warnings have true minus signs; errors repeat what was
/// given. A closed stream changes nothing.
pub fn write_line(line: &str) {
    let shown = if line.contains("warning: ") { true_minus(line) } else { line.into() };
    let mut text = wrap::wrap_message(&escape::line(&shown));
    // A file and its line precede the severity, so that editors find the place.
    for (severity, style) in [("warning: ", 3), ("error: ", 4)] {
        let at = if text.starts_with(severity) {
            Some(0)
        } else {
            text.find(&format!(": {severity}")).map(|at| at + 2)
        };
        if let Some(at) = at {
            let (before, after) = text.split_at(at);
            text = format!("{before}{}{}", styled(1, style, severity), &after[severity.len()..]);
            break;
        }
    }
    let _ = writeln!(stderr(), "{text}");
}

/// Text with a style, if the stream has styles.
fn styled(stream: usize, style: usize, text: &str) -> String {
    if STYLED.get()[stream] && !text.is_empty() {
        format!("{}{text}{}", STYLES[style], STYLES[0])
    } else {
        text.to_owned()
    }
}

/// Applies a change to the parts of a text between the styles.
pub fn between_styles(text: &str, change: impl Fn(&str) -> String) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('\u{1b}') {
        out += &change(&rest[..at]);
        rest = &rest[at..];
        let code = STYLES.iter().find(|code| STYLED.get()[0] && rest.starts_with(**code));
        let taken = code.map_or(1, |code| code.len());
        out += &code.map_or_else(|| change(&rest[..1]), |code| (*code).to_owned());
        rest = &rest[taken..];
    }
    out + &change(rest)
}

/// Output stream.
pub enum Stream {
    Stdout(io::Stdout),
    Stderr(io::Stderr),
    Captured(Text),
}

/// Standard output.
pub fn stdout() -> Stream {
    captured(0).map_or_else(|| Stream::Stdout(io::stdout()), Stream::Captured)
}

/// Standard error.
pub fn stderr() -> Stream {
    captured(1).map_or_else(|| Stream::Stderr(io::stderr()), Stream::Captured)
}

/// True if the output of this thread is captured.
pub fn is_captured() -> bool {
    CAPTURED.with_borrow(Option::is_some)
}

fn captured(stream: usize) -> Option<Text> {
    CAPTURED.with_borrow(|texts| texts.as_ref().map(|texts| texts[stream].clone()))
}

/// Runs `run` with captured output; returns its result, and the bytes of standard output and standard error.
pub fn capture<T>(run: impl FnOnce() -> T) -> (T, [Vec<u8>; 2]) {
    /// Ends the capture, also after a panic.
    struct Restore;
    impl Drop for Restore {
        fn drop(&mut self) {
            CAPTURED.set(None);
        }
    }
    let texts: [Text; 2] = Default::default();
    CAPTURED.set(Some(texts.clone()));
    let restore = Restore;
    let result = run();
    drop(restore);
    (result, texts.map(|text| std::mem::take(&mut *text.lock().unwrap_or_else(PoisonError::into_inner))))
}

impl Stream {
    /// True if the stream is a terminal.
    pub fn is_terminal(&self) -> bool {
        match self {
            Stream::Stdout(stdout) => stdout.is_terminal(),
            Stream::Stderr(stderr) => stderr.is_terminal(),
            Stream::Captured(_) => false,
        }
    }
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Stream::Stdout(stdout) => stdout.write(bytes),
            Stream::Stderr(stderr) => stderr.write(bytes),
            Stream::Captured(text) => text.lock().unwrap_or_else(PoisonError::into_inner).write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Stream::Stdout(stdout) => stdout.flush(),
            Stream::Stderr(stderr) => stderr.flush(),
            Stream::Captured(_) => Ok(()),
        }
    }
}
