//! Bytes of a Parquet file for the reader, after a bounds check of the headers. Pages are read one at a time,
//! and their size is limited.

use crate::format_fault::FormatFault;
use crate::limits::parquet::{MAX_METADATA_BYTES, MAX_PAGE_HEADER, USUAL_PAGE_HEADER};
use crate::parquet_bounds::{self as bounds, HeaderFault};
use crate::parquet_file::ParquetStorage;
use bytes::Bytes;
use parquet::basic::Encoding;
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::{ParquetMetaData, ParquetMetaDataReader};
use parquet::file::reader::{ChunkReader, Length};
use parquet::file::serialized_reader::SerializedPageReader;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::sync::PoisonError;

/// Parquet file with a limit of its page size.
pub(crate) struct ParquetSource {
    storage: ParquetStorage,
    length: u64,
    /// Largest allowed size of a page, bytes, in the file or in memory.
    max_page_size: u64,
}

impl ParquetSource {
    /// Determines the length of the file.
    pub fn new(storage: ParquetStorage) -> io::Result<Self> {
        let length = match &storage {
            ParquetStorage::File(file) => {
                file.lock().unwrap_or_else(PoisonError::into_inner).metadata()?.len()
            }
            ParquetStorage::Memory(bytes) => bytes.len() as u64,
        };
        Ok(Self { storage, length, max_page_size: 0 })
    }

    /// Sets the largest allowed size of a page, bytes.
    pub fn set_max_page_size(&mut self, max_page_size: u64) {
        self.max_page_size = max_page_size;
    }

    /// Reads up to `count` bytes from the offset `start` on; fewer at the end of the file.
    fn read_bytes(&self, start: u64, count: u64) -> io::Result<Vec<u8>> {
        let count = count.min(self.length.saturating_sub(start));
        match &self.storage {
            ParquetStorage::File(file) => {
                let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
                file.seek(SeekFrom::Start(start))?;
                let mut bytes = Vec::new();
                (&mut *file).take(count).read_to_end(&mut bytes)?;
                Ok(bytes)
            }
            ParquetStorage::Memory(bytes) => {
                // Start and count are at most the length of the slice.
                let start = usize::try_from(start).unwrap_or(usize::MAX).min(bytes.len());
                let count = usize::try_from(count).unwrap_or_default();
                Ok(bytes[start..start + count].to_vec())
            }
        }
    }

    /// File metadata (columns and row groups) from the footer.
    pub fn read_metadata(&self) -> Result<ParquetMetaData, FormatFault> {
        let unreadable = |error: io::Error| FormatFault::from(&error);
        let end = self.read_bytes(self.length.saturating_sub(8), 8).map_err(unreadable)?;
        let begin = self.read_bytes(0, 4).map_err(unreadable)?;
        let (length, mark) = match end[..] {
            [a, b, c, d, ref mark @ ..] if mark.len() == 4 => (u32::from_le_bytes([a, b, c, d]), mark),
            _ => return Err(FormatFault::NoParquet),
        };
        match (&begin[..], mark) {
            (b"PAR1", b"PAR1") => {}
            (b"PARE", _) | (_, b"PARE") => return Err(FormatFault::Encrypted),
            _ => return Err(FormatFault::NoParquet),
        }
        let length = u64::from(length);
        let malformed = |why: String| FormatFault::Malformed { why };
        let Some(start) = self.length.checked_sub(12 + length).map(|start| start + 4) else {
            return Err(malformed("the description of its columns is longer than the file".into()));
        };
        if length > MAX_METADATA_BYTES {
            return Err(malformed(format!(
                "the description of its columns has {length} bytes; expected {MAX_METADATA_BYTES} at most"
            )));
        }
        let bytes = self.read_bytes(start, length).map_err(unreadable)?;
        bounds::check_file_metadata(&bytes).map_err(|fault| malformed(header_fault_text(fault)))?;
        ParquetMetaDataReader::decode_metadata(&bytes).map_err(|error| malformed(reader_error_text(error)))
    }
}

/// Text of a header fault.
fn header_fault_text(fault: HeaderFault) -> String {
    match fault {
        HeaderFault::Truncated => "it ends too early".into(),
        HeaderFault::Malformed(why) => why.into(),
    }
}

/// Text of a reader error, without the kind of the error.
pub(crate) fn reader_error_text(error: ParquetError) -> String {
    match error {
        ParquetError::General(why) | ParquetError::NYI(why) | ParquetError::EOF(why) => why,
        other => other.to_string(),
    }
}

impl Length for ParquetSource {
    fn len(&self) -> u64 {
        self.length
    }
}

impl ChunkReader for ParquetSource {
    type T = Cursor<Bytes>;

