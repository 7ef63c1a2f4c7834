//! Travel that drives the pose of a question: a point, a direction, and a displacement.

use crate::question::vary::{Varied, Vary, split};
use percuss_units::{Dimension, Quantity, QuantityError, parse_triple};

/// Requested displacement of a point of a link along a direction, measured from the point's position at the set
/// joint positions. A sweep over a travel varies the same quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenTravel {
    /// The link.
    pub link: String,
    /// The point, m, link's frame.
    pub point: [f64; 3],
    /// Direction, world axes, of any length.
    pub direction: [f64; 3],
    /// Displacement of the point, m.
    pub distance: f64,
}

/// Error in the text of a travel.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GivenTravelError {
    /// Missing parts.
    #[error("expected LINK:X,Y,Z:DX,DY,DZ=DISTANCE, such as spindle:0,0,0:0,0,1=60mm")]
    Form,
    /// Invalid point, direction or distance.
    #[error(transparent)]
    Number(#[from] QuantityError),
}

impl GivenTravel {
    /// Reads `LINK:X,Y,Z:DX,DY,DZ=DISTANCE`; a prefix `travel:` is allowed, as in `--vary`.
    ///
    /// # Errors
    /// [`GivenTravelError`] with the cause and the expected form.
    pub fn parse(text: &str) -> Result<Self, GivenTravelError> {
        let (along, distance) = text.rsplit_once('=').ok_or(GivenTravelError::Form)?;
        let along = along.strip_prefix("travel:").unwrap_or(along);
        let (link, point, direction) = split(along).ok_or(GivenTravelError::Form)?;
        Ok(Self {
            link: link.to_owned(),
            point: parse_triple(point, Dimension::Length)?,
            direction: parse_triple(direction, Dimension::Plain)?,
            distance: Quantity::parse(distance)?.in_dimension(Dimension::Length, distance)?,
        })
    }

    /// Range with one value, for the rows of a grid.
    pub(crate) fn as_range(&self) -> Vary {
        let Self { link, point, direction, distance } = self.clone();
        let at = Quantity { value: distance, dimension: Some(Dimension::Length) };
        Vary { quantity: Varied::Travel { link, point, direction }, from: at, to: at, count: 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_travel_is_read_from_the_right() {
        let travel = GivenTravel::parse("a:b=c:1mm,0,0:0,0,-1=-60mm").unwrap();
        let expected = GivenTravel {
            link: "a:b=c".into(),
            point: [0.001, 0.0, 0.0],
            direction: [0.0, 0.0, -1.0],
            distance: -0.06,
        };
        assert_eq!(travel, expected);
        assert_eq!(GivenTravel::parse("travel:w:0,0,0:0,0,1=0.01").unwrap().link, "w");
        for text in ["", "w", "w=1", "w:0,0,0=1", ":0,0,0:0,0,1=1"] {
            assert_eq!(GivenTravel::parse(text), Err(GivenTravelError::Form), "{text}");
        }
        for text in ["w:0,0,0:0,0,1=", "w:0,0,0:0,0,1=3deg", "w:0,0:0,0,1=1", "w:0,0,0:0,0,1mm=1"] {
            assert!(matches!(GivenTravel::parse(text), Err(GivenTravelError::Number(_))), "{text}");
        }
    }
}
