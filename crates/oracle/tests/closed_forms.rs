//! Route C compared with closed forms.
//!
//! Tolerances: the matrices have unit columns and rows, and m̄ is stationary in v, so its error is some tens of
//! roundings times the condition of the null space: 1e-13 for these small mechanisms.

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use percuss_mechanism::Mechanism;
use percuss_oracle::closed_form::{self, PlanarLink};
use percuss_oracle::maximal::{Outcome, Question, effective_mass, poses};
use percuss_oracle::{random, zoo};

const TOL: f64 = 1e-13;

fn respond(mechanism: &Mechanism, q: &[f64], on: &str, point: [f64; 3], normal: Vector3<f64>) -> Outcome {
    effective_mass(&question(mechanism, q, on, point, normal))
}

/// Question with the joints of one degree of freedom at the values `q`, in order; fixed joints have no value.
fn question<'a>(
    mechanism: &'a Mechanism,
    q: &[f64],
    on: &str,
    point: [f64; 3],
    normal: Vector3<f64>,
) -> Question<'a> {
    let mut values = q.iter();
    let mut take = |n| values.by_ref().take(n).copied().collect();
    let positions = mechanism.joints().iter().map(|j| take(j.kind().positions())).collect();
    Question::new(mechanism, positions, mechanism.find_link(on).unwrap(), point.into(), normal)
}

fn assert_mass(outcome: Outcome, expected: f64, tolerance: f64) {
    let Outcome::Finite(mass) = outcome else { panic!("{outcome:?}, expected {expected}") };
    let error = (mass / expected - 1.0).abs();
    assert!(error <= tolerance, "got {mass}, expected {expected}, relative error {error:e}");
}

#[test]
fn point_mass_on_a_massless_rod() {
    let mechanism = zoo::point_mass_pendulum(1.5, 0.8);
    for (r_b, angle) in [(0.8, 0.0), (0.4, 0.7), (2.0, -2.2), (1e-3, 0.3)] {
        let normal = Vector3::new(-f64::sin(angle), f64::cos(angle), 0.0);
        let got = respond(&mechanism, &[angle], "rod", [r_b, 0.0, 0.0], normal);
        // The closing speed of a point near the hinge is a small difference: the error grows by the factor |j| / |j Z|.
        let tolerance = TOL * (0.8 / r_b).max(1.0);
        assert_mass(got, closed_form::point_mass_pendulum(1.5, 0.8, r_b), tolerance);
    }
}

#[test]
fn physical_pendulum_with_an_oblique_normal() {
    let mechanism = zoo::physical_pendulum(2.3, 0.35, 0.04);
    let inertia = 0.04 + 2.3 * 0.35 * 0.35;
    assert_mass(
        respond(&mechanism, &[0.4], "body", [0.5, 0.0, 0.2], {
            Vector3::new(-f64::sin(0.4), f64::cos(0.4), 0.0)
        }),
        1.287,
        TOL,
    );
    // m̄ depends only on the moment arm of the line of the normal.
    let (point, tilt) = (Vector3::new(0.3, 0.2, -0.1), Vector3::new(0.48, 0.64, 0.6));
    let arm = point.cross(&tilt).z;
    let got = respond(&mechanism, &[0.0], "body", point.into(), tilt);
    assert_mass(got, closed_form::physical_pendulum(inertia, arm), TOL);
}

#[test]
fn armature_of_a_hinge_adds_to_its_inertia() {
    let mechanism = zoo::physical_pendulum(2.3, 0.35, 0.04);
    let mut question = question(&mechanism, &[0.0], "body", [0.5, 0.0, 0.0], Vector3::y());
    question.armature = vec![(mechanism.find_joint("hinge").unwrap(), vec![0.07])];
    let expected = closed_form::physical_pendulum(0.04 + 2.3 * 0.35 * 0.35 + 0.07, 0.5);
    assert_mass(effective_mass(&question), expected, TOL);
}

