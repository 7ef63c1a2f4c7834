//! Warnings about implausible masses and inertias of parts: values in another unit, or about another point.

use crate::findings::{Findings, Spot};
use crate::limits::{
    GRAMS_PER_KILOGRAM, GYRATION_RADII, LEAST_CARRIER_SIZE, LEAST_DISTANCE_TERM, LEAST_SHARE_IN_GRAMS,
    LEAST_SIGN_DISTANCE, LIGHT_ROD, MAX_AXLE_MASS, MAX_PART_DENSITY, MAX_PART_MASS, MAX_ROD_DENSITY,
    MAX_SIGN_DISTANCE_RATIO, MAX_WHEEL_MASS, MIN_PART_SIZE, WHEEL_DENSITIES, WHEEL_GYRATION_RADII,
};
use crate::units::{FilePlaces, Frame};
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

impl CheckedPart<'_> {
    /// Largest plausible mass of a part of this size, kg.
    pub fn largest_mass(&self) -> f64 {
        match self.is_axle {
            true => MAX_AXLE_MASS,
            false if self.is_rod => LIGHT_ROD.max(MAX_ROD_DENSITY * self.size.powi(3)).min(MAX_PART_MASS),
            false if self.size < MIN_PART_SIZE => MAX_PART_MASS,
            false => MAX_PART_MASS.min(MAX_PART_DENSITY * self.size.powi(3)),
        }
    }
}

/// Mass of a part and its largest plausible mass `most`, kg.
pub(crate) struct GivenMass {
    pub part: String,
    pub mass: f64,
    pub most: f64,
    pub spot: Spot,
}

impl GivenMass {
    /// True if the mass is implausible in kilograms, and plausible in grams.
    pub fn is_heavy(&self) -> bool {
        self.mass > self.most && self.mass < GRAMS_PER_KILOGRAM * self.most
    }
}

/// Message about masses in grams; `None` unless at least two masses, and at least the share [`LEAST_SHARE_IN_GRAMS`] of all, are too large
/// in kilograms and plausible in grams.
pub(crate) fn masses_in_grams(masses: &[GivenMass]) -> Option<String> {
    let heavy: Vec<&GivenMass> = masses.iter().filter(|mass| mass.is_heavy()).collect();
    let share = heavy.len() as f64 / masses.len().max(1) as f64;
    if heavy.len() < 2 || share < LEAST_SHARE_IN_GRAMS {
        return None;
    }
    let list: Vec<String> = heavy.iter().map(|mass| format!("{} {} kg", mass.part, mass.mass)).collect();
    Some(format!(
        "the masses are read as kg but look like grams: {} of {} are too large for their parts ({})",
        heavy.len(),
        masses.len(),
        list.join(", ")
    ))
}

