//! Curvature of the motion of an impact.

use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::thresholds::CURVATURE_STEP;
use nalgebra::Vector3;
use percuss_dynamics::Pose;

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
