//! Regions of the human body that a robot may hit.

use crate::ContactLawError;
use crate::error::nearest;
use serde::Serialize;

/// Region of the human body, as a mass on a spring.
///
/// The table is informative. The values are from public secondary copies of ISO/TS 15066:2016; the standard itself
/// was not read. Compare them with the standard before use. The table has no limits of force and pressure, because
/// public copies of these limits contradict each other.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BodyRegion {
    /// Name in files and on the command line.
    pub name: &'static str,
    /// Title for display.
    pub title: &'static str,
    /// Effective mass, in kg.
    pub mass: f64,
    /// Effective stiffness, in N/m.
    pub stiffness: f64,
    /// Remark on the uncertainty of the values.
    pub note: Option<&'static str>,
}

/// Regions: name, title, mass in kg, stiffness in N/m, note.
///
/// The values are those on which public secondary copies of ISO/TS 15066:2016 (now part of ISO 10218-2:2025) agree:
/// open-source code that cites the standard, and a page of a manufacturer for the stiffness. Rows with a note are less certain.
const REGIONS: [BodyRegion; 12] = [
    region("skull", "Skull and forehead", 4.4, 150e3, None),
    region(
        "face",
        "Face",
        4.4,
        75e3,
        Some("the face's own stiffness, apart from the skull's, is from memory of the literature"),
    ),
    region("neck", "Neck", 1.2, 50e3, Some("10e3 N/m is given for the larynx")),
    region(
        "back",
        "Back and shoulders",
        40.0,
        35e3,
        Some("the shoulders' mass is from memory of the literature"),
    ),
    region("chest", "Chest", 40.0, 25e3, None),
    region("abdomen", "Abdomen", 40.0, 10e3, None),
    region("pelvis", "Pelvis", 40.0, 25e3, None),
    region("upper-arm", "Upper arm and elbow", 3.0, 30e3, None),
    region("lower-arm", "Lower arm and wrist", 2.0, 40e3, None),
    region("hand", "Hand and fingers", 0.6, 75e3, None),
    region("thigh", "Thigh and knee", 75.0, 50e3, None),
    region("lower-leg", "Lower leg", 75.0, 60e3, None),
];

const fn region(
    name: &'static str,
    title: &'static str,
    mass: f64,
    stiffness: f64,
    note: Option<&'static str>,
) -> BodyRegion {
    BodyRegion { name, title, mass, stiffness, note }
}

impl BodyRegion {
    /// All regions.
    pub fn all() -> &'static [Self] {
        &REGIONS
    }

    /// Returns the region of a name, ignoring case. Errors: [`ContactLawError::UnknownRegion`].
    pub fn from_name(name: &str) -> Result<&'static Self, ContactLawError> {
        let normalised = name.trim().to_lowercase().replace(['_', ' '], "-");
        let names = || Self::all().iter().map(|region| region.name);
        Self::all().iter().find(|region| region.name == normalised).ok_or_else(|| {
            ContactLawError::UnknownRegion {
                name: name.into(),
                nearest: nearest(&normalised, names()),
                known: names().collect::<Vec<_>>().join(", "),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::BodyRegion;

    #[test]
    fn the_values_are_in_si_units() {
        for region in BodyRegion::all() {
            assert!(region.mass >= 0.6 && region.mass <= 75.0, "{region:?}");
            // In N/m: a value in N/mm would be smaller by a factor of 1000.
            assert!(region.stiffness >= 1e4 && region.stiffness <= 1.5e5, "{region:?}");
        }
    }
}
