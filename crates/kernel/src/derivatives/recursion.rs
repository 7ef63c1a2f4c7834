//! Gradient of m̄ and inverse operational inertia of a tree, one configuration per lane.
//!
//! All quantities are in root axes about the contact point. With the twists V of the bodies under a unit force F along the normal,
//!
//! ```text
//! inwards:   U = I s,  D = s·U + armature,  t = s·f;   I ← I − U D⁻¹ Uᵀ,  f ← f − U D⁻¹ t,  1/m̄ += t²/D
//! outwards:  u̇ = D⁻¹ (t − U·V_p),  V = V_p + s u̇;     Φ ← (1 − s D⁻¹ Uᵀ) Φ (1 − U D⁻¹ sᵀ) + s D⁻¹ sᵀ
//! inwards:   R = I_body V − F + Σ R_children;          g = 2 m̄² (R · (V_p × s) + Q · s)
//! ```
//!
//! The joints of a cluster of mimics follow one coordinate. The reach s′ of a body is its twist at a unit rate with the parent of the cluster
//! at rest; then U = Σ I s′ and D = Σ (s′·I s′ + m² armature) over the bodies, each with the inertias beyond it and outside the cluster, which
//! the parent of the cluster receives. Q is the wrench of a normal that does not turn with the contact link (see [`crate::motion::mass_gradient`], which computes g for
//! every mechanism), Φ the propagation of the inverse operational inertia (Featherstone 2008, §8; Wensing, Featherstone and Orin 2012).

use super::plan::{Plan, Step, StepMotion};
use crate::columns::PositionColumns;
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{
    PackedInertia, PackedTwist, PackedWrench, rotate_symmetric, rotated, rotation_rows, splat,
};

/// Numbers of a body in the scratch memory.
pub(super) const BODY_NUMBERS: usize = 56;
/// First nine: the rotation, by rows.
const ORIGIN: usize = 9;
const MOMENTS: usize = 12;
const FIRST_MOMENT: usize = 18;
pub(super) const INERTIA: usize = 21;
const TWIST: usize = 42;
const IMPULSE: usize = 48;
/// Sums over the rigid subtree: trace of the moments of inertia, mass.
pub(super) const SIZES: usize = 54;
/// Numbers of a velocity in the scratch memory: s, U, 1/D, t.
pub(super) const VELOCITY_NUMBERS: usize = 14;
pub(super) const AXIS: usize = 0;
pub(super) const PRODUCT: usize = 6;
/// 1/D, then t.
pub(super) const OVER_PIVOT: usize = 12;

/// Numbers of Φ per configuration: 6×6.
pub const INERTIA_NUMBERS: usize = 36;

/// Contact of the lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaneContact<T> {
    /// Point (m) and unit normal; see `turns`.
    pub point: [T; 3],
    pub normal: [T; 3],
}

/// Bodies that respond to the contact.
#[derive(Clone, Debug, Default)]
pub(super) struct Selection {
    /// Body of the contact link.
    pub body: usize,
    /// True if the normal is fixed in the contact link; otherwise in the root link.
    pub turns: bool,
    /// Bodies of the subtree on the ground, parents first.
    pub active: Vec<usize>,
    /// Bodies from the ground to the contact link.
    pub path: Vec<usize>,
    /// For each body: true if it is on this path.
    pub on_path: Vec<bool>,
    /// For the first body of each cluster: last body of the cluster on this path.
    pub ends: Vec<Option<usize>>,
}

