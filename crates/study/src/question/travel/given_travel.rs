//! Travel that drives the pose of a question: a moved point or wheel, and a displacement.

use crate::question::travel::moved::{LongTravelError, Moved, WheelMotion};
use crate::question::travel::vary::{Varied, Vary};
use percuss_units::{Dimension, Quantity, QuantityError};
use std::fmt;
use std::str::FromStr;

/// Requested displacement of a point along a direction, or of the wheels, measured from the position at the set joint
/// positions. A sweep over a travel varies the same quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenTravel {
    /// Moved point or wheels.
    pub moved: Moved,
    /// Displacement, m.
    pub distance: f64,
}

/// Error in the text of a travel.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GivenTravelError {
    /// Missing parts.
    #[error(
        "expected LINK:X,Y,Z:DX,DY,DZ=DISTANCE, such as spindle:0,0,0:0,0,1=60mm, or wheel-travel=60mm, heave=60mm, \
         roll=20mm"
    )]
    Form,
    /// Invalid point, direction or distance.
    #[error(transparent)]
    Number(#[from] QuantityError),
    /// Wheel travel that no suspension has.
    #[error(transparent)]
    Long(#[from] LongTravelError),
}

impl FromStr for GivenTravel {
    type Err = GivenTravelError;
    fn from_str(text: &str) -> Result<Self, GivenTravelError> {
        Self::parse(text)
    }
}

impl fmt::Display for GivenTravel {
    /// Writes the form that [`parse`](Self::parse) reads, in metres.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.moved {
            Moved::Point { link, point: [x, y, z], direction: [a, b, c] } => {
                write!(f, "{link}:{x},{y},{z}:{a},{b},{c}={}", self.distance)
            }
            Moved::Wheels(motion) => write!(f, "{}={}", motion.name(), self.distance),
        }
    }
}

impl GivenTravel {
    /// Reads `LINK:X,Y,Z:DX,DY,DZ=DISTANCE`, with an optional prefix `travel:` as in `--vary`, or `MOTION=DISTANCE` with
    /// the name of a [`WheelMotion`].
    ///
    /// # Errors
    /// [`GivenTravelError`] with the cause and the expected form.
    pub fn parse(text: &str) -> Result<Self, GivenTravelError> {
        let (along, distance) = text.rsplit_once('=').ok_or(GivenTravelError::Form)?;
        let length = || Quantity::parse(distance)?.in_dimension(Dimension::Length, distance);
        let moved = match WheelMotion::from_name(along) {
            Some(motion) => {
                motion.check_distance(length()?)?;
                Moved::Wheels(motion)
            }
            None => {
                let along = along.strip_prefix("travel:").unwrap_or(along);
                Moved::parse_point(along).ok_or(GivenTravelError::Form)??
            }
        };
        Ok(Self { moved, distance: length()? })
    }

    /// Range with one value, for the rows of a grid.
    pub(crate) fn as_range(&self) -> Vary {
        let at = Quantity { value: self.distance, dimension: Some(Dimension::Length) };
        Vary { quantity: Varied::Travel(self.moved.clone()), from: at, to: at, count: 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_travel_is_read_from_the_right() {
        let travel = GivenTravel::parse("a:b=c:1mm,0,0:0,0,-1=-60mm").unwrap();
        let moved = |link: &str, point, direction| Moved::Point { link: link.into(), point, direction };
        let expected =
            GivenTravel { moved: moved("a:b=c", [0.001, 0.0, 0.0], [0.0, 0.0, -1.0]), distance: -0.06 };
        assert_eq!(travel, expected);
        let point = GivenTravel::parse("travel:w:0,0,0:0,0,1=0.01").unwrap().moved;
        assert_eq!(point, moved("w", [0.0; 3], [0.0, 0.0, 1.0]));
        assert_eq!(GivenTravel::parse(&travel.to_string()).unwrap(), travel);
        let heave = GivenTravel::parse("heave=-2cm").unwrap();
        assert_eq!(GivenTravel::parse(&heave.to_string()).unwrap(), heave);
        assert_eq!(heave, GivenTravel { moved: Moved::Wheels(WheelMotion::Heave), distance: -0.02 });
        for text in ["", "w", "w=1", "w:0,0,0=1", ":0,0,0:0,0,1=1"] {
            assert_eq!(GivenTravel::parse(text), Err(GivenTravelError::Form), "{text}");
        }
        for text in ["w:0,0,0:0,0,1=", "w:0,0,0:0,0,1=3deg", "w:0,0:0,0,1=1", "w:0,0,0:0,0,1mm=1"] {
            assert!(matches!(GivenTravel::parse(text), Err(GivenTravelError::Number(_))), "{text}");
        }
    }
}
