//! The travel of a point: its exact rate compared with differences of poses, on every linkage and on the shipped
//! suspension; its driving joint and its range.

use nalgebra::Vector3;
use percuss_dynamics::{AssemblyError, Base, Conditions, Configuration, Pose, System, Travel, TravelError};
use percuss_formats::{LoadOptions, Source, load};
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use percuss_oracle::{linkage, random};
use percuss_spatial::Transform;
use percuss_tests::differences::derivative_by;
use percuss_tests::gauge::Gauge;
use percuss_tests::rig::{Rig, in_plane};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::PI;
use std::sync::Arc;

/// Motion of the fastest joint (rad, or m) in the longer step of a difference. The error is step⁴/120 of a fifth
/// derivative, and the closing tolerance of 1e-12 over the step.
const STEP: f64 = 2e-3;
/// Error bound of the difference, in sizes per unit of the driver, for each unit of the fastest joint.
const NEAR: f64 = 2e-10;

fn size(mechanism: &Mechanism) -> f64 {
    mechanism.characteristic_length()
}

fn unit(mechanism: &Mechanism, joint: JointId) -> f64 {
    if mechanism.joint(joint).kind() == JointKind::Prismatic { size(mechanism) } else { 1.0 }
}

/// The rate by differences of poses, followed from a pose, and the speed of the fastest joint; `None` if a pose is
/// missing.
fn difference(travel: &Travel, pose: &Pose, base: &Configuration, joint: JointId) -> Option<(f64, f64)> {
    let mechanism = Arc::clone(pose.mechanism());
    let (name, value) = (mechanism.joint(joint).name(), pose.joint(joint)[0]);
    let there = |h: f64| {
        let mut there = base.clone();
        there.set(name, &[value + h]).expect("a driver");
        pose.assembly().pose_from(pose, &there).ok()
    };
    let first = STEP * 1e-3 * unit(&mechanism, joint);
    let moved = there(first)?
        .positions()
        .iter()
        .zip(pose.positions())
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    let fastest = 1.0 + moved / first;
    let mut missing = false;
    let rate = derivative_by(STEP / fastest, |h| match there(h) {
        Some(pose) => travel.displacement(&pose),
        None => {
            missing = true;
            0.0
        }
    });
    (!missing).then_some((rate, fastest))
}

/// Configuration with all drivers of the rig set except one.
fn others(rig: &Rig, values: &[f64], but: usize) -> Configuration {
    let mut configuration = rig.system.configuration();
    for (k, (name, value)) in rig.drivers.iter().zip(values).enumerate() {
        if k != but {
            configuration.set(name, &[*value]).expect("a driver");
        }
    }
    configuration
}

fn point(rng: &mut StdRng, mechanism: &Mechanism) -> (LinkId, Vector3<f64>, Vector3<f64>) {
    let (link, _, point, direction) = random::contact(rng, mechanism);
    (link, point, direction)
}

/// Every driver of every linkage, with the other drivers set, at poses over the whole range: fixed base, floating base,
/// with a lock.
#[test]
fn rates_are_those_of_poses() {
    let mut gauge = Gauge::new("rates of travels against differences, sizes a unit");
    let (mut compared, mut moving) = (0, 0);
    let all = linkage::all().into_iter().chain(linkage::all()).chain(linkage::all());
    for (number, linkage) in all.enumerate() {
        // Locks constrain velocities, not poses; a floating base is the reference frame.
        let conditions = match number / linkage::all().len() {
            0 => Conditions::new(),
            1 => Conditions::new().base(Base::Floating),
            _ => Conditions::new().lock(linkage.drivers[0].clone()),
        };
        let rig = Rig::under(linkage, &conditions);
        let mut rng = StdRng::seed_from_u64(300 + number as u64);
        let mut pose = rig.closed();
        for i in 0..8 {
            let values = rig.at((f64::from(i) + 0.5) / 8.0);
            pose = rig.reach(&pose, &values);
            for (k, name) in rig.drivers.iter().enumerate() {
                let joint = rig.joint(name);
                let (link, point, direction) = point(&mut rng, &rig.mechanism);
                let travel = Travel::new(&pose, link, point, direction).expect("a travel");
                let case = format!("{} at {values:.3?}, {name}", rig.name);
                assert_eq!(travel.displacement(&pose), 0.0, "{case}");
                let base = others(&rig, &values, k);
                let rate = travel.rate(&pose, joint).unwrap_or_else(|| panic!("{case}: no rate"));
                let Some((wanted, fastest)) = difference(&travel, &pose, &base, joint) else { continue };
                let scale = unit(&rig.mechanism, joint) / size(&rig.mechanism);
                gauge.note(&case, (rate - wanted).abs() * scale / fastest, NEAR);
                compared += 1;
                moving += usize::from((rate * scale).abs() > 1e-3);
            }
        }
    }
    gauge.report();
    assert!(compared > 900 && moving > 500, "{compared} {moving}");
}

