//! Effective masses with a closed form, through `Pose::respond` by both routes.

use nalgebra::{Matrix3, Vector2, Vector3};
use percuss_dynamics::{Base, Conditions, Contact, Direction, EffectiveMass, Frame, Route, System};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder, MimicDescription,
};
use percuss_oracle::closed_form::{self, PlanarLink};
use percuss_oracle::{alter, zoo};
use percuss_spatial::{Transform, rotation_from_rpy};
use percuss_tests::bench::{Bench, TOL, along, assert_close, mass};
use std::sync::Arc;

fn ground() -> LinkDescription {
    LinkDescription::massless("ground")
}

#[test]
fn a_point_mass_on_a_massless_rod() {
    for (m, r_a, r_b) in [(1.5, 0.8, 0.8), (3.0, 1.0, 0.5), (0.02, 0.3, 7.0), (4e3, 12.0, 0.01)] {
        let pendulum = Bench::new(zoo::point_mass_pendulum(m, r_a)).set("hinge", &[0.7]);
        let across = along(0.7 + std::f64::consts::FRAC_PI_2);
        let expected = closed_form::point_mass_pendulum(m, r_a, r_b);
        pendulum.check_mass(&pendulum.contact("rod", [r_b, 0.0, 0.0], across), expected);
        // Oblique normal: only the lever arm of the normal's line counts.
        let oblique = along(0.7 + 1.1);
        pendulum.check_mass(
            &pendulum.contact("rod", [r_b, 0.0, 0.3], oblique),
            closed_form::point_mass_pendulum(m, r_a, r_b * 1.1f64.sin()),
        );
        // The same point in the frame of the bob.
        let expected = closed_form::point_mass_pendulum(m, r_a, r_a + (r_b - r_a));
        pendulum.check_mass(&pendulum.contact("bob", [r_b - r_a, 0.0, 0.0], across), expected);
    }
}

#[test]
fn a_physical_pendulum() {
    let (m, h, i_c) = (2.3, 0.35, 0.04);
    let j_o = i_c + m * h * h;
    let pendulum = Bench::new(zoo::physical_pendulum(m, h, i_c)).set("hinge", &[-1.9]);
    for r_b in [0.01, 0.35, 0.5, 20.0] {
        let across = along(-1.9 - std::f64::consts::FRAC_PI_2);
        let contact = pendulum.contact("body", [r_b, 0.0, 0.1], across);
        pendulum.check_mass(&contact, closed_form::physical_pendulum(j_o, r_b));
        // With a rotor (armature) at the hinge.
        let geared = Conditions::new().armature("hinge", [0.7]);
        let driven = Bench::under(Arc::clone(pendulum.system.mechanism()), &geared).set("hinge", &[-1.9]);
        driven.check_mass(&contact, closed_form::physical_pendulum(j_o + 0.7, r_b));
        // At the radius of gyration r_i, m̄ of a physical pendulum is its mass.
        let r_i = f64::sqrt(j_o / m);
        pendulum.check_mass(&pendulum.contact("body", [r_i, 0.0, 0.0], across), m);
    }
}

/// Two balls (point masses on slides along x) that face each other.
fn two_balls(m_1: f64, m_2: f64) -> Bench {
    let ball = |name: &str, m| LinkDescription::new(name, Inertial::diagonal(m, [0.0; 3], [0.1 * m; 3]));
    let slide = |name: &str, child: &str, x| {
        JointDescription::new(name, JointKind::Prismatic, "ground", child).at([x, 0.0, 0.0])
    };
    let links = vec![ground(), ball("one", m_1), ball("two", m_2)];
    Bench::new(alter::build("balls", links, vec![slide("first", "one", 0.0), slide("second", "two", 1.0)]))
}

