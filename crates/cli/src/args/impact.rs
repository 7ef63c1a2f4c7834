//! Flags of `percuss impact` and `percuss extremes`.

use super::{CheckFormat, ContactArgs, ModelArgs};
use clap::Args;
use percuss_study::headings::{ANSWER, OUTPUT};
use percuss_study::{ExtremesQuestion, GivenNormals, GivenQuantity, GivenRange, ImpactTable};

/// Flags of `percuss impact`.
#[derive(Debug, Args)]
pub struct ImpactArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub impact: ImpactTable,
    /// Impact in time: .svg .png .pdf .csv
    ///
    /// The figure shows the forces of contact and bearings, the penetration and the effective mass over time; CSV has the numbers.
    #[arg(long, short, value_name = "FILE", requires = "in_time", help_heading = OUTPUT)]
    pub output: Option<String>,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = ANSWER)]
    pub format: CheckFormat,
}

/// Flags of `percuss extremes`.
#[derive(Debug, Args)]
pub struct ExtremesArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// Range of a driving joint; default: the limits of all.
    ///
    /// With --range only the given joints vary, and the other joints are held at their --set positions (0 without one). Without --range all
    /// driving joints with limits vary over their limits, except those with --set.
    #[arg(long, value_name = "JOINT=FROM:TO", allow_hyphen_values = true, help_heading = ANSWER)]
    pub range: Vec<GivenRange>,
    /// Quantity: mass, reflected:JOINT, held:JOINT, bearing:JOINT.
    ///
    /// reflected, held: inertia at a joint with the other drivers free, or at rest. bearing: impulse in a joint per closing speed, of a
    /// plastic impact; an impact has (1+e) times this impulse.
    #[arg(long, value_name = "QUANTITY", default_value = "mass", help_heading = ANSWER)]
    pub quantity: GivenQuantity,
    /// Normals among which the extremes are searched: given, any, across:X,Y,Z.
    ///
    /// across: all normals perpendicular to an axis (world axes), such as those in the plane of a planar mechanism.
    #[arg(long, value_name = "NORMALS", default_value = "given", allow_hyphen_values = true, help_heading = ANSWER)]
    pub normals: GivenNormals,
    /// Number of starts of the search.
    #[arg(long, value_name = "N", default_value_t = 32, value_parser = clap::value_parser!(u16).range(1..=10_000), help_heading = ANSWER)]
    pub starts: u16,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = ANSWER)]
    pub format: CheckFormat,
}

impl ExtremesArgs {
    /// Ranges and number of starts.
    pub fn question(&self) -> ExtremesQuestion {
        ExtremesQuestion {
            ranges: self.range.clone(),
            quantity: self.quantity.clone(),
            normals: self.normals,
            starts: usize::from(self.starts),
        }
    }
}
