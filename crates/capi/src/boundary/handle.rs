//! Handles: C's references to objects.
//!
//! The functions here and in `arrays` take pointers from C and rely on the contract of the calling C function
//! ("Pointers" in the header). They are called only by C functions, with the arguments of those functions.

use crate::boundary::status::{
    Failure, PERCUSS_ERROR_BUSY, PERCUSS_ERROR_HANDLE, PERCUSS_ERROR_INTERNAL, PERCUSS_ERROR_NULL,
};
use std::ops::{Deref, DerefMut};
use try_lock::{Locked, TryLock};

/// Type of a C handle.
pub(crate) trait Handle {
    /// The object; calls from several threads share it.
    type Object: Send + Sync;
    /// Number in memory before the object; different for each handle type.
    const TAG: u64;
    /// The name of the type in C.
    const NAME: &'static str;
}

/// Tag of a freed object.
const FREED: u64 = 0x6672_6565_6421_2121;

/// Memory layout of an object.
#[repr(C)]
struct Tagged<T> {
    tag: u64,
    object: T,
}

/// Mutable reference to the value of a pointer argument.
#[inline]
pub(crate) fn argument_mut<'a, T>(pointer: *mut T, name: &str) -> Result<&'a mut T, Failure> {
    check_pointer(pointer, name)?;
    // SAFETY: neither null nor misaligned; the caller of the C function promises that it points to a T of its own.
    Ok(unsafe { &mut *pointer })
}

/// Copy of the value of a pointer argument.
pub(crate) fn read_argument<T: Copy>(pointer: *const T, name: &str) -> Result<T, Failure> {
    check_pointer(pointer, name)?;
    // SAFETY: as above; T is a type of plain numbers, which have no invalid bit pattern.
    Ok(unsafe { *pointer })
}

/// Shared reference to the value of a pointer argument.
#[inline]
pub(crate) fn argument_ref<'a, T: Copy>(pointer: *const T, name: &str) -> Result<&'a T, Failure> {
    check_pointer(pointer, name)?;
    // SAFETY: as above; the caller of the C function promises that the value does not change during the call.
    Ok(unsafe { &*pointer })
}

/// As [`read_argument`]; `None` for a null pointer.
pub(crate) fn read_optional_argument<T: Copy>(pointer: *const T, name: &str) -> Result<Option<T>, Failure> {
    if pointer.is_null() { Ok(None) } else { read_argument(pointer, name).map(Some) }
}

/// Refuses a null or misaligned pointer.
#[inline]
fn check_pointer<T>(pointer: *const T, name: &str) -> Result<(), Failure> {
    if pointer.is_null() || !pointer.is_aligned() {
        Err(pointer_failure(pointer.is_null(), name))
    } else {
        Ok(())
    }
}

/// Error of a null or misaligned pointer.
#[cold]
fn pointer_failure(null: bool, name: &str) -> Failure {
    let fault = if null { "null" } else { "not aligned for its type" };
    Failure::new(PERCUSS_ERROR_NULL, format_args!("{name} is {fault}"))
}

/// Moves an object to the heap and writes its handle to `to`.
pub(crate) fn write_handle<H: Handle>(object: H::Object, to: *mut *mut H) -> Result<(), Failure> {
    let to = argument_mut(to, "the place for the new handle")?;
    *to = Box::into_raw(Box::new(Tagged { tag: H::TAG, object })).cast();
    Ok(())
}

/// Sets the new handle to null, so that a failed call leaves a null handle.
pub(crate) fn clear_handle<H: Handle>(to: *mut *mut H) -> Result<(), Failure> {
    *argument_mut(to, "the place for the new handle")? = std::ptr::null_mut();
    Ok(())
}

/// Pointer to the object of a handle, after a check of its tag.
#[inline]
fn checked_object<H: Handle>(handle: *const H) -> Result<*const Tagged<H::Object>, Failure> {
    let pointer: *const Tagged<H::Object> = handle.cast();
    check_pointer(pointer, H::NAME)?;
    // SAFETY: neither null nor misaligned; all handles begin with a tag. A freed handle must not be read: its
    // detection, while its memory is intact, is a help without guarantee.
    let tag = unsafe { pointer.cast::<u64>().read() };
    if tag == H::TAG { Ok(pointer) } else { Err(handle_failure(tag, H::NAME)) }
}

