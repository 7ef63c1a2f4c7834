//! Outcomes without a finite effective mass, and the contents of their answers.

use nalgebra::Vector3;
use percuss_mechanism::{JointDescription, JointKind, LinkDescription, Mechanism};
use percuss_oracle::alter::{build, describe};
use percuss_oracle::maximal::{Outcome, Question, effective_mass, solve};
use percuss_oracle::{random, zoo};
use rand::{Rng, SeedableRng, rngs::StdRng};

fn at_zero<'a>(mechanism: &'a Mechanism, on: &str, point: [f64; 3], normal: Vector3<f64>) -> Question<'a> {
    let positions = random::zero_positions(mechanism);
    Question::new(mechanism, positions, mechanism.find_link(on).unwrap(), point.into(), normal)
}

#[test]
fn an_impact_into_the_bearings_moves_nothing() {
    let pendulum = zoo::physical_pendulum(2.3, 0.35, 0.04);
    for (point, normal) in [([0.5, 0.0, 0.0], Vector3::x()), ([0.5, 0.1, 0.0], Vector3::z())] {
        assert_eq!(effective_mass(&at_zero(&pendulum, "body", point, normal)), Outcome::Immovable);
    }
    // The bearing constrains a point on the hinge axis in every direction.
    assert_eq!(effective_mass(&at_zero(&pendulum, "body", [0.0; 3], Vector3::y())), Outcome::Immovable);
    // The slide constrains the base of the needle normal to its axis.
    let needle = zoo::needle_on_heavy_base();
    assert_eq!(effective_mass(&at_zero(&needle, "base", [0.1; 3], Vector3::x())), Outcome::Immovable);
}

#[test]
fn nearly_into_the_bearings_is_finite() {
    let pendulum = zoo::physical_pendulum(2.3, 0.35, 0.04);
    let normal = Vector3::new(1.0, 1e-6, 0.0).normalize();
    let Outcome::Finite(mass) = effective_mass(&at_zero(&pendulum, "body", [0.5, 0.0, 0.0], normal)) else {
        panic!("it moves")
    };
    // j Z is 1e-6 of j: of 16 digits 10 remain, and 9.5 in m̄.
    assert!((mass / 1.287e12 - 1.0).abs() < 1e-9, "{mass}");
}

#[test]
fn locked_and_welded_links_are_immovable() {
    let mut rng = StdRng::seed_from_u64(17);
    for (name, mechanism) in zoo::all() {
        let positions = random::positions(&mut rng, &mechanism);
        let (on, against, point, normal) = random::contact(&mut rng, &mechanism);
        let locked = mechanism.joint_ids().collect();
        let question =
            Question { locked, against, ..Question::new(&mechanism, positions, on, point, normal) };
        let answer = solve(&question);
        assert_eq!(answer.outcome, Outcome::Immovable, "{name}");
        assert_eq!(answer.degrees_of_freedom, 0, "{name}");
    }
    let frames = zoo::fixed_frames();
    let mut question = at_zero(&frames, "sensor", [0.1, 0.2, 0.3], Vector3::y());
    question.against = Some(frames.find_link("ballast").unwrap());
    assert_eq!(effective_mass(&question), Outcome::Immovable);
    question.against = Some(question.on);
    assert_eq!(effective_mass(&question), Outcome::Immovable);
}

#[test]
fn a_free_massless_link_weighs_nothing() {
    let arm = zoo::massless_tip();
    let mut question = at_zero(&arm, "feeler", [0.2, 0.0, 0.0], Vector3::y());
    assert_eq!(effective_mass(&question), Outcome::Massless);
    // A contact along the feeler loads the hinge of the arm; with a locked hinge the feeler is a part of the arm.
    question.normal = Vector3::x();
    assert_eq!(effective_mass(&question), Outcome::Immovable);
    question.normal = Vector3::y();
    question.locked = vec![arm.find_joint("feeler_hinge").unwrap()];
    let inertia = arm.link(arm.find_link("arm").unwrap()).inertia().rotational[(2, 2)];
    let mass = effective_mass(&question).finite().unwrap();
    assert!((mass * 0.64 / inertia - 1.0).abs() < 1e-13, "{mass}");
    // A rotor at the hinge of the feeler gives inertia.
    let mut question = at_zero(&arm, "feeler", [0.2, 0.0, 0.0], Vector3::y());
    question.armature = vec![(arm.find_joint("feeler_hinge").unwrap(), vec![0.01])];
    assert!(effective_mass(&question).finite().unwrap() > 0.1);
}

