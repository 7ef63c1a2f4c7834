//! Differences between designs as text.

use crate::terminal::limits;
use crate::terminal::number::{number, triple};
use percuss_study::{ChangeKind, ComparisonReport, DesignChange, DesignRecord};

/// One sentence per design with a reference: both names and the differences. Equal changes at several contacts give one
/// sentence.
pub fn sentences(report: &ComparisonReport) -> Vec<String> {
    let mut listed: Vec<&DesignRecord> = Vec::new();
    for design in report.designs.iter().filter(|design| design.reference.is_some()) {
        let is_known =
            |other: &&DesignRecord| other.changes == design.changes && other.reference != design.reference;
        if !listed.iter().any(is_known) {
            listed.push(design);
        }
    }
    let sentence = |design: &DesignRecord| {
        let reference = &report.designs[design.reference?];
        let names = format!("{}, compared with {}", design.name, reference.name);
        if design.changes.is_empty() {
            return Some(format!(
                "{names}: no difference in links, hardpoints, masses, inertias, gaps or conditions"
            ));
        }
        let shown: Vec<String> = design.changes.iter().take(limits::CHANGES_SHOWN).map(text).collect();
        let rest = design.changes.len() - shown.len();
        let rest = if rest > 0 { format!("; and {rest} more (all: --format json)") } else { String::new() };
        Some(format!("{names}: {}{rest}", shown.join("; ")))
    };
    listed.into_iter().filter_map(sentence).collect()
}

/// A difference in words.
fn text(change: &DesignChange) -> String {
    let DesignChange { kind, name, reference, value } = change;
    let pair = reference.as_deref().zip(value.as_deref());
    let millimetres = |x: f64| (x * 1e6).round() / 1e3 + 0.0;
    let moved = || match pair {
        Some(([a, b, c], [x, y, z])) => {
            format!(" moved by {} mm", triple(&[x - a, y - b, z - c].map(millimetres)))
        }
        _ => " moved".to_owned(),
    };
    let values = |unit: &str, factor: f64| match pair {
        Some(([old], [new])) => {
            format!(" {} {unit} instead of {} {unit}", number(new * factor), number(old * factor))
        }
        _ => " changed".to_owned(),
    };
    match kind {
        ChangeKind::Point => name.clone() + &moved(),
        ChangeKind::CentreOfMass => format!("centre of mass of {name}{}", moved()),
        ChangeKind::Mass => format!("mass of {name}{}", values("kg", 1.0)),
        ChangeKind::Gap => format!("gap of {name}{}", values("mm", 1e3)),
        ChangeKind::Inertia => format!("inertia of {name} changed"),
        ChangeKind::Link if value.is_none() => format!("without {name}"),
        ChangeKind::Link => format!("with {name}"),
        ChangeKind::Contact => "another contact".to_owned(),
        ChangeKind::Pose => "another pose".to_owned(),
        ChangeKind::Conditions => "other conditions".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::text;
    use percuss_study::{ChangeKind, DesignChange};

    #[test]
    fn differences_have_names_and_units() {
        let change = |kind, reference: &[f64], value: &[f64]| {
            let [reference, value] = [reference, value].map(|x| (!x.is_empty()).then(|| x.to_vec()));
            text(&DesignChange { kind, name: "part".to_owned(), reference, value })
        };
        assert_eq!(
            change(ChangeKind::Point, &[0.0, 0.1, 0.2], &[0.0, 0.1, 0.188]),
            "part moved by (0, 0, −12) mm"
        );
        assert_eq!(change(ChangeKind::Mass, &[18.5], &[16.25]), "mass of part 16.25 kg instead of 18.5 kg");
        assert_eq!(change(ChangeKind::Gap, &[0.03], &[0.02]), "gap of part 20 mm instead of 30 mm");
        assert_eq!(change(ChangeKind::Link, &[1.0], &[]), "without part");
        assert_eq!(change(ChangeKind::Link, &[], &[1.0]), "with part");
    }
}
