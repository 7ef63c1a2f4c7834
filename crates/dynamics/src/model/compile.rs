//! Compilation of a mechanism and its conditions to the model: bodies, coordinates, then constraints.

use super::Model;
use super::body::{Body, Coordinate, LinkFrame, MimicPosition, VelocityCoordinate};
use crate::model::conditions::{Base, Conditions, ConditionsError};
use crate::model::joint_motion::JointMotion;
use crate::model::tangent;
use percuss_mechanism::{LinkId, Mechanism};
use percuss_spatial::Transform;
use std::ops::Range;
use std::sync::Arc;

impl Model {
    /// Compiles a mechanism with the conditions of an analysis.
    ///
    /// # Errors
    /// [`ConditionsError`]: an unknown joint or link, a condition given twice, an invalid armature or held contact.
    pub fn compile(mechanism: &Arc<Mechanism>, conditions: &Conditions) -> Result<Self, ConditionsError> {
        let armatures = conditions.resolve_armatures(mechanism)?;
        let requested = conditions.resolve_locks(mechanism)?;
        let (locked, redundant_locks) = effective_locks(mechanism, &requested);
        let joint_q: Vec<Range<usize>> = mechanism.position_ranges().collect();
        let positions = joint_q.last().map_or(0, |range| range.end);
        let ground = LinkFrame { body: None, frame: Transform::identity() };
        let mut model = Self {
            mechanism: Arc::clone(mechanism),
            base: conditions.base,
            bodies: Vec::new(),
            link_frames: vec![ground; mechanism.links().len()],
            velocity_coordinates: Vec::new(),
            locked,
            own_locks: requested,
            joint_q,
            body_of_joint: vec![None; mechanism.joints().len()],
            positions,
            coordinates: Vec::new(),
            redundant_locks,
            has_active_mimics: false,
            closures: Vec::new(),
            couplings: Vec::new(),
            holds: Vec::new(),
            groups: Vec::new(),
            clusters: Vec::new(),
            cluster_of: Vec::new(),
        };
        for &link in mechanism.order() {
            model.add_link(link, &armatures, conditions.keep_fixed_joints);
        }
        model.number_coordinates();
        let holds = conditions.resolve_holds(mechanism)?;
        model.compile_constraints(&holds);
        model.compile_groups();
        model.compile_clusters();
        Ok(model)
    }

    /// Adds a body for the link, or merges the link into the body to which a fixed joint connects it.
    fn add_link(&mut self, link: LinkId, armatures: &[Vec<f64>], keep_fixed_joints: bool) {
        let mechanism = Arc::clone(&self.mechanism);
        let inertia = *mechanism.link(link).inertia();
        let Some(id) = mechanism.parent_joint(link) else {
            if self.base == Base::Floating {
                // The base has no stored position: all poses are relative to the root link.
                self.link_frames[link.index()].body = Some(0);
                self.bodies.push(Body {
                    parent: None,
                    joint: None,
                    motion: JointMotion::floating(),
                    origin: Transform::identity(),
                    inertia,
                    q: 0..0,
                    v: 0..6,
                    armature: vec![0.0; 6],
                    mimic: None,
                });
                self.velocity_coordinates.extend([None; 6]);
            }
            return;
        };
        let joint = mechanism.joint(id);
        let LinkFrame { body: parent, frame } = self.link_frames[joint.parent().index()].clone();
        let origin = frame * *joint.origin();
        if joint.kind().dofs() == 0 && !keep_fixed_joints {
            if let Some(body) = parent {
                self.bodies[body].inertia += origin.inertia(&inertia);
            }
            self.link_frames[link.index()] = LinkFrame { body: parent, frame: origin };
            return;
        }
        let first = self.velocity_coordinates.len();
        let dofs = if self.locked[id.index()] { 0 } else { joint.kind().dofs() };
        self.velocity_coordinates.extend(std::iter::repeat_n(None, dofs));
        self.link_frames[link.index()] =
            LinkFrame { body: Some(self.bodies.len()), frame: Transform::identity() };
        self.body_of_joint[id.index()] = Some(self.bodies.len());
        let mimic = joint.mimic().map(|mimic| MimicPosition {
            master: self.joint_q[mimic.master.index()].start,
            multiplier: mimic.multiplier,
            offset: mimic.offset,
        });
        self.bodies.push(Body {
            parent,
            joint: Some(id),
            motion: JointMotion::of(joint),
            origin,
            inertia,
            q: self.joint_q[id.index()].clone(),
            v: first..first + dofs,
            armature: armatures[id.index()].clone(),
            mimic,
        });
    }

