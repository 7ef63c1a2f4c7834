//! Rigid impacts at many poses, contacts or speeds, in reused memory.

use crate::error::ImpactError;
use crate::motion::joint_rates::JointRates;
use crate::reactions::reaction_map::ReactionMap;
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
}

impl ImpactWorkspace {
    /// Workspace for the poses of the system of `pose`.
    pub fn new(pose: &Pose) -> Self {
        let responses = pose.assembly().workspace();
        Self { map: ReactionMap::new(pose), responses, star: Vec::new() }
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
        let (ImpactWorkspace { map, responses, star }, pose) = (&mut *self.workspace, self.pose);
        let found = responses.respond_at(pose, contact, star)?;
        if found.remarks.contains(RemarkFlags::UNDETERMINED_MOTION) {
            let response = pose.respond(contact)?;
            return RigidImpact::with_reaction_map(pose, map, &response, closing_speed, restitution, None);
        }
        let mass = checked_mass(found.effective_mass, closing_speed, restitution)?;
        let impulse = (1.0 + restitution) * mass * closing_speed;
        let base = found.base_velocity;
        let rates = star.iter().copied();
        let reactions =
            map.reactions_of_motion(&found.contact, found.effective_mass, rates, base, impulse)?;
        let rates = |factor: f64| {
            let tree = map.tree();
            let of_joint = |joint| tree.of_joint(joint, star).iter().map(|v| factor * v).collect();
            JointRates { joints: tree.mechanism.joint_ids().map(of_joint).collect(), base: base * factor }
        };
        Ok(RigidImpact {
            restitution,
            closing_speed,
            impulse,
            energy_loss: 0.5 * mass * (1.0 - restitution * restitution) * closing_speed * closing_speed,
            before: rates(closing_speed),
            after: rates(-restitution * closing_speed),
            undetermined: Vec::new(),
            friction: None,
            reactions,
        })
    }
}
