//! The rules for numbers at every flag and file that takes them: each rule breaks each entry point once.

use crate::support::{Scratch, percuss};

/// A command with `@` in place of the number or the vector, with the expected count of numbers.
struct Entry {
    name: &'static str,
    line: String,
    good: &'static [&'static str],
}

const CONTACT: &str = "--link coupler --point 0.35,0.1,0 --normal 0,1,0";

fn entries(scratch: &Scratch) -> Vec<Entry> {
    let ball = r#"<robot name="r"><link name="g"/><link name="a"><inertial><mass value="2"/>
        <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/></inertial></link>
        <joint name="p" type="spherical"><parent link="g"/><child link="a"/></joint></robot>"#;
    let ball = scratch.write("ball.urdf", ball);
    let bar = "models/four_bar.urdf";
    let entry = |name, line: String, good| Entry { name, line, good };
    vec![
        entry(
            "mass --point",
            format!("mass {bar} --link coupler --point @ --normal 0,1,0"),
            &["0.35", "0.1", "0"],
        ),
        entry(
            "mass --normal",
            format!("mass {bar} --link coupler --point 0.35,0.1,0 --normal @"),
            &["0", "1", "0"],
        ),
        entry("mass --set", format!("mass {bar} {CONTACT} --set crank_hinge=@"), &["0.2"]),
        entry(
            "mass --guess",
            format!("mass {bar} {CONTACT} --set crank_hinge=0.2 --guess crank_pin=@"),
            &["0.1"],
        ),
        entry(
            "mass --set, ball",
            format!("mass {ball} --link a --point 0.4,0,0 --normal 0,1,0 --set p=@"),
            &["0.8", "0", "0.6", "0"],
        ),
        entry("mass --link-mass", format!("mass {bar} {CONTACT} --link-mass crank=@"), &["2"]),
        entry("mass --armature", format!("mass {bar} {CONTACT} --armature crank_hinge=@"), &["0.1"]),
        entry("mass --stiffness", format!("mass {bar} {CONTACT} --restitution 0.5 --stiffness @"), &["1e5"]),
        entry(
            "mass --restitution",
            format!("mass {bar} {CONTACT} --stiffness 1e5 --restitution @"),
            &["0.5"],
        ),
        entry(
            "mass --speed",
            format!("mass {bar} {CONTACT} --restitution 0.5 --stiffness 1e5 --speed @"),
            &["0.5"],
        ),
        entry(
            "mass --travel",
            format!("mass {bar} {CONTACT} --travel rocker:-0.25,0.6,0:1,0,0=@"),
            &["0.01"],
        ),
        entry(
            "mass --travel, direction",
            format!("mass {bar} {CONTACT} --travel rocker:-0.25,0.6,0:@=0.01"),
            &["1", "0", "0"],
        ),
        entry("sweep --vary", format!("sweep {bar} {CONTACT} --vary crank_hinge=0:@:3"), &["0.3"]),
        entry(
            "map --normal",
            format!("map {bar} --link coupler --point 0.35,0.1,0 --directions 9 --set crank_hinge=@"),
            &["0.2"],
        ),
    ]
}

/// Numbers that break a rule, in place of the last good one.
const BAD: [&str; 8] = ["nan", "inf", "-inf", "1e101", "-1e300", "x", "", "0x10"];

