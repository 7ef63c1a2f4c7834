//! Linkages with open loops as drawn.

use super::{Drawn, Kind, drawn_as, origin_of, rotation_of};
use crate::alter;
use crate::maximal::{close, poses};
use crate::random::zero_positions;
use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::{LoopFrame, Mechanism};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// Linkage of the family with one displaced pickup point: with all joints at 0 its loops are open.
#[derive(Debug)]
pub struct DrawnOpen {
    /// The closed linkage before the displacement.
    pub closed: Drawn,
    /// The mechanism with open loops.
    pub mechanism: Mechanism,
    /// Index of the displaced closure.
    pub moved: usize,
    /// Gap of each loop as drawn, m.
    pub gaps: Vec<f64>,
    /// Closed positions near the drawn ones, found by the oracle with the smallest joint motion; `None` if none
    /// are found.
    pub closes: Option<Vec<Vec<f64>>>,
}

/// Linkage of a seed with a pickup point displaced by `fraction` of its size, in a random direction of its plane.
///
/// Kinds whose loops would contradict each other are excluded.
pub fn drawn_open(seed: u64, fraction: f64) -> DrawnOpen {
    const KINDS: [Kind; 6] =
        [Kind::FourBar, Kind::SliderCrank, Kind::Watt, Kind::Cranks(2), Kind::Inverted, Kind::Stephenson];
    let closed = drawn_as(seed, KINDS[seed as usize % KINDS.len()]);
    let mut rng = StdRng::seed_from_u64(0x09E4_0000 + seed);
    let moved = rng.random_range(0..closed.mechanism.closures().len());
    // Direction normal to the axis, in the loop frame.
    let axis = *closed.mechanism.closures()[moved].axis();
    let first = axis.cross(&Vector3::ith(axis.iamin(), 1.0)).normalize();
    let (sin, cos) = rng.random_range(0.0..std::f64::consts::TAU).sin_cos();
    let along = first * cos + axis.cross(&first) * sin;
    let shift = along * (fraction * closed.size);
    let mechanism = alter::displaced(&closed.mechanism, moved, shift, Vector3::zeros());
    let gaps = gaps(&mechanism, &zero_positions(&mechanism));
    let closes = close(&mechanism, &zero_positions(&mechanism), &closed.loop_joints).ok();
    DrawnOpen { closed, mechanism, moved, gaps, closes }
}

/// Distance between the two points of each closure, m, from 4×4 matrices.
///
/// # Panics
/// If the positions do not match the joints.
pub fn gaps(mechanism: &Mechanism, positions: &[Vec<f64>]) -> Vec<f64> {
    let x_wl = poses(mechanism, positions);
    let at = |end: &LoopFrame| {
        let (r, p) = end.link.map_or((Matrix3::identity(), Vector3::zeros()), |link| {
            (rotation_of(&x_wl, link), origin_of(&x_wl, link))
        });
        r * end.frame.translation + p
    };
    mechanism.closures().iter().map(|c| (at(c.successor()) - at(c.predecessor())).norm()).collect()
}
