//! A workspace agrees with a pose: the same status and the same number, also if the recursion is inaccurate or reports
//! a massless contact. Results are bitwise equal, except for the SIMD kernels (trees of hinges and slides, linkages of
//! few degrees of freedom), which agree within the stated error.

use nalgebra::{UnitQuaternion, Vector3};
use percuss_dynamics::{
    Conditions, Contact, ContactResponse, DenseReason, Direction, EffectiveMass, Frame, Pose, ResponseError,
    System, Workspace,
};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};
use percuss_spatial::{Matrix3, Transform};
use percuss_tests::judge::UNSTATED;
use percuss_tests::subjects::{of_linkages, of_trees};
use std::collections::BTreeMap;

/// Number of results by status and by reason for the dense route.
type Counts = BTreeMap<String, usize>;

fn compare(name: &str, pose: &Pose, contact: &Contact, counts: &mut Counts) {
    let mut workspace = pose.assembly().workspace();
    workspace.set_positions(pose.positions()).expect("positions that fit");
    let there = workspace.effective_mass(contact);
    let response = pose.respond(contact);
    let mass = response.as_ref().map(|r| r.effective_mass).map_err(ResponseError::clone);
    let Ok(response) = response else { return assert_eq!(there, mass, "{name}") };
    let has_lanes = pose.assembly().batch(contact).is_ok_and(|batch| batch.has_lanes());
    match (&there, &mass) {
        (Ok(EffectiveMass::Finite(a)), Ok(EffectiveMass::Finite(b))) if has_lanes => {
            // The workspace's own error is at most 1e-11.
            let error = response.effective_mass_error();
            if error.is_none() {
                *counts.entry("in lanes, without a stated error".to_owned()).or_default() += 1;
            }
            let allowed = error.unwrap_or(UNSTATED * b) + 1e-11 * b;
            assert!((a - b).abs() <= allowed, "{name}: {a} {b}, allowed {allowed:e}");
            *counts.entry("in lanes".to_owned()).or_default() += 1;
        }
        _ => assert_eq!(there, mass, "{name}"),
    }
    compare_response(name, &mut workspace, contact, &response);
    let status = match response.effective_mass {
        EffectiveMass::Finite(_) => "finite",
        EffectiveMass::Immovable => "immovable",
        EffectiveMass::Massless => "massless",
    };
    let reason = match response.dense_reason {
        None => "",
        Some(DenseReason::NegativeMass) => ", a negative mass",
        Some(DenseReason::Massless) => ", massless",
        Some(DenseReason::Error { relative }) if relative > 1.0 => ", rounding alone",
        Some(DenseReason::Error { .. }) => ", an error",
    };
    *counts.entry(format!("{status}{reason}")).or_default() += 1;
}

/// The response of a workspace is that of the pose, v* included; its error is that by rounding.
fn compare_response(name: &str, workspace: &mut Workspace, contact: &Contact, response: &ContactResponse) {
    let mut velocities = Vec::new();
    let there = workspace.respond(contact, &mut velocities).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(there.effective_mass, response.effective_mass, "{name}");
    assert_eq!(there.error, response.error.and_then(|budget| budget.rounding), "{name}");
    if let EffectiveMass::Finite(_) = there.effective_mass {
        assert_eq!(velocities, response.joint_velocities.concat(), "{name}");
        assert_eq!(there.base_velocity, response.base_velocity, "{name}");
    }
}

#[track_caller]
fn assert_occurred(counts: &Counts, kinds: &[&str]) {
    println!("{counts:?}");
    for kind in kinds {
        assert!(counts.contains_key(*kind), "{kind} never occurred: {counts:?}");
    }
}

#[test]
fn on_trees_and_linkages() {
    let mut counts = Counts::new();
    for subject in of_trees(16, 3, 120).into_iter().chain(of_linkages(800, 8)) {
        compare(&subject.name, &subject.pose, &subject.contact, &mut counts);
    }
    assert_occurred(&counts, &["finite", "in lanes", "immovable", "massless, massless"]);
}

/// An assembly reuses workspaces: earlier questions do not affect results.
#[test]
fn earlier_questions_change_nothing() {
    let mut others = 0;
    for subject in of_trees(17, 1, 40).into_iter().chain(of_linkages(801, 2)) {
        let whole = |contact: &Contact| format!("{:?}", subject.pose.respond(contact));
        let fresh = whole(&subject.contact);
        for link in subject.mechanism().link_ids() {
            others += usize::from(whole(&Contact::new(link, [0.1, 0.2, -0.3], [0.2, 1.0, -0.4])) != fresh);
        }
        assert_eq!(whole(&subject.contact), fresh, "{}", subject.name);
    }
    assert!(others > 100, "{others} other answers");
}

