//! m̄ of a mechanism of few freedoms by its velocities, for as many configurations as there are lanes.
//!
//! ```text
//! A[d] g = −A[i],  (ω, v) of every body at unit rates of what is independent,  D = Σ (ω, v)ᵀ I (ω, v) + gᵀ diag(armature) g,
//! t = n·v of the struck point,  1/m̄ = tᵀ D⁻¹ t
//! ```
//!
//! with d the coordinates that depend and i those that do not: GᵀMG by the kinetic energy, no articulated inertia. It is what
//! [`crate::recursion`] finds cluster by cluster; for few freedoms the energy is the shorter way. A test compares the two.

use super::plan::{Block, BodyDirection, BodyPoint, Form, Motion, Moving, Plan, Position, Term};
use super::room::{FRAME, along, cross, dot, get, get_vector, minus, plus, put, put_vector, size, times};
use crate::clear_mass::Columns;
use crate::tolerances::{FAR_ROUNDINGS, LINKAGE_FREEDOMS, OPEN_ROUNDINGS, ROUTE_ROUNDINGS};
use percuss_spatial::lanes::{LARGEST_ANGLE, Lanes, Portable};
use percuss_spatial::splat;

/// The contact, in the frames of the plan.
#[derive(Clone, Copy, Debug)]
pub(super) struct Struck {
    pub on: BodyPoint,
    /// The body on the other side; none: the ground.
    pub against: Option<usize>,
    pub normal: Normal,
}

/// The unit normal.
#[derive(Clone, Copy, Debug)]
pub(super) enum Normal {
    Along(BodyDirection),
    /// Toward a point.
    Toward(BodyPoint),
}

/// The answers of some lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer<T> {
    /// 1/m̄, 1/kg.
    pub response: T,
    /// By how many ε it may be off, 1/kg.
    pub error: T,
}

/// 1/m̄ of configurations `first` and those after it.
#[inline(always)]
pub(super) fn evaluate<T: Lanes>(
    plan: &Plan,
    struck: &Struck,
    columns: Columns<'_>,
    first: usize,
    room: &mut [f64],
) -> Answer<T> {
    let (beyond, far): (T, T) = place(plan, columns, first, room);
    let rows: T = fill_rows(plan, room);
    let least: T = eliminate(plan, room);
    fill_rates::<T>(plan, room);
    fill_twists::<T>(plan, room);
    // By how many ε of all rates each rate is off: the roundings of the entries of A, over its pivots.
    let distant = far * T::from_f64(1.0 / plan.length);
    let entries = rows + distant.mul_add(T::from_f64(FAR_ROUNDINGS), T::from_f64(plan.roundings));
    let mut answer: Answer<T> = respond(plan, struck, entries * least * T::from_f64(plan.scale), room);
    answer.error = beyond.mul_add(T::from_f64(f64::MAX), answer.error);
    answer
}

/// A at some positions, before its rows have an order.
pub(super) fn rows_at(plan: &Plan, positions: &[f64]) -> Vec<f64> {
    let mut room = vec![0.0; plan.layout.total];
    place::<Portable<1>>(plan, Columns { values: positions, stride: 1 }, 0, &mut room);
    fill_rows::<Portable<1>>(plan, &mut room);
    room[plan.layout.rows..plan.layout.over].to_vec()
}

