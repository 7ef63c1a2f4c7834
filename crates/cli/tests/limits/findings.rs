//! Every finding × every output: each finding is raised by a small input and appears in the text and the JSON of a mass, beside the table
//! and in the JSON of a sweep, and in the HTML report. `crates/capi/tests/findings.rs` has the outputs of the library and of the C interface.

use super::finding_cases::{Case, cases, codes};
use crate::support::{Scratch, done, percuss, root};
use serde_json::Value;
use std::fs;

/// Findings at a pose or a row that no case raises, and the reason.
const NOT_RAISED: [(&str, &str); 11] = [
    ("base-not-given", "the world of a question is the frame of its root link"),
    ("bushes-rigid", "a case is a URDF, which has no bushes"),
    ("gears-rigid", "a case has no stiffness of a gear"),
    ("massless-to-rounding", "masses over so many decades are no plausible model"),
    ("no-compliance", "a case is a URDF, which has no bushes"),
    ("no-answer", "a mass has an error in its place"),
    ("not-finite", "a mass has an error in its place"),
    ("not-unit-quaternion", "a mass has an error in its place"),
    ("open-loops", "a mass has an error in its place"),
    ("other-assembly", "the library accepts another assembly mode, a question does not"),
    ("unknown-error", "the pose is closer to a singular pose than positions can be given"),
];

/// Findings that a command does not state. The directions of a map are not the normal of the case; the extremes state the gap of a stop, and
/// begin at the pose as drawn; an inertia at a joint has no contact.
const NOT_STATED: [(&str, &[&str]); 3] = [
    ("map", &["nearly-immovable", "uncertain-mass"]),
    ("extremes", &["open-gap", "stop-passed", "unclear-rank-here"]),
    (
        "inertia",
        &[
            "far-from-guess",
            "far-point",
            "hold-pulls",
            "hold-undetermined",
            "immovable-mechanism",
            "indefinite-mass-matrix",
            "massless-motions",
            "nearly-immovable",
            "open-gap",
            "point-converted",
            "point-mass-base",
            "singular-pose",
            "stop-passed",
            "uncertain-mass",
            "unclear-rank-here",
            "undetermined-motion",
            "unused-guess",
        ],
    ),
];

/// Study of a case, with the model beside it.
fn study(case: &Case) -> String {
    let mut tables: toml::Table = serde_json::from_str(&case.request(false)).expect("tables");
    let accepted: Vec<&str> = case.accepted().into_iter().collect();
    let model = format!("path = \"model.urdf\"\naccept = {accepted:?}");
    tables.insert("model".to_owned(), toml::Value::Table(model.parse().expect("a table")));
    toml::to_string(&tables).expect("a study")
}

/// Message of the finding in a report.
fn message(report: &Value, code: &str) -> Option<String> {
    let found = report["diagnostics"].as_array()?.iter().find(|finding| finding["code"] == code)?;
    Some(found["message"].as_str()?.to_owned())
}

/// First long part of a message without a quotation mark: HTML has an entity in its place, and the end may name a flag or a key.
fn part(message: &str) -> &str {
    message.split(['"', '<', '>', '&', '(', ')', ';']).find(|part| part.len() > 20).unwrap_or(message)
}

