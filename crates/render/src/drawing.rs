//! Drawing of a mechanism in two orthographic views: lines, circles, arrows and labelled points in space.

use crate::backend::RenderError;
use crate::convert;
use crate::palette::{Colour, GRID, INK, PAPER, SOFT_INK};
use crate::raster::Raster;
use crate::scene::{Anchor, Item, Point, Scene, solid};
use crate::svg;
use crate::text::{fit_to_width, medium, regular, width};

/// Width of the page, in page units.
const WIDTH: f64 = 900.0;
const MARGIN: f64 = 28.0;
const VIEW_DISTANCE: f64 = 34.0;
/// Largest height of a view.
const HEIGHT: f64 = 430.0;
/// Margin inside a view, for labels.
const LABEL_MARGIN: f64 = 26.0;
/// Segments per circle.
const SEGMENTS: usize = 64;
/// Colours of shading values 0 and 1.
const SHADING_LOW: Colour = Colour(186, 193, 203);
const SHADING_HIGH: Colour = Colour(213, 94, 0);
/// Raster pixels per page unit.
const PIXELS_PER_UNIT: f64 = 2.0;
/// Weight of the shading colour on facets. The rest is paper colour, so that lines on top stay visible.
const SHADING_WEIGHT: f64 = 0.42;
const BLUE: Colour = Colour(0, 114, 178);

/// Drawing of a mechanism; lengths in metres, x forward, y to the left, z up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Title; no title if empty.
    pub title: String,
    /// Subtitle; no subtitle if empty.
    pub subtitle: String,
    /// Quantity shown by the shading; no legend if empty.
    pub shading: String,
    /// Facets of link shapes, drawn below the lines.
    pub facets: Vec<DrawnFacet>,
    /// Lines.
    pub lines: Vec<DrawnLine>,
    /// Circles, such as wheels.
    pub circles: Vec<DrawnCircle>,
    /// Arrows.
    pub arrows: Vec<DrawnArrow>,
    /// Labelled points.
    pub marks: Vec<crate::SkinMark>,
}

/// Triangle of a link shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawnFacet {
    /// Corners, m.
    pub corners: [[f64; 3]; 3],
    /// Shading value from 0 to 1; `None` is drawn as 0.
    pub intensity: Option<f64>,
}

/// A straight line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawnLine {
    /// End points, m.
    pub ends: [[f64; 3]; 2],
    /// Shading value from 0 to 1; `None` is drawn in ink without shading.
    pub intensity: Option<f64>,
}

/// A circle in space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawnCircle {
    /// Centre, m.
    pub centre: [f64; 3],
    /// Unit normal of the circle's plane.
    pub axis: [f64; 3],
    /// Radius, m.
    pub radius: f64,
}

/// Arrow. Its length shows a magnitude, not a distance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnArrow {
    /// Start point, m.
    pub from: [f64; 3],
    /// Direction and relative magnitude; the longest arrow of a drawing has a fixed length on the page.
    pub vector: [f64; 3],
    /// Label; none if empty. Labelled arrows are drawn thicker and as long as the longest.
    pub label: String,
}

/// Viewing direction: axes of the page in space, and title.
struct View {
    right: [f64; 3],
    up: [f64; 3],
    label: &'static str,
}

const VIEWS: [View; 2] = [
    View { right: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], label: "from the front (y to the right, z up)" },
    View { right: [-1.0, 0.0, 0.0], up: [0.0, 0.0, 1.0], label: "from the left (x to the left, z up)" },
];

