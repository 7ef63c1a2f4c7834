//! Command `percuss impact`.

use crate::args::{CheckFormat, ImpactArgs};
use crate::commands::damp::{law_name, stiffness_text};
use crate::commands::impacts::bearings::{BearingTable, place_name};
use crate::commands::impacts::{compliant, in_time, reflected, simultaneous};
use crate::commands::mass::add_estimate;
use crate::commands::mass::conditions::{facts as mass_facts, place as place_of};
use crate::document::{self, Document};
use crate::files::contents::{self, TABLES_AND_PICTURES};
use crate::pictures::impulses;
use crate::terminal::explanation::friction_thresholds;
use crate::terminal::failure::Failure;
use crate::terminal::number::{load, number, rounded, signed, triple, with_unit};
use crate::terminal::report::{details_are_shown, with_findings, write_diagnostics};
use crate::terminal::text::Table;
use crate::terminal::units::ContactUnits;
use percuss_render::Picture;
use percuss_study::{
    DrawnMechanism, FrictionRecord, ImpactReport, JointConstraintKind, JointRateRecord, ReactionRecord,
    Status, impact,
};

/// Largest ratio to the peak force of a bearing at which the forces of the motion before the impact are not reported.
const SMALL_MOTION_FORCE: f64 = 0.01;

/// Parts of the text of an impact that are shown on request.
#[derive(Clone, Copy, Debug, Default)]
pub struct ImpactView {
    /// Bearings of any load.
    pub all: bool,
    /// Components of the reactions.
    pub components: bool,
}

/// Runs the command.
pub fn run(args: &ImpactArgs) -> Result<(), Failure> {
    args.writing.apply();
    args.output.as_deref().map_or(Ok(()), |path| contents::check(path, &TABLES_AND_PICTURES))?;
    if args.needs_no_contact() {
        return reflected::run(args);
    }
    let contact = args.contact.question()?;
    args.impact.check()?;
    let model = args.model.load()?;
    let report = with_findings(impact(&model, &contact, &args.impact), &model)?;
    write_diagnostics(&report.diagnostics, args.model.reading.strict)?;
    if let Some(path) = &args.output {
        write_output(&report, path)?;
    }
    write(&report, args.format, ImpactView { all: args.all, components: args.components })
}

/// Writes the impact in time or the reflected inertias over ranges to a file.
fn write_output(report: &ImpactReport, path: &str) -> Result<(), Failure> {
    match (&report.in_time, &report.reflected_over[..]) {
        (Some(_), []) => in_time::write_history(report, path),
        (None, ranges @ [_, ..]) => reflected::write_ranges(ranges, &report.mass.inputs, path),
        (Some(_), _) => Err(Failure::bad_input(format!(
            "--output {path}: one file cannot contain both --in-time and a range of --reflected; run the command once for each"
        ))),
        (None, []) => Err(reflected::no_output(path)),
    }
}

/// Writes a report.
pub fn write(report: &ImpactReport, format: CheckFormat, view: ImpactView) -> Result<(), Failure> {
    document::print(report, format, || text_document(report, view))
}

/// Text for a terminal.
fn text_document(report: &ImpactReport, view: ImpactView) -> Document<'_> {
    let mut out = Document::default();
    if let Some(several) = &report.simultaneous {
        simultaneous::add(report, several, None, &mut out);
        if several.contacts.len() > 1 {
            out.heading(format!("Impact of {} alone", several.contacts[0].name));
        }
    }
    out.results(results(report));
    out.facts(facts(report));
    if let Some(table) = law_table(report) {
        out.table(table);
        out.note(law_note(report));
    }
    if has_drives(report) || details_are_shown() {
        out.table(mass_table(report));
        out.note(mass_note(report));
    }
    // A free body has no joints.
    if !report.reactions.is_empty() {
        let BearingTable { table, note } = BearingTable::new(report, view.all, false);
        out.table(table);
        let components = if view.components { "" } else { "components along the axes: --components" };
        let separator =
            if note.is_empty() || note.ends_with('\n') || components.is_empty() { "" } else { " · " };
        out.note(format!("{note}{separator}{components}").trim_end());
    }
    if view.components {
        out.table(reaction_table(report));
        out.note(legend(report));
    }
    compliant::add(report, None, view.all, &mut out);
    out.table(gear_table(report));
    add_joint_constraints(report, &mut out);
    if details_are_shown() {
        out.table(rate_table(report, false).0);
        out.facts(mass_facts(&report.mass));
    }
    add_estimate(&report.mass, &mut out);
    out.remark(validity(report));
    out
}

