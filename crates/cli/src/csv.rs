//! Answers as rows of a table (RFC 4180). A header always; an empty cell is a null.

use crate::limits;
use percuss_study::{MassReport, SweepReport};
use std::collections::BTreeMap;

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
    let mut table = Table::default();
    table.header.push("row".into());
    table.row.push("0".into());
    for joint in drivers {
        table.position(joint, &report.pose[joint]);
    }
    table.fixed([
        report.status.name().into(),
        cell(report.effective_mass),
        cell(report.closure_residual),
        report.singular_pose.to_string(),
        cell(estimate.and_then(|e| e.motion_ratio)),
        cell(estimate.and_then(|e| e.estimate)),
        cell(estimate.and_then(|e| e.error_percent)),
    ]);
    table.others(&report.pose, drivers);
    line(&table.header) + &line(&table.row)
}

/// A sweep: a row for each value.
pub fn of_sweep(report: &SweepReport) -> String {
    let drivers = [report.varied.clone()];
    // A row that was not reached has no pose; its joints' cells stay empty.
    let joints = report.rows.iter().map(|row| &row.pose).find(|pose| !pose.is_empty());
    let mut text = String::new();
    for row in &report.rows {
        let mut table = Table::default();
        table.header.extend(["row".into(), report.varied.clone()]);
        table.row.extend([row.row.to_string(), cell(Some(row.value))]);
        table.fixed([
            row.status.into(),
            cell(row.effective_mass),
            cell(row.closure_residual),
            row.singular_pose.map_or_else(String::new, |s| s.to_string()),
            cell(row.motion_ratio),
            cell(row.estimate),
            cell(row.estimate_error_percent),
        ]);
        match joints {
            Some(names) if row.pose.is_empty() => {
                table.others(names, &drivers);
                let known = table.header.len()
                    - names.iter().filter(|(j, _)| !drivers.contains(j)).map(|(_, v)| v.len()).sum::<usize>();
                table.row[known..].fill(String::new());
            }
            _ => table.others(&row.pose, &drivers),
        }
        if text.is_empty() {
            text += &line(&table.header);
        }
        text += &line(&table.row);
    }
    text
}

#[derive(Default)]
struct Table {
    header: Vec<String>,
    row: Vec<String>,
}

impl Table {
    fn fixed(&mut self, cells: [String; FIXED.len()]) {
        self.header.extend(FIXED.map(str::to_owned));
        self.row.extend(cells);
    }

    /// Joints that are no columns yet.
    fn others(&mut self, pose: &BTreeMap<String, Vec<f64>>, drivers: &[String]) {
        for (joint, values) in pose.iter().filter(|(joint, _)| !drivers.contains(joint)) {
            self.position(joint, values);
        }
    }

    /// A joint with several numbers takes a column for each: `name[0]`, `name[1]`, …
    fn position(&mut self, joint: &str, values: &[f64]) {
        for (i, value) in values.iter().enumerate() {
            self.header.push(if values.len() == 1 { joint.to_owned() } else { format!("{joint}[{i}]") });
            self.row.push(number(*value));
        }
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
