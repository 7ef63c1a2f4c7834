//! Velocities of links from differences of poses, independent of Jacobians.

use crate::cases::Case;
use crate::motion::Motion;
use percuss_dynamics::{LocatedContact, Pose};
use percuss_mechanism::LinkId;
use percuss_spatial::{Twist, Vector3};

/// Rotation (rad) of all joints together in the longer step. Central differences with Richardson's extrapolation have a
/// truncation error of step⁴/120 of the velocities and a rounding error of ε/step: 2e-13 and 2e-13.
const STEP: f64 = 2e-3;

/// Relative error of a velocity from differences, with a factor of twenty for the arithmetic of a long chain.
pub const DIFFERENCE: f64 = 1e-11;

/// Derivative at zero of a smooth function of time, with steps adapted to a motion.
pub fn derivative<V>(motion: &Motion, value: impl FnMut(f64) -> V) -> V
where
    V: std::ops::Sub<Output = V> + std::ops::Mul<f64, Output = V>,
{
    derivative_by(STEP / motion.size().max(1e-300), value)
}

/// Derivative at zero of a smooth function: (4 D(h/2) − D(h)) / 3 of central differences D.
pub fn derivative_by<V>(h: f64, mut value: impl FnMut(f64) -> V) -> V
where
    V: std::ops::Sub<Output = V> + std::ops::Mul<f64, Output = V>,
{
    let coarse = (value(h) - value(-h)) * (0.5 / h);
    let fine = (value(h / 2.0) - value(-h / 2.0)) * (1.0 / h);
    fine * (4.0 / 3.0) - coarse * (1.0 / 3.0)
}

/// Second derivative at zero of a function of velocities and duration, along the motion with the joint accelerations
/// `rates`: extrapolated as [`derivative`], with steps five times as long. The error is step⁴/360 and ε/step² of the
/// size of the quantities: some 1e-10.
pub fn second_derivative(
    motion: &Motion,
    rates: &[Vec<f64>],
    value: impl Fn(&[Vec<f64>], f64) -> Vector3<f64>,
) -> Vector3<f64> {
    let speed = motion.size() + rates.iter().flatten().map(|rate| rate.abs().sqrt()).sum::<f64>();
    let h = 5.0 * STEP / speed.max(1e-300);
    // The mean velocity over the duration is the velocity at its middle.
    let at = |h: f64| {
        let mean = |(v, a): (&Vec<f64>, &Vec<f64>)| v.iter().zip(a).map(|(v, a)| v + a * h / 2.0).collect();
        let velocities: Vec<Vec<f64>> = motion.joints.iter().zip(rates).map(mean).collect();
        value(&velocities, h)
    };
    let second = |h: f64| (at(h) - at(0.0) * 2.0 + at(-h)) / (h * h);
    second(h / 2.0) * (4.0 / 3.0) - second(h) * (1.0 / 3.0)
}

/// Twist of a link in its own axes at its origin.
pub fn link_twist(pose: &Pose, motion: &Motion, link: LinkId) -> Twist<f64> {
    let back = pose.link(link).inverse();
    derivative(motion, |h| {
        let later = pose.advanced(&motion.joints, &motion.base, h).expect("velocities that fit");
        let x = back * later.link(link);
        let r = x.rotation;
        let turn = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) / 2.0;
        Twist::new(turn, x.translation)
    })
}

/// Twice the kinetic energy from its definition: m v_c² + ω·I_c ω of every link from differences of poses, and a q̇² of
/// every armature. The second number is the sum of the terms' magnitudes.
pub fn twice_energy(case: &Case, pose: &Pose, motion: &Motion) -> (f64, f64) {
    let (mut sum, mut size) = (0.0, 0.0);
    for (i, twist) in link_twists(pose, motion).iter().enumerate() {
        let Some(inertial) = case.mechanism.links()[i].inertial() else { continue };
        let (omega, v) = (twist.angular, twist.linear + twist.angular.cross(&inertial.com));
        sum += inertial.mass * v.norm_squared() + omega.dot(&(inertial.about_com * omega));
        let reach = twist.linear.norm() + twist.angular.norm() * inertial.com.norm();
        size += inertial.mass * reach * reach + omega.norm_squared() * inertial.about_com.amax();
    }
    for id in case.mechanism.joint_ids() {
        let rates = &motion.joints[id.index()];
        let rotor: f64 = case.armature(id).iter().zip(rates).map(|(a, v)| a * v * v).sum();
        sum += rotor;
        size += rotor;
    }
    (sum, size)
}

/// [`link_twist`] of all links, in their order.
pub fn link_twists(pose: &Pose, motion: &Motion) -> Vec<Twist<f64>> {
    pose.mechanism().link_ids().map(|link| link_twist(pose, motion, link)).collect()
}

/// Closing speed of the gap: n̂ · (velocity of the contact point − velocity of the other side's point at that place).
pub fn closing_speed(pose: &Pose, motion: &Motion, contact: &LocatedContact) -> f64 {
    let velocity = |link: LinkId| {
        let x_wl = pose.link(link);
        let at = x_wl.inverse_point(&contact.point_world);
        x_wl.vector(&link_twist(pose, motion, link).velocity_at(&at))
    };
    let other = contact.against.map_or_else(Vector3::zeros, velocity);
    contact.normal_world.dot(&(velocity(contact.link) - other))
}