/// Adds the impulses of locks, mimics and couplings.
fn add_joint_constraints<'a>(report: &'a ImpactReport, out: &mut Document<'a>) {
    let constraints = joint_constraint_table(report);
    if !constraints.is_empty() {
        out.table(constraints);
        out.note(joint_constraint_note(report));
    }
}

/// Motion before the impact, and what is not included.
fn validity(report: &ImpactReport) -> String {
    let friction = if report.friction.is_some() { "" } else { "no friction, " };
    let several = if report.simultaneous.is_some() { "" } else { ", one impact" };
    let forces = match &report.in_time {
        None => "gravity, springs and dampers do not act".to_owned(),
        Some(found) => in_time::forces_sentence(found),
    };
    let before = match report.motion_before {
        "given" => String::new(),
        _ => "before: v*, the motion of least energy at this closing speed; --rates sets it\n".to_owned(),
    };
    format!("{before}{friction}rigid links{several} · {forces} · docs/howto/IMPACT.md")
}

/// Section of a page: several contacts, results, masses, laws, bearings, rates, with pictures of the mechanism.
pub fn document<'a>(report: &'a ImpactReport, mechanism: &'a DrawnMechanism) -> Document<'a> {
    let mut out = Document::default();
    if let Some(several) = &report.simultaneous {
        simultaneous::add(report, several, Some(mechanism), &mut out);
        if several.contacts.len() > 1 {
            out.heading(format!("Impact of {} alone", several.contacts[0].name));
        }
    }
    out.results(results(report));
    out.facts(facts(report));
    let svg = || impulses::of_contact(report, mechanism).to_svg();
    out.large_picture(svg, "Impulses in the mechanism", impulses::caption(report));
    if let Some(found) = &report.in_time {
        let figure = || in_time::sheet(report, found).to_svg();
        out.picture(figure, "Forces and compression over time", "");
    }
    if !report.reactions.is_empty() {
        let BearingTable { table, note } = BearingTable::new(report, false, true);
        out.heading("Bearings");
        out.table(table);
        out.note(note);
        out.heading("Reactions by components");
        out.table(reaction_table(report));
        out.note(legend(report));
    }
    compliant::add(report, Some("Bushes and gears"), false, &mut out);
    out.table(gear_table(report));
    add_joint_constraints(report, &mut out);
    if !report.mass_states.is_empty() {
        out.heading("Masses");
    }
    out.table(mass_table(report));
    out.note(mass_note(report));
    if let Some(table) = law_table(report) {
        out.table(table);
        out.note(law_note(report));
    }
    let (rates, resting) = rate_table(report, true);
    out.heading("Rates of the joints");
    out.table(rates);
    if resting > 0 {
        out.note(format!("{resting} joints without motion are left out."));
    }
    if !report.reflected_over.is_empty() {
        out.heading("Reflected inertia");
        let figure = || reflected::sheet(&report.reflected_over, "").to_svg();
        out.picture(figure, "Reflected inertia over the position of the joint", "");
    }
    out
}

/// Table of the loaded bearings, and the remark below it.
pub fn bearings(report: &ImpactReport) -> (Table, String) {
    let BearingTable { table, note } = BearingTable::new(report, false, false);
    (table, note.replace(": --all", ""))
}

/// True if rotors move with the joints: m̄ depends on the compliance of the gears.
fn has_drives(report: &ImpactReport) -> bool {
    let [decoupled, coupled, _] = &report.mass_states[..] else { return false };
    decoupled.sliding != coupled.sliding || decoupled.sticking != coupled.sticking
}

