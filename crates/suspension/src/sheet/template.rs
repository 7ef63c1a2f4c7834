//! Template of a sheet, as read from its data file in `templates`.

use crate::corner::CHASSIS;
use crate::corner::design::{DerivedPoint, ON_DAMPER, Part, STOPS};
use crate::options::Side;
use percuss_formats::reading::quoted;
use percuss_mechanism::near_names;
use percuss_spatial::Matrix3;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use toml::Spanned;

/// Template of a sheet. The example values are invented and describe no actual vehicle.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Template {
    pub name: String,
    /// Description in one line.
    pub title: String,
    /// Advice for the user.
    pub about: Vec<String>,
    /// True if both sides are on one axle and always built together.
    #[serde(default)]
    pub axle: bool,
    /// True if the wheel is in the vehicle's middle plane: the template has one side.
    #[serde(default)]
    pub middle: bool,
    /// Construction steps, parents first.
    pub parts: Vec<Part>,
    /// Two points of the axis about which the wheel carrier turns when it is steered, each with the link to which it is
    /// fixed; empty if the axis is not fixed to two ball joints.
    #[serde(default)]
    pub steering_axis: Vec<(String, String)>,
    /// Hardpoints with example values in mm, in the axes of ISO 8855, left side.
    #[serde(deserialize_with = "in_file_order")]
    pub points: Vec<(String, [f64; 3])>,
    /// Points that follow from the hardpoints.
    #[serde(default, deserialize_with = "in_file_order")]
    pub derived: Vec<(String, DerivedPoint)>,
    /// Bodies with example values.
    #[serde(deserialize_with = "in_file_order")]
    pub bodies: Vec<(String, ExampleBody)>,
    /// Default links for the attachment of springs and similar parts: section and link.
    #[serde(deserialize_with = "in_file_order")]
    pub on: Vec<(String, String)>,
    /// Example gaps of the stops, mm.
    #[serde(default = "example_gaps")]
    pub gaps: [(String, f64); 2],
}

/// Example gaps of the stops, mm.
fn example_gaps() -> [(String, f64); 2] {
    [("bump_stop".to_owned(), 30.0), ("rebound_stop".to_owned(), 25.0)]
}

/// Description of each key of the sheets, and the parts that every template has.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    /// Parts of the anti-roll bar.
    pub anti_roll_bar: Vec<Part>,
    /// Meaning of each hardpoint, the same in every template.
    #[serde(deserialize_with = "in_file_order")]
    pub points: Vec<(String, String)>,
    /// Description of each body.
    #[serde(deserialize_with = "in_file_order")]
    pub bodies: Vec<(String, String)>,
}

/// Body with example values.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ExampleBody {
    #[serde(default)]
    pub shape: Shape,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass, mm.
    #[serde(default)]
    pub com: [f64; 3],
    /// xx, yy, zz and, if not zero, xy, xz, yz about the centre of mass, kg·m².
    #[serde(default)]
    pub inertia: Vec<f64>,
}

/// Data of a body that a sheet must contain.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Shape {
    /// Mass, centre of mass, inertia.
    #[default]
    Any,
    /// No data (a massless rod), the mass (a slender rod), or all data.
    Rod,
    /// Rotating body: the centre of mass defaults to the wheel centre.
    Spindle,
    /// Optional.
    Optional,
}

/// Entries of a TOML table in the order of the file; the parser sorts them by key.
fn in_file_order<'de, D, T>(deserializer: D) -> Result<Vec<(String, T)>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let table = BTreeMap::<String, Spanned<T>>::deserialize(deserializer)?;
    let mut entries: Vec<(String, Spanned<T>)> = table.into_iter().collect();
    entries.sort_by_key(|(_, value)| value.span().start);
    Ok(entries.into_iter().map(|(key, value)| (key, value.into_inner())).collect())
}

