//! Route C on closed loops compared with closed forms.

use nalgebra::{Vector2, Vector3};
use percuss_mechanism::Mechanism;
use percuss_oracle::closed_form::{
    self, Crossing, FourBar, PlanarBody, PlanarPose, antiparallelogram, planar_effective_mass,
};
use percuss_oracle::linkage::{self, Linkage};
use percuss_oracle::maximal::{Answer, Outcome, Question, poses, solve};
use percuss_spatial::Transform;
use std::f64::consts::{PI, TAU};

/// Loops in general position: rounding times a condition of some tens.
const TOL: f64 = 1e-11;

fn ask(linkage: &Linkage, positions: &[Vec<f64>], on: &str, point: [f64; 3], normal: Vector3<f64>) -> Answer {
    let mechanism = &linkage.mechanism;
    let on = mechanism.find_link(on).unwrap();
    solve(&Question::new(mechanism, positions.to_vec(), on, point.into(), normal))
}

fn relative(outcome: Outcome, expected: f64) -> f64 {
    let Outcome::Finite(mass) = outcome else { panic!("{outcome:?}, expected {expected}") };
    (mass / expected - 1.0).abs()
}

fn in_plane(n: Vector2<f64>) -> Vector3<f64> {
    linkage::plane().vector(&n.push(0.0))
}

/// Largest relative error for contacts on every link of a planar linkage with one driver, in many directions, over the whole
/// range. Links and bodies are in the same order, the ground first.
fn planar(
    linkage: &Linkage,
    bodies: [PlanarBody; 3],
    expected: impl Fn(f64) -> [PlanarPose; 3],
    redundant: usize,
) -> f64 {
    let mut worst = 0.0f64;
    let mut compared = 0;
    for positions in linkage.sweep(61) {
        let theta = linkage.drivers_at(&positions)[0];
        let poses = expected(theta);
        let bodies: Vec<_> = bodies.into_iter().zip(poses).collect();
        for (i, point) in [(0, [0.2, 0.07]), (1, [0.31, -0.12]), (2, [0.24, 0.1])] {
            for k in 0..3 {
                let (sin, cos) = (0.3 + f64::from(k) * TAU / 7.0).sin_cos();
                let (point, n) = (Vector2::from(point), Vector2::new(cos, sin));
                // The error grows if the velocity of the point along the normal is small.
                let closing = n.dot(&poses[i].velocity_of(point));
                if closing.abs() < 0.02 {
                    continue;
                }
                let name = linkage.mechanism.links()[i + 1].name();
                let answer = ask(linkage, &positions, name, [point.x, point.y, 0.03], in_plane(n));
                let mass = planar_effective_mass(&bodies, i, point, n);
                worst = worst.max(relative(answer.outcome, mass));
                assert_eq!(answer.degrees_of_freedom, 1, "{} at {theta}", linkage.name);
                assert_eq!(answer.redundant_constraints, redundant, "{} at {theta}", linkage.name);
                compared += 1;
            }
        }
    }
    assert!(compared > 250, "{}: only {compared}", linkage.name);
    println!("{}: {worst:e} of {compared}", linkage.name);
    worst
}

fn four_bar(bar: FourBar, crossing: Crossing) -> impl Fn(f64) -> [PlanarPose; 3] {
    move |theta| bar.poses(theta, crossing).unwrap()
}

#[test]
fn planar_linkages_over_their_whole_range() {
    let bodies = linkage::FOUR_BAR_BODIES;
    let poses = four_bar(linkage::FOUR_BAR, Crossing::Left);
    assert!(planar(&linkage::four_bar(), bodies, poses, 3) < TOL);
    let crossed = linkage::four_bar_of("crossed", linkage::FOUR_BAR, bodies, Crossing::Right, 0.7, [-PI, PI]);
    assert!(planar(&crossed, bodies, four_bar(linkage::FOUR_BAR, Crossing::Right), 3) < TOL);
    let poses = |theta| linkage::SLIDER_CRANK.poses(theta).unwrap();
    assert!(planar(&linkage::slider_crank(), linkage::SLIDER_CRANK_BODIES, poses, 3) < TOL);
    let poses = four_bar(linkage::PARALLELOGRAM, Crossing::Left);
    assert!(planar(&linkage::parallelogram(), bodies, poses, 3) < TOL);
    // At 0.3 rad from the change point the condition is ten times larger.
    let poses = four_bar(linkage::PARALLELOGRAM, Crossing::Right);
    assert!(planar(&linkage::antiparallelogram(), bodies, poses, 3) < 10.0 * TOL);
}

