//! Assembly of the loops of a system, computed once from a given guess: a first closed pose, a generic pose, the
//! driving joints and the mobility. The assembly is an immutable value.

use crate::analysis::routes::WorkspacePool;
use crate::kinematics::contact::Contact;
use crate::kinematics::frames::Kinematics;
use crate::kinematics::outcome::{Remark, ResponseError};
use crate::kinematics::remarks::RemarkFlags;
use crate::kinematics::rows::{GroupRows, largest};
use crate::loops::assembling::{Facts, GroupFacts};
use crate::loops::singular::Surroundings;
use crate::mobility::{GroupMobility, MobilityWorkspace, Rank, Redundancy, rank_of_rows};
use crate::model::conditions::Base;
use crate::model::{Constraint, ConstraintRows, Group, Model};
use crate::recursion::{Pivoting, Recursion};
use crate::tolerances::{
    CLOSED_AS_DRAWN, DRAWN_OPEN, HELD_ASIDE, OPEN_ROW, REDUNDANCY_LIMIT, ROUNDED, WEAKLY_CONSTRAINED,
};
use nalgebra::Vector3;
use percuss_mechanism::JointId;
use std::sync::{Arc, OnceLock};

/// A system with assembled loops.
#[derive(Debug)]
pub struct Assembly {
    models: Models,
    facts: Facts,
    /// For each group of the model with its locks and held contacts: rank at a generic pose.
    generic: Vec<Rank>,
    /// For each of these groups: threshold for singular values of A, relative to the largest; smaller values count as
    /// zero.
    floors: Vec<f64>,
    /// For each of these groups: residual misfit of its loops, relative to the group's size.
    misfits: Vec<f64>,
    /// Closed generic pose. With held contacts, joints outside loops are moved away from zero.
    generic_kinematics: Kinematics,
    /// Computed on first use from the other fields, as `kernel_remarks`.
    redundant: OnceLock<Vec<Vec<String>>>,
    kernel_remarks: OnceLock<RemarkFlags>,
    workspaces: WorkspacePool,
    remarks: Vec<Remark>,
}

/// The two models of a system: `answering` computes effective masses, `posing` computes poses. Locks and held
/// contacts constrain velocities, not the pose: loops are closed with every joint free.
#[derive(Clone, Debug)]
pub(crate) struct Models {
    pub mass_model: Arc<Model>,
    pub pose_model: Arc<Model>,
}

/// Gap of a loop in the configuration as drawn: all joints at 0, or at their guesses.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnGap {
    /// Name of the closure or coupling.
    pub constraint: String,
    /// Largest residual, m (angles times the size of the group).
    pub gap: f64,
    /// Size of the group of loops, m.
    pub size: f64,
    /// The joint that moved most to close the group, and its displacement (rad or m).
    pub moved: Option<(JointId, f64)>,
    /// True if the gap exceeds a hundredth of the size. Such a gap is not rounding; a point may be mistyped.
    pub is_wide: bool,
}

impl Assembly {
    /// Decides the generic ranks of all groups from the facts of the assembly, and collects the remarks.
    pub(crate) fn new(models: Models, facts: Facts) -> Self {
        let generic_kinematics = generic_kinematics(&models, &facts);
        let model = &models.mass_model;
        let of_groups = |of: fn(&GroupFacts) -> f64| {
            model
                .groups
                .iter()
                .map(|g| (g, largest_fact(&models, &facts, g, of)))
                .collect::<Vec<(&Group, f64)>>()
        };
        let inexactness = of_groups(|facts| facts.inexactness);
        let floors: Vec<f64> =
            inexactness.into_iter().map(|(g, inexactness)| g.floor_for(inexactness)).collect();
        let misfits: Vec<f64> =
            of_groups(|facts| facts.misfit).into_iter().map(|(g, misfit)| misfit / g.size).collect();
        let rank = |((group, floor), misfit): ((&Group, &f64), &f64)| {
            let mut rows = GroupRows::default();
            rows.fill(model, group, &generic_kinematics);
            rank_of_rows(&rows, group, *floor).explained_by(ROUNDED * misfit)
        };
        let generic: Vec<Rank> = model.groups.iter().zip(&floors).zip(&misfits).map(rank).collect();
        let remarks = assembly_remarks(&models.pose_model, &facts, &generic);
        Self {
            models,
            facts,
            generic,
            floors,
            misfits,
            generic_kinematics,
            redundant: OnceLock::new(),
            kernel_remarks: OnceLock::new(),
            workspaces: WorkspacePool::default(),
            remarks,
        }
    }

