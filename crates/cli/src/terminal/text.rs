//! Tables and bars in text output.

use crate::terminal::console::{bold, dim};
use crate::terminal::escape::line;
use crate::terminal::limits;
use crate::terminal::number::{decimals_of, fixed, number, trim_zeros, true_minus};
use crate::terminal::wrap::{columns, width, wrap_hanging};
use std::fmt;

/// Bar of `width` cells for a share between 0 and 1.
fn bar(share: f64, width: usize) -> String {
    let eighths = (share.clamp(0.0, 1.0) * width as f64 * 8.0).round() as usize;
    let mut text = "█".repeat(eighths / 8);
    if let Some(part) = (eighths % 8).checked_sub(1) {
        text.push(['▏', '▎', '▍', '▌', '▋', '▊', '▉'][part]);
    }
    text
}

/// Cell of a table.
#[derive(Clone, Debug)]
pub enum TableCell {
    Text(String),
    /// Number of which each digit counts; – without a value.
    Number(Option<f64>),
    /// Part of a sum or of the largest number of its column.
    Part(Option<f64>),
}

impl From<String> for TableCell {
    fn from(text: String) -> Self {
        TableCell::Text(text)
    }
}

impl From<&str> for TableCell {
    fn from(text: &str) -> Self {
        TableCell::Text(text.to_owned())
    }
}

impl From<f64> for TableCell {
    fn from(value: f64) -> Self {
        TableCell::Number(Some(value))
    }
}

impl From<Option<f64>> for TableCell {
    fn from(value: Option<f64>) -> Self {
        TableCell::Number(value)
    }
}

/// Table with columns as wide as their contents. The numbers of a column have one number of decimals and are aligned to the right. If a
/// line is too wide, the last column is wrapped between words; if even this is too narrow, columns continue in further lines of the row.
pub struct Table {
    rows: Vec<Vec<TableCell>>,
    /// True if the last row is the sum of the others.
    has_sum: bool,
    /// Lengths of the bars beside the rows, from 0 to 1; no bar if empty.
    bars: Vec<f64>,
}

impl Table {
    /// Creates a table with its header.
    pub fn new<const N: usize>(header: [&str; N]) -> Self {
        Self { rows: vec![header.map(TableCell::from).to_vec()], has_sum: false, bars: Vec::new() }
    }

    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [impl Into<TableCell>; N]) {
        self.rows.push(cells.map(Into::into).into());
    }

    /// Creates a table of rows, starting with the header.
    pub fn from_rows<C: Into<TableCell>>(rows: impl IntoIterator<Item = Vec<C>>) -> Self {
        let rows = rows.into_iter().map(|row| row.into_iter().map(Into::into).collect());
        Self { rows: rows.collect(), has_sum: false, bars: Vec::new() }
    }

    /// Marks the last row as the sum of the others.
    pub fn with_sum(self) -> Self {
        Self { has_sum: true, ..self }
    }

    /// True if the last row is the sum of the others.
    pub fn has_sum(&self) -> bool {
        self.has_sum
    }

    /// Adds a bar beside each row, in proportion to the largest value.
    pub fn with_bars(self, values: &[f64]) -> Self {
        let most = values.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
        Self { bars: values.iter().map(|x| x.abs() / most).collect(), ..self }
    }

    /// Lengths of the bars beside the rows, from 0 to 1.
    pub fn bars(&self) -> &[f64] {
        &self.bars
    }

    /// Rows as text, starting with the header. Numbers of different magnitude are aligned at the decimal point by figure spaces.
    pub fn rows(&self) -> Vec<Vec<String>> {
        let mut rows = vec![Vec::new(); self.rows.len()];
        for column in 0..self.rows.first().map_or(0, Vec::len) {
            let cells = self.rows.iter().map(|row| row.get(column));
            for (row, cell) in rows.iter_mut().zip(column_texts(&cells.collect::<Vec<_>>())) {
                row.push(cell);
            }
        }
        rows
    }

    /// True without a row below the header.
    pub fn is_empty(&self) -> bool {
        self.rows.len() < 2
    }

    /// Ranges of columns for each line of a row.
    fn column_bands(rows: &[Vec<String>], widths: &[usize]) -> Vec<std::ops::Range<usize>> {
        let words = rows.iter().filter_map(|row| row.last()).flat_map(|cell| cell.split(' ').map(width));
        let last = words.max().unwrap_or(0).max(limits::MIN_COLUMN);
        let (mut bands, mut start, mut used) = (Vec::new(), 0, 0);
        for (i, wide) in widths.iter().enumerate() {
            let needed = if i + 1 == widths.len() { (*wide).min(last) } else { *wide };
            if i > start && used + needed > columns() {
                bands.push(start..i);
                (start, used) = (i, limits::BAND_INDENT);
            }
            used += needed + 2;
        }
        bands.push(start..widths.len());
        bands
    }
}

