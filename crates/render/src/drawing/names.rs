//! Names of parts in a view, beside their parts without overlap if possible, and dots with names under the pointer.

use super::items::{label_colour, shading_colour};
use super::shapes::Drawing;
use crate::font::Font;
use crate::palette::{INK, SOFT_INK};
use crate::scene::{Anchor, Point, Scene, solid};
use crate::text::{fit_to_width, medium, regular, width};

const FONT: Font = regular(13.0);
const STRONG: Font = medium(13.0);
/// Shading value from which a name is strong.
const STRONG_FROM: f64 = 0.15;
/// Distances of the middle of a name from its part, page units, and directions tried.
const DISTANCES: [f64; 6] = [16.0, 26.0, 40.0, 60.0, 85.0, 115.0];
const DIRECTIONS: usize = 16;
/// Radius of the disc in which the pointer shows the name of a point.
const HOVER: f64 = 7.0;
/// Largest distance of points that share a name under the pointer.
const COINCIDENT: f64 = 3.0;
/// Costs of a position: overlap with a name, with a point, leaving the view, each crossed line, and a leader through a name.
const OVERLAP: f64 = 60.0;
const ON_POINT: f64 = 8.0;
const OUTSIDE: f64 = 1000.0;
const ON_LINE: f64 = 6.0;
const LEADER_ON_NAME: f64 = 20.0;
/// Length of a leader below which it is not drawn.
const SHORTEST_LEADER: f64 = 5.0;

/// Axis-parallel rectangle: smallest and largest corner.
pub(super) type Rectangle = (Point, Point);

/// True if the rectangles overlap.
fn overlap(a: &Rectangle, b: &Rectangle) -> bool {
    a.0.0 < b.1.0 && b.0.0 < a.1.0 && a.0.1 < b.1.1 && b.0.1 < a.1.1
}

/// True if the point is in the rectangle.
fn contains(rectangle: &Rectangle, p: &Point) -> bool {
    (rectangle.0.0..=rectangle.1.0).contains(&p.0) && (rectangle.0.1..=rectangle.1.1).contains(&p.1)
}

/// True if a sampled point of the segment is in the rectangle.
fn crosses(rectangle: &Rectangle, [a, b]: &[Point; 2]) -> bool {
    let samples = (((b.0 - a.0).hypot(b.1 - a.1) / 5.0).ceil()).clamp(1.0, 200.0);
    (0..=samples as usize).any(|i| {
        let t = i as f64 / samples;
        contains(rectangle, &(a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)))
    })
}

/// Rectangle of a text with its centre at a point.
fn rectangle(text: &str, font: Font, at: Point) -> Rectangle {
    let (half, up) = (0.5 * width(text, font) + 3.0, 0.5 * font.size + 2.0);
    ((at.0 - half, at.1 - up), (at.0 + half, at.1 + up))
}

/// Nearest point of a rectangle.
fn nearest(rectangle: &Rectangle, p: Point) -> Point {
    let ((left, top), (right, bottom)) = rectangle;
    (p.0.clamp(*left, *right), p.1.clamp(*top, *bottom))
}

/// Draws the dots of the named points with their names under the pointer.
pub(super) fn draw_points(
    scene: &mut Scene,
    drawing: &Drawing,
    to_page: &dyn Fn(&[f64; 3]) -> Point,
    frame: Rectangle,
) {
    let points: Vec<Point> = drawing.points.iter().map(|point| to_page(&point.at)).collect();
    let is_drawable = |p: &&Point| contains(&frame, p);
    scene.dots(points.iter().filter(is_drawable).copied().collect(), 2.4, INK);
    for at in points.iter().filter(is_drawable) {
        let is_here = |other: &Point| (other.0 - at.0).hypot(other.1 - at.1) <= COINCIDENT;
        let here = points.iter().zip(&drawing.points).filter(|(other, _)| is_here(other));
        let names: Vec<&str> = here.map(|(_, point)| point.label.as_str()).collect();
        scene.hover(*at, HOVER, names.join("\n"));
    }
}

/// Draws the names of the parts; the largest shading value has the first choice. `occupied`: rectangles without names.
pub(super) fn draw_names(
    scene: &mut Scene,
    drawing: &Drawing,
    to_page: &dyn Fn(&[f64; 3]) -> Point,
    frame: Rectangle,
    occupied: &[Rectangle],
) {
    let lines: Vec<[Point; 2]> =
        drawing.lines.iter().map(|line| line.ends.map(|end| to_page(&end))).collect();
    let points: Vec<Point> =
        drawing.points.iter().chain(&drawing.marks).map(|point| to_page(&point.at)).collect();
    let mut taken: Vec<Rectangle> = occupied.to_vec();
    let mut names: Vec<_> = drawing.names.iter().collect();
    names.sort_by(|a, b| b.intensity.unwrap_or(0.0).total_cmp(&a.intensity.unwrap_or(0.0)));
    for name in names {
        let intensity = name.intensity.unwrap_or(0.0);
        let font = if intensity >= STRONG_FROM { STRONG } else { FONT };
        let text = fit_to_width(&name.text, font, 0.5 * (frame.1.0 - frame.0.0));
        let anchors: Vec<Point> = name.points.iter().map(to_page).filter(|p| contains(&frame, p)).collect();
        let cost = |(anchor, at, distance): &(Point, Point, f64)| {
            let here = rectangle(&text, font, *at);
            let outside = !contains(&frame, &here.0) || !contains(&frame, &here.1);
            let leader = [*anchor, nearest(&here, *anchor)];
            let on_points = points.iter().filter(|p| contains(&here, p)).count();
            let on_lines = lines.iter().filter(|line| crosses(&here, line)).count();
            let overlaps = taken.iter().filter(|other| overlap(&here, other)).count();
            let over = taken.iter().filter(|other| crosses(other, &leader)).count();
            distance / 8.0
                + OVERLAP * overlaps as f64
                + LEADER_ON_NAME * over as f64
                + ON_POINT * on_points as f64
                + ON_LINE * on_lines as f64
                + if outside { OUTSIDE } else { 0.0 }
        };
        let half = 0.5 * width(&text, font);
        let places = anchors.iter().flat_map(|anchor| {
            DISTANCES.into_iter().flat_map(move |distance| {
                (0..DIRECTIONS).map(move |k| {
                    let (s, c) = (std::f64::consts::TAU * k as f64 / DIRECTIONS as f64).sin_cos();
                    // The distance is from the edge of a wide text.
                    (*anchor, (anchor.0 + (distance + half * c.abs()) * c, anchor.1 - distance * s), distance)
                })
            })
        });
        let best = places.map(|place| (cost(&place), place)).min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, (anchor, at, _))) = best.filter(|(cost, _)| *cost < OUTSIDE) else { continue };
        let here = rectangle(&text, font, at);
        let end = nearest(&here, anchor);
        if (end.0 - anchor.0).hypot(end.1 - anchor.1) > SHORTEST_LEADER {
            scene.lines(vec![vec![anchor, end]], solid(SOFT_INK, 0.7));
            scene.dots(vec![anchor], 1.3, SOFT_INK);
        }
        taken.push(here);
        let colour = name.intensity.map_or(INK, |x| label_colour(shading_colour(x)));
        scene.text_with_halo(text, (at.0, at.1 + 0.36 * font.size), Anchor::Middle, font, colour);
    }
}
