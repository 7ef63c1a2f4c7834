//! Names of hardpoints in other programs and drawings: those that a sheet states, those of known programs, and names read by their words.

pub(super) mod vocabulary;

use super::catalogue::{self, BAR_POINTS};
use super::entries::{Cell, Entries};
use super::template::Template;
use crate::findings::{Findings, Spot};
use crate::options::Side;
use percuss_formats::reading::{quoted, shortened};
use percuss_mechanism::near_names;
use vocabulary::{Found, near_meaning, point_of};

/// Section of the names that a sheet states.
pub(super) const NAMES: &str = "names";

/// Longest list of names in a message.
const MOST_NAMES: usize = 20;

/// Renames the hardpoints to the names of the template: first those of the section `names`, then those of other programs, then those that
/// their words determine; notes list them. Of names of both sides, those of the side that is not `side` become `points.right.NAME` or
/// `points.left.NAME` if `builds_both`. Two names of one point are an error. If no mandatory point is missing, other names are not used, with a
/// warning.
pub(super) fn rename_points(
    template: &'static Template,
    (side, builds_both): (Side, bool),
    entries: &mut Entries,
    findings: &mut Findings,
) {
    rename_stated(template, entries, findings);
    let unknown: Vec<(String, Spot)> = entries
        .unread()
        .filter_map(|entry| Some((entry.key.strip_prefix("points.")?.to_owned(), entry.spot.clone())))
        .filter(|(name, _)| template.point(name).is_none())
        .collect();
    let has_bar = entries.has_section("anti_roll_bar");
    let (mut found, mut unused) = (Vec::new(), Vec::new());
    for (name, spot) in unknown {
        match point_of(&name, template) {
            Some(one) if has_bar || !BAR_POINTS.contains(&one.point) => found.push((name, spot, one)),
            _ => unused.push((name, spot)),
        }
    }
    if found.is_empty() {
        return;
    }
    let is_other = |one: &Found| one.side.is_some_and(|of_name| of_name != side);
    // A table with names of one side only describes the side of the sheet.
    let is_own = |other: &Found| {
        entries.has(&format!("points.{}", other.point))
            || found.iter().any(|(.., one)| !is_other(one) && one.point == other.point)
    };
    let has_both = found.iter().any(|(.., one)| is_other(one))
        && found.iter().any(|(.., one)| one.side == Some(side) || is_other(one) && is_own(one));
    let (other, found): (Vec<_>, Vec<_>) = found.into_iter().partition(|(.., one)| has_both && is_other(one));
    let mut programs: Vec<(Option<&str>, Spot, Vec<String>)> = Vec::new();
    let mut coil_overs = Vec::new();
    for (name, spot, Found { point, program, is_coil_over, .. }) in found {
        let key = format!("points.{point}");
        if entries.has(&key) {
            let first = programs
                .iter()
                .flat_map(|(.., list)| list)
                .find(|text| text.ends_with(&format!("→ {point}")));
            let first = first.and_then(|text| text.split(" → ").next()).unwrap_or(point);
            let message = format!(
                "{} and {} are both the point {point} of {}: delete one of them, or state the name by [names] {point} = \"…\"",
                quoted(first),
                quoted(&name),
                template.name
            );
            findings.error("ambiguous-name", &spot, message);
            continue;
        }
        entries.rename(&format!("points.{name}"), &key);
        if is_coil_over {
            coil_overs.push((point, spot.clone()));
        }
        let text = format!("{} → {point}", shortened(&name));
        match programs.iter_mut().find(|(known, ..)| *known == program) {
            Some((.., list)) => list.push(text),
            None => programs.push((program, spot, vec![text])),
        }
    }
    for (program, spot, list) in programs {
        let of = program
            .map_or_else(|| "names read by their words".to_owned(), |title| format!("names of {title}"));
        findings.note("other-names", &spot, format!("{of}: {}", list.join(", ")));
    }
    copy_coil_overs(&coil_overs, template, entries, findings);
    let word = side.other_word();
    let prefix = format!("{word}.");
    let (used, other): (Vec<_>, Vec<_>) =
        other.into_iter().partition(|(name, ..)| builds_both || name.starts_with(&prefix));
    for (name, spot, one) in used {
        let key = format!("points.{word}.{}", one.point);
        if key == format!("points.{name}") {
            continue;
        }
        if entries.has(&key) {
            let message = format!(
                "{} and another name are both the point {} of the {word} side",
                quoted(&name),
                one.point
            );
            findings.error("ambiguous-name", &spot, message);
        }
        entries.rename(&format!("points.{name}"), &key);
        if let Some((damper, spring)) =
            COIL_OVER.iter().find(|(damper, _)| one.is_coil_over && *damper == one.point)
            && coil_overs.iter().any(|(point, _)| point == damper)
        {
            copy_point(&key, &format!("points.{word}.{spring}"), &spot, entries, findings);
        }
    }
    warn_unused(&other, &format!("the points of the {word} side are not used"), entries, findings);
    let has = |key: &str| entries.has(&format!("points.{key}"));
    let is_required =
        |key: &str| Template::optional_group(key).is_none_or(|group| group.iter().any(|other| has(other)));
    let follows = |key: &str| {
        key == "wheel_centre" && entries.has("wheel.half_track")
            || key == "anti_roll_bar_inner" && has("anti_roll_bar_outer")
            || key.starts_with("rocker_") && has("rocker_pivot")
    };
    if template.points.iter().all(|(key, _)| has(key) || follows(key) || !is_required(key)) {
        let message = format!("{} has no such points; they are not used", template.name);
        warn_unused(&unused, &message, entries, findings);
    }
}

