//! Names of hardpoints in other programs: Adams/Car and OptimumK; suggestions for other names.

use super::catalogue;
use super::entries::Entries;
use super::template::Template;
use crate::findings::{Findings, Spot};
use percuss_formats::reading::{quoted, shortened};
use percuss_mechanism::near_names;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Points of percuss for each name of another program, by program.
static ALIASES: LazyLock<BTreeMap<String, BTreeMap<String, Vec<String>>>> = LazyLock::new(|| {
    toml::from_str(include_str!("templates/aliases.toml")).expect("the names of this crate are valid")
});

/// Name without the prefix and the ending of the side, in lower case, and true for a name of the right side.
fn plain_name(name: &str) -> (String, bool) {
    let name = name.trim().to_lowercase();
    let plain = ["hpl_", "hps_", "hpr_"].iter().find_map(|prefix| name.strip_prefix(prefix)).unwrap_or(&name);
    let plain =
        ["_left", "_l", "_right", "_r"].iter().find_map(|end| plain.strip_suffix(end)).unwrap_or(plain);
    let is_right = name.starts_with("hpr_") || name.ends_with("_r") || name.ends_with("_right");
    (plain.to_owned(), is_right)
}

/// Renames hardpoints with names of another program to the names of the template, with a note. Points of such a table without a
/// counterpart are not used: a warning lists them. In a table of both sides, the points of the left side are used.
pub(super) fn rename_points(template: &Template, entries: &mut Entries, findings: &mut Findings) {
    let is_known = |key: &str| template.point(key).is_some();
    let unknown: Vec<(String, Spot)> = entries
        .unread()
        .filter_map(|entry| Some((entry.key.strip_prefix("points.")?.to_owned(), entry.spot.clone())))
        .filter(|(name, _)| !is_known(name))
        .collect();
    let (mut renamed, mut unused, mut right) = (Vec::new(), Vec::new(), Vec::new());
    let mut program_used = None;
    for (name, spot) in unknown {
        let (plain, is_right) = plain_name(&name);
        let found = ALIASES.iter().find_map(|(program, names)| {
            let own = names.get(&plain)?.iter().find(|own| is_known(own))?;
            Some((&**program, own))
        });
        match found {
            Some(_) if is_right => right.push((name, spot)),
            Some((program, own)) if !entries.has(&format!("points.{own}")) => {
                entries.rename(&format!("points.{name}"), &format!("points.{own}"));
                renamed.push(format!("{} → {own}", shortened(&name)));
                program_used.get_or_insert((program, spot));
            }
            Some(_) | None => unused.push((name, spot)),
        }
    }
    let Some((program, spot)) = program_used else { return };
    let program = if program == "adams" { "Adams/Car" } else { "OptimumK" };
    findings.note("other-names", &spot, format!("names of {program}: {}", renamed.join(", ")));
    let left_out = |list: &[(String, Spot)]| {
        let names: Vec<String> = list.iter().take(20).map(|(name, _)| quoted(name)).collect();
        format!("{}{}", names.join(", "), if list.len() > 20 { ", …" } else { "" })
    };
    if let Some((_, spot)) = right.first() {
        let message = format!("the points of the right side are not used: {}", left_out(&right));
        findings.warning("unused-points", spot, message);
    }
    if let Some((_, spot)) = unused.first() {
        let message =
            format!("{} has no such points; they are not used: {}", template.name, left_out(&unused));
        findings.warning("unused-points", spot, message);
    }
    for (name, _) in right.iter().chain(&unused) {
        entries.find(&format!("points.{name}"));
    }
}

/// Reports several unknown names of points in one error, with the points of the template that are missing; true if there are several.
pub(super) fn report_unknown_points(
    template: &'static Template,
    entries: &mut Entries,
    findings: &mut Findings,
) -> bool {
    let unread = entries.unread().filter_map(|entry| entry.key.strip_prefix("points."));
    let names: Vec<String> =
        unread.filter(|name| template.point(name).is_none()).map(str::to_owned).collect();
    if names.len() < 2 {
        return false;
    }
    let is_missing = |key: &&str| !entries.has(&format!("points.{key}"));
    let missing: Vec<&str> = template.points.iter().map(|(key, _)| &**key).filter(is_missing).collect();
    let list = missing.iter().map(|key| {
        let optional = if Template::optional_group(key).is_some() { ", may be left out" } else { "" };
        format!("{key} ({}{optional})", catalogue::description_of(&catalogue::keys().points, key))
    });
    let message = format!(
        "{} names of points are not known to the template {}: {}. Its points that are not given: {}",
        names.len(),
        template.name,
        names_with_nearest(&names, &missing),
        list.collect::<Vec<_>>().join("; ")
    );
    let spots: Vec<Spot> =
        names.iter().filter_map(|name| Some(entries.find(&format!("points.{name}"))?.1)).collect();
    let spot = Spot { path: Some("points".to_owned()), ..spots.into_iter().next().unwrap_or_default() };
    findings.error("unknown-points", &spot, message);
    true
}

/// Unknown names of points, each with the point of nearest spelling or meaning among `points`.
fn names_with_nearest(names: &[String], points: &[&str]) -> String {
    let with_nearest = |name: &String| {
        let near = catalogue::near_meaning(name, points.iter().copied()).map(str::to_owned);
        let near = near.or_else(|| near_names(name, points.iter().copied()).into_iter().next());
        near.map_or_else(|| quoted(name), |near| format!("{} ({near}?)", quoted(name)))
    };
    names.iter().map(with_nearest).collect::<Vec<_>>().join(", ")
}
