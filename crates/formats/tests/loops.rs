//! Loops, couplings and second parents give the expected closures in every notation.

use crate::support::{changed, codes, load_text, told};
use approx::assert_relative_eq;
use percuss_formats::{LoadError, Loaded};
use percuss_mechanism::{Closure, ClosureKind, Severity};
use percuss_spatial::{Vector3, rotation_about, rotation_from_rpy};

// A few roundings of numbers of order one.
const TOL: f64 = 1e-15 * 8.0;

/// Pendulum with additional elements.
fn with(elements: &str) -> Result<Loaded, LoadError> {
    changed(&[("</robot>", &format!("{elements}</robot>"))])
}

/// Loop from the base to the arm.
fn between(kind: &str, inside: &str) -> String {
    format!(
        "<loop name=\"pin\" type=\"{kind}\"><predecessor link=\"base\"/><successor link=\"arm\"/>{inside}</loop>"
    )
}

fn closure(elements: &str) -> Closure {
    let loaded = with(elements).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(loaded.mechanism.closures().len(), 1);
    loaded.mechanism.closures()[0].clone()
}

const AXIS: &str = "<axis xyz=\"0 3 4\"/>";
const AXIS2: &str = "<axis2 xyz=\"2 0 0\"/>";
const DISTANCE: &str = "<distance value=\"0.25\"/>";

#[test]
fn every_kind_has_its_word() {
    for kind in ClosureKind::ALL {
        let mut inside = String::new();
        if kind.has_axis() {
            inside.push_str(AXIS);
        }
        match kind {
            ClosureKind::Universal => inside.push_str(AXIS2),
            ClosureKind::Distance => inside.push_str(DISTANCE),
            _ => {}
        }
        let loaded = with(&between(kind.name(), &inside)).unwrap_or_else(|e| panic!("{e}"));
        let closure = loaded.mechanism.closures()[0].clone();
        assert_eq!((closure.name(), closure.kind()), ("pin", kind));
        assert_eq!(codes(&Ok(loaded)), [], "{}", kind.name());
        if kind.has_axis() {
            assert_relative_eq!(*closure.axis(), Vector3::new(0.0, 0.6, 0.8), epsilon = TOL);
        }
        if kind == ClosureKind::Universal {
            assert_eq!(*closure.axis2(), Vector3::x());
        }
        assert_eq!(closure.distance(), (kind == ClosureKind::Distance).then_some(0.25));
    }
    assert_eq!(closure(&between("continuous", AXIS)).kind(), ClosureKind::Revolute);
}

#[test]
fn frames_stand_where_they_are_put_in_either_spelling() {
    let plus = "<loop name=\"l\" type=\"fixed\"><predecessor link=\"base\"><origin xyz=\"1 2 3\"/></predecessor>\
                <successor link=\"arm\"><origin rpy=\"0.1 -0.2 0.3\"/></successor></loop>";
    let joint = "<loop_joint name=\"l\" type=\"fixed\"><link1 link=\"base\" xyz=\"1 2 3\"/>\
                 <link2 link=\"arm\" rpy=\"0.1 -0.2 0.3\"/></loop_joint>";
    for spelling in [plus, joint] {
        let closure = closure(spelling);
        assert_eq!(closure.predecessor().link.map(|l| l.index()), Some(0));
        assert_eq!(closure.successor().link.map(|l| l.index()), Some(1));
        assert_eq!(closure.predecessor().frame.translation, Vector3::new(1.0, 2.0, 3.0));
        assert_eq!(closure.successor().frame.rotation, rotation_from_rpy([0.1, -0.2, 0.3]));
        assert_eq!(closure.successor().frame.translation, Vector3::zeros());
    }
    let turned = "<successor link=\"arm\"><origin quat_xyzw=\"0 0 0.6 0.8\"/></successor>";
    let turned = between("fixed", "").replace("<successor link=\"arm\"/>", turned);
    let expected = rotation_about(&Vector3::z(), 2.0 * 0.6f64.atan2(0.8));
    assert_relative_eq!(closure(&turned).successor().frame.rotation, expected, epsilon = TOL);
    let hinge = "<loop_joint name=\"l\" type=\"continuous\"><link1 link=\"base\"/><link2 link=\"arm\"/>\
                 <axis xyz=\"0 0 1\"/></loop_joint>";
    assert_eq!((closure(hinge).kind(), *closure(hinge).axis()), (ClosureKind::Revolute, Vector3::z()));
}

