//! Impacts on force curves.

use percuss_contact::exports::{Request, Tool};
use percuss_contact::{
    CompliantContact, Damper, DamperCurve, ForceCurve, Law, Separation, hunt_crossley,
    impact_with_varying_mass,
};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// Curve with random pieces, sometimes with a force at the touch or without a force at its start; or a cubic polynomial, which can soften, or a
/// power.
fn random_curve(rng: &mut StdRng) -> ForceCurve {
    if rng.random_bool(0.3) {
        let (to, force) = (rng.random_range(2e-3..3e-2f64), rng.random_range(500.0..1e4));
        let (c, turn) = (rng.random_range(0.3..4.0f64), rng.random_range(-1.9..1.9));
        // F = f s (1 + turn √c s + c s²), s = x/to: no zero above s = 0.
        let cubic = [1.0, turn * c.sqrt(), c]
            .into_iter()
            .zip(1..)
            .map(|(c, p)| (force * c / to.powi(p), f64::from(p)));
        let p = rng.random_range(1.0..3.0);
        let powers = if rng.random_bool(0.6) { cubic.collect() } else { vec![(force / to.powf(p), p)] };
        return ForceCurve::powers(powers, to).expect("a curve");
    }
    let count = rng.random_range(2..8);
    let (mut x, mut f) = (vec![0.0], vec![if rng.random_bool(0.2) { 150.0 } else { 0.0 }]);
    for i in 1..count {
        x.push(x[i - 1] + rng.random_range(5e-4..8e-3));
        let rise = if i == 1 && rng.random_bool(0.2) { 0.0 } else { rng.random_range(10.0..2500.0) };
        f.push(f[i - 1] + rise);
    }
    ForceCurve::new(x, f).expect("a curve")
}

/// Second algorithm: short steps of third order over the points of the curve. The largest force can be at one of them. Returns restitution,
/// largest penetration, largest force, duration, work of the damper.
fn integrated(
    (force, corners): (&dyn Fn(f64, f64) -> f64, &[f64]),
    (mass, speed): (f64, f64),
    ends_without_force: bool,
    step: f64,
) -> [f64; 5] {
    let rates = |(x, v): (f64, f64)| (v, -force(x, v) / mass);
    let (mut state, mut time, mut lost) = ((0.0, speed), 0.0, 0.0);
    let (mut deepest, mut peak) = (0.0f64, force(0.0, speed));
    let free = |x: f64| force(x, 0.0);
    loop {
        // Rule of Ralston and Rabinowitz, third order.
        let a = rates(state);
        let b = rates((state.0 + 0.5 * step * a.0, state.1 + 0.5 * step * a.1));
        let c = rates((state.0 + 0.75 * step * b.0, state.1 + 0.75 * step * b.1));
        let mean = |a: f64, b: f64, c: f64| (2.0 * a + 3.0 * b + 4.0 * c) / 9.0;
        let next = (state.0 + step * mean(a.0, b.0, c.0), state.1 + step * mean(a.1, b.1, c.1));
        let remaining = |(x, v): (f64, f64)| if ends_without_force { force(x, v) } else { x };
        let closes = next.0 <= 0.0 && force(0.0, next.1) > 0.0;
        let (before, after) = if closes { (state.0, next.0) } else { (remaining(state), remaining(next)) };
        let power = |(x, v): (f64, f64)| (force(x, v) - free(x)) * v;
        if next.1 < 0.0 && after <= 0.0 {
            let part = before / (before - after);
            let v = state.1 + part * (next.1 - state.1);
            lost += part * step * power(state);
            return [-v / speed, deepest, peak, time + part * step, lost];
        }
        lost += 0.5 * step * (power(state) + power(next));
        for x in corners.iter().filter(|x| state.0 < **x && **x <= next.0) {
            peak = peak.max(force(*x, state.1 + (x - state.0) / (next.0 - state.0) * (next.1 - state.1)));
        }
        (state, time) = (next, time + step);
        deepest = deepest.max(state.0);
        peak = peak.max(force(state.0, state.1));
    }
}

