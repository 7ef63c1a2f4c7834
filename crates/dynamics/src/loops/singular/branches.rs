//! Surroundings of a pose at which a group of loops has less than its generic rank: crossing branches, or one regular
//! branch.

use crate::kinematics::frames::Kinematics;
use crate::linear::dense::dot;
use crate::linear::jacobian::Jacobian;
use crate::loops::closing::{Directions, Linearised};
use crate::mobility::{decide_rank, singular_values};
use crate::model::{Group, Model};
use crate::tolerances::{
    BRANCH_CORRECTIONS, BRANCH_DISTANCE, CONE_HALVINGS, DIRECTIONS_IN_A_PLANE, DIRECTIONS_WORK,
    DIRECTIONS_WORK_IN_ALL, FEWEST_DIRECTIONS, MOST_DIRECTIONS, NEAR_CROSSING_RANK_FLOOR, SAME_TANGENT,
    SAME_TANGENT_SPACE, TINY_STEP,
};
use faer::Mat;

/// A branch through a pose.
#[derive(Clone, Debug)]
pub(crate) struct Branch {
    /// Unit vector along the branch, over the group's scaled coordinates.
    pub along: Vec<f64>,
    /// Orthonormal basis of the branch's tangent space near the pose.
    tangents: Vec<Vec<f64>>,
}

/// Surroundings of a pose: the branches through the pose.
#[derive(Clone, Debug)]
pub(crate) struct Surroundings {
    /// The group.
    pub group: Group,
    /// Residual at which the group counts as closed, m.
    pub tolerance: f64,
    /// Threshold for singular values, relative to the largest; smaller values count as zero.
    floor: f64,
    /// Branches found.
    pub branches: Vec<Branch>,
    /// True if all nearby closed poses lie on one smooth branch, with the rank of the pose.
    pub regular: bool,
    /// True if the branches are samples of a continuum (a cone of directions).
    pub continuous: bool,
    /// True if the last directions tried gave no new branch.
    pub complete: bool,
}

impl Model {
    /// Finds the branches through a closed pose. Directions in the kernel of A are tried. Directions that reach a
    /// closed pose lead to branches, distinguished by their tangent spaces.
    pub fn surroundings(&self, kinematics: &Kinematics, group: &Group, inexactness: f64) -> Surroundings {
        let mut around = Surroundings {
            group: group.clone(),
            tolerance: self.rounded_tolerance(kinematics, group, inexactness),
            floor: group.floor_for(inexactness),
            branches: Vec::new(),
            regular: false,
            continuous: false,
            complete: true,
        };
        if factorisation_work(group) > DIRECTIONS_WORK_IN_ALL / 2 {
            around.complete = false;
            return around;
        }
        let tangents = tangent_space(self, kinematics, group, around.floor);
        self.find_branches(kinematics, &tangents, &mut around);
        if around.branches.len() > 2 {
            around.continuous = self.branches_form_continuum(kinematics, &around);
        }
        around
    }

    /// Finds the branches through a pose by trying directions in the kernel of A.
    fn find_branches(&self, kinematics: &Kinematics, kernel: &[Vec<f64>], around: &mut Surroundings) {
        let cube = factorisation_work(&around.group);
        let (mut newest, mut regular) = (0, None);
        for (tried, direction) in directions(kernel).enumerate() {
            if kernel.len() > 2 && tried >= FEWEST_DIRECTIONS.max(4 * newest).max(24 * around.branches.len())
            {
                return;
            }
            if tried > DIRECTIONS_WORK / around.group.coordinates.len().max(1).pow(3) && kernel.len() > 2 {
                break;
            }
            if tried > DIRECTIONS_WORK_IN_ALL / cube {
                around.complete = false;
                return;
            }
            let Some(branch) = self.branch_along(kinematics, around, &direction) else { continue };
            if branch.tangents.len() >= kernel.len() {
                // The nearby pose has as many motions as the pose. If this holds in all directions, no branches cross
                // here.
                let known = *regular.get_or_insert_with(|| {
                    (kernel.len() <= DIRECTIONS_WORK_IN_ALL / cube)
                        .then(|| kernel.iter().all(|e| self.has_branch_along(kinematics, around, e)))
                });
                let Some(known) = known else { break };
                around.regular = known;
                if known {
                    return;
                }
                continue;
            }
            let same = if branch.tangents.len() > 1 { SAME_TANGENT_SPACE } else { SAME_TANGENT };
            if around
                .branches
                .iter()
                .all(|known| subspace_angle_sine(&known.tangents, &branch.tangents) > same)
            {
                around.branches.push(branch);
                newest = tried;
            }
        }
        around.complete = kernel.len() <= 2;
    }

