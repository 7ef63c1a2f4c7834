//! Every finding × every output: each finding is raised by a small input and appears in the text and the JSON of a mass, beside the table
//! and in the JSON of a sweep, and in the HTML report.

use crate::support::{Scratch, done, percuss, root};
use serde_json::Value;
use std::fs;

/// Finding, and an input that raises it.
struct Case {
    code: &'static str,
    model: String,
    /// Link, point and normal.
    contact: [&'static str; 3],
    /// Joint and position at which the finding holds; a sweep starts there.
    joint: &'static str,
    position: f64,
    /// Further flags of a mass and a sweep, and lines of a study.
    further: &'static str,
    tables: &'static str,
}

/// URDF of a model of the repository with one part replaced.
fn changed(model: &str, from: &str, to: &str) -> String {
    let text = fs::read_to_string(root().join("models").join(model)).expect("a model");
    assert!(from.is_empty() || text.contains(from), "{model}: {from}");
    text.replacen(from, to, 1)
}

/// Chain of a link on a slide and a link on a hinge, with the inertias of the two links.
fn chain(rod: &str, tip: &str) -> String {
    format!(
        r#"<robot name="chain"><link name="ground"/><link name="rod">{rod}</link><link name="tip">{tip}</link>
        <joint name="slide" type="prismatic"><parent link="ground"/><child link="rod"/><axis xyz="1 0 0"/>
        <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
        <joint name="turn" type="continuous"><parent link="rod"/><child link="tip"/><axis xyz="0 0 1"/></joint></robot>"#
    )
}

fn inertial(mass: f64, izz: f64) -> String {
    format!(
        r#"<inertial><mass value="{mass}"/><inertia ixx="1" iyy="1" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial>"#
    )
}

/// Four-bar of which all links lie on one line with all joints at 0.
fn flat() -> String {
    let body = inertial(1.0, 0.5);
    format!(
        r#"<robot name="flat"><link name="ground"/><link name="crank">{body}</link><link name="coupler">{body}</link><link name="rocker">{body}</link>
        <joint name="crank_hinge" type="continuous" independent="true"><parent link="ground"/><child link="crank"/><axis xyz="0 0 1"/></joint>
        <joint name="pin" type="continuous"><parent link="crank"/><child link="coupler"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/></joint>
        <joint name="rocker_hinge" type="continuous"><parent link="ground"/><child link="rocker"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>
        <loop name="end" type="revolute"><predecessor link="coupler"><origin xyz="1 0 0"/></predecessor>
        <successor link="rocker"><origin xyz="0.5 0 0"/></successor><axis xyz="0 0 1"/></loop></robot>"#
    )
}

fn cases() -> Vec<Case> {
    let case = |code, model, contact, joint, position| Case {
        code,
        model,
        contact,
        joint,
        position,
        further: "",
        tables: "",
    };
    let coupler = ["coupler", "0.35,0.1,0", "0,1,0"];
    let bar = || changed("four_bar.urdf", "", "");
    let body = inertial(2.0, 1.0);
    vec![
        case("outside-limits", chain(&body, &body), ["rod", "0,0,0", "1,0,0"], "slide", 2.0),
        case("many-turns", bar(), coupler, "crank_hinge", 100.0),
        case("far-point", bar(), ["coupler", "350,0.1,0", "0,1,0"], "crank_hinge", 0.1),
        case(
            "drawn-open",
            changed("four_bar.urdf", "xyz=\"0.4 0.3 0\"", "xyz=\"0.42 0.3 0\""),
            coupler,
            "crank_hinge",
            0.1,
        ),
        case(
            "drivers-chosen",
            changed("four_bar.urdf", " independent=\"true\"", ""),
            coupler,
            "crank_hinge",
            0.1,
        ),
        case("nearly-immovable", chain(&body, &body), ["rod", "0,0,0", "1e-7,1,0"], "slide", 0.1),
        case("massless-motions", chain(&body, ""), ["rod", "0,0,0", "1,0,0"], "slide", 0.1),
        case("undetermined-motion", chain(&body, ""), ["rod", "0,0,0", "1,0,0"], "slide", 0.1),
        case("singular-pose", flat(), ["coupler", "0.3,0,0", "0,1,0"], "crank_hinge", 0.0),
        Case {
            further: "--accept indefinite-inertia",
            tables: "accept = [\"indefinite-inertia\"]",
            ..case(
                "indefinite-mass-matrix",
                chain(&body, &inertial(2.0, -0.5)),
                ["rod", "0,0,0", "1,0,0"],
                "slide",
                0.1,
            )
        },
    ]
}

/// Message of the finding in a report.
fn message(report: &Value, code: &str) -> Option<String> {
    let found = report["diagnostics"].as_array()?.iter().find(|finding| finding["code"] == code)?;
    Some(found["message"].as_str()?.to_owned())
}

/// First long part of a message without a quotation mark: HTML has an entity in its place, and the end may name a flag or a key.
fn part(message: &str) -> &str {
    message.split(['"', '<', '>', '&']).find(|part| part.len() > 20).unwrap_or(message)
}

#[test]
fn every_finding_is_in_every_output() {
    let scratch = Scratch::new("findings");
    let mut missing = Vec::new();
    for Case { code, model, contact: [link, point, normal], joint, position, further, tables } in cases() {
        let file = scratch.write("model.urdf", &model);
        let contact = format!("{file} --link {link} --point {point} --normal {normal} {further}");
        let mass = format!("--notes mass {contact} --set {joint}={position}");
        let sweep =
            format!("--notes sweep {contact} --vary {joint}={position}:{}:2 --force", position + 1e-3);
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
        let json = scratch.path("rows.json");
        let table = percuss(&format!("{sweep} -o {json}"));
        let rows = fs::read_to_string(&json).unwrap_or_default();
        let of_rows = serde_json::from_str(&rows).ok().and_then(|json| message(&json, code));
        expect("JSON of a sweep", of_rows.as_deref(), &rows.replace("\\\"", "\""));
        expect("beside the JSON of a sweep", of_rows.as_deref(), &flat_text(&table.stderr));
        expect("beside the CSV of a sweep", of_rows.as_deref(), &flat_text(&percuss(&sweep).stderr));
        let study = format!(
            "[model]\npath = \"model.urdf\"\n{tables}\n[contact]\nlink = \"{link}\"\npoint = [{point}]\nnormal = [{normal}]\n[pose]\nset = \
             {{ {joint} = {position} }}\n"
        );
        scratch.write("study.toml", &study);
        done(&scratch, &["run", "study.toml", "--report", "page.html", "--force"]);
        let page = fs::read_to_string(scratch.path("page.html")).expect("a report");
        expect("HTML", of_mass, &flat_text(&page));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
