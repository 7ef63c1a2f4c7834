//! Reader of the geometry files of Suspension Explorer (YAML): one corner, or an axle with a left side.

use super::foreign_file::{ForeignFile, wheel_angles};
use super::yaml::{self, Leaf};
use crate::sheet::entries::{Place, parse_number};
use crate::units::VehicleAxes;
use percuss_formats::reading::{quoted, shortened};
use percuss_spatial::Vector3;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Conventions {
    template: Vec<TemplateRule>,
    mounts: BTreeMap<String, String>,
    keys: KeyRules,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TemplateRule {
    #[serde(rename = "type")]
    kind: String,
    actuation: String,
    template: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct KeyRules {
    /// Maps of an axle file that a corner's file has at the top.
    parts: Vec<String>,
    harmless: Vec<String>,
    not_built: BTreeMap<String, String>,
}

static CONVENTIONS: LazyLock<Conventions> = LazyLock::new(|| {
    toml::from_str(include_str!("explorer.toml")).expect("the conventions of this crate are valid")
});

/// True if a text looks like a geometry file: YAML with a map of hardpoints.
pub(super) fn is_geometry(text: &str) -> bool {
    text.lines().any(|line| line.trim_end() == "hardpoints:")
}

/// Points of one side: coordinates, mm, their places, and the first byte.
type Points = BTreeMap<String, ([f64; 3], Vec<Place>, usize)>;

/// Reads a file; `is_right`: the sheet describes the right side.
pub(super) fn read(text: &str, is_right: bool, into: &mut ForeignFile<'_>) {
    into.axes = VehicleAxes::ISO;
    let leaves = match yaml::read(text) {
        Ok(leaves) => leaves,
        Err((at, why)) => return into.error("not-yaml", "", at, format!("no YAML that is read: {why}")),
    };
    // The parts of an axle file have the keys of a corner's file in two maps.
    let path_of = |leaf: &Leaf| {
        let path =
            leaf.path.strip_prefix("axle_config.").or_else(|| leaf.path.strip_prefix("vehicle_config."));
        let of_part =
            |rest: &str| CONVENTIONS.keys.parts.iter().any(|part| rest.starts_with(&format!("{part}.")));
        match path {
            Some(rest) if of_part(rest) => rest.to_owned(),
            Some(rest) => format!("config.{rest}"),
            None => leaf.path.clone(),
        }
    };
    let (points, others): (Vec<&Leaf>, Vec<&Leaf>) =
        leaves.iter().partition(|leaf| leaf.path.starts_with("hardpoints."));
    let mut rest: BTreeMap<String, &Leaf> = others.into_iter().map(|leaf| (path_of(leaf), leaf)).collect();
    let mut word = |key: &str| rest.remove(key).map_or(("", 0), |leaf| (&*leaf.text, leaf.range.start));
    let [
        (kind, at_kind),
        (actuation, _),
        (mount, at_mount),
        (spring, at_spring),
        _,
        (name, at_name),
        (side, _),
        (units, at_units),
    ] = ["type", "actuation.type", "actuation.mount", "spring.type", "damper.type", "name", "side", "units"]
        .map(&mut word);
    if !["", "millimeters", "mm"].contains(&units) {
        into.error("unknown-word", "units", at_units, format!("{}; millimeters is expected", quoted(units)));
    }
    let actuation = if actuation.is_empty() { "direct" } else { actuation };
    let rules = &CONVENTIONS.template;
    let Some(rule) = rules.iter().find(|rule| rule.kind == kind && rule.actuation == actuation) else {
        let known: Vec<String> =
            rules.iter().map(|rule| format!("{} ({})", rule.kind, rule.actuation)).collect();
        let message = format!(
            "{} with the actuation {} has no template; these are read: {}",
            quoted(kind),
            quoted(actuation),
            known.join(", ")
        );
        return into.error("unknown-template", "type", at_kind, message);
    };
    into.word("template", &rule.template, at_kind);
    if !name.is_empty() {
        into.word("name", name, at_name);
    }
    if spring == "torsion_bar" && !into.entries.has("torsion_bar.rate") {
        let message = "the file has no rate of the torsion bar: the wheel rate does not contain it; write a sheet with points = \"FILE.yaml\" and \
                       [torsion_bar] with on and rate"
            .to_owned();
        into.warning("not-built", "spring.type", at_spring, message);
    }
    let (side, mut points) = read_points(&points, side, is_right, into);
    into.word("side", side, 0);
    let sections: &[&str] = match (&*rule.template, spring, points.contains_key("strut_top")) {
        ("pushrod-rocker", ..) => &["pushrod"],
        (_, "coilover", true) => &["spring", "damper"],
        (_, _, true) => &["damper"],
        _ => &[],
    };
    match CONVENTIONS.mounts.get(mount) {
        Some(link) => sections.iter().for_each(|section| into.word(&format!("{section}.on"), link, at_mount)),
        None if mount.is_empty() => {}
        None => {
            let message = format!("the mount {} is not known", quoted(mount));
            into.error("unknown-link", "actuation.mount", at_mount, message);
        }
    }
    add_wheel(&mut points, &mut rest, if side == "right" { -1.0 } else { 1.0 }, into);
    // A strut beside another spring is a damper.
    let is_damper = rule.template != "macpherson-strut" && spring != "coilover";
    for (name, (at, places, byte)) in points {
        let name = match &*name {
            "strut_top" if is_damper => "damper_chassis_seat",
            "strut_bottom" if is_damper => "damper_seat",
            // A point of the arm, which the template does not need.
            "trailing_arm_outboard" => continue,
            name => name,
        };
        into.point(name, at, "mm", places, byte);
    }
    report_rest(&rest, into);
}

/// Side that the points describe, and its points with those of the middle. Of an axle with both sides: the side of the sheet; a warning, if
/// the other side is no mirror image. `stated`: side of a corner.
fn read_points(
    leaves: &[&Leaf],
    stated: &str,
    is_right: bool,
    into: &mut ForeignFile<'_>,
) -> (&'static str, Points) {
    let mut found: BTreeMap<(&str, &str), [Option<&Leaf>; 3]> = BTreeMap::new();
    for leaf in leaves {
        let path: Vec<&str> = leaf.path.split('.').skip(1).collect();
        let axis = path.last().and_then(|last| ["x", "y", "z"].iter().position(|axis| axis == last));
        match (&path[..], axis) {
            ([name, _], Some(k)) => found.entry(("", *name)).or_default()[k] = Some(*leaf),
            ([side @ ("left" | "right" | "center"), name, _], Some(k)) => {
                found.entry((*side, *name)).or_default()[k] = Some(*leaf);
            }
            _ => {
                let path = quoted(&path.join("."));
                let message = format!("{path} is no hardpoint; NAME: {{x: 0, y: 0, z: 0}} is expected");
                into.error("wrong-type", "hardpoints", leaf.range.start, message);
            }
        }
    }
    let has = |side: &str| found.keys().any(|(of, _)| *of == side);
    let is_right = if has("left") && has("right") { is_right } else { has("right") || stated == "right" };
    let (side, other) = if is_right { ("right", "left") } else { ("left", "right") };
    let numbers = |leaves: &[Option<&Leaf>; 3]| leaves.map(|leaf| parse_number(&leaf?.text));
    let mut points = Points::new();
    for ((of, name), leaves) in found.iter().filter(|((of, _), _)| *of != other) {
        let at = leaves.iter().flatten().map(|leaf| leaf.range.start).next().unwrap_or_default();
        let [Some(x), Some(y), Some(z)] = numbers(leaves) else {
            into.error("wrong-type", name, at, "three numbers x, y, z are expected");
            continue;
        };
        let places = leaves.iter().flatten().map(|leaf| Place::Text(leaf.range.clone())).collect();
        points.insert((*name).to_owned(), ([x, y, z], places, at));
        let Some(leaves) = found.get(&(other, *name)).filter(|_| *of == side) else { continue };
        let [Some(other_x), Some(other_y), Some(other_z)] = numbers(leaves) else {
            into.error("wrong-type", name, at, "three numbers x, y, z are expected");
            continue;
        };
        let is_axle = name.starts_with("axle_");
        if is_axle && [other_x, -other_y, other_z] == [x, y, z] {
            continue;
        }
        if is_axle {
            let message = format!(
                "the wheel of the {other} side is no mirror image: it is built as that of the {side} side"
            );
            into.warning("unequal-sides", name, at, message);
            continue;
        }
        let places = leaves.iter().flatten().map(|leaf| Place::Text(leaf.range.clone())).collect();
        into.point(&format!("{other}.{name}"), [other_x, other_y, other_z], "mm", places, at);
    }
    (side, points)
}

/// Adds the wheel: its centre on the axle, camber and toe from the direction of the axle, the radius of the unloaded tyre.
fn add_wheel(points: &mut Points, rest: &mut BTreeMap<String, &Leaf>, sign: f64, into: &mut ForeignFile<'_>) {
    let mut number = |key: &str| {
        let leaf = rest.remove(&format!("config.wheel.{key}"))?;
        let number = parse_number(&leaf.text);
        if number.is_none() {
            into.error(
                "wrong-type",
                key,
                leaf.range.start,
                format!("{}; a number is expected", quoted(&leaf.text)),
            );
        }
        number
    };
    let offset = number("offset").unwrap_or(0.0);
    let tyre = ["tire.aspect_ratio", "tire.section_width", "tire.rim_diameter"].map(number);
    if let [Some(ratio), Some(width), Some(rim)] = tyre {
        into.word("wheel.radius", &format!("{} mm", 12.7 * rim + ratio * width), 0);
    }
    let [inner, outer] = ["axle_inboard", "axle_outboard"].map(|name| points.remove(name));
    let (Some((inner, ..)), Some((outer, _, at))) = (inner, outer) else {
        if !into.findings.has_errors() {
            let message = "the points axle_inboard and axle_outboard are expected".to_owned();
            into.error("missing-key", "hardpoints", 0, message);
        }
        return;
    };
    let (inner, outer) = (Vector3::from(inner), Vector3::from(outer));
    let along = (outer - inner).normalize();
    let [camber, toe] = wheel_angles(Vector3::new(along.x, sign * along.y, along.z));
    into.word("wheel.camber", &format!("{camber} rad"), at);
    into.word("wheel.toe", &format!("{toe} rad"), at);
    into.point("wheel_centre", (outer - along * offset).into(), "mm", Vec::new(), at);
}

/// Reports the keys that are not used: harmless ones in a note, parts that are not built in a warning, others in an error.
fn report_rest(rest: &BTreeMap<String, &Leaf>, into: &mut ForeignFile<'_>) {
    let number =
        |key: &str| rest.get(&format!("config.camber_shim.{key}")).and_then(|leaf| parse_number(&leaf.text));
    let [design, setup] = ["design_thickness", "setup_thickness"].map(number);
    if design != setup {
        let message = "the camber shim of the setup differs from the design: its angle is not computed; give the hardpoints of the setup";
        into.error("not-built", "camber_shim", 0, message);
    }
    let keys = &CONVENTIONS.keys;
    let (mut harmless, mut unknown) = (Vec::new(), Vec::new());
    for (path, leaf) in rest {
        let is_harmless = keys.harmless.iter().any(|key| path == key || path.starts_with(&format!("{key}.")));
        match keys.not_built.get(path) {
            Some(value) if *value == leaf.text => {}
            Some(_) => {
                let message = format!(
                    "{} {} is not built",
                    path.split('.').next().unwrap_or_default(),
                    quoted(&leaf.text)
                );
                into.warning("not-built", path, leaf.range.start, message);
            }
            None if is_harmless => {
                harmless.push(shortened(&path.split('.').take(2).collect::<Vec<_>>().join(".")));
            }
            None => unknown.push((path, leaf.range.start)),
        }
    }
    if let Some((path, at)) = unknown.first() {
        let names: Vec<String> = unknown.iter().take(12).map(|(path, _)| quoted(path)).collect();
        into.error("unknown-key", path, *at, format!("keys that are not known: {}", names.join(", ")));
    }
    if !harmless.is_empty() {
        harmless.dedup();
        let message = format!(
            "not used here: {}; the centre of mass and the wheelbase are flags of percuss kinematics",
            harmless.join(", ")
        );
        into.note("harmless-keys", message);
    }
}
