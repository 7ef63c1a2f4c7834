//! Many contacts of a link at one pose, and the state of a pose.

use crate::boundary::arrays::{
    ByteRange, input_slice, nan_if_unknown, optional_output_slice, output_slice, refuse_overlaps,
};
use crate::boundary::handle::{argument_mut, object_of};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_LENGTH, guard_call, percuss_status,
};
use crate::evaluation::contact::{PERCUSS_GROUND, percuss_outcome};
use crate::evaluation::pose::percuss_pose;
use percuss::RemarkFlags;

/// State of a pose.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_pose_state {
    /// Degrees of freedom at this pose; a floating base counts 6.
    pub degrees_of_freedom: usize,
    /// Rank of A.
    pub rank: usize,
    /// PERCUSS_REMARK_… about the pose added together: joints outside their limits, the closing of the loops, the rank.
    pub remarks: u32,
    /// 1 if the rank of A is smaller than at a generic pose: branches cross.
    pub is_singular: i32,
    /// 1 if the rank of A is clear.
    pub rank_is_clear: i32,
    /// 0.
    pub reserved: i32,
    /// Smallest ratio, over all groups of loops, of the smallest nonzero to the largest zero singular value; NaN without constraints.
    pub rank_gap: f64,
    /// Largest remaining gap of the loops, m; NaN without loops.
    pub closure_residual: f64,
}

/// State of a pose: degrees of freedom, rank, findings, closing of the loops.
///
/// # Safety
/// pose is a handle; state is null or points to storage for a percuss_pose_state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_describe(
    pose: *const percuss_pose,
    state: *mut percuss_pose_state,
) -> percuss_status {
    guard_call(|| {
        let pose = &object_of(pose)?.pose;
        let to = argument_mut(state, "state")?;
        let rank = pose.rank();
        let mut remarks: RemarkFlags = pose.remarks().iter().collect();
        if rank.singular {
            remarks |= RemarkFlags::SINGULAR_POSE;
        }
        if !rank.clear {
            remarks |= RemarkFlags::UNCLEAR_RANK;
        }
        *to = percuss_pose_state {
            degrees_of_freedom: pose.degrees_of_freedom(),
            rank: rank.rank,
            remarks: remarks.bits(),
            is_singular: i32::from(rank.singular),
            rank_is_clear: i32::from(rank.clear),
            reserved: 0,
            rank_gap: nan_if_unknown(rank.gap),
            closure_residual: nan_if_unknown(pose.loops().map(|state| state.residual)),
        };
        Ok(())
    })
}

/// m̄ of count contacts of a link at one pose, by the inverse operational inertia of the link: some nanoseconds per contact.
///
/// against: the other side, a link or PERCUSS_GROUND. points (m) and normals (out of the link, of any length): 3 × count numbers each, one
/// contact after another, in the frame of the link. outcomes and effective_masses (kg; NaN unless finite): count values each. errors: null,
/// or count numbers, the error of m̄, kg; NaN unless finite.
///
/// Errors: PERCUSS_ERROR_NAME: no link of this number; PERCUSS_ERROR_ARGUMENT: a number that is not finite, a zero normal;
/// PERCUSS_ERROR_CONTACT: link and against are the same link; PERCUSS_ERROR_LENGTH: count above SIZE_MAX / 3; PERCUSS_ERROR_OVERLAP.
///
/// # Safety
/// pose is a handle; every array has the stated number of values, or is null where this is permitted.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_contact_map(
    pose: *const percuss_pose,
    link: usize,
    against: usize,
    points: *const f64,
    normals: *const f64,
    count: usize,
    outcomes: *mut percuss_outcome,
    effective_masses: *mut f64,
    errors: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let posed = object_of(pose)?;
        let numbers = count.checked_mul(3).ok_or_else(|| {
            Failure::new(
                PERCUSS_ERROR_LENGTH,
                format_args!("count is {count}; expected at most SIZE_MAX / 3"),
            )
        })?;
        let read = [
            ByteRange::of_array(points, numbers, "points"),
            ByteRange::of_array(normals, numbers, "normals"),
        ];
        let written = [
            ByteRange::of_array(outcomes, count, "outcomes"),
            ByteRange::of_array(effective_masses, count, "effective_masses"),
            ByteRange::of_array(errors, count, "errors"),
        ];
        refuse_overlaps(&written, &read)?;
        let link = posed.model.link_id(link)?;
        let against = match against {
            PERCUSS_GROUND => None,
            number => Some(posed.model.link_id(number)?),
        };
        let (points, normals) =
            (input_slice(points, numbers, "points")?, input_slice(normals, numbers, "normals")?);
        for (name, values) in [("points", points), ("normals", normals)] {
            if let Some(at) = values.iter().position(|x| !x.is_finite()) {
                let message = format_args!(
                    "{name}[{}][{}] is {}; expected a finite number",
                    at / 3,
                    at % 3,
                    values[at]
                );
                return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
            }
        }
        if let Some(row) = normals.chunks(3).position(|normal| normal.iter().all(|x| *x == 0.0)) {
            let message = format_args!("normals[{row}] has no length; expected a direction");
            return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
        }
        let outcomes = output_slice(outcomes, count, "outcomes")?;
        let masses = output_slice(effective_masses, count, "effective_masses")?;
        let errors = optional_output_slice(errors, count, "errors")?;
        let (points, normals) = (points.as_chunks().0, normals.as_chunks().0);
        let found = posed.pose.contact_masses(link, against, points, normals);
        let found = found.map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?;
        outcomes.iter_mut().zip(found.statuses).for_each(|(to, status)| *to = status.into());
        masses.copy_from_slice(&found.masses);
        if let Some(errors) = errors {
            errors.copy_from_slice(&found.errors);
        }
        Ok(())
    })
}
