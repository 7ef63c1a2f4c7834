//! Section of an impact: impulses in the mechanism, bearings, rates, impact in time.

use super::findings::add_warnings;
use super::mechanism::drawing;
use crate::commands::impacts::{extremes, in_time, reflected, rigid_impact, simultaneous};
use crate::files::html::Page;
use crate::terminal::text::short_number;
use percuss_render::{Drawing, DrawnArrow, SkinMark};
use percuss_study::{
    DrawnMechanism, ExtremesReport, ImpactReport, ReactionPlace, ReactionRecord, SimultaneousLawRecord,
    SimultaneousRecord, TouchingRecord,
};

/// Impulse in a bearing, relative to the largest, below which the picture has no arrow.
const DRAWN_IMPULSE: f64 = 1e-3;

/// Explanation of the picture of the impulses.
const LEGEND: &str = "Impulses of the impact. The red arrow p is the impulse on the contact link, the blue arrows are the impulses that \
    the bearings exert on the second of their links, as in the tables below. All arrows have the same scale.";

/// Caption of the drawing for a moment about an axis.
const LEGEND_OF_MOMENT: &str = "Impulses of the impact. The arrows are the impulses that the bearings exert on the second of their links, as in \
    the tables below. The contact is a moment about an axis and has no arrow.";

/// Section of an impact.
pub(super) fn add_impact(report: &ImpactReport, mechanism: &DrawnMechanism, page: &mut Page) {
    page.section("Impact");
    page.facts(rigid_impact::results(report));
    let mut caption = match report.mass.contact.is_moment {
        true => LEGEND_OF_MOMENT.to_owned(),
        false => LEGEND.to_owned(),
    };
    if report.reactions.iter().any(|record| !record.open_by.is_empty()) {
        caption +=
            " Redundant constraints leave components open: of these bearings the determinate part is drawn.";
    }
    if report.simultaneous.as_ref().is_some_and(|several| several.contacts.len() > 1) {
        caption += " Impulses of the first contact alone.";
    }
    page.large_picture(&impulse_drawing(report, mechanism).to_svg(), "Impulses in the mechanism");
    page.paragraph("soft", &caption);
    if let Some(table) = rigid_impact::law_table(report) {
        page.table(table.rows());
        page.paragraph("soft", &rigid_impact::law_note(report).replace('\n', " "));
    }
    if !report.mass_states.is_empty() {
        page.heading("Masses");
        page.table(rigid_impact::mass_table(report).rows());
        let note = rigid_impact::mass_note(report);
        if !note.is_empty() {
            page.paragraph("soft", note);
        }
    }
    add_simultaneous(report, mechanism, page);
    // A free body has no bearings.
    let bearings = bearing_rows(report);
    if bearings.len() > 1 {
        page.heading("Bearings");
        page.table(&bearings);
        page.heading("Reactions by components");
        page.table(rigid_impact::reaction_table(report).rows());
        page.paragraph("soft", &rigid_impact::legend(report).replace('\n', " "));
    }
    if let Some(table) = rigid_impact::gear_table(report) {
        page.table(table.rows());
    }
    if let Some(table) = rigid_impact::joint_constraint_table(report) {
        page.table(table.rows());
        page.paragraph("soft", &rigid_impact::joint_constraint_note(report).replace('\n', " "));
    }
    if !report.reflected_over.is_empty() {
        page.heading("Reflected inertia");
        let figure = reflected::sheet(&report.reflected_over, "").to_svg();
        page.picture(&figure, "Reflected inertia over the position of the joint", "");
    }
    page.heading("Rates of the joints");
    add_rates(report, page);
    if let Some(found) = &report.in_time {
        page.heading("Impact in time");
        page.picture(&in_time::sheet(report, found).to_svg(), "Forces and penetration over time", "");
        if let Some(table) = in_time::bearing_table(report) {
            page.table(table.rows());
        }
    }
    add_warnings(&report.diagnostics, page);
}

/// Section of the extremes of a contact.
pub(super) fn add_extremes(report: &ExtremesReport, page: &mut Page) {
    page.section("Extremes");
    page.facts(extremes::facts(report).into_iter().map(|(name, value)| (name.trim_start(), value)));
    page.paragraph("soft", &extremes::note(report).replace('\n', " "));
    add_warnings(&report.diagnostics, page);
}

