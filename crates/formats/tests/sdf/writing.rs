//! The writer: what is written is read as the same mechanism.

use super::{axis, joint, link, load_sdf, model, read};
use approx::assert_relative_eq;
use percuss_formats::{load_file, write_sdf};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, CouplingDescription, Inertial, JointDescription, JointKind,
    LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::Transform;

fn written(mechanism: &Mechanism) -> String {
    write_sdf(mechanism, "").unwrap_or_else(|error| panic!("{error}")).text
}

/// Joints, links and closures that both mechanisms must have, with equal numbers.
fn assert_same(first: &Mechanism, second: &Mechanism) {
    let names = |mechanism: &Mechanism| {
        let links = mechanism.links().iter().map(|link| link.name().to_owned());
        let joints = mechanism.joints().iter().map(|joint| format!("{} {:?}", joint.name(), joint.kind()));
        let closures =
            mechanism.closures().iter().map(|closure| format!("{} {:?}", closure.name(), closure.kind()));
        links.chain(joints).chain(closures).collect::<Vec<_>>()
    };
    assert_eq!(names(first), names(second));
    let assert_close = |one: &Transform<f64>, two: &Transform<f64>| {
        assert_relative_eq!(one.translation, two.translation, epsilon = 4e-15);
        assert_relative_eq!(one.rotation, two.rotation, epsilon = 4e-15);
    };
    for (one, two) in first.joints().iter().zip(second.joints()) {
        assert_close(one.origin(), two.origin());
        assert_relative_eq!(*one.axis(), *two.axis(), epsilon = 4e-15);
        assert_eq!((one.armature(), one.limits()), (two.armature(), two.limits()));
        let mimic = |joint: &percuss_mechanism::Joint, of: &Mechanism| {
            joint.mimic().map(|mimic| (of.joint(mimic.master).name().to_owned(), mimic.offset))
        };
        assert_eq!(mimic(one, first), mimic(two, second));
    }
    for (one, two) in first.closures().iter().zip(second.closures()) {
        assert_close(&one.predecessor().frame, &two.predecessor().frame);
        assert_close(&one.successor().frame, &two.successor().frame);
    }
    for (one, two) in first.links().iter().zip(second.links()) {
        assert_eq!(one.inertial(), two.inertial());
    }
}

#[test]
fn models_in_sdformat_are_reproduced() {
    let two = |second: &str| {
        format!(
            "{}<axis2><xyz>{second}</xyz></axis2>",
            axis("1 0 0", "<limit><lower>-1</lower><upper>2</upper></limit>")
        )
    };
    let names = ["a", "b", "c", "d", "e", "f", "g"];
    let links: String = names
        .iter()
        .enumerate()
        .map(|(i, name)| link(name, &format!("<pose>{i} 1 0 0.1 0.2 {i}</pose>")))
        .collect();
    let mimic = "<mimic joint=\"jd\" axis=\"axis2\"><multiplier>-2</multiplier><offset>0.5</offset></mimic>";
    let joints = [
        joint("ja", "fixed", "world", "a", ""),
        joint("jb", "revolute", "a", "b", &format!("<pose>0 0.5 0 0.3 0 0</pose>{}", axis("0 1 0", mimic))),
        joint("jc", "prismatic", "b", "c", &axis("0 1 1", "")),
        joint("jd", "universal", "c", "d", &format!("<pose>0 0 0.25 0 0 0.7</pose>{}", two("0 1 0"))),
        joint("je", "revolute2", "d", "e", &two("1 1 0")),
        joint(
            "jf",
            "screw",
            "e",
            "f",
            &format!("<screw_thread_pitch>0.5</screw_thread_pitch>{}", axis("0 0 1", "")),
        ),
        joint("jg", "ball", "f", "g", "<pose>0 0 1 0 0 0</pose>"),
        joint("loop", "universal", "b", "g", &format!("<pose>1 0 0 0 0.4 0</pose>{}", two("0 1 0"))),
        joint("weld", "fixed", "c", "e", "<pose>1 0 2 0 0 0</pose>"),
    ];
    let text = model(
        11,
        &format!(
            "{links}<frame name=\"tool\" attached_to=\"e\"><pose relative_to=\"e\">0 0 1 1 0 0</pose></frame>{}",
            joints.concat()
        ),
    );
    let first = read(&text).mechanism;
    let again = written(&first);
    let second = load_sdf(&again).unwrap_or_else(|error| panic!("{error}\n{again}")).mechanism;
    assert_same(&first, &second);
}

