//! Decoding of texts: UTF-8, or else Windows-1252, which older spreadsheet programs write.

use std::borrow::Cow;

/// Characters of the bytes 0x80 to 0x9F in Windows-1252; undefined bytes are the control characters of the same number.
const HIGH_CONTROLS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Text of the bytes, without a byte order mark.
pub struct Decoded<'b> {
    /// The text.
    pub text: Cow<'b, str>,
    /// Note about the encoding, for the report; `None` for UTF-8.
    pub note: Option<String>,
}

/// Decodes the bytes of a text file.
pub fn decode(bytes: &[u8]) -> Decoded<'_> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let error = match std::str::from_utf8(bytes) {
        Ok(text) => return Decoded { text: Cow::Borrowed(text), note: None },
        Err(error) => error,
    };
    let at = error.valid_up_to();
    let line = 1 + bytes[..at].iter().filter(|byte| **byte == b'\n').count();
    let text: String = bytes.iter().map(|byte| character(*byte)).collect();
    let note = format!(
        "not UTF-8 (byte 0x{:02x} in line {line}): read as Windows-1252, with {} for this byte. Save the file as UTF-8 if \
         names are wrong",
        bytes[at],
        character(bytes[at])
    );
    Decoded { text: Cow::Owned(text), note: Some(note) }
}

/// Character of a byte in Windows-1252.
fn character(byte: u8) -> char {
    match byte {
        0x80..=0x9F => HIGH_CONTROLS[usize::from(byte - 0x80)],
        byte => char::from(byte),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_beyond_ascii_are_decoded() {
        assert_eq!(decode(b"\xEF\xBB\xBFL\xC3\xA4nge").text, "Länge");
        let decoded = decode(b"a\nL\xE4nge 5 \x80 \x96");
        assert_eq!(decoded.text, "a\nLänge 5 € –");
        assert!(decoded.note.is_some_and(|note| note.contains("0xe4 in line 2")));
    }
}
