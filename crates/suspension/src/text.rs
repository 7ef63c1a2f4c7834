//! JSON with comments, as in Chrono's files, and bounds on the text before the parser runs.

use crate::limits::MAX_JSON_DEPTH;

/// Defect of the text, and its byte offset.
pub(super) struct TextError {
    pub at: usize,
    pub code: &'static str,
    pub message: &'static str,
}

/// Replaces `//` and `/* */` comments by blanks, which keeps all byte offsets. An unterminated comment and too deep
/// nesting are errors. The single pass recognises strings; the parser checks the grammar.
pub(super) fn blank_comments(text: &str) -> Result<String, TextError> {
    let bytes = text.as_bytes();
    let mut out = bytes.to_vec();
    let (mut at, mut depth) = (0, 0usize);
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'"' => at = end_of_string(bytes, at),
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                let length = bytes[at..].iter().position(|b| *b == b'\n').unwrap_or(bytes.len() - at);
                out[at..at + length].fill(b' ');
                at += length;
            }
            b'/' if bytes.get(at + 1) == Some(&b'*') => {
                let Some(length) = bytes[at + 2..].windows(2).position(|w| w == b"*/") else {
                    return Err(TextError {
                        at,
                        code: "not-json",
                        message: "this comment has no end, \"*/\"",
                    });
                };
                let end = at + 2 + length + 2;
                out[at..end].iter_mut().filter(|b| **b != b'\n').for_each(|b| *b = b' ');
                at = end;
            }
            b'{' | b'[' => {
                depth += 1;
                if depth > MAX_JSON_DEPTH {
                    let message = "more than 256 objects and arrays within one another";
                    return Err(TextError { at, code: "too-complex", message });
                }
                at += 1;
            }
            b'}' | b']' => {
                depth = depth.saturating_sub(1);
                at += 1;
            }
            _ => at += 1,
        }
    }
    // Comments begin and end with ASCII characters, so only whole characters were overwritten.
    String::from_utf8(out).map_err(|e| TextError {
        at: e.utf8_error().valid_up_to(),
        code: "not-utf-8",
        message: "not UTF-8 text",
    })
}

/// Offset after the closing quote of the string at `at`, or the end of the text.
fn end_of_string(bytes: &[u8], mut at: usize) -> usize {
    at += 1;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'"' => return at + 1,
            b'\\' => at += 2,
            _ => at += 1,
        }
    }
    bytes.len()
}

/// Line and column (in characters) of a byte offset; both start at 1.
pub(super) fn line_and_column(text: &str, at: usize) -> (u32, u32) {
    let before = &text.as_bytes()[..at.min(text.len())];
    let line_start = before.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    let line = before.iter().filter(|b| **b == b'\n').count() as u32 + 1;
    // Counts the bytes that begin a UTF-8 character.
    let column = before[line_start..].iter().filter(|b| **b & 0xC0 != 0x80).count() as u32 + 1;
    (line, column)
}

/// Byte offset of a line and a byte column, both from 1 as in serde_json.
pub(super) fn offset_of(text: &str, line: usize, column: usize) -> usize {
    let start: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    (start + column.saturating_sub(1)).min(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_blanked_in_place_and_strings_left_alone() {
        let text = "{ // é\n \"a//b\\\"/*\": /* x\ny */ 1 }";
        let Ok(clean) = blank_comments(text) else { panic!("refused") };
        assert_eq!(clean.len(), text.len());
        assert_eq!(clean.replace(' ', ""), "{\n\"a//b\\\"/*\":\n1}");
        assert_eq!(clean.find('1'), text.find('1'));
    }

    #[test]
    fn a_comment_must_end_and_brackets_not_nest_without_bound() {
        assert!(blank_comments("{ /* ").is_err_and(|t| t.code == "not-json" && t.at == 2));
        assert!(blank_comments(&"[".repeat(300)).is_err_and(|t| t.code == "too-complex" && t.at == 256));
        assert!(blank_comments(&"[".repeat(256)).is_ok());
        // The text ends with an escape character.
        assert!(blank_comments("\"\\").is_ok());
    }

    #[test]
    fn places_are_counted_from_one_in_characters() {
        let text = "a\né x";
        assert_eq!(line_and_column(text, 0), (1, 1));
        assert_eq!(line_and_column(text, text.len() - 1), (2, 3));
        assert_eq!(offset_of(text, 2, 1), 2);
        assert_eq!(line_and_column(text, 99), (2, 4));
    }
}
