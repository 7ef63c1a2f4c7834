//! Drawings of the impulses at contacts and in bearings.

use crate::pictures::mechanism::drawing;
use percuss_render::{Drawing, DrawnArrow, SkinMark};
use percuss_study::{
    DrawnMechanism, ImpactReport, ReactionPlace, ReactionRecord, SimultaneousLawRecord, SimultaneousRecord,
    TouchingRecord,
};

/// Impulse in a bearing, relative to the largest, below which the picture has no arrow.
const DRAWN_IMPULSE: f64 = 1e-3;

/// Explanation of the picture of the impulses.
const LEGEND: &str = "Impulses of the impact. The blue arrow p is the impulse on the contact link, the green arrows are the impulses that \
    the bearings exert on the second of their links, as in the table below. All arrows have the same scale.";

/// Caption of the drawing for a moment about an axis.
const LEGEND_OF_MOMENT: &str = "Impulses of the impact. The arrows are the impulses that the bearings exert on the second of their links, as in \
    the table below. The contact is a moment about an axis and has no arrow.";

/// Caption of the drawing of the impulses.
pub fn caption(report: &ImpactReport) -> String {
    let mut caption = if report.mass.contact.is_moment { LEGEND_OF_MOMENT } else { LEGEND }.to_owned();
    if report.reactions.iter().any(|record| !record.open_by.is_empty()) {
        caption +=
            " Redundant constraints leave components open: of these bearings the determinate part is drawn.";
    }
    if report.simultaneous.as_ref().is_some_and(|several| several.contacts.len() > 1) {
        caption += " Impulses of the first contact alone.";
    }
    caption
}

/// True if a contact has a contact point: not for the stop of a joint or a moment.
fn has_point(contact: &TouchingRecord) -> bool {
    !contact.is_joint_stop && !contact.is_moment
}

/// Drawing of the mechanism with the impulses of a law at all contacts, without stops of joints, which have no contact point.
pub fn of_law(
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
pub fn of_contact(report: &ImpactReport, mechanism: &DrawnMechanism) -> Drawing {
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
