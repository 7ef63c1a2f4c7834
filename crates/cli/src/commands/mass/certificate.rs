//! Proved bounds of m̄ as text.

use percuss_study::{MassReport, OmittedRowRecord};

/// Assumptions of all proofs.
pub const MEANING: &str = "Proved for rigid links and ideal joints, for the numbers of the model as read: docs/explanation/CERTIFICATES.md.";

/// Bounds with all digits.
pub fn bounds(lower: Option<f64>, upper: Option<f64>, unit: &str) -> String {
    match (lower, upper) {
        (Some(lower), Some(upper)) => format!("{lower} to {upper} {unit}"),
        (Some(lower), None) => format!("at least {lower} {unit}; no upper bound is proved"),
        (None, Some(upper)) => format!("at most {upper} {unit}; no lower bound is proved"),
        (None, None) => "no bound is proved".to_owned(),
    }
}

/// Assumption of a proof that leaves rows out.
pub fn assumption(omitted: &[OmittedRowRecord]) -> Option<(&'static str, String)> {
    let rows: Vec<String> = omitted
        .iter()
        .map(|row| format!("{} (error at most {:.1e})", row.constraint, row.residual))
        .collect();
    let text = format!(
        "the upper bound assumes the mobility of the pose: rows of {} are left out; the lower bound holds without it",
        rows.join(", ")
    );
    (!omitted.is_empty()).then_some(("assumption", text))
}

/// Facts about the proved bounds of m̄; none without a requested proof.
pub fn facts(report: &MassReport) -> Vec<(&'static str, String)> {
    let Some(certificate) = &report.certificate else { return Vec::new() };
    if let Some(reason) = &certificate.reason {
        return vec![("no certificate", reason.clone())];
    }
    let mut facts = vec![("proved", bounds(certificate.lower, certificate.upper, report.unit))];
    if let Some(radius) = certificate.uniqueness {
        let [degrees, metres] =
            [(radius.to_degrees(), 10.0), (radius, 1e3)].map(|(x, steps)| (x * steps).floor() / steps);
        facts.push((
            "  assembly",
            format!("no other one within ±{degrees}° (sliders: ±{metres} m) of each dependent joint"),
        ));
    }
    if certificate.implied > 0 {
        facts.push((
            "  rows",
            format!("{} of {} rows of the loops are implied: proved", certificate.implied, certificate.rows),
        ));
    }
    facts.extend(assumption(&certificate.omitted));
    facts.push(("  meaning", MEANING.to_owned()));
    facts
}
