//! Valid files with random mutations from fixed seeds: loading ends quickly with a mechanism or with errors, without
//! a panic.

use crate::support;
use crate::support::{PENDULUM, bounded};
use percuss_formats::{LoadOptions, Source, load, write_urdf};
use percuss_mechanism::{Accept, Severity};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::ops::Range;

const CASES: usize = 4_000;

const ALL_JOINTS: &str = r#"<?xml version="1.0"?>
<!-- every kind of joint -->
<robot name="all" version="1.1">
  <link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/><link name="f"/><link name="g"/>
  <joint name="ab" type="fixed"><parent link="a"/><child link="b"/><origin quat_xyzw="0 0.6 0 0.8"/></joint>
  <joint name="bc" type="continuous"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/></joint>
  <joint name="cd" type="prismatic"><parent link="c"/><child link="d"/><axis xyz="1 0 0"/><limit lower="0" upper="1"/></joint>
  <joint name="de" type="planar"><parent link="d"/><child link="e"/><axis xyz="0 1 0"/></joint>
  <joint name="ef" type="spherical"><parent link="e"/><child link="f"/></joint>
  <joint name="fg" type="floating"><parent link="f"/><child link="g"/></joint>
</robot>
"#;

const MIMICS: &str = r#"<?xml version="1.0"?>
<robot name="hand" xmlns:drake="http://drake.mit.edu">
  <link name="palm"><inertial><mass value="0.5"/><inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/></inertial></link>
  <link name="tip"><inertial><origin xyz="0.1 0 0" rpy="0 0 0.2"/><mass value="0.1"/></inertial></link>
  <link name="end"><collision><origin xyz="0 0 1"/><geometry><sphere radius="0.02"/></geometry></collision></link>
  <joint name="one" type="revolute">
    <parent link="palm"/><child link="tip"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
    <dynamics armature="0.01"/>
  </joint>
  <joint name="two" type="revolute">
    <origin xyz="0.2 0 0"/><parent link="tip"/><child link="end"/><axis xyz="0 0 1"/>
    <mimic joint="one" multiplier="-0.5" offset="0.1"/>
  </joint>
  <transmission name="t"><joint name="two"/><actuator name="m">
    <drake:rotor_inertia value="1e-5"/><drake:gear_ratio value="100"/></actuator></transmission>
  <gazebo reference="tip"><mu1>0.2</mu1></gazebo>
</robot>
"#;

const ENTITIES: &str = r#"<!DOCTYPE robot [<!ENTITY m "1.5"><!ENTITY z "0 0 &m;">]>
<robot name="entities">
  <link name="a"/>
  <link name="b"><inertial><origin xyz="&z;"/><mass value="&m;"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="&z;"/><![CDATA[ ]]></joint>
</robot>
"#;

/// Four-bar linkage with all other constraints: a distance, a ball joint in the other notation, a gear and a second
/// parent.
const FOUR_BAR: &str = r#"<?xml version="1.0"?>
<robot name="four_bar">
  <link name="ground"/>
  <link name="crank"><inertial><origin xyz="0.15 0 0"/><mass value="2"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.017" iyz="0" izz="0.018"/></inertial></link>
  <link name="coupler"/><link name="rocker"/><link name="rotor"/>
  <joint name="a" type="continuous" independent="true"><parent link="ground"/><child link="crank"/><axis xyz="0 0 1"/></joint>
  <joint name="b" type="continuous" independent="False"><parent link="crank"/><child link="coupler"/><origin xyz="0.3 0 0"/><axis xyz="0 0 1"/></joint>
  <joint name="c" type="continuous"><parent link="ground"/><child link="rocker"/><origin xyz="0.8 0 0"/><axis xyz="0 0 1"/></joint>
  <joint name="r" type="continuous"><parent link="ground"/><child link="rotor"/><axis xyz="0 0 1"/></joint>
  <loop name="pin" type="revolute"><predecessor link="coupler"><origin xyz="0.7 0 0"/></predecessor><successor link="rocker"><origin xyz="0.5 0 0" rpy="0 0 0.1"/></successor><axis xyz="0 0 1"/></loop>
  <loop name="hooke" type="universal"><predecessor link="world"/><successor link="crank"/><axis xyz="0 0 1"/><axis2 xyz="1 0 0"/></loop>
  <loop name="rod" type="distance"><predecessor link="world"/><successor link="rocker"><origin quat_xyzw="0 0 0 1"/></successor><distance value="0.8"/></loop>
  <loop_joint name="ball" type="spherical"><link1 link="ground" xyz="0.8 0 0"/><link2 link="rocker" rpy="0 0 1"/></loop_joint>
  <coupling name="gear" type="rolling"><predecessor link="crank"/><successor link="rotor"/><ratio value="-6"/></coupling>
  <joint name="second" type="planar"><parent link="rotor"/><child link="rocker"/><origin xyz="0.8 0 0"/><axis xyz="0 0 1"/></joint>
</robot>
"#;

const NASTY: [&str; 24] = [
    "nan",
    "inf",
    "-inf",
    "1e400",
    "1e200",
    "-1e308",
    "1e-320",
    "-0",
    "",
    " ",
    "0",
    "-1",
    "x",
    "1,2",
    "0x10",
    "0 0 0",
    "1 2",
    "${x}",
    "$(y)",
    "&lt;",
    "&m;",
    "&#0;",
    "\u{a0}",
    "9999999999999999999999",
];

