//! Compilation of a tree for the recursion in the bodies' own axes. The z axis of each frame is the joint axis, so
//! that a pivot is an entry of the inertia. The transform from each frame to its parent has the least number of
//! rotations about and shifts along coordinate axes (Denavit and Hartenberg 1955).

use super::cluster_joint::ClusterJoint;
use super::workspace::{EnergyShare, Offsets, Places, Sizes, layout};
use crate::mechanism::{Body, JointMotion, Mechanism};
use crate::tolerances::{NO_ACROSS, NO_TURN, PARALLEL_AXES, SLIDE_REACH};
use nalgebra::{Matrix3, Vector3};
use percuss_spatial::lanes::{Lanes, Single};
use percuss_spatial::{PackedInertia, PackedWrench, Scalar, Transform};
use std::ops::Range;

/// Motion of a body relative to its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TreeMotion {
    /// Rotation about z by a position.
    Turn { q: usize },
    /// Translation along z.
    Slide { q: usize },
    /// Translation along x and y of the joint frame, and rotation about z.
    Planar { q: usize },
    /// Rotation by a unit quaternion.
    Ball { q: usize },
    /// Translation by three positions, and rotation by a unit quaternion.
    Floating { q: usize },
    /// Floating base, at the root.
    Base,
}

impl TreeMotion {
    /// Component of the twist for each velocity, angular part first.
    fn components(&self) -> &'static [usize] {
        match self {
            Self::Turn { .. } => &[2],
            Self::Slide { .. } => &[5],
            Self::Planar { .. } => &[3, 4, 2],
            Self::Ball { .. } => &[0, 1, 2],
            Self::Floating { .. } | Self::Base => &[0, 1, 2, 3, 4, 5],
        }
    }

    /// Upper bound (m) of the displacement by the joint's own translations, if each position is at most `size` (m).
    fn travel(&self, size: f64) -> f64 {
        match *self {
            Self::Turn { .. } | Self::Ball { .. } | Self::Base => 0.0,
            Self::Slide { .. } => size,
            Self::Planar { .. } => 2.0 * size,
            Self::Floating { .. } => 3.0 * size,
        }
    }
}

/// Rotation by a constant angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn {
    pub cos: f64,
    pub sin: f64,
}

impl Default for Turn {
    fn default() -> Self {
        Self::NONE
    }
}

/// Transform from a body's frame to its parent's, after the joint's own motion: rotation about z, shift along z,
/// rotation about x, shifts along x, y, z, rotation about z, in this order. Identity parts are omitted.
#[derive(Clone, Debug, Default)]
pub(super) struct ParentTransform {
    pub turn_z: Option<Turn>,
    pub along_z: f64,
    /// Rotation about x.
    pub tilt: Turn,
    pub shift: [f64; 3],
    pub last_turn_z: Option<Turn>,
    /// Largest distance between the origins, m, without the travel of a slide.
    pub length: f64,
    pub shape: Shape,
}

/// Shape of a transform, for transforms that are applied in one step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Shape {
    /// Shift along z, rotation about x, shift along x.
    Skew,
    /// Skew with a right angle.
    Right,
    /// Shift along z and shift along x: parallel axes.
    Parallel,
    /// Any transform.
    #[default]
    General,
}

/// Body with its joint.
#[derive(Clone, Debug)]
pub(super) struct TreeStep {
    pub parent: Option<usize>,
    pub motion: TreeMotion,
    /// True for the free components of the twist, angular part first; all false if the joint is locked.
    pub free: [bool; 6],
    /// True if the body has children with a remaining inertia.
    pub has_child_inertia: bool,
    /// Armature along these components.
    pub armature: [f64; 6],
    pub own: Box<Own>,
    pub parent_transform: ParentTransform,
    /// Largest distance of the origin from the parent's origin, with travels up to [`Plan::travel`], m.
    pub reach: f64,
    /// Largest moment of inertia (kg·m²) and mass (kg) of the rigid subtree about the body's origin, over all joint
    /// positions.
    pub moment: f64,
    pub mass: f64,
    /// Bounds by the kinetic energy of the body itself.
    pub share: EnergyShare,
    /// Constant elimination of a leaf.
    pub leaf: Option<Box<LeafElimination>>,
    /// Position of a joint that mimics another: multiplier and offset of the position with the index in `motion`.
    pub mimic: Option<(f64, f64)>,
    /// Joint in a cluster of mimics.
    pub cluster_joint: Option<Box<ClusterJoint>>,
}

