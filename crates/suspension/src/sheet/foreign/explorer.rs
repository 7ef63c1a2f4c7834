//! Reader of the geometry files of Suspension Explorer (YAML): one corner, or an axle with a left side.

use super::yaml::{self, Leaf};
use super::{ForeignFile, wheel_angles};
use crate::sheet::entries::{Cell, Place, parse_number};
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
        path.map_or_else(|| leaf.path.clone(), |rest| format!("config.{rest}"))
    };
    let mut rest: BTreeMap<String, &Leaf> = leaves.iter().map(|leaf| (path_of(leaf), leaf)).collect();
    for key in ["actuation", "spring", "damper", "anti_roll", "heave_link"] {
        for part in ["type", "mount"] {
            if let Some(leaf) = rest.remove(&format!("config.{key}.{part}")) {
                rest.insert(format!("{key}.{part}"), leaf);
            }
        }
    }
    let mut word =
        |key: &str| rest.remove(key).map_or((String::new(), 0), |leaf| (leaf.text.clone(), leaf.range.start));
    let (kind, at_kind) = word("type");
    let (actuation, _) = word("actuation.type");
    let (mount, at_mount) = word("actuation.mount");
    let (spring, at_spring) = word("spring.type");
    let (_, _) = word("damper.type");
    let (name, at_name) = word("name");
    let (side, _) = word("side");
    let (units, at_units) = word("units");
    if !["", "millimeters", "mm"].contains(&&*units) {
        into.error("unknown-word", "units", at_units, format!("{}; millimeters is expected", quoted(&units)));
    }
    let actuation = if actuation.is_empty() { "direct" } else { &*actuation };
    let rule = CONVENTIONS.template.iter().find(|rule| rule.kind == kind && rule.actuation == actuation);
    let Some(rule) = rule else {
        let known: Vec<String> =
            CONVENTIONS.template.iter().map(|rule| format!("{} ({})", rule.kind, rule.actuation)).collect();
        let message = format!(
            "{} with the actuation {} has no template; these are read: {}",
            quoted(&kind),
            quoted(actuation),
            known.join(", ")
        );
        return into.error("unknown-template", "type", at_kind, message);
    };
    let text_cell = |text: &str| vec![Cell::Text(text.to_owned())];
    into.key("template", text_cell(&rule.template), at_kind);
    if !name.is_empty() {
        into.key("name", text_cell(&name), at_name);
    }
    if spring == "torsion_bar" {
        let message = "the torsion bar is not built: the wheel rate does not contain it".to_owned();
        into.warning("not-built", "spring.type", at_spring, message);
    }
    // Of an axle, the side of the sheet; a file with one side describes the side that it names.
    let points: Vec<(Vec<&str>, &Leaf)> = leaves
        .iter()
        .filter(|leaf| leaf.path.starts_with("hardpoints."))
        .map(|leaf| (leaf.path.split('.').skip(1).collect(), leaf))
        .collect();
    rest.retain(|path, _| !path.starts_with("hardpoints."));
    let has = |side: &str| points.iter().any(|(path, _)| path.len() == 3 && path[0] == side);
    let wanted = match (has("left"), has("right")) {
        (true, true) if is_right => "right",
        (true, _) => "left",
        (false, true) => "right",
        (false, false) => "",
    };
    let described = if wanted.is_empty() { if side.is_empty() { "left" } else { &*side } } else { wanted };
    into.key("side", text_cell(described), 0);
    let mut found: Vec<(String, [Option<&Leaf>; 3])> = Vec::new();
    let mut of_other = Vec::new();
    for (path, leaf) in &points {
        let (name, axis) = match path[..] {
            [name, axis] if wanted.is_empty() => (name, axis),
            [side, name, axis] if side == wanted || side == "center" => (name, axis),
            [side, name, axis] if ["left", "right"].contains(&side) => {
                of_other.push((name, axis, *leaf));
                continue;
            }
            _ => {
                let message = format!(
                    "{} is no hardpoint; NAME: {{x: 0, y: 0, z: 0}} is expected",
                    quoted(&path.join("."))
                );
                into.error("wrong-type", "hardpoints", leaf.range.start, message);
                continue;
            }
        };
        let Some(k) = ["x", "y", "z"].iter().position(|known| *known == axis) else {
            let message = format!("{} is no axis; x, y, z are expected", quoted(axis));
            into.error("wrong-type", name, leaf.range.start, message);
            continue;
        };
        match found.iter_mut().find(|(known, _)| known == name) {
            Some((_, leaves)) => leaves[k] = Some(leaf),
            None => {
                let mut leaves = [None; 3];
                leaves[k] = Some(*leaf);
                found.push((name.to_owned(), leaves));
            }
        }
    }
    let has_strut = found.iter().any(|(name, _)| name.starts_with("strut"));
    let sections: &[&str] = match (&*rule.template, &*spring) {
        ("pushrod-rocker", _) => &["pushrod"],
        (_, "coilover") if has_strut => &["spring", "damper"],
        _ if has_strut => &["damper"],
        _ => &[],
    };
    if let Some(link) = CONVENTIONS.mounts.get(&mount) {
        sections.iter().for_each(|section| into.key(&format!("{section}.on"), text_cell(link), at_mount));
    } else if !mount.is_empty() {
        let message = format!("the mount {} is not known", quoted(&mount));
        into.error("unknown-link", "actuation.mount", at_mount, message);
    }
    let mut points: BTreeMap<String, ([f64; 3], Vec<Place>, usize)> = BTreeMap::new();
    for (name, leaves) in found {
        let at = leaves.iter().flatten().map(|leaf| leaf.range.start).next().unwrap_or_default();
        let numbers = leaves.map(|leaf| parse_number(&leaf?.text));
        match numbers {
            [Some(x), Some(y), Some(z)] => {
                let places =
                    leaves.into_iter().flatten().map(|leaf| Place::Text(leaf.range.clone())).collect();
                points.insert(name, ([x, y, z], places, at));
            }
            _ => into.error("wrong-type", &name, at, "three numbers x, y, z are expected".to_owned()),
        }
    }
    let is_unequal = of_other.iter().find(|(name, axis, leaf)| {
        let k = ["x", "y", "z"].iter().position(|known| known == axis).unwrap_or_default();
        let own = points.get(*name).map(|(at, ..)| if k == 1 { -at[1] } else { at[k] });
        own != parse_number(&leaf.text)
    });
    if let Some((name, _, leaf)) = is_unequal {
        let message = format!(
            "the other side is no mirror image ({name}); only the {described} side is read, and the other is built as its mirror image"
        );
        into.warning("unequal-sides", name, leaf.range.start, message);
    }
    let sign = if described == "right" { -1.0 } else { 1.0 };
    add_wheel(&mut points, &mut rest, sign, into);
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

