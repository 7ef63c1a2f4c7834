//! Parts of a suspension in its mechanism: wheels, steering axis, springs and stops.

use crate::Understood;
use crate::kinematics::force_element::{ForceElement, force_elements};
use crate::kinematics::linkage_motion::{Linkage, LinkageMotion, MotionError, MotionRow};
use crate::kinematics::loads::AntiRollBar;
use crate::kinematics::wheel::{SteeringAxis, WheelParts};
use crate::kinematics::wheel_points::{RACK, SIDES};
use nalgebra::Vector3;
use percuss_dynamics::{Conditions, Pose, System};
use percuss_mechanism::{JointId, LinkId, Mechanism};

/// Mechanism without a wheel that the kinematics can follow.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the model has no {missing}: the kinematics need a wheel on a spin joint")]
pub struct MissingWheel {
    /// Missing link or joint.
    pub missing: String,
}

/// Parts of a suspension in its mechanism.
#[derive(Debug)]
pub struct SuspensionParts {
    /// Pose as drawn.
    pub(super) drawn: Pose,
    pub(super) wheels: Vec<WheelParts>,
    /// True if both wheels are on one rigid axle.
    pub(super) solid_axle: bool,
    /// Springs, torsion bars, dampers and stops.
    pub elements: Vec<ForceElement>,
    /// Keys of masses that are missing in the sheet.
    pub(super) missing_masses: Vec<String>,
    /// Reason for the absence of the wheel rate, if no spring has a rate.
    pub(super) missing_rate: &'static str,
    pub(super) anti_roll_bar: Option<AntiRollBar>,
    /// Joint of the rack, fixed or sliding.
    pub rack: Option<JointId>,
    /// Travel of the rack per turn of the steering wheel, m.
    pub(super) rack_travel: Option<f64>,
    /// Two points of the steering axis of each wheel, m, in the frames of their links; empty without such points.
    steering_points: Vec<[(LinkId, Vector3<f64>); 2]>,
}

impl SuspensionParts {
    /// Finds the parts in the mechanism of the pose as drawn. `origin`: summary of the file of the suspension.
    ///
    /// # Errors
    /// [`MissingWheel`]: no link of a wheel centre, or no joint of its spin.
    pub fn new(drawn: Pose, origin: &Understood) -> Result<Self, MissingWheel> {
        let mechanism = &**drawn.mechanism();
        let rack = mechanism.joint_named(RACK);
        let wheels = wheels(mechanism, &drawn)?;
        let mut steering_points = Vec::new();
        for wheel in &wheels {
            let point = |(link, at): &(String, [f64; 3])| {
                let name = format!("{link}{}", wheel.side);
                let link = mechanism.find_link(&name).or_else(|_| mechanism.find_link(link)).ok()?;
                let at = Vector3::new(at[0], wheel.sign * at[1], at[2]);
                Some((link, drawn.link(link).inverse_point(&at)))
            };
            let axis = if wheel.sign < 0.0 { &origin.right_steering_axis } else { &origin.steering_axis };
            let points: Vec<_> = axis.iter().filter_map(point).collect();
            steering_points.extend(<[_; 2]>::try_from(points).ok());
        }
        let elements = force_elements(mechanism, &drawn, &wheels, &origin.forces);
        let has_spring = elements.iter().any(ForceElement::is_spring);
        let missing_rate = match (has_spring, origin.forces.springs.is_empty()) {
            (true, _) => "spring.rate is missing in the sheet",
            (false, true) => {
                "the points of the spring (spring_seat, spring_chassis_seat) and spring.rate are missing in the sheet"
            }
            (false, false) => {
                "the sheet has spring.rate, and the points of the spring are missing: spring_seat, spring_chassis_seat (of a coil-over: \
                 those of the damper)"
            }
        };
        let mut parts = Self {
            wheels,
            solid_axle: origin.axle,
            elements,
            missing_masses: origin.missing_masses.clone(),
            missing_rate,
            anti_roll_bar: origin
                .forces
                .anti_roll_bar
                .and_then(|stiffness| AntiRollBar::of_suspension(mechanism, stiffness)),
            rack,
            rack_travel: origin.rack_travel,
            steering_points,
            drawn,
        };
        parts.orient_torsion_bars();
        Ok(parts)
    }

    /// Sets the sign of the torsion bars by the motion of all wheels up, as drawn. Without this motion no quantity has a value.
    fn orient_torsion_bars(&mut self) {
        let mut elements = std::mem::take(&mut self.elements);
        if elements.iter().any(ForceElement::is_torsion_bar)
            && let Ok(linkage) = Linkage::new(&self.drawn)
            && let Ok(bump) = self.wheel_motion(&linkage, &self.drawn, &vec![1.0; self.wheels.len()])
        {
            elements.iter_mut().for_each(|element| element.orient(&self.drawn, &bump));
        }
        self.elements = elements;
    }

