//! Flags of the writing of files.

use clap::Args;
use percuss_study::headings::OUTPUT;

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
