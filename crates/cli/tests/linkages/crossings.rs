//! Change points: the limits of m̄ along the branches, compared with closed forms, and the other findings about the
//! loops there.

use crate::support::{Scratch, json, percuss};
use serde_json::Value;

/// Link of a parallelogram: mass, centre of mass on the x axis, moment of inertia.
fn link(name: &str, mass: f64, x: f64, inertia: f64) -> String {
    format!(
        "<link name=\"{name}\"><inertial><origin xyz=\"{x} 0 0\"/><mass value=\"{mass}\"/>\
         <inertia ixx=\"{inertia}\" iyy=\"{inertia}\" izz=\"{inertia}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n"
    )
}

fn hinge(name: &str, parent: &str, child: &str, x: f64) -> String {
    format!(
        "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
         <origin xyz=\"{x} 0 0\"/><axis xyz=\"0 0 1\"/></joint>\n"
    )
}

/// Parallelogram folded flat along x with its joints at 0, on a carrier: cranks 0.5 m, coupler 1 m. At the rate ω of
/// the cranks, each crank has I_O = 0.01 + 3·0.1² = 0.04 kg·m², and the points of the coupler move at 0.5 ω.
fn parallelogram(carrier: &str, prefix: &str, successor: &str) -> String {
    let [crank, coupler, rocker] = ["crank", "coupler", "rocker"].map(|part| format!("{prefix}_{part}"));
    link(&crank, 3.0, 0.1, 0.01)
        + &link(&coupler, 2.0, 0.2, 0.03)
        + &link(&rocker, 3.0, 0.1, 0.01)
        + &hinge(&format!("{prefix}1"), carrier, &crank, 0.0)
        + &hinge(&format!("{prefix}2"), &crank, &coupler, 0.5)
        + &hinge(&format!("{prefix}3"), carrier, &rocker, 1.0)
        + &format!(
            "<loop name=\"{prefix}_pin\" type=\"revolute\"><predecessor link=\"{coupler}\"><origin xyz=\"1 0 0\"/>\
             </predecessor><successor link=\"{rocker}\"><origin {successor}/></successor><axis xyz=\"0 0 1\"/></loop>\n"
        )
}

const STRAIGHT: &str = "xyz=\"0.5 0 0\"";

fn robot(scratch: &Scratch, name: &str, parts: &[String]) -> String {
    scratch.write(name, &format!("<robot name=\"r\"><link name=\"ground\"/>\n{}</robot>", parts.concat()))
}

fn limits(report: &Value) -> Vec<Option<f64>> {
    report["branch_limits"].as_array().expect("a list").iter().map(Value::as_f64).collect()
}

/// The limit extrapolates 1/m̄ from eight poses at distances of up to 4 % of the size; the error is about 1e-10.
#[track_caller]
fn assert_one_is(limits: &[Option<f64>], expected: f64) {
    assert!(limits.iter().flatten().any(|m| (m / expected - 1.0).abs() < 1e-8), "{expected} in {limits:?}");
}

#[test]
fn a_platform_on_three_cranks_has_one_branch() {
    let folded = "mass models/parallelogram.urdf --link platform --point 0.3,0.1,0 --set first_hinge=-90deg --format json";
    // The platform does not rotate: 6 + 3·0.08/0.4² kg perpendicular to the cranks; immovable along the cranks.
    let across = json(&format!("{folded} --normal 0,1,0"));
    assert_eq!(across["singular_pose"], true);
    assert_eq!(limits(&across).len(), 1);
    assert_one_is(&limits(&across), 7.5);
    assert_eq!(limits(&json(&format!("{folded} --normal 1,0,0"))), [None]);
}

#[test]
fn groups_at_crossings_of_their_own_are_taken_together() {
    let scratch = Scratch::new("crossings-two");
    let model = robot(
        &scratch,
        "two.urdf",
        &[parallelogram("ground", "a", STRAIGHT), parallelogram("a_coupler", "b", STRAIGHT)],
    );
    let report =
        json(&format!("mass {model} --link a_coupler --point 0.1,0.05,0 --normal 0,1,0 --format json"));
    assert_eq!(
        (&report["degrees_of_freedom"], &report["generic_degrees_of_freedom"]),
        (&4.into(), &2.into())
    );
    assert_eq!(limits(&report).len(), 4);
    // Both linkages as parallelograms, the first coupler at 1 m/s (ω_a = 2); minimum over w = ω_b of
    // (0.08 + 0.5)·4 + 6 (1 + 0.1 w)² + 0.02 w² + 2 (1 + 0.5 w)².
    assert_one_is(&limits(&report), 2.32 + 8.0 - 3.2 * 3.2 / (4.0 * 0.58));
}

