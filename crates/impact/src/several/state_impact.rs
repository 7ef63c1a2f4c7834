//! Impact of several contacts at one of many states.

use crate::error::ImpactError;
use crate::mobility::delassus::{Delassus, contact_axes, relative_jacobian};
use crate::motion::joint_rates::JointRates;
use crate::several::energetic::ContactStiffness;
use crate::several::laws::{SimultaneousLaw, simultaneous_impact_of_matrix};
use crate::several::sticking::sticking_impact;
use crate::tolerances::{
    CLEAR_PIVOT, COMPLEMENTARY, OPEN_COMPONENT, REGULAR_MASS, ROUNDING_PIVOT, SPEED_ROUNDING,
};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn, Matrix3};
use percuss_dynamics::{LocatedContact, Pose};
use percuss_spatial::Twist;

/// Law of the impact of contacts that touch at the same time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactsLaw {
    /// Without friction: [`simultaneous_impact`](crate::simultaneous_impact) with equal stiffnesses.
    Simultaneous(SimultaneousLaw),
    /// Plastic impact with sticking points: [`sticking_impact`].
    Sticking,
}

/// Impact of several contacts at one state.
#[must_use]
#[derive(Clone, Debug)]
pub struct StateImpact {
    /// Opening speed and two tangential speeds of each contact before the impact, m/s (rad/s for a moment): 3k.
    pub before: DVector<f64>,
    /// Impulse on each contact link along the axes, N·s (N·m·s): 3k; of least norm if redundant contacts leave it open.
    pub impulses: DVector<f64>,
    /// Axes of the components of each contact as columns, in root axes: −n̂ and two tangents.
    pub axes: Vec<Matrix3<f64>>,
    /// Normal impulse of each contact; `None` if redundant contacts leave it open.
    pub normal_impulses: Vec<Option<f64>>,
    /// True for each contact that sticks.
    pub sticks: Vec<bool>,
    /// Rates after the impact.
    pub after: JointRates,
    /// Lost kinetic energy, J.
    pub energy_loss: f64,
    /// Δ of q̇⁺ = Δ q̇⁻ over the coordinates of the pose, if requested, for sticking points.
    pub map: Option<DMatrix<f64>>,
}

/// Impact of the contacts at a pose with the given rates; without impulses if no contact closes.
///
/// `restitution`: e of each contact, not for sticking points. The results are those of [`simultaneous_impact`](crate::simultaneous_impact)
/// and [`sticking_impact`].
/// If all points of a tree stick, one factorisation of M and one of W give the result: O(n³/3 + n² k), without eigenvalues and without
/// the other subsets, because the result with the most sticking contacts is that of all of them.
///
/// # Errors
/// [`ImpactError`], as for the two functions.
pub fn state_impact(
    pose: &Pose,
    contacts: &[LocatedContact],
    rates: &JointRates,
    law: ContactsLaw,
    restitution: &[f64],
    wants_map: bool,
) -> Result<StateImpact, ImpactError> {
    if let Some(tree) = TreeMobility::new(pose, contacts) {
        let coordinates = DVector::from_vec(rates.coordinates(pose));
        let before = tree.velocities(&coordinates);
        let found = match law {
            ContactsLaw::Sticking => tree.stick(before, wants_map),
            ContactsLaw::Simultaneous(law) => {
                let mut found = StateImpact::without_impulses(before, &tree.axes, rates);
                found.add_simultaneous(&tree.normal_matrix(), law, restitution)?;
                Some(found)
            }
        };
        if let Some(mut found) = found {
            let change = tree.rates_of(&tree.half * &found.impulses);
            let (joints, base) = pose.joint_velocities(change.as_slice());
            found.after = rates.plus_scaled(&JointRates { joints, base }, 1.0);
            return Ok(found);
        }
    }
    let delassus = Delassus::new(pose, contacts)?;
    let axes: Vec<_> = (0..contacts.len()).map(|contact| *delassus.axes(contact)).collect();
    let mut found = StateImpact::without_impulses(delassus.velocities(pose, rates), &axes, rates);
    match law {
        ContactsLaw::Simultaneous(law) => {
            found.add_simultaneous(&delassus.normal_matrix(), law, restitution)?;
        }
        ContactsLaw::Sticking => {
            let n = delassus.jacobian().ncols();
            found.map = wants_map.then(|| DMatrix::identity(n, n));
            match sticking_impact(&delassus, &found.before) {
                Err(ImpactError::ClosingSpeed { .. }) => return Ok(found),
                impact => {
                    let impact = impact?;
                    found.normal_impulses =
                        impact.contacts.iter().map(|contact| contact.normal_impulse).collect();
                    found.sticks = impact.contacts.iter().map(|contact| contact.sticks).collect();
                    found.energy_loss = impact.energy_loss;
                    found.impulses = impact.impulses;
                    found.map = wants_map.then_some(impact.map);
                }
            }
        }
    }
    found.after = rates.plus_scaled(&delassus.rate_change(pose, &found.impulses), 1.0);
    Ok(found)
}