/// Warns about points that are not used, and marks them as read.
fn warn_unused<T: Named>(points: &[T], why: &str, entries: &mut Entries, findings: &mut Findings) {
    let Some(first) = points.first() else { return };
    let names: Vec<String> = points.iter().take(MOST_NAMES).map(|point| quoted(point.name())).collect();
    let more = if points.len() > MOST_NAMES { ", …" } else { "" };
    findings.warning("unused-points", first.spot(), format!("{why}: {}{more}", names.join(", ")));
    for point in points {
        entries.find(&format!("points.{}", point.name()));
    }
}

/// Name of a table with its place.
trait Named {
    fn name(&self) -> &str;
    fn spot(&self) -> &Spot;
}

impl Named for (String, Spot) {
    fn name(&self) -> &str {
        &self.0
    }

    fn spot(&self) -> &Spot {
        &self.1
    }
}

impl Named for (String, Spot, Found) {
    fn name(&self) -> &str {
        &self.0
    }

    fn spot(&self) -> &Spot {
        &self.1
    }
}

/// Ends of the damper, and those of the spring of a coil-over.
const COIL_OVER: [(&str, &str); 2] =
    [("damper_seat", "spring_seat"), ("damper_chassis_seat", "spring_chassis_seat")];

/// Adds a point with the numbers and the places of another one.
fn copy_point(from: &str, to: &str, spot: &Spot, entries: &mut Entries, findings: &mut Findings) {
    if let Some(cells) = entries.cells_of(from) {
        entries.add(findings, to.to_owned(), cells, spot.clone());
        let places = entries.places_of(from);
        entries.set_places(to, places);
    }
}

