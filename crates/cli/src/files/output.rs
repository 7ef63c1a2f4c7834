//! Output destinations: stdout, or a file that is replaced after all of the result is written.
//!
//! Every file that percuss writes is opened here. Input files and files that percuss did not write are not replaced.

use crate::files::own_files::is_own;
use crate::terminal::console;
use crate::terminal::escape::Terminal;
use crate::terminal::failure::Failure;
use std::cell::{Cell, RefCell};
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Longest time between two flushes of buffered bytes, so that a reader of stdout sees progress.
const FLUSH_INTERVAL: Duration = Duration::from_millis(200);

/// Longest wait for a file that another program holds: longer than a virus scanner needs, and short for a user who
/// has the table open in a spreadsheet.
const MAX_HELD_WAIT: Duration = Duration::from_secs(2);
/// Pause between two attempts.
const RETRY_PAUSE: Duration = Duration::from_millis(10);
/// Windows error for the replacement of an open file.
const ACCESS_DENIED: i32 = 5;
/// Windows error for opening a file that another program does not share.
const SHARING_VIOLATION: i32 = 32;

thread_local! {
    /// Input files of the run on this thread. No output replaces an input file.
    static INPUTS: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
    /// True if this run replaces files that percuss did not write.
    static REPLACE_FOREIGN: Cell<bool> = const { Cell::new(false) };
}

/// Discards the input files and the permission of the previous run.
pub fn begin_run() {
    INPUTS.take();
    REPLACE_FOREIGN.set(false);
}

/// Allows the replacement of files that percuss did not write.
pub fn allow_replacement(forced: bool) {
    REPLACE_FOREIGN.set(forced);
}

/// Records an input file; outputs do not replace recorded files.
pub fn record_input(path: &str) {
    INPUTS.with_borrow_mut(|inputs| inputs.push(path.to_owned()));
}

/// Output of a result. A new file is written in the same folder and renamed by [`finish`](Self::finish); an
/// unfinished file leaves the previous one unchanged. Devices and pipes are written directly.
pub struct Output {
    out: BufWriter<Box<dyn Write + Send>>,
    path: Option<String>,
    unfinished: Option<UnfinishedFile>,
    last_flush: Instant,
}

/// Unfinished file; removed when the value is dropped.
struct UnfinishedFile {
    temporary: PathBuf,
    path: PathBuf,
    file: File,
}

impl Drop for UnfinishedFile {
    fn drop(&mut self) {
        // After the renaming no unfinished file exists.
        let _ = fs::remove_file(&self.temporary);
    }
}

impl Output {
    /// Opens a file, or stdout for `None`.
    pub fn open(path: Option<&str>) -> Result<Self, Failure> {
        let mut unfinished = None;
        let out: Box<dyn Write + Send> = match path {
            None if console::stdout().is_terminal() => Box::new(Terminal::new(console::stdout())),
            None => Box::new(console::stdout()),
            Some(path) => {
                check_writable(path)?;
                let (file, kept) =
                    open_output(Path::new(path)).map_err(|error| cannot_write(path, &error))?;
                unfinished = kept;
                Box::new(file)
            }
        };
        let path = path.map(str::to_owned);
        Ok(Self { out: BufWriter::with_capacity(1 << 16, out), path, unfinished, last_flush: Instant::now() })
    }

    /// Writes the remaining bytes and renames the file.
    pub fn finish(mut self) -> Result<(), Failure> {
        let renamed = self.out.flush().and_then(|()| match &self.unfinished {
            Some(UnfinishedFile { temporary, path, file }) => {
                // Without the synchronisation, a power cut could leave the new name with a part of the bytes.
                file.sync_all()?;
                retry_while_held(&[ACCESS_DENIED, SHARING_VIOLATION], || fs::rename(temporary, path))
            }
            None => Ok(()),
        });
        renamed.map_err(|error| self.failure(error))
    }

    /// Discards the buffered bytes.
    pub fn discard(self) {
        let _ = self.out.into_parts();
    }