/// Scalar product.
fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Vector product.
fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Difference a − b.
fn difference(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Euclidean norm.
fn length(v: &[f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

impl Drawing {
    /// Returns the drawing as an SVG document.
    pub fn to_svg(&self) -> String {
        svg::write(&self.layout_scene())
    }

    /// Returns the drawing as a PNG with `scale` pixels per page unit.
    ///
    /// # Errors
    /// [`RenderError::Scale`], or [`RenderError::TooLarge`] above 2^25 pixels.
    pub fn to_png(&self, scale: f32) -> Result<Vec<u8>, RenderError> {
        convert::png(&self.to_svg(), scale)
    }

    /// Returns the drawing as a PDF of one page with embedded fonts.
    ///
    /// # Errors
    /// Errors of the PDF writer.
    pub fn to_pdf(&self) -> Result<Vec<u8>, RenderError> {
        convert::pdf(&self.layout_scene())
    }

    /// Points that every view must contain.
    fn bounding_points(&self) -> Vec<[f64; 3]> {
        let facets = self.facets.iter().flat_map(|facet| facet.corners);
        let lines = facets.chain(self.lines.iter().flat_map(|line| line.ends));
        let circles = self.circles.iter().flat_map(circle_polyline);
        let arrows = self.arrows.iter().map(|arrow| arrow.from);
        let all = lines.chain(circles).chain(arrows).chain(self.marks.iter().map(|mark| mark.at));
        all.filter(|p| p.iter().all(|x| x.is_finite() && x.abs() < 1e9)).collect()
    }

    /// Lays out title, both views, scale bar and legend on one page.
    fn layout_scene(&self) -> Scene {
        let width_available = WIDTH - 2.0 * MARGIN;
        let title = fit_to_width(&self.title, medium(19.0), width_available);
        let subtitle = fit_to_width(&self.subtitle, regular(13.0), width_available);
        let mut scene = Scene { width: WIDTH, height: 0.0, caption: title.clone(), items: Vec::new() };
        let mut top = 16.0;
        for (label, font, colour) in [(title, medium(19.0), INK), (subtitle, regular(13.0), SOFT_INK)] {
            if !label.is_empty() {
                top += 24.0;
                scene.text(label, (MARGIN, top), Anchor::Start, font, colour);
            }
        }
        top += 34.0;
        let points = self.bounding_points();
        let side = 0.5 * (width_available - VIEW_DISTANCE);
        // Both views have the same scale and height.
        let extents: Vec<[(f64, f64); 2]> = VIEWS
            .iter()
            .map(|view| [&view.right, &view.up].map(|axis| extent(points.iter().map(|p| dot(axis, p)))))
            .collect();
        let span = |i: usize| extents.iter().map(|s| s[i].1 - s[i].0).fold(0.0, f64::max);
        let free = [side - 2.0 * LABEL_MARGIN, HEIGHT - 2.0 * LABEL_MARGIN];
        let scales = [0, 1].map(|i| if span(i) > 0.0 { free[i] / span(i) } else { f64::INFINITY });
        let units_per_metre = scales[0].min(scales[1]);
        let units_per_metre = if units_per_metre.is_finite() { units_per_metre } else { 1.0 };
        let height = units_per_metre * span(1) + 2.0 * LABEL_MARGIN;
        for (i, view) in VIEWS.iter().enumerate() {
            let left = MARGIN + (side + VIEW_DISTANCE) * i as f64;
            scene.text(view.label.into(), (left, top - 12.0), Anchor::Start, medium(13.0), INK);
            let middle = |k: usize| 0.5 * (extents[i][k].0 + extents[i][k].1);
            let (centre_x, up) = (middle(0), middle(1));
            let to_page = |p: &[f64; 3]| {
                let x = left + 0.5 * side + units_per_metre * (dot(&view.right, p) - centre_x);
                let y = top + 0.5 * height - units_per_metre * (dot(&view.up, p) - up);
                (x, y)
            };
            let (right, bottom) = (left + side, top + height);
            self.draw_facets(&mut scene, view, &to_page, units_per_metre, ((left, top), (side, height)));
            let frame = vec![(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
            scene.lines(vec![frame], solid(GRID, 1.0));
            self.draw_items(&mut scene, &to_page, units_per_metre, (left, right));
        }
        draw_scale_bar(&mut scene, units_per_metre, (MARGIN, top + height + 26.0));
        if !self.shading.is_empty() {
            let right = WIDTH - MARGIN;
            let label = fit_to_width(&self.shading, regular(12.0), 0.5 * width_available);
            let start = right - 100.0;
            for step in 0..20 {
                let x = start + 5.0 * f64::from(step);
                let line = vec![(x, top + height + 22.0), (x + 5.0, top + height + 22.0)];
                scene.lines(vec![line], solid(shading_colour(f64::from(step) / 19.0), 6.0));
            }
            let at = (start - 8.0, top + height + 26.0);
            scene.text(label + ": 0 to 100 %", at, Anchor::End, regular(12.0), SOFT_INK);
        }
        scene.height = (top + height + 44.0).ceil();
        scene
    }

    /// Rasterises the facets into the rectangle of a view.
    fn draw_facets(
        &self,
        scene: &mut Scene,
        view: &View,
        to_page: &dyn Fn(&[f64; 3]) -> Point,
        units_per_metre: f64,
        (corner, size): (Point, (f64, f64)),
    ) {
        if self.facets.is_empty() {
            return;
        }
        let mut raster = Raster::new(
            (PIXELS_PER_UNIT * size.0).ceil() as usize,
            (PIXELS_PER_UNIT * size.1).ceil() as usize,
        );
        let eye = cross(&view.right, &view.up);
        for facet in &self.facets {
            let [a, b, c] = &facet.corners;
            let normal = cross(&difference(b, a), &difference(c, a));
            let facing = (dot(&normal, &eye) / length(&normal).max(f64::MIN_POSITIVE)).abs();
            // Facets inclined to the view are darker, to show the shape.
            let light = 0.82 + 0.18 * facing;
            let colour = shading_colour(facet.intensity.unwrap_or(0.0));
            let tint = |c: u8, paper: u8| {
                (light * (SHADING_WEIGHT * f64::from(c) + (1.0 - SHADING_WEIGHT) * f64::from(paper))).round()
                    as u8
            };
            let colour = Colour(tint(colour.0, PAPER.0), tint(colour.1, PAPER.1), tint(colour.2, PAPER.2));
            let points = facet.corners.map(|p| {
                let (x, y) = to_page(&p);
                [
                    PIXELS_PER_UNIT * (x - corner.0),
                    PIXELS_PER_UNIT * (y - corner.1),
                    PIXELS_PER_UNIT * units_per_metre * dot(&eye, &p),
                ]
            });
            raster.triangle(&points, colour);
        }
        let size = (raster.columns as f64 / PIXELS_PER_UNIT, raster.rows as f64 / PIXELS_PER_UNIT);
        let (columns, pixels) = (raster.columns, raster.pixels);
        scene.items.push(Item::Image { at: corner, size, pixels, columns });
    }

    /// Draws circles, lines, arrows and labelled points in a view; `sides` are its left and right edges, for the
    /// labels.
    fn draw_items(
        &self,
        scene: &mut Scene,
        to_page: &dyn Fn(&[f64; 3]) -> Point,
        units_per_metre: f64,
        sides: (f64, f64),
    ) {
        for circle in &self.circles {
            scene.lines(vec![circle_polyline(circle).iter().map(to_page).collect()], solid(SOFT_INK, 1.2));
            scene.dots(vec![to_page(&circle.centre)], 2.0, SOFT_INK);
        }
        // Draw lines with the largest shading value last, on top.
        let mut lines: Vec<&DrawnLine> = self.lines.iter().collect();
        lines.sort_by(|a, b| a.intensity.unwrap_or(-1.0).total_cmp(&b.intensity.unwrap_or(-1.0)));
        for line in lines {
            let (colour, thick) =
                line.intensity.map_or((INK, 1.6), |intensity| (shading_colour(intensity), 3.0));
            let ends = line.ends.map(|end| to_page(&end));
            scene.lines(vec![ends.to_vec()], solid(colour, thick));
            scene.dots(ends.to_vec(), 0.5 * thick + 0.8, colour);
        }
        let longest = self.arrows.iter().map(|arrow| length(&arrow.vector)).fold(0.0, f64::max);
        for arrow in &self.arrows {
            let own = length(&arrow.vector);
            if !(own > 0.0 && own.is_finite()) {
                continue;
            }
            let strong = !arrow.label.is_empty();
            let of_longest = if strong { 1.0 } else { own / longest };
            let reach = of_longest * 54.0 / own / units_per_metre;
            let tip: [f64; 3] = std::array::from_fn(|k| arrow.from[k] + reach * arrow.vector[k]);
            let (from, to) = (to_page(&arrow.from), to_page(&tip));
            let (colour, thick) = if strong { (INK, 2.0) } else { (BLUE, 1.2) };
            scene.lines(vec![vec![from, to]], solid(colour, thick));
            draw_arrow_head(scene, from, to, colour);
            if strong {
                draw_label(scene, &arrow.label, to, sides, colour);
            }
        }
        for mark in &self.marks {
            let at = to_page(&mark.at);
            scene.dots(vec![at], 3.5, INK);
            draw_label(scene, &mark.label, at, sides, INK);
        }
    }
}

/// Colour of a shading value from 0 to 1.
fn shading_colour(intensity: f64) -> Colour {
    let intensity = intensity.clamp(0.0, 1.0).sqrt();
    let mix = |a: u8, b: u8| (f64::from(a) + intensity * (f64::from(b) - f64::from(a))).round() as u8;
    Colour(
        mix(SHADING_LOW.0, SHADING_HIGH.0),
        mix(SHADING_LOW.1, SHADING_HIGH.1),
        mix(SHADING_LOW.2, SHADING_HIGH.2),
    )
}

/// Draws an arrow head, unless the arrow points nearly along the line of sight.
fn draw_arrow_head(scene: &mut Scene, from: Point, to: Point, colour: Colour) {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let long = dx.hypot(dy);
    if long < 4.0 {
        return;
    }
    let (ux, uy) = (dx / long, dy / long);
    let wing = |side: f64| (to.0 - 7.0 * ux + 3.5 * side * uy, to.1 - 7.0 * uy - 3.5 * side * ux);
    scene.lines(vec![vec![wing(1.0), to, wing(-1.0)]], solid(colour, 1.6));
}

/// Draws a label above its point, kept inside the view.
fn draw_label(scene: &mut Scene, label: &str, at: Point, (left, right): (f64, f64), colour: Colour) {
    let font = medium(12.0);
    let label = fit_to_width(label, font, right - left - 8.0);
    let half = 0.5 * width(&label, font) + 4.0;
    let x = at.0.clamp(left + half, (right - half).max(left + half));
    scene.text_on_paper(label, (x, at.1 - 9.0), font, colour);
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

/// Circle as a closed polyline.
fn circle_polyline(circle: &DrawnCircle) -> Vec<[f64; 3]> {
    let axis = circle.axis;
    // Coordinate axis with the largest angle to the circle's axis.
    let least = (0..3).min_by(|a, b| axis[*a].abs().total_cmp(&axis[*b].abs())).unwrap_or(0);
    let mut first = [0.0; 3];
    first[least] = 1.0;
    let along = dot(&first, &axis);
    let first: [f64; 3] = std::array::from_fn(|k| first[k] - along * axis[k]);
    let size = length(&first).max(f64::MIN_POSITIVE);
    let first = first.map(|x| x / size);
    let second: [f64; 3] = std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        axis[i] * first[j] - axis[j] * first[i]
    });
    let at = |i: usize| {
        let (s, c) = (std::f64::consts::TAU * i as f64 / SEGMENTS as f64).sin_cos();
        std::array::from_fn(|k| circle.centre[k] + circle.radius * (c * first[k] + s * second[k]))
    };
    (0..=SEGMENTS).map(at).collect()
}
