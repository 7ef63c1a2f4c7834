//! A four-bar closed by a spatial revolute joint: three redundant rows, and frames rounded as in a CAD export.

use nalgebra::Vector3;
use percuss_dynamics::{
    AssemblyError, Conditions, Contact, ContactError, ContactResponse, EffectiveMass, PointForce, Pose,
    RouteError, StateSizeError, System,
};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};
use percuss_spatial::{Transform, Twist, rotation_from_rpy};

/// Crank 0.3, coupler 0.7, rocker 0.5, ground 0.8 m, in the x-z plane. The two ground joints are rotated by these
/// angles about x.
fn four_bar(crank_tilt: f64, rocker_tilt: f64) -> System {
    scaled_four_bar(1.0, crank_tilt, rocker_tilt)
}

/// The four-bar with all lengths multiplied by `scale`.
fn scaled_four_bar(scale: f64, crank_tilt: f64, rocker_tilt: f64) -> System {
    let bar = |name: &str, length: f64, mass: f64, moments: [f64; 3]| {
        LinkDescription::new(
            name,
            Inertial::diagonal(mass, [scale * length / 2.0, 0.0, 0.0], moments.map(|m| m * scale * scale)),
        )
    };
    let hinge = |name: &str, parent: &str, child: &str, x: f64, tilt: f64| {
        JointDescription::new(name, JointKind::Continuous, parent, child)
            .origin(Transform::new(rotation_from_rpy([tilt, 0.0, 0.0]), Vector3::new(scale * x, 0.0, 0.0)))
            .axis([0.0, 0.0, 1.0])
    };
    let built = MechanismBuilder::new("four_bar")
        .link(LinkDescription::massless("ground"))
        .link(bar("crank", 0.3, 2.0, [0.002, 0.017, 0.018]))
        .link(bar("coupler", 0.7, 5.0, [0.002, 0.206167, 0.207167]))
        .link(bar("rocker", 0.5, 3.0, [0.002, 0.0645, 0.0655]))
        .joint(hinge("crank_hinge", "ground", "crank", 0.0, crank_tilt))
        .joint(hinge("crank_pin", "crank", "coupler", 0.3, 0.0))
        .joint(hinge("rocker_hinge", "ground", "rocker", 0.8, rocker_tilt))
        .closure(
            ClosureDescription::new("rocker_pin", ClosureKind::Revolute, "coupler", "rocker")
                .at([scale * 0.7, 0.0, 0.0], [scale * 0.5, 0.0, 0.0])
                .axis([0.0, 0.0, 1.0]),
        )
        .build()
        .expect("a good mechanism");
    System::new(built.mechanism, &Conditions::new()).expect("it closes")
}

