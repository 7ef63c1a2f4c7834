//! Friction at one contact: rods, sphere, double pendulum, contacts in space, mechanisms.

use crate::cases::all;
use nalgebra::{DVector, Matrix3, Vector2, Vector3};
use percuss_dynamics::EffectiveMass;
use percuss_impact::{
    Delassus, FrictionLaw, ImpactError, PhaseKind, RestitutionLaw, RigidImpact, friction_thresholds,
    frictional_collision, jamming_threshold, sticking_threshold,
};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// Rounding of sums of a few products of order one, over the impulse or energy.
const ROUNDING: f64 = 1e-12;

const PROCESS_LAWS: [RestitutionLaw; 3] =
    [RestitutionLaw::Energetic, RestitutionLaw::Poisson, RestitutionLaw::Newton];

/// Free rod of mass 1 at the angle θ above the surface, in the plane.
fn rod(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    let coupling = -3.0 * s * c;
    Matrix3::new(1.0 + 3.0 * c * c, coupling, 0.0, coupling, 1.0 + 3.0 * s * s, 0.0, 0.0, 0.0, 0.0)
}

/// Direct computation of the process by the times of its events, as a separate program: velocities are linear and the
/// work is summed by the trapezoid, which is exact. Returns the impulse.
fn process(w: &Matrix3<f64>, before: &Vector3<f64>, friction: f64, e: f64) -> Vector2<f64> {
    let (nn, nt, tt) = (w[(0, 0)], w[(0, 1)], w[(1, 1)]);
    // Direction of the friction while sliding and after it.
    let sliding = before[1].signum() * f64::from(u8::from(before[1] != 0.0));
    let after = if nt.abs() <= friction * tt { -nt / tt } else { -friction * nt.signum() };
    let first = if sliding == 0.0 { after } else { -friction * sliding };
    let stop = {
        let rate = nt + tt * first;
        if sliding != 0.0 && rate * sliding < 0.0 { -before[1] / rate } else { f64::INFINITY }
    };
    let stop = if sliding == 0.0 { 0.0 } else { stop };
    // u_n(p): slope α₁ up to `stop`, then α₂.
    let (a1, a2) = (nn + nt * first, nn + nt * after);
    let at_stop = before[0] + if stop.is_finite() { a1 * stop } else { 0.0 };
    let velocity = |p: f64| if p <= stop { before[0] + a1 * p } else { at_stop + a2 * (p - stop) };
    let compression = if a1 > 0.0 && -before[0] / a1 <= stop { -before[0] / a1 } else { stop - at_stop / a2 };
    let work = |p: f64| {
        let q = p.min(stop);
        0.5 * q * (velocity(0.0) + velocity(q)) + 0.5 * (p - q) * (velocity(q) + velocity(p))
    };
    // Stronge: W(p) = (1 − e²) W(p_c), by bisection on the increasing branch.
    let wanted = (1.0 - e * e) * work(compression);
    let (mut low, mut high) = (compression, 2.0 * compression);
    while work(high) < wanted {
        high *= 2.0;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if work(middle) < wanted { low = middle } else { high = middle }
    }
    let q = high.min(stop);
    Vector2::new(high, first * q + after * (high - q))
}