#[test]
fn limits_are_found_beside_a_long_chain() {
    let scratch = Scratch::new("crossings-chain");
    let mut chain = String::new();
    for i in 0..3000 {
        let parent = if i == 0 { "ground".to_owned() } else { format!("c{}", i - 1) };
        chain += &(link(&format!("c{i}"), 1.0, 0.05, 0.01)
            + &hinge(&format!("to_c{i}"), &parent, &format!("c{i}"), 0.1));
    }
    let [alone, beside] = [String::new(), chain].map(|chain| {
        let model = robot(&scratch, "model.urdf", &[parallelogram("ground", "a", STRAIGHT), chain]);
        json(&format!("mass {model} --link a_coupler --point 0.1,0,0 --normal 0,1,0 --format json"))
    });
    let (alone, beside) = (limits(&alone), limits(&beside));
    assert_eq!((alone.len(), beside.len()), (2, 2));
    for (a, b) in alone.iter().zip(&beside) {
        let (a, b) = (a.expect("a limit"), b.expect("a limit"));
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
    assert_one_is(&beside, 2.32);
}

#[test]
fn a_branch_with_more_freedoms_is_one_branch() {
    let scratch = Scratch::new("crossings-spin");
    // The loop is closed by a ball joint, and the coupler's pin to the crank is a ball joint too: the coupler can
    // roll about its long axis.
    let text = parallelogram("ground", "a", STRAIGHT)
        .replace("name=\"a2\" type=\"continuous\"", "name=\"a2\" type=\"spherical\"")
        .replace("type=\"revolute\"", "type=\"spherical\"");
    let model = robot(&scratch, "spin.urdf", &[text]);
    let report = json(&format!("mass {model} --link a_coupler --point 0.1,0,0 --normal 0,1,0 --format json"));
    assert_eq!(
        (&report["degrees_of_freedom"], &report["generic_degrees_of_freedom"]),
        (&3.into(), &2.into())
    );
    assert_eq!(limits(&report).len(), 2, "{:?}", limits(&report));
    assert_one_is(&limits(&report), 2.32);
}

#[test]
fn axes_may_point_opposite_ways() {
    let scratch = Scratch::new("crossings-reversed");
    let turned = "xyz=\"0.5 0 0\" rpy=\"3.141592653589793 0 0\"";
    let [straight, reversed] = [STRAIGHT, turned].map(|frame| {
        let model = robot(&scratch, "model.urdf", &[parallelogram("ground", "a", frame)]);
        json(&format!(
            "mass {model} --link a_coupler --point 0.1,0,0 --normal 0,1,0 --set a1=0.7 --format json"
        ))
    });
    let mass = |report: &Value| report["effective_mass"].as_f64().expect("a mass");
    assert!((mass(&straight) / mass(&reversed) - 1.0).abs() < 1e-12);
    let codes = |report: &Value| -> Vec<String> {
        let all = report["diagnostics"].as_array().expect("a list");
        all.iter().map(|d| d["code"].as_str().unwrap_or_default().to_owned()).collect()
    };
    assert!(codes(&reversed).contains(&"reversed-axis".to_owned()));
    assert!(!codes(&straight).contains(&"reversed-axis".to_owned()));
}

#[test]
fn separable_loops_are_named_apart() {
    let check = json("check models/six_bar.urdf --format json");
    assert_eq!(check["redundant_loops"], serde_json::json!([["rocker_pin"], ["output_pin"]]));
    let check = json("check models/parallelogram.urdf --format json");
    assert_eq!(check["redundant_loops"], serde_json::json!([["second_pin", "third_pin"]]));
}

/// Pin between two links, at given x positions in the two link frames.
fn pin(name: &str, [a, at_a]: [&str; 2], [b, at_b]: [&str; 2]) -> String {
    format!(
        "<loop name=\"{name}\" type=\"revolute\"><predecessor link=\"{a}\"><origin xyz=\"{at_a} 0 0\"/></predecessor>\
         <successor link=\"{b}\"><origin xyz=\"{at_b} 0 0\"/></successor><axis xyz=\"0 0 1\"/></loop>\n"
    )
}

#[test]
fn more_loops_than_freedoms_drawn_folded_still_move() {
    let scratch = Scratch::new("crossings-third");
    let third = link("third", 3.0, 0.1, 0.01)
        + &hinge("third_hinge", "ground", "third", 0.4)
        + &pin("third_pin", ["a_coupler", "0.4"], ["third", "0.5"]);
    let model = robot(&scratch, "third.urdf", &[parallelogram("ground", "a", STRAIGHT), third]);
    let contact = format!("mass {model} --link a_coupler --point 0.1,0.05,0 --normal 0,1,0 --format json");
    let folded = json(&contact);
    for (key, expected) in
        [("degrees_of_freedom", 2), ("generic_degrees_of_freedom", 1), ("redundant_constraints", 7)]
    {
        assert_eq!(folded[key], expected, "{key}");
    }
    // Three cranks at ω = 2 and the coupler at 1 m/s; the third crank excludes the crossed branch.
    assert_eq!(limits(&folded).len(), 1);
    assert_one_is(&limits(&folded), 3.0 * 0.04 * 4.0 + 2.0);
    let driven = json(&format!("{contact} --set a1=0.5"));
    assert_eq!((&driven["singular_pose"], &driven["degrees_of_freedom"]), (&false.into(), &1.into()));
}

#[test]
fn groups_that_the_contact_does_not_feel_are_left_out() {
    let scratch = Scratch::new("crossings-seven");
    let all: Vec<String> =
        ["a", "b", "c", "d", "e", "f", "g"].map(|name| parallelogram("ground", name, STRAIGHT)).into();
    let model = robot(&scratch, "seven.urdf", &all);
    for side in ["a_coupler", "g_coupler"] {
        let report =
            json(&format!("mass {model} --link {side} --point 0.1,0.05,0 --normal 0,1,0 --format json"));
        assert_eq!(report["degrees_of_freedom"], 14);
        assert_eq!(limits(&report).len(), 2, "{side}");
        assert_one_is(&limits(&report), 2.32);
    }
}

#[test]
fn every_branch_of_a_ladder_is_found() {
    let scratch = Scratch::new("crossings-ladder");
    let mut text = String::new();
    for crank in 0..5 {
        text += &(link(&format!("crank{crank}"), 3.0, 0.1, 0.01)
            + &hinge(&format!("h{crank}"), "ground", &format!("crank{crank}"), f64::from(crank)));
    }
    for cell in 0..4 {
        let (coupler, next) = (format!("coupler{cell}"), format!("crank{}", cell + 1));
        text += &(link(&coupler, 2.0, 0.2, 0.03)
            + &hinge(&format!("p{cell}"), &format!("crank{cell}"), &coupler, 0.5)
            + &pin(&format!("pin{cell}"), [&coupler, "1"], [&next, "0.5"]));
    }
    let model = robot(&scratch, "ladder.urdf", &[text]);
    let report =
        json(&format!("mass {model} --link coupler1 --point 0.1,0.05,0 --normal 0,1,0 --format json"));
    assert_eq!(
        (&report["degrees_of_freedom"], &report["generic_degrees_of_freedom"]),
        (&5.into(), &1.into())
    );
    // Each cell continues as a parallelogram or crossed: 2⁴ branches. All as parallelograms: five cranks at ω = 2,
    // four couplers.
    assert_eq!(limits(&report).len(), 16);
    assert_one_is(&limits(&report), 5.0 * 0.04 * 4.0 + 4.0 * 2.0);
}

fn message<'a>(report: &'a Value, code: &str) -> &'a str {
    let all = report["diagnostics"].as_array().expect("a list");
    let found = all.iter().find(|d| d["code"] == code).unwrap_or_else(|| panic!("{code} in {all:?}"));
    found["message"].as_str().expect("words")
}