#[test]
fn parallelograms_by_hand() {
    let [crank, coupler, rocker] = linkage::FOUR_BAR_BODIES;
    let moment = |b: PlanarBody| b.inertia + b.mass * b.com.norm_squared();
    // The coupler does not rotate: 2T = (J₁ + J₃ + m₂ a²) θ̇².
    let energy = moment(crank) + moment(rocker) + coupler.mass * 0.4 * 0.4;
    let linkage = linkage::parallelogram();
    for positions in linkage.sweep(9) {
        let theta = linkage.drivers_at(&positions)[0];
        let n = in_plane(Vector2::new(-theta.sin(), theta.cos()));
        let answer = ask(&linkage, &positions, "rocker", [0.3, 0.0, 0.0], n);
        assert!(relative(answer.outcome, energy / 0.09) < TOL);
    }
    let linkage = linkage::antiparallelogram();
    for positions in linkage.sweep(9) {
        let theta = linkage.drivers_at(&positions)[0];
        let (psi, _) = antiparallelogram(1.0, 0.4, theta);
        let at = positions[linkage.mechanism.find_joint("rocker_hinge").unwrap().index()][0];
        assert!((at - psi).sin().abs() < 1e-12, "{at} {psi}");
    }
}

#[test]
fn massless_arms_carry_the_wheel() {
    let linkage = linkage::massless_arm_suspension();
    for positions in linkage.sweep(21) {
        let theta = linkage.drivers_at(&positions)[0];
        let n = in_plane(Vector2::new(-theta.sin(), theta.cos()));
        for r_b in [0.1, 0.25, 0.37] {
            let answer = ask(&linkage, &positions, "crank", [r_b, 0.0, 0.0], n);
            let expected = closed_form::massless_arm_suspension(38.0, 0.4, r_b);
            let error = relative(answer.outcome, expected);
            assert!(error < 1e-12, "{theta}, {r_b}: {error:e}");
        }
    }
}

#[test]
fn hooke_shafts_over_a_full_turn() {
    let mut worst = 0.0f64;
    for beta in [0.2, 0.6, 1.1] {
        let linkage = linkage::hooke_shaft(beta);
        for positions in linkage.sweep(49) {
            let theta = linkage.drivers_at(&positions)[0];
            let n = linkage::plane().vector(&Vector3::new(-theta.sin(), theta.cos(), 0.0));
            let answer = ask(&linkage, &positions, "input", [0.15, 0.0, 0.4], n);
            let expected = closed_form::hooke_shaft(0.03, 0.08, beta, theta, 0.15);
            worst = worst.max(relative(answer.outcome, expected));
            assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (1, 3));
            let output = positions[linkage.mechanism.find_joint("output").unwrap().index()][0];
            assert!((output - closed_form::hooke_output_angle(beta, theta)).abs() < 1e-11, "{beta} {theta}");
        }
    }
    println!("{worst:e}");
    assert!(worst < TOL);
}

#[test]
fn rods_between_sliders() {
    let ([first, second], length) = linkage::TRAMMEL;
    for (linkage, degrees) in [(linkage::trammel(), 1), (linkage::trammel_with_rod(), 2)] {
        for positions in linkage.sweep(23) {
            let x = linkage.drivers_at(&positions)[0];
            let y = (length * length - x * x).sqrt();
            let tilt = Vector3::new(0.6, 0.3, -0.4).normalize();
            let answer = ask(&linkage, &positions, "first", [0.1, 0.0, 0.2], linkage::plane().vector(&tilt));
            let along = closed_form::elliptic_trammel(first, second, x, y);
            // Both sliders move under a contact out of the plane at the first; the component of the normal along its guide counts.
            assert!(relative(answer.outcome, closed_form::slider(along, tilt.x)) < TOL, "{}", linkage.name);
            assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (degrees, 0));
        }
    }
}

