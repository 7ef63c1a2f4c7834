//! Bounds check of Parquet headers before the reader allocates memory for the stated sizes. Headers are records
//! in Thrift's compact protocol (apache/thrift, doc/specs/thrift-compact-protocol.md; apache/parquet-format,
//! parquet.thrift). The check scans each record without storing data.
//!
//! The metadata of the crate `parquet` (60.1) are not enough: their decoder overflows the stack on 20,000 nested columns (a
//! footer of 160 kB), and they do not give the sizes in page headers (1 GB is allocated for a page of 17 bytes).

use crate::limits::parquet::{MAX_COLUMN_DEPTH, MAX_METADATA_LIST};

/// Largest nesting depth of structures; Parquet uses six levels.
const MAX_STRUCT_DEPTH: usize = 16;

/// Fault of a header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum HeaderFault {
    /// The bytes end inside the header.
    Truncated,
    /// Malformed header, with the cause.
    Malformed(&'static str),
}

/// Sizes stated by a page header.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct PageBounds {
    /// Size in the file, bytes.
    pub compressed: u64,
    /// Size after decompression, bytes.
    pub uncompressed: u64,
}

/// Event of the scan of a header. The path of an event consists of the enclosing field ids; lists add no
/// element.
enum HeaderEvent {
    /// Start of a structure.
    Structure,
    /// Integer field.
    Number(i64),
}

/// Reads the sizes in the page header at the start of `bytes`, and checks all its numbers.
pub(crate) fn read_page_bounds(bytes: &[u8]) -> Result<PageBounds, HeaderFault> {
    let (mut page, mut entries, mut levels) = (PageBounds::default(), 0, 0);
    let mut visit = |path: &[i16], event: HeaderEvent| {
        let HeaderEvent::Number(number) = event else { return Ok(()) };
        // Fields 1 to 3: kind and sizes; field 4: checksum; fields 5, 7 and 8: headers of the kinds of pages.
        if matches!(path, [1..=3] | [5 | 7 | 8, _]) && !(0..=i64::from(i32::MAX / 2)).contains(&number) {
            return Err(HeaderFault::Malformed("a page's header has a number that is out of range"));
        }
        let number = u64::try_from(number).unwrap_or_default();
        match path {
            [2] => page.uncompressed = number,
            [3] => page.compressed = number,
            [7, 1] => entries = number,
            [8, 5 | 6] => levels += number,
            _ => {}
        }
        Ok(())
    };
    CompactReader { rest: bytes }.read_structure(&mut Vec::new(), &mut visit)?;
    // Each value takes at least four bytes.
    if 4 * entries > page.uncompressed {
        return Err(HeaderFault::Malformed("a dictionary is shorter than the number of its entries"));
    }
    if levels > page.uncompressed {
        return Err(HeaderFault::Malformed("a page is shorter than its levels"));
    }
    Ok(page)
}

/// Number of values stated by a DELTA_BINARY_PACKED page: the third number, after the block size and the number of
/// miniblocks. 0 if the page is too short.
pub(crate) fn delta_value_count(bytes: &[u8]) -> u64 {
    let mut head = CompactReader { rest: bytes };
    let third = head.read_unsigned().and_then(|_| head.read_unsigned()).and_then(|_| head.read_unsigned());
    third.unwrap_or(0)
}

/// Checks the file metadata in the footer.
pub(crate) fn check_file_metadata(bytes: &[u8]) -> Result<(), HeaderFault> {
    let mut children: Vec<i64> = Vec::new();
    let mut visit = |path: &[i16], event: HeaderEvent| {
        match (path, event) {
            // Columns in depth-first order, each with the number of its children.
            ([2], HeaderEvent::Structure) => children.push(0),
            ([2, 5], HeaderEvent::Number(number)) => {
                if let Some(last_count) = children.last_mut() {
                    *last_count = number;
                }
            }
            // Offsets and sizes of the data in row groups.
            ([4, 1, 3, 5..=7 | 9 | 11] | [4, 3], HeaderEvent::Number(number)) if number < 0 => {
                return Err(HeaderFault::Malformed("a column has a negative size or place"));
            }
            _ => {}
        }
        Ok(())
    };
    CompactReader { rest: bytes }.read_structure(&mut Vec::new(), &mut visit)?;
    check_column_tree(&children)
}