#[test]
fn the_rod_over_the_grid() {
    let (mut cases, mut jams, mut newton, mut algebraic) = (0, 0, 0, 0);
    let mut sequences = std::collections::BTreeSet::new();
    for angle in [5.0_f64, 15.0, 30.0, 45.0, 55.0, 63.4, 70.0, 80.0, 89.0] {
        let w = rod(angle.to_radians());
        for mu in [0.0, 0.1, 0.3, 0.5, 0.8, 1.0, 1.3, 1.5, 2.0, 4.0] {
            for e in [0.0, 0.3, 0.7, 1.0] {
                for slip in [-5.0, -1.0, -0.3, -0.05, 0.0, 0.05, 0.3, 1.0, 5.0] {
                    let before = Vector3::new(-1.0, slip, 0.0);
                    cases += 1;
                    for law in PROCESS_LAWS {
                        let found = frictional_collision(&w, &before, mu, e, law).expect("an impact");
                        let size = found.impulse.norm();
                        // The velocities follow from the impulse, and the energy from both.
                        let after = before + w * found.impulse;
                        assert!((after - found.after).norm() < ROUNDING * size, "{angle} {mu} {e} {slip}");
                        assert!(found.impulse[1].abs() <= mu * found.impulse[0] + ROUNDING * size);
                        let sum: f64 = found.phases.iter().map(|p| p.normal_impulse).sum();
                        assert!((sum - found.impulse[0]).abs() < ROUNDING * size);
                        match law {
                            RestitutionLaw::Newton => {
                                newton += usize::from(found.energy_change > ROUNDING);
                                assert!((found.after[0] - e).abs() < ROUNDING * size);
                            }
                            _ => assert!(found.energy_change < ROUNDING, "{}", law.name()),
                        }
                        if law == RestitutionLaw::Energetic {
                            let [inward, outward] = found.normal_work;
                            assert!((outward + e * e * inward).abs() < ROUNDING * size);
                            let other = process(&w, &before, mu, e);
                            let error = (other - Vector2::new(found.impulse[0], found.impulse[1])).norm();
                            // The bisection of a work that is flat at e = 0 has half the digits.
                            let limit = if e == 0.0 { 1e-7 } else { ROUNDING };
                            assert!(error < limit * size, "{angle} {mu} {e} {slip}: {error:e}");
                            jams += usize::from(found.phases.iter().any(|p| p.kind == PhaseKind::Jam));
                            let names: Vec<&str> = found.phases.iter().map(|p| p.kind.name()).collect();
                            sequences.insert(names.join(", "));
                        }
                    }
                    if let Ok(found) = frictional_collision(&w, &before, mu, e, RestitutionLaw::Algebraic) {
                        algebraic += usize::from(found.energy_change > ROUNDING);
                    }
                }
            }
        }
    }
    println!(
        "{cases} cases, {jams} jams, energy created by Newton {newton}, algebraic {algebraic}: {sequences:?}"
    );
    assert_eq!(cases, 3240);
    assert!(jams > 50 && newton > 50 && algebraic > 50, "{jams} {newton} {algebraic}");
    // Slip, stick and reverse slip within both stages, and jams that end in sticking.
    assert!(sequences.len() >= 8, "{sequences:?}");
    assert!(
        sequences.contains("jam, stick, stick") && sequences.contains("slip, reverse slip, reverse slip")
    );
}

#[test]
fn painleve_begins_at_four_thirds() {
    // µ_j = (tan θ + 4/tan θ)/3 is smallest at tan θ = 2; µ_s = 3 s c/(1 + 3 s²).
    let least = 2.0_f64.atan();
    assert!((jamming_threshold(&rod(least)).expect("a jam") - 4.0 / 3.0).abs() < 1e-15);
    for angle in [0.3, 0.8, 1.0, 1.2, 1.4_f64] {
        let (s, c) = angle.sin_cos();
        let jam = jamming_threshold(&rod(angle)).expect("a jam");
        assert!((jam - (s / c + 4.0 * c / s) / 3.0).abs() < 1e-14 && jam >= 4.0 / 3.0);
        let stick = sticking_threshold(&rod(angle)).expect("a threshold");
        assert!((stick - 3.0 * s * c / (1.0 + 3.0 * s * s)).abs() < 1e-14);
        // Just above the threshold the friction accelerates the approach, and just below it does not. In the rod, sliding
        // against the coupling jams.
        for (mu, jams) in [(0.999 * jam, false), (1.001 * jam, true)] {
            let found = frictional_collision(
                &rod(angle),
                &Vector3::new(-1.0, -2.0, 0.0),
                mu,
                0.5,
                RestitutionLaw::Energetic,
            );
            let first = found.expect("an impact").phases[0].kind;
            assert_eq!(first == PhaseKind::Jam, jams, "{angle} {mu}");
        }
    }
    assert_eq!(jamming_threshold(&Matrix3::identity()), None);
}

/// The thresholds are ratios of mobilities: they do not depend on the unit of mass. A coupling by rounding is none in every unit.
#[test]
fn thresholds_do_not_depend_on_the_unit_of_mass() {
    for unit in [1e-9, 1e-3, 1e3, 1e9] {
        for angle in [0.3, 0.8, 1.4] {
            let [scaled, plain] = [rod(angle) * unit, rod(angle)];
            for threshold in [jamming_threshold, sticking_threshold] {
                let [a, b] = [&scaled, &plain].map(|mobility| threshold(mobility).expect("a threshold"));
                assert!((a / b - 1.0).abs() < 1e-14, "{unit} {angle}: {a} {b}");
            }
        }
        let mut nearly_free = Matrix3::identity() * unit;
        (nearly_free[(1, 0)], nearly_free[(0, 1)]) = (1e-15 * unit, 1e-15 * unit);
        assert_eq!(jamming_threshold(&nearly_free), None, "{unit}");
    }
}