/// Symmetric matrix from xx, yy, zz and, if given, xy, xz, yz; default 0.
pub(super) fn symmetric_matrix(values: &[f64]) -> Matrix3<f64> {
    let at = |i: usize| values.get(i).copied().unwrap_or(0.0);
    let [xx, yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4, 5].map(at);
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

impl Template {
    /// Side or sides that are always built, with the reason; `None` if the sheet determines them.
    pub fn only_build(&self) -> Option<(Side, &'static str)> {
        match (self.axle, self.middle) {
            (true, _) => Some((Side::Both, "both sides are on one axle: both are built")),
            (_, true) => {
                Some((Side::Left, "the wheel is in the middle plane: there is one side, build = \"left\""))
            }
            (false, false) => None,
        }
    }

    /// True if the template has tie rods.
    pub fn has_rack(&self) -> bool {
        self.point("tie_rod_inner").is_some()
    }

    /// Links on a hinge on the chassis, on which a torsion bar can be.
    pub fn hinged_links(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().filter_map(|part| match part {
            Part::Hinge { link, parent, .. } | Part::Swivel { link, parent, .. } if parent == CHASSIS => {
                Some(&**link)
            }
            _ => None,
        })
    }

    /// Links that the key `on` of a section can name. A pushrod cannot be on a rod, because the rods are built after the pushrod. Rods
    /// common to both sides are excluded, because their frames belong to no side.
    pub fn holders_of(&self, section: &str) -> impl Iterator<Item = &str> {
        let is_pushrod = section == "pushrod";
        let is_rod = move |key: &str| {
            !is_pushrod
                && !self.is_central_body(key)
                && self.parts.iter().any(|part| matches!(part, Part::Rod { link, .. } if link == key))
        };
        let bodies = self.bodies.iter().map(|(key, _)| &**key);
        bodies.filter(move |key| is_rod(key) || self.solid_holders().any(|holder| holder == *key))
    }

    /// True if the parts of a section are usually on its default link: on an axle, on the arm or fork of a motorcycle, on a rocker, or on
    /// the only link that can carry them.
    pub fn has_usual_body(&self, section: &str) -> bool {
        let is_on_rocker = self.on.iter().any(|(key, link)| key == section && link == "rocker");
        self.axle || self.middle || is_on_rocker || self.holders_of(section).count() < 2
    }

    /// Message about sections without a stated link: the assumed and the possible links.
    pub fn assumed_bodies(&self, sections: &[&str]) -> String {
        let assumed = self.on.iter().filter(|(section, _)| sections.contains(&&**section));
        let assumed = assumed.map(|(section, link)| format!("{section} ({link} is assumed)"));
        let possible = sections.first().into_iter().flat_map(|first| self.holders_of(first));
        format!(
            "the sheet does not state the body of {}: write the key on in each of these sections, with one of {}",
            assumed.collect::<Vec<_>>().join(", "),
            possible.collect::<Vec<_>>().join(", ")
        )
    }

    /// Checks the link that a section is on; the error lists the possible links.
    pub fn check_holder(&self, section: &str, link: &str) -> Result<(), String> {
        let mut holders: Vec<&str> = self.holders_of(section).collect();
        if STOPS.contains(&section) {
            holders.push(ON_DAMPER);
        }
        if holders.contains(&link) {
            return Ok(());
        }
        let near = near_names(link, holders.iter().copied()).into_iter().next();
        let near = near.map_or_else(String::new, |near| format!(" (did you mean {}?)", quoted(&near)));
        Err(format!(
            "{} is no link on which the {} of this template can be{near}: {}",
            quoted(link),
            section.replace('_', " "),
            holders.join(", ")
        ))
    }

    /// Links other than rods between two points.
    fn solid_holders(&self) -> impl Iterator<Item = &str> {
        let is_holder = |(key, body): &&(String, ExampleBody)| {
            let is_made = |part: &Part| match part {
                Part::Rod { .. } | Part::Wheel { .. } => false,
                Part::Hinge { link, .. }
                | Part::Swivel { link, .. }
                | Part::Ball { link, .. }
                | Part::Free { link, .. }
                | Part::Fixed { link, .. }
                | Part::Strut { link, .. }
                | Part::Slide { link, .. } => link == key,
                Part::Axle | Part::GuidedAxle { .. } => key == "axle",
                Part::Close { .. } => false,
            };
            let is_body_of_rod = |part: &Part| {
                matches!(part, Part::Rod { link, .. } if link == key) && body.shape == Shape::Any
            };
            self.parts.iter().any(|part| is_made(part) || is_body_of_rod(part))
        };
        self.bodies.iter().filter(is_holder).map(|(key, _)| &**key)
    }
}
