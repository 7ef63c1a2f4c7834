//! Relations of several joints, polynomial relations, and armatures of tendons.

use super::{load_mjcf, model};
use percuss_formats::{LoadOptions, Loaded, Source, load, write_mjcf, write_urdf};
use percuss_mechanism::{Coupling, Mechanism};

const BODIES: &str = "<body name=\"a\"><joint name=\"j\"/><geom size=\".1\"/><body name=\"b\"><joint name=\"k\"/><geom size=\".1\"/></body></body>
    <body name=\"c\"><joint name=\"l\" type=\"slide\"/><geom size=\".1\"/></body>";

fn read(sections: &str) -> Loaded {
    load_mjcf(&model(BODIES, sections)).unwrap_or_else(|error| panic!("{error}"))
}

/// Terms, constant, and curve with terms, offset and coefficients, by joint names.
type Described = (Vec<(String, f64)>, f64, Option<(Vec<(String, f64)>, f64, [f64; 3])>);

fn describe(mechanism: &Mechanism, coupling: &Coupling) -> Described {
    let described = mechanism.describe_relation(coupling);
    let curve = described.curve.map(|curve| (curve.terms, curve.offset, curve.coefficients));
    (described.terms, described.constant, curve)
}

fn terms(of: &[(&str, f64)]) -> Vec<(String, f64)> {
    of.iter().map(|(name, factor)| ((*name).to_owned(), *factor)).collect()
}

#[test]
fn a_polynomial_of_degree_four_is_a_curve() {
    let loaded = read(
        "<equality><joint name=\"cam\" joint1=\"l\" joint2=\"j\" polycoef=\".1 .2 .3 .4 .5\"/></equality>",
    );
    let [coupling] = loaded.mechanism.couplings() else { panic!("one relation") };
    let expected =
        (terms(&[("l", 1.0), ("j", -0.2)]), 0.1, Some((terms(&[("j", 1.0)]), 0.0, [0.3, 0.4, 0.5])));
    assert_eq!((coupling.name(), describe(&loaded.mechanism, coupling)), ("cam", expected));
}

#[test]
fn tendons_of_several_joints_are_sums() {
    let loaded = read(
        "<tendon><fixed name=\"t\"><joint joint=\"j\" coef=\"1\"/><joint joint=\"k\" coef=\"2\"/></fixed>
           <fixed name=\"u\"><joint joint=\"l\" coef=\"3\"/></fixed></tendon>
         <equality><tendon tendon1=\"t\" tendon2=\"u\" polycoef=\"0 2\"/></equality>",
    );
    let [coupling] = loaded.mechanism.couplings() else { panic!("one relation") };
    let expected = (terms(&[("j", 1.0), ("k", 2.0), ("l", -6.0)]), 0.0, None);
    assert_eq!(describe(&loaded.mechanism, coupling), expected);
    // A locked joint becomes a part of the constant.
    let locked = read(
        "<tendon><fixed name=\"t\"><joint joint=\"j\" coef=\"1\"/><joint joint=\"k\" coef=\"2\"/><joint joint=\"l\" coef=\"4\"/></fixed></tendon>
         <equality><tendon tendon1=\"t\"/><joint joint1=\"k\" polycoef=\"0.25\"/></equality>",
    );
    let [coupling] = locked.mechanism.couplings() else { panic!("one relation") };
    assert_eq!(describe(&locked.mechanism, coupling), (terms(&[("j", 1.0), ("l", 4.0)]), -0.5, None));
}

