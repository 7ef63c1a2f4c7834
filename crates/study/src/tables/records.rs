//! Measured impacts: tables with a column of times and columns of forces, accelerations, velocities or displacements.

use crate::model::loading::{Input, hexadecimal};
use crate::question::errors::table_error::{TableError, TableFault};
use crate::tables::columns::check_separator;
use percuss_contact::identification::{MOST_SAMPLES, Measured, Record, Signal};
use percuss_tables::CsvRecords;
use percuss_units::{Dimension, Unit};
use schemars::JsonSchema;
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::Read;

/// Largest file, bytes: 200,000 rows of 300 bytes.
const MOST_BYTES: u64 = 64 << 20;

/// Column of a record and what it is taken for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RecordColumn {
    /// Name in the file.
    pub column: String,
    /// `time`, `force`, `acceleration`, `velocity` or `displacement`.
    pub quantity: &'static str,
    /// Unit.
    pub unit: &'static str,
}

/// Names of a quantity in the heads of columns, its dimension, and the quantity; `None` is the time.
const NAMES: [(Option<Measured>, Dimension, &[&str]); 5] = [
    (None, Dimension::Time, &["time", "t"]),
    (Some(Measured::Force), Dimension::Force, &["force", "f", "load"]),
    (
        Some(Measured::Acceleration),
        Dimension::Acceleration,
        &["acceleration", "deceleration", "accel", "acc", "a"],
    ),
    (Some(Measured::Velocity), Dimension::Speed, &["velocity", "speed", "v"]),
    (
        Some(Measured::Displacement),
        Dimension::Length,
        &["displacement", "penetration", "compression", "deflection", "position", "travel", "x", "s"],
    ),
];

/// Quantity and unit of a column; without a unit in SI units.
fn meaning(name: &str) -> Result<(Option<Measured>, &'static Unit), TableFault> {
    let text = name.trim();
    let (word, unit) = match text.find(['[', '(']) {
        Some(at) => (text[..at].trim(), Some(text[at + 1..].trim_end_matches([']', ')']).trim())),
        None => match text.rsplit_once(['_', ' ']) {
            Some((word, unit)) => (word.trim(), Some(unit)),
            None => (text, None),
        },
    };
    let word = word.to_lowercase();
    let found = NAMES.iter().find(|(_, _, names)| names.contains(&&*word));
    let Some((quantity, dimension, _)) = found else {
        let names: Vec<&str> = NAMES.iter().map(|(.., names)| names[0]).collect();
        return Err(format!(
            "\"{name}\" is no measured quantity; expected one of {}, with a unit such as force [kN], or the column ignored",
            names.join(", ")
        )
        .into());
    };
    let unit = match unit {
        Some(unit) => Unit::named(unit, &[*dimension]).ok_or_else(|| {
            let units: Vec<&str> = dimension.units().map(|unit| unit.name).collect();
            TableFault::from(format!(
                "\"{unit}\" is no unit of {dimension}; expected one of {}",
                units.join(", ")
            ))
        })?,
        // Every dimension of the table has units.
        None => dimension.default_unit().ok_or_else(|| TableFault::from("it has no unit"))?,
    };
    Ok((*quantity, unit))
}

/// Reads a record without the ignored columns.
pub(crate) fn read_record(
    path: &str,
    ignore: &[String],
) -> Result<(Record, Vec<RecordColumn>, Input), TableError> {
    let unreadable = |error| TableError::unreadable(path, &error);
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(unreadable)?;
    // A pipe has no size.
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(TableError::in_file(
            path,
            format!("more than {MOST_BYTES} bytes; cut the file around the impact"),
        ));
    }
    let input = Input { path: path.to_owned(), sha256: hexadecimal(&Sha256::digest(&bytes)) };
    let mut rows = CsvRecords::new(&bytes[..]);
    let read = |rows: &mut CsvRecords<&[u8]>| {
        rows.read().map_err(|fault| TableError::at_line(path, rows.line, fault))
    };
    if !read(&mut rows)? {
        return Err(TableError::in_file(
            path,
            "it is empty; expected a header such as time [ms], force [kN]",
        ));
    }
    let line = rows.line;
    let names: Vec<String> = rows.cells().map(str::to_owned).collect();
    check_separator(&names).map_err(|fault| TableError::at_line(path, line, fault))?;
    if let Some(unknown) = ignore.iter().find(|name| !names.contains(name)) {
        let why = format!("it has no column \"{unknown}\" to ignore; its columns are {}", names.join(", "));
        return Err(TableError::at_line(path, line, why));
    }
    let mut record = Record::default();
    let (mut columns, mut targets) = (Vec::new(), Vec::new());
    let mut has_time = false;
    for (number, name) in names.iter().enumerate() {
        let refuse = |fault: TableFault| TableError::at_line(path, line, fault).in_column(number, name);
        if ignore.contains(name) {
            targets.push(None);
            continue;
        }
        let (quantity, unit) = meaning(name).map_err(refuse)?;
        let is_twice = match quantity {
            None => std::mem::replace(&mut has_time, true),
            Some(quantity) => record.signals.iter().any(|signal| signal.quantity == quantity),
        };
        let word = quantity.map_or("time", |quantity| quantity.name_and_unit().0);
        if is_twice {
            return Err(refuse(
                format!("a second column of {word}; expected one, or this one ignored").into(),
            ));
        }
        columns.push(RecordColumn { column: name.clone(), quantity: word, unit: unit.name });
        targets.push(Some((quantity.map(|_| record.signals.len()), unit)));
        record.signals.extend(quantity.map(|quantity| Signal { quantity, values: Vec::new() }));
    }
    if !has_time || record.signals.is_empty() {
        let missing = if has_time {
            "a column of a force, an acceleration, a velocity or a displacement"
        } else {
            "a column time"
        };
        return Err(TableError::at_line(path, line, format!("{missing} is missing")));
    }
    while read(&mut rows)? {
        let line = rows.line;
        let at = |fault: String| TableError::at_line(path, line, fault);
        if rows.cells().len() != names.len() {
            return Err(at(format!("{} cells; the header has {}", rows.cells().len(), names.len())));
        }
        if record.times.len() == MOST_SAMPLES {
            return Err(at(format!("more than {MOST_SAMPLES} rows; cut the file around the impact")));
        }
        for (number, (text, target)) in rows.cells().zip(&targets).enumerate() {
            let Some((signal, unit)) = target else { continue };
            let value = text.parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| {
                at(format!("\"{text}\" is no finite number")).in_column(number, &names[number])
            })?;
            match signal {
                Some(signal) => record.signals[*signal].values.push(unit.to_si(value)),
                None => record.times.push(unit.to_si(value)),
            }
        }
    }
    Ok((record, columns, input))
}
