//! Detection and storage of Parquet files.

use std::fs::File;
use std::io::Read;
use std::sync::{Arc, Mutex};

/// Length of the mark at both ends of a file, bytes. The kind of a file is decided by the mark and as many bytes behind it.
const MARK: usize = 4;

/// True for the first bytes of a Parquet file: the mark `PAR1` or `PARE`, then binary data. Text after the mark belongs to a
/// CSV header whose first joint has such a name.
pub fn begins_as_parquet(bytes: &[u8]) -> bool {
    let is_binary = |byte: &u8| byte.is_ascii_control() && !b"\t\r\n".contains(byte);
    let behind = &bytes[MARK.min(bytes.len())..(2 * MARK).min(bytes.len())];
    (bytes.starts_with(b"PAR1") || bytes.starts_with(b"PARE")) && behind.iter().any(is_binary)
}

/// True for a regular file that begins as a Parquet file. False for a file that cannot be read, and for pipes and devices, which
/// can be read only once.
pub fn is_parquet_file(path: &str) -> bool {
    let mut bytes = Vec::new();
    std::fs::metadata(path).is_ok_and(|found| found.is_file())
        && File::open(path)
            .and_then(|file| file.take(2 * MARK as u64).read_to_end(&mut bytes))
            .is_ok_and(|_| begins_as_parquet(&bytes))
}

/// Storage of the bytes.
#[derive(Debug)]
pub enum ParquetStorage {
    /// File on disk.
    File(Mutex<File>),
    /// Bytes in memory.
    Memory(Arc<[u8]>),
}