#[test]
fn free_bodies_meet_off_centre() {
    let mechanism = zoo::two_free_bodies();
    let first_q = UnitQuaternion::from_euler_angles(0.4, -0.2, 1.0);
    let second_q = UnitQuaternion::from_euler_angles(-1.1, 0.6, 0.3);
    let position = |p: [f64; 3], q: UnitQuaternion<f64>| vec![p[0], p[1], p[2], q.w, q.i, q.j, q.k];
    let positions = vec![position([0.1, 0.2, 0.3], first_q), position([-0.4, 0.1, 0.2], second_q)];
    let x_wl = poses(&mechanism, &positions);
    let (first, second) = (mechanism.find_link("first").unwrap(), mechanism.find_link("second").unwrap());
    let normal = Vector3::new(0.3, -0.8, 0.5).normalize();
    let point = Vector3::new(0.3, 0.1, -0.2);
    let p_w = x_wl[first.index()].transform_point(&point.into()).coords;
    let alone = |link: percuss_mechanism::LinkId| {
        let inertia = mechanism.link(link).inertia();
        let com = inertia.first_moment / inertia.mass;
        let x = &x_wl[link.index()];
        let r_wl = x.fixed_view::<3, 3>(0, 0).into_owned();
        let shift = com.dot(&com) * nalgebra::Matrix3::identity() - com * com.transpose();
        let about_com = r_wl * (inertia.rotational - shift * inertia.mass) * r_wl.transpose();
        let arm = p_w - x.transform_point(&com.into()).coords;
        closed_form::free_body(inertia.mass, &about_com, &arm, &normal).unwrap()
    };
    let mut question = Question::new(&mechanism, positions.clone(), first, point, normal);
    assert_mass(effective_mass(&question), alone(first), TOL);
    question.against = Some(second);
    assert_mass(effective_mass(&question), closed_form::series(alone(first), alone(second)), TOL);
}

#[test]
fn double_pendulum_in_any_direction() {
    let mechanism = zoo::double_pendulum();
    let links = [PlanarLink::rod(1.4, 0.6), PlanarLink::rod(0.9, 0.5)];
    let angles = [-30f64.to_radians(), 25f64.to_radians()];
    let q = [angles[0], angles[1] - angles[0]];
    let n = Vector3::new(0.2, 0.98, 0.0).normalize();
    assert_mass(respond(&mechanism, &q, "lower", [0.5, 0.0, 0.0], n), 0.45252397213682, TOL);
    for i in 0..24 {
        let (sin, cos) = (0.1 + f64::from(i) * std::f64::consts::TAU / 24.0).sin_cos();
        let expected = closed_form::planar_2r(links, [0.0; 2], angles, 0.3, Vector2::new(cos, sin));
        let got = respond(&mechanism, &q, "lower", [0.3, 0.0, 0.0], Vector3::new(cos, sin, 0.0));
        assert_mass(got, expected, TOL);
    }
}

#[test]
fn general_two_link_arms_with_armature() {
    let link = |mass, length, com, inertia| PlanarLink { mass, length, com, inertia };
    let arms = [
        ([link(3.0, 0.7, 0.2, 0.09), link(1.1, 0.4, 0.5, 0.02)], [0.05, 0.02]),
        ([PlanarLink::point(2.0, 0.5), PlanarLink::point(0.3, 0.9)], [0.0, 0.0]),
        ([PlanarLink::rod(5.0, 1.0), PlanarLink::point(1e-3, 0.2)], [0.0, 0.4]),
    ];
    for (links, armature) in arms {
        let mechanism = zoo::planar_2r(links, armature);
        for angles in [[0.3, 1.4], [-2.0, 0.5], [1.0, 1.2]] {
            let n = Vector2::new(0.6, 0.8);
            let reach = 1.3 * links[1].length;
            let expected = closed_form::planar_2r(links, armature, angles, reach, n);
            let q = [angles[0], angles[1] - angles[0]];
            let got = respond(&mechanism, &q, "lower", [reach, 0.0, 0.0], n.push(0.0));
            assert_mass(got, expected, TOL);
        }
    }
}

#[test]
fn a_needle_keeps_its_digits_on_ten_tonnes() {
    let mechanism = zoo::needle_on_heavy_base();
    let got = respond(&mechanism, &[0.2, 0.0], "needle", [0.04, 0.0, 0.0], Vector3::y());
    // The masses differ by ten decades: the rounding of the base must not hide the share of the needle.
    assert_mass(got, closed_form::rod_tip_on_sliding_base(1e-6, 1e4), TOL);
    let along =
        respond(&mechanism, &[0.2, std::f64::consts::FRAC_PI_2], "needle", [0.04, 0.0, 0.0], Vector3::y());
    assert_mass(along, 1e4 + 1e-6, TOL);
}

