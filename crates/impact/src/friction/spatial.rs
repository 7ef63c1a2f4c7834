//! Frictional impact of a contact that slides in changing directions: integration over the normal impulse.

use crate::friction::phases::{Collision, Phase, PhaseKind, RestitutionLaw, add_phase};
use crate::friction::rounding::{resolved_rate, sticking_ratio};
use crate::numerics::extrapolation::{controlled_step, step};
use crate::tolerances::{MOST_STEPS, SLIDING_ENDS, STEP_ERROR};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

/// Blocks of the mobility, divided by a_nn: the unit of velocity is the closing speed, that of impulse the closing speed/a_nn.
struct Blocks {
    /// a: change of the tangential velocity per normal impulse.
    coupling: Vector2<f64>,
    /// A: change of the tangential velocity per tangential impulse.
    tangential: Matrix2<f64>,
    /// Coefficient of friction µ.
    friction: f64,
}

impl Blocks {
    /// Change a − µ A ŝ of the sliding velocity per normal impulse while sliding along the unit vector ŝ = `direction`.
    fn sliding_rate(&self, direction: &Vector2<f64>) -> Vector2<f64> {
        self.coupling - self.tangential * direction * self.friction
    }

    /// Change of the normal velocity per normal impulse while sliding along `direction`.
    fn normal_rate(&self, direction: &Vector2<f64>) -> f64 {
        resolved_rate(1.0 - self.friction * self.coupling.dot(direction), 1.0)
    }

    /// True if sliding along `direction` keeps this direction: it is invariant to rounding, and neighbouring directions
    /// approach it. `size`: size of the terms of the rates.
    fn keeps_direction(&self, direction: &Vector2<f64>, size: f64) -> bool {
        let across = Vector2::new(-direction[1], direction[0]);
        let turning = across.dot(&self.sliding_rate(direction));
        // Derivative of the turning by the angle.
        let slope = -direction.dot(&self.sliding_rate(direction))
            - self.friction * (across.transpose() * self.tangential * across)[0];
        turning.abs() <= INVARIANT * size && slope < 0.0
    }

    /// Direction ŝ of the sliding that starts from rest: the direction ŝ with sliding rate λŝ, λ > 0, that is (µA + λ) ŝ = a.
    /// It is unique since |(µA + λ)⁻¹ a| decreases in λ.
    fn direction_from_rest(&self) -> Vector2<f64> {
        let excess = |lambda: f64| {
            let matrix = self.tangential * self.friction + Matrix2::identity() * lambda;
            matrix.try_inverse().map(|inverse| inverse * self.coupling)
        };
        // |a|/(λ + µ a_max) ≤ |ŝ| ≤ |a|/λ: the root is below |a|.
        let (mut low, mut high) = (0.0, self.coupling.norm());
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            match excess(middle) {
                Some(s) if s.norm() <= 1.0 => high = middle,
                _ => low = middle,
            }
            if high - low <= f64::EPSILON * high {
                break;
            }
        }
        excess(high).map_or_else(|| self.coupling.normalize(), |s| s.normalize())
    }
}

/// Turning rate, relative to the size of its terms, of an invariant direction.
const INVARIANT: f64 = 1e-15;

/// State of the impact: totals, and the sums of compressions and expansions.
#[derive(Clone, Copy, Debug)]
struct State {
    normal: f64,
    sliding: Vector2<f64>,
    impulse: Vector3<f64>,
    is_expansion: bool,
    /// Normal impulse and work of compressions and expansions.
    impulses: [f64; 2],
    works: [f64; 2],
}

/// Components of the integrated vector: angle and speed of the sliding, normal impulse, normal velocity, normal work of the
/// stage, and tangential impulse.
const ANGLE: usize = 0;
const SPEED: usize = 1;
const IMPULSE: usize = 2;
const NORMAL: usize = 3;
const WORK: usize = 4;
const TANGENTIAL: usize = 5;

