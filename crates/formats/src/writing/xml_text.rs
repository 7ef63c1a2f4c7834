//! Numbers, names and comments as text of XML files.

use crate::reading::limits::DECIMAL_NOTATION_RANGE;
use percuss_spatial::Vector3;

/// First lines of a file: XML declaration, and `heading` as a comment; no comment if `heading` is empty.
pub(crate) fn xml_head(heading: &str) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    if !heading.is_empty() {
        append!(out, "<!-- {} -->\n", escape_comment(heading));
    }
    out
}

/// Appends formatted text to a string.
macro_rules! append {
    ($out:expr, $($text:tt)*) => {{
        use std::fmt::Write as _;
        // Writing to a string cannot fail.
        let _ = $out.write_fmt(format_args!($($text)*));
    }};
}
pub(crate) use append;

/// Three numbers with spaces between.
pub(crate) fn format_vector(v: &Vector3<f64>) -> String {
    format_numbers(v.as_slice())
}

/// Numbers with spaces between.
pub(crate) fn format_numbers(values: &[f64]) -> String {
    values.iter().map(|x| format_number(*x)).collect::<Vec<_>>().join(" ")
}

/// The scale factors of a mesh in `before` and `after`; nothing if all are 1.
pub(crate) fn scale_text(before: &str, scale: &[f64; 3], after: &str) -> String {
    match scale {
        [1.0, 1.0, 1.0] => String::new(),
        factors => format!("{before}{}{after}", format_vector(&Vector3::from(*factors))),
    }
}

/// Shortest decimal that reads back as the same bits; in exponent notation for very small and very large numbers.
pub(crate) fn format_number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 || DECIMAL_NOTATION_RANGE.contains(&size) { format!("{x}") } else { format!("{x:e}") }
}

/// Escapes text for an attribute in double quotes. Characters forbidden in XML 1.0 become U+FFFD.
pub(crate) fn escape_attribute(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' => out.push_str("&#9;"),
            '\n' => out.push_str("&#10;"),
            '\r' => out.push_str("&#13;"),
            c if is_forbidden(c) => out.push('\u{fffd}'),
            other => out.push(other),
        }
    }
    out
}

/// True for a character that XML 1.0 forbids.
pub(crate) fn is_forbidden(c: char) -> bool {
    !matches!(c, '\t' | '\n' | '\r') && matches!(c, '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}')
}

/// Text for an XML comment: on one line and without `--`.
pub(crate) fn escape_comment(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.trim().chars() {
        match c {
            '-' if out.ends_with('-') => out.push_str(" -"),
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c if c.is_control() => out.push(' '),
            other => out.push(other),
        }
    }
    out
}
