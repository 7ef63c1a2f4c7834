//! Lowest point of a wheel: a contact point that no body carries.

use crate::analysis::pose::Pose;
use crate::kinematics::contact::Contact;
use crate::kinematics::outcome::{EffectiveMass, ResponseError};
use crate::motion::points::point_velocity::PointVelocity;
use nalgebra::{DVector, Vector3};
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_spatial::Transform;

/// Lowest point of a wheel that turns about a joint axis.
///
/// ```text
/// p = c + r d,   d = (a (a·z) − z) / ‖a (a·z) − z‖
/// ```
///
/// with the centre c, the unit axis a, the upward direction z and the radius r: the distance between the origins of the links
/// `patch` and `centre`, both fixed to the wheel. While the wheel carrier pitches, p is another material point of the wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LowestPoint {
    /// Link with its origin at the wheel centre.
    pub centre: LinkId,
    /// Joint whose axis the wheel turns about.
    pub spin: JointId,
    /// Link with its origin on the tread; the link of the contact.
    pub patch: LinkId,
}

impl LowestPoint {
    /// The lowest point at a pose, m, frame of the link `patch`; `None` if the axis is vertical.
    ///
    /// # Panics
    /// If a link or the joint belongs to another mechanism.
    pub fn at(&self, pose: &Pose) -> Option<Vector3<f64>> {
        self.at_frames(pose.mechanism(), |link| pose.link(link))
    }

    /// The lowest point as for [`at`](Self::at), for given frames of the links in the world.
    pub(in crate::motion) fn at_frames(
        &self,
        mechanism: &Mechanism,
        frame: impl Fn(LinkId) -> Transform<f64>,
    ) -> Option<Vector3<f64>> {
        let patch = frame(self.patch);
        let centre = frame(self.centre).translation;
        let radius = (patch.translation - centre).norm();
        let joint = mechanism.joint(self.spin);
        let axis = frame(joint.child()).vector(joint.axis());
        Some(patch.inverse_point(&Self::of_circle(&centre, &axis, radius)?))
    }

    /// Lowest point of a circle, m: `centre` (m), unit `axis` and `radius` (m); `None` if the axis is vertical.
    pub fn of_circle(centre: &Vector3<f64>, axis: &Vector3<f64>, radius: f64) -> Option<Vector3<f64>> {
        let down = (axis * axis.z - Vector3::z()).try_normalize(f64::EPSILON)?;
        Some(centre + down * radius)
    }

    /// The contact with its point at the lowest point of the pose; unchanged if the axis is vertical.
    pub fn contact_at(&self, pose: &Pose, contact: &Contact) -> Contact {
        Contact { point: self.at(pose).unwrap_or(contact.point), ..*contact }
    }

    /// Rate of m̄, kg/s, due to the motion of the lowest point on its link, in addition to the rate of a point fixed to the
    /// link, for the rates `u` of the coordinates of the pose.
    ///
    /// ```text
    /// dm̄/dt = −2 m̄ n · (ω* × s)
    /// ```
    ///
    /// with the velocity s of the lowest point relative to its link, the unit normal n and the angular velocity ω* of the link,
    /// relative to the other side, in the response v*. Zero for a moment, and unless m̄ is finite and ω* is determined.
    ///
    /// # Errors
    /// [`ResponseError`], as [`Pose::respond`].
    ///
    /// # Panics
    /// If the number of rates differs from the number of coordinates.
    pub fn mass_rate(&self, pose: &Pose, contact: &Contact, u: &[f64]) -> Result<f64, ResponseError> {
        let contact = self.contact_at(pose, contact);
        let response = pose.respond(&contact)?;
        let EffectiveMass::Finite(mass) = response.effective_mass else { return Ok(0.0) };
        if contact.normal.is_moment() {
            return Ok(0.0);
        }
        let Some(slip) = self.slip(pose, &contact.point, u) else { return Ok(0.0) };
        let ahead = contact.point + pose.link(self.patch).inverse_vector(&slip);
        let velocity = |point| match pose.point_velocity(&response, contact.link, point) {
            Some(PointVelocity::Known(velocity)) => Some(pose.base().vector(&velocity)),
            Some(PointVelocity::Undetermined) | None => None,
        };
        let turning = velocity(&ahead).zip(velocity(&contact.point)).map(|(ahead, here)| ahead - here);
        Ok(turning.map_or(0.0, |turning| -2.0 * mass * response.contact.normal_world.dot(&turning)))
    }

    /// Axis of the wheel, a unit vector in world axes.
    fn axis(&self, pose: &Pose) -> Vector3<f64> {
        let joint = pose.mechanism().joint(self.spin);
        pose.link(joint.child()).vector(joint.axis())
    }

    /// Velocity of the lowest point relative to the material point at the same place, m/s, world axes.
    fn slip(&self, pose: &Pose, point: &Vector3<f64>, u: &[f64]) -> Option<Vector3<f64>> {
        let u = DVector::from_column_slice(u);
        let velocity = |link, point: &Vector3<f64>| {
            let root = pose.point_jacobian(link, point) * &u;
            pose.base().vector(&Vector3::new(root[0], root[1], root[2]))
        };
        let joint = pose.mechanism().joint(self.spin);
        let axis = self.axis(pose);
        let axis_rate = velocity(joint.child(), joint.axis()) - velocity(joint.child(), &Vector3::zeros());
        let offset = axis * axis.z - Vector3::z();
        let offset_rate = axis_rate * axis.z + axis * axis_rate.z;
        let down = offset.try_normalize(f64::EPSILON)?;
        let down_rate = (offset_rate - down * down.dot(&offset_rate)) / offset.norm();
        let radius = (pose.link(self.patch).translation - pose.link(self.centre).translation).norm();
        let lowest = velocity(self.centre, &Vector3::zeros()) + down_rate * radius;
        Some(lowest - velocity(self.patch, point))
    }
}
