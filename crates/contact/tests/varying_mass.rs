//! Impacts with a mass that changes over the penetration.

use percuss_contact::{CompliantContact, Damper, Law, Separation, impact_with_varying_mass};

const STIFFNESS: f64 = 2e5;

fn dampers(contact: CompliantContact, e: f64, speed: f64) -> [Damper; 3] {
    let kelvin_voigt = |separation| {
        Law::KelvinVoigt.damper(contact, e, None, separation).expect("a damper of Kelvin and Voigt")
    };
    let hunt_crossley = Law::HuntCrossley.damper(contact, e, Some(speed), Separation::ForceVanishes);
    [
        kelvin_voigt(Separation::ForceVanishes),
        kelvin_voigt(Separation::GapCloses),
        hunt_crossley.expect("a damper"),
    ]
}

/// A constant mass gives the closed form.
#[test]
fn a_constant_mass_gives_the_closed_form() {
    for e in [0.1, 0.3, 0.8] {
        for exponent in [1.0, 1.5] {
            for (mass, speed) in [(3.0, 0.5), (150.0, 0.1)] {
                let contact = CompliantContact::new(mass, STIFFNESS).and_then(|c| c.with_exponent(exponent));
                let contact = contact.expect("a contact");
                for damper in dampers(contact, e, speed) {
                    let exact = damper.impact(contact, speed).expect("an impact");
                    let profile = [(0.0, mass), (1e-3, mass), (1.0, mass)];
                    let found =
                        impact_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end");
                    // Fixed steps; for p = 1.5 the force has an infinite slope at both ends.
                    assert!(
                        (found.restitution - exact.restitution).abs() < 2e-4,
                        "{damper:?}: {found:?}, {exact:?}"
                    );
                    assert!((found.max_penetration / exact.max_penetration - 1.0).abs() < 1e-4);
                    assert!((found.peak_force / exact.peak_force - 1.0).abs() < 1e-3);
                }
            }
        }
    }
}

/// A bar on a hinge hits a plane with its tip. With the angle q as the coordinate, the equation of motion is
/// I q̈ = −F L cos q with δ = L (sin q − sin q₀): no effective mass occurs in it.
#[test]
fn a_bar_on_a_hinge_moves_as_its_own_equation_says() {
    let (inertia, length) = (0.23, 0.5);
    for touch in [-0.9f64, 0.3, 1.0] {
        let mass_at = |depth: f64| {
            let sine = touch.sin() + depth / length;
            inertia / (length * length * (1.0 - sine * sine))
        };
        let speed = 2.0;
        let contact = CompliantContact::new(mass_at(0.0), STIFFNESS).expect("a contact");
        for damper in dampers(contact, 0.4, speed) {
            let depth = 1.5 * damper.impact(contact, speed).expect("an impact").max_penetration;
            let profile: Vec<(f64, f64)> =
                (0..=40).map(|i| f64::from(i) / 40.0 * depth).map(|d| (d, mass_at(d))).collect();
            let found = impact_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end");
            let force = |x: f64, v: f64| match damper {
                Damper::KelvinVoigt { coefficient, .. } => STIFFNESS * x + coefficient * v,
                Damper::HuntCrossley { dissipation } => STIFFNESS * x * (1.0 + dissipation * v),
            };
            // Leapfrog with a step that is small enough for five digits.
            let (mut q, mut rate, step) = (touch, speed / (length * touch.cos()), 2e-8);
            let (mut deepest, mut rebound) = (0.0f64, f64::NAN);
            for _ in 0..20_000_000 {
                let (x, v) = (length * (q.sin() - touch.sin()), length * q.cos() * rate);
                let f = force(x, v);
                let over = match damper {
                    Damper::KelvinVoigt { separation: Separation::ForceVanishes, .. } => f <= 0.0,
                    _ => x <= 0.0 && v < 0.0,
                };
                if over && v < 0.0 {
                    rebound = -v / speed;
                    break;
                }
                deepest = deepest.max(x);
                rate -= step * f * length * q.cos() / inertia;
                q += step * rate;
            }
            assert!((found.restitution - rebound).abs() < 1e-4, "{touch} {damper:?}: {found:?}, {rebound}");
            assert!((found.max_penetration / deepest - 1.0).abs() < 1e-4, "{touch}: {found:?}, {deepest}");
        }
    }
}
