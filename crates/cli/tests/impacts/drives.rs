//! Limits of gears and joint rates, springs of joints, and units of rates.

use crate::support::{Scratch, json, percuss, refused, root};
use serde_json::Value;

/// Rounding of a few operations.
const ROUNDING: f64 = 1e-12;

const ARM: &str = "impact models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg --restitution 0.3";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn close(a: f64, b: f64) {
    assert!((a / b - 1.0).abs() < ROUNDING, "{a} {b}");
}

/// At the greatest speed by a torque limit, the impulse of the gear per impulse of the contact, times the peak force, equals the limit. The
/// cases have several contact laws, exponents, joints and limits.
#[test]
fn torque_limits_are_reached_at_the_greatest_speed() {
    for law in ["", "--exponent 1.5", "--law hunt-crossley --exponent 1.5", "--law flores --exponent 1.5"] {
        for (joint, k, limit) in [("elbow", 1, 80.0), ("shoulder", 0, 35.0), ("elbow", 1, 3.0)] {
            let line = format!("{ARM} --stiffness 3e5 {law} --gear-limit {joint}={limit}Nm --format json");
            let found = &json(&format!("{line} --speed 1"))["greatest_closing_speed"];
            assert_eq!(found["limit"], "gear-torque", "{found}");
            assert_eq!(found["joint"], joint);
            let report = json(&format!("{line} --speed {}", number(&found["speed"])));
            let drive = &report["reactions"].as_array().expect("reactions")[k];
            assert_eq!(drive["name"], joint);
            let ratio = number(&drive["gear"][0]).abs() / number(&report["impulse"]);
            let torque = ratio * number(&report["contact_law"]["peak_force"]);
            assert!((torque / limit - 1.0).abs() < 1e-9, "{law} {joint}: {torque} {limit}");
        }
    }
    // The output names the limit that is reached first: here the impulse, not the torque.
    let both = format!(
        "{ARM} --speed 1 --stiffness 3e5 --gear-limit elbow=80Nm --gear-limit shoulder=0.001N·m·s --format json"
    );
    assert_eq!(json(&both)["greatest_closing_speed"]["limit"], "gear");
    let text = percuss(&format!("{ARM} --speed 1 --stiffness 3e5 --gear-limit elbow=80Nm")).stdout;
    assert!(text.replace('\n', " ").contains("limited by the peak torque in the gear of"), "{text}");
}

#[test]
fn units_of_gears_rates_and_springs() {
    let speed = |flags: &str| {
        number(&json(&format!("{ARM} --speed 1 {flags} --format json"))["greatest_closing_speed"]["speed"])
    };
    close(speed("--gear-limit elbow=0.5"), speed("--gear-limit elbow=0.5N·m·s"));
    close(speed("--rate-limit elbow=30rpm"), speed("--rate-limit elbow=180deg/s"));
    let of_rates = |rates: &str| number(&json(&format!("{ARM} {rates} --format json"))["closing_speed"]);
    close(
        of_rates("--rates shoulder=60rpm --rates elbow=0"),
        of_rates("--rates shoulder=360deg/s --rates elbow=0"),
    );
    let in_time = |spring: &str| {
        let line =
            format!("{ARM} --speed 1 --stiffness 1e5 --in-time --joint-spring elbow={spring} --format json");
        number(&json(&line)["in_time"]["duration"])
    };
    let degree = std::f64::consts::PI / 180.0;
    let plain = format!("{},0.2,{}", 10.0 / degree, 30.0 * degree);
    assert!((in_time("10N·m/deg,0.2N·m·s/rad,30deg") / in_time(&plain) - 1.0).abs() < 1e-9);
    for (flags, words) in [
        ("--gear-limit elbow=80Nm", &["--gear-limit", "stiffness of the contact"][..]),
        ("--gear-limit elbow=80N --stiffness 1e5", &["--gear-limit", "elbow", "N·m·s"]),
        ("--gear-limit elbow=3mm", &["elbow=3mm", "N·m·s or N·s or N·m or N"]),
        ("--gear-limit elbow=-1Nm --stiffness 1e5", &["--gear-limit", "above zero"]),
        ("--stiffness 1e5 --in-time --joint-spring elbow=10N/m", &["--joint-spring", "elbow"]),
        ("--stiffness 1e5 --in-time --joint-spring elbow=10,1,2mm", &["--joint-spring", "an angle"]),
        ("--rate-limit elbow=3mm", &["rpm", "mm/s"]),
    ] {
        refused(&format!("{ARM} --speed 1 {flags}"), words);
    }
}

