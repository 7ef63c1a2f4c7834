//! Text from files for output on a terminal. Characters that would move the cursor, reverse the reading direction or
//! begin a new line are escaped.

use std::borrow::Cow;
use std::io::{self, Write};

/// True for characters that must be escaped: controls (C0, DEL, C1), line and paragraph separators, direction marks,
/// zero-width characters, tags.
pub fn is_unsafe(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{061C}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}'
            | '\u{FEFF}' | '\u{FFF9}'..='\u{FFFB}' | '\u{E0000}'..='\u{E007F}')
}

/// Escapes a text for output on one line; line feeds are escaped too.
pub fn line(text: &str) -> Cow<'_, str> {
    escaped(text, is_unsafe, |c| c.escape_default().to_string())
}

/// Escapes a text of several lines; line feeds are kept.
pub fn lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| c != '\n' && is_unsafe(c), |c| c.escape_default().to_string())
}

/// Escapes JSON. Outside strings nothing needs escaping; inside strings the escape is an equivalent notation.
pub fn json(text: &str) -> Cow<'_, str> {
    escaped(
        text,
        |c| c != '\n' && is_unsafe(c),
        |c| c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")).collect(),
    )
}

/// Replaces unsafe characters; borrows the text if there are none.
fn escaped(text: &str, is_unsafe: impl Fn(char) -> bool, escape: impl Fn(char) -> String) -> Cow<'_, str> {
    if !text.contains(&is_unsafe) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_unsafe(c) { out += &escape(c) } else { out.push(c) }
    }
    Cow::Owned(out)
}

/// Terminal that receives tables while they are computed.
pub struct Terminal<W> {
    to: W,
    /// Bytes of an incomplete character.
    incomplete: Vec<u8>,
}

impl<W> Terminal<W> {
    pub fn new(to: W) -> Self {
        Self { to, incomplete: Vec::new() }
    }
}

impl<W: Write> Write for Terminal<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.incomplete.extend_from_slice(bytes);
        let whole = match std::str::from_utf8(&self.incomplete) {
            Ok(text) => text.len(),
            Err(error) => error.valid_up_to(),
        };
        let text = String::from_utf8_lossy(&self.incomplete[..whole]);
        self.to.write_all(lines(&text).as_bytes())?;
        self.incomplete.drain(..whole);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_that_forge_a_line_are_escaped() {
        assert_eq!(line("arm\neffective mass 0.001 kg"), "arm\\neffective mass 0.001 kg");
        assert_eq!(line("\u{1b}[2J\u{9b}2J\u{202e}x\u{7f}"), "\\u{1b}[2J\\u{9b}2J\\u{202e}x\\u{7f}");
        assert_eq!(lines("a\nb\r"), "a\nb\\r");
        assert_eq!(json("\"\u{85}\u{e0041}\""), "\"\\u0085\\udb40\\udc41\"");
        assert_eq!(line("Längsträger m̄ → 質量"), "Längsträger m̄ → 質量");
    }

    #[test]
    fn characters_may_be_split_between_writes() {
        let mut terminal = Terminal::new(Vec::new());
        for byte in "m̄ \u{9b} 質".as_bytes() {
            terminal.write_all(&[*byte]).expect("a list of bytes");
        }
        assert_eq!(terminal.to, "m̄ \\u{9b} 質".as_bytes());
    }
}
