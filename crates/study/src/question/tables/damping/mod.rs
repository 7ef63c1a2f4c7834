//! Question about a damper: the coefficient of restitution, the contact law, and the simulators.

pub(crate) mod restitution;

#[cfg(feature = "flags")]
use super::headings::DAMPER;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::spelled_contact::JointStop;
use crate::values::force_curve::GivenCurve;
use crate::values::quantities::{Plain, PositiveMass, Ratio, Speed, Stiffness, Time};
use crate::values::value::{self, Words};
use percuss_contact::exports::{ExportError, Options, Tool};
use percuss_contact::{Alias, ContactLawError, Law, LawParameter, Separation};
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::Deserialize;
use std::str::FromStr;

/// Contact law by its name, or by an alias that can fix the exponent and the end of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawName {
    law: Law,
    alias: Option<&'static Alias>,
}

impl From<Law> for LawName {
    fn from(law: Law) -> Self {
        Self { law, alias: None }
    }
}

impl FromStr for LawName {
    type Err = ContactLawError;
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(Self { law: Law::from_name(text)?, alias: Law::alias(text) })
    }
}

/// Simulators: one, or all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tools(pub Vec<Tool>);

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

impl From<SeparationName> for Separation {
    fn from(name: SeparationName) -> Self {
        match name {
            SeparationName::Force => Separation::ForceVanishes,
            SeparationName::Gap => Separation::GapCloses,
        }
    }
}

impl From<Separation> for SeparationName {
    fn from(separation: Separation) -> Self {
        match separation {
            Separation::ForceVanishes => SeparationName::Force,
            Separation::GapCloses => SeparationName::Gap,
        }
    }
}

/// Damper for a coefficient of restitution, and the simulators that need its parameters.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = DAMPER))]
#[serde(deny_unknown_fields, default)]
pub struct DampingQuestion {
    /// Required coefficient of restitution, from 0 to 1.
    #[cfg_attr(feature = "flags", arg(long, value_name = "E"))]
    #[schemars(required)]
    pub restitution: Option<Ratio>,
    /// Stiffness of the contact (N/m; 200N/mm).
    ///
    /// Without a restitution: the stiffness for which the effect of the bushes and gears of the model is judged. Default: the force curve of the stop in a suspension sheet, which a given stiffness replaces. Units: N/m, N/mm, kN/m, kN/mm, lbf/in; with an exponent p the number is in N/m^p. The stop of a revolute joint has
    /// N·m/rad (Nm/rad, Nm/deg).
    #[cfg_attr(feature = "flags", arg(long, value_name = "K"))]
    pub stiffness: Option<Stiffness>,
    /// Table of deflection and force of the contact, in place of a stiffness.
    ///
    /// Two columns, CSV; units at the numbers or in brackets in a header, otherwise m and N. Linear between the points; beyond the last
    /// point the last slope continues. Default: the curve of the stop in a suspension sheet.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "FILE",
            value_parser = GivenCurve::read,
            requires = "restitution",
            conflicts_with_all = ["stiffness", "exponent"]
        )
    )]
    pub stiffness_curve: Option<GivenCurve>,
    /// Exponent p of the spring force k x^p.
    ///
    /// 1 is a linear spring (the default), 1.5 a Hertz contact.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", requires = "restitution"))]
    pub exponent: Option<Plain>,
    /// Approach speed (m/s): penetration, force, energy.
    ///
    /// Adds penetration, force and energy to the result. Units: m/s, mm/s, km/h; for the stop of a revolute joint
    /// rad/s, deg/s. Some laws depend on the speed.
    #[cfg_attr(feature = "flags", arg(long, value_name = "V", requires = "restitution"))]
    pub speed: Option<Speed>,
    /// Law of the damper (damp --list-laws).
    ///
    /// `percuss damp --list-laws` lists the laws. Default: kelvin-voigt; hunt-crossley on a force curve, because a linear damper gives a soft
    /// stop its largest force at zero penetration.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", requires = "restitution"))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>", extend("enum" = laws()))]
    pub law: Option<LawName>,
    /// End of the contact: when the force vanishes (the default), or when the gap closes (the damper then pulls at
    /// the end).
    #[cfg_attr(feature = "flags", arg(long, value_enum, requires = "restitution"))]
    pub separation: Option<SeparationName>,
    /// Parameters for one simulator, or for all.
    ///
    /// mujoco, drake, gazebo, gazebo-classic, ode, bullet, physx, rapier, chrono, adams, simscape, dart, opensim,
    /// exudyn, newton, jolt, or all; separate several names by commas.
    #[cfg_attr(
        feature = "flags",
        arg(long = "for", value_name = "TOOL", value_delimiter = ',', requires = "restitution")
    )]
    #[serde(rename = "for", deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub tools: Vec<Tools>,
    /// Permitted error of the simulator's restitution, default 0.001; determines the time step.
    #[cfg_attr(feature = "flags", arg(long, value_name = "E", requires = "restitution"))]
    pub accuracy: Option<Ratio>,
    /// Time step of the simulator (s, ms); default: the step that the accuracy requires.
    #[cfg_attr(feature = "flags", arg(long, value_name = "S", requires = "restitution"))]
    pub time_step: Option<Time>,
    /// Mass (kg) of the contact link alone, for simulators that need it; default: from the model, if any.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", requires = "restitution"))]
    pub own_mass: Option<PositiveMass>,
    /// Mass (kg) of the other body alone, as for the contact link.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", requires = "restitution"))]
    pub other_own_mass: Option<PositiveMass>,
    /// MuJoCo's α = Â·m̄; Â is the sum of body_invweight0 of both bodies. Default: from the model, if any.
    #[cfg_attr(feature = "flags", arg(long, value_name = "A", requires = "restitution"))]
    pub diagonal_ratio: Option<Plain>,
    /// Stop of a joint in place of a contact: JOINT:lower, JOINT:upper, or JOINT at its position.
    ///
    /// The damper uses the effective inertia at the joint, loops included; stiffness in N·m/rad and speed in rad/s for a revolute joint.
    /// The joint is at its set position, or at its lower or upper limit. Of the simulators, mujoco, ode, newton and physx have such stops.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "JOINT[:END]",
            conflicts_with_all = ["at", "link", "point", "normal", "along_line", "against", "against_mass"]
        )
    )]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub limit: Option<JointStop>,
    /// The figure (.svg, .png, .pdf) or the table (.csv, .xlsx, .parquet) of the force over time; with speed.
    #[cfg_attr(feature = "flags", arg(skip))]
    pub output: Option<String>,
    /// Further data for simulators; the values of the keys replace its accuracy, time step, masses and ratio.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(skip)]
    pub options: Options,
}

