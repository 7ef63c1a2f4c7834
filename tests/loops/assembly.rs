//! Assembly of loops: rough guesses, hundreds of loops, rounded files, contradictory loops, and joints that may be set.

use percuss_dynamics::{AssemblyError, Conditions, Contact, ContactResponse, EffectiveMass, Pose, System};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};
use percuss_oracle::linkage::{self, Linkage};
use percuss_oracle::maximal;
use percuss_spatial::{Transform, Vector3, rotation_from_rpy};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::states_enough;
use percuss_tests::motion::Motion;
use percuss_tests::rig::{Rig, mass, question};
use rand::{Rng, SeedableRng, rngs::StdRng};

#[test]
fn guesses_a_third_of_a_radian_off() {
    let (mut closed, mut same) = (0, 0);
    for linkage in linkage::all() {
        let mut rng = StdRng::seed_from_u64(9);
        let rig = Rig::new(linkage);
        let right = rig.closed();
        for _ in 0..8 {
            let mut off = rig.start.clone();
            for (joint, q) in rig.mechanism.joints().iter().zip(&mut off) {
                match joint.kind() {
                    JointKind::Revolute | JointKind::Continuous => q[0] += rng.random_range(-0.3..0.3),
                    JointKind::Prismatic => q[0] += rng.random_range(-0.05..0.05),
                    JointKind::Spherical => {
                        q.iter_mut().for_each(|x| *x += rng.random_range(-0.12..0.12));
                        let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
                        q.iter_mut().for_each(|x| *x /= norm);
                    }
                    JointKind::Fixed | JointKind::Planar | JointKind::Floating => {}
                }
            }
            let pose = rig.system.pose(&rig.guessed(&rig.start_drivers(), &off));
            let pose = pose.unwrap_or_else(|error| panic!("{}: {error}", rig.name));
            assert!(rig.open(&pose) < 1e-12, "{}", rig.name);
            closed += 1;
            let far = pose.positions().iter().zip(right.positions()).map(|(a, b)| (a - b).abs());
            same += usize::from(far.fold(0.0, f64::max) < 1e-9);
        }
    }
    println!("{closed} closed, {same} in the same assembly");
    assert!(closed == 168 && same > 120, "{closed} {same}");
}

/// Prints the name of a task before its start: large linkages take some seconds without optimisation.
fn doing<T>(what: &str, run: impl FnOnce() -> T) -> T {
    println!("{what}");
    run()
}

#[test]
fn hundreds_of_loops() {
    for (linkage, degrees, redundant) in [(linkage::separate(200), 200, 600), (linkage::ladder(200), 1, 600)]
    {
        let rig = Rig::new(linkage);
        let pose = doing(&format!("{} from zero", rig.name), || {
            rig.system.pose(&rig.system.configuration()).unwrap()
        });
        assert!(rig.open(&pose) < 1e-12);
        assert_eq!(
            (rig.system.degrees_of_freedom(), rig.system.reference_or_open().redundant_constraints()),
            (degrees, redundant)
        );
        let mut off = rig.start.clone();
        let mut rng = StdRng::seed_from_u64(31);
        off.iter_mut().flatten().for_each(|q| *q += rng.random_range(-0.3..0.3));
        let pose = doing(&format!("{} from a guess", rig.name), || {
            rig.system.pose(&rig.guessed(&rig.start_drivers(), &off)).unwrap()
        });
        assert!(rig.open(&pose) < 1e-12);
        let pose = doing(&format!("{} at its start", rig.name), || rig.closed());
        let pose = doing(&format!("{} along its branch", rig.name), || rig.reach(&pose, &rig.at(0.4)));
        assert!(rig.open(&pose) < 1e-12);
        if degrees == 1 {
            let theta = rig.at(0.4)[0];
            let n = linkage::plane().vector(&Vector3::new(-theta.sin(), theta.cos(), 0.0));
            let contact = rig.contact("link_0", [0.2, 0.0, 0.0], n);
            let response = doing("its response", || rig.respond(&pose, &contact));
            let expected = (201.0 * 0.07 + 0.16 * 200.0 * 0.8) / 0.04;
            assert!((mass(&response) / expected - 1.0).abs() < 1e-10, "{}", mass(&response) / expected - 1.0);
            let (m, error) = by_kernel(&pose, &contact).expect("an answer");
            assert!((m - expected).abs() <= error, "{m} for {expected}, error {error:e}");
        }
    }
}

/// m̄ and its error by the compiled kernel, kg.
fn by_kernel(pose: &Pose, contact: &Contact) -> Option<(f64, f64)> {
    let answer = pose.assembly().batch(contact).unwrap().effective_mass(pose.positions()).unwrap();
    match (answer.mass, answer.error) {
        (Some(EffectiveMass::Finite(m)), Some(error)) => Some((m, error)),
        _ => None,
    }
}

