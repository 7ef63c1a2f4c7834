//! Contacts of closed linkages on the command line: driving joints, assembly modes, holds, estimates.

use crate::support::{Scratch, json, percuss, root};

const COUPLER: &str = "mass models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";
const ROCKER: &str = "mass models/four_bar.urdf --link rocker --point -0.25,0.6,0 --normal 12,5,0";
const SPRING: &str = "mass models/double_wishbone.urdf --link spring_seat --point 0,0,0 --along-line spring_chassis_seat:0,0,0";
const MIDDLE_WHEEL: &str = "mass models/rocker_bogie.urdf --link right_middle --point 0,0,0 --normal 0,0,-1";

/// Σ (m v² + I ω²) of the four-bar at zero per unit rate of the crank, kg·m²; see the model.
const FOUR_BAR_ENERGY: f64 = 52163.0 / 110250.0;

fn kilograms(line: &str) -> f64 {
    json(&format!("{line} --format json"))["effective_mass"].as_f64().expect("a finite mass")
}

#[track_caller]
fn assert_close(got: f64, expected: f64, tolerance: f64) {
    assert!((got - expected).abs() <= tolerance * expected.abs(), "got {got}, expected {expected}");
}

/// Asserts the exit code and the words of a refusal.
#[track_caller]
fn assert_refused(line: &str, code: i32, words: &[&str]) {
    let outcome = percuss(line);
    assert_eq!(outcome.code, code, "{line}\n{}", outcome.stderr);
    assert_eq!(outcome.stdout, "", "{line}");
    for word in words {
        assert!(outcome.stderr.contains(word), "{line}: {word} is missing in\n{}", outcome.stderr);
    }
}

#[test]
fn json_says_how_the_loops_stand() {
    let report = json(&format!("{COUPLER} --format json"));
    assert_eq!(
        (report["degrees_of_freedom"].as_u64(), report["generic_degrees_of_freedom"].as_u64()),
        (Some(1), Some(1))
    );
    assert_eq!(report["redundant_constraints"], 3);
    assert_eq!(report["redundant_loops"], serde_json::json!([["rocker_pin"]]));
    assert_eq!(report["drivers"], serde_json::json!(["crank_hinge"]));
    assert_eq!((&report["singular_pose"], &report["route"]), (&false.into(), &"articulated".into()));
    assert!(
        report["closure_residual"].as_f64().unwrap()
            <= 1e-12 * report["characteristic_length"].as_f64().unwrap()
    );
    assert!(report["closure_inexactness"].as_f64().unwrap() < 1e-12);
    assert!(report["rank_gap"].as_f64().unwrap() > 1e6);
    assert_eq!(report["assembly_modes"].as_array().unwrap().len(), 1);
    assert_eq!(report["branch_limits"], serde_json::json!([]));
    for joint in ["crank_hinge", "crank_pin", "rocker_hinge"] {
        assert_eq!(report["pose"][joint].as_array().map(Vec::len), Some(1), "{joint}");
    }
    let shares: f64 = report["bodies"].as_array().unwrap().iter().map(|b| b["share"].as_f64().unwrap()).sum();
    assert_close(shares, 1.0, 1e-14);
    // An open chain has no values of loops.
    let open = json(
        "mass models/semi_trailing_arm.urdf --link spring_seat --point 0,0,0 --normal 0,0,1 --format json",
    );
    for key in ["rank_gap", "closure_residual", "closure_inexactness"] {
        assert!(open[key].is_null(), "{key}: {}", open[key]);
    }
    let check = json("check models/six_bar.urdf --format json");
    assert_eq!(
        (check["degrees_of_freedom"].as_u64(), check["redundant_constraints"].as_u64()),
        (Some(1), Some(6))
    );
    assert_eq!(check["closures"].as_array().map(Vec::len), Some(2));
}

