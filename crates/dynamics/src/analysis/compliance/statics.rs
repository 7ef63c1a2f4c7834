//! Static displacements of a mechanism with bushes under loads.

use super::elements::{ElasticDirection, ElasticRow, ElementMotion, LinearElement};
use super::residual::{solve_positive, stiffness_factor};
use super::response::symmetric_eigen;
use super::subspace::{Subspaces, split};
use super::system::{ComplianceError, ElasticSystem, elastic_rows, stacked};
use crate::kinematics::frames::Kinematics;
use crate::tolerances::{DIFFERENCE_OF_FORCES, IMMOVABLE, IN_BALANCE};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn, Vector3};
use percuss_mechanism::{JointId, LinkId};

/// Force and moment on a link, in axes of the root link.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// The link.
    pub link: LinkId,
    /// Point of the link at which the force acts, m, link frame.
    pub point: Vector3<f64>,
    /// Force, N.
    pub force: Vector3<f64>,
    /// Moment, N·m.
    pub moment: Vector3<f64>,
    /// Axis (unit vector, link frame) and radius (m) of a disc about the point: the force acts at the point of its circumference that is farthest against
    /// the force, such as the contact point of a rolling wheel; with a negative radius at the opposite point. `None`: the force acts at the point.
    pub disc: Option<(Vector3<f64>, f64)>,
}

impl Load {
    /// Force at a point of a link (m, link frame).
    pub fn force(link: LinkId, point: Vector3<f64>, force: Vector3<f64>) -> Self {
        Self { link, point, force, moment: Vector3::zeros(), disc: None }
    }
}

/// Mechanism with bushes whose stiffness is decomposed for loads.
///
/// The displacement u = N z solves (K + G) z = Nᵀ Jᵀ F with the static stiffness K of the rows (without dynamic factors) and the geometric stiffness
/// G of the forces at the pose. It is linear in the loads.
#[derive(Debug)]
pub struct StaticSystem<'s> {
    system: &'s ElasticSystem,
    /// Motions with stiffness, and those without.
    spaces: Subspaces,
    /// Square roots of the inverse diagonal of the stiffness, and the decomposition of the stiffness scaled by them.
    factor: Option<(DVector<f64>, Cholesky<f64, Dyn>)>,
}

/// Small displacement of the links of a mechanism with bushes.
#[derive(Debug)]
pub struct StaticDisplacement<'s> {
    statics: &'s StaticSystem<'s>,
    z: DVector<f64>,
}

