//! Points of links that keep their world positions during a search.

use crate::ranges::extreme_question::KeptPoint;
use nalgebra::{DVector, Vector3};
use percuss_dynamics::Pose;
use percuss_mechanism::LinkId;

/// Scalar conditions of kept points: one per direction.
#[derive(Clone, Debug, Default)]
pub(super) struct KeptRows {
    rows: Vec<KeptRow>,
    /// Characteristic length of the mechanism, m.
    size: f64,
}

/// Kept coordinate of a point along a direction.
#[derive(Clone, Debug)]
struct KeptRow {
    link: LinkId,
    /// Point in the frame of the link, m.
    point: Vector3<f64>,
    /// Unit vector, root axes.
    direction: Vector3<f64>,
    /// Coordinate of the point along the direction, m.
    target: f64,
}

impl KeptRows {
    /// Conditions that keep the points at their positions in a pose.
    pub fn new(pose: &Pose, kept: &[KeptPoint]) -> Self {
        let mut rows = Vec::new();
        for kept in kept {
            let place = pose.link_in_root(kept.link).point(&kept.point);
            let directions = match kept.normal {
                Some(normal) => vec![pose.base().inverse_vector(&normal.normalize())],
                None => vec![Vector3::x(), Vector3::y(), Vector3::z()],
            };
            rows.extend(directions.into_iter().map(|direction| KeptRow {
                link: kept.link,
                point: kept.point,
                direction,
                target: direction.dot(&place),
            }));
        }
        Self { rows, size: pose.mechanism().characteristic_length() }
    }

    /// True without conditions.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Coordinate minus target of each condition, divided by the characteristic length.
    pub fn residuals(&self, pose: &Pose) -> DVector<f64> {
        let residual = |row: &KeptRow| {
            let place = pose.link_in_root(row.link).point(&row.point);
            (row.direction.dot(&place) - row.target) / self.size
        };
        DVector::from_iterator(self.rows.len(), self.rows.iter().map(residual))
    }

    /// Largest magnitude of coordinate minus target, m; 0 without conditions.
    pub fn largest_error(&self, pose: &Pose) -> f64 {
        if self.is_empty() { 0.0 } else { self.size * self.residuals(pose).amax() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use percuss_dynamics::{Conditions, System};
    use percuss_oracle::zoo;

    /// The error of a kept point is its displacement in metres, for every size of the mechanism.
    #[test]
    fn the_largest_error_is_a_displacement() {
        for length in [0.05, 20.0] {
            let system =
                System::new(zoo::point_mass_pendulum(2.0, length), &Conditions::new()).expect("fits");
            let mechanism = system.mechanism();
            let link = *mechanism.order().last().expect("links");
            let at = |angle: f64| {
                let mut configuration = system.configuration();
                configuration.set(mechanism.joints()[0].name(), &[angle]).expect("a hinge");
                system.pose(&configuration).expect("a tree")
            };
            let point = Vector3::new(0.3, 0.2, 0.5) * length;
            let kept = KeptRows::new(&at(0.1), &[KeptPoint { link, point, normal: None }]);
            let place = |angle| at(angle).link_in_root(link).point(&point);
            let expected = (place(0.9) - place(0.1)).amax();
            assert!((kept.largest_error(&at(0.9)) / expected - 1.0).abs() < 1e-12, "{length}");
            assert_eq!(kept.largest_error(&at(0.1)), 0.0);
        }
    }
}
