//! Numbers, tables and bars in text output.

use crate::terminal::escape::line;
use crate::terminal::limits;
use crate::terminal::wrap::{WIDTH, width, wrap_hanging};
use std::fmt;

/// A value that is rounding relative to `size` is shown as 0.
pub fn rounded(value: f64, size: f64) -> f64 {
    if value.abs() < limits::COMPONENT_ROUNDING * size { 0.0 } else { value }
}

/// Formats nine significant digits without trailing zeros; scientific notation for very small and very large numbers.
pub fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let magnitude = x.abs().log10().floor();
    if !(-4.0..9.0).contains(&magnitude) {
        let text = format!("{x:.8e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", trim_zeros(digits));
    }
    // The shortest representation is used if it has at most nine digits, because it is faster to compute.
    let shortest = x.to_string();
    if shortest.trim_start_matches(['-', '0', '.']).bytes().filter(u8::is_ascii_digit).count() <= 9 {
        return shortest;
    }
    let decimals = (8.0 - magnitude).max(0.0) as usize;
    trim_zeros(&format!("{x:.decimals$}"))
}

/// Formats five significant digits.
pub fn short_number(x: f64) -> String {
    let rounded: f64 = format!("{x:.4e}").parse().unwrap_or(x);
    number(rounded)
}

/// Formats a number with the digits that its uncertainty supports: to the second significant digit of the uncertainty.
pub fn within_uncertainty(x: f64, uncertainty: f64) -> String {
    let place = uncertainty.log10().floor();
    if !(-12.0..9.0).contains(&place) {
        return number(x);
    }
    let decimals = 1 - place as i32;
    if decimals >= 0 {
        return format!("{x:.*}", decimals as usize);
    }
    let unit = 10_f64.powi(-decimals);
    format!("{}", (x / unit).round() * unit)
}

/// Formats one digit, rounded up: for upper bounds. Two digits for a number slightly above a power of ten: 1.1e-3, not 2e-3.
pub fn upper_bound(x: f64) -> String {
    let nearest = format!("{x:.0e}");
    let above = || {
        let (digit, exponent) = nearest.split_once('e')?;
        let two_digits = format!("1.1e{exponent}");
        if digit == "1" && two_digits.parse().is_ok_and(|bound: f64| x <= bound) {
            return Some(two_digits);
        }
        let above: f64 = format!("{}e{exponent}", digit.parse::<u8>().ok()? + 1).parse().ok()?;
        Some(format!("{above:.0e}"))
    };
    match nearest.parse::<f64>() {
        Ok(shown) if shown < x => above().unwrap_or(nearest),
        _ => nearest,
    }
}

/// Removes trailing zeros after the decimal point.
fn trim_zeros(digits: &str) -> String {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        digits.into()
    }
}

/// Formats `(x, y, z)`; a component that is rounding noise relative to the largest is shown as 0.
pub fn triple(v: &[f64; 3]) -> String {
    let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let shown =
        v.map(|x| if x.abs() < limits::COMPONENT_ROUNDING * largest { "0".into() } else { number(x) });
    format!("({}, {}, {})", shown[0], shown[1], shown[2])
}

/// Bar of `width` cells for a share between 0 and 1.
fn bar(share: f64, width: usize) -> String {
    let eighths = (share.clamp(0.0, 1.0) * width as f64 * 8.0).round() as usize;
    let mut text = "█".repeat(eighths / 8);
    if let Some(part) = (eighths % 8).checked_sub(1) {
        text.push(['▏', '▎', '▍', '▌', '▋', '▊', '▉'][part]);
    }
    text
}

