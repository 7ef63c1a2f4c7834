//! Loads of the elastokinematics, and the anti-roll bar.

use crate::kinematics::linkage_motion::LinkageMotion;
use nalgebra::Vector3;
use percuss_dynamics::{ElementMotion, LinearElement, Pose};
use percuss_mechanism::{JointId, Mechanism};

/// Wheels on which a load of the elastokinematics acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadedWheels {
    /// The wheel of the quantity alone; on the right wheel, the mirror image of the load on the left wheel.
    Single,
    /// Both wheels, with the same vector.
    Parallel,
    /// Both wheels, with opposite vectors; that of the left wheel is positive.
    Opposed,
}

/// Loads of the elastokinematics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ComplianceLoads {
    /// Wheels on which a load acts.
    pub wheels: LoadedWheels,
    /// True if the heights of the wheel centres are held. Otherwise the springs hold the wheels.
    pub travel_held: bool,
}

/// Unit load on a wheel, in the axes of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadCase {
    /// Name in the columns.
    pub name: &'static str,
    /// Direction of the force or moment on the left wheel.
    pub vector: Vector3<f64>,
    /// Direction in words.
    pub direction: &'static str,
    /// True for a moment, which acts on the whole wheel.
    pub is_moment: bool,
    /// True if the force acts at the wheel centre: a driving torque comes from the body by a shaft. Otherwise it acts at the contact point.
    pub is_at_centre: bool,
}

impl LoadCase {
    /// Loads of the elastokinematics. The wheel is locked to its carrier in all of them.
    pub fn all() -> [Self; 5] {
        let case =
            |name, vector, direction| Self { name, vector, direction, is_moment: false, is_at_centre: false };
        [
            case("lateral_force", Vector3::y(), "to the left"),
            case("braking_force", -Vector3::x(), "backward"),
            Self { is_at_centre: true, ..case("driving_force", Vector3::x(), "forward") },
            case("vertical_force", Vector3::z(), "up"),
            Self { is_moment: true, ..case("aligning_torque", Vector3::z(), "counterclockwise from above") },
        ]
    }

    /// Factor of the load on the right wheel, per load on the left wheel or, for a single wheel, per load in its own case.
    pub fn factor_on_right(&self, wheels: LoadedWheels) -> f64 {
        match wheels {
            LoadedWheels::Single => self.mirrored(),
            LoadedWheels::Parallel => 1.0,
            LoadedWheels::Opposed => -1.0,
        }
    }

    /// Factor of the mirror image of the load.
    fn mirrored(&self) -> f64 {
        // A force across the middle plane, and a moment about an axis in this plane, change their sign.
        if (self.vector.y != 0.0) != self.is_moment { -1.0 } else { 1.0 }
    }
}

/// Anti-roll bar with a stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AntiRollBar {
    /// Hinge of a half of the bar.
    pub joint: JointId,
    /// Hinge of the other half; `None`: the model has one side, and the other half is at rest.
    pub other: Option<JointId>,
    /// Torsional stiffness, N·m/rad.
    pub stiffness: f64,
}

impl AntiRollBar {
    /// Anti-roll bar of an imported suspension, of a torsional stiffness (N·m/rad).
    pub fn of_suspension(mechanism: &Mechanism, stiffness: f64) -> Option<Self> {
        let name = |id| mechanism.link(id).name();
        let is_bar = |name: &str| {
            let end = name.strip_prefix("anti_roll_bar");
            end.is_some_and(|end| matches!(end, "" | "_left" | "_right"))
        };
        let links = mechanism.link_ids().filter(|id| is_bar(name(*id)));
        let hinges: Vec<JointId> = links.filter_map(|id| mechanism.parent_joint(id)).collect();
        Some(Self { joint: *hinges.first()?, other: hinges.get(1).copied(), stiffness })
    }

    /// Vertical rate at each of `wheels` wheels, along a motion with the rate `travel` of the travel of a wheel: (k φ′² + k φ φ″)/n with the
    /// stiffness k, the twist φ and its derivatives, N/m.
    pub(super) fn rate_at_wheel(
        &self,
        pose: &Pose,
        drawn: &Pose,
        motion: &LinkageMotion<'_>,
        (travel, wheels): (f64, usize),
    ) -> f64 {
        let twist = |of: &dyn Fn(JointId) -> f64| of(self.joint) - self.other.map_or(0.0, of);
        let [first, second] =
            [0, 1].map(|k| twist(&|joint| motion.hinge_rates(pose, joint)[k]) / travel.powi(k as i32 + 1));
        let angle = twist(&|joint| pose.joint(joint)[0] - drawn.joint(joint)[0]);
        self.stiffness * (first * first + angle * second) / wheels as f64
    }

    /// The bar as a linear element.
    pub fn element(&self) -> LinearElement {
        LinearElement::spring("anti-roll bar", ElementMotion::Twist(self.joint, self.other), self.stiffness)
    }
}
