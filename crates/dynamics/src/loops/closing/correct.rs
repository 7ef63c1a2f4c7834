//! Closing of a group of loops: Gauss–Newton with steps of least norm, damped if these fail.

use crate::kinematics::frames::Kinematics;
use crate::kinematics::rows::{GroupRows, largest};
use crate::linear::jacobian::{Jacobian, NormalEquations};
use crate::model::{Group, Model};
use crate::tolerances::{
    CLOSING_MOTION_FACTOR, CORRECTION_ITERATIONS, CORRECTION_WORK, FEWEST_CORRECTION_ITERATIONS,
    FIRM_DIRECTION, FIRST_DAMPING, KEPT_JACOBIAN, LEAST_DAMPING, MOST_DAMPING, NEGLIGIBLE_GAP, ROUNDING,
    ROUNDING_STEP, STALLED_REDUCTION, STALLED_STEP,
};

/// Directions in which a group may be moved.
#[derive(Clone, Copy)]
pub(crate) struct Directions<'a> {
    /// Coordinates (by index into the group) that move independently.
    pub unknown: &'a [usize],
    /// Additional joint motion along a path of the drivers: rates over the group's coordinates, with a length of 1
    /// m/s.
    pub path: Option<&'a [f64]>,
}

/// Result of a correction.
pub(crate) struct Correction {
    /// Largest residual, m.
    pub residual: f64,
    /// Length of the motion from the start, m.
    pub moved: f64,
    /// Part of the motion along the path, m.
    pub path_motion: f64,
    pub closed: bool,
    /// Row with the largest residual.
    pub worst: usize,
    /// Residuals and rows of the group at the end.
    pub linearised: Linearised,
}

impl<'a> Directions<'a> {
    /// Independent motion of the given coordinates.
    pub fn of(unknown: &'a [usize]) -> Self {
        Self { unknown, path: None }
    }

    pub fn count(&self) -> usize {
        self.unknown.len() + usize::from(self.path.is_some())
    }

    /// A over the directions, each measured in metres.
    pub fn jacobian(&self, group: &Group, rows: &GroupRows) -> Jacobian {
        let mut place = vec![usize::MAX; group.coordinates.len()];
        self.unknown.iter().enumerate().for_each(|(k, &at)| place[at] = k);
        let mut entries = Vec::with_capacity(rows.len() * (1 + usize::from(self.path.is_some())));
        rows.for_each(group, |r, c, a| {
            if place[c] != usize::MAX {
                entries.push((r, place[c], a / group.lengths[c]));
            }
            if let Some(path) = self.path
                && path[c] != 0.0
            {
                entries.push((r, self.unknown.len(), a * path[c]));
            }
        });
        Jacobian { rows: group.rows, columns: self.count(), entries }
    }

    /// Converts amounts along the directions (m) to rates over the group's coordinates.
    pub fn expand(&self, group: &Group, x: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut u = vec![0.0; group.coordinates.len()];
        for (k, &at) in self.unknown.iter().enumerate() {
            u[at] = x(k) / group.lengths[at];
        }
        if let Some(path) = self.path {
            let along = x(self.unknown.len());
            u.iter_mut().zip(path).for_each(|(u, c)| *u += along * c);
        }
        u
    }
}

/// Residuals and rows of a group at its current pose.
pub(crate) struct Linearised {
    pub residuals: Vec<f64>,
    pub rows: GroupRows,
}

impl Linearised {
    /// Residuals and rows at given frames.
    pub fn at(model: &Model, kinematics: &Kinematics, group: &Group) -> Self {
        let mut rows = GroupRows::default();
        rows.fill(model, group, kinematics);
        Self { residuals: model.group_residuals(kinematics, group), rows }
    }

    /// Shortest step that closes the group to first order.
    pub fn step(&self, group: &Group, directions: Directions, floor: f64) -> Vec<f64> {
        let target: Vec<f64> = self.residuals.iter().map(|r| -r).collect();
        directions.jacobian(group, &self.rows).shortest(&target, floor)
    }
}

/// Weakest directions (in singular value) that a step may use.
#[derive(Clone, Copy, PartialEq)]
enum DirectionChoice {
    /// Only directions whose singular value is not caused by the residual itself.
    Firm,
    /// All directions above rounding.
    All,
}

impl Model {
    /// Closes a group by the smallest possible motion.
    ///
    /// A residual within the rounding of a file creates weak directions: free motions of the group, distorted by the
    /// rounding. A pose with such a residual is not moved along directions of that weakness. Weak directions are used
    /// only if they lead to a closed pose at a distance comparable to the residual. Inexact loops end at the
    /// least-squares solution of their residuals.
    pub fn correct(
        &self,
        kinematics: &mut Kinematics,
        group: &Group,
        directions: Directions,
        tolerance: f64,
    ) -> Correction {
        let firm = self.minimise_residuals(kinematics, group, directions, tolerance, DirectionChoice::Firm);
        if firm.closed || firm.residual > ROUNDING * group.size {
            return firm;
        }
        let before = self.group_positions(group, &kinematics.q);
        let all = self.minimise_residuals(kinematics, group, directions, tolerance, DirectionChoice::All);
        if all.closed && all.moved <= CLOSING_MOTION_FACTOR * firm.residual {
            return Correction {
                moved: firm.moved + all.moved,
                path_motion: firm.path_motion + all.path_motion,
                ..all
            };
        }
        self.restore_group(kinematics, group, &before);
        firm
    }

