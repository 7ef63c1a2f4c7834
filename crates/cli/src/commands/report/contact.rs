//! Result of a contact: the number with its uncertainty, conditions, contributions, estimate and motion ratios.

use super::findings::add_warnings;
use super::results::first_with_result;
use crate::commands::impacts::rigid_impact;
use crate::commands::mass::contact_list;
use crate::commands::mass::headline;
use crate::commands::mass::sensitivity::effect_text;
use crate::files::html::Page;
use crate::terminal::explanation::named_contact;
use crate::terminal::text::{number, upper_bound, within_uncertainty};
use crate::terminal::units::ContactUnits;
use percuss_study::{ContactListReport, DiagnosticRecord, ImpactReport, MassOptions, MassReport};

/// Adds the results of all contacts of a study with several, before all sections.
pub(super) fn add_contact_list(listed: &ContactListReport, page: &mut Page) {
    let count = listed.contacts.iter().filter(|contact| contact.report.is_some()).count();
    page.open_result(&format!("m̄ at {count} contacts"));
    contact_list::document(listed).show(page);
    page.close_result();
    add_warnings(&listed.diagnostics, page);
    if let Some(first) = first_with_result(listed) {
        let with_result = if listed.contacts.len() > count { " with a result" } else { "" };
        let text = format!("The details below are those of the first contact{with_result}, {first}.");
        page.paragraph("", &text);
    }
}

/// Adds the result before all sections: the main numbers of an impact, the mass, its uncertainty, the contact, and the findings.
pub(super) fn add_result(
    report: &MassReport,
    requested: &MassOptions,
    impact: Option<&ImpactReport>,
    findings: &[&DiagnosticRecord],
    page: &mut Page,
) {
    let mass = format!("m̄ = {}", headline(report));
    match impact.map(rigid_impact::head) {
        Some((main, facts)) => {
            page.open_result(&main);
            let name = ContactUnits::new(report.contact.is_moment).name;
            page.facts(facts.into_iter().chain([(name, headline(report))]));
        }
        None => page.open_result(&mass),
    }
    let mut facts = uncertainty(report);
    if let (Some(expected), Some(mass)) = (requested.expected(), report.effective_mass) {
        let off = 100.0 * (mass / expected - 1.0);
        facts.push(("expected", format!("{} {}, difference {off:+.2e} %", number(expected), report.unit)));
    }
    match &report.named_contact {
        Some(contact) => facts.extend(named_contact(contact)),
        None => {
            let other =
                report.contact.against.as_ref().map_or_else(String::new, |link| format!(" against {link}"));
            facts.push(("contact", report.contact.link.clone() + &other));
        }
    }
    page.facts(facts);
    page.close_result();
    add_warnings(findings.iter().copied(), page);
}

/// Uncertainty due to tolerances, and numerical error.
fn uncertainty(report: &MassReport) -> Vec<(&'static str, String)> {
    let mut facts = Vec::new();
    let Some(mass) = report.effective_mass else { return facts };
    if let Some(tolerance) = &report.tolerance {
        facts.push(("nominal value", format!("{} {}", number(mass), report.unit)));
        let percent = |m: f64| format!("{} {} ({:.2} %)", effect_text(m), report.unit, 100.0 * m / mass);
        let both = format!(
            "{} root sum square, {} with all at the limit",
            percent(tolerance.root_sum_square),
            percent(tolerance.worst_case)
        );
        facts.push(("tolerances", both));
        if let Some(samples) = &tolerance.samples {
            let rounded = |x: f64| within_uncertainty(x, samples.standard_deviation);
            let (low, high) = (rounded(samples.percentile_2_5), rounded(samples.percentile_97_5));
            facts.push((
                "95 % of samples",
                format!("{low} to {high} {} ({} samples)", report.unit, samples.count),
            ));
        }
    }
    let error = match report.effective_mass_error {
        Some(error) => format!("below {} of the value", upper_bound((error / mass).max(f64::EPSILON))),
        None => "unknown".to_owned(),
    };
    facts.push(("numerical error", error));
    facts
}
