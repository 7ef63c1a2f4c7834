//! Fuzzes the reader that `PERCUSS_READER` names: see run.sh.
#![no_main]

use libfuzzer_sys::fuzz_target;
use percuss_tests::readers::read;
use std::sync::LazyLock;

static READER: LazyLock<String> =
    LazyLock::new(|| std::env::var("PERCUSS_READER").expect("PERCUSS_READER names a reader"));

fuzz_target!(|bytes: &[u8]| {
    read(&READER, bytes);
});
