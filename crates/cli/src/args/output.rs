//! Formats of results, and flags of the writing of files.

use clap::{Args, ValueEnum};
use percuss_study::headings::OUTPUT;

/// Formats of `percuss check`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CheckFormat {
    /// Text for people.
    Text,
    /// JSON for programs.
    Json,
}

/// Formats of `percuss mass`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MassFormat {
    /// Text for people.
    Text,
    /// JSON for programs.
    Json,
    /// One row with a header, in the columns of a sweep.
    Csv,
}

/// Formats of `percuss schema`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SchemaFormat {
    /// JSON schema for editors and programs.
    Json,
    /// JSON schema of the reports of all commands with `--format json`.
    Report,
    /// Page of all keys for people.
    Markdown,
}

/// Formats of `percuss kinematics`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum KinematicsFormat {
    /// Tables for people.
    Table,
    /// Rows with a header, in the units of the tables.
    Csv,
    /// JSON for programs, in SI units.
    Json,
}

/// Flags of the writing of files.
#[derive(Debug, Args)]
pub struct WritingArgs {
    /// Replace an output file that percuss did not write.
    #[arg(long, help_heading = OUTPUT)]
    pub force: bool,
}

impl WritingArgs {
    /// Applies the flag to all files of this run.
    pub fn apply(&self) {
        crate::files::output::allow_replacement(self.force);
    }
}
