//! Several simultaneous contacts: balls in a row, a rod on two stops.

use nalgebra::{DMatrix, DVector};
use percuss_impact::{
    ContactStiffness, ImpactError, SimultaneousImpact, SimultaneousLaw, simultaneous_impact_of_matrix,
};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// Contacts between neighbours in a row of balls of mass 1, the first of which moves with the speed 1.
fn row_of_balls(count: usize) -> (DMatrix<f64>, DVector<f64>) {
    let k = count - 1;
    let w = DMatrix::from_fn(k, k, |r, c| match r.abs_diff(c) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    });
    let mut u = DVector::zeros(k);
    u[0] = -1.0;
    (w, u)
}

/// Velocities of the balls after the impact.
fn balls_after(impact: &SimultaneousImpact) -> Vec<f64> {
    let p = &impact.solution;
    let count = p.len() + 1;
    let of = |i: usize| if i < p.len() { p[i] } else { 0.0 };
    (0..count).map(|i| f64::from(u8::from(i == 0)) - of(i) + if i > 0 { of(i - 1) } else { 0.0 }).collect()
}

fn stiffness(ratios: &[f64], exponent: f64) -> ContactStiffness {
    ContactStiffness { ratios: ratios.to_vec(), exponent }
}

fn solve(
    w: &DMatrix<f64>,
    u: &DVector<f64>,
    e: f64,
    law: SimultaneousLaw,
    stiffness: &ContactStiffness,
) -> SimultaneousImpact {
    simultaneous_impact_of_matrix(w, u, &vec![e; u.len()], law, stiffness).expect("an impact")
}

#[test]
fn three_balls() {
    let (w, u) = row_of_balls(3);
    let energetic = |ratios: &[f64], exponent| {
        balls_after(&solve(&w, &u, 1.0, SimultaneousLaw::Energetic, &stiffness(ratios, exponent)))
    };
    let close = |found: &[f64], expected: [f64; 3], limit: f64| {
        for (a, b) in found.iter().zip(expected) {
            assert!((a - b).abs() < limit, "{found:?} {expected:?}");
        }
    };
    // Two equal linear springs, in closed form, and two equal Hertzian contacts.
    close(&energetic(&[1.0, 1.0], 1.0), [-0.130_261_695, 0.150_229_569, 0.980_032_126], 1e-9);
    close(&energetic(&[1.0, 1.0], 1.5), [-0.070_952_4, 0.076_403_1, 0.994_549_3], 1e-7);
    // From a soft to a hard second contact the last ball gets from 1 to 2/3 of the speed.
    let last = |ratio: f64| energetic(&[1.0, ratio], 1.0)[2];
    assert!(
        (last(1e-4) - 1.0).abs() < 1e-3 && (last(1e4) - 2.0 / 3.0).abs() < 1e-3,
        "{} {}",
        last(1e-4),
        last(1e4)
    );
    // Newton and Poisson without stiffness. Newton: balls 2 and 3 separate with e · 0.
    let none = stiffness(&[1.0, 1.0], 1.0);
    let newton = balls_after(&solve(&w, &u, 1.0, SimultaneousLaw::Newton, &none));
    close(&newton, [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0], 1e-12);
    let poisson = balls_after(&solve(&w, &u, 1.0, SimultaneousLaw::Poisson, &none));
    close(&poisson, [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0], 1e-12);
}

