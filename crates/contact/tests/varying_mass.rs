//! Impacts with a mass that changes over the penetration.

use percuss_contact::{
    CompliantContact, Damper, Law, Separation, history_with_varying_mass, impact_with_varying_mass,
    kelvin_voigt, restitution_with_prescribed_acceleration,
};

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

/// A mass that is quadratic in the penetration: the slopes are those of parabolas, so that points at unequal distances give what many equal
/// ones give, apart from the first and the last interval.
#[test]
fn unequal_distances_give_the_same_impact() {
    let (mass, speed) = (3.0, 0.5);
    let contact = CompliantContact::new(mass, STIFFNESS).expect("a contact");
    for damper in dampers(contact, 0.5, speed) {
        let depth = 3.0 * damper.impact(contact, speed).expect("an impact").max_penetration;
        let at = |part: f64| (part * depth, mass * (1.0 + 2.0 * part + 6.0 * part * part));
        let equal: Vec<_> = (0..=200).map(|i| at(f64::from(i) / 200.0)).collect();
        let unequal: Vec<_> = (0..=9).map(|i| at((f64::from(i) / 9.0).powi(2))).collect();
        let [equal, unequal] = [equal, unequal].map(|profile| {
            impact_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end")
        });
        let change = |one: f64, other: f64| (one / other - 1.0).abs();
        // The chord in place of the tangent of the first interval, 1/81 of the depth.
        assert!(change(unequal.restitution, equal.restitution) < 2e-5, "{unequal:?} {equal:?}");
        assert!(change(unequal.max_penetration, equal.max_penetration) < 2e-5, "{unequal:?} {equal:?}");
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
                Damper::LossFactor { .. } => unreachable!("no damper of these cases"),
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

/// The restitution that is reached differs from that of a constant mass by K/k if the mass is symmetric about the touch, and
/// by K/√k otherwise: the penetration decreases as 1/√k.
#[test]
fn the_error_of_a_constant_mass_has_its_order() {
    let (m0, speed, e) = (2.0, 1.0, 0.5);
    let reached = |stiffness: f64, symmetric: bool| {
        let contact = CompliantContact::new(m0, stiffness).expect("a contact");
        let damper = dampers(contact, e, speed)[0];
        let depth = 1.5 * damper.impact(contact, speed).expect("an impact").max_penetration;
        let mass = |d: f64| if symmetric { m0 * (1.0 + 100.0 * d * d) } else { m0 * (1.0 + 3.0 * d) };
        let profile: Vec<(f64, f64)> =
            (0..=80).map(|i| f64::from(i) / 80.0 * depth).map(|d| (d, mass(d))).collect();
        let found = impact_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end");
        (found.restitution - e).abs()
    };
    for (symmetric, order) in [(true, 1.0), (false, 0.5)] {
        let (soft, hard) = (1e5, 1.6e6);
        let found = (reached(soft, symmetric) / reached(hard, symmetric)).ln() / (hard / soft).ln();
        assert!((found - order).abs() < 0.02, "{symmetric}: {found}");
    }
}

/// The history ends at the key figures, and its forces change the momentum of a constant mass.
#[test]
fn the_history_agrees_with_the_key_figures() {
    let contact = CompliantContact::new(3.0, STIFFNESS).expect("a contact");
    let profile = [(0.0, 3.0), (1e-3, 3.0), (1.0, 3.0)];
    for damper in dampers(contact, 0.4, 0.5) {
        let found = impact_with_varying_mass(damper, contact, &profile, 0.5).unwrap().expect("an end");
        let samples = history_with_varying_mass(damper, contact, &profile, 0.5).unwrap().expect("an end");
        let last = samples.last().expect("samples");
        assert_eq!(-last.rate / 0.5, found.restitution);
        let deepest = samples.iter().map(|s| s.penetration).fold(0.0, f64::max);
        assert_eq!(deepest, found.max_penetration);
        let impulse: f64 =
            samples.windows(2).map(|w| 0.5 * (w[0].force + w[1].force) * (w[1].time - w[0].time)).sum();
        assert!((impulse - 3.0 * 0.5 * (1.0 + found.restitution)).abs() < 1e-5, "{impulse}");
        let exact = damper.impact(contact, 0.5).expect("an impact").duration.expect("an end");
        assert!((last.time / exact - 1.0).abs() < 1e-3, "{} {exact}", last.time);
    }
}

/// A bar on a hinge whose contact prescribes the acceleration of the joint, as MuJoCo's contacts do. The penetration δ = L (sin q − sin q₀)
/// has δ̈ = L cos q q̈ − L sin q q̇², with L cos q q̈ = −(ω² δ + 2ζω δ̇) while the force pushes. `full`: the prescribed acceleration contains
/// the term −L sin q q̇² too, so δ̈ = −(ω² δ + 2ζω δ̇). Near a dead centre the restitution differs from the required one.
#[test]
fn prescribed_accelerations_of_a_bar_on_a_hinge() {
    let (inertia, length, speed) = (0.23f64, 0.5, 0.5);
    for full in [false, true] {
        let mut largest = 0.0f64;
        for (touch, e) in [(-1.3f64, 0.2), (-1.2, 0.6), (-0.6, 0.9), (0.3, 0.2), (1.2, 0.6), (1.0, 0.9)] {
            let sine = |depth: f64| touch.sin() + depth / length;
            let square = |depth: f64| 1.0 - sine(depth) * sine(depth);
            let mass_at = |depth: f64| inertia / (length * length * square(depth));
            let contact = CompliantContact::new(mass_at(0.0), STIFFNESS).expect("a contact");
            let frequency = (STIFFNESS / mass_at(0.0)).sqrt();
            let depth = 1.05 * speed / frequency;
            let depths = || (0..=20).map(|i| f64::from(i) / 20.0 * depth);
            let masses: Vec<(f64, f64)> = depths().map(|d| (d, mass_at(d))).collect();
            let beta = |d: f64| if full { 0.0 } else { -sine(d) / (length * square(d)) };
            let betas: Vec<(f64, f64)> = depths().map(|d| (d, beta(d))).collect();
            let (found, _) = restitution_with_prescribed_acceleration(contact, e, &masses, &betas, speed)
                .unwrap()
                .expect("an end");
            let ratio = kelvin_voigt::ratio(e, Separation::ForceVanishes).expect("a ratio");
            // Leapfrog with a step that is small enough for five digits.
            let (mut q, mut rate, step) = (touch, speed / (length * touch.cos()), 2e-8);
            let mut v = speed;
            for _ in 0..20_000_000 {
                let x = length * (q.sin() - touch.sin());
                v = length * q.cos() * rate;
                if x < 0.0 && v < 0.0 {
                    break;
                }
                let wanted = -frequency * (frequency * x + 2.0 * ratio * v);
                let free = if full { -length * q.sin() * rate * rate } else { 0.0 };
                let arm = length * q.cos();
                let force = ((free - wanted) * inertia / (arm * arm)).max(0.0);
                rate -= step * force * arm / inertia;
                q += step * rate;
            }
            assert!((found + v / speed).abs() < 2e-5, "{full} {touch} {e}: {found}, {}", -v / speed);
            largest = largest.max((found - e).abs());
        }
        assert!(largest > 2e-3, "{full}: the motion of the bar has an effect: {largest}");
    }
}

/// Without damping the force stays zero after the separation: the contact ends at zero penetration, not at the end of a step.
#[test]
fn an_elastic_contact_ends_at_zero_penetration() {
    for (mass, speed, exponent) in [(3.0, 0.5, 1.0), (150.0, 0.1, 1.0), (0.7, 2.0, 1.5), (20.0, 0.3, 2.0)] {
        let contact = CompliantContact::new(mass, STIFFNESS).and_then(|c| c.with_exponent(exponent));
        let contact = contact.expect("a contact");
        let profile = [(0.0, mass), (1e-3, mass), (1.0, mass)];
        for damper in dampers(contact, 1.0, speed) {
            let exact = damper.impact(contact, speed).expect("an impact");
            let samples =
                history_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end");
            let last = samples.last().expect("samples");
            assert!((last.time / exact.duration.expect("an end") - 1.0).abs() < 1e-6, "{damper:?}: {last:?}");
            assert!(last.penetration.abs() < 1e-9 * exact.max_penetration, "{damper:?}: {last:?}");
        }
    }
}

/// An overdamped contact never ends with the mass at the touch, whose duration then has no value, but ends if the mass grows with the
/// penetration. The step follows from the time of the largest penetration. Reference: the equation m x″ + ½ m′ x′² = −F with shorter steps.
#[test]
fn a_contact_can_end_because_the_mass_grows() {
    for (mass, growth) in [(2.0, 3e3), (0.5, 1e4)] {
        let contact = CompliantContact::new(mass, STIFFNESS).expect("a contact");
        let damper = Damper::kelvin_voigt(contact, 1.01, Separation::GapCloses).expect("a damper");
        let Damper::KelvinVoigt { coefficient, .. } = damper else { panic!("{damper:?}") };
        let speed = 1.0;
        assert_eq!(damper.impact(contact, speed).expect("an impact").duration, None);
        let mass_at = |x: f64| mass * (1.0 + growth * x);
        let profile: Vec<(f64, f64)> =
            (0..=50).map(|i| 2e-4 * f64::from(i)).map(|x| (x, mass_at(x))).collect();
        let found = impact_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end");
        let acceleration =
            |x: f64, v: f64| -(STIFFNESS * x + coefficient * v + 0.5 * mass * growth * v * v) / mass_at(x);
        let (mut x, mut v, mut deepest, h) = (0.0, speed, 0.0f64, 1e-8);
        for _ in 0..10_000_000 {
            if x < 0.0 {
                break;
            }
            let (middle, rate) = (x + 0.5 * h * v, v + 0.5 * h * acceleration(x, v));
            (x, v) = (x + h * rate, v + h * acceleration(middle, rate));
            deepest = deepest.max(x);
        }
        assert!((found.max_penetration / deepest - 1.0).abs() < 1e-5, "{found:?} {deepest}");
        assert!((found.restitution + v / speed).abs() < 1e-6, "{found:?} {v}");
    }
}
