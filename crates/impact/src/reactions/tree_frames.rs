//! Wrenches transmitted by the joints of the tree: motions from the root to the tips, then wrenches from the tips to the root.

use crate::reactions::force_elements::SpringForces;
use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{LocatedContact, Pose};
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_spatial::{Transform, Twist, Wrench, plane_basis};
use std::sync::Arc;

/// Frames and motion subspaces of the tree at a pose, with the parts that are the same at all poses of a system.
#[derive(Clone, Debug)]
pub(crate) struct TreeFrames {
    pub mechanism: Arc<Mechanism>,
    /// X_rl of each link.
    pub frames: Vec<Transform<f64>>,
    /// For each joint, in the axes of the child: two transverse directions and the axis as columns; the identity without an axis.
    pub axes: Vec<Matrix3<f64>>,
    /// True if the root link moves: its twist is the first six coordinates.
    pub is_floating: bool,
    /// Number of coordinates.
    pub coordinate_count: usize,
    /// For each joint: its first coordinate and its multiplier as a mimic; `None` for a locked joint.
    coordinates: Vec<Option<(usize, f64)>>,
    /// Armature for each velocity of all joints, kg·m² or kg.
    pub armature: Vec<f64>,
    /// For each velocity of all joints: force (N) or moment (N·m) of springs and dampers, positive if it resists a positive velocity.
    applied: Vec<f64>,
    /// For each end of a spring between points: link, and the wrench that the spring requires from the joints, in the link's axes.
    of_lines: Vec<(LinkId, Wrench<f64>)>,
    /// X_pc of each joint: child link in the parent link.
    steps: Vec<Transform<f64>>,
    /// Motion subspaces of all joints one after another, in the axes of the children.
    columns: Vec<Twist<f64>>,
    /// Index of the first column of each joint, and the number of all columns.
    first_column: Vec<usize>,
}

impl TreeFrames {
    pub fn new(pose: &Pose) -> Self {
        let mechanism = pose.mechanism();
        let of_coordinates = pose.coordinate_joints();
        let mut first = vec![None; mechanism.joints().len()];
        for (c, &(joint, k)) in of_coordinates.iter().enumerate() {
            if let (Some(joint), 0) = (joint, k) {
                first[joint.index()] = Some(c);
            }
        }
        let coordinate = |joint| {
            let mimic = mechanism.joint(joint).mimic();
            let (master, multiplier) = mimic.map_or((joint, 1.0), |m| (m.master, m.multiplier));
            first[master.index()].filter(|_| !pose.is_locked(joint)).map(|c| (c, multiplier))
        };
        let (mut armature, mut first_column) = (Vec::new(), vec![0]);
        for joint in mechanism.joint_ids() {
            armature.extend(pose.armature(joint));
            armature.resize(first_column[joint.index()] + mechanism.joint(joint).kind().dofs(), 0.0);
            first_column.push(armature.len());
        }
        let axes = mechanism.joints().iter().map(|joint| {
            if joint.kind().has_axis() { axes_along(joint.axis()) } else { Matrix3::identity() }
        });
        let mut tree = Self {
            frames: Vec::new(),
            axes: axes.collect(),
            is_floating: of_coordinates.first().is_some_and(|(joint, _)| joint.is_none()),
            coordinate_count: of_coordinates.len(),
            coordinates: mechanism.joint_ids().map(coordinate).collect(),
            applied: vec![0.0; armature.len()],
            armature,
            of_lines: Vec::new(),
            steps: Vec::new(),
            columns: Vec::new(),
            first_column,
            mechanism: Arc::clone(mechanism),
        };
        tree.update(pose);
        tree
    }

    /// Moves the frames to another pose of the same system.
    pub fn update(&mut self, pose: &Pose) {
        let mechanism = &self.mechanism;
        self.frames.clear();
        self.frames.extend(mechanism.link_ids().map(|link| pose.link_in_root(link)));
        self.steps.clear();
        self.steps.extend(mechanism.joint_ids().map(|joint| pose.joint_transform(joint)));
        self.columns.clear();
        for joint in mechanism.joint_ids() {
            pose.add_motion_subspace(joint, &mut self.columns);
        }
    }

