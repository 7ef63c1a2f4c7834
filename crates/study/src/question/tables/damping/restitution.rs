//! Question about the restitution of a given spring and damper, or of given parameters of a simulator.

use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::tables::damping::SeparationName;
#[cfg(feature = "flags")]
use crate::question::tables::headings::IMPACT;
use crate::values::force_curve::GivenCurve;
use crate::values::quantities::{Damping, Force, Plain, Speed, Stiffness};
use crate::values::value;
use percuss_contact::exports::{ContactModel, ExportError, SimulatedContact, Tool};
use percuss_contact::{CompliantContact, Damper, Separation};
use percuss_units::{Dimension, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::str::FromStr;

/// Parameter of a simulator: `name=value` or `name=value,value`.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolParameter {
    name: String,
    values: Vec<f64>,
}

impl FromStr for ToolParameter {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let (name, values) = text.split_once('=').ok_or("expected NAME=VALUE or NAME=VALUE,VALUE")?;
        let number =
            |value: &str| value.trim().parse::<f64>().map_err(|_| format!("\"{value}\" is not a number"));
        let values = values.split(',').map(number).collect::<Result<_, _>>()?;
        Ok(Self { name: name.trim().to_owned(), values })
    }
}

/// Reads a table of parameters, each a number or a list of numbers.
fn parameters<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Vec<ToolParameter>, D::Error> {
    let lists = value::by_name::<D, value::OneOrMany<f64>>(from)?.into_iter();
    Ok(lists.map(|(name, values)| ToolParameter { name, values: values.list() }).collect())
}

/// Spring and damper, or parameters of a simulator, whose restitution is asked.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = IMPACT))]
#[serde(deny_unknown_fields, default)]
pub struct RestitutionQuestion {
    /// Approach speeds (m/s), separated by commas.
    ///
    /// The result has a row for each. Units: m/s, mm/s, km/h.
    #[cfg_attr(feature = "flags", arg(long, value_name = "V", value_delimiter = ','))]
    #[serde(deserialize_with = "value::one_or_many")]
    #[schemars(with = "Option<value::OneOrMany<value::NumberOrText>>", required)]
    pub speed: Vec<Speed>,
    /// Stiffness of the contact (N/m; 200N/mm).
    ///
    /// Units: N/m, N/mm, kN/m, kN/mm, lbf/in; with an exponent p the number is in N/m^p.
    #[cfg_attr(feature = "flags", arg(long, value_name = "K", conflicts_with = "tool"))]
    pub stiffness: Option<Stiffness>,
    /// Force curve of the contact in place of a stiffness: a file, points or powers.
    ///
    /// As --stiffness-curve of `percuss damp`. Default without a stiffness: the curve of the stop in a suspension sheet.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "CURVE", value_parser = GivenCurve::read, conflicts_with_all = ["stiffness", "exponent", "tool"])
    )]
    pub stiffness_curve: Option<GivenCurve>,
    /// Exponent p of the spring force k x^p; default 1.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", requires = "stiffness"))]
    pub exponent: Option<Plain>,
    /// Damping c of k x^p + c x^((p-1)/2) v, or beside a force curve (N·s/m).
    ///
    /// Units: N·s/m, N·s/mm; with an exponent p the number is in N·s/m^((p+1)/2).
    #[cfg_attr(feature = "flags", arg(long, value_name = "C", conflicts_with = "tool"))]
    pub damping: Option<Damping>,
    /// Dissipation d of k x^p (1 + d v), s/m.
    #[cfg_attr(feature = "flags", arg(long, value_name = "D", conflicts_with_all = ["damping", "tool"]))]
    pub hunt_crossley: Option<Plain>,
    /// Loss factor η of F (1 + (π/2) η sgn v), F = k x^p or a force curve.
    ///
    /// Energy lost in a full cycle over 2π times the largest stored energy, from 0 to less than 2/π = 0.6366; for one compression and return
    /// the lost over π times the stored energy.
    #[cfg_attr(feature = "flags", arg(long, value_name = "ETA", conflicts_with_all = ["damping", "hunt_crossley", "tool"]))]
    pub loss_factor: Option<Plain>,
    /// End of the contact: when the force vanishes (the default), or when the gap closes.
    #[cfg_attr(feature = "flags", arg(long, value_enum, requires = "damping"))]
    pub separation: Option<SeparationName>,
    /// Simulator of the parameters (damp --list-tools).
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", requires = "parameter"))]
    pub tool: Option<String>,
    /// Parameter of the simulator, NAME=VALUE or NAME=VALUE,VALUE; repeat it for each.
    ///
    /// The names are those of `percuss damp --for NAME`: solref=-1e4,-50.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME=VALUE", requires = "tool"))]
    #[serde(deserialize_with = "parameters")]
    #[schemars(with = "Option<BTreeMap<String, value::OneOrMany<f64>>>")]
    pub parameter: Vec<ToolParameter>,
    /// Force (N) for the penetration at rest.
    #[cfg_attr(feature = "flags", arg(long, value_name = "F"))]
    pub load: Option<Force>,
}

