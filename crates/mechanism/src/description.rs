//! Plain descriptions handed to the builder: names instead of indices, nothing checked yet.

use crate::{Geometry, JointKind, Limits};
use nalgebra::{Matrix3, Vector3};
use percuss_spatial::{SpatialInertia, Transform};

/// Mass, centre of mass and inertia of a link, as a user declares them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertial {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the link frame, m.
    pub com: Vector3<f64>,
    /// Rotational inertia about the centre of mass, in the link's axes, kg·m².
    pub about_com: Matrix3<f64>,
}

impl Inertial {
    /// A point mass (kg) at `com` (m).
    pub fn point(mass: f64, com: [f64; 3]) -> Self {
        Self { mass, com: com.into(), about_com: Matrix3::zeros() }
    }

    /// Mass (kg), centre of mass (m) and the moments about it along the link's axes (kg·m²).
    pub fn diagonal(mass: f64, com: [f64; 3], moments: [f64; 3]) -> Self {
        Self { mass, com: com.into(), about_com: Matrix3::from_diagonal(&moments.into()) }
    }

    /// About the link's origin.
    pub fn spatial(&self) -> SpatialInertia<f64> {
        SpatialInertia::about_com(self.mass, self.com, self.about_com)
    }
}

/// A link to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkDescription {
    /// Unique name.
    pub name: String,
    /// What it weighs; `None` is a massless link.
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
