//! Units of length of files.

use crate::unit::{Dimension, Unit};

/// Unit of length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthUnit {
    /// Metre, m.
    #[default]
    Metre,
    /// Centimetre, cm.
    Centimetre,
    /// Millimetre, mm.
    Millimetre,
    /// Inch, 25.4 mm.
    Inch,
}

impl LengthUnit {
    /// All units.
    pub const ALL: [Self; 4] = [Self::Metre, Self::Centimetre, Self::Millimetre, Self::Inch];

    /// Name: `m`, `cm`, `mm` or `in`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
            Self::Inch => "in",
        }
    }

    /// Unit with the given name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == name)
    }

    fn unit(self) -> &'static Unit {
        Unit::named(self.name(), &[Dimension::Length]).expect("the table has every unit of length")
    }

    /// Converts a length to metres.
    pub fn to_metres(self, length: f64) -> f64 {
        self.unit().to_si(length)
    }

    /// Unit of results about a file in this unit: inches for inches, otherwise millimetres.
    pub fn of_results(self) -> Self {
        match self {
            Self::Inch => Self::Inch,
            Self::Metre | Self::Centimetre | Self::Millimetre => Self::Millimetre,
        }
    }

    /// Length (m) as text in this unit, to about a hundredth of a millimetre.
    pub fn text(self, metres: f64) -> String {
        format!("{:.*} {}", self.decimals(), self.of_metres(metres), self.name())
    }

    /// Number of decimals that show about a hundredth of a millimetre.
    pub fn decimals(self) -> usize {
        match self {
            Self::Metre => 5,
            Self::Centimetre | Self::Inch => 3,
            Self::Millimetre => 2,
        }
    }

    /// Converts metres to this unit.
    pub fn of_metres(self, length: f64) -> f64 {
        self.unit().from_si(length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_length_are_those_of_the_table() {
        // Feet are units of single values, not of files.
        let names = Dimension::Length.units().map(|unit| unit.name).filter(|name| *name != "ft");
        let names: Vec<&str> = names.collect();
        assert_eq!(LengthUnit::ALL.map(LengthUnit::name).as_slice(), names);
        for unit in LengthUnit::ALL {
            assert_eq!(LengthUnit::from_name(unit.name()), Some(unit));
        }
        assert_eq!(LengthUnit::Millimetre.to_metres(12.0), 0.012);
        assert_eq!(LengthUnit::Inch.to_metres(1.0), 0.0254);
        assert_eq!(LengthUnit::Inch.of_results().text(0.03), "1.181 in");
        assert_eq!(LengthUnit::Metre.of_results().text(0.03), "30.00 mm");
    }
}
