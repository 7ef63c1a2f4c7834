//! Invariance of m̄: position of the world frame, units, sign of the normal, choice of the contact link.

use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::Mechanism;
use percuss_oracle::alter::{build, describe, rebased, scaled, scaled_positions};
use percuss_oracle::maximal::{Outcome, Question, effective_mass, poses};
use percuss_oracle::{random, zoo};
use percuss_spatial::{Transform, rotation_from_rpy};
use rand::{SeedableRng, rngs::StdRng};

/// Random chains of eight bodies: rounding times a condition up to a thousand.
const TOL: f64 = 1e-11;

fn cases(seed: u64) -> Vec<Mechanism> {
    let mut rng = StdRng::seed_from_u64(seed);
    let zoo = zoo::all().into_iter().map(|(_, mechanism)| mechanism);
    zoo.chain((0..25).map(|i| random::mechanism(&mut rng, 3 + i % 8))).collect()
}

fn ask<'a>(rng: &mut StdRng, mechanism: &'a Mechanism) -> Question<'a> {
    let positions = random::positions(rng, mechanism);
    let (on, against, point, normal) = random::contact(rng, mechanism);
    Question { against, ..Question::new(mechanism, positions, on, point, normal) }
}

/// Compares outcomes; returns the relative difference of finite ones.
fn difference(a: Outcome, b: Outcome) -> f64 {
    match (a, b) {
        (Outcome::Finite(a), Outcome::Finite(b)) => (a / b - 1.0).abs(),
        (a, b) if a == b => 0.0,
        (a, b) => panic!("{a:?} against {b:?}"),
    }
}

/// Asserts that `other` has the same outcome as each case, with fixed and floating base.
fn agree(seed: u64, tolerance: f64, other: impl Fn(&Question) -> Outcome) {
    let mut rng = StdRng::seed_from_u64(seed);
    let (mut worst, mut finite) = (0.0f64, 0);
    for mechanism in cases(seed) {
        for floating_base in [false, true] {
            let question = Question { floating_base, ..ask(&mut rng, &mechanism) };
            let expected = effective_mass(&question);
            finite += usize::from(expected.finite().is_some());
            let error = difference(other(&question), expected);
            worst = worst.max(error);
            assert!(error <= tolerance, "{}: {error:e}, {expected:?}", mechanism.name());
        }
    }
    assert!(finite > 40, "only {finite} finite cases");
    println!("worst {worst:e} of {finite} finite");
}

#[test]
fn the_sign_of_the_normal() {
    agree(1, TOL, |q| effective_mass(&Question { normal: -q.normal, ..q.clone() }));
}

#[test]
fn the_order_of_the_two_sides() {
    agree(2, TOL, |q| {
        let Some(against) = q.against else { return effective_mass(q) };
        let x_wl = poses(q.mechanism, &q.positions);
        let p_w = x_wl[q.on.index()].transform_point(&q.point.into());
        let point = x_wl[against.index()].try_inverse().unwrap().transform_point(&p_w).coords;
        let (on, against) = (against, Some(q.on));
        effective_mass(&Question { on, against, point, normal: -q.normal, ..q.clone() })
    });
}

#[test]
fn the_position_of_the_world() {
    let x_gr = Transform::new(rotation_from_rpy([0.4, -1.0, 2.2]), Vector3::new(30.0, -20.0, 10.0));
    agree(3, TOL, |q| {
        let moved = rebased(q.mechanism, x_gr);
        let mut positions = q.positions.clone();
        positions.push(Vec::new());
        let normal = x_gr.vector(&q.normal);
        effective_mass(&Question { mechanism: &moved, positions, normal, ..q.clone() })
    });
}

#[test]
fn the_units() {
    for (length, mass) in [(1e3, 1.0), (1.0, 1e3), (0.0254, 0.4536), (1e-3, 1e-6)] {
        agree(4, TOL, |q| {
            let other = scaled(q.mechanism, length, mass);
            let positions = scaled_positions(q.mechanism, &q.positions, length);
            let point = q.point * length;
            match effective_mass(&Question { mechanism: &other, positions, point, ..q.clone() }) {
                Outcome::Finite(m) => Outcome::Finite(m / mass),
                other => other,
            }
        });
    }
}

#[test]
fn the_choice_of_link_frames() {
    // Every link frame is moved within its link, and the axes stay: a massless link and a fixed joint are inserted between
    // each joint and the new frame of its child.
    let shift = Transform::new(rotation_from_rpy([0.7, 0.2, -0.5]), Vector3::new(0.3, -0.1, 0.2));
    agree(5, TOL, |q| {
        let (mut links, mut joints) = describe(q.mechanism);
        let mut positions = q.positions.clone();
        for id in q.mechanism.joint_ids() {
            let joint = &mut joints[id.index()];
            let between = format!("{} between", joint.child);
            let child = std::mem::replace(&mut joint.child, between.clone());
            let weld = format!("{child} weld");
            use percuss_mechanism::{JointDescription, JointKind, LinkDescription};
            links.push(LinkDescription::massless(between.clone()));
            joints.push(JointDescription::new(weld, JointKind::Fixed, between, child.clone()).origin(shift));
            positions.push(Vec::new());
            // A point p has the coordinates X⁻¹ p in the new frame.
            let back = shift.inverse();
            let link = links.iter_mut().find(|l| l.name == child).unwrap();
            if let Some(inertial) = &mut link.inertial {
                inertial.com = back.point(&inertial.com);
                let turned: Matrix3<f64> = back.rotation * inertial.about_com * back.rotation.transpose();
                inertial.about_com = turned;
            }
            for other in joints.iter_mut().filter(|other| other.parent == child) {
                other.origin = back * other.origin;
            }
        }
        let other = build("shifted", links, joints);
        let root = q.on == q.mechanism.root();
        let point = if root { q.point } else { shift.inverse_point(&q.point) };
        effective_mass(&Question { mechanism: &other, positions, point, ..q.clone() })
    });
}

#[test]
fn sixty_bodies_are_feasible_and_as_exact() {
    let mut rng = StdRng::seed_from_u64(60);
    for _ in 0..3 {
        let mechanism = random::mechanism(&mut rng, 60);
        let question = ask(&mut rng, &mechanism);
        let expected = effective_mass(&question);
        assert!(expected.finite().is_some());
        let mirrored = Question { normal: -question.normal, ..question.clone() };
        assert!(difference(effective_mass(&mirrored), expected) <= TOL);
        let other = scaled(&mechanism, 10.0, 1.0);
        let positions = scaled_positions(&mechanism, &question.positions, 10.0);
        let large =
            Question { mechanism: &other, positions, point: question.point * 10.0, ..question.clone() };
        assert!(difference(effective_mass(&large), expected) <= TOL);
    }
}
