//! Bodies of a model in depth-first order; frames and replicates are resolved.

use crate::mjcf::bodies::geom::Geom;
use crate::reading::document::element_tree::ElementId;
use percuss_mechanism::{Inertial, SpringDamper};
use percuss_spatial::{Transform, Vector3};
use std::collections::HashMap;

/// Kinds of joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum JointType {
    Free,
    Ball,
    Slide,
    Hinge,
}

/// Joint of a body.
#[derive(Clone, Debug)]
pub(crate) struct BodyJoint {
    pub element: ElementId,
    /// Name with the suffixes of replicates; empty if absent.
    pub name: String,
    pub kind: JointType,
    /// Anchor and unit axis in the body's frame, with all joints as drawn.
    pub anchor: Vector3<f64>,
    pub axis: Vector3<f64>,
    /// Lower and upper limit minus the reference position, rad or m.
    pub limits: Option<[f64; 2]>,
    /// MuJoCo's position as drawn, rad or m.
    pub reference: f64,
    /// Armature of the joint and of its actuators, kg·m² or kg.
    pub armature: f64,
    /// Spring and damper parallel to the motion, with its position relative to the drawing.
    pub spring: Option<SpringDamper>,
}

/// Body of a model.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub element: ElementId,
    /// Name with the suffixes of replicates; empty if absent.
    pub name: String,
    /// Index of the parent body; the world is its own parent.
    pub parent: usize,
    /// Frame of the body in its parent, and in the world, with all joints as drawn.
    pub pose: Transform<f64>,
    pub world_pose: Transform<f64>,
    pub joints: Vec<BodyJoint>,
    pub geoms: Vec<Geom>,
    /// Declared inertia, with its element.
    pub inertial: Option<(Inertial, ElementId)>,
    /// Nearest body with a joint on the path to the world, the body itself included; 0 for a body that cannot move.
    pub moving_ancestor: usize,
}

/// Site: named frame of a body.
#[derive(Clone, Debug)]
pub(crate) struct Site {
    pub body: usize,
    pub frame: Transform<f64>,
}

/// Bodies, the world first, and sites.
#[derive(Debug, Default)]
pub(crate) struct Bodies {
    pub bodies: Vec<Body>,
    pub body_by_name: HashMap<String, usize>,
    /// Body and position in its list of joints.
    pub joint_by_name: HashMap<String, (usize, usize)>,
    pub sites: HashMap<String, Site>,
    /// Base names of the elements within replicates: their full names have suffixes.
    pub replicated_names: HashMap<String, ElementId>,
}

impl Bodies {
    /// True if `ancestor` is `body` or one of the bodies that carry it.
    pub fn is_ancestor(&self, ancestor: usize, body: usize) -> bool {
        // An ancestor has a smaller number.
        let above = |&body: &usize| (body > ancestor).then(|| self.bodies[body].parent);
        std::iter::successors(Some(body), above).any(|body| body == ancestor)
    }

    /// Joint of a body.
    pub fn joint(&self, (body, position): (usize, usize)) -> &BodyJoint {
        &self.bodies[body].joints[position]
    }
}
