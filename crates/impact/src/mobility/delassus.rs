//! Delassus matrix of a list of contacts.

use crate::group_rows::GroupRows;
use crate::mobility::semidefinite::{SemidefiniteSolver, unit_diagonal_scale};
use crate::motion::driver_rates::{kernel, lengths};
use crate::motion::joint_rates::JointRates;
use crate::tolerances::{MASSLESS_ENERGY, MASSLESS_RESPONSE, SPEED_ROUNDING, UNMOVED};
use faer::{Mat, Side};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use percuss_dynamics::{Contact, Direction, EffectiveMass, Frame, LocatedContact, Pose};
use percuss_spatial::plane_basis;

/// Error of a Delassus matrix.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DelassusError {
    /// A motion without mass moves a contact point.
    #[error(
        "contact number {contact} (from 1): a motion without mass moves the point, so it transmits no impulse"
    )]
    Massless {
        /// Number of the contact, from 1.
        contact: usize,
    },
    /// The eigenvalues of the mass matrix could not be computed.
    #[error("the eigenvalues of the mass matrix over the admissible motions could not be computed")]
    Eigenvalues,
}

/// Delassus matrix W = J N K⁻¹ Nᵀ Jᵀ of a list of contacts at a pose: change of the relative velocities of all contact points
/// per impulse.
///
/// N is a basis of ker A and K = NᵀMN. Each contact has three rows: the opening speed along −n̂, and the two tangential speeds
/// of the contact link relative to the other side. An impulse has the same components; it acts on the contact link, and the
/// opposite on the other side. The first diagonal entry of a contact is 1/m̄. The rows of a moment are the components of the relative
/// angular velocity along −â and two perpendicular axes; its block is in 1/(kg·m²).
///
/// | symbol | meaning                                    | shape  | unit  |
/// |--------|--------------------------------------------|--------|-------|
/// | W      | relative velocity per impulse              | 3k×3k  | 1/kg  |
/// | J      | relative velocity per coordinate rate      | 3k×n   | m, 1  |
///
/// The normal rows of J and W of an immovable contact ([`EffectiveMass::Immovable`]) are zero, without rounding.
///
/// W is symmetric and positive semi-definite; it is singular if the contacts constrain each other. Cost: O(n³). Sources:
/// Delassus 1917; Khatib 1987 for one link.
#[derive(Clone, Debug)]
pub struct Delassus {
    matrix: DMatrix<f64>,
    jacobian: DMatrix<f64>,
    responses: DMatrix<f64>,
    axes: Vec<Matrix3<f64>>,
}

impl Delassus {
    /// Delassus matrix of `contacts`.
    ///
    /// # Errors
    /// [`DelassusError`].
    pub fn new(pose: &Pose, contacts: &[LocatedContact]) -> Result<Self, DelassusError> {
        let coordinates = pose.coordinate_joints();
        let (n, rows) = (coordinates.len(), 3 * contacts.len());
        let lengths = lengths(pose, &coordinates);
        let mut jacobian = DMatrix::zeros(rows, n);
        let mut axes = Vec::with_capacity(contacts.len());
        for (number, contact) in contacts.iter().enumerate() {
            let own = contact_axes(pose, contact);
            let relative = own.transpose() * relative_jacobian(pose, contact);
            jacobian.rows_mut(3 * number, 3).copy_from(&relative);
            if is_immovable(pose, contact) {
                jacobian.row_mut(3 * number).fill(0.0);
            }
            axes.push(own);
        }
        let groups: Vec<GroupRows> = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
        let kernel = kernel(&groups, &lengths);
        let mass = pose.mass_matrix();
        let scaled = Mat::from_fn(n, n, |r, c| mass[(r, c)] / (lengths[r] * lengths[c]));
        let reduced = kernel.transpose() * scaled * &kernel;
        let moved = Mat::from_fn(rows, n, |r, c| jacobian[(r, c)] / lengths[c]) * &kernel;
        let inverse = inverse_response(&reduced, &moved)?;
        // Rates per impulse: N K⁻¹ (J N)ᵀ, from scaled to plain coordinates.
        let of_kernel = &kernel * &inverse;
        let responses = DMatrix::from_fn(n, rows, |c, r| of_kernel[(c, r)] / lengths[c]);
        let product = &moved * &inverse;
        let matrix = DMatrix::from_fn(rows, rows, |r, c| 0.5 * (product[(r, c)] + product[(c, r)]));
        Ok(Self { matrix, jacobian, responses, axes })
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        self.axes.len()
    }

