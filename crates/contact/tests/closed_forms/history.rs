//! History of an impact: first and last sample, reversal, and loop of force over penetration.

use crate::support::relative_difference;
use percuss_contact::{CompliantContact, Damper, Law, Sample, Separation};

/// Every kind of trajectory: both laws, both definitions of the end, three exponents, light and heavy damping.
fn cases() -> Vec<(Damper, CompliantContact<'static>, f64)> {
    let mut cases = Vec::new();
    for exponent in [1.0, 1.5, 4.0] {
        for (mass, stiffness, speed) in [(0.3, 2e4, 1.5), (80.0, 7e6, 0.2)] {
            let contact = CompliantContact::new(mass, stiffness).unwrap().with_exponent(exponent).unwrap();
            for e in [0.05, 0.4, 0.9, 0.999] {
                for law in [Law::KelvinVoigt, Law::HuntCrossley] {
                    for separation in Separation::ALL {
                        cases.push((
                            law.damper(contact, e, Some(speed), separation).unwrap(),
                            contact,
                            speed,
                        ));
                    }
                }
            }
        }
    }
    cases
}

/// Tolerance of the trapezoidal rule. Its error is proportional to the square of the step, except at the first touch: for
/// p = 3/2 with heavy damping the force grows as x^(1/4), and one step of a thousand reaches a tenth of the peak.
const TRAPEZIUM: f64 = 1e-3;

/// ∫ F dx.
fn loop_area(samples: &[Sample]) -> f64 {
    samples
        .windows(2)
        .map(|pair| 0.5 * (pair[0].force + pair[1].force) * (pair[1].penetration - pair[0].penetration))
        .sum()
}

/// The area enclosed by the loop of force over penetration is ½ m̄ v² (1 − e²).
#[test]
fn the_loop_encloses_the_energy_lost() {
    let count = 1501;
    for (damper, contact, speed) in cases() {
        let impact = damper.impact(contact, speed).unwrap();
        let area = loop_area(&damper.history(contact, speed, count).unwrap());
        let energy = 0.5 * contact.mass() * speed * speed;
        let error = (area - impact.energy_lost).abs() / energy;
        assert!(
            error < TRAPEZIUM,
            "{damper:?} {contact:?}: {area:e} beside {:e}, {error:e}",
            impact.energy_lost
        );
        assert!(relative_difference(impact.energy_lost, energy * (1.0 - impact.restitution.powi(2))) < 1e-12);
    }
}

/// Newton's second law along the history: the impulse between two samples equals the change of momentum.
#[test]
fn the_force_changes_the_speed() {
    for (damper, contact, speed) in cases() {
        let samples = damper.history(contact, speed, 1001).unwrap();
        let greatest = max_force(&samples);
        let mut impulse = 0.0;
        let mut travel = 0.0;
        for pair in samples.windows(2) {
            let time = pair[1].time - pair[0].time;
            assert!(time > 0.0, "{damper:?} {contact:?}: time stands at {pair:?}");
            impulse += 0.5 * (pair[0].force + pair[1].force) * time;
            travel += 0.5 * (pair[0].rate + pair[1].rate) * time;
            let momentum = contact.mass() * (speed - pair[1].rate);
            assert!(
                (impulse - momentum).abs() < TRAPEZIUM * contact.mass() * speed,
                "{damper:?} {contact:?} {pair:?}"
            );
            assert!((travel - pair[1].penetration).abs() < TRAPEZIUM * greatest, "{damper:?} {contact:?}");
        }
    }
}

fn max_force(samples: &[Sample]) -> f64 {
    samples.iter().map(|sample| sample.penetration).fold(0.0, f64::max)
}

#[test]
fn the_history_agrees_with_the_figures_of_the_impact() {
    for (damper, contact, speed) in cases() {
        let name = format!("{damper:?} {contact:?}");
        let impact = damper.impact(contact, speed).unwrap();
        let samples = damper.history(contact, speed, 1001).unwrap();
        let [first, last] = [samples[0], samples[1000]];
        assert!(
            first.time == 0.0 && first.penetration == 0.0 && relative_difference(first.rate, speed) < 1e-14,
            "{name}"
        );
        assert!(relative_difference(last.time, impact.duration.unwrap()) < 1e-14, "{name}");
        assert!(relative_difference(-last.rate, impact.rebound_speed) < 1e-12, "{name}: {last:?}");
        let greatest = max_force(&samples);
        assert!(greatest <= impact.max_penetration * (1.0 + 1e-14), "{name}");
        assert!(greatest > impact.max_penetration * (1.0 - 1e-4), "{name}");
        let peak = samples.iter().map(|sample| sample.force).fold(0.0, f64::max);
        assert!(
            peak <= impact.peak_force * (1.0 + 1e-14) && peak > impact.peak_force * (1.0 - 1e-3),
            "{name}"
        );
        match damper {
            Damper::KelvinVoigt { separation: Separation::GapCloses, coefficient, .. } => {
                assert!(last.penetration == 0.0 && last.force <= 0.0, "{name}: {last:?}");
                if contact.power_law().expect("a spring").1 == 1.0 {
                    assert!(
                        relative_difference(last.force, coefficient * last.rate) < 1e-12,
                        "{name}: {last:?}"
                    );
                }
            }
            Damper::KelvinVoigt { .. } => {
                assert!(last.force == 0.0 && last.penetration > 0.0, "{name}: {last:?}");
                assert!(samples.iter().all(|sample| sample.force >= 0.0), "{name}");
            }
            Damper::HuntCrossley { .. } | Damper::LossFactor { .. } => {
                assert!(last.force == 0.0 && last.penetration == 0.0, "{name}: {last:?}");
                assert!(samples.iter().all(|sample| sample.force >= 0.0), "{name}");
            }
        }
    }
}

/// With critical or larger damping the gap never closes.
#[test]
fn a_contact_without_end_has_a_decaying_history() {
    for ratio in [1.0, 3.0] {
        let contact = CompliantContact::new(2.0, 5e4).unwrap();
        let damper = Damper::kelvin_voigt(contact, ratio, Separation::GapCloses).unwrap();
        let impact = damper.impact(contact, 1.0).unwrap();
        assert_eq!((impact.duration, impact.restitution, impact.rebound_speed), (None, 0.0, 0.0));
        assert!(relative_difference(impact.energy_lost, 1.0) < 1e-15);
        let last = *damper.history(contact, 1.0, 300).unwrap().last().unwrap();
        // e⁻⁸ is 3e-4; for critical damping the factor is 1 + 8.
        assert!(
            last.penetration > 0.0 && last.penetration < 4e-3 * impact.max_penetration,
            "{ratio}: {last:?}"
        );
    }
}

#[test]
fn the_shortest_history_has_two_samples() {
    for (damper, contact, speed) in cases() {
        let samples = damper.history(contact, speed, 2).unwrap();
        assert!(samples.len() == 2 && samples[0].time == 0.0);
        assert!(
            relative_difference(samples[1].time, damper.impact(contact, speed).unwrap().duration.unwrap())
                < 1e-14
        );
    }
}