/// Of more than 64 coordinates only the refined bound of the kernel holds.
#[test]
fn ladders_of_all_sizes_are_answered_by_the_kernel() {
    let (mut answered, mut all) = (0, 0);
    let mut rng = StdRng::seed_from_u64(12);
    for size in [5, 25, 31, 33, 60, 120] {
        let rig = Rig::new(linkage::ladder(size));
        let mut pose = rig.closed();
        for part in [0.2, 0.45, 0.7] {
            pose = rig.reach(&pose, &rig.at(part));
            // The poses, against which the kernel is compared, have a cost of the third order.
            for _ in 0..if size < 100 { 6 } else { 2 } {
                let kind = if rng.random_bool(0.5) { "link" } else { "coupler" };
                let link = format!("{kind}_{}", rng.random_range(1..=size));
                let point = [rng.random_range(0.1..0.5), rng.random_range(-0.1..0.1), 0.0];
                let angle: f64 = rng.random_range(0.0..3.1);
                let n = linkage::plane().vector(&Vector3::new(angle.cos(), angle.sin(), 0.0));
                let contact = rig.contact(&link, point, n);
                let response = rig.respond(&pose, &contact);
                let (EffectiveMass::Finite(expected), Some(own)) =
                    (response.effective_mass, response.effective_mass_error())
                else {
                    continue;
                };
                all += 1;
                let Some((m, error)) = by_kernel(&pose, &contact) else { continue };
                answered += 1;
                assert!((m - expected).abs() <= error + own, "{}: {m} for {expected}, {error:e}", rig.name);
            }
        }
    }
    println!("{answered} of {all}");
    assert!(all > 80 && answered * 100 >= all * 95, "{answered} of {all}");
}

#[test]
fn a_rounded_file_is_its_exact_twin() {
    let mut gauge = Gauge::new("rounded and exact");
    let (exact, rounded) = linkage::rounded_four_bar();
    let (exact, rounded) = (Rig::new(exact), Rig::new(rounded));
    for rig in [&exact, &rounded] {
        assert_eq!(
            (rig.system.degrees_of_freedom(), rig.system.reference_or_open().redundant_constraints()),
            (1, 3)
        );
    }
    let (mut a, mut b) = (exact.closed(), rounded.closed());
    for i in 0..=100 {
        let drivers = exact.at(f64::from(i) / 100.0);
        (a, b) = (exact.reach(&a, &drivers), rounded.reach(&b, &drivers));
        let state = b.loops().expect("loops");
        assert!((1e-7..1e-5).contains(&state.inexactness) && state.residual < 1e-5, "{state:?}");
        assert_eq!(a.loops().expect("loops").inexactness, 0.0);
        for link in ["crank", "coupler", "rocker"] {
            let n = Vector3::new(0.5, 0.2, 0.8).normalize();
            let at = |rig: &Rig, pose: &_| -> ContactResponse {
                rig.respond(pose, &rig.contact(link, [0.3, 0.1, 0.0], n))
            };
            let (right, near) = (at(&exact, &a), at(&rounded, &b));
            assert_eq!((near.degrees_of_freedom, near.singular_pose), (1, false));
            let stated = near.effective_mass_error().expect("finite") / mass(&near);
            let case = format!("{link} at {drivers:?}");
            // Some micrometres per metre, and more if the point moves slowly along the normal and other parts move fast.
            let fast = 1.0 + exact.mechanism.characteristic_length() * Motion::of(&right).size();
            gauge.relative(&case, mass(&near), mass(&right), 1e-6 * fast);
            assert!(
                states_enough(&near, mass(&right), 0.0),
                "{case}: {} ± {stated:e}, {}",
                mass(&near),
                mass(&right)
            );
            assert!(stated < 1e-3 * fast, "{case}: {stated:e}");
        }
    }
    // In one step: following the branch of contradictory rows could lead to another pose.
    for part in [0.02, 0.35, 0.65, 0.98] {
        let drivers = exact.at(part);
        let [(right, there), (near, mass_nearby)] = [&exact, &rounded].map(|rig| {
            let pose = rig.reach(&rig.closed(), &drivers);
            let contact = rig.contact("coupler", [0.3, 0.1, 0.0], Vector3::new(0.5, 0.2, 0.8).normalize());
            let response = rig.respond(&pose, &contact);
            let pushed = pose.advanced_along(&response, 1e-3).expect("it gives way");
            (mass(&response), mass(&rig.respond(&pushed, &contact)) / mass(&response))
        });
        assert!((near / right - 1.0).abs() < 1e-4, "{part}: {near} {right}");
        assert!((mass_nearby - there).abs() < 1e-4, "{part}: {mass_nearby} {there}");
    }
    gauge.report();
}