impl RestitutionQuestion {
    /// Checks the keys.
    ///
    /// # Errors
    /// [`InvalidKey`]: neither or both of a stiffness and a simulator, a value out of range, or no speed.
    pub fn check(&self) -> Result<(), InvalidKey> {
        let refuse = |key, why: String| Err(InvalidKey::with_names(key, why));
        let expected = "give `stiffness` or `stiffness_curve` with `damping`, `hunt_crossley` or `loss_factor`, or `tool` with `parameter`";
        let has_stiffness = self.stiffness.is_some() || self.stiffness_curve.is_some();
        if has_stiffness && self.tool.is_some() {
            return refuse("restitution.tool", format!("a stiffness is given too; {expected}"));
        }
        if self.stiffness_curve.is_some() && (self.stiffness.is_some() || self.exponent.is_some()) {
            return refuse(
                "restitution.stiffness_curve",
                "a stiffness or an exponent is given too; remove one".into(),
            );
        }
        if self.exponent.is_some() && self.stiffness.is_none() {
            return refuse(
                "restitution.exponent",
                "it is the exponent of a stiffness; give `stiffness` too".into(),
            );
        }
        let [damping, dissipation, loss_factor] =
            [self.damping.is_some(), self.hunt_crossley.is_some(), self.loss_factor.is_some()];
        if damping && dissipation {
            return refuse("restitution.hunt_crossley", "`damping` is given too; remove one".into());
        }
        if loss_factor && (damping || dissipation) {
            return refuse(
                "restitution.loss_factor",
                "`damping` or `hunt_crossley` is given too; remove one".into(),
            );
        }
        if self.speed.is_empty() {
            return refuse("restitution.speed", "it is missing; give at least one approach speed".into());
        }
        if let Some(given) =
            self.speed.iter().find(|speed| !(speed.0.value.is_normal() && speed.0.value > 0.0))
        {
            return refuse("restitution.speed", format!("{:?}; expected a speed above 0", given.0.value));
        }
        let is_of_rotation =
            |given: Quantity, expected| given.dimension.is_some_and(|found| found != expected);
        if self.speed.iter().any(|speed| is_of_rotation(speed.0, Dimension::Speed)) {
            return refuse("restitution.speed", "its unit is not that of a translation; expected m/s".into());
        }
        if let Some(given) = self.stiffness
            && (is_of_rotation(given.0, Dimension::Stiffness)
                || given.0.dimension.is_some() && self.exponent() != 1.0)
        {
            let why = "its unit is not that of this contact; expected N/m, or a plain number in N/m^p with an exponent p";
            return refuse("restitution.stiffness", why.into());
        }
        if self.tool.is_some() && (damping || dissipation || loss_factor || self.exponent.is_some()) {
            return refuse("restitution.tool", format!("the spring or the damper is given too; {expected}"));
        }
        if self.separation.is_some() && self.damping.is_none() {
            return refuse(
                "restitution.separation",
                "it is the end of a contact with `damping`; remove it, or give that".into(),
            );
        }
        let damping = self.damping.map(|damping| damping.0.value);
        let dissipation = self.hunt_crossley.map(|dissipation| dissipation.0);
        let loss_factor = self.loss_factor.map(|loss_factor| loss_factor.0);
        for (key, given) in [
            ("restitution.damping", damping),
            ("restitution.hunt_crossley", dissipation),
            ("restitution.loss_factor", loss_factor),
        ] {
            if let Some(given) = given.filter(|given| !(given.is_finite() && *given >= 0.0)) {
                return refuse(key, format!("{given:?}; expected a number of 0 or above"));
            }
        }
        if let Some(given) = self.damping
            && (is_of_rotation(given.0, Dimension::Damping)
                || given.0.dimension.is_some() && self.exponent() != 1.0)
        {
            let why = "its unit is not that of this contact; expected N·s/m, or a plain number in N·s/m^((p+1)/2) with an exponent p";
            return refuse("restitution.damping", why.into());
        }
        if let Some(load) = self.load.filter(|load| !(load.0.is_finite() && load.0 >= 0.0)) {
            return refuse("restitution.load", format!("{:?}; expected a force of 0 or above", load.0));
        }
        Ok(())
    }

