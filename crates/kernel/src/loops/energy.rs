//! m̄ of a mechanism of few degrees of freedom from its kinetic energy, for one configuration per lane.
//!
//! ```text
//! A[d] g = −A[i],  (ω, v) of every body at unit rates of the independent coordinates,
//! D = Σ (ω, v)ᵀ I (ω, v) + gᵀ diag(armature) g,  t = n·v of the contact point,  1/m̄ = tᵀ D⁻¹ t
//! ```
//!
//! with d the dependent and i the independent coordinates: GᵀMG from the kinetic energy, without articulated
//! inertias. For few degrees of freedom this is cheaper than a recursion over clusters. A test compares the two.

use super::frames::{direction, direction_of, fill_frames, frame, joint_axis, point, point_of};
use super::layout::{
    FRAME, add_scaled, cross, dot, get, get_vector, minus, plus, put_vector, size, store, times,
};
use super::plan::{LoopBody, LoopMotion, LoopPlan};
use super::rows::{RowRoundings, eliminate, fill_rate_errors, fill_rates, fill_rows, fill_steps};
use crate::columns::{LaneContacts, PositionColumns, WIDEST, quaternion_norm_excess};
use crate::contact::ContactConversion;
use crate::mechanism::{BodyDirection, BodyPoint};
use crate::tolerances::{
    FAR_ROUNDINGS, LINKAGE_FREEDOMS, NO_BOUND, OPEN_ROUNDINGS, QUICK_COORDINATES, QUICK_ERROR,
    ROUTE_ROUNDINGS,
};
use percuss_spatial::lanes::Lanes;

/// Contact in the frames of the plan.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopContact {
    pub on: BodyPoint,
    /// Body on the other side; `None` for the ground.
    pub against: Option<usize>,
    pub normal: LoopNormal,
    /// True for a moment about an axis: the closing speed is the rate of rotation about the normal.
    pub is_moment: bool,
    /// Points and fixed normals of the rows, which replace those of `on` and `normal`.
    pub columns: Option<LaneContacts>,
    /// Of points, and of normals in fixed directions.
    pub conversion: ContactConversion,
}

impl LoopContact {
    /// Points and normals of the rows in the frames of their bodies, if they are given by columns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_rows<T: Lanes>(&self, columns: PositionColumns<'_>, first: usize) -> Option<[[T; 3]; 2]> {
        self.columns.map(|rows| [rows.points(columns, first), rows.normals(columns, first)])
    }
}

/// Unit normal.
#[derive(Clone, Copy, Debug)]
pub(super) enum LoopNormal {
    Along(BodyDirection),
    /// Direction to a point, close to the line as drawn.
    Toward {
        end: BodyPoint,
        /// Unit vector of the line as drawn.
        drawn: BodyDirection,
        /// Smallest accepted length, m.
        shortest: f64,
        /// Smallest accepted cosine of the angle to the line as drawn.
        least_cosine: f64,
    },
}

/// Results of some lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopResponse<T> {
    /// 1/m̄, 1/kg.
    pub response: T,
    /// Error of the response in units of ε, 1/kg.
    pub error: T,
}

/// 1/m̄ of the configurations from `first` on.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn evaluate<T: Lanes>(
    plan: &LoopPlan,
    contact: &LoopContact,
    columns: PositionColumns<'_>,
    first: usize,
    scratch: &mut [f64],
) -> LoopResponse<T> {
    let (mut beyond, far): (T, T) = fill_frames(plan, columns, first, scratch);
    for body in &plan.bodies {
        match body.motion {
            LoopMotion::Ball(q) => beyond += quaternion_norm_excess(columns, q, first),
            LoopMotion::Floating(q) => beyond += quaternion_norm_excess(columns, q + 3, first),
            LoopMotion::Fixed
            | LoopMotion::Turn(_)
            | LoopMotion::Slide(_)
            | LoopMotion::Planar(_)
            | LoopMotion::Base => {}
        }
    }
    let rows: RowRoundings<T> = fill_rows::<T, true>(plan, scratch).roundings;
    let least: T = eliminate(plan, scratch);
    let of_rows = contact.of_rows(columns, first);
    response_after_elimination(plan, (contact, of_rows), (beyond, far), rows, least, scratch)
}

