//! Tornado chart: first-order effects of many numbers as horizontal bars about zero, largest first.

use crate::figure::axis::{Axis, drawable};
use crate::font::Font;
use crate::palette::{Colour, GRID, INK, MINOR_GRID, SERIES, SOFT_INK, ZERO};
use crate::picture::Laid;
use crate::scene::{Anchor, Item, Scene, pixel_centre, solid};
use crate::text::{fit_to_width, medium, regular, width};

const WIDTH: f64 = 900.0;
const MARGIN: f64 = 28.0;
/// Height of a bar with its distance to the next, and of the bar alone.
const ROW: f64 = 22.0;
const BAR: f64 = 14.0;
/// Largest width of the names.
const NAMES: f64 = 300.0;
/// Space at both ends of the axis for the values.
const VALUES: f64 = 62.0;
/// Width reserve for fonts wider than the embedded one.
const RESERVE: f64 = 1.13;
const TITLE: Font = medium(19.0);
const SUBTITLE: Font = regular(13.0);
const LABEL: Font = medium(13.0);
const NAME: Font = regular(12.5);
const NUMBER: Font = regular(12.0);
const UP: Colour = SERIES[1];
const DOWN: Colour = SERIES[0];

/// Tornado chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tornado {
    /// Title; no title if empty.
    pub title: String,
    /// Subtitle; no subtitle if empty.
    pub subtitle: String,
    /// Label of the axis with its unit.
    pub x_label: String,
    /// Names of both halves of a bar: the number increased, and decreased.
    pub directions: [String; 2],
    /// Bars from top to bottom.
    pub bars: Vec<TornadoBar>,
}

/// Bar of a tornado chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TornadoBar {
    /// Name of the number.
    pub name: String,
    /// Effect of an increase. The effect of a decrease is the opposite: to first order.
    pub effect: f64,
    /// Text of the effect beside the bar; none if empty.
    pub value: String,
}

impl Laid for Tornado {
    /// Lays out title, legend, names and bars.
    fn layout_scene(&self) -> Scene {
        let width_available = WIDTH - 2.0 * MARGIN;
        let title = fit_to_width(&self.title, TITLE, width_available);
        let subtitle = fit_to_width(&self.subtitle, SUBTITLE, width_available);
        let mut scene = Scene { width: WIDTH, height: 0.0, caption: title.clone(), items: Vec::new() };
        let mut y = 16.0;
        for (text, font, colour, line) in [(title, TITLE, INK, 24.0), (subtitle, SUBTITLE, SOFT_INK, 20.0)] {
            if !text.is_empty() {
                y += line;
                scene.text(text, (MARGIN, y), Anchor::Start, font, colour);
            }
        }
        y += 24.0;
        self.draw_legend(&mut scene, y);
        let top = y + 14.0;
        let bottom = top + ROW * self.bars.len().max(1) as f64;
        let names: Vec<String> = self.bars.iter().map(|bar| fit_to_width(&bar.name, NAME, NAMES)).collect();
        let widest = names.iter().map(|name| RESERVE * width(name, NAME)).fold(40.0, f64::max);
        let (left, right) = (MARGIN + widest + 10.0 + VALUES, WIDTH - MARGIN - VALUES);
        let largest =
            self.bars.iter().filter_map(|bar| drawable(bar.effect)).fold(0.0, |m: f64, e| m.max(e.abs()));
        let range = if largest > 0.0 { largest } else { 1.0 };
        let axis = Axis::without_margin(Some((-range, range)), 6);
        let x_at = |value: f64| left + axis.fraction(value) * (right - left);
        let vertical = |x: f64| vec![(pixel_centre(x), top), (pixel_centre(x), bottom)];
        let at = |fraction: f64| vertical(left + fraction * (right - left));
        scene.lines(axis.minor().into_iter().map(at).collect(), solid(MINOR_GRID, 1.0));
        scene.lines(axis.ticks().iter().map(|tick| at(tick.fraction)).collect(), solid(GRID, 1.0));
        for ((bar, name), i) in self.bars.iter().zip(names).zip(0u32..) {
            let middle = top + ROW * (f64::from(i) + 0.5);
            scene.text(name, (left - VALUES - 10.0, middle + 4.5), Anchor::End, NAME, INK);
            let Some(effect) = drawable(bar.effect) else { continue };
            for (value, colour) in [(effect, UP), (-effect, DOWN)] {
                let (a, b) = (x_at(0.0).min(x_at(value)), x_at(0.0).max(x_at(value)));
                let (from, to) = ((a, middle - 0.5 * BAR), (b.max(a + 0.5), middle + 0.5 * BAR));
                scene.items.push(Item::Patch { from, to, colour });
            }
            let end = (x_at(effect.abs()) + 6.0, middle + 4.5);
            let value = fit_to_width(&bar.value, NUMBER, VALUES + MARGIN - 8.0);
            scene.text(value, end, Anchor::Start, NUMBER, SOFT_INK);
        }
        scene.lines(vec![vertical(x_at(0.0))], solid(ZERO, 1.0));
        for tick in axis.ticks() {
            let x = left + tick.fraction * (right - left);
            scene.text(tick.label, (x, bottom + 18.0), Anchor::Middle, NUMBER, SOFT_INK);
        }
        let label = fit_to_width(&self.x_label, LABEL, right - left + 2.0 * VALUES);
        scene.text(label, (0.5 * (left + right), bottom + 40.0), Anchor::Middle, LABEL, INK);
        if self.bars.is_empty() {
            let at = (0.5 * (left + right), top + 0.7 * ROW);
            scene.text_with_halo("nothing to draw".into(), at, Anchor::Middle, SUBTITLE, SOFT_INK);
        }
        scene.height = (bottom + 54.0).ceil();
        scene
    }
}

impl Tornado {
    /// Draws the names of both directions with their colours.
    fn draw_legend(&self, scene: &mut Scene, y: f64) {
        let mut x = MARGIN;
        for (name, colour) in self.directions.iter().zip([UP, DOWN]) {
            let name = fit_to_width(name, NAME, 0.45 * WIDTH);
            if name.is_empty() {
                continue;
            }
            scene.items.push(Item::Patch { from: (x, y - 10.0), to: (x + 12.0, y + 1.0), colour });
            let length = RESERVE * width(&name, NAME);
            scene.text(name, (x + 18.0, y), Anchor::Start, NAME, INK);
            x += 18.0 + length + 24.0;
        }
    }
}
