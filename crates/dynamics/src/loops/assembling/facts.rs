//! Facts about the loops of a mechanism, computed once: a first closed pose, a generic pose, its rank, and the
//! default drivers.

use super::error::AssemblyError;
use crate::kinematics::frames::Kinematics;
use crate::kinematics::rows::GroupRows;
use crate::loops::closing::{Correction, Directions, Linearised};
use crate::mobility::{Drivers, Generic, Rank, independent_rows, rank_of_rows};
use crate::model::{Group, Model};
use crate::tolerances::{
    CLOSED, CONVERGED_STEP, DEPARTURES, DRAWN_CLOSED, FARTHEST, FEWEST_FIRST_STARTS, FIRST_STARTS,
    FIRST_STARTS_ASIDE, FIRST_STARTS_WORK, GENERIC_POSES, GENERIC_POSES_ENOUGH, LARGE_GROUP,
    MOST_FIRST_STARTS, OTHER_POSE_RESIDUAL, ROUNDING, SAME_POSE,
};
use percuss_mechanism::{ClosureKind, JointId};

/// Facts about one group.
#[derive(Clone, Debug)]
pub(crate) struct GroupFacts {
    /// Positions of a closed pose away from singularities.
    pub generic: Vec<f64>,
    /// A at the generic pose, over the group's coordinates.
    pub rows: GroupRows,
    pub rank: Rank,
    /// Misfit of inexact loops, m; 0 for loops that close exactly.
    pub inexactness: f64,
    /// Residual of the loops closed as well as possible, m: the inexactness, or the residual of a closed pose.
    pub misfit: f64,
    /// Threshold for singular values of A, relative to the largest; smaller values count as zero.
    pub floor: f64,
    /// True if the first closed pose has the generic rank.
    pub reference_is_regular: bool,
    /// Default drivers.
    pub drivers: Drivers,
    /// Rows that determine the assembly mode of the default dependent coordinates.
    pub mode_rows: Vec<usize>,
    /// Largest residual of each constraint at the start, m.
    pub drawn_gaps: Vec<f64>,
    /// Joint that moved most during the first closing, and its displacement (rad or m).
    pub moved: Option<(JointId, f64)>,
}

/// A coordinate (by index into the group) that was set although it depends on others, and the actual drivers.
pub(crate) struct Refused {
    pub at: usize,
    pub drivers: Drivers,
}

impl GroupFacts {
    /// Properties of the group at its generic pose.
    pub fn generic(&self) -> Generic<'_> {
        Generic {
            rows: &self.rows,
            rank: self.rank,
            floor: self.floor,
            default_rows: Some((&self.drivers.dependent, &self.mode_rows)),
        }
    }

    /// Drivers for given (set) coordinates. Given coordinates drive as far as possible, followed by declared
    /// coordinates, and by coordinates that are probably actuated. `near`: the frames at which the search begins.
    ///
    /// # Errors
    /// A coordinate that is given and cannot drive.
    pub fn choose_drivers(
        &self,
        model: &Model,
        group: &Group,
        near: impl FnOnce() -> Kinematics,
        given: impl Fn(usize) -> bool,
    ) -> Result<Drivers, Refused> {
        let mut divided = model.drivers_for(group, &self.rows, &self.drivers, self.floor, &given);
        let single =
            |at: usize| group.joints[at].is_some_and(|id| model.mechanism.joint(id).kind().positions() == 1);
        // A joint with several positions may drive with only part of them; the others must result as set.
        let refused =
            |d: &Drivers| d.dependent.iter().copied().find(|&at| given(at) && (single(at) || d.declared));
        if refused(&divided).is_some() && !divided.declared {
            // In long trains a driver may be effective at one pose and, within rounding, not at another. Try the
            // starting pose.
            let mut here = GroupRows::default();
            here.fill(model, group, &near());
            let there = model.drivers_for(group, &here, &self.drivers, self.floor, &given);
            if refused(&there).is_none() {
                divided = there;
            }
        }
        match refused(&divided) {
            Some(at) => Err(Refused { at, drivers: divided }),
            None => Ok(divided),
        }
    }

    /// The misfit, if larger than the rounding of positions; otherwise 0.
    pub fn misfit_beyond(&self, group: &Group, kinematics: &Kinematics, model: &Model) -> f64 {
        let rounding = 0.03 * model.closing_tolerance(kinematics, group);
        if self.misfit > rounding { self.misfit } else { 0.0 }
    }
}