#[test]
fn central_impact() {
    for exponent in -6..=6 {
        let (m_1, m_2) = (2.5, 2.5 * 10f64.powi(exponent));
        let balls = two_balls(m_1, m_2);
        let two = balls.system.mechanism().find_link("two").unwrap();
        let contact = balls.contact("one", [0.5, 0.0, 0.0], Vector3::x()).against(two);
        let expected = m_1 * m_2 / (m_1 + m_2);
        balls.check_mass(&contact, expected);
        // m̄ is between half the lighter mass and the lighter mass.
        let m = mass(&balls.respond(&contact));
        let lighter = m_1.min(m_2);
        assert!(
            lighter / 2.0 * (1.0 - TOL) <= m && m <= lighter * (1.0 + TOL),
            "{m} kg, lighter {lighter} kg"
        );
        // In the limit, m̄ is the lighter mass, less a relative difference of the mass ratio.
        let ratio = 10f64.powi(-exponent.abs());
        assert!((m / lighter - 1.0 / (1.0 + ratio)).abs() <= TOL, "{m} kg");
        // Each ball alone, and one ball against a given mass.
        let alone = balls.contact("one", [0.5, 0.0, 0.0], Vector3::x());
        balls.check_mass(&alone, m_1);
        let against = balls.respond(&alone).against_mass(m_2).expect("a mass");
        assert_close(mass(&against), expected);
        let contributions = against.contributions.expect("finite");
        // At unit closing speed m₁ v₁ = m₂ v₂: the lighter ball moves more.
        let [one, other] = [contributions.links[1], contributions.other_mass.expect("it was given")];
        assert!((one + other - 1.0).abs() <= TOL, "contributions {one} and {other}");
        assert!((one - m_2 / (m_1 + m_2)).abs() <= TOL && (other - m_1 / (m_1 + m_2)).abs() <= TOL);
    }
    let free = Bench::new(zoo::two_free_bodies());
    let (first, second) = (1.2, 3.4);
    let com = Vector3::new(0.1, -0.2, 0.05);
    let x_gs = Transform::new(rotation_from_rpy([0.4, 0.2, -1.3]), Vector3::new(2.0, 0.5, 0.1));
    let line = (x_gs.point(&Vector3::new(-0.15, 0.1, 0.2)) - com).normalize();
    let other = free.system.mechanism().find_link("second").unwrap();
    let contact = free.contact("first", com.into(), line);
    free.check_mass(&contact, first);
    free.check_mass(&contact.against(other), closed_form::series(first, second));
}

#[test]
fn eccentric_impact() {
    // Eccentric contact of a free body, with a floating base and with a floating joint.
    let (m, com) = (1.7, Vector3::new(0.2, -0.1, 0.4));
    let turn = rotation_from_rpy([0.4, -0.2, 0.9]);
    let moments = Vector3::new(0.05, 0.08, 0.11);
    let about_com = turn * Matrix3::from_diagonal(&moments) * turn.transpose();
    let body = || LinkDescription::new("body", Inertial { mass: m, com, about_com });
    let floating =
        Bench::under(alter::build("floating", vec![body()], vec![]), &Conditions::new().base(Base::Floating));
    let free = JointDescription::new("free", JointKind::Floating, "ground", "body");
    let jointed = Bench::new(alter::build("jointed", vec![ground(), body()], vec![free]));
    let normal = Vector3::new(0.3, -0.7, 0.5).normalize();
    for point in [[0.2, -0.1, 0.4], [0.9, 0.3, -0.2], [-5.0, 2.0, 1.0]] {
        let r = Vector3::from(point) - com;
        let expected = closed_form::free_body(m, &about_com, &r, &normal).unwrap();
        for bench in [&floating, &jointed] {
            bench.check_mass(&bench.contact("body", point, normal), expected);
        }
        // Against a free mass: the classical eccentric impact.
        let against =
            jointed.respond(&jointed.contact("body", point, normal)).against_mass(0.8).expect("a mass");
        assert_close(mass(&against), closed_form::series(expected, 0.8));
    }
    // Uniform rod: a quarter of its mass at the tip if free, a third if hinged, a value in between on a sliding base.
    let (m, l) = (0.9, 0.7);
    let moment = m * l * l / 12.0;
    let rod =
        || LinkDescription::new("rod", Inertial::diagonal(m, [l / 2.0, 0.0, 0.0], [1e-3, moment, moment]));
    let tip = [l, 0.0, 0.0];
    let floating =
        Bench::under(alter::build("rod", vec![rod()], vec![]), &Conditions::new().base(Base::Floating));
    floating.check_mass(&floating.contact("rod", tip, Vector3::y()), m / 4.0);
    for base in [1e-3, 0.4, 30.0] {
        let links =
            vec![ground(), LinkDescription::new("sled", Inertial::diagonal(base, [0.0; 3], [0.1; 3])), rod()];
        let joints = vec![
            JointDescription::new("slide", JointKind::Prismatic, "ground", "sled").axis([0.0, 1.0, 0.0]),
            JointDescription::new("hinge", JointKind::Revolute, "sled", "rod").axis([0.0, 0.0, 1.0]),
        ];
        let sled = Arc::new(alter::build("sled", links, joints));
        let free = Bench::new(Arc::clone(&sled));
        free.check_mass(
            &free.contact("rod", tip, Vector3::y()),
            closed_form::rod_tip_on_sliding_base(m, base),
        );
        let held = Bench::under(sled, &Conditions::new().lock("slide"));
        held.check_mass(&held.contact("rod", tip, Vector3::y()), closed_form::rod_tip(m));
    }
}

