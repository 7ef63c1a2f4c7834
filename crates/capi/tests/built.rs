//! Folder of the libraries built by cargo.

use std::path::PathBuf;

/// The folder with `libpercuss_c.a` and `libpercuss_c.so`, which also holds the test program.
pub fn folder() -> PathBuf {
    let test = std::env::current_exe().expect("the path of this test");
    test.parent().expect("a folder").to_path_buf()
}
