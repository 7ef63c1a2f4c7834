//! Included models.

use super::{axis, drawn_pose, find, joint, link};
use crate::support::{Folder, codes, told};
use approx::assert_relative_eq;
use percuss_mechanism::{JointKind, Severity};
use percuss_spatial::Vector3;

/// Library model `arm` of version 1.4 beside the main file: its axis is in the model frame.
fn library() -> Vec<(&'static str, String)> {
    let arm = format!(
        "<sdf version=\"1.4\"><model name=\"arm\"><pose>0 0 9 0 0 0</pose>{}{}{}</model></sdf>",
        link("base", ""),
        link("tip", "<pose>1 0 0 0 0 1.5707963267948966</pose>"),
        joint("elbow", "revolute", "base", "tip", &axis("1 0 0", ""))
    );
    let config =
        "<model><name>arm</name><sdf version=\"1.2\">old.sdf</sdf><sdf version=\"1.4\">new.sdf</sdf></model>";
    vec![("arm/new.sdf", arm), ("arm/model.config", config.to_owned())]
}

fn with_main(main: String) -> Vec<(&'static str, String)> {
    let mut files = library();
    files.push(("main/robot.sdf", main));
    files
}

#[test]
fn included_models_have_scopes_of_their_own() {
    let main = format!(
        "<sdf version=\"1.9\"><model name=\"robot\">{}
           <include><uri>model://arm</uri><name>left</name><pose relative_to=\"body\">0 1 0 0 0 0</pose></include>
           <include><uri>../arm/new.sdf</uri><name>right</name><placement_frame>tip</placement_frame><pose>0 -1 0 0 0 0</pose></include>
           {}{}</model></sdf>",
        link("body", "<pose>0 0 2 0 0 0</pose>"),
        joint("l", "fixed", "body", "left::base", ""),
        joint("r", "fixed", "body", "right::base", ""),
    );
    let folder = Folder::new("scopes", &with_main(main));
    let loaded = folder.load("main/robot.sdf").unwrap_or_else(|error| panic!("{error}"));
    let mechanism = &loaded.mechanism;
    let place = |link: &str| drawn_pose(mechanism, link).translation;
    // The pose of the include replaces that of the model.
    assert_relative_eq!(place("left::base"), Vector3::new(0.0, 1.0, 2.0), epsilon = 1e-15);
    assert_relative_eq!(place("left::tip"), Vector3::new(1.0, 1.0, 2.0), epsilon = 1e-15);
    assert_relative_eq!(place("right::tip"), Vector3::new(0.0, -1.0, 0.0), epsilon = 1e-15);
    // Version 1.4 in the included files alone.
    assert_relative_eq!(
        *find(mechanism, "left::elbow").axis(),
        Vector3::new(0.0, -1.0, 0.0),
        epsilon = 1e-15
    );
    assert_eq!(loaded.files.len(), 2);
    let expected = [(Severity::Warning, "equal-inertias"), (Severity::Note, "floating")];
    assert_eq!(codes(&Ok(loaded)), expected, "arms and body of the same mass");
}

#[test]
fn a_world_includes_models_and_changes_them() {
    let main = "<sdf version=\"1.6\"><world name=\"w\"><include><uri>model://arm</uri></include>
         <include><uri>model://arm</uri><name>held</name><static>true</static></include></world></sdf>";
    let folder = Folder::new("world", &with_main(main.to_owned()));
    let loaded = folder.load("main/robot.sdf").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(loaded.mechanism.name(), "arm");
    assert_eq!(drawn_pose(&loaded.mechanism, "base").translation.z, 9.0);
    let held = folder.load("main/robot.sdf#held").unwrap_or_else(|error| panic!("{error}"));
    assert!(held.mechanism.joints().iter().all(|joint| joint.kind() == JointKind::Fixed));
}