/// A relation names all of its joints with their coefficients, and no links.
#[test]
fn a_relation_names_all_its_joints() {
    let folder = Scratch::new("joints-relation");
    let link = |name: &str| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/><inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" \
             iyz=\"0\"/></inertial></link><joint name=\"{name}_hinge\" type=\"continuous\"><parent link=\"ground\"/>\
             <child link=\"{name}\"/><axis xyz=\"0 0 1\"/></joint>"
        )
    };
    let links = ["left", "cage", "right"].map(link).concat();
    let relation = "<relation name=\"differential\"><joint name=\"left_hinge\" factor=\"0.5\"/>\
                    <joint name=\"cage_hinge\" factor=\"-1\"/><joint name=\"right_hinge\" factor=\"0.5\"/></relation>";
    let text = format!("<robot name=\"r\"><link name=\"ground\"/>{links}{relation}</robot>");
    let file = folder.write("differential.urdf", &text);
    let check = json(&format!("check {file} --format json"));
    let closure = &check["closures"][0];
    assert!(closure["predecessor"].is_null() && closure["successor"].is_null(), "{closure}");
    let terms: Vec<(&str, f64)> = closure["joints"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|term| (term["joint"].as_str().unwrap(), term["coefficient"].as_f64().unwrap()))
        .collect();
    assert_eq!(terms, [("left_hinge", 0.5), ("cage_hinge", -1.0), ("right_hinge", 0.5)]);
    let text = percuss(&format!("check {file}")).stdout;
    assert!(text.contains("0.5·left_hinge − cage_hinge + 0.5·right_hinge"), "{text}");
}

#[test]
fn unreachable_positions_are_reported_with_the_loop_and_the_nearest() {
    let outcome = percuss(&format!("{SPRING} --set lower_arm_hinge=2"));
    assert_eq!((outcome.code, outcome.stdout.as_str()), (1, ""));
    let message = outcome.stderr.lines().last().unwrap();
    assert!(message.contains("lower_arm_hinge = 2") && message.contains("\"upper_ball\""), "{message}");
    let (_, nearest) = message.split_once("nearest reached: lower_arm_hinge = ").expect("it is told");
    let nearest: f64 = nearest.split(',').next().unwrap().trim().parse().expect("a number");
    // Computed independently. The range ends like a parabola: 1e-12 of the size corresponds to 1e-6 of the angle.
    assert!((nearest - 0.457779675518).abs() < 1e-5, "{nearest}");
}

/// In the other assembly, the rocker's pin is reflected in the line from the crank's pin to the rocker's hinge.
#[test]
fn a_guess_selects_the_other_assembly() {
    let (here, there) = (
        json(&format!("{ROCKER} --format json")),
        json(&format!("{ROCKER} --guess rocker_hinge=150deg --format json")),
    );
    let at = |report: &serde_json::Value, i: usize| report["contact"]["point_world"][i].as_f64().unwrap();
    let (x, y) = (0.65, -0.3); // from the crank's pin (0, 0.3) to the rocker's hinge
    let (dx, dy) = (at(&here, 0), at(&here, 1) - 0.3);
    let along = (dx * x + dy * y) / (x * x + y * y);
    let mirrored = [2.0 * along * x - dx, 2.0 * along * y - dy + 0.3];
    for (i, coordinate) in mirrored.into_iter().enumerate() {
        assert!((at(&there, i) - coordinate).abs() < 1e-12, "{} {coordinate}", at(&there, i));
    }
    assert_ne!(here["assembly_modes"], there["assembly_modes"]);
    // Parallelogram with the lengths of the antiparallelogram: the pins of rocker and crank have the same velocity.
    let crossed = "mass models/antiparallelogram.urdf --link rocker --point 0.4,-0.3,0 --normal 3,4,0 --guess rocker_hinge=74deg";
    // Crank, rocker and coupler at 0.5 m: 2·2.4/3 + 3.
    assert_close(kilograms(crossed), 4.6, 1e-12);
}

