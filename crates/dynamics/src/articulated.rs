//! Route B: the articulated-body recursion. No matrix, O(n), open chains without mimics.

use crate::System;
use crate::contact::at_point;
use crate::kinematics::Kinematics;
use nalgebra::Vector3;
use percuss_spatial::{ArticulatedInertia, Scalar, Transform, Twist, Wrench};

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
    /// sᵀ p for every probe.
    t: [T; K],
}

/// Room for the recursion with `K` probes (unit wrenches) at once; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct Articulated<T: Scalar, const K: usize> {
    inertias: Vec<ArticulatedInertia<T>>,
    /// Rigid inertia carried: trace of the rotational part, mass.
    sizes: Vec<(T, T)>,
    probes: Vec<[Wrench<T>; K]>,
    eliminations: Vec<Elimination<T, K>>,
}

/// How far the pivots can be trusted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trust {
    /// Smallest pivot relative to the size of its terms.
    pub least_pivot: f64,
    /// First-order relative error of 1/m̄ from rounding in the pivots.
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
            t: [T::zero(); K],
        };
        Self {
            inertias: vec![ArticulatedInertia::zero(); bodies],
            sizes: vec![(T::zero(), T::zero()); bodies],
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
            self.sizes[i] = (inertia.rotational.trace(), inertia.mass);
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
                let (turn, mass) = self.sizes[i];
                let d_size = s.angular.dot(&s.angular) * turn + s.linear.dot(&s.linear) * mass + armature;
                self.eliminations[v] = Elimination { s, u, d, d_size, t };
            }
            if let Some(parent) = body.parent {
                let (lower, upper) = self.inertias.split_at_mut(i);
                lower[parent] += &upper[0];
                let probes = self.probes[i];
                for (sum, p) in self.probes[parent].iter_mut().zip(probes) {
                    *sum += p;
                }
                let (turn, mass) = self.sizes[i];
                self.sizes[parent].0 += turn;
                self.sizes[parent].1 += mass;
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
    /// How far the pivots can be trusted, weighted by their part in the answer of probe 0.
    pub fn trust(&self) -> Trust {
        let (mut least_pivot, mut error, mut sum) = (1.0f64, 0.0, 0.0);
        for e in &self.eliminations {
            // After a pivot of zero the next ones are NaN: no better.
            let pivot = Some(e.d / e.d_size).filter(|pivot| !pivot.is_nan()).unwrap_or(0.0);
            least_pivot = least_pivot.min(pivot);
            let part = e.t[0] * e.t[0] / e.d;
            sum += part;
            error += part / pivot;
        }
        // A NaN stays one here, and is not trusted.
        Trust { least_pivot, relative_error: if sum == 0.0 { 0.0 } else { f64::EPSILON * error / sum } }
    }
}
