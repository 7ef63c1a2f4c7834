//! Results as rows of a CSV table (RFC 4180), always with a header. An empty cell is a null.

use crate::files::table_style::{ColumnUnit, TableStyle, round_to_digits};
use crate::terminal::limits;
use percuss_mechanism::{JointKind, Mechanism};
use percuss_study::{MassReport, SweepHeading, SweepRow};
use std::borrow::Cow;
use std::fmt::Write;
use std::ops::Range;

/// Columns between the drivers and the joints.
pub const FIXED_COLUMNS: [&str; 7] = [
    "status",
    "effective_mass",
    "closure_residual",
    "singular_pose",
    "motion_ratio",
    "estimate",
    "estimate_error_percent",
];

/// Column of a contact with a gap, after the fixed columns.
const GAP_COLUMN: &str = "gap";

/// Prefix of the names of the gradient columns, which follow the column of the gap.
const GRADIENT_COLUMN: &str = "gradient";

/// Unit of the gradient by a joint with one velocity. `mass`: unit of m̄.
fn gradient_unit(mechanism: &Mechanism, joint: &str, mass: &str) -> Option<String> {
    match mechanism.joint(mechanism.find_joint(joint).ok()?).kind() {
        JointKind::Revolute | JointKind::Continuous => Some(format!("{mass}/rad")),
        JointKind::Prismatic => Some(format!("{mass}/m")),
        _ => None,
    }
}