/// Values that are valid in many attributes.
const TAME: [&str; 6] = ["0.25", "2", "-3e-2", "1 2 3", "0 0 1", "a"];

fn pick<'r, T>(rng: &mut StdRng, items: &'r [T]) -> Option<&'r T> {
    (!items.is_empty()).then(|| &items[rng.random_range(0..items.len())])
}

/// Byte ranges between double quotes.
fn values(text: &[u8]) -> Vec<Range<usize>> {
    let quotes: Vec<usize> = text.iter().enumerate().filter(|(_, b)| **b == b'"').map(|(i, _)| i).collect();
    quotes.chunks_exact(2).map(|pair| pair[0] + 1..pair[1]).collect()
}

/// Byte ranges from `<` to `>`, brackets included.
fn tags(text: &[u8]) -> Vec<Range<usize>> {
    let mut tags = Vec::new();
    let mut start = None;
    for (i, byte) in text.iter().enumerate() {
        match byte {
            b'<' => start = Some(i),
            b'>' => tags.extend(start.take().map(|s| s..i + 1)),
            _ => {}
        }
    }
    tags
}

fn mutate(rng: &mut StdRng, text: &mut Vec<u8>) {
    let kind = rng.random_range(0..9);
    let spans = if kind < 5 { values(text) } else { tags(text) };
    let (Some(a), Some(b)) = (pick(rng, &spans).cloned(), pick(rng, &spans).cloned()) else { return };
    let (first, last) = if a.start <= b.start { (a, b) } else { (b, a) };
    match kind {
        // Replace a value, by an extreme or an ordinary one.
        0..=2 => {
            let words: &[&str] = if rng.random_bool(0.4) { &NASTY } else { &TAME };
            let word = words[rng.random_range(0..words.len())];
            text.splice(first, word.bytes());
        }
        // Exchange two values or two tags.
        3 | 5 if first.end <= last.start => {
            let (one, other) = (text[first.clone()].to_vec(), text[last.clone()].to_vec());
            text.splice(last, one);
            text.splice(first, other);
        }
        // Change a byte.
        3..=5 => {
            let at = rng.random_range(0..text.len());
            text[at] = rng.random();
        }
        // Delete or repeat a range of tags.
        6 => drop(text.drain(first.start..last.end)),
        7 => {
            let copy = text[first.start..last.end].to_vec();
            text.splice(last.end..last.end, copy);
        }
        // Truncate the file.
        _ => text.truncate(rng.random_range(0..text.len())),
    }
}

#[test]
fn no_mutation_makes_loading_panic_or_hang() {
    let mut rng = StdRng::seed_from_u64(0x7e0_cc55);
    let (mut good, mut bad) = (0, 0);
    for original in [PENDULUM, ALL_JOINTS, MIMICS, ENTITIES, FOUR_BAR] {
        assert!(support::load_text(original).is_ok(), "{:?}", support::told(&support::load_text(original)));
        for case in 0..CASES {
            let mut bytes = original.as_bytes().to_vec();
            for _ in 0..rng.random_range(1..=2) {
                if !bytes.is_empty() {
                    mutate(&mut rng, &mut bytes);
                }
            }
            let shown = String::from_utf8_lossy(&bytes).into_owned();
            match bounded(&shown, || load(&Source::new("mutant", bytes), &LoadOptions::default())) {
                Ok(loaded) => {
                    good += 1;
                    assert!(
                        loaded.diagnostics.iter().all(|d| d.severity != Severity::Error),
                        "case {case}\n{shown}"
                    );
                    // An accepted mechanism can be written and loaded again. `write_urdf` writes no shapes; without
                    // these, an inertia may look too large for the link.
                    let text = write_urdf(&loaded.mechanism);
                    let accept = Accept { implausible_inertia: true, ..Accept::default() };
                    let again = load(
                        &Source::from_text("model.urdf", text.clone()),
                        &LoadOptions { accept, ..LoadOptions::default() },
                    );
                    assert!(again.is_ok(), "case {case}: {:?}\n{shown}\n{text}", support::told(&again));
                    let (before, after) = (&loaded.mechanism, &again.unwrap().mechanism);
                    assert_eq!(before.closures().len(), after.closures().len(), "case {case}\n{shown}");
                    assert_eq!(before.couplings().len(), after.couplings().len(), "case {case}\n{shown}");
                    for link in loaded.mechanism.links() {
                        let inertia = link.inertia();
                        assert!(inertia.mass.is_finite() && inertia.mass >= 0.0, "case {case}\n{shown}");
                    }
                }
                Err(error) => {
                    bad += 1;
                    let errors = error.diagnostics.iter().filter(|d| d.severity == Severity::Error).count();
                    assert!(errors > 0, "case {case}: refused without an error\n{shown}");
                    assert!(!error.to_string().is_empty());
                }
            }
        }
    }
    // Enough files load and enough are refused; otherwise the mutations are too weak or too strong.
    assert!(good > CASES / 4 && bad > CASES, "{good} loaded, {bad} refused");
}