    /// W, 1/kg.
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.matrix
    }

    /// J over the coordinates of the pose.
    pub fn jacobian(&self) -> &DMatrix<f64> {
        &self.jacobian
    }

    /// Change of the coordinate rates per impulse, N K⁻¹ Nᵀ Jᵀ.
    pub fn responses(&self) -> &DMatrix<f64> {
        &self.responses
    }

    /// Axes of the components at a contact as columns, in root axes: −n̂ and two tangents.
    ///
    /// # Panics
    /// If the contact does not exist.
    pub fn axes(&self, contact: usize) -> &Matrix3<f64> {
        &self.axes[contact]
    }

    /// Block of one contact, 3×3.
    ///
    /// # Panics
    /// If the contact does not exist.
    pub fn block(&self, contact: usize) -> Matrix3<f64> {
        self.matrix.fixed_view::<3, 3>(3 * contact, 3 * contact).into_owned()
    }

    /// W over the normal rows, k×k.
    pub fn normal_matrix(&self) -> DMatrix<f64> {
        let k = self.contacts();
        DMatrix::from_fn(k, k, |r, c| self.matrix[(3 * r, 3 * c)])
    }

    /// Relative velocities of the contact points at given rates, J q̇. A component that is rounding of its terms is zero.
    pub fn velocities(&self, pose: &Pose, rates: &JointRates) -> DVector<f64> {
        let rates = DVector::from_vec(rates.coordinates(pose));
        let size = |contact: usize| -> f64 {
            let columns = self.jacobian.rows(3 * contact, 3);
            columns.column_iter().zip(rates.iter()).map(|(column, rate)| column.norm() * rate.abs()).sum()
        };
        let sizes: Vec<f64> = (0..self.contacts()).map(size).collect();
        let mut velocities = &self.jacobian * rates;
        for (row, velocity) in velocities.iter_mut().enumerate() {
            if velocity.abs() <= SPEED_ROUNDING * sizes[row / 3] {
                *velocity = 0.0;
            }
        }
        velocities
    }

    /// Change of all joint rates by impulses at the contacts.
    pub fn rate_change(&self, pose: &Pose, impulses: &DVector<f64>) -> JointRates {
        let change = &self.responses * impulses;
        let (joints, base) = pose.joint_velocities(change.as_slice());
        JointRates { joints, base }
    }

    /// Adds a free body of mass `mass` (kg) as the other side of a contact, which must not be a moment. The body does not rotate.
    ///
    /// # Panics
    /// If the contact does not exist.
    pub fn add_free_body(&mut self, contact: usize, mass: f64) {
        for k in 0..3 {
            self.matrix[(3 * contact + k, 3 * contact + k)] += 1.0 / mass;
        }
    }

    /// Orthonormal tangential directions in which a contact can move, as components along both tangents.
    pub(crate) fn movable_tangents(&self, contact: usize) -> Vec<DVector<f64>> {
        let tangential = self.block(contact).view((1, 1), (2, 2)).clone_owned();
        let tangential = DMatrix::from_column_slice(2, 2, tangential.as_slice());
        SemidefiniteSolver::within(tangential, self.mobility_size(contact)).movable_directions().collect()
    }

    /// Size of the mobility of a contact. If the whole block is rounding, an upper bound of it.
    fn mobility_size(&self, contact: usize) -> f64 {
        let unmoved = UNMOVED * UNMOVED / MASSLESS_RESPONSE;
        self.block(contact).norm().max(unmoved * self.matrix.diagonal().amax())
    }

    /// Principal masses of a contact point, kg, in ascending order, with their directions in root axes: reciprocals and
    /// eigenvectors of the block. A direction in which the point cannot move has an infinite mass. For a moment: principal inertias, kg·m².
    ///
    /// # Panics
    /// If the contact does not exist.
    pub fn principal_masses(&self, contact: usize) -> [(f64, Vector3<f64>); 3] {
        let eigen = self.block(contact).symmetric_eigen();
        let least = MASSLESS_RESPONSE * self.mobility_size(contact);
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        order.map(|k| {
            let value = eigen.eigenvalues[k];
            let mass = if value > least { 1.0 / value } else { f64::INFINITY };
            (mass, self.axes[contact] * eigen.eigenvectors.column(k))
        })
    }
}