fn tangent(frame: Transform<f64>, angle: f64) -> Vector3<f64> {
    frame.vector(&Vector3::new(-angle.sin(), angle.cos(), 0.0))
}

#[test]
fn trains_of_couplings() {
    let origin = |m: &Mechanism, name: &str| *m.joint(m.find_joint(name).unwrap()).origin();
    let rack = linkage::rack_and_pinion();
    for positions in rack.sweep(5) {
        let answer = ask(&rack, &positions, "rack", [0.2, 0.1, 0.0], Vector3::x());
        assert!(relative(answer.outcome, closed_form::rack_and_pinion(1.5, 0.0021, 0.06)) < TOL);
        assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (1, 0));
    }
    let pair = linkage::geared_pair();
    for positions in pair.sweep(9) {
        let n = tangent(origin(&pair.mechanism, "slow"), pair.drivers_at(&positions)[0]);
        let answer = ask(&pair, &positions, "slow", [0.08, 0.0, 0.1], n);
        assert!(relative(answer.outcome, closed_form::gear_pair(0.02, 0.005, -2.5, 0.08)) < TOL);
    }
    let cam = linkage::cam_and_sum();
    for positions in cam.sweep(9) {
        let angle = cam.drivers_at(&positions)[0];
        let s = angle + 0.1;
        let slope = 0.1 + 2.0 * 0.05 * s - 3.0 * 0.02 * s * s + 4.0 * 0.01 * s * s * s;
        let along = origin(&cam.mechanism, "follower").vector(&Vector3::x());
        let answer = ask(&cam, &positions, "follower", [0.1, 0.0, 0.0], along);
        // The energy at unit speed of the follower; the cam turns 1/slope times as fast.
        assert!(relative(answer.outcome, 1.5 + 0.02 / (slope * slope)) < TOL);
        assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (3, 0));
    }
    let planetary = linkage::planetary_gear();
    let expected =
        closed_form::planetary_gear([0.004, 0.0006, 0.0003], 0.4, 0.063, 1.0, [24.0, 18.0, 60.0], 0.05);
    for positions in planetary.sweep(9) {
        let n = tangent(origin(&planetary.mechanism, "carrier"), planetary.drivers_at(&positions)[0]);
        let answer = ask(&planetary, &positions, "carrier", [0.05, 0.0, 0.0], n);
        assert!(relative(answer.outcome, expected) < TOL);
        assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (1, 5));
    }
}

#[test]
fn ladders_of_any_length() {
    for n in [1, 4, 12] {
        let linkage = linkage::ladder(n);
        let energy = (n + 1) as f64 * 0.07 + 0.16 * n as f64 * 0.8;
        for positions in linkage.sweep(4) {
            let theta = linkage.drivers_at(&positions)[0];
            let n_plane = in_plane(Vector2::new(-theta.sin(), theta.cos()));
            let answer = ask(&linkage, &positions, "link_0", [0.2, 0.0, 0.0], n_plane);
            let error = relative(answer.outcome, energy / 0.04);
            assert!(error < TOL * n as f64, "{n}: {error:e}");
            assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (1, 3 * n));
        }
    }
}

#[test]
fn separate_loops_are_independent() {
    let linkage = linkage::separate(3);
    let positions = &linkage.sweep(3)[1];
    let mechanism = &linkage.mechanism;
    for i in 1..=3 {
        let size = 1.0 + 0.1 * i as f64;
        let bar = FourBar { ground: 0.9 * size, crank: 0.25 * size, coupler: 0.8 * size, rocker: 0.6 * size };
        let bodies = [
            PlanarBody::new(1.3, [0.08, -0.02], 0.011),
            PlanarBody::new(2.1 * size, [0.38, 0.11], 0.13),
            PlanarBody::new(1.7, [0.27, -0.05], 0.06 * size),
        ];
        let theta = positions[mechanism.find_joint(&format!("crank_hinge_{i}")).unwrap().index()][0];
        let bodies: Vec<_> = bodies.into_iter().zip(bar.poses(theta, Crossing::Left).unwrap()).collect();
        let (point, n) = (Vector2::new(0.3, 0.1), Vector2::new(0.6, 0.8));
        let answer = ask(&linkage, positions, &format!("coupler_{i}"), [0.3, 0.1, 0.0], in_plane(n));
        assert!(relative(answer.outcome, planar_effective_mass(&bodies, 1, point, n)) < TOL);
        assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (3, 9));
    }
}