/// A bar of 2 kg on a ball joint with the moment of inertia `roll` about its own axis (kg·m²); if `tied`, a rod holds
/// its tip level, and the roll stays free.
fn bar(roll: f64, tied: bool) -> Mechanism {
    let inertial = Inertial {
        mass: 2.0,
        com: Vector3::new(0.5, 0.0, 0.0),
        about_com: Matrix3::from_diagonal(&Vector3::new(roll, 0.2, 0.2)),
    };
    let builder = MechanismBuilder::new("bar")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("bar", inertial))
        .joint(JointDescription::new("ball", JointKind::Spherical, "ground", "bar"));
    let at = |x, z| Transform::new(Matrix3::identity(), Vector3::new(x, 0.0, z));
    let rod = ClosureDescription {
        predecessor_frame: at(0.0, 1.0),
        successor_frame: at(1.0, 0.0),
        ..ClosureDescription::new("rod", ClosureKind::Distance, "ground", "bar")
    };
    let builder = if tied { builder.closure(rod) } else { builder };
    builder.build().expect("a mechanism").mechanism
}

/// An arm of 5 kg with a feeler of the given mass on a hinge at its tip.
fn feeler(mass: f64) -> Mechanism {
    let hinge = |name: &str, parent: &str, child: &str| {
        JointDescription::new(name, JointKind::Continuous, parent, child).axis([0.0, 0.0, 1.0])
    };
    MechanismBuilder::new("feeler")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("arm", Inertial::point(5.0, [0.6, 0.0, 0.0])))
        .link(LinkDescription::new("feeler", Inertial::point(mass, [0.1, 0.0, 0.0])))
        .joint(hinge("shoulder", "ground", "arm"))
        .joint(hinge("knuckle", "arm", "feeler").at([0.6, 0.0, 0.0]))
        .build()
        .expect("a mechanism")
        .mechanism
}

fn system(mechanism: Mechanism) -> System {
    System::new(mechanism, &Conditions::new()).expect("a system")
}

#[test]
fn on_nearly_massless_and_massless_contacts() {
    let mut counts = Counts::new();
    let parts = (0..=96).map(|k| 10f64.powf(-0.25 * f64::from(k))).chain([0.0]);
    for (k, part) in parts.enumerate() {
        let angle = 0.3 * k as f64;
        let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle)
            * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.7 * angle);
        for tied in [false, true] {
            let system = system(bar(part, tied));
            let mut configuration = system.configuration();
            let ball = [turned.w, turned.i, turned.j, turned.k];
            configuration.set("ball", &ball).expect("a quaternion");
            let pose = system.pose(&configuration).expect("closed");
            let link = system.mechanism().find_link("bar").expect("there");
            // Normals: tangential to the roll, which alone has little mass; with a component along the tip's motion;
            // into the axis.
            for normal in [[0.0, 0.0, 1.0], [0.0, 0.3, 1.0], [1.0, 0.0, 0.0]] {
                for point in [[0.0, 0.1, 0.0], [0.4, 0.1, 0.0], [0.4, 1e-4, 0.0], [0.4, 0.0, 0.0]] {
                    let along = Direction::Along(Vector3::from(normal), Frame::Link);
                    let contact = Contact::new(link, point, normal).normal(along);
                    let name = format!("bar, {part:.1e}, tied {tied}, {point:?} {normal:?}");
                    compare(&name, &pose, &contact, &mut counts);
                }
            }
        }
        let system = system(feeler(part));
        let mut configuration = system.configuration();
        configuration.set("knuckle", &[angle]).expect("an angle");
        let pose = system.pose(&configuration).expect("a tree");
        let link = system.mechanism().find_link("feeler").expect("there");
        let contact = Contact::new(link, [0.2, 0.0, 0.0], [0.3, 1.0, 0.0]);
        compare(&format!("feeler, {part:.1e}"), &pose, &contact, &mut counts);
    }
    let kinds = ["finite", "finite, an error", "finite, massless", "massless, massless", "immovable"];
    assert_occurred(&counts, &kinds);
}