/// True if no admissible motion closes the gap.
fn is_immovable(pose: &Pose, contact: &LocatedContact) -> bool {
    let LocatedContact { link, against, point_link: point, normal_link, is_moment, .. } = *contact;
    let direction = if is_moment { Direction::About } else { Direction::Along };
    let contact = Contact { link, against, point, normal: direction(normal_link, Frame::Link) };
    pose.respond(&contact).is_ok_and(|response| response.effective_mass == EffectiveMass::Immovable)
}

/// Axes of a contact as columns, in root axes: −n̂ and two tangents.
pub(crate) fn contact_axes(pose: &Pose, contact: &LocatedContact) -> Matrix3<f64> {
    let normal = pose.link_in_root(contact.link).vector(&contact.normal_link);
    let (t1, t2) = plane_basis(&normal);
    Matrix3::from_columns(&[-normal, t1, t2])
}

/// Velocity of the contact link relative to the other side at the contact point, per coordinate rate, root axes. For a moment: relative
/// angular velocity.
pub(crate) fn relative_jacobian(pose: &Pose, contact: &LocatedContact) -> DMatrix<f64> {
    if contact.is_moment {
        let own = pose.angular_jacobian(contact.link);
        return contact.against.map_or(own.clone(), |against| own - pose.angular_jacobian(against));
    }
    let mut jacobian = pose.point_jacobian(contact.link, &contact.point_link);
    if let Some(against) = contact.against {
        let at = pose.link_in_root(contact.link).point(&contact.point_link);
        let point = pose.link_in_root(against).inverse_point(&at);
        jacobian -= pose.point_jacobian(against, &point);
    }
    jacobian
}

/// K⁻¹ Cᵀ for the rows C = J N. Motions without mass that move no contact point are left out.
fn inverse_response(reduced: &Mat<f64>, moved: &Mat<f64>) -> Result<Mat<f64>, DelassusError> {
    let d = reduced.nrows();
    if d == 0 {
        return Ok(Mat::zeros(0, moved.nrows()));
    }
    let scale = unit_diagonal_scale(&(0..d).map(|k| reduced[(k, k)]).collect::<Vec<f64>>());
    let even = Mat::from_fn(d, d, |r, c| scale[r] * scale[c] * 0.5 * (reduced[(r, c)] + reduced[(c, r)]));
    let right = Mat::from_fn(d, moved.nrows(), |k, r| scale[k] * moved[(r, k)]);
    let eigen = even.self_adjoint_eigen(Side::Lower).map_err(|_| DelassusError::Eigenvalues)?;
    let (vectors, values) = (eigen.U(), eigen.S().column_vector());
    let least = (0..d).map(|k| values[k]).fold(f64::INFINITY, f64::min);
    if least > MASSLESS_ENERGY
        && let Ok(cholesky) = even.llt(Side::Lower)
    {
        use faer::linalg::solvers::Solve;
        let solution = cholesky.solve(&right);
        return Ok(Mat::from_fn(d, moved.nrows(), |k, r| scale[k] * solution[(k, r)]));
    }
    let mut weights = vectors.transpose() * &right;
    for k in 0..d {
        let is_massless = values[k] <= MASSLESS_ENERGY;
        for r in 0..moved.nrows() {
            let size = (0..d).map(|i| right[(i, r)].abs()).fold(0.0, f64::max);
            if is_massless && weights[(k, r)].abs() > MASSLESS_RESPONSE.sqrt() * size {
                return Err(DelassusError::Massless { contact: r / 3 + 1 });
            }
            weights[(k, r)] = if is_massless { 0.0 } else { weights[(k, r)] / values[k] };
        }
    }
    let solution = vectors * &weights;
    Ok(Mat::from_fn(d, moved.nrows(), |k, r| scale[k] * solution[(k, r)]))
}
