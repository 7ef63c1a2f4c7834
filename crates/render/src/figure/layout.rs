//! Layout: converts a figure to a scene.

use crate::figure::axis::{Axis, drawable, extent};
use crate::figure::colours::assign_colours;
use crate::figure::curve;
use crate::figure::ends;
use crate::figure::legend::{DOT, ROW, WIDTH_RESERVE, band_tint, layout_legend, stroke};
use crate::figure::marks::{MarkStrip, layout_marks};
use crate::figure::{Figure, LabelledPoint, Panel, Series, Style};
use crate::font::Font;
use crate::palette::{AXIS, Colour, GRID, INK, SOFT_INK, ZERO};
use crate::scene::{Anchor, Item, Point, Scene, pixel_centre, solid};
use crate::text::{fit_to_width, medium, regular, width, wrap_to_width};

/// Width of a page, and of a page beside text.
const WIDTH: f64 = 900.0;
const HALF_WIDTH: f64 = 360.0;
/// Margin on the left and right of a page.
const MARGIN: f64 = 28.0;
const HALF_MARGIN: f64 = 6.0;
/// Height of a panel's frame.
const FRAME: f64 = 232.0;
/// Height of a panel's heading, above its frame.
const HEADING: f64 = 30.0;
/// Distance between a frame and the next heading.
const PANEL_DISTANCE: f64 = 24.0;
const TITLE: Font = medium(19.0);
const SUBTITLE: Font = regular(13.0);
const LABEL: Font = medium(13.0);
const NUMBER: Font = regular(12.0);
/// Distance between tick label and axis.
const LABEL_DISTANCE: f64 = 8.0;
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
    /// y of the lower edge of the frame, page units.
    fn bottom(&self) -> f64 {
        self.top + FRAME
    }
    /// x on the page at a fraction of the x axis.
    fn x_at(&self, fraction: f64) -> f64 {
        self.left + fraction * (self.right - self.left)
    }
    /// y on the page at a fraction of the y axis, from the bottom.
    fn y_at(&self, fraction: f64) -> f64 {
        self.bottom() - fraction * FRAME
    }
    /// Position of a data point on the page.
    fn point_at(&self, x: f64, y: f64) -> Point {
        (self.x_at(self.x.fraction(x)), self.y_at(self.y.fraction(y)))
    }
    /// True if a data point lies outside the axes, so that its series must be clipped.
    fn needs_clipping(&self, panel: &Panel) -> bool {
        let holds = |&(x, y): &(f64, Option<f64>)| {
            let inside = |axis: &Axis, v: f64| drawable(v).is_none_or(|v| axis.contains(v));
            inside(self.x, x) && y.is_none_or(|y| inside(self.y, y))
        };
        !panel.series.iter().flat_map(|s| &s.points).all(holds)
    }
    /// Vertical grid line from the upper to the lower edge of the frame.
    fn vertical_line(&self, x: f64) -> Vec<Point> {
        vec![(pixel_centre(x), self.top), (pixel_centre(x), self.bottom())]
    }
    /// Horizontal grid line from the left to the right edge of the frame.
    fn horizontal_line(&self, y: f64) -> Vec<Point> {
        vec![(self.left, pixel_centre(y)), (self.right, pixel_centre(y))]
    }
}

/// Largest number of lines of a title and of a subtitle.
const TITLE_LINES: usize = 3;

