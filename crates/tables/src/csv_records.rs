//! Reader of comma-separated text (RFC 4180), or with another separator, record by record, in bounded memory.
//!
//! The crate `csv` is not used: it accepts a quote that is never closed, does not limit the length of a record, and does not
//! recognise a quoted cell after blanks.

use crate::format_fault::FormatFault;
use crate::limits::MAX_RECORD_BYTES;
use std::io::{BufRead, Read};
use std::ops::Range;

/// Records of a text with their line numbers.
#[derive(Debug)]
pub struct CsvRecords<R> {
    input: R,
    separator: char,
    /// Number of the line to be read next, from 1.
    next_line: usize,
    /// First line of the last record.
    pub line: usize,
    /// Bytes of the last record.
    bytes: Vec<u8>,
    /// Texts of all cells of the last record.
    text: String,
    /// Range of each cell in `text`.
    cells: Vec<Range<usize>>,
}

impl<R: BufRead> CsvRecords<R> {
    /// Records of a text, from its first line on.
    pub fn new(input: R) -> Self {
        let (bytes, text, cells) = (Vec::new(), String::new(), Vec::new());
        Self { input, separator: ',', next_line: 1, line: 0, bytes, text, cells }
    }

    /// The same records with another separator of the cells.
    #[must_use]
    pub fn separated_by(self, separator: char) -> Self {
        Self { separator, ..self }
    }

    /// Cells of the last record, without quotes.
    pub fn cells(&self) -> impl ExactSizeIterator<Item = &str> {
        self.cells.iter().map(|cell| &self.text[cell.clone()])
    }

    /// Reads the next record and skips empty lines; false at the end.
    ///
    /// # Errors
    /// [`FormatFault`], in the record that begins in [`Self::line`].
    pub fn read(&mut self) -> Result<bool, FormatFault> {
        loop {
            self.bytes.clear();
            self.line = self.next_line;
            if !self.append_line()? {
                return Ok(false);
            }
            // A line break within quotes belongs to a cell. Each byte is examined once.
            let (mut in_quotes, mut examined) = (false, 0);
            loop {
                in_quotes ^= self.bytes[examined..].iter().filter(|byte| **byte == b'"').count() % 2 == 1;
                examined = self.bytes.len();
                if !in_quotes {
                    break;
                }
                if !self.append_line()? {
                    return Err(FormatFault::OpenQuote);
                }
            }
            while self.bytes.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r')) {
                self.bytes.pop();
            }
            let byte_order_mark: &[u8] = if self.line == 1 { b"\xEF\xBB\xBF" } else { b"" };
            let bytes = self.bytes.strip_prefix(byte_order_mark).unwrap_or(&self.bytes);
            if bytes.is_empty() {
                continue;
            }
            let Ok(text) = std::str::from_utf8(bytes) else {
                return Err(FormatFault::NotText);
            };
            self.text.clear();
            self.cells.clear();
            split_record(text, self.separator, &mut self.text, &mut self.cells);
            return Ok(true);
        }
    }

    /// Appends a line to the bytes; false at the end.
    fn append_line(&mut self) -> Result<bool, FormatFault> {
        let bytes_left = (MAX_RECORD_BYTES + 1).saturating_sub(self.bytes.len()) as u64;
        let read = self.input.by_ref().take(bytes_left).read_until(b'\n', &mut self.bytes);
        let read = read.map_err(|error| FormatFault::from(&error))?;
        if self.bytes.len() > MAX_RECORD_BYTES {
            return Err(FormatFault::TooLong);
        }
        self.next_line += 1;
        Ok(read > 0)
    }
}

/// Splits a record. Appends the cells, without quotes and surrounding blanks, to `text`, and their ranges to `cells`.
fn split_record(record: &str, separator: char, text: &mut String, cells: &mut Vec<Range<usize>>) {
    let mut rest = record;
    loop {
        let cell_start = text.len();
        let after = match rest.trim_start_matches([' ', '\u{a0}']).strip_prefix('"') {
            Some(quoted) => {
                let mut quoted = quoted;
                // An even number of quotes: every quoted field is closed.
                while let Some((part, more)) = quoted.split_once('"') {
                    text.push_str(part);
                    quoted = more;
                    match quoted.strip_prefix('"') {
                        Some(more) => {
                            text.push('"');
                            quoted = more;
                        }
                        None => break,
                    }
                }
                quoted
            }
            None => rest,
        };
        let (last_part, more) = match after.split_once(separator) {
            Some((last_part, more)) => (last_part, Some(more)),
            None => (after, None),
        };
        text.push_str(last_part.trim());
        cells.push(cell_start..text.len());
        match more {
            Some(more) => rest = more,
            None => return,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn records(text: &[u8]) -> Result<Vec<Vec<String>>, (usize, FormatFault)> {
        let mut records = CsvRecords::new(text);
        let mut found = Vec::new();
        while records.read().map_err(|fault| (records.line, fault))? {
            found.push(records.cells().map(str::to_owned).collect());
        }
        Ok(found)
    }

    #[test]
    fn cells_are_split() {
        let text = b"\xEF\xBB\xBFa, b ,\"c,\"\"d\"\"\"\r\n\r\n1,,\n\"x\ny\",2,3";
        let expected = [["a", "b", "c,\"d\""], ["1", "", ""], ["x\ny", "2", "3"]];
        assert_eq!(records(text).unwrap(), expected);
        assert_eq!(records(b"1, \"2,3\" ,4").unwrap(), [["1", "2,3", "4"]]);
    }

    #[test]
    fn malformed_records_are_refused() {
        assert_eq!(records(b"a\n\"b"), Err((2, FormatFault::OpenQuote)));
        assert_eq!(records(b"a\n\xFF\n"), Err((2, FormatFault::NotText)));
        assert_eq!(records(&vec![b'1'; MAX_RECORD_BYTES + 2]), Err((1, FormatFault::TooLong)));
        assert_eq!(records(b""), Ok(Vec::new()));
    }
}