/// Dependent joints become drivers if set, unless the file declares other drivers.
#[test]
fn dependent_joints_drive_instead_of_others() {
    let mut gauge = Gauge::new("rates of joints that depend, against differences, sizes a unit");
    let mut compared = 0;
    for (number, linkage) in linkage::all().into_iter().enumerate() {
        let rig = Rig::new(linkage);
        let mut rng = StdRng::seed_from_u64(400 + number as u64);
        let regular = rig.reach(&rig.closed(), &rig.at(0.4));
        // Unset drivers move to zero: only mechanisms with a single driver keep their pose.
        if rig.system.degrees_of_freedom() > 1 || rig.mechanism.links().len() > 20 {
            continue;
        }
        let (link, point, direction) = point(&mut rng, &rig.mechanism);
        let travel = Travel::new(&regular, link, point, direction).expect("a travel");
        for joint in rig.mechanism.joint_ids() {
            let case = format!("{}, {}", rig.name, rig.mechanism.joint(joint).name());
            let Some(rate) = travel.rate(&regular, joint) else { continue };
            let wanted = difference(&travel, &regular, &rig.system.configuration(), joint);
            let Some((wanted, fastest)) = wanted else { continue };
            let scale = unit(&rig.mechanism, joint) / size(&rig.mechanism);
            gauge.note(&case, (rate - wanted).abs() * scale / fastest, NEAR);
            compared += 1;
        }
    }
    gauge.report();
    assert!(compared > 20, "{compared}");
}

/// The requested displacement is reached by the chosen driver, from poses over the whole range.
#[test]
fn displacements_of_every_linkage_are_met() {
    let mut gauge = Gauge::new("displacements met, parts of the size");
    let (mut reached, mut ended) = (0, 0);
    for (number, linkage) in linkage::all().into_iter().enumerate() {
        let rig = Rig::new(linkage);
        let mut rng = StdRng::seed_from_u64(500 + number as u64);
        let values = rig.at(0.4);
        let pose = rig.reach(&rig.closed(), &values);
        for k in 0..6 {
            let (link, point, direction) = point(&mut rng, &rig.mechanism);
            let travel = Travel::new(&pose, link, point, direction).expect("a travel");
            let free = rig.joint(&rig.drivers[k % rig.drivers.len()]);
            let is_set = |id: JointId| {
                id != free && rig.drivers.iter().any(|name| name == rig.mechanism.joint(id).name())
            };
            let driver = match travel.driver(&pose, &is_set) {
                Ok(driver) => driver,
                Err(TravelError::NothingMoves { .. }) => continue,
                Err(error) => panic!("{}: {error}", rig.name),
            };
            let base = others(&rig, &values, k % rig.drivers.len());
            let wanted = rng.random_range(-0.05..0.05) * size(&rig.mechanism);
            let case = format!("{}, {} by {wanted:.3}", rig.name, rig.mechanism.joint(driver).name());
            match travel.pose(&pose, &base, driver, wanted) {
                Ok(there) => {
                    let miss = (travel.displacement(&there) - wanted).abs() / size(&rig.mechanism);
                    gauge.note(&case, miss, 2e-12);
                    assert!(rig.open(&there) < 2e-12, "{case}");
                    reached += 1;
                }
                Err(TravelError::Unreachable { nearest, .. }) => {
                    assert!(nearest.abs() < wanted.abs(), "{case}: {nearest}");
                    ended += 1;
                }
                Err(error) => panic!("{case}: {error}"),
            }
        }
    }
    gauge.report();
    assert!(reached > 60, "{reached} {ended}");
}

