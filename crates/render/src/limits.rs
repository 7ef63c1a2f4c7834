//! Thresholds of drawing, each with unit and reason. Layout dimensions are in the files that use them.

/// Largest drawn magnitude: below this limit no difference, step or label overflows. Data units.
pub(crate) const LARGEST_VALUE: f64 = 1e300;
/// Smallest drawn magnitude; below it values are zero: above it no step of an axis underflows. Data units.
pub(crate) const SMALLEST_VALUE: f64 = 1e-300;
/// Relative width of a range below which the spread is rounding, and the range is drawn as one value.
pub(crate) const FLAT: f64 = 1e-9;
/// Fraction of a step by which a tick may exceed the axis, so that the end points are included in spite of rounding.
pub(crate) const TICK_SLACK: f64 = 1e-6;
/// Relative tolerance of the mantissas 1, 2 and 5: a span of 0.6 in three steps must not depend on rounding.
pub(crate) const STEP_SLACK: f64 = 1e-9;
/// Width of a column, page units: half a pixel at scale 1. Points in one column are merged.
pub(crate) const COLUMN: f64 = 0.5;
/// Approximate limit of points per series, four per column of the page; more points are thinned evenly.
pub(crate) const MAX_POINTS: usize = 8_000;
/// Limit of the pixels of a picture: 128 MiB while drawing.
#[cfg(feature = "convert")]
pub(crate) const MAX_PIXELS: f64 = (1u32 << 25) as f64;
/// Limit of the characters of one text: more characters do not fit the page, however narrow they are.
pub(crate) const MAX_CHARACTERS: usize = 240;
/// Limit of the rows of mark labels above the first panel.
pub(crate) const MAX_MARK_ROWS: usize = 4;
/// Limit of drawn marks: more than one per two page units cannot be distinguished.
pub(crate) const MAX_MARKS: usize = 400;
/// Ratio of largest to smallest value above which a colour scale is logarithmic: on a linear scale, less than a
/// decade would get half of the colours.
pub(crate) const LOGARITHMIC: f64 = 20.0;
/// Quantile of the values at which the colour scale ends if outliers would take most of it: near immovable
/// contacts the effective mass grows without bound.
pub(crate) const SHOWN_QUANTILE: f64 = 0.95;