fn respond(system: &System, pin: f64, rocker: f64) -> ContactResponse {
    let mut configuration = system.configuration();
    configuration.set("crank_hinge", &[1.1]).unwrap();
    configuration.guess("crank_pin", &[pin]).unwrap().guess("rocker_hinge", &[rocker]).unwrap();
    let pose = system.pose(&configuration).unwrap();
    let coupler = system.mechanism().find_link("coupler").unwrap();
    let contact = Contact::new(coupler, [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
    pose.respond(&contact).unwrap()
}

fn kilograms(response: &ContactResponse) -> f64 {
    match response.effective_mass {
        EffectiveMass::Finite(m) => m,
        other => panic!("{other:?}"),
    }
}

#[test]
fn ideal_and_rounded_frames_give_the_same_answer() {
    let right = std::f64::consts::FRAC_PI_2;
    let ideal = four_bar(right, right);
    assert_eq!((ideal.degrees_of_freedom(), ideal.reference_or_open().redundant_constraints()), (1, 3));
    assert!(
        ideal.reference_or_open().rank_gap().unwrap() > 1e12 && ideal.reference_or_open().rank_is_clear()
    );
    let m = kilograms(&respond(&ideal, -0.7, 1.5));
    // Nine digits, computed independently.
    assert!((m - 21.093041).abs() < 1e-6, "{m}");
    let to = |decimals: i32| (right * 10f64.powi(decimals)).round() / 10f64.powi(decimals);
    let rounded = four_bar(to(4), to(6));
    assert_eq!((rounded.degrees_of_freedom(), rounded.reference_or_open().redundant_constraints()), (1, 3));
    let r = kilograms(&respond(&rounded, -0.7, 1.5));
    assert!((r / m - 1.0).abs() < 1e-5, "{r}");
}

#[test]
fn the_other_assembly_is_another_answer() {
    let right = std::f64::consts::FRAC_PI_2;
    let system = four_bar(right, right);
    let (a, b) = (respond(&system, -0.7, 1.5), respond(&system, -2.2, -2.4));
    assert!((kilograms(&a) / kilograms(&b) - 1.0).abs() > 1e-3);
}

#[test]
fn a_rod_between_points_that_coincide_is_refused() {
    let arm = |name: &str| LinkDescription::new(name, Inertial::point(1.0, [0.2, 0.0, 0.0]));
    let hinge = |name: &str, child: &str| JointDescription::new(name, JointKind::Continuous, "ground", child);
    let built = MechanismBuilder::new("arms")
        .link(LinkDescription::massless("ground"))
        .link(arm("a"))
        .link(arm("b"))
        .joint(hinge("ja", "a"))
        .joint(hinge("jb", "b"))
        .closure(ClosureDescription::new("rod", ClosureKind::Distance, "a", "b").at([0.1; 3], [0.1; 3]))
        .build()
        .expect("a good mechanism");
    let system = System::new(built.mechanism, &Conditions::new()).expect("a system");
    let error = system.pose(&system.configuration()).expect_err("no length, no direction");
    assert!(matches!(&error, AssemblyError::NoDistance { name } if name == "rod"), "{error}");
    assert!(error.is_bad_input());
}

/// Two arms of 1 m on the ground at these positions, with their tips connected by a rod.
fn arms(places: [[f64; 3]; 2]) -> System {
    let arm = |name: &str| LinkDescription::new(name, Inertial::point(1.0, [0.2, 0.0, 0.0]));
    let hinge = |name: &str, child: &str, at| {
        JointDescription::new(name, JointKind::Continuous, "ground", child).at(at).axis([0.0, 0.0, 1.0])
    };
    let built = MechanismBuilder::new("arms")
        .link(LinkDescription::massless("ground"))
        .link(arm("a"))
        .link(arm("b"))
        .joint(hinge("ja", "a", places[0]))
        .joint(hinge("jb", "b", places[1]))
        .closure(
            ClosureDescription::new("rod", ClosureKind::Distance, "a", "b")
                .at([1.0, 0.0, 0.0], [1.0, 0.2, 0.0])
                .distance(1.5),
        )
        .build()
        .expect("a good mechanism");
    System::new(built.mechanism, &Conditions::new()).expect("a system")
}

#[test]
fn loops_that_positions_cannot_resolve_are_refused() {
    for x in [1e12, 1e16, 1e20, 1e60] {
        let system = arms([[x, 0.0, 0.0], [x, 1.0, 0.0]]);
        let error = system.pose(&system.configuration()).expect_err("no digits are left of 1 m");
        assert!(
            matches!(&error, AssemblyError::TooFarOut { loops, far, .. } if loops == &["rod"] && (*far / x - 1.0).abs() < 1e-9),
            "{x}: {error}"
        );
        assert!(error.is_bad_input());
        // Diagnostics of loops as drawn must not panic either.
        assert!(system.degrees_of_freedom() <= 2);
    }
    let system = arms([[1e5, 0.0, 0.0], [1e5, 1.0, 0.0]]);
    let posed = system.pose(&system.configuration());
    assert!(posed.is_ok(), "{posed:?}");
}

#[test]
fn how_far_a_mechanism_is_followed_does_not_depend_on_its_unit() {
    let right = std::f64::consts::FRAC_PI_2;
    let pushed = |scale: f64, crank: f64, distance: f64| -> Option<Pose> {
        let system = scaled_four_bar(scale, right, right);
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[crank]).unwrap();
        configuration.guess("crank_pin", &[-0.7]).unwrap().guess("rocker_hinge", &[1.5]).unwrap();
        let pose = system.pose(&configuration).unwrap();
        let coupler = system.mechanism().find_link("coupler").unwrap();
        let contact = Contact::new(coupler, [0.35 * scale, 0.1 * scale, 0.0], [0.0, 1.0, 0.0]);
        let response = pose.respond(&contact).unwrap();
        pose.advanced_along(&response, scale * distance)
    };
    let (mut followed, mut lost) = (0, 0);
    for step in 0..12 {
        for distance in [1e-3, 0.03, 0.1, 0.2] {
            let crank = 0.2 + 0.5 * f64::from(step);
            let [small, large] = [1.0, 64.0].map(|scale| pushed(scale, crank, distance).is_some());
            assert_eq!(small, large, "crank {crank}, {distance}");
            *(if small { &mut followed } else { &mut lost }) += 1;
        }
    }
    assert!(followed > 10 && lost > 2, "{followed} {lost}");
}

/// A plate that moves in the plane, connected to the ground by a chain of `n` links of 1 m in that plane.
fn tied_plate(n: usize) -> System {
    let mut builder = MechanismBuilder::new("plate")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("plate", Inertial::point(1.0, [0.1, 0.0, 0.0])))
        .joint(JointDescription::new("slide", JointKind::Planar, "ground", "plate").axis([0.0, 0.0, 1.0]));
    let mut parent = "ground".to_owned();
    for i in 0..n {
        let link = format!("link_{i}");
        builder = builder.link(LinkDescription::new(&link, Inertial::point(1.0, [0.5, 0.0, 0.0]))).joint(
            JointDescription::new(format!("hinge_{i}"), JointKind::Continuous, &parent, &link)
                .at([if i == 0 { 0.0 } else { 1.0 }, 0.0, 0.0])
                .axis([0.0, 0.0, 1.0]),
        );
        parent = link;
    }
    let half = n as f64 / 2.0;
    let built = builder
        .closure(
            ClosureDescription::new("tie", ClosureKind::Distance, &parent, "plate")
                .at([1.0, 0.0, 0.0], [0.0, half, 0.0])
                .distance(half),
        )
        .build()
        .expect("a good mechanism");
    System::new(built.mechanism, &Conditions::new()).expect("a system")
}

