//! Result of a contact: the number with its uncertainty, conditions, contributions, estimate and motion ratios.

use super::findings::add_warnings;
use crate::commands::mass::contact_list;
use crate::commands::mass::sensitivity::effect_text;
use crate::files::html::Page;
use crate::terminal::limits;
use crate::terminal::number::{fixed, number, upper_bound, within_uncertainty};
use percuss_study::{ContactListReport, DiagnosticRecord, MassOptions, MassReport};

/// Code of the finding about a change of m̄ during the contact.
const MASS_CHANGES: &str = "mass-drifts";

/// Adds the results of all contacts of a study with several, before all sections.
pub(super) fn add_contact_list(listed: &ContactListReport, page: &mut Page) {
    let count = listed.contacts.iter().filter(|contact| contact.report.is_some()).count();
    page.open_result(&format!("m̄ at {count} contacts"));
    contact_list::document(listed).show(page);
    page.close_result();
    add_warnings(&listed.diagnostics, page);
    if let Some(first) = listed.first_with_result().map(|first| &first.name) {
        let with_result = if listed.contacts.len() > count { " with a result" } else { "" };
        let text = format!("The details below are those of the first contact{with_result}, {first}.");
        page.paragraph("", &text);
    }
}

/// Adds the warnings about the result. A change of m̄ without an effect on the damper is a note.
pub(super) fn add_findings(report: &MassReport, findings: &[&DiagnosticRecord], page: &mut Page) {
    let stroke = report.damper.as_ref().and_then(|damper| Some((damper.over_stroke?, damper)));
    let is_small = stroke.is_some_and(|(stroke, damper)| {
        (stroke.restitution - damper.damper.restitution).abs() < limits::SMALL_RESTITUTION_CHANGE
    });
    let is_change = |finding: &&DiagnosticRecord| is_small && finding.code == MASS_CHANGES;
    add_warnings(findings.iter().copied().filter(|finding| !is_change(finding)), page);
    for finding in findings.iter().copied().filter(is_change) {
        let Some((stroke, damper)) = stroke else { continue };
        page.note(&format!(
            "{}. Effect on the rebound: e = {} instead of {}. No action needed.",
            finding.line(),
            fixed(stroke.restitution, 4),
            fixed(damper.damper.restitution, 4)
        ));
    }
}

/// Words about the uncertainty of m̄, for the first page.
pub(super) fn uncertainty_words(report: &MassReport) -> String {
    let Some(tolerance) = &report.tolerance else { return String::new() };
    let given = &tolerance.tolerance;
    let parts = [
        ("mass", 100.0 * given.mass, "%"),
        ("centre of mass", 1e3 * given.com, "mm"),
        ("armature", 100.0 * given.armature, "%"),
        ("point", 1e3 * given.point, "mm"),
    ];
    let parts = parts.iter().filter(|(_, size, _)| *size > 0.0);
    let parts: Vec<String> =
        parts.map(|(name, size, unit)| format!("{name} {} {unit}", number(*size))).collect();
    format!("tolerances: {}", parts.join(", "))
}

/// Facts about the accuracy of the result: expected value, tolerances, samples, numerical error.
pub(super) fn accuracy(report: &MassReport, requested: &MassOptions) -> Vec<(&'static str, String)> {
    let mut facts = uncertainty(report);
    if let (Some(expected), Some(mass)) = (requested.expected(), report.effective_mass) {
        let off = 100.0 * (mass / expected - 1.0);
        facts.push(("expected", format!("{} {}, difference {off:+.2e} %", number(expected), report.unit)));
    }
    facts
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
