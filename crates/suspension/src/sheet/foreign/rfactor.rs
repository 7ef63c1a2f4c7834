//! Reader of a suspension of rFactor (`.pm`): bodies with masses, and bars between them, in metres; x left, y up, z backward.
//!
//! A section has pairs `key=value`, each value a word or three numbers in parentheses: `[BODY]` with name, mass, inertia, pos and ori,
//! `[JOINT&HINGE]` with posbody, negbody, pos and axis, `[BAR]` with posbody, negbody, pos and neg. A corner is a spindle on five bars to the
//! body, with a wheel on a hinge; its names begin with fl_, fr_, rl_, rr_.

use super::foreign_file::{ForeignFile, wheel_angles};
use crate::limits::MAX_SHEET_KEYS;
use crate::sheet::entries::{Cell, Place};
use crate::units::VehicleAxes;
use percuss_formats::reading::{quoted, shortened};
use percuss_spatial::{Matrix3, Vector3};
use std::ops::Range;

/// Largest distance (m) of two ends of bars that are one ball joint.
const ONE_JOINT: f64 = 1e-6;

/// Sections of a file.
const KINDS: [&str; 5] = ["BODY", "JOINT", "HINGE", "JOINT&HINGE", "BAR"];
/// Keys of the sections of a corner.
const KEYS: [&str; 9] = ["name", "mass", "inertia", "pos", "ori", "posbody", "negbody", "neg", "axis"];

/// Value of a pair.
#[derive(Clone, Debug)]
struct Value {
    text: String,
    range: Range<usize>,
}

/// Section with its pairs.
#[derive(Debug)]
struct Section {
    kind: String,
    pairs: Vec<(String, Value)>,
    at: usize,
}

impl Section {
    fn value(&self, key: &str) -> Option<&Value> {
        self.pairs.iter().find(|(known, _)| known == key).map(|(_, value)| value)
    }

    fn word(&self, key: &str) -> String {
        self.value(key).map_or_else(String::new, |value| value.text.trim().to_ascii_lowercase())
    }

    /// Numbers of a value in parentheses.
    fn numbers(&self, key: &str) -> Option<Vec<f64>> {
        let list = self.value(key)?.text.trim().strip_prefix('(')?.strip_suffix(')')?;
        list.split(',').map(|number| number.trim().parse().ok().filter(|x: &f64| x.is_finite())).collect()
    }

    fn triple(&self, key: &str) -> Option<[f64; 3]> {
        self.numbers(key)?.try_into().ok()
    }

    /// Places of the three numbers of a value.
    fn places(&self, text: &str, key: &str) -> Vec<Place> {
        let list = self.value(key).filter(|value| value.text.len() > 1 && value.text.starts_with('('));
        let Some(Value { range, .. }) = list else { return Vec::new() };
        let (mut places, mut begin) = (Vec::new(), range.start + 1);
        for part in text[range.start + 1..range.end - 1].split(',') {
            places.push(Place::Text(begin..begin + part.len()));
            begin += part.len() + 1;
        }
        places
    }
}

/// End of a bar on the spindle or the body, with its place.
type End = ([f64; 3], Vec<Place>);

/// Bar between the body and a spindle.
struct Bar {
    name: String,
    /// End on the body.
    inner: End,
    /// End on the spindle.
    outer: End,
    at: usize,
}

/// True if a text looks like a suspension of rFactor.
pub(super) fn is_suspension(text: &str) -> bool {
    text.lines().any(|line| line.trim_start().to_ascii_uppercase().starts_with("[BODY]"))
}

