//! Division of a group's coordinates into driving and dependent ones.

use super::rank::{decide_rank, singular_values};
use crate::kinematics::rows::GroupRows;
use crate::linear::jacobian::Jacobian;
use crate::linear::sparse::{SparseRows, eliminate_by_class};
use crate::model::{Group, Model};
use crate::tolerances::{DENSE_LIMIT, INDEPENDENT_COLUMNS};
use faer::Mat;
use nalgebra::DMatrix;

/// Driving and dependent coordinates of a group, by index into the group. The coordinates of a floating base are
/// neither, because all poses are relative to the base.
#[derive(Clone, Debug)]
pub(crate) struct Drivers {
    pub dependent: Vec<usize>,
    pub driving: Vec<usize>,
    /// True if the file declares exactly the driving coordinates as independent.
    pub declared: bool,
    /// Ratio of the smallest to the largest pivot of the dependent coordinates' Jacobian at the generic pose.
    pub conditioning: f64,
}

/// Priority of a coordinate for driving. Coordinates of low priority become dependent first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Priority {
    /// Declared dependent in the file.
    Dependent,
    /// One of several velocities of a joint, such as the spin of a rod.
    Component,
    /// A joint of one degree of freedom.
    Single,
    /// A joint with limits or an effort, and therefore probably actuated.
    Actuated,
    /// Declared independent in the file.
    Declared,
    /// Set by the user.
    Given,
}

impl Model {
    /// Default drivers: the declared coordinates, otherwise coordinates that are probably actuated and
    /// well-conditioned.
    pub fn default_drivers(&self, group: &Group, rows: &GroupRows, floor: f64) -> Drivers {
        let jacobian = of_movable(group, rows);
        let count = if group.movable.len() <= DENSE_LIMIT {
            decide_rank(&singular_values(&dense(&jacobian), &vec![1.0; jacobian.columns]), floor).rank
        } else {
            usize::MAX
        };
        let mut drivers = self.divide_coordinates(group, jacobian, count, floor, |_| false);
        let declared = |at: &usize| self.priority(group, *at, |_| false) == Priority::Declared;
        let all = group.movable.iter().filter(|at| declared(at)).count();
        drivers.declared = drivers.driving.iter().all(declared) && all == drivers.driving.len();
        drivers
    }

    /// Drivers for a configuration in which the `given` coordinates are set. Set coordinates drive as far as
    /// possible, unless the file declares others. `rows` are those of the generic pose; `default` is the division
    /// without set coordinates.
    pub fn drivers_for(
        &self,
        group: &Group,
        rows: &GroupRows,
        default: &Drivers,
        floor: f64,
        given: impl Fn(usize) -> bool,
    ) -> Drivers {
        if default.declared || !default.dependent.iter().any(|&at| given(at)) {
            return default.clone();
        }
        self.divide_coordinates(group, of_movable(group, rows), default.dependent.len(), floor, given)
    }

    /// Priority of a coordinate for driving.
    fn priority(&self, group: &Group, at: usize, given: impl Fn(usize) -> bool) -> Priority {
        let coordinate = &self.coordinates[group.coordinates[at]];
        let single = coordinate.joint.is_some_and(|id| self.mechanism.joint(id).kind().dofs() == 1);
        match coordinate.independent {
            _ if given(at) => Priority::Given,
            Some(false) => Priority::Dependent,
            Some(true) => Priority::Declared,
            None if coordinate.actuated => Priority::Actuated,
            None if single => Priority::Single,
            None => Priority::Component,
        }
    }

