//! Random linkages of the family.

use super::drawing::{Drawing, Motion, Pin, across, dyad};
use nalgebra::Vector2;
use rand::Rng;
use rand::seq::SliceRandom;
use std::f64::consts::TAU;

/// Kind of linkage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// Four-bar linkage.
    FourBar,
    /// Platform on the given number of equal parallel cranks; three or more are redundant in the plane.
    Cranks(usize),
    /// Rod between a crank and a slider on the ground.
    SliderCrank,
    /// Inverted slider-crank: a rod on a crank slides in a block that is hinged to the ground.
    Inverted,
    /// Six-bar linkage whose second loop is attached to two bodies that share a pin.
    Watt,
    /// Six-bar linkage whose second loop is attached to two bodies that share no pin.
    Stephenson,
}

impl Kind {
    /// All kinds of the family.
    pub const ALL: [Kind; 8] = [
        Kind::FourBar,
        Kind::Cranks(2),
        Kind::Cranks(3),
        Kind::Cranks(4),
        Kind::SliderCrank,
        Kind::Inverted,
        Kind::Watt,
        Kind::Stephenson,
    ];

    /// True if small errors of the lengths make the loops contradict each other in the plane.
    pub fn is_overconstrained(self) -> bool {
        matches!(self, Kind::Cranks(count) if count > 2)
    }
}

/// Hinge at a point between two bodies.
fn hinge(name: &'static str, bodies: [usize; 2], at: Vector2<f64>) -> Pin {
    Pin { name, bodies, at, slide: None }
}

/// Random point in a square.
fn point<R: Rng + ?Sized>(rng: &mut R) -> Vector2<f64> {
    Vector2::from_fn(|_, _| rng.random_range(-0.7..0.7))
}

/// Unit vector at an angle.
fn along(angle: f64) -> Vector2<f64> {
    Vector2::new(angle.cos(), angle.sin())
}

/// Creates a random linkage of the order of 1 m; pins are in random order, except that sliders come first.
pub(super) fn random_drawing<R: Rng + ?Sized>(rng: &mut R, kind: Kind) -> Drawing {
    let mut drawing = match kind {
        Kind::FourBar => four_bar(rng),
        Kind::Cranks(count) => cranks(rng, count),
        Kind::SliderCrank => slider_crank(rng),
        Kind::Inverted => inverted(rng),
        Kind::Watt => {
            let ends = [[2, 3], [3, 0]][rng.random_range(0..2)];
            six_bar(rng, ends)
        }
        Kind::Stephenson => {
            let ends = [[2, 0], [1, 3]][rng.random_range(0..2)];
            six_bar(rng, ends)
        }
    };
    drawing.pins.shuffle(rng);
    drawing.pins.sort_by_key(|pin| pin.slide.is_none());
    drawing
}

/// Random four-bar with the ground, two pivoted bars and a coupler.
fn four_bar<R: Rng + ?Sized>(rng: &mut R) -> Drawing {
    let [o, a, b, c] = [0; 4].map(|_| point(rng));
    let crank = Motion::about(o, 1.0);
    let [coupler, rocker] = dyad((a, crank), (c, Motion::AT_REST), b);
    Drawing {
        bodies: vec!["ground", "crank", "coupler", "rocker"],
        pins: vec![
            hinge("crank_hinge", [0, 1], o),
            hinge("crank_pin", [1, 2], a),
            hinge("rocker_pin", [2, 3], b),
            hinge("rocker_hinge", [0, 3], c),
        ],
        motions: vec![Motion::AT_REST, crank, coupler, rocker],
        coupler: 2,
    }
}

/// A [`four_bar`] with two more bars, from the given bodies to a common pin.
fn six_bar<R: Rng + ?Sized>(rng: &mut R, ends: [usize; 2]) -> Drawing {
    let mut drawing = four_bar(rng);
    let [d, e, f] = [0; 3].map(|_| point(rng));
    let motions = dyad((d, drawing.motions[ends[0]]), (e, drawing.motions[ends[1]]), f);
    drawing.bodies.extend(["bar_5", "bar_6"]);
    drawing.pins.extend([
        hinge("pin_5", [ends[0], 4], d),
        hinge("pin_6", [ends[1], 5], e),
        hinge("pin_56", [4, 5], f),
    ]);
    drawing.motions.extend(motions);
    drawing
}

/// Random platform on parallel cranks.
fn cranks<R: Rng + ?Sized>(rng: &mut R, count: usize) -> Drawing {
    const NAMES: [[&str; 3]; 4] = [
        ["crank_1", "hinge_1", "pin_1"],
        ["crank_2", "hinge_2", "pin_2"],
        ["crank_3", "hinge_3", "pin_3"],
        ["crank_4", "hinge_4", "pin_4"],
    ];
    let arm = along(rng.random_range(0.0..TAU)) * rng.random_range(0.3..0.6);
    let mut drawing = Drawing {
        bodies: vec!["ground", "platform"],
        pins: vec![],
        motions: vec![Motion::AT_REST, Motion { velocity: across(arm), ..Motion::AT_REST }],
        coupler: 1,
    };
    for [crank, hinged, pinned] in NAMES.into_iter().take(count) {
        let (foot, body) = (point(rng), drawing.bodies.len());
        drawing.bodies.push(crank);
        drawing.pins.push(hinge(hinged, [0, body], foot));
        drawing.pins.push(hinge(pinned, [body, 1], foot + arm));
        drawing.motions.push(Motion::about(foot, 1.0));
    }
    drawing
}

/// Random slider-crank.
fn slider_crank<R: Rng + ?Sized>(rng: &mut R) -> Drawing {
    let [o, a, b] = [0; 3].map(|_| point(rng));
    let guide = along(rng.random_range(0.0..TAU));
    let crank = Motion::about(o, 1.0);
    // The velocity v_a + ω k×(b − a) has no component normal to the guide.
    let (va, arm, side) = (crank.velocity_of(a), across(b - a), across(guide));
    let rate = -va.dot(&side) / arm.dot(&side);
    let rod = Motion { rate, at: a, velocity: va };
    let slider = Motion { rate: 0.0, at: b, velocity: rod.velocity_of(b) };
    Drawing {
        bodies: vec!["ground", "crank", "rod", "slider"],
        pins: vec![
            hinge("crank_hinge", [0, 1], o),
            hinge("crank_pin", [1, 2], a),
            hinge("wrist_pin", [2, 3], b),
            Pin { slide: Some(guide), ..hinge("guide", [0, 3], b) },
        ],
        motions: vec![Motion::AT_REST, crank, rod, slider],
        coupler: 2,
    }
}

/// Random inverted slider-crank.
fn inverted<R: Rng + ?Sized>(rng: &mut R) -> Drawing {
    let [o, a, c] = [0; 3].map(|_| point(rng));
    let guide = along(rng.random_range(0.0..TAU));
    let crank = Motion::about(o, 1.0);
    // The rod's point at the block's pivot moves along the guide.
    let (va, arm, side) = (crank.velocity_of(a), across(c - a), across(guide));
    let rate = -va.dot(&side) / arm.dot(&side);
    Drawing {
        bodies: vec!["ground", "crank", "rod", "block"],
        pins: vec![
            hinge("crank_hinge", [0, 1], o),
            hinge("crank_pin", [1, 2], a),
            hinge("block_hinge", [0, 3], c),
            Pin { slide: Some(guide), ..hinge("guide", [3, 2], c) },
        ],
        motions: vec![Motion::AT_REST, crank, Motion { rate, at: a, velocity: va }, Motion::about(c, rate)],
        coupler: 2,
    }
}