/// Rarely read data of a body, kept apart: long chains are faster with compact hot data.
#[derive(Clone, Debug)]
pub(super) struct Own {
    pub inertia: PackedInertia<f64>,
    /// X_bo: the frame used here (o) in the body frame.
    pub frame: Transform<f64>,
}

impl TreeStep {
    /// Shape of the transform if the joint is a hinge.
    fn hinge_shape(&self) -> Option<Shape> {
        (self.free == [false, false, true, false, false, false]
            && matches!(self.motion, TreeMotion::Turn { .. }))
        .then_some(self.parent_transform.shape)
    }

    /// What the step needs in the workspace.
    fn places(&self) -> Places {
        Places { parent: self.parent.filter(|_| !self.transmits_nothing()), is_light: self.share.is_light() }
    }

    /// True for six freedoms without armature: the remaining inertia is exactly zero.
    pub fn transmits_nothing(&self) -> bool {
        self.free == [true; 6] && self.armature == [0.0; 6]
    }

    /// Position of a joint with one degree of freedom, from the position that it reads.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn own_position<T: Lanes>(&self, read: T) -> T {
        match self.mimic {
            // Two roundings, as in the frames of a pose: far from zero, one rounding less is another angle.
            Some((multiplier, offset)) => T::from_f64(multiplier) * read + T::from_f64(offset),
            None => read,
        }
    }

    /// Positions that the joint reads.
    pub fn positions(&self) -> Range<usize> {
        match self.motion {
            TreeMotion::Turn { q } | TreeMotion::Slide { q } => q..q + 1,
            TreeMotion::Planar { q } => q..q + 3,
            TreeMotion::Ball { q } => q..q + 4,
            TreeMotion::Floating { q } => q..q + 7,
            TreeMotion::Base => 0..0,
        }
    }
}

/// Elimination of a leaf: constant in its own axes.
#[derive(Clone, Debug)]
pub(super) struct LeafElimination {
    pub left: PackedInertia<f64>,
    pub u: PackedWrench<f64>,
    pub d: f64,
    pub inverse_d: f64,
    pub armature_part: f64,
    /// Loss of the pivot: size of its inertia divided by the pivot.
    pub loss: f64,
    /// Sizes of the terms of the remaining inertia.
    pub sizes: Sizes<f64>,
}

/// Remaining inertia of a prismatic leaf in the parent's frame: I₀ + q I₁ + q² I₂.
#[derive(Clone, Debug)]
pub(super) struct PrismaticLeaf {
    /// I₀, plus the parent's own inertia if this is the first child.
    pub constant: PackedInertia<f64>,
    /// I₁; its linear part is zero.
    pub slope: PackedInertia<f64>,
    /// Angular part of I₂; the other parts are zero.
    pub bend: [f64; 6],
    /// See [`Leaf`].
    pub loss: f64,
    /// See [`Leaf`].
    pub sizes: Sizes<f64>,
}

/// Form of a step: consecutive steps of one form run without a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StepForm {
    /// Hinge on the ground with children.
    GroundHinge,
    /// Hinge with a transform other than [`Shape::General`].
    Hinge(HingeForm),
    /// Prismatic leaf.
    PrismaticLeaf,
    /// Joint in a cluster of mimics.
    OfCluster,
    /// Any other joint.
    General,
}

/// Parameters of the compiled hinge code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct HingeForm {
    /// Shape of the transform: skew, right, parallel.
    pub shape: Shape,
    /// True without armature: the remaining inertia about the axis is zero.
    pub bare: bool,
    /// True for a leaf.
    pub leaf: bool,
    /// True if the parent is a hinge on the ground: only one entry of the remaining inertia is needed.
    pub is_parent_on_ground: bool,
}

