//! Written mechanisms are read back unchanged.

use crate::support::load_text;
use approx::assert_relative_eq;
use percuss_formats::{Comments, write_urdf, write_urdf_with};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, CouplingDescription, ElasticGear, Inertial, JointDescription, JointKind,
    Limits, LinkDescription, Mechanism, MechanismBuilder, SpringDamper,
};
use percuss_spatial::{Matrix3, Transform, Vector3, rotation_from_rpy};

fn body(i: usize) -> LinkDescription {
    let x = 1.0 + i as f64 / 3.0;
    let r = rotation_from_rpy([x, -0.4, 0.1 * x]);
    let about_com = r * Matrix3::from_diagonal(&Vector3::new(0.1 * x, 0.2 * x, 0.25 * x)) * r.transpose();
    let about_com = (about_com + about_com.transpose()) * 0.5;
    LinkDescription::new(
        format!("b{i} <\"&'>\té"),
        Inertial { mass: x, com: Vector3::new(0.1, -x, 1e-7), about_com },
    )
}

/// Chain with every kind of joint, with rotated frames, armatures and a mimic.
fn every_joint() -> Mechanism {
    let mut builder = MechanismBuilder::new("all & every").link(LinkDescription::massless("base"));
    let mut parent = "base".to_owned();
    for (i, kind) in JointKind::ALL.into_iter().enumerate() {
        let link = body(i);
        let origin = Transform::new(
            rotation_from_rpy([0.3, 1.2 * i as f64, -2.0]),
            Vector3::new(1e-300, 1.0 / 3.0, 2e22),
        );
        let mut joint = JointDescription::new(kind.name(), kind, parent, &link.name)
            .origin(origin)
            .axis([0.6, 0.0, -0.8]);
        joint.independent = [None, Some(true), Some(false)][i % 3];
        joint.armature = (0..kind.dofs()).map(|d| 0.1 / (1.0 + d as f64)).collect();
        if kind.dofs() == 1 {
            joint.spring = Some(SpringDamper { stiffness: 1.0 / 3.0, damping: 2e-9, reference: -0.7 });
            joint.gear = Some(ElasticGear { stiffness: 9e4, damping: 1.0 / 7.0 });
        }
        if kind == JointKind::Prismatic {
            joint.limits = Some(Limits { lower: -1.0 / 3.0, upper: 1e-9 });
            joint = joint.mimic("revolute", -2.0 / 3.0, 0.1);
        }
        parent = link.name.clone();
        builder = builder.link(link).joint(joint);
    }
    builder.build().unwrap_or_else(|e| panic!("{e}")).mechanism
}

