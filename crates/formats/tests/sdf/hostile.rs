//! Hostile models are read or refused in bounded time, and mutated models without a panic.

use super::{link, load_sdf, model};
use crate::support::bounded;
use percuss_mechanism::Severity;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// Code of the first error; `None` if the model is read.
fn answered_quickly(text: &str) -> Option<&'static str> {
    bounded("the model", || load_sdf(text)).err().map(|error| {
        let mut errors = error.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        errors.next().map_or("", |error| error.code)
    })
}

#[test]
fn nesting_is_bounded() {
    let deep = format!("{}{}{}", "<model name=\"n\">".repeat(100), link("a", ""), "</model>".repeat(100));
    assert_eq!(answered_quickly(&model(9, &deep)), Some("too-complex"));
    let deeper = format!("{}{}", "<x>".repeat(100_000), "</x>".repeat(100_000));
    assert_eq!(answered_quickly(&model(9, &deeper)), Some("too-complex"));
}

#[test]
fn long_chains_take_linear_time() {
    let count = 20_000;
    let frame = |i: usize, of: usize| {
        format!(
            "<frame name=\"f{i}\" attached_to=\"f{of}\"><pose relative_to=\"f{of}\">1 0 0 0 0 0.1</pose></frame>"
        )
    };
    // Forwards and backwards: no order of the file may cost more.
    let forwards: String = (1..count).map(|i| frame(i, i - 1)).collect();
    let backwards: String = (1..count).rev().map(|i| frame(i, i - 1)).collect();
    for frames in [forwards, backwards] {
        let text = model(9, &format!("{}<frame name=\"f0\" attached_to=\"a\"/>{frames}", link("a", "")));
        assert_eq!(answered_quickly(&text), None);
    }
    let circle: String = (0..count).map(|i| frame(i, (i + 1) % count)).collect();
    assert_eq!(answered_quickly(&model(9, &(link("a", "") + &circle))), Some("frame-circle"));
    let links: String = (0..5_000)
        .map(|i| {
            let parent = if i == 0 { "world".to_owned() } else { format!("l{}", i - 1) };
            let relative = if i == 0 { "__model__" } else { &parent };
            format!(
                "<link name=\"l{i}\"><pose relative_to=\"{relative}\">0.01 0 0 0 0 0</pose></link>
                 <joint name=\"j{i}\" type=\"revolute\"><parent>{parent}</parent><child>l{i}</child></joint>"
            )
        })
        .collect();
    assert_eq!(answered_quickly(&model(9, &links)), None);
}

#[test]
fn many_names_and_references_are_bounded() {
    let joints: String = (0..20_000)
        .map(|i| {
            format!("<joint name=\"j{i}\" type=\"fixed\"><parent>p{i}</parent><child>c{i}</child></joint>")
        })
        .collect();
    assert_eq!(answered_quickly(&model(9, &(link("a", "") + &joints))), Some("unknown-link"));
    let colons = "a::".repeat(300);
    let poses: String = (0..2_000)
        .map(|i| format!("<frame name=\"f{i}\"><pose relative_to=\"{colons}b\"/></frame>"))
        .collect();
    assert_eq!(answered_quickly(&model(9, &(link("a", "") + &poses))), Some("unknown-frame"));
    let long = "::".repeat(1_000_000);
    let pose = format!("<frame name=\"f\"><pose relative_to=\"a{long}\"/></frame>");
    assert_eq!(answered_quickly(&model(9, &(link("a", "") + &pose))), Some("unknown-frame"));
    let prefixes: String = (0..200).map(|i| format!("<p{i}:x/>")).collect();
    assert!(answered_quickly(&model(9, &(link("a", "") + &prefixes))).is_some());
}

const SEED: &str = r#"<sdf version="1.9"><world name="w"><frame name="wf"><pose>0 0 1 0 0 0</pose></frame>
  <model name="m" placement_frame="f" canonical_link="b"><static>false</static><pose relative_to="wf">1 0 0 0 0 1</pose>
    <link name="a"><pose degrees="true">1 0 0 0 0 90</pose><inertial><pose>0 0 1 0 0 0</pose><mass>2</mass>
      <inertia><ixx>1</ixx><ixy>0.1</ixy><iyy>2</iyy><izz>2.5</izz></inertia></inertial>
      <collision name="c"><geometry><box><size>1 2 3</size></box></geometry></collision></link>
    <link name="b"><pose relative_to="a">1 0 0 0 0 0</pose></link><link name="c"/>
    <frame name="f" attached_to="a"><pose>0 1 0 0 0 0</pose></frame>
    <model name="n"><link name="x"/><link name="y"><pose rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose></link>
      <joint name="i" type="prismatic"><parent>x</parent><child>y</child><axis><xyz expressed_in="x">1 0 0</xyz></axis></joint></model>
    <joint name="j" type="revolute"><pose>0 0 1 0 0 0</pose><parent>world</parent><child>a</child><axis><xyz>0 0 1</xyz>
      <limit><lower>-1</lower><upper>2</upper></limit></axis></joint>
    <joint name="k" type="universal"><parent>f</parent><child>b</child><axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>
    <joint name="l" type="screw"><parent>b</parent><child>c</child><screw_thread_pitch>0.1</screw_thread_pitch><axis><xyz>0 0 1</xyz>
      <mimic joint="j" axis="axis"><multiplier>2</multiplier><offset>1</offset><reference>0.5</reference></mimic></axis></joint>
    <joint name="o" type="ball"><parent>c</parent><child>n::x</child></joint>
    <joint name="p" type="fixed"><parent>n::y</parent><child>a</child></joint></model></world></sdf>"#;

#[test]
fn mutated_models_are_read_or_refused() {
    assert!(load_sdf(SEED).is_ok(), "{:?}", load_sdf(SEED).err());
    let words: Vec<&str> = SEED.split(['"', ' ', '<', '>']).filter(|word| !word.is_empty()).collect();
    let nasty = [
        "nan", "1e400", "1e200", "-1e308", "1e-320", "0", "-1", "", "0 0 0", "x", "1e9", "&lt;", "world",
        "::", "a::b",
    ];
    let mut rng = StdRng::seed_from_u64(6);
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..2_000 {
        let mut text = SEED.to_owned();
        for _ in 0..rng.random_range(1..4) {
            let old = words[rng.random_range(0..words.len())];
            let new = if rng.random_bool(0.5) {
                nasty[rng.random_range(0..nasty.len())]
            } else {
                words[rng.random_range(0..words.len())]
            };
            text = text.replacen(old, new, 1);
        }
        match load_sdf(&text) {
            Ok(_) => accepted += 1,
            Err(error) => {
                assert!(!error.diagnostics.is_empty(), "{text}");
                refused += 1;
            }
        }
    }
    assert!(accepted > 100 && refused > 100, "{accepted} accepted, {refused} refused");
}
