//! Following a branch: the curve of closed poses that a group runs through while its drivers follow a straight path.
//!
//! Steps go along the curve's own tangent, not along the drivers, so that limits (where the drivers turn back) are
//! points like others: found, and found exactly. Source: Allgower and Georg, Introduction to Numerical Continuation
//! Methods, 2003, ch. 2, 6 and 8; a step is corrected by the shortest motion (their Moore–Penrose correction).

use super::correct::{Directions, Linearised, norm};
use crate::kinematics::Kinematics;
use crate::linear::dense::dot;
use crate::model::{Group, Model};
use crate::tolerances::{
    BRANCH_STEPS, FEWEST_BRANCH_STEPS, LONGEST_BRANCH_STEP, NEARLY_SINGULAR, SHORTEST_BRANCH_STEP, STRAIGHT,
};

/// A straight path of a group's drivers.
pub(crate) struct DriverPath<'a> {
    pub model: &'a Model,
    pub group: &'a Group,
    /// Coordinates (by index into the group's) that follow.
    pub unknown: &'a [usize],
    /// Rates of the drivers over the group's coordinates, 1 m/s long.
    pub direction: Vec<f64>,
    /// m.
    pub length: f64,
    /// Residual at which the group counts as closed, m.
    pub tolerance: f64,
    /// Least over largest pivot of the followers' Jacobian at the generic pose.
    pub conditioning: f64,
    /// The places of the drivers that move among the positions, and where they stand at the end.
    pub ends: Vec<(usize, f64)>,
}

/// Where a path ended.
pub(crate) struct Arrival {
    /// Whether that is where it was to go; else it is a limit, or the nearest point that was found.
    pub there: bool,
    /// A regular pose on the same branch, where the end is none.
    pub anchor: Option<Vec<f64>>,
    /// Whether the path was too long, and nothing but that stopped it.
    pub too_far: bool,
    /// The group where it stands now, where that is known.
    pub here: Option<Linearised>,
}

impl Arrival {
    fn at_end(anchor: Option<Vec<f64>>) -> Self {
        Self { there: true, anchor, too_far: false, here: None }
    }

    fn short_of_end(anchor: Option<Vec<f64>>, too_far: bool) -> Self {
        Self { there: false, anchor, too_far, here: None }
    }
}

/// A point of the curve.
#[derive(Clone)]
pub(super) struct Point {
    pub q: Vec<f64>,
    /// Distance that the drivers have gone along the path, m.
    pub gone: f64,
    /// Unit tangent over the moves: followers, then the drivers' path.
    pub tangent: Vec<f64>,
}

impl<'a> DriverPath<'a> {
    /// The path to drivers' displacements `direction` over the group's coordinates; none where there is none to go.
    pub fn new(
        model: &'a Model,
        group: &'a Group,
        unknown: &'a [usize],
        mut direction: Vec<f64>,
        tolerance: f64,
        conditioning: f64,
        ends: Vec<(usize, f64)>,
    ) -> Option<Self> {
        let length = direction.iter().zip(&group.lengths).map(|(w, l)| (w * l).powi(2)).sum::<f64>().sqrt();
        if length == 0.0 {
            return None;
        }
        direction.iter_mut().for_each(|w| *w /= length);
        Some(Self { model, group, unknown, direction, length, tolerance, conditioning, ends })
    }

