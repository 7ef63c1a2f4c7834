//! Damper table of a study file.

use crate::damper::joint_stop::JointStop;
use crate::question::damping_question::DampingQuestion;
use crate::question::errors::refusal::InvalidKey;
use crate::values::value::{self, NumberOrText, Words};
use percuss_contact::exports::Tool;
use percuss_contact::{Law, Separation};
use percuss_units::Quantity;
use schemars::JsonSchema;
use serde::Deserialize;

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DampingText {
    /// The coefficient of restitution, from 0 to 1.
    #[serde(deserialize_with = "value::ratio")]
    #[schemars(with = "NumberOrText")]
    pub restitution: f64,
    /// The stiffness of the contact, N/m, or N/m^p with an exponent p; for the stop of a rotating joint
    /// N·m/rad.
    #[serde(deserialize_with = "value::stiffness")]
    #[schemars(with = "NumberOrText")]
    pub stiffness: Quantity,
    /// Exponent p of the spring's force k x^p: 1 linear, 1.5 Hertz.
    pub exponent: Option<f64>,
    /// Approach speed, m/s; for a rotating joint rad/s.
    #[serde(default, deserialize_with = "value::speed")]
    #[schemars(with = "Option<NumberOrText>")]
    pub speed: Option<Quantity>,
    /// The damper law; percuss damp --list-laws.
    #[serde(default = "kelvin_voigt")]
    #[schemars(extend("enum" = laws()))]
    pub law: String,
    /// When the contact ends: as the force vanishes, or as the gap closes.
    #[schemars(extend("enum" = ["force", "gap"]))]
    pub separation: Option<String>,
    /// Simulators to write parameters for, or "all"; percuss damp --list-tools.
    #[serde(default, rename = "for", deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub tools: Vec<String>,
    /// Accepted error of the simulator's restitution.
    #[serde(default, deserialize_with = "value::some_ratio")]
    #[schemars(with = "Option<NumberOrText>")]
    pub accuracy: Option<f64>,
    /// The simulator's time step, s.
    #[serde(default, deserialize_with = "value::time")]
    #[schemars(with = "Option<NumberOrText>")]
    pub time_step: Option<f64>,
    /// Mass of the contact body alone, kg, for simulators that divide by this mass.
    #[serde(default, deserialize_with = "value::mass")]
    #[schemars(with = "Option<NumberOrText>")]
    pub own_mass: Option<f64>,
    /// Mass of the other body alone, kg, for simulators that divide by this mass.
    #[serde(default, deserialize_with = "value::mass")]
    #[schemars(with = "Option<NumberOrText>")]
    pub other_own_mass: Option<f64>,
    /// Ratio of MuJoCo's inverse weights to the contact's inverse mass; default from the model.
    pub diagonal_ratio: Option<f64>,
    /// In place of a contact: the stop of this joint, JOINT, JOINT:lower or JOINT:upper.
    pub limit: Option<String>,
    /// The figure (.svg, .png, .pdf) or the table (.csv) of the force over time; with speed.
    pub output: Option<String>,
}

/// Default of the `law` key.
fn kelvin_voigt() -> String {
    Law::KelvinVoigt.name().to_owned()
}

/// Names of the laws, including aliases.
fn laws() -> Vec<&'static str> {
    Law::ALL.iter().map(|law| law.name()).chain(Law::ALIASES.iter().map(|alias| alias.name)).collect()
}

impl DampingText {
    /// Converts the table to a question.
    pub fn question(&self) -> Result<DampingQuestion, InvalidKey> {
        let mut question = DampingQuestion::new(self.restitution, self.stiffness.value);
        let end = |word: &String| {
            let known = Separation::ALL.into_iter().find(|s| s.name() == word);
            known.ok_or_else(|| {
                InvalidKey::new("damping.separation", format!("\"{word}\"; expected force or gap"))
            })
        };
        let separation = self.separation.as_ref().map(end).transpose()?;
        question
            .choose(&self.law, self.exponent, separation)
            .map_err(|e| InvalidKey::new("damping.law", e.to_string()))?;
        question.speed = self.speed.map(|speed| speed.value);
        question.options.accuracy = self.accuracy.unwrap_or(question.options.accuracy);
        question.options.time_step = self.time_step;
        question.options.own_mass = self.own_mass;
        question.options.other_own_mass = self.other_own_mass;
        question.options.diagonal_ratio = self.diagonal_ratio;
        for tool in &self.tools {
            match tool.as_str() {
                "all" => question.tools.extend(Tool::ALL),
                name => question
                    .tools
                    .push(Tool::from_name(name).map_err(|e| InvalidKey::new("damping.for", e.to_string()))?),
            }
        }
        if self.output.is_some() && self.speed.is_none() {
            return Err(InvalidKey::new(
                "damping.output",
                "the force over time requires a speed; give speed",
            ));
        }
        Ok(question)
    }

    /// Joint stop of the `limit` key.
    pub fn stop(&self) -> Result<Option<JointStop>, InvalidKey> {
        let Some(text) = &self.limit else { return Ok(None) };
        JointStop::parse(text).map(Some).map_err(|why| InvalidKey::new("damping.limit", why))
    }
}