    /// Sets the forces of springs, dampers and drives at the pose of the last update, with the velocities of all joints and the twist of the
    /// root.
    pub fn apply_springs(
        &mut self,
        pose: &Pose,
        springs: &SpringForces,
        velocities: &[f64],
        base: Twist<f64>,
    ) {
        self.applied.fill(0.0);
        self.of_lines.clear();
        let has_dampers =
            !springs.supports.is_empty() || springs.lines.iter().any(|spring| spring.damper.is_some());
        let twists = if has_dampers { self.link_twists(velocities, base) } else { Vec::new() };
        let velocity = |link: LinkId, point: &Vector3<f64>| {
            let twist = &twists[link.index()];
            self.frames[link.index()].vector(&(twist.linear + twist.angular.cross(point)))
        };
        for (support, start) in &springs.supports {
            let frame = &self.frames[support.link.index()];
            let direction = pose.base().inverse_vector(&support.direction);
            let displacement =
                support.direction.dot(&pose.base().point(&frame.point(&support.point))) - start;
            let rate = direction.dot(&velocity(support.link, &support.point));
            let balanced = if support.is_balanced { support.force } else { 0.0 };
            let load = balanced - support.force_at(displacement, rate);
            let load = frame.inverse_vector(&(direction * load));
            self.of_lines.push((support.link, Wrench::new(support.point.cross(&load), load)));
        }
        for spring in &springs.lines {
            let ends = &spring.ends;
            let [a, b] = ends.map(|(link, point)| self.frames[link.index()].point(&point));
            let length = (b - a).norm();
            // Points at the same place have no line.
            let line = if length > 0.0 { (b - a) / length } else { Vector3::zeros() };
            let mut push = spring.rate * (spring.free_length.unwrap_or(length) - length) + spring.drive;
            if let Some(damper) = &spring.damper {
                let [va, vb] = ends.map(|(link, point)| velocity(link, &point));
                push -= damper.force(line.dot(&(vb - va)));
            }
            for ((link, point), force) in ends.iter().zip([line * push, line * -push]) {
                let force = self.frames[link.index()].inverse_vector(&force);
                self.of_lines.push((*link, Wrench::new(point.cross(&force), force)));
            }
        }
        for spring in &springs.joints {
            let first = self.first_column(spring.joint);
            let second = spring.other.map(|other| (self.first_column(other), pose.joint(other)[0]));
            let position = pose.joint(spring.joint)[0] - second.map_or(0.0, |(_, position)| position);
            let rate = velocities[first] - second.map_or(0.0, |(column, _)| velocities[column]);
            let load =
                spring.stiffness * (position - spring.free_position) + spring.damping * rate - spring.drive;
            self.applied[first] += load;
            if let Some((column, _)) = second {
                self.applied[column] -= load;
            }
        }
    }

    /// Twist of each link, in its axes at its origin, from the velocities of all joints and the twist of the root.
    fn link_twists(&self, velocities: &[f64], base: Twist<f64>) -> Vec<Twist<f64>> {
        let mut twists = vec![base; self.frames.len()];
        for &link in self.mechanism.order() {
            let Some(joint) = self.mechanism.parent_joint(link) else { continue };
            let parent = self.mechanism.joint(joint).parent();
            let mut twist = self.steps[joint.index()].inverse_twist(&twists[parent.index()]);
            for (column, rate) in self.columns(joint).iter().zip(self.of_joint(joint, velocities)) {
                twist += *column * *rate;
            }
            twists[link.index()] = twist;
        }
        twists
    }

    /// Force (N) or moment (N·m) of springs and dampers at velocity `k` of a joint, positive if it resists a positive velocity.
    pub fn applied(&self, joint: JointId, k: usize) -> f64 {
        self.applied[self.first_column(joint) + k]
    }

    /// Velocities of all joints one after another, from the rates of the coordinates.
    pub fn joint_velocities(&self, u: &[f64], velocities: &mut Vec<f64>) {
        velocities.clear();
        velocities.resize(self.columns.len(), 0.0);
        for (joint, coordinate) in self.coordinates.iter().enumerate() {
            if let Some((c, multiplier)) = coordinate {
                let own = self.first_column[joint]..self.first_column[joint + 1];
                velocities[own].iter_mut().zip(&u[*c..]).for_each(|(to, rate)| *to = multiplier * rate);
            }
        }
    }

