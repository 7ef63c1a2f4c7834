//! Warnings about implausible masses and inertias of parts: values in another unit, or about another point.

use super::drawing::rounded;
use crate::findings::{Findings, Spot};
use crate::limits::{
    GYRATION_RADII, LEAST_CARRIER_SIZE, LEAST_DISTANCE_TERM, LIGHT_ROD, MAX_AXLE_MASS, MAX_PART_DENSITY,
    MAX_PART_MASS, MAX_ROD_DENSITY, MIN_PART_SIZE, WHEEL_DENSITIES, WHEEL_GYRATION_RADII,
};
use percuss_mechanism::Inertial;
use percuss_spatial::{Matrix3, Vector3};

/// Part with its inertial data.
pub(super) struct CheckedPart<'a> {
    pub name: &'a str,
    pub inertial: &'a Inertial,
    /// Centre of mass in the vehicle frame, m.
    pub com: Vector3<f64>,
    /// Diagonal of the box around the joints, the seats and the centre of mass, m; the track for an axle.
    pub size: f64,
    /// True if all joints and seats coincide: a wheel hub.
    pub is_hub: bool,
    /// True for a link with two joints and nothing else.
    pub is_rod: bool,
    /// True for an axle or a beam between both wheels.
    pub is_axle: bool,
}

/// Warns about a mass that is too large for the size of the part, and about an inertia about the origin of the vehicle.
pub(super) fn check_part(part: &CheckedPart, spot: &Spot, findings: &mut Findings) {
    let mass = part.inertial.mass;
    let most = match part.is_axle {
        true => MAX_AXLE_MASS,
        false if part.is_rod => LIGHT_ROD.max(MAX_ROD_DENSITY * part.size.powi(3)).min(MAX_PART_MASS),
        false if part.size < MIN_PART_SIZE => MAX_PART_MASS,
        false => MAX_PART_MASS.min(MAX_PART_DENSITY * part.size.powi(3)),
    };
    if mass > most {
        let message = format!(
            "the mass of {} is {mass} kg; it is too large for a part of {} m: check its unit. A mass can state its unit, as in \"850 g\"",
            part.name,
            rounded(part.size)
        );
        findings.warning("implausible-mass", spot, message);
    }
    let gyration = gyration_radius(part.inertial);
    // The coinciding joints of a hub do not give its size, and its inertia includes the inertia of the drive shaft.
    let is_small = part.size >= MIN_PART_SIZE && gyration < *GYRATION_RADII.start() * part.size;
    let is_large = gyration > *GYRATION_RADII.end() * part.size.max(LEAST_CARRIER_SIZE);
    if gyration > 0.0 && !part.is_hub && (is_small || is_large) {
        let message = format!(
            "the radius of gyration of {} is {} m, and its joints and seats are within {} m: check the unit of its inertia",
            part.name,
            rounded(gyration),
            rounded(part.size)
        );
        findings.warning("implausible-gyration", spot, message);
    }
    if is_about_origin(part) {
        let [x, y, z] = [part.com.x, part.com.y, part.com.z].map(rounded);
        let message = format!(
            "the inertia of {} is probably about the origin of the vehicle: I − m (r² 1 − r rᵀ), with r = ({x}, {y}, {z}) m, is still a valid \
             inertia. Give the inertia about the centre of mass, which is probably this difference",
            part.name
        );
        findings.warning("inertia-about-origin", spot, message);
    }
}

/// Root of the mean square distance of the mass from the centre of mass, m: √(tr I / (2 m)).
fn gyration_radius(inertial: &Inertial) -> f64 {
    (0.5 * inertial.about_com.trace() / inertial.mass).sqrt()
}

/// True if the inertia without the term of the distance r to the origin of the vehicle, I − m (r² 1 − r rᵀ), is a valid inertia, and much
/// smaller than this term. If the inertia of a compact part is about its centre of mass, m r² is much larger: the difference is indefinite.
fn is_about_origin(part: &CheckedPart) -> bool {
    let (mass, r) = (part.inertial.mass, part.com);
    let distance_term = mass * (Matrix3::identity() * r.norm_squared() - r * r.transpose());
    let rest = part.inertial.about_com - distance_term;
    let is_far = distance_term.trace() >= LEAST_DISTANCE_TERM * rest.trace();
    // Second moments of the mass: positive semidefinite for a body.
    let second_moments = Matrix3::identity() * (0.5 * rest.trace()) - rest;
    is_far && rest.trace() > 0.0 && second_moments.symmetric_eigenvalues().min() >= 0.0
}

/// Warns about a wheel whose mass or inertia does not fit its radius: one of them is in another unit.
pub(super) fn check_wheel(wheel: &Inertial, radius: f64, spot: &Spot, findings: &mut Findings) {
    let mass = wheel.mass;
    if mass <= 0.0 {
        return;
    }
    let density = mass / radius.powi(3);
    if !WHEEL_DENSITIES.contains(&density) {
        let light = density < *WHEEL_DENSITIES.start();
        let message = format!(
            "the wheel has {mass} kg and a radius of {:.1} mm; no wheel is so {} for its size: check the units of mass and length",
            1e3 * radius,
            if light { "light" } else { "heavy" }
        );
        findings.warning("implausible-wheel", spot, message);
    }
    let gyration = gyration_radius(wheel);
    if gyration > 0.0 && !WHEEL_GYRATION_RADII.contains(&(gyration / radius)) {
        let message = format!(
            "the radius of gyration of the wheel is {:.1} mm, its radius {:.1} mm: check the unit of its inertia",
            1e3 * gyration,
            1e3 * radius
        );
        findings.warning("implausible-wheel", spot, message);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(mass: f64, com: [f64; 3], moments: [f64; 3], size: f64) -> Vec<&'static str> {
        let inertial = Inertial::diagonal(mass, [0.0; 3], moments);
        let part = CheckedPart {
            name: "arm",
            inertial: &inertial,
            com: Vector3::from(com),
            size,
            is_hub: false,
            is_rod: false,
            is_axle: false,
        };
        let mut findings = Findings::default();
        check_part(&part, &Spot::default(), &mut findings);
        findings.finish(&[("car.toml", "")]).into_iter().map(|found| found.code).collect()
    }

    #[test]
    fn values_in_other_units_and_about_the_origin_are_warned_of() {
        let (com, moments) = ([0.1, 0.6, 0.3], [0.04, 0.02, 0.05]);
        assert_eq!(codes(4.0, com, moments, 0.4), [""; 0]);
        assert_eq!(codes(4000.0, com, moments, 0.4), ["implausible-mass", "implausible-gyration"]);
        assert_eq!(codes(4.0, com, moments.map(|moment| 1e-3 * moment), 0.4), ["implausible-gyration"]);
        assert_eq!(codes(4.0, com, moments.map(|moment| 1e3 * moment), 0.4), ["implausible-gyration"]);
        // The centre of mass is on an axis, so that m (r² 1 − r rᵀ) is diagonal, as the inertia of this test.
        let about_origin = [0.04 + 4.0 * 0.36, 0.02, 0.05 + 4.0 * 0.36];
        assert_eq!(codes(4.0, [0.0, 0.6, 0.0], about_origin, 0.4), ["inertia-about-origin"]);
    }
}
