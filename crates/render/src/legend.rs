//! Legend of a panel: in the heading line if it fits, else in rows below it.

use crate::figure::{Series, Style};
use crate::font::Font;
use crate::palette::{Colour, INK};
use crate::scene::{Anchor, Point, Scene, Stroke};
use crate::text::{fit, regular, width};

const FONT: Font = regular(12.5);
/// Length of a line sample.
const SAMPLE: f64 = 24.0;
const AFTER_SAMPLE: f64 = 7.0;
const BETWEEN: f64 = 20.0;
/// Width reserve: the reader's sans-serif may be wider than the embedded face; DejaVu Sans is 12.5 % wider.
pub(crate) const SLACK: f64 = 1.13;
/// Height of one row.
pub(crate) const ROW: f64 = 19.0;
/// Radius of an isolated value and of a measurement.
pub(crate) const DOT: f64 = 2.8;

/// Entries with their offset from the left end of the row, and their row.
pub(crate) struct Legend {
    entries: Vec<(String, f64, usize)>,
    /// Number of rows below the heading; 0 if the legend is in the heading line.
    pub rows: usize,
    /// Width of a legend of one row.
    width: f64,
}

/// Lays out a legend for two or more series. `room` is the width of the page, `beside` the width left in the
/// heading line.
pub(crate) fn plan(series: &[Series], room: f64, beside: f64) -> Legend {
    if series.len() < 2 {
        return Legend { entries: Vec::new(), rows: 0, width: 0.0 };
    }
    let name = |s: &Series| fit(if s.name.trim().is_empty() { "—" } else { &s.name }, FONT, 0.5 * room);
    let names: Vec<String> = series.iter().map(name).collect();
    let length = |words: &String| SAMPLE + AFTER_SAMPLE + SLACK * width(words, FONT);
    // At the right end the page margin serves as reserve.
    let spare = names.last().map_or(0.0, |last| ((SLACK - 1.0) * width(last, FONT)).min(16.0));
    let whole = names.iter().map(length).sum::<f64>() + BETWEEN * (names.len() - 1) as f64 - spare;
    let beside = whole <= beside;
    let (mut x, mut row, mut entries) = (0.0, 0, Vec::new());
    for words in names {
        let length = length(&words);
        if !beside && x > 0.0 && x + length > room {
            (x, row) = (0.0, row + 1);
        }
        entries.push((words, x, row));
        x += length + BETWEEN;
    }
    Legend { entries, rows: if beside { 0 } else { row + 1 }, width: whole }
}

impl Legend {
    /// Draws the legend: in the heading line up to `right`, or from `left` in the rows below.
    pub fn draw(
        self,
        scene: &mut Scene,
        series: &[Series],
        colours: &[Colour],
        ends: (f64, f64),
        baseline: f64,
    ) {
        let (left, right) = ends;
        let start = if self.rows == 0 { right - self.width } else { left };
        let first = if self.rows == 0 { baseline } else { baseline + ROW };
        for (((words, x, row), series), &colour) in self.entries.into_iter().zip(series).zip(colours) {
            let (x, y) = (start + x, first + ROW * row as f64);
            let middle = y - 4.5;
            let dots = |scene: &mut Scene, at: &[Point]| scene.dots(at.to_vec(), DOT, colour);
            match series.style {
                Style::Dots => dots(scene, &[(x + 6.0, middle), (x + SAMPLE - 6.0, middle)]),
                style => scene.lines(vec![vec![(x, middle), (x + SAMPLE, middle)]], stroke(style, colour)),
            }
            scene.text(words, (x + SAMPLE + AFTER_SAMPLE, y), Anchor::Start, FONT, INK);
        }
    }
}

/// Stroke of a line style, in the legend and in the panel.
pub(crate) fn stroke(style: Style, colour: Colour) -> Stroke {
    let dash = (style == Style::Dashed).then_some((6.5, 3.5));
    Stroke { colour, width: 2.0, dash }
}
