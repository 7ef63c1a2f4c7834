//! Mean inverse mass of a rigid body: of links joined by fixed joints.

use crate::analysis::pose::Pose;
use crate::analysis::system::System;
use crate::kinematics::contact::Contact;
use crate::kinematics::outcome::ResponseError;
use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::LinkId;

impl Pose {
    /// Mean inverse mass over all directions at the centre of mass of the rigid body of a link, tr(J M⁻¹ Jᵀ)/3, 1/kg.
    /// J (3×n) maps the coordinates to the velocity of the centre of mass. 0 for the ground.
    ///
    /// # Errors
    /// [`ResponseError`]: a motion without mass responds to a force at the centre of mass.
    pub fn mean_inverse_mass(&self, link: LinkId) -> Result<f64, ResponseError> {
        let model = self.assembly.model();
        let on = &model.link_frames[link.index()];
        let Some(body) = on.body.map(|body| &model.bodies[body]) else { return Ok(0.0) };
        let inertia = &body.inertia;
        let centre = if inertia.mass > 0.0 { inertia.first_moment / inertia.mass } else { Vector3::zeros() };
        let at = Contact::new(link, on.frame.inverse_point(&centre), Vector3::x());
        let response = self.inverse_operational_inertia(&self.locate(&at)?)?;
        Ok((3..6).map(|i| response.matrix()[(i, i)]).sum::<f64>() / 3.0)
    }

    /// Effective mass at a contact of the rigid bodies of its two sides without their joints, kg:
    /// 1/Σ (1/m + (r × n̂)ᵀ I_c⁻¹ (r × n̂)), r from the centre of mass to the point. For a moment: 1/Σ âᵀ I_c⁻¹ â, kg·m². The ground adds
    /// nothing to the sum.
    /// `None` for a body without mass or with a singular rotational inertia, and for an invalid contact.
    pub fn free_body_mass(&self, contact: &Contact) -> Option<f64> {
        let at = self.locate(contact).ok()?;
        let model = self.assembly.model();
        let mut inverse = 0.0;
        for link in [Some(at.link), at.against].into_iter().flatten() {
            let on = &model.link_frames[link.index()];
            let Some(body) = on.body else { continue };
            let inertia = &model.bodies[body].inertia;
            let x_rl = self.kinematics.link_frame(model, link);
            let point = on.frame.point(&x_rl.inverse_point(&at.point_root));
            let normal = on.frame.vector(&x_rl.inverse_vector(&at.normal_root));
            let c = inertia.first_moment / inertia.mass;
            let central = inertia.rotational
                - (Matrix3::identity() * c.norm_squared() - c * c.transpose()) * inertia.mass;
            let moment = if at.is_moment { normal } else { (point - c).cross(&normal) };
            let of_force = if at.is_moment { 0.0 } else { 1.0 / inertia.mass };
            inverse += of_force + moment.dot(&(central.try_inverse()? * moment));
        }
        Some(1.0 / inverse).filter(|mass| mass.is_finite() && *mass > 0.0)
    }
}

impl System {
    /// Number of rigid bodies that move: links that fixed joints hold together count as one.
    pub fn moving_bodies(&self) -> usize {
        self.model().bodies.iter().filter(|body| !body.v.is_empty()).count()
    }
}
