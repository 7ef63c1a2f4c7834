//! Questions about a model in another form: source code of the effective mass, another format, an impact for simulators.

#[cfg(feature = "flags")]
use super::headings::OUTPUT;
use crate::model::loading::Model;
use crate::question::errors::refusal::InvalidKey;
use crate::values::value::path_in;
use percuss_generate::{Additions, Language};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Heading of the additional functions.
#[cfg(feature = "flags")]
const FUNCTIONS: &str = "Additional functions";

/// Longest prefix of names.
const LONGEST_NAME: usize = 40;

/// Language of generated code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum LanguageName {
    /// C99, also valid C++: header, source, self-test.
    #[default]
    C,
    /// Rust without the standard library: one file.
    Rust,
}

impl From<LanguageName> for Language {
    fn from(name: LanguageName) -> Self {
        match name {
            LanguageName::C => Language::C,
            LanguageName::Rust => Language::Rust,
        }
    }
}

/// Source code of the effective mass at the contact, and its files.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = FUNCTIONS))]
#[serde(deny_unknown_fields, default)]
pub struct CodeQuestion {
    /// Folder of the files; default: the current folder.
    #[cfg_attr(feature = "flags", arg(long, short, value_name = "FOLDER", default_value = ".", help_heading = OUTPUT))]
    pub output: Option<String>,
    /// Language of the code.
    #[cfg_attr(feature = "flags", arg(long, value_enum, default_value_t, help_heading = OUTPUT))]
    pub language: LanguageName,
    /// Prefix of the files and of all names in the code; default: the name of the model file.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", help_heading = OUTPUT))]
    pub name: Option<String>,
    /// Velocities of the joints at unit closing speed.
    #[cfg_attr(feature = "flags", arg(long))]
    pub velocity: bool,
    /// Derivatives of the effective mass.
    ///
    /// Over the positions of the joints; with loops, along the motion of each driving joint.
    #[cfg_attr(feature = "flags", arg(long))]
    pub gradient: bool,
    /// Matrix J M⁻¹ Jᵀ at the contact point.
    ///
    /// It gives 1/m for every normal, without a division by zero along immovable directions.
    #[cfg_attr(feature = "flags", arg(long))]
    pub mobility: bool,
    /// Many configurations in one call.
    #[cfg_attr(feature = "flags", arg(long))]
    pub batch: bool,
    /// Newton iteration that closes the loops.
    ///
    /// The inputs are the positions of the driving joints and previous values of the others.
    #[cfg_attr(feature = "flags", arg(long))]
    pub close: bool,
}

/// True for a character of a name in C and Rust.
fn is_part(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

impl CodeQuestion {
    /// Question with a checked name, and with the path of the folder relative to `folder`.
    ///
    /// # Errors
    /// [`InvalidKey`]: a name that is no prefix of names in C and Rust.
    pub fn checked(&self, folder: &Path) -> Result<Self, InvalidKey> {
        if let Some(name) = &self.name {
            let begins = name.starts_with(|c: char| c.is_ascii_lowercase());
            let is_valid = begins && name.chars().all(|c| is_part(c) && !c.is_ascii_uppercase());
            if !is_valid || name.len() > LONGEST_NAME {
                let why = format!(
                    "{}; a prefix of names in C and Rust is expected: a small letter, then small letters, digits and _, at \
                     most {LONGEST_NAME}",
                    name.escape_debug()
                );
                return Err(InvalidKey::new("generate.name", why));
            }
        }
        let output = path_in(folder, self.output.as_deref().unwrap_or("."));
        Ok(Self { output: Some(output), ..self.clone() })
    }

    /// Prefix of all names in the code: a C identifier.
    pub(crate) fn identifier(&self, model: &Model) -> String {
        if let Some(name) = &self.name {
            return name.clone();
        }
        let stem = model.inputs.first().and_then(|input| Path::new(&input.path).file_stem());
        let stem = stem.map_or_else(|| model.mechanism.name().into(), |stem| stem.to_string_lossy());
        let name: String = stem
            .to_lowercase()
            .chars()
            .map(|c| if is_part(c) { c } else { '_' })
            .take(LONGEST_NAME)
            .collect();
        let name = name.trim_matches('_').to_owned();
        if name.starts_with(|c: char| c.is_ascii_lowercase()) { name } else { format!("model_{name}") }
    }

    /// Additional functions.
    pub(crate) fn additions(&self) -> Additions {
        let Self { velocity, gradient, mobility, batch, close, .. } = *self;
        Additions { velocity, gradient, mobility, batch, close }
    }
}

/// Format of a converted model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum ModelFormat {
    /// MuJoCo's format; loops are equality constraints.
    Mjcf,
    /// URDF; loops are elements of URDF+.
    Urdf,
    /// SDFormat, of Gazebo; loops are joints.
    Sdf,
}

