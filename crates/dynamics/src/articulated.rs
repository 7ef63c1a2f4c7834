//! Route B: the articulated-body recursion. No matrix, O(n), open chains without mimics.

use crate::System;

use crate::kinematics::Kinematics;
use crate::support::at_point;
use nalgebra::Vector3;
use percuss_spatial::{ArticulatedInertia, Scalar, SpatialInertia, Transform, Twist, Wrench};

/// What the recursion keeps for one velocity.
#[derive(Clone, Debug)]
struct Elimination<T: Scalar, const K: usize> {
    /// Motion column in root axes at the struck point.
    s: Twist<T>,
    /// Iᴬ s.
    u: Wrench<T>,
    /// sᵀ Iᴬ s + armature.
    d: T,
    /// The size of the terms whose difference `d` is.
    d_size: T,
    /// sᵀ Iᶜ s + armature: what `d` would be with all joints below frozen.
    frozen: T,
    /// sᵀ p for every probe.
    t: [T; K],
}

/// Room for the recursion with `K` probes (unit wrenches) at once; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct Articulated<T: Scalar, const K: usize> {
    inertias: Vec<ArticulatedInertia<T>>,
    /// Inertia of the body and all it carries, joints frozen.
    composites: Vec<SpatialInertia<T>>,
    probes: Vec<[Wrench<T>; K]>,
    eliminations: Vec<Elimination<T, K>>,
}

/// Errors seen beside 60-digit arithmetic on a robot whose wrist lines up: 11 ε/(what is left).
const SINGULAR_WEIGHT: f64 = 16.0;

/// How far the pivots can be trusted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trust {
    /// Smallest pivot relative to the size of its terms.
    pub least_pivot: f64,
    /// First-order relative error, from rounding in the pivots, of the answer to a probe (1/m̄ where it is a contact).
    pub relative_error: f64,
}

impl<T: Scalar, const K: usize> Articulated<T, K> {
    pub fn new(system: &System) -> Self {
        let bodies = system.bodies.len();
        let blank = Elimination {
            s: Twist::zero(),
            u: Wrench::zero(),
            d: T::zero(),
            d_size: T::zero(),
            frozen: T::zero(),
            t: [T::zero(); K],
        };
        Self {
            inertias: vec![ArticulatedInertia::zero(); bodies],
            composites: vec![SpatialInertia::zero(); bodies],
            probes: vec![[Wrench::zero(); K]; bodies],
            eliminations: vec![blank; system.follows.len()],
        }
    }

    /// Takes all wrenches off.
    pub fn clear(&mut self) {
        self.probes.fill([Wrench::zero(); K]);
    }

    /// Adds a wrench on a body to one of the probes, in root axes about the struck point.
    pub fn push(&mut self, body: Option<usize>, probe: usize, wrench: Wrench<T>) {
        if let Some(body) = body {
            self.probes[body][probe] += wrench;
        }
    }