impl ElasticSystem {
    /// Decomposes the static stiffness. `resting`: loads at the pose, which keep their direction and their point of the link. With the forces of
    /// the elements and the preloads of the bushes they are in balance with further forces of the bushes: the pose is that of the loaded mechanism.
    ///
    /// ```text
    /// G = −Nᵀ ∂(Q − Bᵀf − Aᵀλ)/∂u N
    /// ```
    ///
    /// Q: loads, forces of the elements and preloads; f: forces of the bushes, along axes that move with the link of the bush; λ: forces of the ideal rows A. The
    /// whole force vanishes at the pose, so that its derivative does not depend on the coordinates; it is found by differences of fourth order.
    ///
    /// # Errors
    /// [`ComplianceError`]: a decomposition that does not converge, forces that are not in balance, an unstable equilibrium.
    pub fn statics(&self, resting: &[Load]) -> Result<StaticSystem<'_>, ComplianceError> {
        let resists = |row: &ElasticRow| row.static_stiffness > 0.0;
        let spaces = split(&self.rows_where(resists), self.contact.len(), self.floor);
        let spaces = spaces.ok_or(ComplianceError::Decomposition)?;
        let mut stiffness = self.sum_of_rows(|row| row.static_stiffness);
        if !resting.is_empty() || self.rows.iter().any(|row| row.force != 0.0) {
            stiffness += self.geometric_stiffness(resting, &[])?;
        }
        let stiffness = spaces.range.tr_mul(&stiffness) * &spaces.range;
        let factor = stiffness_factor(&stiffness);
        if factor.is_none() && !stiffness.is_empty() {
            return Err(ComplianceError::Unstable);
        }
        Ok(StaticSystem { system: self, spaces, factor })
    }

    /// The system with the geometric stiffness G of the forces at the pose, as in [`statics`](Self::statics): in residual compliance, receptance, static
    /// compliance and modes. `held`: joints with one velocity whose drives carry what is left over, such as a steering rack.
    ///
    /// # Errors
    /// [`ComplianceError`]: a decomposition that does not converge, forces that are not in balance.
    pub fn with_geometric_stiffness(
        mut self,
        resting: &[Load],
        held: &[JointId],
    ) -> Result<Self, ComplianceError> {
        if resting.is_empty() && self.rows.iter().all(|row| row.force == 0.0) {
            return Ok(self);
        }
        let geometric = self.geometric_stiffness(resting, held)?;
        let (values, vectors) = symmetric_eigen(&geometric).ok_or(ComplianceError::Decomposition)?;
        let row = |(stiffness, vector): (f64, DVector<f64>)| ElasticRow {
            element: "forces at the pose".to_owned(),
            direction: ElasticDirection::Geometric,
            number: None,
            stiffness,
            static_stiffness: 0.0,
            damping: 0.0,
            loss_factor: 0.0,
            is_moment: false,
            is_rigid: false,
            force: 0.0,
            row: vector,
        };
        let vectors = vectors.column_iter().map(|column| column.into_owned());
        self.rows.extend(values.into_iter().zip(vectors).filter(|(value, _)| *value != 0.0).map(row));
        Ok(self)
    }

    /// Geometric stiffness G over z of the forces at the pose.
    fn geometric_stiffness(
        &self,
        resting: &[Load],
        held: &[JointId],
    ) -> Result<DMatrix<f64>, ComplianceError> {
        let is_bush = |row: &ElasticRow| row.number.is_none();
        let applied = |kinematics: &Kinematics, rows: &[ElasticRow]| {
            let mut force = DVector::zeros(self.basis.nrows());
            for load in resting {
                let [angular, linear] = self.jacobians(kinematics, load);
                force += linear.tr_mul(&load.force) + angular.tr_mul(&load.moment);
            }
            rows.iter().for_each(|row| force.axpy(row.force, &row.row, 1.0));
            force
        };
        let all_rows = |kinematics: &Kinematics| {
            elastic_rows(&self.model, kinematics, Some(&self.kinematics), &self.elements)
        };
        // Forces of the bushes in balance with the others.
        let rows = all_rows(&self.kinematics);
        let mut rest = applied(&self.kinematics, &rows);
        let mut reduced = self.basis.tr_mul(&rest);
        let bushes = self.rows_where(|row| is_bush(row) && row.static_stiffness > 0.0);
        let carried = split(&bushes, self.contact.len(), self.floor).ok_or(ComplianceError::Decomposition)?;
        // Forces of the drives of held joints.
        let drive_rows = |kinematics: &Kinematics| -> Vec<DVector<f64>> {
            let element =
                |joint: &JointId| LinearElement::spring("", ElementMotion::Twist(*joint, None), 0.0);
            let row = |joint: &JointId| Some(self.model.element_row(kinematics, (0, &element(joint)))?.row);
            held.iter().filter_map(row).collect()
        };
        let at_pose = drive_rows(&self.kinematics);
        let open = carried.null.transpose() * self.basis.transpose();
        let reach = &open * stacked(&at_pose, self.basis.nrows()).transpose();
        let drives = solve_positive(&reach.tr_mul(&reach), &-reach.tr_mul(&carried.null.tr_mul(&reduced)));
        let drives = drives.unwrap_or_else(|| DVector::zeros(at_pose.len()));
        for (row, force) in at_pose.iter().zip(drives.iter()) {
            rest.axpy(*force, row, 1.0);
        }
        let size = reduced.norm();
        reduced = self.basis.tr_mul(&rest);
        if carried.null.tr_mul(&reduced).norm() > IN_BALANCE * size {
            return Err(ComplianceError::Unbalanced);
        }
        let of_bushes = self.sum_of_rows(|row| if is_bush(row) { row.static_stiffness } else { 0.0 });
        let of_bushes = carried.range.tr_mul(&of_bushes) * &carried.range;
        let deflection = solve_positive(&of_bushes, &carried.range.tr_mul(&reduced));
        let deflection = &carried.range * deflection.ok_or(ComplianceError::Decomposition)?;
        let deflection = &self.basis * deflection;
        let elastic = |row: &ElasticRow| row.static_stiffness < f64::INFINITY;
        let forces: Vec<f64> = rows
            .iter()
            .map(|row| {
                if is_bush(row) && elastic(row) {
                    row.static_stiffness * row.row.dot(&deflection)
                } else {
                    0.0
                }
            })
            .collect();
        rows.iter().zip(&forces).for_each(|(row, force)| rest.axpy(-force, &row.row, 1.0));
        // Forces of the ideal rows.
        let ideal_rows = |kinematics: &Kinematics, rows: &[ElasticRow]| {
            let loops = self.model.constraint_matrix(kinematics);
            let mut ideal: Vec<DVector<f64>> = loops.row_iter().map(|row| row.transpose()).collect();
            ideal.extend(rows.iter().filter(|row| !elastic(row)).map(|row| row.row.clone()));
            stacked(&ideal, self.basis.nrows())
        };
        let held = ideal_rows(&self.kinematics, &rows);
        let independent = split(&held.transpose(), held.nrows(), self.floor);
        let independent = independent.ok_or(ComplianceError::Decomposition)?.range;
        let held = independent.tr_mul(&held);
        let reactions = solve_positive(&(&held * held.transpose()), &(&held * &rest));
        let reactions = independent * reactions.ok_or(ComplianceError::Decomposition)?;
        let whole_force = |u: &DVector<f64>| {
            let mut kinematics = self.kinematics.clone();
            self.model.advance(&mut kinematics, u.as_slice());
            let rows = all_rows(&kinematics);
            let mut force = applied(&kinematics, &rows);
            rows.iter().zip(&forces).for_each(|(row, f)| force.axpy(-f, &row.row, 1.0));
            drive_rows(&kinematics).iter().zip(drives.iter()).for_each(|(row, f)| force.axpy(*f, row, 1.0));
            force - ideal_rows(&kinematics, &rows).tr_mul(&reactions)
        };
        let step = DIFFERENCE_OF_FORCES * self.model.mechanism.characteristic_length();
        let mut stiffness = DMatrix::zeros(self.contact.len(), self.contact.len());
        for (c, motion) in self.basis.column_iter().enumerate() {
            let difference = |factor: f64| {
                whole_force(&(motion * (factor * step))) - whole_force(&(motion * (-factor * step)))
            };
            let derivative = (difference(1.0) * 8.0 - difference(2.0)) / (12.0 * step);
            stiffness.set_column(c, &-self.basis.tr_mul(&derivative));
        }
        Ok((&stiffness + stiffness.transpose()) / 2.0)
    }

    /// Jacobians of the rotation of the link of a load and of the point at which its force acts, 3×n each, in root axes.
    fn jacobians(&self, kinematics: &Kinematics, load: &Load) -> [DMatrix<f64>; 2] {
        let frame = kinematics.link_frame(&self.model, load.link);
        let on_disc = load.disc.and_then(|(axis, radius)| {
            let (axis, against) = (frame.vector(&axis), -load.force);
            let arm = (against - axis * axis.dot(&against)).try_normalize(0.0)?;
            Some(load.point + frame.inverse_vector(&(arm * radius)))
        });
        let point = on_disc.unwrap_or(load.point);
        let angular = self.model.angular_jacobian(kinematics, load.link);
        [angular, self.model.point_jacobian(kinematics, load.link, &point)]
    }

    /// Rates of a link over z: rotation of the link and translation of one of its points (link frame, m), in root axes, 3×m each.
    fn link_rates(&self, link: LinkId, point: &Vector3<f64>) -> [DMatrix<f64>; 2] {
        let angular = self.model.angular_jacobian(&self.kinematics, link);
        let linear = self.model.point_jacobian(&self.kinematics, link, point);
        [angular * &self.basis, linear * &self.basis]
    }
}

