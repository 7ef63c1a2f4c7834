//! Planar linkages compared with their closed forms: over full turns, through crossings of branches, to their limits.

use nalgebra::Vector2;
use percuss_dynamics::{AssemblyError, EffectiveMass, Pose, Singularity};
use percuss_oracle::closed_form::{
    Crossing, FourBar, PlanarBody, PlanarPose, SliderCrank, antiparallelogram, planar_effective_mass,
};
use percuss_oracle::linkage::{self, Linkage};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::states_enough;
use percuss_tests::rig::{Rig, in_plane, mass};
use std::f64::consts::{PI, TAU};

/// Relative rounding error of closed forms: some differences of squares and a root.
const FORM: f64 = 1e-14;

const BODIES: [PlanarBody; 3] = linkage::FOUR_BAR_BODIES;

/// Contact points of the three bodies, with directions.
fn contacts() -> impl Iterator<Item = (usize, Vector2<f64>, Vector2<f64>)> {
    [(0, [0.2, 0.07]), (1, [0.31, -0.12]), (2, [0.24, 0.1])].into_iter().flat_map(|(body, point)| {
        (0..3).map(move |k| {
            let (sin, cos) = (0.3 + f64::from(k) * TAU / 7.0).sin_cos();
            (body, Vector2::from(point), Vector2::new(cos, sin))
        })
    })
}

/// Compares m̄ of every body of a planar linkage at a pose with the bodies' motions.
fn compare_contacts(
    rig: &Rig,
    pose: &Pose,
    bodies: [PlanarBody; 3],
    motions: [PlanarPose; 3],
    (bound, own): (f64, f64),
    gauge: &mut Gauge,
) {
    let all: Vec<_> = bodies.into_iter().zip(motions).collect();
    for (body, point, n) in contacts() {
        // Digits are lost if the point hardly moves along the normal.
        if n.dot(&motions[body].velocity_of(point)).abs() < 0.02 {
            continue;
        }
        let link = rig.mechanism.links()[body + 1].name();
        let response = rig.respond(pose, &rig.contact(link, [point.x, point.y, 0.03], in_plane(n)));
        let case = format!(
            "{} {link} at {:?}",
            rig.name,
            rig.drivers.iter().map(|d| pose.joint(rig.joint(d))).collect::<Vec<_>>()
        );
        let expected = planar_effective_mass(&all, body, point, n);
        gauge.relative(&case, mass(&response), expected, bound);
        assert!(states_enough(&response, expected, own), "{case}: {response:?}, expected {expected} kg");
        assert_eq!((response.degrees_of_freedom, response.singular_pose), (1, false), "{case}");
    }
}

#[test]
fn full_turns() {
    let mut gauge = Gauge::new("full turns against closed forms");
    let mut turn = |linkage: Linkage, bodies, motions: &dyn Fn(f64) -> [PlanarPose; 3]| {
        let rig = Rig::new(linkage);
        assert_eq!(
            (rig.system.degrees_of_freedom(), rig.system.reference_or_open().redundant_constraints()),
            (1, 3)
        );
        let mut pose = rig.closed();
        for i in 0..=360 {
            let theta = f64::from(i) * TAU / 360.0;
            pose = rig.reach(&pose, &[theta]);
            compare_contacts(&rig, &pose, bodies, motions(theta), (1e-12, FORM), &mut gauge);
        }
    };
    let bar = linkage::FOUR_BAR;
    turn(linkage::four_bar(), BODIES, &|t| bar.poses(t, Crossing::Left).unwrap());
    let crossed = linkage::four_bar_of("crossed", bar, BODIES, Crossing::Right, 0.7, [-PI, PI]);
    turn(crossed, BODIES, &|t| bar.poses(t, Crossing::Right).unwrap());
    let engine = linkage::SLIDER_CRANK;
    turn(linkage::slider_crank(), linkage::SLIDER_CRANK_BODIES, &|t| engine.poses(t).unwrap());
    gauge.report();
}

/// Angles and rates of the coupler and the rocker of a parallelogram, open or crossed, for any angle.
fn motions(bar: FourBar, open: bool, theta: f64) -> [PlanarPose; 3] {
    let wrapped = (theta + PI).rem_euclid(TAU) - PI;
    let (psi, rate) = if open { (theta, 1.0) } else { antiparallelogram(bar.ground, bar.crank, wrapped) };
    let along = |angle: f64| Vector2::new(angle.cos(), angle.sin());
    let across = |angle: f64| Vector2::new(-angle.sin(), angle.cos());
    let (pin, end) = (bar.crank * along(theta), Vector2::new(bar.ground, 0.0) + bar.rocker * along(psi));
    let coupler = end - pin;
    let turn = bar.rocker * rate * across(psi) - bar.crank * across(theta);
    let phi_rate = coupler.perp(&turn) / coupler.norm_squared();
    let still = Vector2::zeros();
    [
        PlanarPose { origin: Vector2::zeros(), angle: theta, velocity: still, rate: 1.0 },
        PlanarPose {
            origin: pin,
            angle: coupler.y.atan2(coupler.x),
            velocity: bar.crank * across(theta),
            rate: phi_rate,
        },
        PlanarPose { origin: Vector2::new(bar.ground, 0.0), angle: psi, velocity: still, rate },
    ]
}