#[test]
fn the_world_is_the_ground_unless_a_link_is_called_so() {
    let ball = between("spherical", "").replace("base", "world");
    assert_eq!(closure(&ball).predecessor().link, None);
    let other_end = between("spherical", "").replace("link=\"arm\"", "link=\"world\"");
    assert_eq!(closure(&other_end).successor().link, None);
    let link = "<link name=\"world\"/><joint name=\"j\" type=\"fixed\"><parent link=\"arm\"/>\
                <child link=\"world\"/></joint>";
    let closure = closure(&format!("{link}{ball}"));
    assert_eq!(closure.predecessor().link.map(|l| l.index()), Some(2));
}

#[test]
fn defaults_are_told() {
    let cases = [
        ("revolute", "", "default-axis"),
        ("universal", AXIS, "default-axis"),
        ("distance", "", "default-distance"),
        ("spherical", AXIS, "unused-element"),
        ("fixed", "<limit lower=\"0\"/>", "ignored"),
    ];
    for (kind, inside, code) in cases {
        let loaded = with(&between(kind, inside));
        assert_eq!(codes(&loaded), [(Severity::Note, code)], "{kind}: {:?}", told(&loaded));
    }
    assert_eq!(*closure(&between("revolute", "")).axis(), Vector3::x());
    assert_eq!(*closure(&between("universal", AXIS)).axis2(), Vector3::y());
    assert_eq!(closure(&between("distance", "")).distance(), None);
}

/// Rotor on the base, geared to the arm.
const GEAR: &str = "<link name=\"rotor\"/><joint name=\"spin\" type=\"continuous\"><parent link=\"base\"/>\
                    <child link=\"rotor\"/><axis xyz=\"0 1 0\"/></joint><coupling name=\"gear\" type=\"rolling\">\
                    <predecessor link=\"arm\"/><successor link=\"rotor\"/><ratio value=\"-6\"/></coupling>";

#[test]
fn a_coupling_gives_its_row() {
    let loaded = with(GEAR).unwrap();
    let [coupling] = loaded.mechanism.couplings() else { panic!("one coupling") };
    assert_eq!((coupling.name(), coupling.ratio().map(|links| links.ratio)), ("gear", Some(-6.0)));
    let terms: Vec<(usize, f64)> = coupling.terms().iter().map(|(j, f)| (j.index(), *f)).collect();
    // q_spin + 6 q_hinge = 0.
    assert_eq!(terms, [(1, 1.0), (0, 6.0)]);
}

#[test]
fn a_second_parent_closes_a_loop() {
    let second = "<link name=\"rod\"/>\
                  <joint name=\"first\" type=\"continuous\"><parent link=\"base\"/><child link=\"rod\"/><axis xyz=\"0 1 0\"/></joint>\
                  <joint name=\"second\" type=\"revolute\"><parent link=\"rod\"/><child link=\"arm\"/>\
                  <origin xyz=\"0 0 1\"/><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\"/></joint>";
    let loaded = with(second).unwrap();
    let m = &loaded.mechanism;
    assert_eq!((m.joints().len(), m.closures().len()), (2, 1));
    let pin = &m.closures()[0];
    assert_eq!((pin.name(), pin.kind(), *pin.axis()), ("second", ClosureKind::Revolute, Vector3::y()));
    assert_eq!(pin.predecessor().link, m.find_link("rod").ok());
    assert_eq!(pin.predecessor().frame.translation, Vector3::z());
    let found: Vec<_> = codes(&Ok(loaded)).into_iter().filter(|(_, code)| *code != "massless-link").collect();
    assert_eq!(found, [(Severity::Note, "second-parent"), (Severity::Note, "unused-element")]);
}

