//! Contacts without a finite effective mass, or nearly so: normals into the bearings, massless feelers, all joints
//! locked; and massless links that must not affect m̄.

use nalgebra::{Vector2, Vector3};
use percuss_dynamics::{
    AssemblyError, Conditions, Contact, ContactError, Direction, EffectiveMass, Frame, Remark, ResponseError,
    Route, RouteChoice, System,
};
use percuss_mechanism::{Inertial, JointDescription, LinkDescription};
use percuss_oracle::closed_form::{self, PlanarLink};
use percuss_oracle::linkage::{self, Linkage};
use percuss_oracle::{alter, zoo};
use percuss_tests::bench::{Bench, TOL, along, mass};
use percuss_tests::rig::Rig;
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

#[test]
fn immovable_contacts() {
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
        let response = still.respond(&contact);
        assert_eq!((response.degrees_of_freedom, response.contributions), (0, None), "{name}");
    }
    // An immovable wall against a free mass gives the free mass.
    let wall = pendulum.respond(&pendulum.contact("body", [0.5, 0.0, 0.0], along(0.6)));
    assert_eq!(wall.against_mass(0.3).expect("a mass").effective_mass, EffectiveMass::Finite(0.3));
}

#[test]
fn nearly_immovable_contacts() {
    // From 1e-10 to 1e-6 of a right angle m̄ is finite, with a remark; below, immovable.
    let (m, h, i_c) = (2.3, 0.35, 0.04);
    let pendulum = Bench::new(zoo::physical_pendulum(m, h, i_c));
    for (slope, finite, remarked) in
        [(1e-5f64, true, false), (1e-7, true, true), (1e-9, true, true), (1e-11, false, false)]
    {
        let contact = pendulum.contact("body", [0.5, 0.0, 0.0], Vector3::new(1.0, slope, 0.0));
        for route in [Route::Dense, Route::Articulated] {
            let response = pendulum.respond_by_route(&contact, RouteChoice::Only(route));
            let nearly = response.remarks.iter().any(|r| matches!(r, Remark::NearlyImmovable { .. }));
            assert_eq!(nearly, remarked, "{slope}");
            if finite {
                let expected = closed_form::physical_pendulum(i_c + m * h * h, 0.5 * slope.atan().sin());
                // The lever arm is a difference of numbers of order one: its relative error is ε/slope.
                let stated = response.effective_mass_error().expect("finite");
                let off = (mass(&response) / expected - 1.0).abs();
                assert!(off <= 16.0 * f64::EPSILON / slope + TOL, "{route:?}, {slope}: {off:e}");
                assert!(
                    off * expected <= stated,
                    "{route:?}, {slope}: off by {off:e}, {stated:e} kg is stated"
                );
                assert!(
                    stated <= 5e-14 / slope * expected,
                    "{route:?}, {slope}: {stated:e} of {expected} kg"
                );
            } else {
                assert_eq!(response.effective_mass, EffectiveMass::Immovable, "{slope}");
            }
        }
    }
}

