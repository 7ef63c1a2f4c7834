//! Largest and smallest m̄ over ranges of joints: branch and bound, the box with the worst bound first.

use super::bracket::{self, InverseMass, quadratic_bound};
use super::load::{Load, Loads};
use super::loops::{Loops, times};
use super::plan::{Carried, Motion, Placement, Plan};
use super::records::{ExtremeBracket, RangeProof};
use crate::tolerances::CHECK_ROOM;
use nalgebra::{DMatrix, DVector};
use percuss_spatial::{Interval, Scalar};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Side of a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Largest m̄: lower bounds of 1/m̄.
    Most,
    /// Smallest m̄: upper bounds of 1/m̄.
    Least,
}

/// Problem over ranges of positions.
pub(super) struct Ranges<'a> {
    pub plan: &'a Plan<Interval>,
    pub load: &'a Load<Interval>,
    pub loops: &'a Loops,
    /// Positions of all joints.
    pub q: &'a [Interval],
    /// Index and bounds of each varied position.
    pub varied: &'a [(usize, f64, f64)],
    pub proof: RangeProof,
}

/// A box with its bound of 1/m̄.
struct Cell {
    bounds: Vec<(f64, f64)>,
    /// Bound of 1/m̄: lower for [`Side::Most`], negative upper for [`Side::Least`]. The smallest bound is the worst.
    bound: f64,
    /// Range to be halved.
    division: usize,
    node: usize,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Cell {}
impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound).then(other.node.cmp(&self.node))
    }
}

/// Bound of a box, and the values of 1/m̄ at some of its points.
struct Bound {
    bound: f64,
    division: usize,
    best: (f64, Vec<f64>),
}

/// Rates u = M⁻¹j at the positions x of the varied joints.
struct Solution {
    x: Vec<f64>,
    u: Vec<f64>,
    inverse_mass: f64,
    whitening: Option<DMatrix<f64>>,
    /// |∂r/∂xₖ|² in the metric M⁻¹, over points and normals of the contact: the motion u is not optimal beside x, even if the slopes are
    /// constant. Zero for the smallest m̄, whose bound contains r.
    curvatures: Vec<f64>,
}

/// Contact at a placement of all bodies.
struct At<'a, T: Scalar> {
    plan: &'a Plan<T>,
    load: &'a Load<T>,
    placements: &'a [Placement<T>],
    loads: &'a Loads<T>,
    varied: &'a [(usize, f64, f64)],
}

impl<T: Scalar> At<'_, T> {
    /// Derivatives of j·a + j·b − aᵀM b by the varied positions. `times`: number of the motions of the contact in the normal's part.
    fn slopes(&self, a: &Motion<T>, b: &Motion<T>, times: f64) -> Vec<T> {
        let carried = self.loads.normals.as_ref().map(|(body, normals)| Carried {
            body: *body,
            normals,
            velocity: self.load.velocity(&a.twists[*body]) * T::from_f64(times),
        });
        let mut slopes = vec![T::zero(); self.varied.len()];
        for (position, slope) in self.plan.slopes(self.placements, a, b, carried) {
            if let Some(k) = self.varied.iter().position(|(q, ..)| *q == position) {
                slopes[k] += slope;
            }
        }
        slopes
    }
}

impl Ranges<'_> {
    /// Encloses the extreme of m̄ on one side.
    pub fn enclose(&self, side: Side) -> ExtremeBracket {
        let (plan, load) = (self.plan.middle(), self.load.middle());
        let search = Search { ranges: self, plan, load, side };
        let whole: Vec<(f64, f64)> = self.varied.iter().map(|(_, lower, upper)| (*lower, *upper)).collect();
        // Tree of divisions: children of a node, or none.
        let mut tree: Vec<Option<(usize, usize)>> = vec![None];
        let mut boxes = 0;
        let mut queue = BinaryHeap::new();
        // Smallest sign · 1/m̄ found, and the worst bound among the finished boxes.
        let known = if side == Side::Most { self.proof.known.recip() } else { f64::INFINITY };
        let middle = whole.iter().map(|(a, b)| 0.5 * a + 0.5 * b).collect();
        let (mut best, mut closed) = ((known, middle), f64::INFINITY);
        let enough = |best: f64| match side {
            Side::Most => best / self.proof.ratio(),
            Side::Least => best * self.proof.ratio(),
        };
        let mut pending = vec![(whole, 0)];
        loop {
            for (bounds, node) in pending.drain(..) {
                boxes += 1;
                let Bound { bound, division, best: found } = search.bound(&bounds, enough(best.0));
                if found.0 < best.0 {
                    best = found;
                }
                if bound >= enough(best.0) {
                    closed = closed.min(bound);
                } else {
                    queue.push(Cell { bounds, bound, division, node });
                }
            }
            let Some(worst) = queue.pop() else { break };
            if worst.bound >= enough(best.0) || boxes >= self.proof.budget {
                closed = closed.min(worst.bound);
                break;
            }
            let (lower, upper) = worst.bounds[worst.division];
            let middle = 0.5 * lower + 0.5 * upper;
            if !(lower < middle && middle < upper) {
                closed = closed.min(worst.bound);
                break;
            }
            let first = tree.len();
            tree[worst.node] = Some((worst.division, first));
            tree.extend([None, None]);
            for (k, half) in [(lower, middle), (middle, upper)].into_iter().enumerate() {
                let mut bounds = worst.bounds.clone();
                bounds[worst.division] = half;
                pending.push((bounds, first + k));
            }
        }
        // The value at the best point, proved.
        let at = search.positions(best.1.iter().copied().map(Interval::point));
        let value = bracket::inverse_mass(self.plan, self.load, self.loops, &at, (&[], &[]));
        let [lower, upper] = value.map_or([0.0, f64::INFINITY], InverseMass::mass);
        let outer = InverseMass { least: closed, most: -closed, middle: f64::NAN }.mass();
        let (lower, upper) = match side {
            Side::Most => (lower, outer[1]),
            Side::Least => (outer[0], upper),
        };
        // Room for the roundings of another program that checks the proof.
        let (lower, upper) = (lower * (1.0 - CHECK_ROOM), upper * (1.0 + CHECK_ROOM));
        let is_proved = self.proof.is_met(lower, upper);
        ExtremeBracket { lower, upper, positions: best.1, is_proved, boxes, divisions: preorder(&tree) }
    }
}

