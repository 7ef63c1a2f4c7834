//! Impact of several contacts at once.

use crate::document::Document;
use crate::pictures::impulses;
use crate::terminal::number::{number, rounded, triple};
use crate::terminal::text::Table;
use crate::terminal::units::ContactUnits;
use percuss_render::Picture;
use percuss_study::{
    DrawnMechanism, ImpactReport, SimultaneousLawRecord, SimultaneousRecord, StickingRecord, TouchingRecord,
};

/// Opening speed, m/s, up to which a contact counts as resting: rounding of speeds of about 1 m/s.
const OPENING_SPEED: f64 = 1e-12;

/// Adds several contacts of an impact: contacts, laws and plastic impact.
pub fn add<'a>(
    report: &'a ImpactReport,
    several: &'a SimultaneousRecord,
    mechanism: Option<&'a DrawnMechanism>,
    out: &mut Document<'a>,
) {
    out.heading("Contacts");
    out.table(contact_table(several));
    out.note(contact_note(report, several));
    // Last law of the table without a refusal and without indeterminate impulses.
    let is_complete =
        |law: &&SimultaneousLawRecord| law.refusal.is_none() && law.impulses.iter().all(Option::is_some);
    if let Some((law, mechanism)) = several.laws.iter().rev().find(is_complete).zip(mechanism) {
        let caption = format!(
            "Impulses on the links at all contacts by the law {}; the table shows the other laws.",
            law.law
        );
        out.large_picture(
            || impulses::of_law(several, law, mechanism).to_svg(),
            "Impulses at all contacts",
            caption,
        );
    }
    if !several.laws.is_empty() {
        out.table(law_table(several));
        out.note(law_note(several));
    }
    if let Some(sticking) = &several.sticking {
        out.heading("Plastic impact with sticking points");
        out.table(sticking_table(several, sticking));
        out.note(sticking_note(sticking, report.friction.as_ref().map(|friction| friction.coefficient)));
    }
}

/// The contacts with their masses.
fn contact_table(several: &SimultaneousRecord) -> Table {
    let has_moment = has_moment(several);
    let mut table = Table::new([
        "contact",
        if has_moment { "closing" } else { "closing m/s" },
        if has_moment { "effective mass" } else { "effective mass kg" },
        "principal masses kg and directions (world)",
    ]);
    for (number_of, contact) in several.contacts.iter().enumerate() {
        let principal: Vec<String> = contact
            .principal_masses
            .iter()
            .zip(&contact.principal_directions_world)
            .filter_map(|(mass, direction)| Some(format!("{} along {}", number((*mass)?), short(direction))))
            .collect();
        // If one of the contacts is a moment, each value is followed by its unit.
        let ContactUnits { mass, speed, .. } = ContactUnits::new(contact.is_moment);
        let with = |unit: &str| if has_moment { format!(" {unit}") } else { String::new() };
        table.row([
            format!("{} {}", number_of + 1, contact.name),
            format!(
                "{}{}{}",
                number(contact.closing_speed),
                with(speed),
                if opens(contact) { " (opens)" } else { "" }
            ),
            contact
                .effective_mass
                .map_or_else(|| "immovable".to_owned(), |m| format!("{}{}", number(m), with(mass))),
            if contact.is_moment { String::new() } else { principal.join("; ") },
        ]);
    }
    table
}

/// True if one of the contacts is a moment about an axis.
fn has_moment(several: &SimultaneousRecord) -> bool {
    several.contacts.iter().any(|contact| contact.is_moment)
}

/// True if a contact separates before the impact.
fn opens(contact: &TouchingRecord) -> bool {
    contact.closing_speed < -OPENING_SPEED
}

/// Direction with three digits.
fn short(direction: &[f64; 3]) -> String {
    triple(&direction.map(|x| (x * 1e3).round() / 1e3 + 0.0))
}

/// Assumptions about the contacts.
fn contact_note(report: &ImpactReport, several: &SimultaneousRecord) -> String {
    let mut note = "All contacts are taken as closed at this pose.".to_owned();
    // The warning `stop-not-reached` states the distance of a joint from its stop.
    for contact in several.contacts.iter().filter(|contact| !contact.is_joint_stop) {
        if let Some(gap) = contact.gap.filter(|gap| gap.abs() > 1e-6) {
            note += &format!(" The gap of {} is {} m here.", contact.name, number(gap));
        }
    }
    let opening: Vec<&str> = several
        .contacts
        .iter()
        .filter(|contact| opens(contact))
        .map(|contact| contact.name.as_str())
        .collect();
    if !opening.is_empty() {
        note += &format!(
            " The motion before opens {}: only an impulse of another contact can close this gap.",
            opening.join(", ")
        );
    }
    if report.motion_before != "given" {
        note += " The motion before is the assumed one (v* times the speed); give another motion by --rates.";
    }
    note
}