fn wrapped(angle: f64) -> f64 {
    angle.sin().atan2(angle.cos())
}

/// Two turns forward and two back, with a number of rows per turn, starting at `first`.
fn two_turns(linkage: Linkage, open: bool, first: f64, rows: i32) -> (Gauge, Gauge, usize) {
    let bar = linkage::PARALLELOGRAM;
    let rig = Rig::new(linkage);
    let mut angles = Gauge::new("angles through crossings");
    let mut masses = Gauge::new("masses through crossings");
    let mut crossings = 0;
    let mut pose = rig.closed();
    let there = 0..=2 * rows;
    for i in there.clone().chain(there.rev()) {
        let theta = first + f64::from(i) * TAU / f64::from(rows);
        pose = rig.reach(&pose, &[theta]);
        let motions = motions(bar, open, theta);
        let case = format!("{} at {theta}", rig.name);
        let rocker = pose.joint(rig.joint("rocker_hinge"))[0];
        let pin = pose.joint(rig.joint("crank_pin"))[0];
        angles.note(&case, wrapped(rocker - motions[2].angle).abs(), 1e-12);
        angles.note(&case, wrapped(pin - (motions[1].angle - theta)).abs(), 1e-12);
        assert!(rig.open(&pose) <= 1e-12, "{case}: {}", rig.open(&pose));
        let near = theta.sin().abs();
        let state = pose.loops().expect("loops");
        if near > 1e-9 {
            // A residual of ε displaces the pose from the branch by ε over the distance, and changes its motion by that
            // over the distance.
            let bound = (1e-12 + 10.0 * FORM / (near * near)).min(1e-2);
            compare_contacts(&rig, &pose, BODIES, motions, (bound, FORM / near), &mut masses);
            assert_eq!(state.singularities, [Singularity::None], "{case}");
        } else {
            crossings += 1;
            assert_eq!(
                (state.singularities.as_slice(), state.modes[0]),
                ([Singularity::ChangePoint].as_slice(), 0)
            );
            limits(&rig, &pose, motions, &mut masses);
        }
    }
    (angles, masses, crossings)
}

/// At a crossing, (D) is a lower bound, and one of the branch limits belongs to this branch.
fn limits(rig: &Rig, pose: &Pose, motions: [PlanarPose; 3], gauge: &mut Gauge) {
    let (_, point, n) = contacts().nth(4).expect("a contact");
    let contact = rig.contact("coupler", [point.x, point.y, 0.0], in_plane(n));
    let response = rig.respond(pose, &contact);
    assert!(response.singular_pose && response.degrees_of_freedom == 2);
    let expected = planar_effective_mass(&BODIES.into_iter().zip(motions).collect::<Vec<_>>(), 1, point, n);
    assert!(mass(&response) < expected);
    let limits = pose.branch_limits(&contact).limits;
    let error = |limit: &EffectiveMass| match limit {
        EffectiveMass::Finite(m) => (m / expected - 1.0).abs(),
        EffectiveMass::Immovable | EffectiveMass::Massless => f64::INFINITY,
    };
    let nearest = limits.iter().map(error).fold(f64::INFINITY, f64::min);
    assert_eq!(limits.len(), 2, "{limits:?}");
    gauge.note(&format!("{} limit", rig.name), nearest, 1e-9);
}

#[test]
fn no_branch_is_lost_at_a_crossing() {
    for (linkage, open) in [
        (linkage::parallelogram as fn() -> Linkage, true),
        (linkage::antiparallelogram as fn() -> Linkage, false),
    ] {
        // Rows on the crossings, and near them at many distances.
        let mut crossings = 0;
        for (first, rows) in [(0.0, 24), (-PI, 60), (0.017, 36), (1e-3, 24), (-1e-6, 12), (1e-8, 8), (0.4, 3)]
        {
            let (angles, masses, crossings_met) = two_turns(linkage(), open, first, rows);
            angles.report();
            masses.report();
            crossings += crossings_met;
        }
        assert!(crossings >= 20, "{crossings}");
    }
}

/// Whole turns in one call, with ends near crossings and far from them: the steps are unrestricted.
#[test]
fn long_travels_keep_their_branch() {
    let mut gauge = Gauge::new("angles after long ways");
    for (linkage, open) in [(linkage::parallelogram(), true), (linkage::antiparallelogram(), false)] {
        let rig = Rig::new(linkage);
        let start = rig.closed();
        for i in 0..150 {
            // Some rows pass a crossing at arbitrary distances from their last step.
            let theta = (f64::from(i) * 0.618_033_988_75).fract() * 40.0 - 20.0;
            let theta = if i % 10 == 0 { (theta / PI).round() * PI + 1e-4 } else { theta };
            let from = rig.reach(&start, &[1.2 + f64::from(i) * 1e-3]);
            let pose = rig.reach(&from, &[theta]);
            let rocker = pose.joint(rig.joint("rocker_hinge"))[0];
            let expected = motions(linkage::PARALLELOGRAM, open, theta)[2].angle;
            gauge.note(&format!("{} to {theta}", rig.name), wrapped(rocker - expected).abs(), 1e-11);
        }
    }
    gauge.report();
}

