//! Question about a rigid impact, in addition to its contact.

use super::damping::{DampingQuestion, LawName, SeparationName};
#[cfg(feature = "flags")]
use super::headings::{ADDITIONAL, IMPACT};
use crate::question::errors::refusal::InvalidKey;
use crate::question::spelled_contact::FurtherContact;
use crate::values::drives::{self, GivenGearLimits, GivenSpring};
use crate::values::force_curve::GivenCurve;
#[cfg(feature = "flags")]
use crate::values::named;
use crate::values::point_force::{GivenDrive, GivenPointDamper, GivenPointSpring};
use crate::values::quantities::{Damping, Length, Plain, Ratio, Speed, Stiffness};
use crate::values::rates::GivenRates;
use crate::values::value::{self, NumberOrText, PositionText, Words};
use percuss_impact::RestitutionLaw;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::str::FromStr;

/// Law of restitution of an impact with friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum RestitutionLawName {
    /// Stronge: e² of the work of compression is returned.
    #[default]
    Energetic,
    /// Poisson: e times the impulse of compression.
    Poisson,
    /// Newton: e times the closing speed.
    Newton,
    /// Newton, with the friction of the first sliding or no sliding after the impact.
    Algebraic,
}

impl RestitutionLawName {
    /// All laws.
    pub const ALL: [Self; 4] = [Self::Energetic, Self::Poisson, Self::Newton, Self::Algebraic];

    /// The law.
    pub fn law(self) -> RestitutionLaw {
        match self {
            Self::Energetic => RestitutionLaw::Energetic,
            Self::Poisson => RestitutionLaw::Poisson,
            Self::Newton => RestitutionLaw::Newton,
            Self::Algebraic => RestitutionLaw::Algebraic,
        }
    }
}

/// Springs of the suspension sheet during an impact in time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum SheetSprings {
    /// The change of their forces since the touch.
    #[default]
    Change,
    /// Their whole forces, with the preload of the sheet.
    Full,
    /// Left out.
    None,
}

/// Request of a centre of percussion.
#[derive(Clone, Debug, PartialEq)]
pub struct PercussionRequest {
    /// Bearing with the least impulse: name of a joint or of a closure, or `ground` for the ground under the root link.
    pub joint: String,
    /// Direction of the line, axes of the contact link; `None` for the tangent plane.
    pub direction: Option<[f64; 3]>,
}

impl FromStr for PercussionRequest {
    type Err = String;
    /// Reads `JOINT` or `JOINT:X,Y,Z`.
    fn from_str(text: &str) -> Result<Self, String> {
        let Some((joint, direction)) = text.rsplit_once(':') else {
            return Ok(Self { joint: text.to_owned(), direction: None });
        };
        let direction = percuss_units::parse_triple(direction, percuss_units::Dimension::Plain);
        let direction = direction.map_err(|error| format!("JOINT or JOINT:X,Y,Z is expected: {error}"))?;
        Ok(Self { joint: joint.to_owned(), direction: Some(direction) })
    }
}

