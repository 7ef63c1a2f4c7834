//! A mechanism at one configuration.

use crate::analysis::assembly::Assembly;
use crate::dense::direct::condition_of;
use crate::kinematics::contact::{Contact, ContactError, Frame, LocatedContact};
use crate::kinematics::frames::Kinematics;
use crate::kinematics::outcome::Remark;
use crate::loops::assembling::LoopState;
use crate::loops::singular::Surroundings;
use crate::mobility::{GroupMobility, MobilityWorkspace};
use crate::tolerances::{CONDITION_LIMIT, LIMIT_SLACK, SAME_PIVOTS_DISTANCE};
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::{JointId, JointKind, Limits, LinkId, Mechanism};
use percuss_spatial::Transform;
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// All positions and frames at one configuration, with the assembly. A pose has no setters, so frames and positions
/// are always consistent.
#[derive(Clone, Debug)]
pub struct Pose {
    pub(crate) assembly: Arc<Assembly>,
    pub(crate) kinematics: Kinematics,
    pub(crate) base: Transform<f64>,
    /// True if the pose of the root link in the world was given; otherwise the root link is at the world's origin.
    pub(crate) base_is_given: bool,
    pub(crate) loops: Option<LoopState>,
    /// Rank and dependent coordinates of each group of the model at this pose.
    pub(crate) groups: Vec<GroupMobility>,
    /// Surroundings of the pose in the groups of loops with less than their generic rank here. Computed on first use
    /// from the other fields.
    crossings: OnceLock<Vec<(usize, Surroundings)>>,
}

/// Rank of the constraints at a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseRank {
    /// Number of independent rows of A.
    pub rank: usize,
    /// Smallest gap (ratio), over all groups, between nonzero and zero singular values; `None` without constraints.
    pub gap: Option<f64>,
    /// True if no singular value is within a factor of 30 of the threshold.
    pub clear: bool,
    /// True if the rank is less than at a generic pose: branches cross here.
    pub singular: bool,
}

impl Pose {
    pub(crate) fn new(
        assembly: Arc<Assembly>,
        kinematics: Kinematics,
        base: Transform<f64>,
        loops: Option<LoopState>,
    ) -> Self {
        let groups = assembly.decide_mobility(&kinematics);
        Self { assembly, kinematics, base, base_is_given: false, loops, groups, crossings: OnceLock::new() }
    }

    /// Decides rank and dependent coordinates of all groups at the present frames, in place.
    pub(crate) fn decide_mobility_again(&mut self) {
        self.assembly.decide_mobility_into(&self.kinematics, &mut self.groups);
        self.crossings = OnceLock::new();
    }

    /// Decisions about the groups at frames near this pose. Ranks are kept for groups that moved very little, and
    /// decided anew for the others.
    pub(crate) fn groups_near(&self, kinematics: &Kinematics) -> Vec<GroupMobility> {
        let (model, mut groups) = (self.assembly.model(), self.groups.clone());
        let (here, there) = (&self.kinematics.q, &kinematics.q);
        for (number, (known, group)) in groups.iter_mut().zip(&model.groups).enumerate() {
            let near = SAME_PIVOTS_DISTANCE * group.size.min(1.0);
            let mut moved = group.bodies.iter().flat_map(|&b| model.bodies[b].q.clone());
            if moved.all(|q| (here[q] - there[q]).abs() <= near) {
                known.update_rates(model, group, kinematics);
            } else {
                let (floor, expected) = (self.assembly.floor(number), Some(known.rank.rank));
                let workspace = &mut MobilityWorkspace::default();
                model.decide_mobility(workspace, kinematics, group, floor, expected, known);
            }
        }
        groups
    }

    /// Findings about the pose and its assembly. These findings are part of the
    /// [`remarks`](crate::ContactResponse::remarks) of every response, and also apply to maps, workspaces and batches
    /// made from this pose.
    pub fn remarks(&self) -> Vec<Remark> {
        let mut remarks = self.assembly.remarks().to_vec();
        if let Some(loops) = self.loops() {
            remarks.extend(loops.starts_tried.map(|starts| Remark::OtherAssembly { starts }));
            let off_zero = loops.off_zero.iter();
            remarks.extend(off_zero.map(|&(joint, value)| Remark::DriverOffZero { joint, value }));
            let off_target = loops.off_target.iter();
            remarks.extend(off_target.map(|&(joint, distance)| Remark::OffTarget { joint, distance }));
        }
        remarks.extend(self.outside_limits().map(|(joint, value, _)| {
            let many_turns = Self::is_many_turns(self.mechanism().joint(joint).kind(), value);
            Remark::OutsideLimits { joint, value, many_turns }
        }));
        remarks
    }