/// Lays out a figure on one page.
pub(crate) fn layout_figure(figure: &Figure) -> Scene {
    let (page, margin) = if figure.is_half { (HALF_WIDTH, HALF_MARGIN) } else { (WIDTH, MARGIN) };
    let panels: Vec<Panel> = figure.panels.iter().map(ends::merge_equal).collect();
    let title = wrap_to_width(&figure.title, TITLE, page - 2.0 * margin, TITLE_LINES);
    let subtitle = wrap_to_width(&figure.subtitle, SUBTITLE, page - 2.0 * margin, TITLE_LINES);
    let mut scene =
        Scene { width: page, height: 0.0, caption: caption(figure, &title, &subtitle), items: Vec::new() };

    let mut y_cursor = if figure.is_half { -12.0 } else { 16.0 };
    for (lines, font, colour, height) in [(title, TITLE, INK, 24.0), (subtitle, SUBTITLE, SOFT_INK, 20.0)] {
        for text in lines {
            y_cursor += height;
            scene.text(text, (margin, y_cursor), Anchor::Start, font, colour);
        }
    }
    y_cursor += 12.0;

    let y_axes: Vec<Axis> = panels.iter().map(|panel| scaled(y_axis(panel), figure)).collect();
    let left = margin + LABEL_DISTANCE + widest(&y_axes).ceil();
    let names = ends::width_of_names(&panels, page);
    let right = page - margin - names.unwrap_or(0.0);
    let x_axis = x_axis(figure, right - left);
    let colours = assign_colours(&panels);
    let strip = layout_marks(&figure.marks, &x_axis, left, right);

    for (i, ((panel, y_axis), colours)) in panels.iter().zip(&y_axes).zip(&colours).enumerate() {
        let baseline = y_cursor + 20.0;
        let label = fit_to_width(&panel.y_label, LABEL, right - margin);
        let heading_width = right - margin - WIDTH_RESERVE * width(&label, LABEL) - 32.0;
        scene.text(label, (margin, baseline), Anchor::Start, LABEL, INK);
        // Series without a name at their end are in the legend.
        let is_listed = |series: &Series| names.is_none() || !ends::is_line(series);
        let listed: Vec<Series> = if panel.series.len() > 1 {
            panel.series.iter().filter(|series| is_listed(series)).cloned().collect()
        } else {
            Vec::new()
        };
        let of_listed: Vec<Colour> = panel
            .series
            .iter()
            .zip(colours)
            .filter(|(series, _)| is_listed(series))
            .map(|(_, c)| *c)
            .collect();
        let legend = layout_legend(&listed, right - margin, heading_width);
        let above = HEADING + legend.rows as f64 * ROW + if i == 0 { strip.height() } else { 0.0 };
        legend.draw(&mut scene, &listed, &of_listed, (margin, right), baseline);
        let frame = Frame { x: &x_axis, y: y_axis, left, right, top: y_cursor + above };
        draw_panel(&mut scene, panel, colours, &frame, &strip, i == 0);
        if let Some(available) = names {
            let place = (right, frame.top, frame.bottom());
            ends::draw_names(&mut scene, panel, colours, &|x, y| frame.point_at(x, y), place, available);
        }
        draw_values(&mut scene, panel, colours, &frame);
        y_cursor = frame.bottom();
        if i + 1 < figure.panels.len() {
            y_cursor += PANEL_DISTANCE;
        } else {
            draw_x_labels(&mut scene, &frame, page);
        }
    }
    if figure.panels.is_empty() {
        scene.text("nothing to draw".into(), (margin, y_cursor + 20.0), Anchor::Start, SUBTITLE, SOFT_INK);
        y_cursor += 20.0;
    } else {
        let label = fit_to_width(&figure.x_label, LABEL, right - left);
        scene.text(label, (0.5 * (left + right), y_cursor + 46.0), Anchor::Middle, LABEL, INK);
        y_cursor += if figure.x_label.trim().is_empty() { 28.0 } else { 50.0 };
    }
    scene.height = (y_cursor + 14.0).ceil();
    scene
}

/// Description of a figure: its title and subtitle, or the labels of its axes.
fn caption(figure: &Figure, title: &[String], subtitle: &[String]) -> String {
    let titles = [title.join(" "), subtitle.join(" ")].into_iter().filter(|text| !text.is_empty());
    let titles = titles.collect::<Vec<_>>().join(" — ");
    if !titles.is_empty() {
        return titles;
    }
    let labels = figure.panels.iter().map(|panel| &panel.y_label).chain([&figure.x_label]);
    let labels = labels.map(|label| fit_to_width(label, LABEL, WIDTH)).filter(|label| !label.is_empty());
    labels.collect::<Vec<_>>().join(" over ")
}

/// Draws the labelled values of a panel with their uncertainty.
fn draw_values(scene: &mut Scene, panel: &Panel, colours: &[Colour], frame: &Frame) {
    let colour = colours.first().copied().unwrap_or(INK);
    for value in &panel.values {
        let (Some(x), Some(y)) = (drawable(value.x), drawable(value.y)) else { continue };
        if !(frame.x.contains(x) && frame.y.contains(y)) {
            continue;
        }
        let at = frame.point_at(x, y);
        let mut above = 9.0;
        if let Some(spread) = value.spread.and_then(drawable) {
            let ends =
                [y + spread, y - spread].map(|y| frame.point_at(x, y).1.clamp(frame.top, frame.bottom()));
            let cap = |y: f64| vec![(at.0 - 4.0, y), (at.0 + 4.0, y)];
            scene.lines(
                vec![vec![(at.0, ends[0]), (at.0, ends[1])], cap(ends[0]), cap(ends[1])],
                solid(colour, 1.5),
            );
            above += at.1 - ends[0];
        }
        scene.dots(vec![at], 4.0, colour);
        // Below the curve without an uncertainty, and inside the frame.
        let y = if value.spread.is_none() && at.1 + 24.0 < frame.bottom() {
            at.1 + 20.0
        } else {
            (at.1 - above).max(frame.top + 12.0)
        };
        let half = 0.5 * WIDTH_RESERVE * width(&value.label, LABEL) + 4.0;
        let is_right = at.0 + half > frame.right;
        let anchor = if is_right { Anchor::End } else { Anchor::Middle };
        let x = if is_right { at.0.min(frame.right) - 6.0 } else { at.0.max(frame.left + half) };
        scene.text_with_halo(value.label.clone(), (x, y), anchor, LABEL, INK);
    }
}

