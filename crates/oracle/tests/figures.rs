//! Values from other programs and publications: suspensions of Project Chrono, a linkage at its change point.
//!
//! Hardpoints, masses and inertias of the suspensions: Project Chrono, data/vehicle, `HMMWV_DoubleWishboneFront.json`
//! and `Sedan_DoubleWishbone.json` (BSD 3-clause). The inertias of arms are given in the axes u from the front to the rear hinge
//! point, w normal to the plane of the arm, v = w × u.

use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription,
};
use percuss_oracle::alter::build_with_loops;
use percuss_oracle::linkage::{Arm, Corner, double_wishbone_of};
use percuss_oracle::maximal::{Question, close_as_far_as_possible, poses, solve};
use percuss_oracle::random;
use std::f64::consts::FRAC_PI_2;

type Point = [f64; 3];

fn arm(mass: f64, com: Point, moments: Point, hinge: [Point; 2], ball: Point) -> Arm {
    let [front, back, outer] = [hinge[0], hinge[1], ball].map(Vector3::from);
    let w = (back - outer).cross(&(front - outer)).normalize();
    let u = (back - front).normalize();
    let axes = Matrix3::from_columns(&[u, w.cross(&u), w]);
    let about_com = axes * Matrix3::from_diagonal(&moments.into()) * axes.transpose();
    Arm { hinge, ball, body: Inertial { mass, com: com.into(), about_com } }
}

/// m̄ at the spring seat on the lower arm, along the line of the spring, in the design position; wheel free and locked.
fn felt_by_the_spring(corner: &Corner) -> [f64; 2] {
    let linkage = double_wishbone_of(corner);
    let mechanism = &linkage.mechanism;
    let positions = random::zero_positions(mechanism);
    let on = mechanism.find_link("lower_arm").unwrap();
    let [top, seat] = corner.spring.map(Vector3::from);
    let point = seat - Vector3::from(corner.lower.hinge[0]);
    let free = Question::new(mechanism, positions, on, point, (top - seat).normalize());
    let locked = Question { locked: vec![mechanism.find_joint("spin").unwrap()], ..free.clone() };
    [(free, 2), (locked, 1)].map(|(question, degrees)| {
        let answer = solve(&question);
        assert_eq!((answer.degrees_of_freedom, answer.redundant_constraints), (degrees, 0));
        answer.outcome.finite().unwrap()
    })
}

fn assert_figure(got: f64, figure: f64, unit: f64) {
    assert!((got - figure).abs() <= 0.5001 * unit, "got {got}, expected {figure}");
}

#[test]
fn front_suspension_of_the_hmmwv() {
    let mut corner = Corner {
        lower: arm(
            23.965,
            [0.0, 0.547, -0.059],
            [0.4, 0.4, 0.8938],
            [[0.223, 0.307, 0.0], [-0.223, 0.307, 0.0]],
            [-0.036, 0.787, -0.118],
        ),
        upper: arm(
            5.813,
            [-0.106, 0.589, 0.218],
            [0.03, 0.03, 0.06276],
            [[-0.048, 0.446, 0.245], [-0.268, 0.478, 0.196]],
            [-0.053, 0.716, 0.215],
        ),
        upright: Inertial::diagonal(19.45, [-0.04, 0.751, -0.026], [0.1656, 0.1934, 0.04367]),
        spindle: Inertial::diagonal(14.705, [-0.04, 0.91, -0.026], [0.04117, 0.07352, 0.04117]),
        spin_axis: [0.0, 1.0, 0.0],
        tie_rod: [[-0.25, 0.448, 0.054], [-0.176, 0.821, -0.016]],
        spring: [[0.104, 0.51, 0.197], [0.097, 0.543, -0.047]],
    };
    assert_figure(felt_by_the_spring(&corner)[0], 207.342164, 1e-6);
    // The inertia of the axle about its axis belongs to the spindle; it has no effect if the spindle is free to rotate.
    corner.spindle.about_com.m22 += 0.4;
    let [free, locked] = felt_by_the_spring(&corner);
    assert_figure(free, 207.342164, 1e-6);
    assert_figure(locked, 208.1525, 1e-4);
}

#[test]
fn suspension_of_the_sedan() {
    let corner = Corner {
        lower: arm(
            1.611,
            [0.0048, 0.6112, -0.2932],
            [0.0151, 0.0207, 0.0355],
            [[0.2, 0.42, -0.27], [-0.2, 0.47, -0.265]],
            [0.0, 0.77, -0.32],
        ),
        upper: arm(
            1.032,
            [-0.1083, 0.5972, 0.1063],
            [0.00591, 0.0019, 0.00769],
            [[-0.1, 0.47, 0.105], [-0.25, 0.51, 0.11]],
            [-0.04, 0.695, 0.105],
        ),
        upright: Inertial::diagonal(1.397, [-0.0224, 0.747, -0.1118], [0.0138, 0.0146, 0.00283]),
        spindle: Inertial::diagonal(1.103, [0.0, 0.7979, -0.1199], [0.000478, 0.000496, 0.000478]),
        spin_axis: [0.0, 1.0, 0.0],
        tie_rod: [[-0.2, 0.42, -0.12], [-0.15, 0.77, -0.12]],
        spring: [[-0.04, 0.52, 0.23], [0.0, 0.62, -0.27]],
    };
    assert_figure(felt_by_the_spring(&corner)[0], 12.5797194, 1e-7);
}

