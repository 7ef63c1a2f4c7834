//! All templates of sheets and the descriptions of their keys, read from the data files in `templates`. Reading,
//! building, writing and the tables of the documentation use these data.

use super::names::vocabulary;
use super::template::{Keys, Template};
use crate::corner;
use crate::corner::design::{Part, SEATS, STOPS, is_central};
use crate::limits::MAX_SHEET_KEYS;
use percuss_formats::reading::quoted;
use percuss_mechanism::near_names;
use std::sync::LazyLock;

/// Texts of the data files, in the order of the list of templates.
const FILES: [&str; 21] = [
    include_str!("templates/double-wishbone.toml"),
    include_str!("templates/double-wishbone-rods.toml"),
    include_str!("templates/macpherson-strut.toml"),
    include_str!("templates/semi-trailing-arm.toml"),
    include_str!("templates/three-link.toml"),
    include_str!("templates/multi-link.toml"),
    include_str!("templates/five-link.toml"),
    include_str!("templates/pushrod/pushrod-rocker.toml"),
    include_str!("templates/pushrod/pushrod-third-spring.toml"),
    include_str!("templates/twist-beam.toml"),
    include_str!("templates/swing-axle.toml"),
    include_str!("templates/solid-axle/solid-axle-four-links.toml"),
    include_str!("templates/solid-axle/solid-axle-panhard.toml"),
    include_str!("templates/solid-axle/solid-axle-watt.toml"),
    include_str!("templates/solid-axle/solid-axle-de-dion.toml"),
    include_str!("templates/solid-axle/solid-axle-leaf-springs.toml"),
    include_str!("templates/motorcycle/swing-arm.toml"),
    include_str!("templates/motorcycle/telescopic-fork.toml"),
    include_str!("templates/motorcycle/rear-four-bar.toml"),
    include_str!("templates/motorcycle/rear-rocker-on-frame.toml"),
    include_str!("templates/motorcycle/rear-rocker-on-arm.toml"),
];

const KEYS_FILE: &str = include_str!("templates/keys.toml");

static TEMPLATES: LazyLock<Vec<Template>> = LazyLock::new(|| {
    FILES.iter().map(|text| toml::from_str(text).expect("a template of this crate is valid")).collect()
});

static KEYS: LazyLock<Keys> =
    LazyLock::new(|| toml::from_str(KEYS_FILE).expect("the descriptions of this crate are valid"));

/// All templates.
pub(crate) fn templates() -> impl Iterator<Item = &'static Template> + Clone {
    TEMPLATES.iter()
}

/// Names of all templates.
pub(super) fn template_names() -> Vec<&'static str> {
    templates().map(|template| &*template.name).collect()
}

/// Suggestion of the nearest known name; empty without one.
pub(super) fn suggestion<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> String {
    let near = near_names(name, known).into_iter().next();
    near.map_or_else(String::new, |near| format!("; did you mean {near}?"))
}

/// Descriptions of the keys of all templates.
pub(crate) fn keys() -> &'static Keys {
    &KEYS
}

/// Points of the anti-roll bar, optional as a whole.
pub(crate) const BAR_POINTS: [&str; 4] =
    ["anti_roll_bar_outer", "anti_roll_bar_inner", "drop_link_bar", "drop_link_end"];

/// Description of a key.
pub(crate) fn description_of<'t>(table: &'t [(String, String)], key: &str) -> &'t str {
    table.iter().find(|(known, _)| known == key).map_or("", |(_, text)| text)
}

impl Template {
    /// Parts of the template, then the parts of the anti-roll bar.
    pub fn parts_with_bar(&self) -> impl Iterator<Item = &Part> + Clone {
        self.parts.iter().chain(&keys().anti_roll_bar)
    }

    /// True for a body that both sides share; the sheet describes it as it is, on either side.
    pub fn is_central_body(&self, key: &str) -> bool {
        self.axle && ["axle", "middle_link", "panhard_rod"].contains(&key)
            || key.starts_with("watt")
            || key == corner::CHASSIS
    }

    /// Example position of a point, mm; `None` if the template does not have the point.
    pub fn point(&self, key: &str) -> Option<[f64; 3]> {
        self.points.iter().find(|(known, _)| known == key).map(|(_, at)| *at)
    }

    /// True if a hardpoint belongs to the axle as a whole, not to one side.
    pub fn is_central(&self, point: &str) -> bool {
        is_central(self.axle, point)
    }

    /// Group of points, given or left out as a whole, that contains this point; `None` for a mandatory point.
    pub fn optional_group(point: &str) -> Option<&'static [&'static str]> {
        let seats = SEATS.iter().find(|(_, pair)| pair.contains(&point));
        seats.map(|(_, pair)| &pair[..]).or_else(|| BAR_POINTS.contains(&point).then_some(&BAR_POINTS[..]))
    }
}

/// Keys of the head; any other key without a section is a point.
pub(super) const HEAD: [&str; 11] = [
    "template",
    "name",
    "unit",
    "inertia_unit",
    "axes",
    "side",
    "build",
    "points",
    "worksheet",
    "names",
    "masses",
];

