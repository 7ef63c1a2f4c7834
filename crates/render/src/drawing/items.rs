//! Items of a view: facets, lines, circles, arrows and labelled points.

use super::shapes::{Drawing, DrawnCircle, DrawnLine};
use super::symbols::draw_symbol;
use super::vectors::{cross, difference, dot, length};
use crate::palette::{Colour, INK, PAPER, SOFT_INK};
use crate::raster::Raster;
use crate::scene::{Anchor, Item, Point, Scene, solid};
use crate::text::{fit_to_width, medium, width};

/// Segments per circle.
const SEGMENTS: usize = 64;
/// Colours of shading values 0 and 1.
const SHADING_LOW: Colour = Colour(176, 182, 191);
const SHADING_HIGH: Colour = Colour(190, 60, 10);
/// Raster pixels per page unit.
const PIXELS_PER_UNIT: f64 = 2.0;
/// Weight of the shading colour on facets. The rest is paper colour, so that lines on top stay visible.
const SHADING_WEIGHT: f64 = 0.42;
/// Velocities and loads.
const VECTOR: Colour = Colour(92, 99, 110);
/// Contact and its normal.
const CONTACT: Colour = Colour(11, 87, 164);

/// Appearance of the arrows without a label.
struct ArrowStyle {
    colour: Colour,
    thick: f64,
    /// Length of the longest arrow, page units.
    longest: f64,
    /// True if labelled arrows are in proportion too.
    to_scale: bool,
}

impl ArrowStyle {
    const MOTION: Self = Self { colour: VECTOR, thick: 1.2, longest: 54.0, to_scale: false };
    const LOAD: Self = Self { colour: Colour(0, 130, 96), thick: 2.0, longest: 80.0, to_scale: true };
}

/// Viewing direction: axes of the page in space, and title.
pub(super) struct View {
    pub right: [f64; 3],
    pub up: [f64; 3],
    pub label: &'static str,
}

/// Arrow on the page.
pub(super) struct PageArrow<'a> {
    from: [f64; 3],
    /// Vector on the page per metre of space: its length in page units.
    reach: [f64; 3],
    colour: Colour,
    thick: f64,
    label: &'a str,
}

impl Drawing {
    /// Rasterises the facets into the rectangle of a view.
    pub(super) fn draw_facets(
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

    /// Arrows with their lengths on the page.
    pub(super) fn page_arrows(&self) -> Vec<PageArrow<'_>> {
        let mut all = Vec::new();
        for (arrows, style) in [(&self.arrows, ArrowStyle::MOTION), (&self.loads, ArrowStyle::LOAD)] {
            let longest = arrows.iter().map(|arrow| length(&arrow.vector)).fold(0.0, f64::max);
            for arrow in arrows {
                let own = length(&arrow.vector);
                if !(own > 0.0 && own.is_finite()) {
                    continue;
                }
                let strong = !arrow.label.is_empty();
                let of_longest = if strong && !style.to_scale { 1.0 } else { own / longest };
                let reach = arrow.vector.map(|x| x * of_longest * style.longest / own);
                let (colour, thick) = if strong { (CONTACT, 2.4) } else { (style.colour, style.thick) };
                all.push(PageArrow { from: arrow.from, reach, colour, thick, label: &arrow.label });
            }
        }
        all
    }

    /// Draws circles, symbols and lines in a view.
    pub(super) fn draw_items(&self, scene: &mut Scene, to_page: &dyn Fn(&[f64; 3]) -> Point) {
        for circle in &self.circles {
            let colour = circle.intensity.map_or(SOFT_INK, shading_colour);
            scene.lines(vec![outline(circle, to_page)], solid(colour, 2.0));
            scene.dots(vec![to_page(&circle.centre)], 2.4, colour);
        }
        for symbol in &self.symbols {
            draw_symbol(scene, symbol, to_page);
        }
        // Draw lines with the largest shading value last, on top.
        let mut lines: Vec<&DrawnLine> = self.lines.iter().collect();
        lines.sort_by(|a, b| a.intensity.unwrap_or(-1.0).total_cmp(&b.intensity.unwrap_or(-1.0)));
        for line in lines {
            let (colour, thick) = line
                .intensity
                .map_or((INK, 1.6), |intensity| (shading_colour(intensity), line_width(intensity)));
            let ends = line.ends.map(|end| to_page(&end));
            scene.lines(vec![ends.to_vec()], solid(colour, thick));
            scene.dots(ends.to_vec(), 0.5 * thick + 0.6, colour);
        }
    }