    /// True if a closed pose is found in the given unit direction, within about 8°.
    fn has_branch_along(&self, kinematics: &Kinematics, around: &Surroundings, direction: &[f64]) -> bool {
        self.branch_along(kinematics, around, direction)
            .is_some_and(|branch| dot(&branch.along, direction) > 0.99)
    }

    /// Branch reached in a direction, with its tangent space; `None` if no closed pose is reached.
    fn branch_along(
        &self,
        kinematics: &Kinematics,
        around: &Surroundings,
        direction: &[f64],
    ) -> Option<Branch> {
        // Branches of inexact loops are distinct only at some distance.
        let reach =
            around.group.size * BRANCH_DISTANCE.max(3.0 * (around.tolerance / around.group.size).sqrt());
        let mut beside = kinematics.clone();
        let displaced = self.close_at_distance(&mut beside, around, direction, reach)?;
        let tangents =
            tangent_space(self, &beside, &around.group, around.floor.max(NEAR_CROSSING_RANK_FLOOR));
        Some(Branch { along: unit(&displaced), tangents })
    }

    /// Moves a group to a closed pose at the given distance (m; negative: opposite direction) from its current pose,
    /// starting along a direction of its scaled coordinates. Returns the displacement; `None` if no branch is found.
    ///
    /// Corrections keep the distance. At a crossing the residuals are quadratic forms. If there are more residuals
    /// than degrees of freedom, an unconstrained Newton step leads back to the crossing itself, where all residuals
    /// vanish.
    pub fn close_at_distance(
        &self,
        kinematics: &mut Kinematics,
        around: &Surroundings,
        direction: &[f64],
        reach: f64,
    ) -> Option<Vec<f64>> {
        let group = &around.group;
        let (lengths, distance) = (&group.lengths, reach.abs());
        let before = kinematics.q.clone();
        let u: Vec<f64> = direction.iter().zip(lengths).map(|(d, l)| reach * d / l).collect();
        self.advance_group(kinematics, group, &u);
        let all = Directions::of(&group.movable);
        for _ in 0..BRANCH_CORRECTIONS {
            let here = Linearised::at(self, kinematics, group);
            let displaced = self.displacement(group, &before, &kinematics.q);
            let displaced: Vec<f64> = displaced.iter().zip(lengths).map(|(w, l)| w * l).collect();
            let gone = dot(&displaced, &displaced).sqrt();
            if !(0.1 * distance..10.0 * distance).contains(&gone) {
                return None;
            }
            let mut bordered: Jacobian = all.jacobian(group, &here.rows);
            let last = bordered.rows;
            bordered.rows += 1;
            bordered.entries.extend((0..all.count()).map(|k| (last, k, displaced[group.movable[k]] / gone)));
            let closing = here.residuals.iter().map(|r| -r);
            let target: Vec<f64> = closing.chain(std::iter::once(distance - gone)).collect();
            let x = bordered.shortest(&target, around.tolerance / group.size);
            let residuals = &here.residuals;
            let step = dot(&x, &x).sqrt();
            let there = step <= TINY_STEP * distance && residuals.iter().all(|r| r.abs() <= around.tolerance);
            let part = (0.5 * distance / step).min(1.0);
            self.advance_group(kinematics, group, &all.expand(group, |k| part * x[k]));
            if there {
                kinematics.refill(self);
                return Some(displaced.iter().map(|w| w * reach.signum()).collect());
            }
        }
        None
    }

