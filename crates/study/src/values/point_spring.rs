//! Spring between two points as given by the user.

use crate::values::quantities::{Length, LinkPoint};
use percuss_units::Dimension;
use std::str::FromStr;

/// Spring between two points of links: `LINK=LINK=RATE` or `LINK:X,Y,Z=LINK:X,Y,Z=RATE=FREE`.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPointSpring {
    /// Link and point (m, in the frame of the link) of each end.
    pub(crate) ends: [(String, [f64; 3]); 2],
    /// N/m.
    pub(crate) rate: f64,
    /// Length without force, m; `None`: the length at the touch.
    pub(crate) free_length: Option<f64>,
}

impl FromStr for GivenPointSpring {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let parts: Vec<&str> = text.split('=').map(str::trim).collect();
        let (a, b, rate, free) = match parts[..] {
            [a, b, rate] => (a, b, rate, None),
            [a, b, rate, free] => (a, b, rate, Some(free)),
            _ => {
                return Err("expected LINK:X,Y,Z=LINK:X,Y,Z=RATE or …=RATE=FREE, such as spring_seat=spring_chassis_seat=30N/mm".into());
            }
        };
        // A link without a point has its origin.
        let end = |text: &str| match text.parse::<LinkPoint>() {
            Ok(point) => (point.link, point.point.0),
            Err(_) => (text.to_owned(), [0.0; 3]),
        };
        let rate = Dimension::Stiffness.parse(rate).map_err(|error| error.to_string())?.value;
        let free = free.map(|free| free.parse::<Length>().map(|length| length.0)).transpose();
        let free_length = free.map_err(|error| error.to_string())?;
        if !(rate.is_finite() && rate >= 0.0) || free_length.is_some_and(|length| length < 0.0) {
            return Err("a rate and a free length of at least 0 are expected".into());
        }
        Ok(Self { ends: [end(a), end(b)], rate, free_length })
    }
}