/// Step with its position in the sequence.
#[derive(Clone, Debug)]
pub(super) struct ScheduledStep {
    /// Number of its body.
    pub number: usize,
    pub step: TreeStep,
    pub offsets: Offsets,
    /// Own inertia of the parent.
    pub parent_inertia: PackedInertia<f64>,
    /// True for the first child of the parent: it starts the parent's sum.
    pub is_first: bool,
    /// The body itself, or its nearest ancestor, on the ground or with a zero remaining inertia: bodies outside its subtree do not affect this
    /// step.
    pub subtree_root: usize,
    pub form: StepForm,
    pub prismatic_leaf: Option<Box<PrismaticLeaf>>,
}

impl ScheduledStep {
    /// True for a body on the ground, or that transmits no inertia: the root of an independent subtree.
    #[inline]
    pub fn is_root(&self) -> bool {
        self.number == self.subtree_root
    }

    /// Adds the sizes of the terms of the remaining inertia to those of the parent, if it has one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_sizes_to_parent<T: Lanes>(&self, sizes: Sizes<T>, scratch: &mut [f64]) {
        if self.step.parent.is_some() && !self.step.transmits_nothing() {
            let slot = self.offsets.parent_inertia::<T>(scratch);
            sizes.add_to_parent(self.step.reach, self.is_first, slot);
        }
    }

    /// Index of its cluster.
    pub fn cluster(&self) -> Option<usize> {
        self.step.cluster_joint.as_ref().map(|joint| joint.cluster)
    }
}

/// Bodies of a tree in the order of the model.
#[derive(Clone, Debug)]
pub(super) struct TreePlan {
    pub steps: Vec<TreeStep>,
    /// Travels of slides (m) in the bounds of sizes. For larger travels, sizes grow at most with the square.
    pub travel: f64,
}

impl TreePlan {
    /// Compiles a tree of joints: frames, transforms, inertias and bounds of sizes of all bodies. `None` if the mechanism has
    /// loops or held contacts, or a negative mass.
    pub fn of(mechanism: &Mechanism) -> Option<Self> {
        let bodies = &mechanism.bodies;
        let moves = |body: &Body| body.motion != JointMotion::Fixed;
        if bodies.is_empty() || !bodies.iter().all(moves) || !mechanism.is_positive() {
            return None;
        }
        let length = mechanism.characteristic_length;
        let travel = SLIDE_REACH * if length > 0.0 { length } else { 1.0 };
        let mut frames: Vec<Option<Transform<f64>>> = vec![None; bodies.len()];
        let mut steps: Vec<TreeStep> = Vec::with_capacity(bodies.len());
        // Parents before children: the first child may fix the free parts of its parent's frame.
        for (i, body) in bodies.iter().enumerate() {
            let frame = *frames[i].get_or_insert_with(|| joint_aligned_frame(bodies, i));
            let carrier = body.parent.map_or(Transform::identity(), |p| steps[p].own.frame);
            let k = carrier.inverse() * body.origin * frame;
            let transform = ParentTransform::of(&k);
            let motion = motion_of(body);
            let reach = transform.length + motion.travel(travel);
            let (mut free, mut armature) = ([false; 6], [0.0; 6]);
            for (&component, own) in motion.components().iter().zip(&body.velocities) {
                (free[component], armature[component]) = (true, own.armature);
            }
            if body.floats {
                (free, armature) = ([true; 6], [0.0; 6]);
            }
            steps.push(TreeStep {
                parent: body.parent,
                motion,
                free,
                has_child_inertia: false,
                armature,
                own: Box::new(Own {
                    inertia: PackedInertia::of_body(&frame.inverse().inertia(&body.inertia)),
                    frame,
                }),
                parent_transform: transform,
                reach,
                moment: 0.0,
                mass: 0.0,
                share: EnergyShare::default(),
                leaf: None,
                mimic: body.mimic.map(|mimic| (mimic.multiplier, mimic.offset)),
                cluster_joint: None,
            });
        }
        let mut plan = Self { steps, travel };
        plan.fill_sizes();
        Some(plan)
    }

