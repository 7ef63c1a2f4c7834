//! Errors and warnings of suspension files, with their messages.

use super::models::{all, changed, double_wishbone, file, macpherson_strut, multi_link, three_link_irs};
use super::{WHEEL, import_text, on};
use percuss_formats::{Diagnostic, LoadError, Source};
use percuss_mechanism::Severity;
use percuss_suspension::{ImportOptions, Imported, Rack, Side, import};

fn told(result: &Result<Imported, LoadError>) -> &[Diagnostic] {
    match result {
        Ok(imported) => &imported.diagnostics,
        Err(error) => &error.diagnostics,
    }
}

/// The only error of a wishbone file with some keys changed.
#[track_caller]
fn error(changes: &[(&'static str, &'static str)]) -> Diagnostic {
    let text = file("DoubleWishbone", &changed(&double_wishbone(), changes));
    let error = import_text(&text, &on(Side::Left)).expect_err("an error");
    let mut errors = error.diagnostics.into_iter().filter(|d| d.severity == Severity::Error);
    let first = errors.next().expect("an error");
    assert_eq!(errors.next(), None);
    first
}

/// Warnings and notes of a readable file, without the finding about the wheel.
#[track_caller]
fn doubts(
    template: &str,
    keys: &[(&str, &str)],
    options: &ImportOptions,
) -> Vec<(Severity, &'static str, String)> {
    let result = import_text(&file(template, keys), options);
    assert!(result.is_ok(), "{:?}", told(&result));
    let doubts = told(&result).iter().filter(|d| d.code != "no-wheel");
    doubts.map(|d| (d.severity, d.code, d.element.clone().unwrap_or_default())).collect()
}

#[test]
fn good_files_raise_no_doubt_but_of_the_wheel() {
    for (template, keys) in all() {
        assert_eq!(doubts(template, &keys, &on(Side::Left)), [], "{template}");
    }
}

#[test]
fn a_missing_or_wrong_value_is_named_by_its_path() {
    let cases: [(&str, &str, &str, &str); 9] = [
        ("Lower Control Arm/COM", "", "missing-key", "Lower Control Arm/COM"),
        ("Axle/Inertia", "", "missing-key", "Axle"),
        ("Spindle/Mass", "\"14\"", "wrong-type", "Spindle/Mass"),
        ("Spindle/Mass", "1e999", "not-finite", "Spindle/Mass"),
        ("Spindle/COM", "0.5", "wrong-type", "Spindle/COM"),
        ("Spindle/COM", "[0, 0.9]", "wrong-length", "Spindle/COM"),
        ("Spindle/COM", "[0, 0.9, 0, 0]", "wrong-length", "Spindle/COM"),
        ("Spindle/COM", "[0, null, 0]", "wrong-type", "Spindle/COM[1]"),
        ("Toe Angle (deg)", "true", "wrong-type", "Toe Angle (deg)"),
    ];
    for (key, value, code, element) in cases {
        let found = error(&[(key, value)]);
        assert_eq!((found.code, found.element.as_deref()), (code, Some(element)), "{key}: {value}");
        let line = found.line.unwrap_or_default();
        assert!(element == "Axle" || line > 4, "{found}");
    }
    let flag = error(&[("Vehicle-Frame Inertia", "1")]);
    assert_eq!(flag.message, "a number (1); true or false is expected");
    // The line is that of the key: Name, Type and Template come first, then flags.
    assert_eq!(flag.line, Some(5));
    // The message suggests a similar key.
    let near = error(&[("Spindle/Mass", ""), ("Spindle/mass", "3")]);
    assert!(near.message.ends_with("there is \"mass\""), "{near}");
}

#[test]
fn every_key_that_is_asked_for_is_missed() {
    let mut checked = 0;
    for (template, keys) in all() {
        let optional = ["/Radius", "/Width", "Coefficient", "/Free Length"];
        for (key, _) in keys.iter().filter(|k| !optional.iter().any(|o| k.0.contains(o))) {
            let text = file(template, &changed(&keys, &[(key, "")]));
            let error = import_text(&text, &on(Side::Left)).expect_err(key);
            // If the key was the only one of its section, the section is reported as missing.
            let section = key.split('/').next();
            let missed = |d: &Diagnostic| {
                d.code == "missing-key"
                    && (d.element.as_deref() == Some(key) || d.element.as_deref() == section)
            };
            assert!(error.diagnostics.iter().any(missed), "{template}: {key}: {error}");
            checked += 1;
        }
    }
    assert!(checked > 120, "{checked}");
}

#[test]
fn unknown_templates_and_kinds_are_refused() {
    let text = file("SolidAxle", &double_wishbone());
    let unknown = import_text(&text, &on(Side::Left)).unwrap_err().to_string();
    assert!(unknown.contains("\"SolidAxle\"") && unknown.contains("MacPhersonStrut"), "{unknown}");
    let text = file("DoubleWishbone", &double_wishbone()).replace("Suspension", "Steering");
    let kind = import_text(&text, &on(Side::Left)).unwrap_err();
    assert!(kind.diagnostics.iter().any(|d| d.code == "wrong-kind"), "{kind}");
}

