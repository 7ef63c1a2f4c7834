//! Flags of `percuss import`.

use super::words::{kilograms, metres, moments};
use clap::{Args, ValueEnum};
use percuss_formats::DEFAULT_MAX_SIZE;

/// Which side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SideArg {
    /// As the file has it.
    Left,
    /// Its mirror image.
    Right,
    /// Both on one chassis.
    Both,
}

/// Flags of `percuss import`.
#[derive(Debug, Args)]
pub struct ImportArgs {
    /// The hardpoint file; - reads the standard input.
    pub hardpoints: String,
    /// The URDF+ file to write; - writes to stdout.
    #[arg(long, short, value_name = "MODEL.urdf")]
    pub output: String,
    /// Which side.
    #[arg(long, value_enum, default_value_t = SideArg::Left)]
    pub side: SideArg,
    /// Mass of the wheel with its tyre (kg); the file has none.
    #[arg(long, value_name = "KG", value_parser = kilograms)]
    pub wheel_mass: Option<f64>,
    /// Moments of the wheel about its centre (kg·m²), y along the spin axis.
    #[arg(long, value_name = "IX,IY,IZ", value_parser = moments, requires = "wheel_mass")]
    pub wheel_inertia: Option<[f64; 3]>,
    /// Radius of the wheel (m): names the contact patch.
    #[arg(long, value_name = "M", value_parser = metres, requires = "wheel_mass")]
    pub wheel_radius: Option<f64>,
    /// Lets the rack slide, with this mass (kg); otherwise it is fixed to the chassis.
    #[arg(long, value_name = "KG", value_parser = kilograms)]
    pub rack_mass: Option<f64>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long)]
    pub strict: bool,
}
