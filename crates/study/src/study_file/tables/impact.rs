//! Impact table of a study file.

use super::damping::LawName;
#[cfg(feature = "flags")]
use super::headings::{ADDITIONAL, IMPACT};
use crate::question::damping_question::{DampingQuestion, check_units};
use crate::question::errors::refusal::InvalidKey;
use crate::reports::impact::question::{ImpactQuestion, PercussionRequest};
#[cfg(feature = "flags")]
use crate::values::named;
use crate::values::quantities::{Plain, Ratio, Speed, Stiffness};
use crate::values::rates::GivenRates;
use crate::values::value::{self, PositionText, Words};
use percuss_contact::Law;
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Rigid impact at the contact: impulse, rates after the impact, and reactions.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct ImpactTable {
    /// Coefficient of restitution, from 0 to 1.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "E", required = true, allow_hyphen_values = true, help_heading = IMPACT)
    )]
    #[schemars(required)]
    pub restitution: Option<Ratio>,
    /// Closing speed before the impact (m/s, km/h).
    ///
    /// Without rates, the motion of least energy with this speed is assumed. With rates, the speed follows from them; a given
    /// speed must agree, unless the other side is a free body.
    #[cfg_attr(feature = "flags", arg(long, value_name = "V", allow_hyphen_values = true, help_heading = IMPACT))]
    pub speed: Option<Speed>,
    /// Coefficient of friction, for a linkage with one motion.
    ///
    /// Coulomb friction with the energetic restitution of Stronge, for a contact whose two sides have one relative motion, such
    /// as the stop of a suspension. Reactions include the friction.
    #[cfg_attr(feature = "flags", arg(long, value_name = "MU", allow_hyphen_values = true, help_heading = IMPACT))]
    pub friction: Option<Plain>,
    /// Rate of a driving joint before the impact.
    ///
    /// The other joints follow from the loops. The given joints must determine all others. Units: rad/s, deg/s, m/s.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "JOINT=RATE",
            allow_hyphen_values = true,
            value_parser = named::joint_rates,
            help_heading = IMPACT
        )
    )]
    #[serde(deserialize_with = "rates")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub rates: Vec<(String, GivenRates)>,
    /// Velocity of a floating base before the impact: rad/s, then m/s of its origin, world axes.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "WX,WY,WZ,VX,VY,VZ",
            allow_hyphen_values = true,
            value_delimiter = ',',
            help_heading = IMPACT
        )
    )]
    pub base_twist: Vec<f64>,
    /// Stiffness of the contact (N/m; 200N/mm): adds peak forces of all bearings.
    ///
    /// Peak force of a bearing: its reaction per impulse of the contact, times the peak force of the contact.
    #[cfg_attr(feature = "flags", arg(long, value_name = "K", allow_hyphen_values = true, help_heading = IMPACT))]
    pub stiffness: Option<Stiffness>,
    /// Exponent p of the spring force k x^p.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "P", allow_hyphen_values = true, requires = "stiffness", help_heading = IMPACT)
    )]
    pub exponent: Option<Plain>,
    /// Contact law (damp --list-laws).
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", requires = "stiffness", help_heading = IMPACT))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub law: Option<LawName>,
    /// Reflected inertia at a joint, free and held.
    ///
    /// Free: all other joints move. Held: the other driving joints are at rest.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT", help_heading = ADDITIONAL))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub reflected: Vec<String>,
    /// Contact point with the least impulse at a joint.
    ///
    /// JOINT: in the tangent plane. JOINT:X,Y,Z: along a line through the contact point (axes of the contact link).
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT[:X,Y,Z]", help_heading = ADDITIONAL))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub percussion: Vec<PercussionRequest>,
    /// Largest jump of a joint rate: greatest closing speed.
    ///
    /// Units: rad/s, deg/s, m/s.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=RATE", value_parser = named::joint_rates, help_heading = ADDITIONAL)
    )]
    #[serde(deserialize_with = "rates")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub rate_limit: Vec<(String, GivenRates)>,
}

/// Reads rates by joint.
fn rates<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Vec<(String, GivenRates)>, D::Error> {
    let given = |(joint, text): (String, PositionText)| {
        let rates = match text {
            PositionText::Text(text) => text.parse(),
            PositionText::One(x) => GivenRates::from_numbers(&[x]),
            PositionText::Many(xs) => GivenRates::from_numbers(&xs),
        };
        let rates = rates.map_err(|error| serde::de::Error::custom(format!("joint \"{joint}\": {error}")))?;
        Ok((joint, rates))
    };
    BTreeMap::<String, PositionText>::deserialize(from)?.into_iter().map(given).collect()
}

impl ImpactTable {
    /// Converts the table to a question.
    ///
    /// # Errors
    /// [`InvalidKey`]: a missing restitution, a speed in the unit of a rotation, a law that contradicts the exponent.
    pub fn question(&self) -> Result<ImpactQuestion, InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::new(key, why));
        let Some(Ratio(restitution)) = self.restitution else {
            return refuse("impact.restitution", "it is missing; expected a number from 0 to 1");
        };
        if self.speed.is_some_and(|speed| speed.0.dimension == Some(Dimension::AngularSpeed)) {
            return refuse("impact.speed", "the unit of a rotation; expected m/s, mm/s or km/h");
        }
        let base_twist = match <[f64; 6]>::try_from(self.base_twist.as_slice()) {
            Ok(twist) if twist.iter().all(|x| x.is_finite()) => Some(twist),
            _ if self.base_twist.is_empty() => None,
            _ => return refuse("impact.base_twist", "six finite numbers are expected: WX,WY,WZ,VX,VY,VZ"),
        };
        Ok(ImpactQuestion {
            restitution,
            speed: self.speed.map(|speed| speed.0.value),
            friction: self.friction.map(|friction| friction.0),
            rates: self.rates.clone(),
            base_twist,
            law: self.law(restitution)?,
            rate_limits: self.rate_limit.clone(),
            reflected: self.reflected.clone(),
            percussion: self.percussion.clone(),
        })
    }

    /// Contact law of the peak forces; `None` without a stiffness.
    fn law(&self, restitution: f64) -> Result<Option<DampingQuestion>, InvalidKey> {
        let Some(stiffness) = self.stiffness else { return Ok(None) };
        let mut law = DampingQuestion::new(restitution, stiffness.0.value);
        let name = self.law.as_ref().map_or(Law::KelvinVoigt.name(), |law| law.name());
        law.choose(name, self.exponent.map(|exponent| exponent.0), None)
            .map_err(|error| InvalidKey::new("impact.law", error.to_string()))?;
        check_units(&law, stiffness.0, None, false)
            .map_err(|error| InvalidKey::new("impact.stiffness", error.to_string()))?;
        Ok(Some(law))
    }
}