#[test]
fn impacts_on_random_curves_are_those_of_an_integration() {
    let mut rng = StdRng::seed_from_u64(7);
    for case in 0..40 {
        let curve = random_curve(&mut rng);
        let (mass, speed) = (rng.random_range(5.0..120.0), rng.random_range(0.3..2.0));
        let e = rng.random_range(0.1..0.95);
        let contact = CompliantContact::on_curve(mass, &curve).expect("a contact");
        for (law, separation) in [
            (Law::HuntCrossley, Separation::ForceVanishes),
            (Law::KelvinVoigt, Separation::ForceVanishes),
            (Law::KelvinVoigt, Separation::GapCloses),
        ] {
            let damper = law.damper(contact, e, Some(speed), separation).expect("a damper");
            let found = damper.impact(contact, speed).expect("an impact");
            let force = |x: f64, v: f64| damper.force(contact, x, v);
            let ends_without_force = law == Law::KelvinVoigt && separation == Separation::ForceVanishes;
            // 40,000 steps: errors of the last step and of the peaks of 1e-8.
            let step = found.duration.expect("an end") / 4e4;
            let [restitution, depth, peak, duration, lost] =
                integrated((&force, curve.deflections()), (mass, speed), ends_without_force, step);
            let what = format!("{case} {law:?} {separation:?}: {found:?}");
            assert!((found.restitution - e).abs() < 1e-9, "{what}");
            assert!((restitution - e).abs() < 1e-6, "{restitution} {what}");
            assert!((depth / found.max_penetration - 1.0).abs() < 1e-6, "{depth} {what}");
            assert!((peak / found.peak_force - 1.0).abs() < 1e-5, "{peak} {what}");
            assert!((duration / found.duration.unwrap() - 1.0).abs() < 1e-5, "{duration} {what}");
            // The work of the damper, and the energy that the spring keeps if the force vanishes at a penetration.
            if !ends_without_force {
                assert!((lost / found.energy_lost - 1.0).abs() < 1e-5, "{lost} {what}");
            }
            let samples = damper.history(contact, speed, 300).expect("a history");
            let last = samples.last().expect("an end");
            assert!((last.time - found.duration.unwrap()).abs() < 1e-9 * last.time, "{what}");
            assert!((last.rate + e * speed).abs() < 1e-6 * speed, "{what}");
            let profile = [(0.0, mass), (0.1, mass)];
            let stepped =
                impact_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end");
            assert!((stepped.restitution - e).abs() < 2e-6, "{stepped:?} {what}");
            assert!((stepped.peak_force / found.peak_force - 1.0).abs() < 1e-5, "{stepped:?} {what}");
        }
    }
}

/// A straight curve is a linear spring, and the restitution of Hunt and Crossley's law does not depend on the curve.
#[test]
fn a_straight_curve_is_a_linear_spring() {
    let curve = ForceCurve::new(vec![0.0, 0.001, 0.004, 0.02], vec![0.0, 100.0, 400.0, 2000.0]).unwrap();
    let (on_curve, linear) =
        (CompliantContact::on_curve(30.0, &curve).unwrap(), CompliantContact::new(30.0, 1e5).unwrap());
    for e in [0.05, 0.3, 0.9, 1.0] {
        for law in [Law::HuntCrossley, Law::KelvinVoigt] {
            let impact = |contact: CompliantContact| {
                let damper = law.damper(contact, e, Some(0.7), Separation::ForceVanishes).expect("a damper");
                damper.impact(contact, 0.7).expect("an impact")
            };
            let (a, b) = (impact(on_curve), impact(linear));
            let tolerance = if law == Law::HuntCrossley { 1e-11 } else { 2e-6 };
            for (x, y) in [
                (a.restitution, b.restitution),
                (a.max_penetration, b.max_penetration),
                (a.peak_force, b.peak_force),
                (a.duration.unwrap(), b.duration.unwrap()),
                (a.time_of_max_penetration, b.time_of_max_penetration),
            ] {
                assert!((x / y - 1.0).abs() < tolerance, "{law:?} {e}: {x} {y}");
            }
        }
    }
    let number = hunt_crossley::dissipation_number(0.3).unwrap();
    let damper = Law::HuntCrossley.damper(on_curve, 0.3, Some(0.7), Separation::ForceVanishes).unwrap();
    assert_eq!(damper, Damper::HuntCrossley { dissipation: number / 0.7 });
}