/// Frames of the bodies; how far angles are beyond what they may be, and how far the farthest place is from the centre.
#[inline(always)]
fn place<T: Lanes>(plan: &Plan, columns: Columns<'_>, first: usize, room: &mut [f64]) -> (T, T) {
    let (mut beyond, mut far) = (T::zero(), T::zero());
    for (i, body) in plan.bodies.iter().enumerate() {
        let fixed = [splat(&body.rotation[0]), splat(&body.rotation[1]), splat(&body.rotation[2])];
        let mut shift: [T; 3] = splat(&body.translation);
        let mut turn: [[T; 3]; 3] = fixed;
        if let Some(parent) = body.parent {
            let (carrier, origin) = frame::<T>(room, parent);
            shift = plus(
                &origin,
                &[dot(&carrier[0], &shift), dot(&carrier[1], &shift), dot(&carrier[2], &shift)],
            );
            turn = product(&carrier, &fixed);
        }
        match body.motion {
            Motion::Fixed | Motion::Free => {}
            Motion::Turn(position) => {
                let angle: T = position.at(columns, first);
                let over = angle.abs() - T::from_f64(LARGEST_ANGLE);
                beyond += over + over.abs();
                let (s, c) = angle.sin_cos();
                let mut r = 0;
                while r < 3 {
                    let [x, y, z] = turn[r];
                    turn[r] = [c.mul_add(x, s * y), c.mul_add(y, -(s * x)), z];
                    r += 1;
                }
            }
            Motion::Slide(position) => {
                let travel: T = position.at(columns, first);
                shift = along(&[turn[0][2], turn[1][2], turn[2][2]], travel, &shift);
            }
            Motion::Ball(q) => turn = product(&turn, &of_quaternion(columns, q, first)),
        }
        put_vector(room, FRAME * i, turn[0]);
        put_vector(room, FRAME * i + 3, turn[1]);
        put_vector(room, FRAME * i + 6, turn[2]);
        put_vector(room, FRAME * i + 9, shift);
        far = far.max(size(&shift));
    }
    (beyond, far)
}

impl Position {
    #[inline(always)]
    fn at<T: Lanes>(&self, columns: Columns<'_>, first: usize) -> T {
        columns.at::<T>(self.q, first).mul_add(T::from_f64(self.multiplier), T::from_f64(self.offset))
    }
}

#[inline(always)]
fn product<T: Lanes>(a: &[[T; 3]; 3], b: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let mut all = *a;
    let mut r = 0;
    while r < 3 {
        let row = &a[r];
        let mut sum = times(&b[0], row[0]);
        sum = along(&b[1], row[1], &sum);
        all[r] = along(&b[2], row[2], &sum);
        r += 1;
    }
    all
}

#[inline(always)]
fn of_quaternion<T: Lanes>(columns: Columns<'_>, q: usize, first: usize) -> [[T; 3]; 3] {
    let w: T = columns.at(q, first);
    let x: T = columns.at(q + 1, first);
    let y: T = columns.at(q + 2, first);
    let z: T = columns.at(q + 3, first);
    let one = T::one();
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (xx, yy, zz) = (x * x2, y * y2, z * z2);
    let (xy, xz, yz) = (x * y2, x * z2, y * z2);
    let (wx, wy, wz) = (w * x2, w * y2, w * z2);
    [
        [one - (yy + zz), xy - wz, xz + wy],
        [xy + wz, one - (xx + zz), yz - wx],
        [xz - wy, yz + wx, one - (xx + yy)],
    ]
}

/// A body's rotation, row by row, and its place.
#[inline(always)]
fn frame<T: Lanes>(room: &[f64], body: usize) -> ([[T; 3]; 3], [T; 3]) {
    let at = FRAME * body;
    let turn = [get_vector(room, at), get_vector(room, at + 3), get_vector(room, at + 6)];
    (turn, get_vector(room, at + 9))
}

/// A column of a body's rotation: an axis of it.
#[inline(always)]
fn axis<T: Lanes>(room: &[f64], body: usize, k: usize) -> [T; 3] {
    let at = FRAME * body + k;
    [get(room, at), get(room, at + 3), get(room, at + 6)]
}

#[inline(always)]
fn direction<T: Lanes>(room: &[f64], heading: &BodyDirection) -> [T; 3] {
    let own: [T; 3] = splat(&heading.e);
    match heading.body {
        Some(body) => {
            let (turn, _) = frame::<T>(room, body);
            [dot(&turn[0], &own), dot(&turn[1], &own), dot(&turn[2], &own)]
        }
        None => own,
    }
}