#[test]
fn the_armature_of_a_tendon_is_a_rotor() {
    let loaded = read(
        "<tendon><fixed name=\"t\" armature=\"0.5\"><joint joint=\"j\" coef=\"1\"/><joint joint=\"l\" coef=\"2\"/></fixed></tendon>
         <actuator><motor tendon=\"t\" gear=\"3\" armature=\"0.1\"/></actuator>",
    );
    let mechanism = &loaded.mechanism;
    let rotor = mechanism.joint(mechanism.find_joint("t/length").unwrap());
    assert!((rotor.armature()[0] - (0.5 + 0.9)).abs() < 1e-15);
    let [coupling] = mechanism.couplings() else { panic!("one relation") };
    assert_eq!(
        describe(mechanism, coupling),
        (terms(&[("t/length", 1.0), ("j", -1.0), ("l", -2.0)]), 0.0, None)
    );
    // The joints are on different branches, where MuJoCo leaves an entry of M out.
    assert!(loaded.diagnostics.iter().any(|d| d.code == "tendon-armature"), "{:?}", loaded.diagnostics);
    let chain = read(
        "<tendon><fixed armature=\"1\"><joint joint=\"j\" coef=\"1\"/><joint joint=\"k\" coef=\"2\"/></fixed></tendon>",
    );
    assert!(chain.diagnostics.is_empty(), "{:?}", chain.diagnostics);
}

#[test]
fn relations_survive_urdf_and_mjcf() {
    let loaded = read(
        "<tendon><fixed name=\"t\"><joint joint=\"j\" coef=\"1\"/><joint joint=\"k\" coef=\"2\"/></fixed>
           <fixed name=\"u\"><joint joint=\"l\" coef=\"3\"/></fixed></tendon>
         <equality><tendon name=\"r\" tendon1=\"t\" tendon2=\"u\" polycoef=\"0.01 0.2 0.3 0.4 0.5\"/></equality>",
    );
    let before = describe(&loaded.mechanism, &loaded.mechanism.couplings()[0]);
    for text in [write_urdf(&loaded.mechanism), write_mjcf(&loaded.mechanism, "").unwrap().text] {
        let again = load(&Source::from_text("model", &text), &LoadOptions::default()).unwrap();
        let [coupling] = again.mechanism.couplings() else { panic!("one relation: {text}") };
        assert_eq!((coupling.name(), describe(&again.mechanism, coupling)), ("r", before.clone()), "{text}");
    }
}

#[test]
fn sites_are_contacts_with_their_axis_as_normal() {
    let loaded = load_mjcf(&model(
        "<body name=\"a\" quat=\"1 1 0 0\"><joint/><geom size=\".1\"/><site name=\"pad\" pos=\"1 2 3\"/><site name=\"hook\"/></body>
         <site name=\"ground\"/>",
        "<tendon><spatial><site site=\"hook\"/><site site=\"ground\"/></spatial></tendon>",
    ))
    .unwrap();
    let [contact] = loaded.mechanism.contacts() else { panic!("one contact") };
    assert_eq!((contact.name(), contact.gap()), ("pad", None));
    assert_eq!(contact.point().as_slice(), [1.0, 2.0, 3.0]);
    // The z-axis of the body, turned by 90° about x.
    let percuss_mechanism::ContactNormal::Fixed(normal) = contact.normal() else { panic!("a direction") };
    assert!((normal - percuss_spatial::Vector3::new(0.0, -1.0, 0.0)).norm() < 1e-15, "{normal}");
    // The contact survives as a site.
    let text = write_mjcf(&loaded.mechanism, "").unwrap();
    assert!(text.changes.iter().all(|change| !change.element.contains("contact")), "{:?}", text.changes);
    let again = load_mjcf(&text.text).unwrap();
    assert_eq!(again.mechanism.contacts().len(), 1);
}

/// The length of a tendon with an armature is 0 as drawn, where the follower `b` is at its offset of 0.1.
#[test]
fn lengths_of_tendons_are_closed_as_drawn() {
    let body = |name: &str| format!("<body><joint name=\"{name}\"/><geom size=\".1\"/></body>");
    let sections = "<equality><joint joint1=\"b\" joint2=\"a\" polycoef=\"0.1 2 0 0 0\"/></equality>
        <tendon><fixed name=\"t\" armature=\"0.5\"><joint joint=\"a\" coef=\"3\"/><joint joint=\"b\" coef=\"4\"/></fixed></tendon>";
    let loaded = load_mjcf(&model(&(body("a") + &body("b")), sections)).unwrap();
    let [relation] = loaded.mechanism.couplings() else { panic!("one relation") };
    // length − 3 a − 4 b = −4 · 0.1
    assert_eq!(relation.constant(), -0.4);
}
