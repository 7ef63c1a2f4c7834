//! A rigid body by itself: links that fixed joints hold together.

use crate::contact::Contact;
use crate::outcome::ResponseError;
use crate::pose::Pose;
use nalgebra::Vector3;
use percuss_mechanism::LinkId;

impl Pose {
    /// tr(J M⁻¹ Jᵀ)/3 at the centre of mass of the rigid body that a link belongs to, 1/kg: how readily it gives way,
    /// the mean over all directions. J (3×n) takes the coordinates to the velocity of that point. 0 for the ground.
    ///
    /// # Errors
    /// [`ResponseError`]: a motion without mass that answers a force there.
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
