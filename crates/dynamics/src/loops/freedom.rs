//! Degrees of freedom: generic and present, and which rows are redundant.

use super::assembly::GroupFacts;
use super::following::ease;
use super::rank::{Rank, decide, singular_values};
use super::redundancy::Redundancy;
use super::roles::Roles;
use super::{Group, Held};
use crate::kinematics::Kinematics;
use crate::{Pose, System};
use nalgebra::DMatrix;

/// Rank of all constraints at a generic closed pose.
#[derive(Clone, Debug, Default)]
pub(crate) struct GenericRank {
    pub rows: usize,
    pub rank: usize,
    /// Least gap of any group; none without constraints.
    pub gap: Option<f64>,
    pub clear: bool,
    /// Least singular value that counts, as a part of the largest of its group; 1 without constraints.
    pub least: f64,
    /// Names of the loops and couplings on which redundant rows lie; those that cannot be told apart together.
    pub redundant: Vec<Vec<String>>,
}

/// The rank of the constraints at a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseRank {
    /// How many rows of A are independent.
    pub rank: usize,
    /// Least gap, of any group of loops, between singular values that count and those that do not; none without
    /// constraints.
    pub gap: Option<f64>,
    /// Whether no singular value is within a factor of 30 of the threshold.
    pub clear: bool,
    /// Whether the rank is less than at a generic pose: branches cross here.
    pub singular: bool,
}

impl System {
    /// Degrees of freedom at a generic pose; a floating base counts 6. Loops that do not close count as open.
    pub fn degrees_of_freedom(&self) -> usize {
        self.coordinates - self.generic_rank().rank
    }

    /// Degrees of freedom at a pose: more than the generic number at a change point.
    pub fn degrees_of_freedom_at(&self, pose: &Pose) -> usize {
        self.coordinates - self.rank_at(pose).rank
    }

    /// How the rank of the constraints is decided at a pose.
    pub fn rank_at(&self, pose: &Pose) -> PoseRank {
        let floor = self.rank_floor();
        let mut total = PoseRank { rank: 0, gap: None, clear: true, singular: false };
        let mut add = |values: &[f64]| {
            let rank = decide(values, floor);
            total.rank += rank.rank;
            total.gap = Some(total.gap.unwrap_or(f64::INFINITY).min(rank.gap));
            total.clear &= rank.clear;
        };
        if self.held.is_empty() {
            for group in &self.groups {
                let (_, rows) = self.group_rows(&pose.kinematics, group);
                add(&singular_values(&rows, &group.lengths));
            }
        } else {
            let rows = self.constraint_rows(&pose.kinematics);
            add(&singular_values(&rows, &self.coordinate_lengths()));
        }
        total.singular = total.rank < self.generic_rank().rank && self.is_singular(pose);
        total
    }

    /// Whether a pose with less than the generic rank is singular. It is not where it has as many motions as the poses
    /// beside it: on a branch with more freedoms than the one where the generic rank was taken.
    fn is_singular(&self, pose: &Pose) -> bool {
        let poser = self.unlocked.as_deref().unwrap_or(self);
        let all = 0..poser.groups.len();
        let mut less = all.filter(|&number| poser.has_lost_rank(&pose.kinematics, number)).peekable();
        // What is held or locked may bind less where the loops do not.
        less.peek().is_none() || less.any(|number| poser.is_crossing(pose, number))
    }

    /// Whether a group has less than its generic rank at a pose.
    pub(super) fn has_lost_rank(&self, kinematics: &Kinematics<f64>, number: usize) -> bool {
        let Ok(assembly) = self.assembly() else { return false };
        let group = &self.groups[number];
        let (_, rows) = self.group_rows(kinematics, group);
        let here = decide(&singular_values(&rows, &group.lengths), self.rank_floor()).rank;
        here < assembly.groups[number].rank.rank
    }

