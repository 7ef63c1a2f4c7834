//! Numbers in attributes, read strictly: the right count, every one finite, nothing else.

use crate::report::{Place, Report, quoted};
use crate::survey::is_substitution;
use roxmltree::Node;

/// Exactly N finite numbers with white space between them; else what is the matter.
pub(crate) fn parse<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let expected = || if N == 1 { "1 finite number".to_owned() } else { format!("{N} finite numbers") };
    let mut values = [0.0; N];
    let mut count = 0;
    for word in text.split_ascii_whitespace() {
        let value = word.parse::<f64>().map_err(|_| {
            let remedy = if word.contains(',') { " (spaces, not commas, go between numbers)" } else { "" };
            format!("{} is not a number{remedy}; {} expected", quoted(word), expected_count(N))
        })?;
        if !value.is_finite() {
            return Err(format!("{} is not finite; {} expected", quoted(word), expected_count(N)));
        }
        if let Some(slot) = values.get_mut(count) {
            *slot = value;
        }
        count += 1;
    }
    if count == N {
        Ok(values)
    } else if count == 0 {
        Err(format!("it is empty; {} expected", expected_count(N)))
    } else {
        Err(format!("got {count}, expected {}", expected()))
    }
}

fn expected_count(count: usize) -> String {
    if count == 1 { "1 finite number is".to_owned() } else { format!("{count} finite numbers are") }
}

/// The attribute's text, known to hold N good numbers; `default` where it is absent or bad (which is reported).
pub(crate) fn optional<'a, const N: usize>(
    node: Node<'a, '_>,
    attribute: &'static str,
    default: &'a str,
    report: &mut Report,
) -> &'a str {
    let Some(text) = node.attribute(attribute) else { return default };
    match parse::<N>(text) {
        Ok(_) => text,
        Err(defect) => {
            bad(node, attribute, text, &defect, report);
            default
        }
    }
}

/// As [`optional`], but its absence is reported too.
pub(crate) fn required<'a, const N: usize>(
    node: Node<'a, '_>,
    attribute: &'static str,
    default: &'a str,
    report: &mut Report,
) -> &'a str {
    if node.attribute(attribute).is_none() {
        missing(node, attribute, report);
    }
    optional::<N>(node, attribute, default, report)
}

/// One number from an attribute that must be there.
pub(crate) fn number(node: Node<'_, '_>, attribute: &'static str, report: &mut Report) -> Option<f64> {
    let Some(text) = node.attribute(attribute) else {
        missing(node, attribute, report);
        return None;
    };
    match parse::<1>(text) {
        Ok([value]) => Some(value),
        Err(defect) => {
            bad(node, attribute, text, &defect, report);
            None
        }
    }
}

/// Reports a number that cannot be read.
pub(crate) fn bad(
    node: Node<'_, '_>,
    attribute: &'static str,
    text: &str,
    defect: &str,
    report: &mut Report,
) {
    let place = Place::Attribute(node, attribute);
    if is_substitution(text) {
        report.xacro(place, &format!("{attribute}={}", quoted(text)));
    } else {
        report.error("bad-number", place, || format!("{attribute}={}: {defect}", quoted(text)));
    }
}

/// Reports an attribute that must be there and is not.
pub(crate) fn missing(node: Node<'_, '_>, attribute: &'static str, report: &mut Report) {
    report.error("missing-attribute", Place::Element(node), || {
        format!("<{}> has no attribute \"{attribute}\"", node.tag_name().name())
    });
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn only_the_right_count_of_finite_numbers_passes() {
        assert_eq!(parse::<3>(" 1\t-2.5e-3 +.5\n"), Ok([1.0, -2.5e-3, 0.5]));
        for text in
            ["", "  ", "1 2", "1 2 3 4", "0 x 0 1", "1,2,3", "1 2 nan", "1 2 inf", "1 2 1e400", "1 2 0x3"]
        {
            assert!(parse::<3>(text).is_err(), "{text}");
        }
        // A no-break space is no separator.
        assert!(parse::<2>("1\u{a0}2").is_err());
    }
}
