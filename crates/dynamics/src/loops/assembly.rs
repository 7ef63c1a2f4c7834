//! Putting the loops together: a first closed pose, a generic one, the rank there, and who drives whom.

use super::Group;
use super::closing::{Correction, Moves, shortest};
use super::rank::{FLOOR, Rank, decide, singular_values};
use super::roles::Roles;
use crate::System;
use crate::kinematics::Kinematics;
use faer::Mat;
use nalgebra::DMatrix;
use percuss_mechanism::ClosureKind;

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
    /// Who drives where nothing is set.
    pub roles: Roles,
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
    /// The drivers are wanted so far off that the branch cannot be followed there in one go.
    #[error(
        "{} is too far to follow the loops there in one go: they still closed at {}; whole turns can be left out if the \
         mechanism repeats after them, or give a starting pose there with --guess",
        places(wanted),
        places(reached)
    )]
    TooFar {
        /// Driving joints and where they are wanted.
        wanted: Vec<(String, f64)>,
        /// How far they came.
        reached: Vec<(String, f64)>,
    },
    /// A rod without a declared length whose ends coincide with all joints at 0: no direction to hold.
    #[error(
        "rod \"{name}\" has no distance, and its ends coincide with all joints at 0; give it a <distance>, or hold the points \
         together with a spherical loop"
    )]
    NoDistance {
        /// The closure.
        name: String,
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
        matches!(self, AssemblyError::Dependent { .. } | AssemblyError::NoDistance { .. })
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
/// Loops of a rounded file fit to within this many times their inexactness, which is measured at one pose, at others.
const ROUNDED: f64 = 10.0;
/// A step of Newton's method shorter than this part of the size changes nothing.
const SETTLED: f64 = 1e-8;
/// A pose nearer to the first one than this part of the size is that pose again.
const BACK: f64 = 1e-5;
/// Seeded starts that are tried before a group is given up.
const ATTEMPTS: u64 = 24;

impl System {
    /// Residual (m) at which a loop counts as closed: 1e-12 of the size, and rounding of far-off positions.
    pub(crate) fn closing_tolerance(&self, kinematics: &Kinematics<f64>) -> f64 {
        let far = kinematics.frames.iter().map(|x| x.translation.amax()).fold(0.0, f64::max);
        // Angles of many turns have fewer digits left within one.
        let turned = kinematics.q.iter().fold(0.0, |most: f64, q| most.max(q.abs()));
        let size = self.mechanism.characteristic_length();
        (1e-12 * size).max(16.0 * f64::EPSILON * far).max(4.0 * f64::EPSILON * turned * size)
    }

    /// The same for loops that are inexact by so much at the generic pose (m); they may be by some more at others.
    pub(crate) fn rounded_tolerance(&self, kinematics: &Kinematics<f64>, inexactness: f64) -> f64 {
        self.closing_tolerance(kinematics).max(ROUNDED * inexactness)
    }

    /// Singular values of A below this part of the largest count as zero, where the loops are inexact by so much (m).
    pub(crate) fn floor_for(&self, inexactness: f64) -> f64 {
        FLOOR.max(ROUNDED * inexactness / self.mechanism.characteristic_length())
    }

    /// Finds the first closed pose, starting at `start`, and what is generic about each group.
    pub(crate) fn assemble(&self, mut start: Kinematics<f64>) -> Result<Assembly, AssemblyError> {
        let shortest = 1e-12 * self.mechanism.characteristic_length();
        let rod = self.loops.iter().find(|l| l.kind == ClosureKind::Distance && l.distance <= shortest);
        if let Some(rod) = rod {
            return Err(AssemblyError::NoDistance { name: rod.name.clone() });
        }
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
        let all = &group.movable;
        let advised: Vec<usize> =
            all.iter().copied().filter(|&at| self.advice(group, at) != Some(true)).collect();
        let mut best: Option<(Vec<f64>, Correction)> = None;
        let start = kinematics.q.clone();
        for attempt in 0..ATTEMPTS {
            kinematics.q.copy_from_slice(&start);
            kinematics.refill(self);
            if attempt > 1 {
                // A start that is stuck (Aᵀr = 0 with r ≠ 0) is left by a fixed step aside, then a longer one.
                let size = [0.01, 0.1, 0.3, 1.0, 3.0, 2.0][(attempt as usize / 2 - 1) % 6];
                self.perturb(kinematics, group, size, attempt);
            }
            let unknown = if attempt == 0 { &advised } else { all };
            let correction = self.correct(kinematics, group, Moves { unknown, course: None }, tolerance);
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
        let all = Moves { unknown: &group.movable, course: None };
        let rank_of = |kinematics: &Kinematics<f64>, inexactness: f64| {
            let (_, rows) = self.group_rows(kinematics, group);
            let floor = self.floor_for(inexactness);
            let values = singular_values(&rows, &group.lengths);
            let rank = decide(&values, floor);
            let least = rank.rank.checked_sub(1).map_or(1.0, |last| values[last] / values[0]);
            (rank, least, rows)
        };
        let (at_home, _, home_rows) = rank_of(home, inexactness);
        // Any other pose is better, since much vanishes where all joints are at 0; of those the best-conditioned.
        let mut best = (home.q.clone(), home_rows, at_home, 0.0);
        let mut consider = |kinematics: Kinematics<f64>, inexactness: f64| {
            let (rank, least, rows) = rank_of(&kinematics, inexactness);
            if rank.rank > best.2.rank || (rank.rank == best.2.rank && least > best.3) {
                best = (kinematics.q, rows, rank, least);
            }
        };
        let (mut found, mut unsettled) = (0, None);
        for attempt in 0..12u64 {
            let mut kinematics = home.clone();
            self.perturb(&mut kinematics, group, [0.2, 0.1, 0.03][attempt as usize / 4], 1000 + attempt);
            let correction = self.correct(&mut kinematics, group, all, tolerance);
            let rounding = if inexactness > 0.0 { (2.0 * inexactness).max(1e-4 * length) } else { 0.0 };
            if correction.residual > tolerance.max(rounding) {
                continue;
            }
            let way = self.displacement(group, &home.q, &kinematics.q);
            let gone = way.iter().zip(&group.lengths).map(|(w, l)| (w * l).powi(2)).sum::<f64>().sqrt();
            if gone < BACK * length || !self.is_settled(&kinematics, group) {
                unsettled.get_or_insert(kinematics);
                continue;
            }
            if inexactness > 0.0 {
                inexactness = inexactness.max(correction.residual);
            }
            consider(kinematics, inexactness);
            found += 1;
            if found == 3 {
                break;
            }
        }
        if found == 0 {
            // All ways led back to where branches cross: along one of them, then.
            let around = self.surroundings(home, group, inexactness);
            for branch in &around.branches {
                for reach in [0.1, 0.03, 0.01, 1e-3] {
                    let mut kinematics = home.clone();
                    if self.go_beside(&mut kinematics, &around, &branch.along, reach * around.size).is_some()
                    {
                        consider(kinematics, inexactness);
                        break;
                    }
                }
            }
            // No way leads off: what binds beside the pose counts, though nothing closes there.
            if let Some(kinematics) = unsettled.filter(|_| around.branches.is_empty() && !around.regular) {
                consider(kinematics, inexactness);
            }
        }
        let (generic, rows, rank, _) = best;
        let roles = self.advised_roles(group, &rows, self.floor_for(inexactness));
        GroupFacts { generic, rows, rank, inexactness, home_is_regular: at_home.rank == rank.rank, roles }
    }

    /// Whether a closed pose is where Newton's method would stay: near a crossing, residuals are squares of what is
    /// still to go, and pass for closed long before it is gone.
    fn is_settled(&self, kinematics: &Kinematics<f64>, group: &Group) -> bool {
        let (residuals, rows) = self.group_rows(kinematics, group);
        let jacobian = Moves { unknown: &group.movable, course: None }.jacobian(group, &rows);
        let target = Mat::from_fn(residuals.len(), 1, |r, _| -residuals[r]);
        shortest(&jacobian, &target, 0.0).norm_l2() <= SETTLED * self.mechanism.characteristic_length()
    }

    pub(crate) fn group_names(&self, group: &Group) -> Vec<String> {
        let loops = group.loops.iter().map(|&l| self.loops[l].name.clone());
        loops.chain(group.gears.iter().map(|&g| self.gears[g].name.clone())).collect()
    }

    /// Moves a group's coordinates aside by fixed pseudo-random amounts up to `size` (rad, or times the length).
    pub(crate) fn perturb(&self, kinematics: &mut Kinematics<f64>, group: &Group, size: f64, seed: u64) {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mut u = vec![0.0; group.coordinates.len()];
        for at in 0..u.len() {
            // splitmix64
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            z ^= z >> 31;
            let unit = (z >> 11) as f64 / (1u64 << 53) as f64;
            u[at] = size * (2.0 * unit - 1.0) * self.mechanism.characteristic_length() / group.lengths[at];
        }
        self.advance_group(kinematics, group, &u);
    }
}
