//! Inverse operational inertia Φ: response of one or two links to any wrench at a point.

use crate::analysis::pose::Pose;
use crate::kinematics::contact::LocatedContact;
use crate::kinematics::outcome::RouteError;
use crate::model::input::foreign_link;
use crate::recursion::{Pivoting, Recursion};
use nalgebra::{SMatrix, SVector, Vector3};
use percuss_spatial::Wrench;

/// Inverse operational inertia Φ = J M_c⁻¹ Jᵀ of one link, or of two links, at a point. M_c⁻¹ is the inverse mass
/// matrix under the constraints. Φ is 12×12: the six components of the contact link (moment, then force), then those
/// of the other link, in root axes with the origin at the point.
///
/// For every contact at the point, 1/m̄ = wᵀΦw with w = (0, n̂, 0, −n̂); for a moment, w = (â, 0, −â, 0). Khatib 1987 calls the inverse
/// of the upper left block the operational space inertia.
#[derive(Clone, Debug)]
pub struct InverseOperationalInertia {
    matrix: SMatrix<f64, 12, 12>,
}

impl InverseOperationalInertia {
    /// The 12×12 matrix (1/(kg·m²), 1/(kg·m), 1/kg by blocks). For the ground, the part of the other link is zero.
    pub fn matrix(&self) -> &SMatrix<f64, 12, 12> {
        &self.matrix
    }

    /// 1/m̄ along the unit normal n̂ (root axes, out of the contact link), 1/kg.
    pub fn inverse_effective_mass(&self, normal: &Vector3<f64>) -> f64 {
        let mut w = SVector::<f64, 12>::zeros();
        w.fixed_rows_mut::<3>(3).copy_from(normal);
        w.fixed_rows_mut::<3>(9).copy_from(&-normal);
        (w.transpose() * self.matrix * w)[0]
    }
}

impl Pose {
    /// Φ of the two sides of a contact at its point, including loops, mimics and held contacts. Method: the recursion
    /// with six unit wrenches per side. Cost: O(n).
    ///
    /// # Errors
    /// [`RouteError`]: a motion without mass responds to a wrench at the point; a motion of negative mass; a cluster
    /// of bodies that is too large.
    pub fn inverse_operational_inertia(
        &self,
        contact: &LocatedContact,
    ) -> Result<InverseOperationalInertia, RouteError> {
        let model = self.assembly.model();
        let links = model.mechanism.links().len();
        if let Some(index) =
            foreign_link(&model.mechanism, [Some(contact.link), contact.against].into_iter().flatten())
        {
            return Err(RouteError::ForeignLink { index, links });
        }
        model.refuse_large_clusters(&self.groups)?;
        let mut recursion = Recursion::<12>::new(model);
        let mut deciding = Pivoting::<12>::new(model);
        let sides = [Some(contact.link), contact.against];
        for (side, link) in sides.into_iter().enumerate() {
            let body = link.and_then(|link| model.body_of(link));
            for axis in 0..3 {
                let mut unit = Vector3::zeros();
                unit[axis] = 1.0;
                recursion.add_wrench(body, 6 * side + axis, Wrench::new(unit, Vector3::zeros()));
                recursion.add_wrench(body, 6 * side + 3 + axis, Wrench::new(Vector3::zeros(), unit));
            }
        }
        recursion.eliminate(model, &self.kinematics, &self.groups, &contact.point_root, &mut deciding);
        if deciding.indefinite {
            return Err(RouteError::Indefinite);
        }
        if deciding.massless.contains(&true) {
            return Err(RouteError::MasslessMotion);
        }
        let matrix = SMatrix::from_fn(|a, b| recursion.response(a, b));
        Ok(InverseOperationalInertia { matrix })
    }
}