    /// Assembly with the closed loops of this one and models of the same mechanism under other conditions.
    pub(crate) fn with_models(&self, models: Models) -> Arc<Self> {
        Arc::new(Self::new(models, self.facts.clone()))
    }

    /// Pool of recursion workspaces.
    pub(crate) fn workspaces(&self) -> &WorkspacePool {
        &self.workspaces
    }

    /// Model with locks and held contacts, used for effective masses.
    pub(crate) fn model(&self) -> &Model {
        &self.models.mass_model
    }

    /// Model without locks and held contacts, used for poses.
    pub(crate) fn pose_model(&self) -> &Model {
        &self.models.pose_model
    }

    /// Facts about the loops.
    pub(crate) fn facts(&self) -> &Facts {
        &self.facts
    }

    /// True if both assemblies belong to the same system.
    pub(crate) fn is_same_system(&self, other: &Self) -> bool {
        self.is_for_model(&other.models.mass_model)
    }

    /// Facts about a group of loops.
    pub(crate) fn group_facts(&self, number: usize) -> &GroupFacts {
        &self.facts.groups[number]
    }

    /// True if the assembly was made for the model.
    pub(crate) fn is_for_model(&self, model: &Arc<Model>) -> bool {
        Arc::ptr_eq(&self.models.mass_model, model)
    }

    /// True if both models are the same; then their groups are the same.
    pub(crate) fn has_single_model(&self) -> bool {
        Arc::ptr_eq(&self.models.mass_model, &self.models.pose_model)
    }

    /// Threshold for singular values of A of a group, relative to the largest; smaller values count as zero.
    pub(crate) fn floor(&self, number: usize) -> f64 {
        self.floors[number]
    }

    /// Positions of all joints at a generic pose.
    pub(crate) fn generic_positions(&self) -> &[f64] {
        &self.generic_kinematics.q
    }

    /// Rank of a group's rows at a generic pose.
    pub(crate) fn expected_rank(&self, number: usize) -> usize {
        self.generic[number].rank
    }

    /// Rank of A at a generic pose, over all groups.
    pub(crate) fn generic_rank(&self) -> usize {
        self.generic.iter().map(|g| g.rank).sum()
    }

    /// Decides the rank and the dependent coordinates of each group at the given frames.
    pub(crate) fn decide_mobility(&self, kinematics: &Kinematics) -> Vec<GroupMobility> {
        let mut groups = vec![GroupMobility::default(); self.model().groups.len()];
        self.decide_mobility_into(kinematics, &mut groups);
        groups
    }

    /// Decisions as by [`decide_mobility`](Self::decide_mobility), in place.
    pub(crate) fn decide_mobility_into(&self, kinematics: &Kinematics, groups: &mut [GroupMobility]) {
        let model = self.model();
        let mut workspace = MobilityWorkspace::default();
        for (number, (group, decided)) in model.groups.iter().zip(groups).enumerate() {
            let (floor, expected) = (self.floors[number], Some(self.generic[number].rank));
            model.decide_mobility(&mut workspace, kinematics, group, floor, expected, decided);
        }
    }