/// Adds the wheel: its centre on the axle, camber and toe from the direction of the axle, the radius of the unloaded tyre.
fn add_wheel(
    points: &mut BTreeMap<String, ([f64; 3], Vec<Place>, usize)>,
    rest: &mut BTreeMap<String, &Leaf>,
    sign: f64,
    into: &mut ForeignFile<'_>,
) {
    let mut number = |key: &str| rest.remove(key).and_then(|leaf| parse_number(&leaf.text));
    let offset = number("config.wheel.offset").unwrap_or(0.0);
    let tyre = ["aspect_ratio", "section_width", "rim_diameter"]
        .map(|key| number(&format!("config.wheel.tire.{key}")));
    if let [Some(ratio), Some(width), Some(rim)] = tyre {
        let radius = 12.7 * rim + ratio * width;
        into.key("wheel.radius", vec![Cell::Text(format!("{radius} mm"))], 0);
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
    let centre = outer - along * offset;
    let outward = Vector3::new(along.x, sign * along.y, along.z);
    let [camber, toe] = wheel_angles(outward);
    into.key("wheel.camber", vec![Cell::Text(format!("{camber} rad"))], at);
    into.key("wheel.toe", vec![Cell::Text(format!("{toe} rad"))], at);
    into.point("wheel_centre", centre.into(), "mm", Vec::new(), at);
}

/// Reports the keys that are not used: harmless ones in a note, parts that are not built in a warning, others in an error.
fn report_rest(rest: &BTreeMap<String, &Leaf>, into: &mut ForeignFile<'_>) {
    let number =
        |key: &str| rest.get(&format!("config.camber_shim.{key}")).and_then(|leaf| parse_number(&leaf.text));
    let [design, setup] = ["design_thickness", "setup_thickness"].map(number);
    if design != setup {
        let message = "the camber shim of the setup differs from the design: its angle is not computed; give the hardpoints of the setup";
        into.error("not-built", "camber_shim", 0, message.to_owned());
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
