//! Closing tolerance of a group, relative to its size.

use crate::kinematics::frames::Kinematics;
use crate::model::{Group, Model};
use crate::tolerances::{CLOSED, MOST_FLOOR, RANK_FLOOR, ROUNDED};
use percuss_mechanism::JointKind;

impl Model {
    /// Residual (m) at which a group counts as closed: a fraction of its size, at least the rounding of distant
    /// positions.
    pub fn closing_tolerance(&self, kinematics: &Kinematics, group: &Group) -> f64 {
        let far = |b: &usize| kinematics.frames[*b].translation.amax();
        let far = group.bodies.iter().map(far).fold(0.0, f64::max);
        // Angles of many turns, and long translations, have fewer digits for the fraction.
        let of_body = |b: &usize| {
            let body = &self.bodies[*b];
            largest_position(body.motion.kind, &kinematics.q[body.q.clone()], group.size)
        };
        let gone = group.bodies.iter().map(of_body).fold(0.0, f64::max);
        (CLOSED * group.size).max(16.0 * f64::EPSILON * far).max(4.0 * f64::EPSILON * gone)
    }

    /// Closing tolerance for loops with a given inexactness (m) at the generic pose, with a margin for other poses.
    pub fn rounded_tolerance(&self, kinematics: &Kinematics, group: &Group, inexactness: f64) -> f64 {
        self.closing_tolerance(kinematics, group).max(ROUNDED * inexactness)
    }
}

/// Largest position of a joint in metres: translations unchanged, angles times the size. Quaternions count as 0.
fn largest_position(kind: JointKind, q: &[f64], size: f64) -> f64 {
    let largest = |q: &[f64]| q.iter().fold(0.0, |most: f64, q| most.max(q.abs()));
    match kind {
        JointKind::Fixed | JointKind::Spherical => 0.0,
        JointKind::Revolute | JointKind::Continuous => size * largest(q),
        JointKind::Prismatic => largest(q),
        JointKind::Planar => largest(&q[..2]).max(size * q[2].abs()),
        // The base has no stored position.
        JointKind::Floating => q.get(..3).map_or(0.0, largest),
    }
}

impl Group {
    /// Threshold for singular values of A relative to the largest, for loops with a given inexactness (m). Smaller
    /// values count as zero.
    pub fn floor_for(&self, inexactness: f64) -> f64 {
        let places = 16.0 * f64::EPSILON * self.far;
        RANK_FLOOR.max(ROUNDED * inexactness.max(places) / self.size).min(MOST_FLOOR)
    }
}

#[cfg(test)]
mod tests {
    use super::largest_position;
    use percuss_mechanism::JointKind;

    #[test]
    fn turns_are_measured_on_the_size_and_slides_are_not() {
        assert_eq!(largest_position(JointKind::Continuous, &[-7.0], 0.01), 0.07);
        assert_eq!(largest_position(JointKind::Prismatic, &[-7.0], 0.01), 7.0);
        assert_eq!(largest_position(JointKind::Prismatic, &[7.0], 100.0), 7.0);
        assert_eq!(largest_position(JointKind::Planar, &[2.0, -3.0, 50.0], 0.1), 5.0);
        assert_eq!(largest_position(JointKind::Floating, &[2.0, -3.0, 1.0, 1.0, 0.0, 0.0, 0.0], 100.0), 3.0);
        assert_eq!(largest_position(JointKind::Floating, &[], 100.0), 0.0);
        assert_eq!(largest_position(JointKind::Spherical, &[1.0, 0.0, 0.0, 0.0], 100.0), 0.0);
    }
}
