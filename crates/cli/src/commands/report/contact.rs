//! Result of a contact: the number with its uncertainty, conditions, contributions, estimate and motion ratios.

use super::findings::add_warnings;
use super::results::first_with_result;
use super::sensitivity::effect_text;
use crate::commands::contact_list;
use crate::commands::mass::{conditions, headline, method};
use crate::files::html::Page;
use crate::terminal::explanation::{estimate_ratio, named_contact};
use crate::terminal::limits;
use crate::terminal::text::{number, short_number, triple, upper_bound, within_uncertainty};
use percuss_study::{ContactListReport, DiagnosticRecord, MassOptions, MassReport};

/// Adds the results of all contacts of a study with several, before all sections.
pub(super) fn add_contact_list(listed: &ContactListReport, page: &mut Page) {
    let count = listed.contacts.iter().filter(|contact| contact.report.is_some()).count();
    page.open_result(&format!("m̄ at {count} contacts"));
    page.table(contact_list::mass_table(listed).rows());
    if let Some(dampers) = contact_list::damper_table(listed) {
        page.table(dampers.rows());
    }
    page.close_result();
    page.paragraph("soft", &contact_list::explanation(listed).replace('\n', " "));
    for contact in &listed.contacts {
        if let Some(problem) = &contact.problem {
            page.warning(&format!("{}: {problem}", contact.name));
        }
    }
    add_warnings(&listed.diagnostics, page);
    if let Some(first) = first_with_result(listed) {
        let with_result = if listed.contacts.len() > count { " with a result" } else { "" };
        let text = format!("The details below are those of the first contact{with_result}, {first}.");
        page.paragraph("", &text);
    }
}

/// Adds the result before all sections: the number, its uncertainty, the contact, and the findings.
pub(super) fn add_result(
    report: &MassReport,
    requested: &MassOptions,
    findings: &[&DiagnosticRecord],
    page: &mut Page,
) {
    page.open_result(&format!("m̄ = {}", headline(report)));
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

/// Section with the contact and the conditions.
pub(super) fn add_conditions(report: &MassReport, page: &mut Page) {
    page.section("Contact and conditions");
    match report.point_in_sheet.as_ref().filter(|_| !report.contact.is_moment) {
        Some(contact) => page.facts(super::conditions::facts(report, contact)),
        None => page.facts(conditions(report).into_iter().chain([method(report)])),
    }
}

/// Section with the contribution of each link and rotor.
pub(super) fn add_contributions(report: &MassReport, page: &mut Page) {
    if report.effective_mass.is_none() {
        return;
    }
    page.section("Contribution of each link");
    let links = report.bodies.iter().filter_map(|b| Some((b.link.clone(), b.share?)));
    let rotors = report.rotors.iter().filter_map(|r| Some((format!("rotor of {}", r.joint), r.share?)));
    let other = report.other_mass_share.map(|share| ("the other body".to_owned(), share));
    let mut parts: Vec<(String, f64)> = links.chain(rotors).chain(other).collect();
    parts.sort_by(|a, b| b.1.total_cmp(&a.1));
    let all = parts.len();
    parts.retain(|(_, share)| share.abs() >= limits::MIN_CONTRIBUTION);
    page.table_of_shares(["link", "share of the kinetic energy"], &parts);
    if parts.len() < all {
        let least = 100.0 * limits::MIN_CONTRIBUTION;
        page.paragraph("soft", &format!("and {} of less than {least} %", all - parts.len()));
    }
}

/// Section with the classical estimate.
pub(super) fn add_estimate(report: &MassReport, page: &mut Page) {
    let Some(estimate) = &report.estimate else { return };
    page.section("The classical estimate");
    let value = |x: Option<f64>, unit: &str| x.map_or("–".to_owned(), |x| format!("{} {unit}", number(x)));
    page.facts([
        ("takes", format!("{} kg of {}", number(estimate.mass), estimate.links.join(", "))),
        ("motion ratio", estimate_ratio(estimate)),
        ("estimate", value(estimate.estimate, "kg")),
        ("off by", estimate.error_percent.map_or("–".to_owned(), |x| format!("{} %", short_number(x)))),
    ]);
}

/// Section with the motion ratios relative to the contact.
pub(super) fn add_motion_ratios(report: &MassReport, page: &mut Page) {
    if report.motion_ratios.is_empty() {
        return;
    }
    page.section("Motion ratios");
    let mut rows =
        vec![["point", "direction (world axes)", "contact per travel of the point"].map(str::to_owned)];
    rows.extend(report.motion_ratios.iter().map(|ratio| {
        let shown = ratio.contact_per_wheel.map_or_else(|| "infinite".to_owned(), number);
        [ratio.link.clone(), triple(&ratio.direction), shown]
    }));
    page.table(&rows);
    if let Some(joint) = report.motion_ratios.iter().find_map(|ratio| ratio.held.as_ref()) {
        page.paragraph("soft", &format!("The ratios of the wheel are those with the joint {joint} held."));
    }
    let of_impact: Vec<&str> = report
        .motion_ratios
        .iter()
        .filter(|ratio| !ratio.one_travel)
        .map(|ratio| ratio.link.as_str())
        .collect();
    if !of_impact.is_empty() {
        let links = of_impact.join(", ");
        page.paragraph("soft", &format!("For the motion of this impact only: {links}."));
    }
}
