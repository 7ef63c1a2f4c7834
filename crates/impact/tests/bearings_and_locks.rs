//! Centres of percussion of all bearings, and the reactions of locks, mimics and couplings of one joint.

use crate::closed_forms::{ROUNDING, hinged_rod, model, pose_of, two_rods, value};
use nalgebra::Vector3;
use percuss_dynamics::{Base, Conditions, Contact};
use percuss_impact::{
    Bearing, JointConstraint, PercussionError, centre_of_percussion, centre_of_percussion_in_plane,
    reactions_to_unit_impulse, worst_reaction_within,
};
use percuss_mechanism::{Mechanism, MimicDescription, RelationDescription};
use std::sync::Arc;

/// Centres of percussion of a closure, of the ground and of a joint: no point of a grid has a smaller impulse in the bearing, and a rigid
/// impact at the centre has the reported remaining impulse.
#[test]
fn closures_and_the_ground_have_centres_of_percussion() {
    let mechanism = model("four_bar");
    let pose = pose_of(&mechanism, &Conditions::new(), &[("crank_hinge", 0.4)]);
    let link = mechanism.find_link("coupler").expect("the coupler");
    let contact = Contact::new(link, Vector3::new(0.35, 0.1, 0.0), Vector3::y());
    for bearing in [
        Bearing::Closure(0),
        Bearing::Ground,
        Bearing::Joint(mechanism.find_joint("crank_pin").expect("a joint")),
    ] {
        let force_at = |point: Vector3<f64>| {
            let response = pose.respond(&Contact { point, ..contact }).expect("a response");
            let reactions = reactions_to_unit_impulse(&pose, &response).expect("reactions");
            let force = bearing.reaction(&reactions).expect("a reaction").force;
            force.iter().filter_map(|c| c.value()).map(|x| x * x).sum::<f64>().sqrt()
        };
        let best = centre_of_percussion(&pose, &contact, bearing, Vector3::x()).expect("a centre");
        assert!((force_at(best.point) - best.remaining_reaction).abs() < 1e-10, "{best:?}");
        assert!((force_at(contact.point) - best.given_reaction).abs() < 1e-10, "{best:?}");
        for k in -40..=40 {
            let point = contact.point + Vector3::x() * (f64::from(k) / 40.0);
            assert!(force_at(point) >= best.remaining_reaction - 1e-12, "{bearing:?} {k}");
        }
    }
    let floating = pose_of(&mechanism, &Conditions::new().base(Base::Floating), &[("crank_hinge", 0.4)]);
    let refused = centre_of_percussion(&floating, &contact, Bearing::Ground, Vector3::x());
    assert!(matches!(refused, Err(PercussionError::NoReaction { .. })), "{refused:?}");
}

/// A contact on the hinge line, or with the normal along the rod, is immovable: no impact occurs there, so no centre of percussion exists.
#[test]
fn an_immovable_contact_has_no_centre_of_percussion() {
    let door = hinged_rod(3.0, 0.9);
    let pose = pose_of(&door, &Conditions::new(), &[]);
    let link = door.find_link("rod").expect("the rod");
    let hinge = door.find_joint("hinge").expect("the hinge");
    for (at, normal) in [(Vector3::zeros(), Vector3::y()), (Vector3::x() * 0.6, Vector3::x())] {
        let contact = Contact::new(link, at, normal);
        let expected = PercussionError::Immovable {
            bearing: "joint \"hinge\"".to_owned(),
            point: at.into(),
            is_best: false,
        };
        let along = centre_of_percussion(&pose, &contact, hinge, Vector3::x());
        assert_eq!(along.expect_err("no centre along the line"), expected);
        let plane = centre_of_percussion_in_plane(&pose, &contact, hinge);
        assert_eq!(plane.expect_err("no centre in the plane"), expected);
        let worst = worst_reaction_within(&pose, &contact, hinge, 0.01);
        assert_eq!(worst.expect_err("no reaction"), expected);
    }
}

