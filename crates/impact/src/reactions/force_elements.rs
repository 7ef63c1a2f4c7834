//! Springs, dampers and drives at joints and between points.

use nalgebra::Vector3;
use percuss_contact::DamperCurve;
use percuss_mechanism::{JointId, LinkId};
use std::sync::Arc;

/// Spring, damper and drive of a joint with one velocity during an impact in time: the force or moment −k (q − q₀) − d q̇ + τ on the joint. With
/// a second joint, such as that of the other half of an anti-roll bar, q is the difference of both positions, and the second joint has the
/// opposite force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointSpring {
    /// The joint.
    pub joint: JointId,
    /// Second joint.
    pub other: Option<JointId>,
    /// Stiffness k, N·m/rad or N/m.
    pub stiffness: f64,
    /// Damping d, N·m·s/rad or N·s/m.
    pub damping: f64,
    /// Position without force q₀, rad or m; `None`: the position at the touch, so that only the change of the spring force acts.
    pub free_position: Option<f64>,
    /// Constant force or moment τ of a drive, N·m or N.
    pub drive: f64,
}

/// Spring, damper and drive between two points during an impact in time: the force k (L₀ − L) − F(L̇) + P along the line of the points, which
/// pushes them apart.
#[derive(Clone, Debug, PartialEq)]
pub struct PointSpring {
    /// Link and point (m, axes of the link) of each end.
    pub ends: [(LinkId, Vector3<f64>); 2],
    /// Rate k, N/m.
    pub rate: f64,
    /// Length without force L₀, m; `None`: the length at the touch, so that only the change of the spring force acts.
    pub free_length: Option<f64>,
    /// Force F of the damper over the speed L̇; `None`: no damper.
    pub damper: Option<Arc<DamperCurve>>,
    /// Constant force P of a drive, N.
    pub drive: f64,
}

impl Support {
    /// Force (N) at a displacement s (m) and its rate (m/s) along the direction, without the part that is balanced.
    pub fn force_at(&self, displacement: f64, rate: f64) -> f64 {
        (self.force - self.rate * displacement - self.damping * rate).max(0.0)
    }
}

impl PointSpring {
    /// Spring alone. `free_length`: as the field.
    pub fn new(ends: [(LinkId, Vector3<f64>); 2], rate: f64, free_length: Option<f64>) -> Self {
        Self { ends, rate, free_length, damper: None, drive: 0.0 }
    }
}

/// Support of a point by the ground that never pulls, such as a tyre during an impact in time: the force max(0, P − k s − c ṡ) along a fixed
/// direction, s: displacement of the point along the direction since the touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Support {
    /// The link.
    pub link: LinkId,
    /// Point of the link, m, axes of the link.
    pub point: Vector3<f64>,
    /// Direction of the force on the link, world axes, unit length.
    pub direction: Vector3<f64>,
    /// Stiffness k, N/m.
    pub rate: f64,
    /// Damping c, N·s/m.
    pub damping: f64,
    /// Force at the touch P, N.
    pub force: f64,
    /// True if other forces balance P at the touch, so that only the change of the force acts.
    pub is_balanced: bool,
}

/// Springs, dampers, drives and supports of a mechanism.
#[derive(Clone, Debug, Default)]
pub(crate) struct SpringForces {
    pub joints: Vec<SpringAtJoint>,
    /// All with a free length.
    pub lines: Vec<PointSpring>,
    /// Each with the position of its point along the direction at the touch, m, world axes.
    pub supports: Vec<(Support, f64)>,
}

impl SpringForces {
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty() && self.lines.is_empty() && self.supports.is_empty()
    }

    /// True if the slope of a force jumps at some speed, or where a support is left.
    pub fn has_kinks(&self) -> bool {
        let mut curves = self.lines.iter().filter_map(|spring| spring.damper.as_ref());
        !self.supports.is_empty() || curves.any(|curve| curve.speeds().len() > 2)
    }
}

/// Spring, damper and drive of a joint with one velocity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpringAtJoint {
    pub joint: JointId,
    pub other: Option<JointId>,
    /// N·m/rad or N/m.
    pub stiffness: f64,
    /// N·m·s/rad or N·s/m.
    pub damping: f64,
    /// Position without force, rad or m.
    pub free_position: f64,
    /// N·m or N.
    pub drive: f64,
}
