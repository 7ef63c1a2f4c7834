//! Loads of the elastokinematics, and the anti-roll bar.

use percuss_dynamics::{ElementMotion, LinearElement};
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

    /// The bar as a linear element.
    pub fn element(&self) -> LinearElement {
        LinearElement::spring("anti-roll bar", ElementMotion::Twist(self.joint, self.other), self.stiffness)
    }
}
