//! Hostile models are read or refused in bounded time, and mutated models without a panic.

use super::{load_mjcf, model};
use crate::support::bounded;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// Refused within seconds: the code of the first error.
fn refused_quickly(text: &str) -> &'static str {
    let error = bounded("a refusal", || load_mjcf(text)).expect_err("a refusal");
    error.diagnostics[0].code
}

#[test]
fn copies_are_bounded() {
    let body = "<body><joint/><geom size=\"1\"/></body>";
    let nested =
        (0..12).fold(body.to_owned(), |inner, _| format!("<replicate count=\"1000\">{inner}</replicate>"));
    assert_eq!(refused_quickly(&model(&nested, "")), "too-complex");
    assert_eq!(refused_quickly(&model("<replicate count=\"1000000000\"/>", "")), "too-complex");
    assert_eq!(
        refused_quickly(&model(&format!("<replicate count=\"1000000\">{body}</replicate>"), "")),
        "too-complex"
    );
}

#[test]
fn attached_copies_are_bounded() {
    let body = BODY_ON_HINGE;
    // Each body holds the one before in 240 frames.
    let frames = |inner: &str| format!("{}{inner}{}", "<frame>".repeat(240), "</frame>".repeat(240));
    let attach = |i: usize| frames(&format!("<attach body=\"b{}\" prefix=\"p{i}_\"/>", i - 1));
    let deep: String = (1..8).map(|i| format!("<body name=\"b{i}\">{}</body>", attach(i))).collect();
    let deep = format!("<body name=\"b0\">{body}</body>{deep}");
    assert_eq!(refused_quickly(&model(&deep, "")), "too-complex");
    // Each body holds the one before twice.
    let site = format!("<site user=\"{}\"/>", "1 ".repeat(5_000));
    let twice: String = (1..18)
        .map(|i| {
            let of = i - 1;
            format!("<body name=\"b{i}\"><attach body=\"b{of}\" prefix=\"l\"/><attach body=\"b{of}\" prefix=\"r\"/></body>")
        })
        .collect();
    assert_eq!(
        refused_quickly(&model(&format!("<body name=\"b0\">{body}{site}</body>{twice}"), "")),
        "too-complex"
    );
    let prefix = "p".repeat(100_000);
    let named =
        format!("<body name=\"a\">{body}</body><body><attach body=\"a\" prefix=\"{prefix}\"/></body>");
    assert_eq!(refused_quickly(&model(&named, "")), "long-name");
}

const BODY_ON_HINGE: &str = "<joint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>";

#[test]
fn nesting_is_bounded() {
    let deep = format!("{}{}", "<body>".repeat(300), "</body>".repeat(300));
    assert_eq!(refused_quickly(&model(&deep, "")), "too-complex");
    let classes: String = (0..300).map(|i| format!("<default class=\"c{i}\">")).collect();
    let classes = format!("<default>{classes}{}</default>", "</default>".repeat(300));
    assert_eq!(refused_quickly(&model("", &classes)), "too-complex");
}

#[test]
fn many_constraints_take_linear_time() {
    let count = 3_000;
    let bodies: String =
        (0..count).map(|i| format!("<body><joint name=\"j{i}\"/><geom size=\"1\"/></body>")).collect();
    let chain: String =
        (1..count).map(|i| format!("<joint joint1=\"j{}\" joint2=\"j{i}\"/>", i - 1)).collect();
    let text = model(&bodies, &format!("<equality>{chain}</equality>"));
    let loaded = bounded("a chain of constraints", || load_mjcf(&text)).unwrap();
    assert_eq!(loaded.mechanism.joints().iter().filter(|joint| joint.mimic().is_some()).count(), count - 1);
}

const SEED: &str = r#"<mujoco model="seed">
  <compiler angle="radian" eulerseq="XYZ" settotalmass="3" balanceinertia="true"/>
  <default><joint armature="0.1"/><default class="a"><geom type="capsule" size="0.1 0.2"/></default></default>
  <asset><mesh name="m" vertex="0 0 0 1 0 0 0 1 0 0 0 1" face="0 2 1 0 1 3 0 3 2 1 2 3" inertia="legacy"/></asset>
  <worldbody>
    <body name="x" pos="1 0 0" euler="0 0 1" childclass="a"><freejoint/><geom/><site name="s" pos="0 0 1"/>
      <body name="y"><joint name="j" pos="0 1 0" range="-1 1" ref="0.5"/><joint name="k" type="slide" axis="0 1 0"/>
        <geom type="box" size="1 2 3" zaxis="0 1 1"/><geom type="mesh" mesh="m" mass="1"/></body></body>
    <frame pos="0 1 0"><replicate count="2" offset="0 0 1" euler="0 0 1"><body name="r"><joint name="h"/><geom fromto="0 0 0 1 0 0"
      type="cylinder" size="0.1"/></body></replicate></frame>
    <body name="z"><joint type="ball" name="b"/><inertial pos="0 0 0" mass="1" fullinertia="1 1 1 0 0.1 0"/><site name="t"/></body>
  </worldbody>
  <equality><connect body1="x" body2="z" anchor="0 0 1"/><weld site1="s" site2="t"/><joint joint1="j" joint2="k" polycoef="0 2"/>
    <tendon tendon1="rod"/><tendon tendon1="pair"/></equality>
  <tendon><spatial name="rod"><site site="s"/><site site="t"/></spatial><fixed name="pair"><joint joint="h0" coef="1"/>
    <joint joint="h1" coef="2"/></fixed></tendon>
  <actuator><motor joint="j" gear="2" armature="0.1"/></actuator>
</mujoco>"#;

#[test]
fn mutated_models_are_read_or_refused() {
    assert!(load_mjcf(SEED).is_ok(), "{:?}", load_mjcf(SEED).err());
    let words: Vec<&str> = SEED.split(['"', ' ', '<', '>']).filter(|word| !word.is_empty()).collect();
    let nasty =
        ["nan", "1e400", "1e200", "-1e308", "1e-320", "0", "-1", "", "0 0 0", "x", "1e9", "&lt;", "world"];
    let mut rng = StdRng::seed_from_u64(5);
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
        match load_mjcf(&text) {
            Ok(_) => accepted += 1,
            Err(error) => {
                assert!(!error.diagnostics.is_empty(), "{text}");
                refused += 1;
            }
        }
    }
    assert!(accepted > 100 && refused > 100, "{accepted} accepted, {refused} refused");
}