/// Crank of 0.5 m on the ground with a mass at its tip, constrained by closures.
fn crank(closures: Vec<ClosureDescription>) -> Mechanism {
    let bar =
        |name: &str| LinkDescription::new(name, Inertial::diagonal(1.0, [0.4, 0.0, 0.0], [0.01, 0.02, 0.03]));
    let plate = JointDescription::new("weld", JointKind::Fixed, "crank", "plate").at([0.5, 0.0, 0.0]);
    let hinge = JointDescription::new("hinge", JointKind::Revolute, "ground", "crank").axis([0.0, 0.0, 1.0]);
    let builder = MechanismBuilder::new("crank")
        .link(LinkDescription::massless("ground"))
        .link(bar("crank"))
        .link(bar("plate"))
        .joint(hinge)
        .joint(plate);
    closures.into_iter().fold(builder, MechanismBuilder::closure).build().expect("a crank").mechanism
}

fn unclosed(mechanism: Mechanism) -> Vec<String> {
    let system = System::new(mechanism, &Conditions::new()).expect("free");
    let error = doing("giving up", || system.pose(&system.configuration()).expect_err("it cannot close"));
    let message = error.to_string();
    match error {
        AssemblyError::DoesNotClose { loops, residual, allowed, .. } => {
            assert!(residual > allowed, "{residual} {allowed}");
            assert!(message.contains(&format!("\"{}\"", loops[0])), "{message}");
            loops
        }
        other => panic!("{other}"),
    }
}

#[test]
fn loops_that_contradict_themselves() {
    let rod = |name: &str, at: [f64; 3], length: f64| {
        ClosureDescription::new(name, ClosureKind::Distance, "ground", "crank")
            .at(at, [0.5, 0.0, 0.0])
            .distance(length)
    };
    // One rod fits a quarter turn, the other no turn; one rod alone can be closed.
    let system = System::new(crank(vec![rod("up", [0.0, 1.0, 0.0], 0.6)]), &Conditions::new()).unwrap();
    let pose = system.pose(&system.configuration()).expect("one rod closes");
    assert!(pose.loops().is_some_and(|l| l.residual < 1e-12));
    let loops = unclosed(crank(vec![rod("up", [0.0, 1.0, 0.0], 0.55), rod("down", [0.0, -1.0, 0.0], 0.55)]));
    assert_eq!(loops.len(), 2);
    // Out of reach for every crank angle.
    assert_eq!(unclosed(crank(vec![rod("far", [3.0, 0.0, 0.0], 1.0)])), ["far"]);
    // Hinge and closure have different axes.
    let tilted = ClosureDescription {
        successor_frame: Transform::new(rotation_from_rpy([0.3, 0.0, 0.0]), Vector3::zeros()),
        ..ClosureDescription::new("tilted", ClosureKind::Revolute, "ground", "crank").axis([0.0, 0.0, 1.0])
    };
    assert_eq!(unclosed(crank(vec![tilted])), ["tilted"]);
    // Closures between links of one rigid body, with and without a misfit.
    let weld = |x: f64| {
        ClosureDescription::new("again", ClosureKind::Fixed, "crank", "plate").at([x, 0.0, 0.0], [0.0; 3])
    };
    assert_eq!(unclosed(crank(vec![weld(0.6)])), ["again"]);
    let system = System::new(crank(vec![weld(0.5)]), &Conditions::new()).unwrap();
    let pose = system.pose(&system.configuration()).expect("it fits");
    assert_eq!((system.degrees_of_freedom(), system.reference_or_open().redundant_constraints()), (1, 6));
    assert_eq!(system.reference_or_open().redundant_loops(), [vec!["again".to_owned()]]);
    assert_eq!(pose.loops().unwrap().residual, 0.0);
}

#[test]
fn a_joint_that_follows_is_not_set() {
    let rig = Rig::new(linkage::four_bar());
    let mut both = rig.configuration(&[0.7]);
    both.set("rocker_hinge", &[1.0]).unwrap();
    let error = rig.system.pose(&both).unwrap_err();
    assert!(error.is_bad_input());
    let text = error.to_string();
    assert!(
        text.starts_with(
            "joint \"rocker_hinge\" depends on others through the loops; too many joints are set"
        ),
        "{text}"
    );
    assert!(
        text.contains("follow from \"crank_hinge\", and none of the others is free; leave this one out"),
        "{text}"
    );
    assert!(matches!(error, AssemblyError::Dependent { .. }));
    // Every joint alone may drive.
    for joint in ["crank_hinge", "crank_pin", "rocker_hinge"] {
        let mut one = rig.system.configuration();
        let at = rig.closed().joint(rig.joint(joint))[0];
        one.set(joint, &[at + 0.05]).unwrap();
        let pose = rig.system.pose_from(&rig.closed(), &one).unwrap();
        assert_eq!(pose.loops().unwrap().drivers, [rig.joint(joint)]);
        assert!(rig.open(&pose) < 1e-12 && pose.joint(rig.joint(joint)) == [at + 0.05]);
    }
}