/// Sections of springs and dampers that may have a mass.
pub(super) const MASSIVE_PARTS: [&str; 2] = ["spring", DAMPER];

/// Keys of the wheel.
const WHEEL_KEYS: [&str; 10] = [
    "mass",
    "inertia",
    "radius",
    "tyre",
    "camber",
    "toe",
    "half_track",
    "longitudinal_offset",
    "lateral_offset",
    "vertical_offset",
];

/// Pivot of a rocker in place of two points of its axis, and the direction of this axis.
pub(super) const ROCKER_PIVOT: &str = "points.rocker_pivot";
pub(super) const ROCKER_AXIS: &str = "rocker.axis";

/// Section of a torsion bar.
pub(super) const TORSION_BAR: &str = "torsion_bar";

/// Section of the half shaft.
pub(super) const HALF_SHAFT: &str = "half_shaft";

/// Section of the damper.
pub(super) const DAMPER: &str = "damper";

/// Sections of a template that may state a force: springs, the damper and stops.
pub(super) fn force_sections(template: &'static Template) -> Vec<&'static str> {
    let sections = template.on.iter().map(|(section, _)| &**section);
    sections
        .filter(|section| section.ends_with("spring") || *section == DAMPER || STOPS.contains(section))
        .collect()
}

/// Links of a template on universal joints, whose pins a sheet may state.
pub(super) fn universal_links(template: &'static Template) -> impl Iterator<Item = &'static str> {
    let links = template.parts_with_bar().filter_map(|part| Some(part.universal_link()?.0));
    links.filter(|link| template.bodies.iter().any(|(body, _)| body == link))
}

/// All keys of a template.
pub(super) fn keys_of(template: &'static Template) -> Vec<String> {
    let mut keys: Vec<String> = HEAD.iter().map(|key| (*key).to_owned()).collect();
    keys.extend(template.points.iter().map(|(key, _)| format!("points.{key}")));
    for body in template.bodies.iter().map(|(body, _)| &**body).chain([corner::CHASSIS]) {
        keys.extend(["mass", "com", "inertia"].map(|key| format!("{body}.{key}")));
    }
    keys.extend(universal_links(template).map(|link| format!("{link}.pin")));
    if template.point("rocker_front").is_some() {
        keys.extend([ROCKER_PIVOT, ROCKER_AXIS].map(str::to_owned));
    }
    if !template.middle {
        keys.extend(["mass", "outer"].map(|key| format!("{HALF_SHAFT}.{key}")));
    }
    keys.push("spindle.axle_inertia".to_owned());
    keys.extend(WHEEL_KEYS.map(|key| format!("wheel.{key}")));
    keys.extend(template.on.iter().map(|(section, _)| format!("{section}.on")));
    keys.extend(STOPS.iter().flat_map(|section| ["gap", "direction"].map(|key| format!("{section}.{key}"))));
    for section in force_sections(template) {
        let own: &[&str] = match section {
            DAMPER => &["damping", "speeds", "forces"],
            stop if STOPS.contains(&stop) => &["deflections", "forces", "coefficients", "exponents", "to"],
            _ => &["rate", "preload"],
        };
        keys.extend(own.iter().map(|key| format!("{section}.{key}")));
    }
    if template.hinged_links().next().is_some() {
        keys.extend(["on", "rate", "preload"].map(|key| format!("{TORSION_BAR}.{key}")));
    }
    keys.extend(MASSIVE_PARTS.map(|section| format!("{section}.mass")));
    keys.extend(["vertical", "damping", "load"].map(|key| format!("tyre.{key}")));
    if template.bodies.iter().any(|(body, _)| body == "anti_roll_bar") {
        keys.push("anti_roll_bar.stiffness".to_owned());
    }
    if template.has_rack() {
        keys.extend(["mass", "slides", "stiffness", "travel_per_turn"].map(|key| format!("rack.{key}")));
    }
    debug_assert!(keys.len() < MAX_SHEET_KEYS);
    keys
}

/// Message about an unknown key: the nearest key, and the known keys of its section, or the sections if the section is unknown; the
/// nearest come first.
pub(super) fn unknown_key_message(key: &str, known: &[String]) -> String {
    let mut near = near_keys(key, known.iter().map(String::as_str));
    let (section, last) = split(key);
    if section == "points" {
        // A point is similar to points only, unless it is a key of another section.
        near.retain(|other| split(other).0 == section || split(other).1 == last);
        let points = known.iter().filter_map(|other| other.strip_prefix("points."));
        near.splice(..0, vocabulary::near_meaning(last, points).map(|point| format!("points.{point}")));
    }
    let rank = |of: &str, near: &[&str]| near.iter().position(|other| *other == of).unwrap_or(near.len());
    let of_section = known.iter().map(|other| split(other)).filter(|(other, _)| *other == section);
    let mut of_section: Vec<&str> = of_section.map(|(_, last)| last).collect();
    let mut near_section = None;
    let list = if of_section.is_empty() {
        let mut sections: Vec<&str> = known.iter().map(|other| split(other).0).collect();
        sections.retain(|section| !section.is_empty());
        sections.dedup();
        let nearest = near_names(section, sections.iter().copied());
        near_section = nearest.first().cloned();
        let nearest: Vec<&str> = nearest.iter().map(String::as_str).collect();
        sections.sort_by_key(|section| rank(section, &nearest));
        let mut listed: Vec<&str> = Vec::new();
        for section in sections {
            if !listed.contains(&section) {
                listed.push(section);
            }
        }
        format!("the sections are {}", listed.join(", "))
    } else {
        let nearest = near.iter().map(|near| split(near)).filter(|(other, _)| *other == section);
        let nearest: Vec<&str> = nearest.map(|(_, last)| last).collect();
        of_section.sort_by_key(|last| rank(last, &nearest));
        let place = if section.is_empty() { "the head".to_owned() } else { format!("[{section}]") };
        format!("the keys of {place} are {}", of_section.join(", "))
    };
    // A misspelled section explains all keys in it.
    let near = match near_section {
        Some(section) => Some(format!("[{section}]")),
        None => near.first().map(|near| quoted(near)),
    };
    let hint = near.map_or_else(String::new, |near| format!("; did you mean {near}?"));
    format!("the key {} is not known to this template{hint} ({list})", quoted(key))
}

/// Keys that are similar to a key, the most similar first: keys of the same section by the part after the section, otherwise keys whose
/// last parts are similar. The name of a section alone makes no key similar.
pub(super) fn near_keys<'a>(key: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let (section, last) = split(key);
    let within = candidates.iter().filter(|other| split(other).0 == section).map(|other| split(other).1);
    let whole = |last: String| if section.is_empty() { last } else { format!("{section}.{last}") };
    let near: Vec<String> = near_names(last, within).into_iter().map(whole).collect();
    if !near.is_empty() {
        return near;
    }
    let similar = near_names(last, candidates.iter().map(|other| split(other).1));
    // The key itself in another section is equal, not similar.
    let is_near = |other: &&&str| split(other).1 == last || similar.iter().any(|one| one == split(other).1);
    candidates.iter().filter(is_near).map(|other| (*other).to_owned()).collect()
}

/// Section and last part of a key.
fn split(key: &str) -> (&str, &str) {
    key.rsplit_once('.').unwrap_or(("", key))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_has_its_words_and_every_part_its_points() {
        for template in templates() {
            let of_template: Vec<&Part> = if template.middle {
                template.parts.iter().collect()
            } else {
                template.parts_with_bar().collect()
            };
            let is_derived = |key: &str| template.derived.iter().any(|(known, _)| known == key);
            let has = |key: &str| template.point(key).is_some() || is_derived(key);
            for (key, _) in &template.points {
                assert_ne!(description_of(&keys().points, key), "", "{}: {key}", template.name);
            }
            for (key, _) in &template.bodies {
                assert_ne!(description_of(&keys().bodies, key), "", "{}: {key}", template.name);
            }
            let points = of_template.into_iter().flat_map(|part| match part {
                Part::Hinge { points, .. }
                | Part::Strut { line: points, .. }
                | Part::Slide { line: points, .. } => points.to_vec(),
                Part::Swivel { at, .. }
                | Part::GuidedAxle { at }
                | Part::Ball { at, .. }
                | Part::Free { at, .. }
                | Part::Fixed { at, .. }
                | Part::Close { at, .. } => vec![at.clone()],
                Part::Rod { ends, .. } => ends.iter().map(|(_, point)| point.clone()).collect(),
                Part::Axle | Part::Wheel { .. } => vec!["wheel_centre".to_owned()],
            });
            for point in points {
                assert!(has(&point), "{}: {point}", template.name);
            }
            let seats = SEATS.iter().filter(|(section, _)| *section != "shock").flat_map(|(_, pair)| pair);
            let bar = BAR_POINTS.iter().filter(|_| !template.middle);
            for key in seats.chain(bar) {
                assert!(has(key), "{}: the example lacks {key}", template.name);
            }
            let sections = ["spring", "damper", "bump_stop", "rebound_stop", "drop_link"];
            for section in sections.into_iter().filter(|section| !template.middle || *section != "drop_link")
            {
                assert!(template.on.iter().any(|(key, _)| key == section), "{}: {section}", template.name);
            }
        }
        assert_eq!(templates().count(), 21);
    }

    #[test]
    fn sections_make_no_key_similar() {
        let known = ["points", "points.lower_ball", "points.upper_ball", "upper_arm.mass", "bump_stop.gap"];
        assert_eq!(near_keys("points.hello", known), Vec::<String>::new());
        assert_eq!(near_keys("points.lower_bal", known)[0], "points.lower_ball");
        assert_eq!(near_keys("upper_arm.masss", known), ["upper_arm.mass"]);
        // A key without its section.
        assert_eq!(near_keys("lower_ball", known)[0], "points.lower_ball");
        assert_eq!(near_keys("gap", known), ["bump_stop.gap"]);
    }
}
