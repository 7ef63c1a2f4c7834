//! Which model, and how it is read.

use clap::{Args, ValueEnum};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadError, LoadOptions};
use percuss_mechanism::Accept;
use percuss_study::Model;

/// Which model, and how it is read.
#[derive(Debug, Args)]
pub struct ModelArgs {
    /// The URDF file; - reads the standard input.
    pub model: String,
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// How a model is read.
#[derive(Debug, Args)]
pub struct ReadingArgs {
    /// Accept a model in spite of this finding.
    #[arg(long, value_enum, value_name = "FINDING")]
    pub accept: Vec<Acceptable>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long)]
    pub strict: bool,
}

/// What `--accept` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Acceptable {
    /// Inertias with a negative principal moment.
    IndefiniteInertia,
}

impl ModelArgs {
    /// Reads the model.
    pub fn load(&self) -> Result<Model, LoadError> {
        self.reading.load(&self.model)
    }
}

impl ReadingArgs {
    /// Reads a model.
    pub fn load(&self, path: &str) -> Result<Model, LoadError> {
        let indefinite_inertia = self.accept.contains(&Acceptable::IndefiniteInertia);
        Model::load(path, self.max_size, &LoadOptions { accept: Accept { indefinite_inertia } })
    }
}