#[test]
fn a_merged_model_has_no_scope() {
    let main = format!(
        "<sdf version=\"1.9\"><model name=\"robot\">{}
           <include merge=\"true\"><uri>model://arm</uri><pose>0 0 1 0 0 0</pose></include>{}</model></sdf>",
        link("body", ""),
        joint("on_body", "fixed", "body", "base", "")
    );
    let folder = Folder::new("merged", &with_main(main));
    let loaded = folder.load("main/robot.sdf").unwrap_or_else(|error| panic!("{error}"));
    let names: Vec<&str> = loaded.mechanism.links().iter().map(|link| link.name()).collect();
    assert_eq!(names, ["world", "body", "base", "tip"]);
    assert_relative_eq!(
        drawn_pose(&loaded.mechanism, "tip").translation,
        Vector3::new(1.0, 0.0, 1.0),
        epsilon = 1e-15
    );
}

#[test]
fn a_model_of_models_is_merged_into_a_world() {
    let world = |model: &str| {
        format!(
            "<sdf version=\"1.10\"><world name=\"w\"><include merge=\"true\"><uri>set.sdf</uri><name>set</name></include></world></sdf>{model}"
        )
    };
    let set = |contents: &str| format!("<sdf version=\"1.10\"><model name=\"set\">{contents}</model></sdf>");
    let nested = format!(
        "<model name=\"one\"><pose>1 0 0 0 0 0</pose>{}</model><model name=\"two\">{}</model>{}",
        link("a", ""),
        link("b", ""),
        joint("pin", "revolute", "one::a", "two::b", &axis("0 0 1", ""))
    );
    let folder = Folder::new("merged-world", &[("main.sdf", world("")), ("set.sdf", set(&nested))]);
    let loaded = folder.load("main.sdf").unwrap_or_else(|error| panic!("{error}"));
    let names: Vec<&str> = loaded.mechanism.links().iter().map(|link| link.name()).collect();
    assert!(names.contains(&"one::a") && names.contains(&"two::b"), "{names:?}");
    assert_eq!(drawn_pose(&loaded.mechanism, "one::a").translation.x, 1.0);
    // Links of its own have no place in a world.
    let folder = Folder::new("merged-links", &[("main.sdf", world("")), ("set.sdf", set(&link("a", "")))]);
    let error = folder.load("main.sdf").expect_err("a refusal");
    assert!(error.diagnostics.iter().any(|d| d.code == "merged-links" && d.line.is_some()), "{error}");
}