    /// Constraint rows that add nothing at a generic pose: of loops, couplings, held contacts and locks.
    pub fn redundant_constraints(&self) -> usize {
        let generic = self.generic_rank();
        self.redundant_locks + generic.rows - generic.rank
    }

    /// Loops and couplings on which redundant rows lie.
    pub fn redundant_loops(&self) -> &[Vec<String>] {
        &self.generic_rank().redundant
    }

    /// Least gap between singular values of A that count and those that do not; none without constraints.
    pub fn rank_gap(&self) -> Option<f64> {
        self.generic_rank().gap
    }

    /// The least singular value of A that counts at the generic pose, as a part of the largest of its group. Where it is
    /// small, the constraints bind by a hair: a little off in the figures of a file, and one more motion is free.
    pub fn least_singular_value(&self) -> f64 {
        self.generic_rank().least
    }

    /// Whether the generic rank is beyond doubt.
    pub fn rank_is_clear(&self) -> bool {
        self.generic_rank().clear
    }

    /// Singular values of A below this part of the largest count as zero.
    pub(crate) fn rank_floor(&self) -> f64 {
        let inexact =
            self.assembly().map_or(0.0, |a| a.groups.iter().map(|g| g.inexactness).fold(0.0, f64::max));
        self.floor_for(inexact)
    }

    pub(crate) fn generic_rank(&self) -> &GenericRank {
        if !self.groups.is_empty() && self.assembly().is_err() {
            // Not yet known: a guess may still find where they close.
            return self.open_rank.get_or_init(|| self.find_generic_rank());
        }
        self.generic_rank.get_or_init(|| self.find_generic_rank())
    }

    fn find_generic_rank(&self) -> GenericRank {
        if self.groups.is_empty() && self.held.is_empty() {
            return GenericRank { clear: true, least: 1.0, ..GenericRank::default() };
        }
        let kinematics = self.generic_kinematics();
        let floor = self.rank_floor();
        let mut total = GenericRank { clear: true, least: 1.0, ..GenericRank::default() };
        let mut add = |rows: usize, rank: Rank| {
            total.rows += rows;
            total.rank += rank.rank;
            total.gap = Some(total.gap.unwrap_or(f64::INFINITY).min(rank.gap));
            total.clear &= rank.clear;
            total.least = total.least.min(rank.least);
        };
        let mut redundancy = Redundancy::default();
        if self.held.is_empty() {
            for group in &self.groups {
                let (_, rows) = self.group_rows(&kinematics, group);
                let rank = decide(&singular_values(&rows, &group.lengths), floor);
                add(rows.nrows(), rank);
                let names: Vec<&str> = (0..rows.nrows()).map(|row| group.row_name(self, row)).collect();
                redundancy.look_at(&rows, &group.lengths, rank.rank, &names);
            }
        } else {
            // Held contacts tie groups together.
            let (rows, lengths) = (self.constraint_rows(&kinematics), self.coordinate_lengths());
            let rank = decide(&singular_values(&rows, &lengths), floor);
            add(rows.nrows(), rank);
            let names = self.constraint_names();
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            redundancy.look_at(&rows, &lengths, rank.rank, &names);
        }
        total.redundant = redundancy.sets;
        total
    }

    /// What each row of A belongs to: a closure, a coupling, a held contact.
    fn constraint_names(&self) -> Vec<String> {
        let of_group = |group: &Group| {
            let of_row = |row| group.row_name(self, row).to_owned();
            (0..group.rows(self)).map(of_row).collect::<Vec<_>>()
        };
        let of_hold = |held: &Held| {
            let name = format!("hold of {}", self.mechanism.link(held.link).name());
            vec![name; held.rows()]
        };
        self.groups.iter().flat_map(of_group).chain(self.held.iter().flat_map(of_hold)).collect()
    }