#[test]
fn a_study_reads_limits_and_springs_with_units() {
    let folder = Scratch::new("drives-study");
    let text = |limit: &str, spring: &str| {
        format!(
            "[model]\npath = '{}'\n[contact]\nlink = \"outer\"\npoint = [0.4, 0, 0]\nnormal = [0, 1, 0]\n[pose]\nset.elbow = \"40deg\"\n\
             [impact]\nrestitution = 0.3\nspeed = 1\nstiffness = 3e5\nin_time = true\ngear_limit.elbow = {limit}\n\
             joint_spring.elbow = {spring}\n",
            root().join("models/planar_2r.urdf").display()
        )
    };
    let study = folder.write("study.toml", &text("\"80 N·m\"", "[\"10 N·m/deg\", 0.2]"));
    // The study is an input file too.
    let mut impact = json(&format!("run {study} --format json"))["impact"].take();
    let flags =
        "--speed 1 --stiffness 3e5 --in-time --gear-limit elbow=80Nm --joint-spring elbow=10N·m/deg,0.2";
    let command = json(&format!("{ARM} {flags} --format json"));
    impact["mass"]["inputs"] = command["mass"]["inputs"].clone();
    assert!(impact == command, "study and command differ");
    for (line, words) in [
        ("restitution_law = \"newton\"\n", "impact.restitution_law: it has no effect without friction"),
        ("contact_exponent = 1.5\n", "impact.contact_exponent: it has no effect without also"),
    ] {
        let rigid = text("0.5", "1").replace("in_time = true\n", "").replace("joint_spring.elbow = 1\n", "");
        let outcome = percuss(&format!("run {}", folder.write("without.toml", &(rigid + line))));
        let message = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && message.contains(words), "{line}: {message}");
    }
}

