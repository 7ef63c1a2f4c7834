//! Several simultaneous contacts: balls in a row, a rod on two stops, contacts of which one cannot move or can hardly move.

use crate::cases::all;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Vector2, Vector3};
use percuss_dynamics::{Conditions, Contact, Direction, EffectiveMass, Frame, Pose, System};
use percuss_impact::{
    ContactStiffness, Delassus, ImpactError, JointRates, SimultaneousImpact, SimultaneousLaw,
    simultaneous_impact, simultaneous_impact_of_matrix, sticking_impact,
};
use percuss_mechanism::{Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::sync::Arc;

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

fn vector(rng: &mut StdRng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))
}

/// Two links on two hinges with random axes.
fn two_hinges(rng: &mut StdRng) -> Pose {
    let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let mut builder = MechanismBuilder::new("arm").link(LinkDescription::new("ground", none));
    for (name, parent) in [("a", "ground"), ("b", "a")] {
        let about_com = Matrix3::identity() * rng.random_range(0.01..0.2);
        let inertial = Inertial { mass: rng.random_range(0.5..3.0), com: vector(rng), about_com };
        builder = builder.link(LinkDescription::new(name, inertial));
        let mut hinge = JointDescription::new(format!("h{name}"), JointKind::Continuous, parent, name);
        hinge.axis = vector(rng).normalize();
        hinge.origin.translation = vector(rng);
        builder = builder.joint(hinge);
    }
    let mechanism = Arc::new(builder.build().expect("a mechanism").mechanism);
    let system = System::new(mechanism, &Conditions::new()).expect("a system");
    system.pose(&system.configuration()).expect("a pose")
}

/// Factor F of the inverse mass matrix under the constraints, F Fᵀ = N (NᵀMN)⁻¹ Nᵀ, by singular values. `None` if some motion has no mass.
fn response_factor(pose: &Pose) -> Option<DMatrix<f64>> {
    let mass = pose.mass_matrix();
    let n = mass.nrows();
    let groups = pose.constraint_groups();
    let rank: usize = groups.iter().map(|group| group.rank).sum();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for group in &groups {
        for r in 0..group.rows.nrows() {
            let mut row = vec![0.0; n];
            group.coordinates.iter().enumerate().for_each(|(at, c)| row[*c] = group.rows[(r, at)]);
            rows.push(row);
        }
    }
    rows.resize(rows.len().max(n), vec![0.0; n]);
    // The singular values descend.
    let svd = faer::Mat::from_fn(rows.len(), n, |r, c| rows[r][c]).svd().ok()?;
    let basis = DMatrix::from_fn(n, n - rank, |r, c| svd.V()[(r, rank + c)]);
    let reduced = basis.transpose() * mass * &basis;
    let values = reduced.clone().symmetric_eigenvalues();
    if values.is_empty() || values.min() <= 1e-6 * values.max() {
        return None;
    }
    let inverse = reduced.cholesky()?.l().solve_lower_triangular(&DMatrix::identity(n - rank, n - rank))?;
    Some(basis * inverse.transpose())
}

/// Solution of W z + q ≥ 0 ⊥ z ≥ 0 for two contacts with a regular W, in scaled unknowns.
fn two_contacts(w: &Matrix2<f64>, q: &Vector2<f64>) -> Vector2<f64> {
    let s = Vector2::new(w[(0, 0)].sqrt().recip(), w[(1, 1)].sqrt().recip());
    let (c, q) = (w[(0, 1)] * s[0] * s[1], q.component_mul(&s));
    let both = Vector2::new(c * q[1] - q[0], c * q[0] - q[1]) / (1.0 - c * c);
    let all = [Vector2::zeros(), Vector2::new(-q[0], 0.0), Vector2::new(0.0, -q[1]), both];
    let violation = |z: &Vector2<f64>| {
        let u = Vector2::new(q[0] + z[0] + c * z[1], q[1] + c * z[0] + z[1]);
        [-z[0], -z[1], -u[0], -u[1], (z[0] * u[0]).abs(), (z[1] * u[1]).abs()].into_iter().fold(0.0, f64::max)
    };
    let best = all.into_iter().min_by(|a, b| violation(a).total_cmp(&violation(b)));
    best.expect("four subsets").component_mul(&s)
}

