//! Path follower: follows a branch, the curve of closed poses of a group, while the drivers move along a straight
//! path.
//!
//! Steps are taken along the tangent of the curve, not along the driver path. Limits, at which the drivers reverse,
//! are therefore ordinary points of the curve and are found exactly. Source: Allgower and Georg, Introduction to
//! Numerical Continuation Methods, 2003, ch. 2, 6 and 8. Each step is corrected by the shortest motion (their
//! Moore–Penrose correction).

use super::chart::Chart;
use super::correct::{Correction, Directions, Linearised, norm};
use crate::kinematics::frames::Kinematics;
use crate::linear::dense::dot;
use crate::linear::jacobian::Jacobian;
use crate::model::{Group, Model};
use crate::tolerances::{
    BESIDE_DRIFT, BRACKET_WIDTH, BRANCH_STEPS, FEWEST_BRANCH_STEPS, FLAT_SLOPE, LEAST_MIDDLE_SLOPE,
    LIMIT_OFFSET, LONGEST_BRANCH_STEP, NEARLY_SINGULAR, SHORTEST_BRANCH_STEP, STRAIGHT,
};

/// Straight path of a group's drivers.
pub(crate) struct DriverPath<'a> {
    pub model: &'a Model,
    pub group: &'a Group,
    /// Dependent coordinates (by index into the group).
    pub unknown: &'a [usize],
    /// Rates of the drivers over the group's coordinates, with a length of 1 m/s.
    pub direction: Vec<f64>,
    /// Length of the path, m.
    pub length: f64,
    /// Residual at which the group counts as closed, m.
    pub tolerance: f64,
    /// Ratio of the smallest to the largest pivot of the dependent coordinates' Jacobian at the generic pose.
    pub conditioning: f64,
    /// Position indices of the moving drivers, with their positions at the end.
    pub ends: Vec<(usize, f64)>,
}

/// End of a path.
pub(crate) struct Arrival {
    /// True if the target was reached; otherwise the end is a limit, or the nearest point found.
    pub is_reached: bool,
    /// A regular pose on the same branch, if the end is not regular.
    pub anchor: Option<Vec<f64>>,
    /// True if the step limit stopped the path.
    pub too_far: bool,
    /// True if branches are too close to each other here to be distinguished.
    pub uncertain: bool,
    /// Residuals and rows of the group at the current pose, if known.
    pub linearised: Option<Linearised>,
}

impl Arrival {
    fn at_end(anchor: Option<Vec<f64>>) -> Self {
        Self { is_reached: true, anchor, too_far: false, uncertain: false, linearised: None }
    }

    fn short_of_end(anchor: Option<Vec<f64>>, too_far: bool) -> Self {
        Self { is_reached: false, anchor, too_far, uncertain: false, linearised: None }
    }

    fn uncertain() -> Self {
        Self { uncertain: true, ..Self::short_of_end(None, false) }
    }
}

/// Point of the curve.
#[derive(Clone)]
pub(super) struct BranchPoint {
    pub q: Vec<f64>,
    /// Distance of the drivers along the path, m.
    pub travelled: f64,
    /// Unit tangent over the directions: dependent coordinates, then the driver path.
    pub tangent: Vec<f64>,
    /// A over the directions.
    pub jacobian: Jacobian,
}

/// Evidence that a step stays on its branch.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum BranchEvidence {
    /// No other branch is near.
    Chart,
    /// Branches cross within the closing tolerance, and each continues straight.
    Crossing,
}

/// Result of a direct step to the target.
pub(super) enum TargetStep {
    /// The target was reached. `singular`: the dependent coordinates' Jacobian is nearly singular there.
    Reached { singular: bool, here: Linearised },
    /// The target may lie on another branch that comes near.
    Doubtful,
    /// The correction did not converge, or was too long.
    Failed,
}

/// Result of a step over a crossing.
pub(super) enum CrossingStep {
    /// A point beyond the crossing, and the length of the step, m.
    Beyond(BranchPoint, f64),
    /// The target lies at the crossing; residuals and rows at the target.
    Target(Linearised),
    None,
}

/// Result of a step along the branch.
pub(super) enum BranchStep {
    Taken(BranchPoint),
    /// The end of the step may lie on another branch that comes near.
    Doubtful,
    /// The correction did not converge, or was too long.
    Failed,
}

impl<'a> DriverPath<'a> {
    /// Path along the driver displacements `direction` over the group's coordinates; `None` if all are zero. The other
    /// arguments are the fields of the same name.
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

