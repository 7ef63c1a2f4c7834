//! Rigid impacts at many poses, contacts or speeds, in reused memory.

use crate::error::ImpactError;
use crate::reactions::reaction_map::{ReactionBuffers, ReactionMap};
use crate::rigid::impact::{RigidImpact, checked_mass};
use percuss_dynamics::{Contact, Pose, RemarkFlags, Workspace};

/// Rigid impacts without friction at the contacts of one system, for many poses, contacts or speeds.
///
/// The results are those of [`RigidImpact::new`] for the motion v* c before the impact. The recursion computes m̄ and v* only, without the
/// contributions of the links and the error budget of [`Pose::respond`]. The constraints are factorised once per pose.
#[derive(Clone, Debug)]
pub struct ImpactWorkspace {
    map: ReactionMap,
    responses: Workspace,
    /// v* of all joints.
    star: Vec<f64>,
    buffers: ReactionBuffers,
}

impl ImpactWorkspace {
    /// Workspace for the poses of the system of `pose`.
    pub fn new(pose: &Pose) -> Self {
        let responses = pose.assembly().workspace();
        Self { map: ReactionMap::new(pose), responses, star: Vec::new(), buffers: ReactionBuffers::default() }
    }

    /// Impacts at a pose of the same system.
    ///
    /// # Panics
    /// If the pose belongs to another mechanism.
    pub fn at<'a>(&'a mut self, pose: &'a Pose) -> ImpactsAtPose<'a> {
        self.map.update(pose);
        ImpactsAtPose { workspace: self, pose }
    }
}

/// Rigid impacts at one pose, for many contacts or speeds: [`ImpactWorkspace::at`].
#[derive(Debug)]
pub struct ImpactsAtPose<'a> {
    workspace: &'a mut ImpactWorkspace,
    pose: &'a Pose,
}

impl ImpactsAtPose<'_> {
    /// Impact of a contact with the closing speed `closing_speed` (m/s) and the coefficient of restitution `restitution`.
    ///
    /// # Errors
    /// [`ImpactError`]: values out of range; an immovable or massless contact; an invalid contact.
    pub fn impact(
        &mut self,
        contact: &Contact,
        closing_speed: f64,
        restitution: f64,
    ) -> Result<RigidImpact, ImpactError> {
        let mut impact = RigidImpact::none();
        self.impact_into(contact, closing_speed, restitution, &mut impact)?;
        Ok(impact)
    }

    /// As [`impact`](Self::impact), but writes to `impact` and reuses its memory. After the first call it allocates only in the dense
    /// route, if a massless motion leaves rates undetermined, and for the loops of indeterminate reactions.
    ///
    /// # Errors
    /// As for [`impact`](Self::impact); the contents of `impact` are then undefined.
    pub fn impact_into(
        &mut self,
        contact: &Contact,
        closing_speed: f64,
        restitution: f64,
        impact: &mut RigidImpact,
    ) -> Result<(), ImpactError> {
        let (ImpactWorkspace { map, responses, star, buffers }, pose) = (&mut *self.workspace, self.pose);
        let found = responses.respond_at(pose, contact, star)?;
        if found.remarks.contains(RemarkFlags::UNDETERMINED_MOTION) {
            let response = pose.respond(contact)?;
            *impact = RigidImpact::with_reaction_map(pose, map, &response, closing_speed, restitution, None)?;
            return Ok(());
        }
        let mass = checked_mass(found.effective_mass, closing_speed, restitution)?;
        let (mass_at, base) = (found.effective_mass, found.base_velocity);
        impact.restitution = restitution;
        impact.closing_speed = closing_speed;
        impact.impulse = (1.0 + restitution) * mass * closing_speed;
        impact.energy_loss = 0.5 * mass * (1.0 - restitution * restitution) * closing_speed * closing_speed;
        impact.before.set_scaled(map.tree(), star, base, closing_speed);
        impact.after.set_scaled(map.tree(), star, base, -restitution * closing_speed);
        impact.undetermined.clear();
        impact.friction = None;
        let (rates, reactions) = (star.iter().copied(), &mut impact.reactions);
        map.reactions_of_motion(&found.contact, mass_at, rates, base, impact.impulse, buffers, reactions)?;
        Ok(())
    }
}