#[test]
fn massless_contacts() {
    let arm = Bench::new(zoo::massless_tip());
    let across = arm.contact("feeler", [0.2, 0.0, 0.0], Vector3::y());
    let dense = arm.respond_by_route(&across, RouteChoice::Only(Route::Dense));
    assert_eq!(dense.effective_mass, EffectiveMass::Massless);
    assert_eq!((dense.contributions.clone(), dense.effective_mass_error()), (None, None));
    assert_eq!(arm.respond(&across).effective_mass, EffectiveMass::Massless);
    assert_eq!(dense.against_mass(5.0).expect("a mass").effective_mass, EffectiveMass::Massless);
    // A contact along the feeler pushes into the shoulder; with its hinge locked, the feeler is part of the arm.
    let lengthwise = arm.contact("feeler", [0.2, 0.0, 0.0], Vector3::x());
    assert_eq!(arm.respond(&lengthwise).effective_mass, EffectiveMass::Immovable);
    let locked = Bench::under(Arc::clone(arm.system.mechanism()), &Conditions::new().lock("feeler_hinge"));
    let link = arm.system.mechanism().find_link("arm").unwrap();
    let j_o = arm.system.mechanism().link(link).inertia().rotational[(2, 2)];
    locked.check_mass(&across, closed_form::physical_pendulum(j_o, 0.8));
    // A rotor at its hinge gives the feeler mass: arm and rotor in the rates of the absolute angles.
    let rotor =
        Bench::under(Arc::clone(arm.system.mechanism()), &Conditions::new().armature("feeler_hinge", [0.01]));
    let j_arm = PlanarLink { mass: 0.0, length: 0.6, com: 0.0, inertia: j_o };
    let feeler = PlanarLink { mass: 0.0, length: 0.2, com: 0.0, inertia: 0.0 };
    let expected = closed_form::planar_2r([j_arm, feeler], [0.0, 0.01], [0.0; 2], 0.2, Vector2::y());
    rotor.check_mass(&across, expected);
}

/// A four-bar with a tail of negative inertia: the recursion has no answer, and the dense route states its own closing
/// error.
#[test]
fn the_route_that_answers_states_the_closing_error() {
    let four_bar = linkage::four_bar();
    let (mut links, mut joints) = alter::describe(&four_bar.mechanism);
    let (closures, couplings) = alter::describe_loops(&four_bar.mechanism);
    links.push(LinkDescription::new("tail", Inertial::diagonal(0.0, [0.0; 3], [-1e-3; 3])));
    let (parent, child) = ("coupler".to_owned(), "tail".to_owned());
    joints.push(JointDescription { name: "tail_hinge".into(), parent, child, ..joints[1].clone() });
    let mechanism = alter::build_with_loops("tailed", links, joints, closures, couplings);
    let rig = Rig::new(Linkage { mechanism, ..four_bar });
    let tail = rig.mechanism.find_link("tail").expect("a link");
    let response = rig.respond(&rig.closed(), &Contact::new(tail, [0.01, 0.0, 0.0], [0.3, 1.0, 0.0]));
    assert_eq!(response.route, Route::Dense);
    assert!(response.remarks.contains(&Remark::IndefiniteMassMatrix), "{response:?}");
    let closing = response.error.expect("finite").closing.expect("known");
    assert!(closing < 1e-9 * mass(&response), "{closing:e} of {} kg", mass(&response));
}