#[test]
fn held_contacts_hold_and_say_where_they_pull() {
    let (free, locked) = (2.96923687043227, 0.15 / (0.2 * 0.2));
    assert_close(kilograms(MIDDLE_WHEEL), free, 1e-12);
    // Lifting the middle wheel makes the right rocker press its front wheel down, and the differential lifts the left
    // one.
    let pressed = percuss(&format!(
        "{MIDDLE_WHEEL} --hold right_front:0,0,-0.1:0,0,-1 --expect {locked} --tolerance 1e-12"
    ));
    assert_eq!((pressed.code, pressed.stderr.as_str()), (0, ""));
    let lifted = format!("{MIDDLE_WHEEL} --hold left_front:0,0,-0.1:0,0,-1");
    let outcome = percuss(&lifted);
    assert_eq!(outcome.code, 0);
    assert!(
        outcome.stderr.contains("would need a pulling force") && outcome.stderr.contains("2.9692368704"),
        "{}",
        outcome.stderr
    );
    let report = json(&format!("{lifted} --format json"));
    assert_eq!(report["diagnostics"][0]["code"], "hold-pulls");
    assert_close(report["effective_mass"].as_f64().unwrap(), locked, 1e-12);
    assert_eq!(report["degrees_of_freedom"], 8);
    assert_refused(&format!("{lifted} --strict"), 2, &["would need a pulling force"]);
    assert_refused(&format!("{MIDDLE_WHEEL} --hold nothing:0,0,0"), 2, &["nothing"]);
    assert_refused(&format!("{MIDDLE_WHEEL} --hold left_front:0,0,0:0,0,0"), 2, &["normal"]);
    assert_refused(&format!("{MIDDLE_WHEEL} --hold left_front"), 2, &["LINK:X,Y,Z"]);
    // A rigid tyre without slip permits no motion.
    assert_eq!(json(&format!("{SPRING} --hold contact_patch:0,0,0 --format json"))["status"], "immovable");
}

#[test]
fn locks_on_followers_count() {
    assert_eq!(json(&format!("{COUPLER} --lock rocker_hinge --format json"))["status"], "immovable");
    assert_eq!(json(&format!("{SPRING} --lock upper_arm_hinge --format json"))["status"], "immovable");
    assert_close(kilograms(&format!("{MIDDLE_WHEEL} --lock right_rocker")), 3.75, 1e-12);
    assert_close(kilograms(&format!("{SPRING} --lock spin")), 527.65933305523, 1e-11);
    assert_eq!(json(&format!("{SPRING} --lock spin --format json"))["degrees_of_freedom"], 1);
    assert_refused(&format!("{SPRING} --lock upper_ball"), 2, &["no joint is named \"upper_ball\""]);
}

/// Contacts between links of one loop: the relative speed counts, not the speeds of the two sides.
#[test]
fn against_another_link_of_the_loop() {
    // Coupler against crank: (ω - 1)·0.35 with ω = -5/21.
    assert_close(
        kilograms(&format!("{COUPLER} --against crank")),
        FOUR_BAR_ENERGY / (26.0 / 21.0 * 0.35f64).powi(2),
        1e-12,
    );
    // Coupler against rocker: -0.35·5/21 from the coupler, 8/21·(0.35 - 0.65) from the rocker.
    let speed = -0.35 * 5.0 / 21.0 - 8.0 / 21.0 * (0.35 - 0.65);
    assert_close(kilograms(&format!("{COUPLER} --against rocker")), FOUR_BAR_ENERGY / (speed * speed), 1e-12);
    // The two sides of a contact may be exchanged; the ground may be the contact link.
    let ground = COUPLER.replace("coupler", "ground").replace("0.35,0.1,0", "0.35,0.4,0");
    assert_close(kilograms(&format!("{ground} --against coupler")), FOUR_BAR_ENERGY * 144.0, 1e-12);
    // At a bearing, the relative velocity is always zero.
    let pin =
        "mass models/four_bar.urdf --link coupler --point 0,0,0 --normal 1,2,0 --against crank --format json";
    assert_eq!(json(pin)["status"], "immovable");
    // From the coupler's point towards the rocker's hinge, (0.3, -0.4): v = (-29/105, -1/12).
    let along = COUPLER.replace("--normal 0,1,0", "--along-line rocker:0,0,0");
    let speed = 0.6 * -29.0 / 105.0 + 0.8 / 12.0;
    assert_close(kilograms(&along), FOUR_BAR_ENERGY / (speed * speed), 1e-12);
    assert_close(kilograms(&COUPLER.replace("0,1,0", "3,-4,0")), kilograms(&along), 1e-13);
    // A line to the contact point itself has no direction.
    let nowhere = COUPLER.replace("--normal 0,1,0", "--along-line ground:0.35,0.4,0");
    assert_refused(&nowhere, 2, &["the direction is undefined"]);
}