    /// Eliminates every velocity from the tips to the root. All in root axes with the origin at `point`, so that
    /// articulated inertias and wrenches add without being transformed.
    ///
    /// For each velocity: U = Iᴬ s, D = sᵀU + armature, t = sᵀp; then Iᴬ ← Iᴬ − U D⁻¹ Uᵀ, p ← p − U D⁻¹ t. A joint
    /// with several velocities is eliminated one after another, which is its block elimination; a floating base is
    /// such a joint. Featherstone 2008, §7.3; the test-force form: Wensing et al. 2012, eq. 12.
    pub fn eliminate(&mut self, system: &System, kinematics: &Kinematics<T>, point: &Vector3<T>) {
        for (i, body) in system.bodies.iter().enumerate() {
            let x = at_point(&kinematics.frames[i], point);
            let inertia = x.inertia(&body.inertia.cast());
            self.composites[i] = inertia;
            self.inertias[i] = ArticulatedInertia::from(&inertia);
        }
        for (i, body) in system.bodies.iter().enumerate().rev() {
            let x: Transform<T> = at_point(&kinematics.frames[i], point);
            for (k, v) in body.v.clone().enumerate() {
                let s = x.twist(&kinematics.column(system, i, k));
                let u = self.inertias[i].apply(&s);
                let armature = T::from_f64(body.armature[k]);
                let d = u.power(&s) + armature;
                let over_d = u * (T::one() / d);
                let mut t = [T::zero(); K];
                for (t, p) in t.iter_mut().zip(&mut self.probes[i]) {
                    *t = p.power(&s);
                    *p -= over_d * *t;
                }
                self.inertias[i].subtract_dyad(&over_d, &u);
                let composite = &self.composites[i];
                let d_size = s.angular.dot(&s.angular) * composite.rotational.trace()
                    + s.linear.dot(&s.linear) * composite.mass
                    + armature;
                let frozen = composite.twice_energy(&s) + armature;
                self.eliminations[v] = Elimination { s, u, d, d_size, frozen, t };
            }
            if let Some(parent) = body.parent {
                let (lower, upper) = self.inertias.split_at_mut(i);
                lower[parent] += &upper[0];
                let probes = self.probes[i];
                for (sum, p) in self.probes[parent].iter_mut().zip(probes) {
                    *sum += p;
                }
                let carried = self.composites[i];
                self.composites[parent] += carried;
            }
        }
    }

    /// Σ tₐᵀ D⁻¹ t_b over all velocities: entry (a, b) of Φ for the probes' wrenches. With one probe along the
    /// normal, 1/m̄.
    pub fn response(&self, a: usize, b: usize) -> T {
        self.eliminations.iter().fold(T::zero(), |sum, e| sum + e.t[a] * e.t[b] / e.d)
    }

    /// Velocities of the tree after a unit impulse of probe 0: M⁻¹ jᵀ. `motions` is room for one twist a body.
    pub fn velocities(&self, system: &System, motions: &mut [Twist<T>], velocities: &mut [T]) {
        for (i, body) in system.bodies.iter().enumerate() {
            let mut motion = body.parent.map_or_else(Twist::zero, |p| motions[p]);
            // Eliminated first, found last.
            for v in body.v.clone().rev() {
                let e = &self.eliminations[v];
                velocities[v] = (e.t[0] - e.u.power(&motion)) / e.d;
                motion += e.s * velocities[v];
            }
            motions[i] = motion;
        }
    }
}

impl<const K: usize> Articulated<f64, K> {
    /// How far the pivots can be trusted: each by the size of its terms, weighted by its part in the answer to each
    /// probe, of which the worst counts; and by how little of the frozen inertia is left, which is how nearly singular
    /// the mass matrix is.
    pub fn trust(&self) -> Trust {
        let (mut least_pivot, mut least_left) = (1.0f64, 1.0f64);
        let (mut errors, mut sums) = ([0.0; K], [0.0; K]);
        // After a pivot of zero the next ones are NaN: no better.
        let ratio = |d: f64, size: f64| Some(d / size).filter(|ratio| !ratio.is_nan()).unwrap_or(0.0);
        for e in &self.eliminations {
            let pivot = ratio(e.d, e.d_size);
            least_pivot = least_pivot.min(pivot);
            least_left = least_left.min(ratio(e.d, e.frozen));
            for ((t, error), sum) in e.t.iter().zip(&mut errors).zip(&mut sums) {
                let part = t * t / e.d;
                *sum += part;
                *error += part / pivot;
            }
        }
        let mut weighted = 0.0;
        for (error, sum) in errors.iter().zip(sums).filter(|(_, sum)| *sum != 0.0) {
            let own = error / sum;
            // Not `max`: a NaN must stay, and is not trusted.
            weighted = if own.is_nan() || own > weighted { own } else { weighted };
        }
        Trust { least_pivot, relative_error: f64::EPSILON * (weighted + SINGULAR_WEIGHT / least_left) }
    }
}
