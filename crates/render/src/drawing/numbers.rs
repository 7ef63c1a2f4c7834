//! Numbers of the named points in a view, placed beside their points without overlap if possible.

use super::shapes::Drawing;
use super::vectors::dot;
use crate::font::Font;
use crate::palette::{INK, SOFT_INK};
use crate::scene::{Point, Scene, solid};
use crate::text::{medium, width};

const FONT: Font = medium(11.0);
/// Distances of a number from its point, page units, and directions tried.
const DISTANCES: [f64; 3] = [13.0, 22.0, 33.0];
const DIRECTIONS: usize = 12;
/// Radius of the disc in which the pointer shows the name of a point.
const HOVER: f64 = 7.0;
/// Largest distance of points that share a name under the pointer.
const COINCIDENT: f64 = 3.0;
/// Largest distance on the page at which a point hides a farther one, and least difference of their depths.
const BEHIND: f64 = 8.0;
/// Distance from which a leader connects the number to its point.
const LEADER: f64 = 16.0;
/// Costs of a position: overlap with a number, with a point, leaving the view, and each crossed line.
const OVERLAP: f64 = 50.0;
const ON_POINT: f64 = 12.0;
const OUTSIDE: f64 = 1000.0;
const ON_LINE: f64 = 2.0;

/// Axis-parallel rectangle: smallest and largest corner.
type Rectangle = (Point, Point);

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

/// Rectangle of a number with its centre at a point.
fn rectangle(number: &str, at: Point) -> Rectangle {
    let (half, up) = (0.5 * width(number, FONT) + 2.5, 0.5 * FONT.size + 0.5);
    ((at.0 - half, at.1 - up), (at.0 + half, at.1 + up))
}

/// True for each point that is hidden behind a nearer one, such as the point of the other side of a vehicle in the side view.
/// `points`: positions on the page; `depths`: distances towards the viewer, page units.
fn hidden_points(points: &[Point], depths: &[f64]) -> Vec<bool> {
    let is_hidden = |i: usize| {
        (0..points.len()).any(|other| {
            let apart = (points[other].0 - points[i].0).hypot(points[other].1 - points[i].1);
            apart <= BEHIND && depths[other] > depths[i] + BEHIND
        })
    };
    (0..points.len()).map(is_hidden).collect()
}

/// Draws a dot, a number and if necessary a leader for each named point, with the name under the pointer. `eye`: direction
/// towards the viewer, in which `hides` leaves out the numbers of points behind others.
pub(super) fn draw_numbers(
    scene: &mut Scene,
    drawing: &Drawing,
    to_page: &dyn Fn(&[f64; 3]) -> Point,
    (eye, units_per_metre, hides): ([f64; 3], f64, bool),
    frame: Rectangle,
) {
    let points: Vec<Point> = drawing.points.iter().map(|point| to_page(&point.at)).collect();
    let lines: Vec<[Point; 2]> =
        drawing.lines.iter().map(|line| line.ends.map(|end| to_page(&end))).collect();
    let marks: Vec<Point> = drawing.marks.iter().map(|mark| to_page(&mark.at)).collect();
    let depths: Vec<f64> =
        drawing.points.iter().map(|point| units_per_metre * dot(&eye, &point.at)).collect();
    let hidden = if hides { hidden_points(&points, &depths) } else { vec![false; points.len()] };
    let is_drawable = |p: &Point| contains(&frame, p);
    let mut taken: Vec<Rectangle> = Vec::new();
    let mut hovers: Vec<(Point, String)> = Vec::new();
    for (i, at) in points.iter().enumerate().filter(|(i, at)| is_drawable(at) && !hidden[*i]) {
        let number = (i + 1).to_string();
        let cost = |place: &(Point, f64)| {
            let rectangle = rectangle(&number, place.0);
            let outside = !contains(&frame, &rectangle.0) || !contains(&frame, &rectangle.1);
            let on_points = points.iter().chain(&marks).filter(|p| contains(&rectangle, p)).count();
            let on_lines = lines.iter().filter(|line| crosses(&rectangle, line)).count();
            let overlaps = taken.iter().filter(|other| overlap(&rectangle, other)).count();
            place.1 / 10.0
                + OVERLAP * overlaps as f64
                + ON_POINT * on_points as f64
                + ON_LINE * on_lines as f64
                + if outside { OUTSIDE } else { 0.0 }
        };
        let places = DISTANCES.into_iter().flat_map(|distance| {
            (0..DIRECTIONS).map(move |k| {
                let (s, c) = (std::f64::consts::TAU * (k as f64 + 0.5) / DIRECTIONS as f64).sin_cos();
                ((at.0 + distance * c, at.1 - distance * s), distance)
            })
        });
        let Some((place, distance)) = places.min_by(|a, b| cost(a).total_cmp(&cost(b))) else { continue };
        if distance > LEADER {
            scene.lines(vec![vec![*at, place]], solid(SOFT_INK, 0.7));
        }
        taken.push(rectangle(&number, place));
        scene.dots(vec![*at], 2.4, INK);
        let title = |i: usize| format!("{} {}", i + 1, drawing.points[i].label);
        let is_here = |other: &Point| (other.0 - at.0).hypot(other.1 - at.1) <= COINCIDENT;
        let here = points.iter().enumerate().filter(|(_, other)| is_here(other)).map(|(i, _)| title(i));
        hovers.push((*at, here.collect::<Vec<_>>().join("\n")));
        hovers.push((place, title(i)));
        scene.text_on_paper(number, (place.0, place.1 + 0.36 * FONT.size), FONT, INK);
    }
    // The discs are above all dots and numbers.
    for (at, title) in hovers {
        scene.hover(at, HOVER, title);
    }
}