    /// Numbers the coordinates of masters in tree order, then assigns the mimics to these coordinates.
    fn number_coordinates(&mut self) {
        let mechanism = Arc::clone(&self.mechanism);
        let mut first_of = vec![None; mechanism.joints().len()];
        let mut depth = vec![0usize; self.bodies.len()];
        for (i, body) in self.bodies.iter().enumerate() {
            depth[i] = body.parent.map_or(0, |p| depth[p] + 1);
            if body.mimic.is_some() {
                continue;
            }
            if let Some(id) = body.joint {
                first_of[id.index()] = Some(self.coordinates.len());
            }
            let joint = body.joint.map(|id| mechanism.joint(id));
            for (component, v) in body.v.clone().enumerate() {
                self.velocity_coordinates[v] =
                    Some(VelocityCoordinate { index: self.coordinates.len(), multiplier: 1.0 });
                self.coordinates.push(Coordinate {
                    joint: body.joint,
                    component,
                    turns: body.motion.turns(component),
                    independent: joint.and_then(|j| j.independent()),
                    actuated: joint.is_some_and(|j| j.kind().dofs() == 1 && j.limits().is_some()),
                    depth: depth[i],
                });
            }
        }
        for body in self.bodies.iter().filter(|b| b.mimic.is_some() && !b.v.is_empty()) {
            let mimic = body.joint.and_then(|id| mechanism.joint(id).mimic());
            let Some(mimic) = mimic else { continue };
            self.has_active_mimics = true;
            for v in body.v.clone() {
                self.velocity_coordinates[v] = first_of[mimic.master.index()]
                    .map(|index| VelocityCoordinate { index, multiplier: mimic.multiplier });
            }
        }
    }
}

/// Frames of the bodies in the root link, with all joints at 0.
pub(super) struct ZeroFrames {
    pub frames: Vec<Transform<f64>>,
}

impl ZeroFrames {
    /// Computes the frames; joints that mimic are at their offset.
    pub fn of(model: &Model) -> Self {
        let mut frames: Vec<Transform<f64>> = Vec::with_capacity(model.bodies.len());
        for body in &model.bodies {
            let mut q = vec![0.0; body.motion.kind.positions()];
            tangent::zero_position(body.motion.kind, &mut q);
            if let Some(mimic) = body.mimic {
                q[0] = mimic.offset;
            }
            let step = body.origin * body.motion.transform(&q);
            frames.push(body.parent.map_or(step, |p| frames[p] * step));
        }
        Self { frames }
    }

    /// X_rf of a frame on a body or on the ground.
    pub fn frame_of(&self, on: &LinkFrame) -> Transform<f64> {
        on.body.map_or(on.frame, |body| self.frames[body] * on.frame)
    }
}

/// Returns the lock flag of every joint, and the number of redundant lock rows. A lock on a mimic also locks its
/// master and all mimics of the master.
fn effective_locks(mechanism: &Mechanism, requested: &[bool]) -> (Vec<bool>, usize) {
    let mut master_locked = vec![false; requested.len()];
    let (mut rows, mut rank) = (0, 0);
    for (i, joint) in mechanism.joints().iter().enumerate().filter(|(i, _)| requested[*i]) {
        rows += joint.kind().dofs();
        let holds = match joint.mimic() {
            None => Some(i),
            Some(mimic) => (mimic.multiplier != 0.0).then(|| mimic.master.index()),
        };
        if let Some(master) = holds
            && !std::mem::replace(&mut master_locked[master], true)
        {
            rank += joint.kind().dofs();
        }
    }
    let still = |(i, joint): (usize, &percuss_mechanism::Joint)| match joint.mimic() {
        None => master_locked[i],
        Some(mimic) => master_locked[mimic.master.index()] || mimic.multiplier == 0.0,
    };
    (mechanism.joints().iter().enumerate().map(still).collect(), rows - rank)
}
