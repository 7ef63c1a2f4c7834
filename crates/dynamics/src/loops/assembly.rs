//! Putting the loops together: a first closed pose, a generic one, the rank there, and who drives whom.

use super::rank::{FLOOR, Rank, decide, singular_values};
use super::{Group, closing::Correction};
use crate::System;
use crate::kinematics::Kinematics;
use nalgebra::DMatrix;
use percuss_mechanism::JointId;

/// What was found once about the loops of a system.
#[derive(Clone, Debug)]
pub(crate) struct Assembly {
    /// Positions of a closed pose, as near to all joints at zero as was found.
    pub home: Vec<f64>,
    pub groups: Vec<GroupFacts>,
}

/// What was found about one group.
#[derive(Clone, Debug)]
pub(crate) struct GroupFacts {
    /// Positions of a closed pose off any singularity.
    pub generic: Vec<f64>,
    /// A there, over the group's coordinates.
    pub rows: DMatrix<f64>,
    pub rank: Rank,
    /// How far the loops are from fitting, m, where they do not quite; else 0.
    pub inexactness: f64,
    /// Whether the first closed pose has the generic rank.
    pub home_is_regular: bool,
}

/// Loops that do not go together.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// No closed pose was found at all.
    #[error(
        "the loops do not close: {} is {residual:.3e} m apart at best (a thousandth of the size, {allowed:.1e} m, \
         would pass as rounding); check its frames and axes, or give a starting pose with --guess JOINT=VALUE",
        quoted(loops)
    )]
    DoesNotClose {
        /// The loops and couplings of the group, the worst first.
        loops: Vec<String>,
        /// Largest residual of the best pose, m.
        residual: f64,
        /// What would pass, m.
        allowed: f64,
    },
    /// The drivers cannot be brought where they are wanted.
    #[error(
        "{} cannot be reached: {} would not close; nearest reached: {}",
        places(wanted),
        quoted(loops),
        places(nearest)
    )]
    Unreachable {
        /// Driving joints and where they are wanted.
        wanted: Vec<(String, f64)>,
        /// Where they came to on the same branch.
        nearest: Vec<(String, f64)>,
        /// The loops of the group.
        loops: Vec<String>,
    },
    /// A joint was set that follows others.
    #[error(
        "joint \"{joint}\" follows from the loops; set {} instead, or start from another assembly with --guess",
        quoted(drivers)
    )]
    Dependent {
        /// The joint.
        joint: String,
        /// The joints that drive its group.
        drivers: Vec<String>,
    },
}

impl AssemblyError {
    /// Whether the input is at fault (and not merely the place asked for).
    pub fn is_bad_input(&self) -> bool {
        matches!(self, AssemblyError::Dependent { .. })
    }
}

fn quoted(names: &[String]) -> String {
    if names.is_empty() {
        return "nothing".into();
    }
    names.iter().take(6).map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ")
}

fn places(places: &[(String, f64)]) -> String {
    places.iter().take(6).map(|(n, v)| format!("{n} = {v:.12}")).collect::<Vec<_>>().join(", ")
}

/// Residuals below this part of the size pass as a file's rounding.
pub(crate) const ROUNDING: f64 = 1e-3;
/// Seeded starts that are tried before a group is given up.
const ATTEMPTS: u64 = 24;

impl System {
    /// Residual (m) at which a loop counts as closed: 1e-12 of the size, and rounding of far-off positions.
    pub(crate) fn closing_tolerance(&self, kinematics: &Kinematics<f64>) -> f64 {
        let far = kinematics.frames.iter().map(|x| x.translation.amax()).fold(0.0, f64::max);
        (1e-12 * self.mechanism.characteristic_length()).max(16.0 * f64::EPSILON * far)
    }

