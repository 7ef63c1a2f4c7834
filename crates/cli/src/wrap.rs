//! Lines no wider than a terminal of 80 columns. Words are never broken: a path or a name that is wider stands on a line of
//! its own, so that it can be copied.

use textwrap::core::display_width;
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};

/// The columns of a terminal.
pub const WIDTH: usize = 80;
/// Where the value of a fact begins: behind its name.
const VALUE: usize = 21;

/// How many columns a text takes.
pub fn width(text: &str) -> usize {
    display_width(text)
}

/// A line, divided where it is too wide; what follows the first line is indented.
pub fn hanging(text: &str, indent: usize) -> String {
    if display_width(text) <= WIDTH {
        return text.to_owned();
    }
    // The spaces that it begins with are no place to divide it.
    let begins = text.len() - text.trim_start_matches(' ').len();
    let (before, after) = (&text[..begins], " ".repeat(indent));
    let options = Options::new(WIDTH)
        .initial_indent(before)
        .subsequent_indent(&after)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit)
        .break_words(false);
    textwrap::fill(&text[begins..], options)
}

/// `name   value`, the value in a column of its own; with the end of the line.
pub fn fact(name: &str, value: &str) -> String {
    hanging(&format!("{name:<20} {value}"), VALUE) + "\n"
}

/// A diagnostic: its further lines are indented, so that each line that is not begins a message.
pub fn message(text: &str) -> String {
    let begins = text.len() - text.trim_start_matches(' ').len();
    hanging(text, begins + 2)
}

/// Every line of a text, its further lines indented as it is.
pub fn lines(text: &str) -> String {
    let wrapped = |line: &str| hanging(line, line.len() - line.trim_start_matches(' ').len());
    text.split('\n').map(wrapped).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_divided_between_words_and_no_wider_than_a_terminal() {
        let text = "a word ".repeat(40);
        let divided = fact("what", text.trim());
        assert!(divided.lines().all(|line| width(line) <= WIDTH), "{divided}");
        assert!(divided.lines().skip(1).all(|line| line.starts_with(&" ".repeat(VALUE))), "{divided}");
        let joined: Vec<&str> = divided.split_whitespace().collect();
        assert_eq!(joined.join(" "), format!("what {}", text.trim()));
    }

    #[test]
    fn what_is_not_too_wide_is_left_as_it_is() {
        assert_eq!(message("error:  two  spaces "), "error:  two  spaces ");
        // 40 characters of two columns each, and one of none.
        assert_eq!(width("m̄"), 1);
        let wide = "質".repeat(40);
        assert_eq!(message(&wide), wide);
    }

    #[test]
    fn a_word_is_never_broken() {
        let path = format!("/{}/model.urdf", "folder".repeat(20));
        let divided = message(&format!("error: {path} is not there"));
        assert!(divided.contains(&path), "{divided}");
        assert_eq!(divided.lines().count(), 3);
    }
}
