//! Texts that C reads, kept as long as what they are of.

use crate::status::{Failure, PERCUSS_ERROR_NAME};
use std::ffi::CString;

/// A text with a zero byte at its end; a zero inside, which no name has, is replaced.
pub(crate) fn c_string(text: &str) -> CString {
    CString::new(text.replace('\0', "\u{fffd}")).unwrap_or_default()
}

/// One of a list by its number.
pub(crate) fn nth<'a, T>(list: &'a [T], index: usize, what: &str) -> Result<&'a T, Failure> {
    list.get(index).ok_or_else(|| {
        let message = format_args!("there is no {what} number {index}; there are {}, from 0", list.len());
        Failure::new(PERCUSS_ERROR_NAME, message)
    })
}