#[test]
fn two_freedoms_at_a_change_point() {
    // URDF+'s four_bar.urdf (generalized_rbda, MIT) with all joints at zero: stretched along x.
    let z = [0.0, 0.0, 1.0];
    let bar =
        |name| LinkDescription::new(name, Inertial::diagonal(3.3, [0.0; 3], [0.011253, 0.036203, 0.042673]));
    let hinge = |name, parent, child, x| {
        JointDescription::new(name, JointKind::Revolute, parent, child).at([x, 0.0, 0.0]).axis(z)
    };
    let links = vec![LinkDescription::massless("base_link"), bar("link1"), bar("link2"), bar("link3")];
    let joints = vec![
        hinge("joint1", "base_link", "link1", 0.0),
        hinge("joint2", "link1", "link2", 0.5),
        hinge("joint3", "base_link", "link3", 1.0),
    ];
    let loop1 = ClosureDescription::new("loop1", ClosureKind::Revolute, "link2", "link3")
        .at([1.0, 0.0, 0.0], [0.5, 0.0, 0.0])
        .axis(z);
    let four_bar = build_with_loops("four_bar", links, joints, vec![loop1], Vec::new());
    let on = four_bar.find_link("link2").unwrap();
    let ask = |positions: Vec<Vec<f64>>| {
        let normal = Vector3::y();
        solve(&Question::new(&four_bar, positions, on, Vector3::new(0.4, 0.0, 0.0), normal))
    };
    let at_crossing = ask(random::zero_positions(&four_bar));
    assert_eq!((at_crossing.degrees_of_freedom, at_crossing.redundant_constraints), (2, 4));
    assert_figure(at_crossing.outcome.finite().unwrap(), 1.134, 1e-3);
    // Near the change point on both branches, parallelogram and antiparallelogram.
    let tiny = 1e-4;
    let (psi, _) = percuss_oracle::closed_form::antiparallelogram(1.0, 0.5, tiny);
    let pin = f64::atan2(0.5 * (psi.sin() - tiny.sin()), 1.0 + 0.5 * (psi.cos() - tiny.cos()));
    for (positions, figure, unit) in [
        (vec![vec![tiny], vec![-tiny], vec![tiny]], 3.641, 1e-3),
        (vec![vec![tiny], vec![pin - tiny], vec![psi]], 15.80, 1e-2),
    ] {
        let on_branch = ask(positions);
        assert_eq!((on_branch.degrees_of_freedom, on_branch.redundant_constraints), (1, 3));
        assert_figure(on_branch.outcome.finite().unwrap(), figure, unit);
    }
}

/// Rounded reference linkage: crank 0.3, coupler 0.7, rocker 0.5, ground 0.8 m in the x-z plane; the arguments are the roll
/// angles of the two hinges on the ground.
fn reference_four_bar(rolls: [f64; 2]) -> (usize, f64) {
    let z = [0.0, 0.0, 1.0];
    let bar =
        |name, mass, x, moments| LinkDescription::new(name, Inertial::diagonal(mass, [x, 0.0, 0.0], moments));
    let hinge = |name, parent, child, x, roll| {
        let rotation = percuss_spatial::rotation_from_rpy([roll, 0.0, 0.0]);
        let origin = percuss_spatial::Transform::new(rotation, Vector3::new(x, 0.0, 0.0));
        JointDescription::new(name, JointKind::Continuous, parent, child).origin(origin).axis(z)
    };
    let links = vec![
        LinkDescription::massless("ground"),
        bar("crank", 2.0, 0.15, [0.002, 0.017, 0.018]),
        bar("coupler", 5.0, 0.35, [0.002, 0.206167, 0.207167]),
        bar("rocker", 3.0, 0.25, [0.002, 0.0645, 0.0655]),
    ];
    let joints = vec![
        hinge("crank_hinge", "ground", "crank", 0.0, rolls[0]),
        hinge("crank_pin", "crank", "coupler", 0.3, 0.0),
        hinge("rocker_hinge", "ground", "rocker", 0.8, rolls[1]),
    ];
    let closure = ClosureDescription::new("rocker_pin", ClosureKind::Revolute, "coupler", "rocker")
        .at([0.7, 0.0, 0.0], [0.5, 0.0, 0.0])
        .axis(z);
    let mechanism = build_with_loops("reference", links, joints, vec![closure], Vec::new());
    let free: Vec<_> = mechanism.joint_ids().skip(1).collect();
    let near = vec![vec![1.1], vec![-0.8], vec![1.578]];
    let (positions, _) = close_as_far_as_possible(&mechanism, &near, &free);
    let on = mechanism.find_link("coupler").unwrap();
    let normal = poses(&mechanism, &positions)[on.index()].fixed_view::<3, 1>(0, 1).into_owned();
    let answer = solve(&Question::new(&mechanism, positions, on, Vector3::new(0.35, 0.1, 0.0), normal));
    (answer.degrees_of_freedom, answer.outcome.finite().unwrap())
}

#[test]
fn the_rounded_reference_has_the_mass_of_its_ideal_twin() {
    let (degrees, ideal) = reference_four_bar([FRAC_PI_2; 2]);
    assert_figure(ideal, 21.093041, 1e-6);
    let (rounded_degrees, rounded) =
        reference_four_bar([1e4, 1e6].map(|unit| (FRAC_PI_2 * unit).round() / unit));
    assert_eq!((degrees, rounded_degrees), (1, 1));
    // Frame errors of 4e-6 rad cause a residual of the same size.
    assert!((rounded / ideal - 1.0).abs() < 1e-5, "{rounded} {ideal}");
}
