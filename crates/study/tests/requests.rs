//! Requests about a model in memory.

use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions, Source};
use percuss_study::{Changes, CodeQuestion, ContactTable, LanguageName, MassQuestion, Model};
use percuss_study::{ask, check, explain, generate_code, study_keys, study_schema};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// Tables that are part of other questions.
const PARTS: [&str; 7] = ["model", "conditions", "pose", "hold", "closure", "variant", "report"];

fn pendulum() -> Model {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/point_mass_pendulum.urdf");
    Model::load(path, DEFAULT_MAX_SIZE, &LoadOptions::default()).expect("a model")
}

#[test]
fn every_output_file_is_refused() {
    let model = pendulum();
    let keys: Vec<String> = study_keys().into_iter().filter(|key| key.ends_with(".output")).collect();
    for key in &keys {
        let (table, last) = key.split_once('.').expect("a table and a key");
        let request = format!("{{\"{table}\": {{\"{last}\": \"file.csv\"}}}}");
        let message = ask(&model, &request).expect_err(key).message();
        assert!(message.starts_with(&format!("{key}: a request writes no file")), "{message}");
    }
    assert_eq!(keys.len(), 9, "{keys:?}");
}

#[test]
fn every_question_has_its_key_in_the_report() {
    let model = pendulum();
    let contact = json!({"link": "rod", "point": [0, 0, -0.8], "normal": [1, 0, 0]});
    let measured = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/measured/bump_stop.csv");
    let request = json!({
        "contact": contact, "identify": {"data": measured}, "response": {"frequency": "1:10:3"}, "mass": {"explain": true}, "damping": {"stiffness": 1e4, "restitution": 0.5},
        "impact": {"restitution": 0.5, "speed": 1}, "extremes": {"range": ["hinge=-1:1"]},
        "sweep": {"vary": "hinge=0:1:2"}, "map": {"link": "rod", "point": [0, 0, -0.8], "directions": 8},
        "safe_speed": {"energy": 1}, "restitution": {"stiffness": 1e4, "damping": 10, "speed": 1}, "check": {}, "generate": {"language": "rust", "gradient": true}, "convert": {"to": "mjcf"},
    });
    let report = ask(&model, &request.to_string()).unwrap_or_else(|error| panic!("{}", error.message()));
    let report: Value = serde_json::from_str(&report.to_json()).expect("JSON");
    // The contact is part of the mass, and so is the damper of a contact. Kinematics require a suspension, an export a link with mass.
    let own: BTreeSet<&str> =
        ["contact", "damping", "kinematics", "targets", "export"].into_iter().chain(PARTS).collect();
    let tables = study_schema()["properties"].as_object().expect("tables");
    for table in tables.keys().filter(|table| !own.contains(table.as_str())) {
        assert!(report.get(table).is_some(), "{table}");
    }
    let same = |key: &str, other: Value| assert_eq!(report[key], other, "{key}");
    same("check", serde_json::to_value(check(&model).expect("contents")).expect("JSON"));
    let contact = ContactTable::at_point("rod", [0.0, 0.0, -0.8], [1.0, 0.0, 0.0]);
    let question = MassQuestion { contact, ..MassQuestion::default() };
    let explanation = explain(&model, &question).expect("a finite mass");
    assert_eq!(report["mass"]["explanation"], serde_json::to_value(explanation).expect("JSON"));
    let code = CodeQuestion { language: LanguageName::Rust, gradient: true, ..CodeQuestion::default() };
    let code = generate_code(&model, &question, &code).expect("code");
    assert!(code.files[0].text.contains("pub fn mass"), "{:?}", code.files);
    same("generate", serde_json::to_value(code).expect("JSON"));
}

#[test]
fn files_are_in_the_report() {
    let text = r#"<robot name="r"><link name="a"><visual><geometry><box size="1 1 1"/></geometry><material name="red"/></visual></link></robot>"#;
    let model = Model::from_source(&Source::from_text("r.urdf", text), &LoadOptions::default());
    let model = model.expect("a model");
    let report = ask(&model, r#"{"convert": {"to": "urdf"}}"#).expect("a model").convert.expect("a report");
    let lost: Vec<_> = report.changes.iter().map(|change| change.what.as_str()).collect();
    assert!(lost.contains(&"<material> in <visual>"), "{lost:?}");
    assert!(report.files[0].text.contains("<robot name=\"r\""), "{:?}", report.files);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/planar_2r.urdf");
    let arm = Model::load(path, DEFAULT_MAX_SIZE, &LoadOptions::default()).expect("a model");
    let request = r#"{"contact": {"link": "outer", "point": [0.4, 0, 0], "normal": [1, 0, 0]}, "pose": {"set": {"elbow": "90deg"}},
        "damping": {"stiffness": 1e4, "restitution": 0.5}, "export": {}}"#;
    let report = ask(&arm, request).expect("an impact").export.expect("a report");
    let names: Vec<_> = report.files.iter().map(|file| file.name.as_str()).collect();
    assert!(names == ["model.xml", "model.py"] && report.effective_mass > 4.7, "{report:?}");
    let message = ask(&model, r#"{"convert": {}}"#).expect_err("no format").message();
    assert!(message.starts_with("convert.to: the format is missing"), "{message}");
}

/// A changed mass is implausible above fifty times the old mass and fifty times the mass of all other links.
#[test]
fn a_changed_mass_is_compared_with_all_other_links() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/planar_2r.urdf");
    let arm = Model::load(path, DEFAULT_MAX_SIZE, &LoadOptions::default()).expect("a model");
    // The other link has 4 kg, and this one had 2 kg.
    for (mass, is_implausible) in [(150.0, false), (199.0, false), (201.0, true)] {
        let changes = Changes { link_mass: vec![("outer".to_owned(), mass)], ..Changes::default() };
        let changed = arm.with_changes(&changes).expect("a model");
        let warns = changed.diagnostics.iter().any(|found| found.code == "implausible-mass");
        assert_eq!(warns, is_implausible, "{mass} kg: {:?}", changed.diagnostics);
    }
}