    /// All steps, children before parents, and the number of values of their workspace per lane.
    pub fn into_schedule(self) -> (Vec<ScheduledStep>, usize) {
        let mut tops: Vec<usize> = Vec::with_capacity(self.steps.len());
        for (i, step) in self.steps.iter().enumerate() {
            tops.push(step.parent.filter(|_| !step.transmits_nothing()).map_or(i, |p| tops[p]));
        }
        let (offsets, numbers) = layout(&self.steps.iter().map(TreeStep::places).collect::<Vec<_>>());
        let mut met = vec![false; self.steps.len()];
        let place = |number: usize| {
            let step = &self.steps[number];
            ScheduledStep {
                number,
                offsets: offsets[number],
                parent_inertia: step.parent.map_or(step.own.inertia, |p| self.steps[p].own.inertia),
                is_first: step
                    .parent
                    .filter(|_| !step.transmits_nothing())
                    .is_some_and(|p| !std::mem::replace(&mut met[p], true)),
                subtree_root: tops[number],
                form: self.form(step),
                prismatic_leaf: None,
                step: step.clone(),
            }
        };
        ((0..self.steps.len()).rev().map(place).collect(), numbers)
    }

    /// Form of a step: the compiled code that eliminates its joint.
    fn form(&self, step: &TreeStep) -> StepForm {
        if step.cluster_joint.is_some() {
            return StepForm::OfCluster;
        }
        let Some(parent) = step.parent else {
            return if step.hinge_shape().is_some() && step.leaf.is_none() {
                StepForm::GroundHinge
            } else {
                StepForm::General
            };
        };
        let Some(shape) = step.hinge_shape().filter(|shape| *shape != Shape::General) else {
            return StepForm::General;
        };
        let above = &self.steps[parent];
        let next_to_last = above.parent.is_none() && above.hinge_shape().is_some();
        let (bare, leaf) = (step.armature[2] == 0.0, step.leaf.is_some());
        StepForm::Hinge(HingeForm { shape, bare, leaf, is_parent_on_ground: next_to_last })
    }

    /// Upper bounds of the moment (half the trace, kg·m²) and mass (kg) of every subtree, over all joint positions. A step that
    /// transmits nothing adds nothing to its parent.
    fn fill_sizes(&mut self) {
        let mut first = vec![0.0; self.steps.len()];
        let mut carried = vec![[0.0; 2]; self.steps.len()];
        for i in (0..self.steps.len()).rev() {
            let step = &mut self.steps[i];
            let (own, h) = (&step.own.inertia, &step.own.inertia.coupling);
            step.moment += (own.angular[0] + own.angular[3] + own.angular[5]) / 2.0;
            step.mass += own.linear[0];
            first[i] += Vector3::new(h[1][2], h[2][0], h[0][1]).norm();
            let (moment, mass, h, r) = (step.moment, step.mass, first[i], step.reach);
            step.share = EnergyShare::of(&step.own.inertia, [moment + r * r * mass, mass], carried[i]);
            let (lets_go, is_light) = (step.transmits_nothing(), step.share.is_light());
            if let Some(parent) = step.parent.filter(|_| !lets_go) {
                let about_parent = moment + r * (2.0 * h + r * mass);
                if !is_light {
                    carried[parent][0] += about_parent;
                    carried[parent][1] += mass;
                }
                self.steps[parent].moment += about_parent;
                self.steps[parent].mass += mass;
                first[parent] += h + r * mass;
            }
        }
    }

    /// Marks the steps that receive inertia from children, and eliminates the others in advance where the result is constant.
    pub fn fill_leaves(&mut self) {
        for i in 0..self.steps.len() {
            if let Some(parent) = self.steps[i].parent.filter(|_| !self.steps[i].transmits_nothing()) {
                self.steps[parent].has_child_inertia = true;
            }
        }
        let is_leaf = |step: &&mut TreeStep| !step.has_child_inertia && step.free != [false; 6];
        for step in self.steps.iter_mut().filter(is_leaf).filter(|step| !step.transmits_nothing()) {
            step.leaf = LeafElimination::of(step).map(Box::new);
        }
    }
}

