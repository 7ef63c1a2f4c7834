//! Numbers, tables and bars in text output.

use crate::escape::line;
use crate::limits;
use std::fmt;

/// Nine significant digits, without trailing zeros; scientific where that is shorter to read.
pub fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let magnitude = x.abs().log10().floor();
    if !(-4.0..9.0).contains(&magnitude) {
        let text = format!("{x:.8e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", trimmed(digits));
    }
    // The shortest digits, where nine are enough: found faster than so many decimals.
    let shortest = x.to_string();
    if shortest.trim_start_matches(['-', '0', '.']).bytes().filter(u8::is_ascii_digit).count() <= 9 {
        return shortest;
    }
    let decimals = (8.0 - magnitude).max(0.0) as usize;
    trimmed(&format!("{x:.decimals$}"))
}

/// Five digits.
pub fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.4e}").parse().unwrap_or(x);
    number(rounded)
}

fn trimmed(digits: &str) -> String {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        digits.into()
    }
}

/// `(x, y, z)`; rounding noise beside larger components is shown as 0.
pub fn triple(v: &[f64; 3]) -> String {
    let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let shown =
        v.map(|x| if x.abs() < limits::COMPONENT_ROUNDING * largest { "0".into() } else { number(x) });
    format!("({}, {}, {})", shown[0], shown[1], shown[2])
}

/// A bar of `width` cells for a share between 0 and 1.
pub fn bar(share: f64, width: usize) -> String {
    let eighths = (share.clamp(0.0, 1.0) * width as f64 * 8.0).round() as usize;
    let mut text = "█".repeat(eighths / 8);
    if let Some(part) = (eighths % 8).checked_sub(1) {
        text.push(['▏', '▎', '▍', '▌', '▋', '▊', '▉'][part]);
    }
    text
}

/// Columns under a header, as wide as they must be.
pub struct Table<const N: usize> {
    rows: Vec<[String; N]>,
}

impl<const N: usize> Table<N> {
    /// A table with its header.
    pub fn new(header: [&str; N]) -> Self {
        Self { rows: vec![header.map(str::to_owned)] }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: [String; N]) {
        self.rows.push(cells.map(|cell| line(&cell).into_owned()));
    }

    /// The header, and what was added.
    pub fn rows(&self) -> &[[String; N]] {
        &self.rows
    }
}

impl<const N: usize> fmt::Display for Table<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut widths = [0; N];
        for row in &self.rows {
            for (width, cell) in widths.iter_mut().zip(row) {
                *width = (*width).max(cell.chars().count());
            }
        }
        for row in &self.rows {
            let mut line = String::new();
            for (width, cell) in widths.iter().zip(row) {
                line += cell;
                line.extend(std::iter::repeat_n(' ', width + 2 - cell.chars().count()));
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_keep_nine_digits() {
        let cases = [
            (0.75, "0.75"),
            (207.342164123, "207.342164"),
            (3.3333333333e-7, "3.33333333e-7"),
            (1.0, "1"),
            (-0.5, "-0.5"),
            (1e12, "1e12"),
            (123456789.4, "123456789"),
            (0.0, "0"),
            (-0.00123456789, "-0.00123456789"),
            (0.001234567891, "0.00123456789"),
            (999999999.9, "1000000000"),
        ];
        for (x, text) in cases {
            assert_eq!(number(x), text);
        }
    }

    #[test]
    fn bars_grow() {
        assert_eq!(bar(0.0, 4), "");
        assert_eq!(bar(0.5, 4), "██");
        assert_eq!(bar(1.0, 4), "████");
        assert_eq!(bar(0.03, 4), "▏");
    }
}
