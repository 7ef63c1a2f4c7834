//! Impact in time with elastic bushes and gears: facts, table of the elements, figure and CSV.

use crate::document::Document;
use crate::files::contents::Cells;
use crate::files::csv::Cell;
use crate::terminal::limits::MODES_SHOWN;
use crate::terminal::number::{load, number, signed, supported, upper_bound, with_unit};
use crate::terminal::report::details_are_shown;
use crate::terminal::text::{Table, TableCell};
use crate::terminal::units::ContactUnits;
use percuss_render::{Panel, Series, Style};
use percuss_study::{
    CompliantImpactRecord, ContactEndName, ElementForceRecord, ImpactReport, ImpactTimeRecord,
};

/// Elements with a force below this part of the largest of their unit are left out of the text.
const SHOWN_FORCE: f64 = 1e-3;
/// Most elements in the figure.
const MOST_DRAWN: usize = 4;

/// Results of the mechanism with elastic bushes and gears beside those of the rigid one; empty unless requested.
pub fn facts(report: &ImpactReport, rigid: &ImpactTimeRecord) -> Vec<(&'static str, String)> {
    let Some(found) = &rigid.compliant else { return Vec::new() };
    let ContactUnits { force, impulse, mass, speed, .. } = ContactUnits::new(report.mass.contact.is_moment);
    let change = signed(100.0 * (found.peak_force / rigid.peak_force - 1.0), 2);
    let end = match (found.end, found.duration) {
        (ContactEndName::NoRebound, _) | (_, None) => "no rebound: the sides do not separate".to_owned(),
        (end, Some(duration)) => {
            let grazes = match end {
                ContactEndName::Grazes => ", the contact grazes its end and its duration is uncertain",
                _ => "",
            };
            let (time, e) = (with_unit(1e3 * duration, "ms"), number(found.restitution));
            format!("contact time {time}, restitution {e}{grazes}")
        }
    };
    let peak = load(found.peak_force, force);
    let mut facts = vec![("compliant", format!("peak {peak} ({change} %), {end}"))];
    facts.push((
        "impulse",
        format!(
            "{} of the compliant mechanism: that of a free mass of {} (m_imp)",
            with_unit(found.impulse, impulse),
            with_unit(found.impulse_mass, mass)
        ),
    ));
    if let Some(hit) = found.second_hit {
        let (time, at) = (with_unit(1e3 * hit.time, "ms"), number(hit.speed));
        facts.push((
            "second hit",
            format!("after {time} at {at} {speed}: the impulse is that of the first contact"),
        ));
    }
    if details_are_shown() {
        let energy = found.energy;
        let error = energy.residual.abs();
        facts.push((
            "energy",
            format!(
                "{} J kinetic before, {} J after; bushes and springs store {} J and take {} J, the contact takes {} J, other forces give {} J; \
                 balance to {} J",
                number(energy.kinetic_before),
                supported(energy.kinetic_after, error),
                supported(energy.stored, error),
                supported(energy.dissipated, error),
                supported(energy.taken_by_contact, error),
                supported(energy.work_of_other_forces, error),
                upper_bound(error)
            ),
        ));
    }
    facts
}

/// Name of an element with its direction.
fn name(element: &ElementForceRecord) -> String {
    match element.direction {
        None | Some("motion") => element.element.clone(),
        Some("twist") => format!("gear of {}", element.element),
        Some(direction) => format!("{} {direction}", element.element),
    }
}

/// Adds the table of the elements, below a heading; nothing unless requested. `all`: as for [`elements`].
pub fn add(report: &ImpactReport, heading: Option<&str>, all: bool, out: &mut Document) {
    if let Some(found) = report.in_time.as_ref().and_then(|found| found.compliant.as_ref()) {
        heading.into_iter().for_each(|heading| out.heading(heading));
        let (table, note) = elements(found, all);
        out.table(table);
        out.note(note);
    }
}