#[test]
fn text_that_is_no_json_is_refused_with_its_place() {
    type Case = (&'static str, &'static str, Option<(u32, u32)>);
    let cases: [Case; 9] = [
        ("", "empty-file", None),
        ("  \n", "empty-file", None),
        ("{\n  \"a\": NaN\n}", "not-json", Some((2, 8))),
        ("{\n  \"a\": 1,\n}", "not-json", Some((3, 1))),
        ("{ \"a\": 1 ", "not-json", Some((1, 9))),
        ("<robot name=\"r\"/>", "not-json", Some((1, 1))),
        ("[1]", "not-json", Some((1, 1))),
        ("{ /* \n", "not-json", Some((1, 3))),
        ("{\"a\":\0}", "binary", None),
    ];
    for (text, code, place) in cases {
        let error = import_text(text, &on(Side::Left)).unwrap_err();
        let [.., found] = &error.diagnostics[..] else { panic!("{text}: nothing said") };
        assert_eq!(found.code, code, "{text}: {found}");
        let at = found.line.zip(found.column);
        assert_eq!(at, place, "{text}: {found}");
    }
    let deep = format!("{{\"a\": {}", "[".repeat(100_000));
    assert!(
        import_text(&deep, &on(Side::Left)).unwrap_err().diagnostics.iter().any(|d| d.code == "too-complex")
    );
    let latin = Source::new("x", b"{\"Name\": \"\xe9\"}".to_vec());
    let error = import(&latin, &on(Side::Left)).unwrap_err();
    assert!(error.diagnostics.iter().any(|d| d.code == "not-utf-8"));
}

#[test]
fn hardpoints_that_make_no_joint_are_refused() {
    let front = "Lower Control Arm/Location Chassis Front";
    let cases: [(&str, &'static str, &'static str); 4] = [
        (front, "[-0.25, 0.33, -0.08]", "Lower Control Arm"),
        ("Lower Control Arm/Location Upright", "[0.65, 0.37, -0.12]", "Lower Control Arm"),
        ("Spring/Location Chassis", "[0.06, 0.62, -0.1]", "Spring"),
        ("Tierod/Location Chassis", "[-0.15, 0.8, -0.03]", "Tierod"),
    ];
    for (key, value, element) in cases {
        let key: &'static str = double_wishbone().iter().find(|k| k.0 == key).unwrap().0;
        let found = error(&[(key, value)]);
        let expected = if element == "Tierod" { "bad-distance" } else { "degenerate-geometry" };
        assert_eq!((found.code, found.element.as_deref()), (expected, Some(element)), "{found}");
    }
    let others = [
        ("ThreeLinkIRS", changed(&three_link_irs(), &[("Upper Link/Universal Joint Axis", "[0, 0, 1]")])),
        ("ThreeLinkIRS", changed(&three_link_irs(), &[("Lower Link/Location Arm", "[-0.02, 0.2, -0.1]")])),
        ("MultiLink", changed(&multi_link(), &[("Lateral/Universal Joint Axis Link", "[0, 0, 1]")])),
        ("MultiLink", changed(&multi_link(), &[("Lateral/Universal Joint Axis Link", "[0, 0, 0]")])),
        ("MultiLink", changed(&multi_link(), &[("Spring/Location Link", "[0.35, 0.715, -0.11]")])),
        (
            "MacPhersonStrut",
            changed(&macpherson_strut(), &[("Spring/Location Chassis", "[0.37, 0.91, -0.12]")]),
        ),
    ];
    for (template, keys) in others {
        let error = import_text(&file(template, &keys), &on(Side::Left)).expect_err(template);
        assert!(error.diagnostics.iter().any(|d| d.code == "degenerate-geometry"), "{template}: {error}");
    }
}

#[test]
fn masses_and_inertias_are_judged_by_the_builder_and_placed_in_the_file() {
    let found = error(&[("Upper Control Arm/Mass", "-1")]);
    assert_eq!((found.code, found.element.as_deref()), ("negative-mass", Some("Upper Control Arm")));
    assert!(found.line.is_some());
    let found = error(&[("Axle/Inertia", "-1")]);
    assert_eq!((found.code, found.element.as_deref()), ("negative-inertia", Some("Axle")));
    let keys = changed(&double_wishbone(), &[("Upright/Moments of Inertia", "[0.1, 0.1, 0.3]")]);
    // The warning occurs once, not once per side.
    for side in [Side::Left, Side::Both] {
        let found = doubts("DoubleWishbone", &keys, &on(side));
        let triangle = found.iter().filter(|d| d.1 == "triangle-inequality");
        assert_eq!(triangle.map(|d| &*d.2).collect::<Vec<_>>(), ["Upright"], "{side:?}");
    }
    // The check of the spindle applies to the values in the file, without the axle.
    let keys = changed(&double_wishbone(), &[("Spindle/Inertia", "[0.1, 0.3, 0.1]")]);
    let found = doubts("DoubleWishbone", &keys, &on(Side::Both));
    let triangle: Vec<_> = found.iter().filter(|d| d.1 == "triangle-inequality").collect();
    assert_eq!(triangle.len(), 1);
    assert_eq!(triangle[0].2, "Spindle");
}