#[test]
fn a_sphere_stops_sliding_within_the_cone() {
    // A solid sphere of mass 1: a_tt = 7/2. It sticks if |u_t| ≤ 7/2 µ (1+e) |u_n|, in every direction.
    let w = Matrix3::from_diagonal(&Vector3::new(1.0, 3.5, 3.5));
    for (mu, e) in [(0.2, 0.5), (0.4, 0.9), (0.1, 0.0)] {
        let limit = 3.5 * mu * (1.0 + e);
        for (part, sticks) in [(0.5, true), (0.999_999, true), (1.000_001, false), (3.0, false)] {
            for turn in [0.0_f64, 1.0, 2.5] {
                let slip = Vector2::new(turn.cos(), turn.sin()) * limit * part;
                let before = Vector3::new(-1.0, slip[0], slip[1]);
                for law in RestitutionLaw::ALL {
                    let found = frictional_collision(&w, &before, mu, e, law).expect("an impact");
                    assert!((found.impulse[0] - (1.0 + e)).abs() < ROUNDING);
                    assert!((found.after[0] - e).abs() < ROUNDING, "{}", law.name());
                    let rest = found.after[1].hypot(found.after[2]);
                    let expected = if sticks { 0.0 } else { limit * (part - 1.0) };
                    assert!((rest - expected).abs() < ROUNDING, "{mu} {part} {}: {rest}", law.name());
                }
            }
        }
    }
}

#[test]
fn the_double_pendulum_of_kane_gains_energy_by_the_algebraic_form() {
    // Uniform rods of 1 m and 1 kg at 20° and 30° from the vertical, −0.1 and −0.2 rad/s, µ = e = 0.5 (Kane and Levinson 1985).
    let (a, b) = (20.0_f64.to_radians(), 30.0_f64.to_radians());
    let coupling = 0.5 * (b - a).cos();
    let mass = nalgebra::Matrix2::new(4.0 / 3.0, coupling, coupling, 1.0 / 3.0);
    let jacobian = nalgebra::Matrix2::new(a.sin(), b.sin(), a.cos(), b.cos());
    let block = jacobian * mass.try_inverse().expect("regular") * jacobian.transpose();
    let mut w = Matrix3::zeros();
    w.fixed_view_mut::<2, 2>(0, 0).copy_from(&block);
    let rates = Vector2::new(-0.1, -0.2);
    let u = jacobian * rates;
    let before = Vector3::new(u[0], u[1], 0.0);
    let energy = 0.5 * (rates.transpose() * mass * rates)[0];
    assert!((energy - 0.023_181_4).abs() < 5e-8);
    let change = |law| frictional_collision(&w, &before, 0.5, 0.5, law).expect("an impact");
    for (law, expected) in [
        (RestitutionLaw::Algebraic, 0.013_619_0),
        (RestitutionLaw::Newton, -0.006_093_2),
        (RestitutionLaw::Poisson, -0.010_545_7),
        (RestitutionLaw::Energetic, -0.010_357_7),
    ] {
        let found = change(law);
        assert!((found.energy_change - expected).abs() < 5e-8, "{}: {}", law.name(), found.energy_change);
    }
    let energetic = change(RestitutionLaw::Energetic);
    assert!((energetic.impulse[0] - 0.118_399_7).abs() < 5e-8, "{}", energetic.impulse);
    assert!((energetic.impulse[1].abs() - 0.038_256_5).abs() < 5e-8, "{}", energetic.impulse);
}

/// Random positive definite mobility.
fn random_mobility(rng: &mut StdRng) -> Matrix3<f64> {
    let root = Matrix3::from_fn(|_, _| rng.random_range(-1.0..1.0));
    root * root.transpose() + Matrix3::identity() * 0.05
}