#[inline(always)]
fn point<T: Lanes>(room: &[f64], place: &BodyPoint) -> [T; 3] {
    let own: [T; 3] = splat(&place.at);
    match place.body {
        Some(body) => {
            let (turn, origin) = frame::<T>(room, body);
            plus(&origin, &[dot(&turn[0], &own), dot(&turn[1], &own), dot(&turn[2], &own)])
        }
        None => own,
    }
}

/// A. Gives by how many roundings its entries are off because the loops are open, or their rods are short.
#[inline(always)]
fn fill_rows<T: Lanes>(plan: &Plan, room: &mut [f64]) -> T {
    let (from, to) = (plan.layout.rows * T::WIDTH, plan.layout.over * T::WIDTH);
    room[from..to].fill(0.0);
    let (mut open, mut rods) = (T::zero(), T::zero());
    let still = [T::zero(); 3];
    for block in &plan.blocks {
        let at: [T; 3] = point(room, &block.successor);
        let apart = match &block.predecessor {
            Some(place) => minus(&at, &point(room, place)),
            None => still,
        };
        for (form, rows) in &block.forms {
            match form {
                Form::Point => {
                    open = open.max(size(&apart));
                    add_point(plan, block, rows, &at, room);
                }
                Form::Along(e) => {
                    let force = direction(room, e);
                    open = open.max(dot(&apart, &force).abs());
                    add_row(plan, block, rows[0], &still, &force, &at, room);
                }
                Form::Cosine(e, b, length) => {
                    let (e, b): ([T; 3], [T; 3]) = (direction(room, e), direction(room, b));
                    let length = T::from_f64(*length);
                    open = open.max((dot(&b, &e) * length).abs());
                    add_row(plan, block, rows[0], &times(&cross(&b, &e), length), &still, &at, room);
                }
                Form::Distance(distance) => {
                    let square: T = dot(&apart, &apart);
                    let length = square.sqrt();
                    open = open.max((length - T::from_f64(*distance)).abs());
                    let over = T::one() / length;
                    rods = rods.max((size(&at) + size(&apart)) * over);
                    add_row(plan, block, rows[0], &still, &times(&apart, over), &at, room);
                }
                Form::Constant => {
                    let Some(row) = rows[0] else { continue };
                    for term in &block.terms {
                        let to = plan.layout.rows + row * plan.columns + term.column;
                        put(room, to, get::<T>(room, to) + T::from_f64(term.factor));
                    }
                }
            }
        }
    }
    let open = open * T::from_f64(OPEN_ROUNDINGS / (f64::EPSILON * plan.length));
    rods.mul_add(T::from_f64(FAR_ROUNDINGS), open)
}

/// The axis of a term, root axes, and how far the acting point is from its body's origin.
#[inline(always)]
fn lever<T: Lanes>(term: &Term, bodies: &[Moving], at: &[T; 3], room: &[f64]) -> ([T; 3], [T; 3]) {
    let k = match bodies[term.body].motion {
        Motion::Ball(_) => term.component,
        Motion::Free => term.component % 3,
        Motion::Fixed | Motion::Turn(_) | Motion::Slide(_) => 2,
    };
    let place: [T; 3] = get_vector(room, FRAME * term.body + 9);
    (axis(room, term.body, k), minus(at, &place))
}

/// Three rows: the velocity of a point.
#[inline(always)]
fn add_point<T: Lanes>(plan: &Plan, block: &Block, rows: &[Option<usize>; 3], at: &[T; 3], room: &mut [f64]) {
    for term in &block.terms {
        let (a, arm) = lever(term, &plan.bodies, at, room);
        let velocity = if term.slides { a } else { cross(&a, &arm) };
        let mut k = 0;
        while k < 3 {
            if let Some(row) = rows[k] {
                let to = plan.layout.rows + row * plan.columns + term.column;
                put(room, to, velocity[k].mul_add(T::from_f64(term.factor), get(room, to)));
            }
            k += 1;
        }
    }
}