    /// Finds the first closed pose, starting at `start`, and what is generic about each group.
    pub(crate) fn assemble(&self, mut start: Kinematics<f64>) -> Result<Assembly, AssemblyError> {
        let mut inexact = Vec::with_capacity(self.groups.len());
        for group in &self.groups {
            inexact.push(self.close_first(&mut start, group)?);
        }
        let mut groups = Vec::with_capacity(self.groups.len());
        for (group, inexactness) in self.groups.iter().zip(inexact) {
            groups.push(self.look_around(&start, group, inexactness));
        }
        Ok(Assembly { home: start.q, groups })
    }

    /// Closes a group near where it stands. Returns its inexactness.
    fn close_first(&self, kinematics: &mut Kinematics<f64>, group: &Group) -> Result<f64, AssemblyError> {
        let tolerance = self.closing_tolerance(kinematics);
        let all: Vec<usize> = (0..group.coordinates.len()).collect();
        let advised: Vec<usize> =
            all.iter().copied().filter(|&at| !self.is_advised_to_drive(group.coordinates[at])).collect();
        let mut best: Option<(Vec<f64>, Correction)> = None;
        let start = kinematics.q.clone();
        for attempt in 0..ATTEMPTS {
            kinematics.q.copy_from_slice(&start);
            kinematics.refill(self);
            if attempt > 1 {
                // A start that is stuck (Aᵀr = 0 with r ≠ 0) is left by a fixed step aside, then a longer one.
                let size = [0.01, 0.1, 0.3, 1.0][(attempt as usize / 2 - 1) % 4];
                self.perturb(kinematics, group, size, attempt);
            }
            let unknown = if attempt == 0 { &advised } else { &all };
            let correction = self.correct(kinematics, group, unknown, tolerance);
            if correction.closed {
                return Ok(0.0);
            }
            if best.as_ref().is_none_or(|(_, b)| correction.residual < b.residual) {
                best = Some((kinematics.q.clone(), correction));
            }
        }
        let allowed = ROUNDING * self.mechanism.characteristic_length();
        let Some((q, correction)) = best else { return Ok(0.0) };
        kinematics.q = q;
        kinematics.refill(self);
        if correction.residual <= allowed {
            return Ok(correction.residual);
        }
        let mut loops = self.group_names(group);
        if let Some(worst) = loops.iter().position(|n| n == group.row_name(self, correction.worst)) {
            loops.swap(0, worst);
        }
        Err(AssemblyError::DoesNotClose { loops, residual: correction.residual, allowed })
    }

    /// Looks for the generic rank of a group at closed poses around the first one.
    fn look_around(&self, home: &Kinematics<f64>, group: &Group, mut inexactness: f64) -> GroupFacts {
        let length = self.mechanism.characteristic_length();
        let tolerance = self.closing_tolerance(home);
        let lengths: Vec<f64> = self.lengths_of(group);
        let all: Vec<usize> = (0..group.coordinates.len()).collect();
        let rank_of = |kinematics: &Kinematics<f64>, inexactness: f64| {
            let (_, rows) = self.group_rows(kinematics, group);
            let floor = FLOOR.max(10.0 * inexactness / length);
            (decide(&singular_values(&rows, &lengths), floor), rows)
        };
        let (at_home, home_rows) = rank_of(home, inexactness);
        let mut best = (home.q.clone(), home_rows, at_home);
        let mut found = 0;
        for attempt in 0..12u64 {
            let mut kinematics = home.clone();
            self.perturb(&mut kinematics, group, [0.2, 0.1, 0.03][attempt as usize / 4], 1000 + attempt);
            let correction = self.correct(&mut kinematics, group, &all, tolerance);
            if correction.residual
                > tolerance.max(2.0 * inexactness).max(if inexactness > 0.0 { 1e-4 * length } else { 0.0 })
            {
                continue;
            }
            if inexactness > 0.0 {
                inexactness = correction.residual.max(inexactness.min(correction.residual));
            }
            let (rank, rows) = rank_of(&kinematics, inexactness);
            if rank.rank > best.2.rank || (rank.rank == best.2.rank && rank.gap > best.2.gap) {
                best = (kinematics.q, rows, rank);
            }
            found += 1;
            if found == 3 {
                break;
            }
        }
        let (generic, rows, rank) = best;
        GroupFacts { generic, rows, rank, inexactness, home_is_regular: at_home.rank == rank.rank }
    }

