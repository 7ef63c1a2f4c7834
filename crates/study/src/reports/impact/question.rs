//! Input of an impact, in addition to its contact.

use crate::question::damping_question::DampingQuestion;
use crate::question::spelled_contact::FurtherContact;
use crate::values::drives::{GivenGearLimits, GivenSpring};
use crate::values::rates::GivenRates;
use percuss_impact::RestitutionLaw;
use percuss_units::Dimension;

/// Restitution, motion before the impact, and additional requests.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactQuestion {
    /// Coefficient of restitution e, from 0 to 1.
    pub restitution: f64,
    /// Closing speed, m/s (rad/s for a moment); `None` if the rates give it.
    pub speed: Option<f64>,
    /// Dimensions of the units in which the closing speed and the stiffness of `law` were given, in this order; `None` for plain numbers.
    /// Required: dimensions of rotation for a moment, and of translation for other contacts.
    pub dimensions: [Option<Dimension>; 2],
    /// Coefficient of friction; `None` without friction.
    pub friction: Option<f64>,
    /// Meaning of the coefficient of restitution with friction.
    pub restitution_law: RestitutionLaw,
    /// Further contacts that touch at the same time.
    pub also: Vec<FurtherContact>,
    /// Coefficient of restitution of each further contact; empty for that of the first.
    pub also_restitution: Vec<f64>,
    /// True for a plastic impact with sticking points, in addition.
    pub sticking: bool,
    /// Stiffness of each contact relative to the first, of the energetic law of several contacts; empty for equal ones.
    pub stiffness_ratios: Vec<f64>,
    /// Exponent of the contact forces of the energetic law; `None` for 1.
    pub contact_exponent: Option<f64>,
    /// Rates of driving joints before the impact; empty for the motion of least energy.
    pub rates: Vec<(String, GivenRates)>,
    /// Velocity of a floating base before the impact: angular, then that of the root's origin, world axes.
    pub base_twist: Option<[f64; 6]>,
    /// Contact law for peak forces; its restitution and speed are those of the impact.
    pub law: Option<DampingQuestion>,
    /// True for the impact in time with this law, in addition.
    pub in_time: bool,
    /// Gravity during the impact in time, world axes, m/s²; `None` for none.
    pub gravity: Option<[f64; 3]>,
    /// Springs and dampers of joints during the impact in time.
    pub joint_springs: Vec<(String, GivenSpring)>,
    /// Largest permitted jumps of joint rates.
    pub rate_limits: Vec<(String, GivenRates)>,
    /// Largest permitted impulses or torques in gears.
    pub gear_limits: Vec<(String, GivenGearLimits)>,
    /// Largest displacement of the contact point in the tangent plane, m: adds the worst impulse at the joints of `percussion`.
    pub point_error: Option<f64>,
    /// Joints whose reflected inertia is requested, by name, or over a range of positions as `JOINT=FROM:TO:COUNT`.
    pub reflected: Vec<String>,
    /// Bearings whose centre of percussion is requested, along a line (axes of the contact link) or in the tangent plane.
    pub percussion: Vec<PercussionRequest>,
}

/// Request of a centre of percussion.
#[derive(Clone, Debug, PartialEq)]
pub struct PercussionRequest {
    /// Bearing with the least impulse: name of a joint or of a closure, or `ground` for the ground under the root link.
    pub joint: String,
    /// Direction of the line, axes of the contact link; `None` for the tangent plane.
    pub direction: Option<[f64; 3]>,
}

impl std::str::FromStr for PercussionRequest {
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
