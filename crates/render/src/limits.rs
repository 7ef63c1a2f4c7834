//! The thresholds of drawing, each with its unit and its reason. The dimensions of the layout are in the files that lay
//! out.

/// Values beyond this are not drawn: below it no difference, step or label overflows. In the units of the data.
pub(crate) const LARGEST_VALUE: f64 = 1e300;
/// Values below this are drawn as zero: above it no step of an axis underflows. In the units of the data.
pub(crate) const SMALLEST_VALUE: f64 = 1e-300;
/// A range narrower than this part of its values is rounding, and drawn as one value.
pub(crate) const FLAT: f64 = 1e-9;
/// By this part of a step a tick may lie outside an axis: ends are included in spite of rounding.
pub(crate) const TICK_SLACK: f64 = 1e-6;
/// A step counts as 1, 2 or 5 within this relative slack: a span of 0.6 in three steps must not depend on rounding.
pub(crate) const STEP_SLACK: f64 = 1e-9;
/// Points nearer than this fall into one column, in units of the page: half a pixel at scale 1.
pub(crate) const COLUMN: f64 = 0.5;
/// Places on the page of one series, about: what is beyond is thinned evenly. Four in each column of the page.
pub(crate) const MOST_PLACES: usize = 8_000;
/// The largest picture, in pixels: 128 MiB while it is drawn.
pub(crate) const MOST_PIXELS: f64 = (1u32 << 25) as f64;
/// Characters of one text, however narrow they are: more do not fit the page.
pub(crate) const MOST_CHARACTERS: usize = 240;
/// Rows of names of marks above the first panel.
pub(crate) const MOST_MARK_ROWS: usize = 4;
/// Marks of a figure that are drawn: more than one for two units of the page's width cannot be distinguished.
pub(crate) const MOST_MARKS: usize = 400;
/// Values over a surface have a logarithmic scale where the largest is more than so many times the least: on an even one, half
/// of the colours would be left to less than a decade.
pub(crate) const LOGARITHMIC: f64 = 20.0;
/// Part of the values over a surface up to which the scale goes where the largest would take most of it: beside what nothing moves,
/// masses grow beyond bounds.
pub(crate) const MOST_SHOWN: f64 = 0.95;