/// Peak force, compression, contact time, impulse, energy lost, and m̄ with its place: value and meaning.
pub fn results(report: &ImpactReport) -> Vec<(String, String)> {
    let is_moment = report.mass.contact.is_moment;
    let units = ContactUnits::new(is_moment);
    let ContactUnits { mass: mass_unit, impulse, speed, force, .. } = units;
    let what = if is_moment { "peak moment" } else { "peak force" };
    let at = report
        .mass
        .named_contact
        .as_ref()
        .map_or_else(String::new, |contact| format!(" at {}", contact.name));
    let mut results = Vec::new();
    let law = report.contact_law.as_ref().map_or_else(String::new, |law| {
        format!(
            " ({}, {})",
            law_name(law.law),
            stiffness_text(law.stiffness, law.exponent, law.stiffness_curve.as_ref(), &units)
        )
    });
    let peak = report.in_time.as_ref().map(|found| found.peak_force);
    if let Some(peak) = peak.or(report.contact_law.as_ref().map(|law| law.peak_force)) {
        results.push((load(peak, force), format!("{what}{at}{law}")));
    }
    results.extend(report.in_time.iter().flat_map(|found| in_time::motion(report, found)));
    let place = if results.is_empty() { &*at } else { "" };
    let instantaneous = if report.in_time.is_some() { " of the instantaneous impact" } else { "" };
    results.push((with_unit(report.impulse, impulse), format!("impulse{place}{instantaneous}")));
    let closing = with_unit(report.closing_speed, speed);
    let requested = number(report.restitution);
    let lost = with_unit(in_time::energy_lost(report), "J");
    if let Some(found) = &report.in_time {
        let of = if found.restitution_is_reached { "as requested" } else { "for the contact alone" };
        let reached = format!("restitution reached, {requested} {of}; closing speed {closing}");
        results.push((number(found.restitution), reached));
        results.push((lost, in_time::energy_name(report).to_owned()));
    } else {
        results.push((lost, format!("energy lost; closing speed {closing}, restitution {requested}")));
    }
    if let Some(m) = report.mass.effective_mass {
        let sliding = match report.sticking_status {
            Some(Status::Finite) => "\n(sliding contact point)",
            _ => "",
        };
        results.push((with_unit(m, mass_unit), place_of(&report.mass) + sliding));
    }
    results
}

/// Further results: friction, masses, peaks, speeds, reflected inertias, centres of percussion.
fn facts(report: &ImpactReport) -> Vec<(&'static str, String)> {
    let is_moment = report.mass.contact.is_moment;
    let ContactUnits { speed, force, .. } = ContactUnits::new(is_moment);
    let mut facts = Vec::new();
    facts.extend(report.friction.iter().flat_map(|friction| friction_facts(friction, report)));
    // An immovable sticking point matters with friction only.
    let is_shown =
        |sticking: &Status| *sticking == Status::Finite || report.friction.is_some() || details_are_shown();
    if let Some(sticking) = report.sticking_status.filter(is_shown) {
        facts.push((
            "sticking mass",
            match (sticking, report.sticking_mass) {
                (Status::Finite, Some(mass)) => {
                    format!("{} kg, if the point cannot slide sideways", number(mass))
                }
                (Status::Massless, _) => "massless".to_owned(),
                _ => "immovable: the point closes the gap only by sliding sideways".to_owned(),
            },
        ));
    }
    if let Some(other) = report.other_body {
        let change = number(other.speed_change);
        facts.push(("other body", format!("{} kg, its speed changes by {change} m/s", number(other.mass))));
    }
    if let Some(law) = &report.contact_law {
        // With the impact in time, its own change is shown.
        let change = law.mass_change_over_penetration.filter(|_| report.in_time.is_none());
        facts.extend(
            change.map(|change| {
                ("change of m̄", format!("{} % over the compression", signed(100.0 * change, 2)))
            }),
        );
        facts.extend(law.mass_in_compression.map(|mass| {
            let direction = if law.direction_changes {
                "; the direction of the contact force changes in compression, and the peaks of the bearings use its mean"
            } else {
                ""
            };
            let text = format!("as of {} kg without friction (same work of compression){direction}", number(mass));
            ("normal force", text)
        }));
    }
    let motion = report.contact_law.iter().flat_map(|law| &law.motion_force);
    let motion = motion.filter(|motion| motion.ratio > SMALL_MOTION_FORCE && report.in_time.is_none());
    facts.extend(motion.map(|motion| {
        let text = format!(
            "the velocities before the impact alone load {} with {}; the peak forces of the bearings exclude it, an impact in time \
             includes it",
            place_name(motion.place, &motion.name),
            load(motion.force, force)
        );
        ("motion forces", text)
    }));
    facts.extend(in_time::facts(report));
    if let Some(greatest) = &report.greatest_closing_speed {
        let gear = match greatest.limit {
            "gear" => "the impulse in the gear of ",
            "gear-torque" => "the peak torque in the gear of ",
            _ => "",
        };
        let by = format!("{} {speed}, limited by {gear}{}", number(greatest.speed), greatest.joint);
        facts.push(("greatest speed", by));
    }
    for joint in &report.limits_without_effect {
        let note =
            format!("the limit of {joint} has no effect: the impact does not change the rate of this joint");
        facts.push(("greatest speed", note));
    }
    facts.extend(reflected::facts(&report.reflected_inertia, &report.reflected_over));
    for centre in &report.percussion {
        let along = if centre.direction.is_some() { "along the line" } else { "in the tangent plane" };
        let open = if centre.open_by.is_empty() {
            String::new()
        } else {
            format!("; determinate components only, others are left open by {}", centre.open_by.join(", "))
        };
        facts.push((
            "percussion",
            format!(
                "least impulse at {} {along}: contact point {} m, {} m away; {} of the impulse remains, {} at the \
                 given point{open}",
                centre.joint,
                triple(&centre.point_link),
                number(centre.distance),
                number(rounded(centre.remaining_ratio, 1.0)),
                number(centre.given_ratio),
            ),
        ));
        if let (Some(ratio), Some(point)) = (centre.worst_ratio, &centre.worst_point_link) {
            let worst = format!(
                "impulse at {}: {} of the contact impulse, with the contact point displaced to {} m",
                centre.joint,
                number(ratio),
                triple(point)
            );
            facts.push(("displaced point", worst));
        }
    }
    facts
}