impl ModelFormat {
    /// Name in flags and keys.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mjcf => "mjcf",
            Self::Urdf => "urdf",
            Self::Sdf => "sdf",
        }
    }

    /// Usual ending of file names.
    fn ending(self) -> &'static str {
        if self == Self::Mjcf { "xml" } else { self.name() }
    }
}

/// Returns `to`, or the format that the ending of the file name `output` selects. `keys`: keys of the name and of the format.
fn format_of(
    to: Option<ModelFormat>,
    output: Option<&str>,
    keys: [&'static str; 2],
) -> Result<ModelFormat, InvalidKey> {
    let Some(output) = output else {
        let why = "the format is missing; expected mjcf, urdf or sdf";
        return to.ok_or_else(|| InvalidKey::new(keys[1], why));
    };
    let shown = output.replace('`', "'");
    let refuse = |why: &str| Err(InvalidKey::with_names(keys[0], format!("{shown}: {why}")));
    let ending = output.rsplit_once('.').map_or("", |(_, ending)| ending).to_ascii_lowercase();
    let of_ending = match ending.as_str() {
        "xml" | "mjcf" => Some(ModelFormat::Mjcf),
        "urdf" => Some(ModelFormat::Urdf),
        "sdf" => Some(ModelFormat::Sdf),
        _ => None,
    };
    match (to, of_ending) {
        // The ending .xml is usual for all three formats.
        (Some(format), Some(other)) if format != other && ending != "xml" => {
            let (to, other) = (format.name(), other.name());
            refuse(&format!(
                "the ending names the format {other}, and `to` the format {to}; omit `to`, or use another ending"
            ))
        }
        (Some(format), _) | (None, Some(format)) => Ok(format),
        (None, None) => refuse(
            "the ending names no format; use .xml, .mjcf, .urdf or .sdf, or give `to` mjcf, urdf or sdf",
        ),
    }
}

/// The model in another format.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = OUTPUT))]
#[serde(deny_unknown_fields, default)]
pub struct ConversionQuestion {
    /// File to write; - writes to stdout.
    #[cfg_attr(feature = "flags", arg(long, short, value_name = "FILE", required = true))]
    pub output: Option<String>,
    /// Format; default: from the ending of the file, .xml or .mjcf, .urdf or .sdf.
    #[cfg_attr(feature = "flags", arg(long, value_enum, value_name = "FORMAT"))]
    pub to: Option<ModelFormat>,
    /// MJCF: write the nearest possible moments of inertia of a link with A + B < C, which MuJoCo refuses.
    #[cfg_attr(feature = "flags", arg(long))]
    pub balance_inertia: bool,
}

impl ConversionQuestion {
    /// Question with its format. The path of the file is relative to `folder`.
    ///
    /// # Errors
    /// [`InvalidKey`]: no format, or balanced inertias for another format than MJCF.
    pub fn checked(&self, folder: &Path) -> Result<Self, InvalidKey> {
        let format = format_of(self.to, self.output.as_deref(), ["convert.output", "convert.to"])?;
        check_balance(self.balance_inertia, format, "convert.balance_inertia")?;
        Ok(Self { to: Some(format), output: path_of(&self.output, folder), ..self.clone() })
    }

    /// Format, and the name of the file, which determines the names of the meshes.
    pub(crate) fn file(&self) -> (ModelFormat, String) {
        let format = self.to.unwrap_or(ModelFormat::Mjcf);
        (format, self.output.clone().unwrap_or_else(|| format!("model.{}", format.ending())))
    }
}

/// Refuses balanced inertias for another format than MJCF.
fn check_balance(is_given: bool, format: ModelFormat, key: &'static str) -> Result<(), InvalidKey> {
    if is_given && format != ModelFormat::Mjcf {
        let name = format.name();
        let why = format!("only MJCF refuses moments with A + B < C, and the output is {name}; leave it out");
        return Err(InvalidKey::new(key, why));
    }
    Ok(())
}

/// Path relative to a folder, except the standard output.
fn path_of(output: &Option<String>, folder: &Path) -> Option<String> {
    output.as_ref().map(|file| if file == "-" { file.clone() } else { path_in(folder, file) })
}

/// The impact at the contact or on the stop of a joint, with the damper of the question, as a model for MuJoCo that runs.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = OUTPUT))]
#[serde(deny_unknown_fields, default)]
pub struct ExportQuestion {
    /// Model file to write. With an impact, a script FILE.py is written beside it.
    #[cfg_attr(feature = "flags", arg(long, short, value_name = "FILE", required = true))]
    pub output: Option<String>,
    /// Format; default: from the ending of the file, .xml or .mjcf, .urdf or .sdf. An impact requires MJCF and the ending .xml.
    #[cfg_attr(feature = "flags", arg(long, value_enum, value_name = "FORMAT"))]
    pub to: Option<ModelFormat>,
    /// MJCF: write the nearest possible moments of inertia of a link with A + B < C, which MuJoCo refuses; the damper is that of these moments.
    #[cfg_attr(feature = "flags", arg(long))]
    pub balance_inertia: bool,
}

impl ExportQuestion {
    /// Question about the mechanism alone.
    ///
    /// # Errors
    /// [`InvalidKey`]: no format, or balanced inertias for another format than MJCF.
    pub fn conversion(&self) -> Result<ConversionQuestion, InvalidKey> {
        let format = format_of(self.to, self.output.as_deref(), ["export.output", "export.to"])?;
        check_balance(self.balance_inertia, format, "export.balance_inertia")?;
        let balance_inertia = self.balance_inertia;
        Ok(ConversionQuestion { output: self.output.clone(), to: Some(format), balance_inertia })
    }

    /// Question about an impact. The path of the file is relative to `folder`.
    ///
    /// # Errors
    /// [`InvalidKey`]: a format that has no state of an impact, or a file name without the ending .xml.
    pub fn checked(&self, folder: &Path) -> Result<Self, InvalidKey> {
        let to = self.to.or(self.output.is_none().then_some(ModelFormat::Mjcf));
        let format = format_of(to, self.output.as_deref(), ["export.output", "export.to"])?;
        let (name, tools) = match format {
            ModelFormat::Mjcf => ("", ""),
            ModelFormat::Sdf => ("SDFormat", "gazebo-classic or --for drake"),
            ModelFormat::Urdf => ("URDF", "drake or --for bullet"),
        };
        if format != ModelFormat::Mjcf {
            let (key, given) = match &self.output {
                Some(output) if self.to.is_none() => ("export.output", output.as_str()),
                _ => ("export.to", format.name()),
            };
            return Err(InvalidKey::new(
                key,
                format!(
                    "{given}: {name} cannot store the positions and velocities of joints at an impact; write MJCF (-o FILE.xml), or write \
                     the mechanism alone with \"percuss export MODEL -o FILE.{}\" and the contact parameters with \"percuss damp --for \
                     {tools}\"",
                    format.ending()
                ),
            ));
        }
        if let Some(output) = &self.output
            && Path::new(output).extension().is_none_or(|ending| ending != format.ending())
        {
            let why = format!(
                "{output}: a file name with .{} is expected; the script has the same name with .py",
                format.ending()
            );
            return Err(InvalidKey::new("export.output", why));
        }
        Ok(Self { to: Some(format), output: path_of(&self.output, folder), ..self.clone() })
    }

    /// Names of the model and of its script.
    pub fn files(&self) -> [String; 2] {
        let model = self.output.clone().unwrap_or_else(|| "model.xml".to_owned());
        let script = Path::new(&model).with_extension("py").to_string_lossy().into_owned();
        [model, script]
    }
}
