//! Free and rigid mass of a contact, and the residual compliance of the bushes.

use super::elements::{ElasticDirection, ElasticRow};
use super::response::symmetric_eigen;
use super::subspace::{Subspaces, split};
use super::system::{ComplianceError, ElasticSystem};
use crate::dense::matrices::{MatrixResponse, MatrixView, effective_mass};
use crate::kinematics::outcome::EffectiveMass;
use crate::tolerances::{CLEAR_OF_RIGID_MOTION, IMMOVABLE, NO_INERTIA, REDUCED_ACCURACY};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Residual compliance of the bushes at a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct ResidualCompliance {
    /// m̄ with all bushes free: limit of stiff contacts.
    pub free: EffectiveMass,
    /// m̄ with the rigid rows of the bushes held: limit of soft contacts.
    pub rigid: EffectiveMass,
    /// c_res, m/N (rad/(N·m) for a moment); `None` if the contact is massless or no motion closes the gap.
    pub compliance: Option<f64>,
    /// Velocities ż of the rigid mechanism at unit closing speed, the motion of least energy; `None` unless the rigid mechanism closes the gap.
    pub rigid_motion: Option<DVector<f64>>,
    /// Shares of the rows in the elastic energy, the largest first.
    pub shares: Vec<RowShare>,
    /// True if no stiffness and no damping acts along the motion of the rigid mechanism. The lower bounds of an impact need this.
    pub is_free_along_motion: bool,
}

/// Share of a row of a bush in the elastic energy of the residual compliance.
#[derive(Clone, Debug, PartialEq)]
pub struct RowShare {
    /// Name of the bush.
    pub element: String,
    /// Direction in the bush.
    pub direction: ElasticDirection,
    /// Share, from 0 to 1.
    pub share: f64,
}

impl ElasticSystem {
    /// Free mass, rigid mass and residual compliance.
    ///
    /// ```text
    /// c_res = fᵀ K⁺ f,   f = jᵀ − M v*/m̄   (inertia relief; f = jᵀ if the rigid mechanism is immovable)
    /// h(ω) = −1/(ω² m̄) + c_res + O(ω²)     for the receptance with the rigid rows alone
    /// ```
    ///
    /// K contains the rows that the rigid mechanism holds, v* is the velocity of the rigid mechanism at unit closing speed. One solution of
    /// a linear system in the complement of the rigid motions, which is found from the directions of the rows, not from their stiffness. A geometric
    /// stiffness G of forces at the pose adds QᵀGQ on the motions Q whose momentum is normal to the rigid motions: c_res is then the static part of
    /// the elastic modes.
    ///
    /// # Errors
    /// [`ComplianceError`]: masses that are not positive semi-definite, a decomposition that does not converge, an equilibrium that the forces at the
    /// pose make unstable.
    pub fn residual(&self) -> Result<ResidualCompliance, ComplianceError> {
        let m = self.contact.len();
        let rows = self.rows_where(|row| row.is_rigid && row.acts());
        let held = split(&rows, m, self.floor).ok_or(ComplianceError::Decomposition)?;
        let free = minimum(&self.mass, &self.contact)?;
        let (reduced, closing) = (held.null.tr_mul(&self.mass) * &held.null, held.null.tr_mul(&self.contact));
        // On the rigid motions a contact row that vanishes is rounding, however small the largest of its entries is.
        let is_held = closing.norm() <= IMMOVABLE * self.contact.norm();
        let rigid = if is_held { None } else { Some(minimum(&reduced, &closing)?) };
        let mass = rigid.as_ref().map_or(EffectiveMass::Immovable, |found| found.effective_mass);
        let motion = rigid.map(|found| &held.null * DVector::from_vec(found.velocity));
        let mut result = ResidualCompliance {
            free: free.effective_mass,
            rigid: mass,
            compliance: None,
            shares: Vec::new(),
            is_free_along_motion: motion.as_ref().is_none_or(|v| self.is_free_along(v)),
            rigid_motion: motion.clone(),
        };
        let force = match (mass, free.effective_mass) {
            (EffectiveMass::Massless, _) | (_, EffectiveMass::Immovable) => return Ok(result),
            (EffectiveMass::Immovable, _) => self.contact.clone(),
            (EffectiveMass::Finite(mass), _) => {
                let Some(motion) = motion else { return Ok(result) };
                &self.contact - &self.mass * motion / mass
            }
        };
        let applied = held.range.tr_mul(&force);
        let is_loaded = self.rows.iter().any(ElasticRow::is_geometric);
        let deflection = if is_loaded {
            let stiffness = self.sum_of_rows(|row| if row.is_rigid { row.stiffness } else { 0.0 });
            let geometric = self.sum_of_rows(|row| if row.is_geometric() { row.stiffness } else { 0.0 });
            let elastic = self.without_rigid_momentum(&held)?;
            let own = held.range.tr_mul(&stiffness) * &held.range;
            // Rows with a damper alone leave a motion without stiffness.
            if !applied.is_empty() && stiffness_factor(&own).is_none() {
                return Ok(result);
            }
            let whole = own + elastic.tr_mul(&geometric) * elastic;
            Some(solve_positive(&whole, &applied).ok_or(ComplianceError::Unstable)?)
        } else {
            self.solve_by_roots(&held.range, &applied)
        };
        let Some(deflection) = deflection else { return Ok(result) };
        let work = deflection.dot(&applied);
        let deflection = &held.range * deflection;
        let energy_of = |stiffness: f64, row: &DVector<f64>| stiffness * row.dot(&deflection).powi(2);
        let rigid_rows = || self.rows.iter().filter(|row| row.is_rigid);
        let of_rows: f64 = rigid_rows().map(|row| energy_of(row.stiffness, &row.row)).sum();
        let compliance = if is_loaded { work } else { of_rows };
        result.compliance = Some(compliance);
        if of_rows > 0.0 {
            result.shares = rigid_rows()
                .map(|row| RowShare {
                    element: row.element.clone(),
                    direction: row.direction,
                    share: energy_of(row.stiffness, &row.row) / of_rows,
                })
                .collect();
            result.shares.sort_by(|a, b| b.share.total_cmp(&a.share));
        }
        Ok(result)
    }