/// The spring of every tool has the restitution and the penetration of the curve.
#[test]
fn tools_get_a_spring_with_the_penetration_of_the_curve() {
    let curve = ForceCurve::new(vec![0.0, 0.005, 0.01, 0.015], vec![0.0, 300.0, 1500.0, 6000.0]).unwrap();
    let contact = CompliantContact::on_curve(73.4, &curve).unwrap();
    let request = Request::new(contact, 0.3).at(1.0);
    let damper = Law::HuntCrossley.damper(contact, 0.3, Some(1.0), Separation::ForceVanishes).unwrap();
    let depth = damper.impact(contact, 1.0).unwrap().max_penetration;
    let (mut compared, mut stated_peaks) = (0, 0);
    for tool in Tool::ALL {
        let mut request = request;
        (request.options.own_mass, request.options.other_own_mass) = (Some(40.0), Some(1000.0));
        let Ok(export) = tool.export(&request) else { continue };
        for penetration in export.penetrations.iter().take(1) {
            assert!((penetration.value / depth - 1.0).abs() < 1e-9, "{}: {export:?}", tool.name());
            assert!(export.assumptions.iter().any(|a| a.contains("in place of")), "{}", tool.name());
            compared += 1;
        }
        // The stated peak force is that of the spring and the damper of the tool: Newton's damper acts on approach only, that of Exudyn is for
        // a contact that ends when the gap closes.
        let names = match tool.name() {
            "newton" => ("ke", "kd"),
            "exudyn" => ("contactStiffness", "contactDamping"),
            "simscape" => ("Stiffness", "Damping"),
            _ => continue,
        };
        let (k, c) = (export.number(names.0).unwrap(), export.number(names.1).unwrap());
        let (mut state, mut peak, step) = ((0.0, 1.0), 0.0_f64, 1e-7);
        while state.1 > 0.0 {
            // Leapfrog with the rate in the middle of the step.
            let force = k * state.0 + c * state.1;
            peak = peak.max(force);
            state.1 -= step * force / 73.4;
            state.0 += step * state.1;
        }
        let stated = export.assumptions.iter().find_map(|a| a.split("peak force is ").nth(1)).unwrap();
        let stated: f64 = stated.split(' ').next().unwrap().parse().unwrap();
        assert!((stated / peak - 1.0).abs() < 1e-4, "{}: {stated} {peak}", tool.name());
        stated_peaks += 1;
    }
    assert!(compared >= 10 && stated_peaks == 3, "{compared} tools");
}

/// The code of a tool has the points of the curve and a dissipation with which the impact on these points has the required restitution.
#[test]
fn code_of_tools_has_the_curve() {
    let points = ForceCurve::new(vec![0.0, 0.01, 0.02, 0.03], vec![0.0, 300.0, 1500.0, 4000.0]).unwrap();
    let powers = ForceCurve::powers(vec![(2e4, 1.0), (9e7, 3.0)], 0.04).unwrap();
    for (curve, tolerance) in [(&points, 1e-9), (&powers, 1e-3)] {
        let contact = CompliantContact::on_curve(150.0, curve).unwrap();
        let mut request = Request::new(contact, 0.3).at(1.0);
        request.options.own_mass = Some(150.0);
        let exact = Law::HuntCrossley.damper(contact, 0.3, Some(1.0), Separation::ForceVanishes).unwrap();
        let exact = exact.impact(contact, 1.0).unwrap();
        for tool in [Tool::ADAMS, Tool::CHRONO, Tool::DRAKE, Tool::EXUDYN, Tool::SIMSCAPE] {
            let export = tool.export(&request).unwrap();
            let code = export.snippets.iter().find(|snippet| snippet.title == "force curve").expect("code");
            let numbers = |text: &str| -> Vec<f64> {
                text.split([',', '\n']).filter_map(|word| word.trim().parse().ok()).collect()
            };
            let between = |from: &str, to: &str| {
                let rest = code.text.split_once(from).expect("a beginning").1;
                rest.split_once(to).expect("an end").0.to_owned()
            };
            let [start, end] = if tool == Tool::ADAMS {
                [["X = ", ", Y"], ["Y = ", "SFORCE"]]
            } else if tool == Tool::CHRONO {
                [["x[] = {", "}"], ["f[] = {", "}"]]
            } else if tool == Tool::SIMSCAPE {
                [["deflections = {[", "]"], ["forces = {[", "]"]]
            } else {
                [["DEFLECTIONS = [", "]"], ["FORCES = [", "]"]]
            };
            let [x, f] = [start, end].map(|[from, to]| numbers(&between(from, to)));
            let read = ForceCurve::new(x, f).unwrap();
            let factor = match tool {
                tool if [Tool::ADAMS, Tool::CHRONO].contains(&tool) => "(1 - ",
                tool if tool == Tool::SIMSCAPE => "dissipation = {",
                _ => "(1 + ",
            };
            let text = code.text.replace("(1-", "(1 - ");
            let dissipation = text.split_once(factor).expect("a factor").1;
            let dissipation: f64 = dissipation.split(['*', ' ', ',']).next().unwrap().parse().unwrap();
            let contact = CompliantContact::on_curve(150.0, &read).unwrap();
            let found = Damper::hunt_crossley(dissipation).unwrap().impact(contact, 1.0).unwrap();
            let close = |a: f64, b: f64| (a / b - 1.0).abs() < tolerance;
            assert!(close(found.restitution, 0.3), "{tool:?}: {found:?}");
            assert!(close(found.max_penetration, exact.max_penetration), "{tool:?}: {found:?} {exact:?}");
            assert!(close(found.peak_force, exact.peak_force), "{tool:?}: {found:?} {exact:?}");
        }
    }
}

