//! Flags of `percuss impact`.

use super::{CheckFormat, ContactArgs, ModelArgs};
use clap::Args;
use percuss_study::ImpactTable;
use percuss_study::headings::ANSWER;

/// Flags of `percuss impact`.
#[derive(Debug, Args)]
pub struct ImpactArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub impact: ImpactTable,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = ANSWER)]
    pub format: CheckFormat,
}