/// Axis of a panel: the given limits, or the range of the points with a margin.
fn y_axis(panel: &Panel) -> Axis {
    if let Some(limits) = panel.y_limits.and_then(|(low, high)| extent([low, high].into_iter())) {
        return Axis::without_margin(Some(limits), 6);
    }
    let points = panel.series.iter().flat_map(|s| &s.points);
    // A value without a drawable x is not drawn, so it does not affect the range.
    let points = points.filter(|p| drawable(p.0).is_some()).filter_map(|p| p.1);
    let spread = |value: &LabelledPoint| value.spread.unwrap_or(0.0);
    let values = panel.values.iter().flat_map(|value| [value.y + spread(value), value.y - spread(value)]);
    Axis::with_margin(extent(points.chain(values)), 6)
}

/// Shared x axis with as many ticks as fit side by side.
fn x_axis(figure: &Figure, width_available: f64) -> Axis {
    let points = figure.panels.iter().flat_map(|p| &p.series).flat_map(|s| &s.points).map(|p| p.0);
    let points = points.chain(figure.panels.iter().flat_map(|p| &p.values).map(|value| value.x));
    let limits = figure.x_limits.and_then(|(low, high)| extent([low, high].into_iter()));
    let range = limits.or_else(|| extent(points)).or_else(|| extent(figure.marks.iter().map(|m| m.x)));
    let fits = |axis: &Axis| {
        let ticks = axis.ticks();
        let step = width_available / (ticks.len().max(2) - 1) as f64;
        ticks.iter().all(|t| width(&t.label, NUMBER) + 18.0 < step)
    };
    (2..=10)
        .rev()
        .map(|most| Axis::without_margin(range, most))
        .map(|axis| scaled(axis, figure))
        .find(fits)
        .unwrap_or_else(|| scaled(Axis::without_margin(range, 2), figure))
}

/// The axis, or the axis of the logarithms.
fn scaled(axis: Axis, figure: &Figure) -> Axis {
    if figure.is_logarithmic { axis.of_logarithms() } else { axis }
}

/// Width of the widest tick label of all axes, at least 24 page units.
fn widest(axes: &[Axis]) -> f64 {
    axes.iter().flat_map(Axis::ticks).map(|t| width(&t.label, NUMBER)).fold(24.0, f64::max)
}

/// Draws the frame, marks and series of a panel; `first` also draws the labels of the marks.
fn draw_panel(
    scene: &mut Scene,
    panel: &Panel,
    colours: &[Colour],
    frame: &Frame,
    strip: &MarkStrip,
    first: bool,
) {
    draw_grid(scene, frame);
    strip.draw_lines(scene, frame.top, frame.bottom(), first);
    if first {
        strip.draw_labels(scene, frame.top);
    }

    let point_at = |x, y| frame.point_at(x, y);
    let mut empty = true;
    let inside = ((frame.left, frame.top), (frame.right, frame.bottom()));
    let is_clipped = frame.needs_clipping(panel);
    let is_band = |(series, _): &(&Series, &Colour)| series.style == Style::Band;
    let (bands, others): (Vec<_>, Vec<_>) = panel.series.iter().zip(colours).partition(is_band);
    for (series, &colour) in bands.into_iter().chain(others.into_iter().rev()) {
        let before = scene.items.len();
        if series.style == Style::Dots {
            let dots = curve::merged_dots(&series.points, point_at);
            let dots = dots.into_iter().filter(|p| !is_clipped || curve::is_inside(*p, inside)).collect();
            scene.dots(dots, DOT, colour);
        } else if series.style == Style::Band {
            draw_band(scene, &series.points, colour, frame);
        } else if series.style == Style::Bars {
            draw_bars(scene, &series.points, colour, frame);
        } else {
            let mut curve = curve::polylines(&series.points, point_at);
            if is_clipped {
                curve = curve.clipped_to(inside);
            }
            scene.lines(curve.chains, stroke(series.style, colour));
            scene.dots(curve.isolated, DOT, colour);
        }
        empty &= scene.items.len() == before;
    }
    if empty {
        let at = (0.5 * (frame.left + frame.right), frame.top + 0.5 * FRAME);
        scene.text_with_halo("no value to draw".into(), at, Anchor::Middle, SUBTITLE, SOFT_INK);
    }
}

