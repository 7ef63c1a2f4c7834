//! At a change point branches cross, and (D) is a lower bound that none attains. The limits of m̄ along each.

use super::Group;
use super::closing::Moves;
use super::rank::{decide, singular_values};
use crate::kinematics::Kinematics;
use crate::least_energy::Minimum;
use crate::{Contact, EffectiveMass, Pose, System};
use faer::Mat;

/// How far from the crossing branches are looked for, as a part of the length.
const REACH: f64 = 4e-3;
/// How far apart are the places from which m̄ is carried on to the crossing.
const APART: f64 = 0.01;
/// Directions tried in the plane of admissible motions.
const DIRECTIONS: usize = 96;
/// Directions (up to sign) with a cosine above this are one branch.
const SAME: f64 = 0.995;

impl System {
    /// Limits of the answer along the branches that cross at a singular pose, each once; empty at a regular one.
    ///
    /// In the kernel of A at the crossing, directions are tried; those along which a closed pose lies near are branches,
    /// and m̄ at places on both sides is carried on to the crossing.
    pub fn branch_limits(&self, pose: &Pose, contact: &Contact) -> Vec<EffectiveMass> {
        let poser = self.unlocked.as_deref().unwrap_or(self);
        let Ok(assembly) = poser.assembly() else { return Vec::new() };
        let mut limits = Vec::new();
        for (group, facts) in poser.groups.iter().zip(&assembly.groups) {
            let (_, rows) = poser.group_rows(&pose.kinematics, group);
            let values = singular_values(&rows, &group.lengths);
            if decide(&values, poser.rank_floor()).rank < facts.rank.rank {
                limits.extend(self.limits_of(poser, pose, contact, group, facts.rank.rank));
            }
        }
        limits
    }

    fn limits_of(
        &self,
        poser: &System,
        pose: &Pose,
        contact: &Contact,
        group: &Group,
        generic_rank: usize,
    ) -> Vec<EffectiveMass> {
        let lengths = group.lengths.clone();
        let size = self.mechanism.characteristic_length();
        let kernel = kernel(poser, &pose.kinematics, group, &lengths);
        let mut found: Vec<Vec<f64>> = Vec::new();
        let mut limits = Vec::new();
        for k in 0..DIRECTIONS {
            let direction = direction(&kernel, k);
            let Some(near) = poser.on_branch(pose, group, &lengths, &direction, REACH * size) else {
                continue;
            };
            let along = unit(&near.1);
            if found.iter().any(|f| dot(f, &along).abs() > SAME) {
                continue;
            }
            // The plane may hold more motions than there are branches: a branch has the generic rank beside it.
            let (_, rows) = poser.group_rows(&near.0, group);
            if decide(&singular_values(&rows, &lengths), 1e-8).rank < generic_rank {
                continue;
            }
            found.push(along.clone());
            let at = |places: i32| {
                let reach = f64::from(places) * APART * size;
                let (kinematics, _) = poser.on_branch(pose, group, &lengths, &along, reach)?;
                let located = crate::contact::locate(self, &kinematics, &pose.base, contact).ok()?;
                Some(self.least_energy(&kinematics, &located).minimum)
            };
            limits.extend(carried_on(at));
        }
        limits
    }

    /// A closed pose at about this distance from the crossing, along a direction of the scaled coordinates, and how it
    /// lies from there.
    fn on_branch(
        &self,
        pose: &Pose,
        group: &Group,
        lengths: &[f64],
        direction: &[f64],
        reach: f64,
    ) -> Option<(Kinematics<f64>, Vec<f64>)> {
        let mut kinematics = pose.kinematics.clone();
        let u: Vec<f64> = direction.iter().zip(lengths).map(|(d, l)| reach * d / l).collect();
        self.advance_group(&mut kinematics, group, &u);
        let tolerance = self.closing_tolerance(&kinematics);
        let all = Moves { unknown: &group.movable, course: None };
        let correction = self.correct(&mut kinematics, group, all, tolerance);
        kinematics.refill(self);
        if !correction.closed || correction.moved > 0.9 * reach.abs() {
            return None;
        }
        let way = self.displacement(group, &pose.kinematics.q, &kinematics.q);
        let way: Vec<f64> = way.iter().zip(lengths).map(|(w, l)| w * l * reach.signum()).collect();
        let far = way.iter().map(|w| w * w).sum::<f64>().sqrt();
        (far > 0.3 * reach.abs()).then_some((kinematics, way))
    }
}

/// An orthonormal basis of the admissible motions in scaled coordinates.
fn kernel(system: &System, kinematics: &Kinematics<f64>, group: &Group, lengths: &[f64]) -> Vec<Vec<f64>> {
    let (_, rows) = system.group_rows(kinematics, group);
    let n = lengths.len();
    let rank = decide(&singular_values(&rows, lengths), system.rank_floor()).rank;
    let transposed = Mat::from_fn(n, rows.nrows(), |c, r| rows[(r, c)] / lengths[c]);
    if rank == 0 {
        return (0..n).map(|k| (0..n).map(|i| f64::from(u8::from(i == k))).collect()).collect();
    }
    let q = transposed.col_piv_qr().compute_Q();
    (rank..n).map(|k| (0..n).map(|i| q[(i, k)]).collect()).collect()
}

/// Direction number `k` in a kernel: evenly around in a plane, from a fixed low-discrepancy walk in more dimensions.
fn direction(kernel: &[Vec<f64>], k: usize) -> Vec<f64> {
    let n = kernel.first().map_or(0, Vec::len);
    let mut sum = vec![0.0; n];
    for (i, basis) in kernel.iter().enumerate() {
        let weight = if kernel.len() == 2 {
            (std::f64::consts::PI * (k as f64 + 0.5) / DIRECTIONS as f64
                - std::f64::consts::FRAC_PI_2 * i as f64)
                .cos()
        } else {
            let golden = 0.618_033_988_749_894_9 + 0.1 * i as f64;
            2.0 * ((k as f64 + 1.0) * golden).fract() - 1.0
        };
        sum.iter_mut().zip(basis).for_each(|(s, b)| *s += weight * b);
    }
    unit(&sum)
}

fn unit(v: &[f64]) -> Vec<f64> {
    let norm = dot(v, v).sqrt();
    v.iter().map(|x| x / norm).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The limit at the crossing from the values at one to four places on either side: Lagrange's formula, its weights at 0.
/// The eighth derivative remains, times η⁸/35.
fn carried_on(at: impl Fn(i32) -> Option<Minimum>) -> Option<EffectiveMass> {
    let mut sum = 0.0;
    for (places, weight) in [(1, 4.0 / 5.0), (2, -2.0 / 5.0), (3, 4.0 / 35.0), (4, -1.0 / 70.0)] {
        for side in [places, -places] {
            match at(side)? {
                Minimum::Finite(m) => sum += weight * m,
                Minimum::Immovable => return Some(EffectiveMass::Immovable),
                Minimum::Massless => return Some(EffectiveMass::Massless),
                Minimum::Stationary(_) => return None,
            }
        }
    }
    Some(EffectiveMass::Finite(sum))
}
