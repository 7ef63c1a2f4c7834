//! Readers of files, called with bytes, for the fuzzer and for the tests of its corpus.

use percuss_formats::{FileSystem, LoadOptions, Source, load, read_mesh};
use percuss_study::{
    ContactTable, GivenPose, MassQuestion, Model, PositionFile, RowSource, StudyFile, Sweep,
};
use percuss_suspension::{ImportOptions, import};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::{env, fs, process};

/// Names of the readers: the ending of their files.
pub const READERS: [&str; 15] = [
    "urdf",
    "mjcf",
    "sdf",
    "sheet.toml",
    "sheet.csv",
    "sheet.xlsx",
    "sheet.json",
    "study.toml",
    "pose.json",
    "rows.csv",
    "rows.parquet",
    "obj",
    "stl",
    "dae",
    "msh",
];

/// Largest file, bytes: larger than all files of the fuzzer.
const LARGEST: u64 = 1 << 20;

const PLANAR: &str = include_str!("../../models/planar_2r.urdf");

/// Model of the rows: its joints are "shoulder" and "elbow".
static MODEL: LazyLock<Model> = LazyLock::new(|| {
    let source = Source::from_text("planar_2r.urdf", PLANAR);
    Model::from_source(&source, &LoadOptions::default()).expect("the model is right")
});

/// Reads bytes as a file of a kind. True if the reader accepts them.
///
/// # Panics
/// Defects of the reader; an unknown kind; a folder for temporary files that cannot be written.
pub fn read(reader: &str, bytes: &[u8]) -> bool {
    let named = || Source::new(format!("fuzzed.{reader}"), bytes.to_vec());
    match reader {
        "urdf" | "mjcf" | "sdf" => load(&named(), &LoadOptions::default()).is_ok(),
        "sheet.toml" | "sheet.csv" | "sheet.xlsx" | "sheet.json" => {
            import(&named(), &ImportOptions::default()).is_ok()
        }
        "study.toml" => {
            let file = Temporary::with_model(reader, bytes);
            StudyFile::load(&file.path(), LARGEST).is_ok()
        }
        "pose.json" => GivenPose::read(&Temporary::new(reader, bytes).path(), LARGEST).is_ok(),
        "rows.csv" | "rows.parquet" => rows(&Temporary::new(reader, bytes).path()),
        "obj" | "stl" | "dae" | "msh" => {
            read_mesh(&FileSystem, &Temporary::new(reader, bytes).file, LARGEST).is_ok()
        }
        _ => panic!("no reader {reader:?}; expected one of {READERS:?}"),
    }
}

/// Reads at most ten rows of positions.
fn rows(path: &str) -> bool {
    let last = MODEL.mechanism.links().last().expect("a link").name().to_owned();
    let contact = ContactTable::at_point(last, [0.0; 3], [1.0, 0.0, 0.0]);
    let question = MassQuestion { contact, ..MassQuestion::default() };
    let file = PositionFile { path: path.to_owned(), ignore: Vec::new(), max_size: LARGEST };
    let Ok(sweep) = Sweep::new(&MODEL, &question, RowSource::File(file)) else { return false };
    let mut left = 10;
    let end = sweep.run(&mut |_| {
        left -= 1;
        if left > 0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    end.is_ok()
}

/// Folder with a file and a model; removed on drop.
struct Temporary {
    folder: PathBuf,
    file: PathBuf,
}

impl Temporary {
    fn new(reader: &str, bytes: &[u8]) -> Self {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let folder = env::temp_dir().join(format!("percuss-fuzzed-{}-{number}", process::id()));
        let file = folder.join(format!("fuzzed.{reader}"));
        let written = fs::create_dir(&folder).and_then(|()| fs::write(&file, bytes));
        written.expect("a folder for temporary files");
        Self { folder, file }
    }

    /// Folder with the file and the model `planar_2r.urdf`.
    fn with_model(reader: &str, bytes: &[u8]) -> Self {
        let folder = Self::new(reader, bytes);
        fs::write(folder.folder.join("planar_2r.urdf"), PLANAR).expect("a file in the folder");
        folder
    }

    fn path(&self) -> String {
        self.file.to_string_lossy().into_owned()
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}