/// Several contacts at once, and sticking points.
fn add_simultaneous(report: &ImpactReport, mechanism: &DrawnMechanism, page: &mut Page) {
    let Some(several) = &report.simultaneous else { return };
    page.heading("Several contacts at once");
    // Last law of the table without a refusal and without indeterminate impulses.
    let is_complete =
        |law: &&SimultaneousLawRecord| law.refusal.is_none() && law.impulses.iter().all(Option::is_some);
    if let Some(law) = several.laws.iter().rev().find(is_complete) {
        page.large_picture(&contacts_drawing(several, law, mechanism).to_svg(), "Impulses at all contacts");
        let caption = format!(
            "Impulses on the links at all contacts by the law {}; the table shows the other laws.",
            law.law
        );
        page.paragraph("soft", &caption);
    }
    page.table(simultaneous::contact_table(several).rows());
    if !several.laws.is_empty() {
        page.table(simultaneous::law_table(several).rows());
        page.paragraph("soft", &simultaneous::law_note(several).replace('\n', " "));
    }
    if let Some(sticking) = &several.sticking {
        let friction = report.friction.as_ref().map(|friction| friction.coefficient);
        page.table(simultaneous::sticking_table(several, sticking).rows());
        page.paragraph("soft", &simultaneous::sticking_note(sticking, friction).replace('\n', " "));
    }
}

/// True if a contact has a contact point: not for the stop of a joint or a moment.
fn has_point(contact: &TouchingRecord) -> bool {
    !contact.is_joint_stop && !contact.is_moment
}

/// Drawing of the mechanism with the impulses of a law at all contacts, without stops of joints, which have no contact point.
fn contacts_drawing(
    several: &SimultaneousRecord,
    law: &SimultaneousLawRecord,
    mechanism: &DrawnMechanism,
) -> Drawing {
    let contacts = several.contacts.iter().zip(&law.impulses).enumerate();
    let arrows =
        contacts.filter(|(_, (contact, _))| has_point(contact)).map(|(k, (contact, impulse))| DrawnArrow {
            from: contact.point_world,
            vector: contact.normal_world.map(|n| -impulse.unwrap_or(0.0) * n),
            label: format!("p{}", k + 1),
        });
    let marks = several.contacts.iter().filter(|contact| has_point(contact));
    loaded_drawing(
        mechanism,
        arrows.collect(),
        marks.map(|contact| SkinMark { at: contact.point_world, label: String::new() }).collect(),
    )
}

/// Drawing of the mechanism with arrows of one scale. Arrows shorter than `DRAWN_IMPULSE` times the longest are left out.
fn loaded_drawing(mechanism: &DrawnMechanism, arrows: Vec<DrawnArrow>, marks: Vec<SkinMark>) -> Drawing {
    let largest = arrows.iter().map(|arrow| norm(arrow.vector)).fold(0.0, f64::max);
    let mut drawn = drawing(None, mechanism);
    // Grey lines, so that the arrows stand out.
    drawn.lines.iter_mut().for_each(|line| line.intensity = Some(0.0));
    Drawing {
        arrows: Vec::new(),
        loads: arrows.into_iter().filter(|arrow| norm(arrow.vector) > DRAWN_IMPULSE * largest).collect(),
        marks,
        ..drawn
    }
}

/// The mechanism with the impulses at the contact and in all bearings.
fn impulse_drawing(report: &ImpactReport, mechanism: &DrawnMechanism) -> Drawing {
    let contact = &report.mass.contact;
    let mut impulse = contact.normal_world.map(|n| -report.impulse * n);
    if let Some(friction) = &report.friction {
        impulse.iter_mut().zip(friction.tangential_impulse_world).for_each(|(p, t)| *p += t);
    }
    // A moment has no point and no arrow.
    let of_contact = (!contact.is_moment).then(|| DrawnArrow {
        from: contact.point_world,
        vector: impulse,
        label: "p".into(),
    });
    // The reaction of the ground repeats those of the joints of the root link. A fixed joint is no bearing.
    let bearings = report.reactions.iter().filter(|record| match record.place {
        ReactionPlace::Ground => false,
        ReactionPlace::Joint => !record.gear.is_empty(),
        ReactionPlace::Closure | ReactionPlace::Hold => true,
    });
    let arrows: Vec<DrawnArrow> = bearings
        .map(|record| DrawnArrow {
            from: record.point_world,
            vector: world_vector(record, &record.force),
            label: String::new(),
        })
        .chain(of_contact)
        .collect();
    let mark = (!contact.is_moment).then(|| SkinMark { at: contact.point_world, label: String::new() });
    let centres = report.percussion.iter().map(|centre| SkinMark {
        at: centre.point_world,
        label: format!("centre of percussion ({})", centre.joint),
    });
    loaded_drawing(mechanism, arrows, mark.into_iter().chain(centres).collect())
}

