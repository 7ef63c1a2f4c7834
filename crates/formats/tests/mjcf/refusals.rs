//! Models that are refused: the message names the element, and says what is expected.

use super::{load_mjcf, model};
use crate::support::codes;
use percuss_mechanism::Severity;

const ARM: &str = "<body name=\"upper_arm\"><joint name=\"j\"/><geom size=\".1\"/></body>";
const OTHERS: &str = "<site name=\"s\"/><body name=\"b\"><site name=\"t\" pos=\"1 0 0\"/><joint name=\"k\"/><geom size=\".1\"/></body><body name=\"c\"><joint name=\"l\"/><geom size=\".1\"/></body>";

/// The model is refused with this code, and the first error contains all the words.
fn assert_refused(text: &str, code: &str, words: &[&str]) {
    let error = load_mjcf(text).err().unwrap_or_else(|| panic!("accepted: {text}"));
    let first = error.diagnostics.iter().find(|d| d.severity == Severity::Error).expect("an error");
    assert_eq!(first.code, code, "{first}");
    for word in words {
        assert!(first.to_string().contains(word), "\"{word}\" is not in: {first}");
    }
    assert!(first.line.is_some() && first.path == "model.xml", "no position: {first}");
}

#[test]
fn unknown_names_have_a_remedy() {
    for (sections, code, words) in [
        (
            "<equality><connect body1=\"uper_arm\" anchor=\"0 0 0\"/></equality>",
            "unknown-reference",
            &["uper_arm", "did you mean \"upper_arm\""][..],
        ),
        ("<equality><connect body1=\"upper_arm\"/></equality>", "missing-attribute", &["anchor"]),
        ("<equality><joint joint1=\"x\"/></equality>", "unknown-reference", &["joint \"x\""]),
        ("<equality><tendon tendon1=\"x\"/></equality>", "unknown-reference", &["tendon \"x\""]),
        ("<actuator><motor joint=\"x\" armature=\"1\"/></actuator>", "unknown-reference", &["joint \"x\""]),
        (
            "<equality><conect body1=\"upper_arm\"/></equality>",
            "unknown-element",
            &["<conect>", "did you mean \"connect\""],
        ),
        (
            "<equality><connect body1=\"upper_arm\" anchr=\"0 0 0\"/></equality>",
            "unknown-attribute",
            &["anchr", "anchor"],
        ),
        ("<default><default/></default>", "bad-class", &["class"]),
        ("<default class=\"x\"/>", "bad-class", &["main"]),
        ("<include file=\"nowhere.xml\"/>", "no-such-file", &["nowhere.xml"]),
    ] {
        assert_refused(&model(ARM, sections), code, words);
    }
}

#[test]
fn elements_without_a_form_in_a_mechanism_are_refused_by_name() {
    for (sections, words) in [
        (
            "<deformable><flex name=\"f\" body=\"upper_arm\" element=\"0\"/></deformable>",
            &["<flex>", "deformable"][..],
        ),
        ("<equality><flex flex=\"f\"/></equality>", &["<flex>"]),
        ("<equality><distance geom1=\"a\"/></equality>", &["<distance>"]),
        (
            "<tendon><spatial name=\"t\" armature=\"1\"><site site=\"s\"/><site site=\"t\"/></spatial></tendon>",
            &["armature of a spatial tendon"],
        ),
        ("<actuator><motor body=\"upper_arm\" armature=\"1\"/></actuator>", &["armature of an actuator"]),
        ("<compiler coordinate=\"global\"/>", &["global coordinates"]),
    ] {
        assert_refused(&model(&format!("{ARM}{OTHERS}"), sections), "unsupported", words);
    }
    for (body, words) in [
        ("<composite type=\"cable\"/>", &["<composite>"][..]),
        ("<flexcomp name=\"f\"/>", &["<flexcomp>"]),
        ("<frame scale=\"2\"/>", &["scale of a frame"]),
        (
            "<body><joint/><geom type=\"ellipsoid\" size=\".1 .1 .2\" shellinertia=\"true\"/></body>",
            &["shell of an ellipsoid"],
        ),
        ("<body><joint/><geom type=\"sdf\"/></body>", &["signed distance"]),
        ("<body><joint/><geom type=\"box\" mesh=\"m\"/></body>", &["fits to a mesh", "<inertial>"]),
    ] {
        assert_refused(&model(body, ""), "unsupported", words);
    }
    let mesh = |attributes: &str| {
        model(
            "<body><joint/><geom type=\"mesh\" mesh=\"m\"/></body>",
            &format!("<asset><mesh name=\"m\" inertia=\"convex\" {attributes}/></asset>"),
        )
    };
    let pyramid = "vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\"";
    assert_refused(&mesh(&format!("{pyramid} maxhullvert=\"8\"")), "unsupported", &["maxhullvert"]);
    assert_refused(&mesh("vertex=\"0 0 0 1 0 0 0 1 0 1 1 0\""), "bad-mesh", &["plane"]);
    // The hull needs no limit of its vertices.
    assert!(load_mjcf(&mesh(&format!("{pyramid} maxhullvert=\"-1\""))).is_ok());
}