/// Table of the laws of simultaneous impacts: impulses, opening speeds and energy loss, or the reason for a missing result.
fn law_table(several: &SimultaneousRecord) -> Table {
    let header = match has_moment(several) {
        true => ["law", "impulses N·s or N·m·s", "opening speeds m/s or rad/s", "energy lost J"],
        false => ["law", "impulses N·s", "opening speeds m/s", "energy lost J"],
    };
    let mut table = Table::new(header);
    let speed = several.contacts.iter().fold(0.0, |most: f64, contact| most.max(contact.closing_speed.abs()));
    for law in &several.laws {
        let list = |values: Vec<String>| values.join(", ");
        let created = if law.creates_energy { " (creates energy: not valid)" } else { "" };
        // Scale of the energies, for rounding the loss.
        let energy = speed * law.impulses.iter().flatten().fold(0.0, |sum: f64, p| sum + p.abs());
        let Some(loss) = law.energy_loss else {
            let why = law.refusal.clone().unwrap_or_default();
            table.row([law.law.to_owned(), "-".to_owned(), "-".to_owned(), why]);
            continue;
        };
        table.row([
            law.law.to_owned(),
            list(law.impulses.iter().map(|p| p.map_or_else(|| "?".to_owned(), number)).collect()),
            list(law.opening_speeds.iter().map(|u| number(rounded(*u, speed))).collect()),
            format!("{}{created}", number(rounded(loss, energy))),
        ]);
    }
    table
}

/// Explanation of the laws.
fn law_note(several: &SimultaneousRecord) -> String {
    let ratios: Vec<String> = several.stiffness_ratios.iter().map(|r| number(*r)).collect();
    format!(
        "Without friction. Masses and restitution do not determine several simultaneous impacts: the opening speeds of the laws \
         differ by up to {} of the closing speed. The energetic law has contact stiffnesses in the ratio {} and the exponent {} \
         (--stiffness-ratio, --contact-exponent).{}",
        number(rounded(several.spread.unwrap_or_default(), 1.0)),
        ratios.join(":"),
        number(several.contact_exponent),
        open_note(several),
    )
}

/// Explanation of open impulses.
fn open_note(several: &SimultaneousRecord) -> &'static str {
    let is_open =
        |i: usize| several.laws.iter().any(|law| law.impulses[i].is_none() && law.energy_loss.is_some());
    let open = several.contacts.iter().enumerate().filter(|(i, _)| is_open(*i));
    let immovable: Vec<bool> = open.map(|(_, contact)| contact.effective_mass.is_none()).collect();
    match (immovable.contains(&true), immovable.contains(&false)) {
        (true, true) => {
            " ?: an immovable contact takes part in no law, and redundant contacts leave the impulse open."
        }
        (true, false) => " ?: an immovable contact takes part in no law, and its impulse is not determined.",
        (false, true) => " ?: redundant contacts leave the impulse open.",
        (false, false) => "",
    }
}

/// Contacts of a plastic impact.
fn sticking_table(several: &SimultaneousRecord, sticking: &StickingRecord) -> Table {
    let mut table = Table::new([
        "contact",
        "after",
        "impulse N·s",
        "tangential N·s",
        "friction needed, or opening speed",
    ]);
    let impulses = sticking.normal_impulses.iter().chain(&sticking.tangential_impulses);
    let largest = impulses.flatten().fold(0.0, |most: f64, p| most.max(p.abs()));
    let known = |value: Option<f64>| value.map_or_else(|| "?".to_owned(), |p| number(rounded(p, largest)));
    for (i, contact) in several.contacts.iter().enumerate() {
        let (after, last) = if sticking.sticks[i] {
            ("sticks", friction_needed(sticking, i))
        } else {
            ("lets go", format!("{} m/s", number(sticking.opening_speeds[i])))
        };
        table.row([
            format!("{} {}", i + 1, contact.name),
            after.to_owned(),
            known(sticking.normal_impulses[i]),
            known(sticking.tangential_impulses[i]),
            last,
        ]);
    }
    table
}

/// Coefficient of friction that a sticking contact needs. For open impulses, the least coefficient of all contacts is an upper bound: it
/// suffices for every contact at the best distribution of the open impulses.
fn friction_needed(sticking: &StickingRecord, contact: usize) -> String {
    match (sticking.required_friction[contact], sticking.least_friction) {
        (Some(required), _) => number(rounded(required, 1.0)),
        (None, Some(least)) => format!("at most {}", number(least)),
        (None, None) => "none suffices".to_owned(),
    }
}

/// Conditions of a plastic impact.
fn sticking_note(sticking: &StickingRecord, friction: Option<f64>) -> String {
    let mut note = format!(
        "Energy lost {} J. No contact pulls, and none closes its gap. ",
        number(sticking.energy_loss)
    );
    let redundant = sticking.sticks.iter().zip(&sticking.required_friction).any(|(s, mu)| *s && mu.is_none());
    let over = if redundant { ", for the best distribution of the open impulses (?)" } else { "" };
    note += &match (sticking.least_friction, sticking.friction_suffices, friction) {
        (None, _, _) => "Warning: this result is not possible: a contact has a tangential impulse without a normal one, so that no \
                         friction suffices. "
            .to_owned(),
        (Some(least), Some(false), Some(given)) => format!(
            "Warning: this result is not possible: sticking needs a coefficient of friction of at least {}{over}, and {} is given ({} \
             less); the points slide. ",
            number(least),
            number(given),
            number(least - given),
        ),
        (Some(least), Some(true), _) => {
            format!("The given friction suffices: sticking needs at least {}{over}. ", number(least))
        }
        (Some(least), _, _) => format!(
            "Sticking needs a coefficient of friction of at least {}{over}; give --friction to check it. ",
            number(least)
        ),
    };
    if sticking.consistent_subsets > 1 {
        note += &format!(
            "{} combinations of sticking contacts satisfy the conditions; that with the most contacts is shown. ",
            sticking.consistent_subsets
        );
    }
    note += "The impact map is in --format json.";
    note
}
