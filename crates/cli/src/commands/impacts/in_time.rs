//! Impact in time: facts, figure and CSV.

use crate::commands::damp::{law_name, stiffness_text, unit_power};
use crate::commands::impacts::bearings::place_name;
use crate::commands::impacts::compliant;
use crate::files::contents::{Cells, Contents};
use crate::files::csv::Cell;
use crate::files::output::record_input;
use crate::terminal::failure::Failure;
use crate::terminal::number::{load, number, signed, supported, upper_bound, with_unit};
use crate::terminal::report::details_are_shown;
use crate::terminal::units::ContactUnits;
use percuss_render::{Figure, Mark, Panel, Picture, Series, Sheet, Style};
use percuss_study::{
    AntiRollBarRecord, BearingForceRecord, ImpactReport, ImpactTimeRecord, JointSpringRecord,
    PointSpringRecord, ReactionPlace, TyreRecord,
};

/// Bearings with a force below this part of the contact force are left out of the figure.
const SHOWN_FORCE: f64 = 1e-3;
/// Largest relative change of m̄ that is shown as a percentage: a larger one indicates a pose near an immovable contact.
const LARGEST_PERCENTAGE: f64 = 100.0;
/// Most bearings in the figure: more lines cannot be told apart.
const MOST_SHOWN: usize = 5;

/// Further results of the impact in time; empty unless requested.
pub fn facts(report: &ImpactReport) -> Vec<(&'static str, String)> {
    let Some(found) = &report.in_time else { return Vec::new() };
    let is_moment = report.mass.contact.is_moment;
    let ContactUnits { force, .. } = ContactUnits::new(is_moment);
    let what = if is_moment { "moment" } else { "force" };
    let mut facts = Vec::new();
    if let Some(one) = &found.one_freedom {
        facts.push((
            "one freedom",
            format!(
                "by m̄ over the compression alone: restitution {}, peak {what} {}",
                number(one.restitution),
                load(one.peak_force, force)
            ),
        ));
    }
    if let Some(text) = acting(found) {
        facts.push(("acting", text));
    }
    if let Some(weight) = found.effective_weight {
        let unit = ContactUnits::new(is_moment).mass;
        let work: f64 = found.drives.iter().map(|drive| drive.work).sum();
        let text = format!(
            "{} for catalogues of absorbers: m̄ + 2W/v², the drives do W = {} J until the largest compression",
            with_unit(weight, unit),
            number(work)
        );
        facts.push(("effective weight", text));
    }
    if found.energy.work_of_other_forces != 0.0 {
        let energy = &found.energy;
        let error = energy.residual.abs();
        let text = format!(
            "{} J kinetic before, {} J after; the contact takes {} J, the other forces give {} J; balance to {} J",
            number(energy.kinetic_before),
            supported(energy.kinetic_after, error),
            supported(energy.taken_by_contact, error),
            supported(energy.work_of_other_forces, error),
            upper_bound(error)
        );
        facts.push(("energy", text));
    }
    if let Some(whole) = &found.with_whole_forces {
        let text = format!(
            "the springs act by the change of their forces; with the whole forces, which turn with the motion, and balancing wheel loads: peak {what} {} \
             ({} %), restitution {}",
            load(whole.peak_force, force),
            signed(100.0 * (whole.peak_force / found.peak_force - 1.0), 2),
            number(whole.restitution)
        );
        facts.push(("assumption", text));
    }
    if let Some(touch) = &found.second_touch {
        let speed = ContactUnits::new(is_moment).speed;
        let text = format!(
            "{} ms after the first, at {} {speed}; this report ends with the first contact",
            number(1e3 * touch.time),
            number(touch.speed)
        );
        facts.push(("second touch", text));
    }
    facts.extend(compliant::facts(report, found));
    if found.loop_gap > 0.0 && details_are_shown() {
        facts.push(("loops", format!("closed to {:.1e} m during the motion", found.loop_gap)));
    }
    facts
}