    /// Decides the rank and the dependent coordinates of each group of the model without locks and held contacts.
    pub(crate) fn decide_loop_mobility(&self, kinematics: &Kinematics) -> Vec<GroupMobility> {
        let (model, workspace) = (self.pose_model(), &mut MobilityWorkspace::default());
        let of_groups = model.groups.iter().zip(&self.facts.groups).map(|(group, facts)| {
            let (expected, mut decided) = (Some(facts.rank.rank), GroupMobility::default());
            model.decide_mobility(workspace, kinematics, group, facts.floor, expected, &mut decided);
            decided
        });
        of_groups.collect()
    }

    /// For each group: residual misfit of its loops, relative to the group's size.
    pub(crate) fn misfits(&self) -> &[f64] {
        &self.misfits
    }

    /// Number of coordinates: independent velocities of the tree. A floating base counts 6.
    pub fn coordinates(&self) -> usize {
        self.model().coordinates.len()
    }

    /// Degrees of freedom at a generic pose; a floating base counts 6.
    pub fn degrees_of_freedom(&self) -> usize {
        self.coordinates() - self.generic_rank()
    }

    /// Number of redundant constraint rows at a generic pose: of loops, couplings, held contacts and locks.
    pub fn redundant_constraints(&self) -> usize {
        let rows: usize = self.model().groups.iter().map(|g| g.rows).sum();
        self.model().redundant_locks + rows - self.generic_rank()
    }

    /// Sets of loops, couplings and held contacts that contain redundant rows. Constraints whose redundancy cannot be
    /// separated form one set.
    pub fn redundant_loops(&self) -> &[Vec<String>] {
        self.redundant.get_or_init(|| {
            let model = self.model();
            let mut redundancy = Redundancy::default();
            for (group, rank) in model.groups.iter().zip(&self.generic) {
                if rank.rank >= group.rows || group.coordinates.len() > REDUNDANCY_LIMIT {
                    continue;
                }
                let names: Vec<String> = (0..group.rows).map(|row| model.row_name(group, row)).collect();
                let rows = model.group_matrix(&self.generic_kinematics, group);
                redundancy.look_at(&rows, &group.lengths, rank.rank, &names);
            }
            redundancy.sets
        })
    }

    /// Names of the constraints of each group. A group contains the constraints that share coordinates, directly or
    /// through other constraints.
    pub fn groups(&self) -> Vec<Vec<String>> {
        self.model().groups.iter().map(|group| self.model().group_names(group)).collect()
    }

    /// Rank of each group's rows at a generic pose, in the order of [`groups`](Self::groups).
    pub fn group_ranks(&self) -> Vec<usize> {
        self.generic.iter().map(|g| g.rank).collect()
    }

    /// Joints that drive the loops by default, in joint order.
    pub fn drivers(&self) -> Vec<JointId> {
        let groups = self.facts.groups.iter().zip(&self.pose_model().groups);
        let of_group = groups.flat_map(|(f, g)| f.drivers.driving.iter().filter_map(|&at| g.joints[at]));
        let mut drivers: Vec<JointId> = of_group.collect();
        drivers.sort_unstable();
        drivers.dedup();
        drivers
    }

    /// Smallest gap between the nonzero and the zero singular values of A, over all groups; `None` without
    /// constraints.
    pub fn rank_gap(&self) -> Option<f64> {
        self.generic.iter().map(|g| g.gap).min_by(f64::total_cmp)
    }

    /// Smallest nonzero singular value of A at the generic pose, relative to the largest of its group. A small value
    /// means a weakly constrained mechanism: a small error in the figures of a file can free one more motion.
    pub fn least_singular_value(&self) -> f64 {
        self.generic.iter().map(|g| g.least).fold(1.0, f64::min)
    }

    /// True if the generic rank is clear.
    pub fn rank_is_clear(&self) -> bool {
        self.generic.iter().all(|g| g.clear)
    }

    /// True if the mechanism is weakly constrained: with figures rounded to four digits, one more motion may be free.
    pub fn is_weakly_constrained(&self) -> bool {
        self.least_singular_value() < WEAKLY_CONSTRAINED
    }

