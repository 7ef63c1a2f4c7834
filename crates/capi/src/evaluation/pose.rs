//! Poses: a mechanism at one configuration, its matrices, m̄.

use crate::boundary::arrays::{copy_to_caller, expect_length, output_slice};
use crate::boundary::handle::{
    Handle, argument_mut, clear_handle, free_handle, lock_object, object_of, read_argument, write_handle,
};
use crate::boundary::names::element_at;
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_ASSEMBLY, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_LENGTH,
    guard_call, percuss_status,
};
use crate::evaluation::contact::{mass_summary, parse_route, percuss_contact, percuss_mass, percuss_route};
use crate::evaluation::response::{NamedResponse, percuss_response};
use crate::setup::configuration::percuss_configuration;
use crate::setup::model::{DiagnosticTexts, Model, percuss_diagnostic};
use crate::setup::system::{percuss_assembly, percuss_system};
use percuss::nalgebra::DMatrix;
use percuss::{AssemblyError, Configuration, ContactResponse, Pose};
use std::sync::Arc;

/// A mechanism at one configuration with closed loops. Immutable, so that threads can share it.
pub struct percuss_pose {
    _opaque: [u8; 0],
}

/// A pose, with the names of its links and joints.
pub(crate) struct NamedPose {
    pub model: Arc<Model>,
    pub pose: Pose,
    /// Findings about the path to the touch of a stop.
    pub diagnostics: Vec<DiagnosticTexts>,
}

impl Handle for percuss_pose {
    type Object = NamedPose;
    const TAG: u64 = 0x7063_5f70_6f73_6521;
    const NAME: &'static str = "percuss_pose";
}

/// Memory order of matrix entries.
pub type percuss_layout = i32;
/// Row by row: entry (r, c) at r · leading_dimension + c.
pub const PERCUSS_ROW_MAJOR: percuss_layout = 0;
/// Column by column, as in Fortran and BLAS: entry (r, c) at c · leading_dimension + r.
pub const PERCUSS_COLUMN_MAJOR: percuss_layout = 1;

/// Writes a handle of the pose that `find` gives for a configuration of the model.
fn write_pose(
    model: &Arc<Model>,
    configuration: *const percuss_configuration,
    pose: *mut *mut percuss_pose,
    find: impl FnOnce(&Configuration) -> Result<Pose, AssemblyError>,
) -> Result<(), Failure> {
    let configuration = lock_object(object_of(configuration)?, "percuss_configuration")?;
    configuration.check_model(model)?;
    let found = find(&configuration.values).map_err(Failure::with_status(PERCUSS_ERROR_ASSEMBLY))?;
    write_handle(NamedPose { model: Arc::clone(model), pose: found, diagnostics: Vec::new() }, pose)
}

/// The pose at a configuration: set joints drive, other joints of the loops follow. The pose belongs to the assembly
/// found from all joints at 0 or, if no loop closes from there, to the assembly found from the configuration's guesses.
/// Free it with percuss_pose_free.
///
/// Errors: PERCUSS_ERROR_ASSEMBLY: loops that do not close, drivers that cannot reach their positions, a dependent
/// joint that was set.
///
/// # Safety
/// system and configuration are handles; pose is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_new(
    system: *const percuss_system,
    configuration: *const percuss_configuration,
    pose: *mut *mut percuss_pose,
) -> percuss_status {
    guard_call(|| {
        clear_handle(pose)?;
        let compiled = object_of(system)?;
        write_pose(&compiled.model, configuration, pose, |values| compiled.system.pose(values))
    })
}

/// Like percuss_pose_new, for a given assembly.
///
/// # Safety
/// assembly and configuration are handles; pose is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_assembly_pose(
    assembly: *const percuss_assembly,
    configuration: *const percuss_configuration,
    pose: *mut *mut percuss_pose,
) -> percuss_status {
    guard_call(|| {
        clear_handle(pose)?;
        let assembled = object_of(assembly)?;
        write_pose(&assembled.model, configuration, pose, |values| assembled.assembly.pose(values))
    })
}

/// The pose at a configuration on the branch of another pose of the same assembly, followed from that pose: for steps
/// of a motion.
///
/// # Safety
/// from and configuration are handles; pose is null or points to storage for a pointer, other than from.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_follow(
    from: *const percuss_pose,
    configuration: *const percuss_configuration,
    pose: *mut *mut percuss_pose,
) -> percuss_status {
    guard_call(|| {
        clear_handle(pose)?;
        let from = &object_of(from)?;
        write_pose(&from.model, configuration, pose, |values| {
            from.pose.assembly().pose_from(&from.pose, values)
        })
    })
}

/// Frees a pose and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// pose is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_free(pose: *mut *mut percuss_pose) -> percuss_status {
    guard_call(|| free_handle(pose))
}

/// Number of notes and warnings of percuss_pose_touch about the path to the touch, the pose and the contact, as in the report of percuss_ask
/// with "contact": {"at": STOP}; 0 for a pose of another call.
///
/// # Safety
/// count is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_diagnostic_count(
    pose: *const percuss_pose,
    count: *mut usize,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(count, "count")? = object_of(pose)?.diagnostics.len();
        Ok(())
    })
}

/// Note or warning number index of a pose, from 0. Its texts are valid as long as the pose; its path is empty.
///
/// # Safety
/// diagnostic is null or points to storage for a percuss_diagnostic.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_diagnostic(
    pose: *const percuss_pose,
    index: usize,
    diagnostic: *mut percuss_diagnostic,
) -> percuss_status {
    guard_call(|| {
        let texts = element_at(&object_of(pose)?.diagnostics, index, "diagnostic")?;
        *argument_mut(diagnostic, "diagnostic")? = texts.for_c();
        Ok(())
    })
}