    /// Divides the movable coordinates of a group; `count` of the coordinates become dependent. Coordinates of the
    /// lowest priority become dependent first. Among equal priorities, well-conditioned coordinates far from the root are
    /// preferred. `given`: true for coordinates with a requested position; `floor`: threshold of the rank.
    fn divide_coordinates(
        &self,
        group: &Group,
        jacobian: Jacobian,
        count: usize,
        floor: f64,
        given: impl Fn(usize) -> bool,
    ) -> Drivers {
        let priorities: Vec<Priority> =
            group.movable.iter().map(|&at| self.priority(group, at, &given)).collect();
        let weights: Vec<f64> = group
            .movable
            .iter()
            .map(|&at| 1.0 + self.coordinates[group.coordinates[at]].depth as f64)
            .collect();
        let mut chosen = if group.movable.len() <= DENSE_LIMIT {
            choose(&dense(&jacobian), count, &priorities, &weights)
        } else {
            let mut sparse = SparseRows::default();
            sparse.load(jacobian.rows, jacobian.columns, |add| {
                jacobian.entries.iter().for_each(|(r, c, a)| add(*r, *c, *a));
            });
            let class: Vec<u8> = priorities.iter().map(|p| *p as u8).collect();
            eliminate_by_class(&mut sparse, floor, &class).columns
        };
        chosen.sort_unstable();
        let conditioning = restricted(&jacobian, &chosen).pivot_ratio();
        let depends = |k: &usize| chosen.binary_search(k).is_ok();
        let driving = (0..group.movable.len()).filter(|k| !depends(k)).map(|k| group.movable[k]).collect();
        let dependent = chosen.iter().map(|&k| group.movable[k]).collect();
        Drivers { dependent, driving, declared: false, conditioning }
    }
}

/// A over the movable coordinates, scaled by the group's lengths.
fn of_movable(group: &Group, rows: &GroupRows) -> Jacobian {
    let mut place = vec![usize::MAX; group.coordinates.len()];
    group.movable.iter().enumerate().for_each(|(k, &at)| place[at] = k);
    let mut entries = Vec::new();
    rows.for_each(group, |r, c, a| {
        if place[c] != usize::MAX {
            entries.push((r, place[c], a / group.lengths[c]));
        }
    });
    Jacobian { rows: group.rows, columns: group.movable.len(), entries }
}

/// Columns of a Jacobian.
fn restricted(jacobian: &Jacobian, columns: &[usize]) -> Jacobian {
    let place = |(r, c, a): &(usize, usize, f64)| Some((*r, columns.binary_search(c).ok()?, *a));
    Jacobian {
        rows: jacobian.rows,
        columns: columns.len(),
        entries: jacobian.entries.iter().filter_map(place).collect(),
    }
}

fn dense(jacobian: &Jacobian) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(jacobian.rows, jacobian.columns);
    jacobian.entries.iter().for_each(|(r, c, a)| matrix[(*r, *c)] += a);
    matrix
}

/// Chooses `count` independent columns, lowest priority first.
fn choose(matrix: &DMatrix<f64>, count: usize, priorities: &[Priority], weights: &[f64]) -> Vec<usize> {
    let rows = matrix.nrows();
    let count = count.min(rows).min(matrix.ncols());
    let mut chosen: Vec<usize> = Vec::new();
    let largest = matrix.column_iter().map(|c| c.norm()).fold(0.0, f64::max);
    let mut order: Vec<Priority> = priorities.to_vec();
    order.sort_unstable();
    order.dedup();
    // Orthonormal basis of the chosen columns.
    let mut span = Mat::<f64>::zeros(rows, 0);
    for threshold in INDEPENDENT_COLUMNS {
        for &priority in &order {
            let open: Vec<usize> =
                (0..matrix.ncols()).filter(|k| priorities[*k] == priority && !chosen.contains(k)).collect();
            if open.is_empty() || chosen.len() == count {
                continue;
            }
            let columns = Mat::from_fn(rows, open.len(), |r, k| matrix[(r, open[k])]);
            // Two projections are enough to make the remainder orthogonal to the basis within rounding.
            let once = &columns - &span * (span.transpose() * &columns);
            let rest = &once - &span * (span.transpose() * &once);
            if rest.norm_max() <= threshold * largest {
                continue;
            }
            let weighted = Mat::from_fn(rows, open.len(), |r, k| rest[(r, k)] * weights[open[k]]);
            let qr = weighted.col_piv_qr();
            let (r, order) = (qr.R(), qr.P().arrays().0);
            let size = r.nrows().min(open.len()).min(count - chosen.len());
            let left = |i: usize| r[(i, i)].abs() / weights[open[order[i]]];
            let more = (0..size).take_while(|&i| left(i) > threshold * largest).count();
            chosen.extend(order[..more].iter().map(|&k| open[k]));
            let q = qr.compute_thin_Q();
            let before = span.ncols();
            span =
                Mat::from_fn(
                    rows,
                    before + more,
                    |r, c| {
                        if c < before { span[(r, c)] } else { q[(r, c - before)] }
                    },
                );
        }
    }
    chosen
}