/// Warns about a mass that is too large for the size of the part, and about an inertia about the origin of the vehicle.
pub(super) fn check_part(part: &CheckedPart, spot: &Spot, findings: &mut Findings, places: FilePlaces) {
    let mass = part.inertial.mass;
    if mass > part.largest_mass() {
        let message = format!(
            "the mass of {} is {mass} kg; it is too large for a part of {}: check its unit. A mass can state its unit, as in \"850 g\"",
            part.name,
            places.length(part.size)
        );
        findings.warning("implausible-mass", spot, message);
    }
    let gyration = gyration_radius(part.inertial);
    // The coinciding joints of a hub do not give its size, and its inertia includes the inertia of the drive shaft.
    let is_small = part.size >= MIN_PART_SIZE && gyration < *GYRATION_RADII.start() * part.size;
    let is_large = gyration > *GYRATION_RADII.end() * part.size.max(LEAST_CARRIER_SIZE);
    if gyration > 0.0 && !part.is_hub && (is_small || is_large) {
        let message = format!(
            "the radius of gyration of {} is {}, and its joints and seats are within {}: check the unit of its inertia",
            part.name,
            places.length(gyration),
            places.length(part.size)
        );
        findings.warning("implausible-gyration", spot, message);
    }
    if is_about_origin(part) {
        let message = format!(
            "the inertia of {} is probably about the origin of the vehicle: I − m (r² 1 − r rᵀ), with r = {}, is still a valid \
             inertia. Give the inertia about the centre of mass, which is probably this difference",
            part.name,
            places.point(part.com)
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
pub(super) fn check_wheel(
    wheel: &Inertial,
    radius: f64,
    spot: &Spot,
    findings: &mut Findings,
    places: FilePlaces,
) {
    let mass = wheel.mass;
    // An implausible mass is reported separately.
    if mass <= 0.0 || mass > MAX_WHEEL_MASS {
        return;
    }
    let density = mass / radius.powi(3);
    if !WHEEL_DENSITIES.contains(&density) {
        let light = density < *WHEEL_DENSITIES.start();
        let message = format!(
            "the wheel has {mass} kg and a radius of {}; no wheel is so {} for its size: check the units of mass and length",
            places.length(radius),
            if light { "light" } else { "heavy" }
        );
        findings.warning("implausible-wheel", spot, message);
    }
    let gyration = gyration_radius(wheel);
    if gyration > 0.0 && !WHEEL_GYRATION_RADII.contains(&(gyration / radius)) {
        let message = format!(
            "the radius of gyration of the wheel is {}, its radius {}: check the unit of its inertia",
            places.length(gyration),
            places.length(radius)
        );
        findings.warning("implausible-wheel", spot, message);
    }
}

/// Coordinates whose sign is changed (0 to 2 for x, y, z), fewest changes first; y is first, because the wrong side of the vehicle is the
/// most frequent error.
const SIGN_CHANGES: [&[usize]; 4] = [&[1], &[0], &[2], &[0, 1]];

/// Centre of mass that is far from the joints of its link, and near them with other signs of its coordinates.
pub(super) struct MirroredMass<'c> {
    pub link: &'c str,
    /// Centre of mass in the vehicle frame, m.
    com: Vector3<f64>,
    /// Coordinates with the wrong sign, 0 to 2 for x, y, z.
    axes: &'static [usize],
    spot: Spot,
}

impl<'c> MirroredMass<'c> {
    /// Compares the distances of the centre of mass from the box around the joints (vehicle frame, m) with the given signs and with changed
    /// signs. `None` if the given signs are plausible, or no change of signs is better.
    pub fn find(link: &'c str, com: Vector3<f64>, joints: Vec<Vector3<f64>>, spot: Spot) -> Option<Self> {
        let distance = distance_from_box(&com, &joints);
        let with_signs = |axes: &[usize]| {
            let mut other = com;
            axes.iter().for_each(|axis| other[*axis] = 0.0 - other[*axis]);
            distance_from_box(&other, &joints)
        };
        let is_near = |axes: &&&[usize]| with_signs(axes) < MAX_SIGN_DISTANCE_RATIO * distance;
        let axes = SIGN_CHANGES.iter().find(is_near).filter(|_| distance > LEAST_SIGN_DISTANCE)?;
        Some(Self { link, com, axes, spot })
    }

    /// Prefix of a message, `LINK.com: `; empty if the key path of the finding already names the centre of mass.
    fn label(&self) -> String {
        let name = format!("{}.com", self.link);
        if self.spot.path.as_ref() == Some(&name) { String::new() } else { format!("{name}: ") }
    }

    /// Coordinates with the wrong sign, in the unit and the axes of the file.
    fn stated(&self, places: FilePlaces) -> String {
        let of_axis = |axis: &usize| places.coordinate(*axis, self.com);
        self.axes.iter().map(of_axis).collect::<Vec<_>>().join(", ")
    }
}

/// One warning for all centres of mass in which the same coordinates have the wrong sign.
pub(super) fn warn_mirrored_masses(found: &[MirroredMass], findings: &mut Findings, places: FilePlaces) {
    for axes in SIGN_CHANGES {
        let alike: Vec<&MirroredMass> = found.iter().filter(|mass| mass.axes == axes).collect();
        let Some((first, others)) = alike.split_first() else { continue };
        let likewise: Vec<String> =
            others.iter().map(|mass| format!("{}.com ({})", mass.link, mass.stated(places))).collect();
        let likewise =
            if likewise.is_empty() { String::new() } else { format!("; likewise {}", likewise.join(", ")) };
        let defect = match axes {
            [1] => "is on the other side of the vehicle than the joints of the part",
            [_] => "has another sign than the joints of the part",
            _ => "have other signs than the joints of the part, as if given in other axes",
        };
        let Frame { axes: file_axes, .. } = places.frame;
        let message = format!(
            "{}{} {defect} (axes {}: {}): change the sign{likewise}",
            first.label(),
            first.stated(places),
            file_axes.name(),
            file_axes.words()
        );
        findings.warning("mirrored-com", &first.spot, message);
    }
}

/// Distance (m) of a point from the axis-aligned bounding box of other points; 0 inside.
pub(super) fn distance_from_box<'p>(
    at: &Vector3<f64>,
    others: impl IntoIterator<Item = &'p Vector3<f64>>,
) -> f64 {
    let mut others = others.into_iter();
    let Some(first) = others.next() else { return 0.0 };
    let (low, high) = others.fold((*first, *first), |(low, high), at| (low.inf(at), high.sup(at)));
    (at - at.sup(&low).inf(&high)).norm()
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
        check_part(&part, &Spot::default(), &mut findings, FilePlaces::default());
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