/// Formats a single result as the row of a sweep over the drivers.
pub fn mass_row(report: &MassReport, drivers: &[String]) -> String {
    let estimate = report.estimate.as_ref();
    let mut header = vec!["row".to_owned()];
    let mut row = vec!["0".to_owned()];
    let mut position = |header: &mut Vec<String>, joint: &str, values: &[f64]| {
        add_joint_columns(header, joint, values.len());
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
    header.splice(fixed_at..fixed_at, FIXED_COLUMNS.map(str::to_owned));
    row.splice(fixed_at..fixed_at, fixed);
    if let Some(compliance) = &report.compliance {
        header.extend(["free_mass", "residual_stiffness"].map(str::to_owned));
        row.extend([cell(compliance.free_mass), cell(compliance.residual_stiffness)]);
    }
    line(&header) + &line(&row)
}

/// Table of a sweep: its columns, and the positions of their numbers in a row.
pub struct SweepTable {
    names: Vec<String>,
    header: String,
    /// Numbers of a pose that are not varied, as ranges of indices.
    others: Vec<Range<usize>>,
    /// Number of values in `others`.
    count: usize,
    style: TableStyle,
    /// Units of the varied numbers, and of the numbers in `other_numbers`.
    varied_units: Vec<ColumnUnit>,
    other_units: Vec<ColumnUnit>,
}

/// Cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    Number(f64),
    Text(Cow<'static, str>),
    Logical(bool),
    Empty,
}

impl Cell {
    /// Number, or an empty cell.
    pub fn from_value(value: Option<f64>) -> Self {
        value.map_or(Cell::Empty, Cell::Number)
    }
}

impl SweepTable {
    pub fn new(heading: &SweepHeading, mechanism: &Mechanism, style: TableStyle) -> Self {
        let mut header = vec!["row".to_owned()];
        let varied_units: Vec<ColumnUnit> =
            heading.varied.iter().map(|c| style.unit(c.unit.si_unit())).collect();
        header.extend(heading.varied.iter().zip(&varied_units).map(|(column, unit)| match &column.joint {
            _ if !style.names_units => column.name.clone(),
            // Notation of the column as read by `--input`.
            Some(_) => with_unit(&column.name, unit),
            None => format!("travel_{}", unit.name),
        }));
        header.extend(FIXED_COLUMNS.map(|name| match (style.names_units, name) {
            (true, "effective_mass") => format!("{name}_{}", heading.unit),
            (true, "estimate") => format!("{name}_kg"),
            (true, "closure_residual") => format!("{name}_{}", style.unit("m").name),
            _ => name.to_owned(),
        }));
        if heading.has_gap {
            let unit = style.unit("m").name;
            header.push(if style.names_units {
                format!("{GAP_COLUMN}_{unit}")
            } else {
                GAP_COLUMN.to_owned()
            });
        }
        for (joint, velocities) in heading.gradient.iter().flat_map(|layout| layout.joints()) {
            let before = header.len();
            add_joint_columns(&mut header, &format!("{GRADIENT_COLUMN}_{joint}"), velocities);
            if let (true, Some(unit)) = (style.names_units, gradient_unit(mechanism, joint, heading.unit)) {
                header[before..].iter_mut().for_each(|name| *name = format!("{name} [{unit}]"));
            }
        }
        let mut other_units = Vec::new();
        let mut others: Vec<Range<usize>> = Vec::new();
        let mut first = 0;
        for (joint, numbers) in heading.joints.joints() {
            if !heading.varied.iter().any(|column| column.joint.as_deref() == Some(joint)) {
                let kind = mechanism.find_joint(joint).ok().map(|id| mechanism.joint(id).kind());
                let unit = style.unit(match kind {
                    Some(JointKind::Revolute | JointKind::Continuous) => "rad",
                    Some(JointKind::Prismatic) => "m",
                    _ => "",
                });
                let before = header.len();
                add_joint_columns(&mut header, joint, numbers);
                if style.names_units {
                    header[before..].iter_mut().for_each(|name| *name = with_unit(name, &unit));
                }
                other_units.extend(std::iter::repeat_n(unit, numbers));
                match others.last_mut().filter(|run| run.end == first) {
                    Some(run) => run.end += numbers,
                    None => others.push(first..first + numbers),
                }
            }
            first += numbers;
        }
        let count = others.iter().map(Range::len).sum();
        let header_line = header_in_style(line(&header), &header, style);
        Self { header: header_line, names: header, others, count, style, varied_units, other_units }
    }

    /// Column names: the row, the varied numbers, `status`, six more columns of the result, the gap of a
    /// contact with a gap, the gradient if requested, and the other joints.
    #[cfg_attr(not(feature = "tables"), allow(dead_code))]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Numbers of the joints that are not varied; `None` if the pose was not reached.
    pub fn other_numbers<'r>(&'r self, row: &'r SweepRow) -> impl Iterator<Item = Option<f64>> + 'r {
        let numbers = row.pose.numbers();
        self.others.iter().flat_map(|run| run.clone()).map(|number| numbers.get(number).copied())
    }

    /// Header line, with a line end.
    pub fn header(&self) -> &str {
        &self.header
    }

    /// Formats a row as a line. A row that was not reached has no pose; the cells of its joints are empty.
    pub fn row(&self, row: &SweepRow) -> String {
        if self.style.names_units || self.style.comma {
            return self.styled_row(row);
        }
        let mut text =
            String::with_capacity(24 * (self.count + row.varied.values().len() + FIXED_COLUMNS.len()));
        // Writing to a string cannot fail.
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
        if let Some(gap) = row.gap {
            push_number(&mut text, gap);
        }
        let gradient = row.gradient.iter().flat_map(|gradient| gradient.numbers());
        gradient.for_each(|value| push_number(&mut text, value));
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

impl SweepTable {
    /// Cells of a row, in the units and with the rounding of the style.
    pub fn cells(&self, row: &SweepRow) -> Vec<Cell> {
        let style = &self.style;
        let scaled = |value: f64, unit: &ColumnUnit| style.position(value, unit);
        let mut cells = vec![Cell::Number(row.row as f64)];
        let varied = row.varied.values().iter().zip(&self.varied_units);
        cells.extend(varied.map(|(value, unit)| Cell::Number(scaled(*value, unit))));
        let few = |value: f64, count| if style.names_units { round_to_digits(value, count) } else { value };
        let length = style.unit("m");
        cells.extend([
            Cell::Text(row.status.into()),
            Cell::from_value(row.effective_mass.map(|m| style.number(m, row.effective_mass_error))),
            Cell::from_value(row.closure_residual.map(|r| few(r * length.factor, 3))),
            row.singular_pose.map_or(Cell::Empty, Cell::Logical),
            Cell::from_value(row.motion_ratio.map(|r| style.number(r, None))),
            Cell::from_value(row.estimate.map(|m| style.number(m, None))),
            Cell::from_value(row.estimate_error_percent.map(|e| few(e, 6))),
        ]);
        cells.extend(row.gap.map(|gap| Cell::from_value(gap.map(|gap| scaled(gap, &length)))));
        let gradient = row.gradient.iter().flat_map(|gradient| gradient.numbers());
        cells.extend(gradient.map(|value| Cell::from_value(value.map(|value| style.number(value, None)))));
        let others = self.other_numbers(row).zip(&self.other_units);
        cells.extend(others.map(|(value, unit)| Cell::from_value(value.map(|value| scaled(value, unit)))));
        cells
    }

    /// Row with units, rounding and decimal sign of the style.
    fn styled_row(&self, row: &SweepRow) -> String {
        let cells: Vec<String> = self.cells(row).iter().map(|cell| styled_cell(cell, self.style)).collect();
        cells.join(if self.style.comma { ";" } else { "," }) + "\n"
    }
}

/// Column name with the unit in the notation of `--input`.
pub fn with_unit(name: &str, unit: &ColumnUnit) -> String {
    if unit.name.is_empty() { name.to_owned() } else { format!("{name} [{}]", unit.name) }
}

/// Line of names, separated by semicolons if the table has decimal commas.
fn header_in_style(line: String, names: &[String], style: TableStyle) -> String {
    if !style.comma {
        return line;
    }
    names.iter().map(|name| quote(name)).collect::<Vec<_>>().join(";") + "\n"
}

/// Appends a comma, and the number if present.
fn push_number(text: &mut String, value: Option<f64>) {
    text.push(',');
    if let Some(value) = value {
        write_number(text, value);
    }
}

/// Adds the columns of a joint: `name`, or `name[0]`, `name[1]`, … for several numbers.
fn add_joint_columns(header: &mut Vec<String>, joint: &str, numbers: usize) {
    match numbers {
        1 => header.push(joint.to_owned()),
        _ => header.extend((0..numbers).map(|i| format!("{joint}[{i}]"))),
    }
}

/// Text of a number; empty if absent.
pub fn cell(value: Option<f64>) -> String {
    value.map_or_else(String::new, number)
}

/// Shortest text that reads back as the same number.
pub fn number(x: f64) -> String {
    let mut text = String::new();
    write_number(&mut text, x);
    text
}

/// Writes the shortest digits that read back as the same number; in exponent notation for very small and very large
/// numbers.
fn write_number(text: &mut String, x: f64) {
    // Writing to a string cannot fail.
    let _ = if x == 0.0 || limits::DECIMAL_NUMBERS.contains(&x.abs()) {
        write!(text, "{x}")
    } else {
        write!(text, "{x:e}")
    };
}

/// Cells joined by commas, quoted if necessary, with a line end.
pub fn line(cells: &[String]) -> String {
    cells.iter().map(|c| quote(c)).collect::<Vec<_>>().join(",") + "\n"
}

/// CSV text of a table: header and rows; numbers are rounded already.
pub fn styled_table(columns: &[String], rows: &[Vec<Cell>], style: TableStyle) -> String {
    let row = |cells: &Vec<Cell>| {
        styled_line(&cells.iter().map(|cell| styled_cell(cell, style)).collect::<Vec<_>>(), style)
    };
    styled_line(columns, style) + &rows.iter().map(row).collect::<String>()
}

/// Formats a number with the decimal sign of the style.
pub fn styled_number(x: f64, style: TableStyle) -> String {
    if style.comma { number(x).replace('.', ",") } else { number(x) }
}

/// Formats a cell; numbers are rounded already.
fn styled_cell(cell: &Cell, style: TableStyle) -> String {
    match cell {
        Cell::Number(x) => styled_number(*x, style),
        Cell::Text(text) => text.clone().into_owned(),
        Cell::Logical(value) => value.to_string(),
        Cell::Empty => String::new(),
    }
}

/// Formats a mass, rounded to its error if the style rounds; empty if absent.
pub fn styled_mass(mass: Option<f64>, error: Option<f64>, style: TableStyle) -> String {
    mass.map_or_else(String::new, |mass| styled_number(style.number(mass, error), style))
}

/// Formats an error, with three digits if the style rounds.
pub fn styled_error(error: Option<f64>, style: TableStyle) -> String {
    let rounded = |error: f64| if style.names_units { round_to_digits(error, 3) } else { error };
    error.map_or_else(String::new, |error| styled_number(rounded(error), style))
}

/// Line of cells, separated by semicolons if the table has decimal commas. [`styled_number`] formats the numbers.
pub fn styled_line(cells: &[String], style: TableStyle) -> String {
    if !style.comma {
        return line(cells);
    }
    // A decimal comma does not separate cells here.
    let is_number = |cell: &str| cell.replace(',', ".").parse::<f64>().is_ok();
    let cell = |cell: &String| if is_number(cell) { cell.clone() } else { quote(cell) };
    cells.iter().map(cell).collect::<Vec<_>>().join(";") + "\n"
}

/// Quotes a cell with a separator, a quote or a line break. A text that a spreadsheet would evaluate as a formula
/// gets an apostrophe, which marks it as text.
fn quote(cell: &str) -> String {
    let is_formula = cell.starts_with(['=', '+', '-', '@', '\t', '\r']) && cell.parse::<f64>().is_err();
    let cell = if is_formula { format!("'{cell}") } else { cell.to_owned() };
    if is_formula || cell.contains([',', ';', '"', '\n', '\r']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell
    }
}
