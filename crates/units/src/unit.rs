//! Table of units.

use std::f64::consts::PI;
use std::fmt;

/// Dimension of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Length, m.
    Length,
    /// Angle, rad.
    Angle,
    /// Mass, kg.
    Mass,
    /// Moment of inertia, kg·m².
    Inertia,
    /// Stiffness, N/m.
    Stiffness,
    /// Rotational stiffness, N·m/rad.
    RotationalStiffness,
    /// Damping, N·s/m.
    Damping,
    /// Rotational damping, N·m·s/rad.
    RotationalDamping,
    /// Speed, m/s.
    Speed,
    /// Angular speed, rad/s.
    AngularSpeed,
    /// Force, N.
    Force,
    /// Moment of a force, N·m.
    Moment,
    /// Pressure, Pa. A number without a unit is in N/cm².
    Pressure,
    /// Area, m². A number without a unit is in cm².
    Area,
    /// Energy, J.
    Energy,
    /// Momentum, N·s.
    Momentum,
    /// Angular momentum, N·m·s.
    AngularMomentum,
    /// Acceleration, m/s².
    Acceleration,
    /// Time, s.
    Time,
    /// Ratio: a plain number or per cent.
    Ratio,
    /// Dimensionless, or in a unit that has no name here.
    Plain,
}

/// Unit of a dimension, with its name as text.
#[derive(Debug, PartialEq)]
pub struct Unit {
    /// Name.
    pub name: &'static str,
    /// Dimension.
    pub dimension: Dimension,
    /// Number of these units in the SI unit, for output.
    pub per_si: f64,
    factor: f64,
    divisor: f64,
}

/// Unit with SI value = number · `factor` / `divisor`.
const fn unit(name: &'static str, dimension: Dimension, factor: f64, divisor: f64) -> Unit {
    Unit { name, dimension, per_si: divisor / factor, factor, divisor }
}

/// International avoirdupois pound, kg (exact).
const POUND: f64 = 0.45359237;
/// Weight of a pound at standard gravity 9.80665 m/s², N (exact).
const POUND_FORCE: f64 = 4.4482216152605;

