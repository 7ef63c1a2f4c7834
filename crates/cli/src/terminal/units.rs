//! Units of the results for a contact: at a point, or a moment about an axis.

/// Name of a varied number in words: "wheel travel", "travel of wheel_centre"; joints keep their name.
pub fn varied_name(name: &str) -> String {
    match (name, name.strip_prefix("travel:")) {
        ("wheel-travel" | "travel:wheel_centre", _) => "wheel travel".to_owned(),
        (_, Some(link)) => format!("travel of {link}"),
        (_, None) => name.to_owned(),
    }
}

/// Units of the results for a contact.
#[derive(Clone, Copy, Debug)]
pub struct ContactUnits {
    /// Name of m̄: effective mass or effective inertia.
    pub name: &'static str,
    pub mass: &'static str,
    pub speed: &'static str,
    pub impulse: &'static str,
    pub force: &'static str,
    /// SI unit of compressions.
    pub length: &'static str,
    /// Unit in which compressions are shown: a thousandth of the SI unit.
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
