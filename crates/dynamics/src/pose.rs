//! A mechanism at one configuration.

use crate::assembling::LoopState;
use crate::assembly::Assembly;
use crate::careful::condition_of;
use crate::contact::{Contact, ContactError, Frame, LocatedContact};
use crate::kinematics::Kinematics;
use crate::mobility::{GroupMobility, MobilityRoom};
use crate::outcome::Remark;
use crate::singular::Surroundings;
use crate::tolerances::{BESIDE, CONDITION_LIMIT};
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::{JointId, Limits, LinkId, Mechanism};
use percuss_spatial::Transform;
use std::sync::{Arc, OnceLock};

/// Every position and every frame at one configuration, with the assembly it belongs to. There is no setter, so its
/// frames always fit its positions.
#[derive(Clone, Debug)]
pub struct Pose {
    pub(crate) assembly: Arc<Assembly>,
    pub(crate) kinematics: Kinematics<f64>,
    pub(crate) base: Transform<f64>,
    /// Whether the pose of the root link in the world was given; else it is the world's origin.
    pub(crate) base_is_given: bool,
    pub(crate) loops: Option<LoopState>,
    /// What is decided about each group of the model here: its rank, and which coordinates depend.
    pub(crate) groups: Vec<GroupMobility>,
    /// What lies around it in the groups of loops that have less than their generic rank here; found when first asked for,
    /// a function of the rest.
    crossings: OnceLock<Vec<(usize, Surroundings)>>,
}

/// The rank of the constraints at a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseRank {
    /// How many rows of A are independent.
    pub rank: usize,
    /// Least gap, of any group, between singular values that count and those that do not; none without constraints.
    pub gap: Option<f64>,
    /// Whether no singular value is within a factor of 30 of the threshold.
    pub clear: bool,
    /// Whether the rank is less than at a generic pose: branches cross here.
    pub singular: bool,
}

impl Pose {
    pub(crate) fn new(
        assembly: Arc<Assembly>,
        kinematics: Kinematics<f64>,
        base: Transform<f64>,
        loops: Option<LoopState>,
    ) -> Self {
        let groups = assembly.decide(&kinematics);
        Self { assembly, kinematics, base, base_is_given: false, loops, groups, crossings: OnceLock::new() }
    }

    /// What is decided about the groups here, carried on to frames so near that it holds there too; elsewhere decided anew.
    pub(crate) fn groups_beside(&self, kinematics: &Kinematics<f64>) -> Vec<GroupMobility> {
        let (model, mut groups) = (self.assembly.model(), self.groups.clone());
        let (here, there) = (&self.kinematics.q, &kinematics.q);
        for (number, (known, group)) in groups.iter_mut().zip(&model.groups).enumerate() {
            let near = BESIDE * group.size.min(1.0);
            let mut moved = group.bodies.iter().flat_map(|&b| model.bodies[b].q.clone());
            if moved.all(|q| (here[q] - there[q]).abs() <= near) {
                known.move_to(model, group, kinematics);
            } else {
                let (floor, expected) = (self.assembly.floor(number), Some(known.rank.rank));
                let room = &mut MobilityRoom::default();
                model.decide_mobility(room, kinematics, group, floor, expected, known);
            }
        }
        groups
    }

    /// Findings about the pose and its assembly; they are among the [`remarks`](crate::ContactResponse::remarks) of every
    /// response, and hold for maps, workspaces and batches from here.
    pub fn remarks(&self) -> Vec<Remark> {
        let mut remarks = self.assembly.remarks().to_vec();
        if let Some(loops) = self.loops() {
            remarks.extend(loops.starts_tried.map(|starts| Remark::OtherAssembly { starts }));
            let off_zero = loops.off_zero.iter();
            remarks.extend(off_zero.map(|&(joint, value)| Remark::DriverOffZero { joint, value }));
            let off_target = loops.off_target.iter();
            remarks.extend(off_target.map(|&(joint, distance)| Remark::OffTarget { joint, distance }));
        }
        remarks.extend(self.outside_limits().map(|(joint, value, _)| Remark::OutsideLimits { joint, value }));
        remarks
    }

    /// The assembly it belongs to.
    pub fn assembly(&self) -> &Arc<Assembly> {
        &self.assembly
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        &self.assembly.model().mechanism
    }

    /// What the pose of a mechanism with loops rests on; none for a tree.
    pub fn loops(&self) -> Option<&LoopState> {
        self.loops.as_ref()
    }

    /// X_wr: the root link in the world.
    pub fn base(&self) -> &Transform<f64> {
        &self.base
    }

    /// The position of a joint (layouts of [`JointKind`](percuss_mechanism::JointKind)), mimics included.
    ///
    /// # Panics
    /// A joint of another mechanism: [`Mechanism::has_joint`] is false.
    pub fn joint(&self, joint: JointId) -> &[f64] {
        assert!(self.mechanism().has_joint(joint), "joint number {} is of another mechanism", joint.index());
        &self.kinematics.q[self.assembly.model().joint_q[joint.index()].clone()]
    }

    /// All positions one after another, in joint order.
    pub fn positions(&self) -> &[f64] {
        &self.kinematics.q
    }

