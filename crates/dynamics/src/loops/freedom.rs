//! Degrees of freedom: generic and present, and which rows are redundant.

use super::Group;
use super::assembly::GroupFacts;
use super::rank::{FLOOR, Rank, decide, singular_values};
use crate::System;
use crate::kinematics::Kinematics;
use nalgebra::DMatrix;

/// Rank of all constraints at a generic closed pose.
#[derive(Clone, Debug, Default)]
pub(crate) struct GenericRank {
    pub rows: usize,
    pub rank: usize,
    /// Least gap of any group; none without constraints.
    pub gap: Option<f64>,
    pub clear: bool,
    /// Names of the loops and couplings on which redundant rows lie; those that cannot be told apart together.
    pub redundant: Vec<Vec<String>>,
}

impl System {
    /// Degrees of freedom at a generic pose; a floating base counts 6. Loops that do not close count as open.
    pub fn degrees_of_freedom(&self) -> usize {
        self.coordinates - self.generic_rank().rank
    }

    /// Degrees of freedom at a pose: more than the generic number at a change point.
    pub fn degrees_of_freedom_at(&self, pose: &crate::Pose) -> usize {
        let rows = self.constraint_rows(&pose.kinematics);
        let values = singular_values(&rows, &self.coordinate_lengths());
        self.coordinates - decide(&values, self.rank_floor()).rank
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

    /// Whether the generic rank is beyond doubt.
    pub fn rank_is_clear(&self) -> bool {
        self.generic_rank().clear
    }

    /// Singular values of A below this part of the largest count as zero.
    pub(crate) fn rank_floor(&self) -> f64 {
        let inexact =
            self.assembly().map_or(0.0, |a| a.groups.iter().map(|g| g.inexactness).fold(0.0, f64::max));
        FLOOR.max(10.0 * inexact / self.mechanism.characteristic_length())
    }

    pub(crate) fn generic_rank(&self) -> &GenericRank {
        self.generic_rank.get_or_init(|| self.find_generic_rank())
    }

    fn find_generic_rank(&self) -> GenericRank {
        if self.groups.is_empty() && self.held.is_empty() {
            return GenericRank { clear: true, ..GenericRank::default() };
        }
        let kinematics = self.generic_kinematics();
        let floor = self.rank_floor();
        let mut total = GenericRank { clear: true, ..GenericRank::default() };
        let mut add = |rows: usize, rank: Rank| {
            total.rows += rows;
            total.rank += rank.rank;
            total.gap = Some(total.gap.unwrap_or(f64::INFINITY).min(rank.gap));
            total.clear &= rank.clear;
        };
        if !self.held.is_empty() {
            // Held contacts tie groups together.
            let rows = self.constraint_rows(&kinematics);
            add(rows.nrows(), decide(&singular_values(&rows, &self.coordinate_lengths()), floor));
            return total;
        }
        let mut redundant = Vec::new();
        for group in &self.groups {
            let (_, rows) = self.group_rows(&kinematics, group);
            let lengths = self.lengths_of(group);
            let rank = decide(&singular_values(&rows, &lengths), floor);
            add(rows.nrows(), rank);
            if rank.rank < rows.nrows() {
                let mut names: Vec<String> = dependent_rows(&rows, &lengths, rank.rank)
                    .into_iter()
                    .map(|row| group.row_name(self, row).to_owned())
                    .collect();
                names.dedup();
                redundant.push(names);
            }
        }
        total.redundant = redundant;
        total
    }

    /// Every group at its generic pose.
    fn generic_kinematics(&self) -> Kinematics<f64> {
        let poser = self.unlocked.as_deref().unwrap_or(self);
        let mut kinematics = self.zero_kinematics();
        if let Ok(assembly) = poser.assembly() {
            for (group, facts) in poser.groups.iter().zip(&assembly.groups) {
                poser.set_group(&mut kinematics, group, &facts.generic);
            }
        }
        kinematics.refill(self);
        kinematics
    }
}

impl System {
    /// Sign of the followers' Jacobian's determinant, on rows that are independent at the generic pose; 0 where it is
    /// singular.
    pub(crate) fn mode(
        &self,
        kinematics: &Kinematics<f64>,
        group: &Group,
        facts: &GroupFacts,
        following: &[usize],
    ) -> i8 {
        let lengths = self.lengths_of(group);
        let count = following.len();
        let scaled =
            |rows: &DMatrix<f64>, r: usize, c: usize| rows[(r, following[c])] / lengths[following[c]];
        let generic = faer::Mat::from_fn(count, facts.rows.nrows(), |c, r| scaled(&facts.rows, r, c));
        if count == 0 || generic.norm_max() == 0.0 {
            return 0;
        }
        let order: Vec<usize> = generic.col_piv_qr().P().arrays().0[..count].to_vec();
        let (_, rows) = self.group_rows(kinematics, group);
        let square = DMatrix::from_fn(count, count, |r, c| scaled(&rows, order[r], c));
        let values = singular_values(&square, &vec![1.0; count]);
        let regular = values.last().copied().unwrap_or(0.0) > 1e-9 * values.first().copied().unwrap_or(0.0);
        match (regular, square.determinant() > 0.0) {
            (false, _) => 0,
            (true, true) => 1,
            (true, false) => -1,
        }
    }
}

/// Rows on which some vector of ker Aᵀ is not zero.
fn dependent_rows(rows: &DMatrix<f64>, lengths: &[f64], rank: usize) -> Vec<usize> {
    let (m, n) = rows.shape();
    let scaled = faer::Mat::from_fn(m, n, |r, c| rows[(r, c)] / lengths[c]);
    if rank == 0 || scaled.norm_max() == 0.0 {
        return (0..m).collect();
    }
    let q = scaled.col_piv_qr().compute_Q();
    (0..m).filter(|&r| (rank..m).map(|c| q[(r, c)] * q[(r, c)]).sum::<f64>() > 1e-12).collect()
}