fn shipped(name: &str) -> System {
    let path = format!("{}/../models/{name}", env!("CARGO_MANIFEST_DIR"));
    let source = Source::read(&path, 1 << 20).expect("a file");
    let loaded = load(&source, &LoadOptions::default()).expect("a model");
    System::new(loaded.mechanism, &Conditions::new()).expect("a system")
}

fn link(system: &System, name: &str) -> LinkId {
    system.mechanism().find_link(name).expect("a link")
}

fn joint(system: &System, name: &str) -> JointId {
    system.mechanism().find_joint(name).expect("a joint")
}

#[test]
fn the_wishbone_travels_to_its_ends() {
    let system = shipped("double_wishbone.urdf");
    let base = system.configuration();
    let start = system.pose(&base).expect("closed");
    let wheel = link(&system, "wheel_centre");
    let travel = Travel::new(&start, wheel, Vector3::zeros(), Vector3::z() * 3.0).expect("a travel");
    let driver = travel.driver(&start, &|_| false).expect("a driver");
    assert_eq!(driver, joint(&system, "lower_arm_hinge"));
    assert_eq!(travel.direction(), Some(&Vector3::z()));
    let (size, mut last) = (size(system.mechanism()), start.clone());
    let mut gauge = Gauge::new("rates of the wheel's travel against differences, sizes a radian");
    for row in 0..=40 {
        let wanted = -0.08 + 0.004 * f64::from(row);
        last = travel.pose(&last, &base, driver, wanted).expect("in reach");
        assert!((travel.displacement(&last) - wanted).abs() < 1e-14 * size.max(1.0), "row {row}");
        let rate = travel.rate(&last, driver).expect("a rate");
        let (other, _) = difference(&travel, &last, &base, driver).expect("poses beside");
        gauge.note(&format!("row {row}"), (rate - other).abs() / size, 1e-11);
    }
    gauge.report();
    // The wheel's centre is lowest at a zero of its rate, before the arm reaches its own limit; from near and from far.
    let ends = [&start, &last].map(|from| {
        let Err(TravelError::Unreachable { requested, nearest }) = travel.pose(from, &base, driver, -0.2)
        else {
            panic!("beyond the end")
        };
        assert_eq!(requested, -0.2);
        nearest
    });
    assert!((ends[0] - ends[1]).abs() < 1e-11 && (ends[0] + 0.1834).abs() < 1e-4, "{ends:?}");
    let lowest = travel.pose(&start, &base, driver, ends[0]).expect("the end itself");
    assert!(travel.rate(&lowest, driver).expect("a rate").abs() < 1e-5);
    // Back to the start, on the original side.
    let back = travel.pose(&lowest, &base, driver, 0.0).expect("in reach");
    assert!((back.joint(driver)[0] - start.joint(driver)[0]).abs() < 1e-12);
}

/// At a crossing of branches no rate exists, and a small step determines the driver.
#[test]
fn a_change_point_is_left_by_a_step() {
    for linkage in [linkage::parallelogram(), linkage::antiparallelogram()] {
        let rig = Rig::new(linkage);
        let (crank, length) = (rig.joint(&rig.drivers[0]), linkage::PARALLELOGRAM.crank);
        let start = rig.reach(&rig.closed(), &[PI]);
        let coupler = rig.mechanism.find_link("coupler").expect("a link");
        let across = in_plane([0.0, 1.0].into());
        let travel = Travel::new(&start, coupler, Vector3::zeros(), across).expect("a travel");
        assert!(start.rank().singular && travel.rate(&start, crank).is_none(), "{}", rig.name);
        let driver = travel.driver(&start, &|_| false);
        assert!(driver.is_ok(), "{}: {driver:?}", rig.name);
        // The displacement of the pin is proportional to the sine of the crank angle.
        for part in [-0.5, -1e-3, 1e-3, 0.0, 0.5] {
            let wanted = part * length;
            let pose = travel.pose(&start, &rig.system.configuration(), crank, wanted).expect("in reach");
            let angle = pose.joint(crank)[0];
            assert!((length * angle.sin() - wanted).abs() < 1e-12, "{}: {wanted} {angle}", rig.name);
            assert!(rig.open(&pose) < 1e-12);
        }
    }
}

