//! Workspaces: one configuration after another, without allocations.

use crate::boundary::arrays::{
    ByteRange, copy_to_caller, expect_length, input_slice, nan_if_unknown, refuse_overlaps,
};
use crate::boundary::handle::{
    Exclusive, Handle, argument_mut, argument_ref, clear_handle, free_handle, lock_object, object_of,
    write_handle,
};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_ASSEMBLY, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_LENGTH,
    guard_call, percuss_status,
};
use crate::evaluation::contact::{outcome_and_value, percuss_contact, percuss_outcome};
use crate::setup::configuration::read_base_pose;
use crate::setup::model::Model;
use crate::setup::system::percuss_assembly;
use percuss::{Contact, ResponseError, Workspace};
use std::sync::Arc;

/// Workspace for m̄ at many poses of an assembly. One thread at a time: each thread needs its own.
pub struct percuss_workspace {
    _opaque: [u8; 0],
}

/// A workspace, with its model and its last contact.
pub(crate) struct ModelWorkspace {
    pub model: Arc<Model>,
    pub workspace: Workspace,
    /// The last contact, in C form and resolved on the model.
    last_contact: Option<(percuss_contact, Contact)>,
    /// v* of the last response; a reusable buffer.
    velocities: Vec<f64>,
}

impl Handle for percuss_workspace {
    type Object = Exclusive<ModelWorkspace>;
    const TAG: u64 = 0x7063_5f77_6f72_6b73;
    const NAME: &'static str = "percuss_workspace";
}

/// Workspace for many poses of an assembly, initially at its first closed pose. Free it with percuss_workspace_free.
///
/// # Safety
/// assembly is a handle; workspace is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_new(
    assembly: *const percuss_assembly,
    workspace: *mut *mut percuss_workspace,
) -> percuss_status {
    guard_call(|| {
        clear_handle(workspace)?;
        let assembled = object_of(assembly)?;
        let (model, inside) = (Arc::clone(&assembled.model), assembled.assembly.workspace());
        let workspace_guard =
            ModelWorkspace { model, workspace: inside, last_contact: None, velocities: Vec::new() };
        write_handle(Exclusive::new(workspace_guard), workspace)
    })
}

/// Frees a workspace and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// workspace is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_free(workspace: *mut *mut percuss_workspace) -> percuss_status {
    guard_call(|| free_handle(workspace))
}

/// m̄ of a contact at the positions of all joints (concatenated in joint order; unit quaternions; positions of mimics
/// are not read): count numbers, the positions of percuss_model_counts. Loops must be closed at these positions, to a
/// millionth of their size; positions of a pose of the same assembly satisfy this.
///
/// effective_mass: kg; NaN unless the outcome is PERCUSS_FINITE. remarks: null, or storage for PERCUSS_REMARK_… added
/// together. No error bound is computed: use percuss_pose_effective_mass. Allocates nothing after the first call,
/// unless the recursion is not accurate enough. For normals in the world, the root link is at the pose of
/// percuss_workspace_set_base, else at the world's origin.
///
/// Errors: PERCUSS_ERROR_NULL, PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_ARGUMENT: a relevant position is not finite, a
/// quaternion is not of unit length; PERCUSS_ERROR_ASSEMBLY: a loop is open, with the gap and the tolerance;
/// PERCUSS_ERROR_CONTACT; PERCUSS_ERROR_OVERLAP; PERCUSS_ERROR_BUSY if another thread uses the workspace.
///
/// # Safety
/// workspace is a handle; positions is null or has count numbers; contact is null or points to a contact; the other
/// pointers are null or point to storage.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_effective_mass(
    workspace: *mut percuss_workspace,
    positions: *const f64,
    count: usize,
    contact: *const percuss_contact,
    outcome: *mut percuss_outcome,
    effective_mass: *mut f64,
    remarks: *mut u32,
) -> percuss_status {
    guard_call(|| {
        let read =
            [ByteRange::of_array(positions, count, "positions"), ByteRange::of_array(contact, 1, "contact")];
        refuse_overlaps(&ResultPointers::byte_ranges(outcome, effective_mass, remarks), &read)?;
        let mut workspace_guard = lock_object(object_of(workspace)?, "percuss_workspace")?;
        let results = ResultPointers::from_pointers(outcome, effective_mass, remarks)?;
        let c_contact = argument_ref(contact, "contact")?;
        let positions = input_slice(positions, count, "positions")?;
        workspace_guard
            .workspace
            .set_positions(positions)
            .map_err(Failure::with_status(PERCUSS_ERROR_LENGTH))?;
        workspace_guard.write_effective_mass(c_contact, results)
    })
}