    fn directions(&self) -> Directions<'_> {
        Directions { unknown: self.unknown, path: Some(&self.direction) }
    }

    fn followers(&self) -> Directions<'_> {
        Directions { unknown: self.unknown, path: None }
    }

    fn size(&self) -> f64 {
        self.group.size
    }

    /// Goes from a closed pose to the end of the path, or as far as the branch goes.
    pub fn go(&self, kinematics: &mut Kinematics<f64>) -> Arrival {
        let start = self.start(kinematics);
        self.run(kinematics, start, self.length, true)
    }

    /// The curve's point where the group stands now.
    pub(super) fn start(&self, kinematics: &Kinematics<f64>) -> Point {
        let mut ahead = vec![0.0; self.unknown.len() + 1];
        ahead[self.unknown.len()] = 1.0;
        Point { q: kinematics.q.clone(), gone: 0.0, tangent: self.tangent(kinematics, &ahead) }
    }

    fn stand(&self, kinematics: &mut Kinematics<f64>, q: &[f64]) {
        if kinematics.q != q {
            kinematics.q.copy_from_slice(q);
            self.model.refill_group(kinematics, self.group);
        }
    }

    /// From a point to where the drivers have gone `target` metres, forwards or back. `careful`: near-singular ends are
    /// looked at from both sides.
    pub(super) fn run(
        &self,
        kinematics: &mut Kinematics<f64>,
        mut here: Point,
        target: f64,
        careful: bool,
    ) -> Arrival {
        self.stand(kinematics, &here.q);
        if target == here.gone {
            return Arrival::at_end(None);
        }
        let sign = (target - here.gone).signum();
        let slope = |point: &Point| sign * point.tangent[self.unknown.len()];
        if slope(&here) < 0.0 {
            here.tangent.iter_mut().for_each(|t| *t = -*t);
        }
        let mut step = self.longest(&here.tangent);
        let columns = self.unknown.len() + 1;
        let steps = (10_000_000 / columns.pow(3)).clamp(FEWEST_BRANCH_STEPS, BRANCH_STEPS);
        let mut too_far = true;
        for _ in 0..steps {
            let left = (target - here.gone).abs();
            if slope(&here) > 0.0 && left <= step * slope(&here) {
                if let Some((singular, landed)) = self.land(kinematics, &here, target) {
                    if !singular {
                        return Arrival { here: Some(landed), ..Arrival::at_end(None) };
                    }
                    if !careful {
                        return Arrival::at_end(Some(here.q));
                    }
                    let anchor = self.across(kinematics, &here, target).unwrap_or(here.q);
                    return Arrival::at_end(Some(anchor));
                }
                self.stand(kinematics, &here.q);
            }
            let next = self.step(kinematics, &here, step);
            match next {
                Some(next) if slope(&next) <= 0.0 => {
                    let limit = self.limit(kinematics, &here, step, &slope);
                    let Some(limit) = limit else {
                        step /= 2.0;
                        continue;
                    };
                    let beyond = sign * (limit.gone - target);
                    if beyond < -1e-13 * self.size() {
                        return Arrival::short_of_end(Some(here.q), false);
                    }
                    if beyond.abs() <= 1e-13 * self.size() {
                        self.stand(kinematics, &limit.q);
                        return Arrival::at_end(Some(here.q));
                    }
                    // The end lies before the limit: nearer to it the direct step succeeds.
                    step /= 2.0;
                }
                Some(next) if sign * (next.gone - target) >= 0.0 => step /= 2.0,
                Some(next) => {
                    here = next;
                    step = f64::min(2.0 * step, self.longest(&here.tangent));
                }
                None => step /= 2.0,
            }
            if step < SHORTEST_BRANCH_STEP * self.size() {
                too_far = false;
                break;
            }
        }
        self.stand(kinematics, &here.q);
        Arrival::short_of_end(None, too_far)
    }

    fn longest(&self, tangent: &[f64]) -> f64 {
        LONGEST_BRANCH_STEP * self.size() / tangent.iter().fold(0.0, |most: f64, t| most.max(t.abs()))
    }

    /// A step along the tangent, corrected by the shortest motion; none where it would leave the branch.
    fn step(&self, kinematics: &mut Kinematics<f64>, here: &Point, step: f64) -> Option<Point> {
        self.stand(kinematics, &here.q);
        let directions = self.directions();
        self.model.advance_group(
            kinematics,
            self.group,
            &directions.expand(self.group, |k| step * here.tangent[k]),
        );
        let correction = self.model.correct(kinematics, self.group, directions, self.tolerance);
        if !correction.closed || correction.moved > 0.25 * step + self.tolerance {
            return None;
        }
        let tangent = self.tangent_at(&correction.here, &here.tangent);
        let gone = here.gone + step * here.tangent[self.unknown.len()] + correction.along;
        let point = Point { q: kinematics.q.clone(), gone, tangent };
        (dot(&point.tangent, &here.tangent) > STRAIGHT).then_some(point)
    }

    /// Goes from a point straight to the target, followers alone being corrected. None where that is not the branch;
    /// else whether the end is nearly singular, and the group there.
    fn land(
        &self,
        kinematics: &mut Kinematics<f64>,
        here: &Point,
        target: f64,
    ) -> Option<(bool, Linearised)> {
        self.stand(kinematics, &here.q);
        let n = self.unknown.len();
        let step = (target - here.gone) / here.tangent[n];
        let rates = self.directions().expand(self.group, |k| step * here.tangent[k]);
        self.model.advance_positions(kinematics, self.group, &rates);
        if target == self.length {
            self.ends.iter().for_each(|(q, end)| kinematics.q[*q] = *end);
        }
        self.model.refill_group(kinematics, self.group);
        let correction = self.model.correct(kinematics, self.group, self.followers(), self.tolerance);
        // A root that is nearly double is found to the root of the tolerance.
        let blurred = (self.tolerance * self.size()).sqrt();
        if !correction.closed || correction.moved > 0.25 * step.abs() + blurred {
            return None;
        }
        let singular = self.is_narrow(&correction.here);
        let straight = || dot(&self.tangent_at(&correction.here, &here.tangent), &here.tangent) > STRAIGHT;
        (singular || straight()).then_some((singular, correction.here))
    }

    /// Whether the followers' Jacobian is nearly singular here.
    fn is_narrow(&self, here: &Linearised) -> bool {
        self.followers().jacobian(self.group, &here.rows).pivot_ratio() < NEARLY_SINGULAR * self.conditioning
    }

    /// The unit tangent of the curve that is nearest to `before`: J t = 0, `before`·t > 0. Where branches cross, the part
    /// of `before` in the plane of their tangents.
    pub(super) fn tangent(&self, kinematics: &Kinematics<f64>, before: &[f64]) -> Vec<f64> {
        self.tangent_at(&Linearised::at(self.model, kinematics, self.group), before)
    }

    fn tangent_at(&self, here: &Linearised, before: &[f64]) -> Vec<f64> {
        let jacobian = self.directions().jacobian(self.group, &here.rows);
        let mut t = jacobian.projected(before, self.tolerance / self.size());
        let length = norm(&t);
        t.iter_mut().for_each(|t| *t /= length);
        t
    }

    /// The point between `here` and a step further where the drivers turn back, by the rule of false position
    /// (Illinois) on the slope of the drivers' path.
    fn limit(
        &self,
        kinematics: &mut Kinematics<f64>,
        here: &Point,
        step: f64,
        slope: &dyn Fn(&Point) -> f64,
    ) -> Option<Point> {
        let far = self.step(kinematics, here, step)?;
        let (mut low, mut high) = ((0.0, slope(here)), (step, slope(&far)));
        let mut best = far;
        let mut side = 0;
        for _ in 0..80 {
            let at = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let point = self.step(kinematics, here, at)?;
            let value = slope(&point);
            let done = value.abs() < 1e-13 || (high.0 - low.0).abs() < 1e-15 * self.size();
            best = point;
            if done {
                break;
            }
            let kept = if value > 0.0 { 1 } else { -1 };
            if value > 0.0 {
                low = (at, value);
                high.1 *= if side == kept { 0.5 } else { 1.0 };
            } else {
                high = (at, value);
                low.1 *= if side == kept { 0.5 } else { 1.0 };
            }
            side = kept;
        }
        self.stand(kinematics, &best.q);
        Some(best)
    }
}
