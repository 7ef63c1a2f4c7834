//! Terms of the equations of motion that are quadratic in the velocities, and poses at given positions.

use crate::analysis::pose::Pose;
use crate::kinematics::rows::{closure_wrench_rates, closure_wrenches, coupling_scale};
use crate::model::joint_motion::JointMotion;
use crate::model::tangent;
use crate::model::velocities::{StateSizeError, check_positions, check_velocities};
use crate::model::{Constraint, ConstraintRows, ConstraintTerm, Group, Model};
use nalgebra::Vector3;
use percuss_mechanism::JointId;
use percuss_spatial::{Transform, Twist};
use std::sync::Arc;

impl Pose {
    /// Ṡ v of a joint at its velocities `v`: acceleration of the child relative to the parent at constant velocities, in the
    /// child's axes. Zero unless the columns of [`motion_subspace`](Self::motion_subspace) depend on the position.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism, or `velocities` has another length than its velocities.
    pub fn motion_subspace_rate(&self, joint: JointId, velocities: &[f64]) -> Twist<f64> {
        let q = self.joint(joint);
        JointMotion::of(self.mechanism().joint(joint)).bias(q, velocities)
    }

    /// Rates q̇ of [`positions`](Self::positions) at joint velocities (joint order); those of a quaternion are ½ q ∘ (0, ω).
    ///
    /// # Errors
    /// [`StateSizeError`]: velocities that do not fit the mechanism.
    pub fn position_rates<V: AsRef<[f64]>>(&self, velocities: &[V]) -> Result<Vec<f64>, StateSizeError> {
        let model = self.assembly.pose_model();
        check_velocities(&model.mechanism, velocities)?;
        let mut rates = vec![0.0; self.kinematics.q.len()];
        for ((joint, range), v) in model.mechanism.joints().iter().zip(&model.joint_q).zip(velocities) {
            let q = &self.kinematics.q[range.clone()];
            tangent::position_rates(joint.kind(), q, v.as_ref(), &mut rates[range.clone()]);
        }
        Ok(rates)
    }

    /// Pose at the positions of all joints (layout of [`positions`](Self::positions)), with the root link at `base` in the
    /// world. Quaternions are normalised. Loops are not closed again; the residual of the new pose is the resulting gap.
    ///
    /// # Errors
    /// [`StateSizeError`]: another number of positions.
    pub fn at_positions(&self, positions: &[f64], base: Transform<f64>) -> Result<Pose, StateSizeError> {
        let mut pose = self.clone();
        pose.move_to(positions, base)?;
        Ok(pose)
    }

    /// Moves the pose in place, as by [`at_positions`](Self::at_positions). Reuses the memory of the pose.
    ///
    /// # Errors
    /// [`StateSizeError`]: another number of positions. The pose is then unchanged.
    pub fn move_to(&mut self, positions: &[f64], base: Transform<f64>) -> Result<(), StateSizeError> {
        let assembly = Arc::clone(&self.assembly);
        let model = assembly.pose_model();
        check_positions(positions.len(), self.kinematics.q.len())?;
        for (joint, range) in model.mechanism.joints().iter().zip(&model.joint_q) {
            let q = &mut self.kinematics.q[range.clone()];
            q.copy_from_slice(&positions[range.clone()]);
            tangent::normalise(joint.kind(), q);
        }
        self.kinematics.refill(model);
        if let Some(state) = &mut self.loops {
            let residual = |group| model.group_residual(&self.kinematics, group).0;
            state.residual = model.groups.iter().map(residual).fold(0.0, f64::max);
        }
        self.base = base;
        self.decide_mobility_again();
        Ok(())
    }

    /// Ȧ u of each group of constraints at the joint velocities `velocities` (joint order) and the twist `base` of the root link
    /// (root axes, root origin): the rows of [`constraint_groups`](Self::constraint_groups) satisfy A u̇ + Ȧ u = 0, in m/s².
    ///
    /// A row w · (V_s − V_p), with the wrench w about a point x that moves with the successor, has the rate
    /// ẇ · ΔV + w · (ΔV̇ + (0, Δω × ẋ)); V̇ of a body is Σ (V_parent × s + ṡ) v over the joints on its path to the root.
    /// Source: Featherstone 2008, §8.2; the rates of the wrenches are derived here.
    ///
    /// # Errors
    /// [`StateSizeError`]: velocities that do not fit the mechanism.
    pub fn constraint_bias<V: AsRef<[f64]>>(
        &self,
        velocities: &[V],
        base: &Twist<f64>,
    ) -> Result<Vec<Vec<f64>>, StateSizeError> {
        let model = self.assembly.model();
        check_velocities(&model.mechanism, velocities)?;
        if model.groups.is_empty() {
            return Ok(Vec::new());
        }
        let motions = self.body_motions(model, velocities, base);
        let of_group = |group: &Group| {
            let rows = group.constraints.iter();
            rows.flat_map(|rows| self.row_bias(model, rows, group, velocities, &motions, base)).collect()
        };
        Ok(model.groups.iter().map(of_group).collect())
    }

