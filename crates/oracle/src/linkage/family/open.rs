//! Linkages whose file is not closed as it is drawn.

use super::{Drawn, Kind, drawn_as, place, turn};
use crate::alter;
use crate::maximal::{close, poses};
use crate::random::zero_positions;
use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::{LoopFrame, Mechanism};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// A linkage of the family with a pickup point moved in its plane: with all joints at 0 its loops are open.
#[derive(Debug)]
pub struct DrawnOpen {
    /// As it was before, closed.
    pub closed: Drawn,
    /// What the file says.
    pub mechanism: Mechanism,
    /// Which closure's point was moved.
    pub moved: usize,
    /// By how much each loop is open as drawn, m.
    pub gaps: Vec<f64>,
    /// Positions near the drawn ones where it closes, found by the oracle moving all joints of the loops as little as
    /// it can; none where it finds none.
    pub closes: Option<Vec<Vec<f64>>>,
}

/// The linkage of a seed with a pickup point moved by `fraction` of its size, in a random direction of its plane.
///
/// Never one whose loops would contradict one another then.
pub fn drawn_open(seed: u64, fraction: f64) -> DrawnOpen {
    const KINDS: [Kind; 6] =
        [Kind::FourBar, Kind::SliderCrank, Kind::Watt, Kind::Cranks(2), Kind::Inverted, Kind::Stephenson];
    let closed = drawn_as(seed, KINDS[seed as usize % KINDS.len()]);
    let mut rng = StdRng::seed_from_u64(0x09E4_0000 + seed);
    let moved = rng.random_range(0..closed.mechanism.closures().len());
    // Across the axis, in the loop's frame.
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

/// By how much the points of each closure are apart, m, from 4×4 matrices.
///
/// # Panics
/// Where positions do not fit the joints.
pub fn gaps(mechanism: &Mechanism, positions: &[Vec<f64>]) -> Vec<f64> {
    let x_wl = poses(mechanism, positions);
    let at = |end: &LoopFrame| {
        let (r, p) = end
            .link
            .map_or((Matrix3::identity(), Vector3::zeros()), |link| (turn(&x_wl, link), place(&x_wl, link)));
        r * end.frame.translation + p
    };
    mechanism.closures().iter().map(|c| (at(c.successor()) - at(c.predecessor())).norm()).collect()
}