    fn exponent(&self) -> f64 {
        self.exponent.map_or(1.0, |exponent| exponent.0)
    }

    /// True if a stiffness, a force curve or a simulator is given.
    pub(crate) fn has_law(&self) -> bool {
        self.stiffness.is_some() || self.stiffness_curve.is_some() || self.tool.is_some()
    }

    /// Contacts with an effective mass, kg: that of the spring and damper, or one for each solver of the simulator.
    ///
    /// # Errors
    /// [`StudyError`]: a number out of range, an unknown simulator or an invalid parameter.
    pub(crate) fn contacts(&self, mass: f64) -> Result<Vec<SimulatedContact<'_>>, StudyError> {
        if !self.has_law() {
            let why = "nothing is given; give `stiffness` or `stiffness_curve` with `damping`, `hunt_crossley` or `loss_factor`, or `tool` with `parameter`";
            return Err(InvalidKey::with_names("restitution", why.into()).into());
        }
        if let Some(name) = &self.tool {
            let parameters = self.parameter.iter().map(|given| (given.name.clone(), given.values.clone()));
            let contacts =
                Tool::from_name(name).and_then(|tool| tool.simulated(mass, &parameters.collect::<Vec<_>>()));
            return contacts.map_err(|error| match error {
                ExportError::Contact(error) => error.into(),
                ExportError::UnknownTool { .. } => {
                    InvalidKey::new("restitution.tool", error.to_string()).into()
                }
                _ => InvalidKey::new("restitution.parameter", error.to_string()).into(),
            });
        }
        let contact = match &self.stiffness_curve {
            Some(given) => CompliantContact::on_curve(mass, &given.curve)?,
            None => {
                let stiffness = self.stiffness.map_or(f64::NAN, |given| given.0.value);
                CompliantContact::new(mass, stiffness)?.with_exponent(self.exponent())?
            }
        };
        let damper = match (self.hunt_crossley, self.loss_factor) {
            (Some(dissipation), _) => Damper::hunt_crossley(dissipation.0)?,
            (_, Some(loss_factor)) => Damper::loss_factor(loss_factor.0)?,
            (None, None) => {
                let separation = self.separation.map_or(Separation::ForceVanishes, Separation::from);
                let damping = self.damping.map_or(0.0, |damping| damping.0.value);
                Damper::kelvin_voigt_from_coefficient(contact, damping, separation)?
            }
        };
        Ok(vec![SimulatedContact::of(ContactModel::Compliant(contact, damper))])
    }
}
