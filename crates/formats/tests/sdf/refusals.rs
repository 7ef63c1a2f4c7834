//! Errors name the element and the line.

use super::{axis, joint, link, load_sdf, model};
use crate::support::{codes, told};
use percuss_mechanism::Severity::{Error, Note, Warning};

#[test]
fn files_that_would_give_another_mechanism_are_refused() {
    let two = link("a", "") + &link("b", "");
    let hinge = |contents: &str| format!("{two}{}", joint("j", "revolute", "a", "b", contents));
    let cases = [
        ("<sdf><model name=\"m\"><link name=\"a\"/></model></sdf>".to_owned(), "missing-attribute"),
        (model(3, &two), "unknown-version"),
        (model(7, &two).replace("1.7", "2.0"), "unknown-version"),
        ("<sdf version=\"1.9\"><world name=\"w\"/></sdf>".to_owned(), "no-model"),
        (model(7, "<frame name=\"f\"/>"), "no-links"),
        (model(7, &format!("{two}{}", link("a", ""))), "duplicate-name"),
        (model(7, &link("world", "")), "reserved-name"),
        (model(7, "<link/>"), "missing-attribute"),
        (model(7, &link("a", "<pose>0 0 0</pose>")), "bad-pose"),
        (model(9, &link("a", "<pose rotation_format=\"quat_xyzw\">0 0 0 0 0 0 2</pose>")), "bad-pose"),
        (model(9, &link("a", "<pose degrees=\"maybe\"/>")), "bad-keyword"),
        (model(7, &link("a", "<pose relative_to=\"x\"/>")), "unknown-frame"),
        (
            model(7, &(link("a", "<pose relative_to=\"b\"/>") + &link("b", "<pose relative_to=\"a\"/>"))),
            "frame-circle",
        ),
        (model(7, &link("a", "<pose/><pose/>")), "duplicate-element"),
        (model(7, &hinge("<axis><xyz>0 0 0</xyz></axis>")), "zero-axis"),
        (model(7, &hinge("<axis><xyz>0 nan 0</xyz></axis>")), "bad-number"),
        (model(7, &hinge("<axis><xyz expressed_in=\"x\">0 1 0</xyz></axis>")), "unknown-frame"),
        (model(11, &hinge(&axis("0 0 1", "<mimic joint=\"x\"/>"))), "unknown-joint"),
        (model(11, &hinge(&axis("0 0 1", "<mimic joint=\"j\"/>"))), "mimic-cycle"),
        (model(7, &format!("{two}{}", joint("j", "revolvte", "a", "b", ""))), "unknown-joint-type"),
        (model(7, &format!("{two}{}", joint("j", "fixed", "a", "c", ""))), "unknown-link"),
        (model(7, &format!("{two}{}", joint("j", "fixed", "a", "world", ""))), "child-world"),
        (model(7, &format!("{two}{}", joint("j", "fixed", "a", "a", ""))), "joins-itself"),
        (
            model(7, &format!("{two}<joint name=\"j\" type=\"fixed\"><parent>a</parent></joint>")),
            "missing-element",
        ),
        (model(7, &format!("{two}{}", joint("j", "screw", "a", "b", ""))), "missing-element"),
        (model(7, &format!("{two}{}", joint("j", "universal", "a", "b", ""))), "missing-element"),
        (model(7, &format!("{two}<drake:ball_constraint/>")), "unsupported"),
        (model(12, "<link name=\"a\"><inertial><fluid_added_mass/></inertial></link>"), "unsupported"),
        (
            model(
                11,
                "<link name=\"a\"><inertial auto=\"true\"/><collision name=\"c\"><geometry><mesh><uri>x.stl</uri></mesh></geometry></collision></link>",
            ),
            "unsupported",
        ),
        (model(11, "<link name=\"a\"><inertial auto=\"true\"/></link>"), "default-inertia"),
        (model(7, "<link name=\"a\"><inertial><mass>-1</mass></inertial></link>"), "negative-mass"),
    ];
    for (text, code) in cases {
        let refused = load_sdf(&text);
        let errors: Vec<_> = told(&refused).iter().filter(|found| found.severity == Error).collect();
        assert!(
            refused.is_err() && errors.iter().any(|error| error.code == code),
            "{code}: {errors:?}\n{text}"
        );
        assert!(errors.iter().all(|error| error.line.is_some() && error.element.is_some()), "{errors:?}");
    }
}

#[test]
fn a_comment_within_a_number_makes_two_values() {
    let text = |mass: &str| {
        model(
            9,
            &(link("a", "").replace("<mass>2<", &format!("<mass>{mass}<"))
                + &joint("j", "revolute", "world", "a", &axis("0 0 1", ""))),
        )
    };
    for mass in ["<!-- kg -->2", "2<!-- kg -->"] {
        assert_eq!(codes(&load_sdf(&text(mass))), [], "{mass}");
    }
    assert!(load_sdf(&text("2<!-- kg -->5")).is_err());
}

#[test]
fn doubtful_files_are_read_with_a_warning() {
    let base = link("a", "") + &joint("j", "fixed", "world", "a", "");
    for (contents, code) in [
        ("<nonsense/>".to_owned(), "unknown-element"),
        ("<drake:linear_bushing_rpy/>".to_owned(), "ignored"),
        (
            joint(
                "k",
                "universal",
                "a",
                "b",
                "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0.5 1 0</xyz></axis2>",
            ) + &link("b", ""),
            "oblique-pins",
        ),
        (
            joint("k", "revolute", "a", "b", "<axis>0 1 0<limit><lower>-1</lower></limit></axis>")
                + &link("b", ""),
            "stray-text",
        ),
        (
            "<plugin filename=\"libroboticsgroup_gazebo_mimic_joint_plugin.so\" name=\"p\"/>".to_owned(),
            "plugin",
        ),
        (
            link("b", "<visual name=\"v\"><pose>0 0 0 0 0 0</pose><pose>0 0 1 0 0 0</pose></visual>")
                + &joint("k", "fixed", "world", "b", ""),
            "duplicate-element",
        ),
        (
            joint("k", "revolute", "a", "b", &axis("0 0 1", "<initial_position>-0.5</initial_position>"))
                + &link("b", ""),
            "ignored",
        ),
        (
            "<link name=\"b\"><inertial><pose frame=\"a\">1 0 0 0 0 0</pose><mass>1</mass></inertial></link>"
                .to_owned()
                + &joint("k", "fixed", "world", "b", ""),
            "ignored",
        ),
        (link("b", "<kinematic>true</kinematic>") + &joint("k", "fixed", "world", "b", ""), "ignored"),
    ] {
        assert_eq!(codes(&load_sdf(&model(9, &(base.clone() + &contents)))), [(Warning, code)], "{contents}");
    }
    let newer = model(7, &base).replace("1.7", "1.13");
    assert_eq!(codes(&load_sdf(&newer)), [(Warning, "unknown-version")]);
    let silent = "<plugin filename=\"x\" name=\"y\"/><self_collide>1</self_collide><gz:system_priority/>";
    assert_eq!(codes(&load_sdf(&model(9, &(base.clone() + silent)))), []);
    let loops = base
        + &joint(
            "k",
            "revolute",
            "world",
            "a",
            &axis("0 0 1", "<limit><lower>0</lower><upper>1</upper></limit>"),
        );
    // Between two links that cannot move a joint has no effect.
    assert_eq!(codes(&load_sdf(&model(9, &loops))), []);
    assert!(!codes(&load_sdf(&model(9, &loops))).contains(&(Note, "unused-element")));
}
