//! A mechanism under conditions.

use crate::assembling::{AssemblyError, Facts};
use crate::assembly::{Assembly, Models};
use crate::conditions::{Base, Conditions, ConditionsError};
use crate::configuration::Configuration;
use crate::kinematics::Kinematics;
use crate::model::Model;
use crate::pose::Pose;
use percuss_mechanism::{JointId, LinkId, Mechanism};
use std::sync::{Arc, OnceLock};

/// A [`Mechanism`] under [`Conditions`], ready to be put together and posed. Immutable and `Send + Sync`.
///
/// Its coordinates u (n of them) are the independent velocities: of the floating base, then of every joint that
/// is neither locked nor a mimic, in tree order.
#[derive(Clone, Debug)]
pub struct System {
    models: Models,
    /// The assembly from all joints at 0, found when first asked for: a function of the models alone.
    reference: Arc<OnceLock<Result<Arc<Assembly>, AssemblyError>>>,
    /// What would be known if the loops were left as they are drawn, where they do not close.
    open: Arc<OnceLock<Arc<Assembly>>>,
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
        Ok(Self { models: Models { answering, posing }, reference: Arc::default(), open: Arc::default() })
    }

    /// The mechanism it was compiled from.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        &self.model().mechanism
    }

    /// How the root link stands.
    pub fn base(&self) -> Base {
        self.model().base
    }

    pub(crate) fn model(&self) -> &Arc<Model> {
        &self.models.answering
    }

    /// How many coordinates there are: independent velocities of the tree; a floating base counts 6.
    pub fn coordinates(&self) -> usize {
        self.model().coordinates.len()
    }

    /// What each coordinate is: a joint (none: the floating base) and the number of its velocity.
    pub fn coordinate_joints(&self) -> Vec<(Option<JointId>, usize)> {
        self.model().coordinates.iter().map(|c| (c.joint, c.component)).collect()
    }

    /// Whether the joint cannot move: locked itself, or a mimic and its master where either is. False for a joint of another
    /// mechanism.
    pub fn is_locked(&self, joint: JointId) -> bool {
        self.mechanism().has_joint(joint) && self.model().locked[joint.index()]
    }

    /// Whether a loop or a coupling binds a joint.
    pub fn is_bound(&self, joint: JointId) -> bool {
        self.models.posing.groups.iter().any(|group| group.joints.contains(&Some(joint)))
    }

    /// Closures whose axis points one way in the predecessor's loop frame and the other way in the successor's, with all
    /// joints at 0; they are imposed with the successor's reversed.
    pub fn reversed_axes(&self) -> impl Iterator<Item = &str> {
        self.models.posing.closures.iter().filter(|l| l.successor_axis != l.axis).map(|l| l.name.as_str())
    }

    /// Mass of the rigid body that a link belongs to, with all that fixed joints hold to it, kg; none for the ground, and for
    /// a link of another mechanism.
    pub fn rigid_body_mass(&self, link: LinkId) -> Option<f64> {
        let body =
            self.model().link_frames.get(link.index()).filter(|_| self.mechanism().has_link(link))?.body;
        body.map(|body| self.model().bodies[body].inertia.mass)
    }

    /// Every joint at zero.
    pub fn configuration(&self) -> Configuration {
        Configuration::zero(self.mechanism())
    }

    /// The assembly found from all joints at 0.
    ///
    /// # Errors
    /// [`AssemblyError`]: loops that do not close from there.
    pub fn reference(&self) -> Result<&Arc<Assembly>, AssemblyError> {
        let found = self.reference.get_or_init(|| self.put_together(Kinematics::zero(&self.models.posing)));
        found.as_ref().map_err(Clone::clone)
    }

    /// The loops put together from a configuration's guesses, where joints that are not guessed start at 0.
    ///
    /// # Errors
    /// [`AssemblyError`]: loops that do not close from there.
    pub fn assemble(&self, guesses: &Configuration) -> Result<Arc<Assembly>, AssemblyError> {
        let posing = &self.models.posing;
        let mut start = Kinematics::zero(posing);
        for group in &posing.groups {
            if let Some(guess) = guesses.guess_for(&posing.joint_q, &group.joints) {
                posing.set_group(&mut start, group, &guess);
            }
        }
        start.refill(posing);
        self.put_together(start)
    }

    fn put_together(&self, start: Kinematics<f64>) -> Result<Arc<Assembly>, AssemblyError> {
        let facts = self.models.posing.put_together(start)?;
        Ok(Arc::new(Assembly::new(self.models.clone(), facts)))
    }

    /// The pose at a configuration: of the assembly found from all joints at 0, or, where nothing closes from there, of
    /// that found from the configuration's guesses.
    ///
    /// # Errors
    /// [`AssemblyError`]: loops that do not close, drivers that cannot get there, a dependent joint that was set.
    pub fn pose(&self, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        match self.reference() {
            Ok(assembly) => assembly.pose(configuration),
            Err(failed) if !configuration.has_guesses() => Err(failed),
            Err(_) => self.assemble(configuration)?.pose(configuration),
        }
    }

    /// The pose at a configuration on the branch of another pose of this system, followed from there: through
    /// crossings of branches too.
    ///
    /// # Errors
    /// [`AssemblyError`], as for [`pose`](Self::pose); a pose of another system.
    pub fn pose_from(&self, from: &Pose, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        if !from.assembly.is_of(self.model()) {
            return Err(AssemblyError::ForeignPose);
        }
        from.assembly.pose_from(from, configuration)
    }

    /// The same pose under the conditions of this system: of the same mechanism with the same base, other locks, held
    /// contacts or armatures.
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
        Ok(pose.assembly.under(self.models.clone()).pose_at(
            pose.kinematics.clone(),
            pose.base,
            pose.loops.clone(),
            pose,
        ))
    }

    /// The reference assembly, or, where nothing closes from zero, what would be known with the loops as they are drawn.
    pub fn reference_or_open(&self) -> &Arc<Assembly> {
        match self.reference() {
            Ok(assembly) => assembly,
            Err(_) => self.open.get_or_init(|| {
                let zero = Kinematics::zero(&self.models.posing);
                let facts: Facts = self.models.posing.left_open(zero);
                Arc::new(Assembly::new(self.models.clone(), facts))
            }),
        }
    }

    /// Degrees of freedom at a generic pose; a floating base counts 6. Loops that do not close count as drawn.
    pub fn degrees_of_freedom(&self) -> usize {
        self.reference_or_open().degrees_of_freedom()
    }
}