#[test]
fn points_that_are_no_curve_are_refused() {
    let refused =
        |x: &[f64], f: &[f64]| ForceCurve::new(x.to_vec(), f.to_vec()).expect_err("no curve").to_string();
    assert!(refused(&[0.0], &[0.0]).contains("at least 2"));
    assert!(refused(&[0.0, 0.01], &[0.0]).contains("2 deflections and 1 forces"));
    assert!(refused(&[0.001, 0.01], &[0.0, 1.0]).contains("expected 0"));
    assert!(refused(&[0.0, 0.01, 0.01], &[0.0, 1.0, 2.0]).contains("increasing"));
    assert!(refused(&[0.0, 0.01], &[0.0, -1.0]).contains("compression"));
    assert!(refused(&[0.0, f64::NAN], &[0.0, 1.0]).contains("finite"));
    let weak = ForceCurve::new(vec![0.0, 0.01, 0.02], vec![0.0, 100.0, 50.0]).unwrap();
    let contact = CompliantContact::on_curve(50.0, &weak).unwrap();
    let damper = Damper::hunt_crossley(1.0).unwrap();
    let error = damper.impact(contact, 3.0).expect_err("a mass that is not stopped").to_string();
    assert!(error.contains("never does the work"), "{error}");
}

/// Force of a damper: linear between the points, the last slopes beyond them, and never a force that drives the motion.
#[test]
fn a_damper_resists() {
    let curve = DamperCurve::new(vec![-0.5, 0.0, 1.0, 2.0], vec![-300.0, 0.0, 100.0, 50.0]).unwrap();
    // Numbers with few digits: no rounding.
    for (speed, force) in
        [(-1.0, -600.0), (-0.25, -150.0), (0.0, 0.0), (0.5, 50.0), (1.5, 75.0), (2.5, 25.0), (4.0, 0.0)]
    {
        assert_eq!(curve.force(speed), force, "{speed}");
    }
    let refused =
        |v: &[f64], f: &[f64]| DamperCurve::new(v.to_vec(), f.to_vec()).expect_err("no curve").to_string();
    assert!(refused(&[0.0, 1.0], &[0.0]).contains("2 speeds and 1 forces"));
    assert!(refused(&[0.0, 1.0, 1.0], &[0.0, 5.0, 6.0]).contains("a speed of 1 m/s follows 1 m/s"));
    assert!(refused(&[-1.0, 1.0], &[1.0, 2.0]).contains("drives the motion"));
    assert!(refused(&[0.5, 1.0], &[5.0, 6.0]).contains("at rest"));
    assert!(refused(&[0.0, f64::NAN], &[0.0, 1.0]).contains("finite"));
}

/// A sum with one power is the power law, whose restitution and duration come from another formula; a sum of several has the work of its terms.
#[test]
fn a_power_is_the_power_law() {
    let mut rng = StdRng::seed_from_u64(41);
    for _ in 0..40 {
        let (k, p) = (rng.random_range(1e4..1e7), rng.random_range(1.0..3.0));
        let (mass, speed) = (rng.random_range(5.0..120.0), rng.random_range(0.3..2.0));
        let law = CompliantContact::new(mass, k).and_then(|c| c.with_exponent(p)).expect("a contact");
        let damper = Damper::hunt_crossley(rng.random_range(0.05..3.0)).expect("a damper");
        let expected = damper.impact(law, speed).expect("an impact");
        let to = rng.random_range(1.0..3.0) * expected.max_penetration;
        let curve = ForceCurve::powers(vec![(k, p)], to).expect("a curve");
        let found = CompliantContact::on_curve(mass, &curve).and_then(|c| damper.impact(c, speed));
        let found = found.expect("an impact");
        for (found, expected) in [
            (found.restitution, expected.restitution),
            (found.max_penetration, expected.max_penetration),
            (found.peak_force, expected.peak_force),
            (found.duration.expect("an end"), expected.duration.expect("an end")),
        ] {
            // Quadrature over a singular end.
            assert!(
                (found / expected - 1.0).abs() < 1e-9,
                "k {k} p {p} m {mass} v {speed}: {found} {expected}"
            );
        }
        // Beyond the last penetration the slope continues: less force than the power.
        let short = ForceCurve::powers(vec![(k, p)], 0.5 * expected.max_penetration).expect("a curve");
        let softer = CompliantContact::on_curve(mass, &short).and_then(|c| damper.impact(c, speed));
        let softer = softer.expect("an impact");
        assert!(softer.max_penetration >= expected.max_penetration * (1.0 - 1e-12), "p {p}");
        assert!((softer.restitution - expected.restitution).abs() < 1e-12, "no influence of the curve");
    }
    for (powers, to) in [
        (vec![], 0.01),
        (vec![(1e5, 0.5)], 0.01),
        (vec![(1e5, 2.0), (1e3, 1.0)], 0.01),
        (vec![(1e5, 1.0), (-2e7, 2.0)], 0.01),
        (vec![(1e5, 1.0)], 0.0),
        (vec![(f64::NAN, 1.0)], 0.01),
        (vec![(0.0, 1.0)], 0.01),
    ] {
        assert!(ForceCurve::powers(powers.clone(), to).is_err(), "{powers:?}");
    }
}