#[test]
fn a_small_crossing_beside_a_long_arm_keeps_its_digits() {
    // A cylinder and a sphere with internal contact (radii r and 2r, r = 0.2 m): Viviani's curve intersects itself at
    // the origin along y = z and y = −z. The model also has a link of 10 m.
    let scratch = Scratch::new("crossings-viviani");
    let slide = |name: &str, axis: &str, parent: &str, mass: f64| {
        link(name, mass, 0.0, 0.1)
            + &format!(
                "<joint name=\"along_{name}\" type=\"prismatic\"><parent link=\"{parent}\"/><child link=\"{name}\"/>\
                 <axis xyz=\"{axis}\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>"
            )
    };
    let rod = |name: &str, at: &str, to: &str, length: f64| {
        format!(
            "<loop name=\"{name}\" type=\"distance\"><predecessor link=\"ground\"><origin xyz=\"{at} 0 0\"/></predecessor>\
             <successor link=\"{to}\"><origin xyz=\"0.2 0 0\"/></successor><distance value=\"{length}\"/></loop>"
        )
    };
    let text = slide("X", "1 0 0", "ground", 1.0)
        + &slide("Y", "0 1 0", "X", 2.0)
        + &slide("Z", "0 0 1", "Y", 3.0)
        + &rod("cylinder", "0", "Y", 0.2)
        + &rod("sphere", "-0.2", "Z", 0.4)
        + &link("arm", 1.0, 0.0, 0.1)
        + &link("far", 1.0, 0.0, 0.1)
        + &hinge("arm_hinge", "ground", "arm", 0.0)
        + &hinge("far_hinge", "arm", "far", 10.0);
    let model = robot(&scratch, "viviani.urdf", &[text]);
    let report = json(&format!("mass {model} --link Z --point 0,0,0 --normal 0,1,2 --format json"));
    // 5 kg move along y, 3 kg along z: (5 + 3)/(3/√5)² and (5 + 3)/(1/√5)².
    assert_eq!(limits(&report).len(), 2);
    assert_one_is(&limits(&report), 40.0 / 9.0);
    assert_one_is(&limits(&report), 40.0);
}