    /// Twist of the root link, in root axes at the root origin, from the rates of the coordinates.
    pub fn base_twist(&self, u: &[f64]) -> Twist<f64> {
        if !self.is_floating {
            return Twist::zero();
        }
        Twist::new(Vector3::new(u[0], u[1], u[2]), Vector3::new(u[3], u[4], u[5]))
    }

    /// Part of `velocities` (all joints one after another) that belongs to a joint.
    pub fn of_joint<'a>(&self, joint: JointId, velocities: &'a [f64]) -> &'a [f64] {
        &velocities[self.first_column[joint.index()]..self.first_column[joint.index() + 1]]
    }

    /// Generalised forces that the constraints must supply, over the coordinates, with gears, springs and dampers: M Δq̇ + jᵀ for
    /// [`impulse_loads`](Self::impulse_loads), h + jᵀF − Q + M u̇ for [`motion_loads`](Self::motion_loads). `change`: changes of the
    /// velocities, or accelerations, of all joints. Overwrites `forces`.
    pub fn generalised_loads(&self, loads: &[Wrench<f64>], change: &[f64], forces: &mut Vec<f64>) {
        forces.clear();
        forces.resize(self.coordinate_count, 0.0);
        if self.is_floating {
            let root = &loads[self.mechanism.root().index()];
            forces.iter_mut().zip(root.moment.iter().chain(&root.force)).for_each(|(to, from)| *to = *from);
        }
        for joint in self.mechanism.joint_ids() {
            let Some((c, multiplier)) = self.coordinates[joint.index()] else { continue };
            let load = &loads[self.mechanism.joint(joint).child().index()];
            let first = self.first_column(joint);
            for (k, column) in self.columns(joint).iter().enumerate() {
                let gear = self.armature[first + k] * change[first + k];
                forces[c + k] += multiplier * (load.power(column) + gear + self.applied[first + k]);
            }
        }
    }

    /// Motion subspace of a joint, in the axes of the child.
    pub fn columns(&self, joint: JointId) -> &[Twist<f64>] {
        &self.columns[self.first_column(joint)..self.first_column[joint.index() + 1]]
    }

    /// Index of the first velocity of a joint among the velocities of all joints.
    pub fn first_column(&self, joint: JointId) -> usize {
        self.first_column[joint.index()]
    }

    /// Wrench on each link from its parent joint (from the ground, for the root), in the link's axes at its origin, without the
    /// constraints of loops and holds. `change`: changes of the velocities of all joints; `base`: change of the twist of the root (root
    /// axes, root origin). A unit impulse acts at the contact: −n̂ on the contact link, n̂ on the other link. Overwrites `twists` (of all
    /// links) and `loads`.
    pub fn impulse_loads(
        &self,
        contact: &LocatedContact,
        change: &[f64],
        base: Twist<f64>,
        twists: &mut Vec<Twist<f64>>,
        loads: &mut Vec<Wrench<f64>>,
    ) {
        twists.resize(self.frames.len(), Twist::zero());
        loads.resize(self.frames.len(), Wrench::zero());
        for &link in self.mechanism.order() {
            let i = link.index();
            twists[i] = match self.mechanism.parent_joint(link) {
                None => base,
                Some(joint) => {
                    let parent = self.mechanism.joint(joint).parent();
                    let mut twist = self.steps[joint.index()].inverse_twist(&twists[parent.index()]);
                    for (column, rate) in self.columns(joint).iter().zip(self.of_joint(joint, change)) {
                        twist += *column * *rate;
                    }
                    twist
                }
            };
            loads[i] = self.mechanism.link(link).inertia().momentum(&twists[i]);
        }
        self.add_contact(contact, 1.0, loads);
    }

    /// Wrenches (N, N·m) on each link from its parent joint, as by [`impulse_loads`](Self::impulse_loads), in a motion. `rates`,
    /// `accelerations`: of all joints, and of the root; `gravity`: m/s², root axes; `force`: contact force F, N, −F n̂ on the contact link
    /// and F n̂ on the other link.
    ///
    /// a_i = X a_p + S q̈ + Ṡ q̇ + V × S q̇, f_i = I a + V ×* I V, with a = −g for the ground. Featherstone 2008, table 5.1.
    pub fn motion_loads(
        &self,
        pose: &Pose,
        contact: &LocatedContact,
        force: f64,
        rates: (&[f64], Twist<f64>),
        accelerations: (&[f64], Twist<f64>),
        gravity: &Vector3<f64>,
    ) -> Vec<Wrench<f64>> {
        let mut motions = vec![(Twist::zero(), Twist::zero()); self.frames.len()];
        let mut loads = vec![Wrench::zero(); self.frames.len()];
        for &link in self.mechanism.order() {
            let i = link.index();
            motions[i] = match self.mechanism.parent_joint(link) {
                None => (rates.1, accelerations.1 - Twist::new(Vector3::zeros(), *gravity)),
                Some(joint) => {
                    let (v, a) = motions[self.mechanism.joint(joint).parent().index()];
                    let (step, own_rates) = (&self.steps[joint.index()], self.of_joint(joint, rates.0));
                    let columns = self.columns(joint);
                    let sum = |values: &[f64]| {
                        columns.iter().zip(values).fold(Twist::zero(), |sum, (s, x)| sum + *s * *x)
                    };
                    let own = sum(own_rates);
                    let v = step.inverse_twist(&v) + own;
                    let bias = v.cross_motion(&own) + pose.motion_subspace_rate(joint, own_rates);
                    (v, step.inverse_twist(&a) + sum(self.of_joint(joint, accelerations.0)) + bias)
                }
            };
            let (v, a) = &motions[i];
            let inertia = self.mechanism.link(link).inertia();
            loads[i] = inertia.momentum(a) + v.cross_force(&inertia.momentum(v));
        }
        for (link, wrench) in &self.of_lines {
            loads[link.index()] += *wrench;
        }
        self.add_contact(contact, force, &mut loads);
        loads
    }

    /// Adds the contact and sums the wrenches over the subtrees.
    fn add_contact(&self, contact: &LocatedContact, force: f64, loads: &mut [Wrench<f64>]) {
        let on = contact.link.index();
        let wrench = contact.wrench_link() * force;
        loads[on] += wrench;
        if let Some(against) = contact.against {
            let x_ao = self.frames[against.index()].inverse() * self.frames[on];
            loads[against.index()] -= x_ao.wrench(&wrench);
        }
        for &link in self.mechanism.order().iter().rev() {
            if let Some(joint) = self.mechanism.parent_joint(link) {
                let parent = self.mechanism.joint(joint).parent().index();
                let in_parent = self.steps[joint.index()].wrench(&loads[link.index()]);
                loads[parent] += in_parent;
            }
        }
    }

    /// Converts a wrench (root axes, about `point` in the root frame) to the axes and the origin of a link.
    pub fn in_link(&self, link: LinkId, wrench: &Wrench<f64>, point: &Vector3<f64>) -> Wrench<f64> {
        let frame = &self.frames[link.index()];
        let (arm, force) = (frame.inverse_point(point), frame.inverse_vector(&wrench.force));
        Wrench::new(frame.inverse_vector(&wrench.moment) + arm.cross(&force), force)
    }

    /// Links from `link` to the root, including both; empty for the ground.
    pub fn path_to_root(&self, link: Option<LinkId>) -> impl Iterator<Item = LinkId> {
        let parent = |link: &LinkId| {
            let joint = self.mechanism.parent_joint(*link);
            joint.map(|j| self.mechanism.joint(j).parent())
        };
        std::iter::successors(link, parent)
    }
}

/// Two transverse directions and the axis, as columns. A zero vector gives the unit matrix.
pub(crate) fn axes_along(axis: &Vector3<f64>) -> Matrix3<f64> {
    if axis.norm() == 0.0 {
        return Matrix3::identity();
    }
    let axis = axis.normalize();
    let (e1, e2) = plane_basis(&axis);
    Matrix3::from_columns(&[e1, e2, axis])
}