/// Two bars on hinges, with a closure between them.
fn two_bars(closure: ClosureDescription) -> Mechanism {
    let bar = Inertial::diagonal(2.0, [0.5, 0.0, 0.0], [0.02, 0.2, 0.2]);
    let hinge = |name: &str, child: &str| {
        JointDescription::new(name, JointKind::Continuous, "ground", child).axis([0.0, 0.0, 1.0])
    };
    let built = MechanismBuilder::new("bars")
        .link(LinkDescription::new("ground", bar))
        .link(LinkDescription::new("first", bar))
        .link(LinkDescription::new("second", bar))
        .joint(hinge("one", "first"))
        .joint(hinge("two", "second").at([0.5, 0.0, 0.0]))
        .closure(closure)
        .build();
    built.unwrap().mechanism
}

#[test]
fn closures_are_written_or_refused_by_name() {
    for kind in ClosureKind::ALL {
        let closure =
            ClosureDescription::new("loop", kind, "first", "second").at([1.0, 0.0, 0.0], [0.5, 0.0, 0.0]);
        let mechanism = two_bars(closure);
        match kind {
            ClosureKind::Cylindrical | ClosureKind::Planar | ClosureKind::Distance => {
                let error = write_sdf(&mechanism, "").unwrap_err();
                assert_eq!(error.element, "loop \"loop\"");
                assert!(error.reason.contains(kind.name()), "{error}");
            }
            _ => {
                let read = read(&written(&mechanism)).mechanism;
                let kinds: Vec<ClosureKind> = read.closures().iter().map(|closure| closure.kind()).collect();
                assert_eq!(kinds, [kind]);
            }
        }
    }
    let open = ClosureDescription::new("loop", ClosureKind::Spherical, "first", "second")
        .at([1.0, 0.0, 0.0], [0.4, 0.0, 0.0]);
    assert!(write_sdf(&two_bars(open), "").unwrap_err().reason.contains("open by 1.0e-1"));
    // The world as the successor.
    let turned = ClosureDescription {
        successor_frame: Transform::identity(),
        ..ClosureDescription::new("loop", ClosureKind::Spherical, "first", "world")
    };
    let read = read(&written(&two_bars(turned))).mechanism;
    assert_eq!(
        read.closures()[0].predecessor().link.map(|link| read.link(link).name().to_owned()),
        Some("world".to_owned())
    );
}

#[test]
fn couplings_become_mimics() {
    let bar = Inertial::diagonal(2.0, [0.5, 0.0, 0.0], [0.02, 0.2, 0.2]);
    let hinge = |name: &str, parent: &str, child: &str| {
        JointDescription::new(name, JointKind::Continuous, parent, child).axis([0.0, 0.0, 1.0])
    };
    let built = |successor: &str| {
        MechanismBuilder::new("gears")
            .link(LinkDescription::massless("world"))
            .link(LinkDescription::new("a", bar))
            .link(LinkDescription::new("b", bar))
            .link(LinkDescription::new("c", bar))
            .joint(hinge("ja", "world", "a").armature(0.25))
            .joint(hinge("jb", "world", "b"))
            .joint(hinge("jc", "b", "c"))
            .coupling(CouplingDescription {
                name: "gear".to_owned(),
                predecessor: "a".to_owned(),
                successor: successor.to_owned(),
                ratio: -3.0,
            })
            .build()
            .unwrap()
            .mechanism
    };
    let text = written(&built("b"));
    assert!(
        text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<sdf version=\"1.11\" xmlns:drake="),
        "{text}"
    );
    let read = read(&text).mechanism;
    let mimic = super::find(&read, "jb").mimic().expect("a mimic");
    assert_eq!((read.joint(mimic.master).name(), mimic.multiplier), ("ja", -3.0));
    assert_eq!(super::find(&read, "ja").armature(), [0.25]);
    assert_eq!(write_sdf(&built("c"), "").unwrap_err().element, "coupling \"gear\"");
}