/// Facts about all loops of a model.
#[derive(Clone, Debug)]
pub(crate) struct Facts {
    /// Positions of a closed pose, as close to the start as possible.
    pub reference: Vec<f64>,
    pub groups: Vec<GroupFacts>,
}

impl Model {
    /// Finds the first closed pose from `start`, and the generic properties of each group.
    pub fn find_loop_facts(&self, mut start: Kinematics) -> Result<Facts, AssemblyError> {
        let mut first = Vec::with_capacity(self.groups.len());
        for group in &self.groups {
            self.refuse_far(group)?;
            self.refuse_rod(group)?;
            start.refill_bodies(self, &group.bodies);
            let before = self.group_positions(group, &start.q);
            let drawn_gaps = self.constraint_gaps(&start, group);
            let inexactness = self.close_first(&mut start, group)?;
            let moved = self.most_moved(group, &before, &start.q);
            first.push((inexactness, drawn_gaps, moved));
        }
        start.refill(self);
        let mut groups = Vec::with_capacity(self.groups.len());
        let mut scratch = start.clone();
        for (group, (inexactness, drawn_gaps, moved)) in self.groups.iter().zip(first) {
            let facts = self.find_group_facts(&start, &mut scratch, group, inexactness);
            groups.push(GroupFacts { drawn_gaps, moved, ..facts });
        }
        Ok(Facts { reference: start.q, groups })
    }

    /// Facts with the loops left open at `start`.
    pub fn open_loop_facts(&self, start: Kinematics) -> Facts {
        let open = |group: &Group| {
            let mut rows = GroupRows::default();
            rows.fill(self, group, &start);
            let floor = group.floor_for(0.0);
            let drivers = self.default_drivers(group, &rows, floor);
            GroupFacts {
                generic: self.group_positions(group, &start.q),
                rank: rank_of_rows(&rows, group, floor),
                rows,
                inexactness: 0.0,
                misfit: 0.0,
                floor,
                reference_is_regular: true,
                mode_rows: Vec::new(),
                drivers,
                drawn_gaps: self.constraint_gaps(&start, group),
                moved: None,
            }
        };
        let groups = self.groups.iter().map(open).collect();
        Facts { reference: start.q, groups }
    }

    /// Refuses a group that is too far from the root for its size to be resolved.
    fn refuse_far(&self, group: &Group) -> Result<(), AssemblyError> {
        let (size, far, farthest) = (group.size, group.far, FARTHEST * group.size);
        if far <= farthest {
            return Ok(());
        }
        let known = f64::EPSILON * far;
        Err(AssemblyError::TooFarOut { loops: self.group_names(group), size, far, farthest, known })
    }

    /// Refuses a distance closure without declared length whose ends coincide, relative to the size of the group.
    fn refuse_rod(&self, group: &Group) -> Result<(), AssemblyError> {
        let rod = group.constraints.iter().find_map(|c| match c.constraint {
            crate::model::Constraint::Closure(i) => {
                let closure = &self.closures[i];
                let none = closure.measured_distance && closure.distance <= CLOSED * group.size;
                (closure.kind == ClosureKind::Distance && none).then_some(closure)
            }
            _ => None,
        });
        match rod {
            Some(rod) => Err(AssemblyError::NoDistance { name: rod.name.clone() }),
            None => Ok(()),
        }
    }

    /// Largest residual of each constraint of a group, m.
    fn constraint_gaps(&self, kinematics: &Kinematics, group: &Group) -> Vec<f64> {
        let residuals = self.group_residuals(kinematics, group);
        let gap = |c: &crate::model::ConstraintRows| {
            residuals[c.first..c.first + c.count].iter().fold(0.0, |most: f64, r| most.max(r.abs()))
        };
        group.constraints.iter().map(gap).collect()
    }

    /// The coordinate of the group with the largest displacement × length (m) between two poses: its joint, and its signed
    /// displacement (rad or m). `None` if no coordinate moved.
    fn most_moved(&self, group: &Group, from: &[f64], to: &[f64]) -> Option<(JointId, f64)> {
        let u = self.displacement_from(group, from, to);
        let size = |at: usize| (u[at] * group.lengths[at]).abs();
        let most = group.movable.iter().copied().max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        group.joints[most].filter(|_| u[most] != 0.0).map(|joint| (joint, u[most]))
    }