#[test]
fn locks_within_loops() {
    // Locks of every joint of a loop, of one joint, and of coupled shafts: the same result as route C.
    let whole = ["crank_hinge", "crank_pin", "rocker_hinge"];
    type Case<'a> = (fn() -> Linkage, &'a [&'a str], &'a str);
    let cases: [Case; 5] = [
        (linkage::four_bar, &whole, "coupler"),
        (linkage::four_bar, &whole[1..2], "coupler"),
        (linkage::geared_pair, &["slow"], "fast"),
        (linkage::geared_pair, &["slow", "fast"], "fast"),
        (linkage::planetary_gear, &["planet"], "sun"),
    ];
    for (make, locks, link) in cases {
        let conditions = locks.iter().fold(Conditions::new(), |c, joint| c.lock(*joint));
        let rig = Rig::under(make(), &conditions);
        let pose = rig.closed();
        let contact = rig.contact(link, [0.1, 0.2, 0.0], Vector3::new(0.3, 0.5, 0.1));
        let mut asked = question(&rig.system, &rig.mechanism, &pose, &contact);
        asked.locked = locks.iter().map(|name| rig.joint(name)).collect();
        let answer = maximal::solve(&asked);
        let case = format!("{} {locks:?}", rig.name);
        assert_eq!(answer.degrees_of_freedom, 0, "{case}");
        assert_eq!(rig.system.degrees_of_freedom(), 0, "{case}");
        assert_eq!(
            rig.system.reference_or_open().redundant_constraints(),
            answer.redundant_constraints,
            "{case}"
        );
        assert_eq!(rig.respond(&pose, &contact).effective_mass, EffectiveMass::Immovable, "{case}");
    }
}

#[test]
fn a_sphere_drives_a_loop() {
    // A plate on a ball joint moves a slider on a guide by a rod: the three rotations of the ball drive, the slider follows.
    let body = |name: &str, mass: f64| {
        LinkDescription::new(name, Inertial::diagonal(mass, [0.2, 0.1, 0.0], [0.05, 0.06, 0.08]))
    };
    let rod = ClosureDescription::new("rod", ClosureKind::Distance, "slider", "plate")
        .at([0.0; 3], [0.4, 0.1, 0.0])
        .distance(0.5);
    let mechanism = MechanismBuilder::new("plate")
        .link(LinkDescription::massless("ground"))
        .link(body("plate", 2.0))
        .link(body("slider", 1.0))
        .joint(JointDescription::new("ball", JointKind::Spherical, "ground", "plate"))
        .joint(JointDescription::new("slide", JointKind::Prismatic, "ground", "slider").axis([0.0, 0.0, 1.0]))
        .closure(rod)
        .build()
        .expect("a plate")
        .mechanism;
    let system = System::new(mechanism, &Conditions::new()).expect("free");
    assert_eq!(system.degrees_of_freedom(), 3);
    let slide = system.mechanism().find_joint("slide").unwrap();
    let at_zero = system.pose(&system.configuration()).expect("it closes");
    // On the original side for every rotation: z = p_z ± √(l² − p_x² − p_y²).
    let side = at_zero.joint(slide)[0].signum();
    let mut pose = at_zero;
    for [roll, pitch, yaw] in
        [[0.3, 0.1, 0.0], [-0.4, 0.5, 1.0], [0.2, -0.9, 2.9], [0.0, 0.4, -2.0], [0.7, 0.0, 0.3]]
    {
        let turn = rotation_from_rpy([roll, pitch, yaw]);
        let q = nalgebra::UnitQuaternion::from_matrix(&turn);
        let mut configuration = system.configuration();
        configuration.set("ball", &[q.w, q.i, q.j, q.k]).unwrap();
        for from in [None, Some(&pose)] {
            let here = from
                .map_or_else(|| system.pose(&configuration), |from| system.pose_from(from, &configuration));
            let p = turn * Vector3::new(0.4, 0.1, 0.0);
            let expected = p.z + side * (0.25 - p.x * p.x - p.y * p.y).sqrt();
            let got = here.as_ref().expect("in reach").joint(slide)[0];
            assert!((got - expected).abs() < 1e-12, "{roll} {pitch} {yaw}: {got} {expected}");
        }
        pose = system.pose(&configuration).unwrap();
    }
}