/// Vector with the determinate components of a reaction, world axes.
fn world_vector(record: &ReactionRecord, components: &[Option<f64>; 3]) -> [f64; 3] {
    std::array::from_fn(|k| {
        let terms = components.iter().zip(&record.axes_world);
        terms.map(|(value, axis)| value.unwrap_or(0.0) * axis[k]).sum()
    })
}

/// Euclidean norm.
fn norm(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Table of the loaded bearings by magnitude: impulse and moment, and with a contact law their peaks. Open components make a magnitude a
/// lower bound.
fn bearing_rows(report: &ImpactReport) -> Vec<Vec<String>> {
    let magnitude = |components: &[Option<f64>; 3]| norm(components.map(|c| c.unwrap_or(0.0)));
    let shown = |components: &[Option<f64>; 3], size: f64| {
        let value = magnitude(components);
        let value = if value > DRAWN_IMPULSE * size { short_number(value) } else { "0".to_owned() };
        let is_open = components.iter().any(Option::is_none);
        if is_open { format!("{value} or more") } else { value }
    };
    let largest = |of: fn(&ReactionRecord) -> &[Option<f64>; 3]| {
        report.reactions.iter().map(|record| magnitude(of(record))).fold(0.0, f64::max)
    };
    let (force, moment) =
        rigid_impact::largest_impulses(report, largest(|r| &r.force), largest(|r| &r.moment));
    let mut bearings: Vec<&ReactionRecord> = report
        .reactions
        .iter()
        .filter(|record| {
            magnitude(&record.force) > DRAWN_IMPULSE * force
                || magnitude(&record.moment) > DRAWN_IMPULSE * moment
        })
        .collect();
    bearings.sort_by(|a, b| magnitude(&b.force).total_cmp(&magnitude(&a.force)));
    let law = report.contact_law.as_ref().filter(|_| report.reactions.iter().all(|r| r.peak_force.is_some()));
    let peak = law.map(|law| law.peak_force / report.impulse);
    let mut header = vec!["bearing", "from", "on", "force N·s", "moment N·m·s"];
    header.extend(peak.iter().flat_map(|_| ["peak force N", "peak moment N·m"]));
    let mut rows: Vec<Vec<String>> = vec![header.into_iter().map(str::to_owned).collect()];
    for record in bearings {
        let link = |name: &Option<String>| name.clone().unwrap_or_else(|| "ground".to_owned());
        let mut row =
            vec![in_time::place_name(record.place, &record.name), link(&record.from), link(&record.on)];
        row.extend([shown(&record.force, force), shown(&record.moment, moment)]);
        if let (Some(factor), Some(f), Some(m)) = (peak, &record.peak_force, &record.peak_moment) {
            row.extend([shown(f, factor * force), shown(m, factor * moment)]);
        }
        rows.push(row);
    }
    rows
}

/// Table of the rates before and after an impact, without the joints at rest, such as those of the other side of a vehicle.
fn add_rates(report: &ImpactReport, page: &mut Page) {
    let table = rigid_impact::rate_table(report);
    let is_at_rest =
        |row: &[String; 4]| row[1..3].iter().all(|rates| rates.split(',').all(|rate| rate == "0"));
    let moving: Vec<_> = table.rows().iter().filter(|row| !is_at_rest(row)).cloned().collect();
    page.table(&moving);
    let resting = table.rows().len() - moving.len();
    if resting > 0 {
        page.paragraph("soft", &format!("{resting} joints without motion are left out."));
    }
}
