//! Quantities of a row: name, wheel, unit, and a value or the reason for its absence.

use percuss_units::LengthUnit;

/// Unit of a quantity, in SI and in tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KinematicUnit {
    /// m; in tables mm, or inches for a sheet in inches.
    Length,
    /// rad; deg in tables.
    Angle,
    /// rad/m; deg/m in tables.
    AnglePerLength,
    /// 1/m.
    PerLength,
    /// rad/N; deg/kN in tables.
    AnglePerForce,
    /// rad/(N·m); deg/(kN·m) in tables.
    AnglePerMoment,
    /// m/N; mm/kN in tables.
    LengthPerForce,
    /// m/(N·m); mm/(kN·m) in tables.
    LengthPerMoment,
    /// Plain number.
    Ratio,
    /// Plain number; per cent in tables.
    Percent,
    /// N/m; N/mm in tables.
    Stiffness,
    /// N.
    Force,
    /// N·m.
    Moment,
    /// kg.
    Mass,
    /// Hz.
    Frequency,
}

impl KinematicUnit {
    /// Name of the SI unit; empty for a plain number.
    pub fn si(self) -> &'static str {
        match self {
            KinematicUnit::Length => "m",
            KinematicUnit::Angle => "rad",
            KinematicUnit::AnglePerLength => "rad/m",
            KinematicUnit::PerLength => "1/m",
            KinematicUnit::AnglePerForce => "rad/N",
            KinematicUnit::AnglePerMoment => "rad/(N·m)",
            KinematicUnit::LengthPerForce => "m/N",
            KinematicUnit::LengthPerMoment => "m/(N·m)",
            KinematicUnit::Ratio | KinematicUnit::Percent => "",
            KinematicUnit::Stiffness => "N/m",
            KinematicUnit::Force => "N",
            KinematicUnit::Moment => "N·m",
            KinematicUnit::Mass => "kg",
            KinematicUnit::Frequency => "Hz",
        }
    }

    /// Unit of tables with its number per SI unit, and the number of decimals in a text. `length`: unit of lengths.
    pub fn of_table(self, length: LengthUnit) -> (&'static str, f64, usize) {
        match self {
            KinematicUnit::Length if length == LengthUnit::Inch => (length.name(), length.of_metres(1.0), 3),
            KinematicUnit::Length => ("mm", 1e3, 2),
            KinematicUnit::Angle => ("deg", 180.0 / std::f64::consts::PI, 4),
            KinematicUnit::AnglePerLength => ("deg/m", 180.0 / std::f64::consts::PI, 3),
            KinematicUnit::PerLength => ("1/m", 1.0, 4),
            KinematicUnit::AnglePerForce => ("deg/kN", 180e3 / std::f64::consts::PI, 4),
            KinematicUnit::AnglePerMoment => ("deg/(kN·m)", 180e3 / std::f64::consts::PI, 4),
            KinematicUnit::LengthPerForce => ("mm/kN", 1e6, 4),
            KinematicUnit::LengthPerMoment => ("mm/(kN·m)", 1e6, 4),
            KinematicUnit::Ratio => ("", 1.0, 4),
            KinematicUnit::Percent => ("%", 1e2, 2),
            KinematicUnit::Stiffness => ("N/mm", 1e-3, 3),
            KinematicUnit::Force => ("N", 1.0, 1),
            KinematicUnit::Moment => ("N·m", 1.0, 1),
            KinematicUnit::Mass => ("kg", 1.0, 3),
            KinematicUnit::Frequency => ("Hz", 1.0, 3),
        }
    }
}

/// Value of a quantity at a pose, or the reason for its absence.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicValue {
    /// Name of the quantity.
    pub name: String,
    /// Ending of the wheel's side: `_left`, `_right`, or empty for one wheel and for both together.
    pub side: &'static str,
    /// Unit.
    pub unit: KinematicUnit,
    /// Value in SI units, or the reason for its absence.
    pub value: Result<f64, String>,
}

/// Values of a pose, in the order of the columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KinematicValues(pub Vec<KinematicValue>);

impl KinematicValues {
    /// Adds a quantity of a wheel.
    pub(super) fn add(
        &mut self,
        side: &'static str,
        name: impl Into<String>,
        unit: KinematicUnit,
        value: Result<f64, String>,
    ) {
        // Adding 0 turns −0 into 0.
        let value = value.map(|x| x + 0.0);
        let value = value.and_then(|x| if x.is_finite() { Ok(x) } else { Err("not finite".to_owned()) });
        self.0.push(KinematicValue { name: name.into(), side, unit, value });
    }
}
