//! Flags of `percuss compare`.

use super::contact::ContactArgs;
use super::format::MassFormat;
use super::model::ReadingArgs;
use super::{FigureArgs, TableArgs};
use clap::Args;
use percuss_study::Vary;

/// Flags of `percuss compare`.
#[derive(Debug, Args)]
pub struct CompareArgs {
    /// The designs: studies, each with its own contact (and with its [[variant]]s); or models and sheets, of which one contact
    /// is asked. The others are compared with the first.
    #[arg(required = true)]
    pub designs: Vec<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Goes through a range in every model, as in percuss sweep; a study has its own.
    #[arg(long, value_name = "JOINT=FROM:TO:COUNT | travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT", value_parser = Vary::parse)]
    pub vary: Vec<Vary>,
    /// The figure, or the table, of the ranges.
    #[arg(long, short, value_name = "FILE.svg|.png|.pdf|.csv|.json")]
    pub output: Option<String>,
    #[command(flatten)]
    pub table: TableArgs,
    #[command(flatten)]
    pub figure: FigureArgs,
    #[command(flatten)]
    pub writing: super::WritingArgs,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = MassFormat::Text)]
    pub format: MassFormat,
    #[command(flatten, next_help_heading = "The contact of models and sheets")]
    pub contact: Option<ContactArgs>,
}
