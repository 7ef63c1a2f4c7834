//! Full response to a contact.

use crate::boundary::arrays::{ByteRange, copy_to_caller, expect_length, output_slice, refuse_overlaps};
use crate::boundary::handle::{Handle, argument_mut, free_handle, object_of};
use crate::boundary::status::{Failure, PERCUSS_ERROR_CONTACT, guard_call, percuss_status};
use crate::evaluation::contact::{mass_summary, percuss_mass};
use crate::setup::model::Model;
use percuss::ContactResponse;
use std::sync::Arc;

/// A response to a contact: m̄, v*, contributions. Immutable, so that threads can share it.
pub struct percuss_response {
    _opaque: [u8; 0],
}

/// A response, with the names of links and joints.
pub(crate) struct NamedResponse {
    pub model: Arc<Model>,
    pub response: ContactResponse,
}

impl Handle for percuss_response {
    type Object = NamedResponse;
    const TAG: u64 = 0x7063_5f72_6573_706f;
    const NAME: &'static str = "percuss_response";
}

/// Frees a response and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// response is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_free(response: *mut *mut percuss_response) -> percuss_status {
    guard_call(|| free_handle(response))
}

/// m̄ and its error.
///
/// # Safety
/// mass is null or points to storage for a percuss_mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_mass(
    response: *const percuss_response,
    mass: *mut percuss_mass,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(mass, "mass")? = mass_summary(&object_of(response)?.response);
        Ok(())
    })
}

/// m̄ and its error with a free body of mass other (kg) as the other side: 1/m̄ = 1/m̄₁ + 1/m₂.
///
/// # Safety
/// mass is null or points to storage for a percuss_mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_against_mass(
    response: *const percuss_response,
    other: f64,
    mass: *mut percuss_mass,
) -> percuss_status {
    guard_call(|| {
        let together = object_of(response)?.response.clone().against_mass(other);
        *argument_mut(mass, "mass")? =
            mass_summary(&together.map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?);
        Ok(())
    })
}

/// v*: the velocities of all joints at unit closing speed (1/m·rad, 1), concatenated in joint order; count is the
/// velocities of percuss_model_counts. Also defined for a contact that is not finite, if a motion is known; else zeros.
///
/// # Safety
/// velocities has space for count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_velocities(
    response: *const percuss_response,
    velocities: *mut f64,
    count: usize,
) -> percuss_status {
    guard_call(|| {
        let all = object_of(response)?.response.joint_velocities.concat();
        copy_to_caller(&all, velocities, count, "velocities")
    })
}

/// v* of a floating root link: 3 angular and 3 linear numbers, in its axes at its origin; zeros for a fixed root link.
///
/// # Safety
/// twist has space for 6 numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_base_velocity(
    response: *const percuss_response,
    twist: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let base = object_of(response)?.response.base_velocity;
        let (w, v) = (base.angular, base.linear);
        copy_to_caller(&[w.x, w.y, w.z, v.x, v.y, v.z], twist, 6, "twist")
    })
}

/// The contribution of each link to m̄, in link order (link_count numbers), and of the rotor of each joint (joint_count
/// numbers): their sum is 1. Errors: PERCUSS_ERROR_CONTACT if m̄ is not finite.
///
/// # Safety
/// links has space for link_count numbers, rotors for joint_count; rotors may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_contributions(
    response: *const percuss_response,
    links: *mut f64,
    link_count: usize,
    rotors: *mut f64,
    joint_count: usize,
) -> percuss_status {
    guard_call(|| {
        let named_response = object_of(response)?;
        let written = [
            ByteRange::of_array(links, link_count, "links"),
            ByteRange::of_array(rotors, joint_count, "rotors"),
        ];
        refuse_overlaps(&written, &[])?;
        let contributions = named_response.response.contributions.as_ref().ok_or_else(|| {
            Failure::new(PERCUSS_ERROR_CONTACT, "m̄ is not finite: no link contributes to it")
        })?;
        copy_to_caller(&contributions.links, links, link_count, "links")?;
        if !rotors.is_null() {
            expect_length(joint_count, named_response.model.joints.len(), "rotors")?;
            let to = output_slice(rotors, joint_count, "rotors")?;
            to.fill(0.0);
            contributions.rotors.iter().for_each(|(joint, part)| to[joint.index()] = *part);
        }
        Ok(())
    })
}