#[test]
fn a_travel_beyond_its_end_reports_the_nearest() {
    let system = shipped("four_bar.urdf");
    let start = system.pose(&system.configuration()).expect("closed");
    let travel =
        Travel::new(&start, link(&system, "coupler"), Vector3::zeros(), Vector3::x()).expect("a travel");
    let crank = joint(&system, "crank_hinge");
    assert_eq!(travel.driver(&start, &|_| false), Ok(crank));
    // The displacement of the pin is −0.3 sin θ.
    for wanted in [-0.29999, -0.1, 0.1, 0.29999, 0.0] {
        let pose = travel.pose(&start, &system.configuration(), crank, wanted).expect("in reach");
        assert!((-0.3 * pose.joint(crank)[0].sin() - wanted).abs() < 1e-13, "{wanted}");
    }
    let error = travel.pose(&start, &system.configuration(), crank, 0.4).expect_err("beyond");
    assert_eq!(error.to_string(), "a travel of 0.4 m cannot be reached; nearest reached: 0.300000 m");
    // Joints declared as drivers in the file remain the drivers.
    let depends = joint(&system, "rocker_hinge");
    assert_eq!(travel.rate(&start, depends), None);
    let refused = travel.pose(&start, &system.configuration(), depends, 0.1);
    assert!(matches!(refused, Err(TravelError::Assembly(AssemblyError::Dependent { .. }))), "{refused:?}");
}

/// Two arms, the second a mimic of the first, on a slide.
fn with_mimic(base: Base) -> System {
    let body = "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
    let text = format!(
        "<robot name=\"r\"><link name=\"g\">{body}</link><link name=\"s\">{body}</link><link name=\"a\">{body}</link>\
         <link name=\"b\">{body}</link>\
         <joint name=\"slide\" type=\"prismatic\"><parent link=\"g\"/><child link=\"s\"/><axis xyz=\"1 0 0\"/>\
         <limit lower=\"-9\" upper=\"9\" effort=\"1\" velocity=\"1\"/></joint>\
         <joint name=\"p\" type=\"continuous\"><parent link=\"s\"/><child link=\"a\"/><axis xyz=\"0 0 1\"/></joint>\
         <joint name=\"q\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/><origin xyz=\"2 0 0\"/>\
         <axis xyz=\"0 0 1\"/><mimic joint=\"p\" multiplier=\"-2\" offset=\"0.3\"/></joint></robot>"
    );
    let source = Source::new("r.urdf", text.into_bytes());
    let loaded = load(&source, &LoadOptions::default()).expect("a model");
    System::new(loaded.mechanism, &Conditions::new().base(base)).expect("a system")
}

/// x = d + 2 cos p + cos(0.3 − p), for any pose of the root and for a fixed or floating base.
#[test]
fn mimics_and_floating_bases() {
    for base in [Base::Fixed, Base::Floating] {
        let system = with_mimic(base);
        let turn = percuss_spatial::rotation_about(&Vector3::new(0.36, 0.48, 0.8), 0.7);
        let far = Transform::new(turn, Vector3::new(1e4, -2e4, 3e3));
        let mut configuration = system.configuration();
        configuration.set_base(far);
        let mut start = configuration.clone();
        start.set("p", &[0.5]).expect("a driver");
        let start = system.pose(&start).expect("a tree");
        let (x, y) = (turn * Vector3::x(), turn * Vector3::y());
        let tip = link(&system, "b");
        let (slide, p, q) = (joint(&system, "slide"), joint(&system, "p"), joint(&system, "q"));
        let at = Vector3::new(1.0, 0.0, 0.0);
        let along = Travel::new(&start, tip, at, x).expect("a travel");
        let across = Travel::new(&start, tip, at, y).expect("a travel");
        let gone = |p: f64| 2.0 * p.cos() + (0.3 - p).cos();
        let rate = |p: f64| -2.0 * p.sin() + (0.3 - p).sin();
        assert!((along.rate(&start, p).expect("a rate") - rate(0.5)).abs() < 1e-14);
        assert!((along.rate(&start, slide).expect("a rate") - 1.0).abs() < 1e-15);
        assert_eq!(along.rate(&start, q), None, "a mimic does not drive");
        assert!(across.rate(&start, slide).expect("a rate").abs() < 1e-15);
        // A slide displacement of the mechanism's size exceeds a radian of the arm; across the slide, only the arm
        // moves the tip.
        let most = if size(system.mechanism()) > rate(0.5).abs() { slide } else { p };
        assert_eq!(along.driver(&start, &|_| false), Ok(most));
        assert_eq!(along.driver(&start, &|id| id == slide), Ok(p));
        assert_eq!(across.driver(&start, &|_| false), Ok(p));
        assert!(matches!(
            across.driver(&start, &|id| id == p),
            Err(TravelError::NothingMoves { link }) if link == "b"
        ));
        let there = along.pose(&start, &configuration, p, -0.4).expect("in reach");
        let value = there.joint(p)[0];
        assert!((gone(value) - gone(0.5) + 0.4).abs() < 1e-13);
        assert!((there.joint(q)[0] - 0.3 + 2.0 * value).abs() < 1e-15);
        let there = along.pose(&start, &configuration, slide, 0.7);
        // The arm is not set and goes to 0: 0.7 m in total.
        let there = there.expect("in reach");
        assert!((there.joint(slide)[0] + gone(0.0) - gone(0.5) - 0.7).abs() < 1e-14);
    }
}

