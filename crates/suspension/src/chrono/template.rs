//! Templates of Chrono::Vehicle, as read from their data files.

use crate::corner::design::Part;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Texts of the data files, in the order of the list of templates.
const FILES: [&str; 6] = [
    include_str!("templates/DoubleWishbone.toml"),
    include_str!("templates/DoubleWishboneReduced.toml"),
    include_str!("templates/MacPhersonStrut.toml"),
    include_str!("templates/SemiTrailingArm.toml"),
    include_str!("templates/ThreeLinkIRS.toml"),
    include_str!("templates/MultiLink.toml"),
];

static TEMPLATES: LazyLock<Vec<ChronoTemplate>> = LazyLock::new(|| {
    FILES.iter().map(|text| toml::from_str(text).expect("a template of this crate is valid")).collect()
});

/// All templates.
pub(crate) fn templates() -> &'static [ChronoTemplate] {
    &TEMPLATES
}

/// Template of Chrono::Vehicle.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ChronoTemplate {
    /// Name in the file.
    pub name: String,
    /// Key of the flag that gives the inertias of all arms in the vehicle's axes.
    pub vehicle_axes_flag: Option<String>,
    /// Construction steps, parents first.
    pub parts: Vec<Part>,
    /// Links with the seats of spring and shock absorber.
    pub on: BTreeMap<String, String>,
    /// Sections in the order of reading.
    pub sections: Vec<SectionRule>,
    /// Axes that depend on points of several sections.
    #[serde(default)]
    pub planes: Vec<PlaneRule>,
}

/// Content of a section.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", tag = "kind")]
pub(crate) enum SectionRule {
    /// Body of a link, with its points.
    Body {
        key: String,
        /// Link with the mass; `None` if only the points are read.
        link: Option<String>,
        #[serde(default)]
        inertia: Notation,
        #[serde(default)]
        axes: InertiaAxes,
        /// Key in the file and name of each point.
        #[serde(default)]
        points: Vec<(String, String)>,
        /// Keys of the pins of a universal joint: the pin of the link alone, or the pins of chassis and link.
        #[serde(default)]
        pins: Vec<String>,
    },
    /// Strut, with an inertia in the vehicle's axes. A [`PlaneRule`] determines the centre of mass and the pins.
    Strut { key: String, link: String },
    /// Tie rod: a massless rod, or a body if it has a mass. `massless`: the mass is not read.
    TieRod {
        #[serde(default)]
        massless: bool,
    },
    /// Ends of a spring or shock absorber. `moving`: key of the end on the moving link; `seats`: names of the ends.
    Seats { key: String, moving: String, seats: [String; 2] },
}

/// Notation of inertias in a file.
#[derive(Clone, Copy, Default, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Notation {
    /// `Inertia`: three principal moments.
    #[default]
    Moments,
    /// `Moments of Inertia` and `Products of Inertia` (matrix entries xy, xz, yz).
    Products,
}

/// Axes of an inertia.
#[derive(Clone, Copy, Default, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum InertiaAxes {
    /// Axes of the vehicle.
    #[default]
    Vehicle,
    /// Axes of an arm: its points are the two points of the hinge and the outer point.
    Arm,
    /// x from the second point to the first.
    XInward,
    /// x from the first point to the second.
    XOutward,
    /// A plane of several sections.
    Plane,
}

/// Axes of a link between two points a and b: y along (a − third) × (b − third), z from a to b.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlaneRule {
    pub link: String,
    /// Points a and b.
    pub ends: [String; 2],
    pub third: String,
    /// Message if the points do not determine the axes.
    pub defect: String,
    /// Names of the ends of a strut: its centre of mass is half way between them, and its pins are x and y.
    pub strut: Option<[String; 2]>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_template_has_the_name_of_its_class() {
        let names: Vec<&str> = templates().iter().map(|template| &*template.name).collect();
        let classes = [
            "DoubleWishbone",
            "DoubleWishboneReduced",
            "MacPhersonStrut",
            "SemiTrailingArm",
            "ThreeLinkIRS",
            "MultiLink",
        ];
        assert_eq!(names, classes);
    }
}
