//! Flags of `percuss explore`.

use crate::args::{ContactArgs, ModelArgs, WritingArgs};
use clap::Args;
use percuss_study::headings::OUTPUT;

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
