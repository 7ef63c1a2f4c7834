//! Natural frequencies and shapes of a mechanism with elastic bushes.

use super::elements::{ElasticDirection, ElasticRow};
use super::residual::solve_positive;
use super::response::symmetric_eigen;
use super::system::{ComplianceError, ElasticSystem};
use crate::tolerances::{NO_INERTIA, RIGID_MODE};
use nalgebra::{DVector, Vector3};
use percuss_mechanism::LinkId;

/// Natural mode of the undamped mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// ω, rad/s; 0 for a motion without stiffness.
    pub angular_frequency: f64,
    /// φ: closing speed of the contact in the mass-normalised shape, 1/√kg. 1/m_app(ω) = Σ φᵢ² ω²/(ω² − ωᵢ²).
    pub participation: f64,
    /// Modal damping ratio of the dampers and loss factors, to first order: φᵀCφ/(2ω) + Σ ηᵢ Eᵢ/(2 Σ Eᵢ).
    pub damping_ratio: f64,
    /// Links with their shares of the kinetic energy, the largest first.
    pub links: Vec<(LinkId, f64)>,
    /// Rows of elements with their shares of the elastic energy, the largest first; empty for a motion without stiffness.
    pub rows: Vec<(String, ElasticDirection, f64)>,
}

impl ElasticSystem {
    /// Natural modes in ascending order of the frequency. Motions without mass follow the others statically and have no mode. No modes if
    /// the ideal rows leave no motion.
    ///
    /// K φ = ω² M φ. The frequencies are Rayleigh quotients, in which the elastic energy is the sum over the rows: small frequencies beside large
    /// ones keep their digits.
    ///
    /// # Errors
    /// [`ComplianceError`]: a decomposition that does not converge, an equilibrium that the forces at the pose make unstable.
    pub fn modes(&self) -> Result<Vec<Mode>, ComplianceError> {
        if self.contact.is_empty() {
            return Ok(Vec::new());
        }
        let stiffness = self.sum_of_rows(|row| row.stiffness);
        let (masses, vectors) = symmetric_eigen(&self.mass).ok_or(ComplianceError::Decomposition)?;
        let largest = masses.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let with_mass: Vec<usize> = (0..masses.len()).filter(|&i| masses[i] > NO_INERTIA * largest).collect();
        let without: Vec<usize> = (0..masses.len()).filter(|i| !with_mass.contains(i)).collect();
        let mut shapes = vectors.select_columns(&with_mass);
        for (c, &i) in with_mass.iter().enumerate() {
            shapes.column_mut(c).scale_mut(1.0 / masses[i].sqrt());
        }
        // Motions without mass but with stiffness follow: their forces are in balance.
        let elastic_rows = self.rows.iter().filter(|row| row.is_elastic()).map(|row| &row.row);
        let elastic = self.acting_part(elastic_rows, &vectors.select_columns(&without))?.range;
        if elastic.ncols() > 0 {
            let own = elastic.tr_mul(&stiffness) * &elastic;
            let coupling = elastic.tr_mul(&stiffness) * &shapes;
            for c in 0..shapes.ncols() {
                let follows = solve_positive(&own, &coupling.column(c).into_owned())
                    .ok_or(ComplianceError::Decomposition)?;
                let corrected = shapes.column(c) - &elastic * follows;
                shapes.set_column(c, &corrected);
            }
        }
        let reduced = shapes.tr_mul(&stiffness) * &shapes;
        let (_, combinations) = symmetric_eigen(&reduced).ok_or(ComplianceError::Decomposition)?;
        let motions = shapes * combinations;
        let found: Vec<(f64, Mode)> =
            motions.column_iter().map(|motion| self.mode(motion.into_owned())).collect();
        let highest = found.iter().fold(0.0_f64, |most, (_, mode)| most.max(mode.angular_frequency));
        if found.iter().any(|(square, _)| *square < -(RIGID_MODE * highest).powi(2)) {
            return Err(ComplianceError::Unstable);
        }
        let mut modes: Vec<Mode> = found.into_iter().map(|(_, mode)| mode).collect();
        for mode in modes.iter_mut().filter(|mode| mode.angular_frequency <= RIGID_MODE * highest) {
            (mode.angular_frequency, mode.damping_ratio) = (0.0, 0.0);
            mode.rows.clear();
        }
        modes.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
        Ok(modes)
    }

    /// ω² and mode with the shape `motion`, of any size.
    fn mode(&self, motion: DVector<f64>) -> (f64, Mode) {
        let mass = motion.dot(&(&self.mass * &motion));
        let motion = motion / mass.sqrt();
        let energy = |row: &ElasticRow| row.stiffness * row.row.dot(&motion).powi(2);
        let elastic: f64 = self.rows.iter().map(energy).sum();
        let lossy: f64 = self.rows.iter().map(|row| row.loss_factor * energy(row)).sum();
        let damped: f64 = self.rows.iter().map(|row| row.damping * row.row.dot(&motion).powi(2)).sum();
        let omega = elastic.max(0.0).sqrt();
        // Without the geometric stiffness, whose energy may be negative.
        let of_rows: f64 = self.rows.iter().filter(|row| row.is_elastic()).map(energy).sum();
        let share = |row: &ElasticRow| (row.element.clone(), row.direction, energy(row) / of_rows);
        let mut rows: Vec<_> =
            self.rows.iter().filter(|row| row.is_elastic() && energy(row) > 0.0).map(share).collect();
        rows.sort_by(|a, b| b.2.total_cmp(&a.2));
        let mode = Mode {
            angular_frequency: omega,
            participation: self.contact.dot(&motion),
            damping_ratio: damped / (2.0 * omega) + lossy / (2.0 * elastic),
            links: self.link_energies(&motion),
            rows,
        };
        (elastic, mode)
    }

    /// Shares of the links in the kinetic energy of a motion, the largest first.
    fn link_energies(&self, motion: &DVector<f64>) -> Vec<(LinkId, f64)> {
        let velocities = &self.basis * motion;
        let mechanism = &self.model.mechanism;
        let energy = |id: LinkId| {
            let inertial = mechanism.link(id).inertial()?;
            let frame = self.kinematics.link_frame(&self.model, id);
            let turning = self.model.angular_jacobian(&self.kinematics, id) * &velocities;
            let omega = frame.rotation.tr_mul(&Vector3::new(turning[0], turning[1], turning[2]));
            let speed = self.model.point_jacobian(&self.kinematics, id, &inertial.com) * &velocities;
            Some((id, inertial.mass * speed.norm_squared() + omega.dot(&(inertial.about_com * omega))))
        };
        let mut energies: Vec<(LinkId, f64)> = mechanism.link_ids().filter_map(energy).collect();
        let total: f64 = energies.iter().map(|(_, energy)| energy).sum();
        if total > 0.0 {
            energies.iter_mut().for_each(|(_, energy)| *energy /= total);
        }
        energies.sort_by(|a, b| b.1.total_cmp(&a.1));
        energies
    }
}
