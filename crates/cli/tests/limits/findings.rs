//! Every finding × every output: each finding is raised by a small input and appears in the text and the JSON of a mass, beside the table
//! and in the JSON of a sweep, and in the HTML report.

use crate::support::{Scratch, done, percuss, root};
use serde_json::Value;
use std::fs;

/// Finding, and an input that raises it.
struct Case {
    code: &'static str,
    model: String,
    /// Flags of the contact and its conditions.
    contact: &'static str,
    /// Flags of the pose of a mass.
    pose: &'static str,
    /// Joint and first position of the rows of a sweep; empty if no row can be given.
    vary: &'static str,
}

/// Findings at a pose or a row that no case raises, and the reason.
const NOT_RAISED: [(&str, &str); 8] = [
    ("base-not-given", "the world of a question is the frame of its root link"),
    ("massless-to-rounding", "masses over so many decades are no plausible model"),
    ("no-answer", "a mass has an error in its place"),
    ("not-finite", "a mass has an error in its place"),
    ("not-unit-quaternion", "a mass has an error in its place"),
    ("open-loops", "a mass has an error in its place"),
    ("other-assembly", "the library accepts another assembly mode, a question does not"),
    ("unknown-error", "the pose is closer to a singular pose than positions can be given"),
];

/// URDF of a model of the repository with one part replaced.
fn changed(model: &str, from: &str, to: &str) -> String {
    let text = fs::read_to_string(root().join("models").join(model)).expect("a model");
    assert!(from.is_empty() || text.contains(from), "{model}: {from}");
    text.replacen(from, to, 1)
}

/// Chain of a link on a slide and a link on a hinge, with the inertias of the ground and of the two links; a stop 0.5 m in front of the slide.
fn chain_on(ground: &str, rod: &str, tip: &str) -> String {
    format!(
        r#"<robot name="chain"><link name="ground">{ground}</link><link name="rod">{rod}</link><link name="tip">{tip}</link>
        <joint name="slide" type="prismatic"><parent link="ground"/><child link="rod"/><axis xyz="1 0 0"/>
        <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
        <joint name="turn" type="continuous"><parent link="rod"/><child link="tip"/><axis xyz="0 0 1"/></joint>
        <contact name="buffer" type="stop"><body link="rod" xyz="0 0 0"/><other link="ground"/><normal xyz="1 0 0"/>
        <gap value="0.5"/></contact></robot>"#
    )
}

fn chain(rod: &str, tip: &str) -> String {
    chain_on("", rod, tip)
}

fn inertial(mass: f64, izz: f64) -> String {
    format!(
        r#"<inertial><mass value="{mass}"/><inertia ixx="1" iyy="1" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial>"#
    )
}

/// Bar on a ball, with a rod from its tip to the ground.
const TIED: &str = r#"<robot name="tied"><link name="ground"/><link name="bar"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
    <inertia ixx="0.01" iyy="0.2" izz="0.2" ixy="0" ixz="0" iyz="0"/></inertial></link>
    <joint name="ball" type="spherical"><parent link="ground"/><child link="bar"/></joint>
    <loop name="rod" type="distance"><predecessor link="ground"><origin xyz="0 0 1"/></predecessor>
    <successor link="bar"><origin xyz="1 0 0"/></successor><distance value="1.4142135623730951"/></loop></robot>"#;

/// Four-bar with all joints at 0 on one line: lengths of crank, coupler, rocker and ground. `turned`: angle of the crank, rad.
fn flat(turned: f64, [crank, coupler, rocker, ground]: [f64; 4]) -> String {
    let body = inertial(1.0, 0.5);
    format!(
        r#"<robot name="flat"><link name="ground"/><link name="crank">{body}</link><link name="coupler">{body}</link><link name="rocker">{body}</link>
        <joint name="crank_hinge" type="continuous" independent="true"><parent link="ground"/><child link="crank"/><origin rpy="0 0 {turned}"/>
        <axis xyz="0 0 1"/></joint>
        <joint name="pin" type="continuous"><parent link="crank"/><child link="coupler"/><origin xyz="{crank} 0 0"/><axis xyz="0 0 1"/></joint>
        <joint name="rocker_hinge" type="continuous"><parent link="ground"/><child link="rocker"/><origin xyz="{ground} 0 0"/><axis xyz="0 0 1"/></joint>
        <loop name="end" type="revolute"><predecessor link="coupler"><origin xyz="{coupler} 0 0"/></predecessor>
        <successor link="rocker"><origin xyz="{rocker} 0 0"/></successor><axis xyz="0 0 1"/></loop></robot>"#
    )
}

