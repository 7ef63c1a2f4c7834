//! Plastic impact with sticking contact points.

use crate::error::ImpactError;
use crate::mobility::delassus::Delassus;
use crate::mobility::semidefinite::SemidefiniteSolver;
use crate::several::least_friction::least_friction;
use crate::tolerances::{COMPLEMENTARY, MOST_CONTACTS};
use nalgebra::{DMatrix, DVector};

/// State of a contact after a plastic impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StickingContact {
    /// True if the point sticks: its relative velocity is zero after the impact. False if it lets go.
    pub sticks: bool,
    /// Impulse on the contact link along −n̂, N·s. `None` if redundant contacts leave it open.
    pub normal_impulse: Option<f64>,
    /// Magnitude of the tangential impulse, N·s. `None` if open.
    pub tangential_impulse: Option<f64>,
    /// Opening speed after the impact, m/s: zero or positive.
    pub opening_speed: f64,
    /// Coefficient of friction that the sticking needs, |p_t|/p_n. `None` if open, or without a normal impulse.
    pub required_friction: Option<f64>,
}

/// Plastic impact with sticking points: u⁺ = 0 at the points that stick.
///
/// The points that stick have the impulses P = −W⁺ u⁻ and the impact map q̇⁺ = Δ q̇⁻ with Δ = 1 − N K⁻¹ (J N)ᵀ W⁺ J. All subsets
/// of the contacts are examined. A subset is consistent if no contact pulls (p_n ≥ 0; with open impulses, for at least one distribution)
/// and no other contact closes its gap. Sticking requires a coefficient of friction of at least
/// [`required_friction`](StickingContact::required_friction). Tangential directions in which a point cannot move, such as those across
/// the plane of a planar linkage, have no impulse. Sources: Hurmuzlu and Marghitu 1994 for the conditions; Westervelt et al. 2007, §3.4
/// for the map.
#[derive(Clone, Debug)]
pub struct StickingImpact {
    /// Contacts in the order of the Delassus matrix.
    pub contacts: Vec<StickingContact>,
    /// Δ over the coordinates of the pose, n×n.
    pub map: DMatrix<f64>,
    /// Impulses of all contacts, 3k: of least norm if redundant.
    pub impulses: DVector<f64>,
    /// Lost kinetic energy, J.
    pub energy_loss: f64,
    /// Least coefficient of friction for which all points can stick: with redundant contacts, over all distributions of the open
    /// impulses. `None` if no coefficient suffices: a contact has a tangential impulse without a normal one.
    pub least_friction: Option<f64>,
    /// Number of consistent subsets of sticking contacts. With more than one, the result is that with the most contacts.
    pub consistent_subsets: usize,
}

/// Plastic impact of contacts with the relative velocities `before` (3k, m/s).
///
/// # Errors
/// [`ImpactError`]: no contact closes its gap, too many contacts, no consistent subset.
pub fn sticking_impact(delassus: &Delassus, before: &DVector<f64>) -> Result<StickingImpact, ImpactError> {
    let k = delassus.contacts();
    if k > MOST_CONTACTS {
        return Err(ImpactError::TooManyContacts { got: k, most: MOST_CONTACTS });
    }
    let speed = before.amax();
    let closing = (0..k).map(|i| -before[3 * i]).fold(f64::NEG_INFINITY, f64::max);
    if closing.is_nan() || closing <= COMPLEMENTARY * speed {
        return Err(ImpactError::ClosingSpeed { got: closing });
    }
    let mut consistent: Vec<(u32, Subset)> = Vec::new();
    for mask in 1..1u32 << k {
        let subset = Subset::new(delassus, before, mask);
        if subset.is_consistent(delassus.contacts(), mask, speed) {
            consistent.push((mask, subset));
        }
    }
    let consistent_subsets = consistent.len();
    let most = consistent.into_iter().max_by_key(|(mask, _)| mask.count_ones());
    let (mask, subset) = most.ok_or(ImpactError::NoConsistentSubset)?;
    Ok(StickingImpact {
        contacts: (0..k).map(|i| subset.contact(i, mask)).collect(),
        map: subset.map(delassus),
        energy_loss: -0.5 * subset.impulses.dot(&(before + &subset.after)),
        least_friction: subset.least_friction(k, mask),
        impulses: subset.impulses,
        consistent_subsets,
    })
}

/// Result with a given subset of sticking contacts.
struct Subset {
    /// Directions of the impulses: the normals and the tangential directions in which the points can move, 3k×r.
    directions: DMatrix<f64>,
    solver: SemidefiniteSolver,
    impulses: DVector<f64>,
    after: DVector<f64>,
    /// True for components that redundant contacts leave open.
    is_open: Vec<bool>,
}