/// The elbow turns by the same angle as the shoulder, by a coupling or as a mimic. The contact at the tip is immovable if one of the two
/// joints is locked. The impulse −1 N·s, 2 m from the shoulder and 1 m from the elbow, gives the sums 2 and 1 N·m·s at these joints. With
/// the elbow locked, only the coupling acts on the shoulder, with 2 N·m·s. The coupling then acts on the elbow with −2 N·m·s, so the lock
/// has 3 N·m·s. With the shoulder locked too, only the sums are determinate.
#[test]
fn a_lock_and_a_coupling_of_one_joint_are_separate() {
    let names = |mechanism: &Mechanism| {
        ["shoulder", "elbow"].map(|name| mechanism.find_joint(name).expect("a joint"))
    };
    let terms = vec![("elbow".to_owned(), 1.0), ("shoulder".to_owned(), -1.0)];
    let relation =
        RelationDescription { name: "belt".into(), terms: terms.clone(), constant: 0.0, curve: None };
    let coupled = two_rods().relation(relation.clone()).build().expect("a mechanism").mechanism;
    let twice = two_rods()
        .relation(relation.clone())
        .relation(RelationDescription { name: "gears".into(), ..relation });
    let twice = Arc::new(twice.build().expect("a mechanism").mechanism);
    let (links, mut joints) = percuss_oracle::alter::describe(&coupled);
    joints[1].mimic = Some(MimicDescription { joint: "shoulder".into(), multiplier: 1.0, offset: 0.0 });
    let mimic = Arc::new(percuss_oracle::alter::build("mimic", links, joints));
    let at_tip = |mechanism: &Arc<Mechanism>, locks: &[&str]| {
        let conditions = locks.iter().fold(Conditions::new(), |conditions, lock| conditions.lock(*lock));
        let pose = pose_of(mechanism, &conditions, &[]);
        let contact = Contact::new(mechanism.find_link("outer").expect("a link"), Vector3::x(), Vector3::y());
        let response = pose.respond(&contact).expect("a response");
        reactions_to_unit_impulse(&pose, &response).expect("reactions")
    };
    for mechanism in [Arc::new(coupled), mimic] {
        let [shoulder, elbow] = names(&mechanism);
        let single = at_tip(&mechanism, &["elbow"]);
        let [lock, belt] = &single.joint_constraints[..] else { panic!("{single:?}") };
        assert_eq!(lock.constraint, JointConstraint::Lock(elbow));
        assert!((value(lock.impulses[0].2) - 3.0).abs() < ROUNDING, "{lock:?}");
        for (joint, expected) in [(elbow, -2.0), (shoulder, 2.0)] {
            let own = belt.impulses.iter().find(|(known, ..)| *known == joint).expect("the joint");
            assert!((value(own.2) - expected).abs() < ROUNDING, "{belt:?}");
        }
        let both = at_tip(&mechanism, &["elbow", "shoulder"]);
        assert_eq!(both.joint_constraints.len(), 3, "{both:?}");
        for constraint in &both.joint_constraints {
            assert!(constraint.impulses.iter().all(|(.., v)| v.value().is_none()), "{constraint:?}");
            assert!(!constraint.open_by.is_empty(), "{constraint:?}");
        }
        for reactions in [&single, &both] {
            for (joint, expected) in reactions.joints.iter().zip([2.0, 1.0]) {
                assert!((value(joint.drives[0].constraint) - expected).abs() < ROUNDING, "{joint:?}");
                assert!((value(joint.reaction.moment[2]) - expected).abs() < ROUNDING, "{joint:?}");
            }
        }
    }
    // The shares of a belt and gears in parallel depend on their stiffness, so both impulses are open.
    let parallel = at_tip(&twice, &[]);
    let [belt, gears] = &parallel.joint_constraints[..] else { panic!("{parallel:?}") };
    assert!(belt.open_by == ["belt", "gears"] && gears.open_by == belt.open_by, "{parallel:?}");
    assert!(belt.impulses.iter().chain(&gears.impulses).all(|(.., v)| v.value().is_none()));
    assert!(parallel.joints.iter().all(|joint| joint.drives[0].constraint.value().is_some()));
}