/// Greatest closing speed within the velocity limits of the joints. Arm: Σ |j_i| limit_i, with j_i from the effective masses with all other
/// joints locked. Four-bar linkage: the smaller of the speeds at the limits of the crank and of the rocker.
#[test]
fn safe_speeds_state_the_reach_of_the_joints() {
    let tool = "models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 1,0.3,-0.2 --set elbow=70deg --set shoulder=-0.4";
    let report = json(&format!("safe-speed {tool} --region chest --force 280 --format json"));
    let joints = json("check models/six_r_arm.urdf --format json");
    let names: Vec<&str> = joints["joints"]
        .as_array()
        .expect("joints")
        .iter()
        .filter(|joint| joint["type"] != "fixed")
        .map(|joint| joint["name"].as_str().expect("a name"))
        .collect();
    assert_eq!(names.len(), 6);
    let limits = [2.0, 2.0, 3.0, 4.0, 4.0, 6.0];
    let mut expected = 0.0;
    for (name, limit) in names.iter().zip(limits) {
        let locks: String =
            names.iter().filter(|other| *other != name).map(|other| format!(" --lock {other}")).collect();
        let alone = json(&format!("mass {tool}{locks} --format json"));
        let held = json(&format!(
            "impact models/six_r_arm.urdf --set elbow=70deg --set shoulder=-0.4 --reflected {name} --format json"
        ));
        let inertia = number(&held["reflected_inertia"][0]["held"]);
        if let Some(mass) = alone["effective_mass"].as_f64() {
            expected += (inertia / mass).sqrt() * limit;
        }
    }
    // The masses are accurate to 1e-12; their square roots are summed.
    let found = &report["reachable"];
    assert!((number(&found["speed"]) / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    let text = percuss(&format!("safe-speed {tool} --region chest --force 280")).stdout;
    assert!(
        text.contains("reachable speed") && text.contains("m/s at most within velocity limits"),
        "{text}"
    );
    // Four-bar: per unit rate of the crank the contact moves by 1/12 m, the rocker by 8/21 rad.
    let folder = Scratch::new("reach");
    let bar = std::fs::read_to_string(root().join("models/four_bar.urdf")).expect("the model");
    let limited = |crank: &str, rocker: &str| {
        let with_limit = |text: &str, joint: &str, rate: &str| {
            let start = format!("<joint name=\"{joint}\"");
            let at = text.find(&start).expect("the joint");
            let end = at + text[at..].find("</joint>").expect("its end");
            let limit = if rate.is_empty() {
                String::new()
            } else {
                format!("<limit effort=\"1\" velocity=\"{rate}\"/>")
            };
            format!("{}{limit}{}", &text[..end], &text[end..])
        };
        let text = with_limit(&with_limit(&bar, "crank_hinge", crank), "rocker_hinge", rocker);
        let model = folder.write("limited.urdf", &text);
        let line = format!(
            "safe-speed {model} --link coupler --point 0.35,0.1,0 --normal 0,1,0 --region chest --force 280 --format json"
        );
        json(&line)["reachable"].clone()
    };
    close(number(&limited("3", "")["speed"]), 3.0 / 12.0);
    close(number(&limited("3", "0.5")["speed"]), 0.5 * 21.0 / 8.0 / 12.0);
    assert_eq!(limited("3", "0.5")["limited_by"], serde_json::json!(["rocker_hinge"]));
    assert!(limited("", "").is_null() && limited("0", "").is_null());
}

/// Without `--rates`, errors of the motion before the impact name `--base-twist`; errors of sticking points name `--sticking`.
#[test]
fn errors_of_a_base_twist_name_it() {
    let body = "impact models/floating_body.urdf --base floating --link body --point 0,0.2,0 --normal 1,0,0 --restitution 0.5";
    refused(&format!("{body} --base-twist 0,0,0,-1,0,0"), &["--base-twist: the closing speed"]);
    let agreeing = json(&format!("{body} --speed 1 --base-twist 0,0,0,1,0,0 --format json"));
    close(number(&agreeing["closing_speed"]), 1.0);
    let stop = format!("{ARM} --speed 1 --sticking --also elbow:upper");
    refused(&stop, &["--sticking: the stop of a joint"]);
}

/// Block on a slide against a linear stop, pushed by a constant drive: ½ m v² + F x = ½ k x² at the largest penetration x, and the effective
/// weight of absorber catalogues is m + 2 F x/v². The drive is the same as a force between two points, and its work is in the energy balance.
#[test]
fn drives_push_during_the_stop() {
    let scratch = Scratch::new("drives-push");
    let model = scratch.write(
        "block.urdf",
        "<robot name=\"r\"><link name=\"rail\"/><link name=\"block\"><inertial><mass value=\"36\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" \
         ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link><joint name=\"slide\" type=\"prismatic\"><parent link=\"rail\"/><child \
         link=\"block\"/><axis xyz=\"1 0 0\"/><limit lower=\"-1\" upper=\"1\" effort=\"0\" velocity=\"0\"/></joint></robot>",
    );
    for (speed, force, stiffness) in [(1.5, 400.0, 2e5), (0.4, 2500.0, 8e4), (2.0, -300.0, 1e6)] {
        let run = |drive: &str| {
            json(&format!(
                "impact {model} --link block --point 0,0,0 --normal 1,0,0 --speed {speed} --restitution 1 --stiffness {stiffness} --in-time \
                 --drive {drive} --format json"
            ))
        };
        let x = (force + f64::sqrt(force * force + 36.0 * speed * speed * stiffness)) / stiffness;
        let weight = 36.0 + 2.0 * force * x / (speed * speed);
        for drive in [format!("slide={force}N"), format!("rail:-0.5,0,0=block={force}")] {
            let report = run(&drive);
            let found = &report["in_time"];
            // The tolerance of the steps.
            assert!((number(&found["max_penetration"]) / x - 1.0).abs() < 1e-7, "{drive}: {found}");
            // The parabola through three of about a hundred samples of half a sine: (π/100)³/15.
            assert!(
                (number(&found["effective_weight"]) / weight - 1.0).abs() < 1e-5,
                "{drive}: {weight} {found}"
            );
            assert!(number(&found["energy"]["residual"]).abs() < 1e-7, "{drive}: {found}");
        }
    }
    let line = format!(
        "impact {model} --link block --point 0,0,0 --normal 1,0,0 --speed 1 --restitution 0.5 --stiffness 1e5"
    );
    for (flags, words) in [
        ("--in-time --drive slide=40N·m", &["--drive", "slide", "N"][..]),
        ("--in-time --drive slid=40", &["--drive", "slid"]),
        ("--in-time --drive slide=40=3=2", &["--drive", "JOINT=TORQUE"]),
        ("--in-time --damper rail=block=-5", &["--damper", "sign"]),
        ("--in-time --damper rail=block=0:10,1:20", &["--damper", "at rest"]),
        ("--in-time --damper rail=blok=5", &["--damper", "blok"]),
        ("--drive slide=40", &["--in-time"]),
    ] {
        refused(&format!("{line} {flags}"), words);
    }
    for key in ["damper = [\"rail=block=5\"]", "drive = [\"slide=40\"]"] {
        let study = scratch.write(
            "study.toml",
            &format!(
                "[model]\npath = \"block.urdf\"\n[contact]\nlink = \"block\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]\n[impact]\n\
                 speed = 1\nrestitution = 0.5\nstiffness = 1e5\n{key}\n"
            ),
        );
        refused(&format!("run {study}"), &["impact.d", "in_time"]);
    }
}

/// The damper of a sheet acts as the same damper between its ends, and can be left out; `damp` warns about it.
#[test]
fn dampers_of_the_sheet_act() {
    let scratch = Scratch::new("drives-damper");
    let sheet =
        std::fs::read_to_string(root().join("models/suspensions/double-wishbone.toml")).expect("a sheet");
    let plain = scratch.write("plain.toml", &sheet);
    let line = "--at bump_stop --speed 1 --restitution 0.3 --stiffness 100N/mm";
    let restitution = |path: &str, flags: &str| {
        let report = json(&format!("impact {path} {line} --in-time {flags} --format json"));
        number(&report["in_time"]["restitution"])
    };
    let none = restitution(&plain, "--springs none");
    for (keys, flag) in [
        ("damping = \"1500 N·s/m\"", "1500"),
        (
            "speeds = [-1.0, \"-200 mm/s\", 0, 0.1, 0.5]\nforces = [-900, -300, 0, 250, \"0.9 kN\"]",
            "-1:-900,-0.2:-300,0:0,0.1:250,0.5:900",
        ),
    ] {
        let own = sheet.replacen("[damper]", &format!("[damper]\n{keys}"), 1);
        let own = if own == sheet { format!("{sheet}\n[damper]\n{keys}\n") } else { own };
        let car = scratch.write("car.toml", &own);
        let of_sheet = restitution(&car, "");
        let given = restitution(&plain, &format!("--damper damper_seat=damper_chassis_seat={flag}"));
        // The same equations in another order of forces.
        assert!((of_sheet - given).abs() < 1e-9, "{keys}: {of_sheet} {given}");
        assert!((restitution(&car, "--springs none") - none).abs() < 1e-12, "{keys}");
        assert!(of_sheet < none - 0.01, "{keys}: {of_sheet} {none}");
        let warned = percuss(&format!("damp --mass-from {car} {line}"));
        assert!(warned.stderr.contains("springs and dampers of the model act"), "{}", warned.stderr);
    }
    for keys in
        ["speeds = [0, 1]", "damping = 1500", "speeds = [0, 1]\nforces = [0, -5]", "damping = \"-3 N·s/m\""]
    {
        let own = sheet.replacen("[damper]", &format!("[damper]\n{keys}"), 1);
        let own = if own == sheet { format!("{sheet}\n[damper]\n{keys}\n") } else { own };
        let car = scratch.write("car.toml", &own);
        refused(&format!("mass {car} --at bump_stop"), &["damper."]);
    }
}