#[test]
fn parts_without_a_form_are_refused_by_name() {
    let bar = Inertial::diagonal(2.0, [0.5, 0.0, 0.0], [0.02, 0.2, 0.2]);
    let with = |joint: JointDescription| {
        let builder = MechanismBuilder::new("m")
            .link(LinkDescription::massless("world"))
            .link(LinkDescription::new("a", bar));
        builder.joint(joint).build().unwrap().mechanism
    };
    let planar = with(JointDescription::new("slab", JointKind::Planar, "world", "a"));
    assert_eq!(write_sdf(&planar, "").unwrap_err().element, "joint \"slab\"");
    let geared = with(JointDescription::new("ball", JointKind::Spherical, "world", "a").armature(1.0));
    assert!(write_sdf(&geared, "").unwrap_err().reason.contains("armature"));
    let floating = with(JointDescription::new("free", JointKind::Floating, "world", "a").at([0.0, 0.0, 1.0]));
    assert_eq!(read(&written(&floating)).mechanism.joints()[0].kind(), JointKind::Floating);
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
        match write_sdf(&mechanism, "") {
            Ok(file) => {
                let read = load_sdf(&file.text)
                    .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
                    .mechanism;
                let moving = |mechanism: &Mechanism| {
                    mechanism.joints().iter().map(|joint| joint.kind().dofs()).sum::<usize>()
                };
                assert_eq!(moving(&read), moving(&mechanism), "{}", path.display());
                count += 1;
            }
            Err(error) => refused.push(format!("{}: {error}", path.display())),
        }
    }
    assert!(count >= 14, "{count} written; {refused:#?}");
    // The refusal names a loop or a coupling, such as the relation of the cam in `valve_train.urdf`.
    let is_named = |refusal: &String| refusal.contains(": loop \"") || refusal.contains(": coupling \"");
    assert!(refused.iter().all(is_named), "{refused:#?}");
}

/// A loop whose successor is the root link with the name of the world: the world is the parent of the joint, since SDFormat refuses it as a
/// child.
#[test]
fn loops_to_the_root_have_the_world_as_parent() {
    let body = |name: &str| LinkDescription::new(name, Inertial::diagonal(1.0, [0.1, 0.0, 0.0], [0.1; 3]));
    let mechanism = MechanismBuilder::new("m")
        .link(LinkDescription::massless("world"))
        .link(body("a"))
        .link(body("b"))
        .joint(JointDescription::new("first", JointKind::Continuous, "world", "a").axis([0.0, 0.0, 1.0]))
        .joint(
            JointDescription::new("second", JointKind::Continuous, "a", "b")
                .axis([0.0, 0.0, 1.0])
                .origin(Transform::from_translation([1.0, 0.0, 0.0].into())),
        )
        .closure(ClosureDescription {
            successor_frame: Transform::from_translation([2.0, 0.0, 0.0].into()),
            predecessor_frame: Transform::from_translation([1.0, 0.0, 0.0].into()),
            ..ClosureDescription::new("pin", ClosureKind::Spherical, "b", "world")
        })
        .build()
        .unwrap()
        .mechanism;
    let text = written(&mechanism);
    let again = load_sdf(&text).unwrap_or_else(|error| panic!("{error}: {text}")).mechanism;
    assert_eq!(again.closures().len(), 1, "{text}");
    assert!(text.contains("<parent>world</parent>\n      <child>b</child>"), "{text}");
}

/// Readers remove blanks at the ends of texts, so a name that begins or ends with one is changed, and a name without blanks stays.
#[test]
fn names_with_blanks_at_their_ends_are_changed() {
    let bar = Inertial::diagonal(1.0, [0.0; 3], [1.0; 3]);
    let names = [" lead", "lead", "\tend\n", "world ", " "];
    let mut builder = MechanismBuilder::new("m").link(LinkDescription::massless("world"));
    for (i, name) in names.iter().enumerate() {
        let parent = if i == 0 { "world" } else { names[i - 1] };
        builder = builder.link(LinkDescription::new(*name, bar)).joint(JointDescription::new(
            format!("{name}j "),
            JointKind::Continuous,
            parent,
            *name,
        ));
    }
    let file = write_sdf(&builder.build().unwrap().mechanism, "").unwrap_or_else(|error| panic!("{error}"));
    let read = read(&file.text).mechanism;
    let links: Vec<&str> = read.links().iter().map(|link| link.name()).collect();
    assert_eq!(links, ["world", "lead_2", "lead", "end", "renamed_world", "renamed_"]);
    assert_eq!(read.joints().len(), names.len());
    let changed = |name: &str| file.changes.iter().any(|change| change.element == format!("link \"{name}\""));
    assert_eq!(names.map(changed), [true, false, true, true, true]);
}
