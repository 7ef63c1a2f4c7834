//! Options of a study for its contact, in addition to the effective mass.

#[cfg(feature = "flags")]
use super::headings::{ADDITIONAL, ANSWER};
use crate::question::errors::refusal::InvalidKey;
use crate::reports::answer_mass::StudyMass;
use crate::reports::tolerance::{Sampling, Tolerance};
use crate::values::quantities::PositiveMass;
use crate::values::value::{NumberOrText, OneOrMany};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};
use std::str::FromStr;

/// Tolerance of the expected mass, or of the model's data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GivenTolerance {
    /// Relative tolerance of the expected mass.
    OfExpected(f64),
    /// Tolerances of the model's data.
    OfParts(Tolerance),
}

impl FromStr for GivenTolerance {
    type Err = String;
    /// Reads `1e-6` or `mass=2%,point=0.5mm`.
    fn from_str(text: &str) -> Result<Self, String> {
        if text.contains('=') {
            return Tolerance::parse(text).map(Self::OfParts).map_err(|error| error.to_string());
        }
        match text.trim().parse::<f64>() {
            Ok(relative) if relative >= 0.0 && relative.is_finite() => Ok(Self::OfExpected(relative)),
            _ => Err(format!(
                "\"{text}\"; a tolerance of 0 or more is expected (with an expected mass), or mass=2%,point=0.5mm for \
                 the model's data"
            )),
        }
    }
}

/// Additional requests about a contact.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct MassTable {
    /// Compare with this effective mass (kg); exit 1 if different.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", help_heading = ANSWER))]
    pub expect: Option<PositiveMass>,
    /// Tolerances: mass=2%,com=1mm,point=1mm,armature=10%.
    ///
    /// Tolerances of the model's data, and their effect on the effective mass: masses and armatures in percent,
    /// centres of mass and hardpoints of a sheet as lengths. A single number is the relative tolerance of the expected
    /// mass (default 1e-9).
    #[cfg_attr(feature = "flags", arg(long, value_name = "PART=VALUE,…", help_heading = ADDITIONAL))]
    #[serde(deserialize_with = "tolerances")]
    #[schemars(with = "Option<OneOrMany<NumberOrText>>")]
    pub tolerance: Vec<GivenTolerance>,
    /// Number of random designs within the tolerances, in addition to the first-order estimate.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "COUNT", requires = "tolerance", help_heading = ADDITIONAL)
    )]
    pub samples: Option<usize>,
    /// Random seed of the samples; default 0.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "NUMBER", requires = "samples", help_heading = ADDITIONAL)
    )]
    pub seed: Option<u64>,
    /// Show sensitivities, and the most effective changes.
    ///
    /// Derivatives of the effective mass with respect to each link's mass and centre of mass, each armature and each
    /// hardpoint of a sheet, and the changes that reduce the effective mass most.
    #[cfg_attr(feature = "flags", arg(long, help_heading = ADDITIONAL))]
    pub explain: bool,
    /// Coefficients of friction from which the contact can stick, jam or wedge.
    ///
    /// The coefficients do not depend on the velocities. A contact with one relative motion, such as the bump stop of a suspension, wedges
    /// from a coefficient of 1/t; t is the sliding speed per closing speed.
    #[cfg_attr(feature = "flags", arg(long, help_heading = ADDITIONAL))]
    pub friction_thresholds: bool,
}

/// Deserializes one tolerance or a list of tolerances.
fn tolerances<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<GivenTolerance>, D::Error> {
    let read = |given: NumberOrText| given.text().parse().map_err(serde::de::Error::custom);
    OneOrMany::<NumberOrText>::deserialize(from)?.list().into_iter().map(read).collect()
}

impl MassTable {
    /// Converts the table to options.
    ///
    /// # Errors
    /// [`InvalidKey`]: keys that need or exclude each other.
    pub fn options(&self) -> Result<StudyMass, InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::new(key, why));
        let mut study_mass = StudyMass {
            explain: self.explain,
            friction_thresholds: self.friction_thresholds,
            ..StudyMass::default()
        };
        study_mass.expect = self.expect.map(|mass| mass.0);
        for given in &self.tolerance {
            let twice = match given {
                GivenTolerance::OfExpected(relative) => {
                    study_mass.expect_tolerance.replace(*relative).is_some()
                }
                GivenTolerance::OfParts(parts) => {
                    let merged = study_mass.tolerance.unwrap_or_default().merge(*parts);
                    study_mass.tolerance = merged.or(study_mass.tolerance);
                    merged.is_none()
                }
            };
            if twice {
                let why = "given twice for the same quantity; write each once, such as mass=2%,point=0.5mm";
                return refuse("mass.tolerance", why);
            }
        }
        if study_mass.expect_tolerance.is_some() && study_mass.expect.is_none() {
            let why = "a single number requires `expect`; write tolerances of the model's data as \
                       mass=2%,point=0.5mm";
            return refuse("mass.tolerance", why);
        }
        if self.samples.is_some() && study_mass.tolerance.is_none() {
            let why = "sampling requires tolerances; give `tolerance`, such as mass=2%,point=0.5mm";
            return refuse("mass.samples", why);
        }
        if self.seed.is_some() && self.samples.is_none() {
            return refuse("mass.seed", "it requires `samples`, the number of random designs");
        }
        let seed = self.seed.unwrap_or_default();
        study_mass.sampling = self.samples.map(|count| Sampling { count, seed });
        Ok(study_mass)
    }
}
