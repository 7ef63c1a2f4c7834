//! Options of a study for its contact, in addition to the effective mass.

#[cfg(feature = "flags")]
use super::headings::{ADDITIONAL, ANSWER};
use crate::question::errors::refusal::InvalidKey;
use crate::values::quantities::PositiveMass;
use crate::values::value::{NumberOrText, OneOrMany};
use percuss_units::{Dimension, Quantity};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};
use std::str::FromStr;

/// Tolerances of the parts of a model. Each number varies independently by at most the tolerance to either
/// side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Tolerance {
    /// Mass of each link, relative; the moments of inertia change in proportion.
    pub mass: f64,
    /// Each coordinate of the centre of mass of each link, m.
    pub com: f64,
    /// Armature of each joint, relative.
    pub armature: f64,
    /// Each coordinate of each hardpoint of a sheet, m.
    pub point: f64,
}

/// Error in the text of a tolerance.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "\"{part}\": {why}; expected mass=2%, com=1mm, armature=10%, point=0.5mm, or several of them between commas"
)]
pub struct ToleranceError {
    /// Part of the text with the error.
    pub part: String,
    /// Cause.
    pub why: String,
}

/// Parameters of random sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Number of samples.
    pub count: usize,
    /// Seed of the random numbers.
    pub seed: u64,
}

impl Tolerance {
    /// Union of two sets of tolerances; `None` if both give the same quantity.
    pub(crate) fn merge(self, other: Self) -> Option<Self> {
        let both = |a: f64, b: f64| (a == 0.0 || b == 0.0).then_some(a + b);
        Some(Self {
            mass: both(self.mass, other.mass)?,
            com: both(self.com, other.com)?,
            armature: both(self.armature, other.armature)?,
            point: both(self.point, other.point)?,
        })
    }

    /// Reads comma-separated tolerances: `mass=2%,point=0.5mm`.
    ///
    /// # Errors
    /// [`ToleranceError`] with the invalid part and the expected form.
    pub fn parse(text: &str) -> Result<Self, ToleranceError> {
        let mut tolerance = Self::default();
        let mut given: Vec<&str> = Vec::new();
        for part in text.split(',') {
            let wrong = |why: String| ToleranceError { part: part.to_owned(), why };
            let (what, value) = part.split_once('=').ok_or_else(|| wrong("it has no =".into()))?;
            let what = what.trim();
            let ratio = || Dimension::Ratio.parse(value).map(|m| m.value).map_err(|e| wrong(e.to_string()));
            let length = || {
                Quantity::parse(value)
                    .and_then(|q| q.in_dimension(Dimension::Length, value))
                    .map_err(|e| wrong(e.to_string()))
            };
            let (place, value) = match what {
                "mass" => (&mut tolerance.mass, ratio()?),
                "com" => (&mut tolerance.com, length()?),
                "armature" => (&mut tolerance.armature, ratio()?),
                "point" => (&mut tolerance.point, length()?),
                _ => return Err(wrong(format!("\"{what}\" is no kind of tolerance"))),
            };
            if given.contains(&what) {
                return Err(wrong("it is given twice".into()));
            }
            if value < 0.0 || (matches!(what, "mass" | "armature") && value >= 1.0) {
                return Err(wrong("not a tolerance: it is below 0, or 100 % or more".into()));
            }
            *place = value;
            given.push(what);
        }
        Ok(tolerance)
    }
}

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
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = ADDITIONAL))]
#[serde(deny_unknown_fields, default)]
pub struct MassOptions {
    /// Compare with this effective mass (kg); exit 1 if different.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", help_heading = ANSWER))]
    pub expect: Option<PositiveMass>,
    /// Tolerances: mass=2%,com=1mm,point=1mm,armature=10%.
    ///
    /// Tolerances of the model's data, and their effect on the effective mass: masses and armatures in percent,
    /// centres of mass and hardpoints of a sheet as lengths. A single number is the relative tolerance of the expected
    /// mass (default 1e-9).
    #[cfg_attr(feature = "flags", arg(long, value_name = "PART=VALUE,…"))]
    #[serde(deserialize_with = "tolerances")]
    #[schemars(with = "Option<OneOrMany<NumberOrText>>")]
    pub tolerance: Vec<GivenTolerance>,
    /// Number of random designs within the tolerances, in addition to the first-order estimate.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COUNT", requires = "tolerance"))]
    pub samples: Option<usize>,
    /// Random seed of the samples; default 0.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NUMBER", requires = "samples"))]
    pub seed: Option<u64>,
    /// Prove bounds of the effective mass with interval arithmetic.
    ///
    /// The bounds hold for rigid links and ideal joints, for the numbers of the model as read. For loops the assembly is proved, and that
    /// there is no other one near it.
    #[cfg_attr(feature = "flags", arg(long))]
    pub certify: bool,
    /// Show sensitivities, and the most effective changes.
    ///
    /// Derivatives of the effective mass with respect to each link's mass and centre of mass, each armature and each
    /// hardpoint of a sheet, and the changes that reduce the effective mass most.
    #[cfg_attr(feature = "flags", arg(long))]
    pub explain: bool,
    /// Coefficients of friction from which the contact can stick, jam or wedge.
    ///
    /// The coefficients do not depend on the velocities. A contact with one relative motion, such as the bump stop of a suspension, wedges
    /// from a coefficient of 1/t; t is the sliding speed per closing speed.
    #[cfg_attr(feature = "flags", arg(long))]
    pub friction_thresholds: bool,
}

