//! Flags of `percuss damp`, `percuss restitution`, `percuss identify`, `percuss response` and `percuss safe-speed`.

use super::contact::ContactArgs;
use super::model::{ModelArgs, ReadingArgs};
use super::output::{CheckFormat, WritingArgs};
use clap::Args;
use percuss_study::headings::{LIMIT, OUTPUT};
use percuss_study::{
    DampingQuestion, IdentifyQuestion, Mass, ResponseQuestion, RestitutionQuestion, SafeSpeedQuestion,
};

/// Heading in the help: source of the effective mass.
const FROM: &str = "Effective mass";

/// Flags of `percuss damp`.
#[derive(Debug, Args)]
pub struct DampArgs {
    /// Effective mass (kg).
    #[arg(long, value_name = "KG", conflicts_with = "mass_from", help_heading = FROM)]
    pub mass: Option<Mass>,
    /// Effective mass at a contact of this model.
    ///
    /// The flags of `percuss mass` define the contact.
    #[arg(long, value_name = "MODEL", help_heading = FROM)]
    pub mass_from: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub damping: DampingQuestion,
    /// List the laws and exit.
    #[arg(long, exclusive = true, help_heading = "Lists")]
    pub list_laws: bool,
    /// List the simulators and exit.
    #[arg(long, exclusive = true, help_heading = "Lists")]
    pub list_tools: bool,
    /// Force over time: .csv .xlsx .parquet .svg .png .pdf
    ///
    /// The figure shows the force over time and over penetration; CSV, XLSX and Parquet contain its numbers.
    #[arg(long, short, value_name = "FILE", requires = "speed", help_heading = OUTPUT)]
    pub output: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: ContactArgs,
}

/// Flags of `percuss restitution`.
#[derive(Debug, Args)]
pub struct RestitutionArgs {
    /// URDF, MJCF or SDF, or a suspension sheet or table. Without it, --mass.
    #[arg(required_unless_present = "mass")]
    pub model: Option<String>,
    /// Effective mass (kg), in place of a contact of a model.
    #[arg(long, value_name = "KG", conflicts_with = "model", help_heading = FROM)]
    pub mass: Option<Mass>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub restitution: RestitutionQuestion,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: ContactArgs,
}

/// Flags of `percuss identify`.
#[derive(Debug, Args)]
pub struct IdentifyArgs {
    #[command(flatten)]
    pub identify: IdentifyQuestion,
    /// Expected effective mass (kg); used if the data do not determine it.
    #[arg(long, value_name = "KG", conflicts_with = "mass_from", help_heading = FROM)]
    pub mass: Option<Mass>,
    /// Expected effective mass at a contact of this model.
    ///
    /// The flags of `percuss mass` define the contact.
    #[arg(long, value_name = "MODEL", help_heading = FROM)]
    pub mass_from: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: ContactArgs,
}

/// Flags of `percuss response`.
#[derive(Debug, Args)]
pub struct ResponseArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub response: ResponseQuestion,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: ContactArgs,
}

/// Flags of `percuss safe-speed`.
#[derive(Debug, Args)]
pub struct SafeSpeedArgs {
    /// URDF, MJCF or SDF, or a suspension sheet or table.
    #[arg(required_unless_present = "list_regions")]
    pub model: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub safe_speed: SafeSpeedQuestion,
    /// List the regions and exit.
    #[arg(long, exclusive = true, help_heading = LIMIT)]
    pub list_regions: bool,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: ContactArgs,
}