#[test]
fn what_looks_odd_is_doubted() {
    let cases: [(&'static str, &'static str, &str, &str); 3] = [
        ("Upright/Colour", "\"red\"", "unknown-key", "Upright/Colour"),
        ("Author", "\"me\"", "unknown-key", "Author"),
        ("Upright/Bushing Data", "{}", "bushing", "Upright/Bushing Data"),
    ];
    for (key, value, code, element) in cases {
        let found = doubts("DoubleWishbone", &changed(&double_wishbone(), &[(key, value)]), &on(Side::Left));
        assert_eq!(found, [(Severity::Warning, code, element.to_owned())]);
    }
    // The spindle's centre of mass is on the other side, away from the joints of its upright.
    let found = doubts(
        "DoubleWishbone",
        &changed(&double_wishbone(), &[("Spindle/COM", "[0, -0.9, 0]")]),
        &on(Side::Left),
    );
    let expected = ["right-side", "astray-point"];
    assert_eq!(found, expected.map(|code| (Severity::Warning, code, "Spindle".to_owned())));
    let oblique = changed(&multi_link(), &[("Lateral/Universal Joint Axis Link", "[1, 0, 0.1]")]);
    let found = doubts("MultiLink", &oblique, &on(Side::Left));
    assert_eq!(found, [(Severity::Warning, "oblique-pins", "Lateral".to_owned())]);
    // The products of inertia of the mirror image differ from those of Chrono's right side.
    let found = doubts("DoubleWishbone", &double_wishbone(), &on(Side::Right));
    assert_eq!(found, [(Severity::Note, "mirrored-products", "Upright".to_owned())]);
    assert_eq!(doubts("MultiLink", &multi_link(), &on(Side::Both)), []);
}

#[test]
fn the_same_key_twice_is_refused() {
    let text = file("DoubleWishbone", &double_wishbone()).replacen(
        "\"Mass\": 2.0",
        "\"Mass\": 2.0, \"Mass\": 3.0",
        1,
    );
    let error = import_text(&text, &on(Side::Left)).unwrap_err();
    assert!(error.diagnostics.iter().any(|d| d.code == "duplicate-key"), "{error}");
}

#[test]
fn options_are_judged_too() {
    let text = file("DoubleWishbone", &double_wishbone());
    let mut wheel = WHEEL;
    wheel.radius = Some(f64::NAN);
    let options = ImportOptions { wheel: Some(wheel), ..ImportOptions::default() };
    assert!(import_text(&text, &options).unwrap_err().to_string().contains("radius is NaN"));
    wheel.radius = None;
    wheel.mass = -1.0;
    let options = ImportOptions { wheel: Some(wheel), ..ImportOptions::default() };
    let error = import_text(&text, &options).unwrap_err().to_string();
    assert!(error.contains("link \"wheel\"") && error.contains("-1"), "{error}");
    let options =
        ImportOptions { rack: Some(Rack::Sliding { mass: f64::INFINITY }), ..ImportOptions::default() };
    assert!(import_text(&text, &options).is_err());
}

#[test]
fn many_odd_keys_hide_no_error() {
    let odd = |count| -> String { (0..count).map(|i| format!("\"k{i}\": 0, ")).collect() };
    let text = file("DoubleWishbone", &double_wishbone());
    let many = text.replacen("\"COM\": ", &format!("{}\"COM\": ", odd(600)), 1);
    let many = many.replacen("\"Width\": 0.05", "\"Width\": 0.05, \"Mass\": 1", 1);
    let error = import_text(&many, &on(Side::Left)).unwrap_err();
    assert!(error.diagnostics.iter().any(|d| d.code == "duplicate-key"));
    assert!(error.diagnostics.len() < 60, "{}", error.diagnostics.len());
    let huge = text.replacen("\"COM\": ", &format!("{}\"COM\": ", odd(2000)), 1);
    let error = import_text(&huge, &on(Side::Left)).unwrap_err();
    assert!(error.diagnostics.iter().any(|d| d.code == "too-complex"));
}

#[test]
fn no_mutilated_file_makes_it_panic() {
    let mut refused = 0;
    for (template, keys) in all() {
        let bytes = file(template, &keys).into_bytes();
        for at in (0..bytes.len()).step_by(5) {
            let cut = Source::new("cut", bytes[..at].to_vec());
            refused += usize::from(import(&cut, &on(Side::Both)).is_err());
            for byte in [b'0', b'-', b'"', b'{', b']', b'/', b'*', b'\\', b'e', 0xC3] {
                let mut changed = bytes.clone();
                changed[at] = byte;
                refused += usize::from(import(&Source::new("x", changed), &on(Side::Both)).is_err());
            }
        }
    }
    assert!(refused > 1000, "{refused}");
}
