//! Frames, motion subspaces and inertias of single joints at a pose.

use crate::analysis::pose::Pose;
use crate::model::joint_motion::JointMotion;
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::{Transform, Twist};

impl Pose {
    /// X_rl of a link: link frame in the frame of the root link.
    ///
    /// # Panics
    /// If the link belongs to another mechanism.
    pub fn link_in_root(&self, link: LinkId) -> Transform<f64> {
        assert!(self.mechanism().has_link(link), "link number {} belongs to another mechanism", link.index());
        self.kinematics.link_frame(self.assembly.model(), link)
    }

    /// X_pc of a joint: frame of the child link in the frame of the parent link.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism.
    pub fn joint_transform(&self, joint: JointId) -> Transform<f64> {
        let q = self.joint(joint);
        let joint = self.mechanism().joint(joint);
        *joint.origin() * JointMotion::of(joint).transform(q)
    }

    /// Columns of the motion subspace S of a joint: twist of the child relative to the parent at each unit velocity,
    /// in the child's axes at the child's origin. Locked joints have their columns, too.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism.
    pub fn motion_subspace(&self, joint: JointId) -> Vec<Twist<f64>> {
        let mut columns = Vec::new();
        self.add_motion_subspace(joint, &mut columns);
        columns
    }

    /// Appends the columns of [`motion_subspace`](Self::motion_subspace) to `columns`.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism.
    pub fn add_motion_subspace(&self, joint: JointId, columns: &mut Vec<Twist<f64>>) {
        let q = self.joint(joint);
        let joint = self.mechanism().joint(joint);
        let motion = JointMotion::of(joint);
        columns.extend((0..joint.kind().dofs()).map(|k| motion.column(k, q)));
    }

    /// Armature of each velocity of a joint under the conditions of the pose, kg·m² or kg; empty for a fixed joint.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism.
    pub fn armature(&self, joint: JointId) -> &[f64] {
        assert!(
            self.mechanism().has_joint(joint),
            "joint number {} belongs to another mechanism",
            joint.index()
        );
        let model = self.assembly.model();
        model.body_of_joint[joint.index()].map_or(&[], |body| &model.bodies[body].armature)
    }

    /// True if the joint cannot move under the conditions of the pose: a locked joint, or a mimic or master of a
    /// locked joint. False for a joint of another mechanism.
    pub fn is_locked(&self, joint: JointId) -> bool {
        self.mechanism().has_joint(joint) && self.assembly.model().locked[joint.index()]
    }

    /// True if the conditions of the pose lock this joint itself. False for a mimic or a master of a locked joint, which is at rest without
    /// its own lock, and for a joint of another mechanism.
    pub fn has_lock(&self, joint: JointId) -> bool {
        self.mechanism().has_joint(joint) && self.assembly.model().own_locks[joint.index()]
    }

    /// Joint and velocity index of each coordinate; the joint is `None` for the floating base. See
    /// [`System::coordinate_joints`](crate::System::coordinate_joints).
    pub fn coordinate_joints(&self) -> Vec<(Option<JointId>, usize)> {
        self.assembly.model().coordinates.iter().map(|c| (c.joint, c.component)).collect()
    }

    /// Velocities of all joints, in joint order, and twist of the root link (root axes, root origin) at the rates `u`
    /// of the coordinates. Mimics follow their masters; locked joints are at rest.
    ///
    /// # Panics
    /// If the number of rates differs from the number of coordinates.
    pub fn joint_velocities(&self, u: &[f64]) -> (Vec<Vec<f64>>, Twist<f64>) {
        let model = self.assembly.model();
        assert_eq!(u.len(), model.coordinates.len(), "one rate per coordinate");
        model.split_velocities(&model.expand(u))
    }
}
