//! How files are written.

use super::headings::OUTPUT;
use clap::Args;

/// How files are written.
#[derive(Debug, Args)]
pub struct WritingArgs {
    /// Replace an output file that percuss did not write.
    #[arg(long, help_heading = OUTPUT)]
    pub force: bool,
}

impl WritingArgs {
    /// Makes it so.
    pub fn apply(&self) {
        crate::files::output::force(self.force);
    }
}