/// Sections of a text.
///
/// # Errors
/// Byte and reason of the first defect.
fn sections(text: &str) -> Result<Vec<Section>, (usize, &'static str)> {
    let mut found: Vec<Section> = Vec::new();
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let content = line.split("//").next().unwrap_or_default();
        let mut at = 0;
        loop {
            at += content[at..].len() - content[at..].trim_start().len();
            let rest = &content[at..];
            if rest.is_empty() {
                break;
            }
            if let Some(inner) = rest.strip_prefix('[') {
                let end = inner.find(']').ok_or((start + at, "the bracket is not closed"))?;
                let kind = inner[..end].trim().to_ascii_uppercase();
                found.push(Section { kind, pairs: Vec::new(), at: start + at });
                at += end + 2;
                continue;
            }
            let equals = rest.find('=').ok_or((start + at, "KEY=VALUE is expected"))?;
            let key = rest[..equals].trim().to_ascii_lowercase();
            let begin = at + equals + 1;
            let begin = begin + content[begin..].len() - content[begin..].trim_start().len();
            let value = &content[begin..];
            let end = match value.strip_prefix('(') {
                Some(list) => list
                    .find(')')
                    .map(|end| end + 2)
                    .ok_or((start + begin, "the parenthesis is not closed"))?,
                None => value.find(char::is_whitespace).unwrap_or(value.len()),
            };
            let section = found.last_mut().ok_or((start + at, "a section such as [BODY] is expected"))?;
            let range = start + begin..start + begin + end;
            section.pairs.push((key, Value { text: value[..end].to_owned(), range }));
            at = begin + end;
        }
        if found.len() > MAX_SHEET_KEYS {
            return Err((start, "the file has too many sections"));
        }
    }
    Ok(found)
}