/// One row: the power of a wrench about the acting point.
#[inline(always)]
fn add_row<T: Lanes>(
    plan: &Plan,
    block: &Block,
    row: Option<usize>,
    moment: &[T; 3],
    force: &[T; 3],
    at: &[T; 3],
    room: &mut [f64],
) {
    let Some(row) = row else { return };
    for term in &block.terms {
        let (a, arm) = lever(term, &plan.bodies, at, room);
        let power = if term.slides { dot(&a, force) } else { dot(&a, &plus(moment, &cross(&arm, force))) };
        let to = plan.layout.rows + row * plan.columns + term.column;
        put(room, to, power.mul_add(T::from_f64(term.factor), get(room, to)));
    }
}

/// Eliminates what depends, in the order of the plan. Gives the largest 1/|pivot|.
#[inline(always)]
fn eliminate<T: Lanes>(plan: &Plan, room: &mut [f64]) -> T {
    let (n, rows) = (plan.columns, plan.layout.rows);
    let mut least = T::zero();
    for (k, pivot) in plan.pivots.iter().enumerate() {
        let over = T::one() / get::<T>(room, rows + k * n + k);
        least = least.max(over.abs());
        put(room, plan.layout.over + k, over);
        for &r in &pivot.rows {
            let factor = -(get::<T>(room, rows + r * n + k) * over);
            for &c in &pivot.columns {
                let to = rows + r * n + c;
                put(room, to, get::<T>(room, rows + k * n + c).mul_add(factor, get(room, to)));
            }
        }
    }
    least
}

/// Rates of all coordinates at unit rates of what is independent.
#[inline(always)]
fn fill_rates<T: Lanes>(plan: &Plan, room: &mut [f64]) {
    let (n, f, rank, rates) = (plan.columns, plan.freedoms, plan.layout.count, plan.layout.rates);
    let mut y = 0;
    while y < f {
        let mut free = 0;
        while free < f {
            let unit = if free == y { T::one() } else { T::zero() };
            put(room, rates + (rank + free) * f + y, unit);
            free += 1;
        }
        let mut k = rank;
        while k > 0 {
            k -= 1;
            if !plan.follows[k * f + y] {
                put(room, rates + k * f + y, T::zero());
                continue;
            }
            let mut sum = T::zero();
            for &c in &plan.pivots[k].columns {
                if plan.follows[c * f + y] {
                    let entry: T = get(room, plan.layout.rows + k * n + c);
                    sum = entry.mul_add(get(room, rates + c * f + y), sum);
                }
            }
            put(room, rates + k * f + y, -(sum * get::<T>(room, plan.layout.over + k)));
        }
        y += 1;
    }
}

/// Twists of the bodies at their origins, root axes.
#[inline(always)]
fn fill_twists<T: Lanes>(plan: &Plan, room: &mut [f64]) {
    let f = plan.freedoms;
    for (i, body) in plan.bodies.iter().enumerate() {
        let (turn, origin) = frame::<T>(room, i);
        let arm = body.parent.map(|parent| minus(&origin, &get_vector(room, FRAME * parent + 9)));
        let mut y = 0;
        while y < f {
            let to = plan.layout.twists + 6 * (i * f + y);
            let (mut angular, mut linear) = ([T::zero(); 3], [T::zero(); 3]);
            if let (Some(parent), Some(arm)) = (body.parent, &arm)
                && plan.bodies[parent].moved[y]
            {
                let from = plan.layout.twists + 6 * (parent * f + y);
                angular = get_vector(room, from);
                linear = plus(&get_vector(room, from + 3), &cross(&angular, arm));
            }
            for (k, velocity) in body.velocities.iter().enumerate() {
                if !plan.follows[velocity.column * f + y] {
                    continue;
                }
                let rate: T = get(room, plan.layout.rates + velocity.column * f + y);
                let rate = rate * T::from_f64(velocity.factor);
                match body.motion {
                    Motion::Fixed => {}
                    Motion::Turn(_) => angular = along(&[turn[0][2], turn[1][2], turn[2][2]], rate, &angular),
                    Motion::Slide(_) => linear = along(&[turn[0][2], turn[1][2], turn[2][2]], rate, &linear),
                    Motion::Ball(_) => angular = along(&[turn[0][k], turn[1][k], turn[2][k]], rate, &angular),
                    // Its axes are the root's.
                    Motion::Free if k < 3 => angular[k] += rate,
                    Motion::Free => linear[k - 3] += rate,
                }
            }
            put_vector(room, to, angular);
            put_vector(room, to + 3, linear);
            y += 1;
        }
    }
}

