//! Layout: converts a figure to a scene.

use crate::axis::{Axis, drawable, extent};
use crate::curve;
use crate::figure::{Figure, Panel, Style};
use crate::font::Font;
use crate::legend::{DOT, ROW, SLACK, plan as plan_legend, stroke};
use crate::marks::{Strip, plan as plan_marks};
use crate::palette::{AXIS, Colour, GRID, INK, MINOR_GRID, SOFT_INK, ZERO, assign};
use crate::scene::{Anchor, Point, Scene, crisp, solid};
use crate::text::{fit, medium, regular, width};

const WIDTH: f64 = 900.0;
/// Margin on the left and right of the page.
const MARGIN: f64 = 28.0;
/// Height of a panel's frame.
const FRAME: f64 = 232.0;
/// Height of a panel's heading, above its frame.
const HEADING: f64 = 30.0;
/// Distance between a frame and the next heading.
const BETWEEN: f64 = 24.0;
const TITLE: Font = medium(19.0);
const SUBTITLE: Font = regular(13.0);
const LABEL: Font = medium(13.0);
const NUMBER: Font = regular(12.0);
/// Distance between tick label and axis.
const GAP: f64 = 8.0;
const HALF_DIGIT: f64 = 4.3;

/// Frame of a panel on the page.
struct Frame<'a> {
    x: &'a Axis,
    y: &'a Axis,
    left: f64,
    right: f64,
    top: f64,
}

impl Frame<'_> {
    fn bottom(&self) -> f64 {
        self.top + FRAME
    }
    fn across(&self, fraction: f64) -> f64 {
        self.left + fraction * (self.right - self.left)
    }
    fn down(&self, fraction: f64) -> f64 {
        self.bottom() - fraction * FRAME
    }
    fn place(&self, x: f64, y: f64) -> Point {
        (self.across(self.x.fraction(x)), self.down(self.y.fraction(y)))
    }
    /// True if a point may lie outside the frame.
    fn is_limited(&self, panel: &Panel) -> bool {
        let holds = |&(x, y): &(f64, Option<f64>)| {
            let inside = |axis: &Axis, v: f64| drawable(v).is_none_or(|v| axis.holds(v));
            inside(self.x, x) && y.is_none_or(|y| inside(self.y, y))
        };
        !panel.series.iter().flat_map(|s| &s.points).all(holds)
    }
    fn upright(&self, x: f64) -> Vec<Point> {
        vec![(crisp(x), self.top), (crisp(x), self.bottom())]
    }
    fn level(&self, y: f64) -> Vec<Point> {
        vec![(self.left, crisp(y)), (self.right, crisp(y))]
    }
}

/// Lays out a figure on one page.
pub(crate) fn arrange(figure: &Figure) -> Scene {
    let title = fit(&figure.title, TITLE, WIDTH - 2.0 * MARGIN);
    let subtitle = fit(&figure.subtitle, SUBTITLE, WIDTH - 2.0 * MARGIN);
    let caption = [title.as_str(), subtitle.as_str()].into_iter().filter(|s| !s.is_empty());
    let caption = caption.collect::<Vec<_>>().join(" — ");
    let mut scene = Scene { width: WIDTH, height: 0.0, caption, items: Vec::new() };

    let mut down = 16.0;
    for (words, font, colour, line) in [(title, TITLE, INK, 24.0), (subtitle, SUBTITLE, SOFT_INK, 20.0)] {
        if !words.is_empty() {
            down += line;
            scene.text(words, (MARGIN, down), Anchor::Start, font, colour);
        }
    }
    down += 12.0;

    let y_axes: Vec<Axis> = figure.panels.iter().map(y_axis).collect();
    let left = MARGIN + GAP + widest(&y_axes).ceil();
    let right = WIDTH - MARGIN;
    let x_axis = x_axis(figure, right - left);
    let colours = assign(figure);
    let strip = plan_marks(&figure.marks, &x_axis, left, right);

    for (i, ((panel, y_axis), colours)) in figure.panels.iter().zip(&y_axes).zip(&colours).enumerate() {
        let baseline = down + 20.0;
        let label = fit(&panel.y_label, LABEL, right - MARGIN);
        let beside = right - MARGIN - SLACK * width(&label, LABEL) - 32.0;
        scene.text(label, (MARGIN, baseline), Anchor::Start, LABEL, INK);
        let legend = plan_legend(&panel.series, right - MARGIN, beside);
        let above = HEADING + legend.rows as f64 * ROW + if i == 0 { strip.height() } else { 0.0 };
        legend.draw(&mut scene, &panel.series, colours, (MARGIN, right), baseline);
        let frame = Frame { x: &x_axis, y: y_axis, left, right, top: down + above };
        draw_panel(&mut scene, panel, colours, &frame, &strip, i == 0);
        down = frame.bottom();
        if i + 1 < figure.panels.len() {
            down += BETWEEN;
        } else {
            numbers_across(&mut scene, &frame);
        }
    }
    if figure.panels.is_empty() {
        scene.text("nothing to draw".into(), (MARGIN, down + 20.0), Anchor::Start, SUBTITLE, SOFT_INK);
        down += 20.0;
    } else {
        let label = fit(&figure.x_label, LABEL, right - left);
        scene.text(label, (0.5 * (left + right), down + 46.0), Anchor::Middle, LABEL, INK);
        down += if figure.x_label.trim().is_empty() { 28.0 } else { 50.0 };
    }
    scene.height = (down + 14.0).ceil();
    scene
}