impl StateImpact {
    /// State without an impact.
    fn without_impulses(before: DVector<f64>, axes: &[Matrix3<f64>], rates: &JointRates) -> Self {
        let k = axes.len();
        Self {
            impulses: DVector::zeros(3 * k),
            axes: axes.to_vec(),
            normal_impulses: vec![Some(0.0); k],
            sticks: vec![false; k],
            after: rates.clone(),
            energy_loss: 0.0,
            map: None,
            before,
        }
    }

    /// Adds the impulses of a law without friction, if a contact closes. `matrix`: W of the normals.
    fn add_simultaneous(
        &mut self,
        matrix: &DMatrix<f64>,
        law: SimultaneousLaw,
        restitution: &[f64],
    ) -> Result<(), ImpactError> {
        let k = self.axes.len();
        let speeds = DVector::from_fn(k, |contact, _| self.before[3 * contact]);
        if speeds.iter().all(|speed| *speed >= 0.0) {
            return Ok(());
        }
        let stiffness = ContactStiffness { ratios: vec![1.0; k], exponent: 1.0 };
        let impact = simultaneous_impact_of_matrix(matrix, &speeds, restitution, law, &stiffness)?;
        (0..k).for_each(|contact| self.impulses[3 * contact] = impact.solution[contact]);
        self.normal_impulses = impact.impulses;
        self.energy_loss = impact.energy_loss;
        Ok(())
    }
}

/// Mobility of contacts of a tree with a mass matrix that is clearly regular: M = L Lᵀ, Y = L⁻¹ Jᵀ, W = YᵀY.
struct TreeMobility {
    axes: Vec<Matrix3<f64>>,
    jacobian: DMatrix<f64>,
    mass: Cholesky<f64, Dyn>,
    half: DMatrix<f64>,
    /// W scaled to a unit diagonal, and the scale of its rows.
    even: DMatrix<f64>,
    scale: DVector<f64>,
}

impl TreeMobility {
    /// `None` for mechanisms with constraints, and if motions without mass or contacts that hardly move need a decision about rounding.
    fn new(pose: &Pose, contacts: &[LocatedContact]) -> Option<Self> {
        if !pose.constraint_groups().is_empty() {
            return None;
        }
        let mass = pose.mass_matrix();
        let (rows, n) = (3 * contacts.len(), mass.ncols());
        let diagonal = mass.diagonal();
        let factor = Cholesky::new(mass)?;
        let pivots = factor.l_dirty().diagonal();
        let is_regular = |(pivot, entry): (&f64, &f64)| pivot * pivot > REGULAR_MASS * entry;
        if !pivots.iter().zip(&diagonal).all(is_regular) {
            return None;
        }
        let (mut jacobian, mut axes) = (DMatrix::zeros(rows, n), Vec::with_capacity(contacts.len()));
        for (number, contact) in contacts.iter().enumerate() {
            let own = contact_axes(pose, contact);
            jacobian.rows_mut(3 * number, 3).copy_from(&(own.transpose() * relative_jacobian(pose, contact)));
            axes.push(own);
        }
        let mut half = jacobian.transpose();
        factor.l_dirty().solve_lower_triangular_mut(&mut half);
        let mut even = half.tr_mul(&half);
        let largest = even.diagonal().amax();
        if !even.diagonal().iter().all(|entry| *entry > CLEAR_PIVOT * largest) {
            return None;
        }
        let scale = even.diagonal().map(|entry| entry.sqrt().recip());
        for (r, c) in (0..rows).flat_map(|r| (0..rows).map(move |c| (r, c))) {
            even[(r, c)] *= scale[r] * scale[c];
        }
        Some(Self { axes, jacobian, mass: factor, half, even, scale })
    }

    /// W of the normals.
    fn normal_matrix(&self) -> DMatrix<f64> {
        let entry = |r: usize, c: usize| self.even[(r, c)] / (self.scale[r] * self.scale[c]);
        DMatrix::from_fn(self.axes.len(), self.axes.len(), |r, c| entry(3 * r, 3 * c))
    }

    /// Relative velocities of the contacts, as [`Delassus::velocities`].
    fn velocities(&self, rates: &DVector<f64>) -> DVector<f64> {
        let mut before = &self.jacobian * rates;
        for contact in 0..self.axes.len() {
            let rows = self.jacobian.rows(3 * contact, 3);
            let terms = rows.column_iter().zip(rates.iter());
            let size: f64 = terms.map(|(column, rate)| column.norm() * rate.abs()).sum();
            let own = before.rows_mut(3 * contact, 3).into_iter();
            own.filter(|speed| speed.abs() <= SPEED_ROUNDING * size).for_each(|speed| *speed = 0.0);
        }
        before
    }

