//! Descriptions for the builder: names instead of indices, not yet validated.

use crate::{ClosureKind, ElasticGear, Geometry, Inertial, JointKind, Limits, SpringDamper};
use nalgebra::Vector3;
use percuss_spatial::Transform;

/// Description of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkDescription {
    /// Unique name.
    pub name: String,
    /// Mass and inertia; `None` is a massless link.
    pub inertial: Option<Inertial>,
    /// Extent of the declared shape.
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

/// Description of a mimic relation.
#[derive(Clone, Debug, PartialEq)]
pub struct MimicDescription {
    /// Name of the master joint.
    pub joint: String,
    /// Ratio of the rates.
    pub multiplier: f64,
    /// Position at the master's zero, rad or m.
    pub offset: f64,
}

/// Description of a joint.
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
    /// Largest magnitude of the rate of a joint with one velocity, rad/s or m/s. A value that is not positive and finite is ignored.
    pub rate_limit: Option<f64>,
    /// Rotor inertia reflected to the joint: empty, one value for all velocities, or one per velocity.
    pub armature: Vec<f64>,
    /// Mimic relation.
    pub mimic: Option<MimicDescription>,
    /// Preference where loops leave a choice: `true` for an independent (driving), `false` for a dependent joint.
    pub independent: Option<bool>,
    /// Spring and damper parallel to the motion of a joint with one velocity.
    pub spring: Option<SpringDamper>,
    /// Elasticity of the gear of a joint with one velocity and an armature.
    pub gear: Option<ElasticGear>,
}

impl JointDescription {
    /// Joint at the parent's origin with the x-axis as axis (defaults of URDF).
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
            rate_limit: None,
            armature: Vec::new(),
            mimic: None,
            independent: None,
            spring: None,
            gear: None,
        }
    }

    /// Sets the joint frame in the parent.
    pub fn origin(mut self, x_pj: Transform<f64>) -> Self {
        self.origin = x_pj;
        self
    }

    /// Sets the origin of the joint frame in the parent (m), with parallel axes.
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

    /// Sets the spring and damper parallel to the motion.
    pub fn spring(mut self, spring: SpringDamper) -> Self {
        self.spring = Some(spring);
        self
    }

    /// Sets the elasticity of the gear between the rotor and the joint.
    pub fn gear(mut self, gear: ElasticGear) -> Self {
        self.gear = Some(gear);
        self
    }

    /// Makes the joint mimic another joint.
    pub fn mimic(mut self, joint: impl Into<String>, multiplier: f64, offset: f64) -> Self {
        self.mimic = Some(MimicDescription { joint: joint.into(), multiplier, offset });
        self
    }
}

/// Description of a joint that closes a loop.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosureDescription {
    /// Unique name among closures and couplings.
    pub name: String,
    /// Kind of closure.
    pub kind: ClosureKind,
    /// Name of the predecessor link; `world` is the ground, unless a link has this name.
    pub predecessor: String,
    /// X_lf: the loop frame in the predecessor.
    pub predecessor_frame: Transform<f64>,
    /// Name of the successor link.
    pub successor: String,
    /// X_lf: the loop frame in the successor.
    pub successor_frame: Transform<f64>,
    /// Axis, with the same components in both loop frames; normalised by the builder.
    pub axis: Vector3<f64>,
    /// Axis of the successor's pin of a universal closure, in the successor's loop frame.
    pub axis2: Vector3<f64>,
    /// Length of a distance closure, m; `None` takes the distance with all joints at 0.
    pub distance: Option<f64>,
}

impl ClosureDescription {
    /// Closure between the origins of two links, with the x-axis as axis (default of URDF) and the y-axis as
    /// second axis.
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

    /// Sets the origins of the loop frames in their links (m), with axes parallel to those of the links.
    pub fn at(mut self, predecessor: [f64; 3], successor: [f64; 3]) -> Self {
        self.predecessor_frame = Transform::from_translation(predecessor.into());
        self.successor_frame = Transform::from_translation(successor.into());
        self
    }

    /// Sets the axis, with the same components in both loop frames.
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

/// Description of a ratio between rates.
#[derive(Clone, Debug, PartialEq)]
pub struct CouplingDescription {
    /// Unique name among closures and couplings.
    pub name: String,
    /// Name of the link with the independent rate.
    pub predecessor: String,
    /// Name of the link with the dependent rate.
    pub successor: String,
    /// Rate of the successor divided by the rate of the predecessor.
    pub ratio: f64,
}

/// Description of a relation between joint positions: Σ fᵢ qᵢ = c + a₂ s² + a₃ s³ + a₄ s⁴ (see [`Coupling`](crate::Coupling)).
#[derive(Clone, Debug, PartialEq)]
pub struct RelationDescription {
    /// Unique name among closures and couplings.
    pub name: String,
    /// Names of joints, with the factors fᵢ. Fixed joints have the position 0.
    pub terms: Vec<(String, f64)>,
    /// Constant c, in the unit of the terms.
    pub constant: f64,
    /// Higher powers.
    pub curve: Option<CurveDescription>,
}

/// Description of the higher powers of a relation: a₂ s² + a₃ s³ + a₄ s⁴ with s = s₀ + Σ gⱼ qⱼ.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveDescription {
    /// Names of joints, with the factors gⱼ.
    pub terms: Vec<(String, f64)>,
    /// Offset s₀ of the argument.
    pub offset: f64,
    /// Coefficients a₂, a₃, a₄.
    pub coefficients: [f64; 3],
}