    /// Directions: dependent coordinates, and the driver path.
    pub(super) fn directions(&self) -> Directions<'_> {
        Directions { unknown: self.unknown, path: Some(&self.direction) }
    }

    /// Directions: dependent coordinates only.
    fn dependent_directions(&self) -> Directions<'_> {
        Directions { unknown: self.unknown, path: None }
    }

    pub(super) fn size(&self) -> f64 {
        self.group.size
    }

    /// Follows the branch from a closed pose to the end of the path, or to the end of the branch.
    pub fn follow(&self, kinematics: &mut Kinematics) -> Arrival {
        let start = self.start_point(kinematics);
        self.follow_to(kinematics, start, self.length, true)
    }

    /// Point of the curve at the current pose of the group.
    pub(super) fn start_point(&self, kinematics: &Kinematics) -> BranchPoint {
        let mut ahead = vec![0.0; self.unknown.len() + 1];
        ahead[self.unknown.len()] = 1.0;
        self.point(kinematics, 0.0, &ahead)
    }

    /// Point of the curve at the current pose; its tangent is oriented along the vector `before`.
    pub(super) fn point(&self, kinematics: &Kinematics, gone: f64, before: &[f64]) -> BranchPoint {
        let here = Linearised::at(self.model, kinematics, self.group);
        let jacobian = self.directions().jacobian(self.group, &here.rows);
        BranchPoint {
            q: kinematics.q.clone(),
            travelled: gone,
            tangent: self.tangent(&jacobian, before),
            jacobian,
        }
    }

    /// Restores the positions `q` and the frames of the group.
    pub(super) fn restore_positions(&self, kinematics: &mut Kinematics, q: &[f64]) {
        if kinematics.q != q {
            kinematics.q.copy_from_slice(q);
            self.model.refill_group(kinematics, self.group);
        }
    }

    /// Follows the branch until the drivers have moved to `target` (m), forwards or backwards. `careful`:
    /// near-singular ends are interpolated from both sides.
    pub(super) fn follow_to(
        &self,
        kinematics: &mut Kinematics,
        mut here: BranchPoint,
        target: f64,
        careful: bool,
    ) -> Arrival {
        self.restore_positions(kinematics, &here.q);
        if target == here.travelled {
            return Arrival::at_end(None);
        }
        let sign = (target - here.travelled).signum();
        let slope = |point: &BranchPoint| sign * point.tangent[self.unknown.len()];
        if slope(&here) < 0.0 {
            here.tangent.iter_mut().for_each(|t| *t = -*t);
        }
        let mut step = self.longest_step(&here.tangent);
        let columns = self.unknown.len() + 1;
        let steps = (10_000_000 / columns.pow(3)).clamp(FEWEST_BRANCH_STEPS, BRANCH_STEPS);
        let mut too_far = true;
        for _ in 0..steps {
            let left = (target - here.travelled).abs();
            // At a crossing of branches ahead, shorter steps do not separate the branches.
            let mut crossing = None;
            let mut doubtful = false;
            if slope(&here) > 0.0 && left <= step * slope(&here) {
                match self.step_to_target(kinematics, &here, target, BranchEvidence::Chart) {
                    TargetStep::Reached { singular, here: landed } => {
                        return self.arrival_at_target(kinematics, here, target, singular, landed, careful);
                    }
                    TargetStep::Doubtful => doubtful = true,
                    TargetStep::Failed => {}
                }
                self.restore_positions(kinematics, &here.q);
            }
            let next = if doubtful {
                BranchStep::Doubtful
            } else {
                self.step_along(kinematics, &here, step, BranchEvidence::Chart)
            };
            let next = match next {
                BranchStep::Taken(next) => Some(next),
                BranchStep::Doubtful if step <= self.crossing_width() => {
                    crossing = Some(self.crosses_near(kinematics, &here));
                    None
                }
                BranchStep::Doubtful | BranchStep::Failed => None,
            };
            match crossing {
                Some(false) => {
                    self.restore_positions(kinematics, &here.q);
                    return Arrival::uncertain();
                }
                Some(true) => match self.step_over_crossing(kinematics, &here, target) {
                    CrossingStep::Beyond(next, length) => {
                        here = next;
                        step = 0.5 * length;
                        continue;
                    }
                    CrossingStep::Target(landed) => {
                        return self.arrival_at_target(kinematics, here, target, true, landed, careful);
                    }
                    CrossingStep::None => {}
                },
                None => {}
            }
            match next {
                Some(next) if slope(&next) <= 0.0 => {
                    let limit = self.reversal_point(kinematics, &here, step, &slope);
                    let Some(limit) = limit else {
                        step /= 2.0;
                        continue;
                    };
                    let beyond = sign * (limit.travelled - target);
                    if beyond < -LIMIT_OFFSET * self.size() {
                        return Arrival::short_of_end(Some(here.q), false);
                    }
                    if beyond.abs() <= LIMIT_OFFSET * self.size() {
                        self.restore_positions(kinematics, &limit.q);
                        return Arrival::at_end(Some(here.q));
                    }
                    // The end lies before the limit; with a smaller step the direct step succeeds.
                    step /= 2.0;
                }
                Some(next) if sign * (next.travelled - target) >= 0.0 => step /= 2.0,
                Some(next) => {
                    here = next;
                    step = f64::min(2.0 * step, self.longest_step(&here.tangent));
                }
                None => step /= 2.0,
            }
            if step < SHORTEST_BRANCH_STEP * self.size() {
                too_far = false;
                break;
            }
        }
        self.restore_positions(kinematics, &here.q);
        Arrival::short_of_end(None, too_far)
    }

    /// Result at the end of the path, with the group at the target.
    fn arrival_at_target(
        &self,
        kinematics: &mut Kinematics,
        here: BranchPoint,
        target: f64,
        singular: bool,
        landed: Linearised,
        careful: bool,
    ) -> Arrival {
        if !singular {
            return Arrival { linearised: Some(landed), ..Arrival::at_end(None) };
        }
        if !careful {
            return Arrival::at_end(Some(here.q));
        }
        let anchor = self.interpolate_at_target(kinematics, &here, target).unwrap_or(here.q);
        Arrival::at_end(Some(anchor))
    }

    /// Longest step along a tangent, m.
    pub(super) fn longest_step(&self, tangent: &[f64]) -> f64 {
        LONGEST_BRANCH_STEP * self.size() / tangent.iter().fold(0.0, |most: f64, t| most.max(t.abs()))
    }

    /// A step along the tangent, corrected by the shortest motion.
    pub(super) fn step_along(
        &self,
        kinematics: &mut Kinematics,
        here: &BranchPoint,
        step: f64,
        trust: BranchEvidence,
    ) -> BranchStep {
        self.restore_positions(kinematics, &here.q);
        let directions = self.directions();
        self.model.advance_group(
            kinematics,
            self.group,
            &directions.expand(self.group, |k| step * here.tangent[k]),
        );
        let correction = self.model.correct(kinematics, self.group, directions, self.tolerance);
        if !correction.closed || correction.moved > 0.25 * step + self.tolerance {
            return BranchStep::Failed;
        }
        let gone = here.travelled + step * here.tangent[self.unknown.len()] + correction.path_motion;
        let point = self.corrected_point(kinematics, &correction, gone, &here.tangent);
        if dot(&point.tangent, &here.tangent) <= STRAIGHT {
            return BranchStep::Failed;
        }
        match trust == BranchEvidence::Crossing || self.is_same_branch(here, &point, step) {
            true => BranchStep::Taken(point),
            false => BranchStep::Doubtful,
        }
    }

    /// Point of the curve after a correction.
    fn corrected_point(
        &self,
        kinematics: &Kinematics,
        correction: &Correction,
        gone: f64,
        before: &[f64],
    ) -> BranchPoint {
        let jacobian = self.directions().jacobian(self.group, &correction.linearised.rows);
        BranchPoint {
            q: kinematics.q.clone(),
            travelled: gone,
            tangent: self.tangent(&jacobian, before),
            jacobian,
        }
    }

    /// True if no other branch comes between two points at a distance of about `step` metres.
    fn is_same_branch(&self, here: &BranchPoint, point: &BranchPoint, step: f64) -> bool {
        let chart = Chart::of(&here.jacobian, &here.tangent, self.tolerance / self.size());
        // No chart exists at a crossing itself; its branches are assumed to continue straight.
        chart.is_none_or(|chart| {
            chart.excludes_branch_between(&point.jacobian, &point.tangent, step, self.size())
        }) && self.keeps_direction(here, point)
    }

    /// True if the drivers do not reverse twice between two points with the same driver direction. The slope in the
    /// middle of a cubic through both points is 3/2 of the mean slope minus a quarter of the sum of the end slopes. The
    /// mean slope is negative if the drivers have moved back although they advance at both points.
    fn keeps_direction(&self, here: &BranchPoint, point: &BranchPoint) -> bool {
        let n = self.unknown.len();
        let ahead = here.tangent[n].signum();
        let (first, last) = (ahead * here.tangent[n], ahead * point.tangent[n]);
        let least = f64::min(first, last);
        if least <= 0.0 {
            return true;
        }
        let gone = ahead * (point.travelled - here.travelled);
        let before = self.model.group_positions(self.group, &here.q);
        let moved = self.model.displacement_from(self.group, &before, &point.q);
        let square: f64 = self.unknown.iter().map(|&at| (moved[at] * self.group.lengths[at]).powi(2)).sum();
        let mean = gone / (square + gone * gone).sqrt();
        1.5 * mean - 0.25 * (first + last) >= LEAST_MIDDLE_SLOPE * least
    }

    /// Steps directly from a point to the target; only dependent coordinates are corrected.
    pub(super) fn step_to_target(
        &self,
        kinematics: &mut Kinematics,
        here: &BranchPoint,
        target: f64,
        trust: BranchEvidence,
    ) -> TargetStep {
        self.restore_positions(kinematics, &here.q);
        let n = self.unknown.len();
        let step = (target - here.travelled) / here.tangent[n];
        let rates = self.directions().expand(self.group, |k| step * here.tangent[k]);
        self.model.advance_positions(kinematics, self.group, &rates);
        if target == self.length {
            self.ends.iter().for_each(|(q, end)| kinematics.q[*q] = *end);
        }
        self.model.refill_group(kinematics, self.group);
        let correction =
            self.model.correct(kinematics, self.group, self.dependent_directions(), self.tolerance);
        // A nearly double root is found only to the square root of the tolerance.
        let blurred = (self.tolerance * self.size()).sqrt();
        if !correction.closed || correction.moved > 0.25 * step.abs() + blurred {
            return TargetStep::Failed;
        }
        let followers = self.dependent_directions().jacobian(self.group, &correction.linearised.rows);
        let pivots = followers.pivot_ratio();
        let singular = pivots < NEARLY_SINGULAR * self.conditioning;
        if trust == BranchEvidence::Chart && !singular && self.excludes_other_branch(here, &followers, pivots)
        {
            return TargetStep::Reached { singular, here: correction.linearised };
        }
        let point = self.corrected_point(kinematics, &correction, target, &here.tangent);
        let slopes = here.tangent[n] * point.tangent[n];
        let straight = dot(&point.tangent, &here.tangent) > STRAIGHT;
        if trust == BranchEvidence::Chart && slopes <= 0.0 {
            return TargetStep::Failed;
        }
        if trust == BranchEvidence::Chart && !(straight && self.is_same_branch(here, &point, step.abs())) {
            return if straight { TargetStep::Doubtful } else { TargetStep::Failed };
        }
        match singular || straight {
            true => TargetStep::Reached { singular, here: correction.linearised },
            false => TargetStep::Failed,
        }
    }

    /// True if the change of the dependent coordinates' Jacobian between two points excludes another branch and a
    /// reversal of the drivers in between. The change is compared with the smallest pivot at the end; `pivots` is its
    /// ratio to the largest.
    fn excludes_other_branch(&self, here: &BranchPoint, followers: &Jacobian, pivots: f64) -> bool {
        let n = self.unknown.len();
        let before = here.jacobian.entries.iter().filter(|(_, c, _)| *c < n);
        let (mut change, mut largest) = (0.0, 0.0f64);
        for ((.., a), (.., b)) in followers.entries.iter().zip(before) {
            change += (a - b) * (a - b);
            largest = largest.max(a.abs());
        }
        (change * n as f64).sqrt() <= BESIDE_DRIFT * here.tangent[n].abs() * pivots * largest
    }

    /// Unit tangent of the curve closest to `before`: J t = 0, `before`·t > 0. At a crossing of branches: the
    /// projection of `before` on the plane of the tangents.
    fn tangent(&self, jacobian: &Jacobian, before: &[f64]) -> Vec<f64> {
        let mut t = jacobian.projected(before, self.tolerance / self.size());
        let length = norm(&t);
        t.iter_mut().for_each(|t| *t /= length);
        t
    }

    /// Point between `here` and the end of a step at which the drivers reverse. Method: false position (Illinois) on
    /// the slope of the driver path.
    fn reversal_point(
        &self,
        kinematics: &mut Kinematics,
        here: &BranchPoint,
        step: f64,
        slope: &dyn Fn(&BranchPoint) -> f64,
    ) -> Option<BranchPoint> {
        let mut taken = |at: f64| match self.step_along(kinematics, here, at, BranchEvidence::Chart) {
            BranchStep::Taken(point) => Some(point),
            BranchStep::Doubtful | BranchStep::Failed => None,
        };
        let far = taken(step)?;
        let (mut low, mut high) = ((0.0, slope(here)), (step, slope(&far)));
        let mut best = far;
        let mut side = 0;
        for _ in 0..80 {
            let at = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let point = taken(at)?;
            let value = slope(&point);
            let done = value.abs() < FLAT_SLOPE || (high.0 - low.0).abs() < BRACKET_WIDTH * self.size();
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
        self.restore_positions(kinematics, &best.q);
        Some(best)
    }
}
