//! What is written is read back as it was.

mod support;

use approx::assert_relative_eq;
use percuss_formats::write_urdf;
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, Limits, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::{Matrix3, Transform, Vector3, rotation_from_rpy};
use support::load_text;

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

/// A chain with every kind of joint, turned and armoured, and a mimic.
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
        joint.armature = (0..kind.dofs()).map(|d| 0.1 / (1.0 + d as f64)).collect();
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
        // Decimals are exact to the last bit, also tiny and large ones.
        assert_eq!(a.origin().translation, b.origin().translation);
        assert_eq!((a.limits(), a.armature(), a.mimic()), (b.limits(), b.armature(), b.mimic()));
        assert_eq!(a.axis(), b.axis());
        // Through three angles and back.
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