impl Subset {
    fn new(delassus: &Delassus, before: &DVector<f64>, mask: u32) -> Self {
        let k = delassus.contacts();
        let directions = directions(delassus, mask);
        let w = delassus.matrix();
        let solver = SemidefiniteSolver::of_contacts(&(directions.transpose() * w * &directions));
        let impulses = &directions * solver.solve(&(directions.transpose() * -before));
        let is_open = (0..3 * k).map(|row| solver.is_open(&directions.row(row).transpose())).collect();
        let after = before + w * &impulses;
        Self { directions, solver, impulses, after, is_open }
    }

    /// True if no contact pulls and no contact closes its gap after the impact.
    fn is_consistent(&self, k: usize, mask: u32, speed: f64) -> bool {
        let largest = self.impulses.amax();
        (0..k).all(|i| {
            if mask & (1 << i) != 0 {
                let rests = (0..3).all(|c| self.after[3 * i + c].abs() <= COMPLEMENTARY.sqrt() * speed);
                rests && (self.is_open[3 * i] || self.impulses[3 * i] >= -COMPLEMENTARY * largest)
            } else {
                self.after[3 * i] >= -COMPLEMENTARY * speed
            }
        }) && self.can_press(k, mask)
    }

    /// True if the open impulses can be such that no contact pulls.
    fn can_press(&self, k: usize, mask: u32) -> bool {
        if !(0..k).any(|i| mask & (1 << i) != 0 && self.is_open[3 * i]) {
            return true;
        }
        let mut normal_only = (self.impulses.clone(), self.open_impulses());
        for row in (0..3 * k).filter(|row| row % 3 != 0) {
            normal_only.0[row] = 0.0;
            normal_only.1.row_mut(row).fill(0.0);
        }
        least_friction(&normal_only.0, &normal_only.1, &sticking_contacts(k, mask)).is_some()
    }

    /// Impulses that change no motion, 3k×d.
    fn open_impulses(&self) -> DMatrix<f64> {
        &self.directions * self.solver.kernel()
    }

    /// Least coefficient of friction for which all points can stick.
    fn least_friction(&self, k: usize, mask: u32) -> Option<f64> {
        least_friction(&self.impulses, &self.open_impulses(), &sticking_contacts(k, mask))
    }

    fn contact(&self, i: usize, mask: u32) -> StickingContact {
        let [n, t1, t2] = [3 * i, 3 * i + 1, 3 * i + 2];
        let normal = (!self.is_open[n]).then_some(self.impulses[n]);
        let tangential =
            (!self.is_open[t1] && !self.is_open[t2]).then(|| self.impulses[t1].hypot(self.impulses[t2]));
        let sticks = mask & (1 << i) != 0;
        StickingContact {
            sticks,
            normal_impulse: normal,
            tangential_impulse: tangential,
            opening_speed: if sticks { 0.0 } else { self.after[n] },
            required_friction: normal
                .zip(tangential)
                .filter(|(normal, _)| sticks && *normal > COMPLEMENTARY * self.impulses.amax())
                .map(|(normal, tangential)| tangential / normal),
        }
    }

    /// Δ = 1 − N K⁻¹ (J N)ᵀ W⁺ J.
    fn map(&self, delassus: &Delassus) -> DMatrix<f64> {
        let (jacobian, responses) = (delassus.jacobian(), delassus.responses());
        let n = jacobian.ncols();
        let rows = self.directions.transpose() * jacobian;
        let mut impulses = DMatrix::zeros(rows.nrows(), n);
        for c in 0..n {
            impulses.set_column(c, &self.solver.solve(&rows.column(c).into_owned()));
        }
        DMatrix::identity(n, n) - responses * &self.directions * impulses
    }
}

/// Contacts of a subset.
fn sticking_contacts(k: usize, mask: u32) -> Vec<usize> {
    (0..k).filter(|i| mask & (1 << i) != 0).collect()
}

/// Normals and movable tangential directions of the contacts of a subset, as columns.
fn directions(delassus: &Delassus, mask: u32) -> DMatrix<f64> {
    let k = delassus.contacts();
    let mut columns: Vec<DVector<f64>> = Vec::new();
    for i in (0..k).filter(|i| mask & (1 << i) != 0) {
        let mut normal = DVector::zeros(3 * k);
        normal[3 * i] = 1.0;
        columns.push(normal);
        for tangent in delassus.movable_tangents(i) {
            let mut column = DVector::zeros(3 * k);
            column.rows_mut(3 * i + 1, 2).copy_from(&tangent);
            columns.push(column);
        }
    }
    DMatrix::from_columns(&columns)
}