#[test]
fn independent_mechanisms_add_as_springs_in_series() {
    // Contact between two arms on one ground: neither is an ancestor of the other.
    let arm = [PlanarLink::rod(1.4, 0.6), PlanarLink::rod(0.9, 0.5)];
    let (mut links, mut joints) = alter::describe(&zoo::planar_2r(arm, [0.05, 0.02]));
    let (others, other_joints) = alter::describe(&zoo::physical_pendulum(2.3, 0.35, 0.04));
    links.extend(others.into_iter().filter(|link| link.name != "ground"));
    joints.extend(other_joints.into_iter().map(|joint| joint.at([1.0, -0.4, 0.0])));
    let both = Bench::new(alter::build("both", links, joints))
        .set("shoulder", &[0.4])
        .set("elbow", &[-0.9])
        .set("hinge", &[0.8]);
    let pose = both.system.pose(&both.configuration).expect("a tree poses");
    let mechanism = both.system.mechanism();
    let (lower, body) = (mechanism.find_link("lower").unwrap(), mechanism.find_link("body").unwrap());
    let normal = along(0.3);
    let contact = both.contact("lower", [0.5, 0.0, 0.0], normal);
    let at = pose.link(lower).point(&contact.point);
    let other = both.contact("body", pose.link(body).inverse_point(&at).into(), -normal);
    let first = closed_form::planar_2r(arm, [0.05, 0.02], [0.4, -0.5], 0.5, Vector2::new(normal.x, normal.y));
    let arm_of_line = (at - Vector3::new(1.0, -0.4, 0.0)).cross(&normal).z;
    let second = closed_form::physical_pendulum(0.04 + 2.3 * 0.35 * 0.35, arm_of_line);
    both.check_mass(&contact, first);
    both.check_mass(&other, second);
    both.check_mass(&contact.against(body), closed_form::series(first, second));
    both.check_mass(&other.against(lower), closed_form::series(first, second));
    let by_number = both.respond(&contact).against_mass(second).expect("a mass");
    assert_close(mass(&by_number), closed_form::series(first, second));
}

#[test]
fn a_needle_on_a_heavy_base() {
    // 1 mg on 10 t: a third of the needle's mass at its tip, not zero.
    let needle = Bench::new(zoo::needle_on_heavy_base());
    let contact = needle.contact("needle", [0.04, 0.0, 0.0], Vector3::y());
    let expected = closed_form::rod_tip_on_sliding_base(1e-6, 1e4);
    assert!((expected - 3.333e-7).abs() < 1e-10);
    needle.check_mass(&contact, expected);
    // At the pin, a quarter of the needle's mass and the base; along its length, the needle is immovable.
    let at_pin = needle.contact("needle", [0.0; 3], Vector3::y());
    needle.check_mass(&at_pin, 1e4 + 1e-6 / 4.0);
    let lengthwise = needle.contact("needle", [0.04, 0.0, 0.0], Vector3::x());
    assert_eq!(needle.outcome(&lengthwise), EffectiveMass::Immovable);
}

#[test]
fn planar_arms() {
    let rods = [PlanarLink::rod(1.4, 0.6), PlanarLink::rod(0.9, 0.5)];
    let points = [PlanarLink::point(1.0, 1.0), PlanarLink::point(2.5, 0.4)];
    let mixed = [PlanarLink { mass: 3.0, length: 0.7, com: 0.2, inertia: 0.09 }, PlanarLink::rod(0.4, 1.3)];
    let mut contacts = 0;
    for links in [rods, points, mixed] {
        for armature in [[0.0, 0.0], [0.05, 0.0], [0.0, 0.3], [1.2, 0.02]] {
            // Armatures from conditions replace armatures of the mechanism.
            let bare = Arc::new(zoo::planar_2r(links, [7.0, 7.0]));
            let [a_1, a_2] = armature;
            let conditions = Conditions::new().armature("shoulder", [a_1]).armature("elbow", [a_2]);
            for (first, second) in [(0.0, 1.1), (-2.0, 0.4), (0.9, -2.2)] {
                let own = Bench::new(zoo::planar_2r(links, armature));
                let given = Bench::under(Arc::clone(&bare), &conditions);
                for bench in [own, given] {
                    let bench = bench.set("shoulder", &[first]).set("elbow", &[second]);
                    for (reach, angle) in [(links[1].length, 0.3), (0.2, 2.0), (1.7, -0.8)] {
                        let normal = along(angle);
                        let plane = Vector2::new(normal.x, normal.y);
                        let expected =
                            closed_form::planar_2r(links, armature, [first, first + second], reach, plane);
                        bench.check_mass(&bench.contact("lower", [reach, 0.0, 0.0], normal), expected);
                        contacts += 1;
                    }
                }
            }
        }
    }
    assert_eq!(contacts, 3 * 4 * 3 * 2 * 3);
}

