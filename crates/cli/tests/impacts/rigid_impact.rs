//! `percuss impact`: closed forms, indeterminate components, refusals, and the study table.

use crate::support::{Scratch, json, percuss};
use serde_json::Value;

const FOUR_BAR: &str =
    "impact models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3";

/// Rounding of a few operations.
const ROUNDING: f64 = 1e-12;

fn close(value: &Value, expected: f64) {
    let got = value.as_f64().unwrap_or_else(|| panic!("{value} is no number; expected {expected}"));
    assert!((got - expected).abs() < ROUNDING * expected.abs().max(1.0), "{got} {expected}");
}

fn named<'a>(list: &'a Value, key: &str, name: &str) -> &'a Value {
    let entries = list.as_array().expect("a list");
    entries.iter().find(|entry| entry[key] == name).unwrap_or_else(|| panic!("{name} is missing in {list}"))
}

#[test]
fn a_four_bar_has_the_rates_of_its_fractions() {
    let report = json(&format!("{FOUR_BAR} --rates crank_hinge=-24 --reflected crank_hinge --format json"));
    // Per unit rate of the crank the contact moves by −1/12 m, the coupler by −5/21, the rocker by 8/21 rad.
    let mass = 417_304.0 / 6125.0;
    close(&report["closing_speed"], 2.0);
    close(&report["impulse"], 1.3 * mass * 2.0);
    close(&report["energy_loss"], 0.5 * mass * (1.0 - 0.09) * 4.0);
    close(&report["mass"]["effective_mass"], mass);
    assert_eq!(report["motion_before"], "given");
    let rocker = named(&report["rates"], "joint", "rocker_hinge");
    close(&rocker["before"][0], -24.0 * 8.0 / 21.0);
    close(&rocker["after"][0], 0.3 * 24.0 * 8.0 / 21.0);
    close(&named(&report["reflected_inertia"], "joint", "crank_hinge")["free"], 52163.0 / 110_250.0);
    // A loop of parallel hinges is redundant out of its plane, and only there.
    let hinge = named(&report["reactions"], "name", "crank_hinge");
    assert!(hinge["force"][2].is_null() && hinge["moment"][0].is_null() && hinge["moment"][1].is_null());
    assert!(hinge["force"][0].is_number() && hinge["moment"][2].is_number());
    assert_eq!(hinge["open_by"], serde_json::json!(["rocker_pin"]));
    assert!(report["reaction_residual"].as_f64().expect("a number") < ROUNDING);
    // The ground balances the impulse and the change of momentum, also out of the plane.
    let ground = named(&report["reactions"], "place", "ground");
    assert!(ground["force"].as_array().expect("three").iter().all(Value::is_number));
    // The same impulse from a speed alone, whose motion is stated.
    let assumed = json(&format!("{FOUR_BAR} --speed 2 --format json"));
    close(&assumed["impulse"], 1.3 * mass * 2.0);
    assert_eq!(assumed["motion_before"], "least-energy");
    let text = percuss(&format!("{FOUR_BAR} --speed 2")).stdout;
    assert!(
        text.contains("before: v*, the motion of least energy") && text.contains("?: indeterminate"),
        "{text}"
    );
}

#[test]
fn peak_forces_are_reactions_times_the_peak_of_the_contact() {
    let report = json(&format!("{FOUR_BAR} --speed 2 --stiffness 200N/mm --format json"));
    let factor = report["contact_law"]["peak_force"].as_f64().expect("a force")
        / report["impulse"].as_f64().expect("an impulse");
    let hinge = named(&report["reactions"], "name", "rocker_hinge");
    for k in 0..2 {
        close(&hinge["peak_force"][k], factor * hinge["force"][k].as_f64().expect("determinate"));
    }
    assert!(hinge["peak_force"][2].is_null());
    // The contact itself by percuss damp.
    let damp = "damp --mass-from models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3 \
                --speed 2 --stiffness 200N/mm --format json";
    close(&report["contact_law"]["peak_force"], json(damp)["peak_force"].as_f64().expect("a force"));
}