/// Checks that columns with these numbers of children, in depth-first order, form a tree of limited depth.
fn check_column_tree(children: &[i64]) -> Result<(), HeaderFault> {
    const NO_TREE: HeaderFault = HeaderFault::Malformed("its columns do not fit into one another");
    let mut open_parents: Vec<i64> = Vec::new();
    for (index, &count) in children.iter().enumerate() {
        match open_parents.last_mut() {
            Some(remaining) => *remaining -= 1,
            None if index > 0 => return Err(NO_TREE),
            None => {}
        }
        if !(0..children.len() as i64).contains(&count) {
            return Err(NO_TREE);
        }
        if count > 0 {
            open_parents.push(count);
        }
        while open_parents.last() == Some(&0) {
            open_parents.pop();
        }
        if open_parents.len() > MAX_COLUMN_DEPTH {
            return Err(HeaderFault::Malformed("its columns are nested too deep"));
        }
    }
    if open_parents.is_empty() { Ok(()) } else { Err(NO_TREE) }
}

/// Reader of records in the compact protocol.
struct CompactReader<'b> {
    rest: &'b [u8],
}

/// Receives the path and the event; an error ends the scan.
type HeaderVisitor<'v> = dyn FnMut(&[i16], HeaderEvent) -> Result<(), HeaderFault> + 'v;

