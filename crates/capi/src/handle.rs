//! Handles: what C holds of an object.
//!
//! The functions here and in `arrays` take pointers as C gives them and trust them as far as the contract of the C function says that was
//! called ("Pointers" in the header): they are called by such functions alone, with that function's own arguments.

use crate::status::{
    Failure, PERCUSS_ERROR_BUSY, PERCUSS_ERROR_HANDLE, PERCUSS_ERROR_INTERNAL, PERCUSS_ERROR_NULL,
};
use std::sync::{Mutex, MutexGuard, TryLockError};

/// What a handle of C's stands for.
pub(crate) trait Handle {
    /// The object.
    type Object;
    /// A number that is in memory before the object: other handles have another one.
    const TAG: u64;
    /// The name of the type in C.
    const NAME: &'static str;
}

/// The number that replaces the tag of an object that was freed.
const FREED: u64 = 0x6672_6565_6421_2121;

/// An object as it lies in memory.
#[repr(C)]
struct Tagged<T> {
    tag: u64,
    object: T,
}

/// A place that an argument points to.
pub(crate) fn place<'a, T>(pointer: *mut T, name: &str) -> Result<&'a mut T, Failure> {
    check(pointer, name)?;
    // SAFETY: it is neither null nor misaligned; the caller of the C function promises that it points to a T of his own.
    Ok(unsafe { &mut *pointer })
}

/// A value that an argument points to.
pub(crate) fn value<T: Copy>(pointer: *const T, name: &str) -> Result<T, Failure> {
    check(pointer, name)?;
    // SAFETY: as above; the types that are read so are plain numbers, for which every bit pattern has a meaning.
    Ok(unsafe { *pointer })
}

/// The same, or none where it is null.
pub(crate) fn optional<T: Copy>(pointer: *const T, name: &str) -> Result<Option<T>, Failure> {
    if pointer.is_null() { Ok(None) } else { value(pointer, name).map(Some) }
}

fn check<T>(pointer: *const T, name: &str) -> Result<(), Failure> {
    if pointer.is_null() {
        return Err(Failure::new(PERCUSS_ERROR_NULL, format_args!("{name} is null")));
    }
    if !pointer.is_aligned() {
        return Err(Failure::new(PERCUSS_ERROR_NULL, format_args!("{name} is not aligned for its type")));
    }
    Ok(())
}

/// Hands an object out.
pub(crate) fn give<H: Handle>(object: H::Object, to: *mut *mut H) -> Result<(), Failure> {
    let to = place(to, "the place for the new handle")?;
    *to = Box::into_raw(Box::new(Tagged { tag: H::TAG, object })).cast();
    Ok(())
}

/// Sets the place for a new handle to null, so that none is there where the call fails.
pub(crate) fn clear<H: Handle>(to: *mut *mut H) -> Result<(), Failure> {
    *place(to, "the place for the new handle")? = std::ptr::null_mut();
    Ok(())
}

fn tagged<H: Handle>(handle: *const H) -> Result<*const Tagged<H::Object>, Failure> {
    let pointer: *const Tagged<H::Object> = handle.cast();
    check(pointer, H::NAME)?;
    // SAFETY: it is neither null nor misaligned; all handles begin with a tag. One that was freed must not be read: that it is noticed,
    // where its memory is still there, is a help and no promise.
    let tag = unsafe { pointer.cast::<u64>().read() };
    match tag {
        tag if tag == H::TAG => Ok(pointer),
        FREED => Err(Failure::new(PERCUSS_ERROR_HANDLE, format_args!("this {} was freed before", H::NAME))),
        _ => Err(Failure::new(PERCUSS_ERROR_HANDLE, format_args!("this is no handle of a {}", H::NAME))),
    }
}

/// The object of a handle.
#[inline]
pub(crate) fn get<'a, H: Handle>(handle: *const H) -> Result<&'a H::Object, Failure> {
    let pointer = tagged(handle)?;
    // SAFETY: the tag says that it is an object of this kind, made by `give`; the caller promises not to free it during the call. It is
    // only ever shared: what can be changed is behind a lock.
    Ok(unsafe { &(*pointer).object })
}

/// Frees the object of a handle and sets that to null; nothing where it is null already.
pub(crate) fn free<H: Handle>(handle: *mut *mut H) -> Result<(), Failure> {
    let handle = place(handle, "the place of the handle")?;
    if handle.is_null() {
        return Ok(());
    }
    let pointer = tagged(*handle)?.cast_mut();
    *handle = std::ptr::null_mut();
    // SAFETY: the tag says that `give` made it from a box, and that it was not freed; the caller promises that nobody uses it.
    let mut boxed = unsafe { Box::from_raw(pointer) };
    // SAFETY: it is the box's own. Volatile, so that it is written though nobody may read it.
    unsafe { std::ptr::addr_of_mut!(boxed.tag).write_volatile(FREED) };
    drop(boxed);
    Ok(())
}

/// Takes an object that can be changed for one call.
#[inline]
pub(crate) fn take<'a, T>(object: &'a Mutex<T>, name: &str) -> Result<MutexGuard<'a, T>, Failure> {
    object.try_lock().map_err(|error| match error {
        TryLockError::WouldBlock => Failure::new(
            PERCUSS_ERROR_BUSY,
            format_args!("another thread is using this {name}; give each thread its own"),
        ),
        TryLockError::Poisoned(_) => Failure::new(
            PERCUSS_ERROR_INTERNAL,
            format_args!("a call failed by a defect while it used this {name}; free it"),
        ),
    })
}
