//! Legend of a panel: in the heading line if it fits, else in rows below it.

use crate::figure::{Series, Style};
use crate::font::Font;
use crate::palette::{Colour, INK, PAPER};
use crate::scene::{Anchor, Item, Point, Scene, Stroke};
use crate::text::{fit_to_width, regular, width};

const FONT: Font = regular(12.5);
/// Length of a line sample.
const SAMPLE: f64 = 24.0;
const AFTER_SAMPLE: f64 = 7.0;
const ENTRY_DISTANCE: f64 = 20.0;
/// Width reserve: the reader's sans-serif may be wider than the embedded face; DejaVu Sans is 12.5 % wider.
pub(crate) const WIDTH_RESERVE: f64 = 1.13;
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

/// Lays out a legend for two or more series. `page_width` is the width of the page, `heading_width` the width left in the
/// heading line.
pub(crate) fn layout_legend(series: &[Series], page_width: f64, heading_width: f64) -> Legend {
    if series.len() < 2 {
        return Legend { entries: Vec::new(), rows: 0, width: 0.0 };
    }
    let name = |s: &Series| {
        fit_to_width(if s.name.trim().is_empty() { "—" } else { &s.name }, FONT, 0.5 * page_width)
    };
    let names: Vec<String> = series.iter().map(name).collect();
    let length = |name: &String| SAMPLE + AFTER_SAMPLE + WIDTH_RESERVE * width(name, FONT);
    // At the right end the page margin serves as reserve.
    let margin_reserve =
        names.last().map_or(0.0, |last| ((WIDTH_RESERVE - 1.0) * width(last, FONT)).min(16.0));
    let total_width =
        names.iter().map(length).sum::<f64>() + ENTRY_DISTANCE * (names.len() - 1) as f64 - margin_reserve;
    let fits_in_heading = total_width <= heading_width;
    let (mut x, mut row, mut entries) = (0.0, 0, Vec::new());
    for name in names {
        let length = length(&name);
        if !fits_in_heading && x > 0.0 && x + length > page_width {
            (x, row) = (0.0, row + 1);
        }
        entries.push((name, x, row));
        x += length + ENTRY_DISTANCE;
    }
    Legend { entries, rows: if fits_in_heading { 0 } else { row + 1 }, width: total_width }
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
        for (((name, x, row), series), &colour) in self.entries.into_iter().zip(series).zip(colours) {
            let (x, y) = (start + x, first + ROW * row as f64);
            let middle = y - 4.5;
            let dots = |scene: &mut Scene, at: &[Point]| scene.dots(at.to_vec(), DOT, colour);
            match series.style {
                Style::Dots => dots(scene, &[(x + 6.0, middle), (x + SAMPLE - 6.0, middle)]),
                Style::Band => scene.items.push(Item::Patch {
                    from: (x, middle - 5.0),
                    to: (x + SAMPLE, middle + 5.0),
                    colour: band_tint(colour),
                }),
                style => scene.lines(vec![vec![(x, middle), (x + SAMPLE, middle)]], stroke(style, colour)),
            }
            scene.text(name, (x + SAMPLE + AFTER_SAMPLE, y), Anchor::Start, FONT, INK);
        }
    }
}

/// Part of the series colour in the fill of a band; the rest is paper colour.
const BAND_TINT: f64 = 0.28;

/// Colour of a band, in the legend and in the panel.
pub(crate) fn band_tint(colour: Colour) -> Colour {
    let mix =
        |c: u8, paper: u8| (BAND_TINT * f64::from(c) + (1.0 - BAND_TINT) * f64::from(paper)).round() as u8;
    Colour(mix(colour.0, PAPER.0), mix(colour.1, PAPER.1), mix(colour.2, PAPER.2))
}

/// Stroke of a line style, in the legend and in the panel.
pub(crate) fn stroke(style: Style, colour: Colour) -> Stroke {
    let dash = (style == Style::Dashed).then_some((6.5, 3.5));
    Stroke { colour, width: 2.0, dash }
}
