//! Forward kinematics: the frame of every body, seen from the root link.

use crate::System;
use percuss_mechanism::LinkId;
use percuss_spatial::{Scalar, Transform, Twist};

/// Positions and the frames that follow from them; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct Kinematics<T: Scalar> {
    /// All positions in joint order, mimics filled in.
    pub q: Vec<T>,
    /// X_rb: every body in the root link's frame.
    pub frames: Vec<Transform<T>>,
    /// X_pb: every body in its parent body (the root, for those on the ground).
    pub steps: Vec<Transform<T>>,
}

impl<T: Scalar> Kinematics<T> {
    pub fn new(system: &System) -> Self {
        let bodies = system.bodies.len();
        Self {
            q: vec![T::zero(); system.positions],
            frames: vec![Transform::identity(); bodies],
            steps: vec![Transform::identity(); bodies],
        }
    }

    /// Frames at the positions already in `q`; a mimic's position is written over by what it follows.
    pub fn refill(&mut self, system: &System) {
        for (joint, range) in system.mechanism.joints().iter().zip(&system.joint_q) {
            if let Some(mimic) = joint.mimic() {
                let master = self.q[system.joint_q[mimic.master.index()].start];
                self.q[range.start] = T::from_f64(mimic.multiplier) * master + T::from_f64(mimic.offset);
            }
        }
        for i in 0..system.bodies.len() {
            self.place(system, i);
        }
    }

    /// As [`refill`](Self::refill), but of these bodies alone (parents first, each with all those above it).
    pub fn refill_bodies(&mut self, system: &System, bodies: &[usize]) {
        for &i in bodies {
            let body = &system.bodies[i];
            if let Some(mimic) = body.joint.and_then(|id| system.mechanism.joint(id).mimic()) {
                let master = self.q[system.joint_q[mimic.master.index()].start];
                self.q[body.q.start] = T::from_f64(mimic.multiplier) * master + T::from_f64(mimic.offset);
            }
            self.place(system, i);
        }
    }

    #[inline]
    fn place(&mut self, system: &System, i: usize) {
        let body = &system.bodies[i];
        if body.joint.is_some() {
            self.steps[i] = body.origin.cast() * body.motion.transform(&self.q[body.q.clone()]);
        }
        self.frames[i] = match body.parent {
            Some(parent) => self.frames[parent] * self.steps[i],
            None => self.steps[i],
        };
    }

    /// Motion column `k` of body `i`, in the body's axes at its origin.
    #[inline]
    pub fn column(&self, system: &System, i: usize, k: usize) -> Twist<T> {
        let body = &system.bodies[i];
        body.motion.column(k, &self.q[body.q.clone()])
    }

    /// X_rl: a link in the root link's frame.
    pub fn link_frame(&self, system: &System, link: LinkId) -> Transform<T> {
        let seat = &system.seats[link.index()];
        match seat.body {
            Some(body) => self.frames[body] * seat.frame.cast(),
            None => seat.frame.cast(),
        }
    }
}