/// A hanging pendulum is at the end of its tip's upward travel: no joint moves the tip to first order.
#[test]
fn a_travel_may_start_at_its_end() {
    let system = shipped("physical_pendulum.urdf");
    let start = system.pose(&system.configuration()).expect("a tree");
    let (body, hinge) = (link(&system, "body"), joint(&system, "hinge"));
    let arm = 0.5;
    let travel = Travel::new(&start, body, Vector3::new(0.0, 0.0, -arm), Vector3::z()).expect("a travel");
    assert!(travel.rate(&start, hinge).expect("a rate").abs() < 1e-15);
    assert_eq!(travel.driver(&start, &|_| false), Ok(hinge));
    let pose = travel.pose(&start, &system.configuration(), hinge, 0.2).expect("in reach");
    assert!((arm * (1.0 - pose.joint(hinge)[0].cos()) - 0.2).abs() < 1e-14);
    let below = travel.pose(&start, &system.configuration(), hinge, -0.1);
    let Err(TravelError::Unreachable { nearest, .. }) = below else { panic!("{below:?}") };
    assert!(nearest.abs() < 1e-12, "{nearest}");
}

#[test]
fn invalid_travels_are_refused() {
    let system = shipped("four_bar.urdf");
    let other = shipped("double_wishbone.urdf");
    let start = system.pose(&system.configuration()).expect("closed");
    let coupler = link(&system, "coupler");
    let refused = |link, point, direction| Travel::new(&start, link, point, direction).expect_err("refused");
    let (zero, x) = (Vector3::zeros(), Vector3::x());
    assert_eq!(refused(coupler, zero, zero), TravelError::NoDirection { length: 0.0 });
    assert!(matches!(refused(coupler, x * f64::NAN, x), TravelError::NotFinite { what: "point", .. }));
    assert!(matches!(refused(coupler, x, x / 0.0), TravelError::NotFinite { what: "direction", .. }));
    let foreign = link(&other, "wheel_centre");
    assert!(matches!(refused(foreign, zero, x), TravelError::ForeignLink { .. }));
    let travel = Travel::new(&start, coupler, zero, x).expect("a travel");
    let crank = joint(&system, "crank_hinge");
    let foreign = travel.pose(&start, &other.configuration(), crank, 0.1);
    assert!(matches!(foreign, Err(TravelError::Assembly(AssemblyError::ForeignConfiguration { .. }))));
    let nowhere = travel.pose(&start, &system.configuration(), crank, f64::NAN);
    assert!(matches!(nowhere, Err(TravelError::NotFinite { what: "displacement", .. })));
    let ball = Travel::new(
        &other.pose(&other.configuration()).expect("closed"),
        link(&other, "wheel_centre"),
        zero,
        x,
    );
    let ball = ball.expect("a travel").pose(
        &other.pose(&other.configuration()).expect("closed"),
        &other.configuration(),
        joint(&other, "lower_ball"),
        0.1,
    );
    assert!(matches!(ball, Err(TravelError::NoDriver { joint }) if joint == "lower_ball"));
}
