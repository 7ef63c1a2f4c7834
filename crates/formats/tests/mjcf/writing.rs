//! The writer: what is written is read as the same mechanism.

use super::{load_mjcf, model};
use approx::assert_relative_eq;
use percuss_formats::{balance_inertia, load_file, write_mjcf};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};

fn written(mechanism: &Mechanism) -> String {
    write_mjcf(mechanism, "").unwrap_or_else(|error| panic!("{error}")).text
}

#[test]
fn models_in_mjcf_are_reproduced() {
    let text = model(
        "<body name=\"f\" pos=\"1 2 3\" euler=\"1 0 0\"><freejoint name=\"free\"/><geom size=\".1\"/>
           <body name=\"a\" pos=\"0 0 1\"><joint name=\"x\" type=\"slide\" axis=\"1 0 0\" armature=\"0.5\"/>
             <joint name=\"turn\" pos=\"0.5 0 0\" range=\"-1 1\"/><geom type=\"box\" size=\".1 .2 .3\"/><site name=\"s\" pos=\"0 1 0\"/></body></body>
         <body name=\"b\"><joint name=\"ball\" type=\"ball\" pos=\"0 0 1\"/><geom size=\".1\"/><site name=\"t\"/></body>",
        "<equality><connect name=\"c\" body1=\"a\" body2=\"b\" anchor=\"0 0 0\"/><weld name=\"w\" site1=\"s\" site2=\"t\"/>
           <tendon name=\"rod\" tendon1=\"rod\"/></equality>
         <tendon><spatial name=\"rod\"><site site=\"s\"/><site site=\"t\"/></spatial></tendon>",
    );
    let first = load_mjcf(&text).unwrap().mechanism;
    let second = load_mjcf(&written(&first)).unwrap_or_else(|error| panic!("{error}")).mechanism;
    let names = |mechanism: &Mechanism| {
        let links = mechanism.links().iter().map(|link| link.name().to_owned());
        let joints = mechanism.joints().iter().map(|joint| format!("{} {:?}", joint.name(), joint.kind()));
        let closures =
            mechanism.closures().iter().map(|closure| format!("{} {:?}", closure.name(), closure.kind()));
        links.chain(joints).chain(closures).collect::<Vec<_>>()
    };
    assert_eq!(names(&first), names(&second));
    for (one, two) in first.joints().iter().zip(second.joints()) {
        assert_relative_eq!(one.origin().translation, two.origin().translation, epsilon = 1e-15);
        assert_relative_eq!(one.origin().rotation, two.origin().rotation, epsilon = 1e-15);
        assert_relative_eq!(*one.axis(), *two.axis(), epsilon = 1e-15);
        assert_eq!((one.armature(), one.limits()), (two.armature(), two.limits()));
    }
    for (one, two) in first.closures().iter().zip(second.closures()) {
        assert_relative_eq!(
            one.successor().frame.translation,
            two.successor().frame.translation,
            epsilon = 1e-15
        );
        assert_eq!(one.distance().is_some(), two.distance().is_some());
    }
    for (one, two) in first.links().iter().zip(second.links()) {
        assert_eq!(one.inertial(), two.inertial());
    }
}

/// Two bars on hinges, with a closure between them.
fn two_bars(kind: ClosureKind, mass: f64) -> Mechanism {
    let bar = Inertial::diagonal(mass, [0.5, 0.0, 0.0], [0.01 * mass, 0.1 * mass, 0.1 * mass]);
    let hinge = |name: &str, child: &str| {
        JointDescription::new(name, JointKind::Continuous, "ground", child).axis([0.0, 0.0, 1.0])
    };
    let end = if kind == ClosureKind::Distance { [0.5, 0.3, 0.0] } else { [0.5, 0.0, 0.0] };
    let closure = ClosureDescription::new("loop", kind, "first", "second").at([1.0, 0.0, 0.0], end);
    let built = MechanismBuilder::new("bars")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("first", bar))
        .link(LinkDescription::new("second", bar))
        .joint(hinge("one", "first"))
        .joint(hinge("two", "second").at([0.5, 0.0, 0.0]))
        .closure(closure)
        .build();
    built.unwrap().mechanism
}

