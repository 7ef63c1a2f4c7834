//! Columns of a position file: joint, component and unit of each column.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::question::errors::table_error::{TableError, TableFault};
use crate::values::position::position_dimension;
use percuss_mechanism::{JointId, Mechanism};
use percuss_units::{Dimension, Unit};
use std::collections::HashMap;

/// Target and unit of the cells in a column.
#[derive(Clone, Copy, Debug)]
struct ColumnTarget {
    /// Index in the numbers of a row.
    value: usize,
    unit: Option<&'static Unit>,
}

impl ColumnTarget {
    /// Stores a number, converted to SI units, in a row. Returns false if the number is not finite.
    fn store(&self, read: f64, values: &mut [f64]) -> bool {
        let value = self.unit.map_or(read, |unit| unit.to_si(read));
        if value.is_finite() {
            values[self.value] = value;
        }
        value.is_finite()
    }
}

/// Columns of a file.
#[derive(Clone, Debug)]
pub(crate) struct Columns {
    names: Vec<String>,
    /// Cell of each column; `None` for an ignored column.
    targets: Vec<Option<ColumnTarget>>,
    /// Joints in the order of their first columns. The numbers of a row are in the same order, those of a joint contiguous.
    pub joints: Vec<JointId>,
    /// Number of numbers in a row.
    pub width: usize,
}

/// Position component of a column and unit of its cells; `None` for SI units.
type ColumnMeaning = (PositionComponent, Option<&'static Unit>);

/// Position component of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct PositionComponent {
    joint: JointId,
    component: usize,
}

impl Columns {
    /// Columns for these names; `at_names` is the position of the names in the file.
    pub fn new(
        prepared: &PreparedQuestion,
        names: Vec<String>,
        ignore: &[String],
        at_names: impl Fn(TableFault) -> TableError,
    ) -> Result<Self, TableError> {
        let mechanism = prepared.system.mechanism();
        let known = components_by_name(mechanism);
        let mut found: Vec<Option<ColumnMeaning>> = Vec::with_capacity(names.len());
        for (at, name) in names.iter().enumerate() {
            let refuse = |fault: TableFault| at_names(fault).in_column(at, name);
            if ignore.contains(name) {
                found.push(None);
                continue;
            }
            let (number, unit) = parse_column_name(mechanism, &known, name).map_err(refuse)?;
            let joint = mechanism.joint(number.joint);
            if let Some(mimic) = joint.mimic() {
                let master = mechanism.joint(mimic.master).name().to_owned();
                return Err(refuse(TableFault::Mimic { joint: joint.name().to_owned(), master }));
            }
            if prepared.question.pose.set.iter().any(|(set, _)| set == joint.name()) {
                return Err(refuse(TableFault::IsSet { joint: joint.name().to_owned() }));
            }
            if let Some(first) = found.iter().position(|other| other.is_some_and(|(n, _)| n == number)) {
                return Err(refuse(format!("column {} gives the same position", first + 1).into()));
            }
            found.push(Some((number, unit)));
        }
        let mut joints: Vec<JointId> = Vec::new();
        for (number, _) in found.iter().flatten() {
            if !joints.contains(&number.joint) {
                joints.push(number.joint);
            }
        }
        let mut starts = HashMap::new();
        let (mut width, mut missing) = (0, Vec::new());
        for &joint in &joints {
            starts.insert(joint, width);
            let positions = mechanism.joint(joint).kind().positions();
            width += positions;
            let given = |component: &usize| {
                found.iter().flatten().any(|(n, _)| *n == PositionComponent { joint, component: *component })
            };
            missing.extend((0..positions).filter(|i| !given(i)).map(|i| column_name(mechanism, joint, i)));
        }
        if !missing.is_empty() {
            return Err(at_names(TableFault::Missing { columns: missing }));
        }
        let cell = |(number, unit): ColumnMeaning| ColumnTarget {
            value: starts[&number.joint] + number.component,
            unit,
        };
        Ok(Self { targets: found.into_iter().map(|f| f.map(cell)).collect(), names, joints, width })
    }

    /// Names of joints outside loops that neither a column nor the query sets.
    pub fn unset_outside_loops(&self, prepared: &PreparedQuestion) -> Vec<String> {
        let mechanism = prepared.system.mechanism();
        let free = |joint: &JointId| {
            let found = mechanism.joint(*joint);
            found.kind().positions() > 0 && found.mimic().is_none() && !prepared.system.is_bound(*joint)
        };
        self.unset(prepared, mechanism.joint_ids().filter(free))
    }

    /// Column names for the joints among `joints` that neither a column nor the query sets.
    pub fn unset(&self, prepared: &PreparedQuestion, joints: impl Iterator<Item = JointId>) -> Vec<String> {
        let mechanism = prepared.system.mechanism();
        let is_set = |joint: &JointId| {
            let name = mechanism.joint(*joint).name();
            self.joints.contains(joint) || prepared.question.pose.set.iter().any(|(set, _)| set == name)
        };
        let unset = joints.filter(|joint| !is_set(joint));
        let columns =
            unset.flat_map(|joint| (0..mechanism.joint(joint).kind().positions()).map(move |i| (joint, i)));
        columns.map(|(joint, i)| column_name(mechanism, joint, i)).collect()
    }

    /// First column of a joint: index, from 0, and name.
    pub fn joint_column(&self, joint: JointId, mechanism: &Mechanism) -> Option<(usize, &str)> {
        let before = self.joints.iter().take_while(|other| **other != joint);
        let start: usize = before.map(|other| mechanism.joint(*other).kind().positions()).sum();
        let at = self.targets.iter().position(|cell| cell.is_some_and(|cell| cell.value == start))?;
        Some((at, &self.names[at]))
    }

