//! Table of the bearings in an impact: peaks, impulses and moments by magnitude.

use crate::commands::mass::conditions::words;
use crate::terminal::number::number;
use crate::terminal::text::{Table, TableCell};
use percuss_study::{ImpactReport, ReactionPlace, ReactionRecord};

/// Load of a bearing, relative to the largest, below which the bearing is only counted.
const SHOWN_LOAD: f64 = 0.02;
/// Load of a bearing, relative to the largest, that is rounding.
const NO_LOAD: f64 = 1e-12;
/// Relative difference up to which two bearings transmit the same load.
const EQUAL_LOAD: f64 = 1e-6;

/// Name of the place of a reaction.
pub fn place_name(place: ReactionPlace, name: &str) -> String {
    match place {
        ReactionPlace::Joint => name.to_owned(),
        ReactionPlace::Closure => format!("{name} (closure)"),
        ReactionPlace::Hold => format!("{name} (held point)"),
        ReactionPlace::Ground => format!("{name} (ground)"),
    }
}

/// Magnitude of the determinate components.
pub fn magnitude(components: &[Option<f64>; 3]) -> f64 {
    components.iter().flatten().map(|v| v * v).sum::<f64>().sqrt()
}

/// Load of a bearing or of the contact.
struct Bearing {
    name: String,
    /// Links of the reaction.
    links: [String; 2],
    /// Impulse, N·s, and moment impulse, N·m·s.
    impulse: f64,
    moment: f64,
    /// Peak force, N, its time, s, and peak moment, N·m.
    peak: Option<f64>,
    time: Option<f64>,
    peak_moment: Option<f64>,
    /// True for a fixed joint, which is no bearing.
    is_fixed: bool,
    /// True if components are indeterminate: the magnitudes are lower bounds.
    is_open: bool,
}

/// Table of the bearings, with the largest load first, and the remark below it. The table is empty without reactions.
pub struct BearingTable {
    pub table: Table,
    pub note: String,
}

impl BearingTable {
    /// Table with the loads above the limit, or with `all` loads. `with_links`: with the links of each bearing.
    pub fn new(report: &ImpactReport, all: bool, with_links: bool) -> Self {
        let size = report.mass.characteristic_length;
        let loads = loads(report);
        let largest = loads.iter().map(|b| b.impulse).fold(0.0, f64::max);
        let mut bearings = merged(loads, SHOWN_LOAD * largest * size);
        let most = |of: fn(&Bearing) -> f64| bearings.iter().map(of).fold(f64::MIN_POSITIVE, f64::max);
        let key = |b: &Bearing| b.peak.unwrap_or(b.impulse);
        let force = most(key);
        // A moment counts by the force at the characteristic length.
        let per_force = most(|b| b.impulse) / force;
        let moment = most(|b| b.moment).max(force * per_force * size);
        let load = |b: &Bearing| (key(b) / force).max(b.moment / moment);
        bearings.sort_by(|a, b| key(b).total_cmp(&key(a)).then_with(|| load(b).total_cmp(&load(a))));
        let limit = if all { NO_LOAD } else { SHOWN_LOAD };
        let loaded = bearings.iter().filter(|b| load(b) > NO_LOAD || b.is_open).count();
        bearings.retain(|b| load(b) > limit || b.is_open);
        let has = |of: fn(&Bearing) -> bool| bearings.iter().any(of);
        let (peaks, times) = (has(|b| b.peak.is_some()), has(|b| b.time.is_some()));
        let moments = bearings.iter().any(|b| b.moment > SHOWN_LOAD * moment);
        let peak_moments = moments && has(|b| b.peak_moment.is_some());
        let mut header = vec!["bearing"];
        header.extend(with_links.then_some(["from", "on"]).into_iter().flatten());
        for (is_shown, name) in [
            (peaks, "peak N"),
            (times, "at ms"),
            (true, "impulse N·s"),
            (peak_moments, "peak N·m"),
            (moments, "moment N·m·s"),
        ] {
            header.extend(is_shown.then_some(name));
        }
        let mut rows: Vec<Vec<TableCell>> = vec![header.into_iter().map(TableCell::from).collect()];
        for b in &bearings {
            let mark = if b.is_open { " (?)" } else { "" };
            let mut row = vec![TableCell::from(b.name.clone() + mark)];
            row.extend(b.links.iter().filter(|_| with_links).map(|link| TableCell::from(link.as_str())));
            for (is_shown, value) in [
                (peaks, b.peak),
                (times, b.time.map(|t| 1e3 * t)),
                (true, Some(b.impulse)),
                (peak_moments, b.peak_moment),
                (moments, Some(b.moment)),
            ] {
                row.extend(is_shown.then_some(TableCell::Part(value)));
            }
            rows.push(row);
        }
        let bars: Vec<f64> = bearings.iter().map(key).collect();
        let mut note = String::new();
        let mut open: Vec<&str> =
            report.reactions.iter().flat_map(|r| r.open_by.iter().map(String::as_str)).collect();
        open.sort_unstable();
        open.dedup();
        if !open.is_empty() {
            note = format!(
                "?: indeterminate; redundant constraints leave components open: {}; the determinate part is shown\n",
                open.join(", ")
            );
        }
        let rest = loaded - bearings.len();
        if rest > 0 {
            let unit = if peaks { "N" } else { "N·s" };
            note += &format!(
                "{rest} more below {} {unit}{}",
                number(SHOWN_LOAD * force),
                if with_links { "" } else { ": --all" }
            );
        }
        Self { table: Table::from_rows(rows).with_bars(&bars), note }
    }
}

