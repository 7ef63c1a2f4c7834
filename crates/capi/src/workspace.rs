//! Workspaces: one configuration after another, without allocations.

use crate::arrays::input;
use crate::contact::{outcome, percuss_contact, percuss_outcome};
use crate::handle::{Exclusive, Handle, clear, free, get, give, lent, place, take};
use crate::model::Model;
use crate::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_LENGTH, guarded, percuss_status,
};
use crate::system::percuss_assembly;
use percuss::{Contact, ResponseError, Workspace};
use std::sync::Arc;

/// Room to pose an assembly again and again and to ask for m̄. One thread at a time: each thread its own.
pub struct percuss_workspace {
    _opaque: [u8; 0],
}

/// A workspace, with the names of links.
pub(crate) struct Room {
    model: Arc<Model>,
    workspace: Workspace,
    /// The contact that was asked for last, as it was given and as it is on the model.
    asked: Option<(percuss_contact, Contact)>,
}

impl Handle for percuss_workspace {
    type Object = Exclusive<Room>;
    const TAG: u64 = 0x7063_5f77_6f72_6b73;
    const NAME: &'static str = "percuss_workspace";
}

/// Room for many poses of an assembly; it stands at its first closed pose. Free it with percuss_workspace_free.
///
/// # Safety
/// assembly is a handle; workspace is null or a place for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_new(
    assembly: *const percuss_assembly,
    workspace: *mut *mut percuss_workspace,
) -> percuss_status {
    guarded(|| {
        clear(workspace)?;
        let assembled = get(assembly)?;
        let (model, inside) = (Arc::clone(&assembled.model), assembled.assembly.workspace());
        let room = Room { model, workspace: inside, asked: None };
        give(Exclusive::new(room), workspace)
    })
}

/// Frees a workspace and sets the handle to null; nothing where it is null.
///
/// # Safety
/// workspace is null or the place of a handle that nobody uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_free(workspace: *mut *mut percuss_workspace) -> percuss_status {
    guarded(|| free(workspace))
}

/// m̄ of a contact at the positions of all joints (one after another, in joint order; unit quaternions; those of mimics are not
/// read). Loops are taken as closed there: positions of a pose of the same assembly are. null: at the positions last given.
///
/// effective_mass: kg; NaN unless the outcome is PERCUSS_FINITE. States no error: percuss_pose_effective_mass does. Allocates nothing
/// after the first call, but where the recursion is not accurate enough. Points and normals in the world are taken with the
/// root link at the world's origin.
///
/// Errors: PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_CONTACT; PERCUSS_ERROR_ARGUMENT: a position that matters is not finite;
/// PERCUSS_ERROR_BUSY where another thread uses the workspace.
///
/// # Safety
/// workspace is a handle; positions is null or has count numbers; contact is null or points to a contact; the other pointers are null
/// or places.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_workspace_effective_mass(
    workspace: *mut percuss_workspace,
    positions: *const f64,
    count: usize,
    contact: *const percuss_contact,
    outcome_place: *mut percuss_outcome,
    effective_mass: *mut f64,
) -> percuss_status {
    guarded(|| {
        let mut room = take(get(workspace)?, "percuss_workspace")?;
        let (to_outcome, to_mass) =
            (place(outcome_place, "outcome")?, place(effective_mass, "effective_mass")?);
        let given = lent(contact, "contact")?;
        let Room { model, workspace, asked } = &mut *room;
        let (_, contact) = match asked {
            Some(last) if last.0 == *given => last,
            _ => asked.insert((*given, given.on(model)?)),
        };
        if !positions.is_null() {
            let positions = input(positions, count, "positions")?;
            workspace.set_positions(positions).map_err(Failure::of(PERCUSS_ERROR_LENGTH))?;
        }
        let mass = workspace.effective_mass(contact).map_err(|error| {
            let of_positions = matches!(error, ResponseError::NotFinite { .. });
            Failure::new(if of_positions { PERCUSS_ERROR_ARGUMENT } else { PERCUSS_ERROR_CONTACT }, error)
        })?;
        (*to_outcome, *to_mass) = outcome(mass);
        Ok(())
    })
}
