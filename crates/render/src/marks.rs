//! Marks on the x axis: a line through all panels, labelled above the first panel.

use crate::axis::{Axis, drawable};
use crate::figure::Mark;
use crate::font::Font;
use crate::limits;
use crate::palette::SOFT_INK;
use crate::scene::{Scene, Stroke, crisp};
use crate::text::{fit, regular, width};

const FONT: Font = regular(12.0);
const ROW: f64 = 17.0;
const BETWEEN: f64 = 10.0;
const STROKE: Stroke = Stroke { colour: SOFT_INK, width: 1.0, dash: Some((2.0, 3.0)) };

/// Marks on the page.
pub(crate) struct Strip {
    names: Vec<Name>,
    /// Positions of the marks without label.
    bare: Vec<f64>,
    rows: usize,
}

/// Label of a mark.
struct Name {
    words: String,
    /// Position of the mark.
    x: f64,
    /// Centre of the text.
    middle: f64,
    /// Row, counted upwards from the frame.
    row: usize,
}

/// Assigns each label the first row without overlap; `left` and `right` are the ends of the frame.
pub(crate) fn plan(marks: &[Mark], axis: &Axis, left: f64, right: f64) -> Strip {
    let mut strip = Strip { names: Vec::new(), bare: Vec::new(), rows: 0 };
    let mut taken: [Vec<(f64, f64)>; limits::MOST_MARK_ROWS] = Default::default();
    let drawn = marks.iter().filter_map(|m| Some((drawable(m.x)?, m))).filter(|(x, _)| axis.holds(*x));
    for (x, mark) in drawn.take(limits::MOST_MARKS) {
        let x = crisp(left + axis.fraction(x) * (right - left));
        let words = fit(&mark.label, FONT, 0.5 * (right - left));
        let half = 0.5 * (width(&words, FONT) + BETWEEN);
        let middle = x.clamp(left + half - BETWEEN, right - half + 0.5 * BETWEEN);
        let (low, high) = (middle - half, middle + half);
        let free = |row: &Vec<(f64, f64)>| row.iter().all(|&(a, b)| high <= a || b <= low);
        match taken.iter().position(free).filter(|_| !words.is_empty()) {
            Some(row) => {
                taken[row].push((low, high));
                strip.rows = strip.rows.max(row + 1);
                strip.names.push(Name { words, x, middle, row });
            }
            None => strip.bare.push(x),
        }
    }
    strip
}

impl Strip {
    /// Height of the labels above the first frame.
    pub fn height(&self) -> f64 {
        if self.rows == 0 { 0.0 } else { ROW * self.rows as f64 + 4.0 }
    }

    /// Draws the labels above a frame with its upper edge at `top`.
    pub fn draw_names(&self, scene: &mut Scene, top: f64) {
        for name in &self.names {
            let at = (name.middle, top - 8.0 - ROW * name.row as f64);
            scene.text_on_paper(name.words.clone(), at, FONT, SOFT_INK);
        }
    }

    /// Draws the lines from the upper to the lower edge of a frame; in the first frame, up to the labels.
    pub fn draw_lines(&self, scene: &mut Scene, top: f64, bottom: f64, first: bool) {
        let rise = |row: usize| if first { 4.0 + ROW * row as f64 } else { 0.0 };
        let named = self.names.iter().map(|n| vec![(n.x, top - rise(n.row)), (n.x, bottom)]);
        let bare = self.bare.iter().map(|&x| vec![(x, top), (x, bottom)]);
        scene.lines(named.chain(bare).collect(), STROKE);
    }
}