/// All units: SI value = number · factor / divisor. The first unit of a dimension is the one of a number without a unit.
///
/// Divisors keep 12 mm = 0.012 m exact, because 1/1000 is not a binary number.
static UNITS: &[Unit] = &[
    unit("m", Dimension::Length, 1.0, 1.0),
    unit("cm", Dimension::Length, 1.0, 100.0),
    unit("mm", Dimension::Length, 1.0, 1e3),
    unit("in", Dimension::Length, 254.0, 1e4),
    unit("ft", Dimension::Length, 3048.0, 1e4),
    unit("rad", Dimension::Angle, 1.0, 1.0),
    unit("deg", Dimension::Angle, PI / 180.0, 1.0),
    unit("°", Dimension::Angle, PI / 180.0, 1.0),
    unit("kg", Dimension::Mass, 1.0, 1.0),
    unit("g", Dimension::Mass, 1.0, 1e3),
    unit("t", Dimension::Mass, 1e3, 1.0),
    unit("lb", Dimension::Mass, POUND, 1.0),
    unit("slug", Dimension::Mass, POUND_FORCE * 1e4, 3048.0),
    unit("kg m2", Dimension::Inertia, 1.0, 1.0),
    unit("kg cm2", Dimension::Inertia, 1.0, 1e4),
    unit("kg mm2", Dimension::Inertia, 1.0, 1e6),
    unit("g mm2", Dimension::Inertia, 1.0, 1e9),
    unit("g cm2", Dimension::Inertia, 1.0, 1e7),
    unit("t mm2", Dimension::Inertia, 1.0, 1e3),
    unit("lb in2", Dimension::Inertia, POUND * 254.0 * 254.0, 1e8),
    unit("lb ft2", Dimension::Inertia, POUND * 3048.0 * 3048.0, 1e8),
    unit("slug ft2", Dimension::Inertia, POUND_FORCE * 3048.0, 1e4),
    unit("N/m", Dimension::Stiffness, 1.0, 1.0),
    unit("MN/m", Dimension::Stiffness, 1e6, 1.0),
    unit("kN/mm", Dimension::Stiffness, 1e6, 1.0),
    unit("kN/m", Dimension::Stiffness, 1e3, 1.0),
    unit("N/mm", Dimension::Stiffness, 1e3, 1.0),
    unit("lbf/in", Dimension::Stiffness, POUND_FORCE * 1e4, 254.0),
    unit("lb/in", Dimension::Stiffness, POUND_FORCE * 1e4, 254.0),
    unit("lbf/ft", Dimension::Stiffness, POUND_FORCE * 1e4, 3048.0),
    unit("N·m/rad", Dimension::RotationalStiffness, 1.0, 1.0),
    unit("N·m/deg", Dimension::RotationalStiffness, 180.0, PI),
    unit("N·s/m", Dimension::Damping, 1.0, 1.0),
    unit("N·s/mm", Dimension::Damping, 1e3, 1.0),
    unit("N·m·s/rad", Dimension::RotationalDamping, 1.0, 1.0),
    unit("N·m·s/deg", Dimension::RotationalDamping, 180.0, PI),
    unit("m/s", Dimension::Speed, 1.0, 1.0),
    unit("mm/s", Dimension::Speed, 1.0, 1e3),
    unit("cm/s", Dimension::Speed, 1.0, 100.0),
    unit("km/h", Dimension::Speed, 1.0, 3.6),
    unit("ft/s", Dimension::Speed, 3048.0, 1e4),
    unit("in/s", Dimension::Speed, 254.0, 1e4),
    unit("mph", Dimension::Speed, 44704.0, 1e5),
    unit("m/s2", Dimension::Acceleration, 1.0, 1.0),
    unit("mm/s2", Dimension::Acceleration, 1.0, 1e3),
    unit("g", Dimension::Acceleration, 9.80665, 1.0),
    unit("rad/s", Dimension::AngularSpeed, 1.0, 1.0),
    unit("deg/s", Dimension::AngularSpeed, PI, 180.0),
    unit("rpm", Dimension::AngularSpeed, PI, 30.0),
    unit("N", Dimension::Force, 1.0, 1.0),
    unit("kN", Dimension::Force, 1e3, 1.0),
    unit("lbf", Dimension::Force, POUND_FORCE, 1.0),
    unit("N·m", Dimension::Moment, 1.0, 1.0),
    unit("kN·m", Dimension::Moment, 1e3, 1.0),
    unit("N/cm2", Dimension::Pressure, 1e4, 1.0),
    unit("N/mm2", Dimension::Pressure, 1e6, 1.0),
    unit("MPa", Dimension::Pressure, 1e6, 1.0),
    unit("kPa", Dimension::Pressure, 1e3, 1.0),
    unit("Pa", Dimension::Pressure, 1.0, 1.0),
    unit("cm2", Dimension::Area, 1.0, 1e4),
    unit("mm2", Dimension::Area, 1.0, 1e6),
    unit("m2", Dimension::Area, 1.0, 1.0),
    unit("J", Dimension::Energy, 1.0, 1.0),
    unit("mJ", Dimension::Energy, 1.0, 1e3),
    unit("kJ", Dimension::Energy, 1e3, 1.0),
    unit("N·s", Dimension::Momentum, 1.0, 1.0),
    unit("kg·m/s", Dimension::Momentum, 1.0, 1.0),
    unit("N·m·s", Dimension::AngularMomentum, 1.0, 1.0),
    unit("kg·m²/s", Dimension::AngularMomentum, 1.0, 1.0),
    unit("s", Dimension::Time, 1.0, 1.0),
    unit("ms", Dimension::Time, 1.0, 1e3),
    unit("us", Dimension::Time, 1.0, 1e6),
    unit("%", Dimension::Ratio, 1.0, 100.0),
];

/// Name in a form without alternatives: `kg·mm²`, `kg*mm^2` and `kg mm2` are one unit.
fn canonical(name: &str) -> String {
    let is_kept = |c: &char| !c.is_whitespace() && !['·', '*', '^'].contains(c);
    name.replace('²', "2").chars().filter(is_kept).collect()
}

impl Unit {
    /// Unit of one of the dimensions with this name. `·`, `*`, a blank and nothing are the same, as are `²`, `^2` and `2`.
    pub fn named(name: &str, dimensions: &[Dimension]) -> Option<&'static Self> {
        let wanted = canonical(name);
        let has_name = |unit: &Unit| unit.name == name || canonical(unit.name) == wanted;
        UNITS.iter().find(|unit| dimensions.contains(&unit.dimension) && has_name(unit))
    }

    /// Converts a number in this unit to SI units.
    pub fn to_si(&self, number: f64) -> f64 {
        number * self.factor / self.divisor
    }

    /// Converts a number in SI units to this unit.
    pub fn from_si(&self, number: f64) -> f64 {
        number * self.divisor / self.factor
    }
}

