//! Springs, dampers and drives between two points as given by the user.

use crate::values::quantities::{Force, Length, LinkPoint, Speed};
use percuss_contact::DamperCurve;
use percuss_units::{Dimension, Quantity};
use std::str::FromStr;
use std::sync::Arc;

/// Link and point (m, in the frame of the link) of each end.
pub(crate) type Ends = [(String, [f64; 3]); 2];

/// Ends of a line; a link without a point has its origin.
fn ends(a: &str, b: &str) -> Ends {
    [a, b].map(|text| match text.parse::<LinkPoint>() {
        Ok(point) => (point.link, point.point.0),
        Err(_) => (text.to_owned(), [0.0; 3]),
    })
}

/// Parts between the equal signs.
fn parts(text: &str) -> Vec<&str> {
    text.split('=').map(str::trim).collect()
}

/// Spring between two points of links: `LINK=LINK=RATE` or `LINK:X,Y,Z=LINK:X,Y,Z=RATE=FREE`.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPointSpring {
    pub(crate) ends: Ends,
    /// N/m.
    pub(crate) rate: f64,
    /// Length without force, m; `None`: the length at the touch.
    pub(crate) free_length: Option<f64>,
}

impl FromStr for GivenPointSpring {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let (a, b, rate, free) = match parts(text)[..] {
            [a, b, rate] => (a, b, rate, None),
            [a, b, rate, free] => (a, b, rate, Some(free)),
            _ => {
                return Err("expected LINK:X,Y,Z=LINK:X,Y,Z=RATE or …=RATE=FREE, such as spring_seat=spring_chassis_seat=30N/mm".into());
            }
        };
        let rate = Dimension::Stiffness.parse(rate).map_err(|error| error.to_string())?.value;
        let free = free.map(|free| free.parse::<Length>().map(|length| length.0)).transpose();
        let free_length = free.map_err(|error| error.to_string())?;
        if !(rate.is_finite() && rate >= 0.0) || free_length.is_some_and(|length| length < 0.0) {
            return Err("a rate and a free length of at least 0 are expected".into());
        }
        Ok(Self { ends: ends(a, b), rate, free_length })
    }
}

/// Damper between two points of links: `LINK=LINK=DAMPING` or `LINK=LINK=SPEED:FORCE,SPEED:FORCE,…`, positive in rebound.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPointDamper {
    pub(crate) ends: Ends,
    pub(crate) curve: Arc<DamperCurve>,
}

impl FromStr for GivenPointDamper {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let [a, b, law] = parts(text)[..] else {
            return Err("expected LINK:X,Y,Z=LINK:X,Y,Z=DAMPING or …=SPEED:FORCE,SPEED:FORCE,…, such as \
                        damper_seat=damper_chassis_seat=1500N·s/m"
                .into());
        };
        let curve = if law.contains(':') {
            let (mut speeds, mut forces) = (Vec::new(), Vec::new());
            for pair in law.split(',') {
                let (speed, force) = pair
                    .split_once(':')
                    .ok_or_else(|| format!("\"{pair}\": expected SPEED:FORCE, such as 0.5:900"))?;
                speeds.push(speed.trim().parse::<Speed>().map_err(|error| error.to_string())?.0.value);
                forces.push(force.trim().parse::<Force>().map_err(|error| error.to_string())?.0);
            }
            DamperCurve::new(speeds, forces)
        } else {
            DamperCurve::linear(Dimension::Damping.parse(law).map_err(|error| error.to_string())?.value)
        };
        Ok(Self { ends: ends(a, b), curve: Arc::new(curve.map_err(|error| error.to_string())?) })
    }
}

/// Constant force of a drive: `JOINT=VALUE`, or `LINK=LINK=FORCE` along a line.
#[derive(Clone, Debug, PartialEq)]
pub enum GivenDrive {
    /// Force or moment on a joint with one velocity, positive in its direction; in N without a unit for a sliding joint, in N·m for a hinge.
    Joint(String, Quantity),
    /// Force (N) that pushes two points apart.
    Points(Ends, f64),
}

impl FromStr for GivenDrive {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        match parts(text)[..] {
            [joint, value] => {
                let value = Quantity::parse_as(value, &[Dimension::Moment, Dimension::Force]);
                Ok(Self::Joint(joint.to_owned(), value.map_err(|error| error.to_string())?))
            }
            [a, b, force] => {
                let force = force.parse::<Force>().map_err(|error| error.to_string())?.0;
                Ok(Self::Points(ends(a, b), force))
            }
            _ => Err("expected JOINT=TORQUE or LINK:X,Y,Z=LINK:X,Y,Z=FORCE, such as hinge=40N·m".into()),
        }
    }
}