fn cases() -> Vec<Case> {
    let case = |code, model, contact, pose, vary| Case { code, model, contact, pose, vary };
    let body = inertial(2.0, 1.0);
    let bodies = || chain(&body, &body);
    let on_rod =
        |code, model, pose, vary| case(code, model, "--link rod --point 0,0,0 --normal 1,0,0", pose, vary);
    let bar = |code, from: &str, to: &str| {
        let model = changed("four_bar.urdf", from, to);
        let contact = "--link coupler --point 0.35,0.1,0 --normal 0,1,0";
        case(code, model, contact, "--set crank_hinge=0.1", "crank_hinge=0.1")
    };
    let straight = |code, pose, vary| {
        let contact = "--link coupler --point 0.3,0,0 --normal 0,1,0";
        case(code, flat(0.0, [0.5, 1.0, 0.5, 1.0]), contact, pose, vary)
    };
    // A redundant loop off by a part of its length.
    let off = |code, length: &str| {
        let model =
            changed("parallelogram.urdf", "      <origin xyz=\"1", &format!("      <origin xyz=\"{length}"));
        case(code, model, "--link platform --point 0.3,0.1,0 --normal 1,0,0", "", "")
    };
    let on_tip = "--link tip --point 0.1,0,0 --normal 1,0,0";
    let rocker_pin = "<origin xyz=\"-0.25 0.6 0\"/>";
    vec![
        on_rod("outside-limits", bodies(), "--set slide=2", "slide=2"),
        Case { pose: "--set crank_hinge=100", vary: "crank_hinge=100", ..bar("many-turns", "", "") },
        Case { contact: "--link coupler --point 350,0.1,0 --normal 0,1,0", ..bar("far-point", "", "") },
        bar("drawn-open", "xyz=\"0.4 0.3 0\"", "xyz=\"0.42 0.3 0\""),
        bar("drivers-chosen", " independent=\"true\"", ""),
        bar("inexact-loops", rocker_pin, "<origin xyz=\"-0.25 0.6 0\" rpy=\"1e-6 0 0\"/>"),
        bar("reversed-axis", rocker_pin, "<origin xyz=\"-0.25 0.6 0\" rpy=\"3.141592653589793 0 0\"/>"),
        Case {
            contact: "--link coupler --point 0.35,0.1,0 --normal 0,1,0 --guess rocker_hinge=3.5",
            ..bar("far-from-guess", "", "")
        },
        Case {
            contact: "--link coupler --point 0.35,0.4,0 --normal 0,1,0 --frame world",
            ..bar("point-converted", "", "")
        },
        case(
            "nearly-immovable",
            bodies(),
            "--link rod --point 0,0,0 --normal 1e-7,1,0",
            "--set slide=0.1",
            "slide=0.1",
        ),
        case(
            "uncertain-mass",
            bodies(),
            "--link rod --point 0,0,0 --normal 1e-9,1,0",
            "--set slide=0.1",
            "slide=0.1",
        ),
        on_rod("massless-motions", chain(&body, ""), "--set slide=0.1", "slide=0.1"),
        on_rod("undetermined-motion", chain(&body, ""), "--set slide=0.1", "slide=0.1"),
        straight("singular-pose", "--set crank_hinge=0", "crank_hinge=0"),
        straight("unclear-rank-here", "--set crank_hinge=1e-9", "crank_hinge=1e-9"),
        case(
            "driver-off-zero",
            flat(1.0, [1.0, 0.6, 0.5, 1.9]),
            "--link coupler --point 0.3,0,0 --normal 0,1,0",
            "",
            "",
        ),
        off("unclear-rank", "1.000000001"),
        off("weakly-constrained", "1.0000001"),
        off("rigid-loops", "1.001"),
        case(
            "off-target",
            TIED.to_owned(),
            "--link bar --point 1,0,0 --normal 0,1,0",
            "--set ball=0.9950041652780258,0,0.09983341664682815,0",
            "",
        ),
        case("open-gap", bodies(), "--at buffer", "--set slide=0.1", "slide=0.1"),
        case("stop-passed", bodies(), on_tip, "--travel rod:0,0,0:1,0,0=0.6", "slide=0.6"),
        case(
            "unused-guess",
            bodies(),
            "--link rod --point 0,0,0 --normal 1,0,0 --guess turn=1",
            "",
            "slide=0.1",
        ),
        case(
            "immovable-mechanism",
            bodies(),
            "--link rod --point 0,0,0 --normal 0,0,1 --against-mass 3",
            "",
            "slide=0.1",
        ),
        case(
            "point-mass-base",
            chain_on(&inertial(5.0, 0.0).replace("\"1\"", "\"0\""), &body, &body),
            "--link rod --point 0,0,0 --normal 1,0,0 --base floating",
            "",
            "slide=0.1",
        ),
        case(
            "hold-undetermined",
            chain(&body, ""),
            "--link tip --point 0.5,0,0 --normal 0,1,0 --hold rod:0,0,0:1,0,0",
            "",
            "turn=0.1",
        ),
        case(
            "hold-pulls",
            changed("rocker_bogie.urdf", "", ""),
            "--link right_middle --point 0,0,0 --normal 0,0,-1 --hold left_front:0,0,-0.1:0,0,-1",
            "",
            "left_rocker=0",
        ),
        on_rod("indefinite-mass-matrix", chain(&body, &inertial(2.0, -0.5)), "--set slide=0.1", "slide=0.1"),
    ]
}

