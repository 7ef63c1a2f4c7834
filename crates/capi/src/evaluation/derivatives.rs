//! Gradients of m̄, inverse operational inertias and link frames: at a pose, and for many configurations.

use crate::boundary::arrays::{
    ByteRange, copy_to_caller, expect_length, input_slice, optional_output_slice, output_slice,
    refuse_overlaps,
};
use crate::boundary::handle::{object_of, read_argument};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_NAME, guard_call, percuss_status,
};
use crate::evaluation::batch::percuss_batch;
use crate::evaluation::contact::{outcome_and_value, percuss_contact, percuss_outcome};
use crate::evaluation::pose::{percuss_layout, percuss_pose};
use percuss::{BatchContacts, BatchRows, EffectiveMass, RowColumns};

/// Numbers of a 6×6 matrix.
const MATRIX: usize = 36;

/// Frame of a link in the world: rotation (9 numbers, row by row) and origin (3 numbers, m).
///
/// Errors: PERCUSS_ERROR_NAME: no link of this index.
///
/// # Safety
/// pose is a handle; rotation has space for 9 numbers, origin for 3.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_link_frame(
    pose: *const percuss_pose,
    link: usize,
    rotation: *mut f64,
    origin: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let posed = object_of(pose)?;
        let links = posed.model.links.len();
        let link = posed.model.links.get(link).ok_or_else(|| {
            Failure::new(
                PERCUSS_ERROR_NAME,
                format_args!("link is {link}; the model has {links} links, from 0 on"),
            )
        })?;
        let frame = posed.pose.link(*link);
        copy_to_caller(frame.rotation.transpose().as_slice(), rotation, 9, "rotation")?;
        copy_to_caller(frame.translation.as_slice(), origin, 3, "origin")
    })
}

/// Gradient g of m̄ by the velocities of all joints, in joint order: dm̄/dt = g · v (kg/rad, kg/m) for every admissible motion v; count
/// is the velocities of percuss_model_counts. outcome and effective_mass: as percuss_workspace_effective_mass; g is NaN unless the
/// outcome is PERCUSS_FINITE and the error of m̄ at most 1e-6 m̄.
///
/// Errors: as percuss_pose_effective_mass.
///
/// # Safety
/// pose is a handle; contact is null or points to a contact; gradient has space for count numbers; outcome and effective_mass are
/// null or point to storage.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_gradient(
    pose: *const percuss_pose,
    contact: *const percuss_contact,
    gradient: *mut f64,
    count: usize,
    outcome: *mut percuss_outcome,
    effective_mass: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let written = [
            ByteRange::of_array(gradient, count, "gradient"),
            ByteRange::of_array(outcome, 1, "outcome"),
            ByteRange::of_array(effective_mass, 1, "effective_mass"),
        ];
        refuse_overlaps(&written, &[])?;
        let posed = object_of(pose)?;
        let contact = read_argument(contact, "contact")?.resolve(&posed.model)?;
        expect_length(count, posed.model.velocities, "gradient")?;
        let failure = Failure::with_status(PERCUSS_ERROR_CONTACT);
        let found = posed.pose.effective_mass_gradient(&contact).map_err(&failure)?;
        let (mass, values) = match found {
            Some(found) => (EffectiveMass::Finite(found.effective_mass), found.joints.concat()),
            None => {
                let mass = posed.pose.respond(&contact).map_err(&failure)?.effective_mass;
                (mass, vec![f64::NAN; count])
            }
        };
        copy_to_caller(&values, gradient, count, "gradient")?;
        let (code, value) = outcome_and_value(mass);
        if let Some(outcome) = optional_output_slice(outcome, 1, "outcome")? {
            outcome[0] = code;
        }
        if let Some(to) = optional_output_slice(effective_mass, 1, "effective_mass")? {
            to[0] = value;
        }
        Ok(())
    })
}