#[test]
fn a_joint_set_far_out_of_a_long_loop_is_given_up() {
    let system = tied_plate(40);
    let mut configuration = system.configuration();
    configuration.set("slide", &[1e6, 0.0, 0.0]).unwrap();
    let error = system.pose(&configuration).expect_err("40 m do not reach there");
    let AssemblyError::TooFar { requested: wanted, reached } = &error else { panic!("{error}") };
    assert_eq!(wanted[wanted.len() - 3].0, "slide[0]");
    assert_eq!(wanted[wanted.len() - 3].1, 1e6);
    assert_eq!(reached.len(), wanted.len());
    let mut configuration = system.configuration();
    configuration.set("slide", &[1.0, 2.0, 0.3]).unwrap();
    let slide = system.mechanism().find_joint("slide").unwrap();
    assert_eq!(system.pose(&configuration).unwrap().joint(slide), [1.0, 2.0, 0.3]);
}

#[test]
fn a_ball_that_cannot_stand_where_it_is_set_is_noted_beside_a_guess_too() {
    // A rod of 1 m on a spherical joint, its tip on a cart that moves along x: only its spin is free.
    let built = MechanismBuilder::new("rod")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("rod", Inertial::diagonal(1.0, [0.5, 0.0, 0.0], [0.01, 0.1, 0.1])))
        .link(LinkDescription::new("cart", Inertial::point(1.0, [0.0; 3])))
        .joint(JointDescription::new("ball", JointKind::Spherical, "ground", "rod"))
        .joint(
            JointDescription::new("slide", JointKind::Prismatic, "ground", "cart")
                .at([1.0, 0.0, 0.0])
                .axis([1.0, 0.0, 0.0]),
        )
        .closure(
            ClosureDescription::new("tip", ClosureKind::Spherical, "rod", "cart")
                .at([1.0, 0.0, 0.0], [0.0; 3]),
        )
        .build()
        .expect("a good mechanism");
    let system = System::new(built.mechanism, &Conditions::new()).expect("a system");
    let ball = system.mechanism().find_joint("ball").unwrap();
    for guess in [None, Some(0.0), Some(-0.3)] {
        let mut configuration = system.configuration();
        configuration.set("ball", &[0.25_f64.cos(), 0.0, 0.0, 0.25_f64.sin()]).unwrap();
        if let Some(guess) = guess {
            configuration.guess("slide", &[guess]).unwrap();
        }
        let pose = system.pose(&configuration).unwrap();
        let off = &pose.loops().unwrap().off_target;
        assert!(
            matches!(off[..], [(id, far)] if id == ball && (far - 0.5).abs() < 1e-6),
            "{guess:?}: {off:?}"
        );
    }
}

