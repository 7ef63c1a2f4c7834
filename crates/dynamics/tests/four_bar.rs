//! A four-bar closed by a spatial hinge: three redundant rows, and frames as a CAD export rounds them.

use nalgebra::Vector3;
use percuss_dynamics::{
    AssemblyError, Conditions, Contact, ContactResponse, EffectiveMass, RouteChoice, System,
};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder,
};
use percuss_spatial::{Transform, rotation_from_rpy};

/// Crank 0.3, coupler 0.7, rocker 0.5, ground 0.8 m, in the x-z plane; the two ground hinges turned up by these angles
/// about x.
fn four_bar(crank_tilt: f64, rocker_tilt: f64) -> System {
    let bar = |name: &str, length: f64, mass: f64, moments: [f64; 3]| {
        LinkDescription::new(name, Inertial::diagonal(mass, [length / 2.0, 0.0, 0.0], moments))
    };
    let hinge = |name: &str, parent: &str, child: &str, x: f64, tilt: f64| {
        JointDescription::new(name, JointKind::Continuous, parent, child)
            .origin(Transform::new(rotation_from_rpy([tilt, 0.0, 0.0]), Vector3::new(x, 0.0, 0.0)))
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
                .at([0.7, 0.0, 0.0], [0.5, 0.0, 0.0])
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
    pose.respond(&contact, RouteChoice::Auto).unwrap()
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
