//! Layout of a drawing: title, views at one scale, scale bar and legend.

use super::items::{PageArrow, View, circle_polylines, line_width, shading_colour};
use super::names::{draw_names, draw_points};
use super::shapes::{Drawing, Views};
use super::vectors::dot;
use crate::font::Font;
use crate::palette::{GRID, INK, SOFT_INK};
use crate::scene::{Anchor, Point, Scene, solid};
use crate::text::{fit_to_width, medium, regular, width};

/// Width of the page, in page units, and of a page with one view beside text.
const WIDTH: f64 = 900.0;
const HALF_WIDTH: f64 = 360.0;
const MARGIN: f64 = 28.0;
const HALF_MARGIN: f64 = 6.0;
/// Distance between views side by side; it contains no text.
const COLUMN_DISTANCE: f64 = 34.0;
/// Distance between views one above the other, for the title of the lower view.
const ROW_DISTANCE: f64 = 38.0;
/// Largest height of one row of views, of two rows together, and of a view on a page of half the width.
const ONE_ROW: f64 = 430.0;
const TWO_ROWS: f64 = 700.0;
const HALF_ROW: f64 = 330.0;
/// Smallest width of a view, for its title, and smallest height.
const SMALLEST: [f64; 2] = [230.0, 90.0];
/// Margins inside a view, for the names beside and above the parts.
const NAME_MARGIN: [f64; 2] = [64.0, 26.0];
const LABEL_MARGIN: [f64; 2] = [26.0, 26.0];
/// Extent of a view relative to the largest extent of the drawing, below which the view is only a line.
const LINE: f64 = 0.03;
const FONT: Font = regular(13.0);

/// Views in first-angle projection: the view from the left is to the right of the view from the front, and the view
/// from above is below.
const VIEWS: [View; 3] = [
    View { right: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], label: "from the front (y to the right, z up)" },
    View { right: [-1.0, 0.0, 0.0], up: [0.0, 0.0, 1.0], label: "from the left (x to the left, z up)" },
    View { right: [0.0, 1.0, 0.0], up: [-1.0, 0.0, 0.0], label: "from above (y to the right, x down)" },
];

/// Content of a view on the page: points in space, m, and arrows with a length on the page.
struct Content<'a> {
    points: Vec<[f64; 3]>,
    arrows: Vec<PageArrow<'a>>,
    margin: [f64; 2],
}

impl<'a> Content<'a> {
    fn of(drawing: &'a Drawing) -> Self {
        let margin = if drawing.names.is_empty() { LABEL_MARGIN } else { NAME_MARGIN };
        Self { points: bounding_points(drawing), arrows: drawing.page_arrows(), margin }
    }

    /// Smallest and largest position along an axis of a view, page units.
    fn extent(&self, axis: &[f64; 3], scale: f64) -> (f64, f64) {
        let points = self.points.iter().map(|p| scale * dot(axis, p));
        let arrows = self.arrows.iter().flat_map(|arrow| arrow.ends_along(axis, scale));
        extent(points.chain(arrows))
    }

    /// Width and height of a view, page units.
    fn size(&self, view: &View, scale: f64) -> (f64, f64) {
        let side = |axis: &[f64; 3], k: usize| {
            let (low, high) = self.extent(axis, scale);
            (high - low + 2.0 * self.margin[k]).max(SMALLEST[k])
        };
        (side(&view.right, 0), side(&view.up, 1))
    }

    /// Extents of a view in space, m.
    fn spans(&self, view: &View) -> [f64; 2] {
        [view.right, view.up].map(|axis| {
            let (low, high) = extent(self.points.iter().map(|p| dot(&axis, p)));
            high - low
        })
    }
}

/// Views of a drawing in their order, without those that show only a line; at least one.
fn views(drawing: &Drawing, content: &Content) -> Vec<&'static View> {
    let count = if drawing.views == Views::Two { 2 } else { 3 };
    let largest = VIEWS.iter().flat_map(|view| content.spans(view)).fold(0.0, f64::max);
    let is_area = |view: &&View| content.spans(view).iter().all(|span| *span > LINE * largest);
    // The area counts by the part of the arrows that is in the plane of the view. A line has the width of a line.
    let score = |view: &&View| {
        let area = content.spans(view).iter().map(|span| span.max(LINE * largest)).product::<f64>();
        let part = |arrow: &PageArrow| arrow.part_in_plane(&view.right, &view.up).powi(4);
        area * content.arrows.iter().map(part).fold(1.0, f64::min)
    };
    let best = || VIEWS.iter().rev().max_by(|a, b| score(a).total_cmp(&score(b)));
    let shown: Vec<&View> = match drawing.views {
        Views::Best => best().into_iter().collect(),
        _ => VIEWS.iter().take(count).filter(is_area).collect(),
    };
    if shown.is_empty() { best().or(VIEWS.first()).into_iter().collect() } else { shown }
}

