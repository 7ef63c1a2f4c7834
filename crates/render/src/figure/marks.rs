//! Marks on the x axis: a line through all panels, labelled above the first panel.

use crate::figure::Mark;
use crate::figure::axis::{Axis, drawable};
use crate::font::Font;
use crate::limits;
use crate::palette::SOFT_INK;
use crate::scene::{Anchor, Scene, Stroke, pixel_centre};
use crate::text::{fit_to_width, regular, width};

const FONT: Font = regular(12.0);
const ROW: f64 = 17.0;
const LABEL_DISTANCE: f64 = 10.0;
const STROKE: Stroke = Stroke { colour: SOFT_INK, width: 1.0, dash: Some((2.0, 3.0)) };

/// Marks on the page.
pub(crate) struct MarkStrip {
    labels: Vec<MarkLabel>,
    /// Positions of the marks without label.
    unlabelled: Vec<f64>,
    rows: usize,
}

/// Label of a mark.
struct MarkLabel {
    text: String,
    /// Position of the mark.
    x: f64,
    /// Centre of the text.
    middle: f64,
    /// Row, counted upwards from the frame.
    row: usize,
}

/// Assigns each label the first row without overlap; `left` and `right` are the ends of the frame.
pub(crate) fn layout_marks(marks: &[Mark], axis: &Axis, left: f64, right: f64) -> MarkStrip {
    let mut strip = MarkStrip { labels: Vec::new(), unlabelled: Vec::new(), rows: 0 };
    let mut taken: [Vec<(f64, f64)>; limits::MAX_MARK_ROWS] = Default::default();
    let drawn = marks.iter().filter_map(|m| Some((drawable(m.x)?, m))).filter(|(x, _)| axis.contains(*x));
    for (x, mark) in drawn.take(limits::MAX_MARKS) {
        let x = pixel_centre(left + axis.fraction(x) * (right - left));
        let text = fit_to_width(&mark.label, FONT, 0.5 * (right - left));
        let half = 0.5 * (width(&text, FONT) + LABEL_DISTANCE);
        let middle = x.clamp(left + half - LABEL_DISTANCE, right - half + 0.5 * LABEL_DISTANCE);
        let (low, high) = (middle - half, middle + half);
        let free = |row: &Vec<(f64, f64)>| row.iter().all(|&(a, b)| high <= a || b <= low);
        match taken.iter().position(free).filter(|_| !text.is_empty()) {
            Some(row) => {
                taken[row].push((low, high));
                strip.rows = strip.rows.max(row + 1);
                strip.labels.push(MarkLabel { text, x, middle, row });
            }
            None => strip.unlabelled.push(x),
        }
    }
    strip
}

impl MarkStrip {
    /// Height of the labels above the first frame.
    pub fn height(&self) -> f64 {
        if self.rows == 0 { 0.0 } else { ROW * self.rows as f64 + 4.0 }
    }

    /// Draws the labels above a frame with its upper edge at `top`.
    pub fn draw_labels(&self, scene: &mut Scene, top: f64) {
        for name in &self.labels {
            let at = (name.middle, top - 8.0 - ROW * name.row as f64);
            scene.text_with_halo(name.text.clone(), at, Anchor::Middle, FONT, SOFT_INK);
        }
    }

    /// Draws the lines from the upper to the lower edge of a frame; in the first frame, up to the labels.
    pub fn draw_lines(&self, scene: &mut Scene, top: f64, bottom: f64, first: bool) {
        let label_height = |row: usize| if first { 4.0 + ROW * row as f64 } else { 0.0 };
        let labelled = self.labels.iter().map(|n| vec![(n.x, top - label_height(n.row)), (n.x, bottom)]);
        let unlabelled = self.unlabelled.iter().map(|&x| vec![(x, top), (x, bottom)]);
        scene.lines(labelled.chain(unlabelled).collect(), STROKE);
    }
}