/// Springs, dampers and drives that act, and those of the sheet that are left out; `None` without any.
fn acting(found: &ImpactTimeRecord) -> Option<String> {
    let spring = |spring: &PointSpringRecord| {
        let rate = number(1e-3 * spring.rate);
        let force = match spring.force_at_touch {
            0.0 => "the change of its force since the touch".to_owned(),
            force => format!("{} N at the touch", number(force)),
        };
        format!("{} ({rate} N/mm, {force})", spring.name)
    };
    let mut parts: Vec<String> = found.springs.iter().map(spring).collect();
    parts.extend(found.dampers.iter().map(|damper| named("damper", &damper.name)));
    parts.extend(found.tyres.iter().map(tyre));
    parts.extend(found.anti_roll_bars.iter().map(bar));
    parts.extend(joint_springs(found));
    parts.extend(
        found
            .drives
            .iter()
            .map(|drive| format!("{} (constant {})", drive.name, with_unit(drive.value, drive.unit))),
    );
    if !found.springs_left_out.is_empty() {
        parts.push(format!("left out: {}", found.springs_left_out.join(", ")));
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

/// Springs of joints with their whole forces, springs with the change of the force since the touch, and dampers: each group with the names of at most
/// three joints.
fn joint_springs(found: &ImpactTimeRecord) -> Vec<String> {
    let group = |kind: &str, acts: &dyn Fn(&JointSpringRecord) -> bool, force: &str| {
        let joints: Vec<&str> =
            found.joint_springs.iter().filter(|spring| acts(spring)).map(|spring| &*spring.joint).collect();
        let more = joints.len().saturating_sub(3);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let word = if joints.len() == 1 { "joint" } else { "joints" };
        let names = joints.iter().take(3).copied().collect::<Vec<_>>().join(", ");
        (!joints.is_empty()).then(|| format!("{kind} of {word} {names}{more}{force}"))
    };
    let has_force = |spring: &JointSpringRecord| spring.force_at_touch != 0.0;
    let changes = |spring: &JointSpringRecord| spring.stiffness > 0.0 && !has_force(spring);
    [
        group("springs", &has_force, " (whole force)"),
        group("springs", &changes, " (change of the force since the touch)"),
        group("dampers", &|spring| spring.damping > 0.0, ""),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Tyre with its forces.
fn tyre(tyre: &TyreRecord) -> String {
    let rate = number(1e-3 * tyre.rate);
    let leaves = tyre
        .leaves_road_at
        .map_or_else(String::new, |time| format!(", off the road after {} ms", number(1e3 * time)));
    format!("tyre at {} ({rate} N/mm, {} N at the touch{leaves})", tyre.name, number(tyre.force_at_touch))
}

/// Anti-roll bar with its stiffness and its other half.
fn bar(bar: &AntiRollBarRecord) -> String {
    let other = if bar.hinges.len() == 1 { ", other wheel at rest" } else { "" };
    format!("anti-roll bar ({} N·m/deg{other})", number(bar.stiffness.to_radians()))
}

/// Name of a spring or a damper, which starts with the kind.
fn named(kind: &str, name: &str) -> String {
    if name.starts_with(kind) { name.to_owned() } else { format!("{kind} {name}") }
}

/// Forces that act during the impact in time, as a sentence.
pub fn forces_sentence(found: &ImpactTimeRecord) -> String {
    let mut parts: Vec<String> =
        found.springs.iter().map(|spring| format!("the {}", named("spring", &spring.name))).collect();
    if found.gravity_world != [0.0; 3] {
        parts.insert(0, "gravity".to_owned());
    }
    parts.extend(found.dampers.iter().map(|damper| format!("the {}", named("damper", &damper.name))));
    parts.extend(found.tyres.iter().map(|tyre| format!("the tyre at {}", tyre.name)));
    parts.extend(found.anti_roll_bars.first().map(|_| "the anti-roll bar".to_owned()));
    parts.extend(found.drives.iter().map(|drive| format!("the drive of {}", drive.name)));
    parts.extend(joint_springs(found).iter().map(|group| format!("the {group}")));
    let left_out = match found.springs_left_out.is_empty() {
        true => String::new(),
        false => format!(" Left out: {}.", found.springs_left_out.join(", ")),
    };
    match parts.is_empty() {
        true => format!(
            "The impact in time includes the contact force alone: neither gravity nor springs, dampers and drives.{left_out}"
        ),
        false => format!("The impact in time includes {}.{left_out}", parts.join(", ")),
    }
}

/// Compression, contact time and damping: value and meaning.
pub fn motion(report: &ImpactReport, found: &ImpactTimeRecord) -> Vec<(String, String)> {
    let ContactUnits { force, length, small_length, .. } = ContactUnits::new(report.mass.contact.is_moment);
    let depth = with_unit(1e3 * found.max_penetration, small_length);
    let mut results = vec![(depth, format!("compression{}", mass_change(found)))];
    results.push(match found.duration {
        Some(duration) => (with_unit(1e3 * duration, "ms"), "contact time".to_owned()),
        None => ("no rebound".to_owned(), "the sides do not separate".to_owned()),
    });
    let of = match found.restitution_is_reached {
        true => "for this restitution with all forces",
        false => "of the contact alone",
    };
    results.extend(found.dissipation.map(|d| (with_unit(d, "s/m"), format!("dissipation {of}"))));
    results.extend(found.loss_factor.map(|loss| (number(loss), format!("loss factor {of}"))));
    results.extend(found.damping.map(|c| {
        let exponent = report.contact_law.as_ref().and_then(|law| law.exponent).unwrap_or(1.0);
        let power = unit_power(0.5 * (exponent + 1.0));
        (format!("{} {force}·s/{length}{power}", number(c)), format!("damping {of}"))
    }));
    results
}

/// Name of the energy of a report.
pub fn energy_name(report: &ImpactReport) -> &'static str {
    if report.in_time.is_some() { "energy lost in the contact" } else { "energy lost" }
}

/// Energy that the contact takes, J: of the impact in time, if there is one.
pub fn energy_lost(report: &ImpactReport) -> f64 {
    report.in_time.as_ref().map_or(report.energy_loss, |found| found.energy.taken_by_contact)
}

/// Change of m̄ from the touch to the largest compression, as text; empty if unknown.
pub fn mass_change(found: &ImpactTimeRecord) -> String {
    found.mass_change.map_or_else(String::new, |change| match change {
        change if change > LARGEST_PERCENTAGE => {
            "; the mechanism approaches a pose at which the contact is immovable".to_owned()
        }
        change => format!("; m̄ changes by {} % over it", signed(100.0 * change, 2)),
    })
}

/// True for the force of the contact, as in the fixed joints beside it: the curve would lie on that of the contact.
fn follows_contact(bearing: &BearingForceRecord, found: &ImpactTimeRecord) -> bool {
    let pairs = bearing.force.iter().zip(&found.force);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) <= SHOWN_FORCE * found.peak_force
}

fn is_loaded(bearing: &BearingForceRecord, found: &ImpactTimeRecord) -> bool {
    bearing.peak_force > SHOWN_FORCE * found.peak_force
}

/// Writes the impact in time as a figure or as numbers.
pub fn write_history(report: &ImpactReport, path: &str) -> Result<(), Failure> {
    report.mass.inputs.iter().for_each(|input| record_input(&input.path));
    let Some(found) = &report.in_time else { return Ok(()) };
    let table = || found.compliant.as_ref().map_or_else(|| cells(found), compliant::cells);
    let picture = || Ok(Box::new(sheet(report, found)) as Box<dyn Picture>);
    Contents { name: "impact", table: Some(&table), picture: Some(&picture), ..Contents::default() }
        .write(path)
}

/// One row for each time: contact, effective mass, joint rates, bearing forces.
fn cells(found: &ImpactTimeRecord) -> Cells {
    let mut names = ["time", "penetration", "rate", "force", "effective_mass"].map(str::to_owned).to_vec();
    for motion in &found.joints {
        match motion.rates.first().map_or(0, Vec::len) {
            1 => names.push(format!("rate of {}", motion.joint)),
            count => names.extend((0..count).map(|k| format!("rate {k} of {}", motion.joint))),
        }
    }
    let force =
        |bearing: &BearingForceRecord| format!("force at {}", place_name(bearing.place, &bearing.name));
    names.extend(found.bearings.iter().map(force));
    let row = |k: usize| {
        let contact = [found.times[k], found.penetration[k], found.closing_speed[k], found.force[k]];
        let mut row = contact.map(Cell::Number).to_vec();
        row.push(Cell::from_value(found.effective_mass[k]));
        row.extend(found.joints.iter().flat_map(|motion| &motion.rates[k]).map(|rate| Cell::Number(*rate)));
        row.extend(found.bearings.iter().map(|bearing| Cell::Number(bearing.force[k])));
        row
    };
    (names, (0..found.times.len()).map(row).collect())
}

/// Forces of the contact and of the most loaded bearings over time, for a place beside text.
pub fn forces_figure(report: &ImpactReport, found: &ImpactTimeRecord) -> Figure {
    let whole = figure(report, found);
    let panels = whole.panels.iter().take(1).cloned().collect();
    Figure { title: String::new(), subtitle: String::new(), panels, is_half: true, ..whole }
}

/// Sheet with the figure of the impact in time.
pub fn sheet(report: &ImpactReport, found: &ImpactTimeRecord) -> Sheet {
    Sheet { figures: vec![figure(report, found)] }
}

/// Figure of the impact in time: forces, penetration, effective mass.
fn figure(report: &ImpactReport, found: &ImpactTimeRecord) -> Figure {
    let over_time = |values: &dyn Fn(usize) -> Option<f64>| -> Vec<(f64, Option<f64>)> {
        found.times.iter().enumerate().map(|(k, t)| (1e3 * t, values(k))).collect()
    };
    let series = |name: String, points| Series { name, style: Style::Line, points };
    let mut forces = vec![series("contact".into(), over_time(&|k| Some(found.force[k])))];
    let mut loaded: Vec<&BearingForceRecord> = found
        .bearings
        .iter()
        .filter(|bearing| bearing.place != ReactionPlace::Ground && is_loaded(bearing, found))
        .filter(|bearing| !follows_contact(bearing, found))
        .collect();
    loaded.sort_by(|a, b| b.peak_force.total_cmp(&a.peak_force));
    for bearing in loaded.into_iter().take(MOST_SHOWN) {
        let points = over_time(&|k| Some(bearing.force[k]));
        forces.push(series(place_name(bearing.place, &bearing.name), points));
    }
    let panel = |label: &str, series| Panel { y_label: label.into(), series, ..Panel::default() };
    let depth = series("compression".into(), over_time(&|k| Some(1e3 * found.penetration[k])));
    let mass = series("effective mass".into(), over_time(&|k| found.effective_mass[k]));
    let deepest = (0..found.times.len())
        .max_by(|&a, &b| found.penetration[a].total_cmp(&found.penetration[b]))
        .map(|k| Mark { x: 1e3 * found.times[k], label: "deepest".into() });
    let is_moment = report.mass.contact.is_moment;
    let ContactUnits { mass: mass_unit, speed, force, small_length, .. } = ContactUnits::new(is_moment);
    let law = report.contact_law.as_ref().map_or_else(String::new, |law| {
        let units = ContactUnits::new(is_moment);
        let stiffness = stiffness_text(law.stiffness, law.exponent, law.stiffness_curve.as_ref(), &units);
        let stiffness = if law.stiffness.is_some() { format!("stiffness {stiffness}") } else { stiffness };
        format!("{}, {stiffness}, {} {speed}", law_name(law.law), number(report.closing_speed))
    });
    // For a moment, the contact has a moment in N·m; the bearings have forces in N.
    let label = if is_moment { "moment (N·m), forces (N)" } else { "force (N)" };
    Figure {
        title: format!(
            "Impact in time: restitution {}, peak force {}",
            number(found.restitution),
            load(found.peak_force, force)
        ),
        subtitle: law,
        x_label: "time (ms)".into(),
        panels: [panel(label, forces)]
            .into_iter()
            .chain(found.compliant.as_ref().map(|with| compliant::panel(found, with, label)))
            .chain([
                panel(&format!("compression ({small_length})"), vec![depth]),
                panel(&format!("m̄ ({mass_unit})"), vec![mass]),
            ])
            .collect(),
        marks: deepest.into_iter().collect(),
        ..Figure::default()
    }
}
