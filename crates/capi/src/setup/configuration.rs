//! Configurations: joint positions given by the user.

use crate::boundary::arrays::{input_slice, input_text};
use crate::boundary::handle::{
    Exclusive, Handle, clear_handle, free_handle, lock_object, object_of, write_handle,
};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_CONDITIONS, guard_call, percuss_status,
};
use crate::setup::model::{Model, percuss_model};
use percuss::spatial::Transform;
use percuss::{Configuration, ConfigurationError};
use std::ffi::c_char;
use std::sync::Arc;

/// Positions of the joints, and pose of the root link in the world. One thread at a time.
pub struct percuss_configuration {
    _opaque: [u8; 0],
}

/// A configuration with its model.
pub(crate) struct ModelConfiguration {
    model: Arc<Model>,
    pub values: Configuration,
}

impl ModelConfiguration {
    /// Refuses a configuration of another model.
    pub fn check_model(&self, model: &Arc<Model>) -> Result<(), Failure> {
        if Arc::ptr_eq(&self.model, model) {
            return Ok(());
        }
        let (got, expected) = (self.model.mechanism.name(), model.mechanism.name());
        let message =
            format_args!("the configuration is of the model \"{got}\"; expected one of \"{expected}\"");
        Err(Failure::new(PERCUSS_ERROR_CONDITIONS, message))
    }
}

impl Handle for percuss_configuration {
    type Object = Exclusive<ModelConfiguration>;
    const TAG: u64 = 0x7063_5f63_6f6e_6669;
    const NAME: &'static str = "percuss_configuration";
}

/// Every joint at zero (quaternions at 1, 0, 0, 0), the root link at the world's origin. Free it with percuss_configuration_free.
///
/// # Safety
/// model is a handle; configuration is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_new(
    model: *const percuss_model,
    configuration: *mut *mut percuss_configuration,
) -> percuss_status {
    guard_call(|| {
        clear_handle(configuration)?;
        let model = Arc::clone(object_of(model)?);
        let values = Configuration::zero(&model.mechanism);
        write_handle(Exclusive::new(ModelConfiguration { model, values }), configuration)
    })
}

/// Frees a configuration and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// configuration is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_free(
    configuration: *mut *mut percuss_configuration,
) -> percuss_status {
    guard_call(|| free_handle(configuration))
}

/// Resets every joint to zero and removes all settings and guesses.
///
/// # Safety
/// configuration is null or a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_reset(
    configuration: *mut percuss_configuration,
) -> percuss_status {
    guard_call(|| {
        let mut configuration_guard = lock_object(object_of(configuration)?, "percuss_configuration")?;
        configuration_guard.values.reset();
        Ok(())
    })
}

/// Setter of a joint's values.
type JointSetter =
    for<'a> fn(&'a mut Configuration, &str, &[f64]) -> Result<&'a mut Configuration, ConfigurationError>;

/// Passes the values of a joint to a setter of the locked configuration.
fn set_joint_values(
    handle: *mut percuss_configuration,
    joint: *const c_char,
    values: *const f64,
    count: usize,
    set: JointSetter,
) -> percuss_status {
    guard_call(|| {
        let (joint, values) = (input_text(joint, "joint")?, input_slice(values, count, "values")?);
        let mut configuration_guard = lock_object(object_of(handle)?, "percuss_configuration")?;
        set(&mut configuration_guard.values, joint, values)
            .map_err(Failure::with_status(PERCUSS_ERROR_CONDITIONS))?;
        Ok(())
    })
}

/// Sets a driving joint to count values (layouts of percuss_joint_kind). Other joints of the loops follow.
///
/// Errors: PERCUSS_ERROR_CONDITIONS: unknown joint, repeated setting, a mimic, a wrong number of values, an invalid
/// value.
///
/// # Safety
/// joint ends with a zero byte; values has count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_set(
    configuration: *mut percuss_configuration,
    joint: *const c_char,
    values: *const f64,
    count: usize,
) -> percuss_status {
    set_joint_values(configuration, joint, values, count, Configuration::set)
}

/// Sets the initial position in the search for a dependent joint of a loop, which selects the assembly mode.
///
/// Errors: as percuss_configuration_set.
///
/// # Safety
/// As percuss_configuration_set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_guess(
    configuration: *mut percuss_configuration,
    joint: *const c_char,
    values: *const f64,
    count: usize,
) -> percuss_status {
    set_joint_values(configuration, joint, values, count, Configuration::guess)
}

/// Sets the whole configuration: the positions of all joints, concatenated in joint order; positions of mimics are not
/// read. Loops are closed from there. Earlier settings are dropped.
///
/// Errors: PERCUSS_ERROR_CONDITIONS.
///
/// # Safety
/// positions has count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_set_positions(
    configuration: *mut percuss_configuration,
    positions: *const f64,
    count: usize,
) -> percuss_status {
    guard_call(|| {
        let positions = input_slice(positions, count, "positions")?;
        let mut configuration_guard = lock_object(object_of(configuration)?, "percuss_configuration")?;
        let found = Configuration::from_positions(&configuration_guard.model.mechanism, positions);
        configuration_guard.values = found.map_err(Failure::with_status(PERCUSS_ERROR_CONDITIONS))?;
        Ok(())
    })
}

/// Sets the pose of the root link in the world: its origin (3 numbers, m) and its orientation (4 numbers, a unit
/// quaternion w, x, y, z: a norm within 0.01 of 1, which is normalised).
///
/// Errors: PERCUSS_ERROR_ARGUMENT: a number that is not finite, another norm.
///
/// # Safety
/// position has 3 numbers, quaternion 4.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_set_base(
    configuration: *mut percuss_configuration,
    position: *const f64,
    quaternion: *const f64,
) -> percuss_status {
    guard_call(|| {
        let x_wr = read_base_pose(position, quaternion)?;
        let mut configuration_guard = lock_object(object_of(configuration)?, "percuss_configuration")?;
        configuration_guard.values.set_base(x_wr);
        Ok(())
    })
}

/// Transform X_wr, root link to world, from its origin (3 numbers, m) and its orientation (unit quaternion w, x, y, z). Null pointers
/// are errors.
pub(crate) fn read_base_pose(
    position: *const f64,
    quaternion: *const f64,
) -> Result<Transform<f64>, Failure> {
    let (mut p, mut q) = ([0.0; 3], [0.0; 4]);
    p.copy_from_slice(input_slice(position, 3, "position")?);
    q.copy_from_slice(input_slice(quaternion, 4, "quaternion")?);
    percuss::input::base_pose(p, q).map_err(Failure::with_status(PERCUSS_ERROR_ARGUMENT))
}

/// Accepts a pose on another assembly mode, beyond the reach of the branch of the first closed pose. Such a pose has
/// PERCUSS_REMARK_OTHER_ASSEMBLY; without this setting, the result is PERCUSS_ERROR_ASSEMBLY. A guess also selects a
/// mode.
///
/// # Safety
/// configuration is null or a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_configuration_allow_other_assembly(
    configuration: *mut percuss_configuration,
) -> percuss_status {
    guard_call(|| {
        lock_object(object_of(configuration)?, "percuss_configuration")?.values.allow_other_assembly();
        Ok(())
    })
}