/// Reads one corner; `axle`: `front` (default) or `rear`.
pub(super) fn read(text: &str, is_right: bool, axle: Option<&str>, into: &mut ForeignFile<'_>) {
    into.axes = VehicleAxes::RFACTOR;
    into.entries.worksheet = Some(axle.unwrap_or("front").to_owned());
    let all = match sections(text) {
        Ok(all) => all,
        Err((at, why)) => return into.error("not-pm", "", at, format!("no suspension of rFactor: {why}")),
    };
    if let Some(other) = all.iter().find(|section| !KINDS.contains(&section.kind.as_str())) {
        into.warning("not-built", &other.kind, other.at, "this section is not known, and not read");
    }
    let start = match axle.unwrap_or("front") {
        "front" => "f",
        "rear" => "r",
        other => {
            let message = format!("no axle is named {}; front or rear is expected", quoted(other));
            return into.error("unknown-worksheet", "", 0, message);
        }
    };
    let corner = format!("{start}{}", if is_right { "r" } else { "l" });
    let (spindle_name, wheel_name) = (format!("{corner}_spindle"), format!("{corner}_wheel"));
    let bodies: Vec<&Section> = all.iter().filter(|section| section.kind == "BODY").collect();
    let body = |name: &str| bodies.iter().copied().find(|section| section.word("name") == name);
    let (Some(spindle), Some(wheel)) = (body(&spindle_name), body(&wheel_name)) else {
        let names: Vec<String> = bodies.iter().map(|section| section.word("name")).collect();
        let message = format!(
            "the bodies {spindle_name} and {wheel_name} are expected; the file has: {}",
            shortened(&names.join(", "))
        );
        return into.error("missing-key", "", 0, message);
    };
    let position = |section: &Section, key: &str| {
        let name = section.word(key);
        section.triple(key).or_else(|| body(&name)?.triple("pos"))
    };
    let (mut bars, mut hinge) = (Vec::new(), None);
    for section in &all {
        let ends = [section.word("posbody"), section.word("negbody")];
        let names = [section.word("name"), ends[0].clone(), ends[1].clone()];
        if !names.iter().any(|name| [&spindle_name, &wheel_name].contains(&name)) {
            continue;
        }
        if let Some((key, _)) = section.pairs.iter().find(|(key, _)| !KEYS.contains(&key.as_str())) {
            into.error(
                "unknown-key",
                &section.kind,
                section.at,
                format!("the key {} is not known", quoted(key)),
            );
        }
        let is_negative = ends[1] == spindle_name;
        let [one, other] = if is_negative { [&ends[1], &ends[0]] } else { [&ends[0], &ends[1]] };
        match (&*section.kind, &**other) {
            ("BODY", _) => {}
            ("BAR", "body") if *one == spindle_name => {
                let [Some(pos), Some(neg)] = ["pos", "neg"].map(|key| position(section, key)) else {
                    into.error(
                        "wrong-type",
                        "BAR",
                        section.at,
                        "pos and neg are expected, three numbers each",
                    );
                    continue;
                };
                let (pos, neg) = ((pos, section.places(text, "pos")), (neg, section.places(text, "neg")));
                let (inner, outer) = if is_negative { (pos, neg) } else { (neg, pos) };
                bars.push(Bar { name: section.word("name"), inner, outer, at: section.at });
            }
            ("JOINT&HINGE", other) if *one == spindle_name && other == wheel_name && hinge.is_none() => {
                hinge = Some(section);
            }
            _ => {
                let message = format!(
                    "{} between {} and {} is not read",
                    quoted(&section.kind),
                    quoted(&ends[0]),
                    quoted(&ends[1])
                );
                into.error("not-built", &spindle_name, section.at, message);
            }
        }
    }
    let Some(hinge) = hinge else {
        let message = format!("a [JOINT&HINGE] of {wheel_name} and {spindle_name} is expected");
        return into.error("missing-key", &wheel_name, wheel.at, message);
    };
    if bars.len() != 5 {
        let message = format!("{} bars join body and {spindle_name}; five are expected", bars.len());
        return into.error("wrong-length", &spindle_name, spindle.at, message);
    }
    add_bars(bars, into);
    let (Some(at), Some(axis)) = (position(hinge, "pos"), position(hinge, "axis")) else {
        return into.error("wrong-type", "JOINT&HINGE", hinge.at, "pos and axis are expected");
    };
    // The wheel is on its hinge: both positions are the wheel centre.
    let mut places = Vec::new();
    for section in [hinge, wheel] {
        if section.triple("pos").is_some() {
            places.extend(section.places(text, "pos"));
        }
    }
    into.point("wheel_centre", at, "m", places, hinge.at);
    let spin = into.axes.to_iso(Vector3::from(axis));
    // The axis may point inward; the mirror image of a right wheel is a left one.
    let sign = spin.y.signum() * if is_right { -1.0 } else { 1.0 };
    let [camber, toe] = wheel_angles(Vector3::new(sign * spin.x, spin.y.abs(), sign * spin.z));
    for (key, angle) in [("wheel.camber", camber), ("wheel.toe", toe)] {
        if angle != 0.0 {
            into.word(key, &format!("{angle} rad"), hinge.at);
        }
    }
    add_bodies(spindle, wheel, at, into);
    into.word("side", if is_right { "right" } else { "left" }, 0);
    into.word("name", &format!("{} of rFactor", axle.unwrap_or("front")), 0);
    let massive = bodies.iter().filter(|section| {
        let name = section.word("name");
        let is_corner = ["spindle", "wheel"].iter().any(|end| name.ends_with(&format!("_{end}")));
        !is_corner && section.numbers("mass").is_some_and(|mass| mass != [0.0])
    });
    let massive: Vec<String> = massive.map(|section| section.word("name")).collect();
    let which = if axle.is_none() { " (the front axle; --worksheet rear reads the other one)" } else { "" };
    let others = if massive.is_empty() {
        String::new()
    } else {
        format!("; bodies that are not used: {}", massive.join(", "))
    };
    into.note("corner", format!("the corner {corner} is read{which}{others}. Springs, dampers and the radius of the tyre are in other files of rFactor"));
}