    /// Closes a group near its current pose. Returns the inexactness.
    fn close_first(&self, kinematics: &mut Kinematics, group: &Group) -> Result<f64, AssemblyError> {
        let tolerance = self.closing_tolerance(kinematics, group);
        let allowed = ROUNDING * group.size;
        let all = &group.movable;
        let declared = |at: &usize| self.coordinates[group.coordinates[*at]].independent == Some(true);
        let advised: Vec<usize> = all.iter().copied().filter(|at| !declared(at)).collect();
        let mut best: Option<(Vec<f64>, Correction)> = None;
        let start = self.group_positions(group, &kinematics.q);
        // A start costs some tens of factorisations of the rows.
        let (rows, columns) = (group.rows as u64, group.coordinates.len() as u64);
        let affordable = FIRST_STARTS_WORK / (columns * columns * rows.max(columns)).max(1);
        let starts = affordable.clamp(FEWEST_FIRST_STARTS, FIRST_STARTS);
        let mut may_be_rounded: Option<bool> = None;
        for attempt in 0..MOST_FIRST_STARTS {
            // Poses that are nearly closed by chance need more starts.
            if attempt >= starts && (starts < FIRST_STARTS || may_be_rounded.unwrap_or(true)) {
                break;
            }
            // Without declared drivers the second attempt is the first one again.
            if attempt == 1 && advised.len() == all.len() {
                continue;
            }
            self.restore_group(kinematics, group, &start);
            if attempt > 1 {
                // At a stationary start (Aᵀr = 0 with r ≠ 0), restart from fixed perturbations of increasing size.
                self.perturb(
                    kinematics,
                    group,
                    FIRST_STARTS_ASIDE[(attempt as usize / 2 - 1) % FIRST_STARTS_ASIDE.len()],
                    attempt,
                );
            }
            let unknown = if attempt == 0 { &advised } else { all };
            let correction = self.correct(kinematics, group, Directions::of(unknown), tolerance);
            if correction.closed {
                return Ok(0.0);
            }
            if best.as_ref().is_none_or(|(_, b)| correction.residual < b.residual) {
                best = Some((self.group_positions(group, &kinematics.q), correction));
            }
            // If the residual is within the rounding of a file, no search elsewhere is needed.
            if (attempt >= 1 || advised.len() == all.len())
                && best.as_ref().is_some_and(|(_, b)| b.residual <= allowed)
                && *may_be_rounded.get_or_insert_with(|| self.may_be_rounded(kinematics, group, &start))
            {
                break;
            }
        }
        let Some((positions, correction)) = best else { return Ok(0.0) };
        self.restore_group(kinematics, group, &positions);
        if correction.residual <= allowed {
            return Ok(correction.residual);
        }
        let mut loops = self.group_names(group);
        if let Some(worst) = loops.iter().position(|n| *n == self.row_name(group, correction.worst)) {
            loops.swap(0, worst);
        }
        let cut = (starts < FIRST_STARTS).then_some((starts, FIRST_STARTS, group.coordinates.len()));
        Err(AssemblyError::DoesNotClose { loops, residual: correction.residual, allowed, cut })
    }

    /// True if a small residual of a group can come from the rounding of its file: the file draws the group nearly closed,
    /// or its rows are dependent. Otherwise a small residual is a pose that is nearly closed by chance, such as the end of
    /// a branch. Leaves the group at `start`, its positions as drawn.
    fn may_be_rounded(&self, kinematics: &mut Kinematics, group: &Group, start: &[f64]) -> bool {
        self.restore_group(kinematics, group, start);
        if self.group_residual(kinematics, group).0 <= DRAWN_CLOSED * group.size {
            return true;
        }
        self.perturb(kinematics, group, FIRST_STARTS_ASIDE[0], 2000);
        let mut rows = GroupRows::default();
        rows.fill(self, group, kinematics);
        self.restore_group(kinematics, group, start);
        rank_of_rows(&rows, group, group.floor_for(0.0)).rank < group.rows
    }

