//! Figure of kinematics over a travel: one panel per quantity; all motion ratios share a panel, and all forces.

use crate::terminal::failure::Failure;
use crate::terminal::limits;
use percuss_render::{Figure, Panel, Series, Style};
use percuss_study::{KinematicColumn, KinematicLoads, KinematicsReport};
use percuss_suspension::LengthUnit;
use std::path::Path;

/// Quantities of the figure if none are selected.
const USUAL: [&str; 8] = [
    "camber",
    "toe",
    "half_track_change",
    "motion_ratio_",
    "wheel_rate",
    "roll_centre_height",
    "toe_per_lateral_force",
    "toe_per_braking_force",
];
/// Quantities of springs, dampers and stops, which share a panel.
const SHARED: [&str; 2] = ["motion_ratio_", "force_"];
/// Largest number of panels of one figure: its height is then about one page.
const MOST_PANELS: usize = 8;

/// Title of the panel of a column, and the name of its curve.
fn panel_and_curve(column: &KinematicColumn, length_unit: LengthUnit) -> (String, String) {
    let unit = column.unit.of_table(length_unit).0;
    let side = if column.side.is_empty() { String::new() } else { format!(" {}", column.side) };
    let shared = SHARED.iter().find_map(|start| Some((*start, column.quantity.strip_prefix(start)?)));
    let (name, curve) = match shared {
        Some((start, contact)) => {
            (start.trim_end_matches('_').replace('_', " "), contact.replace('_', " ") + &side)
        }
        None => (column.quantity.replace('_', " "), format!("{}{side}", column.quantity.replace('_', " "))),
    };
    let label = match (name.as_str(), unit) {
        ("motion ratio", "") => "motion ratio, contact/wheel".to_owned(),
        (_, "") => name,
        (_, unit) => format!("{name} ({unit})"),
    };
    (label, curve)
}

/// True if two curves of one style coincide to [`limits::SAME_CURVE`] of their largest value, such as the curves of a damper and of the
/// stop on its rod.
fn has_same_points(one: &Series, other: &Series) -> bool {
    let largest = one.points.iter().filter_map(|(_, y)| *y).fold(0.0, |most: f64, y| most.max(y.abs()));
    let is_near = |a: Option<f64>, b: Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= limits::SAME_CURVE * largest,
        (a, b) => a == b,
    };
    one.style == other.style
        && one.points.len() == other.points.len()
        && one.points.iter().zip(&other.points).all(|(a, b)| a.0 == b.0 && is_near(a.1, b.1))
}

/// Figure of a report over a range; `selected`: true if the user selected the columns.
pub fn kinematics_figure(report: &KinematicsReport, selected: bool) -> Result<Figure, Failure> {
    let Some(variable) = report.variable else {
        return Err(Failure::bad_input(
            "--output: a picture shows a range; give --wheel-travel, --heave, --roll or --steer FROM:TO:COUNT",
        ));
    };
    let is_usual = |column: &KinematicColumn| {
        USUAL.iter().any(|usual| {
            column.quantity == *usual || usual.ends_with('_') && column.quantity.starts_with(usual)
        })
    };
    let mut panels: Vec<Panel> = Vec::new();
    for (i, column) in report.columns.iter().enumerate() {
        if column.missing.is_some() || !(selected || is_usual(column)) {
            continue;
        }
        let (y_label, name) = panel_and_curve(column, report.length_unit);
        let factor = column.unit.of_table(report.length_unit).1;
        let point = |row: &percuss_study::KinematicsRow| {
            let x = report.length_unit.of_metres(row.variable.unwrap_or_default());
            (x, row.values.get(i).copied().flatten().map(|y| factor * y))
        };
        let style = if column.side == "right" { Style::Dashed } else { Style::Line };
        let series = Series { name, style, points: report.rows.iter().map(point).collect() };
        match panels.iter_mut().find(|panel| panel.y_label == y_label) {
            Some(panel) => match panel.series.iter_mut().find(|other| has_same_points(other, &series)) {
                // A curve that covers another one carries both names.
                Some(other) => other.name += &format!(", {}", series.name),
                None => panel.series.push(series),
            },
            None => panels.push(Panel { y_label, series: vec![series], ..Panel::default() }),
        }
    }
    if panels.is_empty() || panels.len() > MOST_PANELS {
        return Err(Failure::bad_input(format!(
            "--output: {} quantities with values; a picture has 1 to {MOST_PANELS}: select them by --columns",
            panels.len()
        )));
    }
    let has_loads = report.columns.iter().any(|column| column.quantity.contains("_per_"));
    let loads = report.loads.as_ref().filter(|_| has_loads).map(KinematicLoads::wheels_text);
    let file = report.inputs.first().and_then(|input| Path::new(&input.path).file_name());
    Ok(Figure {
        title: "Kinematics".to_owned(),
        subtitle: [file.map(|name| name.to_string_lossy().into_owned()), loads]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join(" · "),
        x_label: format!("{variable} ({})", report.length_unit.name()),
        panels,
        ..Figure::default()
    })
}