    /// Draws arrows and marks above all else; `sides` are the left and right edges of the view, for the labels.
    pub(super) fn draw_arrows(
        &self,
        scene: &mut Scene,
        to_page: &dyn Fn(&[f64; 3]) -> Point,
        view: &View,
        sides: (f64, f64),
    ) {
        for arrow in self.page_arrows() {
            let from = to_page(&arrow.from);
            let to = (from.0 + dot(&view.right, &arrow.reach), from.1 - dot(&view.up, &arrow.reach));
            scene.lines(vec![vec![from, to]], solid(arrow.colour, arrow.thick));
            draw_arrow_head(scene, from, to, arrow.colour);
            if !arrow.label.is_empty() {
                draw_label(scene, arrow.label, (from, to), sides, arrow.colour);
            }
        }
        for mark in &self.marks {
            let at = to_page(&mark.at);
            scene.dots(vec![at], 4.5, CONTACT);
            draw_label(scene, &mark.label, ((at.0, at.1 + 1.0), at), sides, INK);
        }
    }
}

impl PageArrow<'_> {
    /// Length of the arrow in a plane, relative to its length in space.
    pub(super) fn part_in_plane(&self, right: &[f64; 3], up: &[f64; 3]) -> f64 {
        dot(right, &self.reach).hypot(dot(up, &self.reach)) / length(&self.reach).max(f64::MIN_POSITIVE)
    }

    /// Ends of the arrow along an axis of a view, page units. `scale`: page units per metre.
    pub(super) fn ends_along(&self, axis: &[f64; 3], scale: f64) -> [f64; 2] {
        let from = scale * dot(axis, &self.from);
        [from, from + dot(axis, &self.reach)]
    }
}

/// Width of a line by its shading value.
pub(super) fn line_width(intensity: f64) -> f64 {
    2.0 + 4.5 * intensity.clamp(0.0, 1.0)
}

/// Colour of a text about a part with a shading colour: darker, so that it is readable on white.
pub(super) fn label_colour(colour: Colour) -> Colour {
    let dark = |c: u8| (0.62 * f64::from(c)) as u8;
    Colour(dark(colour.0), dark(colour.1), dark(colour.2))
}

/// Outline of a circle or of a wheel on the page: the convex hull of both sides.
fn outline(circle: &DrawnCircle, to_page: &dyn Fn(&[f64; 3]) -> Point) -> Vec<Point> {
    let sides = circle_polylines(circle);
    let mut points: Vec<Point> = sides.iter().flatten().map(to_page).collect();
    if sides.len() < 2 || !points.iter().all(|p| p.0.is_finite() && p.1.is_finite()) {
        return points;
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let turn = |a: &Point, b: &Point, c: &Point| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
    let mut hull: Vec<Point> = Vec::new();
    for chain in [points.clone(), points.into_iter().rev().collect()] {
        let first = hull.len();
        for p in chain {
            while hull.len() >= first + 2 && turn(&hull[hull.len() - 2], &hull[hull.len() - 1], &p) <= 0.0 {
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
    }
    let closing = hull.first().copied();
    hull.extend(closing);
    hull
}

/// Circles of both sides of a wheel; one circle without a width.
pub(super) fn circle_polylines(circle: &DrawnCircle) -> Vec<Vec<[f64; 3]>> {
    if circle.width == 0.0 {
        return vec![circle_polyline(circle)];
    }
    let side = |part: f64| {
        let centre = std::array::from_fn(|k| circle.centre[k] + part * circle.width * circle.axis[k]);
        circle_polyline(&DrawnCircle { centre, ..*circle })
    };
    vec![side(0.5), side(-0.5)]
}

/// Colour of a shading value from 0 to 1.
pub(super) fn shading_colour(intensity: f64) -> Colour {
    let intensity = intensity.clamp(0.0, 1.0);
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

/// Draws a label beyond the tip of an arrow, kept inside the view.
fn draw_label(
    scene: &mut Scene,
    label: &str,
    (from, to): (Point, Point),
    (left, right): (f64, f64),
    colour: Colour,
) {
    let font = medium(13.0);
    let label = fit_to_width(label, font, right - left - 8.0);
    let half = 0.5 * width(&label, font) + 4.0;
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let long = dx.hypot(dy).max(f64::MIN_POSITIVE);
    let at = (to.0 + (half + 3.0) * dx / long, to.1 + 10.0 * dy / long + 0.36 * font.size);
    let x = at.0.clamp(left + half, (right - half).max(left + half));
    scene.text_with_halo(label, (x, at.1), Anchor::Middle, font, colour);
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