/// 1/m̄ after the elimination of A. First pair: the contact, and the points and normals of the rows. Second pair: excess of the
/// angles beyond their accepted range, and distance of the farthest body (m). `rows`: errors of the entries of A, in roundings.
/// `least`: the largest 1/|pivot|.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn response_after_elimination<T: Lanes>(
    plan: &LoopPlan,
    contact: (&LoopContact, Option<[[T; 3]; 2]>),
    (beyond, far): (T, T),
    rows: RowRoundings<T>,
    least: T,
    scratch: &mut [f64],
) -> LoopResponse<T> {
    fill_rates::<T>(plan, scratch);
    fill_twists::<T>(plan, scratch);
    // Frames fixed to the root link are rounded at their distance from its origin.
    let far = far + T::from_f64(plan.centre.norm() / 2.0);
    let distant = far * T::from_f64(1.0 / plan.length);
    let other = rows.rods + distant.mul_add(T::from_f64(FAR_ROUNDINGS), T::from_f64(plan.roundings));
    // For many coordinates, 1/(smallest pivot) is no estimate of the norm of the inverse: only the refined bound is used.
    let is_large = plan.columns > QUICK_COORDINATES;
    let least = if is_large { least.max(T::from_f64(NO_BOUND)) } else { least };
    // Error of the positions: the residual of the loops divided by the pivots, and at least the residual itself.
    let open = rows.open * (least * T::from_f64(plan.scale)).max(T::one());
    let mut answer: LoopResponse<T> = solve_response(plan, contact, (other + open, least), false, scratch);
    let mut quick = [0.0; WIDEST];
    answer.error.store(&mut quick);
    // The quick bound is enough for most configurations. Lanes for which it is enough keep it, so that their results do not depend on
    // the other lanes.
    let mut excess = [0.0; WIDEST];
    let accepted = answer.response * T::from_f64(QUICK_ERROR / f64::EPSILON);
    (answer.error - accepted).store(&mut excess);
    let is_clear = excess.map(|excess| excess <= 0.0);
    // Without dependent coordinates both bounds are the same.
    if plan.layout.count > 0 && is_clear[..T::WIDTH].contains(&false) {
        fill_rate_errors(plan, least, scratch);
        // The Newton step δ would close the loops. The change of an entry is estimated by ‖δ‖ or the
        // largest |δ| for all coordinates up to both ends of a closure, whichever is smaller.
        let per_metre = T::from_f64(OPEN_ROUNDINGS / (f64::EPSILON * plan.length));
        let step: T = fill_steps(plan, scratch);
        let mut largest = T::zero();
        for k in 0..plan.layout.count {
            largest = largest.max(get::<T>(scratch, plan.layout.steps + k).abs());
        }
        let step = smaller(largest * T::from_f64(2.0 * plan.chain), step);
        let open = smaller(step.mul_add(per_metre, rows.open), open);
        let refined: LoopResponse<T> = solve_response(plan, contact, (other + open, least), true, scratch);
        let mut errors = [0.0; WIDEST];
        refined.error.store(&mut errors);
        for lane in (0..T::WIDTH).filter(|lane| is_clear[*lane]) {
            errors[lane] = quick[lane];
        }
        answer.error = T::load(&errors);
    }
    // `least` exceeds NO_BOUND if a pivot vanishes, or if a redundant row is not redundant here: no result is certified.
    let beyond = beyond + (least - T::from_f64(NO_BOUND)).max(T::zero());
    answer.error = beyond.mul_add(T::from_f64(f64::MAX), answer.error);
    answer
}

