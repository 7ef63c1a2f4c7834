//! Where results go: stdout, or a file that is replaced when all of it is written.

use crate::failure::Failure;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What is written is passed on at least this often, so that whoever reads stdout sees that there is some.
const PASSED_ON: Duration = Duration::from_millis(200);

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
            None => Box::new(io::stdout()),
            Some(path) => {
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
            Some(Beside { temporary, path }) => fs::rename(temporary, path),
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
            OpenOptions::new().write(true).open(path)?;
            fs::canonicalize(path)?
        }
        Err(_) => path.to_owned(),
    };
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.part", std::process::id()));
    let temporary = path.with_file_name(name);
    let file = File::create(&temporary)?;
    let beside = Beside { temporary, path };
    if let Ok(found) = found {
        file.set_permissions(found.permissions())?;
    }
    Ok((file, Some(beside)))
}

/// Why a file cannot be written.
pub fn cannot_write(path: &str, error: &io::Error) -> Failure {
    Failure::bad_input(format!("{path} cannot be written: {error}"))
}