/// Draws the polygons of a band inside the frame, in a light tint so that the grid's labels and the lines stay readable.
fn draw_band(scene: &mut Scene, points: &[(f64, Option<f64>)], colour: Colour, frame: &Frame) {
    let on_page = |&(x, y): &(f64, Option<f64>)| {
        let (x, y) = frame.point_at(drawable(x)?, drawable(y?)?);
        Some((x.clamp(frame.left, frame.right), y.clamp(frame.top, frame.bottom())))
    };
    let points: Vec<Option<Point>> = points.iter().map(on_page).collect();
    for polygon in points.split(Option::is_none).filter(|polygon| polygon.len() > 2) {
        let corners = polygon.iter().copied().flatten().collect();
        scene.items.push(Item::Area { corners, colour: band_tint(colour) });
    }
}

/// Draws the bars of a histogram inside the frame, with thin gaps between them.
fn draw_bars(scene: &mut Scene, points: &[(f64, Option<f64>)], colour: Colour, frame: &Frame) {
    for pair in points.windows(2) {
        let (Some(from), Some(to), Some(y)) =
            (drawable(pair[0].0), drawable(pair[1].0), pair[0].1.and_then(drawable))
        else {
            continue;
        };
        let at = |x: f64, y: f64| {
            let (x, y) = frame.point_at(x, y);
            (x.clamp(frame.left, frame.right), y.clamp(frame.top, frame.bottom()))
        };
        let (low, high) = (at(from.min(to), 0.0), at(from.max(to), y));
        if y != 0.0 && high.0 > low.0 {
            let gap = (0.1 * (high.0 - low.0)).min(0.5);
            scene.items.push(Item::Patch {
                from: (low.0 + gap, low.1.min(high.1)),
                to: (high.0 - gap, low.1.max(high.1)),
                colour,
            });
        }
    }
}

/// Draws the grid, the zero lines, the axis and the tick labels of y.
fn draw_grid(scene: &mut Scene, frame: &Frame) {
    let vertical_lines =
        |fractions: Vec<f64>| fractions.into_iter().map(|f| frame.vertical_line(frame.x_at(f)));
    let horizontal_lines =
        |fractions: Vec<f64>| fractions.into_iter().map(|f| frame.horizontal_line(frame.y_at(f)));
    let tick_fractions = |axis: &Axis| axis.ticks().iter().map(|t| t.fraction).collect::<Vec<_>>();
    let major =
        vertical_lines(tick_fractions(frame.x)).chain(horizontal_lines(tick_fractions(frame.y))).collect();
    scene.lines(major, solid(GRID, 1.0));
    let zero = |axis: &Axis| if axis.contains(0.0) { vec![axis.fraction(0.0)] } else { Vec::new() };
    scene.lines(
        vertical_lines(zero(frame.x)).chain(horizontal_lines(zero(frame.y))).collect(),
        solid(ZERO, 1.0),
    );

    let tick_mark = |f: f64| {
        vec![
            (pixel_centre(frame.x_at(f)), frame.bottom()),
            (pixel_centre(frame.x_at(f)), frame.bottom() + 5.0),
        ]
    };
    let mut axis: Vec<Vec<Point>> = tick_fractions(frame.x).into_iter().map(tick_mark).collect();
    axis.push(frame.horizontal_line(frame.bottom()));
    scene.lines(axis, solid(AXIS, 1.0));
    for tick in frame.y.ticks() {
        let at = (frame.left - LABEL_DISTANCE, frame.y_at(tick.fraction) + HALF_DIGIT);
        scene.text(tick.label, at, Anchor::End, NUMBER, SOFT_INK);
    }
}

/// Draws the tick labels of x below the last panel; labels at the ends are moved to stay on the page.
fn draw_x_labels(scene: &mut Scene, frame: &Frame, page: f64) {
    for tick in frame.x.ticks() {
        let half = 0.5 * width(&tick.label, NUMBER) + 4.0;
        let x = frame.x_at(tick.fraction).clamp(half, (page - half).max(half));
        scene.text(tick.label, (x, frame.bottom() + 22.0), Anchor::Middle, NUMBER, SOFT_INK);
    }
}
