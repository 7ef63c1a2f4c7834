//! A mechanism under conditions.

use crate::analysis::assembly::{Assembly, Models};
use crate::analysis::pose::Pose;
use crate::kinematics::frames::Kinematics;
use crate::loops::assembling::{AssemblyError, Facts};
use crate::model::Model;
use crate::model::conditions::{Base, Conditions, ConditionsError};
use crate::model::configuration::Configuration;
use percuss_mechanism::{JointId, LinkId, Mechanism};
use std::sync::{Arc, OnceLock};

/// A [`Mechanism`] under [`Conditions`], ready for assembly and poses. Immutable and `Send + Sync`.
///
/// The n coordinates u are the independent velocities: of the floating base, then of every joint that is neither
/// locked nor a mimic, in tree order.
#[derive(Clone, Debug)]
pub struct System {
    models: Models,
    /// Assembly found from all joints at 0, computed on first use from the models alone.
    reference: Arc<OnceLock<Result<Arc<Assembly>, AssemblyError>>>,
    /// Assembly with the loops left open as drawn, for loops that do not close.
    open_assembly: Arc<OnceLock<Arc<Assembly>>>,
}

impl System {
    /// Compiles a mechanism with the conditions of an analysis.
    ///
    /// # Errors
    /// [`ConditionsError`]: an unknown joint, a condition given twice, a bad armature or hold.
    pub fn new(
        mechanism: impl Into<Arc<Mechanism>>,
        conditions: &Conditions,
    ) -> Result<Self, ConditionsError> {
        let mechanism = mechanism.into();
        let answering = Arc::new(Model::compile(&mechanism, conditions)?);
        let posing = match conditions.holds_velocities() {
            false => Arc::clone(&answering),
            true => Arc::new(Model::compile(&mechanism, &conditions.clone().without_holds())?),
        };
        Ok(Self {
            models: Models { mass_model: answering, pose_model: posing },
            reference: Arc::default(),
            open_assembly: Arc::default(),
        })
    }