    /// Reads the numbers of a row from the text of the cells.
    pub fn parse_row<'c>(
        &self,
        cells: impl ExactSizeIterator<Item = &'c str>,
        values: &mut [f64],
        at: impl Fn(TableFault) -> TableError,
    ) -> Result<(), TableError> {
        if cells.len() != self.targets.len() {
            let (got, expected) = (cells.len(), self.targets.len());
            return Err(at(format!("{got} cells; the header has {expected}").into()));
        }
        for (number, (text, cell)) in cells.zip(&self.targets).enumerate() {
            let Some(cell) = cell else { continue };
            let fault = match text.parse::<f64>() {
                Ok(read) if cell.store(read, values) => continue,
                Ok(_) => not_finite(&shorten_cell(text)),
                Err(_) if text.is_empty() => "the cell is empty; expected a number".to_owned(),
                Err(_) => format!(
                    "\"{}\" is no number; expected one such as 0.5 or -1e-3, its unit in the header",
                    shorten_cell(text)
                ),
            };
            return Err(at(fault.into()).in_column(number, &self.names[number]));
        }
        Ok(())
    }

    /// Stores the numbers of a row; `numbers`: column index and number, `None` for a null.
    pub fn store_row(
        &self,
        numbers: impl Iterator<Item = (usize, Option<f64>)>,
        values: &mut [f64],
        at: impl Fn(TableFault) -> TableError,
    ) -> Result<(), TableError> {
        for (number, read) in numbers {
            let Some(cell) = &self.targets[number] else { continue };
            let fault = match read {
                Some(read) if cell.store(read, values) => continue,
                Some(read) => not_finite(&read.to_string()),
                None => "the value is null; expected a number".to_owned(),
            };
            return Err(at(fault.into()).in_column(number, &self.names[number]));
        }
        Ok(())
    }

    /// Indices of the columns that are not ignored.
    pub fn selected_columns(&self) -> impl Iterator<Item = usize> {
        self.targets.iter().enumerate().filter(|(_, cell)| cell.is_some()).map(|(number, _)| number)
    }
}

/// Text of a cell for a message, at most 40 characters.
fn shorten_cell(text: &str) -> String {
    if text.chars().count() > 40 { text.chars().take(40).chain(['…']).collect() } else { text.to_owned() }
}

/// Column name of a position component.
fn column_name(mechanism: &Mechanism, joint: JointId, component: usize) -> String {
    let joint = mechanism.joint(joint);
    match joint.kind().positions() {
        1 => joint.name().to_owned(),
        _ => format!("{}[{component}]", joint.name()),
    }
}

/// Position components of all joints by column name.
fn components_by_name(mechanism: &Mechanism) -> HashMap<String, PositionComponent> {
    let numbers = mechanism.joint_ids().flat_map(|joint| {
        (0..mechanism.joint(joint).kind().positions())
            .map(move |component| PositionComponent { joint, component })
    });
    numbers.map(|n| (column_name(mechanism, n.joint, n.component), n)).collect()
}

/// Position component and unit for a column name.
fn parse_column_name(
    mechanism: &Mechanism,
    known: &HashMap<String, PositionComponent>,
    name: &str,
) -> Result<ColumnMeaning, TableFault> {
    let expected = |n: PositionComponent| position_dimension(mechanism.joint(n.joint).kind(), n.component);
    if let Some(&number) = known.get(name) {
        return Ok((number, None));
    }
    if name.is_empty() {
        return Err("it has no name; expected the name of a joint".into());
    }
    // Written tables have an apostrophe before a name that a spreadsheet would read as a formula.
    if let Some(written) = name.strip_prefix('\'')
        && written.starts_with(['=', '+', '-', '@', '\t', '\r'])
    {
        return parse_column_name(mechanism, known, written);
    }
    let with_unit = name.strip_suffix(']').and_then(|name| name.rsplit_once('['));
    if let Some((before, unit)) = with_unit
        && let Some(&number) = known.get(before.trim_end())
    {
        let (unit, expected) = (unit.trim(), expected(number));
        return match Unit::named(unit, &[Dimension::Length, Dimension::Angle, Dimension::Mass]) {
            Some(found) if found.dimension == expected => Ok((number, Some(found))),
            Some(found) => {
                let got = found.dimension;
                Err(format!("[{unit}] is the unit of {got}; expected {expected}").into())
            }
            None => {
                let units: Vec<&str> = expected.units().map(|unit| unit.name).collect();
                let units = units.join(", ");
                Err(format!("\"{unit}\" is no unit of a position; expected {expected}, in {units}").into())
            }
        };
    }
    let joint = mechanism.find_joint(name)?;
    Err(match mechanism.joint(joint).kind().positions() {
        0 => TableFault::Fixed { joint: name.to_owned() },
        numbers => {
            let last = numbers - 1;
            format!(
                "joint \"{name}\" has {numbers} numbers; expected columns \"{name}[0]\" to \"{name}[{last}]\""
            )
            .into()
        }
    })
}

/// Message: a number that is not finite.
fn not_finite(text: &str) -> String {
    format!("\"{text}\" is not finite; expected a finite number")
}

/// Refuses a header with a single name that contains semicolons or tabs: the separator of the file is no comma.
pub(crate) fn check_separator(names: &[String]) -> Result<(), TableFault> {
    let [name] = names else { return Ok(()) };
    for separator in [';', '\t'] {
        let count = name.matches(separator).count();
        if count > 0 {
            let separator = if separator == '\t' { '⇥' } else { separator };
            let why = format!(
                "the header has no comma and {count} \"{separator}\"; expected cells separated by commas"
            );
            return Err(why.into());
        }
    }
    Ok(())
}