/// Study with the flags of a mass.
fn study(flags: &str) -> String {
    let words: Vec<&str> = flags.split_whitespace().collect();
    let [mut model, mut contact, mut pose, mut conditions, mut hold] = [(); 5].map(|()| String::new());
    for pair in words.chunks(2) {
        let (key, value) = (pair[0].trim_start_matches('-').replace('-', "_"), pair[1]);
        match key.as_str() {
            "point" | "normal" => contact += &format!("{key} = [{value}]\n"),
            "set" | "guess" => {
                let (joint, value) = value.split_once('=').expect("a joint");
                pose += &format!("{key}.{joint} = [{value}]\n");
            }
            "travel" => pose += &format!("{key} = \"{value}\"\n"),
            "base" => conditions += &format!("{key} = \"{value}\"\n"),
            "accept" => model += &format!("{key} = [\"{value}\"]\n"),
            "hold" => {
                let parts: Vec<&str> = value.split(':').collect();
                hold += &format!(
                    "[[hold]]\nlink = \"{}\"\npoint = [{}]\nnormal = [{}]\n",
                    parts[0], parts[1], parts[2]
                );
            }
            _ => contact += &format!("{key} = \"{value}\"\n"),
        }
    }
    format!(
        "[model]\npath = \"model.urdf\"\n{model}[contact]\n{contact}[pose]\n{pose}[conditions]\n{conditions}{hold}"
    )
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

/// Codes of the findings about a pose or a row.
fn codes() -> impl Iterator<Item = &'static str> {
    include_str!("../../../study/src/checks/finding_kind.rs").lines().filter_map(|line| {
        let (code, scope) = line.split_once(" = \"")?.1.split_once("\", ")?;
        (!scope.ends_with("Report;")).then_some(code)
    })
}

#[test]
fn every_finding_is_in_every_output() {
    let scratch = Scratch::new("findings");
    let mut missing = Vec::new();
    for Case { code, model, contact, pose, vary } in cases() {
        let file = scratch.write("model.urdf", &model);
        let accept = if code == "indefinite-mass-matrix" { "--accept indefinite-inertia" } else { "" };
        let mass = format!("--notes mass {file} {contact} {accept} {pose}");
        let mut expect = |output: &str, message: Option<&str>, text: &str| match message {
            Some(message) if text.contains(part(message)) => {}
            _ => missing.push(format!("{code}, {output}: {message:?}")),
        };
        let report = percuss(&format!("{mass} --format json"));
        let of_mass = serde_json::from_str(&report.stdout).ok().and_then(|json| message(&json, code));
        let of_mass = of_mass.as_deref();
        expect("JSON", of_mass, &report.stdout.replace("\\\"", "\""));
        let flat_text = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        expect("text", of_mass, &flat_text(&percuss(&mass).stderr));
        if let Some((joint, position)) = vary.split_once('=') {
            let last = position.parse::<f64>().expect("a number") + 1e-3;
            let sweep =
                format!("--notes sweep {file} {contact} {accept} --vary {joint}={position}:{last}:2 --force");
            let json = scratch.path("rows.json");
            let table = percuss(&format!("{sweep} -o {json}"));
            let rows = fs::read_to_string(&json).unwrap_or_default();
            let of_rows = serde_json::from_str(&rows).ok().and_then(|json| message(&json, code));
            expect("JSON of a sweep", of_rows.as_deref(), &rows.replace("\\\"", "\""));
            expect("beside the JSON of a sweep", of_rows.as_deref(), &flat_text(&table.stderr));
            expect("beside the CSV of a sweep", of_rows.as_deref(), &flat_text(&percuss(&sweep).stderr));
        }
        scratch.write("study.toml", &study(&format!("{contact} {accept} {pose}")));
        done(&scratch, &["run", "study.toml", "--report", "page.html", "--force"]);
        for (output, file) in [("HTML", "page.html"), ("JSON of a report", "page.json")] {
            let page = fs::read_to_string(scratch.path(file)).expect("a report");
            expect(output, of_mass, &flat_text(&page).replace("\\\"", "\""));
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
    let raised: Vec<&str> =
        cases().iter().map(|case| case.code).chain(NOT_RAISED.map(|(code, _)| code)).collect();
    assert!(
        codes().count() > 30 && codes().all(|code| raised.contains(&code)),
        "{:?}",
        codes().collect::<Vec<_>>()
    );
}
