//! The whole response to a contact.

use crate::arrays::{Span, copy_out, expect_length, output, refuse_overlaps};
use crate::contact::{percuss_mass, summary};
use crate::handle::{Handle, free, get, place};
use crate::model::Model;
use crate::status::{Failure, PERCUSS_ERROR_CONTACT, guarded, percuss_status};
use percuss::ContactResponse;
use std::sync::Arc;

/// A response to a contact: m̄, v*, contributions. Cannot be changed: threads may share it.
pub struct percuss_response {
    _opaque: [u8; 0],
}

/// A response, with the names of links and joints.
pub(crate) struct Answered {
    pub model: Arc<Model>,
    pub response: ContactResponse,
}

impl Handle for percuss_response {
    type Object = Answered;
    const TAG: u64 = 0x7063_5f72_6573_706f;
    const NAME: &'static str = "percuss_response";
}

/// Frees a response and sets the handle to null; nothing where it is null.
///
/// # Safety
/// response is null or the place of a handle that nobody uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_free(response: *mut *mut percuss_response) -> percuss_status {
    guarded(|| free(response))
}

/// m̄ and its error.
///
/// # Safety
/// mass is null or a place for a percuss_mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_mass(
    response: *const percuss_response,
    mass: *mut percuss_mass,
) -> percuss_status {
    guarded(|| {
        *place(mass, "mass")? = summary(&get(response)?.response);
        Ok(())
    })
}

/// The same where the other side is a free mass (kg) of its own: 1/m̄ = 1/m̄₁ + 1/m₂.
///
/// # Safety
/// mass is null or a place for a percuss_mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_against_mass(
    response: *const percuss_response,
    other: f64,
    mass: *mut percuss_mass,
) -> percuss_status {
    guarded(|| {
        let together = get(response)?.response.clone().against_mass(other);
        *place(mass, "mass")? = summary(&together.map_err(Failure::of(PERCUSS_ERROR_CONTACT))?);
        Ok(())
    })
}

/// v*: the velocities of all joints at unit closing speed (1/m·rad, 1), one after another in joint order; count is that of
/// percuss_model_counts. Of a contact that is not finite too, where a motion is known; else zeros.
///
/// # Safety
/// velocities has room for count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_velocities(
    response: *const percuss_response,
    velocities: *mut f64,
    count: usize,
) -> percuss_status {
    guarded(|| {
        let all = get(response)?.response.joint_velocities.concat();
        copy_out(&all, velocities, count, "velocities")
    })
}

/// v* of a floating root link: 3 angular and 3 linear numbers, in its axes at its origin; zeros where it is the ground.
///
/// # Safety
/// twist has room for 6 numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_base_velocity(
    response: *const percuss_response,
    twist: *mut f64,
) -> percuss_status {
    guarded(|| {
        let base = get(response)?.response.base_velocity;
        let (w, v) = (base.angular, base.linear);
        copy_out(&[w.x, w.y, w.z, v.x, v.y, v.z], twist, 6, "twist")
    })
}

/// The contribution of each link to m̄, in link order (links numbers), and of the rotor of each joint (joints numbers): together 1.
/// Errors: PERCUSS_ERROR_CONTACT where m̄ is not finite.
///
/// # Safety
/// links has room for link_count numbers, rotors for joint_count; rotors may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_response_contributions(
    response: *const percuss_response,
    links: *mut f64,
    link_count: usize,
    rotors: *mut f64,
    joint_count: usize,
) -> percuss_status {
    guarded(|| {
        let answered = get(response)?;
        let written = [Span::of(links, link_count, "links"), Span::of(rotors, joint_count, "rotors")];
        refuse_overlaps(&written, &[])?;
        let contributions = answered.response.contributions.as_ref().ok_or_else(|| {
            Failure::new(PERCUSS_ERROR_CONTACT, "m̄ is not finite: no link contributes to it")
        })?;
        copy_out(&contributions.links, links, link_count, "links")?;
        if !rotors.is_null() {
            expect_length(joint_count, answered.model.joints.len(), "rotors")?;
            let to = output(rotors, joint_count, "rotors")?;
            to.fill(0.0);
            contributions.rotors.iter().for_each(|(joint, part)| to[joint.index()] = *part);
        }
        Ok(())
    })
}