/// Adds the five bars: the tie rod by its name or as the last one, of the others the two with the higher ends on the spindle as the upper ones,
/// and of both the one that is in front on the body as the front one. Bars that share their ends on the spindle are arms of two rods.
fn add_bars(mut bars: Vec<Bar>, into: &mut ForeignFile<'_>) {
    let steering = bars.iter().position(|bar| bar.name.ends_with("_steering")).unwrap_or(bars.len() - 1);
    let tie_rod = bars.remove(steering);
    bars.sort_by(|a, b| b.outer.0[1].total_cmp(&a.outer.0[1]));
    // z is backward.
    bars[..2].sort_by(|a, b| a.inner.0[2].total_cmp(&b.inner.0[2]));
    bars[2..].sort_by(|a, b| a.inner.0[2].total_cmp(&b.inner.0[2]));
    let is_one =
        |pair: &[Bar]| (Vector3::from(pair[0].outer.0) - Vector3::from(pair[1].outer.0)).norm() <= ONE_JOINT;
    let has_arms = bars.chunks(2).all(is_one);
    let template = if has_arms { "double-wishbone-rods" } else { "five-link" };
    into.word("template", template, tie_rod.at);
    // A shared end is given by both rods.
    if has_arms {
        for pair in bars.chunks_mut(2) {
            let twin = std::mem::take(&mut pair[1].outer.1);
            pair[0].outer.1.extend(twin);
        }
    }
    for (k, bar) in bars.into_iter().enumerate() {
        let (level, end) = (["upper", "lower"][k / 2], ["front", "back"][k % 2]);
        let [inner, outer] = if has_arms {
            [format!("{level}_{end}"), format!("{level}_ball")]
        } else {
            [format!("{level}_{end}_link_chassis"), format!("{level}_{end}_link_outer")]
        };
        into.point(&inner, bar.inner.0, "m", bar.inner.1, bar.at);
        if !has_arms || k % 2 == 0 {
            into.point(&outer, bar.outer.0, "m", bar.outer.1, bar.at);
        }
    }
    into.point("tie_rod_inner", tie_rod.inner.0, "m", tie_rod.inner.1, tie_rod.at);
    into.point("tie_rod_outer", tie_rod.outer.0, "m", tie_rod.outer.1, tie_rod.at);
}

/// Adds the masses: the spindle of the file is the upright; the wheel turns about x of the file.
fn add_bodies(spindle: &Section, wheel: &Section, centre: [f64; 3], into: &mut ForeignFile<'_>) {
    let axes = into.axes_of_sheet();
    for section in [spindle, wheel] {
        let is_turned = section.triple("ori").is_some_and(|ori| ori != [0.0; 3]);
        if is_turned {
            into.error("not-built", "ori", section.at, "a turned body is not read; ori=(0,0,0) is expected");
        }
    }
    let data = |section: &Section| {
        let mass: [f64; 1] = section.numbers("mass")?.try_into().ok()?;
        Some((mass[0], section.triple("inertia")?, section.triple("pos")?))
    };
    let [Some((mass, moments, com)), Some((wheel_mass, [about_x, about_y, about_z], at))] =
        [spindle, wheel].map(data)
    else {
        return into.error(
            "wrong-type",
            "BODY",
            spindle.at,
            "mass=(m), inertia=(xx,yy,zz) and pos=(x,y,z) are expected for spindle and wheel",
        );
    };
    if (Vector3::from(at) - Vector3::from(centre)).norm() > ONE_JOINT {
        let message =
            "the wheel's pos is not on its hinge: a wheel with an eccentric centre of mass is not read";
        into.error("not-built", "wheel", wheel.at, message);
    }
    let numbers = |list: &[f64]| list.iter().map(|x| Cell::Number(*x)).collect::<Vec<_>>();
    let kilograms = |list: [f64; 3]| list.map(|x| Cell::Text(format!("{x} kg m2"))).to_vec();
    let com = axes.from_iso(into.axes.to_iso(com.into()));
    let inertia = axes.inertia_from_iso(into.axes.inertia_to_iso(Matrix3::from_diagonal(&moments.into())));
    into.key("upright.mass", numbers(&[mass]), spindle.at);
    into.key("upright.com", [com.x, com.y, com.z].map(|x| Cell::Text(format!("{x} m"))).to_vec(), spindle.at);
    into.key("upright.inertia", kilograms([inertia[(0, 0)], inertia[(1, 1)], inertia[(2, 2)]]), spindle.at);
    into.key("spindle.mass", numbers(&[0.0]), spindle.at);
    into.key("spindle.inertia", numbers(&[0.0; 3]), spindle.at);
    into.key("wheel.mass", numbers(&[wheel_mass]), wheel.at);
    // About the directions of the wheel: forward, the spin axis, upward.
    into.key("wheel.inertia", kilograms([about_z, about_x, about_y]), wheel.at);
}