/// Impact by integration.
///
/// While the point slides with s (cos φ, sin φ), the parameter τ with dp = s dτ gives equations without a singularity at
/// s = 0, with r = a_tn − µ A_tt ŝ:
///
/// φ′ = ŝ⊥·r,  s′ = s ŝ·r,  u_n′ = s (a_nn − µ a_tn·ŝ),  w′ = s u_n
///
/// φ approaches an invariant direction and s decreases or grows exponentially. After the sliding has stopped the contact
/// sticks if |A_tt⁻¹ a_tn| ≤ µ, and slides along the invariant direction with (µ A_tt + λ) ŝ = a_tn, λ > 0 otherwise. All later
/// phases are linear. If the normal velocity changes its sign again during expansion, compression and expansion are summed.
/// Sources: Stronge 2000, ch. 4; Batlle 1996.
///
/// `None`: the impact does not end within the largest number of steps.
pub(crate) fn spatial_collision(
    mobility: &Matrix3<f64>,
    before: &Vector3<f64>,
    friction: f64,
    restitution: f64,
    law: RestitutionLaw,
) -> Option<Collision> {
    let (nn, speed) = (mobility[(0, 0)], -before[0]);
    let blocks = Blocks {
        coupling: Vector2::new(mobility[(1, 0)], mobility[(2, 0)]) / nn,
        tangential: mobility.fixed_view::<2, 2>(1, 1) / nn,
        friction,
    };
    let mut state = State {
        normal: -1.0,
        sliding: Vector2::new(before[1], before[2]) / speed,
        impulse: Vector3::zeros(),
        is_expansion: false,
        impulses: [0.0; 2],
        works: [0.0; 2],
    };
    let mut phases = Vec::new();
    let mut ended = false;
    let mut has_slid = false;
    if state.sliding.norm() > SLIDING_ENDS {
        ended = slide(&blocks, &mut state, &mut phases, restitution, law)?;
        has_slid = true;
    }
    let mut is_wedged = false;
    if !ended {
        state.sliding = Vector2::zeros();
        let ratio = sticking_ratio(mobility).filter(|ratio| ratio.norm() <= friction);
        let (kind, ratio, sliding) = match ratio {
            Some(ratio) => (PhaseKind::Stick, ratio, Vector2::zeros()),
            None => {
                let direction = blocks.direction_from_rest();
                let kind = if has_slid { PhaseKind::ReverseSlip } else { PhaseKind::Slip };
                (kind, -direction * friction, direction * direction.dot(&blocks.sliding_rate(&direction)))
            }
        };
        let alpha = resolved_rate(1.0 + blocks.coupling.dot(&ratio), 1.0);
        while !ended {
            if kind == PhaseKind::Stick && alpha <= 0.0 {
                is_wedged = true;
                break;
            }
            let length = linear_end(&state, alpha, restitution, law)?;
            add_phase(&mut phases, kind, state.is_expansion, length);
            let stage = usize::from(state.is_expansion);
            state.works[stage] += length * (state.normal + 0.5 * alpha * length);
            state.impulses[stage] += length;
            state.impulse += Vector3::new(1.0, ratio[0], ratio[1]) * length;
            state.normal += alpha * length;
            state.sliding += sliding * length;
            ended = state.is_expansion;
            if !ended {
                state.normal = 0.0;
                state.is_expansion = true;
            }
        }
    }
    let unit = speed / nn;
    for phase in &mut phases {
        phase.normal_impulse *= unit;
    }
    let impulse = state.impulse * unit;
    let after = Vector3::new(state.normal, state.sliding[0], state.sliding[1]) * speed;
    Some(Collision {
        energy_change: 0.5 * impulse.dot(&(before + after)),
        impulse,
        after,
        phases,
        compression: state.impulses[0] * unit,
        normal_work: state.works.map(|work| work * unit * speed),
        is_wedged,
    })
}

/// Remaining amount until the impact ends: positive before the end.
fn remaining(law: RestitutionLaw, restitution: f64, normal: f64, works: [f64; 2], impulses: [f64; 2]) -> f64 {
    match law {
        RestitutionLaw::Energetic => -restitution * restitution * works[0] - works[1],
        RestitutionLaw::Poisson => restitution * impulses[0] - impulses[1],
        RestitutionLaw::Newton | RestitutionLaw::Algebraic => restitution - normal,
    }
}

/// Normal impulse until the end of the stage in a linear phase with du_n/dp = `alpha`.
fn linear_end(state: &State, alpha: f64, restitution: f64, law: RestitutionLaw) -> Option<f64> {
    if !state.is_expansion {
        return (alpha > 0.0).then(|| -state.normal / alpha);
    }
    let wanted = remaining(law, restitution, state.normal, state.works, state.impulses);
    if wanted <= 0.0 {
        return Some(0.0);
    }
    match law {
        RestitutionLaw::Poisson => Some(wanted),
        RestitutionLaw::Newton | RestitutionLaw::Algebraic => (alpha > 0.0).then(|| wanted / alpha),
        RestitutionLaw::Energetic => {
            let root = state.normal * state.normal + 2.0 * alpha * wanted;
            (root >= 0.0).then(|| 2.0 * wanted / (state.normal + root.sqrt()))
        }
    }
}

