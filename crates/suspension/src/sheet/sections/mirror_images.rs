//! Points of both sides of a vehicle, and their mirror images.

use crate::findings::Spot;
use crate::limits::MIRROR_TOLERANCE;
use percuss_spatial::Vector3;
use std::collections::BTreeMap;

/// Hardpoints by name, m, in the axes of ISO 8855.
pub type Points = BTreeMap<&'static str, (Vector3<f64>, Spot)>;

/// Names of points of the other side that are mirror images. Both lists are points of the left side.
pub fn mirror_images(other: &Points, own: &Points) -> Vec<&'static str> {
    let is_mirror_image = |(name, (at, _)): &(&&'static str, &(Vector3<f64>, Spot))| {
        own.get(**name).is_some_and(|(of_own, _)| (at - of_own).amax() <= MIRROR_TOLERANCE)
    };
    other.iter().filter(is_mirror_image).map(|(name, _)| *name).collect()
}
