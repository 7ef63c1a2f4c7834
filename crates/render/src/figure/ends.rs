//! Names of lines at their ends, beside the frame of a panel.

use crate::figure::axis::drawable;
use crate::figure::legend::{WIDTH_RESERVE, stroke};
use crate::figure::{Panel, Series, Style};
use crate::font::Font;
use crate::palette::{Colour, INK};
use crate::scene::{Anchor, Point, Scene};
use crate::text::{fit_to_width, regular, width};

const FONT: Font = regular(12.5);
/// Length of the line between a curve and its name, and distance of the name from it.
const SAMPLE: f64 = 16.0;
const AFTER: f64 = 5.0;
/// Smallest distance of two names.
const ROW: f64 = 15.0;
/// Largest part of the page for names.
const MOST: f64 = 0.3;
/// Largest number of lines with names at their ends.
const MOST_LINES: usize = 7;
/// Relative difference up to which two lines are equal.
const EQUAL: f64 = 1e-6;

/// True for a series that has its name at its end.
pub(crate) fn is_line(series: &Series) -> bool {
    matches!(series.style, Style::Line | Style::Dashed)
        && series.points.iter().any(|(x, y)| drawable(*x).is_some() && y.and_then(drawable).is_some())
}

/// Width beside the frame for the names of all panels; `None` if a legend has the names.
pub(crate) fn width_of_names(panels: &[Panel], page: f64) -> Option<f64> {
    let named = || panels.iter().filter(|panel| has_names(panel));
    let names = named().flat_map(|panel| &panel.series).filter(|series| is_line(series));
    let widest = names.map(|series| width(&series.name, FONT)).fold(0.0, f64::max);
    let needed = SAMPLE + AFTER + WIDTH_RESERVE * widest;
    let is_short =
        named().all(|panel| panel.series.iter().filter(|series| is_line(series)).count() <= MOST_LINES);
    (widest > 0.0 && needed <= MOST * page && is_short).then_some(needed)
}

/// True if the lines of a panel need names.
fn has_names(panel: &Panel) -> bool {
    panel.series.len() > 1
}

/// Draws the names of the lines of a panel at the right edge of its frame, from top to bottom without overlap.
pub(crate) fn draw_names(
    scene: &mut Scene,
    panel: &Panel,
    colours: &[Colour],
    point_at: &dyn Fn(f64, f64) -> Point,
    (right, top, bottom): (f64, f64, f64),
    available: f64,
) {
    if !has_names(panel) {
        return;
    }
    let lines = panel.series.iter().zip(colours).filter(|(series, _)| is_line(series));
    let end = |series: &Series| {
        let values = series.points.iter().filter_map(|(x, y)| Some((drawable(*x)?, drawable((*y)?)?)));
        values.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(x, y)| point_at(x, y))
    };
    let mut ends: Vec<(f64, f64, &Series, Colour)> = lines
        .filter_map(|(series, colour)| {
            let y = end(series)?.1.clamp(top, bottom);
            Some((y, y, series, *colour))
        })
        .collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Downwards, then upwards from the lower edge.
    for i in 1..ends.len() {
        ends[i].1 = ends[i].1.max(ends[i - 1].1 + ROW);
    }
    let mut limit = bottom + 4.0;
    for end in ends.iter_mut().rev() {
        end.1 = end.1.min(limit);
        limit = end.1 - ROW;
    }
    for (y, at, series, colour) in ends {
        scene.lines(vec![vec![(right + 2.0, y), (right + SAMPLE, at)]], stroke(series.style, colour));
        let name = fit_to_width(&series.name, FONT, available - SAMPLE - AFTER);
        scene.text(name, (right + SAMPLE + AFTER, at + 4.3), Anchor::Start, FONT, INK);
    }
}

/// Panel in which lines with equal points are one line with all names.
pub(crate) fn merge_equal(panel: &Panel) -> Panel {
    let is_near = |a: f64, b: f64| (a - b).abs() <= EQUAL * a.abs().max(b.abs());
    let is_same = |a: &Series, b: &Series| {
        a.style == b.style
            && is_line(a)
            && a.points.len() == b.points.len()
            && a.points.iter().zip(&b.points).all(|(a, b)| {
                a.0 == b.0
                    && match (a.1, b.1) {
                        (Some(a), Some(b)) => is_near(a, b),
                        (a, b) => a.is_none() == b.is_none(),
                    }
            })
    };
    let mut series: Vec<Series> = Vec::new();
    for next in &panel.series {
        match series.iter_mut().find(|known| is_same(known, next)) {
            Some(known) if known.name != next.name => known.name += &format!(", {}", next.name),
            Some(_) => {}
            None => series.push(next.clone()),
        }
    }
    Panel { series, ..panel.clone() }
}