/// Texts of the cells of a column.
fn column_texts(cells: &[Option<&TableCell>]) -> Vec<String> {
    let values = cells.iter().filter_map(|cell| match cell {
        Some(TableCell::Number(Some(x)) | TableCell::Part(Some(x))) if *x != 0.0 && x.is_finite() => {
            Some(x.abs())
        }
        _ => None,
    });
    let range = values.fold(None, |range: Option<[f64; 2]>, x| {
        Some(range.map_or([x, x], |[least, most]| [least.min(x), most.max(x)]))
    });
    let are_parts = cells.iter().any(|cell| matches!(cell, Some(TableCell::Part(_))));
    let decimals = range.and_then(|[least, most]| common_decimals(least, most, are_parts));
    // Zeros at the end of all numbers are left out.
    let numbers = || {
        cells.iter().filter_map(|cell| match cell {
            Some(TableCell::Number(Some(x)) | TableCell::Part(Some(x))) if *x != 0.0 => Some(*x),
            _ => None,
        })
    };
    let decimals = decimals.map(|most| {
        (0..most)
            .find(|n| numbers().all(|x| trim_zeros(&fixed(x, most)) == trim_zeros(&fixed(x, *n))))
            .unwrap_or(most)
    });
    let text = |cell: &Option<&TableCell>| match cell {
        None => String::new(),
        Some(TableCell::Text(text)) => text.clone(),
        Some(TableCell::Number(None) | TableCell::Part(None)) => "–".to_owned(),
        Some(TableCell::Number(Some(x)) | TableCell::Part(Some(x))) => match decimals {
            Some(decimals) if *x != 0.0 => fixed(*x, decimals),
            _ => number(*x),
        },
    };
    let mut texts: Vec<String> = cells.iter().map(text).collect();
    if is_numeric(texts.iter().skip(1)) {
        // Digits after the decimal point, with the point.
        let after = |text: &str| text.find('.').map_or(0, |at| text.len() - at);
        let is_value =
            |text: &str| text.starts_with(|c: char| c.is_ascii_digit() || c == '−') && !text.contains('e');
        let most =
            texts.iter().skip(1).filter(|text| is_value(text)).map(|text| after(text)).max().unwrap_or(0);
        for text in texts.iter_mut().skip(1).filter(|text| is_value(text)) {
            let missing = most - after(text);
            text.extend(std::iter::repeat_n('\u{2007}', missing));
        }
    }
    texts
}

/// Number of decimals for all numbers of a column: one digit more than those of the largest, if this gives all digits of the smallest;
/// for parts the digits of the largest. `None` if the magnitudes differ too much, or need an exponent.
fn common_decimals(least: f64, most: f64, are_parts: bool) -> Option<usize> {
    if !(1e-4..1e9).contains(&most) {
        return None;
    }
    let (of_least, of_most) = (decimals_of(least), decimals_of(most));
    match are_parts {
        true => Some(of_most),
        false if of_least > of_most + 2 => None,
        false => Some(of_least.min(of_most + 1)),
    }
}

/// True for each column of numbers: apart from the header and empty cells it has numbers only, after which a percent sign may follow. The
/// first column names the rows and is never one.
pub fn numeric_columns<R: AsRef<[String]>>(rows: &[R]) -> Vec<bool> {
    let cells = |k: usize| rows.iter().skip(1).filter_map(move |row| row.as_ref().get(k));
    (0..rows.first().map_or(0, |row| row.as_ref().len())).map(|k| k > 0 && is_numeric(cells(k))).collect()
}