    /// Gauss–Newton steps of least norm, with Levenberg–Marquardt if a step fails. Stops without further improvement.
    /// The Jacobian is reused after a step with such a large reduction that another equal reduction leaves only
    /// rounding.
    fn minimise_residuals(
        &self,
        kinematics: &mut Kinematics,
        group: &Group,
        directions: Directions,
        tolerance: f64,
        followed: DirectionChoice,
    ) -> Correction {
        let size = group.size;
        let (mut moved, mut along) = (0.0, 0.0);
        let mut damping = 0.0;
        let mut here = Linearised::at(self, kinematics, group);
        // `rows_are_here`: the rows of `here` belong to the current frames. `linear`: Jacobian and factors of the
        // last step.
        let mut rows_are_here = true;
        let mut linear: Option<(Jacobian, Option<NormalEquations>)> = None;
        let mut is_kept = false;
        let (mut next, mut before) = (Vec::with_capacity(group.rows), Vec::new());
        let affordable = CORRECTION_WORK / group.coordinates.len().pow(3).max(1);
        for _ in 0..affordable.clamp(FEWEST_CORRECTION_ITERATIONS, CORRECTION_ITERATIONS) {
            let cost = norm(&here.residuals);
            let worst = largest(&here.residuals).0;
            if cost == 0.0 || worst <= NEGLIGIBLE_GAP * tolerance {
                break;
            }
            let small = worst <= ROUNDING * size;
            let firm = small && followed == DirectionChoice::Firm;
            let floor = (tolerance / size).max(if firm { FIRM_DIRECTION * worst / size } else { 0.0 });
            let target: Vec<f64> = here.residuals.iter().map(|r| -r).collect();
            let (jacobian, equations) = linear.get_or_insert_with(|| {
                if !rows_are_here {
                    here.rows.fill(self, group, kinematics);
                    rows_are_here = true;
                }
                let jacobian = directions.jacobian(group, &here.rows);
                let equations = if damping > 0.0 { None } else { jacobian.normal_equations(floor) };
                (jacobian, equations)
            });
            let mut x = match equations {
                _ if damping > 0.0 => jacobian.damped(&target, damping),
                Some(equations) => equations.shortest(&target),
                None => jacobian.shortest_by_factors(&target, floor),
            };
            let mut length = norm(&x);
            if !(length > 0.0 && length.is_finite()) {
                break;
            }
            // Limit of the first-order model: a third of a radian, or of the gap. A damped step is preferred to a
            // shortened step of this length.
            let longest = 0.3 * size.max(worst) * (directions.count() as f64).sqrt();
            if length > longest && damping < 0.1 {
                damping = f64::max(10.0 * damping, FIRST_DAMPING);
                continue;
            }
            let part = (longest / length).min(1.0);
            x.iter_mut().for_each(|x| *x *= part);
            length *= part;
            self.group_positions_into(group, &kinematics.q, &mut before);
            self.advance_group(kinematics, group, &directions.expand(group, |k| x[k]));
            self.group_residuals_into(kinematics, group, &mut next);
            let left = norm(&next);
            let at_rounding = |residuals: &[f64]| largest(residuals).0 <= 0.01 * tolerance;
            if left < cost {
                let stalled = left > STALLED_REDUCTION * cost && (length < STALLED_STEP * size || firm)
                    || left > 0.3 * cost && at_rounding(&next);
                std::mem::swap(&mut here.residuals, &mut next);
                rows_are_here = false;
                moved += length;
                along += directions.path.map_or(0.0, |_| x[directions.unknown.len()]);
                if damping > 0.0 {
                    // If the actual reduction agrees with the predicted one, the damping is reduced.
                    let promised = norm_of_difference(&jacobian.times(&x), &target);
                    let kept = (cost * cost - left * left) / (cost * cost - promised * promised);
                    damping *= if kept > 0.75 {
                        0.1
                    } else if kept > 0.25 {
                        0.5
                    } else {
                        2.0
                    };
                    if damping < LEAST_DAMPING {
                        damping = 0.0;
                    }
                    linear = None;
                }
                is_kept = left * left <= KEPT_JACOBIAN * size * cost && matches!(linear, Some((_, Some(_))));
                if !is_kept {
                    linear = None;
                }
                if stalled {
                    break;
                }
            } else {
                self.restore_group(kinematics, group, &before);
                if at_rounding(&here.residuals) || length <= ROUNDING_STEP * size {
                    break;
                }
                if std::mem::take(&mut is_kept) {
                    linear = None;
                    continue;
                }
                if firm || damping > MOST_DAMPING {
                    break;
                }
                damping = if damping == 0.0 { FIRST_DAMPING } else { damping * 10.0 };
            }
        }
        if !rows_are_here {
            here.rows.fill(self, group, kinematics);
        }
        let (residual, worst) = largest(&here.residuals);
        Correction {
            residual,
            moved,
            path_motion: along,
            closed: residual <= tolerance,
            worst,
            linearised: here,
        }
    }
}

pub(super) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|r| r * r).sum::<f64>().sqrt()
}

fn norm_of_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
