//! No input causes a panic, and no result is NaN or infinite.

use percuss_contact::{
    CompliantContact, Damper, Law, Sample, Separation, TransientContact, hunt_crossley, kelvin_voigt,
};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// Random positive number with a uniform exponent: from 1e-300 to 1e300, or (half of the numbers) near 1.
fn number(rng: &mut StdRng) -> f64 {
    let range = if rng.random_bool(0.5) { 300.0 } else { 8.0 };
    10f64.powf(rng.random_range(-range..range))
}

/// Random restitution near 0, near 1 or between.
fn restitution(rng: &mut StdRng) -> f64 {
    match rng.random_range(0..5) {
        0 => 10f64.powf(rng.random_range(-300.0..0.0)),
        1 => 1.0 - 10f64.powf(rng.random_range(-16.0..0.0)),
        2 => [0.0, 1.0, f64::MIN_POSITIVE, 5e-324, 1.0 - f64::EPSILON / 2.0][rng.random_range(0..5)],
        _ => rng.random_range(0.0..1.0),
    }
}

fn contact(rng: &mut StdRng) -> CompliantContact<'static> {
    let exponent = match rng.random_range(0..5) {
        0 => 1.0,
        1 => 1.5,
        2 => 1.0 + 10f64.powf(rng.random_range(-17.0..0.0)),
        3 => 10.0,
        _ => rng.random_range(1.0..10.0),
    };
    CompliantContact::new(number(rng), number(rng)).unwrap().with_exponent(exponent).unwrap()
}

fn all_finite(samples: &[Sample]) -> bool {
    samples.iter().flat_map(|s| [s.time, s.penetration, s.rate, s.force]).all(f64::is_finite)
}

/// True if the impact has a result. Asserts that the figures of the impact are consistent.
fn respond(damper: Damper, contact: CompliantContact, speed: f64, name: &str) -> bool {
    if let Ok(e) = damper.restitution(contact, speed) {
        assert!((0.0..=1.0).contains(&e), "{name}: {e}");
        let loss = damper.restitution_loss(contact, speed).unwrap();
        assert!((loss + e - 1.0).abs() < 1e-15, "{name}: {e} and {loss}");
    }
    if let Ok(samples) = damper.history(contact, speed, 5) {
        assert!(all_finite(&samples) && samples.len() == 5, "{name}: {samples:?}");
    }
    let Ok(impact) = damper.impact(contact, speed) else { return false };
    let figures = [
        impact.restitution,
        impact.duration.unwrap_or(1.0),
        impact.max_penetration,
        impact.time_of_max_penetration,
        impact.peak_force,
        impact.time_of_peak_force,
        impact.energy_lost,
        impact.rebound_speed,
    ];
    assert!(figures.iter().all(|figure| figure.is_finite() && *figure >= 0.0), "{name}: {impact:?}");
    assert!(impact.duration.is_none_or(|time| time >= impact.time_of_max_penetration), "{name}: {impact:?}");
    assert!(
        impact.time_of_peak_force <= impact.time_of_max_penetration * (1.0 + 1e-12),
        "{name}: {impact:?}"
    );
    assert!(impact.rebound_speed <= speed, "{name}: {impact:?}");
    // While the speed decreases from v to 0 the travel is at most v t, and the mean force is at least m̄ v/t.
    let bound = speed * impact.time_of_max_penetration;
    assert!(impact.max_penetration <= bound * (1.0 + 1e-9), "{name}: {impact:?}");
    let momentum = contact.mass().sqrt() * speed * contact.mass().sqrt();
    let push = impact.peak_force * impact.time_of_max_penetration;
    assert!(momentum == 0.0 || push >= momentum * (1.0 - 1e-9), "{name}: {impact:?}");
    true
}

#[test]
fn impacts_of_every_law() {
    let mut rng = StdRng::seed_from_u64(20_250_917);
    let mut results = 0;
    let rounds = 6000;
    for _ in 0..rounds {
        let contact = contact(&mut rng);
        let (e, speed) = (restitution(&mut rng), number(&mut rng));
        let law = Law::ALL[rng.random_range(0..Law::ALL.len())];
        let separation = Separation::ALL[rng.random_range(0..2)];
        let name = format!("{law:?} {e:e} {contact:?} {speed:e} {separation:?}");
        if let Ok(damper) = law.damper(contact, e, Some(speed), separation) {
            results += usize::from(respond(damper, contact, speed, &name));
        }
    }
    // Products of such numbers overflow often, but not always.
    assert!(results > rounds / 4, "{results} of {rounds}");
}

#[test]
fn dampers_of_any_size() {
    let mut rng = StdRng::seed_from_u64(4711);
    let mut results = 0;
    let rounds = 6000;
    for _ in 0..rounds {
        let contact = contact(&mut rng);
        let (size, speed) = (number(&mut rng), number(&mut rng));
        let separation = Separation::ALL[rng.random_range(0..2)];
        let damper = match rng.random_range(0..3) {
            0 => Damper::hunt_crossley(size),
            1 => Damper::kelvin_voigt(contact, size, separation),
            _ => Damper::kelvin_voigt_from_coefficient(contact, size, separation),
        };
        let name = format!("{damper:?} {contact:?} {speed:e}");
        if let Ok(damper) = damper {
            results += usize::from(respond(damper, contact, speed, &name));
        }
    }
    assert!(results > rounds / 5, "{results} of {rounds}");
}

#[test]
fn the_relations() {
    let mut rng = StdRng::seed_from_u64(99);
    for _ in 0..20_000 {
        let (size, e) = (number(&mut rng), restitution(&mut rng));
        for separation in Separation::ALL {
            let got = kelvin_voigt::restitution(size, separation).unwrap();
            let loss = kelvin_voigt::restitution_loss(size, separation).unwrap();
            assert!((0.0..=1.0).contains(&got) && (0.0..=1.0).contains(&loss), "{size:e}: {got} {loss}");
            if let Ok(ratio) = kelvin_voigt::ratio(e, separation) {
                assert!(ratio.is_finite() && ratio >= 0.0, "{e:e}: {ratio}");
            }
        }
        assert!(kelvin_voigt::compression_time(size).unwrap().is_finite(), "{size:e}");
        let got = hunt_crossley::restitution(size).unwrap();
        let loss = hunt_crossley::restitution_loss(size).unwrap();
        assert!((0.0..=1.0).contains(&got) && (0.0..=1.0).contains(&loss), "{size:e}: {got} {loss}");
        if let Ok(a) = hunt_crossley::dissipation_number(e) {
            assert!(a.is_finite() && a >= 0.0, "{e:e}: {a}");
        }
        for law in Law::ALL {
            if let Ok(error) = law.approximation_error(e) {
                assert!((0.0..=1.0).contains(&error.achieved), "{law:?} {e:e}: {error:?}");
            }
        }
    }
}

#[test]
fn impacts_on_people() {
    let mut rng = StdRng::seed_from_u64(7);
    for _ in 0..20_000 {
        let [body, stiffness, robot, force, area] = [(); 5].map(|()| number(&mut rng));
        let contact = TransientContact::with_body(body, stiffness, robot).unwrap();
        assert!(contact.reduced_mass() <= body.min(robot) && contact.reduced_mass() > 0.0);
        for safe in
            [contact.speed_for_force(force), contact.speed_for_pressure(force, area)].into_iter().flatten()
        {
            assert!(safe.speed > 0.0 && safe.speed.is_finite() && safe.energy.is_finite(), "{safe:?}");
        }
        if let Ok(force) = contact.force(area) {
            assert!(force > 0.0 && force.is_finite());
        }
    }
}
