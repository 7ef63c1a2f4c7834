//! Flags of the model and of its reading.

use super::headings::{CHANGES, READING};
use super::value_parsers::{link_com, link_mass, point_shift};
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_mechanism::Accept;
use percuss_study::{Changes, Model};

/// Model file, and options of its reading.
#[derive(Debug, Args)]
pub struct ModelArgs {
    /// URDF file, or a suspension sheet or table.
    ///
    /// - reads a URDF from the standard input. A sheet or table (.toml, .csv, .xlsx, .json) is read as by `percuss import`.
    pub model: String,
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Options of the reading, and changes to the model.
#[derive(Debug, Args)]
pub struct ReadingArgs {
    /// Change the mass of a link (kg).
    ///
    /// The moments of inertia about the centre of mass are scaled by the same factor.
    #[arg(
        long,
        value_name = "LINK=KG",
        value_parser = link_mass,
        allow_hyphen_values = true,
        help_heading = CHANGES
    )]
    pub link_mass: Vec<(String, f64)>,
    /// Change the centre of mass of a link (m, link frame).
    #[arg(
        long,
        value_name = "LINK=X,Y,Z",
        value_parser = link_com,
        allow_hyphen_values = true,
        help_heading = CHANGES
    )]
    pub link_com: Vec<(String, [f64; 3])>,
    /// Shift a hardpoint of a suspension sheet (m; 5mm).
    ///
    /// The shift is in the axes of the sheet; numbers without a unit are in m.
    #[arg(
        long = "move",
        value_name = "POINT=X,Y,Z",
        value_parser = point_shift,
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
    /// Treat warnings as errors (exit 2).
    #[arg(long, help_heading = READING)]
    pub strict: bool,
}

/// Values of `--accept`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Acceptable {
    /// Inertias with a negative principal moment.
    IndefiniteInertia,
    /// Inertias far too large for the size of the links.
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
        if changes.is_empty() { Ok(model) } else { Ok(model.with_changes(&changes)?) }
    }

    /// Options of the reader.
    pub fn options(&self) -> LoadOptions {
        let indefinite_inertia = self.accept.contains(&Acceptable::IndefiniteInertia);
        let implausible_inertia = self.accept.contains(&Acceptable::ImplausibleInertia);
        LoadOptions { accept: Accept { indefinite_inertia, implausible_inertia } }
    }

    /// Changes to the model.
    pub fn changes(&self) -> Changes {
        Changes {
            link_mass: self.link_mass.clone(),
            link_com: self.link_com.clone(),
            moves: self.moves.clone(),
        }
    }
}
