//! Damper table of a study file.

#[cfg(feature = "flags")]
use super::headings::DAMPER;
use crate::damper::joint_stop::JointStop;
use crate::question::damping_question::{DampingQuestion, check_units};
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::values::quantities::{Plain, PositiveMass, Ratio, Speed, Stiffness, Time};
use crate::values::value::{self, Words};
use percuss_contact::exports::{ExportError, Tool};
use percuss_contact::{ContactLawError, Law, Separation};
use schemars::JsonSchema;
use serde::Deserialize;
use std::str::FromStr;

/// Name of a contact law.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LawName(String);

impl LawName {
    /// The name.
    pub(crate) fn name(&self) -> &str {
        &self.0
    }
}

impl FromStr for LawName {
    type Err = ContactLawError;
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Law::from_name(text).map(|_| Self(text.to_owned()))
    }
}

/// Simulators: one, or all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tools(Vec<Tool>);

impl FromStr for Tools {
    type Err = ExportError;
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "all" => Ok(Self(Tool::ALL.to_vec())),
            _ => Tool::from_name(text).map(|tool| Self(vec![tool])),
        }
    }
}

/// End of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum SeparationName {
    /// When the force vanishes.
    Force,
    /// When the gap closes.
    Gap,
}

/// Damper for a coefficient of restitution, and the simulators that need its parameters.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct DampingTable {
    /// Required coefficient of restitution, from 0 to 1.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "E", allow_hyphen_values = true, requires = "stiffness", help_heading = DAMPER)
    )]
    #[schemars(required)]
    pub restitution: Option<Ratio>,
    /// Stiffness of the contact (N/m; 200N/mm).
    ///
    /// Units: N/m, N/mm, kN/m, kN/mm, lbf/in; with an exponent p the number is in N/m^p. The stop of a revolute joint has
    /// N·m/rad (Nm/rad, Nm/deg).
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "K", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    #[schemars(required)]
    pub stiffness: Option<Stiffness>,
    /// Exponent p of the spring force k x^p.
    ///
    /// 1 is a linear spring (the default), 1.5 a Hertz contact.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "P", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    pub exponent: Option<Plain>,
    /// Approach speed (m/s): penetration, force, energy.
    ///
    /// Adds penetration, force and energy to the result. Units: m/s, mm/s, km/h; for the stop of a revolute joint
    /// rad/s, deg/s. Some laws depend on the speed.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "V", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    pub speed: Option<Speed>,
    /// Law of the damper (damp --list-laws).
    ///
    /// `percuss damp --list-laws` lists the laws. Default: kelvin-voigt.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "NAME", requires = "restitution", help_heading = DAMPER)
    )]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>", extend("enum" = laws()))]
    pub law: Option<LawName>,
    /// End of the contact: when the force vanishes (the default), or when the gap closes (the damper then pulls at
    /// the end).
    #[cfg_attr(feature = "flags", arg(long, value_enum, requires = "restitution", help_heading = DAMPER))]
    pub separation: Option<SeparationName>,
    /// Parameters for one simulator, or for all.
    ///
    /// mujoco, drake, gazebo, gazebo-classic, ode, bullet, physx, rapier, chrono, adams, simscape, dart, opensim,
    /// exudyn, newton, jolt, or all; separate several names by commas.
    #[cfg_attr(
        feature = "flags",
        arg(
            long = "for",
            value_name = "TOOL",
            value_delimiter = ',',
            requires = "restitution",
            help_heading = DAMPER
        )
    )]
    #[serde(rename = "for", deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub tools: Vec<Tools>,
    /// Permitted error of the simulator's restitution, default 0.001; determines the time step.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "E", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    pub accuracy: Option<Ratio>,
    /// Time step of the simulator (s, ms); default: the step that the accuracy requires.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "S", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    pub time_step: Option<Time>,
    /// Mass (kg) of the contact link alone, for simulators that need it; default: from the model, if any.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "KG", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    pub own_mass: Option<PositiveMass>,
    /// Mass (kg) of the other body alone, as for the contact link.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "KG", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    pub other_own_mass: Option<PositiveMass>,
    /// MuJoCo's α = Â·m̄; Â is the sum of body_invweight0 of both bodies. Default: from the model, if any.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "A", allow_hyphen_values = true, requires = "restitution", help_heading = DAMPER)
    )]
    pub diagonal_ratio: Option<Plain>,
    /// In place of a contact: the stop of this joint, JOINT, JOINT:lower or JOINT:upper.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub limit: Option<JointStop>,
    /// The figure (.svg, .png, .pdf) or the table (.csv) of the force over time; with speed.
    #[cfg_attr(feature = "flags", arg(skip))]
    pub output: Option<String>,
}

/// Names of the laws, including aliases.
fn laws() -> Vec<&'static str> {
    Law::ALL.iter().map(|law| law.name()).chain(Law::ALIASES.iter().map(|alias| alias.name)).collect()
}

impl DampingTable {
    /// First required key that is missing.
    pub fn missing(&self) -> Option<&'static str> {
        let required = [("restitution", self.restitution.is_some()), ("stiffness", self.stiffness.is_some())];
        required.into_iter().find(|(_, is_given)| !is_given).map(|(key, _)| key)
    }

    /// Converts the table to a question; `None` without a restitution or a stiffness.
    ///
    /// # Errors
    /// [`InvalidKey`]: a law whose name fixes another exponent or separation, or a figure without a speed.
    pub fn question(&self) -> Result<Option<DampingQuestion>, InvalidKey> {
        let (Some(restitution), Some(stiffness)) = (self.restitution, self.stiffness) else {
            return Ok(None);
        };
        let mut question = DampingQuestion::new(restitution.0, stiffness.0.value);
        let separation = self.separation.map(|end| match end {
            SeparationName::Force => Separation::ForceVanishes,
            SeparationName::Gap => Separation::GapCloses,
        });
        let law = self.law.as_ref().map_or(Law::KelvinVoigt.name(), |law| &law.0);
        question
            .choose(law, self.exponent.map(|exponent| exponent.0), separation)
            .map_err(|error| InvalidKey::new("damping.law", error.to_string()))?;
        if separation.is_some() && question.law != Law::KelvinVoigt {
            let why = "it is the end of a contact with the law kelvin-voigt; remove it, or give that `law`";
            return Err(InvalidKey::new("damping.separation", why));
        }
        question.speed = self.speed.map(|speed| speed.0.value);
        let options = &mut question.options;
        options.accuracy = self.accuracy.map_or(options.accuracy, |accuracy| accuracy.0);
        options.time_step = self.time_step.map(|step| step.0);
        options.own_mass = self.own_mass.map(|mass| mass.0);
        options.other_own_mass = self.other_own_mass.map(|mass| mass.0);
        options.diagonal_ratio = self.diagonal_ratio.map(|ratio| ratio.0);
        for tool in self.tools.iter().flat_map(|tools| &tools.0) {
            if !question.tools.contains(tool) {
                question.tools.push(*tool);
            }
        }
        if self.output.is_some() && self.speed.is_none() {
            let why = "the force over time requires a speed; give `speed`";
            return Err(InvalidKey::new("damping.output", why));
        }
        Ok(Some(question))
    }

    /// Refuses rotational units for a translation, and translational units for a rotation.
    ///
    /// # Errors
    /// [`StudyError`] with the field and the expected unit.
    pub fn check_units(&self, question: &DampingQuestion, turns: bool) -> Result<(), StudyError> {
        let Some(stiffness) = self.stiffness else { return Ok(()) };
        check_units(question, stiffness.0, self.speed.map(|speed| speed.0), turns)
    }
}
