//! Arrays and texts of the caller.

use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_NULL, PERCUSS_ERROR_OVERLAP,
    PERCUSS_ERROR_TEXT,
};
use std::ffi::{CStr, c_char};

/// Slice of `length` values of the caller; an empty array may be null.
#[inline]
pub(crate) fn input_slice<'a, T>(values: *const T, length: usize, name: &str) -> Result<&'a [T], Failure> {
    check_array(values, length, name)?;
    if length == 0 {
        return Ok(&[]);
    }
    // SAFETY: neither null nor misaligned, no larger than memory; the caller promises that `length` values are there.
    Ok(unsafe { std::slice::from_raw_parts(values, length) })
}

/// Mutable slice of `length` values of the caller; an empty array may be null.
pub(crate) fn output_slice<'a, T>(values: *mut T, length: usize, name: &str) -> Result<&'a mut [T], Failure> {
    check_array(values, length, name)?;
    if length == 0 {
        return Ok(&mut []);
    }
    // SAFETY: as above; the caller promises exclusive access during the call, and plain numbers, which have no invalid
    // bit pattern.
    Ok(unsafe { std::slice::from_raw_parts_mut(values, length) })
}

/// As [`output_slice`]; `None` for a null pointer.
pub(crate) fn optional_output_slice<'a, T>(
    values: *mut T,
    length: usize,
    name: &str,
) -> Result<Option<&'a mut [T]>, Failure> {
    if values.is_null() { Ok(None) } else { output_slice(values, length, name).map(Some) }
}

/// Checks a pointer to `length` values: not null unless `length` is 0, aligned, at most the size of memory.
#[inline]
fn check_array<T>(values: *const T, length: usize, name: &str) -> Result<(), Failure> {
    let fits = length <= isize::MAX as usize / size_of::<T>().max(1);
    if fits && !values.is_null() && values.is_aligned() {
        Ok(())
    } else {
        array_failure(values, length, fits, name)
    }
}

/// Error of an invalid array; no error for an empty array with a null pointer.
#[cold]
fn array_failure<T>(values: *const T, length: usize, fits: bool, name: &str) -> Result<(), Failure> {
    if !fits {
        let message = format_args!("{name}: {length} values are more than any memory holds");
        return Err(Failure::new(PERCUSS_ERROR_LENGTH, message));
    }
    if values.is_null() && length > 0 {
        return Err(Failure::new(
            PERCUSS_ERROR_NULL,
            format_args!("{name} is null; expected {length} values"),
        ));
    }
    if !values.is_null() && !values.is_aligned() {
        return Err(Failure::new(PERCUSS_ERROR_NULL, format_args!("{name} is not aligned for its type")));
    }
    Ok(())
}

/// Byte range of an array or of a single value of the caller.
#[derive(Clone, Copy)]
pub(crate) struct ByteRange {
    first: usize,
    bytes: usize,
    name: &'static str,
}

impl ByteRange {
    /// Byte range of `length` values; empty for a null pointer.
    #[inline]
    pub fn of_array<T>(values: *const T, length: usize, name: &'static str) -> Self {
        let length = if values.is_null() { 0 } else { length };
        Self { first: values as usize, bytes: length.saturating_mul(size_of::<T>()), name }
    }

    /// True if the two ranges share a byte.
    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        self.bytes > 0
            && other.bytes > 0
            && self.first < other.first.saturating_add(other.bytes)
            && other.first < self.first.saturating_add(self.bytes)
    }
}

/// Refuses output ranges that overlap each other or an input range.
#[inline]
pub(crate) fn refuse_overlaps(written: &[ByteRange], read: &[ByteRange]) -> Result<(), Failure> {
    for (i, own) in written.iter().enumerate() {
        if let Some(other) = written[i + 1..].iter().chain(read).find(|other| own.overlaps(other)) {
            return Err(overlap_failure(own.name, other.name));
        }
    }
    Ok(())
}

/// Error of two overlapping arrays.
#[cold]
fn overlap_failure(written: &str, other: &str) -> Failure {
    let message = format_args!(
        "{written} overlaps {other}; expected output arrays that share no memory with other arrays"
    );
    Failure::new(PERCUSS_ERROR_OVERLAP, message)
}

/// Refuses an array of the wrong length.
pub(crate) fn expect_length(got: usize, expected: usize, name: &str) -> Result<(), Failure> {
    if got == expected {
        return Ok(());
    }
    let message = format_args!("{name}: {got} values are given; expected {expected}");
    Err(Failure::new(PERCUSS_ERROR_LENGTH, message))
}

/// Copies values to an array of the caller, whose length must match.
pub(crate) fn copy_to_caller(from: &[f64], to: *mut f64, length: usize, name: &str) -> Result<(), Failure> {
    expect_length(length, from.len(), name)?;
    output_slice(to, length, name)?.copy_from_slice(from);
    Ok(())
}

/// UTF-8 string from a zero-terminated text of the caller.
pub(crate) fn input_text<'a>(text: *const c_char, name: &str) -> Result<&'a str, Failure> {
    if text.is_null() {
        return Err(Failure::new(PERCUSS_ERROR_NULL, format_args!("{name} is null")));
    }
    // SAFETY: not null; the caller promises that a zero byte ends it, and that it does not change during the call.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map_err(|_| Failure::new(PERCUSS_ERROR_TEXT, format_args!("{name} is not UTF-8")))
}

/// Value of an enumeration constant of C, which numbers `values` from 0.
pub(crate) fn enumeration_value<T: Copy>(values: &[T], number: i32, name: &str) -> Result<T, Failure> {
    usize::try_from(number).ok().and_then(|at| values.get(at)).copied().ok_or_else(|| {
        let most = values.len() - 1;
        Failure::new(PERCUSS_ERROR_ARGUMENT, format_args!("{name} is {number}; expected 0 to {most}"))
    })
}

/// The number; NaN for `None`.
pub(crate) fn nan_if_unknown(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}