#[test]
fn every_finding_is_in_every_output() {
    let scratch = Scratch::new("findings");
    let (mut missing, mut further) = (Vec::new(), 0);
    for case in cases() {
        let Case { code, model, contact, pose, .. } = &case;
        let file = scratch.write("model.urdf", model);
        let accept = case.accepted().map_or_else(String::new, |accepted| format!("--accept {accepted}"));
        let mass = format!("--notes mass {file} {contact} {accept} {pose}");
        let mut expect = |output: &str, message: Option<&str>, text: &str| match message {
            Some(message) if text.contains(&*part(message).replace('−', "-")) => {}
            _ => missing.push(format!("{code}, {output}: {message:?}")),
        };
        let report = percuss(&format!("{mass} --format json"));
        let of_mass = serde_json::from_str(&report.stdout).ok().and_then(|json| message(&json, code));
        let of_mass = of_mass.as_deref();
        expect("JSON", of_mass, &report.stdout.replace("\\\"", "\""));
        let flat_text = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").replace('−', "-");
        expect("text", of_mass, &flat_text(&percuss(&mass).stderr));
        if let Some(range) = case.range() {
            let sweep = format!("--notes sweep {file} {contact} {accept} --vary {range} --force");
            let json = scratch.path("rows.json");
            let table = percuss(&format!("{sweep} -o {json}"));
            let rows = fs::read_to_string(&json).unwrap_or_default();
            let of_rows = serde_json::from_str(&rows).ok().and_then(|json| message(&json, code));
            expect("JSON of a sweep", of_rows.as_deref(), &rows.replace("\\\"", "\""));
            expect("beside the JSON of a sweep", of_rows.as_deref(), &flat_text(&table.stderr));
            expect("beside the CSV of a sweep", of_rows.as_deref(), &flat_text(&percuss(&sweep).stderr));
        }
        let law = "--restitution 0.3 --stiffness 1e5 --speed 1";
        // The contact without its normal.
        let of_point = contact.split_once(" --normal ").filter(|(before, _)| before.contains("--point"));
        let of_point = of_point.map(|(before, after)| {
            format!("{before} {}", after.split_once(' ').map_or("", |(_, further)| further))
        });
        let mut lines = vec![
            ("damp", format!("damp --mass-from {file} {contact} {pose} {law}")),
            ("compare", format!("compare {file} {file} {contact} {pose}")),
        ];
        lines.extend(of_point.map(|contact| ("map", format!("map {file} {contact} {pose} --directions 3"))));
        if let Some((joint, ends)) = case.range().as_deref().and_then(|range| range.split_once('=')) {
            let ends = ends.trim_end_matches(":2");
            lines.push(("extremes", format!("extremes {file} {contact} --starts 2 --range {joint}={ends}")));
            lines.push(("inertia", format!("impact {file} --reflected {joint} {pose}")));
        }
        for (output, line) in lines {
            let report = percuss(&format!("--notes {line} {accept} --format json"));
            let is_excepted = NOT_STATED.iter().any(|(of, codes)| *of == output && codes.contains(code));
            // A refused question has an error in place of a finding.
            if report.code == 0 && !is_excepted {
                let found = serde_json::from_str(&report.stdout).ok().and_then(|json| message(&json, code));
                expect(
                    output,
                    found.as_deref(),
                    &flat_text(&percuss(&format!("--notes {line} {accept}")).stderr),
                );
                further += 1;
            }
        }
        scratch.write("study.toml", &study(&case));
        done(&scratch, &["run", "study.toml", "--report", "page.html", "--force"]);
        for (output, file) in [("HTML", "page.html"), ("JSON of a report", "page.json")] {
            let page = fs::read_to_string(scratch.path(file)).expect("a report");
            expect(output, of_mass, &flat_text(&page).replace("\\\"", "\""));
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
    assert!(further > 60, "{further} results of other commands");
    let raised: Vec<&str> =
        cases().iter().map(|case| case.code).chain(NOT_RAISED.map(|(code, _)| code)).collect();
    assert!(
        codes().count() > 30 && codes().all(|code| raised.contains(&code)),
        "{:?}",
        codes().collect::<Vec<_>>()
    );
}

/// Sheet with a fault, and the findings at one of its contacts.
struct FaultyContact {
    /// Texts and their replacements.
    edits: &'static [[&'static str; 2]],
    contact: &'static str,
    codes: &'static [&'static str],
}

/// Findings about the path of a stop to its touch, and about the motion of a spring.
const FAULTY_CONTACTS: [FaultyContact; 4] = [
    FaultyContact {
        edits: &[
            ["bump_stop_pad =", "pad ="],
            ["\nbump_stop =", "\nbump_stop_pad ="],
            ["\npad =", "\nbump_stop ="],
        ],
        contact: "bump_stop",
        codes: &["wrong-way-stop"],
    },
    FaultyContact {
        edits: &[["gap = 30.0 ", "gap = 150.0 "]],
        contact: "bump_stop",
        codes: &["behind-dead-centre", "far-contact-travel"],
    },
    FaultyContact {
        edits: &[["gap = 30.0 ", "direction = [1.0, 0.2, 0.4]\ngap = 5.0 "]],
        contact: "bump_stop",
        codes: &["oblique-stop"],
    },
    FaultyContact {
        edits: &[["[-10.0, 500.0, 560.0]", "[-10.0, 500.0, 20.0]"]],
        contact: "spring",
        codes: &["extending-element"],
    },
];

