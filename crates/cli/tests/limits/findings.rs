//! Every finding × every output: each finding is raised by a small input and appears in the text and the JSON of a mass, beside the table
//! and in the JSON of a sweep, and in the HTML report. `crates/capi/tests/findings.rs` has the outputs of the library and of the C interface.

use super::finding_cases::{Case, cases, codes};
use crate::support::{Scratch, done, percuss};
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

/// Findings that a command does not state. Each contact of a map has its own status and error; the extremes state the gap of a stop, and
/// begin at the pose as drawn; an inertia at a joint has no contact.
const NOT_STATED: [(&str, &[&str]); 3] = [
    (
        "map",
        &[
            "hold-pulls",
            "hold-undetermined",
            "immovable-mechanism",
            "indefinite-mass-matrix",
            "massless-motions",
            "nearly-immovable",
            "uncertain-mass",
            "unclear-rank-here",
            "undetermined-motion",
        ],
    ),
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
