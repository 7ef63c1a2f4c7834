//! Zero-terminated texts for C, and elements by number.

use crate::status::{Failure, PERCUSS_ERROR_NAME};
use std::ffi::CString;

/// Zero-terminated text; zero bytes inside, which no valid name has, are replaced.
pub(crate) fn c_string(text: &str) -> CString {
    CString::new(text.replace('\0', "\u{fffd}")).unwrap_or_default()
}

/// Element of a list by its number.
pub(crate) fn element<'a, T>(list: &'a [T], index: usize, what: &str) -> Result<&'a T, Failure> {
    list.get(index).ok_or_else(|| {
        let message = format_args!("there is no {what} number {index}; there are {}, from 0", list.len());
        Failure::new(PERCUSS_ERROR_NAME, message)
    })
}
