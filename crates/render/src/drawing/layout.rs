//! Layout of a drawing: title, views at one scale, key of the points, scale bar and legend.

use super::items::{View, circle_polyline, shading_colour};
use super::key::{KEY_COLUMN, KEY_ROW, draw_key, key_rows};
use super::numbers::draw_numbers;
use super::shapes::Drawing;
use super::vectors::{cross, dot};
use crate::palette::{GRID, INK, SOFT_INK};
use crate::scene::{Anchor, Point, Scene, solid};
use crate::text::{fit_to_width, medium, regular};

/// Width of the page, in page units.
const WIDTH: f64 = 900.0;
const MARGIN: f64 = 28.0;
/// Distance between views side by side; it contains no text.
const COLUMN_DISTANCE: f64 = 34.0;
/// Distance between views one above the other, for the title of the lower view.
const ROW_DISTANCE: f64 = 38.0;
/// Largest height of one row of views, and of two rows together.
const ONE_ROW: f64 = 430.0;
const TWO_ROWS: f64 = 700.0;
/// Smallest width of a view, for its title, and smallest height, for an arrow of a motion or of a load up or down from the middle.
const SMALLEST: [f64; 2] = [230.0, 124.0];
const SMALLEST_WITH_LOADS: [f64; 2] = [230.0, 212.0];
/// Columns of a key below the views.
const KEY_COLUMNS_BELOW: usize = 4;
/// Margin inside a view, for labels.
const LABEL_MARGIN: f64 = 26.0;

/// Views in first-angle projection: the view from the left is to the right of the view from the front, and the view
/// from above is below.
const VIEWS: [View; 3] = [
    View {
        right: [0.0, 1.0, 0.0],
        up: [0.0, 0.0, 1.0],
        label: "from the front (y to the right, z up)",
        hides_far_points: false,
    },
    // The views from the front and from above show the points of the other side.
    View {
        right: [-1.0, 0.0, 0.0],
        up: [0.0, 0.0, 1.0],
        label: "from the left (x to the left, z up)",
        hides_far_points: true,
    },
    View {
        right: [0.0, 1.0, 0.0],
        up: [-1.0, 0.0, 0.0],
        label: "from above (y to the right, x down)",
        hides_far_points: false,
    },
];

/// Rectangles of the views on the page, and the scale.
struct Grid {
    units_per_metre: f64,
    /// Widths of the columns, and heights of the rows.
    columns: [f64; 2],
    rows: [f64; 2],
}

impl Grid {
    /// Largest scale at which both columns and all rows fit. `spans`: extents of the drawing along x, y and z, m; `smallest`: width and
    /// height of the smallest view.
    fn fit(spans: [f64; 3], smallest: [f64; 2], has_top_view: bool) -> Self {
        let [x, y, z] = spans;
        let width_available = WIDTH - 2.0 * MARGIN - COLUMN_DISTANCE;
        let side = |scale: f64, span: f64, k: usize| (scale * span + 2.0 * LABEL_MARGIN).max(smallest[k]);
        let sizes = |scale: f64| {
            let columns = [side(scale, y, 0), side(scale, x, 0)];
            (columns, [side(scale, z, 1), if has_top_view { side(scale, x, 1) } else { 0.0 }])
        };
        let height = if has_top_view { TWO_ROWS } else { ONE_ROW };
        let fits = |scale: f64| {
            let (columns, rows) = sizes(scale);
            columns[0] + columns[1] <= width_available && rows[0] <= ONE_ROW && rows[0] + rows[1] <= height
        };
        // Bisection over the scale; the largest extent bounds the scale.
        let largest = x.max(y).max(z);
        let (mut low, mut high) = (0.0, width_available / largest);
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
        let rest = 0.5 * (width_available - columns[0] - columns[1]).max(0.0);
        columns = columns.map(|column| column + rest);
        Self { units_per_metre: low.max(f64::MIN_POSITIVE), columns, rows }
    }
}

/// Points that every view must contain.
fn bounding_points(drawing: &Drawing) -> Vec<[f64; 3]> {
    let facets = drawing.facets.iter().flat_map(|facet| facet.corners);
    let lines = facets.chain(drawing.lines.iter().flat_map(|line| line.ends));
    let circles = drawing.circles.iter().flat_map(circle_polyline);
    let arrows = drawing.arrows.iter().chain(&drawing.loads).map(|arrow| arrow.from);
    let symbols = drawing.symbols.iter().flat_map(|symbol| symbol.ends);
    let marks = drawing.marks.iter().chain(&drawing.points).map(|mark| mark.at);
    let all = lines.chain(circles).chain(arrows).chain(symbols).chain(marks);
    all.filter(|p| p.iter().all(|x| x.is_finite() && x.abs() < 1e9)).collect()
}

