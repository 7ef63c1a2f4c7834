//! Greatest closing speed that the rate limits of the joints permit.

use crate::group_rows::GroupRows;
use crate::motion::driver_rates::{kernel, least_squares, lengths};
use crate::tolerances::{ACTIVE_RATE, CLOSES, MOST_VERTICES};
use faer::Mat;
use nalgebra::{DMatrix, DVector};
use percuss_dynamics::{LocatedContact, Pose};
use percuss_mechanism::JointId;

/// Greatest closing speed of the admissible motions within rate limits.
#[derive(Clone, Debug, PartialEq)]
pub struct ReachableSpeed {
    /// Closing speed, m/s (rad/s for a moment).
    pub speed: f64,
    /// Joints at their rate limits that determine the speed, in the order of the joints.
    pub limited_by: Vec<JointId>,
}

/// Greatest closing speed max j q̇ over the motions with A q̇ = 0 and |q̇_i| ≤ limit_i: a linear program. Without loops it is
/// Σ |j_i| limit_i.
///
/// The rate limits are those of the joints of the model ([`Joint::rate_limit`](percuss_mechanism::Joint::rate_limit)). `None` if no motion
/// closes the gap, if a motion without limited joints closes the gap, or if the search exceeds its largest number of vertices.
/// Method: active sets along the projected gradient (Rosen 1960).
pub fn reachable_closing_speed(pose: &Pose, contact: &LocatedContact) -> Option<ReachableSpeed> {
    let mechanism = pose.mechanism();
    let coordinates = pose.coordinate_joints();
    let lengths = lengths(pose, &coordinates);
    let groups: Vec<GroupRows> = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
    let basis = kernel(&groups, &lengths);
    let freedoms = basis.ncols();
    let rate = |coordinate: usize, k: usize| basis[(coordinate, k)] / lengths[coordinate];
    let row = pose.contact_row(contact);
    let gradient =
        DVector::from_fn(freedoms, |k, _| (0..row.len()).map(|c| row[c] * rate(c, k)).sum::<f64>());
    let size = (0..row.len()).map(|c| (row[c] / lengths[c]).powi(2)).sum::<f64>().sqrt();
    if gradient.norm() <= CLOSES * size {
        return None;
    }
    let mut limited: Vec<(JointId, DVector<f64>)> = Vec::new();
    for joint in mechanism.joint_ids() {
        let declared = mechanism.joint(joint);
        let Some(limit) = declared.rate_limit() else { continue };
        let (master, factor) =
            declared.mimic().map_or((joint, 1.0), |mimic| (mimic.master, mimic.multiplier));
        let Some(c) = coordinates.iter().position(|c| *c == (Some(master), 0)) else { continue };
        let of_joint = DVector::from_fn(freedoms, |k, _| factor * rate(c, k) / limit);
        if of_joint.norm() > 0.0 {
            limited.push((joint, of_joint));
        }
    }
    let rows: Vec<DVector<f64>> = limited.iter().map(|(_, row)| row.clone()).collect();
    let (speed, active) = greatest(&gradient, &rows)?;
    let mut limited_by: Vec<JointId> = active.into_iter().map(|i| limited[i].0).collect();
    limited_by.sort_unstable();
    Some(ReachableSpeed { speed, limited_by })
}

/// Largest c·y with |g_i·y| ≤ 1, and the active rows. `None` if c·y is unbounded, or after the largest number of vertices.
fn greatest(c: &DVector<f64>, rows: &[DVector<f64>]) -> Option<(f64, Vec<usize>)> {
    let mut y = DVector::zeros(c.len());
    let mut active: Vec<(usize, f64)> = Vec::new();
    for _ in 0..MOST_VERTICES {
        let matrix = DMatrix::from_fn(c.len(), active.len(), |k, a| active[a].1 * rows[active[a].0][k]);
        let columns = Mat::from_fn(matrix.nrows(), matrix.ncols(), |k, a| matrix[(k, a)]);
        let multipliers = DVector::from_vec(least_squares(&columns, c.as_slice()).weights);
        let along = c - &matrix * &multipliers;
        if along.norm() <= ACTIVE_RATE * c.norm() {
            // Optimal if no multiplier is negative; otherwise the first limit with a negative multiplier is released (Bland's rule).
            let floor = -ACTIVE_RATE * multipliers.amax();
            match (0..active.len()).filter(|a| multipliers[*a] < floor).min_by_key(|a| active[*a].0) {
                Some(released) => {
                    active.remove(released);
                    continue;
                }
                None => return Some((c.dot(&y), active.into_iter().map(|(row, _)| row).collect())),
            }
        }
        let step = |i: usize| {
            let change = rows[i].dot(&along);
            let sign = change.signum();
            let is_free = active.iter().all(|(row, _)| *row != i)
                && change.abs() > ACTIVE_RATE * rows[i].norm() * along.norm();
            is_free.then(|| (((1.0 - sign * rows[i].dot(&y)) / change.abs()).max(0.0), i, sign))
        };
        let (length, row, sign) = (0..rows.len()).filter_map(step).min_by(|a, b| a.0.total_cmp(&b.0))?;
        y += &along * length;
        active.push((row, sign));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For random polytopes, the search finds the largest value over all vertices.
    #[test]
    fn the_greatest_vertex_is_found() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
        };
        let mut compared = 0;
        for case in 0..300 {
            let (d, m) = (2 + case % 2, 4 + case % 4);
            let rows: Vec<DVector<f64>> = (0..m).map(|_| DVector::from_fn(d, |_, _| random())).collect();
            let c = DVector::from_fn(d, |_, _| random());
            let mut best = 0.0_f64;
            for mask in 0_u32..1 << m {
                let chosen: Vec<usize> = (0..m).filter(|i| mask & (1 << i) != 0).collect();
                if chosen.len() != d {
                    continue;
                }
                let matrix = DMatrix::from_fn(d, d, |r, k| rows[chosen[r]][k]);
                let Some(inverse) = matrix.try_inverse() else { continue };
                for signs in 0_u32..1 << d {
                    let sides = DVector::from_fn(d, |r, _| if signs & (1 << r) != 0 { 1.0 } else { -1.0 });
                    let y = &inverse * sides;
                    if rows.iter().all(|row| row.dot(&y).abs() <= 1.0 + 1e-9) {
                        best = best.max(c.dot(&y));
                    }
                }
            }
            let (found, active) = greatest(&c, &rows).expect("a bounded set");
            assert!((found / best - 1.0).abs() < 1e-9, "{case}: {found} {best}");
            assert_eq!(active.len(), d, "{case}");
            compared += 1;
        }
        assert_eq!(compared, 300);
        // One limit in the plane leaves the maximum unbounded.
        assert_eq!(greatest(&DVector::from_vec(vec![1.0, 0.5]), &[DVector::from_vec(vec![1.0, 0.0])]), None);
    }
}