/// The positions of all joints, concatenated in joint order, mimics included: count is the positions of
/// percuss_model_counts.
///
/// # Safety
/// positions has space for count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_positions(
    pose: *const percuss_pose,
    positions: *mut f64,
    count: usize,
) -> percuss_status {
    guard_call(|| copy_to_caller(object_of(pose)?.pose.positions(), positions, count, "positions"))
}

/// m̄, its error and v* at a pose for a contact; `route` is PERCUSS_ROUTE_….
fn compute_response(
    posed: &NamedPose,
    contact: *const percuss_contact,
    route: i32,
) -> Result<ContactResponse, Failure> {
    let contact = read_argument(contact, "contact")?.resolve(&posed.model)?;
    let found = posed.pose.respond_by_route(&contact, parse_route(route)?);
    found.map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))
}

/// m̄ of a contact, with its error. route: normally PERCUSS_ROUTE_AUTO.
///
/// Errors: PERCUSS_ERROR_CONTACT: an invalid contact, or a contact that the route cannot solve.
///
/// # Safety
/// pose is a handle; contact is null or points to a contact; mass is null or points to storage for a percuss_mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_effective_mass(
    pose: *const percuss_pose,
    contact: *const percuss_contact,
    route: percuss_route,
    mass: *mut percuss_mass,
) -> percuss_status {
    guard_call(|| {
        let response = compute_response(object_of(pose)?, contact, route)?;
        *argument_mut(mass, "mass")? = mass_summary(&response);
        Ok(())
    })
}

/// The full response to a contact, with v* and the contributions. Free it with percuss_response_free.
///
/// Errors: as percuss_pose_effective_mass.
///
/// # Safety
/// As percuss_pose_effective_mass; response is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_respond(
    pose: *const percuss_pose,
    contact: *const percuss_contact,
    route: percuss_route,
    response: *mut *mut percuss_response,
) -> percuss_status {
    guard_call(|| {
        clear_handle(response)?;
        let posed = object_of(pose)?;
        let found = compute_response(posed, contact, route)?;
        write_handle(NamedResponse { model: Arc::clone(&posed.model), response: found }, response)
    })
}

/// Copies a matrix to an array of the caller; refuses one that is too small.
fn copy_matrix_to_caller(
    matrix: &DMatrix<f64>,
    values: *mut f64,
    length: usize,
    layout: percuss_layout,
    leading: usize,
) -> Result<(), Failure> {
    let (rows, columns) = matrix.shape();
    let (outer, inner) = match layout {
        PERCUSS_ROW_MAJOR => (rows, columns),
        PERCUSS_COLUMN_MAJOR => (columns, rows),
        _ => {
            let message =
                format_args!("layout is {layout}; expected PERCUSS_ROW_MAJOR or PERCUSS_COLUMN_MAJOR");
            return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
        }
    };
    if leading < inner {
        let message = format_args!("the leading dimension is {leading}; expected at least {inner}");
        return Err(Failure::new(PERCUSS_ERROR_LENGTH, message));
    }
    let needed = match outer {
        0 => Some(0),
        _ => (outer - 1).checked_mul(leading).and_then(|before| before.checked_add(inner)),
    };
    if needed.is_none_or(|needed| length < needed) {
        let message = format_args!(
            "values has room for {length} numbers; a {rows}×{columns} matrix with leading dimension {leading} needs more"
        );
        return Err(Failure::new(PERCUSS_ERROR_LENGTH, message));
    }
    let to = output_slice(values, length, "values")?;
    for o in 0..outer {
        for i in 0..inner {
            to[o * leading + i] = if layout == PERCUSS_ROW_MAJOR { matrix[(o, i)] } else { matrix[(i, o)] };
        }
    }
    Ok(())
}

/// M, the mass matrix over the coordinates, n×n (kg, kg·m, kg·m²), written to an array of length numbers.
///
/// # Safety
/// values has space for length numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_mass_matrix(
    pose: *const percuss_pose,
    values: *mut f64,
    length: usize,
    layout: percuss_layout,
    leading_dimension: usize,
) -> percuss_status {
    guard_call(|| {
        copy_matrix_to_caller(&object_of(pose)?.pose.mass_matrix(), values, length, layout, leading_dimension)
    })
}

/// Number of rows of A, redundant rows included.
///
/// # Safety
/// rows is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_constraint_rows(
    pose: *const percuss_pose,
    rows: *mut usize,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(rows, "rows")? = object_of(pose)?.pose.constraint_matrix().nrows();
        Ok(())
    })
}

/// A, the Jacobian of all constraints over the coordinates, rows×n, written to an array of length numbers; each group
/// of loops is scaled to entries of at most 1.
///
/// # Safety
/// values has space for length numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_constraint_matrix(
    pose: *const percuss_pose,
    values: *mut f64,
    length: usize,
    layout: percuss_layout,
    leading_dimension: usize,
) -> percuss_status {
    guard_call(|| {
        copy_matrix_to_caller(
            &object_of(pose)?.pose.constraint_matrix(),
            values,
            length,
            layout,
            leading_dimension,
        )
    })
}

/// j, the closing speed of a contact at unit rates of the coordinates, 1×n (m, 1): count is n.
///
/// # Safety
/// contact is null or points to a contact; values has space for count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_pose_contact_row(
    pose: *const percuss_pose,
    contact: *const percuss_contact,
    values: *mut f64,
    count: usize,
) -> percuss_status {
    guard_call(|| {
        let posed = object_of(pose)?;
        let contact = read_argument(contact, "contact")?.resolve(&posed.model)?;
        let located = posed.pose.locate(&contact).map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?;
        let row = posed.pose.contact_row(&located);
        expect_length(count, row.len(), "values")?;
        copy_to_caller(&row, values, count, "values")
    })
}