impl CompactReader<'_> {
    /// Reads a byte.
    fn read_byte(&mut self) -> Result<u8, HeaderFault> {
        let (first, rest) = self.rest.split_first().ok_or(HeaderFault::Truncated)?;
        self.rest = rest;
        Ok(*first)
    }

    /// Skips bytes.
    fn skip(&mut self, bytes: u64) -> Result<(), HeaderFault> {
        let rest = usize::try_from(bytes).ok().and_then(|bytes| self.rest.get(bytes..));
        self.rest = rest.ok_or(HeaderFault::Truncated)?;
        Ok(())
    }

    /// Reads an unsigned varint, seven bits per byte.
    fn read_unsigned(&mut self) -> Result<u64, HeaderFault> {
        let mut number = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.read_byte()?;
            number |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Ok(number);
            }
        }
        Err(HeaderFault::Malformed("a number has too many digits"))
    }

    /// Reads a signed varint in zigzag encoding: 0, -1, 1, -2, …
    fn read_signed(&mut self) -> Result<i64, HeaderFault> {
        let number = self.read_unsigned()?;
        Ok((number >> 1).cast_signed() ^ -(number & 1).cast_signed())
    }

    /// Reads a Thrift structure; `visit` receives its fields by path.
    fn read_structure(
        &mut self,
        path: &mut Vec<i16>,
        visit: &mut HeaderVisitor<'_>,
    ) -> Result<(), HeaderFault> {
        if path.len() >= MAX_STRUCT_DEPTH {
            return Err(HeaderFault::Malformed("its structures are nested too deep"));
        }
        visit(path, HeaderEvent::Structure)?;
        let mut last = 0_i64;
        loop {
            let head = self.read_byte()?;
            if head == 0 {
                return Ok(());
            }
            let id = match head >> 4 {
                0 => self.read_signed()?,
                step => last + i64::from(step),
            };
            // Writers follow the order of the definition. Repeated fields are rejected, because the reader
            // would count only one of them.
            let field = i16::try_from(id).ok().filter(|id| i64::from(*id) > last);
            let field = field.ok_or(HeaderFault::Malformed("its fields are out of order"))?;
            last = id;
            path.push(field);
            // The kind of a boolean field holds the value.
            if !matches!(head & 0x0f, 1 | 2) {
                self.read_value(head & 0x0f, path, visit)?;
            }
            path.pop();
        }
    }

    /// Reads or skips a value of a Thrift type.
    fn read_value(
        &mut self,
        kind: u8,
        path: &mut Vec<i16>,
        visit: &mut HeaderVisitor<'_>,
    ) -> Result<(), HeaderFault> {
        match kind {
            1..=3 => self.skip(1),
            4..=6 => {
                let number = self.read_signed()?;
                visit(path, HeaderEvent::Number(number))
            }
            7 => self.skip(8),
            8 => {
                let length = self.read_unsigned()?;
                self.skip(length)
            }
            9 | 10 => {
                let head = self.read_byte()?;
                let length = if head >> 4 == 15 { self.read_unsigned()? } else { u64::from(head >> 4) };
                if length > MAX_METADATA_LIST {
                    return Err(HeaderFault::Malformed(
                        "it has more columns, or groups of rows, than are read",
                    ));
                }
                (0..length).try_for_each(|_| self.read_value(head & 0x0f, path, visit))
            }
            12 => self.read_structure(path, visit),
            13 => self.skip(16),
            _ => Err(HeaderFault::Malformed("it has a field of no known kind")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Header of a data page: 80 bytes, 40 bytes in the file, ten values of encoding 0.
    const PAGE: [u8; 16] = [0x15, 0, 0x15, 160, 1, 0x15, 80, 0x2c, 0x15, 20, 0x15, 0, 0x15, 6, 0, 0];

    #[test]
    fn sizes_are_read() {
        assert_eq!(read_page_bounds(&PAGE), Ok(PageBounds { compressed: 40, uncompressed: 80 }));
        for end in 0..PAGE.len() {
            assert_eq!(read_page_bounds(&PAGE[..end]), Err(HeaderFault::Truncated), "{end}");
        }
    }

    #[test]
    fn what_is_out_of_bounds_is_refused() {
        // Field 2 twice, the second time with an explicit id.
        let twice = [0x15, 0, 0x15, 2, 0x05, 4, 2, 0];
        assert_eq!(read_page_bounds(&twice), Err(HeaderFault::Malformed("its fields are out of order")));
        let negative = [0x15, 0, 0x15, 1, 0];
        assert!(
            matches!(read_page_bounds(&negative), Err(HeaderFault::Malformed(why)) if why.contains("out of range"))
        );
        // Dictionary of a hundred entries in eight bytes.
        let dictionary = [0x15, 4, 0x15, 16, 0x15, 16, 0x4c, 0x15, 200, 1, 0, 0];
        assert!(
            matches!(read_page_bounds(&dictionary), Err(HeaderFault::Malformed(why)) if why.contains("entries"))
        );
        let deep = [0x1c; 64];
        assert_eq!(
            read_page_bounds(&deep),
            Err(HeaderFault::Malformed("its structures are nested too deep"))
        );
        let long = [0x29, 0xfc, 0xff, 0xff, 0xff, 0x7f];
        assert!(
            matches!(check_file_metadata(&long), Err(HeaderFault::Malformed(why)) if why.contains("more columns"))
        );
    }

    #[test]
    fn columns_are_a_tree() {
        assert_eq!(check_column_tree(&[2, 0, 1, 0]), Ok(()));
        assert_eq!(check_column_tree(&[]), Ok(()));
        for wrong in [&[2, 0][..], &[1, 0, 0], &[-1], &[3, 0, 0], &[i64::MAX, 0]] {
            assert!(check_column_tree(wrong).is_err(), "{wrong:?}");
        }
        let mut deep = vec![1; 1000];
        deep.push(0);
        assert_eq!(check_column_tree(&deep), Err(HeaderFault::Malformed("its columns are nested too deep")));
    }
}
