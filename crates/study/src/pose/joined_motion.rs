//! Closing speed of a contact in a motion of given points, such as wheel travel, heave or roll of a suspension.

use crate::thresholds::SPEED_ROUNDING;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_dynamics::{Contact, DeterminedSystem, Pose, Travel};
use percuss_mechanism::{JointId, LinkId};

/// Closing speed of a contact, m/s, if each travel has its rate (m/s) and the joints `held` do not move.
///
/// u solves A u = 0, nᵢ · J_i u = rateᵢ, and J_h u = 0 for the points of the held joints and of the root link; the result is
/// j u. Joints without influence on these rows, such as the spin of a wheel, do not move. `None` if the conditions do not
/// determine the motion. Cost: one QR factorisation of the rows.
pub(crate) fn closing_speed(
    pose: &Pose,
    travels: &[(&Travel, f64)],
    held: &[JointId],
    contact: &Contact,
) -> Option<f64> {
    let closing = pose.contact_row(&pose.locate(contact).ok()?);
    let constraints = pose.constraint_matrix();
    let mut rows: Vec<Vec<f64>> = constraints.row_iter().map(|row| row.iter().copied().collect()).collect();
    let mut rates = vec![0.0; rows.len()];
    let mechanism = pose.mechanism();
    // Links that do not move relative to another link: all three points of a triangle stay.
    let joints = held.iter().map(|joint| mechanism.joint(*joint));
    let pairs = joints.map(|joint| (joint.child(), Some(joint.parent())));
    for (link, against) in pairs.chain([(mechanism.root(), None)]) {
        for point in [Vector3::zeros(), Vector3::x(), Vector3::y()] {
            rows.extend(relative_rows(pose, link, against, point));
            rates.resize(rows.len(), 0.0);
        }
    }
    for (travel, rate) in travels {
        let along = pose.base().inverse_vector(travel.direction()?);
        let jacobian = pose.point_jacobian(travel.link(), travel.point());
        rows.push(jacobian.column_iter().map(|column| along.dot(&column)).collect());
        rates.push(*rate);
    }
    let moves = |column: usize| rows.iter().any(|row| row[column] != 0.0);
    let columns: Vec<usize> = (0..closing.len()).filter(|column| moves(*column)).collect();
    let height = rows.len().max(columns.len());
    let value = |i: usize, k: usize| rows.get(i).map_or(0.0, |row| row[columns[k]]);
    let matrix = DMatrix::from_fn(height, columns.len(), value);
    rates.resize(height, 0.0);
    let motion = DeterminedSystem::new(matrix)?.solve(&DVector::from_vec(rates))?;
    let speed: f64 = columns.iter().zip(motion.iter()).map(|(column, rate)| closing[*column] * rate).sum();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0f64, |most, x| most.max(x.abs()));
    let scale = largest(&mut closing.iter().copied()) * largest(&mut motion.iter().copied());
    // A contact that the motion does not move has rounding errors only.
    Some(if speed.abs() > SPEED_ROUNDING * scale { speed } else { 0.0 })
}

/// Rows of the velocity of a point of a link (m, link's frame) relative to another link.
fn relative_rows(
    pose: &Pose,
    link: LinkId,
    against: Option<LinkId>,
    point: Vector3<f64>,
) -> impl Iterator<Item = Vec<f64>> {
    let mut jacobian = pose.point_jacobian(link, &point);
    if let Some(other) = against {
        let at = pose.link(other).inverse_point(&pose.link(link).point(&point));
        jacobian -= pose.point_jacobian(other, &at);
    }
    (0..3).map(move |i| jacobian.row(i).iter().copied().collect())
}