/// Table with columns as wide as their contents. If a line is too wide, the last column is wrapped between words; if
/// even this is too narrow, columns continue in further lines of the row.
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// Creates a table with its header.
    pub fn new<const N: usize>(header: [&str; N]) -> Self {
        Self { rows: vec![header.map(str::to_owned).to_vec()] }
    }

    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        self.rows.push(cells.into());
    }

    /// Creates a table of rows, starting with the header.
    pub fn from_rows<R: Into<Vec<String>>>(rows: impl IntoIterator<Item = R>) -> Self {
        Self { rows: rows.into_iter().map(Into::into).collect() }
    }

    /// Rows, starting with the header.
    pub fn rows(&self) -> &[Vec<String>] {
        &self.rows
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
            if i > start && used + needed > WIDTH {
                bands.push(start..i);
                (start, used) = (i, limits::BAND_INDENT);
            }
            used += needed + 2;
        }
        bands.push(start..widths.len());
        bands
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let escaped = |row: &Vec<String>| row.iter().map(|cell| line(cell).into_owned()).collect();
        let rows: Vec<Vec<String>> = self.rows.iter().map(escaped).collect();
        let mut widths = vec![0; rows.first().map_or(0, Vec::len)];
        for row in &rows {
            for (widest, cell) in widths.iter_mut().zip(row) {
                *widest = (*widest).max(width(cell));
            }
        }
        let bands = Self::column_bands(&rows, &widths);
        for row in &rows {
            for band in &bands {
                let mut text = " ".repeat(if band.start == 0 { 0 } else { limits::BAND_INDENT });
                let (mut column, mut last) = (0, 0);
                for i in band.clone() {
                    (column, last) = (width(&text), i);
                    text += &row[i];
                    text.extend(std::iter::repeat_n(' ', widths[i] + 2 - width(&row[i])));
                }
                let text = text.trim_end();
                // A continued line is omitted if empty.
                if band.start == 0 || !text.is_empty() {
                    let is_last = last + 1 == widths.len();
                    writeln!(f, "{}", if is_last { wrap_hanging(text, column) } else { text.to_owned() })?;
                }
            }
        }
        Ok(())
    }
}

/// Names with bars and percentages.
pub fn bars(shares: &[(String, f64)]) -> String {
    let names: Vec<_> = shares.iter().map(|(name, _)| line(name)).collect();
    let widest = names.iter().map(|name| width(name)).max().unwrap_or(0).max(20);
    // Long names shorten the bars.
    let bars = limits::BAR_WIDTH.min(WIDTH.saturating_sub(widest + 13));
    let row = |(name, (_, share)): (&std::borrow::Cow<str>, &(String, f64))| {
        let pad = " ".repeat(widest - width(name));
        let row = format!("  {name}{pad} {:>6.2} %  {}", share * 100.0, bar(*share, bars));
        format!("{}\n", row.trim_end())
    };
    names.iter().zip(shares).map(row).collect()
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
    fn a_bound_is_never_less_than_what_it_bounds() {
        let cases = [
            (1e-13, "1e-13"),
            (1.4e-13, "2e-13"),
            (1.6e-13, "2e-13"),
            (9.4e-14, "1e-13"),
            (0.0, "0e0"),
            (1.0000000000000937e-3, "1.1e-3"),
        ];
        for (x, shown) in cases {
            assert_eq!(upper_bound(x), shown);
        }
        for k in -3000..3000 {
            let x = (0.1 * f64::from(k)).exp();
            let shown: f64 = upper_bound(x).parse().expect("a number");
            assert!(x <= shown && shown <= 2.0 * x, "{x} by {shown}");
        }
        assert_eq!(upper_bound(f64::NAN), "NaN");
        assert_eq!(upper_bound(f64::INFINITY), "inf");
    }

    #[test]
    fn a_number_has_the_digits_of_its_uncertainty() {
        let cases =
            [(137.800409, 1.1782, "137.8"), (0.0123456, 3.4e-4, "0.01235"), (98765.4, 1234.0, "98800")];
        for (x, uncertainty, text) in cases {
            assert_eq!(within_uncertainty(x, uncertainty), text);
        }
        // Without an uncertainty, all digits.
        assert_eq!(within_uncertainty(0.75, 0.0), "0.75");
    }

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
    fn tables_are_no_wider_than_a_terminal() {
        let mut table = Table::new(["link", "mass", "notes"]);
        table.row(["arm".into(), "1 kg".into(), "a word ".repeat(30).trim().into()]);
        let text = table.to_string();
        assert!(text.lines().all(|line| width(line) <= WIDTH), "{text}");
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
    fn bars_grow() {
        assert_eq!(bar(0.0, 4), "");
        assert_eq!(bar(0.5, 4), "██");
        assert_eq!(bar(1.0, 4), "████");
        assert_eq!(bar(0.03, 4), "▏");
    }
}
