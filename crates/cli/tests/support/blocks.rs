//! Blocks of pages, and the commands in them.

/// Part of a page in Markdown.
pub enum Part<'t> {
    /// Lines outside blocks.
    Prose(&'t str),
    /// Lines between fences, and the text after the first fence.
    Block { info: &'t str, text: &'t str },
}

const FENCE: &str = "```";

/// Divides a page into its parts. Panics on a block without an end.
pub fn parts(page: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut rest = page;
    while let Some(prose) = before_fence(rest) {
        parts.push(Part::Prose(&rest[..prose]));
        let (info, block) = rest[prose + FENCE.len()..].split_once('\n').expect("a line after a fence");
        let end = before_fence(block).unwrap_or_else(|| panic!("a block has no end: {block}"));
        parts.push(Part::Block { info, text: &block[..end] });
        rest = block[end..].split_once('\n').map_or("", |(_, after)| after);
    }
    parts.push(Part::Prose(rest));
    parts
}

/// Number of bytes before the first line that begins with a fence.
fn before_fence(text: &str) -> Option<usize> {
    if text.starts_with(FENCE) { Some(0) } else { text.find("\n```").map(|end| end + 1) }
}

/// Commands of a `console` block: words without `$`, and the lines below. Panics on lines before the first command.
pub fn commands(block: &str) -> Vec<(&str, &str)> {
    let mut commands = Vec::new();
    let mut next = block.strip_prefix("$ ");
    assert!(next.is_some(), "a block starts without a command: {block}");
    while let Some(rest) = next {
        let (command, after) = rest.split_at(rest.find("\n$ ").map_or(rest.len(), |end| end + 1));
        // A backslash continues the line.
        let mut end = 0;
        let line_end = command.split_inclusive('\n').find_map(|line| {
            end += line.len();
            (!line.ends_with("\\\n")).then_some(end)
        });
        let (line, shown) = command.split_at(line_end.unwrap_or(command.len()));
        commands.push((line.trim_end_matches('\n'), shown));
        next = after.strip_prefix("$ ");
    }
    commands
}

/// True if two lines are equal except for numbers, which may differ by 1e-12 of their value, because the exponential
/// function depends on the system.
pub fn agree(line: &str, other: &str) -> bool {
    let is_digit = |c: char| c.is_ascii_digit() || c == '.';
    let numbers = |text: &str| -> Vec<f64> {
        text.split(|c| !is_digit(c)).filter_map(|number| number.parse().ok()).collect()
    };
    let words = |text: &str| text.split(is_digit).collect::<String>();
    let (shown, found) = (numbers(line), numbers(other));
    let are_close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12 * b.abs();
    line == other
        || words(line) == words(other)
            && shown.len() == found.len()
            && shown.iter().zip(&found).all(are_close)
}