/// Φ = J M⁻¹ Jᵀ of the contact link at the contact point, under the constraints: 36 numbers, 6×6 row by row, in root axes, angular part
/// first; 1/m̄ = nᵀΦn for contacts with the ground, n = (0, normal). Its inverse is the operational space inertia.
///
/// Errors: as percuss_pose_effective_mass; PERCUSS_ERROR_CONTACT if a motion without mass responds.
///
/// # Safety
/// pose is a handle; contact is null or points to a contact; values has space for 36 numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_inverse_inertia(
    pose: *const percuss_pose,
    contact: *const percuss_contact,
    values: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let posed = object_of(pose)?;
        let contact = read_argument(contact, "contact")?.resolve(&posed.model)?;
        let located = posed.pose.locate(&contact).map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?;
        let found = posed.pose.inverse_operational_inertia(&located);
        let found = found.map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?;
        let rows: Vec<f64> = (0..MATRIX).map(|k| found.matrix()[(k / 6, k % 6)]).collect();
        copy_to_caller(&rows, values, MATRIX, "values")
    })
}

/// m̄ at count configurations, with a contact point and normal for each, its gradient and Φ.
///
/// positions, length, layout, stride, count, outcomes, effective_masses: as percuss_batch_run. points (m, in the frame of the contact
/// link) and normals (of any length, in the frame of the contact's normal): 3 numbers for each configuration, or 3 for all, with
/// point_numbers and normal_numbers numbers; both null: those of the contact of the batch. errors: count numbers. gradients: null,
/// or count × n numbers, row by row, n the velocities of percuss_model_counts, as percuss_pose_gradient. inverse_inertias: null, or
/// count × 36 numbers, as percuss_pose_inverse_inertia. Without a result the numbers are NaN.
///
/// Errors: as percuss_batch_run; PERCUSS_ERROR_CONTACT: an invalid point or normal, with the number of its configuration.
///
/// # Safety
/// batch is a handle; every array has the stated number of values, or is null where this is permitted.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_batch_derivatives(
    batch: *const percuss_batch,
    positions: *const f64,
    length: usize,
    layout: percuss_layout,
    stride: usize,
    count: usize,
    points: *const f64,
    point_numbers: usize,
    normals: *const f64,
    normal_numbers: usize,
    outcomes: *mut percuss_outcome,
    effective_masses: *mut f64,
    errors: *mut f64,
    gradients: *mut f64,
    inverse_inertias: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let threaded = object_of(batch)?;
        let width = threaded.batch.velocities();
        let [gradient_numbers, inertia_numbers] = [width, MATRIX].map(|width| count.saturating_mul(width));
        let written = [
            ByteRange::of_array(outcomes, count, "outcomes"),
            ByteRange::of_array(effective_masses, count, "effective_masses"),
            ByteRange::of_array(errors, count, "errors"),
            ByteRange::of_array(gradients, gradient_numbers, "gradients"),
            ByteRange::of_array(inverse_inertias, inertia_numbers, "inverse_inertias"),
        ];
        let read = [
            ByteRange::of_array(positions, length, "positions"),
            ByteRange::of_array(points, point_numbers, "points"),
            ByteRange::of_array(normals, normal_numbers, "normals"),
        ];
        refuse_overlaps(&written, &read)?;
        let values = input_slice(positions, length, "positions")?;
        let contacts = match points.is_null() && normals.is_null() {
            true => None,
            false => Some(BatchContacts {
                points: input_slice(points, point_numbers, "points")?,
                normals: input_slice(normals, normal_numbers, "normals")?,
            }),
        };
        let mut columns = RowColumns {
            statuses: output_slice(outcomes, count, "outcomes")?,
            masses: output_slice(effective_masses, count, "effective_masses")?,
            errors: output_slice(errors, count, "errors")?,
            remarks: None,
            gradients: optional_output_slice(gradients, gradient_numbers, "gradients")?,
            inverse_inertias: optional_output_slice(inverse_inertias, inertia_numbers, "inverse_inertias")?,
        };
        let positions = threaded.positions(values, layout, stride, count)?;
        columns.clear();
        threaded.run(BatchRows { contacts, ..positions.into() }, columns)
    })
}
