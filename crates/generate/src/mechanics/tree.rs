//! Bodies of the spanning tree with numbers: links joined by fixed joints are one body.

use crate::request::Request;
use percuss_dynamics::Base;
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use percuss_spatial::{SpatialInertia, Transform, Vector3, rotation_about};
use std::ops::Range;

/// Body with the joint to its parent, in the frame of its child link.
#[derive(Clone, Debug)]
pub(crate) struct TreeBody {
    /// Parent body; `None` for the ground.
    pub parent: Option<usize>,
    /// Joint to the parent; `None` for the floating base.
    pub joint: Option<JointId>,
    pub kind: JointKind,
    pub axis: Vector3<f64>,
    /// X_pj: joint frame in the parent body.
    pub origin: Transform<f64>,
    pub inertia: SpatialInertia<f64>,
    /// Range of the positions among the inputs; empty for the floating base and for mimics.
    pub inputs: Range<usize>,
    /// Position as multiplier · input + offset, for mimics.
    pub mimic: Option<(usize, f64, f64)>,
    /// True for a joint with a position and no velocity.
    pub is_locked: bool,
    /// Range of the tree velocities; empty if locked.
    pub velocities: Range<usize>,
    pub armature: Vec<f64>,
}

impl TreeBody {
    /// Number of velocities; 0 if locked.
    pub fn dofs(&self) -> usize {
        if self.is_locked { 0 } else { self.kind.dofs() }
    }
}

/// Velocity of the tree as multiplier · coordinate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TreeVelocity {
    pub body: usize,
    /// Index within the joint.
    pub component: usize,
    pub coordinate: usize,
    pub multiplier: f64,
    /// True for a rotation.
    pub turns: bool,
}

/// Joint whose positions are inputs of the function.
#[derive(Clone, Debug)]
pub(crate) struct InputJoint {
    pub joint: JointId,
    pub inputs: Range<usize>,
}

/// Spanning tree.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    pub bodies: Vec<TreeBody>,
    /// Body and frame X_bl of every link; the body is `None` for the ground.
    pub links: Vec<(Option<usize>, Transform<f64>)>,
    pub velocities: Vec<TreeVelocity>,
    /// Number of coordinates: velocities of masters and of the floating base.
    pub coordinates: usize,
    pub input_joints: Vec<InputJoint>,
    /// Number of inputs.
    pub inputs: usize,
    /// Body of every joint; `None` for fixed joints.
    pub body_of_joint: Vec<Option<usize>>,
}

impl Tree {
    /// Tree of the request's mechanism under its conditions.
    pub fn new(request: &Request) -> Self {
        let mechanism: &Mechanism = request.system.mechanism();
        let ground = (None, Transform::identity());
        let mut tree = Self {
            bodies: Vec::new(),
            links: vec![ground; mechanism.links().len()],
            velocities: Vec::new(),
            coordinates: 0,
            input_joints: Vec::new(),
            inputs: 0,
            body_of_joint: vec![None; mechanism.joints().len()],
        };
        let mut first_input = vec![0; mechanism.joints().len()];
        for id in mechanism.joint_ids() {
            let joint = mechanism.joint(id);
            first_input[id.index()] = tree.inputs;
            if joint.mimic().is_none() && joint.kind().positions() > 0 {
                let inputs = tree.inputs..tree.inputs + joint.kind().positions();
                tree.inputs = inputs.end;
                tree.input_joints.push(InputJoint { joint: id, inputs });
            }
        }
        for &link in mechanism.order() {
            tree.add_link(request, mechanism, link, &first_input);
        }
        tree.number_coordinates(mechanism);
        tree
    }

