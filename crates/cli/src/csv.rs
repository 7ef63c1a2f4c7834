//! Answers as rows of a table (RFC 4180). A header always; an empty cell is a null.

use crate::limits;
use percuss_study::{MassReport, SweepHeading, SweepRow};
use std::fmt::Write;
use std::ops::Range;

/// Columns between the drivers and the joints.
pub const FIXED: [&str; 7] = [
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

/// The table of a sweep: its columns, and where their numbers stand in a row.
pub struct SweepTable {
    names: Vec<String>,
    header: String,
    /// The numbers of a pose that are not varied, runs of them.
    others: Vec<Range<usize>>,
    /// How many these are.
    count: usize,
}

impl SweepTable {
    pub fn new(heading: &SweepHeading) -> Self {
        let mut header = vec!["row".to_owned()];
        header.extend(heading.varied.iter().map(|column| column.name.clone()));
        header.extend(FIXED.map(str::to_owned));
        let mut others: Vec<Range<usize>> = Vec::new();
        let mut first = 0;
        for (joint, numbers) in heading.joints.joints() {
            if !heading.varied.iter().any(|column| column.joint.as_deref() == Some(joint)) {
                columns(&mut header, joint, numbers);
                match others.last_mut().filter(|run| run.end == first) {
                    Some(run) => run.end += numbers,
                    None => others.push(first..first + numbers),
                }
            }
            first += numbers;
        }
        let count = others.iter().map(Range::len).sum();
        Self { header: line(&header), names: header, others, count }
    }

    /// The names of its columns: the row, what is varied, `status`, six more of the answer, and the other joints.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The numbers of the joints that are not varied; none where the pose was not reached.
    pub fn others<'r>(&'r self, row: &'r SweepRow) -> impl Iterator<Item = Option<f64>> + 'r {
        let numbers = row.pose.numbers();
        self.others.iter().flat_map(|run| run.clone()).map(|number| numbers.get(number).copied())
    }

    /// Its first line.
    pub fn header(&self) -> &str {
        &self.header
    }

    /// A row as a line. One that was not reached has no pose; its joints' cells stay empty.
    pub fn row(&self, row: &SweepRow) -> String {
        let mut text = String::with_capacity(24 * (self.count + row.varied.values().len() + FIXED.len()));
        // Writing to a text does not fail.
        let _ = write!(text, "{}", row.row);
        row.varied.values().iter().for_each(|value| push_number(&mut text, Some(*value)));
        text.push(',');
        text += row.status;
        push_number(&mut text, row.effective_mass);
        push_number(&mut text, row.closure_residual);
        text += row.singular_pose.map_or(",", |singular| if singular { ",true" } else { ",false" });
        push_number(&mut text, row.motion_ratio);
        push_number(&mut text, row.estimate);
        push_number(&mut text, row.estimate_error_percent);
        let numbers = row.pose.numbers();
        for run in &self.others {
            match numbers.get(run.clone()) {
                Some(numbers) => numbers.iter().for_each(|value| push_number(&mut text, Some(*value))),
                None => text.extend(std::iter::repeat_n(',', run.len())),
            }
        }
        text.push('\n');
        text
    }
}

/// A comma, and the number where there is one.
fn push_number(text: &mut String, value: Option<f64>) {
    text.push(',');
    if let Some(value) = value {
        write_number(text, value);
    }
}

/// A joint with several numbers takes a column for each: `name[0]`, `name[1]`, …
fn columns(header: &mut Vec<String>, joint: &str, numbers: usize) {
    match numbers {
        1 => header.push(joint.to_owned()),
        _ => header.extend((0..numbers).map(|i| format!("{joint}[{i}]"))),
    }
}

pub fn cell(value: Option<f64>) -> String {
    value.map_or_else(String::new, number)
}

pub fn number(x: f64) -> String {
    let mut text = String::new();
    write_number(&mut text, x);
    text
}

/// The shortest digits that read back as the same number; with an exponent where zeros would fill the cell.
fn write_number(text: &mut String, x: f64) {
    // Writing to a text does not fail.
    let _ = if x == 0.0 || limits::DECIMAL_NUMBERS.contains(&x.abs()) {
        write!(text, "{x}")
    } else {
        write!(text, "{x:e}")
    };
}

pub fn line(cells: &[String]) -> String {
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
