//! Strict parser of numbers in attributes: the right count, finite, and no other text.

use crate::reading::report::{Place, Report, quoted};
use crate::reading::xml::Node;
use crate::urdf::elements::survey::has_xacro_substitution;

/// Parses exactly N finite numbers separated by white space. The error text names the defect.
pub(crate) fn parse_numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let expected = || format!("{N} finite number{}", if N == 1 { "" } else { "s" });
    let are = if N == 1 { "is" } else { "are" };
    let mut values = [0.0; N];
    let mut count = 0;
    for word in text.split_ascii_whitespace() {
        let value = word.parse::<f64>().map_err(|_| {
            let remedy = if word.contains(',') { " (spaces, not commas, go between numbers)" } else { "" };
            format!("{} is not a number{remedy}; {} {are} expected", quoted(word), expected())
        })?;
        if !value.is_finite() {
            return Err(format!("{} is not finite; {} {are} expected", quoted(word), expected()));
        }
        if let Some(slot) = values.get_mut(count) {
            *slot = value;
        }
        count += 1;
    }
    if count == N {
        Ok(values)
    } else if count == 0 {
        Err(format!("it is empty; {} {are} expected", expected()))
    } else {
        Err(format!("got {count}, expected {}", expected()))
    }
}

/// N finite numbers of an attribute; `default` if absent or invalid (an error).
pub(crate) fn optional_numbers<const N: usize>(
    node: Node<'_>,
    attribute: &'static str,
    default: [f64; N],
    report: &mut Report,
) -> [f64; N] {
    let Some(text) = node.attribute(attribute) else { return default };
    parse_numbers(text).unwrap_or_else(|defect| {
        report_bad_number(node, attribute, text, &defect, report);
        default
    })
}

/// As [`optional_numbers`], but an absent attribute is an error.
pub(crate) fn required_numbers<const N: usize>(
    node: Node<'_>,
    attribute: &'static str,
    default: [f64; N],
    report: &mut Report,
) -> [f64; N] {
    if node.attribute(attribute).is_none() {
        report_missing_attribute(node, attribute, report);
    }
    optional_numbers(node, attribute, default, report)
}

/// Number in a mandatory attribute; `None` if absent or invalid.
pub(crate) fn required_number(node: Node<'_>, attribute: &'static str, report: &mut Report) -> Option<f64> {
    // An absent or invalid number becomes NaN; valid numbers are finite.
    let [value] = required_numbers(node, attribute, [f64::NAN], report);
    Some(value).filter(|value| !value.is_nan())
}

/// Reports an invalid number; `defect` is the error text of [`parse_numbers`].
pub(crate) fn report_bad_number(
    node: Node<'_>,
    attribute: &'static str,
    text: &str,
    defect: &str,
    report: &mut Report,
) {
    let place = Place::Attribute(node, attribute);
    if has_xacro_substitution(text) {
        report.add_xacro_error(place, &format!("{attribute}={}", quoted(text)));
    } else {
        report.error("bad-number", place, || format!("{attribute}={}: {defect}", quoted(text)));
    }
}

/// Reports an absent mandatory attribute.
pub(crate) fn report_missing_attribute(node: Node<'_>, attribute: &'static str, report: &mut Report) {
    report.error("missing-attribute", Place::Element(node), || {
        format!("<{}> has no attribute \"{attribute}\"", node.tag_name().name())
    });
}

#[cfg(test)]
mod tests {
    use super::parse_numbers;

    #[test]
    fn only_the_right_count_of_finite_numbers_passes() {
        assert_eq!(parse_numbers::<3>(" 1\t-2.5e-3 +.5\n"), Ok([1.0, -2.5e-3, 0.5]));
        for text in
            ["", "  ", "1 2", "1 2 3 4", "0 x 0 1", "1,2,3", "1 2 nan", "1 2 inf", "1 2 1e400", "1 2 0x3"]
        {
            assert!(parse_numbers::<3>(text).is_err(), "{text}");
        }
        // A no-break space does not separate numbers.
        assert!(parse_numbers::<2>("1\u{a0}2").is_err());
    }
}