/// Lays out title, views, key, scale bar and legend on one page.
pub(super) fn layout_drawing(drawing: &Drawing) -> Scene {
    let width_available = WIDTH - 2.0 * MARGIN;
    let title = fit_to_width(&drawing.title, medium(19.0), width_available);
    let subtitle = fit_to_width(&drawing.subtitle, regular(13.0), width_available);
    let mut scene = Scene { width: WIDTH, height: 0.0, caption: title.clone(), items: Vec::new() };
    let mut top = 16.0;
    for (label, font, colour) in [(title, medium(19.0), INK), (subtitle, regular(13.0), SOFT_INK)] {
        if !label.is_empty() {
            top += 24.0;
            scene.text(label, (MARGIN, top), Anchor::Start, font, colour);
        }
    }
    top += if drawing.title.is_empty() && drawing.subtitle.is_empty() { 12.0 } else { 34.0 };
    let points = bounding_points(drawing);
    let spans = [0, 1, 2].map(|k| {
        let (low, high) = extent(points.iter().map(|p| p[k]));
        high - low
    });
    let smallest = if drawing.loads.is_empty() { SMALLEST } else { SMALLEST_WITH_LOADS };
    let grid = Grid::fit(spans, smallest, drawing.has_top_view);
    let second_column = MARGIN + grid.columns[0] + COLUMN_DISTANCE;
    let second_row = top + grid.rows[0] + ROW_DISTANCE;
    let corners = [(MARGIN, top), (second_column, top), (MARGIN, second_row)];
    let shown = if drawing.has_top_view { 3 } else { 2 };
    for (i, view) in VIEWS.iter().enumerate().take(shown) {
        let size = (grid.columns[i % 2], grid.rows[i / 2]);
        draw_view(&mut scene, drawing, view, &points, grid.units_per_metre, (corners[i], size));
    }
    let names: Vec<&str> = drawing.points.iter().map(|point| point.label.as_str()).collect();
    let bottom = if drawing.has_top_view {
        // The key fills the free quarter, or is below the views if it is longer.
        let most_columns = ((grid.columns[1] / KEY_COLUMN) as usize).clamp(1, 3);
        let rows_available = ((grid.rows[1] - KEY_ROW) / KEY_ROW) as usize;
        let (rows, columns) = key_rows(names.len(), rows_available, most_columns);
        let end_of_views = second_row + grid.rows[1];
        if rows <= rows_available {
            let area = (second_column, grid.columns[1]);
            draw_key(&mut scene, &names, area, second_row + 4.0, (rows, columns)).max(end_of_views)
        } else {
            let rows = key_rows(names.len(), 0, KEY_COLUMNS_BELOW);
            draw_key(&mut scene, &names, (MARGIN, width_available), end_of_views + 24.0, rows)
        }
    } else if names.is_empty() {
        top + grid.rows[0]
    } else {
        let rows = key_rows(names.len(), 0, 3);
        draw_key(&mut scene, &names, (MARGIN, width_available), top + grid.rows[0] + 24.0, rows)
    };
    draw_scale_bar(&mut scene, grid.units_per_metre, (MARGIN, bottom + 26.0));
    if !drawing.shading.is_empty() {
        draw_shading_legend(&mut scene, &drawing.shading, bottom);
    }
    scene.height = (bottom + 44.0).ceil();
    scene
}

/// Draws a view with its title and frame; the drawing is centred in the frame.
fn draw_view(
    scene: &mut Scene,
    drawing: &Drawing,
    view: &View,
    points: &[[f64; 3]],
    units_per_metre: f64,
    (corner, size): (Point, (f64, f64)),
) {
    let ((left, top), (width, height)) = (corner, size);
    let middle = |axis: &[f64; 3]| {
        let (low, high) = extent(points.iter().map(|p| dot(axis, p)));
        0.5 * (low + high)
    };
    let (centre_x, centre_y) = (middle(&view.right), middle(&view.up));
    let to_page = |p: &[f64; 3]| {
        let x = left + 0.5 * width + units_per_metre * (dot(&view.right, p) - centre_x);
        let y = top + 0.5 * height - units_per_metre * (dot(&view.up, p) - centre_y);
        (x, y)
    };
    let label = fit_to_width(view.label, medium(13.0), width);
    scene.text(label, (left, top - 12.0), Anchor::Start, medium(13.0), INK);
    drawing.draw_facets(scene, view, &to_page, units_per_metre, (corner, size));
    let (right, bottom) = (left + width, top + height);
    let frame = vec![(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
    scene.lines(vec![frame], solid(GRID, 1.0));
    drawing.draw_items(scene, &to_page, units_per_metre, (left, right));
    let eye = cross(&view.right, &view.up);
    let frame = ((left, top), (right, bottom));
    draw_numbers(scene, drawing, &to_page, (eye, units_per_metre, view.hides_far_points), frame);
}

/// Draws the colour scale of the shading below the views.
fn draw_shading_legend(scene: &mut Scene, shading: &str, bottom: f64) {
    let right = WIDTH - MARGIN;
    let label = fit_to_width(shading, regular(12.0), 0.5 * (WIDTH - 2.0 * MARGIN));
    let start = right - 100.0;
    for step in 0..20 {
        let x = start + 5.0 * f64::from(step);
        let line = vec![(x, bottom + 22.0), (x + 5.0, bottom + 22.0)];
        scene.lines(vec![line], solid(shading_colour(f64::from(step) / 19.0), 6.0));
    }
    let at = (start - 8.0, bottom + 26.0);
    scene.text(label + ": 0 to 100 %", at, Anchor::End, regular(12.0), SOFT_INK);
}

/// Draws a scale bar of 1, 2 or 5 times a power of ten, about a sixth of the page wide.
fn draw_scale_bar(scene: &mut Scene, units_per_metre: f64, (x, y): Point) {
    let target_length = 150.0 / units_per_metre;
    let power = 10_f64.powf(target_length.log10().floor());
    let long = [5.0, 2.0, 1.0].map(|m| m * power).into_iter().find(|l| *l <= target_length).unwrap_or(power);
    let end = x + long * units_per_metre;
    let line = vec![(x, y - 8.0), (x, y), (end, y), (end, y - 8.0)];
    scene.lines(vec![line], solid(SOFT_INK, 1.0));
    let label =
        if long < 1.0 { format!("{} mm", (1e3 * long * 1e6).round() / 1e6) } else { format!("{long} m") };
    scene.text(label, (end + 8.0, y), Anchor::Start, regular(12.0), SOFT_INK);
}

/// Smallest and largest drawable value; (0, 0) without values.
fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    crate::figure::axis::extent(values).unwrap_or((0.0, 0.0))
}
