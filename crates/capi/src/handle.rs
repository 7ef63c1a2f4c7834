//! Handles: what C holds of an object.
//!
//! The functions here and in `arrays` take pointers as C gives them and trust them as far as the contract of the C function says that was
//! called ("Pointers" in the header): they are called by such functions alone, with that function's own arguments.

use crate::status::{
    Failure, PERCUSS_ERROR_BUSY, PERCUSS_ERROR_HANDLE, PERCUSS_ERROR_INTERNAL, PERCUSS_ERROR_NULL,
};
use std::ops::{Deref, DerefMut};
use try_lock::{Locked, TryLock};

/// What a handle of C's stands for.
pub(crate) trait Handle {
    /// The object: calls from several threads share it.
    type Object: Send + Sync;
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
#[inline]
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

/// A value that an argument points to, where it lies.
#[inline]
pub(crate) fn lent<'a, T: Copy>(pointer: *const T, name: &str) -> Result<&'a T, Failure> {
    check(pointer, name)?;
    // SAFETY: as above; the caller of the C function promises that it does not change during the call.
    Ok(unsafe { &*pointer })
}

/// The same as `value`, or none where it is null.
pub(crate) fn optional<T: Copy>(pointer: *const T, name: &str) -> Result<Option<T>, Failure> {
    if pointer.is_null() { Ok(None) } else { value(pointer, name).map(Some) }
}

#[inline]
fn check<T>(pointer: *const T, name: &str) -> Result<(), Failure> {
    if pointer.is_null() || !pointer.is_aligned() { Err(no_place(pointer.is_null(), name)) } else { Ok(()) }
}

#[cold]
fn no_place(null: bool, name: &str) -> Failure {
    let fault = if null { "null" } else { "not aligned for its type" };
    Failure::new(PERCUSS_ERROR_NULL, format_args!("{name} is {fault}"))
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

#[inline]
fn tagged<H: Handle>(handle: *const H) -> Result<*const Tagged<H::Object>, Failure> {
    let pointer: *const Tagged<H::Object> = handle.cast();
    check(pointer, H::NAME)?;
    // SAFETY: it is neither null nor misaligned; all handles begin with a tag. One that was freed must not be read: that it is noticed,
    // where its memory is still there, is a help and no promise.
    let tag = unsafe { pointer.cast::<u64>().read() };
    if tag == H::TAG { Ok(pointer) } else { Err(no_handle(tag, H::NAME)) }
}

#[cold]
fn no_handle(tag: u64, name: &str) -> Failure {
    match tag {
        FREED => Failure::new(PERCUSS_ERROR_HANDLE, format_args!("this {name} was freed before")),
        _ => Failure::new(PERCUSS_ERROR_HANDLE, format_args!("this is no handle of a {name}")),
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

/// An object that can be changed, by one call at a time. It is never waited for, so that to give it back takes no more than a store.
pub(crate) struct Exclusive<T>(TryLock<Kept<T>>);

struct Kept<T> {
    /// A call failed by a defect while it used the object.
    broken: bool,
    object: T,
}

/// The object, for one call.
pub(crate) struct Taken<'a, T>(Locked<'a, Kept<T>>);

impl<T> Exclusive<T> {
    pub fn new(object: T) -> Self {
        Self(TryLock::new(Kept { broken: false, object }))
    }
}

impl<T> Deref for Taken<'_, T> {
    type Target = T;

    #[inline]
    fn deref(&self) -> &T {
        &self.0.object
    }
}

impl<T> DerefMut for Taken<'_, T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut T {
        &mut self.0.object
    }
}

impl<T> Drop for Taken<'_, T> {
    #[inline]
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.broken = true;
        }
    }
}

/// Takes an object that can be changed for one call.
#[inline]
pub(crate) fn take<'a, T>(object: &'a Exclusive<T>, name: &str) -> Result<Taken<'a, T>, Failure> {
    match object.0.try_lock() {
        Some(kept) if !kept.broken => Ok(Taken(kept)),
        found => Err(not_taken(found.is_some(), name)),
    }
}

#[cold]
fn not_taken(broken: bool, name: &str) -> Failure {
    match broken {
        true => Failure::new(
            PERCUSS_ERROR_INTERNAL,
            format_args!("a call failed by a defect while it used this {name}; free it"),
        ),
        false => Failure::new(
            PERCUSS_ERROR_BUSY,
            format_args!("another thread is using this {name}; give each thread its own"),
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    #[test]
    fn one_call_at_a_time_and_none_after_a_defect() {
        let object = Exclusive::new(1);
        let mut first = take(&object, "thing").expect("nobody has it");
        *first += 1;
        let second = take(&object, "thing").err().expect("it is taken");
        assert_eq!(second.status, PERCUSS_ERROR_BUSY);
        drop(first);
        assert_eq!(*take(&object, "thing").expect("it was given back"), 2);
        let panicked = catch_unwind(AssertUnwindSafe(|| {
            let _taken = take(&object, "thing").expect("nobody has it");
            panic!("a defect");
        }));
        assert!(panicked.is_err());
        for _ in 0..2 {
            let after = take(&object, "thing").err().expect("it is broken");
            assert_eq!(after.status, PERCUSS_ERROR_INTERNAL);
        }
    }
}
