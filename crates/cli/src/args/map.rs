//! Flags of `percuss map`.

use super::{ContactArgs, MassFormat, ModelArgs, WritingArgs};
use crate::terminal::failure::Failure;
use clap::Args;
use percuss_study::headings::OUTPUT;
use percuss_study::{MapQuestion, MassQuestion, StudyTable};
use std::path::Path;

/// Flags of `percuss map`.
#[derive(Debug, Args)]
pub struct MapArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub map: MapQuestion,
    #[command(flatten)]
    pub table: StudyTable,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Format of the result on stdout.
    #[arg(long, value_enum, default_value_t = MassFormat::Text, help_heading = OUTPUT)]
    pub format: MassFormat,
    /// Number of threads; default: the number of processors. Results do not depend on it.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = OUTPUT)]
    pub threads: Option<u16>,
}

impl MapArgs {
    /// Converts the flags to a contact and a map.
    pub fn questions(&self) -> Result<(MassQuestion, MapQuestion), Failure> {
        let contact = &self.contact.contact;
        if contact.link.is_none() && !self.map.all {
            return Err(Failure::bad_input("give a link (--link LINK), or --all for every link"));
        }
        let link = contact.link.iter().cloned().collect();
        let StudyTable { units: unit, decimal } = self.table.clone();
        let map = MapQuestion { link, point: contact.point, unit, decimal, ..self.map.clone() };
        let contact = self.contact.conditions()?;
        let map = map.checked(&contact, Path::new(""))?;
        Ok((contact, map))
    }
}