impl LeafElimination {
    /// Elimination of the joint of a leaf. `None` unless the joint has one degree of freedom.
    fn of(step: &TreeStep) -> Option<Self> {
        type One = Single;
        let value = One::number;
        let mut left: PackedInertia<One> = step.own.inertia.cast();
        let pivot = match step.motion {
            TreeMotion::Turn { .. } => left.turn_pivot::<2>(One::from_f64(step.armature[2])),
            TreeMotion::Slide { .. } => left.slide_pivot::<2>(One::from_f64(step.armature[5])),
            TreeMotion::Planar { .. }
            | TreeMotion::Ball { .. }
            | TreeMotion::Floating { .. }
            | TreeMotion::Base => {
                return None;
            }
        };
        let turns = matches!(step.motion, TreeMotion::Turn { .. });
        let sizes = Sizes::of(&left, false, &[]);
        let size = value(if turns { sizes.moment } else { sizes.mass });
        // A body without mass leaves a zero inertia and no loss. Its own m̄ would be NaN.
        let is_massless = size == 0.0 && value(pivot.d) == 0.0;
        let loss = if is_massless { 1.0 } else { size * value(pivot.inverse_d).abs() };
        let sizes = sizes.amplified(One::from_f64(loss));
        let over_d = pivot.u.scaled(pivot.inverse_d);
        match turns {
            _ if is_massless => {}
            true => left.eliminate_turn::<2>(&pivot, &over_d),
            false => left.eliminate_slide::<2>(&pivot, &over_d),
        }
        let wrench =
            |w: &PackedWrench<One>| PackedWrench { moment: w.moment.map(value), force: w.force.map(value) };
        Some(Self {
            left: left.plain(),
            u: wrench(&pivot.u),
            d: value(pivot.d),
            inverse_d: value(pivot.inverse_d),
            loss,
            sizes: Sizes { moment: value(sizes.moment), mass: value(sizes.mass) },
            armature_part: value(pivot.armature_part),
        })
    }
}

/// Motion of the joint of a body, with the index of its first position.
fn motion_of(body: &Body) -> TreeMotion {
    let q = body.mimic.map_or(body.q, |mimic| mimic.q);
    match body.motion {
        JointMotion::Base => TreeMotion::Base,
        // Fixed joints are merged into their parent and have no entry here.
        JointMotion::Revolute | JointMotion::Fixed => TreeMotion::Turn { q },
        JointMotion::Prismatic => TreeMotion::Slide { q },
        JointMotion::Planar => TreeMotion::Planar { q },
        JointMotion::Spherical => TreeMotion::Ball { q },
        JointMotion::Floating => TreeMotion::Floating { q },
    }
}

/// Frame of a body: z along its joint axis; x and the origin follow from the axis of its first child, as far as the
/// joint leaves them free.
fn joint_aligned_frame(bodies: &[Body], i: usize) -> Transform<f64> {
    let body = &bodies[i];
    let Some(z) = axis_of(body) else { return Transform::identity() };
    if body.motion == JointMotion::Planar {
        let (x, y) = percuss_spatial::plane_basis(&z);
        return Transform::new(Matrix3::from_columns(&[x, y, z]), Vector3::zeros());
    }
    let child = bodies[i + 1..].iter().find(|child| child.parent == Some(i));
    let line =
        child.and_then(|child| Some((child.origin.vector(&axis_of(child)?), child.origin.translation)));
    let (x, origin) = match line {
        Some((direction, point)) => common_normal(&z, &direction, &point),
        None => (None, Vector3::zeros()),
    };
    let x = x.unwrap_or_else(|| percuss_spatial::plane_basis(&z).0);
    Transform::new(Matrix3::from_columns(&[x, z.cross(&x), z]), origin)
}

fn axis_of(body: &Body) -> Option<Vector3<f64>> {
    (!matches!(body.motion, JointMotion::Floating | JointMotion::Base | JointMotion::Spherical))
        .then_some(body.axis)
}

