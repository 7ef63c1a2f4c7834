//! Largest and smallest m̄ of a linkage over one or two ranges of driving joints.

use super::bracket::{InverseMass, inverse_mass};
use super::loops::Closed;
use super::problem::Problem;
use super::records::{BranchProof, ExtremeBracket, ExtremesCertificate, NoCertificate, RangeProof};
use crate::tolerances::MOST_LINKAGE_RANGES;
use percuss_spatial::Interval;

/// Box of the ranges.
#[derive(Clone)]
struct Piece {
    bounds: Vec<(f64, f64)>,
    /// Enclosure of the positions of all joints; without a proof, positions near the box.
    q: Vec<Interval>,
    is_closed: bool,
    /// Bounds of m̄ in the box, and its value at the middle without a proof.
    within: [f64; 2],
    middle: f64,
}

impl Piece {
    fn centre(&self) -> Vec<f64> {
        self.bounds.iter().map(|(a, b)| 0.5 * a + 0.5 * b).collect()
    }
}

/// Encloses the extremes of m̄ on the branch of the pose of a problem.
pub(super) fn enclose(
    problem: &Problem,
    varied: &[(usize, f64, f64)],
    proof: RangeProof,
) -> Result<ExtremesCertificate, NoCertificate> {
    if varied.len() > MOST_LINKAGE_RANGES {
        return Err(NoCertificate::TooManyRanges { ranges: varied.len() });
    }
    let linkage = Linkage { problem, varied };
    let whole = Piece {
        bounds: varied.iter().map(|(_, a, b)| (*a, *b)).collect(),
        q: problem.q.clone(),
        is_closed: false,
        within: [0.0, f64::INFINITY],
        middle: f64::NAN,
    };
    let (mut open, mut done, mut boxes) = (vec![whole], Vec::new(), 0);
    // Best values with their positions: the smallest and the largest m̄, proved.
    let none = ([0.0, f64::INFINITY], f64::NAN, Vec::new());
    let (mut small, mut large) = (none.clone(), none);
    // All boxes of one size, then the halves of those without a sufficient bound.
    while !open.is_empty() {
        boxes += open.len();
        open.iter_mut().for_each(|piece| linkage.evaluate(piece));
        let values = || open.iter().filter(|piece| piece.is_closed);
        if let Some(best) = values().min_by(|a, b| a.middle.total_cmp(&b.middle))
            && (small.2.is_empty() || best.middle < small.1)
        {
            small = (linkage.mass_at_centre(best), best.middle, best.centre());
        }
        if let Some(best) = values().max_by(|a, b| a.middle.total_cmp(&b.middle))
            && (large.2.is_empty() || best.middle > large.1)
        {
            large = (linkage.mass_at_centre(best), best.middle, best.centre());
        }
        for piece in std::mem::take(&mut open) {
            let is_enough = piece.is_closed
                && (proof.only_largest || piece.within[0] * proof.ratio() >= small.0[1])
                && piece.within[1] <= large.0[0] * proof.ratio();
            let width = |k: usize| (piece.bounds[k].1 - piece.bounds[k].0) / (varied[k].2 - varied[k].1);
            let widest = (0..varied.len()).max_by(|&a, &b| width(a).total_cmp(&width(b)));
            match widest {
                Some(k) if !is_enough && boxes + open.len() < proof.budget => {
                    let (a, b) = piece.bounds[k];
                    let middle = 0.5 * a + 0.5 * b;
                    for half in [(a, middle), (middle, b)] {
                        let mut part = piece.clone();
                        part.bounds[k] = half;
                        open.push(part);
                    }
                }
                _ => done.push(piece),
            }
        }
    }
    let is_one_branch = done.iter().all(|piece| piece.is_closed) && linkage.is_connected(&done);
    let bracket = |lower: f64, upper: f64, positions: Vec<f64>| {
        let [lower, upper] = if is_one_branch { [lower, upper] } else { [0.0, f64::INFINITY] };
        ExtremeBracket {
            lower,
            upper,
            positions,
            is_proved: proof.is_met(lower, upper),
            boxes,
            divisions: Vec::new(),
        }
    };
    let lower = done.iter().map(|piece| piece.within[0]).fold(f64::INFINITY, f64::min);
    let upper = done.iter().map(|piece| piece.within[1]).fold(0.0, f64::max);
    let omitted = problem.close(&problem.q).map(|closed| problem.omitted(&closed))?;
    Ok(ExtremesCertificate {
        least: Some(bracket(lower, small.0[1], small.2)),
        most: bracket(large.0[0], upper, large.2),
        branch: Some(BranchProof { pieces: done.len(), is_one_branch, omitted }),
        tree: None,
    })
}