#[test]
fn one_suspension_in_two_descriptions() {
    let (hinged, balls) = (linkage::double_wishbone(), linkage::two_point_wishbone());
    let start = hinged.closed_start();
    let hinge = *linkage::GENERIC_CORNER.lower.hinge.first().unwrap();
    let axis = (Vector3::from(linkage::GENERIC_CORNER.lower.hinge[1]) - Vector3::from(hinge)).normalize();
    let mut worst = 0.0f64;
    for positions in balls.sweep(7) {
        // Angle of the lower arm about its hinge.
        let arm = balls.mechanism.find_link("lower_arm").unwrap();
        let turn = poses(&balls.mechanism, &positions)[arm.index()].fixed_view::<3, 3>(0, 0).into_owned();
        let sine = Vector3::new(turn.m32 - turn.m23, turn.m13 - turn.m31, turn.m21 - turn.m12) / 2.0;
        let angle = axis.dot(&sine).asin();
        let spin = balls.drivers_at(&positions)[1];
        let same = hinged.move_drivers(&start, &[angle, spin]).unwrap();
        let n = Vector3::new(0.1, -0.2, 0.9).normalize();
        for (link, point) in
            [("lower_arm", [0.1, 0.15, 0.02]), ("upright", [0.0; 3]), ("spindle", [0.2, 0.1, -0.3])]
        {
            let (a, b) = (ask(&hinged, &same, link, point, n), ask(&balls, &positions, link, point, n));
            worst = worst.max(relative(a.outcome, b.outcome.finite().unwrap()));
            assert_eq!((a.degrees_of_freedom, a.redundant_constraints), (2, 0));
            assert_eq!((b.degrees_of_freedom, b.redundant_constraints), (2, 2));
        }
    }
    println!("{worst:e}");
    assert!(worst < 1e-10, "{worst:e}");
}

#[test]
fn a_rounded_four_bar_is_its_exact_twin() {
    let (exact, rounded) = linkage::rounded_four_bar();
    let mut worst = 0.0f64;
    for positions in exact.sweep(24) {
        let free = rounded.dependent();
        let (near, residual) =
            percuss_oracle::maximal::close_as_far_as_possible(&rounded.mechanism, &positions, &free);
        assert!((1e-7..1e-5).contains(&residual), "{residual:e}");
        let n = Vector3::new(0.5, 0.2, 0.8);
        for link in ["crank", "coupler", "rocker"] {
            let (a, b) = (
                ask(&exact, &positions, link, [0.3, 0.1, 0.0], n.normalize()),
                ask(&rounded, &near, link, [0.3, 0.1, 0.0], n.normalize()),
            );
            assert_eq!((a.degrees_of_freedom, a.redundant_constraints), (1, 3));
            assert_eq!((b.degrees_of_freedom, b.redundant_constraints), (1, 3));
            worst = worst.max(relative(b.outcome, a.outcome.finite().unwrap()));
            // With the default threshold of the exact file the linkage would be rigid.
            let question = Question {
                threshold: Some(1e-10),
                ..Question::new(
                    &rounded.mechanism,
                    near.clone(),
                    rounded.mechanism.find_link(link).unwrap(),
                    Vector3::new(0.3, 0.1, 0.0),
                    n.normalize(),
                )
            };
            assert_eq!(solve(&question).outcome, Outcome::Immovable);
        }
    }
    println!("{worst:e}");
    // Some micrometres per metre, times the transmission ratio.
    assert!(worst < 1e-4, "{worst:e}");
}