/// Friction: result, phases and thresholds.
fn friction_facts(friction: &FrictionRecord, report: &ImpactReport) -> Vec<(&'static str, String)> {
    let end = if friction.wedged { "wedged, without rebound" } else { "rebounds" };
    let slides = match friction.slope {
        Some(slope) => format!("the point slides with {} of the closing speed", number(slope)),
        None => {
            let speed = |v: &[f64; 3]| number(v.iter().map(|x| x * x).sum::<f64>().sqrt());
            let assumed = if report.motion_before == "given" { "" } else { " (by the assumed motion)" };
            format!(
                "the point slides with {} m/s before{assumed} and {} m/s after the impact",
                speed(&friction.sliding_before_world),
                speed(&friction.sliding_after_world),
            )
        }
    };
    let mut facts = vec![(
        "friction",
        format!(
            "coefficient {}; {slides}: {end}, separation speed {} of the closing speed; impulse on the contact link {} N·s \
             (world)",
            number(friction.coefficient),
            number(rounded(friction.kinematic_restitution, 1.0)),
            triple(&friction.tangential_impulse_world),
        ),
    )];
    let phases: Vec<String> =
        friction.phases.iter().map(|phase| format!("{} ({})", phase.kind, phase.stage)).collect();
    if !phases.is_empty() {
        facts.push(("phases", phases.join(", ")));
    }
    facts.extend(friction_thresholds(&friction.thresholds()).map(|text| ("thresholds", text)));
    facts
}

/// Masses by the state of rotors and joints.
fn mass_table(report: &ImpactReport) -> Table {
    let mut table = Table::new(["mass, kg", "sliding point", "sticking point"]);
    let shown = |status: Status, mass: Option<f64>| mass.map_or_else(|| status.name().to_owned(), number);
    for state in &report.mass_states {
        let name = match state.state {
            "rotors-decoupled" => "rotors decoupled (compliant gears)",
            "rotors-coupled" => "rotors coupled (result above)",
            _ => "joints locked (one body, free of the ground)",
        };
        table.row([
            name.to_owned(),
            shown(state.sliding_status, state.sliding),
            shown(state.sticking_status, state.sticking),
        ]);
    }
    table
}

/// Explanation of the last row of the masses, if it is smaller than the second row.
fn mass_note(report: &ImpactReport) -> &'static str {
    let [_, coupled, locked] = &report.mass_states[..] else { return "" };
    let sliding = coupled.sliding.zip(locked.sliding);
    if sliding.is_some_and(|(coupled, locked)| locked < coupled) {
        "The body of the last row has no bearings on the ground; here these bearings increase the effective mass of the mechanism."
    } else {
        ""
    }
}

