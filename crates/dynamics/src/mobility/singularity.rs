//! Assembly mode of a group, and singularities.

use super::drivers::Drivers;
use super::elimination::rank_of_rows;
use super::rank::Rank;
use super::{decide_rank, singular_values};
use crate::kinematics::rows::GroupRows;
use crate::linear::dense::determinant_sign;
use crate::linear::jacobian::Jacobian;
use crate::model::{Group, Model};
use crate::tolerances::{DEAD_CENTRE, MODE_LIMIT, NEAR_CHANGE_POINT, SINGULAR_VALUES_LIMIT};
use std::borrow::Cow;

/// Singularity of a group of loops at a pose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Singularity {
    /// No singularity: the driving coordinates determine the others.
    #[default]
    None,
    /// Dead centre: a limit of the chosen driving coordinates, with almost no motion transmitted to the other
    /// coordinates. The mechanism has its usual mobility.
    DeadCentre,
    /// Change point: branches cross, and the constraints have less than their generic rank.
    ChangePoint,
}

/// Assembly mode and singularity of a group.
pub(crate) struct Mode {
    pub sign: i8,
    pub singularity: Singularity,
}

/// Properties of a group at its generic pose.
pub(crate) struct Generic<'a> {
    pub rows: &'a GroupRows,
    pub rank: Rank,
    pub floor: f64,
    /// The dependent coordinates of the default drivers, and the rows that determine their mode.
    pub default_rows: Option<(&'a [usize], &'a [usize])>,
}

impl Model {
    /// Assembly mode of a group with these rows: the sign of the determinant of the dependent coordinates' Jacobian,
    /// on rows that are independent at the generic pose. 0 at a singularity.
    pub fn mode_of(&self, rows: &GroupRows, group: &Group, generic: &Generic, drivers: &Drivers) -> Mode {
        let dependent = &drivers.dependent;
        let here = scaled(group, rows, dependent);
        // A singularity requires weak columns of the dependent coordinates.
        let weak = here.pivot_ratio() < DEAD_CENTRE * drivers.conditioning;
        let singularity = if weak { singularity(group, rows, generic) } else { Singularity::None };
        let count = dependent.len();
        if singularity != Singularity::None || count == 0 || count > MODE_LIMIT {
            return Mode { sign: 0, singularity };
        }
        let order: Cow<[usize]> = match generic.default_rows {
            Some((known, order)) if known == dependent => order.into(),
            _ => independent_rows(group, generic.rows, dependent).into(),
        };
        if order.len() < count {
            return Mode { sign: 0, singularity };
        }
        let mut place = vec![usize::MAX; group.rows];
        order.iter().enumerate().for_each(|(i, r)| place[*r] = i);
        let mut square = vec![0.0; count * count];
        for (r, c, a) in here.entries.iter().filter(|(r, ..)| place[*r] != usize::MAX) {
            square[place[*r] * count + c] += a;
        }
        Mode { sign: determinant_sign(&mut square, count), singularity }
    }
}

/// Rows that are independent at the generic pose, as many as dependent coordinates.
pub(crate) fn independent_rows(group: &Group, rows: &GroupRows, dependent: &[usize]) -> Vec<usize> {
    if dependent.len() > MODE_LIMIT || group.rows < dependent.len() {
        return Vec::new();
    }
    let there = scaled(group, rows, dependent).dense();
    if there.norm_max() == 0.0 {
        return Vec::new();
    }
    there.transpose().to_owned().col_piv_qr().P().arrays().0[..dependent.len()].to_vec()
}

/// A over some coordinates, scaled by the group's lengths.
fn scaled(group: &Group, rows: &GroupRows, columns: &[usize]) -> Jacobian {
    let mut entries = Vec::with_capacity(rows.len());
    rows.for_each(group, |r, c, a| {
        if let Ok(k) = columns.binary_search(&c) {
            entries.push((r, k, a / group.lengths[c]));
        }
    });
    Jacobian { rows: group.rows, columns: columns.len(), entries }
}

/// Kind of singularity behind weak columns of the dependent coordinates. `None` near a change point at which A still
/// has full rank.
fn singularity(group: &Group, rows: &GroupRows, generic: &Generic) -> Singularity {
    let (here, least) = rank_near(rows, group, generic);
    if here < generic.rank.rank {
        Singularity::ChangePoint
    } else if least > NEAR_CHANGE_POINT {
        Singularity::DeadCentre
    } else {
        Singularity::None
    }
}

/// Rank of a group's rows, and the singular value at the index of the generic rank, relative to the largest. Large
/// groups use sparse pivots.
fn rank_near(rows: &GroupRows, group: &Group, generic: &Generic) -> (usize, f64) {
    if group.coordinates.len() > SINGULAR_VALUES_LIMIT {
        let rank = rank_of_rows(rows, group, generic.floor);
        return (rank.rank, rank.least);
    }
    let mut matrix = nalgebra::DMatrix::zeros(group.rows, group.coordinates.len());
    rows.for_each(group, |r, c, a| matrix[(r, c)] += a);
    let values = singular_values(&matrix, &group.lengths);
    let last = generic.rank.rank.checked_sub(1).and_then(|last| values.get(last));
    let largest = values.first().copied().unwrap_or(0.0);
    (decide_rank(&values, generic.floor).rank, last.map_or(f64::INFINITY, |last| last / largest))
}