    /// Findings about the loops that hold at every pose.
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Findings about each finite result of a SIMD kernel. The kernels leave out motions without mass; a motion that is massless at a generic
    /// pose is massless at every pose.
    pub(crate) fn kernel_remarks(&self) -> RemarkFlags {
        *self.kernel_remarks.get_or_init(|| {
            let (model, mut kinematics) = (self.model(), self.generic_kinematics.clone());
            move_unbound_joints(self.pose_model(), &mut kinematics);
            kinematics.refill(model);
            let groups = self.decide_mobility(&kinematics);
            let mut deciding = Pivoting::<1>::new(model);
            let origin = Vector3::zeros();
            Recursion::<1>::new(model).eliminate(model, &kinematics, &groups, &origin, &mut deciding);
            match deciding.dropped {
                0 => RemarkFlags::NONE,
                _ => RemarkFlags::MASSLESS_MOTIONS | RemarkFlags::UNDETERMINED_MOTION,
            }
        })
    }

    /// Returns a remark if the normal of the contact is given in the world, the base floats, and the base pose is not
    /// given.
    pub(crate) fn base_remark(&self, contact: &Contact, base_is_given: bool) -> Option<Remark> {
        let missing = self.model().base == Base::Floating && !base_is_given && contact.has_world_normal();
        missing.then_some(Remark::BaseNotGiven)
    }

    /// Refuses positions at which a group of loops is open. `residuals` is a reusable buffer.
    pub(crate) fn refuse_open_loops(
        &self,
        kinematics: &Kinematics,
        residuals: &mut Vec<f64>,
    ) -> Result<(), ResponseError> {
        let model = self.pose_model();
        for (number, group) in model.groups.iter().enumerate() {
            model.group_residuals_into(kinematics, group, residuals);
            let (gap, worst) = largest(residuals);
            let accepted = OPEN_ROW * group.size;
            // The tolerance of far and rounded loops is more expensive than the residuals.
            if gap <= accepted {
                continue;
            }
            let tolerance = accepted.max(self.tolerance(kinematics, number));
            if gap > tolerance {
                let mut loops = model.group_names(group);
                if let Some(at) = loops.iter().position(|name| *name == model.row_name(group, worst)) {
                    loops.swap(0, at);
                }
                return Err(ResponseError::OpenLoops { loops, gap, tolerance });
            }
        }
        Ok(())
    }

    /// Gap of each loop in the configuration as drawn, if larger than rounding. A relation with a constant is no loop: it offsets joints.
    pub fn drawn_gaps(&self) -> Vec<DrawnGap> {
        let model = self.pose_model();
        let mut gaps = Vec::new();
        for (group, facts) in model.groups.iter().zip(&self.facts.groups) {
            let least = (CLOSED_AS_DRAWN * group.size).max(2.0 * facts.inexactness);
            for (constraint, &gap) in group.constraints.iter().zip(&facts.drawn_gaps) {
                if gap > least && matches!(constraint.constraint, Constraint::Closure(_)) {
                    gaps.push(DrawnGap {
                        constraint: model.constraint_name(constraint.constraint),
                        gap,
                        size: group.size,
                        moved: facts.moved,
                        is_wide: gap > DRAWN_OPEN * group.size,
                    });
                }
            }
        }
        gaps
    }

    /// True if a group of loops has less than its generic rank at the given frames.
    pub(crate) fn has_lost_rank(&self, kinematics: &Kinematics, number: usize) -> bool {
        let (model, facts) = (self.pose_model(), &self.facts.groups[number]);
        let group = &model.groups[number];
        let mut rows = GroupRows::default();
        rows.fill(model, group, kinematics);
        rank_of_rows(&rows, group, facts.floor).rank < facts.rank.rank
    }

    /// Surroundings of a pose of a group of loops: the branches near the pose.
    pub(crate) fn surroundings(&self, kinematics: &Kinematics, number: usize) -> Surroundings {
        let model = self.pose_model();
        model.surroundings(kinematics, &model.groups[number], self.facts.groups[number].inexactness)
    }