    /// X_wl: a link in the world.
    ///
    /// # Panics
    /// A link of another mechanism: [`Mechanism::has_link`] is false.
    pub fn link(&self, link: LinkId) -> Transform<f64> {
        self.refuse_foreign(link);
        self.base * self.kinematics.link_frame(self.assembly.model(), link)
    }

    fn refuse_foreign(&self, link: LinkId) {
        assert!(self.mechanism().has_link(link), "link number {} is of another mechanism", link.index());
    }

    /// Joints that stand outside their limits.
    pub fn outside_limits(&self) -> impl Iterator<Item = (JointId, f64, Limits)> + '_ {
        let mechanism = self.mechanism();
        mechanism.joint_ids().filter_map(|id| {
            let limits = mechanism.joint(id).limits()?;
            let &[value] = self.joint(id) else { return None };
            Self::is_outside(value, limits).then_some((id, value, limits))
        })
    }

    /// Whether a position (rad or m) is outside limits, as poses count it.
    pub fn is_outside(value: f64, limits: Limits) -> bool {
        // A limit typed with nine digits is no violation.
        let slack = 1e-9 * (1.0 + value.abs());
        value < limits.lower - slack || value > limits.upper + slack
    }

    /// Degrees of freedom here: more than the generic number at a change point.
    pub fn degrees_of_freedom(&self) -> usize {
        self.assembly.model().coordinates.len() - self.rank().rank
    }

    /// The rank of the constraints here.
    pub fn rank(&self) -> PoseRank {
        let rank = self.groups.iter().map(|g| g.rank.rank).sum();
        let gap = self.groups.iter().map(|g| g.rank.gap).min_by(f64::total_cmp);
        let clear = self.groups.iter().all(|g| g.rank.clear);
        let singular = rank < self.assembly.generic_rank() && self.is_crossing();
        PoseRank { rank, gap, clear, singular }
    }

    /// Whether branches cross here, where the rank is less than the generic one. They do not where the pose has as many
    /// motions as the poses beside it: on a branch with more freedoms than the one where the generic rank was taken.
    fn is_crossing(&self) -> bool {
        let crossings = self.crossings();
        // What is held or locked may constrain less where the loops do not.
        crossings.is_empty() || crossings.iter().any(|(_, around)| !around.regular)
    }

    /// What lies around the pose in the groups of loops that have less than their generic rank here.
    pub(crate) fn crossings(&self) -> &[(usize, Surroundings)] {
        self.crossings.get_or_init(|| {
            let all = 0..self.assembly.posing().groups.len();
            let lost = all.filter(|&number| self.assembly.has_lost_rank(&self.kinematics, number));
            lost.map(|number| (number, self.assembly.around(&self.kinematics, number))).collect()
        })
    }

    /// Joint-space mass matrix M over the coordinates, n×n, symmetric, positive semi-definite (kg, kg·m, kg·m²).
    ///
    /// Armatures included; joints that mimic are folded into their masters, GᵀMG. Composite rigid body algorithm,
    /// Featherstone 2008 §6.2. Cost: O(n · depth).
    pub fn mass_matrix(&self) -> DMatrix<f64> {
        self.assembly.model().mass_matrix(&self.kinematics)
    }

    /// A, the Jacobian of all constraints over the coordinates: groups one after another, in the order of
    /// [`Assembly::groups`]; each group's rows (m/s at unit rates) divided by its largest entry over scaled coordinates.
    pub fn constraint_matrix(&self) -> DMatrix<f64> {
        self.assembly.model().constraint_matrix(&self.kinematics)
    }

    /// Condition λ_max/λ_min of M scaled to unit diagonal; none where M is singular or has more than 300 coordinates.
    pub fn condition(&self) -> Option<f64> {
        // M is formed over the tree's velocities, mimics folded afterwards.
        let small = self.assembly.model().follows.len() <= CONDITION_LIMIT;
        small.then(|| condition_of(&self.mass_matrix())).flatten()
    }

    /// Finds the point and the normal of a contact.
    ///
    /// # Errors
    /// [`ContactError`]: not finite, no direction, a link against itself, a link of another mechanism.
    pub fn locate(&self, contact: &Contact) -> Result<LocatedContact, ContactError> {
        self.assembly.model().locate(&self.kinematics, &self.base, contact)
    }

    /// A point (m) given in a frame, in the coordinates of `link`.
    ///
    /// # Panics
    /// A link of another mechanism.
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

    /// The contact row j = n̂ᵀ(J_on − J_against) over the coordinates: the closing speed of the gap at unit rates,
    /// 1×n (m for turns, 1 for slides). Joints that carry both sides cancel and are left out.
    pub fn contact_row(&self, contact: &LocatedContact) -> Vec<f64> {
        let model = self.assembly.model();
        let mut values = vec![0.0; model.follows.len()];
        for entry in model.contact_row(&self.kinematics, contact).entries {
            values[entry.velocity] = entry.value;
        }
        model.reduce_vector(&values, |multiplier| multiplier)
    }

    /// Jacobian of a point of a link, 3×n over the coordinates: v_P = J u, in the root link's axes, relative to
    /// the ground (m for turns, 1 for slides).
    ///
    /// # Panics
    /// A link of another mechanism.
    pub fn point_jacobian(&self, link: LinkId, point: &Vector3<f64>) -> DMatrix<f64> {
        self.refuse_foreign(link);
        self.assembly.model().point_jacobian(&self.kinematics, link, point)
    }
}