/// Twists of the bodies at their origins, root axes.
#[cfg_attr(not(debug_assertions), inline(always))]
fn fill_twists<T: Lanes>(plan: &LoopPlan, scratch: &mut [f64]) {
    let f = plan.freedoms;
    for (i, body) in plan.bodies.iter().enumerate() {
        let (turn, origin) = frame::<T>(scratch, i);
        let arm = body.parent.map(|parent| minus(&origin, &get_vector(scratch, FRAME * parent + 9)));
        let mut y = 0;
        while y < f {
            let to = plan.layout.twists + 6 * (i * f + y);
            let (mut angular, mut linear) = ([T::zero(); 3], [T::zero(); 3]);
            if let (Some(parent), Some(arm)) = (body.parent, &arm)
                && plan.bodies[parent].moved_by[y]
            {
                let from = plan.layout.twists + 6 * (parent * f + y);
                angular = get_vector(scratch, from);
                linear = plus(&get_vector(scratch, from + 3), &cross(&angular, arm));
            }
            for (k, velocity) in body.velocities.iter().enumerate() {
                if !plan.depends_on[velocity.column * f + y] {
                    continue;
                }
                let rate: T = get(scratch, plan.layout.rates + velocity.column * f + y);
                let rate = rate * T::from_f64(velocity.factor);
                match body.motion {
                    LoopMotion::Fixed => {}
                    LoopMotion::Planar(_) if k < 2 => {
                        linear = add_scaled(&joint_axis(&plan.bodies, i, k, scratch), rate, &linear)
                    }
                    LoopMotion::Turn(_) | LoopMotion::Planar(_) => {
                        angular = add_scaled(&[turn[0][2], turn[1][2], turn[2][2]], rate, &angular)
                    }
                    LoopMotion::Slide(_) => {
                        linear = add_scaled(&[turn[0][2], turn[1][2], turn[2][2]], rate, &linear)
                    }
                    LoopMotion::Floating(_) if k >= 3 => {
                        let axis = [turn[0][k - 3], turn[1][k - 3], turn[2][k - 3]];
                        linear = add_scaled(&axis, rate, &linear)
                    }
                    LoopMotion::Ball(_) | LoopMotion::Floating(_) => {
                        angular = add_scaled(&[turn[0][k], turn[1][k], turn[2][k]], rate, &angular)
                    }
                    // The axes of the floating base are the root axes.
                    LoopMotion::Base if k < 3 => angular[k] += rate,
                    LoopMotion::Base => linear[k - 3] += rate,
                }
            }
            put_vector(scratch, to, angular);
            put_vector(scratch, to + 3, linear);
            y += 1;
        }
    }
}