    /// Residual at which a group counts as closed, m.
    pub(crate) fn tolerance(&self, kinematics: &Kinematics, number: usize) -> f64 {
        let model = self.pose_model();
        let group = &model.groups[number];
        let misfit = self.facts.groups[number].misfit_beyond(group, kinematics, model);
        model.rounded_tolerance(kinematics, group, misfit)
    }
}

/// Findings about loops that hold at every pose.
fn assembly_remarks(posing: &Model, facts: &Facts, generic: &[Rank]) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let gaps = posing.groups.iter().zip(&facts.groups).flat_map(|(group, facts)| {
        let closes = |c: &&ConstraintRows| matches!(c.constraint, Constraint::Closure(_));
        let own = group.constraints.iter().zip(&facts.drawn_gaps).filter(move |(c, _)| closes(c));
        own.map(|(_, &gap)| (gap, group.size))
    });
    let widest = gaps
        .filter(|(gap, size)| *gap > DRAWN_OPEN * size)
        .max_by(|(gap, size), (other, of)| (gap / size).total_cmp(&(other / of)));
    remarks.extend(widest.map(|(gap, size)| Remark::DrawnOpen { gap, size }));
    let inexactness = facts.groups.iter().map(|facts| facts.inexactness).fold(0.0, f64::max);
    remarks.extend((inexactness > 0.0).then_some(Remark::InexactLoops { inexactness }));
    if posing.groups.is_empty() {
        return remarks;
    }
    let least = generic.iter().map(|rank| rank.least).fold(1.0, f64::min);
    remarks.extend((least < WEAKLY_CONSTRAINED).then_some(Remark::WeaklyConstrained { least }));
    if !generic.iter().all(|rank| rank.clear) {
        let gap = generic.iter().map(|rank| rank.gap).fold(f64::INFINITY, f64::min);
        remarks.push(Remark::UnclearMobility { gap });
    }
    remarks
}

/// Largest value of a fact over the posed groups that share constraints with a group of the answering model.
fn largest_fact(models: &Models, facts: &Facts, group: &Group, of: fn(&GroupFacts) -> f64) -> f64 {
    let shares = |posed: &Group| {
        posed.constraints.iter().any(|c| group.constraints.iter().any(|own| own.constraint == c.constraint))
    };
    let same = Arc::ptr_eq(&models.mass_model, &models.pose_model);
    let meant = |posed: &Group| if same { std::ptr::eq(posed, group) } else { shares(posed) };
    let meant = models.pose_model.groups.iter().zip(&facts.groups).filter(|(posed, _)| meant(posed));
    meant.map(|(_, facts)| of(facts)).fold(0.0, f64::max)
}

/// Kinematics with every group at its generic pose. With held contacts, the joints outside loops are moved away from
/// zero.
fn generic_kinematics(models: &Models, facts: &Facts) -> Kinematics {
    let posing = &models.pose_model;
    let mut kinematics = Kinematics::zero(posing);
    if models.mass_model.groups.iter().any(|g| g.is_held) {
        move_unbound_joints(posing, &mut kinematics);
    }
    for (group, facts) in posing.groups.iter().zip(&facts.groups) {
        posing.restore_group(&mut kinematics, group, &facts.generic);
    }
    kinematics.refill(&models.mass_model);
    kinematics
}

/// Moves the joints outside loops to generic positions.
fn move_unbound_joints(posing: &Model, kinematics: &mut Kinematics) {
    let bound = |c: &usize| posing.groups.iter().any(|g| g.column(*c).is_some());
    let coordinates: Vec<usize> = (0..posing.coordinates.len()).filter(|c| !bound(c)).collect();
    let size = posing.mechanism.characteristic_length();
    let lengths = coordinates.iter().map(|&c| if posing.coordinates[c].turns { size } else { 1.0 });
    let outside = Group {
        lengths: lengths.collect(),
        coordinates,
        size,
        bodies: (0..posing.bodies.len()).collect(),
        ..Group::default()
    };
    posing.perturb(kinematics, &outside, HELD_ASIDE, 77);
}