/// Gives the spring the ends of a coil-over, unless the sheet has ends of the spring.
fn copy_coil_overs(
    ends: &[(&'static str, Spot)],
    template: &Template,
    entries: &mut Entries,
    findings: &mut Findings,
) {
    let has_spring = COIL_OVER.iter().any(|(_, spring)| entries.has(&format!("points.{spring}")));
    if has_spring || template.point("spring_seat").is_none() {
        return;
    }
    let copies = ends.iter().filter_map(|(end, spot)| {
        let (_, spring) = COIL_OVER.iter().find(|(damper, _)| damper == end)?;
        Some((*end, *spring, spot))
    });
    let copies: Vec<_> = copies.collect();
    for (end, spring, spot) in &copies {
        copy_point(&format!("points.{end}"), &format!("points.{spring}"), spot, entries, findings);
    }
    if let Some((.., spot)) = copies.first() {
        let message = "the points of a coil-over are the ends of the damper and of the spring".to_owned();
        findings.note("coil-over", spot, message);
    }
}

/// Renames the points that the section `names` states.
fn rename_stated(template: &'static Template, entries: &mut Entries, findings: &mut Findings) {
    let stated: Vec<String> = entries.keys_in(NAMES).into_iter().map(str::to_owned).collect();
    let (mut renamed, mut place) = (Vec::new(), None);
    for point in stated {
        let Some((cells, spot)) = entries.find(&format!("{NAMES}.{point}")) else { continue };
        let is_known = catalogue::keys().points.iter().any(|(key, _)| *key == point);
        if !is_known {
            let near = catalogue::suggestion(&point, catalogue::keys().points.iter().map(|(key, _)| &**key));
            let message = format!(
                "{} is no point of percuss{near}; POINT = \"NAME IN THE TABLE\" is expected",
                quoted(&point)
            );
            findings.error("unknown-point", &spot, message);
            continue;
        }
        let names: Option<Vec<&str>> = cells
            .iter()
            .map(|cell| if let Cell::Text(name) = cell { Some(name.trim()) } else { None })
            .collect();
        let Some(names) = names.filter(|names| !names.is_empty()) else {
            let message = "a name of the table is expected, such as \"LBJ\", or a list of names".to_owned();
            findings.error("wrong-type", &spot, message);
            continue;
        };
        if template.point(&point).is_none() {
            continue;
        }
        let key = format!("points.{point}");
        let given: Vec<&&str> = names.iter().filter(|name| entries.has(&format!("points.{name}"))).collect();
        match given[..] {
            [name] if **name == point => {}
            [name] if !entries.has(&key) => {
                entries.rename(&format!("points.{name}"), &key);
                for side in ["left", "right"] {
                    entries.rename(&format!("points.{side}.{name}"), &format!("points.{side}.{point}"));
                }
                renamed.push(format!("{} → {point}", shortened(name)));
                place.get_or_insert(spot);
            }
            [] if entries.has(&key) || Template::optional_group(&point).is_some() => {}
            [] => {
                let all = entries.keys_in("points");
                let near =
                    names.iter().find_map(|name| near_names(name, all.iter().copied()).into_iter().next());
                let near = near.map_or_else(String::new, |near| format!("; did you mean {}?", quoted(&near)));
                let names: Vec<String> = names.iter().map(|name| quoted(name)).collect();
                let message = format!("the table has no point {}{near}", names.join(" or "));
                findings.error("unknown-point", &spot, message);
            }
            _ => {
                let names: Vec<String> = names.iter().map(|name| quoted(name)).collect();
                let message = format!(
                    "{} and {point} are given more than once: one of them is expected",
                    names.join(", ")
                );
                findings.error("ambiguous-name", &spot, message);
            }
        }
    }
    if let Some(spot) = place {
        findings.note("other-names", &spot, format!("names as stated: {}", renamed.join(", ")));
    }
}

/// Reports unknown names of points in one error, with the points of the template that are missing; true if there are several, or one and a
/// missing point.
pub(super) fn report_unknown_points(
    template: &'static Template,
    entries: &mut Entries,
    findings: &mut Findings,
) -> bool {
    let unread = entries.unread().filter_map(|entry| entry.key.strip_prefix("points."));
    let is_of_other = |name: &str| name.starts_with("left.") || name.starts_with("right.");
    let names: Vec<String> = unread
        .filter(|name| template.point(name).is_none() && !is_of_other(name))
        .map(str::to_owned)
        .collect();
    let is_missing = |key: &&str| !entries.has(&format!("points.{key}"));
    let missing: Vec<&str> = template.points.iter().map(|(key, _)| &**key).filter(is_missing).collect();
    if names.len() < 2 {
        return false;
    }
    let (optional, required): (Vec<&str>, Vec<&str>) =
        missing.iter().partition(|key| Template::optional_group(key).is_some());
    let describe =
        |key: &&str| format!("{key} ({})", catalogue::description_of(&catalogue::keys().points, key));
    let required = required.iter().map(describe).collect::<Vec<_>>().join("; ");
    let lists = [
        (". Its points that are not given: ", required),
        (". Points that may be left out: ", optional.join(", ")),
    ];
    let lists: String = lists
        .iter()
        .filter(|(_, list)| !list.is_empty())
        .map(|(title, list)| format!("{title}{list}"))
        .collect();
    let message = format!(
        "{} names of points are not known to the template {}: {}. State them by [names] POINT = \"NAME\"{lists}",
        names.len(),
        template.name,
        names_with_nearest(&names, &missing),
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
        let near = near_meaning(name, points.iter().copied()).map(str::to_owned);
        let near = near.or_else(|| near_names(name, points.iter().copied()).into_iter().next());
        near.map_or_else(|| quoted(name), |near| format!("{} ({near}?)", quoted(name)))
    };
    let more = if names.len() > MOST_NAMES { ", …" } else { "" };
    names.iter().take(MOST_NAMES).map(with_nearest).collect::<Vec<_>>().join(", ") + more
}

#[cfg(test)]
mod tests {
    use super::vocabulary::{VOCABULARY, patterns_of};
    use super::*;
    use std::collections::BTreeSet;

    /// All words of the patterns can be in a name, and each pattern belongs to a point.
    #[test]
    fn patterns_have_known_words_and_points() {
        let vocabulary = &*VOCABULARY;
        let known: BTreeSet<&str> = vocabulary.words.values().flatten().map(String::as_str).collect();
        for (point, _) in vocabulary.points.iter().chain(&vocabulary.points_with_rocker) {
            assert_ne!(catalogue::description_of(&catalogue::keys().points, point), "", "{point}");
            for pattern in patterns_of(point, false).chain(patterns_of(point, true)) {
                for word in pattern.required.iter().chain(&pattern.optional) {
                    assert!(known.contains(word), "{point}: {word}");
                }
            }
        }
    }

    /// No two patterns of one template match the same words.
    #[test]
    fn patterns_of_a_template_exclude_each_other() {
        for template in catalogue::templates() {
            let has_rocker = template.point("pushrod_rocker").is_some();
            for (i, (one, _)) in template.points.iter().enumerate() {
                for (other, _) in &template.points[..i] {
                    for (a, b) in patterns_of(one, has_rocker)
                        .flat_map(|a| patterns_of(other, has_rocker).map(move |b| (a.required.clone(), b)))
                    {
                        assert!(!b.matches(&a), "{}: {one} and {other}", template.name);
                    }
                }
            }
        }
    }
}