/// Plain integration over the normal impulse with the classical Runge–Kutta method, in Cartesian components. Valid while the
/// point slides.
fn plain_integration(
    w: &Matrix3<f64>,
    before: &Vector3<f64>,
    mu: f64,
    e: f64,
    steps: usize,
) -> Option<Vector3<f64>> {
    let rate = |u: &Vector3<f64>| {
        let s = Vector2::new(u[1], u[2]).normalize();
        let impulse = Vector3::new(1.0, -mu * s[0], -mu * s[1]);
        (w * impulse, impulse)
    };
    let h = -before[0] / w[(0, 0)] / steps as f64;
    let step = |u: &Vector3<f64>, h: f64| {
        let (a, pa) = rate(u);
        let (b, pb) = rate(&(u + a * (0.5 * h)));
        let (c, pc) = rate(&(u + b * (0.5 * h)));
        let (d, pd) = rate(&(u + c * h));
        let work = h * u[0] + h * h / 6.0 * (a[0] + b[0] + c[0]);
        (u + (a + (b + c) * 2.0 + d) * (h / 6.0), (pa + (pb + pc) * 2.0 + pd) * (h / 6.0), work)
    };
    let (mut u, mut p, mut work, mut compression) = (*before, Vector3::zeros(), 0.0, 0.0);
    for _ in 0..1000 * steps {
        if Vector2::new(u[1], u[2]).norm() < 0.05 {
            return None;
        }
        let is_expansion = u[0] >= 0.0;
        let (next, add, gain) = step(&u, h);
        let over = |v: &Vector3<f64>, total: f64| {
            if is_expansion { total >= -e * e * compression } else { v[0] >= 0.0 }
        };
        if !over(&next, work + gain) {
            (u, p, work) = (next, p + add, work + gain);
            continue;
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let (at, _, gain) = step(&u, middle);
            if over(&at, work + gain) { high = middle } else { low = middle }
        }
        let (next, add, gain) = step(&u, high);
        if is_expansion {
            return Some(p + add);
        }
        (compression, work) = (work + gain, 0.0);
        (u, p) = (next, p + add);
        u[0] = u[0].max(0.0);
    }
    None
}

#[test]
fn contacts_in_space() {
    let mut rng = StdRng::seed_from_u64(77);
    let (mut compared, mut turned, mut stuck) = (0, 0, 0);
    for _ in 0..400 {
        let w = random_mobility(&mut rng);
        let before = Vector3::new(-1.0, rng.random_range(-2.0..2.0), rng.random_range(-2.0..2.0));
        let (mu, e) = (rng.random_range(0.0..1.2), rng.random_range(0.0..1.0));
        for law in PROCESS_LAWS {
            let found = frictional_collision(&w, &before, mu, e, law).expect("an impact");
            // Independent sums: the velocities follow from the impulse.
            let after = before + w * found.impulse;
            let size = before.norm() + after.norm() + (w * found.impulse).norm();
            assert!((after - found.after).norm() < 1e-11 * size, "{:e}", (after - found.after).norm());
            if law != RestitutionLaw::Newton {
                assert!(found.energy_change < ROUNDING);
            }
            assert!(found.impulse[1].hypot(found.impulse[2]) <= mu * found.impulse[0] * (1.0 + ROUNDING));
            stuck += usize::from(found.phases.iter().any(|p| p.kind == PhaseKind::Stick));
        }
        let found = frictional_collision(&w, &before, mu, e, RestitutionLaw::Energetic).expect("an impact");
        let [inward, outward] = found.normal_work;
        assert!((outward + e * e * inward).abs() < 1e-11);
        // The tangent axes are arbitrary.
        let (s, c) = 0.7_f64.sin_cos();
        let turn = Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);
        let other = frictional_collision(
            &(turn * w * turn.transpose()),
            &(turn * before),
            mu,
            e,
            RestitutionLaw::Energetic,
        );
        let error = (turn * found.impulse - other.expect("an impact").impulse).norm();
        assert!(error < 1e-11 * found.impulse.norm(), "{error:e}");
        if let Some(expected) = plain_integration(&w, &before, mu, e, 2000) {
            let error = (expected - found.impulse).norm() / expected.norm();
            assert!(error < 1e-7, "{error:e}");
            compared += 1;
            let angle = |v: &Vector3<f64>| v[2].atan2(v[1]);
            turned += usize::from((angle(&before) - angle(&found.after)).abs() > 0.2);
        }
    }
    println!("{compared} compared, {turned} turned, {stuck} stuck");
    assert!(compared > 100 && turned > 30 && stuck > 100, "{compared} {turned} {stuck}");
}

