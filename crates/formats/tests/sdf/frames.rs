//! Poses of frames, and choice of a model.

use super::{axis, drawn_pose, find, joint, link, load_sdf, model, read};
use crate::support::{codes, told};
use approx::assert_relative_eq;
use percuss_formats::{LoadOptions, Source, load};
use percuss_mechanism::Severity;
use percuss_spatial::{Vector3, rotation_from_rpy};

fn origin(text: &str, frame: &str) -> Vector3<f64> {
    drawn_pose(&read(text).mechanism, frame).translation
}

#[test]
fn poses_are_relative_to_links_joints_frames_and_models() {
    let text = model(
        9,
        &format!(
            "<pose>0 0 10 0 0 0</pose>{}{}<frame name=\"f\" attached_to=\"a\"><pose degrees=\"true\">0 1 0 0 0 90</pose></frame>
             <frame name=\"g\"><pose relative_to=\"f\">1 0 0 0 0 0</pose></frame>
             <frame name=\"h\" attached_to=\"j\"/><frame name=\"k\"><pose relative_to=\"n::inner\">0 0 1 0 0 0</pose></frame>
             <model name=\"n\"><pose relative_to=\"b\">0 5 0 0 0 0</pose>{}</model>{}",
            link("a", "<pose>1 0 0 0 0 0</pose>"),
            link("b", "<pose relative_to=\"a\">1 0 0 0 0 0</pose>"),
            link("inner", "<pose rotation_format=\"quat_xyzw\">0 0 2 0 0 0 1</pose>"),
            joint("j", "revolute", "a", "b", &format!("<pose relative_to=\"g\">0 0 3 0 0 0</pose>{}", axis("0 0 1", ""))),
        ),
    );
    for (frame, expected) in [
        ("a", [1.0, 0.0, 10.0]),
        ("b", [2.0, 0.0, 10.0]),
        ("f", [1.0, 1.0, 10.0]),
        ("g", [1.0, 2.0, 10.0]),
        ("h", [1.0, 2.0, 13.0]),
        ("n::inner", [2.0, 5.0, 12.0]),
        ("k", [2.0, 5.0, 13.0]),
    ] {
        assert_relative_eq!(origin(&text, frame), Vector3::from(expected), epsilon = 1e-14);
    }
}

#[test]
fn angles_are_about_fixed_axes() {
    let loaded = read(&model(7, &link("a", "<pose>0 0 0 0.3 -0.4 0.5</pose>")));
    let rotation = drawn_pose(&loaded.mechanism, "a").rotation;
    assert_relative_eq!(rotation, rotation_from_rpy([0.3, -0.4, 0.5]), epsilon = 1e-15);
}

/// Value of libsdformat 12.3.0.
#[test]
fn a_placement_frame_takes_the_pose_of_the_model() {
    let text = format!(
        "<sdf version=\"1.8\"><model name=\"m\" placement_frame=\"f\"><pose>0 0 0 0 0 0</pose>{}
         <frame name=\"f\"><pose relative_to=\"a\">-1 5 1 0 0 0</pose></frame></model></sdf>",
        link("a", "<pose>0 0 1 0 0 0</pose>")
    );
    assert_relative_eq!(origin(&text, "a"), Vector3::new(1.0, -5.0, -1.0), epsilon = 1e-15);
    assert_relative_eq!(origin(&text, "f"), Vector3::zeros(), epsilon = 1e-15);
}

#[test]
fn ends_of_joints_may_be_frames_and_models() {
    let text = model(
        8,
        &format!(
            "{}<frame name=\"f\" attached_to=\"a\"><pose>0 2 0 0 0 0</pose></frame>
             <model name=\"n\" canonical_link=\"y\"><pose>0 3 0 0 0 0</pose>{}{}</model>{}{}",
            link("a", ""),
            link("x", ""),
            link("y", ""),
            joint("j", "revolute", "f", "n", &axis("0 0 1", "")),
            joint("k", "fixed", "n::y", "n::x", ""),
        ),
    );
    let loaded = read(&text);
    let joint = find(&loaded.mechanism, "j");
    let ends = [joint.parent(), joint.child()].map(|link| loaded.mechanism.link(link).name());
    assert_eq!(ends, ["a", "n::y"]);
    assert_eq!(joint.origin().translation, Vector3::new(0.0, 3.0, 0.0));
}

#[test]
fn older_files_name_frames_by_another_attribute() {
    let contents = link("a", "<pose>1 0 0 0 0 0</pose>")
        + &link("b", "<pose frame=\"a\" relative_to=\"nothing\">1 0 0 0 0 0</pose>");
    assert_eq!(origin(&model(6, &contents), "b").x, 2.0);
    assert!(codes(&load_sdf(&model(7, &contents))).contains(&(Severity::Error, "unknown-frame")));
    // A joint may have the name of a link; poses then mean the link.
    let shared = link("a", "<pose>1 0 0 0 0 0</pose>") + &joint("a", "fixed", "world", "a", "");
    assert_eq!(codes(&load_sdf(&model(6, &shared))), [(Severity::Note, "duplicate-name")]);
}

#[test]
fn one_model_of_a_world_is_chosen_by_name() {
    let world = |second: &str| {
        format!(
            "<sdf version=\"1.9\"><world name=\"w\"><model name=\"ground\"><static>true</static>{}</model>
             <model name=\"first\"><pose relative_to=\"ground\">1 0 0 0 0 0</pose>{}</model>{second}</world></sdf>",
            link("plane", "<pose>0 0 1 0 0 0</pose>"),
            link("a", "")
        )
    };
    let alone = read(&world(""));
    assert_eq!(drawn_pose(&alone.mechanism, "a").translation, Vector3::x());
    assert_eq!(alone.mechanism.links().len(), 2);
    let second = format!("<model name=\"second\"><pose>0 7 0 0 0 0</pose>{}</model>", link("a", ""));
    let refused = load_sdf(&world(&second));
    assert_eq!(codes(&refused), [(Severity::Error, "several-models")]);
    assert!(told(&refused)[0].message.contains("ground, first, second"), "{:?}", told(&refused));
    let chosen = |name: &str| load(&Source::from_text(name, world(&second)), &LoadOptions::default());
    for name in ["my.sdf#second", "my.sdf#w::second"] {
        let loaded = chosen(name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(loaded.mechanism.name(), "second");
        assert_eq!(drawn_pose(&loaded.mechanism, "a").translation.y, 7.0);
    }
    let unknown = chosen("my.sdf#secnod");
    assert!(
        told(&unknown)[0]
            .to_string()
            .starts_with("my.sdf:1: error: sdf: no model of the name \"secnod\" (did you mean \"second\"?)")
    );
    // A joint of the world joins two models.
    let joint = joint("between", "revolute", "first::a", "second::a", &axis("0 0 1", ""));
    let text = world(&(second.clone() + &joint));
    let joined = load(&Source::from_text("my.sdf#second", text), &LoadOptions::default()).unwrap();
    let names: Vec<&str> = joined.mechanism.links().iter().map(|link| link.name()).collect();
    assert_eq!(names, ["world", "first::a", "a"]);
}

#[test]
fn unusual_xml_is_accepted() {
    let text = format!(
        "<?xml version=\"1.0\"?><!-- a -- b ---><sdf version=\"1.9\"><model name=\"m\" gz:x=\"1\">{}<gz:anything/></model></sdf>",
        link("a", "<!-- -- -->")
    );
    assert_eq!(codes(&load_sdf(&text)), [(Severity::Note, "floating")]);
}