/// tᵀ D⁻¹ t from D and t, with its error. `entries`: errors of the entries of A and of the frames, in units of ε; `least`: the largest
/// 1/|pivot|, or [`NO_BOUND`] for many coordinates. The errors δg of the rates affect the speed of the contact point and the energy even of
/// bodies nearly at rest:
///
/// ```text
/// δt = (Σ |lever| δg on the chain of the contact link + (roundings + entries) · |terms of t|) ε
/// δd = (2 √d Σ √weight δg + roundings · |terms of d|) ε + (Σ √weight δg ε)²
/// δ(1/m̄) = Σ (2 |t/d| δt + (t/d)² δd)
/// ```
///
/// by the triangle inequality of √energy. The quick bound takes Σ |g| · least for every sum over δg; `refined`: the smaller of both.
#[cfg_attr(not(debug_assertions), inline(always))]
fn solve_response<T: Lanes>(
    plan: &LoopPlan,
    (contact, of_rows): (&LoopContact, Option<[[T; 3]; 2]>),
    (entries, least): (T, T),
    refined: bool,
    scratch: &mut [f64],
) -> LoopResponse<T> {
    const MOST: usize = LINKAGE_FREEDOMS;
    let f = plan.freedoms;
    let mut sizes = [T::zero(); MOST];
    let energy_entries = plan.layout.energy..plan.layout.energy_entry(f, 0);
    scratch[energy_entries.start * T::WIDTH..energy_entries.end * T::WIDTH].fill(0.0);
    for (i, body) in plan.bodies.iter().enumerate() {
        add_energy(plan, i, body, scratch, &mut sizes);
    }
    let (mut t, mut tests) = ([T::zero(); MOST], [T::zero(); MOST]);
    let at: [T; 3] = match of_rows {
        Some([at, _]) => point_of(scratch, contact.on.body, at),
        None => point(scratch, &contact.on),
    };
    let (mut turned, mut refused) = (T::one(), T::zero());
    let normal = match &contact.normal {
        LoopNormal::Along(heading) => match of_rows {
            Some([_, normal]) => direction_of(scratch, heading.body, normal),
            None => direction(scratch, heading),
        },
        LoopNormal::Toward { end, drawn, shortest, least_cosine } => {
            let end = point(scratch, end);
            let line = minus(&end, &at);
            let over = T::one() / dot(&line, &line).sqrt();
            // The line rotates by the errors of its ends.
            turned = (size(&end) + size(&at)).mul_add(over, turned);
            let unit = times(&line, over);
            let cosine = dot(&unit, &direction(scratch, drawn));
            // A refused line is left to the evaluation of a pose, which reports the reason.
            let short = T::from_f64(*shortest) - dot(&line, &unit);
            let aside = T::from_f64(*least_cosine) - cosine;
            refused = short.max(T::zero()) + aside.max(T::zero());
            unit
        }
    };
    let mut y = 0;
    while y < f {
        if let Some(body) = contact.on.body {
            let (speed, test) = speed::<T>(plan, (body, contact.is_moment), y, &at, &normal, scratch);
            (t[y], tests[y]) = (t[y] + speed, tests[y] + test);
        }
        if let Some(body) = contact.against {
            let (speed, test) = speed::<T>(plan, (body, contact.is_moment), y, &at, &normal, scratch);
            (t[y], tests[y]) = (t[y] - speed, tests[y] + test);
        }
        y += 1;
    }
    let reach_of = |body: Option<usize>| body.map_or(0.0, |b| plan.bodies[b].reach);
    let reach = reach_of(contact.on.body) + reach_of(contact.against);
    let arm = size(&at) + T::from_f64(reach);
    let per_length = T::from_f64(1.0 / plan.length);
    let arms = if contact.is_moment { per_length } else { arm.mul_add(per_length, T::one()) };
    // The errors of the entries are also errors of the frames.
    let roundings = entries + T::from_f64(ROUTE_ROUNDINGS);
    let entry_error = entries * T::from_f64(plan.scale);
    let mut k = 0;
    while k < f {
        let most = rate_sum::<T>(plan, k, scratch) * least;
        let (mut speeds, mut energy) = (most * arms, most * T::from_f64(plan.weight.sqrt()));
        if refined {
            let on = speed_error::<T>(plan, (contact.on.body, contact.is_moment), k, &at, scratch);
            let against = speed_error::<T>(plan, (contact.against, contact.is_moment), k, &at, scratch);
            speeds = smaller(on + against, speeds);
            energy = smaller(energy_error::<T>(plan, k, scratch), energy);
        }
        tests[k] = turned * entry_error.mul_add(speeds, tests[k] * roundings);
        let off = entry_error * energy;
        let cross = off * get::<T>(scratch, plan.layout.energy_entry(k, k)).abs().sqrt();
        let second = off * off * T::from_f64(f64::EPSILON);
        sizes[k] = sizes[k].mul_add(T::from_f64(ROUTE_ROUNDINGS), cross + cross + second);
        k += 1;
    }
    let mut answer = LoopResponse { response: T::zero(), error: T::zero() };
    k = 0;
    while k < f {
        let over = T::one() / get::<T>(scratch, plan.layout.energy_entry(k, k));
        let rate = t[k] * over;
        let part = rate.abs();
        answer.response = t[k].mul_add(rate, answer.response);
        answer.error = part.mul_add(part.mul_add(sizes[k], tests[k] + tests[k]), answer.error);
        let mut j = k + 1;
        while j < f {
            let factor = -(get::<T>(scratch, plan.layout.energy_entry(j, k)) * over);
            let mut c = k + 1;
            while c <= j {
                let pivot_column = get::<T>(scratch, plan.layout.energy_entry(c, k));
                let entry = plan.layout.energy_entry(j, c);
                store(scratch, entry, pivot_column.mul_add(factor, get(scratch, entry)));
                c += 1;
            }
            t[j] = t[k].mul_add(factor, t[j]);
            tests[j] = tests[k].mul_add(factor.abs(), tests[j]);
            sizes[j] = sizes[k].mul_add(factor * factor, sizes[j]);
            j += 1;
        }
        k += 1;
    }
    answer.error = refused.mul_add(T::from_f64(f64::MAX), answer.error);
    answer
}

