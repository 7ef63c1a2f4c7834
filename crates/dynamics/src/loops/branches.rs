//! At a change point branches cross, and (D) is a lower bound that none attains. The limits of m̄ along each.

use super::Group;
use super::closing::{Moves, shortest};
use super::rank::{decide, singular_values};
use crate::kinematics::Kinematics;
use crate::least_energy::Minimum;
use crate::{Contact, EffectiveMass, Pose, System};
use faer::Mat;

/// How far from the crossing branches are looked for, as a part of the length.
const REACH: f64 = 4e-3;
/// How far apart are the places from which m̄ is carried on to the crossing.
const APART: f64 = 0.01;
/// Directions tried where two motions are admissible, and where there are more.
const IN_A_PLANE: usize = 96;
const IN_MORE: usize = 256;
/// Most corrections on the way to a branch.
const CORRECTIONS: usize = 30;
/// Projections of two tangent spaces that differ by less than this belong to one branch.
const SAME: f64 = 0.1;
/// Most combinations of branches of several groups that are looked at.
const COMBINATIONS: usize = 64;
/// A limit below this part of the values it is carried on from is zero.
const VANISHING: f64 = 1e-8;

/// A group of loops at a crossing, with a direction (unit, scaled coordinates) along each of its branches.
struct Crossing<'a> {
    group: &'a Group,
    tolerance: f64,
    branches: Vec<Vec<f64>>,
}

impl System {
    /// Limits of the answer along the branches that cross at a singular pose, one for each branch, and for each
    /// combination of branches where several groups stand at crossings of their own; empty at a regular pose.
    ///
    /// In the kernel of A at the crossing, directions are tried; those along which a closed pose lies near are branches,
    /// told apart by their tangent spaces, and 1/m̄ at places on both sides is carried on to the crossing.
    pub fn branch_limits(&self, pose: &Pose, contact: &Contact) -> Vec<EffectiveMass> {
        let poser = self.unlocked.as_deref().unwrap_or(self);
        let crossings = poser.crossings(pose);
        let combinations: usize =
            crossings.iter().try_fold(1, |n: usize, c| n.checked_mul(c.branches.len())).unwrap_or(usize::MAX);
        if crossings.is_empty() {
            return Vec::new();
        }
        let limit = |number: usize| {
            self.carried_on(&|places| {
                let mut kinematics = pose.kinematics.clone();
                let mut number = number;
                for crossing in &crossings {
                    let along = &crossing.branches[number % crossing.branches.len()];
                    number /= crossing.branches.len();
                    let reach = f64::from(places) * APART * self.mechanism.characteristic_length();
                    poser.go_along(&mut kinematics, crossing.group, crossing.tolerance, along, reach)?;
                }
                let located = crate::contact::locate(self, &kinematics, &pose.base, contact).ok()?;
                Some(self.least_energy(&kinematics, &located).minimum)
            })
        };
        (0..combinations.min(COMBINATIONS)).filter_map(limit).collect()
    }

