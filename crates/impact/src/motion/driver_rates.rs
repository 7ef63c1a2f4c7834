//! Rates of all joints from the rates of the drivers.

use crate::group_rows::GroupRows;
use crate::motion::joint_rates::JointRates;
use crate::tolerances::{DETERMINED, INADMISSIBLE, OPEN_PER_FLOOR};
use faer::Mat;
use percuss_dynamics::Pose;
use percuss_mechanism::{JointId, JointKind};
use percuss_spatial::Twist;

/// Rates of one driving joint before the impact.
#[derive(Clone, Debug, PartialEq)]
pub struct DriverRate {
    /// The joint.
    pub joint: JointId,
    /// Velocities of the joint (layouts of [`JointKind`]), rad/s and m/s.
    pub rates: Vec<f64>,
}

/// Error of given rates.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RatesError {
    /// A joint has another number of velocities.
    #[error("joint \"{joint}\": {got} rates are given; expected {expected}")]
    Count {
        /// The joint.
        joint: String,
        /// Number of given rates.
        got: usize,
        /// Number of velocities of the joint.
        expected: usize,
    },
    /// A rate is not a finite number.
    #[error("joint \"{joint}\": the rate {rate} is not a finite number")]
    NotFinite {
        /// The joint.
        joint: String,
        /// The rate.
        rate: f64,
    },
    /// A joint is given twice.
    #[error("joint \"{joint}\": rates are given twice")]
    Twice {
        /// The joint.
        joint: String,
    },
    /// The given joints do not determine the rates of all others.
    #[error(
        "the given rates leave {open} of {freedoms} degrees of freedom open; give also the rates of {open} of: {}",
        joints.join(", ")
    )]
    Undetermined {
        /// Degrees of freedom without a rate.
        open: usize,
        /// Degrees of freedom of the mechanism.
        freedoms: usize,
        /// Joints whose rates are not determined.
        joints: Vec<String>,
    },
    /// The constraints do not allow the given rates together.
    #[error(
        "joint \"{joint}\": the constraints do not allow the rate {given} together with the other given rates: the nearest \
         admissible motion has {admissible} (residual {residual:.1e} of the largest rate)"
    )]
    Inadmissible {
        /// Joint with the largest residual.
        joint: String,
        /// Given rate, rad/s or m/s.
        given: f64,
        /// Rate of the nearest admissible motion, rad/s or m/s.
        admissible: f64,
        /// Difference of both, relative to the largest given rate.
        residual: f64,
    },
}

/// Row of a given rate over the coordinates: entry and coordinate; no entry for a locked joint.
struct GivenRow {
    joint: JointId,
    entry: Option<(usize, f64)>,
    rate: f64,
    /// Displacement, m, of a point at the characteristic length at unit rate.
    length: f64,
}

