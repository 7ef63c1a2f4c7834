//! Rigid impact at a contact.

use crate::boundary::arrays::{
    ByteRange, copy_to_caller, expect_length, input_slice, nan_if_unknown, output_slice, refuse_overlaps,
};
use crate::boundary::handle::{argument_mut, object_of, read_argument};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_CONTACT, guard_call, percuss_status,
};
use crate::evaluation::contact::percuss_contact;
use crate::evaluation::pose::percuss_pose;
use percuss::impact::{ImpactError, JointRates, JointReaction, RigidImpact, closing_speed};
use percuss::spatial::Twist;

/// Numbers of the reaction in one joint: three of the impulse, three of its moment.
const REACTION: usize = 6;

/// Largest relative difference of the given speed from the closing speed of the velocities: both may have six digits.
const SAME_SPEED: f64 = 1e-5;

/// Result of a rigid impact.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct percuss_rigid_impact {
    /// Impulse between the two sides, (1+e) m̄ c, N·s.
    pub impulse: f64,
    /// Lost kinetic energy, ½ m̄ (1−e²) c², J.
    pub energy_loss: f64,
    /// Largest unbalanced impulse of the reactions, relative to the impulse.
    pub residual: f64,
}

/// Rigid impact without friction at a contact, with the closing speed (m/s) and the coefficient of restitution (0 to 1).
///
/// before (count numbers, or null): the velocities of all joints before the impact, concatenated in joint order, as for
/// percuss_response_velocities; they must have this closing speed, and the base is then at rest. null: the motion of least energy with
/// this closing speed, v* times the speed. after (count numbers, or null): the velocities after the impact.
/// reactions (6 joint_count numbers, or null): for each joint the impulse of the parent on the child, N·s, along two transverse
/// directions and the axis of the joint, then its moment about the child's origin, N·m·s; NaN for a component that redundant loops leave
/// open.
///
/// Errors: PERCUSS_ERROR_ARGUMENT: speed or restitution out of range, or velocities in before with another closing speed.
/// PERCUSS_ERROR_CONTACT: an invalid contact, or a contact without finite m̄.
///
/// # Safety
/// pose is a handle; contact and impact are null or point to their types; before, after and reactions are null or have space for the
/// given counts.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments, reason = "arrays of the caller with their lengths")]
pub unsafe extern "C" fn percuss_pose_impact(
    pose: *const percuss_pose,
    contact: *const percuss_contact,
    speed: f64,
    restitution: f64,
    before: *const f64,
    after: *mut f64,
    count: usize,
    reactions: *mut f64,
    reaction_count: usize,
    impact: *mut percuss_rigid_impact,
) -> percuss_status {
    guard_call(|| {
        let posed = object_of(pose)?;
        let contact = read_argument(contact, "contact")?.resolve(&posed.model)?;
        let written = [
            ByteRange::of_array(after, count, "after"),
            ByteRange::of_array(reactions, reaction_count, "reactions"),
        ];
        refuse_overlaps(&written, &[ByteRange::of_array(before, count, "before")])?;
        let response = posed.pose.respond(&contact).map_err(Failure::with_status(PERCUSS_ERROR_CONTACT))?;
        let before = if before.is_null() {
            None
        } else {
            let numbers = input_slice(before, count, "before")?;
            let rates = split(&response.joint_velocities, numbers)?;
            let closing = closing_speed(&posed.pose, &response.contact, &rates);
            if (closing - speed).abs() > SAME_SPEED * speed.abs() {
                let message = format_args!(
                    "speed is {speed} m/s, but the velocities in before have the closing speed {closing} m/s; expected equal values"
                );
                return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
            }
            Some(rates)
        };
        let found =
            RigidImpact::new(&posed.pose, &response, speed, restitution, before).map_err(|error| {
                let status = match error {
                    ImpactError::Restitution { .. } | ImpactError::ClosingSpeed { .. } => {
                        PERCUSS_ERROR_ARGUMENT
                    }
                    _ => PERCUSS_ERROR_CONTACT,
                };
                Failure::new(status, error)
            })?;
        if !after.is_null() {
            copy_to_caller(&found.after.joints.concat(), after, count, "after")?;
        }
        if !reactions.is_null() {
            expect_length(reaction_count, REACTION * found.reactions.joints.len(), "reactions")?;
            let numbers = found.reactions.joints.iter().flat_map(components);
            let to = output_slice(reactions, reaction_count, "reactions")?;
            to.iter_mut().zip(numbers).for_each(|(to, value)| *to = value);
        }
        *argument_mut(impact, "impact")? = percuss_rigid_impact {
            impulse: found.impulse,
            energy_loss: found.energy_loss,
            residual: found.reactions.residual,
        };
        Ok(())
    })
}

/// Velocities of all joints, with those of `layout` as the layout.
fn split(layout: &[Vec<f64>], numbers: &[f64]) -> Result<JointRates, Failure> {
    expect_length(numbers.len(), layout.iter().map(Vec::len).sum(), "before")?;
    if let Some(k) = numbers.iter().position(|v| !v.is_finite()) {
        let message = format_args!("before: number {k} (from 0) is {}; expected a finite number", numbers[k]);
        return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
    }
    let mut rest = numbers;
    let mut joints = Vec::with_capacity(layout.len());
    for joint in layout {
        let (own, others) = rest.split_at(joint.len());
        joints.push(own.to_vec());
        rest = others;
    }
    Ok(JointRates { joints, base: Twist::zero() })
}

/// Force, then moment; NaN for an open component.
fn components(joint: &JointReaction) -> impl Iterator<Item = f64> {
    let (force, moment) = (joint.reaction.force, joint.reaction.moment);
    force.into_iter().chain(moment).map(|component| nan_if_unknown(component.value()))
}
