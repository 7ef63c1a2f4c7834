//! The tree, joints that close loops, gearboxes and mimics.

use super::{axis, find, joint, link, load_sdf, model, read};
use crate::support::codes;
use approx::assert_relative_eq;
use percuss_mechanism::{ClosureKind, JointKind, Mechanism, Severity};
use percuss_spatial::Vector3;

/// Parallelogram of three links on the ground, of side 1; `marked`: contents of the joint between the coupler and the crank.
fn parallelogram(marked: &str) -> String {
    let hinge = |name: &str, parent: &str, child: &str, contents: &str| {
        joint(name, "revolute", parent, child, &format!("{contents}{}", axis("0 0 1", "")))
    };
    format!(
        "{}{}{}{}{}{}{}",
        link("crank", ""),
        link("coupler", "<pose>0 1 0 0 0 0</pose>"),
        link("rocker", "<pose>1 0 0 0 0 0</pose>"),
        hinge("a", "world", "crank", ""),
        hinge("b", "crank", "coupler", marked),
        hinge("d", "world", "rocker", ""),
        hinge("c", "rocker", "coupler", "<pose>1 0 0 0 0 0</pose>"),
    )
}

fn names(mechanism: &Mechanism) -> (Vec<&str>, Vec<&str>) {
    let moving = mechanism.joints().iter().filter(|joint| joint.kind() != JointKind::Fixed);
    (
        moving.map(|joint| joint.name()).collect(),
        mechanism.closures().iter().map(|closure| closure.name()).collect(),
    )
}

#[test]
fn the_second_joint_to_a_child_closes_the_loop() {
    let loaded = read(&model(7, &parallelogram("")));
    assert_eq!(names(&loaded.mechanism), (vec!["a", "b", "d"], vec!["c"]));
    let closure = &loaded.mechanism.closures()[0];
    assert_eq!(closure.kind(), ClosureKind::Revolute);
    // Placed on the child; on the parent as drawn.
    assert_eq!(closure.successor().frame.translation, Vector3::x());
    assert_eq!(closure.predecessor().frame.translation, Vector3::y());
    assert_eq!(codes(&Ok(loaded)), []);
    let marked = "<physics><simbody><must_be_loop_joint>true</must_be_loop_joint></simbody></physics>";
    let loaded = read(&model(7, &parallelogram(marked)));
    assert_eq!(names(&loaded.mechanism), (vec!["a", "c", "d"], vec!["b"]));
}

/// `parent` and `child` give no direction of the tree: a link may be only ever a parent.
#[test]
fn links_that_are_only_parents_belong_to_the_tree() {
    let loaded = read(&model(
        7,
        &format!(
            "{}{}{}{}",
            link("a", "<pose>1 0 0 0 0 0</pose>"),
            link("b", "<pose>2 0 0 0 0 0</pose>"),
            joint("to_world", "revolute", "world", "a", &axis("0 0 1", "")),
            joint(
                "up",
                "universal",
                "b",
                "a",
                &format!("{}<axis2><xyz>0 1 0</xyz></axis2>", axis("1 0 0", ""))
            )
        ),
    ));
    let mechanism = &loaded.mechanism;
    // Passed from child to parent: the second axis comes first, and the axes change their signs.
    let joints: Vec<(&str, Vector3<f64>)> =
        mechanism.joints().iter().map(|joint| (joint.name(), *joint.axis())).collect();
    assert_eq!(joints[0], ("to_world", Vector3::z()));
    assert_eq!(joints[1], ("up/axis2", -Vector3::y()));
    assert_eq!(joints[2], ("up/axis", -Vector3::x()));
    assert_eq!(joints[3].0, "b_fixed");
    assert_eq!(mechanism.closures().len(), 0);
}