    /// The groups that have less than their generic rank at a pose, and the branches that cross there.
    fn crossings(&self, pose: &Pose) -> Vec<Crossing<'_>> {
        let Ok(assembly) = self.assembly() else { return Vec::new() };
        let mut crossings = Vec::new();
        for (group, facts) in self.groups.iter().zip(&assembly.groups) {
            let (_, rows) = self.group_rows(&pose.kinematics, group);
            let generic = facts.rank.rank;
            if decide(&singular_values(&rows, &group.lengths), self.rank_floor()).rank >= generic {
                continue;
            }
            let tolerance =
                self.closing_tolerance(&pose.kinematics).max(super::closer::ROUNDED * facts.inexactness);
            let mut crossing = Crossing { group, tolerance, branches: Vec::new() };
            self.find_branches(pose, &mut crossing, generic);
            if !crossing.branches.is_empty() {
                crossings.push(crossing);
            }
        }
        crossings
    }

    fn find_branches(&self, pose: &Pose, crossing: &mut Crossing, generic_rank: usize) {
        let group = crossing.group;
        let reach = REACH * self.mechanism.characteristic_length();
        let floor = self.rank_floor().max(1e-8);
        let (kernel, _) = kernel(self, &pose.kinematics, group, self.rank_floor());
        let mut spaces: Vec<Vec<Vec<f64>>> = Vec::new();
        for direction in directions(&kernel) {
            let mut kinematics = pose.kinematics.clone();
            let Some(way) = self.go_along(&mut kinematics, group, crossing.tolerance, &direction, reach)
            else {
                continue;
            };
            // The plane may hold more motions than there are branches: a branch has the generic rank beside it.
            let (tangents, rank) = self::kernel(self, &kinematics, group, floor);
            if rank < generic_rank || spaces.iter().any(|known| apart(known, &tangents) < SAME) {
                continue;
            }
            spaces.push(tangents);
            crossing.branches.push(unit(&way));
        }
    }

    /// Moves a group to a closed pose at about this distance from where it stands, along a direction of its scaled
    /// coordinates, and says how it lies from there; none where no branch leads that way.
    ///
    /// Corrections go across the direction only: at a crossing the residuals are quadratic forms, and where these are
    /// more than the freedoms, Newton's free step leads straight back to where all of them vanish.
    fn go_along(
        &self,
        kinematics: &mut Kinematics<f64>,
        group: &Group,
        tolerance: f64,
        direction: &[f64],
        reach: f64,
    ) -> Option<Vec<f64>> {
        let lengths = &group.lengths;
        let before = kinematics.q.clone();
        let u: Vec<f64> = direction.iter().zip(lengths).map(|(d, l)| reach * d / l).collect();
        self.advance_group(kinematics, group, &u);
        let all = Moves { unknown: &group.movable, course: None };
        let mut moved = 0.0;
        let mut closed = false;
        for _ in 0..CORRECTIONS {
            let (residuals, rows) = self.group_rows(kinematics, group);
            let jacobian = all.jacobian(group, &rows);
            let m = residuals.len();
            closed = residuals.iter().all(|r| r.abs() <= tolerance);
            let bordered = Mat::from_fn(m + 1, all.count(), |r, k| {
                if r < m { jacobian[(r, k)] } else { direction[group.movable[k]] }
            });
            let target = Mat::from_fn(m + 1, 1, |r, _| if r < m { -residuals[r] } else { 0.0 });
            let x = shortest(&bordered, &target);
            let step = x.norm_l2();
            // At rounding, or no longer beside the direction.
            if closed && step <= 1e-9 * reach.abs() {
                break;
            }
            moved += step;
            if moved.is_nan() || moved > 0.9 * reach.abs() {
                return None;
            }
            self.advance_group(kinematics, group, &all.expand(group, |k| x[(k, 0)]));
        }
        kinematics.refill(self);
        let way = self.displacement(group, &before, &kinematics.q);
        closed.then(|| way.iter().zip(lengths).map(|(w, l)| w * l * reach.signum()).collect())
    }

    /// The limit at the crossing from the values at one to four places on either side: Lagrange's formula for 1/m̄, its
    /// weights at 0. The eighth derivative remains, times η⁸/35.
    fn carried_on(&self, at: &dyn Fn(i32) -> Option<Minimum>) -> Option<EffectiveMass> {
        let (mut mobility, mut most_mobile) = (0.0, 0.0_f64);
        let (mut mass, mut heaviest) = (0.0, 0.0_f64);
        for (places, weight) in [(1, 4.0 / 5.0), (2, -2.0 / 5.0), (3, 4.0 / 35.0), (4, -1.0 / 70.0)] {
            for side in [places, -places] {
                let m = match at(side)? {
                    Minimum::Finite(m) => m,
                    Minimum::Immovable => return Some(EffectiveMass::Immovable),
                    Minimum::Massless => return Some(EffectiveMass::Massless),
                    Minimum::Stationary(_) => return None,
                };
                mobility += weight / m;
                mass += weight * m;
                most_mobile = most_mobile.max(1.0 / m);
                heaviest = heaviest.max(m);
            }
        }
        Some(if mobility <= VANISHING * most_mobile {
            EffectiveMass::Immovable
        } else if mass <= VANISHING * heaviest {
            EffectiveMass::Massless
        } else {
            EffectiveMass::Finite(1.0 / mobility)
        })
    }
}

/// An orthonormal basis of the admissible motions within a group, over its scaled coordinates, and the rank of A.
fn kernel(
    system: &System,
    kinematics: &Kinematics<f64>,
    group: &Group,
    floor: f64,
) -> (Vec<Vec<f64>>, usize) {
    let (_, rows) = system.group_rows(kinematics, group);
    let rank = decide(&singular_values(&rows, &group.lengths), floor).rank;
    let jacobian = Moves { unknown: &group.movable, course: None }.jacobian(group, &rows);
    let n = jacobian.ncols();
    let q = jacobian.transpose().col_piv_qr().compute_Q();
    let mut basis = vec![vec![0.0; group.lengths.len()]; n.saturating_sub(rank)];
    for (k, vector) in basis.iter_mut().enumerate() {
        for (i, &at) in group.movable.iter().enumerate() {
            vector[at] = if rank == 0 { f64::from(u8::from(i == k)) } else { q[(i, rank + k)] };
        }
    }
    (basis, rank)
}

/// Sine of the largest angle between two spaces, given by orthonormal bases of the same number.
fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let outside = |v: &Vec<f64>| {
        let inside: f64 = a.iter().map(|e| dot(e, v).powi(2)).sum();
        (1.0 - inside).max(0.0).sqrt()
    };
    b.iter().map(outside).fold(0.0, f64::max)
}

/// Directions in a kernel: evenly around in a plane, from a fixed low-discrepancy walk in more dimensions.
fn directions(kernel: &[Vec<f64>]) -> impl Iterator<Item = Vec<f64>> {
    let dimension = kernel.len();
    let n = kernel.first().map_or(0, Vec::len);
    // Kronecker's sequence on the powers of the root of x^(d+1) = x + 1.
    let root = (0..50).fold(1.5_f64, |x, _| (1.0 + x).powf(1.0 / (dimension as f64 + 1.0)));
    let count = if dimension == 2 { IN_A_PLANE } else { IN_MORE };
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

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
