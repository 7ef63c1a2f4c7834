//! Compliance of the bushes at a contact, as facts.

use crate::terminal::limits::{MUCH_COMPLIANCE, SEEN_SHARE};
use crate::terminal::number::{fixed, load, number, with_unit};
use crate::terminal::units::ContactUnits;
use percuss_study::{ComplianceRecord, CompliantContactRecord, MassReport, Status};

/// Facts about the compliance of the bushes; empty for a model without bushes.
pub fn facts(report: &MassReport) -> Vec<(String, String)> {
    let Some(compliance) = &report.compliance else { return Vec::new() };
    let rigid =
        report.effective_mass.map_or_else(|| report.status.name().to_owned(), |m| with_unit(m, report.unit));
    facts_of(compliance, &rigid, report.unit, &ContactUnits::new(report.contact.is_moment))
}

/// Facts about a compliance. `rigid`: the effective mass with rigid bushes; `unit`: of masses.
pub fn facts_of(
    compliance: &ComplianceRecord,
    rigid: &str,
    unit: &str,
    units: &ContactUnits,
) -> Vec<(String, String)> {
    let free = match (compliance.free_status, compliance.free_mass) {
        (Status::Finite, Some(mass)) => with_unit(mass, unit),
        (status, _) => status.name().to_owned(),
    };
    let elastic = compliance.elastic;
    let mut facts = vec![(format!("{elastic} free"), format!("{free}   ({elastic} rigid: {rigid})"))];
    facts.push(("residual stiffness".to_owned(), residual(compliance, units)));
    if let Some(contact) = &compliance.contact {
        facts.push((format!("for {}", stiffness(contact.stiffness, units)), verdict(contact)));
        facts.push(("peak force".to_owned(), peak_force(contact, units)));
        facts.extend(contact.impact.map(|impact| {
            let mass = |mass: f64| with_unit(mass, unit);
            let most = impact.most_impulse_mass.map_or_else(String::new, |most| {
                format!(", proved between {free} and {}", mass(most))
            });
            let least = contact.least_duration.map_or_else(String::new, |least| {
                format!(" (at least {} ms)", number(1e3 * least))
            });
            let end = impact.duration.map_or_else(
                || "no rebound".to_owned(),
                |time| format!("contact {} ms{least}, restitution {}", number(1e3 * time), number(impact.restitution)),
            );
            let text = format!(
                "impulse as of {} (m_imp{most}), peak force as of {}; {end}; contact without damping, {elastic} alone",
                mass(impact.impulse_mass),
                mass(impact.force_mass)
            );
            ("impact".to_owned(), text)
        }));
    } else if let Some([one, five]) = compliance.rigid_up_to {
        let [one, five] = [one, five].map(|k| stiffness(k, units));
        facts.push((
            "rigid mass holds".to_owned(),
            format!("within 1 % up to contacts of {one}, 5 % up to {five}"),
        ));
    }
    if !compliance.lower_bounds_hold {
        let text = match &compliance.beside[..] {
            [] => "free rotations of bushes act along the motion too".to_owned(),
            names => format!(
                "{}, or free rotations of bushes act along the motion too; an impact in time includes the former",
                names.join(", ")
            ),
        };
        facts.push(("beside".to_owned(), text));
    }
    facts
}

/// Stiffness with its unit, from 1000 N/mm on in kN/mm.
pub fn stiffness(value: f64, units: &ContactUnits) -> String {
    match units.length {
        "m" if value >= 1e6 => format!("{} kN/mm", number(value / 1e6)),
        "m" => format!("{} N/mm", number(value / 1e3)),
        length => format!("{} {}/{length}", number(value), units.force),
    }
}

/// Residual stiffness with the rows that dominate.
fn residual(compliance: &ComplianceRecord, units: &ContactUnits) -> String {
    let Some(value) = compliance.residual_stiffness else {
        return match compliance.residual_compliance {
            Some(_) => format!("infinite: the {} do not give way at this contact", compliance.elastic),
            None => "none: the contact is massless or immovable".to_owned(),
        };
    };
    let shown = compliance.rows.iter().take(3).filter(|row| row.share >= SEEN_SHARE);
    let rows: Vec<String> = shown
        .map(|row| format!("{} {} {} %", row.bush, row.direction, fixed(100.0 * row.share, 0)))
        .collect();
    let (value, elastic) = (stiffness(value, units), compliance.elastic);
    format!("{value} of the {elastic} at the contact   ({})", rows.join(", "))
}

/// Range in which the rigid mass holds, with the contact.
fn verdict(contact: &CompliantContactRecord) -> String {
    let times = match (contact.duration, contact.frequency) {
        (Some(duration), Some(frequency)) => {
            format!("; contact {} ms, {} Hz", number(1e3 * duration), number(frequency))
        }
        _ => String::new(),
    };
    match contact.impulse_change {
        Some(change) if change <= MUCH_COMPLIANCE => {
            let percent = number(100.0 * change);
            format!(
                "the rigid mass is right within {percent} % for peak force and impulse (rule of thumb){times}"
            )
        }
        Some(_) => format!(
            "the rigid mass does not hold: the residual stiffness is not far above that of the contact{times}"
        ),
        None => format!("not judged by the residual stiffness{times}"),
    }
}

/// Proved bounds of the peak force.
fn peak_force(contact: &CompliantContactRecord, units: &ContactUnits) -> String {
    let (bounds, unit) = match contact.peak_force {
        Some(bounds) => (bounds, units.force.to_owned()),
        None => (contact.peak_force_per_speed, format!("{} per {}", units.force, units.speed)),
    };
    match bounds {
        [Some(least), Some(most)] => {
            format!("{} to {} (proved without contact damping)", load(least, &unit), load(most, &unit))
        }
        [None, Some(most)] => format!("at most {} (proved without contact damping)", load(most, &unit)),
        [Some(least), None] => format!("at least {} (proved without contact damping)", load(least, &unit)),
        [None, None] => "no bounds".to_owned(),
    }
}