    fn add_link(&mut self, request: &Request, mechanism: &Mechanism, link: LinkId, first_input: &[usize]) {
        let inertia = *mechanism.link(link).inertia();
        let Some(id) = mechanism.parent_joint(link) else {
            if request.system.base() == Base::Floating {
                self.links[link.index()].0 = Some(0);
                self.bodies.push(TreeBody {
                    parent: None,
                    joint: None,
                    kind: JointKind::Floating,
                    axis: Vector3::z(),
                    origin: Transform::identity(),
                    inertia,
                    inputs: 0..0,
                    mimic: None,
                    is_locked: false,
                    velocities: 0..0,
                    armature: vec![0.0; 6],
                });
            }
            return;
        };
        let joint = mechanism.joint(id);
        let (parent, frame) = self.links[joint.parent().index()];
        let origin = frame * *joint.origin();
        if joint.kind() == JointKind::Fixed {
            if let Some(body) = parent {
                self.bodies[body].inertia += origin.inertia(&inertia);
            }
            self.links[link.index()] = (parent, origin);
            return;
        }
        self.links[link.index()] = (Some(self.bodies.len()), Transform::identity());
        self.body_of_joint[id.index()] = Some(self.bodies.len());
        let first = first_input[id.index()];
        let mimic = joint.mimic().map(|m| (first_input[m.master.index()], m.multiplier, m.offset));
        let positions = if mimic.is_some() { 0 } else { joint.kind().positions() };
        self.bodies.push(TreeBody {
            parent,
            joint: Some(id),
            kind: joint.kind(),
            axis: *joint.axis(),
            origin,
            inertia,
            inputs: first..first + positions,
            mimic,
            is_locked: request.system.is_locked(id),
            velocities: 0..0,
            armature: request.armature_of(id),
        });
    }

    /// Numbers the tree velocities, and the coordinates of all joints that are not mimics.
    fn number_coordinates(&mut self, mechanism: &Mechanism) {
        let mut first_of = vec![0; mechanism.joints().len()];
        for body in self.bodies.iter().filter(|b| b.mimic.is_none()) {
            if let Some(id) = body.joint {
                first_of[id.index()] = self.coordinates;
            }
            self.coordinates += body.dofs();
        }
        let mut base = 0;
        for (number, body) in self.bodies.iter_mut().enumerate() {
            let first = self.velocities.len();
            let dofs = body.dofs();
            body.velocities = first..first + dofs;
            let mimic = body.joint.and_then(|id| mechanism.joint(id).mimic());
            let (coordinate, multiplier) = match (mimic, body.joint) {
                (Some(mimic), _) => (first_of[mimic.master.index()], mimic.multiplier),
                (None, Some(id)) => (first_of[id.index()], 1.0),
                (None, None) => (std::mem::take(&mut base), 1.0),
            };
            for component in 0..dofs {
                let turns = body.kind.turns(component);
                let coordinate = coordinate + component;
                self.velocities.push(TreeVelocity { body: number, component, coordinate, multiplier, turns });
            }
        }
    }

    /// Bodies from `body` to the ground.
    pub fn ancestors(&self, body: Option<usize>) -> Vec<usize> {
        std::iter::successors(body, |&b| self.bodies[b].parent).collect()
    }

    /// Nearest common ancestor of two bodies; `None` is the ground.
    pub fn common_ancestor(&self, mut a: Option<usize>, mut b: Option<usize>) -> Option<usize> {
        // Parents have lower numbers than children.
        while a != b {
            if a > b {
                a = a.and_then(|a| self.bodies[a].parent);
            } else {
                b = b.and_then(|b| self.bodies[b].parent);
            }
        }
        a
    }
}

impl Tree {
    /// X_rl of a link with all joints at 0; mimics are at their offsets.
    pub fn drawn_frame(&self, request: &Request, link: LinkId) -> Transform<f64> {
        let mechanism = request.system.mechanism();
        let mut frame = Transform::identity();
        let mut at = link;
        while let Some(id) = mechanism.parent_joint(at) {
            let joint = mechanism.joint(id);
            let offset = joint.mimic().map_or(0.0, |mimic| mimic.offset);
            let moved = match joint.kind() {
                JointKind::Revolute | JointKind::Continuous => {
                    Transform::new(rotation_about(joint.axis(), offset), Vector3::zeros())
                }
                JointKind::Prismatic => Transform::from_translation(joint.axis() * offset),
                JointKind::Fixed | JointKind::Planar | JointKind::Spherical | JointKind::Floating => {
                    Transform::identity()
                }
            };
            frame = *joint.origin() * moved * frame;
            at = joint.parent();
        }
        frame
    }
}