/// Direction of the common normal of the z axis and another line, and its foot on the z axis.
fn common_normal(
    z: &Vector3<f64>,
    direction: &Vector3<f64>,
    point: &Vector3<f64>,
) -> (Option<Vector3<f64>>, Vector3<f64>) {
    let normal = z.cross(direction);
    let sine = normal.norm();
    let across = point - z * z.dot(point);
    if sine > PARALLEL_AXES {
        let x = normal / sine;
        // point + s direction − t z is along x.
        let in_plane = z.cross(&x);
        let s = -point.dot(&in_plane) / direction.dot(&in_plane);
        return (Some(x), z * z.dot(&(point + direction * s)));
    }
    let length = across.norm();
    // The difference is orthogonal to z only within the rounding of the point, so its component along z is removed
    // again.
    let x = (length > NO_ACROSS * point.norm()).then(|| across - z * z.dot(&across));
    (x.map(|x| x.normalize()), z * z.dot(point))
}

impl ParentTransform {
    /// Divides the transform X_po with the joint at 0 into rotations about and shifts along coordinate axes.
    fn of(k: &Transform<f64>) -> Self {
        let (r, p) = (&k.rotation, &k.translation);
        // R = Rz(φ₁) Rx(α) Rz(φ₂).
        let sine = r[(0, 2)].hypot(r[(1, 2)]);
        let parallel = sine <= NO_TURN;
        let first = if parallel { Turn::NONE } else { Turn::of(-r[(1, 2)], r[(0, 2)]) };
        // Rows of Rz(−φ₁) R: the first is (cos φ₂, −sin φ₂, 0).
        let second = Turn::of(
            first.cos * r[(0, 0)] + first.sin * r[(1, 0)],
            -(first.cos * r[(0, 1)] + first.sin * r[(1, 1)]),
        );
        let tilt = match (parallel, r[(2, 2)].abs() <= NO_TURN) {
            (true, _) => Turn { cos: r[(2, 2)].signum(), sin: 0.0 },
            (_, true) => Turn::RIGHT,
            _ => Turn::of(r[(2, 2)], sine),
        };
        let mut along = [first.cos * p.x + first.sin * p.y, first.cos * p.y - first.sin * p.x, p.z];
        let mut along_z = 0.0;
        if sine > PARALLEL_AXES {
            // The part across the common normal is a shift along the child's axis: (0, −sin α, cos α).
            along_z = -along[1] / tilt.sin;
            along[2] -= along_z * tilt.cos;
            along[1] = 0.0;
        } else if parallel {
            // Parallel axes: a shift along one axis is a shift along the other.
            along_z = along[2] * tilt.cos;
            along[2] = 0.0;
        }
        let small = |d: f64| if d.abs() <= f64::EPSILON * p.norm() { 0.0 } else { d };
        let (along, along_z) = (along.map(small), small(along_z));
        let length = along_z.abs() + Vector3::from(along).norm();
        let last_turn_z = first.unless_identity();
        let shape = if along[1] != 0.0 || along[2] != 0.0 || last_turn_z.is_some() {
            Shape::General
        } else if tilt == Turn::NONE {
            Shape::Parallel
        } else if tilt == Turn::RIGHT {
            Shape::Right
        } else {
            Shape::Skew
        };
        Self { turn_z: second.unless_identity(), along_z, tilt, shift: along, last_turn_z, length, shape }
    }
}

impl Turn {
    const NONE: Self = Self { cos: 1.0, sin: 0.0 };
    const RIGHT: Self = Self { cos: 0.0, sin: 1.0 };

    /// A right angle within rounding is exactly a right angle.
    fn of(x: f64, y: f64) -> Self {
        let length = x.hypot(y);
        let (cos, sin) = (x / length, y / length);
        if cos.abs() <= NO_TURN { Self { cos: 0.0, sin: sin.signum() } } else { Self { cos, sin } }
    }

    fn unless_identity(self) -> Option<Self> {
        (self.sin.abs() > NO_TURN || self.cos < 0.0).then_some(self)
    }
}
