//! Flags of the commands that write models, code and pages: `convert`, `export`, `generate`, `explore`.

use super::{CheckFormat, ContactArgs, ModelArgs, WritingArgs};
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_study::generated::{Additions, Language};
use percuss_study::headings::{CONTACT, OUTPUT};
use percuss_study::{DampingQuestion, JointStop};

/// Heading of the additional functions.
const FUNCTIONS: &str = "Additional functions";

/// Language of generated code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LanguageName {
    /// C99, also valid C++: header, source, self-test.
    C,
    /// Rust without the standard library: one file.
    Rust,
}

/// Flags of `percuss generate`.
#[derive(Debug, Args)]
pub struct GenerateArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// Folder of the files; default: the current folder.
    #[arg(long, short, value_name = "FOLDER", default_value = ".", help_heading = OUTPUT)]
    pub output: String,
    /// Language of the code.
    #[arg(long, value_enum, default_value_t = LanguageName::C, help_heading = OUTPUT)]
    pub language: LanguageName,
    /// Prefix of the files and of all names in the code; default: the name of the model file.
    #[arg(long, value_name = "NAME", help_heading = OUTPUT)]
    pub name: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Velocities of the joints at unit closing speed.
    #[arg(long, help_heading = FUNCTIONS)]
    pub velocity: bool,
    /// Derivatives of the effective mass.
    ///
    /// Over the positions of the joints; with loops, along the motion of each driving joint.
    #[arg(long, help_heading = FUNCTIONS)]
    pub gradient: bool,
    /// Matrix J M⁻¹ Jᵀ at the contact point.
    ///
    /// It gives 1/m for every normal, without a division by zero along immovable directions.
    #[arg(long, help_heading = FUNCTIONS)]
    pub mobility: bool,
    /// Many configurations in one call.
    #[arg(long, help_heading = FUNCTIONS)]
    pub batch: bool,
    /// Newton iteration that closes the loops.
    ///
    /// The inputs are the positions of the driving joints and previous values of the others.
    #[arg(long, help_heading = FUNCTIONS)]
    pub close: bool,
}

impl GenerateArgs {
    /// Additional functions.
    pub fn additions(&self) -> Additions {
        let Self { velocity, gradient, mobility, batch, close, .. } = *self;
        Additions { velocity, gradient, mobility, batch, close }
    }

    /// Language of the code.
    pub fn language(&self) -> Language {
        match self.language {
            LanguageName::C => Language::C,
            LanguageName::Rust => Language::Rust,
        }
    }

    /// Prefix of the names in the code: a C identifier.
    pub fn identifier(&self) -> Result<String, Failure> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if let Some(name) = &self.name {
            let begins = name.starts_with(|c: char| c.is_ascii_lowercase());
            let is_valid = begins && name.chars().all(|c| is_part(c) && !c.is_ascii_uppercase());
            return match is_valid && name.len() <= LONGEST_NAME {
                true => Ok(name.clone()),
                false => Err(Failure::bad_input(format!(
                    "--name {}: a prefix of names in C and Rust is expected: a small letter, then small letters, digits \
                     and _, at most {LONGEST_NAME}",
                    name.escape_debug()
                ))),
            };
        }
        let stem =
            std::path::Path::new(&self.model.model).file_stem().map(|s| s.to_string_lossy().to_lowercase());
        let name: String = stem
            .unwrap_or_default()
            .chars()
            .map(|c| if is_part(c) { c } else { '_' })
            .take(LONGEST_NAME)
            .collect();
        let name = name.trim_matches('_').to_owned();
        Ok(if name.starts_with(|c: char| c.is_ascii_lowercase()) { name } else { format!("model_{name}") })
    }
}

/// Longest prefix of names.
const LONGEST_NAME: usize = 40;

/// Format of a converted model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ModelFormat {
    /// MuJoCo's format; loops are equality constraints.
    Mjcf,
    /// URDF; loops are elements of URDF+.
    Urdf,
    /// SDFormat, of Gazebo; loops are joints.
    Sdf,
}

impl ModelFormat {
    /// Name in flags.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mjcf => "mjcf",
            Self::Urdf => "urdf",
            Self::Sdf => "sdf",
        }
    }

    /// Returns `given`, or the format that the ending of the file name `output` selects.
    pub fn of_output(given: Option<Self>, output: &str) -> Result<Self, Failure> {
        let ending = output.rsplit_once('.').map_or("", |(_, ending)| ending).to_ascii_lowercase();
        let of_ending = match ending.as_str() {
            "xml" | "mjcf" => Some(Self::Mjcf),
            "urdf" => Some(Self::Urdf),
            "sdf" => Some(Self::Sdf),
            _ => None,
        };
        match (given, of_ending) {
            // The ending .xml is usual for all three formats.
            (Some(format), Some(other)) if format != other && ending != "xml" => {
                let (to, other) = (format.name(), other.name());
                Err(Failure::bad_input(format!(
                    "--output {output}: the ending names the format {other}, and --to the format {to}; omit --to, or use another ending"
                )))
            }
            (Some(format), _) | (None, Some(format)) => Ok(format),
            (None, None) => Err(Failure::bad_input(format!(
                "--output {output}: the ending names no format; use .xml, .mjcf, .urdf or .sdf, or give --to mjcf, urdf or sdf"
            ))),
        }
    }
}

/// Flags of `percuss convert`.
#[derive(Debug, Args)]
pub struct ConvertArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    /// File to write; - writes to stdout.
    #[arg(long, short, value_name = "FILE", help_heading = OUTPUT)]
    pub output: String,
    /// Format; default: from the ending of the file, .xml or .mjcf, .urdf or .sdf.
    #[arg(long, value_enum, value_name = "FORMAT", help_heading = OUTPUT)]
    pub to: Option<ModelFormat>,
    /// MJCF: write the nearest possible moments of inertia of a link with A + B < C, which MuJoCo refuses.
    #[arg(long, help_heading = OUTPUT)]
    pub balance_inertia: bool,
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
    /// Stop of a joint instead of a contact: JOINT:lower, JOINT:upper, or JOINT at its position.
    ///
    /// Stiffness in N·m/rad and speed in rad/s for a revolute joint.
    #[arg(
        long,
        value_name = "JOINT[:END]",
        help_heading = CONTACT,
        conflicts_with_all = ["at", "link", "point", "normal", "along_line", "against", "against_mass"]
    )]
    pub limit: Option<JointStop>,
    /// Model file to write. With an impact, a script FILE.py is written beside it.
    #[arg(long, short, value_name = "FILE", help_heading = OUTPUT)]
    pub output: String,
    /// Format; default: from the ending of the file, .xml or .mjcf, .urdf or .sdf. An impact requires MJCF and the ending .xml.
    #[arg(long, value_enum, value_name = "FORMAT", help_heading = OUTPUT)]
    pub to: Option<ModelFormat>,
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
