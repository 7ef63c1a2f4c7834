//! Reader of comma-separated text (RFC 4180), record by record, in bounded memory.

use crate::question::table_error::{TableError, TableFault};
use crate::thresholds::LONGEST_RECORD;
use std::io::{BufRead, Read};
use std::ops::Range;

/// Records of a text with their line numbers.
pub(crate) struct CsvRecords<R> {
    input: R,
    path: String,
    /// Number of the next line, from 1.
    next: usize,
    /// First line of the last record.
    pub line: usize,
    bytes: Vec<u8>,
    text: String,
    cells: Vec<Range<usize>>,
}

impl<R: BufRead> CsvRecords<R> {
    pub fn new(input: R, path: &str) -> Self {
        let (bytes, text, cells) = (Vec::new(), String::new(), Vec::new());
        Self { input, path: path.to_owned(), next: 1, line: 0, bytes, text, cells }
    }

    /// Name of the file.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Cells of the last record, without quotes.
    pub fn cells(&self) -> impl ExactSizeIterator<Item = &str> {
        self.cells.iter().map(|cell| &self.text[cell.clone()])
    }

    /// Reads the next record that is not an empty line; false at the end.
    pub fn read(&mut self) -> Result<bool, TableError> {
        loop {
            self.bytes.clear();
            self.line = self.next;
            if !self.append_line()? {
                return Ok(false);
            }
            // A line break within quotes belongs to a cell. Each byte is examined once.
            let (mut in_quotes, mut counted) = (false, 0);
            loop {
                in_quotes ^= self.bytes[counted..].iter().filter(|byte| **byte == b'"').count() % 2 == 1;
                counted = self.bytes.len();
                if !in_quotes {
                    break;
                }
                if !self.append_line()? {
                    return Err(self.record_error(TableFault::OpenQuote));
                }
            }
            while self.bytes.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r')) {
                self.bytes.pop();
            }
            let mark: &[u8] = if self.line == 1 { b"\xEF\xBB\xBF" } else { b"" };
            let bytes = self.bytes.strip_prefix(mark).unwrap_or(&self.bytes);
            if bytes.is_empty() {
                continue;
            }
            let Ok(text) = std::str::from_utf8(bytes) else {
                return Err(self.record_error(TableFault::NotText));
            };
            self.text.clear();
            self.cells.clear();
            split(text, &mut self.text, &mut self.cells);
            return Ok(true);
        }
    }

    /// Appends a line to the bytes; false at the end.
    fn append_line(&mut self) -> Result<bool, TableError> {
        let bytes_left = (LONGEST_RECORD + 1).saturating_sub(self.bytes.len()) as u64;
        let read = self.input.by_ref().take(bytes_left).read_until(b'\n', &mut self.bytes);
        let read = read.map_err(|error| TableError::unreadable(&self.path, &error))?;
        if self.bytes.len() > LONGEST_RECORD {
            return Err(self.record_error(TableFault::TooLong));
        }
        self.next += 1;
        Ok(read > 0)
    }

    /// Error of the last record.
    pub fn record_error(&self, fault: TableFault) -> TableError {
        TableError::at_line(&self.path, self.line, fault)
    }
}

/// Splits a record: `text` receives the cells in order, without quotes and surrounding blanks.
fn split(record: &str, text: &mut String, cells: &mut Vec<Range<usize>>) {
    let mut rest = record;
    loop {
        let begins = text.len();
        let after = match rest.trim_start().strip_prefix('"') {
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
        let (own, more) = match after.split_once(',') {
            Some((own, more)) => (own, Some(more)),
            None => (after, None),
        };
        text.push_str(own.trim());
        cells.push(begins..text.len());
        match more {
            Some(more) => rest = more,
            None => return,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn records(text: &[u8]) -> Result<Vec<Vec<String>>, TableError> {
        let mut records = CsvRecords::new(text, "t.csv");
        let mut found = Vec::new();
        while records.read()? {
            found.push(records.cells().map(str::to_owned).collect());
        }
        Ok(found)
    }

    #[test]
    fn cells_are_split() {
        let text = b"\xEF\xBB\xBFa, b ,\"c,\"\"d\"\"\"\r\n\r\n1,,\n\"x\ny\",2,3";
        let expected = [["a", "b", "c,\"d\""], ["1", "", ""], ["x\ny", "2", "3"]];
        assert_eq!(records(text).unwrap(), expected);
    }

    #[test]
    fn what_is_no_table_is_refused() {
        assert!(records(b"a\n\"b").unwrap_err().to_string().contains("t.csv:2: a quote is not closed"));
        assert!(records(b"a\n\xFF\n").unwrap_err().to_string().contains("t.csv:2: not UTF-8 text"));
        let long = vec![b'1'; LONGEST_RECORD + 2];
        assert!(records(&long).unwrap_err().to_string().contains("t.csv:1: the line is longer than"));
        assert_eq!(records(b"").unwrap(), Vec::<Vec<String>>::new());
    }
}