/// Results of the lanes before their last step.
pub(super) struct LaneState<'a, T> {
    pub plan: &'a Plan,
    pub selection: &'a Selection,
    scratch: &'a mut [f64],
    normal: [T; 3],
    /// 1/m̄, 1/kg.
    pub response: T,
    /// Largest ratio of the summed terms of a pivot to the pivot.
    pub loss: T,
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn dot<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn cross<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [
        a[1].mul_add(b[2], -(a[2] * b[1])),
        a[2].mul_add(b[0], -(a[0] * b[2])),
        a[0].mul_add(b[1], -(a[1] * b[0])),
    ]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn add<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Reads `N` numbers of the lanes.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn load<T: Lanes, const N: usize>(from: &[f64]) -> [T; N] {
    let mut numbers = [T::zero(); N];
    let mut k = 0;
    while k < N {
        numbers[k] = T::load(&from[k * T::WIDTH..]);
        k += 1;
    }
    numbers
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn store<T: Lanes, const N: usize>(numbers: &[T; N], to: &mut [f64]) {
    let mut k = 0;
    while k < N {
        numbers[k].store(&mut to[k * T::WIDTH..]);
        k += 1;
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn load_rows<T: Lanes>(from: &[f64]) -> [[T; 3]; 3] {
    let [a, b, c, d, e, f, g, h, i] = load::<T, 9>(from);
    [[a, b, c], [d, e, f], [g, h, i]]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn load_twist<T: Lanes>(from: &[f64]) -> PackedTwist<T> {
    let [a, b, c, d, e, f] = load::<T, 6>(from);
    PackedTwist { angular: [a, b, c], linear: [d, e, f] }
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn load_wrench<T: Lanes>(from: &[f64]) -> PackedWrench<T> {
    let [a, b, c, d, e, f] = load::<T, 6>(from);
    PackedWrench { moment: [a, b, c], force: [d, e, f] }
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn store_screw<T: Lanes>(angular: &[T; 3], linear: &[T; 3], to: &mut [f64]) {
    store(angular, to);
    store(linear, &mut to[3 * T::WIDTH..]);
}

/// R A for two rotations given by rows.
#[cfg_attr(not(debug_assertions), inline(always))]
fn product<T: Lanes>(r: &[[T; 3]; 3], a: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let mut out = *r;
    let mut i = 0;
    while i < 3 {
        let mut k = 0;
        while k < 3 {
            out[i][k] = r[i][0].mul_add(a[0][k], r[i][1].mul_add(a[1][k], r[i][2] * a[2][k]));
            k += 1;
        }
        i += 1;
    }
    out
}

/// Column `k` of a rotation given by rows.
#[cfg_attr(not(debug_assertions), inline(always))]
fn column<T: Lanes>(r: &[[T; 3]; 3], k: usize) -> [T; 3] {
    [r[0][k], r[1][k], r[2][k]]
}

/// I v, with I an inertia.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn apply<T: Lanes>(i: &PackedInertia<T>, v: &PackedTwist<T>) -> PackedWrench<T> {
    let (a, c, l) = (&i.angular, &i.coupling, &i.linear);
    let (ω, v) = (&v.angular, &v.linear);
    let moment = [
        dot(&[a[0], a[1], a[2]], ω) + dot(&c[0], v),
        dot(&[a[1], a[3], a[4]], ω) + dot(&c[1], v),
        dot(&[a[2], a[4], a[5]], ω) + dot(&c[2], v),
    ];
    let force = [
        dot(&column(c, 0), ω) + dot(&[l[0], l[1], l[2]], v),
        dot(&column(c, 1), ω) + dot(&[l[1], l[3], l[4]], v),
        dot(&column(c, 2), ω) + dot(&[l[2], l[4], l[5]], v),
    ];
    PackedWrench { moment, force }
}

impl<'a, T: Lanes> LaneState<'a, T> {
    /// Frames, articulated inertias and the response to a unit force at the contact.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn new(
        (plan, selection): (&'a Plan, &'a Selection),
        contact: &LaneContact<T>,
        columns: PositionColumns<'_>,
        first: usize,
        scratch: &'a mut [f64],
    ) -> Self {
        let zero = T::zero();
        let mut state = Self { plan, selection, scratch, normal: contact.normal, response: zero, loss: zero };
        for &number in &selection.active {
            state.fill_frame(number, columns, first);
        }
        let own = state.body(selection.body);
        let r = load_rows::<T>(own);
        let point = add(&load::<T, 3>(&own[ORIGIN * T::WIDTH..]), &rotated(&contact.point, &r));
        if selection.turns {
            state.normal = rotated(&contact.normal, &r);
        }
        for &number in &selection.active {
            state.fill_inertia(number, &point);
        }
        let mut wrench = PackedWrench { moment: [zero; 3], force: state.normal };
        for &number in selection.active.iter().rev() {
            state.eliminate(number, &mut wrench);
        }
        state
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn body(&self, number: usize) -> &[f64] {
        &self.scratch[number * BODY_NUMBERS * T::WIDTH..][..BODY_NUMBERS * T::WIDTH]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn body_mut(&mut self, number: usize) -> &mut [f64] {
        &mut self.scratch[number * BODY_NUMBERS * T::WIDTH..][..BODY_NUMBERS * T::WIDTH]
    }

    /// Numbers of a velocity.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn velocity(&self, step: &Step, k: usize) -> &[f64] {
        let start = self.plan.steps.len() * BODY_NUMBERS + (step.column + k) * VELOCITY_NUMBERS;
        &self.scratch[start * T::WIDTH..][..VELOCITY_NUMBERS * T::WIDTH]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn velocity_mut(&mut self, step: &Step, k: usize) -> &mut [f64] {
        let start = self.plan.steps.len() * BODY_NUMBERS + (step.column + k) * VELOCITY_NUMBERS;
        &mut self.scratch[start * T::WIDTH..][..VELOCITY_NUMBERS * T::WIDTH]
    }

    /// Frame of a body relative to the root.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn fill_frame(&mut self, number: usize, columns: PositionColumns<'_>, first: usize) {
        let plan = self.plan;
        let step = &plan.steps[number];
        let [x, y, z] = &step.rotation;
        let mut r = [splat(x), splat(y), splat(z)];
        let mut p = splat::<T>(&step.origin);
        if let Some(parent) = step.parent {
            let own = self.body(parent);
            let (above, at) = (load_rows::<T>(own), load::<T, 3>(&own[ORIGIN * T::WIDTH..]));
            r = product(&above, &r);
            p = add(&at, &rotated(&p, &above));
        }
        match step.motion {
            StepMotion::Turn { q } => {
                let (s, c) = step_position::<T>(step, columns, q, first).sin_cos();
                let mut i = 0;
                while i < 3 {
                    let (a, b) = (r[i][0], r[i][1]);
                    r[i][0] = c.mul_add(a, s * b);
                    r[i][1] = c.mul_add(b, -(s * a));
                    i += 1;
                }
            }
            StepMotion::Slide { q } => {
                let travel: T = step_position(step, columns, q, first);
                let axis = column(&r, 2);
                p = [
                    axis[0].mul_add(travel, p[0]),
                    axis[1].mul_add(travel, p[1]),
                    axis[2].mul_add(travel, p[2]),
                ];
            }
            StepMotion::Ball { q } => r = product(&r, &quaternion_rows(columns, q, first)),
            StepMotion::Floating { q } => {
                let moved = [columns.at(q, first), columns.at(q + 1, first), columns.at(q + 2, first)];
                p = add(&p, &rotated(&moved, &r));
                r = product(&r, &quaternion_rows(columns, q + 3, first));
            }
            StepMotion::Base => {}
        }
        let own = self.body_mut(number);
        store(&r[0], own);
        store(&r[1], &mut own[3 * T::WIDTH..]);
        store(&r[2], &mut own[6 * T::WIDTH..]);
        store(&p, &mut own[ORIGIN * T::WIDTH..]);
    }

    /// Inertia of a body about the contact point, and its motion columns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn fill_inertia(&mut self, number: usize, point: &[T; 3]) {
        let plan = self.plan;
        let step = &plan.steps[number];
        let of = T::from_f64;
        let own = self.body(number);
        let (r, p) = (load_rows::<T>(own), load::<T, 3>(&own[ORIGIN * T::WIDTH..]));
        let arm = [p[0] - point[0], p[1] - point[1], p[2] - point[2]];
        let [a, b, c, d, e, f] = step.moments;
        let mut j = [of(a), of(b), of(c), of(d), of(e), of(f)];
        rotate_symmetric(&mut j, &r);
        let h = rotated(&splat::<T>(&step.first_moment), &r);
        let m = of(step.mass);
        let moved = [m.mul_add(arm[0], h[0]), m.mul_add(arm[1], h[1]), m.mul_add(arm[2], h[2])];
        let along = dot(&h, &arm) + dot(&arm, &moved);
        let (x, y, z) = (0, 1, 2);
        let less = |i: usize, k: usize| h[i].mul_add(arm[k], arm[i] * moved[k]);
        j = [
            j[0] + along - less(x, x),
            j[1] - less(x, y),
            j[2] - less(x, z),
            j[3] + along - less(y, y),
            j[4] - less(y, z),
            j[5] + along - less(z, z),
        ];
        let o = T::zero();
        let inertia = PackedInertia {
            angular: j,
            coupling: [[o, -moved[2], moved[1]], [moved[2], o, -moved[0]], [-moved[1], moved[0], o]],
            linear: [m, o, o, m, o, m],
        };
        let own = self.body_mut(number);
        store(&j, &mut own[MOMENTS * T::WIDTH..]);
        store(&moved, &mut own[FIRST_MOMENT * T::WIDTH..]);
        inertia.store(&mut own[INERTIA * T::WIDTH..]);
        (j[0] + j[3] + j[5]).store(&mut own[SIZES * T::WIDTH..]);
        m.store(&mut own[(SIZES + 1) * T::WIDTH..]);
        let mut k = 0;
        while k < step.velocities {
            let (axis, turns) = match step.motion {
                StepMotion::Turn { .. } => (column(&r, 2), true),
                StepMotion::Slide { .. } => (column(&r, 2), false),
                StepMotion::Ball { .. } => (column(&r, k), true),
                StepMotion::Floating { .. } | StepMotion::Base => (column(&r, k % 3), k < 3),
            };
            let (angular, linear) = if turns { (axis, cross(&arm, &axis)) } else { ([o; 3], axis) };
            store_screw(&angular, &linear, &mut self.velocity_mut(step, k)[AXIS * T::WIDTH..]);
            k += 1;
        }
        if let Some(member) = &step.member {
            self.fill_reach(number, member);
        }
    }

    /// Eliminates the velocities of a body and adds the remaining inertia to its parent's.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn eliminate(&mut self, number: usize, wrench: &mut PackedWrench<T>) {
        let plan = self.plan;
        let step = &plan.steps[number];
        if let Some(member) = &step.member {
            return self.eliminate_member(number, member, wrench);
        }
        let on_path = self.selection.on_path[number];
        let own = self.body(number);
        let mut inertia = PackedInertia::<T>::load(&own[INERTIA * T::WIDTH..]);
        let [moments, mass] = load::<T, 2>(&own[SIZES * T::WIDTH..]);
        let mut place = 0;
        while place < step.velocities {
            let k = step.velocity(place);
            let axis = load_twist::<T>(&self.velocity(step, k)[AXIS * T::WIDTH..]);
            let u = apply(&inertia, &axis);
            let over = T::one() / (axis.power(&u) + T::from_f64(step.armature[k]));
            let (ω, v) = (dot(&axis.angular, &axis.angular), dot(&axis.linear, &axis.linear));
            let terms = ω.mul_add(moments, v * mass);
            // Twice: the mixed terms of ω and v are at most the sum of the others.
            // A pivot that is only rounding may be negative.
            self.loss = self.loss.max(((terms + terms) * over).abs());
            let over_d = u.scaled(over);
            let mut load = T::zero();
            if on_path {
                load = axis.power(wrench);
                self.response = (load * load).mul_add(over, self.response);
                wrench.subtract(&over_d, load);
            }
            inertia.subtract_dyad(&u, &over_d);
            let to = self.velocity_mut(step, k);
            store_screw(&u.moment, &u.force, &mut to[PRODUCT * T::WIDTH..]);
            store(&[over, load], &mut to[OVER_PIVOT * T::WIDTH..]);
            place += 1;
        }
        let Some(parent) = step.parent else { return };
        let above = self.body_mut(parent);
        if !step.transmits_nothing() {
            let mut sum = PackedInertia::<T>::load(&above[INERTIA * T::WIDTH..]);
            sum.add(&inertia);
            sum.store(&mut above[INERTIA * T::WIDTH..]);
        }
        let [a, m] = load::<T, 2>(&above[SIZES * T::WIDTH..]);
        store(&[a + moments, m + mass], &mut above[SIZES * T::WIDTH..]);
    }

    /// Twist of the parent of a body under the unit force.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn parent_twist(&self, step: &Step) -> PackedTwist<T> {
        match step.parent {
            Some(parent) => load_twist(&self.body(parent)[TWIST * T::WIDTH..]),
            None => PackedTwist::zero(),
        }
    }

    /// Gradient of m̄ by the velocities of all joints, kg/rad or kg/m: velocity v of lane l at `output[v · stride + l]`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn gradient(&mut self, output: &mut [f64], stride: usize) {
        let (plan, selection) = (self.plan, self.selection);
        for &number in &selection.active {
            let step = &plan.steps[number];
            let mut twist = self.parent_twist(step);
            let mut place = step.velocities;
            while place > 0 {
                place -= 1;
                let from = self.velocity(step, step.velocity(place));
                let axis = load_twist::<T>(&from[AXIS * T::WIDTH..]);
                let rate = if let Some(member) = &step.member {
                    T::from_f64(member.multiplier) * self.cluster_rate(number, member, &twist)
                } else {
                    let u = load_wrench::<T>(&from[PRODUCT * T::WIDTH..]);
                    let [over, load] = load::<T, 2>(&from[OVER_PIVOT * T::WIDTH..]);
                    (load - twist.power(&u)) * over
                };
                let mut i = 0;
                while i < 3 {
                    twist.angular[i] = axis.angular[i].mul_add(rate, twist.angular[i]);
                    twist.linear[i] = axis.linear[i].mul_add(rate, twist.linear[i]);
                    i += 1;
                }
            }
            let own = self.body(number);
            let j = load::<T, 6>(&own[MOMENTS * T::WIDTH..]);
            let h = load::<T, 3>(&own[FIRST_MOMENT * T::WIDTH..]);
            let (ω, v, m) = (&twist.angular, &twist.linear, T::from_f64(step.mass));
            // Momentum: L = J ω + h × v, p = m v + ω × h.
            let (hv, ωh) = (cross(&h, v), cross(ω, &h));
            let moment = [
                dot(&[j[0], j[1], j[2]], ω) + hv[0],
                dot(&[j[1], j[3], j[4]], ω) + hv[1],
                dot(&[j[2], j[4], j[5]], ω) + hv[2],
            ];
            let mut force = [m.mul_add(v[0], ωh[0]), m.mul_add(v[1], ωh[1]), m.mul_add(v[2], ωh[2])];
            if number == selection.body {
                let n = &self.normal;
                force = [force[0] - n[0], force[1] - n[1], force[2] - n[2]];
            }
            let own = self.body_mut(number);
            store_screw(&twist.angular, &twist.linear, &mut own[TWIST * T::WIDTH..]);
            store_screw(&moment, &force, &mut own[IMPULSE * T::WIDTH..]);
        }
        let speed = load_twist::<T>(&self.body(selection.body)[TWIST * T::WIDTH..]).linear;
        let turning = if selection.turns { [T::zero(); 3] } else { cross(&self.normal, &speed) };
        let factor = T::from_f64(2.0) / (self.response * self.response);
        for &number in selection.active.iter().rev() {
            let step = &plan.steps[number];
            let impulse = load_wrench::<T>(&self.body(number)[IMPULSE * T::WIDTH..]);
            let above = self.parent_twist(step);
            let mut k = 0;
            while k < step.velocities {
                let axis = load_twist::<T>(&self.velocity(step, k)[AXIS * T::WIDTH..]);
                let linear = add(&cross(&above.angular, &axis.linear), &cross(&above.linear, &axis.angular));
                let moved = PackedTwist { angular: cross(&above.angular, &axis.angular), linear };
                let mut rate = moved.power(&impulse);
                if selection.on_path[number] {
                    rate += dot(&turning, &axis.angular);
                }
                if let Some(first) = step.output {
                    (rate * factor).store(&mut output[(first + k) * stride..]);
                }
                k += 1;
            }
            if let Some(parent) = step.parent {
                let to = &mut self.body_mut(parent)[IMPULSE * T::WIDTH..];
                let mut sum = load_wrench::<T>(to);
                sum.add(&impulse);
                store_screw(&sum.moment, &sum.force, to);
            }
        }
    }

    /// Φ = J M⁻¹ Jᵀ of the contact link at the contact point, in root axes: entry (i, k) of lane l at `output[(6 i + k) · stride + l]`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn inverse_inertia(&self, output: &mut [f64], stride: usize) {
        let o = T::zero();
        let mut φ = PackedInertia { angular: [o; 6], coupling: [[o; 3]; 3], linear: [o; 6] };
        for &number in &self.selection.path {
            let mut step = &self.plan.steps[number];
            let mut place = step.velocities;
            let member = step.member.as_ref();
            if let Some(member) = member {
                if self.selection.ends[member.head] != Some(number) {
                    continue;
                }
                step = &self.plan.steps[member.head];
            }
            while place > 0 {
                place -= 1;
                let from = self.velocity(step, step.velocity(place));
                let s = match member {
                    Some(_) => self.reach(number),
                    None => load_twist::<T>(&from[AXIS * T::WIDTH..]),
                };
                let u = load_wrench::<T>(&from[PRODUCT * T::WIDTH..]);
                let [over, _] = load::<T, 2>(&from[OVER_PIVOT * T::WIDTH..]);
                // y = Φ U;  Φ − (s yᵀ + y sᵀ)/D + s sᵀ (1 + Uᵀy/D)/D = Φ − s zᵀ − z sᵀ with z below.
                let y = apply(&φ, &PackedTwist { angular: u.moment, linear: u.force });
                let y = PackedTwist { angular: y.moment, linear: y.force };
                let half = T::from_f64(0.5) * over.mul_add(y.power(&u), T::one());
                let mut z = y;
                let mut i = 0;
                while i < 3 {
                    z.angular[i] = over * (-half).mul_add(s.angular[i], y.angular[i]);
                    z.linear[i] = over * (-half).mul_add(s.linear[i], y.linear[i]);
                    i += 1;
                }
                subtract_symmetric(&mut φ, &s, &z);
            }
        }
        let (a, c, l) = (&φ.angular, &φ.coupling, &φ.linear);
        let place = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
        let mut i = 0;
        while i < 3 {
            let mut k = 0;
            while k < 3 {
                a[place[i][k]].store(&mut output[(6 * i + k) * stride..]);
                c[i][k].store(&mut output[(6 * i + 3 + k) * stride..]);
                c[k][i].store(&mut output[(6 * (3 + i) + k) * stride..]);
                l[place[i][k]].store(&mut output[(6 * (3 + i) + 3 + k) * stride..]);
                k += 1;
            }
            i += 1;
        }
    }
}