/// True for numbers, of which some may be missing.
fn is_numeric<'t>(cells: impl Iterator<Item = &'t String>) -> bool {
    let is_number = |cell: &str| {
        cell.trim_end_matches(" %").trim().replace('−', "-").parse::<f64>().is_ok_and(f64::is_finite)
    };
    let words = ["", "–", "?", "0", "immovable", "massless", "unreachable", "no answer", "none"];
    let mut cells = cells.map(|cell| cell.trim()).filter(|cell| !words.contains(cell)).peekable();
    cells.peek().is_some() && cells.all(is_number)
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let escaped =
            |row: Vec<String>| row.iter().map(|cell| line(&true_minus(cell)).into_owned()).collect();
        let mut rows: Vec<Vec<String>> = self.rows().into_iter().map(escaped).collect();
        if !self.bars.is_empty() {
            // A wide table has shorter bars, or none.
            let wide = |k: usize| rows.iter().map(|row| width(&row[k])).max().unwrap_or(0) + 2;
            let used: usize = (0..rows[0].len()).map(wide).sum();
            let left = limits::BAR_WIDTH.min(columns().saturating_sub(used));
            if left >= limits::LEAST_BAR_WIDTH {
                let bars = self.bars.iter().map(|length| bar(*length, left)).map(Some);
                let bars = std::iter::once(None).chain(bars).chain(std::iter::repeat(None));
                rows.iter_mut().zip(bars).for_each(|(row, bar)| row.push(bar.unwrap_or_default()));
            }
        }
        let is_number = numeric_columns(&rows);
        let mut widths = vec![0; rows.first().map_or(0, Vec::len)];
        for row in &rows {
            for (widest, cell) in widths.iter_mut().zip(row) {
                *widest = (*widest).max(width(cell));
            }
        }
        let bands = Self::column_bands(&rows, &widths);
        for (number_of, row) in rows.iter().enumerate() {
            if self.has_sum && number_of + 1 == rows.len() {
                let wide = widths.iter().zip(&is_number).rposition(|(_, is_number)| *is_number);
                let wide: usize =
                    widths.iter().take(wide.map_or(0, |last| last + 1)).map(|wide| wide + 2).sum();
                writeln!(f, "{}", dim(&"─".repeat(wide.saturating_sub(2))))?;
            }
            for band in &bands {
                let mut text = " ".repeat(if band.start == 0 { 0 } else { limits::BAND_INDENT });
                let (mut column, mut last) = (0, 0);
                for i in band.clone() {
                    (column, last) = (width(&text), i);
                    let padding = " ".repeat(widths[i] - width(&row[i]));
                    text += &if is_number[i] {
                        padding + &row[i] + "  "
                    } else {
                        row[i].clone() + &padding + "  "
                    };
                }
                let text = text.replace('\u{2007}', " ");
                let text = text.trim_end();
                // A continued line is omitted if empty.
                if band.start == 0 || !text.is_empty() {
                    let is_last = last + 1 == widths.len();
                    let text = if is_last { wrap_hanging(text, column) } else { text.to_owned() };
                    let is_sum = self.has_sum && number_of + 1 == rows.len();
                    let text = if number_of == 0 {
                        dim(&text)
                    } else if is_sum {
                        bold(&text)
                    } else {
                        text
                    };
                    writeln!(f, "{text}")?;
                }
            }
        }
        Ok(())
    }
}

/// Quotes a word for the shell of this system, if necessary.
pub fn shell_quoted(text: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "._-/".contains(c);
    if text.chars().all(is_plain) {
        return text.to_owned();
    }
    // cmd.exe and PowerShell both accept double quotes, which are not permitted in file names on Windows.
    if cfg!(windows) { format!("\"{text}\"") } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_no_wider_than_a_terminal() {
        let mut table = Table::new(["link", "mass", "notes"]);
        table.row(["arm", "1 kg", "a word ".repeat(30).trim()]);
        let text = table.to_string();
        assert!(text.lines().all(|line| width(line) <= columns()), "{text}");
        // The notes stay in their column.
        assert!(
            text.lines()
                .skip(2)
                .all(|line| line.starts_with("            a") || line.starts_with("            w")),
            "{text}"
        );
        let long = |letter: char| String::from(letter).repeat(30);
        let mut table = Table::new(["joint", "from", "to"]);
        table.row([long('a'), long('b'), long('c')]);
        table.row([long('d'), String::new(), String::new()]);
        let expected = [
            format!("{:<30}  from", "joint"),
            "    to".to_owned(),
            format!("{}  {}", long('a'), long('b')),
            format!("    {}", long('c')),
            long('d'),
        ];
        assert_eq!(table.to_string().lines().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn columns_have_one_number_of_decimals() {
        let texts = |values: &[f64], part: bool| -> Vec<String> {
            let mut table = Table::new(["name", "kg"]);
            for x in values {
                let value = if part { TableCell::Part(Some(*x)) } else { TableCell::Number(Some(*x)) };
                table.row([TableCell::from("a"), value]);
            }
            table.rows().into_iter().skip(1).map(|row| row[1].replace('\u{2007}', "_")).collect()
        };
        assert_eq!(texts(&[428.367, 33.8641, -116.955], false), ["428.37", "33.86", "−116.95"]);
        assert_eq!(texts(&[7731.37, 144.29, 0.0], true), ["7731", "144", "0"]);
        // Each digit of a small number counts.
        assert_eq!(texts(&[1800.0, 0.52134, 0.0], false), ["1800_____", "0.5213", "0_____"]);
    }

    #[test]
    fn columns_of_numbers_are_recognised() {
        let rows = [["a", "b", "c"], ["2", "−1.5", "2 %"], ["1", "", "–"]].map(|row| row.map(str::to_owned));
        assert_eq!(numeric_columns(&rows), [false, true, true]);
    }

    #[test]
    fn bars_grow() {
        assert_eq!(bar(0.0, 4), "");
        assert_eq!(bar(0.5, 4), "██");
        assert_eq!(bar(1.0, 4), "████");
        assert_eq!(bar(0.03, 4), "▏");
    }
}
