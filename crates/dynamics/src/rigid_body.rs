//! Mean inverse mass of a rigid body: of links joined by fixed joints.

use crate::contact::Contact;
use crate::outcome::ResponseError;
use crate::pose::Pose;
use nalgebra::Vector3;
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
}