/// D and t, and tᵀ D⁻¹ t, and how far that may be off. Rates are off by `lost` ε of all of them, and with them the speed of
/// the struck point and the energy of bodies that hardly move:
///
/// ```text
/// δt = (lost · all · (1 + arm/length) + roundings · |terms of t|) ε
/// δd = (2 lost · all · √(weight · d) + roundings · |terms of d|) ε + (lost · all · ε)² weight
/// δ(1/m̄) = Σ (2 |t/d| δt + (t/d)² δd)
/// ```
#[inline(always)]
fn respond<T: Lanes>(plan: &Plan, struck: &Struck, lost: T, room: &[f64]) -> Answer<T> {
    const MOST: usize = LINKAGE_FREEDOMS;
    let f = plan.freedoms;
    let (mut d, mut sizes) = ([[T::zero(); MOST]; MOST], [T::zero(); MOST]);
    for (i, body) in plan.bodies.iter().enumerate() {
        add_energy(plan, i, body, room, &mut d, &mut sizes);
    }
    let (mut t, mut tests) = ([T::zero(); MOST], [T::zero(); MOST]);
    let at: [T; 3] = point(room, &struck.on);
    let mut turned = T::one();
    let normal = match &struck.normal {
        Normal::Along(heading) => direction(room, heading),
        Normal::Toward(end) => {
            let end = point(room, end);
            let line = minus(&end, &at);
            let over = T::one() / dot(&line, &line).sqrt();
            // It turns by what its ends are off.
            turned = (size(&end) + size(&at)).mul_add(over, turned);
            times(&line, over)
        }
    };
    let mut y = 0;
    while y < f {
        if let Some(body) = struck.on.body {
            let (speed, test) = speed::<T>(plan, body, y, &at, &normal, room);
            (t[y], tests[y]) = (t[y] + speed, tests[y] + test);
        }
        if let Some(body) = struck.against {
            let (speed, test) = speed::<T>(plan, body, y, &at, &normal, room);
            (t[y], tests[y]) = (t[y] - speed, tests[y] + test);
        }
        y += 1;
    }
    // The point's speed is a sum of what any rate gives it, also where it stands still.
    let reach_of = |body: Option<usize>| body.map_or(0.0, |b| plan.bodies[b].reach);
    let reach = reach_of(struck.on.body) + reach_of(struck.against);
    let arm = size(&at) + T::from_f64(reach);
    let arms = arm.mul_add(T::from_f64(1.0 / plan.length), T::one());
    let roundings = T::from_f64(ROUTE_ROUNDINGS);
    let mut k = 0;
    while k < f {
        let off: T = lost * all_rates::<T>(plan, k, room);
        tests[k] = turned * off.mul_add(arms, tests[k] * roundings);
        let square = off * off * T::from_f64(plan.weight);
        let cross = (square * d[k][k].abs()).sqrt();
        let second = square * T::from_f64(f64::EPSILON);
        sizes[k] = sizes[k].mul_add(roundings, cross + cross + second);
        k += 1;
    }
    let mut answer = Answer { response: T::zero(), error: T::zero() };
    k = 0;
    while k < f {
        let over = T::one() / d[k][k];
        let rate = t[k] * over;
        let part = rate.abs();
        answer.response = t[k].mul_add(rate, answer.response);
        answer.error = part.mul_add(part.mul_add(sizes[k], tests[k] + tests[k]), answer.error);
        let mut j = k + 1;
        while j < f {
            let factor = -(d[j][k] * over);
            let mut c = k + 1;
            while c <= j {
                d[j][c] = d[c][k].mul_add(factor, d[j][c]);
                c += 1;
            }
            t[j] = t[k].mul_add(factor, t[j]);
            tests[j] = tests[k].mul_add(factor.abs(), tests[j]);
            sizes[j] = sizes[k].mul_add(factor * factor, sizes[j]);
            j += 1;
        }
        k += 1;
    }
    answer
}

