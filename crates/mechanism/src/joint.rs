//! A joint of the tree: the motion a child link has in its parent.

use crate::LinkId;
use crate::name_mark::NameMark;
use percuss_spatial::{Transform, Vector3};

/// Index of a joint in its mechanism, in the order the joints were given. It holds in every mechanism that has a joint of
/// the same name at the same index: [`Mechanism::has_joint`](crate::Mechanism::has_joint).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct JointId {
    pub(crate) index: u32,
    pub(crate) mark: NameMark,
}

impl JointId {
    pub(crate) fn new(index: usize, name: &str) -> Self {
        Self { index: index as u32, mark: NameMark::of(name) }
    }

    /// Position in [`Mechanism::joints`](crate::Mechanism::joints).
    pub fn index(self) -> usize {
        self.index as usize
    }
}

/// The kinds of joint. A closed list: every `match` names them all.
///
/// | kind       | positions              | velocities                                        |
/// |------------|------------------------|---------------------------------------------------|
/// | fixed      | –                      | –                                                 |
/// | revolute   | angle (rad)            | rad/s about the axis                              |
/// | continuous | angle (rad), no limits | rad/s about the axis                              |
/// | prismatic  | distance (m)           | m/s along the axis                                |
/// | planar     | x, y (m), angle (rad)  | their rates; the plane is normal to the axis, its x and y as in [`plane_basis`](percuss_spatial::plane_basis) |
/// | spherical  | unit quaternion w,x,y,z | angular velocity in the child's axes, rad/s      |
/// | floating   | x,y,z (m), w,x,y,z     | twist in the child's axes at its origin, angular first |
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// No motion.
    Fixed,
    /// Turns about its axis.
    Revolute,
    /// Turns about its axis without limits.
    Continuous,
    /// Slides along its axis.
    Prismatic,
    /// Moves in the plane normal to its axis and turns about it.
    Planar,
    /// Turns in any way about a point.
    Spherical,
    /// Moves freely.
    Floating,
}

impl JointKind {
    /// Every kind, for tests that must skip none.
    pub const ALL: [JointKind; 7] = [
        JointKind::Fixed,
        JointKind::Revolute,
        JointKind::Continuous,
        JointKind::Prismatic,
        JointKind::Planar,
        JointKind::Spherical,
        JointKind::Floating,
    ];

    /// Degrees of freedom: how many velocities it has.
    pub fn dofs(self) -> usize {
        match self {
            JointKind::Fixed => 0,
            JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic => 1,
            JointKind::Planar | JointKind::Spherical => 3,
            JointKind::Floating => 6,
        }
    }

    /// How many numbers its position takes.
    pub fn positions(self) -> usize {
        match self {
            JointKind::Fixed => 0,
            JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic => 1,
            JointKind::Planar => 3,
            JointKind::Spherical => 4,
            JointKind::Floating => 7,
        }
    }

    /// Whether the motion has an axis that must be given.
    pub fn has_axis(self) -> bool {
        match self {
            JointKind::Fixed | JointKind::Spherical | JointKind::Floating => false,
            JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Planar => true,
        }
    }

    /// Whether all its velocities have one unit, so that one armature value fits them all.
    pub fn is_homogeneous(self) -> bool {
        match self {
            JointKind::Planar | JointKind::Floating => false,
            JointKind::Fixed
            | JointKind::Revolute
            | JointKind::Continuous
            | JointKind::Prismatic
            | JointKind::Spherical => true,
        }
    }

    /// The name URDF gives it.
    pub fn name(self) -> &'static str {
        match self {
            JointKind::Fixed => "fixed",
            JointKind::Revolute => "revolute",
            JointKind::Continuous => "continuous",
            JointKind::Prismatic => "prismatic",
            JointKind::Planar => "planar",
            JointKind::Spherical => "spherical",
            JointKind::Floating => "floating",
        }
    }

    /// The layout of its position, as a user types it.
    pub fn layout(self) -> &'static str {
        match self {
            JointKind::Fixed => "nothing",
            JointKind::Revolute | JointKind::Continuous => "one angle (rad)",
            JointKind::Prismatic => "one distance (m)",
            JointKind::Planar => "x,y,θ (m, m, rad)",
            JointKind::Spherical => "a quaternion w,x,y,z",
            JointKind::Floating => "x,y,z,w,x,y,z (m and a quaternion)",
        }
    }
}

/// Range of a joint's position, rad or m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Least position.
    pub lower: f64,
    /// Greatest position.
    pub upper: f64,
}

/// A joint that follows another: q = multiplier · q_master + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mimic {
    /// The joint that is followed; it mimics nothing itself (chains are resolved by the builder).
    pub master: JointId,
    /// Ratio of the rates.
    pub multiplier: f64,
    /// Position at the master's zero, rad or m.
    pub offset: f64,
}

/// A joint between a parent and a child link.
#[derive(Clone, Debug)]
pub struct Joint {
    pub(crate) name: String,
    pub(crate) mark: NameMark,
    pub(crate) kind: JointKind,
    pub(crate) parent: LinkId,
    pub(crate) child: LinkId,
    pub(crate) origin: Transform<f64>,
    pub(crate) axis: Vector3<f64>,
    pub(crate) limits: Option<Limits>,
    pub(crate) armature: Vec<f64>,
    pub(crate) mimic: Option<Mimic>,
    pub(crate) independent: Option<bool>,
}

impl Joint {
    /// Its name, unique among the joints.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its kind.
    pub fn kind(&self) -> JointKind {
        self.kind
    }

    /// The parent link.
    pub fn parent(&self) -> LinkId {
        self.parent
    }

    /// The child link; its frame is the joint frame, moved.
    pub fn child(&self) -> LinkId {
        self.child
    }

    /// X_pj: the joint frame (the child's frame at position zero) in the parent.
    pub fn origin(&self) -> &Transform<f64> {
        &self.origin
    }

    /// The unit axis in the joint frame; meaningless where the kind has none.
    pub fn axis(&self) -> &Vector3<f64> {
        &self.axis
    }

    /// Position limits, where declared.
    pub fn limits(&self) -> Option<Limits> {
        self.limits
    }

    /// Rotor inertia reflected to the joint, one value a velocity (kg·m² or kg).
    pub fn armature(&self) -> &[f64] {
        &self.armature
    }

    /// What it follows, if anything.
    pub fn mimic(&self) -> Option<Mimic> {
        self.mimic
    }

    /// Whether it was advised to drive or to follow where loops leave a choice. Never changes m̄.
    pub fn independent(&self) -> Option<bool> {
        self.independent
    }
}
