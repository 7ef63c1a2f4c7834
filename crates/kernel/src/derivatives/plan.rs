//! Plan of the derivative kernel: one step per body, with the joint axis along z.

use crate::mechanism::{Body, Cluster, JointMotion, Mechanism};
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

/// Body of a cluster: all its joints follow one coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    /// First body of the cluster.
    pub head: usize,
    /// Parent body, if it is in the cluster.
    pub parent: Option<usize>,
    /// Parent body of the cluster; `None` for the ground.
    pub outside: Option<usize>,
    /// Velocity of the joint per rate of the coordinate.
    pub multiplier: f64,
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
    /// Multiplier and offset of the position of a mimic joint.
    pub mimic: Option<[f64; 2]>,
    /// Part in a cluster of mimic joints.
    pub member: Option<Member>,
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
    /// Plan of a tree; `None` for loops, held contacts, planar joints, negative masses, and clusters of mimic joints with several coordinates,
    /// with locked joints, with joints of several velocities, or with several bodies on the ground.
    pub fn of(mechanism: &Mechanism) -> Option<Self> {
        let is_still = |body: &Body| body.velocities.iter().any(|velocity| velocity.coordinate.is_none());
        if !mechanism.is_positive() || mechanism.bodies.iter().any(is_still) {
            return None;
        }
        let mut plan = Self { steps: Vec::new(), frames: Vec::new(), columns: 0 };
        for (number, body) in mechanism.bodies.iter().enumerate() {
            let q = body.mimic.map_or(body.q, |mimic| mimic.q);
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
                mimic: body.mimic.map(|mimic| [mimic.multiplier, mimic.offset]),
                member: None,
            });
        }
        mechanism.clusters.iter().try_for_each(|cluster| plan.add_cluster(mechanism, cluster))?;
        Some(plan)
    }

    /// Marks the bodies of a cluster; `None` if it is not supported.
    fn add_cluster(&mut self, mechanism: &Mechanism, cluster: &Cluster) -> Option<()> {
        let roots = cluster.parents.iter().filter(|parent| parent.is_none()).count();
        if cluster.coordinates != 1 || cluster.parent.is_none() && roots > 1 {
            return None;
        }
        let head = *cluster.bodies.iter().min()?;
        for (&number, parent) in cluster.bodies.iter().zip(&cluster.parents) {
            let [velocity] = &mechanism.bodies[number].velocities[..] else { return None };
            self.steps[number].member = Some(Member {
                head,
                parent: parent.map(|at| cluster.bodies[at]),
                outside: cluster.parent,
                multiplier: velocity.multiplier,
            });
        }
        Some(())
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