#[test]
fn a_rod_on_a_sliding_base_at_all_mass_ratios() {
    for exponent in -12..=12 {
        let base = 10f64.powi(exponent);
        let (mut links, joints) = percuss_oracle::alter::describe(&zoo::needle_on_heavy_base());
        links[1].inertial.as_mut().unwrap().mass = base;
        let mechanism = percuss_oracle::alter::build("sliding", links, joints);
        let got = respond(&mechanism, &[0.0, 0.0], "needle", [0.04, 0.0, 0.0], Vector3::y());
        // The velocities of the fixed base are some ε instead of zero; their energy M (8 ε)² adds to m/3 of the needle.
        let tolerance = TOL + base / 1e-6 * (8.0 * f64::EPSILON).powi(2);
        assert_mass(got, closed_form::rod_tip_on_sliding_base(1e-6, base), tolerance);
    }
}

#[test]
fn mimics_are_gears() {
    let mechanism = zoo::mimic_gripper();
    let mut q = random::zero_positions(&mechanism);
    q[mechanism.find_joint("left").unwrap().index()] = vec![0.3];
    random::follow(&mechanism, &mut q);
    let finger = mechanism.find_link("left_finger").unwrap();
    let point = Vector3::new(0.1, 0.0, 0.0);
    let mut question = Question::new(&mechanism, q.clone(), finger, point, Vector3::x());
    question.locked = vec![mechanism.find_joint("lift").unwrap()];
    // With a locked lift there is one degree of freedom. Energy by hand: J about each hinge with the rates 1, −1, 1 − 0.5
    // (pad relative to the palm), and −0.03 of the plunger.
    let about_y = |link: &str, offset: Vector3<f64>| {
        let inertia = mechanism.link(mechanism.find_link(link).unwrap()).inertia();
        let r = offset + inertia.first_moment / inertia.mass;
        (inertia.mass, inertia.rotational[(1, 1)] - inertia.mass * (offset - r).xz().norm_squared(), r)
    };
    let mut energy = 0.002 + 0.001 + 0.1 * 0.03 * 0.03;
    let (m, moment, r) = about_y("left_finger", Vector3::zeros());
    energy += moment + m * r.xz().norm_squared();
    let (m, moment, r) = about_y("right_finger", Vector3::zeros());
    energy += moment + m * r.xz().norm_squared();
    // The pad in the axes of the finger: the hinge of the finger has the rate 1, the hinge of the pad −0.5.
    let tip = q[mechanism.find_joint("left_tip").unwrap().index()][0];
    let (m, moment, c) = about_y("left_pad", Vector3::zeros());
    let turned = Vector3::new(c.x * tip.cos() + c.z * tip.sin(), 0.0, c.z * tip.cos() - c.x * tip.sin());
    let velocity = Vector3::y().cross(&Vector3::new(0.08, 0.0, 0.02)) + 0.5 * Vector3::y().cross(&turned);
    energy += 0.25 * moment + m * velocity.norm_squared();
    energy += 0.3 * 0.03 * 0.03;
    // Contact point at 0.1 along the x-axis of the finger, rotated by 0.3 about y: its velocity along x is −0.1 sin 0.3.
    let arm = 0.1 * 0.3f64.sin();
    assert_mass(effective_mass(&question), energy / (arm * arm), TOL * 10.0);
}

#[test]
fn three_hinges_with_massless_links_are_a_ball_joint() {
    let (chain, ball) = (zoo::massless_chain(), zoo::ball_joint());
    let (a, b, c) = (0.4, -0.7, 1.1);
    let about = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
    let q = about(Vector3::x_axis(), a) * about(Vector3::y_axis(), b) * about(Vector3::z_axis(), c);
    let (point, normal) = ([0.2, 0.1, -0.3], Vector3::new(0.3, 0.5, -0.8).normalize());
    let Outcome::Finite(expected) = respond(&ball, &[q.w, q.i, q.j, q.k], "body", point, normal) else {
        panic!("the ball joint moves")
    };
    assert_mass(respond(&chain, &[a, b, c], "body", point, normal), expected, TOL);
    // By hand: 1/m̄ = (r × n)ᵀ I_O⁻¹ (r × n), in the axes of the body.
    let body = ball.link(ball.find_link("body").unwrap()).inertia();
    let arm = Vector3::from(point).cross(&(q.inverse() * normal));
    let mobility = arm.dot(&(body.rotational.try_inverse().unwrap() * arm));
    assert_mass(Outcome::Finite(expected), 1.0 / mobility, TOL);
}