    pub(crate) fn lengths_of(&self, group: &Group) -> Vec<f64> {
        let lengths = self.coordinate_lengths();
        group.coordinates.iter().map(|&c| lengths[c]).collect()
    }

    pub(crate) fn group_names(&self, group: &Group) -> Vec<String> {
        let loops = group.loops.iter().map(|&l| self.loops[l].name.clone());
        loops.chain(group.gears.iter().map(|&g| self.gears[g].name.clone())).collect()
    }

    /// The joint that a coordinate is a velocity of; none for the floating base.
    pub(crate) fn joint_of_coordinate(&self, coordinate: usize) -> Option<JointId> {
        self.bodies.iter().find_map(|body| {
            let id = body.joint.filter(|id| self.mechanism.joint(*id).mimic().is_none())?;
            let own = body.v.clone().any(|v| self.follows[v].is_some_and(|f| f.index == coordinate));
            own.then_some(id)
        })
    }

    fn is_advised_to_drive(&self, coordinate: usize) -> bool {
        self.joint_of_coordinate(coordinate)
            .is_some_and(|id| self.mechanism.joint(id).independent() == Some(true))
    }

    /// Moves a group's coordinates aside by fixed pseudo-random amounts up to `size` (rad, or times the length).
    pub(crate) fn perturb(&self, kinematics: &mut Kinematics<f64>, group: &Group, size: f64, seed: u64) {
        let lengths = self.coordinate_lengths();
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mut u = vec![0.0; self.coordinates];
        for &c in &group.coordinates {
            // splitmix64
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            z ^= z >> 31;
            let unit = (z >> 11) as f64 / (1u64 << 53) as f64;
            u[c] = size * (2.0 * unit - 1.0) * self.mechanism.characteristic_length() / lengths[c];
        }
        self.advance(kinematics, &u);
    }

    /// Splits a group's coordinates (by index into it) into those that follow and those that drive. `wish` says how
    /// much each wants to drive; among equals the best-conditioned choice follows.
    pub(crate) fn followers(&self, group: &Group, facts: &GroupFacts, wish: &[u8]) -> Vec<usize> {
        let lengths = self.lengths_of(group);
        let mut columns: Vec<Vec<f64>> = (0..lengths.len())
            .map(|c| facts.rows.column(c).iter().map(|x| x / lengths[c]).collect())
            .collect();
        let size = |c: &Vec<f64>| c.iter().map(|x| x * x).sum::<f64>().sqrt();
        let largest = columns.iter().map(size).fold(0.0, f64::max);
        let mut following = Vec::with_capacity(facts.rank.rank);
        // A second, laxer pass takes what the first found too nearly dependent.
        for threshold in [1e-6, 1e-12_f64] {
            for class in 0..=u8::MAX {
                if class > wish.iter().copied().max().unwrap_or(0) {
                    break;
                }
                loop {
                    let open = (0..columns.len()).filter(|c| wish[*c] == class && !following.contains(c));
                    let best = open.max_by(|&a, &b| size(&columns[a]).total_cmp(&size(&columns[b])));
                    let Some(best) = best.filter(|&c| {
                        following.len() < facts.rank.rank && size(&columns[c]) > threshold * largest
                    }) else {
                        break;
                    };
                    let norm = size(&columns[best]);
                    let unit: Vec<f64> = columns[best].iter().map(|x| x / norm).collect();
                    following.push(best);
                    for (c, column) in columns.iter_mut().enumerate() {
                        if !following.contains(&c) {
                            let along: f64 = column.iter().zip(&unit).map(|(a, b)| a * b).sum();
                            column.iter_mut().zip(&unit).for_each(|(a, b)| *a -= along * b);
                        }
                    }
                }
            }
        }
        following.sort_unstable();
        following
    }
}
