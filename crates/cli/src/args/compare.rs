//! Flags of `percuss compare`.

use super::contact::ContactArgs;
use super::model::ReadingArgs;
use super::output::MassFormat;
use clap::Args;
use percuss_study::headings::{OUTPUT, POSE};
use percuss_study::{StudyFigure, StudyTable, Vary};

/// Flags of `percuss compare`.
#[derive(Debug, Args)]
pub struct CompareArgs {
    /// Designs; the first is the reference.
    ///
    /// Either studies, each with its own contact (and its [[variant]]s), or models and sheets with one contact given
    /// by flags. All designs are compared with the first.
    #[arg(required = true)]
    pub designs: Vec<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Range in every model, as in sweep.
    ///
    /// JOINT=FROM:TO:COUNT or travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT. A study contains its own range.
    #[arg(long, value_name = "JOINT=FROM:TO:COUNT", help_heading = POSE)]
    pub vary: Vec<Vary>,
    /// Figure or table of the results over the range.
    #[arg(long, short, value_name = "FILE.svg|.png|.pdf|.csv|.xlsx|.json", help_heading = OUTPUT)]
    pub output: Option<String>,
    #[command(flatten)]
    pub table: StudyTable,
    #[command(flatten)]
    pub figure: StudyFigure,
    #[command(flatten)]
    pub writing: super::WritingArgs,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = MassFormat::Text, help_heading = OUTPUT)]
    pub format: MassFormat,
    #[command(flatten)]
    pub contact: ContactArgs,
}
