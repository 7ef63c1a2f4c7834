//! Table of a sweep for people: evenly distributed rows, and the number of rows without a finite effective mass.

use crate::pictures::sweep_figure::axis_unit;
use crate::terminal::number::with_unit;
use crate::terminal::text::{Table, TableCell};
use crate::terminal::units::varied_name;
use percuss_study::{Status, SweepHeading, SweepRow};

/// Number of rows from which every second row is left out.
const MOST_ROWS: usize = 80;

/// Numbers of a row.
struct Row {
    varied: Vec<f64>,
    status: &'static str,
    mass: Option<f64>,
    ratio: Option<f64>,
    estimate: Option<f64>,
    gap: Option<f64>,
    is_singular: bool,
}

/// Rows of a sweep, collected while it runs; the memory does not depend on the number of rows.
pub struct SweepText {
    heading: SweepHeading,
    /// Every `stride`-th row.
    rows: Vec<Row>,
    stride: usize,
    last: Option<Row>,
    count: usize,
    /// Numbers of rows by status, without finite ones.
    others: Vec<(&'static str, usize)>,
    /// Smallest and largest m̄.
    pub range: Option<[f64; 2]>,
}

impl SweepText {
    /// No rows yet.
    pub fn new(heading: &SweepHeading) -> Self {
        let (rows, others) = (Vec::new(), Vec::new());
        Self { heading: heading.clone(), rows, stride: 1, last: None, count: 0, others, range: None }
    }

    /// Adds a row.
    pub fn add(&mut self, row: &SweepRow) {
        if let Some(m) = row.effective_mass {
            self.range = Some(self.range.map_or([m, m], |[least, most]| [least.min(m), most.max(m)]));
        }
        if row.status != Status::Finite.name() {
            match self.others.iter_mut().find(|(status, _)| *status == row.status) {
                Some((_, count)) => *count += 1,
                None => self.others.push((row.status, 1)),
            }
        }
        let kept = Row {
            varied: row.varied.values().to_vec(),
            status: row.status,
            mass: row.effective_mass,
            ratio: row.motion_ratio,
            estimate: row.estimate,
            gap: row.gap.flatten(),
            is_singular: row.singular_pose == Some(true),
        };
        if self.count.is_multiple_of(self.stride) {
            if self.rows.len() == MOST_ROWS {
                let mut at = 0;
                self.rows.retain(|_| {
                    at += 1;
                    at % 2 == 1
                });
                self.stride *= 2;
            }
            if self.count.is_multiple_of(self.stride) {
                self.rows.push(kept);
                self.last = None;
                self.count += 1;
                return;
            }
        }
        self.last = Some(kept);
        self.count += 1;
    }

    /// Table with about `most` evenly distributed rows, among them the first and the last.
    pub fn table(&self, most: usize) -> Table {
        let rows: Vec<&Row> = self.rows.iter().chain(&self.last).collect();
        let step = rows.len().saturating_sub(1).div_ceil(most.max(2) - 1).max(1);
        let end = rows.len().saturating_sub(1);
        let shown: Vec<&Row> = rows
            .iter()
            .enumerate()
            .filter(|(i, _)| i % step == 0 || *i == end)
            .map(|(_, row)| *row)
            .collect();
        let units = self.heading.varied.iter().map(|varied| axis_unit(varied, self.heading.length_unit));
        let units: Vec<(f64, &str)> = units.collect();
        let with = |name: &str, unit: &str| format!("{name} {unit}").trim_end().to_owned();
        let names = self.heading.varied.iter().zip(&units);
        let mut header: Vec<String> =
            names.map(|(varied, (_, unit))| with(&varied_name(&varied.name), unit)).collect();
        header.push(format!("m̄ {}", self.heading.unit));
        let has = |of: fn(&Row) -> bool| shown.iter().any(|row| of(row));
        let (ratios, estimates) = (has(|row| row.ratio.is_some()), has(|row| row.estimate.is_some()));
        let (gaps, singular) = (has(|row| row.gap.is_some()), has(|row| row.is_singular));
        let length = self.heading.length_unit;
        for (is_shown, name) in [
            (ratios, "motion ratio".to_owned()),
            (estimates, "estimate kg".to_owned()),
            (gaps, with("gap", length.name())),
            (singular, String::new()),
        ] {
            header.extend(is_shown.then_some(name));
        }
        let mut cells: Vec<Vec<TableCell>> = vec![header.into_iter().map(TableCell::Text).collect()];
        for row in shown {
            let mut line: Vec<TableCell> = row
                .varied
                .iter()
                .zip(&units)
                .map(|(x, (scale, _))| TableCell::Part(Some(scale * x)))
                .collect();
            line.push(row.mass.map_or_else(|| row.status.into(), TableCell::from));
            for (is_shown, cell) in [
                (ratios, TableCell::Part(row.ratio)),
                (estimates, TableCell::from(row.estimate)),
                (gaps, TableCell::Part(row.gap.map(|gap| length.of_metres(gap)))),
                (singular, if row.is_singular { "singular".into() } else { "".into() }),
            ] {
                line.extend(is_shown.then_some(cell));
            }
            cells.push(line);
        }
        Table::from_rows(cells)
    }

    /// Numbers of rows by status, and the range of m̄.
    pub fn summary(&self) -> String {
        let mut parts = vec![format!("{} rows", self.count)];
        parts.extend(self.others.iter().map(|(status, count)| format!("{count} {status}")));
        let range = self.range.map(|[least, most]| {
            let unit = self.heading.unit;
            format!("; smallest {}, largest {}", with_unit(least, unit), with_unit(most, unit))
        });
        parts.join(", ") + &range.unwrap_or_default()
    }
}
