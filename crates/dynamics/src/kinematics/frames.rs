//! Forward kinematics: the frame of every body relative to the root link.

use crate::model::tangent;
use crate::model::{LinkFrame, Model};
use nalgebra::Vector3;
use percuss_mechanism::LinkId;
use percuss_spatial::{Transform, Twist};

/// Positions and the resulting frames; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct Kinematics {
    /// Positions of all joints, in joint order, including mimics.
    pub q: Vec<f64>,
    /// X_rb of every body: body frame in the frame of the root link.
    pub frames: Vec<Transform<f64>>,
    /// X_pb of every body: body frame in its parent body (in the root, for bodies on the ground).
    pub parent_transforms: Vec<Transform<f64>>,
}

impl Kinematics {
    /// Kinematics with every joint at zero, quaternions at identity.
    pub fn zero(model: &Model) -> Self {
        let mut kinematics = Self::new(model);
        for (joint, range) in model.mechanism.joints().iter().zip(&model.joint_q) {
            tangent::zero_position(joint.kind(), &mut kinematics.q[range.clone()]);
        }
        kinematics.refill(model);
        kinematics
    }

    /// Buffers for a model: all positions 0, frames not yet computed (identity). See [`refill`](Self::refill).
    pub fn new(model: &Model) -> Self {
        let bodies = model.bodies.len();
        Self {
            q: vec![0.0; model.positions],
            frames: vec![Transform::identity(); bodies],
            parent_transforms: vec![Transform::identity(); bodies],
        }
    }

    /// Updates all frames from the positions in `q`. Positions of mimics are overwritten by their masters.
    pub fn refill(&mut self, model: &Model) {
        for i in 0..model.bodies.len() {
            self.update_frame(model, i);
        }
    }

    /// Like [`refill`](Self::refill), for the given bodies only (parents first). Their ancestors are not updated.
    pub fn refill_bodies(&mut self, model: &Model, bodies: &[usize]) {
        for &i in bodies {
            self.update_frame(model, i);
        }
    }

    /// Updates the frames of body `i` from the positions and the frame of its parent.
    #[inline]
    fn update_frame(&mut self, model: &Model, i: usize) {
        let body = &model.bodies[i];
        if let Some(mimic) = body.mimic {
            self.q[body.q.start] = mimic.multiplier * self.q[mimic.master] + mimic.offset;
        }
        if body.joint.is_some() {
            self.parent_transforms[i] = body.origin * body.motion.transform(&self.q[body.q.clone()]);
        }
        self.frames[i] = match body.parent {
            Some(parent) => self.frames[parent] * self.parent_transforms[i],
            None => self.parent_transforms[i],
        };
    }

    /// Motion column `k` of body `i`, in the body's axes at its origin.
    #[inline]
    pub fn column(&self, model: &Model, i: usize, k: usize) -> Twist<f64> {
        let body = &model.bodies[i];
        body.motion.column(k, &self.q[body.q.clone()])
    }

    /// Motion column `k` of body `i` in root axes, at `point` (root frame).
    #[inline]
    pub fn column_at(&self, model: &Model, i: usize, k: usize, point: &Vector3<f64>) -> Twist<f64> {
        let (frame, column) = (&self.frames[i], self.column(model, i, k));
        if !model.bodies[i].motion.turns(k) {
            return Twist::new(Vector3::zeros(), frame.rotation * column.linear);
        }
        // A rotation has no linear velocity at the body's origin.
        let angular = frame.rotation * column.angular;
        Twist::new(angular, (frame.translation - point).cross(&angular))
    }

    /// X_rf of a frame on a body or on the ground.
    #[inline]
    pub fn frame_of(&self, on: &LinkFrame) -> Transform<f64> {
        match on.body {
            Some(body) => self.frames[body] * on.frame,
            None => on.frame,
        }
    }

    /// X_rl of a link: link frame in the frame of the root link.
    pub fn link_frame(&self, model: &Model, link: LinkId) -> Transform<f64> {
        self.frame_of(&model.link_frames[link.index()])
    }
}