/// Error of a handle with another tag: freed before, or of another type.
#[cold]
fn handle_failure(tag: u64, name: &str) -> Failure {
    match tag {
        FREED => Failure::new(PERCUSS_ERROR_HANDLE, format_args!("this {name} was freed before")),
        _ => Failure::new(PERCUSS_ERROR_HANDLE, format_args!("this is no handle of a {name}")),
    }
}

/// Object of a handle, after a check of its tag.
#[inline]
pub(crate) fn object_of<'a, H: Handle>(handle: *const H) -> Result<&'a H::Object, Failure> {
    let pointer = checked_object(handle)?;
    // SAFETY: the tag proves an object of this kind, made by `write_handle`; the caller promises not to free it during the
    // call. References are shared only: mutable objects are behind a lock.
    Ok(unsafe { &(*pointer).object })
}

/// Frees the object of a handle and sets the handle to null; a null handle is ignored.
pub(crate) fn free_handle<H: Handle>(handle: *mut *mut H) -> Result<(), Failure> {
    let handle = argument_mut(handle, "the place of the handle")?;
    if handle.is_null() {
        return Ok(());
    }
    let pointer = checked_object(*handle)?.cast_mut();
    *handle = std::ptr::null_mut();
    // SAFETY: the tag proves that `write_handle` made the object from a box, and that it was not freed; the caller promises
    // that no other call uses it.
    let mut boxed = unsafe { Box::from_raw(pointer) };
    // SAFETY: the field belongs to the box. The write is volatile, because the compiler could otherwise remove it as
    // unread.
    unsafe { std::ptr::addr_of_mut!(boxed.tag).write_volatile(FREED) };
    drop(boxed);
    Ok(())
}

/// Mutable object with exclusive access by one call at a time. No call waits for the lock, so that a release is a
/// single store.
pub(crate) struct Exclusive<T>(TryLock<Guarded<T>>);

struct Guarded<T> {
    /// True if a call panicked while it used the object.
    broken: bool,
    object: T,
}

/// Lock guard of an [`Exclusive`] object.
pub(crate) struct ExclusiveGuard<'a, T>(Locked<'a, Guarded<T>>);

impl<T> Exclusive<T> {
    pub fn new(object: T) -> Self {
        Self(TryLock::new(Guarded { broken: false, object }))
    }
}

impl<T> Deref for ExclusiveGuard<'_, T> {
    type Target = T;

    #[inline]
    fn deref(&self) -> &T {
        &self.0.object
    }
}

impl<T> DerefMut for ExclusiveGuard<'_, T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut T {
        &mut self.0.object
    }
}

impl<T> Drop for ExclusiveGuard<'_, T> {
    #[inline]
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.broken = true;
        }
    }
}

/// Locks a mutable object for one call; fails if another call uses it or a panic left it unusable.
#[inline]
pub(crate) fn lock_object<'a, T>(
    object: &'a Exclusive<T>,
    name: &str,
) -> Result<ExclusiveGuard<'a, T>, Failure> {
    match object.0.try_lock() {
        Some(kept) if !kept.broken => Ok(ExclusiveGuard(kept)),
        found => Err(lock_failure(found.is_some(), name)),
    }
}

/// Error of an object that a panic left unusable (`broken`), or that another thread is using.
#[cold]
fn lock_failure(broken: bool, name: &str) -> Failure {
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
        let mut first = lock_object(&object, "thing").expect("nobody has it");
        *first += 1;
        let second = lock_object(&object, "thing").err().expect("it is taken");
        assert_eq!(second.status, PERCUSS_ERROR_BUSY);
        drop(first);
        assert_eq!(*lock_object(&object, "thing").expect("it was given back"), 2);
        let panicked = catch_unwind(AssertUnwindSafe(|| {
            let _taken = lock_object(&object, "thing").expect("nobody has it");
            panic!("a defect");
        }));
        assert!(panicked.is_err());
        for _ in 0..2 {
            let after = lock_object(&object, "thing").err().expect("it is broken");
            assert_eq!(after.status, PERCUSS_ERROR_INTERNAL);
        }
    }
}