/// Divisions of a tree in preorder.
fn preorder(tree: &[Option<(usize, usize)>]) -> Vec<i32> {
    let (mut open, mut divisions) = (vec![0], Vec::with_capacity(tree.len()));
    while let Some(node) = open.pop() {
        match tree[node] {
            None => divisions.push(-1),
            Some((division, first)) => {
                divisions.push(division as i32);
                open.extend([first + 1, first]);
            }
        }
    }
    divisions
}

struct Search<'a> {
    ranges: &'a Ranges<'a>,
    plan: Plan<f64>,
    load: Load<f64>,
    side: Side,
}

impl Search<'_> {
    /// +1 for lower bounds of 1/m̄, −1 for upper bounds.
    fn sign(&self) -> f64 {
        if self.side == Side::Most { 1.0 } else { -1.0 }
    }

    /// Rates u = M⁻¹j at positions of the varied joints; `None` if M is singular.
    fn solution(&self, x: &[f64]) -> Option<Solution> {
        let mut q: Vec<f64> = self.ranges.q.iter().map(|x| x.mid()).collect();
        self.ranges.varied.iter().zip(x).for_each(|((k, ..), x)| q[*k] = *x);
        let (plan, n) = (&self.plan, self.plan.coordinates);
        let placements = plan.placements(&q);
        let loads = self.load.wrenches(plan, &placements);
        let still = vec![0.0; n];
        let pressed = plan.motion(&placements, still.clone(), &loads.wrenches);
        let j = plan.residual(&placements, &pressed.balances, &still);
        let units = plan.unit_motions(&placements);
        let columns = plan.mass_columns(&placements, &units);
        let factor = DMatrix::from_fn(n, n, |r, c| columns[c][r]).cholesky()?;
        let u = factor.solve(&DVector::from_column_slice(&j));
        let inverse_mass = u.iter().zip(&j).map(|(u, j)| u * j).sum::<f64>();
        let u: Vec<f64> = u.iter().copied().collect();
        let varied = self.ranges.varied;
        let (mut whitening, mut curvatures) = (None, vec![0.0; varied.len()]);
        if self.side == Side::Least {
            whitening = Some(factor.l().try_inverse()?);
        } else if self.ranges.proof.varies_contact() {
            let at = At { plan, load: &self.load, placements: &placements, loads: &loads, varied };
            let motion = plan.motion(&placements, u.clone(), &loads.wrenches);
            let columns: Vec<Vec<f64>> = units.iter().map(|unit| at.slopes(unit, &motion, 1.0)).collect();
            for (k, curvature) in curvatures.iter_mut().enumerate() {
                let change = DVector::from_fn(n, |i, _| columns[i][k]);
                *curvature = change.dot(&factor.solve(&change));
            }
        }
        Some(Solution { x: x.to_vec(), u, inverse_mass, whitening, curvatures })
    }

    /// Positions of all joints, with the varied ones replaced.
    fn positions(&self, x: impl Iterator<Item = Interval>) -> Vec<Interval> {
        let mut q = self.ranges.q.to_vec();
        self.ranges.varied.iter().zip(x).for_each(|((k, ..), x)| q[*k] = x);
        q
    }

    /// Bound of a box. A second motion, of the worst corner, is used if the bound of the motion at the centre is not `enough`.
    fn bound(&self, bounds: &[(f64, f64)], enough: f64) -> Bound {
        let sign = self.sign();
        let centre: Vec<f64> = bounds.iter().map(|(a, b)| 0.5 * a + 0.5 * b).collect();
        let widest = (0..bounds.len())
            .max_by(|&a, &b| (bounds[a].1 - bounds[a].0).total_cmp(&(bounds[b].1 - bounds[b].0)));
        let unbounded = Bound {
            bound: f64::NEG_INFINITY,
            division: widest.unwrap_or(0),
            best: (f64::INFINITY, centre.clone()),
        };
        let Some(solution) = self.solution(&centre) else { return unbounded };
        let mut found = self.bound_with(bounds, &solution);
        found.best = (sign * solution.inverse_mass, centre);
        if found.bound >= enough || found.corner == found.best.1 {
            return found.into();
        }
        if let Some(other) = self.solution(&found.corner) {
            let value = sign * other.inverse_mass;
            if value < found.best.0 {
                found.best = (value, found.corner.clone());
            }
            found.bound = found.bound.max(self.bound_with(bounds, &other).bound);
        }
        found.into()
    }

    /// Bound with the rates of one solution: mean-value form from the worst corner of the directions with a derivative of one sign.
    fn bound_with(&self, bounds: &[(f64, f64)], solution: &Solution) -> Evaluated {
        let (plan, load, varied) = (self.ranges.plan, self.ranges.load, self.ranges.varied);
        let sign = Interval::point(self.sign());
        let u: Vec<Interval> = solution.u.iter().copied().map(Interval::point).collect();
        let placements = plan.placements(&self.positions(bounds.iter().map(|(a, b)| Interval::new(*a, *b))));
        let loads = load.wrenches(plan, &placements);
        let motion = plan.motion(&placements, u.clone(), &loads.wrenches);
        let mut bound = (plan.energy_bound(&motion.twists, &loads.wrenches, &u) * sign).lo();
        let mut importance: Vec<f64> = bounds.iter().map(|(a, b)| b - a).collect();
        let mut corner = solution.x.clone();
        let reach = |k: usize| Interval::new(bounds[k].0, bounds[k].1) - Interval::point(solution.x[k]);
        let at = At { plan, load, placements: &placements, loads: &loads, varied };
        if !loads.is_relative {
            let mut loss = Interval::point(0.0);
            for (k, slope) in at.slopes(&motion, &motion, 2.0).into_iter().enumerate() {
                let slope = slope * sign;
                let width = bounds[k].1 - bounds[k].0;
                importance[k] = (slope.hi() - slope.lo()) * width + solution.curvatures[k] * width * width;
                if slope.lo() >= 0.0 && slope.hi() > 0.0 {
                    corner[k] = bounds[k].0;
                } else if slope.hi() <= 0.0 && slope.lo() < 0.0 {
                    corner[k] = bounds[k].1;
                } else {
                    loss += Interval::point((slope * reach(k)).lo().min(0.0));
                }
            }
            let placements = plan.placements(&self.positions(corner.iter().copied().map(Interval::point)));
            let loads = load.wrenches(plan, &placements);
            let twists = plan.twists(&placements, &u);
            let value = plan.energy_bound(&twists, &loads.wrenches, &u) * sign;
            bound = bound.max((value + loss).lo());
        }
        if let Some(c) = &solution.whitening {
            // w ≤ G + rᵀM⁻¹r, with C r by the mean-value form: r vanishes at the solution.
            let units = plan.unit_motions(&placements);
            let white = if loads.is_relative {
                times(c, &plan.residual(&placements, &motion.balances, &u))
            } else {
                let there = plan.placements(&self.positions(solution.x.iter().copied().map(Interval::point)));
                let loads = load.wrenches(plan, &there);
                let middle = plan.motion(&there, u.clone(), &loads.wrenches);
                let mut white = times(c, &plan.residual(&there, &middle.balances, &u));
                let columns: Vec<Vec<Interval>> =
                    units.iter().map(|unit| at.slopes(unit, &motion, 1.0)).collect();
                for k in 0..bounds.len() {
                    let column: Vec<Interval> = columns.iter().map(|slopes| slopes[k]).collect();
                    for (white, step) in white.iter_mut().zip(times(c, &column)) {
                        let step = step * reach(k);
                        *white += step;
                        importance[k] += step.magnitude() * step.magnitude();
                    }
                }
                white
            };
            let gap = quadratic_bound(&plan.mass_columns(&placements, &units), c, &white);
            bound = (Interval::point(bound) - Interval::point(gap)).lo();
        }
        let most = (0..bounds.len()).max_by(|&a, &b| importance[a].total_cmp(&importance[b]));
        Evaluated { bound, division: most.unwrap_or(0), corner, best: (f64::INFINITY, Vec::new()) }
    }
}

/// Bound with the worst corner.
struct Evaluated {
    bound: f64,
    division: usize,
    corner: Vec<f64>,
    best: (f64, Vec<f64>),
}

impl From<Evaluated> for Bound {
    fn from(from: Evaluated) -> Self {
        Self { bound: from.bound, division: from.division, best: from.best }
    }
}