#[test]
fn advice_is_kept_and_only_what_cannot_be_bound_is_told() {
    let advised = |word: &str, more: &str| {
        let attribute = format!("type=\"revolute\" independent=\"{word}\"");
        changed(&[("type=\"revolute\"", &attribute), ("</robot>", &format!("{more}</robot>"))])
    };
    for (word, value) in [
        ("true", Some(true)),
        ("True", Some(true)),
        ("TRUE", Some(true)),
        ("false", Some(false)),
        ("fALSE", Some(false)),
        ("1", None),
    ] {
        let loaded = advised(word, "").unwrap();
        assert_eq!(loaded.mechanism.joints()[0].independent(), value, "{word}");
    }
    let unbound = |more: &str| codes(&advised("false", more)).contains(&(Severity::Warning, "unbound-joint"));
    let second = "<joint name=\"j\" type=\"spherical\"><parent link=\"base\"/><child link=\"arm\"/></joint>";
    assert!(unbound(""));
    assert!(!unbound(&between("spherical", "")) && !unbound(GEAR) && !unbound(second));
    // A fixed joint is not reported as free.
    let fixed = "<link name=\"tip\"/><joint name=\"j\" type=\"fixed\" independent=\"false\">\
                 <parent link=\"arm\"/><child link=\"tip\"/></joint>";
    assert!(!codes(&with(fixed)).contains(&(Severity::Warning, "unbound-joint")));
}

#[test]
fn findings_of_the_builder_find_their_elements() {
    let elements = |loaded: Result<Loaded, LoadError>| -> Vec<String> {
        loaded.unwrap_err().diagnostics.into_iter().filter_map(|d| d.element).collect()
    };
    // The defect is in the second of two loops, with the first in the other notation.
    let first =
        "<loop_joint name=\"l\" type=\"spherical\"><link1 link=\"base\"/><link2 link=\"arm\"/></loop_joint>";
    let bad = between("distance", "<distance value=\"-1\"/>");
    assert_eq!(elements(with(&format!("{first}{bad}"))), ["robot/loop[pin]/distance"]);
    let itself = first.replace("base", "arm").replace("\"l\"", "\"m\"");
    assert_eq!(elements(with(&format!("{bad}{itself}")))[1], "robot/loop_joint[m]/link2");
    let second = GEAR[GEAR.find("<coupling").unwrap()..].replace("\"gear\"", "\"other\"");
    assert_eq!(elements(with(&format!("{GEAR}{second}"))), ["robot/coupling[other]"]);
    let huge = GEAR.replace("\"-6\"", "\"1e200\"");
    assert_eq!(elements(with(&huge)), ["robot/coupling[gear]/ratio"]);
}

#[test]
fn loops_keep_the_order_of_the_file() {
    let mut text = String::new();
    for (i, spelling) in ["loop", "loop_joint", "loop"].iter().enumerate() {
        let ends = if *spelling == "loop" { ["predecessor", "successor"] } else { ["link1", "link2"] };
        let [a, b] = ends;
        text += &format!(
            "<{spelling} name=\"l{i}\" type=\"spherical\"><{a} link=\"base\"/><{b} link=\"arm\"/></{spelling}>"
        );
    }
    let loaded = with(&text).unwrap();
    let names: Vec<&str> = loaded.mechanism.closures().iter().map(Closure::name).collect();
    assert_eq!(names, ["l0", "l1", "l2"]);
    assert!(load_text(&percuss_formats::write_urdf(&loaded.mechanism)).is_ok());
}