fn y_axis(panel: &Panel) -> Axis {
    if let Some(limits) = panel.y_limits.and_then(|(low, high)| extent([low, high].into_iter())) {
        return Axis::tight(Some(limits), 6);
    }
    let points = panel.series.iter().flat_map(|s| &s.points);
    // A value without a drawable x is not drawn, so it does not affect the range.
    Axis::roomy(extent(points.filter(|p| drawable(p.0).is_some()).filter_map(|p| p.1)), 6)
}

/// Shared x axis with as many ticks as fit side by side.
fn x_axis(figure: &Figure, room: f64) -> Axis {
    let points = figure.panels.iter().flat_map(|p| &p.series).flat_map(|s| &s.points).map(|p| p.0);
    let limits = figure.x_limits.and_then(|(low, high)| extent([low, high].into_iter()));
    let range = limits.or_else(|| extent(points)).or_else(|| extent(figure.marks.iter().map(|m| m.x)));
    let fits = |axis: &Axis| {
        let ticks = axis.ticks();
        let step = room / (ticks.len().max(2) - 1) as f64;
        ticks.iter().all(|t| width(&t.label, NUMBER) + 18.0 < step)
    };
    (2..=10).rev().map(|most| Axis::tight(range, most)).find(fits).unwrap_or_else(|| Axis::tight(range, 2))
}

fn widest(axes: &[Axis]) -> f64 {
    axes.iter().flat_map(Axis::ticks).map(|t| width(&t.label, NUMBER)).fold(24.0, f64::max)
}

fn draw_panel(
    scene: &mut Scene,
    panel: &Panel,
    colours: &[Colour],
    frame: &Frame,
    strip: &Strip,
    first: bool,
) {
    draw_grid(scene, frame);
    strip.draw_lines(scene, frame.top, frame.bottom(), first);
    if first {
        strip.draw_names(scene, frame.top);
    }

    let place = |x, y| frame.place(x, y);
    let mut empty = true;
    let inside = ((frame.left, frame.top), (frame.right, frame.bottom()));
    let is_clipped = frame.is_limited(panel);
    for (series, &colour) in panel.series.iter().zip(colours).rev() {
        let before = scene.items.len();
        if series.style == Style::Dots {
            let dots = curve::scatter(&series.points, place);
            let dots = dots.into_iter().filter(|p| !is_clipped || curve::is_inside(*p, inside)).collect();
            scene.dots(dots, DOT, colour);
        } else {
            let mut curve = curve::line(&series.points, place);
            if is_clipped {
                curve = curve.within(inside);
            }
            scene.lines(curve.chains, stroke(series.style, colour));
            scene.dots(curve.lone, DOT, colour);
        }
        empty &= scene.items.len() == before;
    }
    if empty {
        let at = (0.5 * (frame.left + frame.right), frame.top + 0.5 * FRAME);
        scene.text_on_paper("no value to draw".into(), at, SUBTITLE, SOFT_INK);
    }
}

/// Draws the grid, the zero lines, the axis and the tick labels of y.
fn draw_grid(scene: &mut Scene, frame: &Frame) {
    let uprights = |fractions: Vec<f64>| fractions.into_iter().map(|f| frame.upright(frame.across(f)));
    let levels = |fractions: Vec<f64>| fractions.into_iter().map(|f| frame.level(frame.down(f)));
    let places = |axis: &Axis| axis.ticks().iter().map(|t| t.fraction).collect::<Vec<_>>();
    let minor = uprights(frame.x.minor()).chain(levels(frame.y.minor())).collect();
    scene.lines(minor, solid(MINOR_GRID, 1.0));
    let major = uprights(places(frame.x)).chain(levels(places(frame.y))).collect();
    scene.lines(major, solid(GRID, 1.0));
    let zero = |axis: &Axis| if axis.holds(0.0) { vec![axis.fraction(0.0)] } else { Vec::new() };
    scene.lines(uprights(zero(frame.x)).chain(levels(zero(frame.y))).collect(), solid(ZERO, 1.0));

    let notch = |f: f64| {
        vec![(crisp(frame.across(f)), frame.bottom()), (crisp(frame.across(f)), frame.bottom() + 5.0)]
    };
    let mut axis: Vec<Vec<Point>> = places(frame.x).into_iter().map(notch).collect();
    axis.push(frame.level(frame.bottom()));
    scene.lines(axis, solid(AXIS, 1.0));
    for tick in frame.y.ticks() {
        let at = (frame.left - GAP, frame.down(tick.fraction) + HALF_DIGIT);
        scene.text(tick.label, at, Anchor::End, NUMBER, SOFT_INK);
    }
}

/// Draws the tick labels of x below the last panel; labels at the ends are moved to stay on the page.
fn numbers_across(scene: &mut Scene, frame: &Frame) {
    for tick in frame.x.ticks() {
        let half = 0.5 * width(&tick.label, NUMBER) + 4.0;
        let x = frame.across(tick.fraction).clamp(half, (WIDTH - half).max(half));
        scene.text(tick.label, (x, frame.bottom() + 22.0), Anchor::Middle, NUMBER, SOFT_INK);
    }
}