#[test]
fn the_estimate_stands_beside_the_answer() {
    let asked = format!("{SPRING} --estimate wheel,spindle,upright");
    let report = json(&format!("{asked} --format json"));
    let estimate = &report["estimate"];
    let of = |key: &str| estimate[key].as_f64().unwrap_or_else(|| panic!("{key} in {estimate}"));
    assert_close(of("mass"), 60.0 + 14.705 + 19.45, 1e-15);
    // In a suspension the point moves upwards, as in every other motion ratio.
    assert_close(of("motion_ratio"), 1.0 / 2.21478924, 1e-8);
    let ratios = report["motion_ratios"].as_array().unwrap();
    let of_wheel = ratios.iter().find(|ratio| ratio["link"] == "wheel_centre").unwrap();
    assert_close(of("motion_ratio"), of_wheel["contact_per_wheel"].as_f64().unwrap(), 1e-12);
    assert_close(of("estimate"), of("mass") / of("motion_ratio").powi(2), 1e-14);
    let exact = report["effective_mass"].as_f64().unwrap();
    assert_close(of("error_percent"), 100.0 * (of("estimate") / exact - 1.0), 1e-10);
    let carried: f64 = ["wheel", "spindle", "upright"]
        .iter()
        .map(|link| {
            report["bodies"].as_array().unwrap().iter().find(|b| b["link"] == **link).unwrap()["share"]
                .as_f64()
                .unwrap()
        })
        .sum();
    assert!((of("share_left_out") - (1.0 - carried)).abs() < 1e-14);
    let text = percuss(&asked).stdout;
    for words in [
        "estimate m_K/l²      461.9 kg   (−10.71 %)",
        "94.16 kg of wheel, spindle, upright",
        "0.4515, closing of the contact per upward travel of wheel\n",
    ] {
        assert!(text.contains(words), "{words} is missing in\n{text}");
    }
    // Component of the velocity along a direction.
    let lateral = json(&format!("{asked}:0,0,0:0,2,0 --format json"));
    let ratio = lateral["estimate"]["motion_ratio"].as_f64().unwrap();
    let (vertical, full) = (2.21478924_f64, 2.2621034649_f64);
    assert!(1.0 / ratio.powi(2) <= full.powi(2) - vertical.powi(2) + 1e-7, "{ratio}");
    assert!(lateral["estimate"]["direction"] == serde_json::json!([0.0, 1.0, 0.0]), "{lateral}");
    assert_refused(&format!("{SPRING} --estimate wheel,nothing"), 2, &["no link is named \"nothing\""]);
    assert_refused(&format!("{SPRING} --estimate wheel:0,0,0:0,0,0"), 2, &["direction"]);
    assert_refused(&format!("{SPRING} --estimate wheel,,upright"), 2, &["LINK[,LINK"]);
    assert!(json(&format!("{SPRING} --format json"))["estimate"].is_null());
}

