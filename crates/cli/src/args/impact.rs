//! Flags of `percuss impact` and `percuss extremes`.

use super::{CheckFormat, ContactArgs, ModelArgs, WritingArgs};
use crate::terminal::failure::Failure;
use clap::Args;
use percuss_study::headings::{ANSWER, OUTPUT};
use percuss_study::{ContactTable, ExtremesQuestion, GivenPath, ImpactQuestion, RowSource};
use std::path::Path;

/// Flags of `percuss impact`.
#[derive(Debug, Args)]
pub struct ImpactArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub impact: ImpactQuestion,
    /// Impact in time, or --reflected over a range: .csv .xlsx .parquet .svg .png .pdf
    ///
    /// The figure of an impact in time shows the forces of contact and bearings, the compression and the effective mass over time. The
    /// figure of a range shows the inertia, free and held. CSV, XLSX and Parquet contain the numbers.
    #[arg(long, short, value_name = "FILE", help_heading = OUTPUT)]
    pub output: Option<String>,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = ANSWER)]
    pub format: CheckFormat,
    /// Show bearings of any load; default: from 2 % of the largest.
    #[arg(long, help_heading = ANSWER)]
    pub all: bool,
    /// Show the components of the reactions along the axes of the joints.
    #[arg(long, help_heading = ANSWER)]
    pub components: bool,
    #[command(flatten)]
    pub writing: WritingArgs,
}

impl ImpactArgs {
    /// True if only reflected inertias are requested: no flag of a contact or of an impact is given.
    pub fn needs_no_contact(&self) -> bool {
        let without_reflected = ImpactQuestion { reflected: Vec::new(), ..self.impact.clone() };
        !self.impact.reflected.is_empty()
            && self.contact.contact == ContactTable::default()
            && without_reflected == ImpactQuestion::default()
    }
}

/// Flags of `percuss extremes`.
#[derive(Debug, Args)]
pub struct ExtremesArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub extremes: ExtremesQuestion,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = ANSWER)]
    pub format: CheckFormat,
}

impl ExtremesArgs {
    /// Converts the flags to a question. A range of a wheel motion forms the path.
    pub fn question(&self) -> Result<ExtremesQuestion, Failure> {
        if matches!(&self.extremes.path, Some(GivenPath(RowSource::File(file))) if file.path == "-")
            && self.model.model == "-"
        {
            return Err(Failure::bad_input(
                "--path -: the model is already read from the standard input; give a file name for one of the two",
            ));
        }
        let max_size = self.model.reading.max_size;
        Ok(self.extremes.checked(self.contact.ranges()?, Path::new(""), max_size)?)
    }
}