/// Laws of restitution side by side; `None` without friction.
fn law_table(report: &ImpactReport) -> Option<Table> {
    let friction = report.friction.as_ref()?;
    let mut table =
        Table::new(["law of restitution", "impulse N·s", "friction N·s", "separation m/s", "energy lost J"]);
    let shown = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), number);
    for law in &friction.laws {
        let mark = if law.law == friction.law { " (used)" } else { "" };
        let created = if law.creates_energy { " (creates energy)" } else { "" };
        table.row([
            format!("{}{mark}", law.law),
            shown(law.normal_impulse),
            shown(law.tangential_impulse),
            shown(law.separation_speed),
            format!("{}{created}", shown(law.energy_loss)),
        ]);
    }
    Some(table)
}

/// Explanation of the laws of restitution.
fn law_note(report: &ImpactReport) -> String {
    let used = report.friction.iter().flat_map(|f| f.laws.iter().filter(|law| law.law == f.law));
    let warning = if used.into_iter().any(|law| law.creates_energy) {
        "Warning: the law that is used creates energy; its result is not valid. "
    } else {
        ""
    };
    format!(
        "{warning}Rigid contact without tangential compliance: a ball with a soft surface can spin back. The laws differ in the meaning \
         of the restitution (docs/howto/IMPACT.md)."
    )
}

/// Rates of the joints and of a floating base, and the number of joints that are left out: with `only_moving` those without motion.
fn rate_table(report: &ImpactReport, only_moving: bool) -> (Table, usize) {
    let mut table = Table::new(["rate, rad/s or m/s", "before", "after", ""]);
    let values = report.rates.iter().flat_map(|r| r.before.iter().chain(&r.after));
    let largest = values.fold(0.0, |most: f64, v| most.max(v.abs()));
    let list =
        |values: &[f64]| values.iter().map(|v| number(rounded(*v, largest))).collect::<Vec<_>>().join(",");
    let is_at_rest =
        |rate: &&JointRateRecord| rate.before.iter().chain(&rate.after).all(|v| rounded(*v, largest) == 0.0);
    let resting = report.rates.iter().filter(|_| only_moving).filter(is_at_rest).count();
    for rate in report.rates.iter().filter(|rate| !only_moving || !is_at_rest(rate)) {
        let note = if rate.undetermined { "undetermined: a motion without mass" } else { "" };
        table.row([rate.joint.clone(), list(&rate.before), list(&rate.after), note.to_owned()]);
    }
    if let Some(base) = &report.base {
        let name = |what: &str| format!("base, {what} (world)");
        table.row([name("angular"), list(&base.angular_before), list(&base.angular_after), String::new()]);
        table.row([name("linear"), list(&base.linear_before), list(&base.linear_after), String::new()]);
    }
    (table, resting)
}

/// Table of reactions.
fn reaction_table(report: &ImpactReport) -> Table {
    let largest = |components: fn(&ReactionRecord) -> &[Option<f64>; 3]| {
        let all = report.reactions.iter().flat_map(move |r| components(r).iter().flatten());
        all.fold(0.0, |most: f64, v| most.max(v.abs()))
    };
    let (force, moment) = largest_impulses(report, largest(|r| &r.force), largest(|r| &r.moment));
    let shown = |components: &[Option<f64>; 3], size: f64| {
        components.iter().map(|v| component(*v, size)).collect::<Vec<_>>().join(", ")
    };
    let [force_header, moment_header] = ["force N·s", "moment N·m·s"];
    // The last column is wrapped if the table is too wide.
    let mut table = Table::new(match report.contact_law {
        Some(_) => ["reaction", "peak N", force_header, moment_header],
        None => ["reaction", force_header, moment_header, ""],
    });
    for record in report.reactions.iter().filter(|record| !is_unloaded(record, force, moment)) {
        let (at, force, moment) = (place(record), shown(&record.force, force), shown(&record.moment, moment));
        table.row(match record.peak_force {
            Some(peak) => {
                let known: Option<Vec<f64>> = peak.into_iter().collect();
                let norm = known.map(|values| values.iter().map(|v| v * v).sum::<f64>().sqrt());
                [at, component(norm, 0.0), force, moment]
            }
            None => [at, force, moment, String::new()],
        });
    }
    table
}

