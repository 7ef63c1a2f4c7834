//! One answer as the row of a table: the columns of a sweep.

use percuss_study::{MassReport, Status};

/// Header and row. An empty cell is a null.
pub fn of_mass(report: &MassReport, drivers: &[String]) -> String {
    let mut header: Vec<String> = vec!["row".into()];
    let mut row: Vec<String> = vec!["0".into()];
    for joint in drivers {
        push_position(&mut header, &mut row, joint, &report.pose[joint]);
    }
    let status = match report.status {
        Status::Finite => "finite",
        Status::Immovable => "immovable",
        Status::Massless => "massless",
    };
    let cell = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v}"));
    let fixed = [
        ("status", status.to_owned()),
        ("effective_mass", cell(report.effective_mass)),
        ("closure_residual", cell(report.closure_residual)),
        ("singular_pose", report.singular_pose.to_string()),
        ("motion_ratio", String::new()),
        ("estimate", String::new()),
        ("estimate_error_percent", String::new()),
    ];
    for (name, value) in fixed {
        header.push(name.into());
        row.push(value);
    }
    for (joint, values) in report.pose.iter().filter(|(joint, _)| !drivers.contains(joint)) {
        push_position(&mut header, &mut row, joint, values);
    }
    let line = |cells: Vec<String>| cells.iter().map(|c| quoted(c)).collect::<Vec<_>>().join(",") + "\n";
    line(header) + &line(row)
}

/// A joint with several numbers takes a column for each: `name[0]`, `name[1]`, …
fn push_position(header: &mut Vec<String>, row: &mut Vec<String>, joint: &str, values: &[f64]) {
    for (i, value) in values.iter().enumerate() {
        header.push(if values.len() == 1 { joint.to_owned() } else { format!("{joint}[{i}]") });
        row.push(format!("{value}"));
    }
}

/// RFC 4180: quotes where a comma, a quote or a line break asks for them.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.into()
    }
}
