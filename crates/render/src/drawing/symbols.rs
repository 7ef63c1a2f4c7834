//! Symbols of springs, dampers, stops and the ground, projected to the page.

use super::shapes::{DrawnSymbol, SymbolKind};
use crate::palette::{Colour, INK};
use crate::scene::{Point, Scene, solid};

/// Colour of springs and dampers: the green of the series colours, darker on white.
const ELEMENT: Colour = Colour(0, 130, 96);
/// Half width of a spring and of a damper, page units.
const HALF_WIDTH: f64 = 6.5;
/// Half turns of a spring.
const HALF_TURNS: usize = 12;
/// Half length of the pad of a stop and of the hatched face.
const PAD: f64 = 9.0;
const FACE: f64 = 13.0;
/// Half length of the ground.
const GROUND: f64 = 22.0;
/// Length of a hatch line, and distance between two.
const HATCH: f64 = 6.0;
/// Projected length below which a spring or a damper is seen along its axis and drawn as a circle.
const ALONG_SIGHT: f64 = 8.0;

/// Draws a symbol in a view.
pub(super) fn draw_symbol(scene: &mut Scene, symbol: &DrawnSymbol, to_page: &dyn Fn(&[f64; 3]) -> Point) {
    let [from, to] = symbol.ends.map(|end| to_page(&end));
    if ![from.0, from.1, to.0, to.1].iter().all(|x| x.is_finite()) {
        return;
    }
    let tip: [f64; 3] = std::array::from_fn(|k| symbol.ends[0][k] + symbol.normal[k]);
    let tip = to_page(&tip);
    let normal = unit(from, tip);
    match symbol.kind {
        SymbolKind::Spring | SymbolKind::Damper => {
            let length = (to.0 - from.0).hypot(to.1 - from.1);
            match unit(from, to).filter(|_| length > ALONG_SIGHT) {
                None => scene.lines(vec![circle(from)], solid(ELEMENT, 1.6)),
                Some(along) => {
                    let chains = match symbol.kind {
                        SymbolKind::Spring => spring(from, along, length),
                        _ => damper(from, along, length),
                    };
                    scene.lines(chains, solid(ELEMENT, 1.6));
                }
            }
            scene.dots(vec![from, to], 2.4, ELEMENT);
        }
        SymbolKind::Stop => {
            // Seen along its normal, a stop is a point.
            if let Some(normal) = normal {
                scene.lines(vec![across(from, normal, PAD)], solid(INK, 3.4));
                scene.lines(hatched(to, normal, FACE), solid(INK, 1.2));
            }
        }
        SymbolKind::Ground => {
            if let Some(normal) = normal {
                scene.lines(hatched(from, normal, GROUND), solid(INK, 1.2));
            }
        }
    }
}

/// Unit vector between two points of the page; `None` if they are less than 1e-3 apart.
fn unit(from: Point, to: Point) -> Option<Point> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    (length > 1e-3).then(|| (dx / length, dy / length))
}

/// Point at `along` in the direction and `aside` to its left.
fn at(from: Point, (ux, uy): Point, along: f64, aside: f64) -> Point {
    (from.0 + along * ux - aside * uy, from.1 + along * uy + aside * ux)
}

/// Circle with the half width of a spring as radius.
fn circle(centre: Point) -> Vec<Point> {
    let on = |i: usize| {
        let (s, c) = (std::f64::consts::TAU * i as f64 / 24.0).sin_cos();
        (centre.0 + HALF_WIDTH * c, centre.1 + HALF_WIDTH * s)
    };
    (0..=24).map(on).collect()
}

/// Zigzag with straight ends.
fn spring(from: Point, along: Point, length: f64) -> Vec<Vec<Point>> {
    let (start, end) = (0.14 * length, 0.86 * length);
    let step = (end - start) / HALF_TURNS as f64;
    let turn = |i: usize| {
        let side = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        at(from, along, start + step * (i as f64 + 0.5), side * HALF_WIDTH)
    };
    let mut chain = vec![from, at(from, along, start, 0.0)];
    chain.extend((0..HALF_TURNS).map(turn));
    chain.extend([at(from, along, end, 0.0), at(from, along, length, 0.0)]);
    vec![chain]
}

/// Cylinder on the first side, and piston with its rod on the other.
fn damper(from: Point, along: Point, length: f64) -> Vec<Vec<Point>> {
    let p = |part: f64, aside: f64| at(from, along, part * length, aside * HALF_WIDTH);
    vec![
        vec![p(0.0, 0.0), p(0.22, 0.0)],
        vec![p(0.66, 1.0), p(0.22, 1.0), p(0.22, -1.0), p(0.66, -1.0)],
        vec![p(0.5, 0.8), p(0.5, -0.8)],
        vec![p(0.5, 0.0), p(1.0, 0.0)],
    ]
}

/// Line across the normal.
fn across(centre: Point, normal: Point, half: f64) -> Vec<Point> {
    vec![at(centre, normal, 0.0, -half), at(centre, normal, 0.0, half)]
}

/// Face across the normal, hatched on the far side.
fn hatched(centre: Point, normal: Point, half: f64) -> Vec<Vec<Point>> {
    let count = (2.0 * half / HATCH) as usize;
    let hatch = |i: usize| {
        let aside = -half + HATCH * (i as f64 + 0.5);
        vec![at(centre, normal, 0.0, aside), at(centre, normal, HATCH, aside + 0.6 * HATCH)]
    };
    std::iter::once(across(centre, normal, half)).chain((0..count).map(hatch)).collect()
}
