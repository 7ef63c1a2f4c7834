//! Units of the results for a contact: at a point, or a moment about an axis.

/// Units of the results for a contact.
#[derive(Clone, Copy, Debug)]
pub struct ContactUnits {
    /// Name of m̄: effective mass or effective inertia.
    pub name: &'static str,
    pub mass: &'static str,
    pub speed: &'static str,
    pub impulse: &'static str,
    pub force: &'static str,
    /// SI unit of penetrations.
    pub length: &'static str,
    /// Unit in which penetrations are shown: a thousandth of the SI unit.
    pub small_length: &'static str,
}

impl ContactUnits {
    /// Units for a contact at a point, or for a moment (about an axis, or at the stop of a revolute joint).
    pub fn new(is_moment: bool) -> Self {
        if is_moment {
            return Self {
                name: "effective inertia",
                mass: "kg·m²",
                speed: "rad/s",
                impulse: "N·m·s",
                force: "N·m",
                length: "rad",
                small_length: "mrad",
            };
        }
        Self {
            name: "effective mass",
            mass: "kg",
            speed: "m/s",
            impulse: "N·s",
            force: "N",
            length: "m",
            small_length: "mm",
        }
    }
}