#[test]
fn flags_refuse_numbers_that_break_a_rule() {
    let scratch = Scratch::new("input-rules");
    let (mut refused, mut failures) = (0, Vec::new());
    for Entry { name, line, good } in entries(&scratch) {
        let with = |numbers: &[&str]| line.replace('@', &numbers.join(","));
        let outcome = percuss(&with(good));
        assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
        let kept = &good[..good.len() - 1];
        let mut cases: Vec<Vec<&str>> = BAD.iter().map(|bad| [kept, &[*bad]].concat()).collect();
        cases.push([good, &["1"]].concat());
        if !kept.is_empty() {
            cases.push(kept.to_vec());
        }
        for case in cases {
            let outcome = percuss(&with(&case));
            if outcome.code != 2 || !outcome.stdout.is_empty() || !outcome.stderr.contains("error: ") {
                failures.push(format!("{name} {case:?}: exit code {}, {}", outcome.code, outcome.stderr));
            }
            refused += 1;
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
    assert_eq!(refused, 14 * 9 + 4);
}

#[test]
fn rows_of_a_file_follow_the_same_rules() {
    let scratch = Scratch::new("input-rows-rules");
    for (number, bad) in BAD.iter().enumerate() {
        let file = scratch.write(&format!("{number}.csv"), &format!("crank_hinge\n0.1\n{bad}\n0.3\n"));
        let outcome = percuss(&format!("sweep models/four_bar.urdf {CONTACT} --input {file}"));
        // An empty line of a CSV file is no row.
        let expected = if bad.is_empty() { 0 } else { 2 };
        assert_eq!(outcome.code, expected, "{bad}: {}{}", outcome.stdout, outcome.stderr);
        assert!(bad.is_empty() || outcome.stderr.contains(".csv:3"), "{bad}: {}", outcome.stderr);
    }
}

#[test]
fn changes_of_a_link_are_given_once() {
    for (flag, values) in
        [("link-mass", ["1", "2"]), ("link-com", ["0,0,0", "0.1,0,0"]), ("link-inertia", ["1,1,1", "2,2,2"])]
    {
        let [first, second] = values.map(|value| format!("--{flag} crank={value}"));
        let outcome = percuss(&format!("mass models/four_bar.urdf {CONTACT} {first} {second}"));
        assert!(outcome.code == 2 && outcome.stderr.contains("given twice"), "{flag}: {}", outcome.stderr);
    }
}

/// Flags without influence on a result are refused, with the command or the flag that uses them.
#[test]
fn flags_without_influence_are_refused() {
    let scratch = Scratch::new("unread-flags");
    let data = scratch.write("data.csv", "time,force\n0,0\n1,1\n");
    let bar = "models/four_bar.urdf";
    let law = "--restitution 0.3 --stiffness 1e5 --speed 1";
    let of_model = format!("{bar} {CONTACT}");
    let estimate = ["--estimate crank", "--ratio-at crank:0,0,0:0,1,0"];
    let of_file = ["--link-mass crank=2", "--total-mass 3", "--masses shapes", "--move x=1,2,3"];
    for (line, flags) in [
        (format!("damp --mass-from {of_model} {law}"), &estimate[..]),
        (format!("restitution {of_model} --stiffness 1e5 --damping 10 --speed 1"), &estimate),
        (format!("identify {data} --mass-from {of_model}"), &estimate),
        (format!("response {of_model}"), &estimate),
        (format!("safe-speed {of_model} --region chest --force 140"), &estimate),
        (format!("extremes {of_model}"), &estimate),
        (
            format!("map {bar} --link coupler --point 0,0,0 --directions 3"),
            &["--ratio-at crank:0,0,0:0,1,0", "--normal-frame world", "--unit mm"],
        ),
        (format!("compare {bar} {of_model}"), &["--estimate crank", "--title x"]),
        (format!("damp --mass 3 {law}"), &of_file),
        ("restitution --mass 3 --stiffness 1e5 --damping 10 --speed 1".to_owned(), &of_file),
        ("restitution --mass 3 --stiffness 1e5 --damping 10 --speed 1".to_owned(), &["--parameter k=1"]),
        (format!("mass {of_model} {law}"), &["--time-step 1e-4", "--diagonal-ratio 2", "--other-own-mass 2"]),
        (
            format!("sweep {of_model} --vary crank_hinge=0:1:3"),
            &["--title x", "--x-limits 0:1", "--ratio-at crank:0,0,0"],
        ),
        (
            "kinematics models/suspensions/double-wishbone.toml".to_owned(),
            &["--within 5mm", "--inboard-brakes", "--tyre-rate 200N/mm"],
        ),
    ] {
        for flag in flags {
            let outcome = percuss(&format!("{line} {flag}"));
            let name = flag.split(' ').next().unwrap_or_default();
            assert!(
                outcome.code == 2 && outcome.stderr.contains(&format!("{name}: it has no influence")),
                "{line} {flag}: {}",
                outcome.stderr
            );
        }
    }
}