#[test]
fn every_closure_is_written() {
    for kind in ClosureKind::ALL {
        let text = written(&two_bars(kind, 2.0));
        let read = load_mjcf(&text).unwrap_or_else(|error| panic!("{kind:?}: {error}\n{text}")).mechanism;
        assert_relative_eq!(read.total_mass(), 4.0, epsilon = 1e-14);
        let kinds: Vec<ClosureKind> = read.closures().iter().map(|closure| closure.kind()).collect();
        let expected = match kind {
            ClosureKind::Spherical => vec![ClosureKind::Spherical],
            ClosureKind::Revolute => vec![ClosureKind::Spherical; 2],
            ClosureKind::Distance => vec![ClosureKind::Distance],
            _ => vec![ClosureKind::Fixed],
        };
        assert_eq!(kinds, expected, "{kind:?}");
    }
}

#[test]
fn links_that_mujoco_refuses_are_named() {
    let massless = MechanismBuilder::new("m")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::massless("tip"))
        .joint(JointDescription::new("hinge", JointKind::Continuous, "ground", "tip"));
    let error = write_mjcf(&massless.build().unwrap().mechanism, "").unwrap_err();
    assert_eq!(error.element, "link \"tip\"");
    assert!(error.to_string().contains("without mass"), "{error}");
    let flat = MechanismBuilder::new("m")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("disc", Inertial::diagonal(1.0, [0.0; 3], [1.0, 1.0, 4.0])))
        .link(LinkDescription::massless("tip"))
        .joint(JointDescription::new("hinge", JointKind::Continuous, "ground", "disc"))
        .joint(JointDescription::new("end", JointKind::Continuous, "disc", "tip"));
    let error = write_mjcf(&flat.build().unwrap().mechanism, "").unwrap_err();
    assert!(error.to_string().contains("A + B < C"), "{error}");
    assert!(error.to_string().ends_with("; also refused: link \"tip\""), "{error}");
    // The inertia of an immovable link is left out. For a link that is fixed to a moving link, such moments are an error.
    for (kind, at_rest) in [(JointKind::Fixed, true), (JointKind::Continuous, false)] {
        let arm = Inertial::diagonal(1.0, [0.0; 3], [1.0; 3]);
        let mechanism = MechanismBuilder::new("m")
            .link(LinkDescription::massless("ground"))
            .link(LinkDescription::new("arm", arm))
            .link(LinkDescription::new("disc", Inertial::diagonal(1.0, [0.0; 3], [1.0, 1.0, 4.0])))
            .joint(JointDescription::new("first", kind, "ground", "arm"))
            .joint(JointDescription::new("second", JointKind::Fixed, "arm", "disc"))
            .build()
            .unwrap()
            .mechanism;
        match write_mjcf(&mechanism, "") {
            Ok(file) => assert!(at_rest && file.changes.iter().any(|change| change.what == "its inertia")),
            Err(error) => assert!(!at_rest && error.element == "link \"disc\"", "{error}"),
        }
    }
}

#[test]
fn small_moments_are_written_as_principal_moments() {
    // MuJoCo's eigenvalue iteration stops at off-diagonal entries of 1e-12 kg·m².
    let small = MechanismBuilder::new("m")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("tip", Inertial::diagonal(1e-4, [0.0; 3], [1e-13; 3])))
        .joint(JointDescription::new("slide", JointKind::Prismatic, "ground", "tip").axis([1.0, 0.0, 0.0]));
    let text = written(&small.build().unwrap().mechanism);
    assert!(text.contains(" diaginertia=") && !text.contains("fullinertia"), "{text}");
}

