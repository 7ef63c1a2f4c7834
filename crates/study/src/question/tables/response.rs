//! Question about the response of a contact over frequency.

#[cfg(feature = "flags")]
use super::headings::{OUTPUT, ROWS};
use crate::question::errors::refusal::InvalidKey;
use crate::thresholds::FREQUENCIES;
use crate::values::value::{NumberOrText, path_in};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::str::FromStr;

/// Frequencies from the first to the last, in equal ratios, Hz.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "NumberOrText")]
#[schemars(with = "String")]
pub struct FrequencyRange {
    /// First frequency, Hz.
    pub from: f64,
    /// Last frequency, Hz.
    pub to: f64,
    /// Number of frequencies.
    pub count: usize,
}

impl Default for FrequencyRange {
    fn default() -> Self {
        Self { from: 1.0, to: 2000.0, count: 400 }
    }
}

impl FrequencyRange {
    /// All frequencies in ascending order, Hz.
    pub fn values(&self) -> Vec<f64> {
        let last = (self.count - 1) as f64;
        let at = |i: usize| self.from * (self.to / self.from).powf(i as f64 / last);
        (0..self.count).map(|i| if i + 1 == self.count { self.to } else { at(i) }).collect()
    }
}

impl FromStr for FrequencyRange {
    type Err = String;
    /// Reads `1:2000Hz:400`; a unit (Hz, kHz) at the last frequency holds for the first one without a unit.
    fn from_str(text: &str) -> Result<Self, String> {
        let expected = "expected FROM:TO:COUNT, such as 1:2000Hz:400";
        let [from, to, count] = text.split(':').collect::<Vec<_>>()[..] else {
            return Err(format!("\"{text}\"; {expected}"));
        };
        let split = |part: &str| -> Result<(f64, Option<f64>), String> {
            let (number, unit) = percuss_units::split(part.trim());
            let number = number.trim().parse::<f64>().map_err(|_| format!("\"{part}\"; {expected}"))?;
            match unit {
                "" => Ok((number, None)),
                "Hz" => Ok((number, Some(1.0))),
                "kHz" => Ok((number, Some(1e3))),
                unit => Err(format!("\"{unit}\" is no unit of a frequency; expected Hz or kHz")),
            }
        };
        let ((from, own), (to, unit)) = (split(from)?, split(to)?);
        let unit = unit.unwrap_or(1.0);
        let (from, to) = (from * own.unwrap_or(unit), to * unit);
        let count = count.trim().parse::<usize>().map_err(|_| format!("COUNT is \"{count}\"; {expected}"))?;
        if !FREQUENCIES.contains(&count) {
            let (least, most) = (FREQUENCIES.start(), FREQUENCIES.end());
            return Err(format!("{count} frequencies; {least} to {most} are possible"));
        }
        if !(from.is_normal() && from > 0.0 && to.is_finite() && to > from) {
            return Err(format!("{from} Hz to {to} Hz; expected ascending frequencies above 0"));
        }
        Ok(Self { from, to, count })
    }
}

impl TryFrom<NumberOrText> for FrequencyRange {
    type Error = String;
    fn try_from(given: NumberOrText) -> Result<Self, String> {
        given.text().parse()
    }
}

/// Response of a contact of a mechanism with bushes over frequency.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct ResponseQuestion {
    /// Frequencies (Hz, kHz) in equal ratios; default 1:2000Hz:400.
    #[cfg_attr(feature = "flags", arg(long, value_name = "FROM:TO:COUNT", allow_hyphen_values = true, help_heading = ROWS))]
    #[schemars(with = "Option<String>")]
    pub frequency: Option<FrequencyRange>,
    /// Responses over frequency: .csv .xlsx .parquet .svg .png .pdf
    #[cfg_attr(feature = "flags", arg(long, short, value_name = "FILE", help_heading = OUTPUT))]
    pub output: Option<String>,
}

impl ResponseQuestion {
    /// Question with its path relative to `folder`.
    ///
    /// # Errors
    /// [`InvalidKey`]: a range that is not ascending, or a number of frequencies out of range.
    pub fn checked(&self, folder: &Path) -> Result<Self, InvalidKey> {
        self.check()?;
        Ok(Self { output: self.output.as_ref().map(|path| path_in(folder, path)), ..self.clone() })
    }

    /// Checks the keys.
    ///
    /// # Errors
    /// [`InvalidKey`], as for [`checked`](Self::checked).
    pub fn check(&self) -> Result<(), InvalidKey> {
        let FrequencyRange { from, to, count } = self.frequency.unwrap_or_default();
        if !(from.is_normal() && from > 0.0 && to.is_finite() && to > from && FREQUENCIES.contains(&count)) {
            let why =
                format!("{from}:{to}:{count}; expected ascending frequencies above 0, such as 1:2000Hz:400");
            return Err(InvalidKey::new("response.frequency", why));
        }
        Ok(())
    }
}
