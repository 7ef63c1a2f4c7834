//! Distance of the pivots followed by duals and lanes from the zero threshold, without a branch on a value.

use super::Recursion;
use crate::kinematics::frames::Kinematics;
use crate::mobility::GroupMobility;
use crate::model::Model;
use crate::tolerances::PIVOT;
use nalgebra::Vector3;
use percuss_spatial::{Scalar, Transform, Twist};

/// Size of the terms of an articulated inertia: moment (kg·m²) and mass (kg).
#[derive(Clone, Copy)]
struct Size<T> {
    moment: T,
    mass: T,
}

impl<T: Scalar, const K: usize> Recursion<T, K> {
    /// Sum of (zero/pivot)² over the followed pivots, and of (pivot/zero)² over the dropped pivots of plain joints.
    /// The zero threshold is that of `Deciding` and of the groups, with the sizes here.
    pub fn pivot_loss(
        &self,
        model: &Model,
        kinematics: &Kinematics<T>,
        groups: &[GroupMobility],
        point: &Vector3<T>,
    ) -> T {
        let mut sizes: Vec<Size<T>> = Vec::with_capacity(model.bodies.len());
        let mut arms: Vec<T> = Vec::with_capacity(model.bodies.len());
        for (frame, own) in kinematics.frames.iter().zip(&self.bodies) {
            let x = Transform::new(frame.rotation, frame.translation - point);
            let arm = root(x.translation.dot(&x.translation));
            let first = root(own.first_moment.dot(&own.first_moment));
            let two = T::from_f64(2.0);
            let r = &own.rotational;
            let moment = r.m11 + r.m22 + r.m33 + two * arm * (two * first + arm * own.mass);
            arms.push(arm);
            sizes.push(Size { moment, mass: own.mass });
        }
        let zero = T::from_f64(PIVOT);
        let mut loss = T::zero();
        for (number, cluster) in model.clusters.iter().enumerate() {
            match self.cluster_index[number] {
                None => {
                    let i = cluster.bodies[0];
                    for e in &self.joints[model.bodies[i].v.clone()] {
                        let zero = zero * energy(&e.s, arms[i], sizes[i]);
                        let tiny = T::from_f64(f64::MIN_POSITIVE);
                        let part = if e.counts { zero / e.d } else { e.d / (zero + tiny) };
                        loss += part * part;
                    }
                }
                Some(place) => loss += self.cluster_pivot_loss(model, number, place, groups, &sizes),
            }
            if let Some(parent) = cluster.parent {
                for &b in &cluster.bodies {
                    let Size { moment, mass } = sizes[b];
                    sizes[parent].moment += moment;
                    sizes[parent].mass += mass;
                }
            }
        }
        loss
    }

    /// Part of [`pivot_loss`](Self::pivot_loss) of the bound cluster `number`, stored at `clusters[place]`: its own pivots and
    /// those of its constraints. `sizes`: per body, with its subtree.
    fn cluster_pivot_loss(
        &self,
        model: &Model,
        number: usize,
        place: usize,
        groups: &[GroupMobility],
        sizes: &[Size<T>],
    ) -> T {
        let (cluster, elimination) = (&model.clusters[number], &self.clusters[place]);
        let (d, mut loss) = (elimination.d, T::zero());
        for &y in &elimination.order {
            let mut size = T::zero();
            for (at, &b) in cluster.bodies.iter().enumerate() {
                size += energy(&elimination.psi[at * d + y], T::zero(), sizes[b]);
            }
            for v in &cluster.velocities {
                let own = elimination.g[v.coordinate * d + y] * T::from_f64(v.multiplier);
                size += self.armature[v.index] * own * own;
            }
            let part = T::from_f64(PIVOT) * size / elimination.factor[y * d + y];
            loss += part * part;
        }
        for (rates, own) in elimination.rates.iter().zip(&cluster.groups) {
            loss += rates.pivot_loss(&model.groups[own.group], &groups[own.group]);
        }
        loss
    }
}

/// Size of the terms of sᵀIs for an inertia I of given size; the terms of the lever of s are as large as the arm.
fn energy<T: Scalar>(s: &Twist<T>, arm: T, size: Size<T>) -> T {
    let turn = s.angular.dot(&s.angular);
    let slide = root(s.linear.dot(&s.linear)) + root(turn) * arm;
    turn * size.moment + slide * slide * size.mass
}

/// √x with a finite derivative at x = 0.
fn root<T: Scalar>(x: T) -> T {
    (x + T::from_f64(f64::MIN_POSITIVE)).sqrt()
}
