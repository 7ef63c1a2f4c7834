//! Who drives a group and who follows.

use super::Group;
use super::assembly::GroupFacts;
use super::following::ease;
use super::rank::{decide, singular_values};
use crate::System;
use crate::kinematics::Kinematics;
use faer::Mat;
use nalgebra::DMatrix;

/// Who drives a group; by index into its coordinates. A floating base does neither: everything is seen from it.
#[derive(Clone, Debug)]
pub(crate) struct Roles {
    pub following: Vec<usize>,
    pub driving: Vec<usize>,
    /// Whether the file declared exactly these as independent.
    pub declared: bool,
    /// Least over largest pivot of the followers' Jacobian at the generic pose.
    pub ease: f64,
}

impl System {
    /// What the file says of a coordinate: to drive, to follow, or nothing.
    pub(crate) fn advice(&self, group: &Group, at: usize) -> Option<bool> {
        group.joints[at].and_then(|id| self.mechanism.joint(id).independent())
    }

    /// Who drives where nothing is set: what is declared, else the best-conditioned choice.
    pub(crate) fn advised_roles(&self, group: &Group, generic: &DMatrix<f64>, floor: f64) -> Roles {
        let wish = |at: usize| self.wish(group, at, |_| false);
        let movable =
            DMatrix::from_fn(generic.nrows(), group.movable.len(), |r, k| generic[(r, group.movable[k])]);
        let lengths: Vec<f64> = group.movable.iter().map(|&at| group.lengths[at]).collect();
        let count = decide(&singular_values(&movable, &lengths), floor).rank;
        let mut roles = self.roles_by(group, generic, count, wish);
        let advised = group.movable.iter().filter(|&&at| wish(at) == 2).count();
        roles.declared = roles.driving.iter().all(|&at| wish(at) == 2) && advised == roles.driving.len();
        roles
    }

    /// Who drives where these are set: they do as far as they can, unless the file declares others.
    pub(crate) fn roles(&self, group: &Group, facts: &GroupFacts, given: impl Fn(usize) -> bool) -> Roles {
        let advised = &facts.roles;
        if advised.declared || !advised.following.iter().any(|&at| given(at)) {
            return advised.clone();
        }
        self.roles_by(group, &facts.rows, advised.following.len(), |at| self.wish(group, at, &given))
    }

    /// As [`roles`](Self::roles), by the rows at another pose; as many follow as in `generic`.
    pub(crate) fn roles_at(
        &self,
        group: &Group,
        kinematics: &Kinematics<f64>,
        generic: &Roles,
        given: impl Fn(usize) -> bool,
    ) -> Roles {
        let (_, rows) = self.group_rows(kinematics, group);
        self.roles_by(group, &rows, generic.following.len(), |at| self.wish(group, at, &given))
    }

    /// How much a coordinate wants to drive.
    fn wish(&self, group: &Group, at: usize, given: impl Fn(usize) -> bool) -> u8 {
        match self.advice(group, at) {
            _ if given(at) => 3,
            Some(false) => 0,
            None => 1,
            Some(true) => 2,
        }
    }

    /// Splits a group's coordinates, `count` of which follow. `wish` says how much each wants to drive; among equals the best-conditioned choice
    /// follows.
    fn roles_by(
        &self,
        group: &Group,
        generic: &DMatrix<f64>,
        count: usize,
        wish: impl Fn(usize) -> u8,
    ) -> Roles {
        let rows = generic.nrows();
        let mut following = Vec::new();
        let column = |at: usize| generic.column(at) / group.lengths[at];
        let largest = group.movable.iter().map(|&at| column(at).norm()).fold(0.0, f64::max);
        // Orthonormal columns that the followers span.
        let mut span = Mat::<f64>::zeros(rows, 0);
        // A second, laxer pass takes what the first found too nearly dependent.
        for threshold in [1e-6, 1e-10] {
            for class in 0..=3 {
                let open: Vec<usize> = group
                    .movable
                    .iter()
                    .copied()
                    .filter(|at| wish(*at) == class && !following.contains(at))
                    .collect();
                let columns =
                    Mat::from_fn(rows, open.len(), |r, k| generic[(r, open[k])] / group.lengths[open[k]]);
                // Twice is enough: what is left is normal to the span to rounding.
                let once = &columns - &span * (span.transpose() * &columns);
                let rest = &once - &span * (span.transpose() * &once);
                if open.is_empty() || following.len() == count || rest.norm_max() <= threshold * largest {
                    continue;
                }
                let qr = rest.col_piv_qr();
                let r = qr.R();
                let size = r.nrows().min(open.len()).min(count - following.len());
                let more = (0..size).take_while(|&i| r[(i, i)].abs() > threshold * largest).count();
                following.extend(qr.P().arrays().0[..more].iter().map(|&k| open[k]));
                let q = qr.compute_thin_Q();
                let before = span.ncols();
                span = Mat::from_fn(rows, before + more, |r, c| {
                    if c < before { span[(r, c)] } else { q[(r, c - before)] }
                });
            }
        }
        following.sort_unstable();
        let follows = |at: &usize| following.binary_search(at).is_ok();
        let driving = group.movable.iter().copied().filter(|at| !follows(at)).collect();
        let ease = ease(group, generic, &following);
        Roles { following, driving, declared: false, ease }
    }
}