/// A loss factor gives its restitution on every curve, also with a mass that changes over the penetration; the energy balance gives the largest
/// penetration, and the integration with a step that ends at the reversal the rest.
#[test]
fn a_loss_factor_gives_its_restitution() {
    let mut rng = StdRng::seed_from_u64(19);
    for case in 0..40 {
        let curve = random_curve(&mut rng);
        let (mass, speed) = (rng.random_range(5.0..120.0), rng.random_range(0.3..2.0));
        let e = rng.random_range(0.05..1.0);
        let contact = CompliantContact::on_curve(mass, &curve).expect("a contact");
        let damper = Law::LossFactor.damper(contact, e, None, Separation::ForceVanishes).expect("a damper");
        let Damper::LossFactor { loss_factor } = damper else { panic!("{damper:?}") };
        let h = 0.5 * std::f64::consts::PI * loss_factor;
        let found = damper.impact(contact, speed).expect("an impact");
        let what = format!("{case}: {e} {found:?}");
        // Rounding of e² = (1 − h)/(1 + h).
        assert!((found.restitution - e).abs() < 1e-15 / (e * e), "{what}");
        // Midpoints of 1e5 parts: 1e-10 of a smooth piece, 1e-5 of the part of a corner.
        let (mut work, mut largest, part) = (0.0, 0.0f64, found.max_penetration / 1e5);
        for i in 0..100_000 {
            let force = curve.at((f64::from(i) + 0.5) * part).0;
            (work, largest) = (work + force * part, largest.max(force));
        }
        let kinetic = 0.5 * mass * speed * speed;
        assert!(((1.0 + h) * work / kinetic - 1.0).abs() < 1e-7, "{work} {what}");
        assert!((found.energy_lost / (kinetic - (1.0 - h) * work) - 1.0).abs() < 1e-6 / (1.0 - e), "{what}");
        assert!(((1.0 + h) * largest / found.peak_force - 1.0).abs() < 1e-4, "{largest} {what}");
        for change in [0.0, -0.4, 1.5] {
            let to = 2.0 * found.max_penetration;
            let profile: Vec<(f64, f64)> =
                (0..=16).map(|i| f64::from(i) / 16.0).map(|s| (to * s, mass * (1.0 + change * s))).collect();
            let stepped =
                impact_with_varying_mass(damper, contact, &profile, speed).unwrap().expect("an end");
            assert!((stepped.restitution - e).abs() < 2e-6, "{change} {stepped:?} {what}");
            if change == 0.0 {
                assert!((stepped.max_penetration / found.max_penetration - 1.0).abs() < 1e-6, "{what}");
                assert!((stepped.peak_force / found.peak_force - 1.0).abs() < 1e-5, "{stepped:?} {what}");
                let history = percuss_contact::history_with_varying_mass(damper, contact, &profile, speed);
                let last = *history.unwrap().expect("an end").last().expect("an end");
                assert!((last.time / found.duration.unwrap() - 1.0).abs() < 1e-5, "{last:?} {what}");
            }
        }
        let samples = damper.history(contact, speed, 300).expect("a history");
        let last = samples.last().expect("an end");
        assert!((last.rate + e * speed).abs() < 1e-9 * speed / (e * e), "{what}");
    }
    for wrong in [-0.1, 2.0 / std::f64::consts::PI, f64::NAN] {
        assert!(Damper::loss_factor(wrong).is_err(), "{wrong}");
    }
    let linear = CompliantContact::new(3.0, 2e4).expect("a contact");
    let refused =
        Law::LossFactor.damper(linear, 0.0, None, Separation::ForceVanishes).expect_err("no damper");
    assert!(refused.to_string().contains("no force is left for the return"), "{refused}");
}