/// Names of the laws, including aliases.
fn laws() -> Vec<&'static str> {
    Law::ALL.iter().map(|law| law.name()).chain(Law::ALIASES.iter().map(|alias| alias.name)).collect()
}

impl DampingQuestion {
    /// Question for a linear spring without a speed: Kelvin–Voigt law with separation at zero force, no
    /// simulators.
    pub fn new(restitution: f64, stiffness: f64) -> Self {
        Self { restitution: Some(restitution.into()), stiffness: Some(stiffness.into()), ..Self::default() }
    }

    /// First required key that is missing.
    pub fn missing(&self) -> Option<&'static str> {
        self.restitution.is_none().then_some("restitution")
    }

    /// The question with checked keys; `None` without a restitution.
    ///
    /// # Errors
    /// [`InvalidKey`]: a stiffness beside a force curve, a law whose name fixes another exponent or separation, or a figure without a speed.
    pub fn checked(&self) -> Result<Option<&Self>, InvalidKey> {
        if self.missing().is_some() {
            return Ok(None);
        }
        if self.stiffness_curve.is_some() && (self.stiffness.is_some() || self.exponent.is_some()) {
            let why = "it is given beside `stiffness` or `exponent`; expected one of the two";
            return Err(InvalidKey::new("damping.stiffness_curve", why));
        }
        self.check_law().map_err(|error| InvalidKey::new("damping.law", error.to_string()))?;
        if self.separation.is_some() && self.law() != Law::KelvinVoigt {
            let why = "it is the end of a contact with the law kelvin-voigt; remove it, or give that `law`";
            return Err(InvalidKey::new("damping.separation", why));
        }
        if self.output.is_some() && self.speed.is_none() {
            let why = "the force over time requires a speed; give `speed`";
            return Err(InvalidKey::new("damping.output", why));
        }
        Ok(Some(self))
    }

    /// The question with checked keys if it has a restitution, or a stiffness alone, for which the bushes of a model are judged.
    ///
    /// # Errors
    /// As for [`checked`](Self::checked); a stiffness that is not a finite number above 0.
    pub fn checked_for_mass(&self) -> Result<Option<&Self>, InvalidKey> {
        let checked = self.checked()?;
        if checked.is_some() || self.stiffness.is_none() {
            return Ok(checked);
        }
        if !(self.stiffness().is_finite() && self.stiffness() > 0.0) {
            let why = format!("{}; expected a finite number above 0", self.stiffness());
            return Err(InvalidKey::new("damping.stiffness", why));
        }
        Ok(Some(self))
    }

    /// True for a stiffness alone, for which the bushes and gears of a model are judged.
    pub fn judges_compliance(&self) -> bool {
        self.stiffness.is_some() && *self == Self { stiffness: self.stiffness, ..Self::default() }
    }

    /// Error for a stiffness without a restitution and without bushes.
    pub(crate) fn restitution_missing(&self) -> InvalidKey {
        let why = "it requires `restitution`, for the damper of the contact; alone it judges the elastic bushes and gears of a model, and this model has none";
        InvalidKey::new("damping.stiffness", why)
    }

    /// Refuses an exponent or an end of the contact that contradicts the alias of the law.
    ///
    /// # Errors
    /// [`ContactLawError::Contradicts`].
    pub fn check_law(&self) -> Result<(), ContactLawError> {
        let Some(alias) = self.law.and_then(|law| law.alias) else { return Ok(()) };
        let contradicts = |what, fixed: String, got: String| {
            Err(ContactLawError::Contradicts { name: alias.name, what, fixed: fixed.into(), got: got.into() })
        };
        match (alias.exponent, self.exponent) {
            (Some(fixed), Some(Plain(got))) if fixed != got => {
                return contradicts(LawParameter::Exponent, fixed.to_string(), got.to_string());
            }
            _ => {}
        }
        if let (Some(fixed), Some(_)) = (alias.exponent, &self.stiffness_curve) {
            return contradicts(LawParameter::Exponent, fixed.to_string(), "a force curve".to_owned());
        }
        match (alias.separation, self.separation.map(Separation::from)) {
            (Some(fixed), Some(got)) if fixed != got => {
                contradicts(LawParameter::Separation, fixed.name().into(), got.name().into())
            }
            _ => Ok(()),
        }
    }

    /// Refuses the stop of a joint, at a contact or for a given mass.
    pub(crate) fn refuse_limit(&self) -> Result<(), InvalidKey> {
        if self.limit.is_none() || self.options.stop.is_some() {
            return Ok(());
        }
        let why = "the stop of a joint replaces the contact and the mass; expected no `limit` with them";
        Err(InvalidKey::new("damping.limit", why))
    }

    /// Refuses parameters of simulators without a simulator.
    pub(crate) fn refuse_unread(&self) -> Result<(), InvalidKey> {
        let given = [
            ("damping.accuracy", self.accuracy.is_some()),
            ("damping.time_step", self.time_step.is_some()),
            ("damping.other_own_mass", self.other_own_mass.is_some()),
            ("damping.diagonal_ratio", self.diagonal_ratio.is_some()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given && self.tools().is_empty()) {
            Some((key, _)) => Err(InvalidKey::new(
                key,
                "it belongs to the parameters of a simulator; name one by `for`, or remove it",
            )),
            None => Ok(()),
        }
    }

    /// Coefficient of restitution e, from 0 to 1; NaN if it is missing.
    pub fn restitution(&self) -> f64 {
        self.restitution.map_or(f64::NAN, |restitution| restitution.0)
    }

    /// Stiffness k, N/m^p; NaN if it is missing.
    pub fn stiffness(&self) -> f64 {
        self.stiffness.map_or(f64::NAN, |stiffness| stiffness.0.value)
    }

    /// Exponent p of the spring force k xᵖ.
    pub fn exponent(&self) -> f64 {
        let fixed = self.law.and_then(|law| law.alias?.exponent);
        fixed.or(self.exponent.map(|exponent| exponent.0)).unwrap_or(1.0)
    }

    /// Approach speed, m/s.
    pub fn speed(&self) -> Option<f64> {
        self.speed.map(|speed| speed.0.value)
    }

    /// The law of the damper; without a given law, Hunt–Crossley on a force curve, otherwise Kelvin–Voigt. A given end of the contact implies
    /// Kelvin–Voigt.
    pub fn law(&self) -> Law {
        let default = match self.stiffness_curve.is_some() && self.separation.is_none() {
            true => Law::HuntCrossley,
            false => Law::KelvinVoigt,
        };
        self.law.map_or(default, |law| law.law)
    }

    /// True if the question has a stiffness or a force curve.
    pub(crate) fn has_stiffness(&self) -> bool {
        self.stiffness.is_some() || self.stiffness_curve.is_some()
    }

    /// Alias by which the law was requested.
    pub fn alias(&self) -> Option<&'static str> {
        Some(self.law?.alias?.name)
    }

    /// Condition for the end of a Kelvin–Voigt contact.
    pub fn separation(&self) -> Separation {
        let fixed = self.law.and_then(|law| law.alias?.separation);
        fixed.or(self.separation.map(Separation::from)).unwrap_or(Separation::ForceVanishes)
    }

    /// Simulators to write parameters for, each once.
    pub fn tools(&self) -> Vec<Tool> {
        let mut tools = Vec::new();
        for tool in self.tools.iter().flat_map(|tools| &tools.0) {
            if !tools.contains(tool) {
                tools.push(*tool);
            }
        }
        tools
    }

    /// Options of single simulators; missing values are completed from the model.
    pub(crate) fn export_options(&self) -> Options {
        let Options { accuracy, time_step, own_mass, other_own_mass, diagonal_ratio, .. } = self.options;
        Options {
            accuracy: self.accuracy.map_or(accuracy, |accuracy| accuracy.0),
            time_step: self.time_step.map(|step| step.0).or(time_step),
            own_mass: self.own_mass.map(|mass| mass.0).or(own_mass),
            other_own_mass: self.other_own_mass.map(|mass| mass.0).or(other_own_mass),
            diagonal_ratio: self.diagonal_ratio.map(|ratio| ratio.0).or(diagonal_ratio),
            ..self.options
        }
    }

    /// Checks the units of stiffness and speed: units of rotation for a joint that turns, units of translation
    /// otherwise, and units of a linear spring only with exponent 1.
    ///
    /// # Errors
    /// [`StudyError`] with the field and the expected unit.
    pub fn check_units(&self, turns: bool) -> Result<(), StudyError> {
        self.check_dimensions("damping.stiffness", "damping.speed", turns)
    }

    /// As [`check_units`](Self::check_units), with the fields of the stiffness and the speed.
    pub(crate) fn check_dimensions(
        &self,
        stiffness: &'static str,
        speed: &'static str,
        turns: bool,
    ) -> Result<(), StudyError> {
        let exponent = self.exponent();
        let given_stiffness = self.stiffness.and_then(|given| given.0.dimension);
        let given_speed = self.speed.and_then(|given| given.0.dimension);
        if given_stiffness.is_some() && exponent != 1.0 {
            let why = format!(
                "its unit is that of a linear spring; with the exponent {exponent} a plain number in N/m^{exponent} is expected \
                 (1 N/mm^{exponent} is {:e} N/m^{exponent})",
                1e3_f64.powf(exponent)
            );
            return Err(StudyError::input(stiffness, why));
        }
        let of_stiffness = if turns { Dimension::RotationalStiffness } else { Dimension::Stiffness };
        let of_speed = if turns { Dimension::AngularSpeed } else { Dimension::Speed };
        for (field, given, expected) in
            [(stiffness, given_stiffness, of_stiffness), (speed, given_speed, of_speed)]
        {
            if given.is_some_and(|dimension| dimension != expected) {
                let (motion, unit) = (if turns { "a rotation" } else { "a translation" }, expected.si_unit());
                let why = format!("its unit is not that of {motion}; expected {unit}");
                return Err(StudyError::input(field, why));
            }
        }
        Ok(())
    }
}