/// A free body on the other side is in series with the mechanism; the estimate applies to the mechanism alone.
#[test]
fn a_free_body_on_the_other_side_of_a_linkage() {
    let mass = kilograms(SPRING);
    assert_close(kilograms(&format!("{SPRING} --against-mass 500")), mass * 500.0 / (mass + 500.0), 1e-12);
    let at_dead_centre = "mass models/slider_crank.urdf --link slider --point 0,0,0 --normal 1,0,0 --set crank_hinge=90deg --against-mass 2";
    let report = json(&format!("{at_dead_centre} --format json"));
    assert_eq!(
        (report["effective_mass"].as_f64(), report["other_mass_share"].as_f64()),
        (Some(2.0), Some(1.0))
    );
}

/// A lock, a hold or additional mass never reduces m̄; a floating base never increases it.
#[test]
fn more_constraints_never_lower_the_mass() {
    let free = kilograms(MIDDLE_WHEEL);
    for more in [
        "--lock left_bogie",
        "--lock right_rocker",
        "--lock right_middle",
        "--hold left_rear:0,0,-0.1:1,0,0",
        "--armature right_bogie=0.5",
    ] {
        assert!(kilograms(&format!("{MIDDLE_WHEEL} {more}")) >= free * (1.0 - 1e-13), "{more}");
    }
    for (model, root_mass) in [
        ("rocker_bogie --link left_front", ""),
        ("four_bar --link rocker", "--link-mass ground=3kg"),
        ("multi_link --link upright", "--link-mass chassis=800kg"),
    ] {
        let (name, link) = model.split_once(' ').unwrap();
        assert!(root().join(format!("models/{name}.urdf")).exists());
        let line = format!("mass models/{name}.urdf {link} --point 0.01,0.1,0.02 --normal 0.3,0.5,0.7");
        let floating = format!("{line} --base floating {root_mass}");
        assert!(kilograms(&floating) <= kilograms(&line) * (1.0 + 1e-12), "{model}");
    }
}

/// A screw of Gazebo moves m + I·p² along its axis, with p rad/m of the nut. Between one slide and one hinge it is a relation; with a second
/// slide it is a loop, which holds this slide.
#[test]
fn screws_of_gazebo_carry_the_inertia_of_the_nut() {
    let folder = Scratch::new("gazebo-screw");
    let inertial = |mass: f64| {
        format!(
            "<inertial><mass value=\"{mass}\"/><inertia ixx=\".02\" iyy=\".03\" izz=\".04\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>"
        )
    };
    let joint = |name: &str, kind: &str, parent: &str, child: &str, axis: &str| {
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/><axis xyz=\"{axis}\"/>\
             <limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>"
        )
    };
    let side = format!("<link name=\"mid\"/>{}", joint("side", "prismatic", "base", "mid", "1 0 0"));
    for (below, side) in [("base", String::new()), ("mid", side)] {
        let model = folder.write(
            "screw.urdf",
            &format!(
                "<robot name=\"r\"><link name=\"base\"/>{side}<link name=\"torso\">{}</link><link name=\"nut\">{}</link>{}{}\
                 <gazebo><joint name=\"screw\" type=\"screw\"><parent>torso</parent><child>nut</child><axis><xyz>0 0 1</xyz></axis>\
                 <thread_pitch>7.5</thread_pitch></joint></gazebo></robot>",
                inertial(3.0),
                inertial(1.0),
                joint("lift", "prismatic", below, "torso", "0 0 1"),
                joint("spin", "continuous", "base", "nut", "0 0 1"),
            ),
        );
        let at = format!("mass {model} --link torso --point 0,0,0 --format json --set spin=0.5 --normal");
        let report = json(&format!("{at} 0,0,1"));
        assert_close(report["effective_mass"].as_f64().expect("a mass"), 3.0 + 0.04 * 7.5 * 7.5, 1e-12);
        // Left-handed: the nut, which stays at its height, sinks against the torso.
        assert_close(report["pose"]["lift"][0].as_f64().expect("a position"), 0.5 / 7.5, 1e-12);
        assert_eq!(json(&format!("{at} 1,0,0"))["status"], "immovable", "{below}");
    }
}