impl StaticSystem<'_> {
    /// Displacement under loads; `None` if a motion without stiffness gives way to them.
    pub fn displacement(&self, loads: &[Load]) -> Option<StaticDisplacement<'_>> {
        let mut force = DVector::zeros(self.system.contact.len());
        let mut size = 0.0;
        for load in loads {
            let [angular, linear] = self.system.jacobians(&self.system.kinematics, load);
            let [angular, linear] = [angular, linear].map(|rates| rates * &self.system.basis);
            force += linear.tr_mul(&load.force) + angular.tr_mul(&load.moment);
            size += linear.norm() * load.force.norm() + angular.norm() * load.moment.norm();
        }
        if self.spaces.null.tr_mul(&force).norm() > IMMOVABLE * size {
            return None;
        }
        let reduced = self.spaces.range.tr_mul(&force);
        let z = match &self.factor {
            Some((scale, factor)) => factor.solve(&reduced.component_mul(scale)).component_mul(scale),
            None => reduced,
        };
        Some(StaticDisplacement { statics: self, z: &self.spaces.range * z })
    }
}

impl StaticDisplacement<'_> {
    /// Rotation (rad) of a link and displacement (m) of one of its points (link frame, m), in axes of the root link; `None` if a motion without
    /// stiffness moves the link, so that its place is not determined.
    pub fn of(&self, link: LinkId, point: &Vector3<f64>) -> Option<[Vector3<f64>; 2]> {
        let rates = self.statics.system.link_rates(link, point);
        let is_free =
            |rate: &DMatrix<f64>| (rate * &self.statics.spaces.null).norm() > IMMOVABLE * rate.norm();
        if rates.iter().any(is_free) {
            return None;
        }
        Some(rates.map(|rate| Vector3::from_column_slice((rate * &self.z).as_slice())))
    }
}