#[test]
fn findings_of_a_named_contact_are_in_every_output() {
    let scratch = Scratch::new("contact-findings");
    let sheet = fs::read_to_string(root().join("models/suspensions/double-wishbone.toml")).expect("a sheet");
    let law = "--restitution 0.3 --stiffness 4e5 --speed 0.5";
    let mut missing = Vec::new();
    for FaultyContact { edits, contact, codes } in FAULTY_CONTACTS {
        let text = edits.iter().fold(sheet.clone(), |text, [from, to]| text.replacen(from, to, 1));
        let file = scratch.write("faulty.toml", &text);
        let at = format!("{file} --at {contact}");
        let lines = [
            format!("mass {at}"),
            format!("mass {at} {law}"),
            format!("damp --mass-from {at} {law}"),
            format!("restitution {at} --stiffness 4e5 --damping 900 --speed 0.5"),
            format!("response {at} --frequency 10:100Hz:3"),
            format!("impact {at} --restitution 0.3 --speed 0.5"),
            format!("impact {at} {law} --in-time"),
            format!("extremes {at} --path wheel-travel=-5mm:5mm:3"),
            format!("compare {file} {at}"),
            format!("kinematics {file} --solve lower_ball.z --for mass_{contact}=100kg --within 1mm"),
        ];
        for line in &lines {
            let report = percuss(&format!("--notes {line} --format json"));
            let json: Value = serde_json::from_str(&report.stdout).unwrap_or_default();
            let text = percuss(&format!("--notes {line}")).stderr;
            let text = text.split_whitespace().collect::<Vec<_>>().join(" ").replace('−', "-");
            for code in codes {
                match message(&json, code) {
                    Some(found) if text.contains(&*part(&found).replace('−', "-")) => {}
                    found => missing.push(format!("{code}, {line}: {found:?}; {}", report.stderr)),
                }
            }
        }
        let found = percuss(&format!("mass {at} --format json"));
        let found: Value = serde_json::from_str(&found.stdout).expect("a report");
        let out = scratch.path("x");
        for line in [
            format!("sweep {at} --wheel-travel -5mm:5mm:3"),
            format!("generate {at} -o {out} --force"),
            format!("export {at} {law} -o {out}.xml --force"),
        ] {
            let text = percuss(&format!("--notes {line}")).stderr;
            let text = text.split_whitespace().collect::<Vec<_>>().join(" ").replace('−', "-");
            for code in codes {
                let expected = message(&found, code).map(|found| part(&found).replace('−', "-"));
                if !expected.is_some_and(|expected| text.contains(&expected)) {
                    missing.push(format!("{code}, {line}: {text}"));
                }
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Block on a hinge. The normals of two triangles of its face pass the axis at 10 nm: the closing speed is 10 nm per 0.4 m of its terms.
const NEAR_BLOCK: &str = r#"<robot name="near"><link name="base"/><link name="arm">
  <inertial><origin xyz="0.3 0 0"/><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  <collision><origin xyz="0.3 0.10000001 0"/><geometry><box size="0.2 0.6 0.2"/></geometry></collision></link>
  <joint name="hinge" type="continuous"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/></joint></robot>"#;

#[test]
fn single_contacts_of_a_map_have_findings() {
    let scratch = Scratch::new("map-findings");
    let file = scratch.write("near.urdf", NEAR_BLOCK);
    let map = format!("--notes map {file} --link arm --edge 10");
    // 12 triangles: two are nearly immovable, four are parallel to the axis; a point held on the line of the normals pulls for four.
    for (flags, code, count) in [
        ("", "nearly-immovable", "and 1 more)"),
        ("--against-mass 2kg", "immovable-mechanism", "and 3 more)"),
        ("--hold arm:0.3,0.1,0:0,-1,0", "hold-pulls", "and 3 more)"),
    ] {
        let report = percuss(&format!("{map} {flags} --format json"));
        let json: Value = serde_json::from_str(&report.stdout).expect("a report");
        let found = message(&json, code).unwrap_or_default();
        assert!(found.starts_with("link \"arm\": ") && found.ends_with(count), "{flags}: {found}");
        let text = percuss(&format!("{map} {flags}")).stderr;
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(part(&found)), "{flags}: {text}");
    }
}
