//! Conditions of an analysis: the base, locks, armatures, held contacts.

use crate::boundary::arrays::{enumeration_value, input_slice, input_text};
use crate::boundary::handle::{
    Exclusive, Handle, clear_handle, free_handle, lock_object, object_of, write_handle,
};
use crate::boundary::status::{Failure, PERCUSS_ERROR_NULL, guard_call, percuss_status};
use percuss::nalgebra::Vector3;
use percuss::{Base, Conditions};
use std::ffi::c_char;

/// Conditions of an analysis. One thread at a time.
pub struct percuss_conditions {
    _opaque: [u8; 0],
}

impl Handle for percuss_conditions {
    type Object = Exclusive<Conditions>;
    const TAG: u64 = 0x7063_5f63_6f6e_6469;
    const NAME: &'static str = "percuss_conditions";
}

/// The root link is the ground.
pub const PERCUSS_BASE_FIXED: i32 = 0;
/// The root link moves freely.
pub const PERCUSS_BASE_FLOATING: i32 = 1;

/// Fixed base, every joint free, armatures as declared in the file. Free the conditions with percuss_conditions_free.
///
/// # Safety
/// conditions is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_conditions_new(conditions: *mut *mut percuss_conditions) -> percuss_status {
    guard_call(|| {
        clear_handle(conditions)?;
        write_handle(Exclusive::new(Conditions::new()), conditions)
    })
}

/// Frees conditions and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// conditions is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_conditions_free(conditions: *mut *mut percuss_conditions) -> percuss_status {
    guard_call(|| free_handle(conditions))
}

/// Locks the conditions of a handle and replaces them by the result of `change`.
fn modify_conditions(
    handle: *mut percuss_conditions,
    change: impl FnOnce(Conditions) -> Result<Conditions, Failure>,
) -> Result<(), Failure> {
    let mut conditions = lock_object(object_of(handle)?, "percuss_conditions")?;
    *conditions = change(conditions.clone())?;
    Ok(())
}

/// Sets the mobility of the root link: PERCUSS_BASE_FIXED (the default) or PERCUSS_BASE_FLOATING.
///
/// # Safety
/// conditions is null or a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_conditions_base(
    conditions: *mut percuss_conditions,
    base: i32,
) -> percuss_status {
    guard_call(|| {
        let base = enumeration_value(&[Base::Fixed, Base::Floating], base, "base")?;
        modify_conditions(conditions, |conditions| Ok(conditions.base(base)))
    })
}

/// Locks a joint at its position: its velocities are zero. percuss_system_new checks the name of the joint.
///
/// # Safety
/// joint ends with a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_conditions_lock(
    conditions: *mut percuss_conditions,
    joint: *const c_char,
) -> percuss_status {
    guard_call(|| {
        let joint = input_text(joint, "joint")?;
        modify_conditions(conditions, |conditions| Ok(conditions.lock(joint)))
    })
}

/// Replaces a joint's armature (the rotor's inertia at the joint, kg·m² or kg): one value for all velocities of the
/// joint, or one value per velocity. percuss_system_new checks the values.
///
/// # Safety
/// joint ends with a zero byte; values has count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_conditions_armature(
    conditions: *mut percuss_conditions,
    joint: *const c_char,
    values: *const f64,
    count: usize,
) -> percuss_status {
    guard_call(|| {
        let (joint, values) = (input_text(joint, "joint")?, input_slice(values, count, "values")?);
        modify_conditions(conditions, |conditions| Ok(conditions.armature(joint, values.to_vec())))
    })
}

/// Holds a point (3 numbers, m, link's frame) of a link to the ground: along a normal (3 numbers, root link's axes), or
/// in all directions if normal is null. Constrains velocities only. percuss_system_new checks the values.
///
/// # Safety
/// link ends with a zero byte; point has 3 numbers; normal is null or has 3.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_conditions_hold(
    conditions: *mut percuss_conditions,
    link: *const c_char,
    point: *const f64,
    normal: *const f64,
) -> percuss_status {
    guard_call(|| {
        if point.is_null() {
            return Err(Failure::new(PERCUSS_ERROR_NULL, "point is null; expected 3 values"));
        }
        let link = input_text(link, "link")?;
        let point = Vector3::from_column_slice(input_slice(point, 3, "point")?);
        let normal = match normal.is_null() {
            true => None,
            false => Some(Vector3::from_column_slice(input_slice(normal, 3, "normal")?)),
        };
        modify_conditions(conditions, |conditions| Ok(conditions.hold(link, point, normal)))
    })
}
