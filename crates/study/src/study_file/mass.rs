//! Options of a study for its contact, in addition to the effective mass.

use crate::question::errors::refusal::InvalidKey;
use crate::reports::tolerance::{Sampling, Tolerance};
use crate::values::value::{self, NumberOrText};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};

/// Options of a study for its contact, in addition to the effective mass.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StudyMass {
    /// Expected effective mass, kg.
    pub expect: Option<f64>,
    /// Relative tolerance of the expected mass; `None` for the default of the command.
    pub expect_tolerance: Option<f64>,
    /// True if sensitivities of m̄ are requested.
    pub explain: bool,
    /// Tolerances of the model's parts.
    pub tolerance: Option<Tolerance>,
    /// Random samples within the tolerances.
    pub sampling: Option<Sampling>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MassText {
    /// Expected effective mass, kg; exit code 1 on a mismatch.
    #[serde(default, deserialize_with = "value::mass")]
    #[schemars(with = "Option<NumberOrText>")]
    pub expect: Option<f64>,
    /// A number: the relative tolerance of expect. Text such as "mass=2%,point=0.5mm": tolerances of the
    /// model's parts. Or a list of both.
    #[serde(default, deserialize_with = "tolerances")]
    #[schemars(with = "Option<Tolerances>")]
    tolerance: Vec<NumberOrText>,
    /// Number of random designs within tolerance.
    pub samples: Option<usize>,
    /// The seed of samples; default 0.
    pub seed: Option<u64>,
    /// Report the sensitivities of the effective mass.
    #[serde(default)]
    pub explain: bool,
}

/// One tolerance, or several.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a number, text such as \"mass=2%,point=0.5mm\", or a list of both")]
enum Tolerances {
    One(NumberOrText),
    Many(Vec<NumberOrText>),
}

/// Deserializes one tolerance or a list of tolerances.
fn tolerances<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<NumberOrText>, D::Error> {
    Ok(match Tolerances::deserialize(from)? {
        Tolerances::One(one) => vec![one],
        Tolerances::Many(many) => many,
    })
}

impl MassText {
    /// Converts the table to options.
    pub fn options(&self) -> Result<StudyMass, InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::new(key, why));
        let mut study_mass = StudyMass { expect: self.expect, explain: self.explain, ..StudyMass::default() };
        if let Some(mass) = self.expect.filter(|mass| !(mass.is_finite() && *mass > 0.0)) {
            let why = format!("{mass} kg; a mass above 0 is expected");
            return Err(InvalidKey::new("mass.expect", why));
        }
        for given in &self.tolerance {
            let twice = match given {
                NumberOrText::Number(relative) if !(*relative >= 0.0 && relative.is_finite()) => {
                    let why = format!("{relative}; a tolerance of 0 or more is expected");
                    return Err(InvalidKey::new("mass.tolerance", why));
                }
                NumberOrText::Number(relative) => study_mass.expect_tolerance.replace(*relative).is_some(),
                NumberOrText::Text(text) => {
                    let parts = Tolerance::parse(text)
                        .map_err(|error| InvalidKey::new("mass.tolerance", error.to_string()))?;
                    study_mass.tolerance.replace(parts).is_some()
                }
            };
            if twice {
                let why = "given twice for the same quantity; write \"mass=2%,point=0.5mm\" as one";
                return refuse("mass.tolerance", why);
            }
        }
        if study_mass.expect_tolerance.is_some() && study_mass.expect.is_none() {
            let why = "a single number requires expect; write tolerances of the model's data as \
                       \"mass=2%,point=0.5mm\"";
            return refuse("mass.tolerance", why);
        }
        if self.samples.is_some() && study_mass.tolerance.is_none() {
            let why = "sampling requires tolerances; give tolerance = \"mass=2%,point=0.5mm\"";
            return refuse("mass.samples", why);
        }
        if self.seed.is_some() && self.samples.is_none() {
            return refuse("mass.seed", "a seed requires samples; give samples");
        }
        let seed = self.seed.unwrap_or_default();
        study_mass.sampling = self.samples.map(|count| Sampling { count, seed });
        Ok(study_mass)
    }
}
