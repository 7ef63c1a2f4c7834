//! A travel that a question drives its pose to: a point, a direction, and how far.

use crate::quantity::{Dimension, Quantity, QuantityError, parse_triple};
use crate::vary::{Varied, Vary};

/// The displacement of a point of a link along a direction, from where the joints as set put it: what a sweep varies, at one
/// value.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenTravel {
    /// The link.
    pub link: String,
    /// The point, m, link's frame.
    pub point: [f64; 3],
    /// The direction, world axes; its length does not matter.
    pub direction: [f64; 3],
    /// How far the point is displaced, m.
    pub distance: f64,
}

/// A text that is no travel.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GivenTravelError {
    /// Parts are missing.
    #[error("expected LINK:X,Y,Z:DX,DY,DZ=DISTANCE, such as spindle:0,0,0:0,0,1=60mm")]
    Form,
    /// The point, the direction or the distance.
    #[error(transparent)]
    Number(#[from] QuantityError),
}

impl GivenTravel {
    /// Reads `LINK:X,Y,Z:DX,DY,DZ=DISTANCE`; `travel:` may stand before it, as in `--vary`.
    ///
    /// # Errors
    /// [`GivenTravelError`]: what is wrong, and how it should look.
    pub fn parse(text: &str) -> Result<Self, GivenTravelError> {
        let (along, distance) = text.rsplit_once('=').ok_or(GivenTravelError::Form)?;
        let along = along.strip_prefix("travel:").unwrap_or(along);
        let (link, point, direction) = split(along).ok_or(GivenTravelError::Form)?;
        Ok(Self {
            link: link.to_owned(),
            point: parse_triple(point, Dimension::Length)?,
            direction: parse_triple(direction, Dimension::Plain)?,
            distance: Quantity::parse(distance)?.of(Dimension::Length, distance)?,
        })
    }

    /// As a range of one value, for the rows of a grid.
    pub(crate) fn as_range(&self) -> Vary {
        let Self { link, point, direction, distance } = self.clone();
        let at = Quantity { value: distance, dimension: Some(Dimension::Length) };
        Vary { what: Varied::Travel { link, point, direction }, from: at, to: at, count: 1 }
    }
}

/// `LINK:X,Y,Z:DX,DY,DZ`, split from the right: link names may have colons of their own.
pub(crate) fn split(text: &str) -> Option<(&str, &str, &str)> {
    let mut parts = text.rsplitn(3, ':');
    let (direction, point, link) = (parts.next()?, parts.next()?, parts.next()?);
    (!link.is_empty()).then_some((link, point, direction))
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
