//! A loop of many links, most of which stay free: one cluster with a dense mass matrix.

use percuss_dynamics::{
    Conditions, Contact, ContactResponse, EffectiveMass, ResponseError, Route, RouteChoice, RouteError,
    System,
};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};
use percuss_spatial::{Matrix3, Transform, Vector3};

/// `n` links of 1.3 kg in a chain on a carriage, with alternating hinges along y and z; a rod holds the tip to the
/// carriage.
fn tethered(n: usize) -> Mechanism {
    let mut builder = MechanismBuilder::new("tethered")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("carriage", Inertial::point(2.0, [0.0; 3])))
        .joint(
            JointDescription::new("rail", JointKind::Prismatic, "ground", "carriage").axis([0.6, 0.0, 0.8]),
        );
    let mut parent = "carriage".to_owned();
    for i in 0..n {
        let link = format!("link_{i}");
        let inertial = Inertial {
            mass: 1.3,
            com: Vector3::new(0.05, 0.01, -0.02),
            about_com: Matrix3::from_diagonal(&Vector3::new(0.002, 0.003, 0.004)),
        };
        let axis = if i % 2 == 0 { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] };
        let origin = [if i == 0 { 0.0 } else { 0.1 }, 0.0, 0.0];
        builder = builder.link(LinkDescription::new(&link, inertial)).joint(
            JointDescription::new(format!("hinge_{i}"), JointKind::Continuous, &parent, &link)
                .at(origin)
                .axis(axis),
        );
        parent = link;
    }
    let rod = ClosureDescription {
        predecessor_frame: Transform::new(Matrix3::identity(), Vector3::new(0.1, 0.0, 0.0)),
        successor_frame: Transform::new(Matrix3::identity(), Vector3::new(0.03 * n as f64, 0.5, 0.3)),
        ..ClosureDescription::new("rod", ClosureKind::Distance, &parent, "carriage")
    };
    builder.closure(rod).build().unwrap().mechanism
}

#[test]
fn clusters_of_many_freedoms_agree_with_the_dense_route() {
    for n in [40, 60, 90] {
        let mechanism = tethered(n);
        let link = mechanism.find_link(&format!("link_{}", 2 * n / 3)).unwrap();
        let system = System::new(mechanism, &Conditions::new()).unwrap();
        assert_eq!(system.degrees_of_freedom(), n);
        let mut configuration = system.configuration();
        for i in 0..n / 2 {
            configuration.set(&format!("hinge_{i}"), &[0.1 * f64::sin(i as f64)]).unwrap();
        }
        let pose = system.pose(&configuration).unwrap();
        let contact = Contact::new(link, [0.05, 0.02, 0.0], [0.2, 0.7, -0.4]);
        let answer =
            |route| -> ContactResponse { pose.respond_by_route(&contact, RouteChoice::Only(route)).unwrap() };
        let (recursion, dense) = (answer(Route::Articulated), answer(Route::Dense));
        let (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) =
            (recursion.effective_mass, dense.effective_mass)
        else {
            panic!("{n}: {recursion:?} {dense:?}")
        };
        let stated = (recursion.effective_mass_error().unwrap() + dense.effective_mass_error().unwrap()) / b;
        assert!(
            (a / b - 1.0).abs() < 1e-9 && (a / b - 1.0).abs() <= stated,
            "{n}: {a} {b} stated {stated:.1e}"
        );
    }
}

#[test]
fn a_cluster_of_too_many_freedoms_is_refused() {
    let mechanism = tethered(2500);
    let link = mechanism.find_link("link_7").unwrap();
    let system = System::new(mechanism, &Conditions::new()).unwrap();
    let pose = system.pose(&system.configuration()).unwrap();
    let contact = Contact::new(link, [0.05, 0.02, 0.0], [0.2, 0.7, -0.4]);
    let refused = |error: ResponseError| match error {
        ResponseError::Route(RouteError::ClusterTooLarge { loops, freedoms, bytes, most_bytes, .. }) => {
            assert_eq!((loops, freedoms), (vec!["rod".to_owned()], 2499));
            assert!(bytes > most_bytes);
        }
        other => panic!("{other}"),
    };
    refused(pose.respond(&contact).expect_err("gigabytes"));
    refused(pose.assembly().workspace().effective_mass(&contact).expect_err("gigabytes"));
    refused(pose.effective_mass_gradient(&contact).expect_err("gigabytes"));
    let located = pose.locate(&contact).unwrap();
    refused(pose.inverse_operational_inertia(&located).expect_err("gigabytes").into());
}
