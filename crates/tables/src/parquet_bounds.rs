//! Bounds check of Parquet headers before the reader allocates memory for the stated sizes. Headers are records
//! in Thrift's compact protocol (apache/thrift, doc/specs/thrift-compact-protocol.md; apache/parquet-format,
//! parquet.thrift). The check scans each record without storing data.

use crate::limits::parquet::{DEEPEST_COLUMN, LONGEST_METADATA_LIST};

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
    Structure,
    Number(i64),
}

/// Checks the page header at the start of `bytes`.
pub(crate) fn page(bytes: &[u8]) -> Result<PageBounds, HeaderFault> {
    let (mut page, mut entries, mut levels) = (PageBounds::default(), 0, 0);
    let mut visit = |path: &[i16], met: HeaderEvent| {
        let HeaderEvent::Number(number) = met else { return Ok(()) };
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
    CompactReader { rest: bytes }.structure(&mut Vec::new(), &mut visit)?;
    // Each value takes at least four bytes.
    if 4 * entries > page.uncompressed {
        return Err(HeaderFault::Malformed("a dictionary is shorter than the number of its entries"));
    }
    if levels > page.uncompressed {
        return Err(HeaderFault::Malformed("a page is shorter than its levels"));
    }
    Ok(page)
}

/// Number of values stated by a DELTA_BINARY_PACKED page: third number, after block size and number of
/// miniblocks.
pub(crate) fn delta_value_count(bytes: &[u8]) -> u64 {
    let mut head = CompactReader { rest: bytes };
    let third = head.read_unsigned().and_then(|_| head.read_unsigned()).and_then(|_| head.read_unsigned());
    third.unwrap_or(0)
}

/// Checks the file metadata in the footer.
pub(crate) fn check_file_metadata(bytes: &[u8]) -> Result<(), HeaderFault> {
    let mut children: Vec<i64> = Vec::new();
    let mut visit = |path: &[i16], met: HeaderEvent| {
        match (path, met) {
            // Columns in depth-first order, each with the number of its children.
            ([2], HeaderEvent::Structure) => children.push(0),
            ([2, 5], HeaderEvent::Number(number)) => {
                if let Some(of_last) = children.last_mut() {
                    *of_last = number;
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
    CompactReader { rest: bytes }.structure(&mut Vec::new(), &mut visit)?;
    nesting(&children)
}

/// Checks that columns with these numbers of children, in depth-first order, form a tree of limited depth.
fn nesting(children: &[i64]) -> Result<(), HeaderFault> {
    const NO_TREE: HeaderFault = HeaderFault::Malformed("its columns do not fit into one another");
    let mut open: Vec<i64> = Vec::new();
    for (at, &count) in children.iter().enumerate() {
        match open.last_mut() {
            Some(left) => *left -= 1,
            None if at > 0 => return Err(NO_TREE),
            None => {}
        }
        if !(0..children.len() as i64).contains(&count) {
            return Err(NO_TREE);
        }
        if count > 0 {
            open.push(count);
        }
        while open.last() == Some(&0) {
            open.pop();
        }
        if open.len() > DEEPEST_COLUMN {
            return Err(HeaderFault::Malformed("its columns are nested too deep"));
        }
    }
    if open.is_empty() { Ok(()) } else { Err(NO_TREE) }
}

/// Reader of bytes in the compact protocol.
struct CompactReader<'b> {
    rest: &'b [u8],
}

type HeaderVisitor<'v> = dyn FnMut(&[i16], HeaderEvent) -> Result<(), HeaderFault> + 'v;

impl CompactReader<'_> {
    /// Reads a byte.
    fn byte(&mut self) -> Result<u8, HeaderFault> {
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

    /// Unsigned varint, seven bits per byte.
    fn read_unsigned(&mut self) -> Result<u64, HeaderFault> {
        let mut number = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            number |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Ok(number);
            }
        }
        Err(HeaderFault::Malformed("a number has too many digits"))
    }

    /// Signed varint in zigzag encoding: 0, -1, 1, -2, …
    fn signed(&mut self) -> Result<i64, HeaderFault> {
        let number = self.read_unsigned()?;
        Ok((number >> 1).cast_signed() ^ -(number & 1).cast_signed())
    }

    /// Reads a Thrift structure; `visit` receives its fields by path.
    fn structure(&mut self, path: &mut Vec<i16>, visit: &mut HeaderVisitor<'_>) -> Result<(), HeaderFault> {
        if path.len() >= MAX_STRUCT_DEPTH {
            return Err(HeaderFault::Malformed("its structures are nested too deep"));
        }
        visit(path, HeaderEvent::Structure)?;
        let mut last = 0_i64;
        loop {
            let head = self.byte()?;
            if head == 0 {
                return Ok(());
            }
            let id = match head >> 4 {
                0 => self.signed()?,
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
                self.value(head & 0x0f, path, visit)?;
            }
            path.pop();
        }
    }

    /// Reads or skips a value of a Thrift type.
    fn value(
        &mut self,
        kind: u8,
        path: &mut Vec<i16>,
        visit: &mut HeaderVisitor<'_>,
    ) -> Result<(), HeaderFault> {
        match kind {
            1..=3 => self.skip(1),
            4..=6 => {
                let number = self.signed()?;
                visit(path, HeaderEvent::Number(number))
            }
            7 => self.skip(8),
            8 => {
                let length = self.read_unsigned()?;
                self.skip(length)
            }
            9 | 10 => {
                let head = self.byte()?;
                let length = if head >> 4 == 15 { self.read_unsigned()? } else { u64::from(head >> 4) };
                if length > LONGEST_METADATA_LIST {
                    return Err(HeaderFault::Malformed(
                        "it has more columns, or groups of rows, than are read",
                    ));
                }
                (0..length).try_for_each(|_| self.value(head & 0x0f, path, visit))
            }
            12 => self.structure(path, visit),
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
        assert_eq!(page(&PAGE), Ok(PageBounds { compressed: 40, uncompressed: 80 }));
        for end in 0..PAGE.len() {
            assert_eq!(page(&PAGE[..end]), Err(HeaderFault::Truncated), "{end}");
        }
    }

    #[test]
    fn what_is_out_of_bounds_is_refused() {
        // Field 2 twice, the second time with an explicit id.
        let twice = [0x15, 0, 0x15, 2, 0x05, 4, 2, 0];
        assert_eq!(page(&twice), Err(HeaderFault::Malformed("its fields are out of order")));
        let negative = [0x15, 0, 0x15, 1, 0];
        assert!(matches!(page(&negative), Err(HeaderFault::Malformed(why)) if why.contains("out of range")));
        // Dictionary of a hundred entries in eight bytes.
        let dictionary = [0x15, 4, 0x15, 16, 0x15, 16, 0x4c, 0x15, 200, 1, 0, 0];
        assert!(matches!(page(&dictionary), Err(HeaderFault::Malformed(why)) if why.contains("entries")));
        let deep = [0x1c; 64];
        assert_eq!(page(&deep), Err(HeaderFault::Malformed("its structures are nested too deep")));
        let long = [0x29, 0xfc, 0xff, 0xff, 0xff, 0x7f];
        assert!(
            matches!(check_file_metadata(&long), Err(HeaderFault::Malformed(why)) if why.contains("more columns"))
        );
    }

    #[test]
    fn columns_are_a_tree() {
        assert_eq!(nesting(&[2, 0, 1, 0]), Ok(()));
        assert_eq!(nesting(&[]), Ok(()));
        for wrong in [&[2, 0][..], &[1, 0, 0], &[-1], &[3, 0, 0], &[i64::MAX, 0]] {
            assert!(nesting(wrong).is_err(), "{wrong:?}");
        }
        let mut deep = vec![1; 1000];
        deep.push(0);
        assert_eq!(nesting(&deep), Err(HeaderFault::Malformed("its columns are nested too deep")));
    }
}