/// Loads of the contact and of all bearings.
fn loads(report: &ImpactReport) -> Vec<Bearing> {
    let in_time = report.in_time.as_ref();
    let bearing = |record: &ReactionRecord| {
        let link = |name: &Option<String>| name.clone().unwrap_or_else(|| "ground".to_owned());
        let timed = in_time.and_then(|found| {
            found.bearings.iter().find(|b| b.place == record.place && b.name == record.name)
        });
        let name = match record.place {
            ReactionPlace::Joint => words(&record.name),
            place => place_name(place, &record.name),
        };
        Bearing {
            name,
            links: [link(&record.from), link(&record.on)],
            impulse: magnitude(&record.force),
            moment: magnitude(&record.moment),
            peak: timed.map(|b| b.peak_force).or(record.peak_force.as_ref().map(magnitude)),
            time: timed.map(|b| b.peak_time),
            peak_moment: record.peak_moment.as_ref().map(magnitude).filter(|_| timed.is_none()),
            is_fixed: record.place == ReactionPlace::Joint && record.gear.is_empty(),
            is_open: !record.open_by.is_empty(),
        }
    };
    let contact = &report.mass.contact;
    let name = report.mass.named_contact.as_ref().map_or("contact", |contact| &contact.name);
    let peak_at = |found: &percuss_study::ImpactTimeRecord| {
        let peak = (0..found.force.len()).max_by(|&a, &b| found.force[a].total_cmp(&found.force[b]))?;
        found.times.get(peak).copied()
    };
    let of_contact = (!contact.is_moment).then(|| Bearing {
        name: name.to_owned(),
        links: [contact.against.clone().unwrap_or_else(|| "ground".to_owned()), contact.link.clone()],
        impulse: report.impulse,
        moment: 0.0,
        peak: in_time.map(|found| found.peak_force).or(report.contact_law.as_ref().map(|law| law.peak_force)),
        time: in_time.and_then(peak_at),
        peak_moment: None,
        is_fixed: false,
        is_open: false,
    });
    of_contact.into_iter().chain(report.reactions.iter().map(bearing)).collect()
}

/// Bearings of which those with the same load are one: the two axes of a universal joint. A fixed joint beside a bearing or a contact with the
/// same force has no row of its own. `small`: moment that is not shown, N·m·s.
fn merged(bearings: Vec<Bearing>, small: f64) -> Vec<Bearing> {
    let is_near = |a: f64, b: f64| (a - b).abs() <= EQUAL_LOAD * a.abs().max(b.abs());
    let mut each: Vec<Bearing> = Vec::new();
    for bearing in bearings {
        let is_same = |other: &&mut Bearing| {
            let is_small = other.moment <= small && bearing.moment <= small;
            (other.is_fixed || bearing.is_fixed || other.name == bearing.name)
                && (is_small || is_near(other.moment, bearing.moment))
                && is_near(other.impulse, bearing.impulse)
                && is_near(other.peak.unwrap_or_default(), bearing.peak.unwrap_or_default())
                && other.is_open == bearing.is_open
        };
        match each.iter_mut().find(is_same) {
            Some(other) if other.is_fixed && !bearing.is_fixed => *other = bearing,
            Some(_) => {}
            None => each.push(bearing),
        }
    }
    each
}
