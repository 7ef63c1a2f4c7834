//! SDF joints in `<gazebo>`: complete joints are read as loops; others are refused, with the element and the line.

use crate::support::{changed, codes, told};
use percuss_formats::{LoadError, LoadOptions, Loaded, Source, load};
use percuss_mechanism::{ClosureKind, Severity};
use percuss_spatial::Vector3;

/// Pendulum at a height of 1 m, turned by 0.1 rad, with a `<gazebo>`.
fn with(gazebo: &str) -> Result<Loaded, LoadError> {
    changed(&[("rpy=\"0 0 0\"", "rpy=\"0 0.1 0\""), ("</robot>", &format!("{gazebo}\n</robot>"))])
}

fn joint(attributes: &str, inside: &str) -> Result<Loaded, LoadError> {
    with(&format!("<gazebo><joint {attributes}>{inside}</joint></gazebo>"))
}

const ENDS: &str = "<parent>base</parent><child>arm</child>";

#[test]
fn a_joint_is_placed_on_its_child_and_held_where_it_is_drawn() {
    let loaded = joint("name=\"pin\" type=\"revolute\"", &format!("<pose>0 0 -0.5 0 0 0</pose>{ENDS}"));
    let loaded = loaded.unwrap_or_else(|error| panic!("{error}"));
    let [closure] = loaded.mechanism.closures() else { panic!("one closure") };
    assert_eq!((closure.name(), closure.kind()), ("pin", ClosureKind::Revolute));
    assert_eq!(*closure.axis(), Vector3::z());
    let below = Vector3::new(0.0, 0.0, -0.5);
    assert!((closure.successor().frame.translation - below).norm() < 1e-15);
    let expected = Vector3::new(-0.5 * 0.1f64.sin(), 0.0, 1.0 - 0.5 * 0.1f64.cos());
    let off = closure.predecessor().frame.translation - expected;
    assert!(off.norm() < 1e-15, "{off}");
    assert!(codes(&Ok(loaded)).contains(&(Severity::Note, "gazebo-joint")));
}

/// A model with an unreadable loop must not be treated as a tree.
#[test]
fn what_cannot_be_read_is_refused() {
    let good = "name=\"pin\" type=\"revolute\"";
    let cases = [
        ("name=\"pin\" type=\"gearbox\"", ENDS.to_owned(), "<gearbox_reference_body>"),
        ("name=\"pin\" type=\"screw\"", ENDS.to_owned(), "<screw_thread_pitch>"),
        ("name=\"pin\"", ENDS.to_owned(), "universal, revolute2, fixed, screw and gearbox are read"),
        (good, "<child>arm</child>".to_owned(), "<parent>LINK</parent>"),
        (good, "<parent link=\"base\"/><child link=\"arm\"/>".to_owned(), "with the link's name as text"),
        (good, "<parent>base</parent><child>hand</child>".to_owned(), "\"hand\""),
        (good, format!("<pose>0 0 0</pose>{ENDS}"), "got 3"),
        (
            good,
            format!("<pose relative_to=\"moon\">0 0 0 0 0 0</pose>{ENDS}"),
            "the frame \"moon\" is not known",
        ),
        (good, format!("<pose rotation_format=\"matrix\">0 0 0 0 0 0</pose>{ENDS}"), "euler_rpy"),
        (good, format!("<pose rotation_format=\"quat_xyzw\">0 0 0 0 0 0 2</pose>{ENDS}"), "norm 2"),
        (good, format!("<axis><xyz>0 0 0</xyz></axis>{ENDS}"), "the axis is zero"),
        (good, format!("<axis><xyz>0 nan 0</xyz></axis>{ENDS}"), "not finite"),
        (good, format!("<axis><xyz expressed_in=\"moon\">0 1 0</xyz></axis>{ENDS}"), "\"moon\""),
        (
            good,
            format!(
                "<axis><xyz>0 1 0</xyz><use_parent_model_frame>tRUE</use_parent_model_frame></axis>{ENDS}"
            ),
            "neither true nor false",
        ),
        (good, format!("<axis><xyz>0 1 0</xyz><mimic joint=\"hinge\"/></axis>{ENDS}"), "<coupling>"),
        ("name=\"pin\" type=\"universal\"", format!("<axis><xyz>0 1 0</xyz></axis>{ENDS}"), "has no <axis2>"),
        (
            "name=\"pin\" type=\"universal\"",
            format!("<axis><xyz>0 1 0</xyz></axis><axis2><xyz>0 1 1</xyz></axis2>{ENDS}"),
            "right angles",
        ),
        (good, "<parent>arm</parent><child>arm</child>".to_owned(), "to itself"),
        (good, format!("<pose>0 0 0 0 0 0</pose><pose>0 0 1 0 0 0</pose>{ENDS}"), "a second <pose>"),
        (good, "<parent>world</parent><child>base</child>".to_owned(), "root"),
    ];
    for (attributes, inside, said) in cases {
        let loaded = joint(attributes, &inside);
        assert!(loaded.is_err(), "{attributes} {inside}");
        let errors = told(&loaded).iter().filter(|d| d.severity == Severity::Error);
        let errors: Vec<_> = errors.collect();
        assert!(errors.iter().any(|d| d.message.contains(said)), "{attributes} {inside}: {errors:?}");
        assert!(errors.iter().all(|d| d.line.is_some() && d.element.is_some()), "{errors:?}");
    }
    let elsewhere = with(&format!("<gazebo reference=\"arm\"><joint {good}>{ENDS}</joint></gazebo>"));
    assert!(told(&elsewhere)[0].message.contains("no attribute \"reference\""), "{:?}", told(&elsewhere));
    let twice = format!("<joint {good}>{ENDS}</joint>");
    let twice = with(&format!("<gazebo>{twice}{twice}</gazebo>"));
    assert!(codes(&twice).contains(&(Severity::Error, "duplicate-name")), "{:?}", told(&twice));
}