    /// The assembly of the pose.
    pub fn assembly(&self) -> &Arc<Assembly> {
        &self.assembly
    }

    /// The mechanism of the pose.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        &self.assembly.model().mechanism
    }

    /// Assembly state of the loops; `None` for a tree.
    pub fn loops(&self) -> Option<&LoopState> {
        self.loops.as_ref()
    }

    /// X_wr: pose of the root link in the world.
    pub fn base(&self) -> &Transform<f64> {
        &self.base
    }

    /// Position of a joint (layouts of [`JointKind`](percuss_mechanism::JointKind)), also of a mimic.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism: [`Mechanism::has_joint`] is false.
    pub fn joint(&self, joint: JointId) -> &[f64] {
        assert!(
            self.mechanism().has_joint(joint),
            "joint number {} belongs to another mechanism",
            joint.index()
        );
        &self.kinematics.q[self.assembly.model().joint_q[joint.index()].clone()]
    }

    /// Positions of all joints one after another, in joint order.
    pub fn positions(&self) -> &[f64] {
        &self.kinematics.q
    }

    /// X_wl: pose of a link in the world.
    ///
    /// # Panics
    /// If the link belongs to another mechanism: [`Mechanism::has_link`] is false.
    pub fn link(&self, link: LinkId) -> Transform<f64> {
        self.refuse_foreign(link);
        self.base * self.kinematics.link_frame(self.assembly.model(), link)
    }

    fn refuse_foreign(&self, link: LinkId) {
        assert!(self.mechanism().has_link(link), "link number {} belongs to another mechanism", link.index());
    }

    /// Joints outside their limits, with position and limits.
    pub fn outside_limits(&self) -> impl Iterator<Item = (JointId, f64, Limits)> + '_ {
        let mechanism = self.mechanism();
        mechanism.joint_ids().filter_map(|id| {
            let limits = mechanism.joint(id).limits()?;
            let &[value] = self.joint(id) else { return None };
            Self::is_outside(value, limits).then_some((id, value, limits))
        })
    }

    /// True if a position (rad or m) is outside the limits, with the slack used by poses.
    pub fn is_outside(value: f64, limits: Limits) -> bool {
        let slack = LIMIT_SLACK * (1.0 + value.abs());
        value < limits.lower - slack || value > limits.upper + slack
    }

    /// True if the position of a hinge is more than one turn from 0, rad. A position of a hinge with limits is then probably in degrees.
    pub fn is_many_turns(kind: JointKind, value: f64) -> bool {
        matches!(kind, JointKind::Revolute | JointKind::Continuous) && value.abs() > TAU
    }

    /// Degrees of freedom at this pose: more than the generic number at a change point.
    pub fn degrees_of_freedom(&self) -> usize {
        self.assembly.model().coordinates.len() - self.rank().rank
    }

    /// Rank of the constraints at this pose.
    pub fn rank(&self) -> PoseRank {
        let rank = self.groups.iter().map(|g| g.rank.rank).sum();
        let gap = self.groups.iter().map(|g| g.rank.gap).min_by(f64::total_cmp);
        let clear = self.groups.iter().all(|g| g.rank.clear);
        let singular = rank < self.assembly.generic_rank() && self.is_crossing();
        PoseRank { rank, gap, clear, singular }
    }

    /// True if branches cross at this pose, for a rank below the generic rank. Branches do not cross if the pose has
    /// as many free motions as its neighbours. The pose is then on a branch with more freedoms than the branch of the
    /// generic rank.
    fn is_crossing(&self) -> bool {
        let crossings = self.crossings();
        // Held contacts and locks may lose rank at a pose at which the loops keep theirs.
        crossings.is_empty() || crossings.iter().any(|(_, around)| !around.regular)
    }

    /// Surroundings of the pose in the groups of loops with less than their generic rank here.
    pub(crate) fn crossings(&self) -> &[(usize, Surroundings)] {
        self.crossings.get_or_init(|| {
            let all = 0..self.assembly.pose_model().groups.len();
            let lost = all.filter(|&number| self.assembly.has_lost_rank(&self.kinematics, number));
            lost.map(|number| (number, self.assembly.surroundings(&self.kinematics, number))).collect()
        })
    }

    /// Joint-space mass matrix M over the coordinates, n×n, symmetric, positive semi-definite (kg, kg·m, kg·m²).
    ///
    /// Armatures are included. Mimics are folded into their masters, GᵀMG. Algorithm: composite rigid body,
    /// Featherstone 2008 §6.2. Cost: O(n · depth).
    pub fn mass_matrix(&self) -> DMatrix<f64> {
        self.assembly.model().mass_matrix(&self.kinematics)
    }

    /// A, the Jacobian of all constraints over the coordinates. Groups follow one another in the order of
    /// [`Assembly::groups`]. The rows of each group (m/s at unit rates) are divided by the group's largest entry over
    /// scaled coordinates.
    pub fn constraint_matrix(&self) -> DMatrix<f64> {
        self.assembly.model().constraint_matrix(&self.kinematics)
    }

    /// Condition number λ_max/λ_min of M scaled to unit diagonal; `None` if M is singular or has more than 300
    /// coordinates.
    pub fn condition(&self) -> Option<f64> {
        // M is formed over the tree velocities; mimics are folded afterwards.
        let small = self.assembly.model().velocity_coordinates.len() <= CONDITION_LIMIT;
        small.then(|| condition_of(&self.mass_matrix())).flatten()
    }

    /// Computes the point and the normal of a contact.
    ///
    /// # Errors
    /// [`ContactError`]: a number that is not finite, no direction, a link against itself, a link of another
    /// mechanism.
    pub fn locate(&self, contact: &Contact) -> Result<LocatedContact, ContactError> {
        self.assembly.model().locate(&self.kinematics, &self.base, contact)
    }

    /// Converts a point (m) given in `frame` to the coordinates of `link`.
    ///
    /// # Panics
    /// If a link belongs to another mechanism.
    pub fn point_in_link(
        &self,
        link: LinkId,
        against: Option<LinkId>,
        frame: Frame,
        point: Vector3<f64>,
    ) -> Vector3<f64> {
        [Some(link), against].into_iter().flatten().for_each(|link| self.refuse_foreign(link));
        let model = self.assembly.model();
        let x_rl = self.kinematics.link_frame(model, link);
        match (frame, against) {
            (Frame::Link, _) => point,
            (Frame::Against, Some(other)) => {
                x_rl.inverse_point(&self.kinematics.link_frame(model, other).point(&point))
            }
            (Frame::World, _) | (Frame::Against, None) => {
                x_rl.inverse_point(&self.base.inverse_point(&point))
            }
        }
    }

    /// Contact row j = n̂ᵀ(J_on − J_against) over the coordinates: closing speed of the gap at unit rates, 1×n (m for
    /// rotations, 1 for translations). For a moment: j = âᵀ(J_ω,on − J_ω,against) (1 for rotations, 0 for translations). Joints that move
    /// both sides equally are omitted.
    pub fn contact_row(&self, contact: &LocatedContact) -> Vec<f64> {
        let model = self.assembly.model();
        let mut values = vec![0.0; model.velocity_coordinates.len()];
        for entry in model.contact_row(&self.kinematics, contact).entries {
            values[entry.velocity] = entry.value;
        }
        model.reduce_vector(&values, |multiplier| multiplier)
    }

    /// Jacobian of a point of a link over the coordinates, 3×n: v_P = J u, in root axes, relative to the ground (m
    /// for rotations, 1 for translations).
    ///
    /// # Panics
    /// If the link belongs to another mechanism.
    pub fn point_jacobian(&self, link: LinkId, point: &Vector3<f64>) -> DMatrix<f64> {
        self.refuse_foreign(link);
        self.assembly.model().point_jacobian(&self.kinematics, link, point)
    }

    /// Jacobian of the angular velocity of a link over the coordinates, 3×n (1 for rotations, 0 for translations): ω = J u, in root axes,
    /// relative to the ground.
    ///
    /// # Panics
    /// If the link belongs to another mechanism.
    pub fn angular_jacobian(&self, link: LinkId) -> DMatrix<f64> {
        self.refuse_foreign(link);
        self.assembly.model().angular_jacobian(&self.kinematics, link)
    }
}