/// Largest impulse (N·s) and moment impulse (N·m·s) of the reactions and of the contact. `force`, `moment`: largest of the reactions.
/// An impulse and a moment impulse are converted into each other by the characteristic length.
fn largest_impulses(report: &ImpactReport, force: f64, moment: f64) -> (f64, f64) {
    let size = report.mass.characteristic_length;
    let impulse = if report.mass.contact.is_moment { report.impulse / size } else { report.impulse };
    let force = force.max(impulse);
    (force, moment.max(force * size))
}

/// True if a place transmits nothing beyond rounding.
fn is_unloaded(record: &ReactionRecord, force: f64, moment: f64) -> bool {
    let none = |components: &[Option<f64>; 3], size| {
        components.iter().all(|v| v.is_some_and(|v| rounded(v, size) == 0.0))
    };
    none(&record.force, force) && none(&record.moment, moment)
}

/// Component as text: 0 for a value that is rounding relative to `size`, ? for an indeterminate component.
fn component(value: Option<f64>, size: f64) -> String {
    value.map_or_else(|| "?".to_owned(), |v| number(rounded(v, size)))
}

/// Explanation of the table of reactions.
fn legend(report: &ImpactReport) -> String {
    let mut legend = "Rates of a ball joint are the angular velocity of its child in the axes of the child. Reactions are the action of the \
                      parent on the child, along two transverse axes and the axis of the joint; the moment refers to the origin of \
                      the child. The ground acts along the axes of the root link. --format json contains all axes and points. Joints \
                      without any reaction are left out."
        .to_owned();
    let mut open: Vec<&str> =
        report.reactions.iter().flat_map(|r| r.open_by.iter().map(String::as_str)).collect();
    open.sort_unstable();
    open.dedup();
    if !open.is_empty() {
        legend += &format!(
            "\n?: indeterminate; redundant constraints leave the component open: {}.",
            open.join(", ")
        );
    }
    legend
}

/// Name of the place of a reaction.
fn place(record: &ReactionRecord) -> String {
    place_name(record.place, &record.name)
}

/// Table of the impulses in gears; empty if no gear has an impulse.
fn gear_table(report: &ImpactReport) -> Table {
    let mut table = Table::new(["drive", "impulse in the gear (N·m·s, N·s)"]);
    let scale = drive_scale(report);
    for record in report.reactions.iter().filter(|record| record.gear.iter().any(|gear| *gear != 0.0)) {
        let gear: Vec<String> = record.gear.iter().map(|v| component(Some(*v), scale)).collect();
        table.row([record.name.clone(), gear.join(", ")]);
    }
    table
}

/// Table of the impulses of locks, mimics and couplings on their joints; empty if all impulses are zero.
fn joint_constraint_table(report: &ImpactReport) -> Table {
    let mut table = Table::new(["constraint of joints", "impulses (N·m·s, N·s)"]);
    let scale = drive_scale(report);
    let is_loaded = |v: &Option<f64>| v.is_none_or(|v| rounded(v, scale) != 0.0);
    for record in report.joint_constraints.iter().filter(|record| record.impulses.iter().any(is_loaded)) {
        let place = format!("{} {}", record.kind.name(), record.name);
        let of_joint =
            |(joint, value): (&String, &Option<f64>)| format!("{joint} {}", component(*value, scale));
        let impulses = record.joints.iter().zip(&record.impulses);
        let impulses: Vec<String> = match record.kind {
            JointConstraintKind::Lock => impulses.map(|(_, value)| component(*value, scale)).collect(),
            _ => impulses.map(of_joint).collect(),
        };
        table.row([place, impulses.join(", ")]);
    }
    table
}

/// Names of the constraints that leave impulses of locks, mimics and couplings open; empty if all impulses are determinate.
fn joint_constraint_note(report: &ImpactReport) -> String {
    let open = report.joint_constraints.iter().flat_map(|record| record.open_by.iter().map(String::as_str));
    let mut open: Vec<&str> = open.collect();
    open.sort_unstable();
    open.dedup();
    if open.is_empty() {
        return String::new();
    }
    format!(
        "?: indeterminate; redundant constraints leave the impulse open: {}. The sum of the impulses on a joint can still be determinate: \
         see constraint in --format json.",
        open.join(", ")
    )
}

/// Scale for the rounding of the impulses of gears, locks, mimics and couplings, N·m·s: an impulse far below this scale is shown as 0.
fn drive_scale(report: &ImpactReport) -> f64 {
    report.impulse * report.mass.characteristic_length.max(1.0)
}