/// Slides until the impact ends (true) or the sliding stops (false). `None`: too many steps.
fn slide(
    blocks: &Blocks,
    state: &mut State,
    phases: &mut Vec<Phase>,
    restitution: f64,
    law: RestitutionLaw,
) -> Option<bool> {
    let direction = |y: &[f64]| Vector2::new(y[ANGLE].cos(), y[ANGLE].sin());
    let rates = |y: &[f64], r: &mut [f64]| {
        let along = direction(y);
        let across = Vector2::new(-along[1], along[0]);
        let (turning, s) = (blocks.sliding_rate(&along), y[SPEED]);
        r[ANGLE] = across.dot(&turning);
        r[SPEED] = s * along.dot(&turning);
        r[IMPULSE] = s;
        r[NORMAL] = s * blocks.normal_rate(&along);
        r[WORK] = s * y[NORMAL];
        r[TANGENTIAL] = -blocks.friction * s * along[0];
        r[TANGENTIAL + 1] = -blocks.friction * s * along[1];
    };
    let first = state.sliding;
    let mut y = vec![first[1].atan2(first[0]), first.norm(), 0.0, state.normal, 0.0, 0.0, 0.0];
    // Sums of the stages before the current one.
    let (mut impulse_before, mut stage_impulse, mut stage_work) = (0.0, 0.0, 0.0);
    let size = 1.0 + blocks.coupling.norm() + blocks.friction * blocks.tangential.norm();
    let mut h = 0.1 / size;
    for _ in 0..MOST_STEPS {
        let is_expansion = state.is_expansion;
        let stage = usize::from(is_expansion);
        let totals = |y: &[f64]| {
            let (mut works, mut impulses) = (state.works, state.impulses);
            works[stage] = stage_work + y[WORK];
            impulses[stage] = stage_impulse + y[IMPULSE] - impulse_before;
            (works, impulses)
        };
        // Positive before the event: end of the compression; end of the impact, or of an expansion that turns back.
        let event = |y: &[f64]| {
            if !is_expansion {
                return -y[NORMAL];
            }
            let (works, impulses) = totals(y);
            remaining(law, restitution, y[NORMAL], works, impulses)
        };
        let turns_back = |y: &[f64]| is_expansion && y[NORMAL] < -STEP_ERROR;
        if is_expansion && event(&y) <= 0.0 {
            finish(state, &y, totals(&y));
            return Some(true);
        }
        let along = direction(&y);
        if blocks.keeps_direction(&along, size) {
            finish(state, &y, totals(&y));
            return slide_straight(blocks, state, phases, &along, restitution, law);
        }
        let turning = blocks.sliding_rate(&along).norm();
        let (next, taken, proposal) =
            controlled_step(&rates, &y, h.min(0.5 / (turning + 1e-3 * size)), STEP_ERROR);
        h = proposal;
        let kind = match (is_expansion, blocks.normal_rate(&along) <= 0.0) {
            (false, true) => PhaseKind::Jam,
            _ => PhaseKind::Slip,
        };
        if event(&next) > 0.0 && !turns_back(&next) {
            add_phase(phases, kind, is_expansion, next[IMPULSE] - y[IMPULSE]);
            y = next;
            if y[SPEED] <= SLIDING_ENDS {
                rest(blocks, &mut y);
                finish(state, &y, totals(&y));
                return Some(false);
            }
            continue;
        }
        let crosses = |y: &[f64]| event(y) <= 0.0 || turns_back(y);
        let (mut low, mut high) = (0.0, taken);
        let mut found = next;
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            let (at, _) = step(&rates, &y, middle, STEP_ERROR);
            if crosses(&at) {
                (high, found) = (middle, at);
            } else {
                low = middle;
            }
        }
        add_phase(phases, kind, is_expansion, found[IMPULSE] - y[IMPULSE]);
        y = found;
        let ends = is_expansion && !turns_back(&y);
        let (works, impulses) = totals(&y);
        (state.works, state.impulses) = (works, impulses);
        if ends {
            finish(state, &y, (works, impulses));
            return Some(true);
        }
        y[NORMAL] = 0.0;
        state.is_expansion = !is_expansion;
        let next_stage = usize::from(state.is_expansion);
        (stage_impulse, stage_work) = (impulses[next_stage], works[next_stage]);
        (impulse_before, y[WORK]) = (y[IMPULSE], 0.0);
    }
    None
}