#[test]
fn singular_poses_without_a_crossing_are_reported() {
    let scratch = Scratch::new("crossings-odd");
    // Stretched out: the ground link is as long as the other three together, and no motion is possible.
    let chain = |lengths: [f64; 3], base: f64| {
        link("A", 1.0, 0.1, 0.05)
            + &link("B", 1.0, 0.1, 0.05)
            + &link("C", 1.0, 0.1, 0.05)
            + &hinge("jA", "ground", "A", 0.0)
            + &hinge("jB", "A", "B", lengths[0])
            + &hinge("jC", "ground", "C", base)
            + &pin("closing", ["B", &lengths[1].to_string()], ["C", &lengths[2].to_string()])
    };
    let model = robot(&scratch, "stretched.urdf", &[chain([0.3, 0.5, -0.4], 1.2)]);
    let report = json(&format!("mass {model} --link B --point 0.1,0.2,0 --normal 0.3,1,0 --format json"));
    assert_eq!((&report["singular_pose"], limits(&report).len()), (&true.into(), 0));
    assert!(message(&report, "singular-pose").contains("no branch through this pose was found"));
    // A flat five-bar has three degrees of freedom at the crossing, and the continuing directions form a cone.
    let five = chain([0.6, 0.5, 0.0], 0.7)
        .replace("link=\"B\"><origin xyz=\"0.5", "link=\"D\"><origin xyz=\"-0.1")
        .replace("link=\"C\"><origin xyz=\"0 ", "link=\"C\"><origin xyz=\"0.3 ")
        + &link("D", 1.0, 0.1, 0.05)
        + &hinge("jD", "B", "D", 0.5);
    let model = robot(&scratch, "five.urdf", &[five]);
    let report = json(&format!("mass {model} --link B --point 0.1,0.2,0 --normal 0.3,1,0 --format json"));
    assert!(message(&report, "singular-pose").contains("continuum"));
    let range = limits(&report);
    assert!(range.len() == 2 && range[0].expect("a mass") < 0.5 * range[1].expect("a mass"), "{range:?}");
    assert!(report["effective_mass"].as_f64().expect("a mass") < range[0].expect("a mass"));
}

