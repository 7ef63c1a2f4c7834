//! When there is no finite effective mass, or hardly one: blows into the bearings, massless feelers, everything
//! locked; and massless links that must not matter.

use nalgebra::{Vector2, Vector3};
use percuss_dynamics::{
    Conditions, Contact, ContactError, Direction, EffectiveMass, Frame, Remark, Route, RouteChoice,
    StrikeError, System,
};
use percuss_oracle::closed_form::{self, PlanarLink};
use percuss_oracle::zoo;
use percuss_tests::bench::{Bench, TOL, along, mass};
use std::sync::Arc;

#[test]
fn nothing_moves() {
    let pendulum = Bench::new(zoo::physical_pendulum(2.3, 0.35, 0.04)).set("hinge", &[0.6]);
    // Into the bearing: along the arm, along the axis, and anywhere on the axis.
    for (point, normal) in
        [([0.5, 0.0, 0.2], along(0.6)), ([0.5, 0.1, 0.0], Vector3::z()), ([0.0, 0.0, 0.7], along(1.9))]
    {
        assert_eq!(pendulum.outcome(&pendulum.contact("body", point, normal)), EffectiveMass::Immovable);
    }
    // The ground itself; links that are one body.
    assert_eq!(
        pendulum.outcome(&pendulum.contact("ground", [0.1; 3], Vector3::x())),
        EffectiveMass::Immovable
    );
    let frames = Bench::new(zoo::fixed_frames());
    let ballast = frames.system.mechanism().find_link("ballast").unwrap();
    let one_body = frames.contact("sensor", [0.1, 0.2, 0.3], Vector3::y()).against(ballast);
    assert_eq!(frames.outcome(&one_body), EffectiveMass::Immovable);
    // Everything locked.
    for (name, mechanism) in zoo::all() {
        let all = mechanism.joints().iter().fold(Conditions::new(), |c, joint| c.lock(joint.name()));
        let leaf = mechanism.order().last().unwrap();
        let leaf = mechanism.link(*leaf).name().to_owned();
        let still = Bench::under(mechanism, &all);
        let contact = still.contact(&leaf, [0.3, 0.2, 0.1], Vector3::new(1.0, 2.0, 3.0));
        assert_eq!(still.outcome(&contact), EffectiveMass::Immovable, "{name}");
        let strike = still.strike(&contact, RouteChoice::Auto);
        assert_eq!((strike.degrees_of_freedom, strike.shares), (0, None), "{name}");
    }
    // Struck against a number, an immovable wall leaves the number.
    let wall = pendulum.strike(&pendulum.contact("body", [0.5, 0.0, 0.0], along(0.6)), RouteChoice::Auto);
    assert_eq!(wall.against_mass(0.3).effective_mass, EffectiveMass::Finite(0.3));
}

#[test]
fn hardly_anything_moves() {
    // From 1e-10 to 1e-6 of a right angle the answer is finite, with a remark; below, immovable.
    let (m, h, i_c) = (2.3, 0.35, 0.04);
    let pendulum = Bench::new(zoo::physical_pendulum(m, h, i_c));
    for (slope, finite, remarked) in
        [(1e-5f64, true, false), (1e-7, true, true), (1e-9, true, true), (1e-11, false, false)]
    {
        let contact = pendulum.contact("body", [0.5, 0.0, 0.0], Vector3::new(1.0, slope, 0.0));
        for route in [Route::Dense, Route::Articulated] {
            let strike = pendulum.strike(&contact, RouteChoice::Only(route));
            let nearly = strike.remarks.iter().any(|r| matches!(r, Remark::NearlyImmovable { .. }));
            assert_eq!(nearly, remarked, "{slope}");
            if finite {
                let expected = closed_form::physical_pendulum(i_c + m * h * h, 0.5 * slope.atan().sin());
                // The arm is a difference of ones: it keeps slope/ε digits, and m̄ says so.
                let said = strike.effective_mass_error.expect("finite");
                assert!((mass(&strike) - expected).abs() <= said + TOL * expected, "{slope}");
                assert!(said <= 1e-15 * 10.0 / slope * expected, "{slope}: it is better than that");
            } else {
                assert_eq!(strike.effective_mass, EffectiveMass::Immovable, "{slope}");
            }
        }
    }
}