/// Slides along an invariant direction, in linear phases, until the impact ends (true) or the sliding stops (false). `None`:
/// neither happens.
fn slide_straight(
    blocks: &Blocks,
    state: &mut State,
    phases: &mut Vec<Phase>,
    along: &Vector2<f64>,
    restitution: f64,
    law: RestitutionLaw,
) -> Option<bool> {
    let (alpha, rate) = (blocks.normal_rate(along), along.dot(&blocks.sliding_rate(along)));
    let mut speed = state.sliding.norm();
    // Compression, expansion, and one more pair if the expansion turns back before the sliding stops.
    for _ in 0..4 {
        let to_rest = if rate < 0.0 { -speed / rate } else { f64::INFINITY };
        let to_end = linear_end(state, alpha, restitution, law).unwrap_or(f64::INFINITY);
        let to_turn = if state.is_expansion && alpha < 0.0 { -state.normal / alpha } else { f64::INFINITY };
        let length = to_rest.min(to_end).min(to_turn);
        if !length.is_finite() {
            return None;
        }
        let kind = if alpha <= 0.0 && !state.is_expansion { PhaseKind::Jam } else { PhaseKind::Slip };
        add_phase(phases, kind, state.is_expansion, length);
        let stage = usize::from(state.is_expansion);
        state.works[stage] += length * (state.normal + 0.5 * alpha * length);
        state.impulses[stage] += length;
        state.impulse += Vector3::new(1.0, -blocks.friction * along[0], -blocks.friction * along[1]) * length;
        state.normal += alpha * length;
        speed = (speed + rate * length).max(0.0);
        state.sliding = along * speed;
        if to_end <= to_rest.min(to_turn) {
            if state.is_expansion {
                return Some(true);
            }
            (state.normal, state.is_expansion) = (0.0, true);
        } else if to_rest <= to_turn {
            state.sliding = Vector2::zeros();
            return Some(false);
        } else {
            (state.normal, state.is_expansion) = (0.0, false);
        }
    }
    None
}

/// Adds the last part of a sliding motion, linear along the last direction, and sets the sliding speed to zero.
fn rest(blocks: &Blocks, y: &mut [f64]) {
    let along = Vector2::new(y[ANGLE].cos(), y[ANGLE].sin());
    let rate = along.dot(&blocks.sliding_rate(&along));
    if rate < 0.0 {
        let length = -y[SPEED] / rate;
        y[WORK] += length * y[NORMAL];
        y[NORMAL] += length * blocks.normal_rate(&along);
        y[IMPULSE] += length;
        y[TANGENTIAL] -= blocks.friction * length * along[0];
        y[TANGENTIAL + 1] -= blocks.friction * length * along[1];
    }
    y[SPEED] = 0.0;
}

/// Copies the integrated values `y`, the works and the impulses to the state.
fn finish(state: &mut State, y: &[f64], (works, impulses): ([f64; 2], [f64; 2])) {
    state.normal = y[NORMAL];
    state.sliding = Vector2::new(y[ANGLE].cos(), y[ANGLE].sin()) * y[SPEED];
    state.impulse = Vector3::new(y[IMPULSE], y[TANGENTIAL], y[TANGENTIAL + 1]);
    (state.works, state.impulses) = (works, impulses);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With A = diag(1, 2) and a along the first axis, sliding along both signs of this axis does not turn. For small µ the direction of a is
    /// stable, and the opposite one is not.
    #[test]
    fn only_stable_invariant_directions_are_kept() {
        let blocks = |coupling| Blocks {
            coupling: Vector2::new(coupling, 0.0),
            tangential: Matrix2::new(1.0, 0.0, 0.0, 2.0),
            friction: 0.1,
        };
        let keeps =
            |coupling: f64, x: f64, y: f64| blocks(coupling).keeps_direction(&Vector2::new(x, y), 1.0);
        assert!(keeps(0.5, 1.0, 0.0) && !keeps(0.5, -1.0, 0.0));
        assert!(keeps(-0.5, -1.0, 0.0) && !keeps(-0.5, 1.0, 0.0));
        // Directions that turn, towards the stable one and away from the other one.
        assert!(!keeps(0.5, 0.8, 0.6) && !keeps(0.5, -0.8, 0.6));
        // The derivative −a − µ (A₂₂ − A₁₁) of the turning vanishes: no stable direction.
        assert!(!keeps(-0.1, 1.0, 0.0));
    }
}
