//! Poses of an assembly.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::kinematics::frames::Kinematics;
use crate::loops::assembling::{AssemblyError, Closer, LoopState, Start};
use crate::model::configuration::Configuration;
use crate::model::input::rigid_base_pose;
use crate::model::interruption;
use percuss_spatial::Transform;
use std::sync::Arc;

impl Assembly {
    /// Pose at a configuration. Joints that were set drive; the other joints of the loops depend on them. The branch
    /// is that of the first closed pose, or that of the configuration's guesses.
    ///
    /// # Errors
    /// [`AssemblyError`]: drivers that cannot reach their positions, or reach them only in another assembly mode that
    /// the configuration does not accept; a dependent joint that was set; a configuration of another mechanism; a
    /// base that is not a rigid frame.
    pub fn pose(self: &Arc<Self>, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        self.pose_along(configuration, None)
    }

    /// Pose at a configuration on the branch of another pose of the same assembly. The branch is followed from that
    /// pose, also through crossings of branches.
    ///
    /// # Errors
    /// [`AssemblyError`], as for [`pose`](Self::pose); a pose of another assembly.
    pub fn pose_from(
        self: &Arc<Self>,
        from: &Pose,
        configuration: &Configuration,
    ) -> Result<Pose, AssemblyError> {
        if !self.is_same_system(&from.assembly) {
            return Err(AssemblyError::ForeignPose);
        }
        self.pose_along(configuration, Some(from))
    }

    /// Pose at a configuration, on the branch of `from` if given.
    fn pose_along(
        self: &Arc<Self>,
        configuration: &Configuration,
        from: Option<&Pose>,
    ) -> Result<Pose, AssemblyError> {
        interruption::check();
        let model = self.pose_model();
        if !Arc::ptr_eq(configuration.mechanism(), &model.mechanism) {
            return Err(AssemblyError::ForeignConfiguration {
                got: configuration.mechanism().name().to_owned(),
                expected: model.mechanism.name().to_owned(),
            });
        }
        let base = rigid_base_pose(&configuration.base)?;
        let mut kinematics = Kinematics::new(model);
        for (values, range) in configuration.values.iter().zip(&model.joint_q) {
            kinematics.q[range.clone()].copy_from_slice(values);
        }
        kinematics.refill(model);
        let mut loops = None;
        if !model.groups.is_empty() {
            let anchors = from.and_then(|pose| pose.loops.as_ref()).map_or(&[][..], |l| &l.anchors);
            let start = from.map(|pose| Start { positions: pose.positions(), anchors });
            let state = LoopState { declared: true, ..LoopState::default() };
            let facts = self.facts();
            let mut closer = Closer { model, facts, configuration, start, kinematics, state };
            for number in 0..model.groups.len() {
                if number > 0 {
                    // Previous groups may contain ancestors of this group.
                    model.refill_group(&mut closer.kinematics, &model.groups[number]);
                }
                closer.close(number)?;
            }
            closer.state.drivers.sort_unstable();
            closer.state.drivers.dedup();
            kinematics = closer.kinematics;
            kinematics.refill(model);
            loops = Some(closer.state);
        }
        let mut pose = Pose::new(Arc::clone(self), kinematics, base, loops);
        pose.base_is_given = configuration.base_is_given;
        Ok(pose)
    }

    /// Pose at given frames, reached from another pose.
    pub(crate) fn pose_at(
        self: &Arc<Self>,
        kinematics: Kinematics,
        base: Transform<f64>,
        loops: Option<LoopState>,
        from: &Pose,
    ) -> Pose {
        let mut pose = Pose::new(Arc::clone(self), kinematics, base, loops);
        pose.base_is_given = from.base_is_given;
        pose
    }

    /// Frames of a pose moved by its closing uncertainty, in the direction of `sign`. `None` for a tree, or if the
    /// uncertainty cannot be found.
    pub(crate) fn pose_within_uncertainty(&self, pose: &Pose, sign: f64) -> Option<Kinematics> {
        let model = self.pose_model();
        let state = pose.loops.as_ref()?;
        let mut moved = pose.kinematics.clone();
        for (number, group) in model.groups.iter().enumerate() {
            let inexactness = self.facts().groups[number].misfit_beyond(group, &pose.kinematics, model);
            let dependent = &state.dependent[number];
            let known = self.has_single_model().then(|| &pose.groups[number].rows);
            let mut u = model.closing_uncertainty(&pose.kinematics, group, dependent, inexactness, known)?;
            u.iter_mut().for_each(|u| *u *= sign);
            model.advance_group(&mut moved, group, &u);
        }
        moved.refill(model);
        Some(moved)
    }
}