#[test]
fn values_that_mujoco_refuses() {
    for (body, code, words) in [
        ("<joint/>", "misplaced", &["<body>"][..]),
        ("<body><joint axis=\"0 0 0\"/></body>", "zero-axis", &["0 0 1"]),
        ("<body><joint type=\"free\"/><joint/></body>", "free-joint", &["only joint"]),
        ("<body><body><freejoint/></body></body>", "free-joint", &["<worldbody>"]),
        ("<body><joint type=\"hing\"/></body>", "bad-keyword", &["did you mean \"hinge\""]),
        ("<body><geom size=\"0\"/></body>", "bad-size", &["positive"]),
        ("<body><geom type=\"box\" size=\"1 1\"/></body>", "bad-size", &["3 positive"]),
        (
            "<body><geom size=\"1\" pos=\"1 0 0\" fromto=\"0 0 0 1 0 0\" type=\"capsule\"/></body>",
            "two-poses",
            &["fromto"],
        ),
        ("<body quat=\"0 0 0 0\"/>", "zero-axis", &["quat"]),
        ("<body quat=\"1 0 0 0\" euler=\"0 0 0\"/>", "two-orientations", &["quat", "euler"]),
        ("<body name=\"a\"/><body name=\"a\"/>", "duplicate-name", &["\"a\""]),
        (
            "<body><joint/><inertial pos=\"0 0 0\" mass=\"-1\" diaginertia=\"1 1 1\"/></body>",
            "negative-mass",
            &["-1"],
        ),
        ("<body><joint/><inertial mass=\"1\" diaginertia=\"1 1 1\"/></body>", "missing-attribute", &["pos"]),
        ("<body pos=\"0 nan 0\"/>", "bad-number", &["nan"]),
        ("<body><joint/><geom type=\"plane\" size=\"1 1 1\"/></body>", "moving-plane", &["cannot move"]),
        ("<replicate count=\"0\"/>", "bad-count", &["positive"]),
        (
            "<body><joint/><geom size=\".1\"/><geom size=\".1\" mass=\"-1\"/></body>",
            "negative-mass",
            &["mass is -1"],
        ),
        (
            "<body><joint/><geom size=\".1\"/><geom size=\".1\" density=\"-1\"/></body>",
            "negative-mass",
            &["density is -1"],
        ),
        (
            "<body><joint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\" fullinertia=\"1 1 1 0 0 0\"/></body>",
            "two-inertias",
            &["fullinertia and diaginertia"],
        ),
        ("<replicate count=\"2\"><joint/></replicate>", "misplaced", &["<replicate>"]),
    ] {
        assert_refused(&model(body, ""), code, words);
    }
    let replicated = model(
        "<replicate count=\"2\"><body name=\"a\"><joint/><geom size=\".1\"/></body></replicate>",
        "<equality><connect body1=\"a\" anchor=\"0 0 0\"/></equality>",
    );
    assert_refused(&replicated, "unknown-reference", &["<replicate>", "\"a0\""]);
    let tendon = |sections: &str| {
        model(
            "<replicate count=\"2\"><body name=\"a\"><joint name=\"r\"/><geom size=\".1\"/></body></replicate>",
            &format!("<tendon><fixed name=\"t\"><joint joint=\"r\" coef=\"1\"/></fixed></tendon>{sections}"),
        )
    };
    assert!(load_mjcf(&tendon("")).is_ok());
    assert_refused(
        &tendon("<equality><tendon tendon1=\"t\"/></equality>"),
        "unsupported",
        &["<replicate>", "\"a0\""],
    );
    let twice =
        "<equality><joint joint1=\"j\" polycoef=\"0.1\"/><joint joint1=\"j\" polycoef=\"0.2\"/></equality>";
    assert_refused(&model(ARM, twice), "contradiction", &["earlier constraints"]);
    let own = "<equality><joint joint1=\"j\" joint2=\"j\" polycoef=\"0 2\"/></equality>";
    assert_refused(&model(ARM, own), "unsupported", &["the same joint"]);
    let terms = "<joint joint=\"j\" coef=\"1\"/>".repeat(2);
    let twice = format!("<tendon><fixed name=\"t\" armature=\"1\">{terms}</fixed></tendon>");
    assert_refused(&model(ARM, &twice), "duplicate-name", &["\"j\" occurs twice"]);
}

#[test]
fn implausible_inertias_are_refused_as_in_a_urdf() {
    // Moments in kg·mm² read as kg·m².
    let body = "<body name=\"a\" pos=\"0.1 0 0\"><joint/><inertial pos=\"0.1 0 0\" mass=\"1\" diaginertia=\"900 900 900\"/></body>";
    assert_refused(&model(body, ""), "implausible-inertia", &["kg"]);
}

#[test]
fn what_has_no_effect_is_silent() {
    let text = model(
        ARM,
        "<option timestep=\"0.001\"><flag contact=\"disable\"/></option><size memory=\"1M\"/><visual/><statistic/>
         <custom/><contact><exclude body1=\"a\" body2=\"b\"/></contact><sensor><jointpos joint=\"j\"/></sensor>
         <keyframe><key qpos=\"0\"/></keyframe><actuator><motor joint=\"j\" gear=\"2\"/></actuator>",
    );
    assert_eq!(codes(&load_mjcf(&text)), []);
}
