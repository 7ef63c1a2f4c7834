//! Plain descriptions handed to the builder: names instead of indices, nothing checked yet.

use crate::{ClosureKind, Geometry, Inertial, JointKind, Limits};
use nalgebra::Vector3;
use percuss_spatial::Transform;

/// A link to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkDescription {
    /// Unique name.
    pub name: String,
    /// Its mass and inertia; `None` is a massless link.
    pub inertial: Option<Inertial>,
    /// How far its declared shape reaches.
    pub geometry: Geometry,
}

impl LinkDescription {
    /// A massless link.
    pub fn massless(name: impl Into<String>) -> Self {
        Self { name: name.into(), inertial: None, geometry: Geometry::None }
    }

    /// A link with mass.
    pub fn new(name: impl Into<String>, inertial: Inertial) -> Self {
        Self { inertial: Some(inertial), ..Self::massless(name) }
    }
}

/// What a joint follows, by name.
#[derive(Clone, Debug, PartialEq)]
pub struct MimicDescription {
    /// Name of the joint that is followed.
    pub joint: String,
    /// Ratio of the rates.
    pub multiplier: f64,
    /// Position at the master's zero, rad or m.
    pub offset: f64,
}

/// A joint to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct JointDescription {
    /// Unique name.
    pub name: String,
    /// Kind of motion.
    pub kind: JointKind,
    /// Name of the parent link.
    pub parent: String,
    /// Name of the child link.
    pub child: String,
    /// X_pj: the joint frame in the parent.
    pub origin: Transform<f64>,
    /// Axis in the joint frame; normalised by the builder.
    pub axis: Vector3<f64>,
    /// Position limits.
    pub limits: Option<Limits>,
    /// Rotor inertia reflected to the joint: nothing, one value for all velocities, or one each.
    pub armature: Vec<f64>,
    /// What it follows.
    pub mimic: Option<MimicDescription>,
    /// Whether it is advised to drive (`true`) or to follow (`false`) where loops leave a choice.
    pub independent: Option<bool>,
}

impl JointDescription {
    /// A joint at the parent's origin about or along the x-axis (URDF's defaults).
    pub fn new(
        name: impl Into<String>,
        kind: JointKind,
        parent: impl Into<String>,
        child: impl Into<String>,
    ) -> Self {
        Self {
            name: name.into(),
            kind,
            parent: parent.into(),
            child: child.into(),
            origin: Transform::identity(),
            axis: Vector3::x(),
            limits: None,
            armature: Vec::new(),
            mimic: None,
            independent: None,
        }
    }

    /// Places the joint frame in the parent.
    pub fn origin(mut self, x_pj: Transform<f64>) -> Self {
        self.origin = x_pj;
        self
    }

    /// Places the joint frame's origin in the parent (m), axes parallel.
    pub fn at(self, p: [f64; 3]) -> Self {
        self.origin(Transform::from_translation(p.into()))
    }

    /// Sets the axis.
    pub fn axis(mut self, axis: [f64; 3]) -> Self {
        self.axis = axis.into();
        self
    }

    /// Sets the armature of every velocity (kg·m² or kg).
    pub fn armature(mut self, value: f64) -> Self {
        self.armature = vec![value];
        self
    }

    /// Makes it follow another joint.
    pub fn mimic(mut self, joint: impl Into<String>, multiplier: f64, offset: f64) -> Self {
        self.mimic = Some(MimicDescription { joint: joint.into(), multiplier, offset });
        self
    }
}

/// A joint that closes a loop, to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosureDescription {
    /// Unique name among closures and couplings.
    pub name: String,
    /// What it imposes.
    pub kind: ClosureKind,
    /// Name of the predecessor link; `world` is the ground where no link is called so.
    pub predecessor: String,
    /// X_lf: the loop frame in the predecessor.
    pub predecessor_frame: Transform<f64>,
    /// Name of the successor link.
    pub successor: String,
    /// X_lf: the loop frame in the successor.
    pub successor_frame: Transform<f64>,
    /// Axis, the same components in both loop frames; normalised by the builder.
    pub axis: Vector3<f64>,
    /// The successor's pin of a universal closure, in its loop frame.
    pub axis2: Vector3<f64>,
    /// Length of a distance closure, m; none: the distance with all joints at 0.
    pub distance: Option<f64>,
}

impl ClosureDescription {
    /// Between the origins of two links, axes along x (URDF's default), pins of a universal along x and y.
    pub fn new(
        name: impl Into<String>,
        kind: ClosureKind,
        predecessor: impl Into<String>,
        successor: impl Into<String>,
    ) -> Self {
        Self {
            name: name.into(),
            kind,
            predecessor: predecessor.into(),
            predecessor_frame: Transform::identity(),
            successor: successor.into(),
            successor_frame: Transform::identity(),
            axis: Vector3::x(),
            axis2: Vector3::y(),
            distance: None,
        }
    }

    /// Places the loop frames' origins in their links (m), axes parallel to the links'.
    pub fn at(mut self, predecessor: [f64; 3], successor: [f64; 3]) -> Self {
        self.predecessor_frame = Transform::from_translation(predecessor.into());
        self.successor_frame = Transform::from_translation(successor.into());
        self
    }

    /// Sets the axis.
    pub fn axis(mut self, axis: [f64; 3]) -> Self {
        self.axis = axis.into();
        self
    }

    /// Sets the successor's pin of a universal closure.
    pub fn axis2(mut self, axis: [f64; 3]) -> Self {
        self.axis2 = axis.into();
        self
    }

    /// Sets the length of a distance closure, m.
    pub fn distance(mut self, distance: f64) -> Self {
        self.distance = Some(distance);
        self
    }
}

/// A ratio between rates, to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct CouplingDescription {
    /// Unique name among closures and couplings.
    pub name: String,
    /// Name of the link whose rate is given.
    pub predecessor: String,
    /// Name of the link whose rate follows.
    pub successor: String,
    /// Successor's rate over predecessor's.
    pub ratio: f64,
}