    /// Static compliance jᵀK⁺j of the contact with all stiffness, m/N; `None` if a motion without stiffness closes the gap.
    ///
    /// # Errors
    /// [`ComplianceError`]: a decomposition that does not converge.
    pub fn static_compliance(&self) -> Result<Option<f64>, ComplianceError> {
        let rows = self.rows_where(ElasticRow::is_elastic);
        let spaces = split(&rows, self.contact.len(), self.floor).ok_or(ComplianceError::Decomposition)?;
        if spaces.null.tr_mul(&self.contact).norm() > IMMOVABLE * self.contact.norm() {
            return Ok(None);
        }
        let stiffness = spaces.range.tr_mul(&self.sum_of_rows(|row| row.stiffness)) * &spaces.range;
        let force = spaces.range.tr_mul(&self.contact);
        Ok(solve_positive(&stiffness, &force).map(|deflection| deflection.dot(&force)))
    }

    /// True if no element with stiffness or damping resists a motion.
    fn is_free_along(&self, motion: &DVector<f64>) -> bool {
        let resists =
            |row: &DVector<f64>| row.dot(motion).abs() > CLEAR_OF_RIGID_MOTION * row.norm() * motion.norm();
        // The geometric stiffness on the motion, compared with the stiffness of the bushes.
        let bushes = self.sum_of_rows(|row| if row.is_rigid { row.stiffness } else { 0.0 });
        let geometric = self.sum_of_rows(|row| if row.is_geometric() { row.stiffness } else { 0.0 });
        let is_loaded = (geometric * motion).norm() > CLEAR_OF_RIGID_MOTION * bushes.norm() * motion.norm();
        !is_loaded && !self.rows.iter().any(|row| row.acts() && resists(&row.row))
    }

    /// Solves RᵀKR x = f with the stiffness K of the rigid rows B by the triangle of √k B R = Q T: the condition is the root of that of K. `None` for
    /// a singular triangle.
    fn solve_by_roots(&self, range: &DMatrix<f64>, force: &DVector<f64>) -> Option<DVector<f64>> {
        let rigid: Vec<&ElasticRow> =
            self.rows.iter().filter(|row| row.is_rigid && row.is_elastic()).collect();
        let roots = DMatrix::from_fn(rigid.len(), self.contact.len(), |r, c| {
            rigid[r].stiffness.sqrt() * rigid[r].row[c]
        });
        if force.is_empty() {
            return Some(force.clone());
        }
        let triangle = (roots * range).qr().r();
        // Rows with a damper alone leave a motion without stiffness.
        triangle.is_square().then_some(())?;
        let sizes = triangle.diagonal().abs();
        (sizes.min() > self.floor * sizes.max()).then_some(())?;
        triangle.solve_upper_triangular(&triangle.tr_solve_upper_triangular(force)?)
    }