    /// Reason why the output cannot be written.
    pub fn failure(&self, error: io::Error) -> Failure {
        match &self.path {
            None => error.into(),
            Some(path) => cannot_write(path, &error),
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        if self.last_flush.elapsed() > FLUSH_INTERVAL {
            self.flush()?;
        }
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.last_flush = Instant::now();
        self.out.flush()
    }
}

/// Writes a whole file.
pub fn write_file(path: &str, bytes: &[u8]) -> Result<(), Failure> {
    let mut out = Output::open(Some(path))?;
    out.write_all(bytes).map_err(|error| out.failure(error))?;
    out.finish()
}

/// Ending of the name of an output file, in lower case.
///
/// # Errors
/// An ending that is not one of `possible`.
pub fn ending_of(path: &str, possible: &[&'static str]) -> Result<&'static str, Failure> {
    let ending = Path::new(path).extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    possible.iter().find(|known| **known == ending).copied().ok_or_else(|| {
        let all: Vec<String> = possible.iter().map(|ending| format!(".{ending}")).collect();
        let (last, others) = all.split_last().map_or(("", &[][..]), |(last, others)| (last.as_str(), others));
        Failure::output(path, format!("its name must end in {} or {last}", others.join(", ")))
    })
}

/// Refuses a file whose format is not part of this build.
fn check_built(path: &str) -> Result<(), Failure> {
    let ending = Path::new(path).extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    match ending.as_str() {
        "png" | "pdf" if !cfg!(feature = "pictures") => {
            Err(not_built(path, &ending.to_ascii_uppercase(), "pictures"))
        }
        "xlsx" if !cfg!(feature = "tables") => Err(not_built(path, "XLSX", "tables")),
        "parquet" if !cfg!(feature = "tables") => Err(not_built(path, "Parquet", "tables")),
        _ => Ok(()),
    }
}

/// Error for a format that is not part of this build.
pub(super) fn not_built(path: &str, format: &str, feature: &str) -> Failure {
    let instead = if feature == "tables" { ".csv" } else { ".svg" };
    Failure::output(
        path,
        format!(
            "this build of percuss writes no {format}; write {instead}, or build it with \
         `cargo build --release --features {feature}` (packages have everything)"
        ),
    )
}

/// Refuses an input file, by any path or link, a file that percuss did not write, and a format that is not part of this build.
///
/// # Errors
/// The file and the remedy.
pub fn check_writable(path: &str) -> Result<(), Failure> {
    check_built(path)?;
    // The comparison opens both files, and a pipe would wait for its other end. Writing to pipes and devices destroys nothing.
    let is_file = |path: &str| fs::metadata(path).is_ok_and(|found| found.is_file());
    // A file that cannot be opened counts as a different file.
    let is_same = |input: &String| {
        is_file(path) && is_file(input) && same_file::is_same_file(path, input).unwrap_or(false)
    };
    if let Some(input) = INPUTS.with_borrow(|inputs| inputs.iter().find(|input| is_same(input)).cloned()) {
        let which = if input == path { String::new() } else { format!(" ({input})") };
        return Err(Failure::output(
            path,
            format!("this is an input file of the same run{which}; give another file"),
        ));
    }
    if REPLACE_FOREIGN.get() || is_own(Path::new(path)).map_err(|e| cannot_write(path, &e))? {
        return Ok(());
    }
    Err(Failure::output(path, "the file exists and percuss did not write it; --force replaces it"))
}

/// Opens the output: a device or pipe directly, otherwise a new file in the same folder.
fn open_output(path: &Path) -> io::Result<(File, Option<UnfinishedFile>)> {
    let found = fs::metadata(path);
    if let Ok(found) = &found
        && !found.is_file()
    {
        return Ok((OpenOptions::new().write(true).open(path)?, None));
    }
    let path = match &found {
        Ok(_) => {
            // A read-only file is not replaced.
            retry_while_held(&[SHARING_VIOLATION], || OpenOptions::new().write(true).open(path))?;
            fs::canonicalize(path)?
        }
        Err(_) => link_target(path)?,
    };
    let (temporary, file) = create_unfinished(&path)?;
    let kept = UnfinishedFile { temporary, path, file: file.try_clone()? };
    if let Ok(found) = found {
        file.set_permissions(found.permissions())?;
    }
    Ok((file, Some(kept)))
}

/// Target of a chain of links without an existing file; for a path that is no link, the path.
fn link_target(path: &Path) -> io::Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MAX_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(io::Error::other(format!("more than {MAX_LINKS} links, one to the next")))
}

/// Repeats an operation for a limited time if another program holds the file. On Windows, scanners, indexers and
/// other runs open a file for a moment, and an open file cannot be replaced.
fn retry_while_held<T>(held: &[i32], mut action: impl FnMut() -> io::Result<T>) -> io::Result<T> {
    let start = Instant::now();
    let is_held = |error: &io::Error| {
        cfg!(windows)
            && error.raw_os_error().is_some_and(|code| held.contains(&code))
            && start.elapsed() < MAX_HELD_WAIT
    };
    loop {
        match action() {
            Err(error) if is_held(&error) => std::thread::sleep(RETRY_PAUSE),
            done => return done,
        }
    }
}

/// Creates a file `.NAME.NUMBER.percuss-part` in the same folder and locks the file. Unfinished files of killed runs
/// for the same output are removed first.
fn create_unfinished(path: &Path) -> io::Result<(PathBuf, File)> {
    remove_unfinished(path);
    let name = |operation: u32| {
        let number = u64::from(std::process::id()) + (u64::from(operation) << 32);
        let mut name = unfinished_prefix(path);
        name.push(format!("{number}{UNFINISHED_SUFFIX}"));
        path.with_file_name(name)
    };
    let mut operation = 0;
    loop {
        let temporary = name(operation);
        match OpenOptions::new().write(true).create_new(true).open(&temporary) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && operation < 100 => operation += 1,
            opened => {
                let file = opened?;
                // Before the lock, another run may have removed the file as unfinished.
                let is_taken =
                    matches!(file.try_lock(), Err(TryLockError::WouldBlock)) || !temporary.exists();
                if is_taken && operation < 100 {
                    operation += 1;
                    continue;
                }
                return Ok((temporary, file));
            }
        }
    }
}

/// End of the names of unfinished files.
const UNFINISHED_SUFFIX: &str = ".percuss-part";
/// Largest number of unfinished files removed at once.
const MAX_REMOVED: usize = 1000;

/// Largest number of links from an output to its file, as on Linux.
const MAX_LINKS: usize = 40;
/// Longest name (bytes) that becomes a part of another name. Systems allow 255 bytes, and `..NUMBER.percuss-part` has
/// 36.
const LONGEST_WHOLE_NAME: usize = 200;

/// Start of the names of unfinished files of an output: `.NAME.`. A long name is cut, and a hash of the full name
/// follows.
fn unfinished_prefix(path: &Path) -> OsString {
    let whole = path.file_name().unwrap_or_default();
    let mut name = OsString::from(".");
    if whole.len() <= LONGEST_WHOLE_NAME {
        name.push(whole);
    } else {
        let text = whole.to_string_lossy();
        let cut = text.char_indices().take_while(|(at, _)| *at < LONGEST_WHOLE_NAME - 24).last();
        let mut hash = DefaultHasher::new();
        whole.hash(&mut hash);
        name.push(&text[..cut.map_or(0, |(at, _)| at)]);
        name.push(format!("~{:016x}", hash.finish()));
    }
    name.push(".");
    name
}

/// Removes the unfinished files of killed runs for an output: regular files with a name of this form and without a
/// lock. A file that cannot be locked, or that another system may have locked, is kept.
fn remove_unfinished(path: &Path) {
    let begin = unfinished_prefix(path);
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = fs::read_dir(folder) else { return };
    let is_part = |entry: &fs::DirEntry| {
        let name = entry.file_name();
        let number = name.as_encoded_bytes().strip_prefix(begin.as_encoded_bytes());
        let number = number.and_then(|rest| rest.strip_suffix(UNFINISHED_SUFFIX.as_bytes()));
        // Links are not followed: percuss creates none.
        number.is_some_and(|n| !n.is_empty() && n.len() <= 20 && n.iter().all(u8::is_ascii_digit))
            && entry.file_type().is_ok_and(|kind| kind.is_file())
    };
    for entry in entries.flatten().filter(is_part).take(MAX_REMOVED) {
        let Ok(file) = OpenOptions::new().read(true).write(true).open(entry.path()) else { continue };
        if file.try_lock().is_ok() {
            // Without permission, the file remains.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Reason why a file cannot be written. A full disk is no fault of the input, as on stdout.
pub fn cannot_write(path: &str, error: &io::Error) -> Failure {
    let message = format!("{path} cannot be written: {error}");
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded | io::ErrorKind::FileTooLarge => {
            Failure::NoAnswer(message)
        }
        // All other errors; `ErrorKind` is not exhaustive.
        _ => Failure::bad_input(message),
    }
}