#[test]
fn energy_is_kept_by_e_one_and_the_momentum_by_all() {
    for count in [2, 4, 10] {
        let (w, u) = row_of_balls(count);
        for exponent in [1.0, 1.5] {
            for law in SimultaneousLaw::ALL {
                let found = solve(&w, &u, 1.0, law, &stiffness(&vec![1.0; count - 1], exponent));
                let v = balls_after(&found);
                assert!((v.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                let energy = 0.5 * v.iter().map(|v| v * v).sum::<f64>();
                assert!((0.5 - energy - found.energy_loss).abs() < 1e-12, "{count} {}", law.name());
                assert!(found.energy_loss.abs() < 1e-10, "{count} {}: {:e}", law.name(), found.energy_loss);
                assert!(!found.creates_energy);
                assert!(found.after.iter().all(|u| *u > -1e-10), "{:?}", found.after);
            }
        }
    }
    // Ten Hertzian balls of the validation of Siconos: 0.985956 there, with an energy error of 2.6e-5.
    let (w, u) = row_of_balls(10);
    let found = solve(&w, &u, 1.0, SimultaneousLaw::Energetic, &stiffness(&[1.0; 9], 1.5));
    let last = balls_after(&found)[9];
    assert!((last - 0.985_866).abs() < 1e-6, "{last}");
}

/// No law lets the sides of a closed contact move into each other, whether the contact closes, rests or opens before.
#[test]
fn no_contact_closes_after_the_impact() {
    let mut random = StdRng::seed_from_u64(5);
    let mut opening = 0;
    for _ in 0..2000 {
        let k = random.random_range(2..5);
        let a = DMatrix::from_fn(k, k, |_, _| random.random_range(-1.0..1.0));
        let w = &a * a.transpose() + DMatrix::identity(k, k) * 0.1;
        let mut u = DVector::from_fn(k, |_, _| random.random_range(-1.0..1.0));
        u[0] = -1.0;
        opening += usize::from(u.iter().any(|u| *u > 0.0));
        let e = random.random_range(0.01..1.0);
        for law in SimultaneousLaw::ALL {
            let found = solve(&w, &u, e, law, &stiffness(&vec![1.0; k], 1.0));
            assert!(found.after.iter().all(|u| *u > -1e-9), "{}: {w} {u} {:?}", law.name(), found.after);
        }
    }
    assert!(opening > 1000, "{opening}");
}

#[test]
fn a_rod_on_two_stops() {
    // Free uniform rod of mass 1 and length 2 falls without turning on stops at x₁ and x₂.
    let rod = |x1: f64, x2: f64| {
        let entry = |a: f64, b: f64| 1.0 + 3.0 * a * b;
        DMatrix::from_row_slice(2, 2, &[entry(x1, x1), entry(x1, x2), entry(x2, x1), entry(x2, x2)])
    };
    let u = DVector::from_element(2, -1.0);
    let equal = stiffness(&[1.0, 1.0], 1.0);
    for e in [0.2, 0.5, 0.9] {
        let mut spread = 0.0_f64;
        for (x1, x2) in [(-1.0, 1.0), (-0.9, 0.4), (-0.3, 0.8), (-0.2, 0.3)] {
            let w = rod(x1, x2);
            let of = |law| solve(&w, &u, e, law, &equal);
            let newton = of(SimultaneousLaw::Newton);
            // With two stops that both transmit, Newton reverses both speeds.
            assert!(newton.after.iter().all(|v| (v - e).abs() < 1e-12), "{newton:?}");
            let energetic = of(SimultaneousLaw::Energetic);
            assert!(energetic.energy_loss > 0.0 && !energetic.creates_energy);
            spread = (0..2).fold(spread, |most, i| most.max((energetic.after[i] - e).abs()));
            if x1 == -x2 {
                // Both contacts are one by symmetry.
                for law in SimultaneousLaw::ALL {
                    assert!(of(law).after.iter().all(|v| (v - e).abs() < 1e-10), "{}", law.name());
                }
            }
        }
        assert!(spread > 0.01, "{e}: {spread}");
    }
}

#[test]
fn elastic_linear_contacts_follow_their_modes() {
    // Second algorithm for e = 1 and linear springs while both contacts last: δ″ = −W K δ by the modes of W K, up to the first
    // separation; after it only one contact remains. Both separate at once for the symmetric rod, so the first case is general.
    let w = DMatrix::from_row_slice(2, 2, &[2.0, -1.0, -1.0, 2.0]);
    let u = DVector::from_vec(vec![-1.0, 0.0]);
    let depth = |t: f64| {
        // Modes (1, 1)/√2 with ω² = 1 and (1, −1)/√2 with ω² = 3.
        let (slow, fast) = (0.5 * t.sin(), 0.5 * (3.0_f64.sqrt() * t).sin() / 3.0_f64.sqrt());
        (slow + fast, slow - fast)
    };
    // The first contact separates at its first zero after t = 1.
    let (mut low, mut high) = (1.0, 3.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if depth(middle).0 > 0.0 { low = middle } else { high = middle }
    }
    let t = low;
    let root = 3.0_f64.sqrt();
    let rate = (0.5 * t.cos() + 0.5 * (root * t).cos(), 0.5 * t.cos() - 0.5 * (root * t).cos());
    // Then the second alone: δ₂″ = −2 δ₂ up to its zero; the energy gives its speed.
    let second = (rate.1 * rate.1 + 2.0 * depth(t).1 * depth(t).1).sqrt();
    let impact = solve(&w, &u, 1.0, SimultaneousLaw::Energetic, &stiffness(&[1.0, 1.0], 1.0));
    assert!((impact.after[1] - second).abs() < 1e-10, "{:?} {second}", impact.after);
    // u₁ after: its own speed at separation, changed by the impulse of the second contact since then.
    let first = -rate.0 - 0.5 * (second + rate.1);
    assert!((impact.after[0] - first).abs() < 1e-10, "{:?} {first}", impact.after);
}

#[test]
fn redundant_contacts_leave_impulses_open() {
    // A massive bar on three stops: two freedoms, three impulses.
    let x = [-1.0, 0.0, 1.0];
    let w = DMatrix::from_fn(3, 3, |r, c| 1.0 + 3.0 * x[r] * x[c]);
    let u = DVector::from_element(3, -1.0);
    let equal = stiffness(&[1.0; 3], 1.0);
    let newton = solve(&w, &u, 0.5, SimultaneousLaw::Newton, &equal);
    assert!(newton.impulses.iter().all(Option::is_none), "{newton:?}");
    assert!(newton.after.iter().all(|v| (v - 0.5).abs() < 1e-12));
    let energetic = solve(&w, &u, 0.5, SimultaneousLaw::Energetic, &equal);
    assert!(energetic.impulses.iter().all(Option::is_some));
    assert!(energetic.after.iter().all(|v| (v - 0.5).abs() < 1e-9), "{energetic:?}");
}

/// Plastic contacts: a single one stops, independent ones stop, and coupled ones are the limit of e → 0, to the first order in e: the
/// duration of an expansion is proportional to e.
#[test]
fn plastic_contacts_of_the_energetic_law_are_a_limit() {
    let law = SimultaneousLaw::Energetic;
    let single = DMatrix::from_element(1, 1, 0.5);
    let found = solve(&single, &DVector::from_element(1, -2.0), 0.0, law, &stiffness(&[1.0], 1.5));
    assert!((found.solution[0] - 4.0).abs() < 1e-10 && found.after[0].abs() < 1e-10, "{found:?}");
    assert!((found.energy_loss - 4.0).abs() < 1e-10, "{found:?}");
    for count in [3, 4, 6] {
        for exponent in [1.0, 1.5] {
            for ratio in [0.1, 1.0, 7.0] {
                let (w, u) = row_of_balls(count);
                let ratios: Vec<f64> = (0..count - 1).map(|k| if k % 2 == 0 { 1.0 } else { ratio }).collect();
                let stiffness = stiffness(&ratios, exponent);
                let plastic = solve(&w, &u, 0.0, law, &stiffness);
                assert!(plastic.after.iter().all(|u| *u > -2e-10), "{plastic:?}");
                // Perfectly plastic balls keep momentum, and lose no more than the energy of the relative motion.
                let v = balls_after(&plastic);
                let n = count as f64;
                assert!((v.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{v:?}");
                assert!(plastic.energy_loss > 0.0 && plastic.energy_loss <= 0.5 * (1.0 - 1.0 / n) + 1e-12);
                let differences = [0.04, 0.02, 0.01].map(|e| {
                    let near = solve(&w, &u, e, law, &stiffness);
                    (&near.solution - &plastic.solution).amax()
                });
                assert!(differences[2] < 0.03, "{differences:?}");
                // Without an expansion that others interrupt the impulses are equal to the remaining closing speed, 1e-10.
                let limit = |k: usize| 0.7 * differences[k] + 2e-10;
                assert!(differences[1] < limit(0) && differences[2] < limit(1), "{differences:?}");
            }
        }
    }
}

#[test]
fn invalid_values_are_refused() {
    let (w, u) = row_of_balls(3);
    let equal = stiffness(&[1.0, 1.0], 1.0);
    let law = SimultaneousLaw::Energetic;
    let solve = |u: &DVector<f64>, e: &[f64], s: &ContactStiffness| {
        simultaneous_impact_of_matrix(&w, u, e, law, s).expect_err("an error")
    };
    assert!(matches!(solve(&u, &[1.0], &equal), ImpactError::ContactValues { .. }));
    assert!(matches!(solve(&u, &[1.0, 0.005], &equal), ImpactError::OutOfRange { .. }));
    assert!(matches!(solve(&u, &[1.0, 1.5], &equal), ImpactError::Restitution { .. }));
    assert!(matches!(solve(&-&u, &[1.0, 1.0], &equal), ImpactError::ClosingSpeed { .. }));
    assert!(matches!(solve(&u, &[1.0, 1.0], &stiffness(&[1.0, -1.0], 1.0)), ImpactError::OutOfRange { .. }));
    assert!(matches!(solve(&u, &[1.0, 1.0], &stiffness(&[1.0, 1.0], 0.5)), ImpactError::OutOfRange { .. }));
}
