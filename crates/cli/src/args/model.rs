//! Flags of the model and of its reading.

use crate::terminal::failure::Failure;
use clap::Args;
use percuss_formats::{DEFAULT_MAX_SIZE, LoadError, LoadOptions};
use percuss_study::headings::READING;
use percuss_study::{Changes, Model, ModelTable};

/// Model file, and options of its reading.
#[derive(Debug, Args)]
pub struct ModelArgs {
    /// URDF, MJCF or SDF, or a suspension sheet or table.
    ///
    /// - reads a URDF, MJCF or SDF from the standard input; FILE#MODEL is one of several models of an SDF file. A sheet or table (.toml, .csv, .xlsx, .xlsm, .json) is read as by `percuss import`.
    pub model: String,
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Options of the reading, and changes to the model.
#[derive(Debug, Args)]
pub struct ReadingArgs {
    #[command(flatten)]
    pub changes: ModelTable,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES", help_heading = READING)]
    pub max_size: u64,
    /// Treat warnings as errors (exit 2).
    #[arg(long, help_heading = READING)]
    pub strict: bool,
}

/// Reader of a model: path, largest size, options, worksheet.
type ReadModel = fn(&str, u64, &LoadOptions, Option<&str>) -> Result<Model, LoadError>;

impl ModelArgs {
    /// Reads the model.
    pub fn load(&self) -> Result<Model, Failure> {
        self.reading.load(&self.model)
    }

    /// Reads the model of a suspension, whose masses may be missing.
    pub fn load_for_kinematics(&self) -> Result<Model, Failure> {
        self.reading.load_with(Model::load_for_kinematics, &self.model)
    }
}

impl ReadingArgs {
    /// Reads a model.
    pub fn load(&self, path: &str) -> Result<Model, Failure> {
        self.load_with(Model::load_worksheet, path)
    }

    /// Reads a model with the changes of the flags.
    fn load_with(&self, read: ReadModel, path: &str) -> Result<Model, Failure> {
        refuse_second("link-mass", &self.changes.link_mass)?;
        refuse_second("link-com", &self.changes.link_com)?;
        refuse_second("link-inertia", &self.changes.link_inertia)?;
        let worksheet = self.changes.worksheet.as_deref();
        let model = read(path, self.max_size, &self.options(), worksheet)?;
        let changes = self.changes();
        if changes.is_empty() { Ok(model) } else { Ok(model.with_changes(&changes)?) }
    }

    /// Options of the reader.
    pub fn options(&self) -> LoadOptions {
        LoadOptions { accept: self.changes.accepted(), ..LoadOptions::default() }
    }

    /// Changes to the model: link masses, centres of mass, moved hardpoints.
    pub fn changes(&self) -> Changes {
        self.changes.changes()
    }
}

/// Refuses a second change of the same link.
fn refuse_second<T>(flag: &str, entries: &[(String, T)]) -> Result<(), Failure> {
    let is_second =
        |(i, (name, _)): &(usize, &(String, T))| entries[..*i].iter().any(|(other, _)| other == name);
    match entries.iter().enumerate().find(is_second) {
        Some((_, (name, _))) => {
            Err(Failure::bad_input(format!("--{flag}: link \"{name}\" is given twice; give it once")))
        }
        None => Ok(()),
    }
}
