//! Standard output and standard error of the run on this thread: the streams of the process, or texts in memory.

use std::cell::RefCell;
use std::io::{self, IsTerminal, Write};
use std::sync::{Arc, Mutex, PoisonError};

/// Text in memory that an output on another thread can also write.
type Text = Arc<Mutex<Vec<u8>>>;

thread_local! {
    /// Texts of standard output and standard error; `None`: the streams of the process.
    static CAPTURED: RefCell<Option<[Text; 2]>> = const { RefCell::new(None) };
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