    /// The mechanism from which the system was compiled.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        &self.model().mechanism
    }

    /// Attachment of the root link to the world.
    pub fn base(&self) -> Base {
        self.model().base
    }

    /// Model with locks and held contacts.
    pub(crate) fn model(&self) -> &Arc<Model> {
        &self.models.mass_model
    }

    /// Number of coordinates: independent velocities of the tree. A floating base counts 6.
    pub fn coordinates(&self) -> usize {
        self.model().coordinates.len()
    }

    /// Joint and velocity index of each coordinate; the joint is `None` for the floating base.
    pub fn coordinate_joints(&self) -> Vec<(Option<JointId>, usize)> {
        self.model().coordinates.iter().map(|c| (c.joint, c.component)).collect()
    }

    /// True if the joint cannot move: a locked joint, or a mimic or master of a locked joint. False for a joint of
    /// another mechanism.
    pub fn is_locked(&self, joint: JointId) -> bool {
        self.mechanism().has_joint(joint) && self.model().locked[joint.index()]
    }

    /// True if a loop or a coupling constrains the joint.
    pub fn is_bound(&self, joint: JointId) -> bool {
        self.models.pose_model.groups.iter().any(|group| group.joints.contains(&Some(joint)))
    }

    /// Closures whose axis in the predecessor's loop frame is opposite to the axis in the successor's frame, with all
    /// joints at 0. The constraint uses the reversed axis of the successor.
    pub fn reversed_axes(&self) -> impl Iterator<Item = &str> {
        self.models.pose_model.closures.iter().filter(|l| l.successor_axis != l.axis).map(|l| l.name.as_str())
    }

    /// Mass of the rigid body of a link, including all links attached by fixed joints, kg. `None` for the ground and
    /// for a link of another mechanism.
    pub fn rigid_body_mass(&self, link: LinkId) -> Option<f64> {
        let body =
            self.model().link_frames.get(link.index()).filter(|_| self.mechanism().has_link(link))?.body;
        body.map(|body| self.model().bodies[body].inertia.mass)
    }

    /// Configuration with every joint at zero.
    pub fn configuration(&self) -> Configuration {
        Configuration::zero(self.mechanism())
    }

    /// The assembly found from all joints at 0.
    ///
    /// # Errors
    /// [`AssemblyError`]: the loops do not close from this start.
    pub fn reference(&self) -> Result<&Arc<Assembly>, AssemblyError> {
        let found =
            self.reference.get_or_init(|| self.assemble_from(Kinematics::zero(&self.models.pose_model)));
        found.as_ref().map_err(Clone::clone)
    }

    /// Closes the loops starting from the guesses of a configuration. Joints without a guess start at 0.
    ///
    /// # Errors
    /// [`AssemblyError`]: the loops do not close from this start.
    pub fn assemble(&self, guesses: &Configuration) -> Result<Arc<Assembly>, AssemblyError> {
        let posing = &self.models.pose_model;
        let mut start = Kinematics::zero(posing);
        for group in &posing.groups {
            if let Some(guess) = guesses.guess_for(&posing.joint_q, &group.joints) {
                posing.set_group(&mut start, group, &guess);
            }
        }
        start.refill(posing);
        self.assemble_from(start)
    }

    /// Closes the loops from a start, and collects the facts about the loops.
    fn assemble_from(&self, start: Kinematics) -> Result<Arc<Assembly>, AssemblyError> {
        let facts = self.models.pose_model.find_loop_facts(start)?;
        Ok(Arc::new(Assembly::new(self.models.clone(), facts)))
    }

    /// Pose at a configuration. The pose belongs to the assembly found from all joints at 0 or, if the loops do not
    /// close from there, to the assembly found from the guesses of the configuration.
    ///
    /// # Errors
    /// [`AssemblyError`]: loops that do not close, unreachable positions of driving joints, a dependent joint that
    /// was set.
    pub fn pose(&self, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        match self.reference() {
            Ok(assembly) => assembly.pose(configuration),
            Err(failed) if !configuration.has_guesses() => Err(failed),
            Err(_) => self.assemble(configuration)?.pose(configuration),
        }
    }

    /// Pose at a configuration on the branch of another pose of this system. The branch is followed from that pose,
    /// also through crossings of branches.
    ///
    /// # Errors
    /// [`AssemblyError`], as for [`pose`](Self::pose); a pose of another system.
    pub fn pose_from(&self, from: &Pose, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        if !from.assembly.is_for_model(self.model()) {
            return Err(AssemblyError::ForeignPose);
        }
        from.assembly.pose_from(from, configuration)
    }

    /// Transfers a pose of the same mechanism with the same base to the conditions of this system, with its own
    /// locks, held contacts and armatures.
    ///
    /// # Errors
    /// [`AssemblyError::ForeignPose`]: a pose of another mechanism, or with another base.
    pub fn pose_like(&self, pose: &Pose) -> Result<Pose, AssemblyError> {
        let (own, theirs) = (self.model(), pose.assembly.model());
        if !Arc::ptr_eq(&own.mechanism, &theirs.mechanism)
            || own.base != theirs.base
            || own.bodies.len() != theirs.bodies.len()
        {
            return Err(AssemblyError::ForeignPose);
        }
        Ok(pose.assembly.with_models(self.models.clone()).pose_at(
            pose.kinematics.clone(),
            pose.base,
            pose.loops.clone(),
            pose,
        ))
    }

    /// The reference assembly or, if the loops do not close from zero, the assembly with the loops left open as
    /// drawn.
    pub fn reference_or_open(&self) -> &Arc<Assembly> {
        match self.reference() {
            Ok(assembly) => assembly,
            Err(_) => self.open_assembly.get_or_init(|| {
                let zero = Kinematics::zero(&self.models.pose_model);
                let facts: Facts = self.models.pose_model.open_loop_facts(zero);
                Arc::new(Assembly::new(self.models.clone(), facts))
            }),
        }
    }

    /// Degrees of freedom at a generic pose; a floating base counts 6. Loops that do not close are counted as drawn.
    pub fn degrees_of_freedom(&self) -> usize {
        self.reference_or_open().degrees_of_freedom()
    }
}