/// Places of the views: columns and rows with their sizes, and the scale.
struct Grid {
    units_per_metre: f64,
    /// Column and row of each view.
    cells: Vec<(usize, usize)>,
    columns: [f64; 2],
    rows: [f64; 2],
}

impl Grid {
    /// Largest scale at which the columns and rows fit.
    fn fit(content: &Content, views: &[&View], width: f64, heights: [f64; 2]) -> Self {
        // A view from above is below that from the front.
        let cell = |i: usize| if i < 2 { (i, 0) } else { (0, 1) };
        let cells: Vec<(usize, usize)> = (0..views.len()).map(cell).collect();
        let sizes = |scale: f64| {
            let (mut columns, mut rows) = ([0.0_f64; 2], [0.0_f64; 2]);
            for (view, &(column, row)) in views.iter().zip(&cells) {
                let (wide, high) = content.size(view, scale);
                columns[column] = columns[column].max(wide);
                rows[row] = rows[row].max(high);
            }
            (columns, rows)
        };
        let available = if views.len() > 1 { width - COLUMN_DISTANCE } else { width };
        let fits = |scale: f64| {
            let (columns, rows) = sizes(scale);
            columns.iter().sum::<f64>() <= available
                && rows[0] <= heights[0]
                && rows[0] + rows[1] <= heights[1]
        };
        // Bisection over the scale; the largest extent bounds the scale.
        let largest = views.iter().flat_map(|view| content.spans(view)).fold(0.0, f64::max);
        let (mut low, mut high) = (0.0, width / largest);
        if largest > 0.0 && high.is_finite() {
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if fits(middle) { low = middle } else { high = middle }
            }
        } else {
            low = 1.0;
        }
        let (mut columns, rows) = sizes(low);
        // The rest of the width is divided evenly.
        let used = if views.len() > 1 { 2.0 } else { 1.0 };
        let rest = (available - columns[0] - columns[1]).max(0.0) / used;
        columns.iter_mut().filter(|column| **column > 0.0).for_each(|column| *column += rest);
        Self { units_per_metre: low.max(f64::MIN_POSITIVE), cells, columns, rows }
    }
}

/// Points that every view must contain.
fn bounding_points(drawing: &Drawing) -> Vec<[f64; 3]> {
    let facets = drawing.facets.iter().flat_map(|facet| facet.corners);
    let lines = facets.chain(drawing.lines.iter().flat_map(|line| line.ends));
    let circles = drawing.circles.iter().flat_map(circle_polylines).flatten();
    let symbols = drawing.symbols.iter().flat_map(|symbol| symbol.ends);
    let marks = drawing.marks.iter().chain(&drawing.points).map(|mark| mark.at);
    let all = lines.chain(circles).chain(symbols).chain(marks);
    all.filter(|p| p.iter().all(|x| x.is_finite() && x.abs() < 1e9)).collect()
}

/// Lays out title, views, scale bar and legend on one page.
pub(super) fn layout_drawing(drawing: &Drawing) -> Scene {
    let is_half = drawing.views == Views::Best;
    let (width, margin) = if is_half { (HALF_WIDTH, HALF_MARGIN) } else { (WIDTH, MARGIN) };
    let width_available = width - 2.0 * margin;
    let title = fit_to_width(&drawing.title, medium(19.0), width_available);
    let subtitle = fit_to_width(&drawing.subtitle, regular(13.0), width_available);
    let content = Content::of(drawing);
    let views = views(drawing, &content);
    let described = if drawing.content.is_empty() { &title } else { &drawing.content };
    let of_views: Vec<&str> = views.iter().map(|view| view.label).collect();
    let caption = format!("{described} {}", of_views.join(", ")).trim().to_owned();
    let mut scene = Scene { width, height: 0.0, caption, items: Vec::new() };
    let mut top = 16.0;
    for (label, font, colour) in [(title, medium(19.0), INK), (subtitle, regular(13.0), SOFT_INK)] {
        if !label.is_empty() {
            top += 24.0;
            scene.text(label, (margin, top), Anchor::Start, font, colour);
        }
    }
    top += if drawing.title.is_empty() && drawing.subtitle.is_empty() { 12.0 } else { 34.0 };
    let heights = match (is_half, views.len()) {
        (true, _) => [HALF_ROW; 2],
        (false, 1) => [ONE_ROW; 2],
        (false, _) => [ONE_ROW, TWO_ROWS],
    };
    let grid = Grid::fit(&content, &views, width_available, heights);
    for (view, &(column, row)) in views.iter().zip(&grid.cells) {
        let left = margin + if column == 0 { 0.0 } else { grid.columns[0] + COLUMN_DISTANCE };
        let upper = top + if row == 0 { 0.0 } else { grid.rows[0] + ROW_DISTANCE };
        let size = (grid.columns[column], grid.rows[row]);
        draw_view(&mut scene, drawing, view, &content, grid.units_per_metre, ((left, upper), size));
    }
    let has_second_row = grid.rows[1] > 0.0;
    let bottom = top + grid.rows[0] + if has_second_row { ROW_DISTANCE + grid.rows[1] } else { 0.0 };
    draw_scale_bar(&mut scene, grid.units_per_metre, (margin, bottom + 26.0), 0.17 * width);
    if let Some((shading, most)) = &drawing.shading {
        draw_shading_legend(&mut scene, shading, *most, (width - margin, bottom), 0.6 * width_available);
    }
    scene.height = (bottom + 40.0).ceil();
    scene
}