/// Rigid impact at the contact: impulse, rates after the impact, and reactions.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = IMPACT))]
#[serde(deny_unknown_fields, default)]
pub struct ImpactQuestion {
    /// Coefficient of restitution, from 0 to 1.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "E", required_unless_present_any = ["reflected", "damping", "hunt_crossley", "loss_factor"])
    )]
    #[schemars(required)]
    pub restitution: Option<Ratio>,
    /// Damping of the contact, in place of a restitution: c of k x^p + c x^((p-1)/2) v, or beside a force curve (N·s/m).
    ///
    /// The restitution is that of this damping for the effective mass at the touch and the closing speed. Units: N·s/m, N·s/mm; with an
    /// exponent p the number is in N·s/m^((p+1)/2).
    #[cfg_attr(feature = "flags", arg(long, value_name = "C", conflicts_with_all = ["restitution", "law", "reach"]))]
    pub damping: Option<Damping>,
    /// Dissipation of the contact, in place of a restitution: d of k x^p (1 + d v), or of a force curve (s/m).
    #[cfg_attr(feature = "flags", arg(long, value_name = "D", conflicts_with_all = ["restitution", "damping", "law", "reach"]))]
    pub hunt_crossley: Option<Plain>,
    /// Loss factor of the contact, in place of a restitution: η of F (1 + (π/2) η sgn v), F = k x^p or a force curve.
    ///
    /// Energy lost in a full cycle over 2π times the largest stored energy, from 0 to less than 2/π = 0.6366.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "ETA", conflicts_with_all = ["restitution", "damping", "hunt_crossley", "law", "reach"])
    )]
    pub loss_factor: Option<Plain>,
    /// Closing speed before the impact (m/s, km/h).
    ///
    /// Without rates, the motion of least energy with this speed is assumed. With rates, the speed follows from them; a given
    /// speed must agree, unless the other side is a free body.
    #[cfg_attr(feature = "flags", arg(long, value_name = "V"))]
    pub speed: Option<Speed>,
    /// Coefficient of friction (Coulomb).
    ///
    /// The restitution is the energetic one of Stronge (--restitution-law). Sliding, sticking and jamming are found; the sliding
    /// before the impact is that of the rates. Reactions include the friction.
    #[cfg_attr(feature = "flags", arg(long, value_name = "MU"))]
    pub friction: Option<Plain>,
    /// Law of restitution with friction: energetic, poisson, newton, algebraic.
    ///
    /// All laws are printed side by side. Newton's law and its algebraic form can create energy.
    #[cfg_attr(feature = "flags", arg(long, value_enum, requires = "friction"))]
    pub restitution_law: Option<RestitutionLawName>,
    /// Further contact at the same time: NAME, LINK:X,Y,Z:NX,NY,NZ, a moment, a cable, or JOINT:upper.
    ///
    /// A contact of the model; a point (link's frame) with its normal (out of the link, world axes); a moment LINK:about:X,Y,Z about an
    /// axis (link's frame); a cable LINK:X,Y,Z=LINK:X,Y,Z between two links; or the stop JOINT:lower or JOINT:upper. A point or a moment
    /// acts against the ground, or with =OTHER at the end against the link OTHER. The report has the laws of Newton and Poisson and the
    /// energetic law for all contacts, without friction, and the Delassus matrix.
    #[cfg_attr(feature = "flags", arg(long, value_name = "CONTACT", help_heading = ADDITIONAL))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub also: Vec<FurtherContact>,
    /// Coefficient of restitution of each further contact; default: that of the first.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "E,E,…", value_delimiter = ',', requires = "also", help_heading = ADDITIONAL)
    )]
    pub also_restitution: Vec<f64>,
    /// Plastic impact in which the contact points stick.
    ///
    /// Adds the impulses, the contacts that let go, the friction that sticking needs, and the impact map.
    #[cfg_attr(feature = "flags", arg(long, help_heading = ADDITIONAL))]
    pub sticking: bool,
    /// Stiffness of the contacts relative to the first, in the energetic law of several contacts.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "R,R,…", value_delimiter = ',', requires = "also", help_heading = ADDITIONAL)
    )]
    pub stiffness_ratio: Vec<f64>,
    /// Exponent of the contact forces in the energetic law of several contacts (1; 1.5 for spheres).
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", requires = "also", help_heading = ADDITIONAL))]
    pub contact_exponent: Option<Plain>,
    /// Rate of a driving joint before the impact.
    ///
    /// The other joints follow from the loops. The given joints must determine all others. Units: rad/s, deg/s, rpm, m/s.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=RATE", allow_hyphen_values = true, value_parser = named::joint_rates)
    )]
    #[serde(deserialize_with = "rates")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub rates: Vec<(String, GivenRates)>,
    /// Velocity of a floating base before the impact: rad/s, then m/s of its origin, world axes.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "WX,WY,WZ,VX,VY,VZ", allow_hyphen_values = true, value_delimiter = ',')
    )]
    pub base_twist: Vec<f64>,
    /// Stiffness of the contact (N/m; 200N/mm): adds peak forces of all bearings.
    ///
    /// Default: the force curve of the stop in a suspension sheet, if any. Peak force of a bearing: its reaction per impulse of the contact, times the peak force of the contact.
    #[cfg_attr(feature = "flags", arg(long, value_name = "K"))]
    pub stiffness: Option<Stiffness>,
    /// Table of deflection and force of the contact, in place of a stiffness.
    ///
    /// Two columns, CSV; units at the numbers or in brackets in a header, otherwise m and N. Linear between the points; beyond the last
    /// point the last slope continues. Default: the curve of the stop in a suspension sheet.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "FILE", value_parser = GivenCurve::read, conflicts_with_all = ["stiffness", "exponent"])
    )]
    pub stiffness_curve: Option<GivenCurve>,
    /// Exponent p of the spring force k x^p.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", requires = "stiffness"))]
    pub exponent: Option<Plain>,
    /// Contact law (damp --list-laws); default: kelvin-voigt, on a force curve hunt-crossley.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME"))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub law: Option<LawName>,
    /// Impact in time with the contact law: force, penetration, speeds and bearing forces.
    ///
    /// The equations of motion of the whole mechanism, without friction. Adds the restitution that is reached, the change of the
    /// effective mass, and the peak force of every bearing beside its estimate.
    #[cfg_attr(feature = "flags", arg(long, conflicts_with = "friction"))]
    pub in_time: bool,
    /// Also with the elastic bushes and gears of the model: their forces, and the impact of the compliant mechanism.
    ///
    /// Linear about the touch, from the motion of the rigid mechanism. Bushes are those of the suspension sheet, gears those of
    /// --gear-stiffness. Springs, dampers, tyre, drives and gravity act as in the impact of the rigid mechanism; the contact has the same law and
    /// damping.
    #[cfg_attr(feature = "flags", arg(long, requires = "in_time"))]
    pub compliance: bool,
    /// Damping with which the impact in time reaches the restitution.
    ///
    /// With springs, dampers, tyre, drives and gravity as they act, and the effective mass over the stroke. Without it, the damping is that of
    /// `percuss damp`, for the contact alone and the effective mass at the touch.
    #[cfg_attr(feature = "flags", arg(long, requires = "in_time"))]
    pub reach: bool,
    /// Gravity during the impact in time (m/s², world axes); default: none.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "X,Y,Z",
            allow_hyphen_values = true,
            value_delimiter = ',',
            requires = "in_time"
        )
    )]
    pub gravity: Vec<f64>,
    /// Spring and damper of a joint during the impact in time: K, K,D or K,D,FREE.
    ///
    /// Stiffness (N·m/rad, N·m/deg, N/m), damping (N·m·s/rad, N·s/m), and the position without force (rad, deg, m); default: that at the
    /// touch. Numbers without units are in SI units.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT=K,D", value_parser = named::joint_spring, requires = "in_time"))]
    #[serde(deserialize_with = "drives::by_joint")]
    #[schemars(with = "BTreeMap<String, value::OneOrMany<NumberOrText>>")]
    pub joint_spring: Vec<(String, GivenSpring)>,
    /// Springs and dampers of the suspension sheet and of the joints of a model during the impact in time: change, full, none.
    ///
    /// change (the default): the change of the spring forces since the touch; the forces at the touch are in balance with weight, tyre and
    /// other loads. full: the whole forces, with the preload of the sheet or the position without force of a joint, without a load that balances them. Dampers have their whole forces.
    /// none: left out.
    #[cfg_attr(feature = "flags", arg(long, value_enum, requires = "in_time"))]
    pub springs: Option<SheetSprings>,
    /// Spring between two points during the impact in time: LINK:X,Y,Z=LINK:X,Y,Z=RATE[=FREE].
    ///
    /// A link without a point has its origin. RATE in N/m or with a unit; FREE is the length without force; default: the length at the touch,
    /// so that only the change of the force acts. May be repeated.
    #[cfg_attr(feature = "flags", arg(long, value_name = "A=B=RATE", requires = "in_time"))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub spring: Vec<GivenPointSpring>,
    /// Damper between two points during the impact in time: LINK:X,Y,Z=LINK:X,Y,Z=DAMPING.
    ///
    /// DAMPING in N·s/m or with a unit; or the force over the speed, SPEED:FORCE,SPEED:FORCE,… (m/s and N or with units), positive in rebound,
    /// linear between the points. May be repeated. The dampers of a suspension sheet act by default.
    #[cfg_attr(feature = "flags", arg(long, value_name = "A=B=DAMPING", requires = "in_time"))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub damper: Vec<GivenPointDamper>,
    /// Constant force of a drive during the impact in time: JOINT=TORQUE, or A=B=FORCE between two points.
    ///
    /// On a joint with one velocity, positive in its direction (N·m, N); or a force (N) that pushes two points apart,
    /// LINK:X,Y,Z=LINK:X,Y,Z=FORCE. The report states the effective weight of absorber catalogues, m̄ + 2W/v², with the work W of the drives
    /// until the largest penetration. May be repeated.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT=TORQUE", requires = "in_time"))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub drive: Vec<GivenDrive>,
    /// Reflected inertia at a joint, free and held.
    ///
    /// Free: all other joints move. Held: the other driving joints are at rest. JOINT=FROM:TO:COUNT gives the inertia over a range of
    /// positions, and two substitutes for simulators without loops with their errors: the best constant armature, and mimic joints with an
    /// armature. Reflected inertias require neither a contact nor --restitution.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT", allow_hyphen_values = true, help_heading = ADDITIONAL))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub reflected: Vec<String>,
    /// Contact point with the least impulse in a joint, a closure or the ground.
    ///
    /// JOINT: point in the tangent plane. JOINT:X,Y,Z: point on a line through the contact point (axes of the contact link). JOINT is the
    /// name of a joint or of a loop closure, or the word ground for the reaction of the ground on the root link.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT[:X,Y,Z]", help_heading = ADDITIONAL))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub percussion: Vec<PercussionRequest>,
    /// Largest jump of a joint rate: greatest closing speed.
    ///
    /// Units: rad/s, deg/s, rpm, m/s.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=RATE", value_parser = named::joint_rates, help_heading = ADDITIONAL)
    )]
    #[serde(deserialize_with = "rates")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub rate_limit: Vec<(String, GivenRates)>,
    /// Largest impulse (N·m·s, N·s) or torque (N·m, N) in a gear: greatest closing speed.
    ///
    /// The gear transmits the impulse armature · jump of the rate. Its peak torque is this impulse per unit impulse of the contact, times the
    /// peak force of the contact; this requires the stiffness of the contact. A number without a unit is an impulse. One value, or one value
    /// per velocity, separated by commas.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=LIMIT", value_parser = named::gear_limit, help_heading = ADDITIONAL)
    )]
    #[serde(deserialize_with = "drives::by_joint")]
    #[schemars(with = "BTreeMap<String, value::OneOrMany<NumberOrText>>")]
    pub gear_limit: Vec<(String, GivenGearLimits)>,
    /// Largest displacement of the contact point: worst impulse at the joints of --percussion.
    ///
    /// The point is displaced in the tangent plane, in the worst direction (m; 5mm).
    #[cfg_attr(feature = "flags", arg(long, value_name = "DISTANCE", requires = "percussion", help_heading = ADDITIONAL))]
    pub point_error: Option<Length>,
    /// End of the contact of the law; no key gives it.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(skip)]
    pub separation: Option<SeparationName>,
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