/// m̄ of another contact at the last positions of the workspace; at its first closed pose if no positions were given.
///
/// Errors: as percuss_workspace_effective_mass.
///
/// # Safety
/// As percuss_workspace_effective_mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_effective_mass_again(
    workspace: *mut percuss_workspace,
    contact: *const percuss_contact,
    outcome: *mut percuss_outcome,
    effective_mass: *mut f64,
    remarks: *mut u32,
) -> percuss_status {
    guard_call(|| {
        let read = [ByteRange::of_array(contact, 1, "contact")];
        refuse_overlaps(&ResultPointers::byte_ranges(outcome, effective_mass, remarks), &read)?;
        let mut workspace_guard = lock_object(object_of(workspace)?, "percuss_workspace")?;
        let results = ResultPointers::from_pointers(outcome, effective_mass, remarks)?;
        workspace_guard.write_effective_mass(argument_ref(contact, "contact")?, results)
    })
}

/// Response of a workspace to a contact.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_workspace_response {
    /// PERCUSS_FINITE, PERCUSS_IMMOVABLE or PERCUSS_MASSLESS.
    pub outcome: percuss_outcome,
    /// PERCUSS_REMARK_… added together.
    pub remarks: u32,
    /// m̄, kg; NaN unless finite.
    pub effective_mass: f64,
    /// Error of m̄ by rounding, kg; NaN unless finite. Those by the closing of loops and by the file: percuss_pose_effective_mass.
    pub error: f64,
    /// v* of a floating root link: 3 angular and 3 linear numbers, in its axes at its origin; zeros for a fixed root link.
    pub base_velocity: [f64; 6],
}

/// m̄ of a contact at the last positions of the workspace, its error, findings, and v*: the velocities of all joints at unit closing
/// speed (1/m·rad, 1), concatenated in joint order; velocity_count is the velocities of percuss_model_counts. positions: count
/// numbers, as percuss_workspace_effective_mass; null with count 0: the last positions. Allocates nothing after the first call,
/// unless the recursion is not accurate enough. v* is zero unless m̄ is finite.
///
/// Errors: as percuss_workspace_effective_mass.
///
/// # Safety
/// workspace is a handle; positions is null or has count numbers; contact is null or points to a contact; response is null or points
/// to storage; velocities has space for velocity_count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_respond(
    workspace: *mut percuss_workspace,
    positions: *const f64,
    count: usize,
    contact: *const percuss_contact,
    response: *mut percuss_workspace_response,
    velocities: *mut f64,
    velocity_count: usize,
) -> percuss_status {
    guard_call(|| {
        let read =
            [ByteRange::of_array(positions, count, "positions"), ByteRange::of_array(contact, 1, "contact")];
        let written = [
            ByteRange::of_array(response, 1, "response"),
            ByteRange::of_array(velocities, velocity_count, "velocities"),
        ];
        refuse_overlaps(&written, &read)?;
        let mut workspace_guard = lock_object(object_of(workspace)?, "percuss_workspace")?;
        let to = argument_mut(response, "response")?;
        let c_contact = argument_ref(contact, "contact")?;
        expect_length(velocity_count, workspace_guard.model.velocities, "velocities")?;
        if !positions.is_null() || count > 0 {
            let positions = input_slice(positions, count, "positions")?;
            let set = workspace_guard.workspace.set_positions(positions);
            set.map_err(Failure::with_status(PERCUSS_ERROR_LENGTH))?;
        }
        let ModelWorkspace { model, workspace, last_contact, velocities: own } = &mut *workspace_guard;
        let (_, contact) = match last_contact {
            Some(last) if last.0 == *c_contact => last,
            _ => last_contact.insert((*c_contact, c_contact.resolve(model)?)),
        };
        let found = workspace.respond(contact, own).map_err(response_failure)?;
        copy_to_caller(own, velocities, velocity_count, "velocities")?;
        let (outcome, effective_mass) = outcome_and_value(found.effective_mass);
        let (w, v) = (found.base_velocity.angular, found.base_velocity.linear);
        *to = percuss_workspace_response {
            outcome,
            remarks: found.remarks.bits(),
            effective_mass,
            error: nan_if_unknown(found.error),
            base_velocity: [w.x, w.y, w.z, v.x, v.y, v.z],
        };
        Ok(())
    })
}