    /// Every group at its generic pose; where contacts are held, the joints outside loops aside from zero too.
    fn generic_kinematics(&self) -> Kinematics<f64> {
        let poser = self.unlocked.as_deref().unwrap_or(self);
        let mut kinematics = self.zero_kinematics();
        if !self.held.is_empty() {
            poser.perturb(&mut kinematics, &poser.outside_loops(), 0.2, 77);
        }
        if let Ok(assembly) = poser.assembly() {
            for (group, facts) in poser.groups.iter().zip(&assembly.groups) {
                poser.set_group(&mut kinematics, group, &facts.generic);
            }
        }
        kinematics.refill(self);
        kinematics
    }
}

/// How a group of loops stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Singularity {
    /// Regularly: the drivers determine the followers.
    #[default]
    None,
    /// At a limit of the chosen drivers, which have nearly no say there; the mechanism has its usual mobility.
    DeadCentre,
    /// Where branches cross: the constraints have less than their generic rank.
    ChangePoint,
}

/// Which assembly a group stands in, and how.
pub(crate) struct Place {
    pub mode: i8,
    pub singularity: Singularity,
}

/// Followers whose Jacobian's least pivot is below this part of its generic size stand at a dead centre.
const DEAD: f64 = 1e-6;
/// Where the least singular value that should count is below this part of the largest, a change point is near.
const NEAR: f64 = 1e-4;

impl System {
    /// Which assembly a group stands in: the sign of the followers' Jacobian's determinant, on rows that are independent
    /// at the generic pose; 0 where it is singular.
    pub(crate) fn place_of(
        &self,
        kinematics: &Kinematics<f64>,
        group: &Group,
        facts: &GroupFacts,
        roles: &Roles,
    ) -> Place {
        let (_, rows) = self.group_rows(kinematics, group);
        let following = &roles.following;
        // Only where the followers' rows are weak can there be a singularity.
        let weak = ease(group, &rows, following) < DEAD * roles.ease;
        let singularity = if weak { self.singularity(group, &rows, facts) } else { Singularity::None };
        let count = following.len();
        let scaled =
            |rows: &DMatrix<f64>, r: usize, c: usize| rows[(r, following[c])] / group.lengths[following[c]];
        let generic = faer::Mat::from_fn(count, facts.rows.nrows(), |c, r| scaled(&facts.rows, r, c));
        if singularity != Singularity::None || count == 0 || generic.norm_max() == 0.0 {
            return Place { mode: 0, singularity };
        }
        let order: Vec<usize> = generic.col_piv_qr().P().arrays().0[..count].to_vec();
        let square = faer::Mat::from_fn(count, count, |r, c| scaled(&rows, order[r], c));
        Place { mode: determinant_sign(&square), singularity }
    }

    /// Which singularity makes the followers' rows weak. Beside a change point they are, but all of A counts: none.
    fn singularity(&self, group: &Group, rows: &DMatrix<f64>, facts: &GroupFacts) -> Singularity {
        let floor = self.floor_for(facts.inexactness);
        let values = singular_values(rows, &group.lengths);
        let least = facts.rank.rank.checked_sub(1).map_or(f64::INFINITY, |last| values[last]);
        if decide(&values, floor).rank < facts.rank.rank {
            Singularity::ChangePoint
        } else if least > NEAR * values[0] {
            Singularity::DeadCentre
        } else {
            Singularity::None
        }
    }
}

/// The sign of a determinant that may be too small, or too large, for a number.
fn determinant_sign(square: &faer::Mat<f64>) -> i8 {
    let lu = square.partial_piv_lu();
    let order = lu.P().arrays().0;
    let mut seen = vec![false; order.len()];
    let mut negative = false;
    for first in 0..order.len() {
        // A cycle of an even number is an odd permutation.
        let mut next = first;
        while !std::mem::replace(&mut seen[next], true) {
            next = order[next];
            negative ^= next != first;
        }
        negative ^= lu.U()[(first, first)] < 0.0;
    }
    if negative { -1 } else { 1 }
}