    /// Impact in which all points stick, with the rates after it left out; `None` if no contact closes, if a contact would pull, or if the
    /// result needs a decision about rounding.
    fn stick(&self, before: DVector<f64>, wants_map: bool) -> Option<StateImpact> {
        let k = self.axes.len();
        let speed = before.amax();
        let closing = (0..k).map(|contact| -before[3 * contact]).fold(f64::NEG_INFINITY, f64::max);
        if closing.is_nan() || closing <= COMPLEMENTARY * speed {
            return None;
        }
        let solver = self.solver()?;
        let impulses = solver.solve(&-&before);
        let response = &self.half * &impulses;
        let after = &before + self.half.tr_mul(&response);
        let rests = after.amax() <= COMPLEMENTARY.sqrt() * speed;
        // Open impulses of least norm that press show that some distribution presses.
        let presses = (0..k).all(|contact| impulses[3 * contact] >= -COMPLEMENTARY * impulses.amax());
        if !rests || !presses {
            return None;
        }
        let is_open = |contact: usize| solver.kernel.row(3 * contact).norm() > OPEN_COMPONENT;
        let map = wants_map.then(|| {
            let mut map = DMatrix::identity(self.jacobian.ncols(), self.jacobian.ncols());
            for (column, mut to) in self.jacobian.column_iter().zip(map.column_iter_mut()) {
                to -= self.rates_of(&self.half * solver.solve(&column.into_owned()));
            }
            map
        });
        Some(StateImpact {
            normal_impulses: (0..k).map(|i| (!is_open(i)).then_some(impulses[3 * i])).collect(),
            sticks: vec![true; k],
            after: JointRates { joints: Vec::new(), base: Twist::zero() },
            energy_loss: -0.5 * impulses.dot(&(&before + after)),
            axes: self.axes.clone(),
            map,
            before,
            impulses,
        })
    }

    /// L⁻ᵀ y: rates of the coordinates.
    fn rates_of(&self, mut y: DVector<f64>) -> DVector<f64> {
        self.mass.l_dirty().tr_solve_lower_triangular_mut(&mut y);
        y
    }

    /// Solver of W P = b, by a factorisation with pivots that are clearly rounding or clearly not; `None` for pivots in between.
    fn solver(&self) -> Option<RankSolver<'_>> {
        let m = self.even.nrows();
        let mut left = self.even.diagonal();
        let mut order: Vec<usize> = (0..m).collect();
        let mut lower = DMatrix::zeros(m, m);
        let mut rank = 0;
        while rank < m {
            let next = (rank..m).max_by(|a, b| left[order[*a]].total_cmp(&left[order[*b]]))?;
            let pivot = left[order[next]];
            if pivot <= ROUNDING_PIVOT {
                break;
            }
            if pivot < CLEAR_PIVOT {
                return None;
            }
            order.swap(rank, next);
            lower.swap_rows(rank, next);
            let root = pivot.sqrt();
            lower[(rank, rank)] = root;
            for row in rank + 1..m {
                let known: f64 = (0..rank).map(|c| lower[(row, c)] * lower[(rank, c)]).sum();
                let entry = (self.even[(order[row], order[rank])] - known) / root;
                lower[(row, rank)] = entry;
                left[order[row]] -= entry * entry;
            }
            rank += 1;
        }
        // Kernel of G Gᵀ: −G₁⁻ᵀ G₂ᵀ over the pivots, 1 over the other rows; times the scale, for W.
        let mut parts = lower.view((rank, 0), (m - rank, rank)).transpose();
        let square = lower.view((0, 0), (rank, rank)).into_owned();
        square.tr_solve_lower_triangular_mut(&mut parts);
        let mut kernel = DMatrix::zeros(m, m - rank);
        for column in 0..m - rank {
            for row in 0..rank {
                kernel[(order[row], column)] = -parts[(row, column)] * self.scale[order[row]];
            }
            kernel[(order[rank + column], column)] = self.scale[order[rank + column]];
        }
        let kernel = if rank < m { kernel.qr().q() } else { kernel };
        Some(RankSolver { scale: &self.scale, order, square, kernel })
    }
}

/// Solver of W P = b for b in the range of W.
struct RankSolver<'a> {
    scale: &'a DVector<f64>,
    /// Rows with pivots, then the other rows.
    order: Vec<usize>,
    /// Triangular factor over the rows with pivots.
    square: DMatrix<f64>,
    /// Orthonormal basis of the kernel of W.
    kernel: DMatrix<f64>,
}

impl RankSolver<'_> {
    /// Solution of least norm.
    fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let rank = self.square.nrows();
        let mut own = DVector::from_fn(rank, |row, _| right[self.order[row]] * self.scale[self.order[row]]);
        self.square.solve_lower_triangular_mut(&mut own);
        self.square.tr_solve_lower_triangular_mut(&mut own);
        let mut found = DVector::zeros(self.order.len());
        for row in 0..rank {
            found[self.order[row]] = own[row] * self.scale[self.order[row]];
        }
        &found - &self.kernel * self.kernel.tr_mul(&found)
    }
}
