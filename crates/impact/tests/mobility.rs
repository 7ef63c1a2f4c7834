//! Delassus matrices: against the responses, the recursion with unit wrenches, and closed forms.

use crate::cases::all;
use nalgebra::{Matrix3, SMatrix, Vector3};
use percuss_dynamics::{Contact, Direction, EffectiveMass, Frame};
use percuss_impact::Delassus;
use percuss_oracle::random;
use rand::SeedableRng;
use rand::rngs::StdRng;

/// Wrench about the origin of the contact of the recursion by an impulse `f` at `arm`.
fn wrench(arm: &Vector3<f64>, f: &Vector3<f64>) -> [f64; 6] {
    let moment = arm.cross(f);
    [moment.x, moment.y, moment.z, f.x, f.y, f.z]
}

#[test]
fn the_matrix_agrees_with_responses_and_unit_wrenches() {
    let (mut compared, mut crossed) = (0, 0);
    for (number, case) in all(64).into_iter().enumerate() {
        let pose = &case.pose;
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let mut rng = StdRng::seed_from_u64(31 + number as u64);
        let (link, _, point, normal) = random::contact(&mut rng, &case.mechanism);
        let second = Contact { link, against: None, point, normal: Direction::Along(normal, Frame::World) };
        let first = Contact { against: None, ..case.contact };
        let located = [first, second].map(|contact| pose.locate(&contact).expect("a contact"));
        let Ok(delassus) = Delassus::new(pose, &located) else { continue };
        let w = delassus.matrix();
        let size = w.amax();
        // Rounding of points that cannot move.
        let total: f64 = case.mechanism.links().iter().map(|link| link.inertia().mass).sum();
        if size * total < 1e-9 {
            continue;
        }
        for (i, contact) in [first, second].iter().enumerate() {
            if let EffectiveMass::Finite(mass) = pose.respond(contact).expect("a response").effective_mass {
                let error = (w[(3 * i, 3 * i)] * mass - 1.0).abs();
                // Rounding of a light point relative to the largest mobility.
                assert!(error < 1e-9 * (1.0 + size * mass), "{}: {error:e}, {mass} kg, {w}", case.name);
                compared += 1;
            }
        }
        // Both links at the first point: the recursion gives the responses of both to wrenches on both.
        if located[0].link == located[1].link {
            continue;
        }
        let pair = Contact { against: Some(located[1].link), ..first };
        let Ok(pair) = pose.locate(&pair) else { continue };
        let Ok(inertia) = pose.inverse_operational_inertia(&pair) else { continue };
        let phi: &SMatrix<f64, 12, 12> = inertia.matrix();
        let at = |i: usize| pose.link_in_root(located[i].link).point(&located[i].point_link);
        let arms = [Vector3::zeros(), at(1) - at(0)];
        let mut rows = SMatrix::<f64, 6, 12>::zeros();
        for i in 0..2 {
            for k in 0..3 {
                let axis = delassus.axes(i).column(k).into_owned();
                let entries = wrench(&arms[i], &axis);
                (0..6).for_each(|c| rows[(3 * i + k, 6 * i + c)] = entries[c]);
            }
        }
        let expected = rows * phi * rows.transpose();
        let error = (w - expected).amax() / size;
        assert!(error < 1e-9, "{}: {error:e}", case.name);
        crossed += 1;
    }
    println!("{compared} masses, {crossed} pairs");
    assert!(compared > 200 && crossed > 60, "{compared} {crossed}");
}

#[test]
fn principal_masses_are_extreme() {
    let mut compared = 0;
    for case in all(24) {
        let pose = &case.pose;
        let located = pose.locate(&case.contact).expect("a contact");
        if !pose.rank().clear {
            continue;
        }
        let Ok(delassus) = Delassus::new(pose, std::slice::from_ref(&located)) else { continue };
        let masses = delassus.principal_masses(0);
        let block: Matrix3<f64> = delassus.block(0);
        if block.amax() == 0.0 {
            continue;
        }
        assert!(masses[0].0 <= masses[1].0 && masses[1].0 <= masses[2].0);
        // Along a principal direction the response is parallel to the impulse.
        for (mass, direction) in masses.iter().filter(|(mass, _)| mass.is_finite()) {
            let own = delassus.axes(0).transpose() * direction;
            let response = block * own * *mass;
            assert!((response - own).norm() < 1e-9 * (1.0 + mass * block.amax()), "{}", case.name);
            compared += 1;
        }
    }
    assert!(compared > 60, "{compared}");
}

/// W of a moment and a contact point: its first diagonal entry is 1/m̄ of the moment, and the block of the moment is the angular part of
/// the inverse operational inertia.
#[test]
fn moments_are_rows_of_angular_velocities() {
    let mut compared = 0;
    for case in all(64) {
        let pose = &case.pose;
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let (axis, frame) = case.contact.normal.vector().expect("a vector");
        let moment = case.contact.normal(Direction::About(axis, frame));
        let located = [moment, case.contact].map(|contact| pose.locate(&contact).expect("a contact"));
        let Ok(delassus) = Delassus::new(pose, &located) else { continue };
        let w = delassus.matrix();
        let EffectiveMass::Finite(mass) = pose.respond(&moment).expect("a response").effective_mass else {
            continue;
        };
        let size = delassus.block(0).norm();
        let error = (w[(0, 0)] * mass - 1.0).abs();
        // Rounding of a light axis relative to the largest mobility.
        assert!(error < 1e-9 * (1.0 + size * mass), "{}: {error:e}, {mass} kg·m²", case.name);
        let Ok(inertia) = pose.inverse_operational_inertia(&located[0]) else { continue };
        let block = |r: usize, c: usize| inertia.matrix().fixed_view::<3, 3>(r, c).into_owned();
        let mut angular: Matrix3<f64> = block(0, 0);
        if moment.against.is_some() {
            angular += block(6, 6) - block(0, 6) - block(6, 0);
        }
        let axes = delassus.axes(0);
        let expected = axes.transpose() * angular * axes;
        assert!((delassus.block(0) - expected).norm() < 1e-8 * (size + angular.norm()), "{}", case.name);
        compared += 1;
    }
    println!("{compared} compared");
    assert!(compared > 100, "{compared}");
}
