//! Input of an impact, in addition to its contact.

use crate::question::damping_question::DampingQuestion;
use crate::values::rates::GivenRates;

/// Restitution, motion before the impact, and additional requests.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactQuestion {
    /// Coefficient of restitution e, from 0 to 1.
    pub restitution: f64,
    /// Closing speed, m/s; `None` if the rates give it.
    pub speed: Option<f64>,
    /// Coefficient of friction, for a contact of one relative motion; `None` without friction.
    pub friction: Option<f64>,
    /// Rates of driving joints before the impact; empty for the motion of least energy.
    pub rates: Vec<(String, GivenRates)>,
    /// Velocity of a floating base before the impact: angular, then that of the root's origin, world axes.
    pub base_twist: Option<[f64; 6]>,
    /// Contact law for peak forces; its restitution and speed are those of the impact.
    pub law: Option<DampingQuestion>,
    /// Largest permitted jumps of joint rates.
    pub rate_limits: Vec<(String, GivenRates)>,
    /// Joints whose reflected inertia is requested.
    pub reflected: Vec<String>,
    /// Joints whose centre of percussion is requested, along a line (axes of the contact link) or in the tangent plane.
    pub percussion: Vec<PercussionRequest>,
}

/// Request of a centre of percussion.
#[derive(Clone, Debug, PartialEq)]
pub struct PercussionRequest {
    /// Joint with the least impulse.
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
