//! Reader of the part of YAML that files of hardpoints use: nested maps, flow maps and lists on one line, plain and quoted values, comments.

use crate::limits::{MAX_SHEET_BYTES, MAX_SHEET_KEYS};
use std::ops::Range;

/// Value with its path, `hardpoints.left.strut_top.x`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Leaf {
    pub path: String,
    pub text: String,
    /// Bytes of the value in the file.
    pub range: Range<usize>,
}

/// Deepest nesting.
const MAX_DEPTH: usize = 12;

/// Error with its position in the text.
type Defect = (usize, &'static str);

/// Values of a text.
///
/// # Errors
/// Another part of YAML (lists of several lines, anchors, tags, block texts, tabs), a key given twice, or a text above a limit.
pub(super) fn read(text: &str) -> Result<Vec<Leaf>, Defect> {
    if text.len() > MAX_SHEET_BYTES {
        return Err((0, "the file is too large"));
    }
    let (mut leaves, mut above, mut offset) = (Vec::new(), Vec::<(usize, String)>::new(), 0);
    let mut sections = Vec::new();
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = without_comment(line).trim_end();
        let indent = line.len() - line.trim_start_matches(' ').len();
        let content = &line[indent..];
        if content.is_empty() || content == "---" && leaves.is_empty() {
            continue;
        }
        let at = start + indent;
        if content.starts_with('\t') {
            return Err((at, "a tab before a key; blanks are expected"));
        }
        if content == "-" || content.starts_with("- ") {
            return Err((at, "a list of several lines; maps of keys and values are expected"));
        }
        let (key, value) = split_key(content).ok_or((at, "KEY: VALUE is expected"))?;
        while above.last().is_some_and(|(of, _)| *of >= indent) {
            above.pop();
        }
        let path = above.iter().map(|(_, key)| key.as_str()).chain([key]).collect::<Vec<_>>().join(".");
        if value.trim().is_empty() {
            if above.len() == MAX_DEPTH {
                return Err((at, "the nesting is too deep"));
            }
            if sections.contains(&path) {
                return Err((at, "the key is given twice"));
            }
            sections.push(path);
            above.push((indent, key.to_owned()));
        } else {
            let begin = at + content.len() - value.trim_start().len();
            add_value(text, path, begin..start + line.len(), 0, &mut leaves)?;
        }
        if leaves.len() + sections.len() > MAX_SHEET_KEYS {
            return Err((at, "the file has too many keys"));
        }
    }
    for (i, leaf) in leaves.iter().enumerate() {
        if leaves[..i].iter().any(|other| other.path == leaf.path) {
            return Err((leaf.range.start, "the key is given twice"));
        }
    }
    Ok(leaves)
}

/// Line without its comment: from a # at the beginning or after a blank, outside quotes.
fn without_comment(line: &str) -> &str {
    let (mut quote, mut before) = (None, ' ');
    for (i, c) in line.char_indices() {
        match quote {
            Some(open) if c == open => quote = None,
            Some(_) => {}
            None if c == '#' && before.is_whitespace() => return &line[..i],
            None if (c == '"' || c == '\'') && !before.is_alphanumeric() => quote = Some(c),
            None => {}
        }
        before = c;
    }
    line
}

/// Key and value, separated by a colon and a blank or by a colon at the end.
fn split_key(content: &str) -> Option<(&str, &str)> {
    let end = content.find(": ").or_else(|| content.strip_suffix(':').map(str::len))?;
    let key = content[..end].trim().trim_matches(['"', '\'']);
    (!key.is_empty() && !key.contains(['{', '}', '[', ']', ','])).then(|| (key, &content[end + 1..]))
}

/// Adds a value, or the values of a flow map or list.
fn add_value(
    text: &str,
    path: String,
    range: Range<usize>,
    depth: usize,
    leaves: &mut Vec<Leaf>,
) -> Result<(), Defect> {
    let value = text[range.clone()].trim();
    let begin = range.start + text[range.clone()].len() - text[range.clone()].trim_start().len();
    let inner = |open: char, close: char| value.strip_prefix(open).and_then(|rest| rest.strip_suffix(close));
    if depth == MAX_DEPTH {
        return Err((begin, "the nesting is too deep"));
    }
    let is_map = value.starts_with('{');
    if is_map || value.starts_with('[') {
        let list = if is_map { inner('{', '}') } else { inner('[', ']') };
        let list = list.ok_or((begin, "the bracket is not closed on its line"))?;
        for (number, part) in parts(list, begin + 1).into_iter().enumerate() {
            let item = &text[part.clone()];
            if item.trim().is_empty() {
                continue;
            }
            let (key, from) = if is_map {
                let (key, value) = split_key(item.trim()).ok_or((part.start, "KEY: VALUE is expected"))?;
                (key.to_owned(), part.end - (value.len() + item.len() - item.trim_end().len()))
            } else {
                (number.to_string(), part.start)
            };
            add_value(text, format!("{path}.{key}"), from..part.end, depth + 1, leaves)?;
        }
        return Ok(());
    }
    if value.starts_with(['&', '*', '!', '|', '>', '%', '@', '`', '{', '[']) {
        return Err((begin, "anchors, tags and block texts are not read"));
    }
    let plain = value.trim_matches(['"', '\'']);
    leaves.push(Leaf { path, text: plain.to_owned(), range: begin..begin + value.len() });
    Ok(())
}

/// Parts between commas outside brackets; `at`: byte of the text at which the list begins.
fn parts(list: &str, at: usize) -> Vec<Range<usize>> {
    let (mut found, mut depth, mut begin) = (Vec::new(), 0i32, 0);
    for (i, c) in list.char_indices() {
        match c {
            '{' | '[' => depth += 1,
            '}' | ']' => depth -= 1,
            ',' if depth == 0 => {
                found.push(at + begin..at + i);
                begin = i + 1;
            }
            _ => {}
        }
    }
    found.push(at + begin..at + list.len());
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_read_with_their_places() {
        let text = "# a\ntype: \"x y\"  # b\nhardpoints:\n  left:\n    ball: {x: 1.5, y: -2, z: 3e1}\n  list: [4, 5]\nend: 'it#s'\n";
        let leaves = read(text).expect("a map");
        let found: Vec<(&str, &str)> = leaves.iter().map(|leaf| (&*leaf.path, &*leaf.text)).collect();
        let expected = [
            ("type", "x y"),
            ("hardpoints.left.ball.x", "1.5"),
            ("hardpoints.left.ball.y", "-2"),
            ("hardpoints.left.ball.z", "3e1"),
            ("hardpoints.list.0", "4"),
            ("hardpoints.list.1", "5"),
            ("end", "it#s"),
        ];
        assert_eq!(found, expected);
        for leaf in &leaves {
            assert_eq!(text[leaf.range.clone()].trim_matches(['"', '\'']), leaf.text);
        }
    }

    #[test]
    fn other_parts_of_yaml_are_refused() {
        for text in [
            "a:\n  - 1",
            "a: &b 1",
            "a: |\n  x",
            "\ta: 1",
            "a: {b: 1",
            "a",
            "a: 1\na: 2",
            "a:\n b: 1\na:\n c: 1",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
        let deep = format!("a: {}1{}", "{b: ".repeat(40), "}".repeat(40));
        assert!(read(&deep).is_err());
    }
}