/// Rates of all joints from the rates of some joints, such that all constraints hold: A u = 0 with the given rates.
///
/// The root link of a floating base has the twist `base` (root axes, root origin). More rates than degrees of freedom
/// are accepted if they agree.
///
/// # Errors
/// [`RatesError`]: rates that do not fit their joint, too few rates, rates that the constraints do not allow.
pub fn rates_from_drivers(
    pose: &Pose,
    drivers: &[DriverRate],
    base: Twist<f64>,
) -> Result<JointRates, RatesError> {
    let coordinates = pose.coordinate_joints();
    let n = coordinates.len();
    let rows = given_rows(pose, drivers, &coordinates)?;
    let lengths = lengths(pose, &coordinates);
    let groups: Vec<GroupRows> = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
    if groups.is_empty()
        && let Some(u) = rates_without_constraints(&rows, &coordinates, &base)
    {
        let (joints, base) = pose.joint_velocities(&u);
        return Ok(JointRates { joints, base });
    }
    let kernel = kernel(&groups, &lengths);
    let freedoms = kernel.ncols();
    // Rows of the base, then those of the joints; all in displacements of the characteristic length.
    let of_base: Vec<f64> = base.angular.iter().chain(base.linear.iter()).copied().collect();
    let base_rows = coordinates.iter().enumerate().filter(|(_, (joint, _))| joint.is_none());
    let mut entries: Vec<Option<(usize, f64)>> = Vec::new();
    let mut wanted: Vec<f64> = Vec::new();
    for (c, &(_, k)) in base_rows {
        entries.push(Some((c, 1.0 / lengths[c])));
        wanted.push(of_base[k] * lengths[c]);
    }
    let first = entries.len();
    for row in &rows {
        entries.push(row.entry.map(|(c, factor)| (c, factor * row.length / lengths[c])));
        wanted.push(row.rate * row.length);
    }
    // The kernel has orthonormal columns over scaled coordinates, w = length · u.
    let scaled = Mat::from_fn(entries.len(), freedoms, |i, k| {
        entries[i].map_or(0.0, |(c, factor)| {
            let factor = if i < first { 1.0 } else { factor };
            factor * kernel[(c, k)]
        })
    });
    let solution = least_squares(&scaled, &wanted);
    let moved = |weights: &[f64]| -> Vec<f64> {
        (0..n).map(|c| (0..freedoms).map(|k| kernel[(c, k)] * weights[k]).sum::<f64>()).collect()
    };
    let scaled_rates = moved(&solution.weights);
    // Rates that disagree are reported before missing rates, because the residual explains the error better.
    let largest = wanted.iter().fold(0.0, |most: f64, w| most.max(w.abs()));
    let floor = groups.iter().map(|g| OPEN_PER_FLOOR * g.relative_error()).fold(0.0, f64::max);
    let value = |i: usize| entries[i].map_or(0.0, |(c, f)| scaled_rates[c] * if i < first { 1.0 } else { f });
    let worst = (0..wanted.len()).max_by(|&a, &b| {
        let residual = |i: usize| (value(i) - wanted[i]).abs();
        residual(a).total_cmp(&residual(b))
    });
    if let Some(i) = worst {
        let residual = (value(i) - wanted[i]).abs() / largest;
        if residual > INADMISSIBLE.max(floor) {
            let (joint, given, admissible) = match i.checked_sub(first).map(|i| &rows[i]) {
                Some(row) => (pose.mechanism().joint(row.joint).name(), row.rate, value(i) / row.length),
                None => ("base", wanted[i], value(i)),
            };
            return Err(RatesError::Inadmissible { joint: joint.to_owned(), given, admissible, residual });
        }
    }
    if solution.rank < freedoms {
        let open = freedoms - solution.rank;
        return Err(RatesError::Undetermined {
            open,
            freedoms,
            joints: undetermined_joints(pose, &coordinates, &kernel, &solution),
        });
    }
    let u: Vec<f64> = scaled_rates.iter().zip(&lengths).map(|(w, length)| w / length).collect();
    let (joints, base) = pose.joint_velocities(&u);
    Ok(JointRates { joints, base })
}

/// Rates of the coordinates, if each has one given rate; `None` otherwise.
fn rates_without_constraints(
    rows: &[GivenRow],
    coordinates: &[(Option<JointId>, usize)],
    base: &Twist<f64>,
) -> Option<Vec<f64>> {
    let of_base = |k: usize| if k < 3 { base.angular[k] } else { base.linear[k - 3] };
    let known = |(joint, k): &(Option<JointId>, usize)| joint.is_none().then(|| of_base(*k));
    let mut rates: Vec<Option<f64>> = coordinates.iter().map(known).collect();
    for row in rows {
        let (c, factor) = row.entry.filter(|(_, factor)| *factor != 0.0)?;
        if rates[c].replace(row.rate / factor).is_some() {
            return None;
        }
    }
    rates.into_iter().collect()
}

/// Displacement, m, of a point at the characteristic length at unit rate, for every coordinate.
pub(crate) fn lengths(pose: &Pose, coordinates: &[(Option<JointId>, usize)]) -> Vec<f64> {
    let mechanism = pose.mechanism();
    let size = mechanism.characteristic_length();
    let length = |&(joint, k): &(Option<JointId>, usize)| {
        let kind = joint.map_or(JointKind::Floating, |joint| mechanism.joint(joint).kind());
        if kind.turns(k) { size } else { 1.0 }
    };
    coordinates.iter().map(length).collect()
}

/// Orthonormal basis of ker A over scaled coordinates, n × degrees of freedom.
pub(crate) fn kernel(groups: &[GroupRows], lengths: &[f64]) -> Mat<f64> {
    let n = lengths.len();
    let mut columns: Vec<Vec<(usize, f64)>> = Vec::new();
    let mut bound = vec![false; n];
    for group in groups {
        group.coordinates().iter().for_each(|&c| bound[c] = true);
        columns.extend(group.kernel(lengths));
    }
    columns.extend((0..n).filter(|&c| !bound[c]).map(|c| vec![(c, 1.0)]));
    let mut kernel = Mat::zeros(n, columns.len());
    for (k, column) in columns.iter().enumerate() {
        column.iter().for_each(|&(c, value)| kernel[(c, k)] = value);
    }
    kernel
}

