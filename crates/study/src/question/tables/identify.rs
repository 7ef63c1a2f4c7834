//! Question about the contact of measured impacts.

#[cfg(feature = "flags")]
use super::headings::{DAMPER, IMPACT, OUTPUT, READING};
use crate::question::errors::refusal::InvalidKey;
use crate::values::quantities::{Length, Plain, Speed};
use crate::values::value::{self, Words, path_in};
use percuss_contact::identification::{DamperForm, Known};
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// Standard acceleration of free fall, m/s².
const FREE_FALL: f64 = 9.80665;

/// Form of the damper of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum DamperFormName {
    /// c x^((p-1)/2) v.
    KelvinVoigt,
    /// d k x^p v.
    HuntCrossley,
}

/// Measured impacts, and what is known about them.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct IdentifyQuestion {
    /// CSV files, each of one impact: time, and force, acceleration, velocity or displacement.
    ///
    /// The head names the columns with their units, such as time (ms), force (kN), acceleration (g), or the units are in the row below.
    /// Commas, semicolons, tabs or blanks separate the cells. Signs and offsets are found. Several files are impacts of the same contact.
    #[cfg_attr(feature = "flags", arg(value_name = "DATA.csv", required = true))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Words", required)]
    pub data: Vec<String>,
    /// Column that is not used; repeat it for several.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COLUMN", help_heading = READING))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Names of all columns in place of the head, separated by commas: time [ms],force [kN],- (-: not used).
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "NAMES", value_delimiter = ',', allow_hyphen_values = true, help_heading = READING)
    )]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub columns: Vec<String>,
    /// Sampling rate of files without a column of the time (Hz).
    #[cfg_attr(feature = "flags", arg(long, value_name = "HZ", help_heading = READING))]
    pub rate: Option<Plain>,
    /// Known approach speed of all impacts, or of each file, separated by commas (m/s); default: identified.
    #[cfg_attr(feature = "flags", arg(long, value_name = "V", value_delimiter = ',', help_heading = IMPACT))]
    #[serde(deserialize_with = "value::one_or_many")]
    #[schemars(with = "Option<value::OneOrMany<value::NumberOrText>>")]
    pub speed: Vec<Speed>,
    /// Height of a free fall onto the contact (m): gives the speed, and the weight acts.
    #[cfg_attr(feature = "flags", arg(long, value_name = "H", conflicts_with = "speed", help_heading = IMPACT))]
    pub drop: Option<Length>,
    /// The weight acts along the motion, as on a falling body; --gravity=0: it does not (m/s²; 9.80665).
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "G",
            num_args = 0..=1,
            require_equals = true,
            default_missing_value = "9.80665",
            help_heading = IMPACT
        )
    )]
    pub gravity: Option<Plain>,
    /// Known exponent p of the spring force k x^p; default: identified.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", help_heading = DAMPER))]
    pub exponent: Option<Plain>,
    /// Form of the damper; default: the form that is nearer to the data.
    #[cfg_attr(feature = "flags", arg(long, value_enum, help_heading = DAMPER))]
    pub damper: Option<DamperFormName>,
    /// Channel frequency class of the filter that the data have passed (SAE J211), such as 600.
    #[cfg_attr(feature = "flags", arg(long, value_name = "CFC", help_heading = READING))]
    pub filter: Option<Plain>,
    /// Data and fit over time: .csv .xlsx .parquet .svg .png .pdf
    #[cfg_attr(feature = "flags", arg(long, short, value_name = "FILE", help_heading = OUTPUT))]
    pub output: Option<String>,
}

impl IdentifyQuestion {
    /// Question with checked keys; paths are relative to `folder`.
    ///
    /// # Errors
    /// As for [`check`](Self::check).
    pub fn checked(&self, folder: &Path) -> Result<Self, InvalidKey> {
        self.check()?;
        let data = self.data.iter().map(|path| path_in(folder, path)).collect();
        let output = self.output.as_ref().map(|path| path_in(folder, path));
        Ok(Self { data, output, ..self.clone() })
    }

    /// Checks the keys.
    ///
    /// # Errors
    /// [`InvalidKey`]: no file, both of a speed and a height, or a value out of range.
    pub fn check(&self) -> Result<(), InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::with_names(key, why.to_owned()));
        if self.data.is_empty() {
            return refuse("identify.data", "it is missing; give a CSV file of a measured impact");
        }
        if !self.speed.is_empty() && self.drop.is_some() {
            return refuse("identify.drop", "`speed` is given too; remove one");
        }
        let is_of_rotation =
            |speed: &Speed| speed.0.dimension.is_some_and(|dimension| dimension != Dimension::Speed);
        if self.speed.iter().any(is_of_rotation) {
            return refuse("identify.speed", "its unit is not that of a translation; expected m/s");
        }
        let (speeds, files) = (self.speed.len(), self.data.len());
        if speeds > 1 && speeds != files {
            let why = format!("{speeds} values for {files} files; expected one, or one for each file");
            return refuse("identify.speed", &why);
        }
        if self.gravity.is_some_and(|gravity| !gravity.0.is_finite()) {
            return refuse("identify.gravity", "it is not finite; expected m/s², such as 9.80665");
        }
        let speeds = self.speed.iter().map(|speed| ("identify.speed", Some(speed.0.value)));
        let numbers = [
            ("identify.rate", self.rate.map(|rate| rate.0)),
            ("identify.drop", self.drop.map(|height| height.0)),
            ("identify.filter", self.filter.map(|class| class.0)),
            ("identify.exponent", self.exponent.map(|exponent| exponent.0)),
        ];
        for (key, number) in speeds.chain(numbers) {
            if let Some(number) = number.filter(|number| !(number.is_normal() && *number > 0.0)) {
                return refuse(key, &format!("{number:?}; expected a finite number above 0"));
            }
        }
        Ok(())
    }

    /// Known approach speed of a file, m/s.
    pub(crate) fn approach_speed(&self, file: usize) -> Option<f64> {
        let fall = self.drop.map(|height| (2.0 * FREE_FALL * height.0).sqrt());
        self.speed.get(file).or(self.speed.first()).map(|speed| speed.0.value).or(fall)
    }

    /// What is known beside the data; `mass`: the effective mass, kg.
    pub(crate) fn known(&self, mass: Option<f64>) -> Known {
        Known {
            mass,
            gravity: self
                .gravity
                .map_or(if self.drop.is_some() { FREE_FALL } else { 0.0 }, |gravity| gravity.0),
            exponent: self.exponent.map(|exponent| exponent.0),
            damper: self.damper.map(|form| match form {
                DamperFormName::KelvinVoigt => DamperForm::KelvinVoigt,
                DamperFormName::HuntCrossley => DamperForm::HuntCrossley,
            }),
            filter_class: self.filter.map(|class| class.0),
        }
    }
}