fn pendulum() -> (System, Mechanism) {
    let arm = |links: &[&str]| {
        let mut builder = MechanismBuilder::new("arm").link(LinkDescription::massless("ground"));
        let mut parent = "ground";
        for link in links {
            builder = builder
                .link(LinkDescription::new(*link, Inertial::diagonal(1.0, [0.5, 0.0, 0.0], [0.1; 3])))
                .joint(JointDescription::new(format!("to_{link}"), JointKind::Continuous, parent, *link));
            parent = link;
        }
        builder.build().expect("a good mechanism").mechanism
    };
    (System::new(arm(&["arm"]), &Conditions::new()).expect("a system"), arm(&["a", "b", "c"]))
}

#[test]
fn what_does_not_fit_a_mechanism_is_refused() {
    let (system, other) = pendulum();
    let foreign = other.find_link("c").unwrap();
    let pose = system.pose(&system.configuration()).unwrap();
    let link = system.mechanism().find_link("arm").unwrap();
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let accelerations = |velocities: &[Vec<f64>], forces: &[PointForce]| {
        pose.accelerations(velocities, &Twist::zero(), &gravity, forces)
    };
    for (velocities, joints) in [(vec![], true), (vec![vec![]], false), (vec![vec![0.0, 0.0]], false)] {
        let error = accelerations(&velocities, &[]).expect_err("not the mechanism's");
        match error {
            RouteError::Velocities(StateSizeError::Joints { got: 0, expected: 1 }) => assert!(joints),
            RouteError::Velocities(StateSizeError::VelocityCount { expected: 1, .. }) => assert!(!joints),
            other => panic!("{other}"),
        }
    }
    let push = PointForce { link: foreign, point: Vector3::zeros(), force: gravity };
    assert!(matches!(
        accelerations(&[vec![0.0]], &[push]),
        Err(RouteError::ForeignLink { index: 3, links: 2 })
    ));
    let known = accelerations(&[vec![0.0]], &[]).unwrap();
    assert!(matches!(
        pose.point_acceleration(&known, foreign, &Vector3::zeros()),
        Err(RouteError::ForeignLink { .. })
    ));
    let other = System::new(other, &Conditions::new()).unwrap();
    let beside = other.pose(&other.configuration()).unwrap();
    assert!(matches!(
        beside.point_acceleration(&known, foreign, &Vector3::zeros()),
        Err(RouteError::ForeignAccelerations { got: 1, expected: 3 })
    ));

    let contact = Contact::new(link, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let count = |got| Err(StateSizeError::PositionCount { got, expected: 1 });
    let mut workspace = system.workspace();
    assert_eq!(workspace.set_positions(&[]), count(0));
    assert_eq!(workspace.set_positions(&[0.0; 7]), count(7));
    assert!(workspace.effective_mass(&contact).is_ok());

    let response = pose.respond(&contact).unwrap();
    for mass in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        let refused = response.clone().against_mass(mass);
        assert!(matches!(refused, Err(ContactError::OtherMass { .. })), "{mass}");
    }
}
