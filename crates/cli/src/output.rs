//! Where results go: stdout, or a file that is replaced when all of it is written.
//!
//! Every file that percuss writes is opened here. One that is an input, or that percuss did not write, is left alone.

use crate::escape::Terminal;
use crate::failure::Failure;
use crate::own_files::is_own;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// What is written is passed on at least this often, so that whoever reads stdout sees that there is some.
const PASSED_ON: Duration = Duration::from_millis(200);

/// How long a file that another program holds is waited for: longer than a scanner takes, not so long that one who has the
/// table open in a spreadsheet wonders.
const HELD: Duration = Duration::from_secs(2);
/// Between two attempts.
const HELD_PAUSE: Duration = Duration::from_millis(10);
/// What Windows says where a file that is open is to be replaced.
const ACCESS_DENIED: i32 = 5;
/// What it says where a file is opened that another program shares with nobody.
const SHARING_VIOLATION: i32 = 32;

/// The files that this run has read: none of them is an output.
static INPUTS: Mutex<Vec<String>> = Mutex::new(Vec::new());
/// Whether files that percuss did not write are replaced; set once, from the command line.
static FORCED: AtomicBool = AtomicBool::new(false);

/// Replaces files that percuss did not write, from now on.
pub fn force(forced: bool) {
    FORCED.store(forced, Ordering::Relaxed);
}

/// Says that a file is an input: no output takes its place.
pub fn is_input(path: &str) {
    // A panic of another thread leaves the list as it was.
    INPUTS.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push(path.to_owned());
}

/// Where a result goes. A file is written beside the one that is to be, and renamed by [`finish`](Self::finish): one that
/// is not finished leaves what was there before. Devices and pipes are written as they are.
pub struct Output {
    out: BufWriter<Box<dyn Write + Send>>,
    path: Option<String>,
    beside: Option<Beside>,
    passed_on: Instant,
}

/// A file that is not finished; it goes with the value.
struct Beside {
    temporary: PathBuf,
    path: PathBuf,
    file: File,
}

impl Drop for Beside {
    fn drop(&mut self) {
        // After it was renamed there is none.
        let _ = fs::remove_file(&self.temporary);
    }
}

impl Output {
    /// Opens a file; stdout for none.
    pub fn open(path: Option<&str>) -> Result<Self, Failure> {
        let mut beside = None;
        let out: Box<dyn Write + Send> = match path {
            None if io::stdout().is_terminal() => Box::new(Terminal::new(io::stdout())),
            None => Box::new(io::stdout()),
            Some(path) => {
                may_be_written(path)?;
                let (file, kept) = file(Path::new(path)).map_err(|error| cannot_write(path, &error))?;
                beside = kept;
                Box::new(file)
            }
        };
        let path = path.map(str::to_owned);
        Ok(Self { out: BufWriter::with_capacity(1 << 16, out), path, beside, passed_on: Instant::now() })
    }

    /// Passes on what is left, and puts the file in its place.
    pub fn finish(mut self) -> Result<(), Failure> {
        let renamed = self.out.flush().and_then(|()| match &self.beside {
            Some(Beside { temporary, path, file }) => {
                // A name that stands for bytes that a power cut loses would be the part of a file.
                file.sync_all()?;
                when_free(&[ACCESS_DENIED, SHARING_VIOLATION], || fs::rename(temporary, path))
            }
            None => Ok(()),
        });
        renamed.map_err(|error| self.failure(error))
    }

    /// Leaves out what was not passed on yet.
    pub fn discard(self) {
        let _ = self.out.into_parts();
    }

    /// Why it cannot be written.
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
        if self.passed_on.elapsed() > PASSED_ON {
            self.flush()?;
        }
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.passed_on = Instant::now();
        self.out.flush()
    }
}

/// Writes a whole file.
pub fn write_file(path: &str, bytes: &[u8]) -> Result<(), Failure> {
    let mut out = Output::open(Some(path))?;
    out.write_all(bytes).map_err(|error| out.failure(error))?;
    out.finish()
}

/// Refuses a file that is an input, by any path or link, and one that percuss did not write.
///
/// # Errors
/// Which it is, and what can be done.
pub fn may_be_written(path: &str) -> Result<(), Failure> {
    let inputs = INPUTS.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    // The comparison opens both files: a pipe would wait for its other end. Pipes and devices lose nothing when they are written.
    let is_file = |path: &str| fs::metadata(path).is_ok_and(|found| found.is_file());
    for input in inputs.iter().filter(|input| is_file(path) && is_file(input)) {
        // One of them may not be opened: they are not the same then.
        if same_file::is_same_file(path, input).unwrap_or(false) {
            let which = if input == path { String::new() } else { format!(" ({input})") };
            return Err(Failure::bad_input(format!(
                "--output {path}: this is an input of the same run{which}; name another file"
            )));
        }
    }
    if FORCED.load(Ordering::Relaxed) || is_own(Path::new(path)).map_err(|e| cannot_write(path, &e))? {
        return Ok(());
    }
    Err(Failure::bad_input(format!(
        "--output {path}: the file is there already and percuss did not write it; --force replaces it"
    )))
}