#[test]
fn a_point_mass_is_felt_at_itself_and_nowhere_beside() {
    // A free body without moment of inertia: an eccentric contact is massless. Many contact points are tested, because
    // the rounding of the parallel-axis theorem differs between them and is zero at most of them.
    let mut rng = StdRng::seed_from_u64(13);
    for _ in 0..200 {
        let c: [f64; 3] = std::array::from_fn(|_| rng.random_range(-2.0..2.0));
        let links = vec![
            LinkDescription::massless("ground"),
            LinkDescription::new("dot", percuss_mechanism::Inertial::point(0.7, c)),
        ];
        let free = JointDescription::new("free", JointKind::Floating, "ground", "dot");
        let dot = build("dot", links, vec![free]);
        let at = |x, y| effective_mass(&at_zero(&dot, "dot", [c[0] + x, c[1] + y, c[2]], Vector3::y()));
        assert!((at(0.0, 0.0).finite().unwrap() / 0.7 - 1.0).abs() < 1e-13);
        assert!((at(0.0, 5.0).finite().unwrap() / 0.7 - 1.0).abs() < 1e-13);
        assert_eq!(at(0.1, 0.0), Outcome::Massless);
    }
}

#[test]
fn bare_mechanisms_are_massless_or_immovable() {
    let ground_only = build("ground", vec![LinkDescription::massless("ground")], Vec::new());
    let mut question = at_zero(&ground_only, "ground", [0.1, 0.2, 0.3], Vector3::z());
    assert_eq!(effective_mass(&question), Outcome::Immovable);
    question.floating_base = true;
    assert_eq!(effective_mass(&question), Outcome::Massless);
}

#[test]
fn freedoms_and_redundancy_are_counted() {
    let gripper = zoo::mimic_gripper();
    let mut question = at_zero(&gripper, "palm", [0.0; 3], Vector3::z());
    // Independent joints: lift and left; the other three are mimics.
    assert_eq!(solve(&question).degrees_of_freedom, 2);
    assert_eq!(solve(&question).redundant_constraints, 0);
    question.floating_base = true;
    assert_eq!(solve(&question).degrees_of_freedom, 8);
    // With master and mimic both locked, the row of the mimic is redundant.
    question.locked = vec![gripper.find_joint("left").unwrap(), gripper.find_joint("right").unwrap()];
    assert_eq!(solve(&question).degrees_of_freedom, 7);
    assert_eq!(solve(&question).redundant_constraints, 1);
    let every = zoo::every_joint();
    // 1 + 1 + 1 + 0 + 3 + 3 + 6 + 1; the last joint is a mimic.
    assert_eq!(solve(&at_zero(&every, "puck", [0.1; 3], Vector3::z())).degrees_of_freedom, 16);
}

#[test]
fn energies_of_links_and_rotors_sum_to_the_mass() {
    let mut rng = StdRng::seed_from_u64(23);
    for (name, mechanism) in zoo::all() {
        let positions = random::positions(&mut rng, &mechanism);
        let (on, against, point, normal) = random::contact(&mut rng, &mechanism);
        let question = Question { against, ..Question::new(&mechanism, positions, on, point, normal) };
        let answer = solve(&question);
        if let Outcome::Finite(mass) = answer.outcome {
            let sum: f64 = answer.links.iter().chain(&answer.rotors).sum();
            assert!((sum / mass - 1.0).abs() < 1e-14, "{name}: {sum} {mass}");
            // The velocity of the ground is of the order of rounding, and its energy of rounding squared.
            assert!(answer.links[mechanism.root().index()] <= 1e-28 * mass, "{name}: the ground moves");
        }
    }
}

#[test]
fn mass_and_constraints_never_lower_it() {
    let mut rng = StdRng::seed_from_u64(29);
    let mut compared = 0;
    for _ in 0..30 {
        let mechanism = random::mechanism(&mut rng, 7);
        let positions = random::positions(&mut rng, &mechanism);
        let (on, against, point, normal) = random::contact(&mut rng, &mechanism);
        let fixed = Question { against, ..Question::new(&mechanism, positions, on, point, normal) };
        let mass = |question: &Question| match effective_mass(question) {
            Outcome::Finite(mass) => mass,
            Outcome::Immovable => f64::INFINITY,
            Outcome::Massless => 0.0,
        };
        let base = mass(&fixed);
        // Margin for rounding if the change has no effect on the contact.
        let least = base * (1.0 - 1e-11);
        let floating = Question { floating_base: true, ..fixed.clone() };
        assert!(mass(&floating) <= base * (1.0 + 1e-11));
        for id in mechanism.joint_ids() {
            assert!(mass(&Question { locked: vec![id], ..fixed.clone() }) >= least);
        }
        let (mut links, joints) = describe(&mechanism);
        for i in 0..links.len() {
            let inertial = links[i].inertial.as_mut().unwrap();
            let before = *inertial;
            inertial.mass *= 1.5;
            let heavier = build("heavier", links.clone(), joints.clone());
            assert!(mass(&Question { mechanism: &heavier, ..fixed.clone() }) >= least);
            links[i].inertial = Some(before);
            compared += 1;
        }
    }
    assert_eq!(compared, 30 * 8);
}