#[test]
fn geared_masses() {
    // The gripper's fingers mirror each other: the dense route expresses their energy by the master's rate.
    let slide = |name: &str, child: &str| {
        JointDescription::new(name, JointKind::Prismatic, "ground", child).axis([0.0, 0.0, 1.0])
    };
    let block = |name: &str, m| LinkDescription::new(name, Inertial::diagonal(m, [0.0; 3], [0.01; 3]));
    let links = vec![ground(), block("one", 2.0), block("two", 0.7)];
    let joints = vec![slide("first", "one"), slide("second", "two").mimic("first", -3.0, 0.1)];
    let pair = Bench::new(alter::build("geared", links, joints));
    let contact = pair.contact("one", [0.1, 0.0, 0.0], Vector3::z());
    pair.check_mass_by(&contact, closed_form::geared(2.0, 0.7, -3.0), &[Route::Dense]);
    let follower = pair.contact("two", [0.1, 0.0, 0.0], Vector3::z());
    pair.check_mass_by(&follower, closed_form::geared(2.0, 0.7, -3.0) / 9.0, &[Route::Dense]);
    // Against each other, the gap closes at the rate 1 + 3.
    let other = pair.system.mechanism().find_link("two").unwrap();
    pair.check_mass_by(&contact.against(other), closed_form::geared(2.0, 0.7, -3.0) / 16.0, &[Route::Dense]);
}

/// Three fingers of mass m on a palm of mass M, with the travels q, −q and q along the slide of the palm. The palm and q have the mass
/// matrix [[M + 3m, m], [m, 3m]]; fingers with opposite travels close at 2 q̇, so that m̄ = (3m − m²/(M + 3m)) / 4.
#[test]
fn fingers_that_mimic_one_another() {
    let (palm_mass, m) = (1.7, 0.4);
    let body = |name: &str, m| LinkDescription::new(name, Inertial::diagonal(m, [0.0; 3], [0.1 * m; 3]));
    let slide = |name: &str, parent: &str, child: &str| {
        JointDescription::new(name, JointKind::Prismatic, parent, child)
    };
    let mut builder = MechanismBuilder::new("gripper").link(ground()).link(body("palm", palm_mass));
    builder = builder.joint(slide("palm_slide", "ground", "palm"));
    for (k, multiplier) in [1.0, -1.0, 1.0].into_iter().enumerate() {
        let mut joint =
            slide(&format!("slide_{k}"), "palm", &format!("finger_{k}")).at([0.0, 0.1 * k as f64, 0.0]);
        if k > 0 {
            joint.mimic = Some(MimicDescription { joint: "slide_0".into(), multiplier, offset: 0.0 });
        }
        builder = builder.link(body(&format!("finger_{k}"), m)).joint(joint);
    }
    let system =
        System::new(builder.build().expect("a gripper").mechanism, &Conditions::new()).expect("fits");
    let pose = system.pose(&system.configuration()).expect("a pose");
    let finger = |k: usize| system.mechanism().find_link(&format!("finger_{k}")).expect("a finger");
    let expected = (3.0 * m - m * m / (palm_mass + 3.0 * m)) / 4.0;
    for (on, against) in [(0, 1), (1, 0), (1, 2), (2, 1)] {
        for frame in [Frame::Link, Frame::Against, Frame::World] {
            let contact =
                Contact::new(finger(on), [0.02, 0.03, -0.01], [1.0, 0.0, 0.0]).against(finger(against));
            let contact = contact.normal(Direction::Along(Vector3::x(), frame));
            let answer = pose
                .assembly()
                .batch(&contact)
                .expect("a contact")
                .effective_mass(pose.positions())
                .expect("fits");
            let Some(EffectiveMass::Finite(mass)) = answer.mass else { panic!("{answer:?}") };
            assert!(answer.error.is_some(), "{answer:?}");
            assert_close(mass, expected);
        }
    }
}