/// Opens what is written: the file itself where it is none of the usual kind, else one beside it.
fn file(path: &Path) -> io::Result<(File, Option<Beside>)> {
    let found = fs::metadata(path);
    if let Ok(found) = &found
        && !found.is_file()
    {
        return Ok((OpenOptions::new().write(true).open(path)?, None));
    }
    let path = match &found {
        Ok(_) => {
            // One that may not be written is not replaced either.
            when_free(&[SHARING_VIOLATION], || OpenOptions::new().write(true).open(path))?;
            fs::canonicalize(path)?
        }
        Err(_) => link_target(path)?,
    };
    let (temporary, file) = beside(&path)?;
    let kept = Beside { temporary, path, file: file.try_clone()? };
    if let Ok(found) = found {
        file.set_permissions(found.permissions())?;
    }
    Ok((file, Some(kept)))
}

/// The file that a chain of links names, which does not exist; the path itself if it is no link.
fn link_target(path: &Path) -> io::Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(io::Error::other(format!("more than {MOST_LINKS} links, one to the next")))
}

/// Does it again for a while where the error says that another program holds the file: on Windows, scanners, indexes and other runs that replace it
/// have it open for a moment, and nothing takes the place of an open file there.
fn when_free<T>(held: &[i32], mut action: impl FnMut() -> io::Result<T>) -> io::Result<T> {
    let begun = Instant::now();
    let is_held = |error: &io::Error| {
        cfg!(windows)
            && error.raw_os_error().is_some_and(|code| held.contains(&code))
            && begun.elapsed() < HELD
    };
    loop {
        match action() {
            Err(error) if is_held(&error) => std::thread::sleep(HELD_PAUSE),
            done => return done,
        }
    }
}

/// A new file in the same folder, `.NAME.NUMBER.percuss-part`, locked as long as it is written. Those that killed runs left of
/// the same output go first.
fn beside(path: &Path) -> io::Result<(PathBuf, File)> {
    remove_left(path);
    let name = |attempt: u32| {
        let number = u64::from(std::process::id()) + (u64::from(attempt) << 32);
        let mut name = part_of(path);
        name.push(format!("{number}{PART}"));
        path.with_file_name(name)
    };
    let mut attempt = 0;
    loop {
        let temporary = name(attempt);
        match OpenOptions::new().write(true).create_new(true).open(&temporary) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && attempt < 100 => attempt += 1,
            opened => {
                let file = opened?;
                // Another run may have taken it for one that was left, before it was locked.
                let is_taken =
                    matches!(file.try_lock(), Err(TryLockError::WouldBlock)) || !temporary.exists();
                if is_taken && attempt < 100 {
                    attempt += 1;
                    continue;
                }
                return Ok((temporary, file));
            }
        }
    }
}

/// How the names of files that are not finished end.
const PART: &str = ".percuss-part";
/// Files left by killed runs that are removed at once.
const MOST_LEFT: usize = 1000;

/// Links that are followed from an output to its file, as many as Linux follows.
const MOST_LINKS: usize = 40;
/// Bytes of a name that is part of another name whole. Systems allow 255 bytes, and `..NUMBER.percuss-part` has 36.
const LONGEST_WHOLE_NAME: usize = 200;

/// How the names of files that are to be an output begin: `.NAME.`. A long name is cut, and a hash of the whole follows.
fn part_of(path: &Path) -> OsString {
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

/// Removes what killed runs left of an output: regular files of the very name that percuss gives, which no run has locked. One
/// that cannot be locked, or that another system's lock may hold, stays.
fn remove_left(path: &Path) {
    let begin = part_of(path);
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = fs::read_dir(folder) else { return };
    let is_part = |entry: &fs::DirEntry| {
        let name = entry.file_name();
        let number = name.as_encoded_bytes().strip_prefix(begin.as_encoded_bytes());
        let number = number.and_then(|rest| rest.strip_suffix(PART.as_bytes()));
        // Not through a link: that is none of ours.
        number.is_some_and(|n| !n.is_empty() && n.len() <= 20 && n.iter().all(u8::is_ascii_digit))
            && entry.file_type().is_ok_and(|kind| kind.is_file())
    };
    for entry in entries.flatten().filter(is_part).take(MOST_LEFT) {
        let Ok(file) = OpenOptions::new().read(true).write(true).open(entry.path()) else { continue };
        if file.try_lock().is_ok() {
            // Who may not remove it leaves it there.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Why a file cannot be written. A disk that is full is no fault of the input, as on stdout.
pub fn cannot_write(path: &str, error: &io::Error) -> Failure {
    let message = format!("{path} cannot be written: {error}");
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded | io::ErrorKind::FileTooLarge => {
            Failure::NoAnswer(message)
        }
        // An open list of the operating system's.
        _ => Failure::bad_input(message),
    }
}
