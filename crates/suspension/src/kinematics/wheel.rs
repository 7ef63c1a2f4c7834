//! Geometry of a wheel at a pose: camber, toe, steering axis, contact point. Definitions of ISO 8855 and SAE J670, in the
//! vehicle's axes; the ground is the horizontal plane through the contact point.

use crate::kinematics::linkage_motion::{LinkageMotion, LinkedPoint};
use crate::limits::MIDDLE_PLANE;
use nalgebra::Vector3;
use percuss_dynamics::{LowestPoint, Pose};
use percuss_mechanism::{JointId, LinkId};

/// Parts of a wheel in the mechanism.
#[derive(Clone, Debug)]
pub(crate) struct WheelParts {
    /// Ending of the names: `_left`, `_right`, or empty for a single side.
    pub side: &'static str,
    /// +1 on the left side of the vehicle and in the middle plane, −1 on the right side.
    pub sign: f64,
    /// Distance of the wheel centre from the middle plane as drawn, m.
    pub offset: f64,
    pub centre: LinkId,
    pub spindle: LinkId,
    pub carrier: LinkId,
    pub spin: JointId,
    /// Radius, m; `None` without a contact patch.
    pub radius: Option<f64>,
}

/// Wheel at a pose.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WheelState {
    /// Wheel centre, m.
    pub centre: Vector3<f64>,
    /// Spin axis, a unit vector that points out of the vehicle.
    pub outward: Vector3<f64>,
    /// Lowest point of the wheel, m.
    pub contact: Option<Vector3<f64>>,
    sign: f64,
}

/// Line about which the wheel carrier turns when it is steered.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SteeringAxis {
    pub point: Vector3<f64>,
    /// Unit vector that points upward.
    pub direction: Vector3<f64>,
}

impl WheelParts {
    /// State of the wheel at a pose.
    pub fn at(&self, pose: &Pose) -> WheelState {
        let centre = pose.link(self.centre).translation;
        let axis = pose.link(self.spindle).vector(pose.mechanism().joint(self.spin).axis());
        let outward = if axis.y * self.sign < 0.0 { -axis } else { axis };
        let contact = self.radius.and_then(|radius| LowestPoint::of_circle(&centre, &outward, radius));
        WheelState { centre, outward, contact, sign: self.sign }
    }

    /// True for a wheel in the middle plane of the vehicle.
    pub fn is_in_middle(&self) -> bool {
        self.offset <= MIDDLE_PLANE
    }

    /// Point that moves with the wheel carrier.
    pub fn on_wheel(&self, at: Vector3<f64>) -> LinkedPoint {
        (Some(self.spindle), at)
    }
}

impl WheelState {
    /// Camber, rad; positive: the top leans outward.
    pub fn camber(&self) -> f64 {
        -self.outward.z.asin()
    }

    /// Toe, rad; positive: the front of the wheel points to the middle plane of the vehicle.
    pub fn toe(&self) -> f64 {
        self.outward.x.atan2(self.sign * self.outward.y)
    }

    /// Rates of camber and toe at an angular velocity of the wheel carrier.
    pub fn angle_rates(&self, angular_velocity: &Vector3<f64>) -> [f64; 2] {
        let (s, rate) = (self.outward, angular_velocity.cross(&self.outward));
        let horizontal = s.x * s.x + s.y * s.y;
        [-rate.z / horizontal.sqrt(), self.sign * (rate.x * s.y - s.x * rate.y) / horizontal]
    }

    /// Distance of a point from the middle plane of the vehicle, m.
    pub fn lateral(&self, at: &Vector3<f64>) -> f64 {
        self.sign * at.y
    }

    /// Caster and kingpin inclination, rad. Caster is positive if the top of the axis leans backward, the inclination if it
    /// leans to the middle plane.
    pub fn steering_angles(&self, axis: &SteeringAxis) -> [f64; 2] {
        let k = axis.direction;
        [(-k.x).atan2(k.z), (-self.sign * k.y).atan2(k.z)]
    }

    /// Scrub radius and mechanical trail, m, in the directions of the wheel's plane on the ground. The radius is positive
    /// if the axis meets the ground inside of the contact point, the trail if in front of the contact point.
    pub fn ground_offsets(&self, axis: &SteeringAxis) -> Option<[f64; 2]> {
        let contact = self.contact?;
        let on_ground = axis.point + axis.direction * ((contact.z - axis.point.z) / axis.direction.z);
        let offset = on_ground - contact;
        let outward = Vector3::new(self.outward.x, self.outward.y, 0.0).normalize();
        let forward = self.sign * outward.cross(&Vector3::z());
        Some([-offset.dot(&outward), offset.dot(&forward)])
    }

    /// Velocity of the contact point, as a point of the wheel carrier.
    pub fn contact_velocity(&self, parts: &WheelParts, motion: &LinkageMotion<'_>) -> Option<Vector3<f64>> {
        Some(motion.velocity(parts.on_wheel(self.contact?)))
    }
}

impl SteeringAxis {
    /// Axis through two points; `None` if they coincide, or if the axis is horizontal.
    pub fn through(first: Vector3<f64>, second: Vector3<f64>) -> Option<Self> {
        Self::along(first, second - first)
    }

    /// Axis through a point along a direction.
    pub fn along(point: Vector3<f64>, direction: Vector3<f64>) -> Option<Self> {
        let direction = direction.try_normalize(0.0)?;
        let direction = if direction.z < 0.0 { -direction } else { direction };
        (direction.z > 0.0 && direction.iter().all(|x| x.is_finite())).then_some(Self { point, direction })
    }
}

/// Reason for the absence of a quantity of the contact point.
pub(crate) fn no_radius() -> String {
    "no contact point: wheel.radius is missing in the sheet".to_owned()
}