/// The limit in an error: first the driver, then the dependent joints.
fn nearest(error: AssemblyError) -> Vec<(String, f64)> {
    match error {
        AssemblyError::Unreachable { nearest, .. } => nearest,
        other => panic!("{other}"),
    }
}

fn value(places: &[(String, f64)], joint: &str) -> f64 {
    places.iter().find(|(name, _)| name == joint).unwrap_or_else(|| panic!("{joint} of {places:?}")).1
}

#[test]
fn limits_are_found() {
    let mut gauge = Gauge::new("limits");
    // Coupler and rocker aligned: cos θ = (a² + g² − (b + c)²) / 2ag; in both directions, from near and far.
    let bar = FourBar { ground: 0.8, crank: 0.6, coupler: 0.5, rocker: 0.4 };
    let reach = bar.coupler + bar.rocker;
    let limit =
        ((bar.crank.powi(2) + bar.ground.powi(2) - reach * reach) / (2.0 * bar.crank * bar.ground)).acos();
    let [a, g] = [bar.crank, bar.ground];
    for (start, wanted) in
        [(0.7, 1.5), (0.7, 3.0), (-0.7, -2.0), (limit - 1e-3, limit + 1e-9), (0.9, limit + 1e-6)]
    {
        for crossing in [Crossing::Left, Crossing::Right] {
            let rig =
                Rig::new(linkage::four_bar_of("triple rocker", bar, BODIES, crossing, start, [-1.3, 1.3]));
            let places = nearest(rig.move_drivers(&rig.closed(), &[wanted]).unwrap_err());
            let limit = limit.copysign(wanted);
            let phi = (-a * limit.sin()).atan2(g - a * limit.cos());
            let case = format!("triple rocker from {start} to {wanted}");
            gauge.note(&case, (places[0].1 - limit).abs(), 1e-12);
            gauge.note(&case, wrapped(value(&places, "crank_pin") - (phi - limit)).abs(), 1e-10);
            gauge.note(&case, wrapped(value(&places, "rocker_hinge") - phi - PI).abs(), 1e-10);
            // At the limit the pose is a dead centre: the driver is blocked, the mechanism is movable.
            let mut there = rig.system.configuration();
            there.set("crank_hinge", &[places[0].1]).unwrap();
            for (name, at) in &places[1..] {
                there.guess(name, &[*at]).unwrap();
            }
            let pose = rig.system.pose(&there).unwrap();
            let state = pose.loops().expect("loops");
            assert_eq!((state.singularities[0], state.modes[0]), (Singularity::DeadCentre, 0), "{case}");
            assert_eq!(pose.degrees_of_freedom(), 1);
            assert!(!pose.rank().singular && pose.rank().clear);
            // Just before the limit, the branch is still correct.
            for before in [1e-3, 1e-6, 1e-9, 1e-12] {
                let theta = limit - before * limit.signum();
                let pose = rig.reach(&rig.closed(), &[theta]);
                let [_, coupler, rocker] = bar.poses(theta, crossing).expect("in reach");
                // The driver's angle has an error of ε. The dependent angles vary as the square root of the distance to
                // the limit, so their error is ε over this root.
                let bound = 1e-10f64.max(4e-15 / before.sqrt());
                gauge.note(
                    &case,
                    wrapped(pose.joint(rig.joint("rocker_hinge"))[0] - rocker.angle).abs(),
                    bound,
                );
                gauge.note(
                    &case,
                    wrapped(pose.joint(rig.joint("crank_pin"))[0] + theta - coupler.angle).abs(),
                    bound,
                );
            }
        }
    }
    // A slider-crank driven by its slider: stretched, √((r + l)² − e²), and folded.
    let engine = SliderCrank { crank: 0.3, rod: 1.1, offset: 0.12 };
    for (wanted, sum) in [(2.0, engine.rod + engine.crank), (-0.3, engine.rod - engine.crank)] {
        let rig = Rig::new(linkage::slider_crank_of("pushed", engine, linkage::SLIDER_CRANK_BODIES));
        let start = rig.closed();
        let mut configuration = rig.system.configuration();
        configuration.set("guide", &[wanted]).unwrap();
        let places = nearest(rig.system.pose_from(&start, &configuration).unwrap_err());
        let limit = (sum * sum - engine.offset * engine.offset).sqrt();
        let line = engine.offset.atan2(limit);
        let crank = if wanted > 0.0 { line } else { line + PI };
        gauge.note("slider", (places[0].1 - limit).abs(), 1e-12);
        gauge.note("slider's crank", wrapped(value(&places, "crank_hinge") - crank).abs(), 1e-10);
    }
    gauge.report();
}