/// All rates at a unit rate of one independent coordinate, added up.
#[inline(always)]
fn all_rates<T: Lanes>(plan: &Plan, y: usize, room: &[f64]) -> T {
    let mut sum = T::one();
    let mut k = 0;
    while k < plan.layout.count {
        sum += get::<T>(room, plan.layout.rates + k * plan.freedoms + y).abs();
        k += 1;
    }
    sum
}

/// The closing speed of a body's point, and the size of what it is the sum of.
#[inline(always)]
fn speed<T: Lanes>(plan: &Plan, body: usize, y: usize, at: &[T; 3], normal: &[T; 3], room: &[f64]) -> (T, T) {
    if !plan.bodies[body].moved[y] {
        return (T::zero(), T::zero());
    }
    let from = plan.layout.twists + 6 * (body * plan.freedoms + y);
    let (angular, linear): ([T; 3], [T; 3]) = (get_vector(room, from), get_vector(room, from + 3));
    let arm = minus(at, &get_vector(room, FRAME * body + 9));
    let velocity = plus(&linear, &cross(&angular, &arm));
    (dot(normal, &velocity), size(&angular).mul_add(size(&arm), size(&linear)))
}

/// A body's part of D, below the diagonal and on it, and of the size of what the diagonal is the sum of.
#[inline(always)]
fn add_energy<T: Lanes>(
    plan: &Plan,
    i: usize,
    body: &Moving,
    room: &[f64],
    d: &mut [[T; LINKAGE_FREEDOMS]; LINKAGE_FREEDOMS],
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
            let own = get::<T>(room, plan.layout.rates + velocity.column * f + y) * armature;
            let mut z = 0;
            while z <= y {
                d[y][z] = own.mul_add(get(room, plan.layout.rates + velocity.column * f + z), d[y][z]);
                z += 1;
            }
            sizes[y] = own.mul_add(get(room, plan.layout.rates + velocity.column * f + y), sizes[y]);
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
    let (turn, _) = frame::<T>(room, i);
    let mut known = [[[T::zero(); 3]; 2]; LINKAGE_FREEDOMS];
    let mut y = 0;
    while y < f {
        if body.moved[y] {
            let from = plan.layout.twists + 6 * (i * f + y);
            let angular = back(&turn, &get_vector(room, from));
            let linear = back(&turn, &get_vector(room, from + 3));
            known[y] = [angular, linear];
            let about_origin = of(inertia[4] + inertia[7] + inertia[9]) * dot(&angular, &angular);
            sizes[y] += mass.mul_add(dot(&linear, &linear), about_origin);
            let momentum = plus(&times(&linear, mass), &cross(&angular, &c));
            let about = plus(
                &[dot(&rows[0], &angular), dot(&rows[1], &angular), dot(&rows[2], &angular)],
                &cross(&c, &linear),
            );
            let mut z = 0;
            while z <= y {
                if body.moved[z] {
                    d[y][z] += dot(&known[z][0], &about) + dot(&known[z][1], &momentum);
                }
                z += 1;
            }
        }
        y += 1;
    }
}

/// Rᵀ x.
#[inline(always)]
fn back<T: Lanes>(turn: &[[T; 3]; 3], x: &[T; 3]) -> [T; 3] {
    along(&turn[2], x[2], &along(&turn[1], x[1], &times(&turn[0], x[0])))
}
