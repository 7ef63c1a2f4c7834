//! Every reader on the seed files of the fuzzer, and on cut and changed copies: a file is read or refused, without a panic.

use percuss_tests::readers::{READERS, read};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Files of a reader, `tests/fuzz/corpus/READER/*`, sorted by name.
fn corpus(reader: &str) -> BTreeMap<String, Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(reader);
    let files = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let named = |entry: fs::DirEntry| {
        (entry.file_name().to_string_lossy().into_owned(), fs::read(entry.path()).expect("a file"))
    };
    files.flatten().map(named).collect()
}

#[test]
fn the_corpus_is_read_or_refused() {
    for reader in READERS {
        let files = corpus(reader);
        let accepted = files.values().filter(|bytes| read(reader, bytes)).count();
        assert!(files.len() >= 5, "{reader}: only {} files", files.len());
        assert!(
            accepted > 0,
            "{reader}: no file is accepted, so that nothing after the first check is tested"
        );
        assert!(accepted < files.len(), "{reader}: no file is refused");
    }
}

#[test]
fn files_that_end_anywhere_are_read_or_refused() {
    for reader in READERS {
        for bytes in corpus(reader).values() {
            for part in 1..8 {
                read(reader, &bytes[..bytes.len() * part / 8]);
            }
            for at in (0..bytes.len()).step_by(1 + bytes.len() / 8) {
                let mut changed = bytes.clone();
                changed[at] ^= 1 << (at % 8);
                read(reader, &changed);
            }
        }
    }
}