#[test]
fn a_model_floats_unless_something_holds_it() {
    let free = read(&model(
        7,
        &(link("a", "<pose>0 0 1 0 0 0</pose>") + &link("b", "") + &joint("j", "ball", "b", "a", "")),
    ));
    let floating = find(&free.mechanism, "b_floating");
    assert_eq!(floating.kind(), JointKind::Floating);
    assert_eq!(codes(&Ok(free)), [(Severity::Note, "floating")]);
    let held = read(&model(7, &("<static>1</static>".to_owned() + &link("a", "") + &link("b", ""))));
    assert!(held.mechanism.joints().iter().all(|joint| joint.kind() == JointKind::Fixed));
}

/// Two wheels on a carrier, as in SDFormat's description of a gearbox: θ₂ = −ratio · θ₁.
fn gears(first_axis: &str, reference: &str) -> String {
    format!(
        "{}{}{}{}{}{}{}",
        link("carrier", ""),
        link("one", "<pose>1 0 0 0 0 0</pose>"),
        link("two", "<pose>-1 0 0 0 0 0</pose>"),
        joint("base", "fixed", "world", "carrier", ""),
        joint("j1", "revolute", "carrier", "one", &axis(first_axis, "")),
        joint("j2", "revolute", "carrier", "two", &axis("0 0 1", "")),
        joint(
            "gear",
            "gearbox",
            "one",
            "two",
            &format!(
                "<gearbox_ratio>3</gearbox_ratio><gearbox_reference_body>{reference}</gearbox_reference_body>{}<axis2><xyz>0 0 1</xyz></axis2>",
                axis("0 0 1", "")
            )
        ),
    )
}

#[test]
fn gearboxes_couple_two_joints() {
    for (direction, ratio) in [("0 0 1", -3.0), ("0 0 -1", 3.0)] {
        let loaded = read(&model(7, &gears(direction, "carrier")));
        let coupling = &loaded.mechanism.couplings()[0];
        assert_eq!(
            (coupling.name(), coupling.ratio().map(|links| links.ratio)),
            ("gear", Some(ratio)),
            "{direction}"
        );
        assert_eq!(coupling.terms().len(), 2);
        assert_eq!(codes(&Ok(loaded)), [(Severity::Warning, "gearbox")]);
    }
    for (direction, reference) in [("0 1 0", "carrier"), ("0 0 1", "one")] {
        let refused = load_sdf(&model(7, &gears(direction, reference)));
        assert_eq!(codes(&refused), [(Severity::Error, "gearbox")], "{direction} {reference}");
    }
}

#[test]
fn axes_follow_others() {
    let mimic = "<mimic joint=\"j2\" axis=\"axis2\"><multiplier>2</multiplier><offset>0.5</offset><reference>0.1</reference></mimic>";
    let loaded = read(&model(
        11,
        &format!(
            "{}{}{}{}",
            link("a", ""),
            link("b", ""),
            joint("j1", "prismatic", "world", "a", &axis("1 0 0", mimic)),
            joint(
                "j2",
                "universal",
                "world",
                "b",
                &format!("{}<axis2><xyz>0 1 0</xyz></axis2>", axis("1 0 0", ""))
            )
        ),
    ));
    let mimic = find(&loaded.mechanism, "j1").mimic().expect("a mimic");
    assert_eq!(loaded.mechanism.joint(mimic.master).name(), "j2/axis2");
    assert_eq!(mimic.multiplier, 2.0);
    assert_relative_eq!(mimic.offset, 0.3, max_relative = 1e-15);
}

/// Joints that have a position to follow, or a rotor, stay in the tree.
#[test]
fn joints_that_cannot_close_a_loop_stay_in_the_tree() {
    let rotor = "<drake:rotor_inertia>1</drake:rotor_inertia>";
    let loaded = read(&model(
        7,
        &parallelogram("")
            .replace("<pose>1 0 0 0 0 0</pose><axis>", &format!("<pose>1 0 0 0 0 0</pose>{rotor}<axis>")),
    ));
    assert_eq!(names(&loaded.mechanism), (vec!["a", "b", "c"], vec!["d"]));
    let all = parallelogram("").replace("<axis>", &format!("{rotor}<axis>"));
    assert_eq!(codes(&load_sdf(&model(7, &all))), [(Severity::Error, "loop-unsupported")]);
}