    /// Motion of the linkage with a rate of each wheel centre upward; wheels do not spin relative to their carriers, and
    /// the rack stays.
    pub(super) fn wheel_motion<'l>(
        &self,
        linkage: &'l Linkage,
        pose: &Pose,
        rates: &[f64],
    ) -> Result<LinkageMotion<'l>, MotionError> {
        let mut conditions = self.held_joints(linkage, pose, 0.0);
        for (wheel, rate) in self.wheels.iter().zip(rates) {
            let centre = pose.link(wheel.centre).translation;
            conditions.push((linkage.point_row(wheel.on_wheel(centre), Vector3::z()), *rate));
        }
        linkage.solve(&conditions)
    }

    /// Conditions of the bearings of the wheels and of the rack.
    pub(super) fn held_joints(
        &self,
        linkage: &Linkage,
        pose: &Pose,
        rack_rate: f64,
    ) -> Vec<(MotionRow, f64)> {
        let mechanism = &**self.drawn.mechanism();
        let mut conditions = Vec::new();
        for wheel in &self.wheels {
            let axis = pose.link(wheel.spindle).vector(mechanism.joint(wheel.spin).axis());
            conditions.push((linkage.turn_row(wheel.carrier, wheel.spindle, axis), 0.0));
        }
        if let Some(rack) = self.rack {
            let link = mechanism.joint(rack).child();
            let row = linkage.point_row((Some(link), pose.link(link).translation), Vector3::y());
            conditions.push((row, rack_rate));
        }
        conditions
    }

    /// Steering axis of a wheel: the line through two ball joints, or the instantaneous axis of the wheel carrier while the
    /// rack moves and the spring (or else the damper, or the torsion bar) keeps its length.
    pub(super) fn steering_axis(
        &self,
        linkage: &Linkage,
        pose: &Pose,
        wheel: usize,
    ) -> Result<SteeringAxis, String> {
        let horizontal = || "no steering axis: the axis is horizontal".to_owned();
        if let Some(points) = self.steering_points.get(wheel) {
            let [first, second] = points.map(|(link, at)| pose.link(link).point(&at));
            return SteeringAxis::through(first, second).ok_or_else(horizontal);
        }
        if self.rack.is_none() {
            return Err("no steering axis: the template has no tie rod".to_owned());
        }
        let mut conditions = self.held_joints(linkage, pose, 1.0);
        for parts in &self.wheels {
            let of_side = || self.elements.iter().filter(|e| e.side == parts.side);
            let held = of_side().filter(|e| e.name == "spring").chain(of_side());
            let Some(held) = held.filter_map(|element| element.hold(linkage, pose)).next() else {
                return Err(
                    "no steering axis: a spring or a damper that keeps its length is required".to_owned()
                );
            };
            conditions.push((held, 0.0));
        }
        let motion = linkage.solve(&conditions).map_err(|error| format!("no steering axis: {error}"))?;
        let parts = &self.wheels[wheel];
        let centre = pose.link(parts.centre).translation;
        let (omega, v) = (motion.angular_velocity(parts.spindle), motion.velocity(parts.on_wheel(centre)));
        let point = centre + omega.cross(&v) / omega.norm_squared();
        SteeringAxis::along(point, omega).ok_or_else(horizontal)
    }
}

/// Sign of the rotation of the hinge of the torsion bar of a sheet as the wheels move up, as drawn: 1 or −1; `None` without this motion.
pub(crate) fn torsion_sign(mechanism: Mechanism, origin: &Understood) -> Option<f64> {
    let system = System::new(mechanism, &Conditions::new()).ok()?;
    let drawn = system.pose(&system.configuration()).ok()?;
    SuspensionParts::new(drawn, origin).ok()?.elements.iter().find_map(ForceElement::sign)
}

/// Wheels of a mechanism.
fn wheels(mechanism: &Mechanism, drawn: &Pose) -> Result<Vec<WheelParts>, MissingWheel> {
    let mut wheels = Vec::new();
    for side in [""].into_iter().chain(SIDES) {
        let Ok(centre) = mechanism.find_link(&format!("wheel_centre{side}")) else { continue };
        let missing = |missing: String| MissingWheel { missing };
        let name = format!("spin{side}");
        let spin = mechanism.find_joint(&name).map_err(|_| missing(format!("joint \"{name}\"")))?;
        let (spindle, carrier) = (mechanism.joint(spin).child(), mechanism.joint(spin).parent());
        let at = drawn.link(centre).translation;
        let patch = mechanism.find_link(&format!("contact_patch{side}")).ok();
        let radius = patch.map(|patch| (drawn.link(patch).translation - at).norm());
        let sign = if at.y < 0.0 { -1.0 } else { 1.0 };
        wheels.push(WheelParts { side, sign, offset: at.y.abs(), centre, spindle, carrier, spin, radius });
    }
    if wheels.is_empty() {
        return Err(MissingWheel { missing: "link \"wheel_centre\"".to_owned() });
    }
    Ok(wheels)
}
