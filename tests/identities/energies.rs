//! The formula and 2T/V² agree, with velocities from differences of poses (the third definition, F/a, is in
//! `accelerations.rs`). The mass matrix, the contact row and Φ agree with the same velocities for any motion and any
//! normal.

use nalgebra::{DVector, Vector3};
use percuss_dynamics::{Base, Direction, EffectiveMass, Frame, Route, RouteChoice, RouteError};
use percuss_oracle::zoo;
use percuss_tests::cases::{self, Case};
use percuss_tests::differences::{DIFFERENCE, closing_speed, twice_energy};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::{near_at, regular_condition};
use percuss_tests::motion::Motion;
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

/// Relative rounding of a mass matrix entry: terms of a long chain, each transformed a few dozen times.
const ROUNDING: f64 = 1e-13;

/// All cases: models of the zoo and random models.
fn all_cases() -> Vec<Case> {
    [cases::of_the_zoo(2, 2), cases::at_random(2000, 200, 60)].concat()
}

#[test]
fn the_mass_matrix_is_the_energy_of_the_links() {
    let mut rng = StdRng::seed_from_u64(21);
    let mut energy = Gauge::new("vᵀMv = link energies");
    let mut symmetry = Gauge::new("M − Mᵀ");
    let mut negative = Gauge::new("negative part of M");
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        let mass = pose.mass_matrix();
        assert_eq!(mass.shape(), (system.degrees_of_freedom(), system.degrees_of_freedom()), "{}", case.name);
        for _ in 0..2 {
            let motion = Motion::random(&mut rng, &system);
            let u = motion.coordinates(&system);
            let (by_links, size) = twice_energy(&case, &pose, &motion);
            if size == 0.0 {
                assert_eq!(u.dot(&(&mass * &u)).max(0.0), 0.0, "{}", case.name);
                continue;
            }
            // Velocities have the error DIFFERENCE of the greatest possible speed, `chain`; the error of a slow link's
            // energy is the product of this error and its own speed.
            let chain = case.mechanism.total_mass() * (motion.size() * reach(&case)).powi(2);
            let bound = 2.0 * DIFFERENCE * (size * chain).sqrt().max(size);
            energy.note(&case.name, (u.dot(&(&mass * &u)) - by_links).abs() / size, bound / size);
        }
        if mass.nrows() > 0 {
            // The block of a joint with several velocities is symmetric only to rounding.
            symmetry.note(&case.name, (&mass - mass.transpose()).amax(), ROUNDING * mass.amax());
            let diagonal = mass.diagonal().map(|m| if m > 0.0 { 1.0 / m.sqrt() } else { 0.0 });
            let scaled = mass.map_with_location(|r, c, m| m * diagonal[r] * diagonal[c]);
            let least = scaled.symmetric_eigenvalues().min();
            negative.note(&case.name, (-least).max(0.0), ROUNDING);
        }
    }
    energy.report();
    symmetry.report();
    negative.report();
}

/// Upper bound of the mechanism's extent, m: all links in a line.
fn reach(case: &Case) -> f64 {
    case.mechanism.links().iter().map(percuss_mechanism::Link::extent).sum()
}

#[test]
fn twice_the_energy_over_the_speed_squared() {
    let mut gauge = Gauge::new("2T/V²");
    let mut speed = Gauge::new("closing speed of v*");
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        for route in [Route::Dense, Route::Articulated] {
            let response =
                pose.respond_by_route(&case.contact(), RouteChoice::Only(route)).expect("an answer");
            let EffectiveMass::Finite(m) = response.effective_mass else { continue };
            let motion = Motion::of(&response);
            // For every motion, 2T/V² ≥ m̄; for the response, equality. The response closes the gap at unit speed, but
            // its rates, which have the error of differences, may be much faster.
            let v = closing_speed(&pose, &motion, &response.contact);
            let (energy, size) = twice_energy(&case, &pose, &motion);
            let fast = 1.0 + motion.size() * case.mechanism.characteristic_length();
            speed.note(&case.name, (v - 1.0).abs(), DIFFERENCE * fast + near_at(&pose));
            let bound = DIFFERENCE * (fast + size / m) + near_at(&pose);
            gauge.note(&case.name, (energy / (v * v) / m - 1.0).abs(), bound);
        }
    }
    speed.report();
    gauge.report();
}

