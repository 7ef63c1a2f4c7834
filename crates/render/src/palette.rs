//! Colours: the set of Okabe and Ito, distinguishable with the common colour vision deficiencies, and greys.

/// Red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Colour(pub u8, pub u8, pub u8);

pub(crate) const PAPER: Colour = Colour(255, 255, 255);
pub(crate) const INK: Colour = Colour(28, 32, 38);
pub(crate) const SOFT_INK: Colour = Colour(92, 99, 110);
pub(crate) const AXIS: Colour = Colour(120, 128, 140);
pub(crate) const ZERO: Colour = Colour(176, 183, 193);
pub(crate) const GRID: Colour = Colour(220, 224, 230);
pub(crate) const MINOR_GRID: Colour = Colour(242, 244, 247);

/// Blue, vermilion, green, purple, orange, sky blue, black. Yellow is left out: its contrast on white is too low.
pub(crate) const SERIES: [Colour; 7] = [
    Colour(0, 114, 178),
    Colour(213, 94, 0),
    Colour(0, 158, 115),
    Colour(204, 121, 167),
    Colour(230, 159, 0),
    Colour(86, 180, 233),
    Colour(60, 60, 60),
];
