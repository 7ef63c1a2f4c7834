//! Rigid impacts at many poses, contacts or speeds, in reused memory.

use crate::error::ImpactError;
use crate::motion::joint_rates::JointRates;
use crate::reactions::reaction_map::ReactionMap;
use crate::rigid::impact::{RigidImpact, checked_mass};
use percuss_dynamics::{Contact, Pose, RemarkFlags, ResponseError, Workspace};

/// Rigid impacts without friction at the contacts of one system, for many poses, contacts or speeds.
///
/// The results are those of [`RigidImpact::new`] for the motion v* c before the impact. The recursion computes m̄ and v* without the
/// additional results of [`Pose::respond`] (contributions of the links, error budget). The constraints are factorised once per pose.
#[derive(Clone, Debug)]
pub struct ImpactWorkspace {
    pose: Pose,
    map: ReactionMap,
    responses: Workspace,
    /// True if `responses` is at `pose`; otherwise [`Pose::respond`] is used.
    is_set: bool,
    /// v* of all joints.
    star: Vec<f64>,
}

impl ImpactWorkspace {
    /// Workspace at a pose.
    pub fn new(pose: &Pose) -> Self {
        let responses = pose.assembly().workspace();
        let map = ReactionMap::new(pose);
        let mut workspace = Self { pose: pose.clone(), map, responses, is_set: false, star: Vec::new() };
        workspace.set_responses();
        workspace
    }

    /// Moves the workspace to another pose of the same system.
    ///
    /// # Panics
    /// If the pose belongs to another mechanism.
    pub fn move_to(&mut self, pose: &Pose) {
        self.map.update(pose);
        self.pose.clone_from(pose);
        self.set_responses();
    }

    fn set_responses(&mut self) {
        self.is_set = self.responses.set_positions(self.pose.positions()).is_ok()
            && self.responses.set_base(self.pose.base()).is_ok();
    }

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
        let found = self.responses.respond(contact, &mut self.star)?;
        if !self.is_set || found.remarks.contains(RemarkFlags::UNDETERMINED_MOTION) {
            let (pose, map) = (&self.pose, &self.map);
            let response = pose.respond(contact)?;
            return RigidImpact::with_reaction_map(pose, map, &response, closing_speed, restitution, None);
        }
        let mass = checked_mass(found.effective_mass, closing_speed, restitution)?;
        let located = self.pose.locate(contact).map_err(ResponseError::from)?;
        let impulse = (1.0 + restitution) * mass * closing_speed;
        let star = self.star.iter().copied();
        let base = found.base_velocity;
        let reactions = self.map.reactions_of_motion(&located, found.effective_mass, star, base, impulse)?;
        let rates = |factor: f64| {
            let tree = self.map.tree();
            let of_joint = |joint| tree.of_joint(joint, &self.star).iter().map(|v| factor * v).collect();
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
