//! Sections of the other questions of a study: variants, damper, kinematics, map, safe speed.

use super::bands::{Tolerances, add_band};
use super::findings::add_warnings;
use crate::commands::compare;
use crate::commands::suspension::kinematics;
use crate::files::html::Page;
use crate::pictures::clipping::{clip_outliers, remove_flat_panels};
use crate::pictures::kinematics_figure::kinematics_figure;
use crate::terminal::limits;
use percuss_render::{Figure, Picture};
use percuss_study::{ComparisonReport, KinematicsReport, StudyFile, SweepQuestion};

/// Section of the variants.
pub(super) fn add_variants(
    compared: &ComparisonReport,
    tolerances: &[Tolerances],
    study: &StudyFile,
    page: &mut Page,
) {
    let title = match (compare::has_several_contacts(compared), study.variants.is_empty()) {
        (true, true) => "Contacts",
        (true, false) => "Contacts and variants",
        (false, _) => "Variants",
    };
    page.section(title);
    compare::document(compared).show(page);
    // A comparison without a figure is covered by the sweep's table.
    let figure = study.tables.sweep.as_ref().map(SweepQuestion::figure).unwrap_or_default();
    // Each of several contacts has its own figure below.
    let is_of_one = !compare::has_several_contacts(compared);
    if let Some(all) = compare::figure(compared, &figure).ok().filter(|_| is_of_one) {
        let content = "Effective mass of the designs over the varied quantity";
        add_figure(all, content, &[], page);
    }
    if compare::has_several_contacts(compared) {
        let mut drawn: Vec<Figure> = Vec::new();
        for (i, of_contact) in compare::contact_figures(compared, &figure).into_iter().enumerate() {
            match drawn.iter().find(|other| has_same_curves(other, &of_contact)) {
                Some(other) => {
                    page.paragraph(
                        "",
                        &format!("{}: the same curves as in \"{}\".", of_contact.title, other.title),
                    );
                }
                None => {
                    let content = of_contact.title.clone();
                    drawn.push(of_contact.clone());
                    add_figure(of_contact, &content, tolerances.get(i).map_or(&[], Vec::as_slice), page);
                }
            }
        }
    }
    add_warnings(&compared.diagnostics, page);
}

/// True if all curves of two figures coincide to [`limits::SAME_CURVE`], as those of both sides of a vehicle.
fn has_same_curves(one: &Figure, other: &Figure) -> bool {
    let values = |figure: &Figure| -> Vec<(f64, Option<f64>)> {
        figure
            .panels
            .iter()
            .flat_map(|panel| &panel.series)
            .flat_map(|series| series.points.clone())
            .collect()
    };
    let is_near = |a: f64, b: f64| (a - b).abs() <= limits::SAME_CURVE * a.abs().max(b.abs());
    let (one, other) = (values(one), values(other));
    one.len() == other.len()
        && one.iter().zip(&other).all(|(a, b)| {
            a.0 == b.0
                && match (a.1, b.1) {
                    (Some(a), Some(b)) => is_near(a, b),
                    (a, b) => a == b,
                }
        })
}

/// Adds a figure with clipped outliers and the band of tolerances. The caption states constants; without other curves, there is no
/// picture.
fn add_figure(mut figure: Figure, content: &str, tolerances: &[(f64, f64)], page: &mut Page) {
    let clipped = clip_outliers(&mut figure);
    let band = add_band(&mut figure, tolerances);
    let constants = remove_flat_panels(&mut figure);
    let caption = [&constants, &clipped, band].join(" ").trim().to_owned();
    if figure.panels.is_empty() {
        page.paragraph("", &format!("{}: {caption}", figure.title));
    } else {
        page.picture(&figure.to_svg(), content, &caption);
    }
}

/// Largest number of panels of a kinematics figure on the page.
const PANELS_PER_FIGURE: usize = 2;

/// Section of the kinematics over a travel: a figure, and a table of evenly distributed rows.
pub(super) fn add_kinematics(report: &KinematicsReport, study: &StudyFile, page: &mut Page) {
    page.section("Kinematics");
    let is_selected = study.tables.kinematics.as_ref().is_some_and(|requested| !requested.columns.is_empty());
    match kinematics_figure(report, is_selected) {
        Ok(figure) => {
            // Two panels fill the width of a page.
            for panels in figure.panels.chunks(PANELS_PER_FIGURE) {
                let labels: Vec<&str> = panels.iter().map(|panel| panel.y_label.as_str()).collect();
                let title = labels.join(", ");
                let part = Figure { panels: panels.to_vec(), title, ..figure.clone() };
                add_figure(part, "Kinematics over the travel", &[], page);
            }
        }
        Err(_) => page
            .paragraph("soft", "No figure: a figure has one to eight quantities with values over a range."),
    }
    for problem in report.rows.iter().filter_map(|row| row.problem.as_ref()).take(1) {
        page.warning(&format!("some rows have no result; the first: {problem}"));
    }
    if is_selected {
        let rows = kinematics::table_rows(report);
        let last = rows.len() - 1;
        let steps = last.saturating_sub(1).clamp(1, limits::SWEEP_ROWS_SHOWN - 1);
        let chosen = (0..=steps).map(|i| 1 + (i * (last - 1) + steps / 2) / steps);
        let chosen = [0].into_iter().chain(chosen);
        page.table(&chosen.filter_map(|i| rows.get(i).cloned()).collect::<Vec<_>>());
    }
    if let Some(loads) = &report.loads {
        page.paragraph("soft", &format!("Loads: {}.", loads.text()));
    }
    page.paragraph(
        "soft",
        &format!(
            "Axes of the vehicle, ISO 8855; derivatives along {}, per travel of the wheel; definitions: docs/howto/KINEMATICS.md.",
            report.derivatives
        ),
    );
}
