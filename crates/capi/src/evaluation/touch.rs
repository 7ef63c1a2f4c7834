//! Poses at which a stop touches.

use crate::boundary::arrays::input_text;
use crate::boundary::handle::{argument_mut, clear_handle, lock_object, object_of, write_handle};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ASSEMBLY, PERCUSS_ERROR_NAME, guard_call, percuss_status,
};
use crate::evaluation::contact::percuss_contact;
use crate::evaluation::pose::{NamedPose, percuss_pose};
use crate::setup::configuration::percuss_configuration;
use crate::setup::model::DiagnosticTexts;
use crate::setup::system::percuss_system;
use percuss::study::{StudyError, pose_at_stop_with_findings};
use std::ffi::c_char;
use std::sync::Arc;

/// The pose at which a stop touches, and its contact, as the command `percuss mass --at STOP`. stop: the name of a contact of the model,
/// or the stop of a joint, JOINT:lower or JOINT:upper. The mechanism moves from the pose of the configuration until the gap is closed; joints
/// that are set keep their positions, and if no other joint moves the stop, the gap stays open (PERCUSS_REMARK_OPEN_GAP). Free the
/// pose with percuss_pose_free. Findings about the path to the touch, such as a stop that touches while the wheel moves the wrong way, about the
/// pose and about the contact: percuss_pose_diagnostic.
///
/// Errors: PERCUSS_ERROR_NAME: an unknown stop. PERCUSS_ERROR_ASSEMBLY: a stop that is out of reach, with the smallest gap; loops that do not close.
///
/// # Safety
/// system and configuration are handles; stop ends with a zero byte; pose is null or points to storage for a pointer; contact is null or
/// points to storage for a percuss_contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_touch(
    system: *const percuss_system,
    configuration: *const percuss_configuration,
    stop: *const c_char,
    pose: *mut *mut percuss_pose,
    contact: *mut percuss_contact,
) -> percuss_status {
    guard_call(|| {
        clear_handle(pose)?;
        let to = argument_mut(contact, "contact")?;
        let compiled = object_of(system)?;
        let configuration = lock_object(object_of(configuration)?, "percuss_configuration")?;
        configuration.check_model(&compiled.model)?;
        let (model, stop) = (&compiled.model, input_text(stop, "stop")?);
        let found = pose_at_stop_with_findings(&model.study, &compiled.system, &configuration.values, stop);
        let (found, of_stop, findings) = found.map_err(|error| match error {
            StudyError::Input { .. } => Failure::new(PERCUSS_ERROR_NAME, error),
            _ => Failure::new(PERCUSS_ERROR_ASSEMBLY, error),
        })?;
        let diagnostics = findings.iter().map(DiagnosticTexts::from_record).collect();
        write_handle(NamedPose { model: Arc::clone(model), pose: found, diagnostics }, pose)?;
        *to = percuss_contact::of(&of_stop);
        Ok(())
    })
}
