//! Flags of the commands that write models, code and pages: `convert`, `export`, `generate`, `explore`.

use super::{CheckFormat, ContactArgs, ModelArgs, WritingArgs};
use clap::Args;
use percuss_study::headings::OUTPUT;
use percuss_study::{CodeQuestion, ConversionQuestion, DampingQuestion, ExportQuestion};

/// Flags of `percuss generate`.
#[derive(Debug, Args)]
pub struct GenerateArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub code: CodeQuestion,
    #[command(flatten)]
    pub writing: WritingArgs,
}

/// Flags of `percuss convert`.
#[derive(Debug, Args)]
pub struct ConvertArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub conversion: ConversionQuestion,
    /// Format of the report about everything changed or lost.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub writing: WritingArgs,
}

/// Flags of `percuss export`.
#[derive(Debug, Args)]
pub struct ExportArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub damping: DampingQuestion,
    #[command(flatten)]
    pub export: ExportQuestion,
    /// Format of the report: the impact, and everything changed or lost.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub writing: WritingArgs,
}

/// Flags of `percuss explore`.
#[derive(Debug, Args)]
pub struct ExploreArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// Output file; default: the name of the model with .html, in the current folder.
    #[arg(long, short, value_name = "FILE.html", help_heading = OUTPUT)]
    pub output: Option<String>,
    /// Open the page in the browser.
    #[arg(long, help_heading = OUTPUT)]
    pub open: bool,
    #[command(flatten)]
    pub writing: WritingArgs,
}
