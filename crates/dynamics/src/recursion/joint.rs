//! Elimination of one plain joint, one velocity after another, which equals block elimination. Velocities with small
//! pivots come last. A floating base is a plain joint.

use super::Recursion;
use super::elimination::{JointElimination, RecursionMotion};
use super::pivoting::Pivoting;
use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use nalgebra::Vector3;
use percuss_spatial::Twist;

/// Motion column of a joint at the contact point. The columns of a floating base span all twists, so unit twists at the
/// contact point replace them and the distance of the base does not enter.
#[inline]
fn base_or_joint_column(
    model: &Model,
    kinematics: &Kinematics,
    i: usize,
    k: usize,
    point: &Vector3<f64>,
) -> Twist<f64> {
    if model.bodies[i].joint.is_some() {
        return kinematics.column_at(model, i, k, point);
    }
    let mut unit = Twist::zero();
    if k < 3 {
        unit.angular[k] = 1.0;
    } else {
        unit.linear[k - 3] = 1.0;
    }
    unit
}

impl<const K: usize> Recursion<K> {
    /// U = Iᴬ s, D = sᵀU + armature, t = sᵀf; then Iᴬ ← Iᴬ − U D⁻¹ Uᵀ, f ← f − U D⁻¹ t, and both to the parent.
    #[inline]
    pub(super) fn eliminate_joint(
        &mut self,
        model: &Model,
        kinematics: &Kinematics,
        i: usize,
        point: &Vector3<f64>,
        pivoting: &mut Pivoting<K>,
    ) {
        let body = &model.bodies[i];
        let (first, dofs) = (body.v.start, body.v.len());
        // Restarted, so that no result depends on the previous one.
        for (k, v) in (first..first + dofs).enumerate() {
            self.order[v] = v;
            self.joints[v].s = base_or_joint_column(model, kinematics, i, k, point);
        }
        for done in 0..dofs {
            let mut chosen = None;
            for candidate in done..dofs {
                let v = self.order[first + candidate];
                let s = self.joints[v].s;
                let u = self.inertias[i].apply(&s);
                let d = u.power(&s) + self.armature[v];
                let t = self.wrenches[i].map(|f| f.power(&s));
                let step = JointElimination { s, u, d, t, counts: true };
                if pivoting.eliminates_next(i, candidate, dofs, &step) {
                    chosen = Some((candidate, step));
                    break;
                }
            }
            // The last candidate is always accepted.
            let Some((candidate, mut step)) = chosen else { break };
            self.order.swap(first + done, first + candidate);
            let v = self.order[first + done];
            step.counts = pivoting.counts_pivot(i, v, &step, &self.inertias[i]);
            if step.counts {
                let over_d = step.u * (1.0 / step.d);
                for (f, t) in self.wrenches[i].iter_mut().zip(step.t) {
                    *f -= over_d * t;
                }
                self.inertias[i].subtract_dyad(&over_d, &step.u);
            }
            self.joints[v] = step;
        }
        if let Some(parent) = body.parent {
            let (lower, upper) = self.inertias.split_at_mut(i);
            lower[parent] += &upper[0];
            let wrenches = self.wrenches[i];
            for (sum, f) in self.wrenches[parent].iter_mut().zip(wrenches) {
                *sum += f;
            }
            pivoting.propagate_sizes(i, parent);
        }
    }

    /// u̇ = D⁻¹ (t − Uᵀ V), in reverse order of elimination. Without `loaded`, the joint follows its parent.
    #[inline]
    pub(super) fn joint_velocities(
        &self,
        model: &Model,
        i: usize,
        loaded: bool,
        motion: &mut RecursionMotion,
    ) {
        let RecursionMotion { velocities, twists, .. } = motion;
        let body = &model.bodies[i];
        let mut twist = body.parent.map_or_else(Twist::zero, |p| twists[p]);
        for &v in self.order[body.v.clone()].iter().rev() {
            let e = &self.joints[v];
            velocities[v] = 0.0;
            if e.counts {
                let load = if loaded { e.t[0] } else { 0.0 };
                velocities[v] = (load - e.u.power(&twist)) / e.d;
                twist += e.s * velocities[v];
            }
        }
        twists[i] = twist;
    }
}
