//! Tree joints: motion of a child link relative to its parent.

use crate::LinkId;
use crate::names::name_mark::NameMark;
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

/// Kinds of joint. The enum is exhaustive, so that each `match` handles every kind.
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
    /// Rotation about the axis.
    Revolute,
    /// Rotation about the axis without limits.
    Continuous,
    /// Translation along the axis.
    Prismatic,
    /// Translation in the plane normal to the axis and rotation about the axis.
    Planar,
    /// Rotation about a point.
    Spherical,
    /// Free motion.
    Floating,
}

impl JointKind {
    /// All kinds, for exhaustive tests.
    pub const ALL: [JointKind; 7] = [
        JointKind::Fixed,
        JointKind::Revolute,
        JointKind::Continuous,
        JointKind::Prismatic,
        JointKind::Planar,
        JointKind::Spherical,
        JointKind::Floating,
    ];

    /// Degrees of freedom: number of velocities.
    pub fn dofs(self) -> usize {
        match self {
            JointKind::Fixed => 0,
            JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic => 1,
            JointKind::Planar | JointKind::Spherical => 3,
            JointKind::Floating => 6,
        }
    }

    /// True if velocity `k` is a rotation (rad/s), false for a translation (m/s).
    pub fn turns(self, k: usize) -> bool {
        match self {
            JointKind::Revolute | JointKind::Continuous | JointKind::Spherical => true,
            JointKind::Prismatic | JointKind::Fixed => false,
            JointKind::Planar => k == 2,
            JointKind::Floating => k < 3,
        }
    }

    /// Number of position coordinates.
    pub fn positions(self) -> usize {
        match self {
            JointKind::Fixed => 0,
            JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic => 1,
            JointKind::Planar => 3,
            JointKind::Spherical => 4,
            JointKind::Floating => 7,
        }
    }

    /// True if the kind needs an axis.
    pub fn has_axis(self) -> bool {
        match self {
            JointKind::Fixed | JointKind::Spherical | JointKind::Floating => false,
            JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Planar => true,
        }
    }

    /// True if all velocities have the same unit, so that one armature value suits all.
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

    /// Name in URDF.
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

    /// Layout of the position coordinates in user input.
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
    /// Smallest position.
    pub lower: f64,
    /// Largest position.
    pub upper: f64,
}

/// Mimic relation q = multiplier · q_master + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mimic {
    /// Master joint, which is no mimic itself (the builder resolves chains).
    pub master: JointId,
    /// Ratio of the rates.
    pub multiplier: f64,
    /// Position at the master's zero, rad or m.
    pub offset: f64,
}

/// Spring and damper parallel to the motion of a joint with one velocity: the force or moment −k (q − q₀) − d q̇ on the joint.
///
/// It has no effect on effective masses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpringDamper {
    /// Stiffness k, N·m/rad or N/m; 0 for a damper alone.
    pub stiffness: f64,
    /// Damping d, N·m·s/rad or N·s/m.
    pub damping: f64,
    /// Position without force q₀, rad or m.
    pub reference: f64,
}

/// Elasticity of the gear between the rotor of a joint with one velocity, its armature, and the joint: in series with the drive.
///
/// The rigid mechanism holds it: rotor and joint move together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticGear {
    /// Stiffness at the joint, N·m/rad or N/m, above 0.
    pub stiffness: f64,
    /// Damping, N·m·s/rad or N·s/m.
    pub damping: f64,
}

/// Joint between a parent and a child link.
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
    pub(crate) rate_limit: Option<f64>,
    pub(crate) armature: Vec<f64>,
    pub(crate) mimic: Option<Mimic>,
    pub(crate) independent: Option<bool>,
    pub(crate) spring: Option<SpringDamper>,
    pub(crate) gear: Option<ElasticGear>,
}

impl Joint {
    /// Name, unique among the joints.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Kind.
    pub fn kind(&self) -> JointKind {
        self.kind
    }

    /// The parent link.
    pub fn parent(&self) -> LinkId {
        self.parent
    }

    /// Child link; the link frame is the moving joint frame.
    pub fn child(&self) -> LinkId {
        self.child
    }

    /// X_pj: joint frame (the child's frame at position zero) in the parent.
    pub fn origin(&self) -> &Transform<f64> {
        &self.origin
    }

    /// Unit axis in the joint frame; no meaning if the kind has no axis.
    pub fn axis(&self) -> &Vector3<f64> {
        &self.axis
    }

    /// Declared position limits.
    pub fn limits(&self) -> Option<Limits> {
        self.limits
    }

    /// Largest magnitude of the rate of a joint with one velocity, rad/s or m/s, if declared. It has no effect on effective masses.
    pub fn rate_limit(&self) -> Option<f64> {
        self.rate_limit
    }

    /// Rotor inertia reflected to the joint, one value per velocity (kg·m² or kg).
    pub fn armature(&self) -> &[f64] {
        &self.armature
    }

    /// Mimic relation, if any.
    pub fn mimic(&self) -> Option<Mimic> {
        self.mimic
    }

    /// Declared preference for an independent or dependent joint where loops leave a choice. The effective mass
    /// does not depend on the preference.
    pub fn independent(&self) -> Option<bool> {
        self.independent
    }

    /// Spring and damper parallel to the motion, if any.
    pub fn spring(&self) -> Option<SpringDamper> {
        self.spring
    }

    /// Elasticity of the gear between rotor and joint; `None` for a rigid gear.
    pub fn gear(&self) -> Option<ElasticGear> {
        self.gear
    }
}
