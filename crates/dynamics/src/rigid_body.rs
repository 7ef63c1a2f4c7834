//! A rigid body by itself: links that fixed joints hold together.

use crate::{Contact, Pose, StrikeError, System};
use nalgebra::Vector3;
use percuss_mechanism::LinkId;

impl System {
    /// Mass of the rigid body that a link belongs to, with all that fixed joints hold to it, kg; none for the ground.
    pub fn rigid_body_mass(&self, link: LinkId) -> Option<f64> {
        self.seats.get(link.index())?.body.map(|body| self.bodies[body].inertia.mass)
    }

    /// tr(J M⁻¹ Jᵀ)/3 at the centre of mass of the rigid body that a link belongs to, 1/kg: how readily it gives way,
    /// the mean over all directions. J (3×n) takes the coordinates to the velocity of that point. 0 for the ground.
    ///
    /// # Errors
    /// [`StrikeError`]: mimics, loops, or a mass matrix that is singular to rounding.
    pub fn mean_inverse_mass(&self, pose: &Pose, link: LinkId) -> Result<f64, StrikeError> {
        let seat = &self.seats[link.index()];
        let Some(body) = seat.body.map(|body| &self.bodies[body]) else { return Ok(0.0) };
        let inertia = &body.inertia;
        let centre = if inertia.mass > 0.0 { inertia.first_moment / inertia.mass } else { Vector3::zeros() };
        let at = Contact::new(link, seat.frame.inverse_point(&centre), Vector3::x());
        let response = self.inverse_operational_inertia(pose, &self.locate(pose, &at)?)?;
        Ok((3..6).map(|i| response.matrix()[(i, i)]).sum::<f64>() / 3.0)
    }
}