#[test]
fn nothing_opposes() {
    let arm = Bench::new(zoo::massless_tip());
    let across = arm.contact("feeler", [0.2, 0.0, 0.0], Vector3::y());
    let dense = arm.strike(&across, RouteChoice::Only(Route::Dense));
    assert_eq!(dense.effective_mass, EffectiveMass::Massless);
    assert_eq!((dense.shares.clone(), dense.effective_mass_error), (None, None));
    assert_eq!(arm.strike(&across, RouteChoice::Auto).effective_mass, EffectiveMass::Massless);
    assert_eq!(dense.against_mass(5.0).effective_mass, EffectiveMass::Massless);
    // Along itself it pushes into the shoulder; its hinge locked, it is a part of the arm.
    let lengthwise = arm.contact("feeler", [0.2, 0.0, 0.0], Vector3::x());
    assert_eq!(arm.strike(&lengthwise, RouteChoice::Auto).effective_mass, EffectiveMass::Immovable);
    let locked = Bench::under(Arc::clone(arm.system.mechanism()), &Conditions::new().lock("feeler_hinge"));
    let link = arm.system.mechanism().find_link("arm").unwrap();
    let j_o = arm.system.mechanism().link(link).inertia().rotational[(2, 2)];
    locked.weighs(&across, closed_form::physical_pendulum(j_o, 0.8));
    // A rotor at its hinge gives it weight: the arm and the rotor in the rates of the absolute angles.
    let rotor =
        Bench::under(Arc::clone(arm.system.mechanism()), &Conditions::new().armature("feeler_hinge", [0.01]));
    let j_arm = PlanarLink { mass: 0.0, length: 0.6, com: 0.0, inertia: j_o };
    let feeler = PlanarLink { mass: 0.0, length: 0.2, com: 0.0, inertia: 0.0 };
    let expected = closed_form::planar_2r([j_arm, feeler], [0.0, 0.01], [0.0; 2], 0.2, Vector2::y());
    rotor.weighs(&across, expected);
}

#[test]
fn massless_links_within_are_exact() {
    // Three hinges with massless links between are a ball joint, though M is singular where two axes line up.
    for (about_x, about_y, about_z) in [(0.0, 0.0, 0.0), (0.4, -0.9, 1.7), (0.3, 1.5, 0.2)] {
        let chain = Bench::new(zoo::massless_chain())
            .set("about_x", &[about_x])
            .set("about_y", &[about_y])
            .set("about_z", &[about_z]);
        let ball = Bench::new(zoo::ball_joint());
        let normal = Vector3::new(0.2, 0.5, -0.8).normalize();
        // The same contact in the body: struck in its own axes, both bodies are alike.
        let point = [0.3, -0.2, 0.4];
        let of = |bench: &Bench| {
            bench.contact("body", point, normal).normal(Direction::Along(normal, Frame::Link))
        };
        let expected = mass(&ball.strike(&of(&ball), RouteChoice::Auto));
        chain.weighs(&of(&chain), expected);
    }
}

#[test]
fn handles_of_another_mechanism_are_refused() {
    let system = |mechanism| System::new(mechanism, &Conditions::new()).expect("default conditions fit");
    let (arm, pendulum) = (system(zoo::six_r_arm()), system(zoo::double_pendulum()));
    let last = arm.mechanism().link_ids().last().expect("links");
    let pose = pendulum.pose(&pendulum.configuration()).expect("a tree poses");
    let foreign = pendulum.strike(&pose, &Contact::new(last, [0.0; 3], [1.0, 0.0, 0.0]), RouteChoice::Auto);
    assert!(
        matches!(foreign, Err(StrikeError::Contact(ContactError::ForeignLink { index, links })) if index >= links),
        "{foreign:?}"
    );
    let first = arm.mechanism().link_ids().nth(1).expect("links");
    let foreign = arm.strike(&pose, &Contact::new(first, [0.0; 3], [1.0, 0.0, 0.0]), RouteChoice::Auto);
    assert!(
        matches!(foreign, Err(StrikeError::Contact(ContactError::ForeignPose { got: 2, expected: 6 }))),
        "{foreign:?}"
    );
}