/// Sum of the absolute rates of all coordinates at a unit rate of one independent coordinate.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rate_sum<T: Lanes>(plan: &LoopPlan, y: usize, scratch: &[f64]) -> T {
    let mut sum = T::one();
    let mut k = 0;
    while k < plan.layout.count {
        sum += get::<T>(scratch, plan.layout.rates + k * plan.freedoms + y).abs();
        k += 1;
    }
    sum
}

/// Bound of √energy of the errors of all rates at a unit rate of one independent coordinate, per error of an entry (√kg/m).
#[cfg_attr(not(debug_assertions), inline(always))]
fn energy_error<T: Lanes>(plan: &LoopPlan, y: usize, scratch: &[f64]) -> T {
    let mut sum = T::zero();
    for k in 0..plan.layout.count {
        let error: T = get(scratch, plan.layout.rate_errors + k * plan.freedoms + y);
        sum = error.mul_add(T::from_f64(plan.root_weights[k]), sum);
    }
    sum
}

/// The smaller of two values.
#[cfg_attr(not(debug_assertions), inline(always))]
fn smaller<T: Lanes>(a: T, b: T) -> T {
    -(-a).max(-b)
}

/// Bound of the error of the speed of a body's point `at`, or for a moment of the body's rate of rotation, from the errors of the rates, per
/// error of an entry.
#[cfg_attr(not(debug_assertions), inline(always))]
fn speed_error<T: Lanes>(
    plan: &LoopPlan,
    (body, is_moment): (Option<usize>, bool),
    y: usize,
    at: &[T; 3],
    scratch: &[f64],
) -> T {
    let (mut sum, mut next) = (T::zero(), body);
    while let Some(index) = next {
        let body = &plan.bodies[index];
        let arm = size(&minus(at, &get_vector(scratch, FRAME * index + 9)));
        for (k, velocity) in body.velocities.iter().enumerate() {
            let error: T = get(scratch, plan.layout.rate_errors + velocity.column * plan.freedoms + y);
            let factor = T::from_f64(velocity.factor.abs());
            let lever = match (body.motion.translates(k), is_moment) {
                (true, true) => continue,
                (true, false) | (false, true) => factor,
                (false, false) => arm * factor,
            };
            sum = error.mul_add(lever, sum);
        }
        next = body.parent;
    }
    sum
}