impl ImpactQuestion {
    /// Checks the keys.
    ///
    /// # Errors
    /// [`InvalidKey`]: missing restitution, keys without an effect, or a law that contradicts the exponent.
    pub fn check(&self) -> Result<(), InvalidKey> {
        let refuse = |key, why: &'static str| Err(InvalidKey::new(key, why));
        let damping = self.damping.map(|damping| damping.0.value);
        let given = [
            ("impact.damping", damping),
            ("impact.hunt_crossley", self.hunt_crossley.map(|d| d.0)),
            ("impact.loss_factor", self.loss_factor.map(|loss| loss.0)),
        ];
        let given = given.iter().filter_map(|(key, value)| Some((*key, (*value)?)));
        let given: Vec<(&'static str, f64)> = given.collect();
        match (self.restitution, &given[..]) {
            (None, []) => {
                return refuse("impact.restitution", "it is missing; expected a number from 0 to 1");
            }
            (_, [_, (key, _), ..]) => return refuse(key, "another damping is given too; remove one"),
            (Some(_), [(key, _)]) => return refuse(key, "`restitution` is given too; remove one"),
            (None, [(key, value)]) if !(value.is_finite() && *value >= 0.0) => {
                return refuse(key, "expected a number of 0 or above");
            }
            (None, [(key, _)]) if self.law.is_some() || self.reach => {
                return refuse(key, "it gives the law and the damping; remove `law` and `reach`");
            }
            _ => {}
        }
        let has = |numbers: &[f64], count| numbers.len() == count && numbers.iter().all(|x| x.is_finite());
        if !self.base_twist.is_empty() && !has(&self.base_twist, 6) {
            return refuse("impact.base_twist", "six finite numbers are expected: WX,WY,WZ,VX,VY,VZ");
        }
        if !self.also_restitution.is_empty() && self.also_restitution.len() != self.also.len() {
            return refuse("impact.also_restitution", "one number for each contact of `also` is expected");
        }
        if self.also_restitution.iter().any(|e| !(0.0..=1.0).contains(e)) {
            return refuse("impact.also_restitution", "numbers from 0 to 1 are expected");
        }
        if !self.gravity.is_empty() && !has(&self.gravity, 3) {
            return refuse("impact.gravity", "three finite numbers are expected: X,Y,Z in m/s²");
        }
        if !self.gravity.is_empty() && !self.in_time {
            return refuse("impact.gravity", "it requires `in_time`: a rigid impact is instantaneous");
        }
        if self.stiffness_curve.is_some() && (self.stiffness.is_some() || self.exponent.is_some()) {
            return refuse(
                "impact.stiffness_curve",
                "it is given beside `stiffness` or `exponent`; expected one of the two",
            );
        }
        if self.in_time && self.friction.is_some() {
            return refuse("impact.in_time", "the impact in time has no friction; expected no `friction`");
        }
        if !self.joint_spring.is_empty() && !self.in_time {
            return refuse("impact.joint_spring", "it requires `in_time`: a rigid impact is instantaneous");
        }
        let needs = [
            ("impact.springs", self.springs.is_some(), "in_time", self.in_time),
            ("impact.reach", self.reach, "in_time", self.in_time),
            ("impact.compliance", self.compliance, "in_time", self.in_time),
            ("impact.spring", !self.spring.is_empty(), "in_time", self.in_time),
            ("impact.damper", !self.damper.is_empty(), "in_time", self.in_time),
            ("impact.drive", !self.drive.is_empty(), "in_time", self.in_time),
            ("impact.restitution_law", self.restitution_law.is_some(), "friction", self.friction.is_some()),
            ("impact.exponent", self.exponent.is_some(), "stiffness", self.stiffness.is_some()),
            ("impact.stiffness_ratio", !self.stiffness_ratio.is_empty(), "also", !self.also.is_empty()),
            ("impact.contact_exponent", self.contact_exponent.is_some(), "also", !self.also.is_empty()),
        ];
        for (key, is_given, needed, is_there) in needs {
            if is_given && !is_there {
                let why = format!("it has no effect without `{needed}`");
                return Err(InvalidKey::with_names(key, why));
            }
        }
        if self.point_error.is_some() && self.percussion.is_empty() {
            return refuse("impact.point_error", "it requires `percussion`, the joints");
        }
        let law = self.contact_law(f64::NAN);
        let law = law.map_or(Ok(()), |law| law.check_law());
        law.map_err(|error| InvalidKey::new("impact.law", error.to_string()))
    }

    /// Coefficient of restitution e, from 0 to 1; NaN if it is missing.
    pub fn restitution(&self) -> f64 {
        self.restitution.map_or(f64::NAN, |restitution| restitution.0)
    }

    /// Closing speed, m/s (rad/s for a moment); `None` if the rates give it.
    pub fn speed(&self) -> Option<f64> {
        self.speed.map(|speed| speed.0.value)
    }

    /// Coefficient of friction; `None` without friction.
    pub fn friction(&self) -> Option<f64> {
        self.friction.map(|friction| friction.0)
    }

    /// Velocity of a floating base before the impact: angular, then that of the root's origin, world axes; `None` if it is not given.
    pub fn base_twist(&self) -> Option<[f64; 6]> {
        self.base_twist.as_slice().try_into().ok()
    }

    /// Gravity during the impact in time, world axes, m/s²; `None` for none.
    pub fn gravity(&self) -> Option<[f64; 3]> {
        self.gravity.as_slice().try_into().ok()
    }

    /// Contact law with the restitution of the impact at a closing speed; `None` without a stiffness and a force curve.
    pub(crate) fn contact_law(&self, closing_speed: f64) -> Option<DampingQuestion> {
        let Self { restitution, stiffness, exponent, law, separation, .. } = *self;
        let (speed, stiffness_curve) = (Some(closing_speed.into()), self.stiffness_curve.clone());
        (stiffness.is_some() || stiffness_curve.is_some()).then_some(DampingQuestion {
            restitution,
            stiffness,
            stiffness_curve,
            speed,
            exponent,
            law,
            separation,
            ..DampingQuestion::default()
        })
    }
}
