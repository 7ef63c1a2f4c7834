//! Answers as rows of a table (RFC 4180). A header always; an empty cell is a null.

use crate::limits;
use percuss_study::{MassReport, SweepHeading, SweepRow};

/// Columns between the drivers and the joints.
const FIXED: [&str; 7] = [
    "status",
    "effective_mass",
    "closure_residual",
    "singular_pose",
    "motion_ratio",
    "estimate",
    "estimate_error_percent",
];

/// One answer, as the row of a sweep over the joints that were set.
pub fn of_mass(report: &MassReport, drivers: &[String]) -> String {
    let estimate = report.estimate.as_ref();
    let mut header = vec!["row".to_owned()];
    let mut row = vec!["0".to_owned()];
    let mut position = |header: &mut Vec<String>, joint: &str, values: &[f64]| {
        columns(header, joint, values.len());
        row.extend(values.iter().map(|value| number(*value)));
    };
    for joint in drivers {
        position(&mut header, joint, report.pose.get(joint).unwrap_or_default());
    }
    let fixed_at = header.len();
    let others = report.pose.iter().filter(|(joint, _)| !drivers.iter().any(|driver| driver == joint));
    others.for_each(|(joint, values)| position(&mut header, joint, values));
    let fixed = [
        report.status.name().into(),
        cell(report.effective_mass),
        cell(report.closure_residual),
        report.singular_pose.to_string(),
        cell(estimate.and_then(|e| e.motion_ratio)),
        cell(estimate.and_then(|e| e.estimate)),
        cell(estimate.and_then(|e| e.error_percent)),
    ];
    header.splice(fixed_at..fixed_at, FIXED.map(str::to_owned));
    row.splice(fixed_at..fixed_at, fixed);
    line(&header) + &line(&row)
}

/// The header of a sweep.
pub fn sweep_header(heading: &SweepHeading) -> String {
    let mut header = vec!["row".to_owned(), heading.varied.clone()];
    header.extend(FIXED.map(str::to_owned));
    let others = heading.joints.joints().filter(|(joint, _)| *joint != heading.varied);
    others.for_each(|(joint, numbers)| columns(&mut header, joint, numbers));
    line(&header)
}

/// A row of a sweep. One that was not reached has no pose; its joints' cells stay empty.
pub fn sweep_row(heading: &SweepHeading, row: &SweepRow) -> String {
    let mut cells = vec![
        row.row.to_string(),
        cell(Some(row.value)),
        row.status.into(),
        cell(row.effective_mass),
        cell(row.closure_residual),
        row.singular_pose.map_or_else(String::new, |s| s.to_string()),
        cell(row.motion_ratio),
        cell(row.estimate),
        cell(row.estimate_error_percent),
    ];
    if row.pose.is_empty() {
        let others = heading.joints.joints().filter(|(joint, _)| *joint != heading.varied);
        cells.extend(std::iter::repeat_n(String::new(), others.map(|(_, numbers)| numbers).sum()));
    } else {
        let others = row.pose.iter().filter(|(joint, _)| *joint != heading.varied);
        cells.extend(others.flat_map(|(_, values)| values).map(|value| number(*value)));
    }
    line(&cells)
}

/// A joint with several numbers takes a column for each: `name[0]`, `name[1]`, …
fn columns(header: &mut Vec<String>, joint: &str, numbers: usize) {
    match numbers {
        1 => header.push(joint.to_owned()),
        _ => header.extend((0..numbers).map(|i| format!("{joint}[{i}]"))),
    }
}

fn cell(value: Option<f64>) -> String {
    value.map_or_else(String::new, number)
}

/// The shortest digits that read back as the same number; with an exponent where zeros would fill the cell.
fn number(x: f64) -> String {
    if x == 0.0 || limits::DECIMAL_NUMBERS.contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

fn line(cells: &[String]) -> String {
    cells.iter().map(|c| quoted(c)).collect::<Vec<_>>().join(",") + "\n"
}

/// Quotes where a comma, a quote or a line break asks for them.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.into()
    }
}