/// Rows of the given rates.
fn given_rows(
    pose: &Pose,
    drivers: &[DriverRate],
    coordinates: &[(Option<JointId>, usize)],
) -> Result<Vec<GivenRow>, RatesError> {
    let mechanism = pose.mechanism();
    let size = mechanism.characteristic_length();
    let mut rows = Vec::new();
    for (number, driver) in drivers.iter().enumerate() {
        let joint = mechanism.joint(driver.joint);
        let name = || joint.name().to_owned();
        if drivers[..number].iter().any(|other| other.joint == driver.joint) {
            return Err(RatesError::Twice { joint: name() });
        }
        let (got, expected) = (driver.rates.len(), joint.kind().dofs());
        if got != expected {
            return Err(RatesError::Count { joint: name(), got, expected });
        }
        let (master, multiplier) = joint.mimic().map_or((driver.joint, 1.0), |m| (m.master, m.multiplier));
        for (k, &rate) in driver.rates.iter().enumerate() {
            if !rate.is_finite() {
                return Err(RatesError::NotFinite { joint: name(), rate });
            }
            let coordinate = coordinates.iter().position(|c| *c == (Some(master), k));
            let length = if joint.kind().turns(k) { size } else { 1.0 };
            rows.push(GivenRow {
                joint: driver.joint,
                entry: coordinate.map(|c| (c, multiplier)),
                rate,
                length,
            });
        }
    }
    Ok(rows)
}

/// Least-squares solution of the given rates.
pub(crate) struct DriverSolution {
    pub weights: Vec<f64>,
    rank: usize,
    /// Motions that the given rates leave open: orthonormal weights, freedoms × open.
    open: Mat<f64>,
}

/// Solution of least norm by two QR decompositions.
pub(crate) fn least_squares(matrix: &Mat<f64>, wanted: &[f64]) -> DriverSolution {
    let d = matrix.ncols();
    if matrix.nrows() == 0 || d == 0 || matrix.norm_max() == 0.0 {
        return DriverSolution { weights: vec![0.0; d], rank: 0, open: Mat::identity(d, d) };
    }
    // matrixᵀ P = Q R: the first columns of Q span the determined motions.
    let qr = matrix.transpose().to_owned().col_piv_qr();
    let (r, q) = (qr.R().to_owned(), qr.compute_Q());
    let size = r.nrows().min(r.ncols());
    let rank = (0..size).take_while(|&i| r[(i, i)].abs() > DETERMINED * r[(0, 0)].abs()).count();
    let order = qr.P().arrays().0;
    // matrix Q₁ y = wanted, in the least-squares sense; matrix = P R₁ᵀ Q₁ᵀ.
    let lower = Mat::from_fn(matrix.nrows(), rank, |i, k| if k <= i { r[(k, i)] } else { 0.0 });
    let right = Mat::from_fn(matrix.nrows(), 1, |i, _| wanted[order[i]]);
    use faer::linalg::solvers::SolveLstsq;
    let y = lower.qr().solve_lstsq(&right);
    let weights = (0..d).map(|i| (0..rank).map(|k| q[(i, k)] * y[(k, 0)]).sum()).collect();
    DriverSolution { weights, rank, open: q.get(.., rank..).to_owned() }
}

/// Joints whose rates are not determined: first those of one velocity, in joint order.
fn undetermined_joints(
    pose: &Pose,
    coordinates: &[(Option<JointId>, usize)],
    kernel: &Mat<f64>,
    solution: &DriverSolution,
) -> Vec<String> {
    let open = kernel * &solution.open;
    let mut joints: Vec<JointId> = Vec::new();
    for (c, (joint, _)) in coordinates.iter().enumerate() {
        let moves = (0..open.ncols()).any(|k| open[(c, k)].abs() > DETERMINED);
        if let (true, Some(joint)) = (moves, joint) {
            joints.push(*joint);
        }
    }
    joints.dedup();
    joints.into_iter().map(|joint| pose.mechanism().joint(joint).name().to_owned()).collect()
}