#[test]
fn integration_agrees_with_the_closed_form_of_the_plane() {
    // A sliding speed out of the plane of 1e-11 of the closing speed: the impact is integrated, and differs by this order.
    let mut compared = 0;
    for angle in [5.0_f64, 20.0, 35.0, 50.0, 63.0, 70.0, 80.0, 88.0] {
        let mut w = rod(angle.to_radians());
        w[(2, 2)] = 1.0;
        for mu in [0.05, 0.3, 0.8, 1.4, 2.5] {
            for e in [0.1, 0.4, 1.0] {
                for slip in [-3.0, -0.4, 0.7, 2.0] {
                    for law in PROCESS_LAWS {
                        let solve = |across: f64| {
                            frictional_collision(&w, &Vector3::new(-1.0, slip, across), mu, e, law)
                                .expect("an end")
                        };
                        let (exact, other) = (solve(0.0), solve(1e-11));
                        let error = (exact.impulse - other.impulse).norm() / exact.impulse.norm();
                        assert!(error < 1e-9, "{angle} {mu} {e} {slip} {}: {error:e}", law.name());
                        compared += 1;
                    }
                }
            }
        }
    }
    assert_eq!(compared, 8 * 5 * 3 * 4 * 3);
}

/// A contact of two motions, one of them oblique: the velocity that sticking with Newton's restitution requires is no sum of both, so that
/// the contact slides and keeps the restitution, at any speed.
#[test]
fn algebraic_friction_keeps_the_restitution_of_oblique_motions() {
    let (oblique, across) = (Vector3::new(1.0, 0.0, 1.0).normalize(), Vector3::y());
    let w = oblique * oblique.transpose() + across * across.transpose();
    for speed in [1e-4, 1.0] {
        for friction in [0.1, 5.0] {
            let before = -speed * (oblique + 0.2 * across);
            let found = frictional_collision(&w, &before, friction, 0.5, RestitutionLaw::Algebraic);
            let after = found.expect("an impact").after[0];
            assert!((after / (-0.5 * before[0]) - 1.0).abs() < ROUNDING, "{speed} {friction}: {after}");
        }
    }
}

#[test]
fn friction_of_mechanisms_balances_momentum_and_energy() {
    let (mut impacts, mut several) = (0, 0);
    for case in all(64) {
        let pose = &case.pose;
        let response = pose.respond(&case.contact).expect("a contact");
        let EffectiveMass::Finite(_) = response.effective_mass else { continue };
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        for coefficient in [-0.1, f64::INFINITY, f64::NAN] {
            let law = FrictionLaw { coefficient, restitution: RestitutionLaw::Energetic };
            let refused = RigidImpact::with_friction(pose, &response, 0.7, 0.4, law, None);
            assert!(matches!(refused, Err(ImpactError::Friction { .. })), "{}: {coefficient}", case.name);
        }
        for law in PROCESS_LAWS {
            let law = FrictionLaw { coefficient: 0.3, restitution: law };
            let impact = match RigidImpact::with_friction(pose, &response, 0.7, 0.4, law, None) {
                Ok(impact) => impact,
                Err(ImpactError::Mobility(_)) => continue,
                Err(error) => panic!("{}: {error}", case.name),
            };
            let friction = impact.friction.as_ref().expect("friction");
            let rates = |rates: &percuss_impact::JointRates| -> DVector<f64> {
                let coordinate = |(joint, k): (Option<percuss_mechanism::JointId>, usize)| match joint {
                    Some(joint) => rates.joint(joint)[k],
                    None if k < 3 => rates.base.angular[k],
                    None => rates.base.linear[k - 3],
                };
                DVector::from_vec(pose.coordinate_joints().into_iter().map(coordinate).collect())
            };
            let (before, after) = (rates(&impact.before), rates(&impact.after));
            let mass = pose.mass_matrix();
            let energy = |u: &DVector<f64>| 0.5 * u.dot(&(&mass * u));
            let fast = after.amax().max(1.0);
            let error = (energy(&before) - energy(&after) - impact.energy_loss).abs() / energy(&before);
            assert!(error < 1e-9 * fast, "{}: {error:e}", case.name);
            // The relative velocity after the impact, from the rates and from the process.
            let Ok(delassus) = Delassus::new(pose, std::slice::from_ref(&response.contact)) else { continue };
            let u = delassus.velocities(pose, &impact.after);
            assert!((u[0] - 0.7 * friction.kinematic_restitution).abs() < 1e-9 * fast, "{}", case.name);
            let own = pose.link_in_root(response.contact.link);
            let sliding = delassus.axes(0) * Vector3::new(0.0, u[1], u[2]);
            let error = (own.vector(&friction.sliding_after) - sliding).norm();
            assert!(error < 1e-8 * fast, "{}: {error:e}", case.name);
            assert!(impact.reactions.residual < 1e-9, "{}", case.name);
            impacts += 1;
            several += usize::from(friction.thresholds.slope.is_none());
        }
    }
    println!("{impacts} impacts, {several} with several motions");
    assert!(impacts > 500 && several > 300, "{impacts} {several}");
}