/// Linkages with one degree of freedom, link masses over fourteen decades, and normals nearly across the motion of the point: the routes
/// agree within their stated errors.
#[test]
fn routes_agree_within_their_errors_over_many_decades() {
    let mut random = StdRng::seed_from_u64(90_061);
    let mut compared = 0;
    for linkage in [linkage::four_bar, linkage::slider_crank, linkage::antiparallelogram, linkage::six_bar] {
        for _ in 0..60 {
            let linkage = linkage();
            let (mut links, joints) = alter::describe(&linkage.mechanism);
            let (closures, couplings) = alter::describe_loops(&linkage.mechanism);
            for inertial in links.iter_mut().filter_map(|link| link.inertial.as_mut()) {
                let factor = 10.0_f64.powf(random.random_range(-7.0..7.0));
                inertial.mass *= factor;
                inertial.about_com *= factor;
            }
            let link = links[random.random_range(1..links.len())].name.clone();
            let mechanism = alter::build_with_loops("decades", links, joints, closures, couplings);
            let rig = Rig::new(Linkage { mechanism, ..linkage });
            let (pose, link) = (rig.closed(), rig.mechanism.find_link(&link).expect("a link"));
            let contact = |normal: Vector3<f64>| {
                let at = Contact::new(link, [0.11, -0.07, 0.03], normal);
                at.normal(Direction::Along(normal, Frame::World))
            };
            let speed = |normal: Vector3<f64>| match rig.respond(&pose, &contact(normal)).effective_mass {
                EffectiveMass::Finite(m) => 1.0 / m.sqrt(),
                _ => 0.0,
            };
            // Velocity of the point per unit energy, up to its sign: magnitudes along the axes, signs along the diagonals.
            let mut velocity = Vector3::new(speed(Vector3::x()), speed(Vector3::y()), speed(Vector3::z()));
            for k in 1..3 {
                let mut diagonal = Vector3::x();
                diagonal[k] = 1.0;
                let [sum, difference] = [1.0, -1.0].map(|sign| (velocity.x + sign * velocity[k]).abs());
                let shown = speed(diagonal.normalize()) * 2.0_f64.sqrt();
                if (shown - difference).abs() < (shown - sum).abs() {
                    velocity[k] = -velocity[k];
                }
            }
            let Some(along) = velocity.try_normalize(0.0) else { continue };
            let across = along.cross(&Vector3::new(0.3, -0.5, 0.8)).normalize();
            let normal = across + along * 10.0_f64.powf(random.random_range(-4.0..0.0));
            let by = |route| pose.respond_by_route(&contact(normal.normalize()), RouteChoice::Only(route));
            let answers = [Route::Dense, Route::Articulated].map(|route| by(route).expect("an answer"));
            let [EffectiveMass::Finite(dense), EffectiveMass::Finite(recursive)] =
                answers.each_ref().map(|answer| answer.effective_mass)
            else {
                continue;
            };
            let stated: f64 = answers.iter().filter_map(|answer| answer.effective_mass_error()).sum();
            let name = rig.mechanism.name();
            assert!((dense - recursive).abs() <= stated, "{name}: {dense} {recursive} ± {stated:e}");
            compared += 1;
        }
    }
    assert!(compared > 200, "{compared}");
}

#[test]
fn massless_links_within_are_exact() {
    // Three hinges with massless links between them form a ball joint, although M is singular if two axes are aligned.
    for (about_x, about_y, about_z) in [(0.0, 0.0, 0.0), (0.4, -0.9, 1.7), (0.3, 1.5, 0.2)] {
        let chain = Bench::new(zoo::massless_chain())
            .set("about_x", &[about_x])
            .set("about_y", &[about_y])
            .set("about_z", &[about_z]);
        let ball = Bench::new(zoo::ball_joint());
        let normal = Vector3::new(0.2, 0.5, -0.8).normalize();
        // The same contact in the body's own axes: both bodies give the same result.
        let point = [0.3, -0.2, 0.4];
        let of = |bench: &Bench| {
            bench.contact("body", point, normal).normal(Direction::Along(normal, Frame::Link))
        };
        let expected = mass(&ball.respond(&of(&ball)));
        chain.check_mass(&of(&chain), expected);
    }
}

#[test]
fn handles_of_another_mechanism_are_refused() {
    let system = |mechanism| System::new(mechanism, &Conditions::new()).expect("default conditions fit");
    let (arm, pendulum) = (system(zoo::six_r_arm()), system(zoo::double_pendulum()));
    let last = arm.mechanism().link_ids().last().expect("links");
    let pose = pendulum.pose(&pendulum.configuration()).expect("a tree poses");
    let foreign = pose.respond(&Contact::new(last, [0.0; 3], [1.0, 0.0, 0.0]));
    assert!(
        matches!(foreign, Err(ResponseError::Contact(ContactError::ForeignLink { index, links })) if index >= links),
        "{foreign:?}"
    );
    // A configuration or a pose of another system is refused.
    let foreign = arm.pose(&pendulum.configuration());
    assert!(matches!(foreign, Err(AssemblyError::ForeignConfiguration { .. })), "{foreign:?}");
    let foreign = arm.pose_from(&pose, &arm.configuration());
    assert!(matches!(foreign, Err(AssemblyError::ForeignPose)), "{foreign:?}");
}