struct Linkage<'a> {
    problem: &'a Problem<'a>,
    varied: &'a [(usize, f64, f64)],
}

impl Linkage<'_> {
    /// Positions of all joints with the varied ones replaced.
    fn replaced(&self, start: &[Interval], x: impl Iterator<Item = Interval>) -> Vec<Interval> {
        let mut q = start.to_vec();
        self.varied.iter().zip(x).for_each(|((k, ..), x)| q[*k] = x);
        q
    }

    fn inverse_mass(&self, closed: &Closed) -> Option<InverseMass> {
        let Problem { plan, load, loops, .. } = self.problem;
        inverse_mass(plan, load, loops, &closed.q, (&closed.rows, &closed.dependent))
    }

    /// Proves the assembly in a box, and bounds m̄ there. The start is the assembly of the box that was halved, or a pose.
    fn evaluate(&self, piece: &mut Piece) {
        let problem = self.problem;
        if !piece.is_closed {
            let centre = self.replaced(&piece.q, piece.centre().into_iter().map(Interval::point));
            let Some(q) = problem.closing().approximate(&centre) else { return };
            piece.q = q;
        }
        piece.is_closed = false;
        let ranges = piece.bounds.iter().map(|(a, b)| Interval::new(*a, *b));
        let Ok(closed) = problem.close(&self.replaced(&piece.q, ranges)) else { return };
        let Some(w) = self.inverse_mass(&closed) else { return };
        (piece.q, piece.is_closed, piece.within, piece.middle) = (closed.q, true, w.mass(), 1.0 / w.middle);
    }

    /// Positions of all joints at positions `x` of the varied joints, near an assembly.
    fn closed_at(&self, near: &Piece, x: &[f64]) -> Option<Closed> {
        self.problem.close(&self.replaced(&near.q, x.iter().copied().map(Interval::point))).ok()
    }

    /// Proved bounds of m̄ at the centre of a box.
    fn mass_at_centre(&self, piece: &Piece) -> [f64; 2] {
        let closed = self.closed_at(piece, &piece.centre());
        closed.and_then(|closed| self.inverse_mass(&closed)).map_or([0.0, f64::INFINITY], InverseMass::mass)
    }

    /// True if the pose and all boxes have one branch: the assembly at the middle of each common face is proved to be that of both boxes.
    fn is_connected(&self, pieces: &[Piece]) -> bool {
        let holds = |piece: &Piece, q: &[Interval]| {
            q.iter().zip(&piece.q).all(|(x, within)| within.lo() <= x.lo() && x.hi() <= within.hi())
        };
        // The pose at the floating-point numbers of the varied positions: their intervals may lie on both sides of a face.
        let start = &self.problem.q;
        let at = self.varied.iter().map(|(k, ..)| Interval::point(start[*k].mid()));
        let Ok(pose) = self.problem.close(&self.replaced(start, at)) else { return false };
        let Some(first) = pieces.iter().position(|piece| holds(piece, &pose.q)) else { return false };
        let (mut reached, mut queue) = (vec![false; pieces.len()], vec![first]);
        reached[first] = true;
        while let Some(i) = queue.pop() {
            for k in 0..pieces.len() {
                if reached[k] {
                    continue;
                }
                let faces = pieces[i].bounds.iter().zip(&pieces[k].bounds);
                let common: Vec<(f64, f64)> = faces.map(|((a, b), (c, d))| (a.max(*c), b.min(*d))).collect();
                let touching = common.iter().filter(|(a, b)| a == b).count();
                if common.iter().any(|(a, b)| a > b) || touching > 1 {
                    continue;
                }
                let face: Vec<f64> = common.iter().map(|(a, b)| 0.5 * a + 0.5 * b).collect();
                let closed = self.closed_at(&pieces[i], &face);
                if closed.is_some_and(|at| holds(&pieces[i], &at.q) && holds(&pieces[k], &at.q)) {
                    reached[k] = true;
                    queue.push(k);
                }
            }
        }
        reached.into_iter().all(|reached| reached)
    }
}