/// Sets the pose of the root link in the world, as percuss_configuration_set_base: for normals that are given in the
/// world.
///
/// Errors: PERCUSS_ERROR_ARGUMENT.
///
/// # Safety
/// workspace is a handle; position has 3 numbers, quaternion 4.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_set_base(
    workspace: *mut percuss_workspace,
    position: *const f64,
    quaternion: *const f64,
) -> percuss_status {
    guard_call(|| {
        let x_wr = read_base_pose(position, quaternion)?;
        let mut workspace_guard = lock_object(object_of(workspace)?, "percuss_workspace")?;
        workspace_guard.workspace.set_base(&x_wr).map_err(Failure::with_status(PERCUSS_ERROR_ARGUMENT))
    })
}

/// Output pointers of a result.
struct ResultPointers<'a> {
    outcome: &'a mut percuss_outcome,
    mass: &'a mut f64,
    remarks: Option<&'a mut u32>,
}

impl ResultPointers<'_> {
    /// Memory ranges of the outputs, for the check of overlaps.
    #[inline]
    fn byte_ranges(outcome: *const percuss_outcome, mass: *const f64, remarks: *const u32) -> [ByteRange; 3] {
        [
            ByteRange::of_array(outcome, 1, "outcome"),
            ByteRange::of_array(mass, 1, "effective_mass"),
            ByteRange::of_array(remarks, 1, "remarks"),
        ]
    }

    /// References to the outputs; `remarks` may be null.
    #[inline]
    fn from_pointers(
        outcome: *mut percuss_outcome,
        mass: *mut f64,
        remarks: *mut u32,
    ) -> Result<Self, Failure> {
        let remarks = if remarks.is_null() { None } else { Some(argument_mut(remarks, "remarks")?) };
        Ok(Self {
            outcome: argument_mut(outcome, "outcome")?,
            mass: argument_mut(mass, "effective_mass")?,
            remarks,
        })
    }
}

impl ModelWorkspace {
    /// Computes m̄ of a contact at the workspace's positions and writes the results. The last contact is kept resolved.
    #[inline]
    fn write_effective_mass(
        &mut self,
        c_contact: &percuss_contact,
        results: ResultPointers<'_>,
    ) -> Result<(), Failure> {
        let ModelWorkspace { model, workspace, last_contact, .. } = self;
        let (_, contact) = match last_contact {
            Some(last) if last.0 == *c_contact => last,
            _ => last_contact.insert((*c_contact, c_contact.resolve(model)?)),
        };
        let mass = workspace.effective_mass(contact).map_err(response_failure)?;
        (*results.outcome, *results.mass) = outcome_and_value(mass);
        if let Some(remarks) = results.remarks {
            *remarks = workspace.remarks().bits();
        }
        Ok(())
    }
}

/// Failure with the status for the kind of the error.
fn response_failure(error: ResponseError) -> Failure {
    let status = match &error {
        ResponseError::NotFinite { .. } | ResponseError::Quaternion { .. } => PERCUSS_ERROR_ARGUMENT,
        ResponseError::OpenLoops { .. } => PERCUSS_ERROR_ASSEMBLY,
        _ => PERCUSS_ERROR_CONTACT,
    };
    Failure::new(status, error)
}
