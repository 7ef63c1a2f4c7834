//! Version of the library, which may be newer than the header.

use std::ffi::c_char;

const VERSION: &std::ffi::CStr =
    match std::ffi::CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => c"",
    };

/// The version of the library, such as "0.1.0". The header's version is PERCUSS_VERSION. While the first number is 0,
/// the second number changes with every change that requires programs to be recompiled.
#[unsafe(no_mangle)]
pub extern "C" fn percuss_version() -> *const c_char {
    VERSION.as_ptr()
}