/// A joint that fixes the root to the world acts like `--base fixed` and closes no loop.
#[test]
fn a_root_fixed_to_the_world_is_no_loop() {
    for ends in ["<parent>world</parent><child>base</child>", "<parent>base</parent><child>world</child>"] {
        let loaded = joint("name=\"foot\" type=\"fixed\"", ends).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(loaded.mechanism.closures().len(), 0);
        assert!(codes(&Ok(loaded)).contains(&(Severity::Note, "gazebo-joint")));
    }
}

/// The linkage `four_bar_split.urdf` of Gazebo's tutorial "kinematic loop", as URDF with a joint in a `<gazebo>` and as SDFormat.
fn four_bar(is_urdf: bool) -> Loaded {
    let inertia = |mass: f64, along: usize, length: f64| {
        let mut moments = [mass * (length * length + 0.0004) / 12.0; 3];
        moments[along] = mass * 0.0008 / 12.0;
        moments
    };
    let parts = [
        ("link_AB", 0.072, [-0.01, -0.15, 0.0], inertia(0.072, 1, 0.3)),
        ("link_BE", 0.024, [0.05, -0.01, 0.0], inertia(0.024, 0, 0.1)),
        ("link_EC", 0.024, [-0.05, -0.01, 0.0], inertia(0.024, 0, 0.1)),
        ("link_CD", 0.072, [0.01, -0.15, 0.0], inertia(0.072, 1, 0.3)),
    ];
    let joints = [
        ("joint_A", "world", "link_AB", [0.0, 0.0, 0.0]),
        ("joint_B", "link_AB", "link_BE", [0.0, -0.3, 0.0]),
        ("joint_D", "world", "link_CD", [0.2, 0.0, 0.0]),
        ("joint_C", "link_CD", "link_EC", [0.0, -0.3, 0.0]),
    ];
    let triple = |v: [f64; 3]| format!("{} {} {}", v[0], v[1], v[2]);
    let mut text = String::new();
    for (name, mass, com, [x, y, z]) in parts {
        text += &if is_urdf {
            format!(
                "<link name=\"{name}\"><inertial><origin xyz=\"{}\"/><mass value=\"{mass}\"/>
                 <inertia ixx=\"{x}\" iyy=\"{y}\" izz=\"{z}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>",
                triple(com)
            )
        } else {
            let (_, parent, _, at) = joints.iter().find(|joint| joint.2 == name).unwrap();
            let base = if *parent == "world" { "__model__" } else { parent };
            format!(
                "<link name=\"{name}\"><pose relative_to=\"{base}\">{} 0 0 0</pose><inertial><pose>{} 0 0 0</pose><mass>{mass}</mass>
                 <inertia><ixx>{x}</ixx><iyy>{y}</iyy><izz>{z}</izz></inertia></inertial></link>",
                triple(*at),
                triple(com)
            )
        };
    }
    for (name, parent, child, at) in joints {
        text += &if is_urdf {
            format!(
                "<joint name=\"{name}\" type=\"continuous\"><origin xyz=\"{}\"/><parent link=\"{parent}\"/><child link=\"{child}\"/>
                 <axis xyz=\"0 0 1\"/></joint>",
                triple(at)
            )
        } else {
            format!(
                "<joint name=\"{name}\" type=\"revolute\"><parent>{parent}</parent><child>{child}</child></joint>"
            )
        };
    }
    let weld = "<joint name=\"joint_E\" type=\"fixed\"><pose>-0.1 0 0 0 0 0</pose><parent>link_BE</parent><child>link_EC</child></joint>";
    let text = if is_urdf {
        format!("<robot name=\"r\"><link name=\"world\"/>{text}<gazebo>{weld}</gazebo></robot>")
    } else {
        format!("<sdf version=\"1.7\"><model name=\"r\">{text}{weld}</model></sdf>")
    };
    load(&Source::from_text("r", text), &LoadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Both spellings give the same loop.
#[test]
fn the_joint_of_gazebo_is_that_of_sdformat() {
    let [urdf, sdf] = [true, false].map(four_bar);
    let [one, two] = [&urdf, &sdf].map(|loaded| &loaded.mechanism.closures()[0]);
    assert_eq!((one.kind(), two.kind()), (ClosureKind::Fixed, ClosureKind::Fixed));
    for (a, b) in [(one.predecessor(), two.predecessor()), (one.successor(), two.successor())] {
        assert!((a.frame.translation - b.frame.translation).norm() < 1e-15, "{a:?} {b:?}");
    }
    assert!((one.predecessor().frame.translation - Vector3::new(0.1, 0.0, 0.0)).norm() < 1e-15);
}
