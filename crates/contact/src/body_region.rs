//! Regions of the human body that a robot may hit.

use crate::ContactLawError;
use crate::error::nearest;
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;

/// Region of the human body, as a mass on a spring.
///
/// The table is informative. The values are from public secondary copies of ISO/TS 15066:2016; the standard itself
/// was not read. Compare them with the standard before use. The table has no limits of force and pressure, because
/// public copies of these limits contradict each other.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct BodyRegion {
    /// Name in files and on the command line.
    pub name: String,
    /// Title for display.
    pub title: String,
    /// Effective mass, in kg.
    pub mass: f64,
    /// Effective stiffness, in N/m.
    pub stiffness: f64,
    /// Remark on the uncertainty of the values.
    pub note: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    region: Vec<BodyRegion>,
}

/// Table, parsed once; a test of this file checks that the parsing succeeds.
static TABLE: LazyLock<Vec<BodyRegion>> = LazyLock::new(|| {
    let read = toml::from_str::<Table>(include_str!("../data/body_regions.toml"));
    read.map(|table| table.region).unwrap_or_default()
});

impl BodyRegion {
    /// All regions.
    pub fn all() -> &'static [Self] {
        &TABLE
    }

    /// Returns the region of a name, ignoring case. Errors: [`ContactLawError::UnknownRegion`].
    pub fn from_name(name: &str) -> Result<&'static Self, ContactLawError> {
        let normalised = name.trim().to_lowercase().replace(['_', ' '], "-");
        let names = || Self::all().iter().map(|region| region.name.as_str());
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
    fn the_table_can_be_read() {
        assert_eq!(BodyRegion::all().len(), 12);
        for region in BodyRegion::all() {
            assert!(region.mass >= 0.6 && region.mass <= 75.0, "{region:?}");
            // In N/m: a value in N/mm would be smaller by a factor of 1000.
            assert!(region.stiffness >= 1e4 && region.stiffness <= 1.5e5, "{region:?}");
        }
    }
}
