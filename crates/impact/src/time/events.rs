//! Points of the motion of an impact within a step: points of a force curve, reversals, the largest penetration, the end.

use crate::numerics::extrapolation::state_after;
use crate::time::history::SecondTouch;
use crate::time::motion::{Instant, Motion, finite_mass};
use crate::tolerances::{
    CONTACT_ENDS, CORNER_DISTANCE, END_ITERATIONS, LARGEST_TIME_STEP, MOST_TIME_STEPS, TIME_STEP_ERROR,
};
use percuss_dynamics::Pose;

/// Part of the largest step after which a motion that reverses has a direction.
const STICKING_STEP: f64 = 0.01;
/// Distance of a point of the force curve, over the penetration without damping, within which a step is examined.
const NEAR_CORNER: f64 = 0.01;
/// Least part of a step before a turn of the motion at which the step ends: the motion starts at an earlier turn otherwise.
const LEAST_TURN: f64 = 1e-6;
/// Least gap before a second touch, over the penetration without damping: a smaller gap at the end of the contact is rounding.
const OPEN_GAP: f64 = 1e-6;

impl Motion<'_> {
    /// First point of the force curve that the penetration passes within a step of length `h` from `y`, where it is `penetration` (m): state,
    /// values, and distance from `y`. Moves `pose` to the state. `None` without such a point.
    pub(super) fn corner(
        &self,
        y: &[f64],
        h: f64,
        (penetration, closing): (f64, f64),
        pose: &mut Pose,
    ) -> Option<(Vec<f64>, Instant, f64)> {
        let corners = &self.conditions.corners;
        // Far points are not reached: the speed changes little within a step, and the turning point is within a hundredth of the depth.
        let most = (2.0 * closing.abs() / self.speed * h + NEAR_CORNER) * self.depth;
        if corners.iter().all(|x| (x - penetration).abs() > most) {
            return None;
        }
        let f = |y: &[f64], out: &mut [f64]| self.derivative(y, out);
        let states = |h: f64| state_after(&f, y, h, TIME_STEP_ERROR);
        let reached = self.instant(&states(h), &mut self.start.clone())?;
        let least = CORNER_DISTANCE * self.depth;
        // First point on the way from one penetration to another.
        let passed = |from: f64, to: f64| {
            let sign = (to - from).signum();
            let ahead = |x: &f64| sign * (x - from) > least && sign * (to - x) > 0.0;
            let distance = |x: &f64| (x - from).abs();
            corners.iter().copied().filter(ahead).min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        let mut until = |corner: f64, h: f64| {
            let sign = (corner - penetration).signum();
            self.locate(y, h, &states, &|at| sign * (corner - at.penetration) / self.depth, pose)
        };
        if closing * reached.closing < 0.0 {
            // A motion that turns within the step can pass a point twice: the step ends at its first passage or at the turn.
            let mut turned = self.start.clone();
            let away = closing.signum();
            let (state, turn, part) =
                self.locate(y, h, &states, &|at| away * at.closing / self.speed, &mut turned)?;
            if let Some(corner) = passed(penetration, turn.penetration) {
                return until(corner, part);
            }
            if part > LEAST_TURN * h && passed(turn.penetration, reached.penetration).is_some() {
                *pose = turned;
                return Some((state, turn, part));
            }
        }
        until(passed(penetration, reached.penetration)?, h)
    }

    /// Reversal of the motion within a step of length `h` from `y`, for a force that jumps there; values as for [`corner`](Self::corner).
    pub(super) fn reversal(&self, y: &[f64], h: f64, pose: &mut Pose) -> Option<(Vec<f64>, Instant, f64)> {
        if !self.conditions.jumps_at_reversal {
            return None;
        }
        let f = |y: &[f64], out: &mut [f64]| self.derivative(y, out);
        let states = |h: f64| state_after(&f, y, h, TIME_STEP_ERROR);
        let sign = if self.is_closing.get() { 1.0 } else { -1.0 };
        let reached = self.instant(&states(h), &mut self.start.clone())?.closing;
        if sign * reached >= 0.0 {
            return None;
        }
        self.locate(y, h, &states, &|at| sign * at.closing / self.speed, pose)
    }

    /// True if the sides stay together after a reversal at the state `y`: the force of the new direction does not drive the motion on.
    pub(super) fn sticks(&self, y: &[f64]) -> bool {
        let f = |y: &[f64], out: &mut [f64]| self.derivative(y, out);
        let after = state_after(&f, y, STICKING_STEP * LARGEST_TIME_STEP, TIME_STEP_ERROR);
        let closing = self.instant(&after, &mut self.start.clone()).map(|at| at.closing);
        closing.is_some_and(|closing| if self.is_closing.get() { closing <= 0.0 } else { closing >= 0.0 })
    }

    /// Largest penetration (m) within a step of length `h` from `y`, and m̄ (kg) there.
    pub(super) fn turning_point(
        &self,
        y: &[f64],
        h: f64,
        states: &dyn Fn(f64) -> Vec<f64>,
    ) -> Option<(f64, Option<f64>)> {
        let mut pose = self.start.clone();
        let (_, turn, _) = self.locate(y, h, states, &|at| at.closing / self.speed, &mut pose)?;
        Some((turn.penetration, finite_mass(&pose, self.contact)))
    }

    /// State at which `value` falls to zero within a step of length `h` from `y`, by the Illinois method, with its values and its distance
    /// from `y`. A value that stays zero, such as a force without pull, is not linear there: its first zero is found by bisection. `states`:
    /// state at a distance from `y`. Moves `pose` to the state.
    pub(super) fn locate(
        &self,
        y: &[f64],
        h: f64,
        states: &dyn Fn(f64) -> Vec<f64>,
        value: &dyn Fn(&Instant) -> f64,
        pose: &mut Pose,
    ) -> Option<(Vec<f64>, Instant, f64)> {
        let mut above = value(&self.instant(y, pose)?);
        let mut state = |h: f64| {
            let next = states(h);
            self.instant(&next, pose).map(|at| (next, at, h))
        };
        let (mut low, mut high) = (0.0, h);
        let mut found = state(h)?;
        let mut below = value(&found.1);
        let mut side = 0;
        for _ in 0..END_ITERATIONS {
            if above - below == 0.0 || high - low <= CONTACT_ENDS * h {
                break;
            }
            let has_sign = below < 0.0;
            let part = if has_sign { (above / (above - below)).clamp(0.0, 1.0) } else { 0.5 };
            let middle = low + (high - low) * part;
            found = state(middle)?;
            let v = value(&found.1);
            if has_sign && v.abs() <= CONTACT_ENDS {
                break;
            }
            if v > 0.0 {
                (low, above) = (middle, v);
                below *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (high, below) = (middle, v);
                above *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        Some(found)
    }

    /// Second touch after the end of the contact at the scaled state `y` within the scaled time `within`: the motion goes on without the force of
    /// the contact. `None` also for a mechanism of one freedom without other forces, which moves on.
    pub(super) fn second_touch(&self, y: &[f64], within: f64) -> Option<SecondTouch> {
        let is_single = self.start.degrees_of_freedom() == 1 && self.conditions.other_mass.is_none();
        if is_single && !self.has_other_forces() {
            return None;
        }
        self.is_free.set(true);
        let found = self.free_motion(y, within);
        self.is_free.set(false);
        found
    }

    fn free_motion(&self, y: &[f64], within: f64) -> Option<SecondTouch> {
        let f = |y: &[f64], out: &mut [f64]| self.derivative(y, out);
        let (mut state, mut time, mut is_open) = (y.to_vec(), 0.0, false);
        let mut rate = vec![0.0; y.len()];
        f(&state, &mut rate);
        let mut integrator = self.integrator(rate);
        let mut pose = self.start.clone();
        for _ in 0..MOST_TIME_STEPS {
            let (next, taken) = integrator.advance(&f, &state, &|| false);
            let next = next?;
            let at = self.instant(&next, &mut pose)?;
            is_open |= at.penetration < -OPEN_GAP * self.depth;
            if is_open && at.penetration >= 0.0 && at.closing > 0.0 {
                let states = |h: f64| state_after(&f, &state, h, TIME_STEP_ERROR);
                let gap = |at: &Instant| -at.penetration / self.depth;
                let (_, at, h) = self.locate(&state, taken, &states, &gap, &mut pose)?;
                let after_end = (time + h) * self.depth / self.speed;
                return Some(SecondTouch { after_end, closing_speed: at.closing });
            }
            (state, time) = (next, time + taken);
            if time >= within {
                break;
            }
        }
        None
    }
}