/// Sums of a few hundred samples by the trapezium rule.
const SAMPLED: f64 = 2e-3;

#[test]
fn an_impact_in_time_reaches_its_restitution_and_loads_its_bearings() {
    let scratch = Scratch::new("impact-in-time");
    let csv = scratch.path("time.csv");
    let line = format!("{FOUR_BAR} --speed 0.5 --stiffness 2e6 --in-time");
    let report = json(&format!("{line} --output {csv} --format json"));
    let found = &report["in_time"];
    let number = |value: &Value| value.as_f64().expect("a number");
    // The stiff limit is the rigid impact.
    assert!((number(&found["restitution"]) - 0.3).abs() < 0.02, "{}", found["restitution"]);
    // The motion of one freedom by the effective mass alone is another computation; its steps are fixed.
    let one = &found["one_freedom"];
    for key in ["restitution", "peak_force", "max_penetration"] {
        let (a, b) = (number(&one[key]), number(&found[key]));
        assert!((a / b - 1.0).abs() < 1e-3, "{key}: {a} {b}");
    }
    assert!(number(&found["loop_gap"]) < 1e-10, "{}", found["loop_gap"]);
    // The bearings: the estimate is that of a constant pose.
    let hinge = named(&found["bearings"], "name", "crank_hinge");
    let (peak, estimate) = (number(&hinge["peak_force"]), number(&hinge["estimate"]));
    assert!((peak / estimate - 1.0).abs() < 0.1, "{peak} {estimate}");
    assert_eq!(hinge["open_components"], serde_json::json!([false, false, true]));
    // Force over penetration encloses the lost energy, up to the change of the kinetic energy with the pose.
    let table = std::fs::read_to_string(&csv).expect("written");
    let mut rows = table.lines();
    assert!(
        rows.next().expect("a header").starts_with("time,penetration,rate,force,effective_mass,rate of ")
    );
    let rows: Vec<Vec<f64>> =
        rows.map(|row| row.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect();
    let work: f64 = rows.windows(2).map(|w| 0.5 * (w[0][3] + w[1][3]) * (w[1][1] - w[0][1])).sum();
    let energy = |row: &[f64]| 0.5 * row[4] * row[2] * row[2];
    let lost = energy(&rows[0]) - energy(rows.last().expect("rows"));
    assert!((work / lost - 1.0).abs() < SAMPLED, "{work} {lost}");
    // Gravity presses the sides together or apart.
    let pressed = json(&format!("{line} --gravity 0,9.81,0 --format json"));
    let apart = json(&format!("{line} --gravity 0,-9.81,0 --format json"));
    assert!(number(&pressed["in_time"]["max_penetration"]) > number(&apart["in_time"]["max_penetration"]));
    assert!(pressed["in_time"]["one_freedom"].is_null());
    let text = percuss(&line).stdout;
    assert!(text.contains("  compression") && text.contains("at ms"), "{text}");
    let svg = scratch.path("time.svg");
    assert_eq!(percuss(&format!("{line} --output {svg}")).code, 0);
    let drawn = std::fs::read_to_string(&svg).expect("written");
    assert!(drawn.contains("crank_hinge") && drawn.contains("compression (mm)"));
}

#[test]
fn a_free_body_on_the_other_side_and_a_floating_base() {
    // Two free masses: 1/m̄ = 1/m₁ + 1/m₂.
    let scratch = Scratch::new("impact-free");
    let body = r#"<robot name="b"><link name="body"><inertial><mass value="3"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"#;
    let model = scratch.write("body.urdf", body);
    let contact = format!("impact {model} --link body --point 0,0,0 --normal 0,0,-1 --base floating");
    let report = json(&format!(
        "{contact} --restitution 0.5 --speed 4 --base-twist 0,0,0,0,0,-3 --against-mass 6 --format json"
    ));
    let impulse = 1.5 * 2.0 * 4.0;
    close(&report["impulse"], impulse);
    close(&report["base"]["linear_after"][2], -3.0 + impulse / 3.0);
    close(&report["other_body"]["speed_change"], impulse / 6.0);
    close(&report["sticking_mass"], 2.0);
    // Without the other body, the given motion gives the closing speed.
    let falling = json(&format!("{contact} --restitution 0 --base-twist 0,0,0,0,0,-3 --format json"));
    close(&falling["closing_speed"], 3.0);
    close(&falling["base"]["linear_after"][2], 0.0);
    assert!(!falling["diagnostics"].to_string().contains("base-at-rest"), "{falling}");
    // Rates of joints without a velocity of the base: a note. Two bars of 2 kg in line, hinged at their ends; the second
    // turns about the hinge.
    let bar = |name: &str| {
        format!(
            r#"<link name="{name}"><inertial><origin xyz="0 0 -0.3"/><mass value="2"/>
            <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.1"/></inertial></link>"#
        )
    };
    let text = format!(
        r#"<robot name="bars">{}{}<joint name="elbow" type="continuous"><parent link="body"/><child link="tip"/>
        <origin xyz="0 0 -0.5"/><axis xyz="0 1 0"/></joint></robot>"#,
        bar("body"),
        bar("tip")
    );
    let bars = scratch.write("bars.urdf", &text);
    let elbow = format!(
        "impact {bars} --link tip --point 0,0,-0.5 --normal 1,0,0 --restitution 0 --rates elbow=-1 --format json"
    );
    let base = "--base floating";
    let codes = |flags: &str| json(&format!("{elbow} {flags}"))["diagnostics"].to_string();
    let floating = codes(base);
    assert!(
        floating.contains("base-at-rest") && floating.contains("(--base-twist)") && floating.contains("note"),
        "{floating}"
    );
    for other in ["--base floating --base-twist 0,0,0,0,0,0", ""] {
        assert!(!codes(other).contains("base-at-rest"), "{other}");
    }
}

#[test]
fn friction_at_the_stop_of_a_linkage() {
    // e_kinematic = e √((1−µt)/(1+µt)); t is the sliding of the point at unit closing speed.
    let report = json(&format!("{FOUR_BAR} --speed 2 --friction 0.2 --format json"));
    let number = |key: &str| report["friction"][key].as_f64().expect("a number");
    // At (0.35, 0.1) of the coupler, per unit rate of the crank: v = (−0.3 + 0.1·5/21, −0.35·5/21).
    let slope = (0.3 - 0.5 / 21.0) * 12.0;
    assert!((number("slope") / slope - 1.0).abs() < ROUNDING);
    let product = 0.2 * slope;
    let reached = 0.3 * ((1.0 - product) / (1.0 + product)).sqrt();
    assert!((number("kinematic_restitution") - reached).abs() < ROUNDING, "{report}");
    let mass = 417_304.0 / 6125.0;
    close(&report["impulse"], mass * 2.0 * (1.0 / (1.0 + product) + 0.3 / (1.0 - product * product).sqrt()));
    close(&named(&report["rates"], "joint", "crank_hinge")["after"][0], reached * 24.0);
    // Beyond µt = 1 the contact wedges.
    let wedged = json(&format!("{FOUR_BAR} --speed 2 --friction 0.4 --format json"));
    assert_eq!(wedged["friction"]["wedged"], true);
    close(&named(&wedged["rates"], "joint", "crank_hinge")["after"][0], 0.0);
    assert!(
        percuss(&format!("{FOUR_BAR} --speed 2 --friction 0.4")).stdout.contains("wedged, without rebound")
    );
    for (command, words) in [
        (format!("{FOUR_BAR} --speed 2 --friction -1"), "--friction: the coefficient"),
        (format!("{FOUR_BAR} --speed 2 --restitution-law newton"), "--friction"),
    ] {
        let outcome = percuss(&command);
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{command}: {}", outcome.stderr);
    }
}

/// Arm with two motions of its tip.
const ARM: &str = "impact models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg \
                   --rates shoulder=1 --rates elbow=0.5";

#[test]
fn friction_with_several_motions_lists_phases_thresholds_and_laws() {
    let command = format!("{ARM} --restitution 0.5 --friction 0.3");
    let report = json(&format!("{command} --format json"));
    let friction = &report["friction"];
    assert_eq!(friction["law"], "energetic");
    assert!(friction["slope"].is_null() && friction["sticking_threshold"].is_number());
    assert!(!friction["phases"].as_array().expect("phases").is_empty());
    let number = |value: &Value| value.as_f64().expect("a number");
    for law in friction["laws"].as_array().expect("laws") {
        if law["law"] == "energetic" {
            close(&law["normal_impulse"], number(&report["impulse"]));
            close(&law["energy_loss"], number(&report["energy_loss"]));
            let separation = number(&law["separation_speed"]) / number(&report["closing_speed"]);
            close(&friction["kinematic_restitution"], separation);
        }
        assert_eq!(law["creates_energy"], number(&law["energy_loss"]) < 0.0, "{law}");
    }
    // Friction acts within the cone and against the sliding or at rest.
    let tangential = friction["tangential_impulse_world"].as_array().expect("three");
    let size = tangential.iter().map(|x| number(x).powi(2)).sum::<f64>().sqrt();
    assert!(size <= 0.3 * number(&report["impulse"]) * (1.0 + ROUNDING));
    let text = percuss(&command).stdout;
    for words in ["phases", "thresholds", "law of restitution", "energetic (used)", "can stick from"] {
        assert!(text.contains(words), "{words} is missing in\n{text}");
    }
    // Without friction all laws are the frictionless impact.
    let smooth = json(&format!("{ARM} --restitution 0.5 --format json"));
    let none = json(&format!("{ARM} --restitution 0.5 --friction 0 --format json"));
    close(&none["impulse"], number(&smooth["impulse"]));
    for law in none["friction"]["laws"].as_array().expect("laws") {
        if law["law"] != "algebraic" {
            close(&law["normal_impulse"], number(&smooth["impulse"]));
        }
    }
    // The sliding of an assumed motion is stated.
    let assumed = percuss(
        "impact models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg --restitution 0.5 --speed 1 \
         --friction 0.3",
    );
    assert!(assumed.stdout.contains("by the assumed motion"), "{}", assumed.stdout);
}

/// Free body of 5 kg and 0.3 kg·m² about y that falls on two points.
const TWO_POINTS: &str = "impact models/floating_body.urdf --base floating --link body --point 0.3,0,0 --normal 0,0,-1 \
                          --base-twist 0,0,0,0,0,-1 --restitution 0.5 --also body:-0.2,0,0:0,0,-1";

#[test]
fn several_contacts_show_the_spread_of_the_laws() {
    let report = json(&format!("{TWO_POINTS} --format json"));
    let several = &report["simultaneous"];
    let contacts = several["contacts"].as_array().expect("contacts");
    assert_eq!(contacts.len(), 2);
    close(&contacts[0]["effective_mass"], 1.0 / (0.2 + 0.09 / 0.3));
    close(&contacts[1]["closing_speed"], 1.0);
    // W over the normals: 1/5 + x x'/0.3.
    close(&several["delassus"][0][3], 0.2 - 0.06 / 0.3);
    assert_eq!(several["delassus"].as_array().expect("rows").len(), 6);
    let laws = several["laws"].as_array().expect("laws");
    let law = |name: &str| laws.iter().find(|law| law["law"] == name).expect("a law");
    for name in ["newton", "poisson"] {
        (0..2).for_each(|i| close(&law(name)["opening_speeds"][i], 0.5));
    }
    // W is diagonal here: the energetic law has independent contacts, so that all laws agree.
    let spread = several["spread"].as_f64().expect("a spread");
    assert!(spread < 1e-9, "{spread}");
    // Each contact has its own restitution.
    let own = json(&format!("{TWO_POINTS} --also-restitution 0.2 --format json"));
    for (contact, e) in [(0, 0.5), (1, 0.2)] {
        close(&own["simultaneous"]["laws"][0]["opening_speeds"][contact], e);
    }
    // With coupled contacts they differ, and depend on the stiffness ratio.
    let coupled = TWO_POINTS.replace("body:-0.2", "body:-0.1");
    let spread = |more: &str| {
        let report = json(&format!("{coupled}{more} --format json"));
        report["simultaneous"]["spread"].as_f64().expect("a spread")
    };
    assert!(spread("") > 0.01);
    assert!((spread("") - spread(" --stiffness-ratio 1,10")).abs() > 1e-4);
    let text = percuss(&coupled).stdout;
    for words in ["energetic", "do not determine", "taken as closed", "alone"] {
        assert!(text.contains(words), "{words} is missing in\n{text}");
    }
    for (more, words) in [
        (" --stiffness-ratio 1", "--stiffness-ratio"),
        (" --also-restitution 0.2,0.3", "also-restitution"),
        (" --also-restitution 1.2", "also-restitution"),
        (" --also nope", "--also"),
        (" --also body:0,0,0", "--also"),
    ] {
        let outcome = percuss(&format!("{TWO_POINTS}{more}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{more}: {}", outcome.stderr);
    }
}

#[test]
fn sticking_points_let_go_and_need_friction() {
    let report = json(&format!("{TWO_POINTS} --sticking --friction 0.1 --format json"));
    let sticking = &report["simultaneous"]["sticking"];
    assert_eq!(sticking["sticks"], serde_json::json!([true, true]));
    // All momentum is lost: 3 N·s and 2 N·s at the distances 0.2 and 0.3 m from the centre, without friction.
    close(&sticking["normal_impulses"][0], 2.0);
    close(&sticking["normal_impulses"][1], 3.0);
    close(&sticking["energy_loss"], 2.5);
    let map = sticking["impact_map"].as_array().expect("rows");
    assert_eq!((map.len(), sticking["coordinates"].as_array().expect("names").len()), (6, 6));
    let text = percuss(&format!("{TWO_POINTS} --sticking")).stdout;
    assert!(text.contains("Plastic impact with sticking points"), "{text}");
}

#[test]
fn the_best_constant_armature_of_the_crank() {
    let command = format!("{FOUR_BAR} --speed 2 --reflected crank_hinge=0:360deg:361");
    let report = json(&format!("{command} --format json"));
    let range = &report["reflected_over"][0];
    assert_eq!(range["held"].as_array().expect("values").len(), 361);
    let number = |key: &str| range[key].as_f64().expect("a number");
    let (a, b) = (number("least"), number("most"));
    close(&range["best_constant"], 2.0 * a * b / (a + b));
    assert!((number("largest_error") - 0.7146).abs() < 1e-3, "{range}");
    close(&range["held"][0], 52163.0 / 110_250.0);
    assert!(percuss(&command).stdout.contains("the best constant"));
    let outcome = percuss(&format!("{FOUR_BAR} --speed 2 --reflected crank_hinge=0:1m:5"));
    assert!(outcome.code == 2 && outcome.stderr.contains("--reflected"), "{}", outcome.stderr);
}

#[test]
fn a_centre_of_percussion_names_open_components() {
    let command = format!("{FOUR_BAR} --speed 2 --percussion crank_hinge");
    let report = json(&format!("{command} --format json"));
    assert_eq!(report["percussion"][0]["open_components"], serde_json::json!([false, false, true]));
    assert_eq!(report["percussion"][0]["open_by"], serde_json::json!(["rocker_pin"]));
    let text = percuss(&command).stdout;
    assert!(
        text.split_whitespace().collect::<Vec<_>>().join(" ").contains("determinate components only"),
        "{text}"
    );
}

/// A joint spring makes the impact in time shorter; the check by the equation for one degree of freedom is then omitted.
#[test]
fn joint_springs_act_in_time() {
    let door = "impact models/physical_pendulum.urdf --link body --point 0,0,-0.5 --normal 1,0,0 --restitution 0.5 \
                --speed 1 --stiffness 1e5 --in-time";
    let duration = |more: &str| {
        let report = json(&format!("{door} {more} --format json"));
        (
            report["in_time"]["duration"].as_f64().expect("a duration"),
            report["in_time"]["one_freedom"].is_null(),
        )
    };
    let (free, (sprung, is_left_out)) = (duration("").0, duration("--joint-spring hinge=1e4"));
    // The spring adds k₂/l² to the stiffness of the contact, here 40 %: half a period of 1/√1.4 = 0.845. The damper of the contact, which is
    // that without the spring, shortens it by some per cent.
    let ratio = sprung / free;
    assert!(is_left_out && (0.79..0.845).contains(&ratio), "{ratio}");
    for (more, words) in [
        ("--joint-spring hinge=-1", "expected finite numbers"),
        ("--joint-spring hinge=1,2,3,4", "K,D,FREE"),
        ("--joint-spring nope=1", "--joint-spring"),
    ] {
        let outcome = percuss(&format!("{door} {more}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{more}: {}", outcome.stderr);
    }
}

/// Limits of rates and gears: the limit that is reached first is named, and an impact with this speed reaches it.
#[test]
fn the_first_limit_is_named() {
    let arm = "impact models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg \
               --restitution 0.1";
    let greatest = |limits: &str| {
        let report = json(&format!("{arm} --speed 1 {limits} --format json"));
        report["greatest_closing_speed"].clone()
    };
    let gear = greatest("--gear-limit elbow=0.1 --rate-limit elbow=180deg/s");
    assert_eq!((&gear["joint"], &gear["limit"]), (&"elbow".into(), &"gear".into()));
    let speed = gear["speed"].as_f64().expect("a speed");
    let report = json(&format!("{arm} --speed {speed} --format json"));
    let drive = report["reactions"].as_array().expect("reactions").iter().find(|r| r["name"] == "elbow");
    let impulse = drive.expect("the elbow")["gear"][0].as_f64().expect("an impulse");
    assert!((impulse.abs() / 0.1 - 1.0).abs() < 1e-9, "{impulse}");
    let rate = greatest("--gear-limit elbow=100 --rate-limit elbow=180deg/s");
    assert_eq!(rate["limit"], "rate");
    for (limits, words) in [
        ("--gear-limit elbow=-1", "--gear-limit"),
        ("--gear-limit elbow=1,2", "expected 1"),
        ("--gear-limit elbow=1 --armature elbow=0", "no armature"),
        ("--point-error 20mm", "--percussion"),
        ("--percussion shoulder --point-error=-1", "--point-error"),
    ] {
        let outcome = percuss(&format!("{arm} --speed 1 {limits}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{limits}: {}", outcome.stderr);
    }
}

/// Worst displaced contact point: an impact at this point has the reported impulse at the joint.
#[test]
fn a_displaced_point_has_the_worst_impulse() {
    let arm = "impact models/planar_2r.urdf --link outer --normal 0,1,0 --set elbow=40deg --restitution 0.1 --speed 1";
    let report =
        json(&format!("{arm} --point 0.4,0,0 --percussion shoulder --point-error 20mm --format json"));
    let centre = &report["percussion"][0];
    let (ratio, given) = (centre["worst_ratio"].as_f64(), centre["given_ratio"].as_f64());
    let ratio = ratio.expect("a ratio");
    assert!(ratio > given.expect("a ratio"));
    let point = centre["worst_point_link"].as_array().expect("a point");
    let point: Vec<String> = point.iter().map(|x| x.as_f64().expect("a number").to_string()).collect();
    let there = json(&format!("{arm} --point={} --percussion shoulder --format json", point.join(",")));
    let found = there["percussion"][0]["given_ratio"].as_f64().expect("a ratio");
    assert!((found / ratio - 1.0).abs() < 1e-9, "{found} {ratio}");
}

/// Rover with two locked rockers: the differential and the locks are redundant, so only the sum on each rocker is determinate. With one
/// lock all impulses are determinate, and the differential has equal impulses on both rockers.
#[test]
fn locks_and_couplings_of_one_joint_are_separate() {
    let wheel = "impact models/rocker_bogie.urdf --base floating --link left_front --point 0,0,-0.1 --normal 0,0,-1 --restitution 0 --speed 1";
    let constraints =
        |flags: &str| json(&format!("{wheel} {flags} --format json"))["joint_constraints"].clone();
    let one = constraints("--lock left_rocker");
    let of = |record: &Value, k: usize| record["impulses"][k].as_f64();
    assert_eq!((&one[0]["kind"], &one[0]["name"]), (&"lock".into(), &"left_rocker".into()));
    assert_eq!((&one[1]["kind"], &one[1]["name"]), (&"coupling".into(), &"differential".into()));
    assert!(of(&one[0], 0).is_some_and(|lock| lock.abs() > 1e-3), "{one}");
    let [left, right] = [0, 1].map(|k| of(&one[1], k).expect("an impulse"));
    assert!((left / right - 1.0).abs() < 1e-12, "{one}");
    let both = constraints("--lock left_rocker --lock right_rocker");
    assert_eq!(both.as_array().map(Vec::len), Some(3), "{both}");
    for record in both.as_array().expect("a list") {
        assert!(record["impulses"].as_array().is_some_and(|all| all.iter().all(Value::is_null)), "{record}");
    }
    let text = percuss(&format!("{wheel} --lock left_rocker --lock right_rocker")).stdout;
    assert!(text.contains("coupling differential  right_rocker ?, left_rocker ?"), "{text}");
    assert!(text.contains("redundant constraints leave the impulse open: differential"), "{text}");
}

/// Body of 5 kg with two feet: the impulses 5 N·s along the ground and across it need a coefficient of 1, however the feet share the
/// impulse along the ground. A contact that opens before the impact is marked.
#[test]
fn sticking_feet_need_friction() {
    let body = "impact models/floating_body.urdf --base floating --link body --point 0.1,0,-0.1 --normal 0,0,-1 --restitution 0";
    let feet = format!("{body} --also body:-0.1,0,-0.1:0,0,-1 --sticking --base-twist 0,0,0,1,0,-1");
    let sticking =
        |more: &str| json(&format!("{feet} {more} --format json"))["simultaneous"]["sticking"].clone();
    let alone = sticking("");
    // Accuracy of the search: the impulses are known to 1e-8.
    let least = alone["least_friction"].as_f64().expect("a coefficient");
    assert!((least - 1.0).abs() < 1e-5 && alone["friction_suffices"].is_null(), "{alone}");
    assert_eq!(sticking("--friction 0.9")["friction_suffices"], false);
    assert_eq!(sticking("--friction 1.1")["friction_suffices"], true);
    let text = percuss(&format!("{feet} --friction 0.4")).stdout.replace('\n', " ");
    assert!(
        text.contains("not possible") && text.contains("at least 1, ") && text.contains("0.6 less"),
        "{text}"
    );
    // The tangential impulses are open: the table states the bound of the best distribution, not a question mark.
    assert_eq!(text.matches("at most 1 ").count() + text.matches("at most 0.99").count(), 2, "{text}");
    let tilting =
        percuss(&format!("{body} --also body:-0.1,0,-0.1:0,0,-1 --base-twist 0,20,0,0,0,-1")).stdout;
    assert!(tilting.contains("(opens)") && tilting.contains("The motion before opens"), "{tilting}");
}