/// Elements by their largest force, forces before moments, and the note below. `all`: elements of any force and all components.
fn elements(found: &CompliantImpactRecord, all: bool) -> (Table, String) {
    let is_component =
        |element: &&ElementForceRecord| matches!(element.direction, Some("radial x" | "radial y" | "axial"));
    let largest = |unit: &str| {
        let same = found.elements.iter().filter(|element| element.unit == unit);
        same.map(|element| element.peak_force).fold(0.0, f64::max)
    };
    let is_shown =
        |element: &&ElementForceRecord| element.peak_force >= SHOWN_FORCE * largest(element.unit) || all;
    let shown = found.elements.iter().filter(|element| all || !is_component(element)).filter(is_shown);
    let mut shown: Vec<&ElementForceRecord> = shown.collect();
    shown.sort_by(|a, b| {
        (a.unit.len(), b.peak_force)
            .partial_cmp(&(b.unit.len(), a.peak_force))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let most = if all { usize::MAX } else { MODES_SHOWN };
    let left = shown.len().saturating_sub(most);
    let mut table = Table::new(["bush, bearing, spring, gear", "peak", "", "at ms", "after the contact"]);
    for element in shown.into_iter().take(most) {
        table.row([
            TableCell::from(name(element)),
            TableCell::Part(Some(element.peak_force)),
            TableCell::from(element.unit),
            TableCell::Part(Some(1e3 * element.peak_time)),
            TableCell::Part(element.peak_force_after),
        ]);
    }
    let more = if left > 0 { format!("{left} more and ") } else { String::new() };
    let rest = if all { String::new() } else { format!("{more}the components of the forces: --all · ") };
    let with = found.with_geometric_stiffness.map_or_else(String::new, |with| {
        let change = signed(100.0 * (with.peak_force / found.peak_force - 1.0), 2);
        format!(" (with it the peak changes by {change} %)")
    });
    let note = format!(
        "{rest}linear about the touch, without geometric stiffness{with}, loss factors as dampers at {} Hz",
        number(found.loss_frequency)
    );
    (table, note)
}

/// One row for each time: contact, and the forces of all elements.
pub fn cells(found: &CompliantImpactRecord) -> Cells {
    let mut names = ["time", "penetration", "rate", "force"].map(str::to_owned).to_vec();
    names.extend(found.elements.iter().map(|element| match element.unit {
        "N" => format!("force at {}", name(element)),
        _ => format!("moment at {}", name(element)),
    }));
    let row = |k: usize| {
        let contact = [found.times[k], found.penetration[k], found.closing_speed[k], found.force[k]];
        let elements = found.elements.iter().map(|element| element.force[k]);
        contact.into_iter().chain(elements).map(Cell::Number).collect()
    };
    (names, (0..found.times.len()).map(row).collect())
}

/// Panel of the contact force with and without bushes, and of the largest forces of the elements.
pub fn panel(rigid: &ImpactTimeRecord, found: &CompliantImpactRecord, label: &str) -> Panel {
    let series = |name: &str, style, times: &[f64], values: &[f64]| Series {
        name: name.to_owned(),
        style,
        points: times.iter().zip(values).map(|(t, value)| (1e3 * t, Some(*value))).collect(),
    };
    let mut all = vec![
        series("contact, compliant", Style::Line, &found.times, &found.force),
        series("contact, rigid", Style::Dashed, &rigid.times, &rigid.force),
    ];
    let mut drawn: Vec<&ElementForceRecord> =
        found.elements.iter().filter(|element| element.direction.is_none()).collect();
    drawn.sort_by(|a, b| b.peak_force.total_cmp(&a.peak_force));
    for element in drawn.into_iter().take(MOST_DRAWN) {
        all.push(series(&element.element, Style::Line, &found.times, &element.force));
    }
    Panel { y_label: label.to_owned(), series: all, ..Panel::default() }
}