/// Impulses of two contacts by Newton's or Poisson's law.
fn reference(w: &Matrix2<f64>, u: &Vector2<f64>, e: f64, law: SimultaneousLaw) -> Vector2<f64> {
    match law {
        SimultaneousLaw::Newton => two_contacts(w, &u.map(|u| u + e * u.min(0.0))),
        _ => {
            let compression = two_contacts(w, u) * (1.0 + e);
            let s = Vector2::new(w[(0, 0)].sqrt(), w[(1, 1)].sqrt());
            let after = u + w * compression;
            let size = u.component_div(&s).amax();
            let after = after.zip_map(&s, |u, s| if u.abs() <= 1e-8 * size * s { 0.0 } else { u });
            compression + two_contacts(w, &after)
        }
    }
}

/// Poses with two contacts: the first in a random direction, the second in a direction in which its point cannot move, turned by the angle
/// √scale towards a direction in which it moves.
fn poses(count: u64) -> Vec<(String, Pose, Contact)> {
    let mut found = Vec::new();
    for seed in 0..count {
        let mut rng = StdRng::seed_from_u64(31_000 + seed);
        let pose = two_hinges(&mut rng);
        for link in ["a", "b"] {
            let link = pose.mechanism().find_link(link).expect("a link");
            let normal = Direction::Along(vector(&mut rng), Frame::World);
            let contact = Contact { link, against: None, point: vector(&mut rng), normal };
            found.push((format!("two hinges {seed}"), pose.clone(), contact));
        }
    }
    found.extend(all(count / 8).into_iter().map(|case| (case.name, case.pose, case.contact)));
    found
}

