//! The regions of the human body: where a robot may hit a person.

use crate::ContactLawError;
use crate::error::nearest;
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;

/// A region of the human body, as a mass on a spring.
///
/// The table is informational: public secondary copies of ISO/TS 15066:2016's values, the standard itself not opened.
/// Check it against the purchased standard before anything depends on it. Limits of force and pressure are not in it:
/// public copies of those contradict each other.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct BodyRegion {
    /// As it is written in files and on the command line.
    pub name: String,
    /// A title for display.
    pub title: String,
    /// Its effective mass, in kg.
    pub mass: f64,
    /// Its effective spring, in N/m.
    pub stiffness: f64,
    /// What is less certain about the row.
    pub note: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    region: Vec<BodyRegion>,
}

/// Read once; that it can be read is a test of this file.
static TABLE: LazyLock<Vec<BodyRegion>> = LazyLock::new(|| {
    let read = toml::from_str::<Table>(include_str!("../data/body_regions.toml"));
    read.map(|table| table.region).unwrap_or_default()
});

impl BodyRegion {
    /// The whole table.
    pub fn all() -> &'static [Self] {
        &TABLE
    }

    /// The region of this name, upper and lower case alike. Errors: [`ContactLawError::UnknownRegion`].
    pub fn from_name(name: &str) -> Result<&'static Self, ContactLawError> {
        let wanted = name.trim().to_lowercase().replace(['_', ' '], "-");
        let names = || Self::all().iter().map(|region| region.name.as_str());
        Self::all().iter().find(|region| region.name == wanted).ok_or_else(|| {
            ContactLawError::UnknownRegion {
                name: name.into(),
                nearest: nearest(&wanted, names()),
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
            // In N/m: a value left in N/mm would be a thousand times less.
            assert!(region.stiffness >= 1e4 && region.stiffness <= 1.5e5, "{region:?}");
        }
    }
}
