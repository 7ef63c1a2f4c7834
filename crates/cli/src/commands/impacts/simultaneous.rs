//! Impact of several contacts at once, as text.

use crate::terminal::escape::line;
use crate::terminal::text::{Table, number, short_number, triple};
use crate::terminal::wrap::wrap_lines;
use percuss_study::{ImpactReport, SimultaneousRecord, StickingRecord};

/// Section of a report about several contacts: contacts, laws and plastic impact.
pub fn text(report: &ImpactReport, several: &SimultaneousRecord) -> String {
    let mut out = format!("Contacts\n{}", contact_table(several));
    out += &wrap_lines(&contact_note(report, several));
    if !several.laws.is_empty() {
        out += &format!("\n{}", law_table(several));
        out += &wrap_lines(&law_note(several));
    }
    if let Some(sticking) = &several.sticking {
        out += &format!("\nPlastic impact with sticking points\n{}", sticking_table(several, sticking));
        out += &wrap_lines(&sticking_note(sticking));
    }
    out
}

/// The contacts with their masses.
pub fn contact_table(several: &SimultaneousRecord) -> Table<4> {
    let mut table = Table::new([
        "contact",
        "closing m/s",
        "effective mass kg",
        "principal masses kg and directions (world)",
    ]);
    for (number_of, contact) in several.contacts.iter().enumerate() {
        let principal: Vec<String> = contact
            .principal_masses
            .iter()
            .zip(&contact.principal_directions_world)
            .filter_map(|(mass, direction)| {
                Some(format!("{} along {}", short_number((*mass)?), short(direction)))
            })
            .collect();
        table.row([
            format!("{} {}", number_of + 1, contact.name),
            short_number(contact.closing_speed),
            contact.effective_mass.map_or_else(|| "immovable".to_owned(), number),
            principal.join("; "),
        ]);
    }
    table
}

/// Direction with three digits.
fn short(direction: &[f64; 3]) -> String {
    triple(&direction.map(|x| (x * 1e3).round() / 1e3 + 0.0))
}

/// Assumptions about the contacts.
fn contact_note(report: &ImpactReport, several: &SimultaneousRecord) -> String {
    let mut note = "All contacts are taken as closed at this pose.".to_owned();
    for contact in &several.contacts {
        if let Some(gap) = contact.gap.filter(|gap| gap.abs() > 1e-6) {
            note += &format!(" The gap of {} is {} m here.", line(&contact.name), short_number(gap));
        }
    }
    if report.motion_before != "given" {
        note += " The motion before is the assumed one (v* times the speed); give --rates for another.";
    }
    note.push('\n');
    note
}

/// Table of the laws of simultaneous impacts: impulses, opening speeds and energy loss, or the reason for a missing result.
pub fn law_table(several: &SimultaneousRecord) -> Table<4> {
    let mut table = Table::new(["law", "impulses N·s", "opening speeds m/s", "energy loss J"]);
    for law in &several.laws {
        let list = |values: Vec<String>| values.join(", ");
        let created = if law.creates_energy { " (creates energy: not valid)" } else { "" };
        let Some(loss) = law.energy_loss else {
            let why = law.refusal.clone().unwrap_or_default();
            table.row([law.law.to_owned(), "-".to_owned(), "-".to_owned(), why]);
            continue;
        };
        table.row([
            law.law.to_owned(),
            list(law.impulses.iter().map(|p| p.map_or_else(|| "?".to_owned(), short_number)).collect()),
            list(law.opening_speeds.iter().map(|u| short_number(*u)).collect()),
            format!("{}{created}", short_number(loss)),
        ]);
    }
    table
}

/// Explanation of the laws.
pub fn law_note(several: &SimultaneousRecord) -> String {
    let ratios: Vec<String> = several.stiffness_ratios.iter().map(|r| short_number(*r)).collect();
    format!(
        "Without friction. Masses and restitution do not determine several simultaneous impacts: the opening speeds of the laws \
         differ by up to {} of the closing speed. The energetic law has contact stiffnesses in the ratio {} and the exponent {} \
         (--stiffness-ratio, --contact-exponent).{}\n",
        short_number(several.spread.unwrap_or_default()),
        ratios.join(":"),
        short_number(several.contact_exponent),
        if several
            .laws
            .iter()
            .any(|law| law.impulses.iter().any(Option::is_none) && law.energy_loss.is_some())
        {
            " ?: redundant contacts leave the impulse open."
        } else {
            ""
        },
    )
}

/// Contacts of a plastic impact.
pub fn sticking_table(several: &SimultaneousRecord, sticking: &StickingRecord) -> Table<5> {
    let mut table = Table::new([
        "contact",
        "after",
        "impulse N·s",
        "tangential N·s",
        "friction needed, or opening speed",
    ]);
    let known = |value: Option<f64>| value.map_or_else(|| "?".to_owned(), short_number);
    for (i, contact) in several.contacts.iter().enumerate() {
        let (after, last) = if sticking.sticks[i] {
            ("sticks", known(sticking.required_friction[i]))
        } else {
            ("lets go", format!("{} m/s", short_number(sticking.opening_speeds[i])))
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

/// Conditions of a plastic impact.
pub fn sticking_note(sticking: &StickingRecord) -> String {
    let mut note = format!(
        "Energy loss {} J. No contact pulls, and none closes its gap. ",
        short_number(sticking.energy_loss)
    );
    note += match sticking.friction_suffices {
        Some(true) => "The given friction suffices. ",
        Some(false) => {
            "Warning: the given friction does not suffice; the points slide, and this result is not valid. "
        }
        None if sticking.sticks.iter().zip(&sticking.required_friction).any(|(s, mu)| *s && mu.is_none()) => {
            "Redundant contacts leave the needed friction open (?): it is assumed to suffice. "
        }
        None => "Friction is assumed to suffice (compare the needed coefficient, or give --friction). ",
    };
    if sticking.consistent_subsets > 1 {
        note += &format!(
            "{} combinations of sticking contacts satisfy the conditions; that with the most contacts is shown. ",
            sticking.consistent_subsets
        );
    }
    note += "The impact map is in --format json.\n";
    note
}
