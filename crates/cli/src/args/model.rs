//! Which model, and how it is read.

use super::headings::{CHANGES, READING};
use super::words::{link_com, link_mass, moved_point};
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_mechanism::Accept;
use percuss_study::{Changes, Model};

/// Which model, and how it is read.
#[derive(Debug, Args)]
pub struct ModelArgs {
    /// A URDF file, or a suspension's sheet or table.
    ///
    /// URDF: - reads the standard input. A sheet or table (.toml, .csv, .xlsx, .json) is read as `percuss import` reads it.
    pub model: String,
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// How a model is read.
#[derive(Debug, Args)]
pub struct ReadingArgs {
    /// Gives a link another mass (kg).
    ///
    /// Its moments about the centre of mass change in proportion.
    #[arg(
        long,
        value_name = "LINK=KG",
        value_parser = link_mass,
        allow_hyphen_values = true,
        help_heading = CHANGES
    )]
    pub link_mass: Vec<(String, f64)>,
    /// Gives a link another centre of mass (m, link's frame).
    #[arg(
        long,
        value_name = "LINK=X,Y,Z",
        value_parser = link_com,
        allow_hyphen_values = true,
        help_heading = CHANGES
    )]
    pub link_com: Vec<(String, [f64; 3])>,
    /// Moves a hardpoint of a suspension's sheet (m; 5mm).
    ///
    /// In the sheet's axes; numbers without a unit are m.
    #[arg(
        long = "move",
        value_name = "POINT=X,Y,Z",
        value_parser = moved_point,
        allow_hyphen_values = true,
        help_heading = CHANGES
    )]
    pub moves: Vec<(String, [f64; 3])>,
    /// Accept a model in spite of this finding.
    #[arg(long, value_enum, value_name = "FINDING", help_heading = READING)]
    pub accept: Vec<Acceptable>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES", help_heading = READING)]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long, help_heading = READING)]
    pub strict: bool,
}

/// What `--accept` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Acceptable {
    /// Inertias with a negative principal moment.
    IndefiniteInertia,
    /// Inertias far beyond what the size of the links allows.
    ImplausibleInertia,
}

impl ModelArgs {
    /// Reads the model.
    pub fn load(&self) -> Result<Model, Failure> {
        self.reading.load(&self.model)
    }
}

impl ReadingArgs {
    /// Reads a model.
    pub fn load(&self, path: &str) -> Result<Model, Failure> {
        let model = Model::load(path, self.max_size, &self.options())?;
        let changes = self.changes();
        if changes.is_empty() { Ok(model) } else { Ok(model.changed(&changes)?) }
    }

    /// How it is read.
    pub fn options(&self) -> LoadOptions {
        let indefinite_inertia = self.accept.contains(&Acceptable::IndefiniteInertia);
        let implausible_inertia = self.accept.contains(&Acceptable::ImplausibleInertia);
        LoadOptions { accept: Accept { indefinite_inertia, implausible_inertia } }
    }

    /// What is changed of it.
    pub fn changes(&self) -> Changes {
        Changes {
            link_mass: self.link_mass.clone(),
            link_com: self.link_com.clone(),
            moves: self.moves.clone(),
        }
    }
}
