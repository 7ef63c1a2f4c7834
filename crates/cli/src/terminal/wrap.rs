//! Lines as wide as the terminal, at most 120 columns; 80 columns in a file or a pipe. Words are never broken: a wider path or name is on a line of its own and can be
//! copied.

use crate::terminal::escape;
use std::cell::Cell;
use textwrap::core::display_width;
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};

/// Columns in a file or a pipe.
pub const WIDTH: usize = 80;
/// Least and largest number of columns on a terminal: longer lines are hard to read.
const COLUMNS: [usize; 2] = [40, 120];

thread_local! {
    /// Columns of the run on this thread.
    static COLUMNS_USED: Cell<usize> = const { Cell::new(WIDTH) };
}

/// Sets the number of columns to that of the terminal; `None`: a file or a pipe.
pub fn use_columns(of_terminal: Option<usize>) {
    let [least, most] = COLUMNS;
    COLUMNS_USED.set(of_terminal.map_or(WIDTH, |columns| columns.clamp(least, most)));
}

/// Number of columns of a line.
pub fn columns() -> usize {
    COLUMNS_USED.get()
}
/// Column of the value of a fact, after its name.
const VALUE_COLUMN: usize = 21;

/// Display width of a text, in columns.
pub fn width(text: &str) -> usize {
    display_width(text)
}

/// Wraps a line that is too wide; continuation lines are indented.
pub fn wrap_hanging(text: &str, indent: usize) -> String {
    if display_width(text) <= columns() {
        return text.to_owned();
    }
    // Leading spaces are excluded from wrapping.
    let begins = text.len() - text.trim_start_matches(' ').len();
    let (before, after) = (&text[..begins], " ".repeat(indent));
    let options = Options::new(columns())
        .initial_indent(before)
        .subsequent_indent(&after)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit)
        .break_words(false);
    textwrap::fill(&text[begins..], options)
}

/// Formats `name   value` with a line feed; the value has its own column.
pub fn fact_line(name: &str, value: &str) -> String {
    fact_lines(&[(name, value)])
}

/// Formats names with values, one below the other.
pub fn fact_lines<N: AsRef<str>, V: AsRef<str>>(facts: &[(N, V)]) -> String {
    let widest = facts.iter().map(|(name, _)| width(name.as_ref())).max().unwrap_or(0);
    let column = VALUE_COLUMN.max(widest + 2);
    let line = |(name, value): &(N, V)| {
        let padding = " ".repeat(column - width(name.as_ref()));
        wrap_hanging(&format!("{}{padding}{}", name.as_ref(), escape::line(value.as_ref())), column) + "\n"
    };
    facts.iter().map(line).collect()
}

/// Wraps a diagnostic. Continuation lines are indented, so that each line without indentation begins a message.
pub fn wrap_message(text: &str) -> String {
    let begins = text.len() - text.trim_start_matches(' ').len();
    wrap_hanging(text, begins + 2)
}

/// Wraps every line of a text; continuation lines keep the indentation of their line.
pub fn wrap_lines(text: &str) -> String {
    let wrapped = |line: &str| wrap_hanging(line, line.len() - line.trim_start_matches(' ').len());
    text.split('\n').map(wrapped).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_divided_between_words_and_no_wider_than_a_terminal() {
        let text = "a word ".repeat(40);
        let divided = fact_line("what", text.trim());
        assert!(divided.lines().all(|line| width(line) <= WIDTH), "{divided}");
        assert!(divided.lines().skip(1).all(|line| line.starts_with(&" ".repeat(VALUE_COLUMN))), "{divided}");
        let joined: Vec<&str> = divided.split_whitespace().collect();
        assert_eq!(joined.join(" "), format!("what {}", text.trim()));
    }

    #[test]
    fn lines_that_fit_are_unchanged() {
        assert_eq!(wrap_message("error:  two  spaces "), "error:  two  spaces ");
        // 40 characters of two columns each; then a combining character without width.
        assert_eq!(width("m̄"), 1);
        let wide = "質".repeat(40);
        assert_eq!(wrap_message(&wide), wide);
    }

    #[test]
    fn a_word_is_never_broken() {
        let path = format!("/{}/model.urdf", "folder".repeat(20));
        let divided = wrap_message(&format!("error: {path} is not there"));
        assert!(divided.contains(&path), "{divided}");
        assert_eq!(divided.lines().count(), 3);
    }
}