/// Closing speed of a body's point, or for a moment the body's rate of rotation about the normal, and the size of its terms.
#[cfg_attr(not(debug_assertions), inline(always))]
fn speed<T: Lanes>(
    plan: &LoopPlan,
    (body, is_moment): (usize, bool),
    y: usize,
    at: &[T; 3],
    normal: &[T; 3],
    scratch: &[f64],
) -> (T, T) {
    if !plan.bodies[body].moved_by[y] {
        return (T::zero(), T::zero());
    }
    let from = plan.layout.twists + 6 * (body * plan.freedoms + y);
    let (angular, linear): ([T; 3], [T; 3]) = (get_vector(scratch, from), get_vector(scratch, from + 3));
    if is_moment {
        return (dot(normal, &angular), size(&angular));
    }
    let arm = minus(at, &get_vector(scratch, FRAME * body + 9));
    let velocity = plus(&linear, &cross(&angular, &arm));
    (dot(normal, &velocity), size(&angular).mul_add(size(&arm), size(&linear)))
}

/// Adds a body's part of D, on and below the diagonal, and the sizes of the terms of the diagonal.
#[cfg_attr(not(debug_assertions), inline(always))]
fn add_energy<T: Lanes>(
    plan: &LoopPlan,
    i: usize,
    body: &LoopBody,
    scratch: &mut [f64],
    sizes: &mut [T; LINKAGE_FREEDOMS],
) {
    let f = plan.freedoms;
    for velocity in &body.velocities {
        if velocity.armature == 0.0 {
            continue;
        }
        let armature = T::from_f64(velocity.armature * velocity.factor * velocity.factor);
        let mut y = 0;
        while y < f {
            let own = get::<T>(scratch, plan.layout.rates + velocity.column * f + y) * armature;
            let mut z = 0;
            while z <= y {
                let rate = get(scratch, plan.layout.rates + velocity.column * f + z);
                let entry = plan.layout.energy_entry(y, z);
                store(scratch, entry, own.mul_add(rate, get(scratch, entry)));
                z += 1;
            }
            sizes[y] = own.mul_add(get(scratch, plan.layout.rates + velocity.column * f + y), sizes[y]);
            y += 1;
        }
    }
    let Some(inertia) = &body.inertia else { return };
    let of = T::from_f64;
    let mass = of(inertia[0]);
    let c = [of(inertia[1]), of(inertia[2]), of(inertia[3])];
    let rows = [
        [of(inertia[4]), of(inertia[5]), of(inertia[6])],
        [of(inertia[5]), of(inertia[7]), of(inertia[8])],
        [of(inertia[6]), of(inertia[8]), of(inertia[9])],
    ];
    let (turn, _) = frame::<T>(scratch, i);
    let mut y = 0;
    while y < f {
        if body.moved_by[y] {
            let from = plan.layout.twists + 6 * (i * f + y);
            let angular = back(&turn, &get_vector(scratch, from));
            let linear = back(&turn, &get_vector(scratch, from + 3));
            put_vector(scratch, plan.layout.known + 6 * y, angular);
            put_vector(scratch, plan.layout.known + 6 * y + 3, linear);
            let about_origin = of(inertia[4] + inertia[7] + inertia[9]) * dot(&angular, &angular);
            sizes[y] += mass.mul_add(dot(&linear, &linear), about_origin);
            let momentum = plus(&times(&linear, mass), &cross(&angular, &c));
            let about = plus(
                &[dot(&rows[0], &angular), dot(&rows[1], &angular), dot(&rows[2], &angular)],
                &cross(&c, &linear),
            );
            let mut z = 0;
            while z <= y {
                if body.moved_by[z] {
                    let known = plan.layout.known + 6 * z;
                    let energy = dot(&get_vector(scratch, known), &about)
                        + dot(&get_vector(scratch, known + 3), &momentum);
                    let entry = plan.layout.energy_entry(y, z);
                    store(scratch, entry, get::<T>(scratch, entry) + energy);
                }
                z += 1;
            }
        }
        y += 1;
    }
}

/// Rᵀ x.
#[cfg_attr(not(debug_assertions), inline(always))]
fn back<T: Lanes>(turn: &[[T; 3]; 3], x: &[T; 3]) -> [T; 3] {
    add_scaled(&turn[2], x[2], &add_scaled(&turn[1], x[1], &times(&turn[0], x[0])))
}