/// Deserializes one tolerance or a list of tolerances.
fn tolerances<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<GivenTolerance>, D::Error> {
    let read = |given: NumberOrText| given.text().parse().map_err(serde::de::Error::custom);
    OneOrMany::<NumberOrText>::deserialize(from)?.list().into_iter().map(read).collect()
}

impl MassOptions {
    /// Checks the keys.
    ///
    /// # Errors
    /// [`InvalidKey`]: keys that need or exclude each other.
    pub fn check(&self) -> Result<(), InvalidKey> {
        let refuse = |key, why: &'static str| Err(InvalidKey::new(key, why));
        let relative = |given: &&GivenTolerance| matches!(given, GivenTolerance::OfExpected(_));
        if self.tolerance.iter().filter(relative).count() > 1 || self.parts().is_none() {
            let why = "given twice for the same quantity; write each once, such as mass=2%,point=0.5mm";
            return refuse("mass.tolerance", why);
        }
        if self.expected_tolerance().is_some() && self.expect.is_none() {
            let why = "a single number requires `expect`; write tolerances of the model's data as \
                       mass=2%,point=0.5mm";
            return refuse("mass.tolerance", why);
        }
        if self.samples.is_some() && self.tolerance().is_none() {
            let why = "sampling requires tolerances; give `tolerance`, such as mass=2%,point=0.5mm";
            return refuse("mass.samples", why);
        }
        if self.seed.is_some() && self.samples.is_none() {
            return refuse("mass.seed", "it requires `samples`, the number of random designs");
        }
        Ok(())
    }

    /// Expected effective mass, kg.
    pub fn expected(&self) -> Option<f64> {
        self.expect.map(|mass| mass.0)
    }

    /// Relative tolerance of the expected mass; `None` for the default of the command.
    pub fn expected_tolerance(&self) -> Option<f64> {
        self.tolerance.iter().find_map(|given| match given {
            GivenTolerance::OfExpected(relative) => Some(*relative),
            GivenTolerance::OfParts(_) => None,
        })
    }

    /// Tolerances of the model's parts.
    pub fn tolerance(&self) -> Option<Tolerance> {
        self.parts().flatten()
    }

    /// Union of all tolerances of the model's parts; `None` if one is given twice.
    fn parts(&self) -> Option<Option<Tolerance>> {
        self.tolerance.iter().try_fold(None::<Tolerance>, |all, given| match given {
            GivenTolerance::OfExpected(_) => Some(all),
            GivenTolerance::OfParts(parts) => all.unwrap_or_default().merge(*parts).map(Some),
        })
    }

    /// Random samples within the tolerances.
    pub fn sampling(&self) -> Option<Sampling> {
        self.samples.map(|count| Sampling { count, seed: self.seed.unwrap_or_default() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_read_or_refused() {
        let read = Tolerance::parse("mass=2%, point=0.5mm,com=1e-3,armature=0.1").unwrap();
        assert_eq!(read, Tolerance { mass: 0.02, com: 1e-3, armature: 0.1, point: 0.5e-3 });
        for text in [
            "",
            "mass",
            "mass=",
            "mass=2kg",
            "mass=-1%",
            "mass=100%",
            "point=2%",
            "mass=1%,mass=2%",
            "girth=1",
        ] {
            assert!(Tolerance::parse(text).is_err(), "{text}");
        }
    }
}