/// Largest number of steps of a compression: three times those of a frictionless one.
const MOST_COMPRESSION_STEPS: usize = 48_000;

/// Compression of a compliant contact of stiffness `k` with Coulomb friction at constant mobility, integrated in small time steps. Returns
/// the peak normal force and the impulse of compression. `sticks`: false for one relative motion, in which the point slides until the end
/// of compression. `None` if the compression takes more than `MOST_COMPRESSION_STEPS` steps, as near a jam.
fn compliant(
    w: &Matrix3<f64>,
    before: &Vector3<f64>,
    friction: f64,
    k: f64,
    sticks: bool,
) -> Option<(f64, Vector3<f64>)> {
    let (mut u, mut depth, mut impulse) = (*before, 0.0, Vector3::zeros());
    let block = w.fixed_view::<2, 2>(1, 1).into_owned();
    let coupling = Vector2::new(w[(1, 0)], w[(2, 0)]);
    let eigen = block.symmetric_eigen();
    let mut sticking = Vector2::zeros();
    for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        if *value > 1e-12 * eigen.eigenvalues.amax() {
            sticking -= vector * (vector.dot(&coupling) / value);
        }
    }
    let step = 1e-4 / (k * w[(0, 0)]).sqrt();
    let mut peak: f64 = 0.0;
    for _ in 0..MOST_COMPRESSION_STEPS {
        if u[0] >= 0.0 {
            return Some((peak, impulse));
        }
        let force = k * (depth - 0.5 * step * u[0]);
        let slip = Vector2::new(u[1], u[2]);
        // A sliding speed that one step can reverse is zero.
        let stops = sticks && slip.norm() <= friction * force * step * block.norm();
        let tangential = if stops && sticking.norm() <= friction {
            sticking
        } else if stops {
            sticking * (friction / sticking.norm())
        } else {
            -slip * (friction / slip.norm().max(f64::MIN_POSITIVE))
        };
        let change = Vector3::new(1.0, tangential[0], tangential[1]) * (force * step);
        let next = u + w * change;
        depth -= 0.5 * step * (u[0] + next[0]);
        u = next;
        impulse += change;
        peak = peak.max(force);
    }
    None
}

/// The work of compression with friction equals that of a frictionless contact of the equivalent mass m, so the peak force of a linear
/// contact spring is c √(k m). For random mechanisms, peak force and impulse agree with an integration in small time steps; the reactions
/// balance the impulse.
#[test]
fn the_compression_has_the_work_of_its_mass() {
    let (mut cases, mut unfinished) = (0, 0);
    for case in all(2) {
        let pose = &case.pose;
        let response = pose.respond(&case.contact).expect("a contact");
        let EffectiveMass::Finite(mass) = response.effective_mass else { continue };
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let speed = 0.8;
        let law = FrictionLaw { coefficient: 0.3, restitution: RestitutionLaw::Energetic };
        let Ok(impact) = RigidImpact::with_friction(pose, &response, speed, 0.4, law, None) else { continue };
        let friction = impact.friction.expect("friction");
        let Ok(delassus) = Delassus::new(pose, &[response.contact]) else { continue };
        let w = delassus.block(0);
        if w.norm() > 1e3 * w[(0, 0)] {
            continue;
        }
        let velocities = delassus.velocities(pose, &impact.before);
        let before = Vector3::new(-speed, velocities[1], velocities[2]);
        let stiffness = 1e4 * mass;
        let found = compliant(&w, &before, 0.3, stiffness, friction.thresholds.slope.is_none());
        let Some((peak, impulse)) = found else {
            unfinished += 1;
            continue;
        };
        let compression = &friction.compression;
        // Errors of the steps: 1e-4 of the duration, times the ratio of the sliding to the closing speed.
        let expected = speed * (stiffness * compression.equivalent_mass).sqrt();
        assert!((peak / expected - 1.0).abs() < 5e-3, "{}: {peak} {expected}", case.name);
        let normal = impulse[0] / compression.normal_impulse;
        let slope = friction.thresholds.slope;
        assert!((normal - 1.0).abs() < 5e-3, "{}: {normal}, slope {slope:?}, {before}", case.name);
        let tangential = impulse.fixed_rows::<2>(1).norm();
        let expected = compression.tangential_impulse.norm();
        assert!((tangential - expected).abs() < 5e-3 * compression.normal_impulse, "{}", case.name);
        if let Some(slope) = slope {
            let expected = mass / (1.0 + 0.3 * slope);
            assert!((compression.equivalent_mass / expected - 1.0).abs() < ROUNDING, "{}", case.name);
        }
        assert!(compression.reactions.residual < 1e-9, "{}", case.name);
        cases += 1;
    }
    println!("{cases} compressions, {unfinished} without an end of the integration");
    assert!(cases > 80 && 5 * unfinished < cases, "{cases} {unfinished}");
}