/// Draws a view with its title and frame; the drawing is centred in the frame.
fn draw_view(
    scene: &mut Scene,
    drawing: &Drawing,
    view: &View,
    content: &Content,
    units_per_metre: f64,
    (corner, size): (Point, (f64, f64)),
) {
    let ((left, top), (width, height)) = (corner, size);
    let middle = |axis: &[f64; 3]| {
        let (low, high) = content.extent(axis, units_per_metre);
        0.5 * (low + high)
    };
    let (centre_x, centre_y) = (middle(&view.right), middle(&view.up));
    let to_page = |p: &[f64; 3]| {
        let x = left + 0.5 * width + units_per_metre * dot(&view.right, p) - centre_x;
        let y = top + 0.5 * height - units_per_metre * dot(&view.up, p) + centre_y;
        (x, y)
    };
    let label = fit_to_width(view.label, FONT, width);
    scene.text(label, (left, top - 10.0), Anchor::Start, FONT, SOFT_INK);
    drawing.draw_facets(scene, view, &to_page, units_per_metre, (corner, size));
    let (right, bottom) = (left + width, top + height);
    if drawing.views != Views::Best {
        let frame = vec![(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        scene.lines(vec![frame], solid(GRID, 1.0));
    }
    drawing.draw_items(scene, &to_page);
    let frame = ((left, top), (right, bottom));
    draw_points(scene, drawing, &to_page, frame);
    // Names keep clear of the arrows, which are drawn above them.
    let arrows = content.arrows.iter().map(|arrow| {
        let ([x0, x1], [y0, y1]) =
            (arrow.ends_along(&view.right, units_per_metre), arrow.ends_along(&view.up, units_per_metre));
        let at = |x: f64, y: f64| (left + 0.5 * width + x - centre_x, top + 0.5 * height - y + centre_y);
        let (a, b) = (at(x0, y0), at(x1, y1));
        ((a.0.min(b.0) - 4.0, a.1.min(b.1) - 4.0), (a.0.max(b.0) + 4.0, a.1.max(b.1) + 4.0))
    });
    let symbols = drawing.symbols.iter().map(|symbol| {
        let [a, b] = symbol.ends.map(|end| to_page(&end));
        ((a.0.min(b.0), a.1.min(b.1)), (a.0.max(b.0), a.1.max(b.1)))
    });
    draw_names(scene, drawing, &to_page, frame, &arrows.chain(symbols).collect::<Vec<_>>());
    drawing.draw_arrows(scene, &to_page, view, (left, right));
}

/// Draws the scale of the shading, in colour and width, below the views: from 0 to the largest value, in percent.
fn draw_shading_legend(scene: &mut Scene, shading: &str, most: f64, (right, bottom): Point, available: f64) {
    let end = format!("{most:.0} %");
    let end_width = width(&end, FONT);
    let start = right - end_width - 8.0 - 80.0;
    for step in 0..20 {
        let x = start + 4.0 * f64::from(step);
        let value = f64::from(step) / 19.0;
        let line = vec![(x, bottom + 21.5), (x + 4.2, bottom + 21.5)];
        scene.lines(vec![line], solid(shading_colour(value), line_width(value)));
    }
    scene.text(end, (right, bottom + 26.0), Anchor::End, FONT, SOFT_INK);
    let label = fit_to_width(&format!("{shading}: 0"), FONT, available - 80.0 - end_width);
    scene.text(label, (start - 6.0, bottom + 26.0), Anchor::End, FONT, SOFT_INK);
}

/// Draws a scale bar of 1, 2 or 5 times a power of ten, at most `longest` page units long.
fn draw_scale_bar(scene: &mut Scene, units_per_metre: f64, (x, y): Point, longest: f64) {
    let target_length = longest / units_per_metre;
    let power = 10_f64.powf(target_length.log10().floor());
    let long = [5.0, 2.0, 1.0].map(|m| m * power).into_iter().find(|l| *l <= target_length).unwrap_or(power);
    let end = x + long * units_per_metre;
    let line = vec![(x, y - 8.0), (x, y), (end, y), (end, y - 8.0)];
    scene.lines(vec![line], solid(SOFT_INK, 1.0));
    let label =
        if long < 1.0 { format!("{} mm", (1e3 * long * 1e6).round() / 1e6) } else { format!("{long} m") };
    scene.text(label, (end + 8.0, y), Anchor::Start, FONT, SOFT_INK);
}

/// Smallest and largest drawable value; (0, 0) without values.
fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    crate::figure::axis::extent(values).unwrap_or((0.0, 0.0))
}
