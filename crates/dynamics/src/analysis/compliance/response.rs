//! Receptance of a contact over frequency.

use super::elements::ElasticRow;
use super::subspace::{Subspaces, split};
use super::system::{ComplianceError, ElasticSystem};
use crate::tolerances::{MASSLESS_CLOSING, NO_INERTIA};
use nalgebra::{Complex, DMatrix, DVector};

/// Driving-point receptance of a contact at an angular frequency ω: displacement along the normal per force, other forces zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receptance {
    /// ω, rad/s.
    pub angular_frequency: f64,
    /// h(ω) = j (K(1 + iη) + iωC − ω²M)⁻¹ jᵀ, m/N (rad/(N·m) for a moment).
    pub receptance: Complex<f64>,
}

impl Receptance {
    /// Apparent mass F/ẍ = −1/(ω²h), kg (ANSI/ASA S1.1 6.31).
    pub fn apparent_mass(&self) -> Complex<f64> {
        -(self.receptance * self.angular_frequency.powi(2)).inv()
    }

    /// Accelerance ẍ/F = −ω²h, 1/kg.
    pub fn accelerance(&self) -> Complex<f64> {
        -self.receptance * self.angular_frequency.powi(2)
    }

    /// Mobility ẋ/F = iωh, m/(N·s).
    pub fn mobility(&self) -> Complex<f64> {
        self.receptance * Complex::new(0.0, self.angular_frequency)
    }

    /// Dynamic stiffness F/x = 1/h, N/m.
    pub fn dynamic_stiffness(&self) -> Complex<f64> {
        self.receptance.inv()
    }
}

impl ElasticSystem {
    /// Receptance at angular frequencies above 0, rad/s. `None` for a frequency at which the solution does not exist, and for all of them if no motion
    /// closes the gap, or one without mass, stiffness and damping.
    ///
    /// # Errors
    /// [`ComplianceError`]: a decomposition that does not converge.
    pub fn receptance(
        &self,
        angular_frequencies: &[f64],
    ) -> Result<Vec<Option<Receptance>>, ComplianceError> {
        let basis = if self.is_immovable { None } else { self.resisting_motions(ElasticRow::acts)? };
        let Some(basis) = basis else {
            return Ok(vec![None; angular_frequencies.len()]);
        };
        let reduce = |matrix: DMatrix<f64>| basis.tr_mul(&matrix) * &basis;
        let mass = reduce(self.mass.clone());
        let stiffness = reduce(self.sum_of_rows(|row| row.stiffness));
        let lossy = reduce(self.sum_of_rows(|row| row.stiffness * row.loss_factor));
        let damping = reduce(self.sum_of_rows(|row| row.damping));
        let contact = basis.tr_mul(&self.contact);
        let n = contact.len();
        let at = |omega: &f64| {
            let omega = *omega;
            let entry = |r: usize, c: usize| {
                let real = stiffness[(r, c)] - omega * omega * mass[(r, c)];
                Complex::new(real, omega * damping[(r, c)] + lossy[(r, c)])
            };
            // Terms of the diagonal do not cancel in the scale.
            let size = |i: usize| stiffness[(i, i)] + omega * omega * mass[(i, i)] + omega * damping[(i, i)];
            let scale = DVector::from_fn(n, |i, _| 1.0 / size(i).sqrt());
            let matrix = DMatrix::from_fn(n, n, |r, c| entry(r, c) * (scale[r] * scale[c]));
            let force = DVector::from_fn(n, |i, _| Complex::new(contact[i] * scale[i], 0.0));
            let motion = matrix.lu().solve(&force)?;
            let receptance: Complex<f64> = force.iter().zip(motion.iter()).map(|(f, x)| f * x).sum();
            let is_valid = receptance.re.is_finite() && receptance.im.is_finite() && receptance.norm() > 0.0;
            is_valid.then_some(Receptance { angular_frequency: omega, receptance })
        };
        Ok(angular_frequencies.iter().map(at).collect())
    }

    /// Orthonormal basis of the motions with a mass or with a row for which `resists` is true; `None` if another motion closes the gap.
    pub(super) fn resisting_motions(
        &self,
        resists: impl Fn(&ElasticRow) -> bool,
    ) -> Result<Option<DMatrix<f64>>, ComplianceError> {
        let m = self.contact.len();
        let elastic = self.rows_where(resists);
        let masses = self.mass_rows()?;
        let rows = DMatrix::from_fn(masses.nrows() + elastic.nrows(), m, |r, c| {
            match r.checked_sub(masses.nrows()) {
                None => masses[(r, c)],
                Some(r) => elastic[(r, c)],
            }
        });
        let spaces = split(&rows, m, self.floor).ok_or(ComplianceError::Decomposition)?;
        let open = spaces.null.tr_mul(&self.contact).norm();
        Ok((open <= MASSLESS_CLOSING * self.contact.norm()).then_some(spaces.range))
    }

    /// Part of a subspace on which rows act (`range`), and the rest (`null`).
    pub(super) fn acting_part<'r>(
        &self,
        rows: impl Iterator<Item = &'r DVector<f64>>,
        subspace: &DMatrix<f64>,
    ) -> Result<Subspaces, ComplianceError> {
        // A part of a row that is rounding of the row does not act.
        let part = |row: &DVector<f64>| {
            let part = subspace.tr_mul(row);
            (part.norm() > self.floor * row.norm()).then_some(part)
        };
        let kept: Vec<DVector<f64>> = rows.filter_map(part).collect();
        let columns = subspace.ncols();
        let matrix = DMatrix::from_fn(kept.len(), columns, |r, c| kept[r][c]);
        let own = split(&matrix, columns, self.floor).ok_or(ComplianceError::Decomposition)?;
        Ok(Subspaces { null: subspace * own.null, range: subspace * own.range })
    }

    /// Directions with a mass, one per row: eigenvectors of M whose eigenvalue is more than rounding.
    fn mass_rows(&self) -> Result<DMatrix<f64>, ComplianceError> {
        let (values, vectors) = symmetric_eigen(&self.mass).ok_or(ComplianceError::Decomposition)?;
        let largest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let kept: Vec<usize> = (0..values.len()).filter(|&i| values[i] > NO_INERTIA * largest).collect();
        Ok(DMatrix::from_fn(kept.len(), values.len(), |r, c| vectors[(c, kept[r])]))
    }
}

/// Eigenvalues in ascending order and eigenvectors (columns) of a symmetric matrix.
pub(super) fn symmetric_eigen(matrix: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let n = matrix.nrows();
    let even = faer::Mat::from_fn(n, n, |r, c| (matrix[(r, c)] + matrix[(c, r)]) / 2.0);
    let eigen = even.self_adjoint_eigen(faer::Side::Lower).ok()?;
    let values = (0..n).map(|i| eigen.S().column_vector()[i]).collect();
    Some((values, DMatrix::from_fn(n, n, |r, c| eigen.U()[(r, c)])))
}