/// For random mechanisms, the impact changes at the thresholds. Above its threshold, a contact with one relative motion wedges, a contact
/// without initial sliding sticks, and a sliding contact jams.
#[test]
fn impacts_change_at_the_thresholds() {
    let (mut wedged, mut stuck, mut jammed) = (0, 0, 0);
    for case in all(1) {
        let pose = &case.pose;
        let response = pose.respond(&case.contact).expect("a contact");
        let EffectiveMass::Finite(_) = response.effective_mass else { continue };
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let found = match friction_thresholds(pose, &response) {
            Ok(found) => found,
            Err(ImpactError::Mobility(_)) => continue,
            Err(error) => panic!("{}: {error}", case.name),
        };
        // Factors just below and just above a threshold, outside its rounding.
        let sides = [1.0 - 1e-6, 1.0 + 1e-6];
        if found.slope.is_some() {
            let Some(jamming) = found.jamming else { continue };
            assert_eq!(found.sticking, None, "{}", case.name);
            let is_wedged = sides.map(|side| {
                let law = FrictionLaw { coefficient: jamming * side, restitution: RestitutionLaw::Energetic };
                let impact = RigidImpact::with_friction(pose, &response, 0.7, 0.4, law, None);
                impact.expect("an impact").friction.expect("friction").is_wedged
            });
            assert_eq!(is_wedged, [false, true], "{}", case.name);
            wedged += 1;
            continue;
        }
        let w = Delassus::new(pose, &[response.contact]).expect("a mobility").block(0);
        if w.norm() > 1e3 * w[(0, 0)] {
            continue;
        }
        let first_phase = |friction: f64, sliding: Vector2<f64>| {
            let before = Vector3::new(-1.0, sliding[0], sliding[1]);
            let found = frictional_collision(&w, &before, friction, 0.4, RestitutionLaw::Energetic);
            found.ok().and_then(|found| found.phases.first().map(|phase| phase.kind))
        };
        if let Some(sticking) = found.sticking.filter(|sticking| *sticking > 1e-3) {
            let first = sides.map(|side| first_phase(sticking * side, Vector2::zeros()));
            // A sticking contact without motion along the normal wedges at once.
            let before = Vector3::new(-1.0, 0.0, 0.0);
            let above = sticking * sides[1];
            let stuck_at_once = frictional_collision(&w, &before, above, 0.4, RestitutionLaw::Energetic);
            let sticks =
                first[1] == Some(PhaseKind::Stick) || stuck_at_once.is_ok_and(|found| found.is_wedged);
            assert!(first[0] == Some(PhaseKind::Slip) && sticks, "{}: {first:?}", case.name);
            stuck += 1;
        }
        // Fast sliding along a_tn: the friction accelerates the approach of the sides.
        let coupling = Vector2::new(w[(1, 0)], w[(2, 0)]);
        if let Some(jamming) = found.jamming.filter(|jamming| *jamming < 10.0) {
            let sliding = coupling.normalize() * 1e3;
            let first = sides.map(|side| first_phase(jamming * side, sliding));
            assert_eq!(first[1], Some(PhaseKind::Jam), "{}", case.name);
            assert_ne!(first[0], Some(PhaseKind::Jam), "{}", case.name);
            jammed += 1;
        }
    }
    println!("{wedged} wedge, {stuck} stick, {jammed} jam");
    assert!(wedged > 20 && stuck > 20 && jammed > 20, "{wedged} {stuck} {jammed}");
}
