//! Curvature of the motion of an impact, and acceleration of the gap at constant joint rates.

use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::thresholds::CURVATURE_STEP;
use nalgebra::Vector3;
use percuss_dynamics::{Contact, ContactResponse, Pose};
use percuss_mechanism::JointKind;
use percuss_spatial::Twist;

/// Acceleration of the contact point plus the largest acceleration of a centre of mass, at constant joint rates and a
/// closing speed of 1 m/s, 1/m.
///
/// For one hinge: 1/l + r/l², l the distance from the hinge to the contact, r that to the centre of mass. The
/// accelerations are second differences along the motion of the impact v*. `None` if the mechanism cannot follow v*.
pub(crate) fn motion_curvature(evaluated: &EvaluatedQuestion) -> Option<f64> {
    let (pose, response) = (&evaluated.pose, evaluated.result.mechanism_response());
    let (start, ahead) =
        (points(pose, evaluated), points(&pose.advanced_along(response, CURVATURE_STEP)?, evaluated));
    let behind = points(&pose.advanced_along(response, -CURVATURE_STEP)?, evaluated);
    let mut accelerations = start.iter().zip(&ahead).zip(&behind).map(|((start, ahead), behind)| {
        (ahead + behind - 2.0 * start).norm() / (CURVATURE_STEP * CURVATURE_STEP)
    });
    let contact = accelerations.next()?;
    let curvature = contact + accelerations.fold(0.0, f64::max);
    curvature.is_finite().then_some(curvature)
}

/// β: acceleration of the penetration at constant joint rates and a closing speed of 1 m/s, 1/m. It is the second difference of the contact
/// point in the frame of the other side. The constant rates are those of MuJoCo: the linear velocity of a floating joint is along axes of
/// its parent. Loops are not closed after the steps, because closing them would change the rates. `None` if the response does not fit the
/// pose.
pub(crate) fn gap_acceleration(pose: &Pose, response: &ContactResponse, contact: &Contact) -> Option<f64> {
    let normal = response.contact.normal_world;
    let point = |pose: &Pose| {
        let touched = pose.link(contact.link).point(&contact.point);
        contact.against.map_or(touched, |other| pose.link(other).inverse_point(&touched))
    };
    let normal = contact.against.map_or(normal, |other| pose.link(other).inverse_vector(&normal));
    let moved = |step: f64| {
        let without_turn = |w: Vector3<f64>, v: Vector3<f64>| v - w.cross(&v) * (0.5 * step);
        let joints = pose.mechanism().joints().iter().zip(&response.joint_velocities);
        let velocities: Vec<Vec<f64>> = joints
            .map(|(joint, rates)| match (joint.kind(), &rates[..]) {
                (JointKind::Floating, &[a, b, c, x, y, z]) => {
                    let linear = without_turn(Vector3::new(a, b, c), Vector3::new(x, y, z));
                    vec![a, b, c, linear.x, linear.y, linear.z]
                }
                _ => rates.clone(),
            })
            .collect();
        let Twist { angular, linear } = response.base_velocity;
        let base = Twist::new(angular, without_turn(angular, linear));
        Some(point(&pose.advanced(&velocities, &base, step).ok()?))
    };
    let (ahead, behind) = moved(CURVATURE_STEP).zip(moved(-CURVATURE_STEP))?;
    let acceleration = normal.dot(&(ahead + behind - 2.0 * point(pose))) / (CURVATURE_STEP * CURVATURE_STEP);
    acceleration.is_finite().then_some(acceleration)
}

/// Position of the contact point relative to that of the other link, and positions of the centres of mass of all links
/// with mass.
fn points(pose: &Pose, evaluated: &EvaluatedQuestion) -> Vec<Vector3<f64>> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let mut contact = pose.link(evaluated.contact.link).point(&evaluated.contact.point);
    if let Some(against) = evaluated.contact.against {
        let touched = evaluated.pose.link(evaluated.contact.link).point(&evaluated.contact.point);
        contact -= pose.link(against).point(&evaluated.pose.link(against).inverse_point(&touched));
    }
    let massive =
        mechanism.links().iter().zip(mechanism.link_ids()).filter(|(link, _)| link.inertia().mass > 0.0);
    let centres = massive.map(|(link, id)| {
        let inertia = link.inertia();
        pose.link(id).point(&(inertia.first_moment / inertia.mass))
    });
    std::iter::once(contact).chain(centres).collect()
}