    /// Motions of the rigid rows, each with the rigid motion that makes its momentum normal to the rigid motions, and with the massless rigid motions that
    /// are in balance with all stiffness.
    fn without_rigid_momentum(&self, held: &Subspaces) -> Result<DMatrix<f64>, ComplianceError> {
        let of_rigid = held.null.tr_mul(&self.mass) * &held.null;
        let (masses, vectors) = symmetric_eigen(&of_rigid).ok_or(ComplianceError::Decomposition)?;
        let largest = masses.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let with_mass: Vec<usize> = (0..masses.len()).filter(|&i| masses[i] > NO_INERTIA * largest).collect();
        let rigid = &held.null * vectors.select_columns(&with_mass);
        let mut momentum = rigid.tr_mul(&self.mass) * &held.range;
        for (r, &i) in with_mass.iter().enumerate() {
            momentum.row_mut(r).scale_mut(1.0 / masses[i]);
        }
        let elastic = &held.range - rigid * momentum;
        let without: Vec<usize> = (0..masses.len()).filter(|i| !with_mass.contains(i)).collect();
        let massless = &held.null * vectors.select_columns(&without);
        let stiffness = self.sum_of_rows(|row| row.stiffness);
        let own = massless.tr_mul(&stiffness) * &massless;
        let follows = solve_positive_columns(&own, massless.tr_mul(&stiffness) * &elastic);
        Ok(follows.map_or_else(|| elastic.clone(), |follows| &elastic - massless * follows))
    }
}

/// m̄ of a reduced system, whose coordinates all have the unit of a length.
fn minimum(mass: &DMatrix<f64>, contact: &DVector<f64>) -> Result<MatrixResponse, ComplianceError> {
    let symmetric = (mass + mass.transpose()) / 2.0;
    let n = contact.len();
    let view =
        MatrixView::column_major(symmetric.as_slice(), n, n).map_err(|_| ComplianceError::Decomposition)?;
    // Entries of the basis are exact to some roundings of the decomposition.
    let options = crate::dense::matrices::MatrixOptions::new().accuracy(REDUCED_ACCURACY);
    Ok(effective_mass(view, contact.as_slice(), None, &options)?)
}

/// Solves A x = b for a symmetric positive definite matrix. `None` if it is not positive definite.
pub(super) fn solve_positive(a: &DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
    let columns = DMatrix::from_column_slice(b.len(), 1, b.as_slice());
    Some(solve_positive_columns(a, columns)?.column(0).into_owned())
}

/// Solves A X = B for a symmetric positive definite matrix, scaled to unit diagonal. `None` if it is not positive definite.
pub(super) fn solve_positive_columns(a: &DMatrix<f64>, mut b: DMatrix<f64>) -> Option<DMatrix<f64>> {
    if b.is_empty() {
        return Some(b);
    }
    let (scale, factor) = stiffness_factor(a)?;
    b.column_iter_mut().for_each(|mut column| column.component_mul_assign(&scale));
    factor.solve_mut(&mut b);
    b.column_iter_mut().for_each(|mut column| column.component_mul_assign(&scale));
    Some(b)
}

/// Scale s of a symmetric positive definite matrix A, and the decomposition of the matrix sᵢ aᵢⱼ sⱼ, whose diagonal is 1. `None` for an empty matrix
/// and for one that is not positive definite.
pub(super) fn stiffness_factor(a: &DMatrix<f64>) -> Option<(DVector<f64>, Cholesky<f64, Dyn>)> {
    let n = a.nrows();
    let scale = DVector::from_fn(n, |i, _| 1.0 / a[(i, i)].sqrt());
    let scaled = DMatrix::from_fn(n, n, |r, c| scale[r] * a[(r, c)] * scale[c]);
    (n > 0).then_some(())?;
    Some((scale, scaled.cholesky()?))
}
