//! Plan of the derivative kernel: one step per body, with the joint axis along z.

use crate::mechanism::{JointMotion, Mechanism};
use nalgebra::{Matrix3, Unit, Vector3};
use percuss_spatial::{PackedInertia, SpatialInertia, Transform, plane_basis};

/// Largest number of velocities of one joint.
pub(super) const MOST_VELOCITIES: usize = 6;
/// Order of the elimination of six velocities: translations first.
pub(super) const SIX: [usize; 6] = [3, 4, 5, 0, 1, 2];

/// Motion of a joint; `q`: index of its first position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StepMotion {
    /// Rotation about z.
    Turn { q: usize },
    /// Translation along z.
    Slide { q: usize },
    /// Rotation by a quaternion.
    Ball { q: usize },
    /// Translation, then rotation by a quaternion.
    Floating { q: usize },
    /// Floating base: the root link defines the axes.
    Base,
}

/// Body with its joint, in a frame of which z is the axis of the joint.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub parent: Option<usize>,
    pub motion: StepMotion,
    /// Rotation (rows) and origin (m) of the frame in the frame of the parent's step, with the joint at zero.
    pub rotation: [[f64; 3]; 3],
    pub origin: [f64; 3],
    /// Moments of inertia about the origin, upper triangle by rows, kg·m²; first moment, kg·m; mass, kg.
    pub moments: [f64; 6],
    pub first_moment: [f64; 3],
    pub mass: f64,
    /// Armature of each velocity.
    pub armature: [f64; MOST_VELOCITIES],
    /// Number of velocities; 0 for a locked joint.
    pub velocities: usize,
    /// Index of the first velocity among those of all joints; `None` for the floating base.
    pub output: Option<usize>,
    /// Index of the first velocity in the scratch memory.
    pub column: usize,
    /// Body on the ground from which the body descends.
    pub subtree_root: usize,
}

/// Compiled tree.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// Steps of the bodies, parents before children.
    pub steps: Vec<Step>,
    /// Frame of each step in the frame of its body.
    pub frames: Vec<Transform<f64>>,
    /// Number of velocities of all bodies.
    pub columns: usize,
}

impl Plan {
    /// Plan of a tree; `None` for loops, held contacts, mimics, planar joints and negative masses.
    pub fn of(mechanism: &Mechanism) -> Option<Self> {
        if !mechanism.is_positive() || mechanism.bodies.iter().any(|body| body.mimic.is_some()) {
            return None;
        }
        let mut plan = Self { steps: Vec::new(), frames: Vec::new(), columns: 0 };
        for (number, body) in mechanism.bodies.iter().enumerate() {
            let q = body.q;
            let motion = match body.motion {
                JointMotion::Base => StepMotion::Base,
                JointMotion::Revolute => StepMotion::Turn { q },
                JointMotion::Prismatic => StepMotion::Slide { q },
                JointMotion::Spherical => StepMotion::Ball { q },
                JointMotion::Floating => StepMotion::Floating { q },
                JointMotion::Planar | JointMotion::Fixed => return None,
            };
            let own = match motion {
                StepMotion::Turn { .. } | StepMotion::Slide { .. } => axis_frame(&body.axis),
                StepMotion::Ball { .. } | StepMotion::Floating { .. } | StepMotion::Base => {
                    Transform::identity()
                }
            };
            let drawn = if motion == StepMotion::Base { Transform::identity() } else { body.origin };
            let parent = body.parent.map_or_else(Transform::identity, |p| plan.frames[p]);
            let step = parent.inverse() * drawn * own;
            let inertia = own.inverse().inertia(&body.inertia);
            let mut armature = [0.0; MOST_VELOCITIES];
            armature.iter_mut().zip(&body.velocities).for_each(|(to, own)| *to = own.armature);
            let column = plan.columns;
            plan.columns += body.velocities.len();
            plan.frames.push(own);
            plan.steps.push(Step {
                parent: body.parent,
                motion,
                rotation: rows(&step.rotation),
                origin: step.translation.into(),
                moments: moments(&inertia),
                first_moment: inertia.first_moment.into(),
                mass: inertia.mass,
                armature,
                velocities: body.velocities.len(),
                output: body.output,
                column,
                subtree_root: body.parent.map_or(number, |p| plan.steps[p].subtree_root),
            });
        }
        Some(plan)
    }
}

impl Step {
    /// Velocities in the order of their elimination.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn velocity(&self, number: usize) -> usize {
        if self.velocities == SIX.len() { SIX[number] } else { number }
    }

    /// True for six free velocities without armature: the inertia left by their elimination is exactly zero.
    pub fn transmits_nothing(&self) -> bool {
        self.velocities == MOST_VELOCITIES && self.armature == [0.0; MOST_VELOCITIES]
    }
}

/// Frame of which z is along an axis.
fn axis_frame(axis: &Vector3<f64>) -> Transform<f64> {
    let z = Unit::new_normalize(*axis).into_inner();
    let (x, y) = plane_basis(&z);
    Transform::new(Matrix3::from_columns(&[x, y, z]), Vector3::zeros())
}

fn rows(m: &Matrix3<f64>) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|k| m[(i, k)]))
}

/// Moments of inertia about the origin, upper triangle by rows.
fn moments(inertia: &SpatialInertia<f64>) -> [f64; 6] {
    PackedInertia::of_body(inertia).angular
}