    /// Twist of each body, and its rate at constant joint velocities, in root axes about the root origin.
    fn body_motions<V: AsRef<[f64]>>(
        &self,
        model: &Model,
        velocities: &[V],
        base: &Twist<f64>,
    ) -> Vec<(Twist<f64>, Twist<f64>)> {
        let kinematics = &self.kinematics;
        let of_base: Vec<f64> = base.angular.iter().chain(base.linear.iter()).copied().collect();
        let mut motions = Vec::with_capacity(model.bodies.len());
        for (i, body) in model.bodies.iter().enumerate() {
            let (parent, mut rate) = body.parent.map_or((Twist::zero(), Twist::zero()), |p| motions[p]);
            let mut twist = parent;
            if !body.v.is_empty() {
                let own = body.joint.map_or(&of_base[..], |id| velocities[id.index()].as_ref());
                for (k, v) in own.iter().enumerate() {
                    let column = kinematics.column_at(model, i, k, &Vector3::zeros());
                    twist += column * *v;
                    rate += parent.cross_motion(&column) * *v;
                }
                let bias = body.motion.bias(&kinematics.q[body.q.clone()], own);
                rate += Twist::new(Vector3::zeros(), kinematics.frames[i].vector(&bias.linear));
            }
            motions.push((twist, rate));
        }
        motions
    }

    /// Ȧ u of the rows of one constraint of a group.
    fn row_bias<V: AsRef<[f64]>>(
        &self,
        model: &Model,
        rows: &ConstraintRows,
        group: &Group,
        velocities: &[V],
        motions: &[(Twist<f64>, Twist<f64>)],
        base: &Twist<f64>,
    ) -> Vec<f64> {
        let of_body = |body: Option<usize>| body.map_or((Twist::zero(), Twist::zero()), |b| motions[b]);
        match rows.constraint {
            Constraint::Closure(number) => {
                let closure = &model.closures[number];
                let x_rp = self.kinematics.frame_of(&closure.predecessor);
                let x_rs = self.kinematics.frame_of(&closure.successor);
                let (twist_p, rate_p) = of_body(closure.predecessor.body);
                let (twist_s, rate_s) = of_body(closure.successor.body);
                let at = x_rs.translation;
                let (twist, rate) = (twist_s - twist_p, rate_s - rate_p);
                let speed = twist_s.velocity_at(&at);
                let about = Twist::new(twist.angular, twist.velocity_at(&at));
                let changed = Twist::new(rate.angular, rate.velocity_at(&at) + twist.angular.cross(&speed));
                let length = group.size;
                let wrenches = closure_wrenches(closure, &x_rp, &x_rs, length);
                let turned = closure_wrench_rates(closure, &x_rp, &x_rs, length, &twist_p, &twist_s);
                (0..rows.count).map(|k| turned[k].power(&about) + wrenches[k].power(&changed)).collect()
            }
            // The rows of a curve p(s) change by −p″(s) ṡ.
            Constraint::Coupling(number) => {
                let coupling = &model.couplings[number];
                let [_, curvature] = coupling.curve_derivatives(&self.kinematics.q);
                let rate = |term: &ConstraintTerm| {
                    let joint = model.bodies[term.body].joint;
                    joint.map_or(0.0, |id| term.argument * velocities[id.index()].as_ref()[term.component])
                };
                let rate: f64 = rows.terms.iter().map(rate).sum();
                vec![-coupling_scale(coupling.turns, group) * curvature * rate * rate; rows.count]
            }
            Constraint::Hold(number) => {
                let hold = &model.holds[number];
                let at = self.kinematics.link_frame(model, hold.link).point(&hold.point);
                let (twist, rate) = of_body(model.body_of(hold.link));
                let speed = twist.velocity_at(&at);
                // The directions are fixed in the root link.
                let turn = base.angular.cross(&speed);
                let acceleration = rate.velocity_at(&at) + twist.angular.cross(&speed) - turn;
                hold.directions()[..rows.count].iter().map(|d| d.dot(&acceleration)).collect()
            }
        }
    }
}
