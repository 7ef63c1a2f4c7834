//! Prepares text for the page: printable characters, one line, limited width.

use crate::font::{Font, Weight, advance, substitute_missing};
use crate::limits;

/// Removes control characters and outer spaces, and shortens the text to `max_width` page units with an ellipsis.
pub(crate) fn fit_to_width(text: &str, font: Font, max_width: f64) -> String {
    let mut length = 0.0;
    let ellipsis = width("…", font);
    // Length of the text that fits together with an ellipsis.
    let (mut kept, mut length_with_ellipsis) = (String::new(), 0);
    for (i, c) in substitute_missing(text.trim()).chars().map(replace_unprintable).enumerate() {
        length += advance(font.weight, c);
        let needed_width = length * font.size;
        if needed_width > max_width || i >= limits::MAX_CHARACTERS {
            kept.truncate(length_with_ellipsis);
            kept.truncate(kept.trim_end().len());
            kept.push('…');
            return kept;
        }
        kept.push(c);
        if needed_width + ellipsis <= max_width {
            length_with_ellipsis = kept.len();
        }
    }
    kept
}

/// Lines of a text, broken at spaces; the last of `most` lines is shortened.
pub(crate) fn wrap_to_width(text: &str, font: Font, max_width: f64, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match (longer, lines.last_mut()) {
            (Some(longer), Some(line)) if lines_end_here(&longer, font, max_width) => *line = longer,
            _ => lines.push(word.to_owned()),
        }
    }
    if lines.len() > most {
        let rest = lines.split_off(most.saturating_sub(1)).join(" ");
        lines.push(rest);
    }
    lines.iter().map(|line| fit_to_width(line, font, max_width)).collect()
}

/// True if a line is within the width and the limit of characters.
fn lines_end_here(line: &str, font: Font, max_width: f64) -> bool {
    width(&substitute_missing(line), font) <= max_width && line.chars().count() < limits::MAX_CHARACTERS
}

/// Width of a text, in page units.
pub(crate) fn width(text: &str, font: Font) -> f64 {
    text.chars().map(|c| advance(font.weight, c)).sum::<f64>() * font.size
}

/// Replaces control characters by spaces, and characters that XML cannot hold by U+FFFD.
fn replace_unprintable(c: char) -> char {
    match c {
        c if c.is_control() || matches!(c, '\u{2028}' | '\u{2029}') => ' ',
        '\u{FFFE}' | '\u{FFFF}' => '\u{FFFD}',
        c => c,
    }
}

/// Font of the regular face.
pub(crate) const fn regular(size: f64) -> Font {
    Font { weight: Weight::Regular, size }
}

/// Font of the medium face.
pub(crate) const fn medium(size: f64) -> Font {
    Font { weight: Weight::Medium, size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_have_one_width_so_that_columns_of_numbers_align() {
        for digit in '0'..='9' {
            assert_eq!(width(&digit.to_string(), regular(12.0)), width("0", regular(12.0)));
        }
    }

    #[test]
    fn accents_have_no_width() {
        assert_eq!(width("m̄", regular(10.0)), width("m", regular(10.0)));
    }

    #[test]
    fn missing_characters_are_substituted_or_boxed() {
        assert_eq!(width("→", regular(10.0)), width("->", regular(10.0)));
        assert_eq!(fit_to_width("a → b", regular(10.0), 100.0), "a -> b");
        assert!(width("質", regular(10.0)) > 0.0);
        assert_eq!(width("a\u{200B}b", regular(10.0)), width("ab", regular(10.0)));
        // The faces contain every character that percuss itself writes.
        for c in "0123456789−.×⁰¹²³⁴⁵⁶⁷⁸⁹⁻…m̄ (kg) · ° µ Δ √ ≤ ≥ ≈ ∞".chars()
        {
            for weight in [Weight::Regular, Weight::Medium] {
                assert!(weight.face().glyph_index(c).is_some(), "{weight:?} lacks {c:?}");
            }
        }
    }

    #[test]
    fn long_texts_end_in_an_ellipsis_within_their_width() {
        let font = medium(13.0);
        let cut = fit_to_width(&"effective ".repeat(50), font, 200.0);
        assert!(cut.ends_with('…') && width(&cut, font) <= 200.0 && width(&cut, font) > 150.0, "{cut}");
        assert_eq!(fit_to_width("  mass  ", font, 200.0), "mass");
        assert_eq!(fit_to_width("a\nb\u{0}c\u{FFFF}", font, 200.0), "a b c\u{FFFD}");
        assert!(fit_to_width(&format!("m{}", "\u{304}".repeat(100_000)), font, 200.0).chars().count() <= 241);
        assert_eq!(fit_to_width("mass", font, 0.0), "…");
    }

    #[test]
    fn titles_are_wrapped_and_keep_all_words_up_to_the_last_line() {
        let font = medium(13.0);
        let text = "bump_stop_left, rebound_stop_left, spring_left, damper_left, contact_patch_left";
        let lines = wrap_to_width(text, font, 250.0, 3);
        assert!(
            (2..=3).contains(&lines.len()) && lines.iter().all(|line| width(line, font) <= 250.0),
            "{lines:?}"
        );
        assert_eq!(lines.join(" "), text);
        let cut = wrap_to_width(text, font, 120.0, 2);
        assert!(cut.len() == 2 && cut[1].ends_with('…') && width(&cut[1], font) <= 120.0, "{cut:?}");
        assert_eq!(wrap_to_width("", font, 100.0, 3), [""; 0]);
    }
}