#[test]
fn bad_includes_are_refused_where_they_are() {
    let include = |uri: &str| {
        format!(
            "<sdf version=\"1.9\">\n<model name=\"m\">\n<include><uri>{uri}</uri></include></model></sdf>"
        )
    };
    let files = [
        ("a.sdf", include("b.sdf")),
        ("b.sdf", include("a.sdf")),
        ("self.sdf", include("self.sdf")),
        ("absent.sdf", include("model://nothing/here.sdf")),
        ("remote.sdf", include("https://example.org/model")),
        ("urdf.sdf", include("robot.urdf")),
        ("robot.urdf", "<robot name=\"r\"><link name=\"a\"/></robot>".to_owned()),
        ("empty.sdf", include("")),
        ("broken.sdf", include("bad.sdf")),
        ("bad.sdf", "<sdf version=\"1.9\"><model name=\"m\">\n<link name=\"a\"><inertial><mass>x</mass></inertial></link></model></sdf>".to_owned()),
    ];
    let folder = Folder::new("refused", &files);
    for (file, place, code) in [
        ("a.sdf", "b.sdf:3: ", "include-cycle"),
        ("self.sdf", "self.sdf:3: ", "include-cycle"),
        ("absent.sdf", "absent.sdf:3: ", "no-such-file"),
        ("remote.sdf", "remote.sdf:3: ", "no-such-file"),
        ("urdf.sdf", "robot.urdf:1: ", "wrong-root"),
        ("empty.sdf", "empty.sdf:3: ", "missing-element"),
    ] {
        let refused = folder.load(file);
        let first = told(&refused).iter().find(|found| found.severity == Severity::Error).expect("an error");
        assert_eq!(first.code, code, "{file}: {first}");
        assert!(first.to_string().contains(place), "{file}: {first}");
    }
    // A world may include scenery that is not at hand.
    let world = format!(
        "<sdf version=\"1.6\"><world name=\"w\"><include><uri>model://sun</uri></include><model name=\"m\">{}</model></world></sdf>",
        link("a", "") + &joint("j", "fixed", "world", "a", "")
    );
    let folder = Folder::new("scenery", &[("world.sdf", world)]);
    assert_eq!(codes(&folder.load("world.sdf")), [(Severity::Warning, "no-such-file")]);
    assert!(folder.load("world.sdf#sun").is_err());
    // Other models do not matter, unless joints of the world can join them. Plugins and populations are not read.
    let with = |contents: &str, joint: &str| {
        let good = link("a", "") + &super::joint("j", "fixed", "world", "a", "");
        format!(
            "<sdf version=\"1.10\"><world name=\"w\"><model name=\"good\">{good}</model><model name=\"bad\">{}{contents}</model>{joint}</world></sdf>",
            link("b", "")
        )
    };
    let absent = "<include><uri>model://nothing</uri></include>";
    let broken = "<include><uri>broken.sdf</uri></include>";
    let joins = super::joint("k", "fixed", "good", "bad", "");
    let others = [
        ("absent.sdf", with(absent, "")),
        ("broken.sdf", "<sdf version=\"1.9\"><model>".to_owned()),
        ("reads.sdf", with(broken, "")),
        ("joined.sdf", with(absent, &joins)),
        ("plugin.sdf", with(&format!("<plugin><sdf version=\"1.0\">{absent}</sdf></plugin>"), "")),
    ];
    let folder = Folder::new("other-models", &others);
    assert_eq!(codes(&folder.load("absent.sdf#good")), [(Severity::Warning, "no-such-file")]);
    assert_eq!(codes(&folder.load("reads.sdf#w::good")), [(Severity::Warning, "unreadable")]);
    assert_eq!(codes(&folder.load("plugin.sdf#good")), []);
    for refused in ["absent.sdf#bad", "reads.sdf#bad", "joined.sdf#good"] {
        assert!(folder.load(refused).is_err(), "{refused}");
    }
    // The other formats hold one model per file, whose own name may have a #.
    let urdf = "<robot name=\"r\"><link name=\"a\"/></robot>".to_owned();
    let mjcf = "<mujoco><worldbody><body><geom size=\"1\"/></body></worldbody></mujoco>".to_owned();
    let folder = Folder::new("others", &[("r.urdf", urdf.clone()), ("m.xml", mjcf), ("r#2.urdf", urdf)]);
    for (name, format) in [("r.urdf", "a URDF"), ("m.xml", "an MJCF")] {
        assert!(folder.load(name).is_ok(), "{name}");
        let refused = folder.load(&format!("{name}#arm"));
        let first = told(&refused).iter().find(|found| found.severity == Severity::Error).expect("an error");
        assert_eq!(first.code, "unknown-model");
        let expected =
            format!("\"#arm\" selects one of several models of an SDFormat file; {format} holds one model");
        assert!(first.message.starts_with(&expected), "{first}");
    }
    assert!(folder.load("r#2.urdf").is_ok());
    // A value of an included file is reported there.
    let body = link("body", "");
    let whole = include("bad.sdf").replace("<include>", &format!("{body}<include>"));
    let folder = Folder::new("value", &[("whole.sdf", whole), files[9].clone()]);
    let refused = folder.load("whole.sdf");
    assert!(
        told(&refused)
            .iter()
            .any(|found| found.code == "bad-number" && found.to_string().contains("bad.sdf:2: ")),
        "{:?}",
        told(&refused)
    );
}