/// Position of a joint: that of its master, for a mimic.
#[cfg_attr(not(debug_assertions), inline(always))]
fn step_position<T: Lanes>(step: &Step, columns: PositionColumns<'_>, q: usize, first: usize) -> T {
    let position = columns.at::<T>(q, first);
    match step.mimic {
        Some([multiplier, offset]) => position.mul_add(T::from_f64(multiplier), T::from_f64(offset)),
        None => position,
    }
}

/// Φ − s zᵀ − z sᵀ.
#[cfg_attr(not(debug_assertions), inline(always))]
fn subtract_symmetric<T: Lanes>(φ: &mut PackedInertia<T>, s: &PackedTwist<T>, z: &PackedTwist<T>) {
    let packed = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let mut at = 0;
    while at < packed.len() {
        let (i, k) = packed[at];
        φ.angular[at] -= s.angular[i].mul_add(z.angular[k], z.angular[i] * s.angular[k]);
        φ.linear[at] -= s.linear[i].mul_add(z.linear[k], z.linear[i] * s.linear[k]);
        at += 1;
    }
    let mut i = 0;
    while i < 3 {
        let mut k = 0;
        while k < 3 {
            φ.coupling[i][k] -= s.angular[i].mul_add(z.linear[k], z.angular[i] * s.linear[k]);
            k += 1;
        }
        i += 1;
    }
}

/// Rows of the rotation of the quaternion with the first position `q`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn quaternion_rows<T: Lanes>(columns: PositionColumns<'_>, q: usize, first: usize) -> [[T; 3]; 3] {
    rotation_rows([
        columns.at(q, first),
        columns.at(q + 1, first),
        columns.at(q + 2, first),
        columns.at(q + 3, first),
    ])
}
