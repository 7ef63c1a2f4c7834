//! Zero-terminated texts for C, and elements by number.

use crate::boundary::status::{Failure, PERCUSS_ERROR_NAME};
use std::ffi::CString;

/// Zero-terminated text. Zero bytes inside, which no valid name has, become U+FFFD.
pub(crate) fn c_string(text: &str) -> CString {
    CString::new(text.replace('\0', "\u{fffd}")).unwrap_or_default()
}

/// Element number `index`, from 0; `kind` names the element in messages.
pub(crate) fn element_at<'a, T>(list: &'a [T], index: usize, kind: &str) -> Result<&'a T, Failure> {
    list.get(index).ok_or_else(|| {
        let message = format_args!("there is no {kind} number {index}; there are {}, from 0", list.len());
        Failure::new(PERCUSS_ERROR_NAME, message)
    })
}