    /// Searches closed poses around the first closed pose for the generic rank. First the poses are found, then the
    /// largest inexactness over all poses, then the ranks with a common threshold. `scratch`: workspace with the same frames
    /// as `reference`; restored at the end.
    fn find_group_facts(
        &self,
        reference: &Kinematics,
        scratch: &mut Kinematics,
        group: &Group,
        at_first: f64,
    ) -> GroupFacts {
        let home = self.group_positions(group, &reference.q);
        let tolerance = self.closing_tolerance(reference, group);
        let all = Directions::of(&group.movable);
        let fits = if at_first > 0.0 { (OTHER_POSE_RESIDUAL * at_first).max(tolerance) } else { tolerance };
        let enough = if group.coordinates.len() > LARGE_GROUP { 1 } else { GENERIC_POSES_ENOUGH };
        let (mut found, mut unsettled, mut inexactness) = (Vec::new(), None, at_first);
        for attempt in 0..GENERIC_POSES {
            self.restore_group(scratch, group, &home);
            self.perturb(scratch, group, [0.2, 0.1, 0.03][attempt as usize / 4], 1000 + attempt);
            let correction = self.correct(scratch, group, all, tolerance);
            if correction.residual > fits {
                continue;
            }
            let apart = self.displacement(group, &reference.q, &scratch.q);
            let gone = apart.iter().zip(&group.lengths).map(|(w, l)| (w * l).powi(2)).sum::<f64>().sqrt();
            let there = self.group_positions(group, &scratch.q);
            if gone < SAME_POSE * group.size || !self.is_converged(scratch, group, at_first) {
                unsettled.get_or_insert(there);
                continue;
            }
            if at_first > 0.0 {
                inexactness = inexactness.max(correction.residual);
            }
            found.push(there);
            if found.len() == enough {
                break;
            }
        }
        if found.is_empty() {
            // All corrections led back to a crossing of branches: follow the branches instead.
            let around = self.surroundings(reference, group, inexactness);
            for branch in &around.branches {
                let beside = DEPARTURES.into_iter().find_map(|reach| {
                    self.restore_group(scratch, group, &home);
                    let size = reach * around.group.size;
                    let beside = self.close_at_distance(scratch, &around, &branch.along, size);
                    beside.map(|_| self.group_positions(group, &scratch.q))
                });
                found.extend(beside);
            }
            // No branch leaves the pose: use the rank at a nearby pose that does not count as closed.
            found.extend(unsettled.filter(|_| around.branches.is_empty() && !around.regular));
        }
        let floor = group.floor_for(inexactness);
        let rank_of = |kinematics: &Kinematics| {
            let mut rows = GroupRows::default();
            rows.fill(self, group, kinematics);
            (rank_of_rows(&rows, group, floor), rows)
        };
        let (at_reference, reference_rows) = rank_of(reference);
        // Any other pose is preferred, because many terms vanish with all joints at 0. Of several, the
        // best-conditioned is used.
        let mut best = (home.clone(), reference_rows, at_reference, 0.0);
        for positions in found {
            self.restore_group(scratch, group, &positions);
            let (rank, rows) = rank_of(scratch);
            if rank.rank > best.2.rank || (rank.rank == best.2.rank && rank.least > best.3) {
                best = (positions, rows, rank, rank.least);
            }
        }
        self.restore_group(scratch, group, &home);
        let (generic, rows, rank, _) = best;
        let drivers = self.default_drivers(group, &rows, floor);
        let reference_is_regular = at_reference.rank == rank.rank;
        let (drawn_gaps, moved) = (Vec::new(), None);
        let misfit = inexactness.max(self.group_residual(reference, group).0);
        let mode_rows = independent_rows(group, &rows, &drivers.dependent);
        GroupFacts {
            generic,
            rows,
            rank,
            inexactness,
            misfit,
            floor,
            reference_is_regular,
            drivers,
            mode_rows,
            drawn_gaps,
            moved,
        }
    }

    /// True if Newton's method would stay at a closed pose. Near a crossing the residual is the square of the
    /// remaining distance, and falls below the closing tolerance too early.
    fn is_converged(&self, kinematics: &Kinematics, group: &Group, inexactness: f64) -> bool {
        let here = Linearised::at(self, kinematics, group);
        let floor = if inexactness > 0.0 { group.floor_for(inexactness) } else { 0.0 };
        let step = here.step(group, Directions::of(&group.movable), floor);
        step.iter().map(|x| x * x).sum::<f64>().sqrt() <= CONVERGED_STEP * group.size
    }

    /// Perturbs a group's coordinates by fixed pseudo-random amounts up to `size` (rad, or times the group's size).
    pub fn perturb(&self, kinematics: &mut Kinematics, group: &Group, size: f64, seed: u64) {
        let mut random = Splitmix::new(seed);
        let u: Vec<f64> =
            group.lengths.iter().map(|length| size * random.symmetric() * group.size / length).collect();
        self.advance_group(kinematics, group, &u);
    }
}

/// Fixed pseudo-random sequence (splitmix64: Steele, Lea, Flood 2014).
pub(crate) struct Splitmix(u64);

impl Splitmix {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    /// Next number in −1…1.
    pub fn symmetric(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        2.0 * ((z >> 11) as f64 / (1u64 << 53) as f64) - 1.0
    }
}