    /// True if another branch lies between the two nearest branches, another one between that branch and the first,
    /// and so on. The branches are then samples of a cone.
    fn branches_form_continuum(&self, kinematics: &Kinematics, around: &Surroundings) -> bool {
        let branches = &around.branches;
        let pairs = (0..branches.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
        let cosine = |&(a, b): &(usize, usize)| dot(&branches[a].along, &branches[b].along);
        let Some((a, b)) = pairs.max_by(|p, q| cosine(p).abs().total_cmp(&cosine(q).abs())) else {
            return false;
        };
        let first = &branches[a];
        let between = |second: &Branch| {
            let sign = dot(&first.along, &second.along).signum();
            let middle: Vec<f64> = first.along.iter().zip(&second.along).map(|(x, y)| x + sign * y).collect();
            let found = self.branch_along(kinematics, around, &unit(&middle))?;
            let limit = 0.25 * subspace_angle_sine(&first.tangents, &second.tangents);
            let new = [first, second]
                .iter()
                .all(|known| subspace_angle_sine(&known.tangents, &found.tangents) > limit);
            new.then_some(found)
        };
        let mut second = between(&branches[b]);
        for _ in 1..CONE_HALVINGS {
            second = second.as_ref().and_then(&between);
        }
        second.is_some()
    }
}

/// Work of factorising a group's A, in multiplications: the cube of the number of coordinates, or more with more
/// rows.
fn factorisation_work(group: &Group) -> usize {
    let n = group.coordinates.len().max(1);
    n.saturating_mul(n).saturating_mul(n.max(group.rows))
}

/// Orthonormal basis of the admissible motions within a group, over its scaled coordinates.
fn tangent_space(model: &Model, kinematics: &Kinematics, group: &Group, floor: f64) -> Vec<Vec<f64>> {
    let rows = model.group_matrix(kinematics, group);
    let lengths = &group.lengths;
    let rank = decide_rank(&singular_values(&rows, &group.lengths), floor).rank;
    let n = group.movable.len();
    let transposed =
        Mat::from_fn(n, rows.nrows(), |k, r| rows[(r, group.movable[k])] / lengths[group.movable[k]]);
    let q = transposed.col_piv_qr().compute_Q();
    let mut basis = vec![vec![0.0; lengths.len()]; n.saturating_sub(rank)];
    for (k, vector) in basis.iter_mut().enumerate() {
        for (i, &at) in group.movable.iter().enumerate() {
            vector[at] = if rank == 0 { f64::from(u8::from(i == k)) } else { q[(i, rank + k)] };
        }
    }
    basis
}

/// Sine of the largest angle between two spaces, given by orthonormal bases; 1 for spaces of different dimension.
fn subspace_angle_sine(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    if a.len() != b.len() {
        return 1.0;
    }
    let outside = |v: &Vec<f64>| {
        let mut rest = v.clone();
        for e in a {
            let along = dot(e, v);
            rest.iter_mut().zip(e).for_each(|(r, e)| *r -= along * e);
        }
        dot(&rest, &rest).sqrt()
    };
    b.iter().map(outside).fold(0.0, f64::max)
}

/// Directions in a kernel: evenly distributed in a plane, from a fixed low-discrepancy sequence in more dimensions.
fn directions(kernel: &[Vec<f64>]) -> impl Iterator<Item = Vec<f64>> {
    let dimension = kernel.len();
    let n = kernel.first().map_or(0, Vec::len);
    // Kronecker sequence on the powers of the root of x^(d+1) = x + 1.
    let root = (0..50).fold(1.5_f64, |x, _| (1.0 + x).powf(1.0 / (dimension as f64 + 1.0)));
    let count = match dimension {
        0 => 0,
        1 => 1,
        2 => DIRECTIONS_IN_A_PLANE,
        _ => MOST_DIRECTIONS,
    };
    (0..count).map(move |k| {
        let mut sum = vec![0.0; n];
        for (i, basis) in kernel.iter().enumerate() {
            let weight = if dimension == 2 {
                let turn = std::f64::consts::PI * (k as f64 + 0.5) / count as f64;
                (turn - std::f64::consts::FRAC_PI_2 * i as f64).cos()
            } else {
                2.0 * ((k as f64 + 1.0) * root.powi(-(i as i32 + 1))).fract() - 1.0
            };
            sum.iter_mut().zip(basis).for_each(|(s, b)| *s += weight * b);
        }
        unit(&sum)
    })
}

fn unit(v: &[f64]) -> Vec<f64> {
    let norm = dot(v, v).sqrt();
    v.iter().map(|x| x / norm).collect()
}
