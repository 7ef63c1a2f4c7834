//! Motion of a group by velocities of its coordinates, and velocities between two poses of a group.

use crate::kinematics::frames::Kinematics;
use crate::model::tangent;
use crate::model::{Group, Model};

impl Model {
    /// Moves the positions in `kinematics` by the velocities `u` of a group's coordinates over unit time, and updates
    /// frames.
    pub fn advance_group(&self, kinematics: &mut Kinematics, group: &Group, u: &[f64]) {
        self.advance_positions(kinematics, group, u);
        self.refill_group(kinematics, group);
    }

    /// Moves all positions in `kinematics` by the velocities `u` of the coordinates over unit time, and updates frames.
    pub fn advance(&self, kinematics: &mut Kinematics, u: &[f64]) {
        (0..self.bodies.len()).for_each(|body| self.advance_body(kinematics, body, |c| u[c]));
        kinematics.refill(self);
    }

    /// Moves only the positions, without updating frames and mimics.
    pub fn advance_positions(&self, kinematics: &mut Kinematics, group: &Group, u: &[f64]) {
        for &body in &group.bodies {
            let rate = |c: usize| group.column(c).map_or(0.0, |at| u[at]);
            self.advance_body(kinematics, body, rate);
        }
    }

    /// Moves the positions of one body by the rates of its coordinates over unit time; mimics are skipped.
    fn advance_body(&self, kinematics: &mut Kinematics, body: usize, rate: impl Fn(usize) -> f64) {
        let body = &self.bodies[body];
        if body.v.is_empty() || body.joint.is_none() || body.mimic.is_some() {
            return;
        }
        let q = &mut kinematics.q[body.q.clone()];
        let of = |v: usize| self.velocity_coordinates[v].map_or(0.0, |f| f.multiplier * rate(f.index));
        if q.len() == 1 {
            q[0] += of(body.v.start);
            return;
        }
        let mut velocity = [0.0; 6];
        let velocity = &mut velocity[..body.v.len()];
        velocity.iter_mut().zip(body.v.clone()).for_each(|(v, k)| *v = of(k));
        if velocity.iter().any(|v| *v != 0.0) {
            tangent::advance(body.motion.kind, q, velocity, 1.0);
        }
    }

    /// Velocities over a group's coordinates that lead from one position to another in unit time.
    pub fn displacement(&self, group: &Group, from: &[f64], to: &[f64]) -> Vec<f64> {
        self.displacement_from(group, &self.group_positions(group, from), to)
    }

    /// Like [`displacement`](Self::displacement), from positions of the group's bodies, one after another.
    pub fn displacement_from(&self, group: &Group, from: &[f64], to: &[f64]) -> Vec<f64> {
        let mut u = vec![0.0; group.coordinates.len()];
        let mut rest = from;
        for body in group.bodies.iter().map(|&b| &self.bodies[b]) {
            let (own, others) = rest.split_at(body.q.len());
            rest = others;
            if body.joint.is_none() || body.mimic.is_some() {
                continue;
            }
            let rates = tangent::displacement(body.motion.kind, own, &to[body.q.clone()]);
            for (v, rate) in body.v.clone().zip(rates) {
                let at = self.velocity_coordinates[v].and_then(|f| group.column(f.index));
                if let Some(at) = at {
                    u[at] = rate;
                }
            }
        }
        u
    }

    /// Updates the frames and mimics of a group's bodies from the positions in `q`.
    pub fn refill_group(&self, kinematics: &mut Kinematics, group: &Group) {
        kinematics.refill_bodies(self, &group.bodies);
    }

    /// Positions of a group's bodies, one after another: all positions that a motion of the group changes.
    pub fn group_positions(&self, group: &Group, q: &[f64]) -> Vec<f64> {
        let mut positions = Vec::new();
        self.group_positions_into(group, q, &mut positions);
        positions
    }

    /// Like [`group_positions`](Self::group_positions), into a reused vector.
    pub fn group_positions_into(&self, group: &Group, q: &[f64], positions: &mut Vec<f64>) {
        positions.clear();
        positions.reserve(group.coordinates.len() + group.bodies.len());
        group.bodies.iter().for_each(|&b| positions.extend_from_slice(&q[self.bodies[b].q.clone()]));
    }

    /// Restores positions saved by [`group_positions`](Self::group_positions), and the frames of the group's bodies.
    pub fn restore_group(&self, kinematics: &mut Kinematics, group: &Group, positions: &[f64]) {
        let mut rest = positions;
        for &b in &group.bodies {
            let range = self.bodies[b].q.clone();
            let (own, others) = rest.split_at(range.len());
            kinematics.q[range].copy_from_slice(own);
            rest = others;
        }
        self.refill_group(kinematics, group);
    }

    /// Copies the positions of a group's joints from `q`.
    pub fn set_group(&self, kinematics: &mut Kinematics, group: &Group, q: &[f64]) {
        for id in group.joints.iter().copied().flatten() {
            let range = self.joint_q[id.index()].clone();
            kinematics.q[range.clone()].copy_from_slice(&q[range]);
        }
        self.refill_group(kinematics, group);
    }
}