    /// Bytes from a page header on, after a check of the sizes in the header.
    fn get_read(&self, start: u64) -> Result<Self::T> {
        for header_size in [USUAL_PAGE_HEADER, MAX_PAGE_HEADER] {
            let bytes = self.read_bytes(start, header_size)?;
            match bounds::read_page_bounds(&bytes) {
                Ok(page) if page.uncompressed.max(page.compressed) > self.max_page_size => {
                    let got = page.uncompressed.max(page.compressed);
                    return Err(ParquetError::General(format!(
                        "a page has {got} bytes; expected {} at most: write it with smaller pages",
                        self.max_page_size
                    )));
                }
                Ok(_) => return Ok(Cursor::new(bytes.into())),
                Err(HeaderFault::Truncated)
                    if bytes.len() as u64 == header_size && header_size < MAX_PAGE_HEADER => {}
                Err(fault) => return Err(ParquetError::General(header_fault_text(fault))),
            }
        }
        Err(ParquetError::General(header_fault_text(HeaderFault::Truncated)))
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        let bytes = self.read_bytes(start, length as u64)?;
        if bytes.len() == length {
            Ok(bytes.into())
        } else {
            Err(ParquetError::EOF(header_fault_text(HeaderFault::Truncated)))
        }
    }
}

/// Pages of a column. Each page is checked for properties that the reader assumes without a check.
pub(crate) struct CheckedPages {
    pages: SerializedPageReader<ParquetSource>,
    /// True if nulls are possible; pages then begin with definition levels.
    has_levels: bool,
    /// Size of a value, bytes.
    value_size: usize,
    has_dictionary: bool,
}

impl CheckedPages {
    pub fn new(pages: SerializedPageReader<ParquetSource>, has_levels: bool, value_size: usize) -> Self {
        Self { pages, has_levels, value_size, has_dictionary: false }
    }

    /// Refuses a page whose levels or encoding the decoder would not check.
    fn check_page(&mut self, page: &Page) -> Result<()> {
        let invalid = |why: &str| Err(ParquetError::General(why.into()));
        // Number of values including nulls, and the bytes after the levels.
        let (count, bytes) = match page {
            Page::DictionaryPage { encoding, .. } => {
                if std::mem::replace(&mut self.has_dictionary, true) {
                    return invalid("a column has two dictionaries");
                }
                if !matches!(encoding, Encoding::PLAIN | Encoding::PLAIN_DICTIONARY) {
                    return invalid("a dictionary has an invalid encoding");
                }
                return Ok(());
            }
            Page::DataPage { buf, num_values, def_level_encoding, .. } => {
                if self.has_levels && *def_level_encoding != Encoding::RLE {
                    return invalid(
                        "a page's levels are not in runs; expected what version 2 of the format has",
                    );
                }
                let length = buf.first_chunk().map(|length| 4 + u64::from(u32::from_le_bytes(*length)));
                (*num_values, if self.has_levels { skip_bytes(buf, length) } else { Some(&buf[..]) })
            }
            Page::DataPageV2 {
                buf, num_values, num_nulls, def_levels_byte_len, rep_levels_byte_len, ..
            } => {
                let levels = u64::from(*def_levels_byte_len) + u64::from(*rep_levels_byte_len);
                (*num_values, skip_bytes(buf, Some(levels)).filter(|_| num_nulls <= num_values))
            }
        };
        let Some(bytes) = bytes else { return invalid("a page is shorter than its levels") };
        match page.encoding() {
            Encoding::PLAIN => Ok(()),
            Encoding::BYTE_STREAM_SPLIT if bytes.len() == count as usize * self.value_size => Ok(()),
            Encoding::BYTE_STREAM_SPLIT => {
                invalid("a page has another number of values than rows: nulls, or damage")
            }
            Encoding::DELTA_BINARY_PACKED if bounds::delta_value_count(bytes) > 0 || count == 0 => Ok(()),
            Encoding::DELTA_BINARY_PACKED => invalid("a page has no values"),
            Encoding::RLE_DICTIONARY | Encoding::PLAIN_DICTIONARY if self.has_dictionary => Ok(()),
            Encoding::RLE_DICTIONARY | Encoding::PLAIN_DICTIONARY => {
                invalid("a page refers to a dictionary that its column does not have")
            }
            other => Err(ParquetError::General(format!(
                "a page is encoded as {other}, which is invalid for \
                numbers"
            ))),
        }
    }
}

/// Bytes after the first `count`; `None` if there are fewer.
fn skip_bytes(bytes: &[u8], count: Option<u64>) -> Option<&[u8]> {
    bytes.get(usize::try_from(count?).ok()?..)
}

impl Iterator for CheckedPages {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for CheckedPages {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let page = self.pages.get_next_page()?;
        if let Some(page) = &page {
            self.check_page(page)?;
        }
        Ok(page)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.pages.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.pages.skip_next_page()
    }
}