#[test]
fn shipped_models_are_written_or_refused_by_name() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models");
    let (mut count, mut refused) = (0, Vec::new());
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|ending| ending != "urdf") {
            continue;
        }
        let mechanism = load_file(&path.to_string_lossy()).unwrap().mechanism;
        match write_mjcf(&mechanism, "") {
            Ok(file) => {
                let read =
                    load_mjcf(&file.text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
                assert_relative_eq!(
                    read.mechanism.total_mass(),
                    mechanism.total_mass(),
                    max_relative = 1e-14
                );
                count += 1;
            }
            Err(error) => refused.push(format!("{}: {error}", path.display())),
        }
    }
    assert!(count >= 13, "{count} written; {refused:#?}");
}

/// The nearest moments with A + B = C differ by a third of the excess.
#[test]
fn moments_are_balanced_on_request() {
    let of_moments = |moments: [f64; 3]| {
        let disc = Inertial::diagonal(2.0, [0.1, 0.0, 0.0], moments);
        let built = MechanismBuilder::new("m")
            .link(LinkDescription::massless("ground"))
            .link(LinkDescription::new("disc", disc))
            .joint(JointDescription::new("hinge", JointKind::Continuous, "ground", "disc"));
        built.build().unwrap().mechanism
    };
    for excess in [1e-13, 1e-11, 1e-6, 0.3, 2.0] {
        let mechanism = of_moments([1.0, 1.0 + excess + 2.0, 2.0]);
        // An excess by rounding is removed in any case.
        assert_eq!(write_mjcf(&mechanism, "").is_ok(), excess < 1e-10, "{excess}");
        let (balanced, changes) = balance_inertia(&mechanism).unzip();
        let written =
            write_mjcf(balanced.as_ref().unwrap_or(&mechanism), "").unwrap_or_else(|error| panic!("{error}"));
        let read = load_mjcf(&written.text).unwrap().mechanism;
        let found = read.links().last().unwrap().inertial().unwrap();
        let third = excess / 3.0;
        for (k, expected) in [1.0 + third, 3.0 + excess - third, 2.0 + third].into_iter().enumerate() {
            assert_relative_eq!(found.about_com[(k, k)], expected, max_relative = 1e-11);
        }
        assert!(found.about_com[(1, 1)] <= found.about_com[(0, 0)] + found.about_com[(2, 2)]);
        let changes = changes.unwrap_or_default();
        assert_eq!(changes.iter().any(|change| change.what.contains("moments")), excess > 1e-10);
        assert!(written.changes.iter().all(|change| !change.what.contains("principal")));
    }
}

/// A massless rotor that follows a joint is an armature of the tendon over it: J N², whatever the joints before it.
#[test]
fn rotors_become_armatures() {
    let arm = Inertial::diagonal(2.0, [0.1, 0.0, 0.0], [1.0; 3]);
    let z = [0.0, 0.0, 1.0];
    let hinge = |name: &str, parent: &str, child: &str| {
        JointDescription::new(name, JointKind::Continuous, parent, child).axis(z)
    };
    let geared = JointDescription { armature: vec![0.01], ..hinge("gear", "arm", "rotor") };
    let built = MechanismBuilder::new("m")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("arm", arm))
        .link(LinkDescription::new("hand", arm))
        .link(LinkDescription::massless("rotor"))
        .joint(hinge("first", "ground", "arm"))
        .joint(hinge("second", "arm", "hand"))
        .joint(geared.mimic("second", -50.0, 0.0));
    let file = write_mjcf(&built.build().unwrap().mechanism, "").unwrap();
    assert!(
        file.text.contains(
            "<fixed name=\"gear\" armature=\"0.01\">\n      <joint joint=\"second\" coef=\"-50\"/>"
        ),
        "{}",
        file.text
    );
    assert!(!file.text.contains("body name=\"rotor\"") && !file.text.contains("joint1=\"gear\""));
    assert!(file.changes.iter().any(|change| change.element == "link \"rotor\""));
}