impl Dimension {
    /// All units of the dimension.
    pub fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |unit| unit.dimension == self)
    }

    /// Unit of a number without a unit; `None` for plain numbers and ratios.
    pub fn default_unit(self) -> Option<&'static Unit> {
        if self == Dimension::Ratio { None } else { self.units().next() }
    }

    /// Unit for pictures and texts: mm for lengths, deg for angles; `None` for other dimensions.
    pub fn display_unit(self) -> Option<&'static Unit> {
        match self {
            Dimension::Length => Unit::named("mm", &[self]),
            Dimension::Angle => Unit::named("deg", &[self]),
            _ => None,
        }
    }

    /// SI unit; empty for plain numbers and ratios.
    pub fn si_unit(self) -> &'static str {
        match self {
            Dimension::Length => "m",
            Dimension::Angle => "rad",
            Dimension::Mass => "kg",
            Dimension::Inertia => "kg·m²",
            Dimension::Stiffness => "N/m",
            Dimension::RotationalStiffness => "N·m/rad",
            Dimension::Damping => "N·s/m",
            Dimension::RotationalDamping => "N·m·s/rad",
            Dimension::Speed => "m/s",
            Dimension::AngularSpeed => "rad/s",
            Dimension::Force => "N",
            Dimension::Moment => "N·m",
            Dimension::Pressure => "Pa",
            Dimension::Area => "m²",
            Dimension::Energy => "J",
            Dimension::Momentum => "N·s",
            Dimension::AngularMomentum => "N·m·s",
            Dimension::Acceleration => "m/s²",
            Dimension::Time => "s",
            Dimension::Ratio | Dimension::Plain => "",
        }
    }
}

/// Name with the SI unit, for messages.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Dimension::Length => "a length",
            Dimension::Angle => "an angle",
            Dimension::Mass => "a mass",
            Dimension::Inertia => "a moment of inertia",
            Dimension::Stiffness => "a stiffness",
            Dimension::RotationalStiffness => "a rotational stiffness",
            Dimension::Damping => "a damping",
            Dimension::RotationalDamping => "a rotational damping",
            Dimension::Speed => "a speed",
            Dimension::AngularSpeed => "an angular speed",
            Dimension::Force => "a force",
            Dimension::Moment => "a moment",
            Dimension::Pressure => "a pressure",
            Dimension::Area => "an area",
            Dimension::Energy => "an energy",
            Dimension::Momentum => "a momentum",
            Dimension::AngularMomentum => "an angular momentum",
            Dimension::Acceleration => "an acceleration",
            Dimension::Time => "a time",
            Dimension::Ratio => "a ratio",
            Dimension::Plain => "a plain number",
        };
        match self.si_unit() {
            "" => f.write_str(name),
            unit => write!(f, "{name} ({unit})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_unit_of_a_dimension() {
        for (i, unit) in UNITS.iter().enumerate() {
            let same = |other: &&Unit| {
                other.dimension == unit.dimension && canonical(other.name) == canonical(unit.name)
            };
            assert_eq!(UNITS.iter().position(|other| same(&other)), Some(i), "{}", unit.name);
            let back = unit.from_si(unit.to_si(123.4));
            assert!((back / 123.4 - 1.0).abs() < 4.0 * f64::EPSILON, "{}: {back}", unit.name);
            assert!((unit.to_si(unit.per_si) - 1.0).abs() < 2.0 * f64::EPSILON, "{}", unit.name);
        }
    }

    #[test]
    fn names_have_several_forms() {
        for name in ["kg mm2", "kg·mm²", "kg*mm^2", " kg  mm2 ", "kgmm2"] {
            assert_eq!(
                Unit::named(name, &[Dimension::Inertia]).map(|unit| unit.to_si(5e4)),
                Some(0.05),
                "{name}"
            );
        }
        assert!(Unit::named("kg*m/s", &[Dimension::Momentum]).is_some());
        assert!(Unit::named("mm", &[Dimension::Mass, Dimension::Angle]).is_none());
        assert!(Unit::named("MM", &[Dimension::Length]).is_none());
    }
}