/// At a crossing of branches, the value of (D) is a lower bound. A question that needs one mass uses the limits of
/// the branches, or reports the reason for failing.
#[test]
fn a_speed_and_a_damper_are_for_masses_that_branches_have() {
    let platform = "models/parallelogram.urdf --link platform --point 0.3,0.1,0 --set first_hinge=-90deg";
    let speed = |contact: &str| {
        let report = json(&format!("safe-speed {contact} --region chest --force 280 --format json"));
        (report["reflected"]["robot_mass"].as_f64(), report["reflected"]["speed"].as_f64().expect("a speed"))
    };
    // Chest: 40 kg on 25 N/mm. The lower bound of 5.41 kg would permit 0.81 m/s.
    let by_hand = |robot: f64| 280.0 / (25e3 / (1.0 / 40.0 + 1.0 / robot)).sqrt();
    let (mass, at_most) = speed(&format!("{platform} --normal 0,1,0"));
    assert_one_is(&[mass], 7.5);
    assert!((at_most / by_hand(7.5) - 1.0).abs() < 1e-8, "{at_most}");
    let (none, at_most) = speed(&format!("{platform} --normal 1,0,0"));
    assert!(none.is_none() && (at_most / (280.0 / (40.0f64 * 25e3).sqrt()) - 1.0).abs() < 1e-12, "{at_most}");
    // One branch gives one damper; no drift is reported along the motion of the bound.
    let damp = "--restitution 0.5 --stiffness 1e5 --speed 1 --format json";
    let of_one = json(&format!("damp --mass-from {platform} --normal 0,1,0 {damp}"));
    assert_one_is(&[of_one["effective_mass"].as_f64()], 7.5);
    assert!(of_one["drift"]["per_metre"].is_null() && of_one["drift"]["over_penetration"].is_null());
    let refused = |line: &str, words: &[&str]| {
        let outcome = percuss(line);
        assert_eq!(outcome.code, 1, "{line}\n{}", outcome.stderr);
        assert!(words.iter().all(|word| outcome.stderr.contains(word)), "{line}\n{}", outcome.stderr);
    };
    // Two branches: the speed uses the heavier one; no damper is given, but the mass is.
    let scratch = Scratch::new("crossings-one-mass");
    let folded = robot(&scratch, "folded.urdf", &[parallelogram("ground", "a", STRAIGHT)]);
    let contact = format!("{folded} --link a_coupler --point 0.1,0.05,0 --normal 0,1,0");
    let whole = json(&format!("mass {contact} {damp}"));
    let branches: Vec<f64> = limits(&whole).into_iter().flatten().collect();
    let [least, most] = [f64::min, f64::max].map(|of| branches.iter().copied().reduce(of).expect("a limit"));
    assert!(branches.len() == 2 && whole["effective_mass"].as_f64().expect("a mass") < least && least < most);
    assert!(whole["damper"].is_null() && message(&whole, "no-damper").contains(&format!("{most} kg")));
    assert_eq!(speed(&contact).0, Some(most));
    refused(
        &format!("damp --mass-from {contact} {damp}"),
        &["singular", &format!("{least} kg"), "nearby pose"],
    );
    // Without a branch, and with branches without a value, no bound on the mass exists.
    let held = "models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --hold outer:0.4,0,0:1,0,0";
    refused(
        &format!("safe-speed {held} --region chest --force 280"),
        &["singular", "largest effective mass of the robot is unknown"],
    );
    refused(&format!("damp --mass-from {held} {damp}"), &["singular", "no branch"]);
}

/// For loops that close only from a guess, the results belong to the closed pose, not to the pose as drawn.
#[test]
fn figures_are_of_the_assembly_of_the_pose() {
    let scratch = Scratch::new("crossings-guess");
    // A shaft, and a second one geared to turn 50 times as fast. A rod on each shaft closes at the angles 1.1 rad and
    // 55 rad; elsewhere, one of the rods does not fit. An additional folded parallelogram is singular as drawn.
    let rod = |name: &str, from: f64, at: f64| {
        let gap: f64 = (5.0 - 4.0 * (at - from).cos()).sqrt();
        format!(
            "<loop name=\"{name}_rod\" type=\"distance\"><predecessor link=\"ground\"><origin xyz=\"{} {} 0\"/>\
             </predecessor><successor link=\"{name}\"><origin xyz=\"1 0 0\"/></successor><distance value=\"{gap}\"/></loop>",
            2.0 * from.cos(),
            2.0 * from.sin()
        )
    };
    let gears = link("slow", 1.0, 0.1, 0.01)
        + &link("fast", 1.0, 0.1, 0.01)
        + &hinge("slow_hinge", "ground", "slow", 0.0)
        + &hinge("fast_hinge", "ground", "fast", 0.0)
        + "<coupling name=\"gear\"><predecessor link=\"slow\"/><successor link=\"fast\"/><ratio value=\"50\"/></coupling>"
        + &rod("slow", 0.3, 1.1)
        + &rod("fast", 0.7, 55.0);
    let model = robot(&scratch, "geared.urdf", &[parallelogram("ground", "a", STRAIGHT), gears]);
    let line =
        format!("mass {model} --link a_coupler --point 0.1,0,0 --normal 0,1,0 --set a1=0.7 --format json");
    let drawn = percuss(&line);
    assert!(drawn.code == 1 && drawn.stderr.contains("the loops do not close"), "{}", drawn.stderr);
    let report = json(&format!("{line} --guess slow_hinge=1.1 --guess fast_hinge=55"));
    for (key, expected) in
        [("degrees_of_freedom", 1), ("generic_degrees_of_freedom", 1), ("redundant_constraints", 4)]
    {
        assert_eq!(report[key], expected, "{key}");
    }
    assert_eq!(report["redundant_loops"], serde_json::json!([["a_pin"], ["slow_rod", "fast_rod", "gear"]]));
}
