//! Paths: the driving joints of a linkage move step by step, and the other joints close the loops.

use crate::boundary::arrays::{
    ByteRange, expect_length, input_slice, nan_if_unknown, optional_output_slice, output_slice,
    refuse_overlaps,
};
use crate::boundary::handle::{
    Exclusive, Handle, argument_mut, clear_handle, free_handle, lock_object, object_of, read_argument,
    write_handle,
};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ASSEMBLY, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_NAME, guard_call, percuss_status,
};
use crate::evaluation::contact::percuss_contact;
use crate::evaluation::pose::percuss_pose;
use crate::setup::model::Model;
use percuss::{DrivenPath, JointId, PathAnswer};
use std::sync::Arc;

/// A contact of a linkage whose driving joints follow a path. One thread at a time.
pub struct percuss_path {
    _opaque: [u8; 0],
}

/// A path, with reusable buffers.
pub(crate) struct ModelPath {
    model: Arc<Model>,
    path: DrivenPath,
    joints: usize,
    answers: Vec<PathAnswer>,
    positions: Vec<f64>,
}

impl Handle for percuss_path {
    type Object = Exclusive<ModelPath>;
    const TAG: u64 = 0x7063_5f70_6174_6821;
    const NAME: &'static str = "percuss_path";
}

/// Path of driving joints (indices of percuss_model_find_joint, of one position each) from a pose, for one contact. All other drivers
/// keep their positions. Free it with percuss_path_free.
///
/// Errors: PERCUSS_ERROR_ASSEMBLY if the mechanism has no such path: no loops, more degrees of freedom than the kernel has, redundant
/// rows, a singular pose, or a joint that is no driver; percuss_pose_follow then closes the loops. PERCUSS_ERROR_CONTACT,
/// PERCUSS_ERROR_NAME.
///
/// # Safety
/// pose is a handle; contact is null or points to a contact; joints has joint_count numbers; path is null or points to storage for a
/// pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_path_new(
    pose: *const percuss_pose,
    contact: *const percuss_contact,
    joints: *const usize,
    joint_count: usize,
    path: *mut *mut percuss_path,
) -> percuss_status {
    guard_call(|| {
        clear_handle(path)?;
        let posed = object_of(pose)?;
        let contact = read_argument(contact, "contact")?.resolve(&posed.model)?;
        let given = input_slice(joints, joint_count, "joints")?;
        let of_index = |index: &usize| {
            posed.model.joints.get(*index).copied().ok_or_else(|| {
                let count = posed.model.joints.len();
                Failure::new(
                    PERCUSS_ERROR_NAME,
                    format_args!("joints has {index}; the model has {count} joints, from 0 on"),
                )
            })
        };
        let ids: Vec<JointId> = given.iter().map(of_index).collect::<Result<_, _>>()?;
        let found = posed.pose.driven_path(&contact, &ids);
        let found = found.map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?.ok_or_else(|| {
            Failure::new(
                PERCUSS_ERROR_ASSEMBLY,
                "the mechanism has no path of these joints: expected a linkage of few degrees of freedom without redundant \
                 rows, at a regular pose, and its drivers; percuss_pose_follow closes the loops of every mechanism",
            )
        })?;
        let object = ModelPath {
            model: Arc::clone(&posed.model),
            path: found,
            joints: joint_count,
            answers: Vec::new(),
            positions: Vec::new(),
        };
        write_handle(Exclusive::new(object), path)
    })
}

/// Frees a path and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// path is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_path_free(path: *mut *mut percuss_path) -> percuss_status {
    guard_call(|| free_handle(path))
}

/// Follows rows of the path: values has count rows of one number per joint of the path. Newton's method closes the loops of each row
/// from the row before. done: number of rows that were completed; the path stops before a row of which the branch is in doubt, and
/// percuss_path_restart continues it. Allocates nothing after a call with as many rows.
///
/// positions: count × p numbers, the positions of all joints, row by row, for percuss_workspace_respond and batches.
/// effective_masses, errors: null, or count numbers: m̄ and its error, kg; NaN where m̄ is uncertain, for percuss_workspace_respond at
/// these positions. remarks: null, or count numbers: PERCUSS_REMARK_… added together. Rows that were not completed are not written.
///
/// Errors: PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_OVERLAP, PERCUSS_ERROR_BUSY.
///
/// # Safety
/// path is a handle; every array has the stated number of values; done is null or points to storage.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_path_follow(
    path: *mut percuss_path,
    values: *const f64,
    length: usize,
    count: usize,
    positions: *mut f64,
    position_numbers: usize,
    effective_masses: *mut f64,
    errors: *mut f64,
    remarks: *mut u32,
    done: *mut usize,
) -> percuss_status {
    guard_call(|| {
        let written = [
            ByteRange::of_array(positions, position_numbers, "positions"),
            ByteRange::of_array(effective_masses, count, "effective_masses"),
            ByteRange::of_array(errors, count, "errors"),
            ByteRange::of_array(remarks, count, "remarks"),
            ByteRange::of_array(done, 1, "done"),
        ];
        refuse_overlaps(&written, &[ByteRange::of_array(values, length, "values")])?;
        let mut guard = lock_object(object_of(path)?, "percuss_path")?;
        let ModelPath { model, path, joints, answers, positions: own } = &mut *guard;
        let values = input_slice(values, length, "values")?;
        expect_length(length, count.saturating_mul(*joints), "values")?;
        expect_length(position_numbers, count.saturating_mul(model.positions), "positions")?;
        let to = output_slice(positions, position_numbers, "positions")?;
        let masses = optional_output_slice(effective_masses, count, "effective_masses")?;
        let errors = optional_output_slice(errors, count, "errors")?;
        let remarks = optional_output_slice(remarks, count, "remarks")?;
        let completed = argument_mut(done, "done")?;
        answers.clear();
        own.clear();
        *completed = path.follow(values, answers, own);
        to[..own.len()].copy_from_slice(own);
        let mass = |answer: &PathAnswer| nan_if_unknown(answer.mass.map(|(mass, _)| mass));
        let error = |answer: &PathAnswer| nan_if_unknown(answer.mass.map(|(_, error)| error));
        if let Some(masses) = masses {
            masses.iter_mut().zip(&*answers).for_each(|(to, answer)| *to = mass(answer));
        }
        if let Some(errors) = errors {
            errors.iter_mut().zip(&*answers).for_each(|(to, answer)| *to = error(answer));
        }
        if let Some(remarks) = remarks {
            remarks.iter_mut().zip(&*answers).for_each(|(to, answer)| *to = answer.remarks.bits());
        }
        Ok(())
    })
}

/// Moves a path to another pose of the same assembly, for example that of percuss_pose_follow at the row before which the path stopped.
///
/// Errors: PERCUSS_ERROR_ASSEMBLY if the path cannot continue there; the path stays as it is.
///
/// # Safety
/// path and pose are handles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_path_restart(
    path: *mut percuss_path,
    pose: *const percuss_pose,
) -> percuss_status {
    guard_call(|| {
        let mut guard = lock_object(object_of(path)?, "percuss_path")?;
        match guard.path.restart(&object_of(pose)?.pose) {
            true => Ok(()),
            false => Err(Failure::new(
                PERCUSS_ERROR_ASSEMBLY,
                "the path cannot continue at this pose: it is singular, of another assembly, or driven by other joints",
            )),
        }
    })
}