#[test]
fn an_immovable_further_contact_changes_nothing_and_a_hardly_movable_one_is_exact() {
    let equal = ContactStiffness { ratios: vec![1.0; 2], exponent: 1.0 };
    let (mut immovable, mut compared, mut slow, mut energetic) = (0, 0, 0, 0);
    for (number, (name, pose, contact)) in poses(8).into_iter().enumerate() {
        let mut rng = StdRng::seed_from_u64(77 + number as u64);
        let Ok(alone) = pose.respond(&contact) else { continue };
        let EffectiveMass::Finite(mass) = alone.effective_mass else { continue };
        let Some(factor) = response_factor(&pose) else { continue };
        let located = alone.contact;
        if !pose.rank().clear || located.is_moment {
            continue;
        }
        let links: Vec<_> = pose.mechanism().link_ids().collect();
        let (link, point) = (links[rng.random_range(0..links.len())], vector(&mut rng));
        let further =
            |normal| Contact { link, against: None, point, normal: Direction::Along(normal, Frame::World) };
        let rows = [Vector3::x(), Vector3::y(), Vector3::z()]
            .map(|axis| pose.locate(&further(axis)).map(|at| DVector::from_vec(pose.contact_row(&at))));
        let [Ok(x), Ok(y), Ok(z)] = rows else { continue };
        let jacobian = DMatrix::from_columns(&[x, y, z]).transpose();
        let moved = &jacobian * &factor;
        let block = &moved * moved.transpose();
        let eigen = Matrix3::from_iterator(block.iter().copied()).symmetric_eigen();
        let (still, moving) = (eigen.eigenvalues.imin(), eigen.eigenvalues.imax());
        let (least, most) = (eigen.eigenvalues[still], eigen.eigenvalues[moving]);
        // Also points that cannot move at all: on the axis of a hinge, or on the ground.
        if least > 1e-14 * most && most > 0.0 {
            continue;
        }
        let (still, moving) = (eigen.eigenvectors.column(still), eigen.eigenvectors.column(moving));
        let motion = &factor * DVector::from_fn(factor.ncols(), |_, _| rng.random_range(-1.0..1.0));
        let row = DVector::from_vec(pose.contact_row(&located));
        let motion = if row.dot(&motion) < 0.0 { -motion } else { motion };
        let closing = row.dot(&motion);
        if closing < 1e-3 * motion.norm() {
            continue;
        }
        let (joints, base) = pose.joint_velocities(motion.as_slice());
        let rates = JointRates { joints, base };
        let e = rng.random_range(0.1..1.0);
        for scale in [0.0_f64, 1e-16, 1e-12, 1e-8, 1e-4, 0.5] {
            let angle = scale.sqrt();
            let sign = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
            let normal: Vector3<f64> = sign * still + angle * moving;
            let Ok(second) = pose.locate(&further(normal)) else { continue };
            let Ok(delassus) = Delassus::new(&pose, &[located, second]) else { continue };
            let velocities = delassus.velocities(&pose, &rates);
            let speeds = DVector::from_vec(vec![velocities[0], velocities[3]]);
            let is_immovable = matches!(
                pose.respond(&further(normal)).map(|response| response.effective_mass),
                Ok(EffectiveMass::Immovable)
            );
            assert!(is_immovable || scale > 0.0, "{name}: {scale:e}");
            let own = DVector::from_vec(pose.contact_row(&second));
            let exact = Matrix2::from_fn(|r, c| {
                let moved = |i: usize| factor.tr_mul(if i == 0 { &row } else { &own });
                moved(r).dot(&moved(c))
            });
            let before = Vector2::new(-closing, -own.dot(&motion));
            // Opposite contacts of one motion can have no solution by Newton's law.
            let coupling = exact[(0, 1)].powi(2) / (exact[(0, 0)] * exact[(1, 1)]);
            if !is_immovable && coupling > 1.0 - 1e-4 {
                continue;
            }
            for law in SimultaneousLaw::ALL {
                let context = format!("{name}, {scale:e}, {}", law.name());
                let found = match simultaneous_impact(&delassus, &speeds, &[e; 2], law, &equal) {
                    Err(ImpactError::SlowContact { contact: 2, ratio }) if scale < 1e-3 && ratio > 1e2 => {
                        slow += 1;
                        continue;
                    }
                    found => found.unwrap_or_else(|error| panic!("{context}: {error}")),
                };
                if is_immovable {
                    let impulse = (1.0 + e) * mass * closing;
                    let error = found.impulses[0].expect("an impulse") / impulse - 1.0;
                    assert!(error.abs() < 1e-8, "{context}: {found:?} {impulse}");
                    assert_eq!((found.impulses[1], found.after[1]), (None, 0.0), "{context}");
                    assert!((found.after[0] / closing - e).abs() < 1e-8, "{context}: {found:?}");
                    let loss = 0.5 * mass * (1.0 - e * e) * closing * closing;
                    assert!((found.energy_loss - loss).abs() < 1e-8 * mass * closing * closing, "{context}");
                    assert!(!found.creates_energy, "{context}");
                    immovable += 1;
                    continue;
                }
                // Rounding of the second row, and of the motions that loops permit, relative to the row.
                let size = Vector2::new(exact[(0, 0)].sqrt(), exact[(1, 1)].sqrt());
                let energy = before.component_div(&size).norm();
                let noise = if pose.constraint_groups().is_empty() { 1e-13 } else { 1e-9 };
                let limit = (1e-9 + noise / angle) / (1.0 - coupling) * energy.max(motion.norm());
                if law == SimultaneousLaw::Energetic {
                    let after = before + exact * Vector2::new(found.solution[0], found.solution[1]);
                    let least = after.component_div(&size).min();
                    assert!(least > -1e-6 * energy - limit, "{context}: {after}");
                    assert!(found.energy_loss > -1e-6 * energy * energy - limit, "{context}: {found:?}");
                    energetic += 1;
                    continue;
                }
                let expected = reference(&exact, &before, e, law);
                for i in 0..2 {
                    let error = (found.solution[i] - expected[i]).abs() * size[i];
                    assert!(error < limit, "{context}: {} {expected} {exact} {before}", found.solution);
                }
                compared += 1;
            }
            if is_immovable && let Ok(found) = sticking_impact(&delassus, &velocities) {
                assert_eq!(found.contacts[1].normal_impulse, None, "{name}");
            }
        }
    }
    println!("{immovable} immovable, {compared} compared, {energetic} energetic, {slow} slow");
    assert!(immovable > 60 && compared > 100 && energetic > 40, "{immovable} {compared} {energetic} {slow}");
}