#[test]
fn every_joint_comes_back() {
    let before = every_joint();
    let text = write_urdf(&before);
    let loaded = load_text(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let after = &loaded.mechanism;
    assert_eq!(after.name(), before.name());
    assert_eq!(after.joints().len(), JointKind::ALL.len());
    for (a, b) in after.joints().iter().zip(before.joints()) {
        assert_eq!((a.name(), a.kind(), a.parent(), a.child()), (b.name(), b.kind(), b.parent(), b.child()));
        // Decimals are exact to the last bit, even for very small and very large numbers.
        assert_eq!(a.origin().translation, b.origin().translation);
        assert_eq!((a.limits(), a.armature(), a.mimic()), (b.limits(), b.armature(), b.mimic()));
        assert_eq!((a.spring(), a.gear()), (b.spring(), b.gear()));
        assert_eq!((a.axis(), a.independent()), (b.axis(), b.independent()));
        // Rotations pass through three angles.
        assert_relative_eq!(a.origin().rotation, b.origin().rotation, epsilon = 2e-15);
    }
    for (a, b) in after.links().iter().zip(before.links()) {
        assert_eq!((a.name(), a.has_inertial()), (b.name(), b.has_inertial()));
        assert_eq!((a.inertial(), a.inertia()), (b.inertial(), b.inertia()));
    }
}

#[test]
fn urdf_rs_reads_what_is_written() {
    let robot = urdf_rs::read_from_string(&write_urdf(&every_joint())).unwrap();
    assert_eq!((robot.links.len(), robot.joints.len()), (JointKind::ALL.len() + 1, JointKind::ALL.len()));
}

/// All numbers agree with urdf-rs to the last bit.
#[test]
fn numbers_are_those_of_urdf_rs() {
    let text = write_urdf(&every_joint());
    let theirs = urdf_rs::read_from_string(&text).unwrap();
    let ours = load_text(&text).unwrap_or_else(|e| panic!("{e}")).mechanism;
    let mut inertias = 0;
    assert_eq!((theirs.links.len(), theirs.joints.len()), (ours.links().len(), ours.joints().len()));
    for (link, found) in theirs.links.iter().zip(ours.links()) {
        let Some(inertial) = found.inertial() else { continue };
        assert_eq!(inertial.mass, link.inertial.mass.value);
        assert_eq!(inertial.com.as_slice(), &link.inertial.origin.xyz.0);
        inertias += 1;
    }
    let (mut limits, mut mimics) = (0, 0);
    for (joint, found) in theirs.joints.iter().zip(ours.joints()) {
        assert_eq!(found.origin().translation.as_slice(), &joint.origin.xyz.0);
        if let Some(own) = found.limits() {
            assert_eq!((own.lower, own.upper), (joint.limit.lower, joint.limit.upper));
            limits += 1;
        }
        if let (Some(own), Some(mimic)) = (found.mimic(), &joint.mimic) {
            assert_eq!(Some(own.multiplier), mimic.multiplier);
            assert_eq!(Some(own.offset), mimic.offset);
            mimics += 1;
        }
    }
    assert!(inertias > 3 && limits > 0 && mimics > 0, "{inertias} {limits} {mimics}");
}

/// Two arms and a rotor; a closure of every kind between the arms and to the world, a gear, and two second parents.
fn every_closure() -> Mechanism {
    let frame = |i: usize| {
        let x = i as f64 / 3.0;
        Transform::new(rotation_from_rpy([x, -1.3 * x, 2.0 - x]), Vector3::new(x, 1e-7, -1.0 / 7.0))
    };
    let hinge = |name: &str, child: &str| JointDescription::new(name, JointKind::Continuous, "base", child);
    let mut builder = MechanismBuilder::new("every closure")
        .link(LinkDescription::massless("base"))
        .link(body(0))
        .link(body(1))
        .link(LinkDescription::massless("rotor"))
        .joint(hinge("left", &body(0).name))
        .joint(hinge("second", "rotor").axis([0.6, 0.0, -0.8]))
        .joint(hinge("right", &body(1).name))
        .joint(hinge("third", &body(1).name).axis([0.6, 0.0, -0.8]).origin(frame(5)))
        .joint(JointDescription::new("fourth", JointKind::Planar, "rotor", body(0).name).at([0.1, 0.2, 0.3]));
    for (i, kind) in ClosureKind::ALL.into_iter().enumerate() {
        let successor = if i % 3 == 0 { "world".to_owned() } else { body(1).name };
        let name = format!("{} <&\">", kind.name());
        builder = builder.closure(ClosureDescription {
            predecessor_frame: frame(i),
            successor_frame: frame(2 * i),
            distance: (i % 2 == 1).then_some(1.0 / 3.0),
            ..ClosureDescription::new(name, kind, body(0).name, successor)
                .axis([0.0, 3.0, 4.0])
                .axis2([-2.0, 0.1, 0.0])
        });
    }
    let free = ClosureDescription::new("free length", ClosureKind::Distance, "rotor", "world")
        .at([1.0; 3], [0.0; 3]);
    let gear = CouplingDescription {
        name: "gear".into(),
        predecessor: body(1).name,
        successor: "rotor".into(),
        ratio: -19.0 / 3.0,
    };
    builder.closure(free).coupling(gear).build().unwrap_or_else(|e| panic!("{e}")).mechanism
}

#[test]
fn every_closure_comes_back() {
    let before = every_closure();
    let text = write_urdf(&before);
    let loaded = load_text(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let after = &loaded.mechanism;
    let kinds: Vec<ClosureKind> = before.closures().iter().map(|c| c.kind()).collect();
    assert!(ClosureKind::ALL.iter().all(|kind| kinds.contains(kind)));
    assert_eq!(kinds.len(), ClosureKind::ALL.len() + 3);
    // Joints to second parents have become loops.
    assert_eq!(before.closures().last().unwrap().name(), "fourth");
    assert_eq!((after.joints().len(), after.closures().len()), (before.joints().len(), kinds.len()));
    assert!(loaded.diagnostics.iter().all(|d| d.code != "second-parent"));
    for (a, b) in after.closures().iter().zip(before.closures()) {
        assert_eq!((a.name(), a.kind(), a.distance()), (b.name(), b.kind(), b.distance()));
        assert_eq!((a.axis(), a.axis2()), (b.axis(), b.axis2()), "{}", a.name());
        for (a, b) in [(a.predecessor(), b.predecessor()), (a.successor(), b.successor())] {
            assert_eq!((a.link, a.frame.translation), (b.link, b.frame.translation));
            assert_relative_eq!(a.frame.rotation, b.frame.rotation, epsilon = 2e-15);
        }
    }
    assert_eq!(after.couplings().len(), 1);
    let (a, b) = (&after.couplings()[0], &before.couplings()[0]);
    assert_eq!((a.name(), a.ratio(), a.terms()), (b.name(), b.ratio(), b.terms()));
}

#[test]
fn comments_stand_above_what_they_are_about() {
    let mechanism = every_closure();
    let named = |name: &str, text: &str| [(name.to_owned(), text.to_owned())].into();
    let comments = Comments {
        heading: vec![
            "a -- b --- c --> <robot>-".into(),
            String::new(),
            "-two\nlines\u{0}\u{ffff}\u{7}é".into(),
        ],
        links: named("rotor", "the rotor"),
        joints: named("left", "the left -"),
        closures: [("gear".to_owned(), "the gear".to_owned()), ("third".to_owned(), "the third".to_owned())]
            .into(),
        known: Vec::new(),
    };
    let text = write_urdf_with(&mechanism, &comments);
    load_text(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let bare: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("<!--")).collect();
    assert_eq!(bare, write_urdf(&mechanism).lines().collect::<Vec<_>>());
    for pair in [
        "<!-- a - - b - - - c - -> <robot>- -->\n<!--  -->\n<!-- -two lines \u{fffd} é -->\n<robot",
        "  <!-- the rotor -->\n  <link name=\"rotor\"/>",
        "  <!-- the left - -->\n  <joint name=\"left\"",
        "  <!-- the third -->\n  <loop name=\"third\"",
        "  <!-- the gear -->\n  <coupling name=\"gear\"",
    ] {
        assert!(text.contains(pair), "{pair}\nis not in\n{text}");
    }
    assert_eq!(text.matches("<!--").count(), 7);
}