#[test]
fn contact_row_and_jacobians() {
    let mut gauge = Gauge::new("contact row");
    let mut speed = Gauge::new("contact row, by differences");
    let mut rng = StdRng::seed_from_u64(23);
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        let contact = pose.locate(&case.contact()).expect("a contact");
        let row = DVector::from_vec(pose.contact_row(&contact));
        let of = |link| {
            let point = pose.link(link).inverse_point(&contact.point_world);
            pose.point_jacobian(link, &point)
        };
        let on = of(case.on);
        let mut relative = on.clone();
        let mut size = on.amax();
        if let Some(link) = case.against {
            let other = of(link);
            size = size.max(other.amax());
            relative -= other;
        }
        let expected = relative.tr_mul(&case.normal);
        // Joints that are ancestors of both sides cancel here and are omitted in `row`. The world point passes through
        // the inverse frame of a long chain.
        let bound = ROUNDING * (1.0 + size);
        for (a, b) in row.iter().zip(&expected) {
            gauge.note(&case.name, (a - b).abs(), bound);
        }
        let motion = Motion::random(&mut rng, &system);
        let by_row = row.dot(&motion.coordinates(&system));
        let by_poses = closing_speed(&pose, &motion, &contact);
        speed.note(&case.name, (by_row - by_poses).abs(), DIFFERENCE * (1.0 + size) * (1.0 + motion.size()));
    }
    gauge.report();
    speed.report();
}

#[test]
fn the_inverse_operational_inertia_answers_every_normal() {
    let mut rng = StdRng::seed_from_u64(24);
    let mut gauge = Gauge::new("Φ");
    let mut symmetry = Gauge::new("Φ − Φᵀ");
    let mut refused = 0;
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        let contact = pose.locate(&case.contact()).expect("a contact");
        let phi = match pose.inverse_operational_inertia(&contact) {
            Ok(phi) => phi,
            Err(RouteError::MasslessMotion) => {
                // Some wrench at the point moves a massless part: a property of the mechanism, visible in M.
                assert_eq!(regular_condition(&pose), None, "{}", case.name);
                refused += 1;
                continue;
            }
            Err(error) => panic!("{}: {error}", case.name),
        };
        let size = phi.matrix().amax();
        assert!(size.is_finite(), "{}", case.name);
        symmetry.note(
            &case.name,
            (phi.matrix() - phi.matrix().transpose()).amax(),
            f64::EPSILON * 4.0 * size,
        );
        for _ in 0..4 {
            let normal = Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
            let contact = case.contact().normal(Direction::Along(normal, Frame::World));
            let response =
                pose.respond_by_route(&contact, RouteChoice::Only(Route::Dense)).expect("an answer");
            let bound = near_at(&pose);
            let inverse = phi.inverse_effective_mass(&normal);
            match response.effective_mass {
                EffectiveMass::Finite(m) => {
                    // Entries of both sides cancel if the sides share ancestors.
                    let cancelled = phi.matrix().fixed_view::<3, 3>(3, 3).amax() * m;
                    gauge.note(&case.name, (inverse * m - 1.0).abs(), bound * (1.0 + cancelled));
                }
                EffectiveMass::Immovable => gauge.note(&case.name, inverse.abs() / (1.0 + size), bound),
                EffectiveMass::Massless => panic!("{}: massless, and yet it has an inverse", case.name),
            }
        }
    }
    gauge.report();
    symmetry.report();
    assert!(refused > 0, "singular matrices never came");
}

/// M of a massless floating ground is singular.
#[test]
fn a_singular_mass_matrix_has_no_condition() {
    let mut rng = StdRng::seed_from_u64(26);
    let mut singular = 0;
    for mechanism in [zoo::physical_pendulum(2.3, 0.35, 0.04), zoo::point_mass_pendulum(1.0, 0.5)] {
        let mechanism = Arc::new(mechanism);
        for i in 0..100 {
            let name = format!("{} {i}", mechanism.name());
            let case = Case::plain(&mut rng, name, Arc::clone(&mechanism), Base::Floating);
            let condition = case.pose(&case.system()).condition();
            assert!(condition.is_none(), "{}: {condition:?}", case.name);
            singular += 1;
        }
    }
    assert!(singular > 0);
}

#[test]
fn massless_contacts_have_no_inverse_inertia() {
    // A massless floating ground: rounding leaves nonzero pivots. All twelve probes must be tested for dependence on
    // them; a single probe, a moment, often does not depend on them.
    let mut rng = StdRng::seed_from_u64(25);
    let mut massless = 0;
    for mechanism in [zoo::two_free_bodies(), zoo::massless_chain()] {
        let mechanism = Arc::new(mechanism);
        for i in 0..1000 {
            let name = format!("{} {i}", mechanism.name());
            let plain = Case::plain(&mut rng, name, Arc::clone(&mechanism), Base::Floating);
            let case = plain.with_armatures(&mut rng);
            if case.response().effective_mass == EffectiveMass::Massless {
                let (system, contact) = (case.system(), case.response().contact);
                let phi = case.pose(&system).inverse_operational_inertia(&contact);
                assert!(phi.is_err(), "{}: {phi:?}", case.name);
                massless += 1;
            }
        }
    }
    assert!(massless > 0, "nothing was massless");
}
