//! The same question for other poses and designs: travels and pose files, changed masses and hardpoints,
//! sensitivities of a result, motion ratios.

use crate::support::{Scratch, Sweep, json, percuss, refused, root};
use serde_json::Value;

/// Sheets of one corner, and the contact at the bump stop.
const CORNERS: [&str; 6] =
    ["double-wishbone", "macpherson-strut", "multi-link", "pushrod-rocker", "three-link", "twist-beam"];
const STOP: &str =
    "--link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --turning-normal --against chassis";
const AXLE: &str = "models/suspensions/solid-axle-panhard.toml --link bump_stop_pad_left --point 0,0,0 \
     --along-line bump_stop_left:0,0,0 --against chassis";
const PENDULUM: &str = "models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0";

fn sheet(name: &str) -> String {
    format!("models/suspensions/{name}.toml {STOP}")
}

fn mass(line: &str) -> f64 {
    let report = json(&format!("{line} --format json"));
    report["effective_mass"].as_f64().unwrap_or_else(|| panic!("{line}: {report}"))
}

/// Loops are closed and travels are met to 1e-12 of the size; the relative change of m̄ is some multiple of this.
fn assert_same(a: f64, b: f64, what: &str) {
    assert!((a / b - 1.0).abs() < 1e-9, "{what}: {a} {b}");
}

#[test]
fn a_travel_stands_where_a_sweep_over_it_does_and_its_json_is_a_pose() {
    let folder = Scratch::new("questions-travel");
    let along = "wheel_centre:0,0,0:0,0,1";
    for name in CORNERS {
        let question = sheet(name);
        let rows = percuss(&format!("sweep {question} --vary travel:{along}=-20mm:20mm:5"));
        let rows = Sweep::read(&rows.stdout);
        let travels = [(0, "-20mm"), (4, "2cm"), (1, "-0.01"), (2, "0")];
        // The units of a travel do not depend on the suspension.
        let count = if name == CORNERS[0] { 4 } else { 2 };
        for (row, travel) in travels.into_iter().take(count) {
            let line = format!("mass {question} --travel {along}={travel} --format json");
            let outcome = percuss(&line);
            let report: Value = serde_json::from_str(&outcome.stdout).expect("JSON");
            let found = report["effective_mass"].as_f64().expect("a mass");
            assert_same(found, rows.number(row, "effective_mass").expect("a mass"), &line);
            let file = folder.write("pose.json", &outcome.stdout);
            assert_same(mass(&format!("mass {question} --pose {file}")), found, &line);
            // The ratio of the speeds of wheel and contact equals the motion ratio of the sweep.
            let ratios = report["motion_ratios"].as_array().expect("a list");
            let of_centre = ratios.iter().find(|r| r["link"] == "wheel_centre").expect("the wheel's centre");
            let ratio = of_centre["contact_per_wheel"].as_f64().expect("a ratio");
            assert_same(ratio, rows.number(row, "motion_ratio").expect("a ratio"), &line);
            assert_eq!(of_centre["one_travel"], true, "{line}");
        }
        // Beyond the range of travel no pose exists: exit code 1, with the largest reachable travel in the message.
        let beyond = percuss(&format!("mass {question} --travel {along}=3m"));
        assert_eq!(beyond.code, 1, "{}", beyond.stderr);
        assert!(beyond.stderr.contains("--travel: "), "{}", beyond.stderr);
    }
}

#[test]
fn two_travels_are_reached_together() {
    let at = |left: &str, right: &str| {
        let of = |side: &str, by: &str| format!("--travel wheel_centre_{side}:0,0,0:0,0,1={by}");
        let report = json(&format!("mass {AXLE} {} {} --format json", of("left", left), of("right", right)));
        (report["effective_mass"].as_f64().expect("a mass"), report["pose"].clone())
    };
    // The order of the travels does not matter.
    let (there, _) = at("8mm", "-4mm");
    let line = format!(
        "mass {AXLE} --travel wheel_centre_right:0,0,0:0,0,1=-4mm --travel wheel_centre_left:0,0,0:0,0,1=8mm"
    );
    assert_same(there, mass(&line), &line);
    // At the design position, both travels are zero.
    assert_same(at("0", "0").0, mass(&format!("mass {AXLE}")), "no travel");
    assert!((there / at("0", "0").0 - 1.0).abs() > 1e-6, "the axle does not roll");
}

#[test]
fn a_travel_goes_with_ranges_and_studies() {
    let folder = Scratch::new("questions-study");
    let model = root().join("models/double_wishbone.urdf");
    let spring = "--link spring_seat --point 0,0,0 --along-line spring_chassis_seat:0,0,0";
    let text = |pose: &str| {
        format!(
            "[model]\npath = {:?}\n[pose]\n{pose}\n[contact]\nlink = \"spring_seat\"\npoint = [0, 0, 0]\n\
             along_line = {{ link = \"spring_chassis_seat\", point = [0, 0, 0] }}\nratio_at = [{{ link = \"spindle\" }}]\n",
            model.to_string_lossy()
        )
    };
    let by_flags = format!("mass models/double_wishbone.urdf {spring} --travel spindle:0,0,0:0,0,1=40mm");
    let expected = mass(&by_flags);
    let study = folder.write("travel.toml", &text("travel = \"spindle:0,0,0:0,0,1=40mm\""));
    assert_same(mass(&format!("run {study}")), expected, "study");
    folder.write("pose.json", &percuss(&format!("{by_flags} --format json")).stdout);
    let study = folder.write("file.toml", &text("file = \"pose.json\""));
    let report = json(&format!("run {study} --format json"));
    assert_same(report["effective_mass"].as_f64().expect("a mass"), expected, "file");
    assert_eq!(report["motion_ratios"][0]["link"], "spindle");
    assert_eq!(report["inputs"].as_array().expect("inputs").len(), 3, "model, study and pose");
    // With a range, a travel acts as the last range, with a single value.
    let sweep = |more: &str| {
        let line = format!("sweep models/double_wishbone.urdf {spring} --vary spin=0:1:2 {more}");
        Sweep::read(&percuss(&line).stdout)
    };
    let (with, as_range) =
        (sweep("--travel spindle:0,0,0:0,0,1=40mm"), sweep("--vary travel:spindle:0,0,0:0,0,1=40mm:40mm:1"));
    assert_eq!(with.rows, as_range.rows);
    assert_same(with.number(0, "effective_mass").expect("a mass"), expected, "sweep");
    refused(
        &format!("sweep models/double_wishbone.urdf {spring} --travel spindle:0,0,0:0,0,1=1mm --random 3"),
        &["--travel: ", "random positions"],
    );
    for (pose, words) in [
        ("travel = \"spindle=40mm\"", ["pose.travel", "LINK:X,Y,Z:DX,DY,DZ=DISTANCE"]),
        ("travel = \"spndle:0,0,0:0,0,1=40mm\"", ["pose.travel", "spindle"]),
        ("file = \"nowhere.json\"", ["pose.file", "no such file"]),
    ] {
        refused(&format!("run {}", folder.write("bad.toml", &text(pose))), &words);
    }
}

#[test]
fn files_of_poses_are_read_or_refused() {
    let folder = Scratch::new("questions-pose");
    let arm = "models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --normal-frame world";
    let by_flags = mass(&format!("mass {arm} --set shoulder=-40deg --set elbow=70deg"));
    let with = |name: &str, text: &str, more: &str| {
        mass(&format!("mass {arm} --pose {} {more}", folder.write(name, text)))
    };
    // Some joints in any notation; flags take precedence over the file.
    assert_same(
        with("map.json", "{\"shoulder\": \"-40deg\", \"elbow\": [1.2217304763960306]}", ""),
        by_flags,
        "map",
    );
    let line = "{\"shoulder\": 1, \"elbow\": \"70deg\"}";
    assert_same(with("over.json", line, "--set shoulder=-40deg"), by_flags, "over");
    let crank = "models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";
    let linkage = json(&format!("mass {crank} --set crank_hinge=50deg --format json"));
    let pose = serde_json::to_string(&linkage["pose"]).expect("JSON");
    // All joints of a linkage; then with a different crank position.
    let file = folder.write("whole.json", &pose);
    assert_same(
        mass(&format!("mass {crank} --pose {file}")),
        linkage["effective_mass"].as_f64().unwrap(),
        "whole",
    );
    assert_same(
        mass(&format!("mass {crank} --pose {file} --set crank_hinge=60deg")),
        mass(&format!("mass {crank} --set crank_hinge=60deg")),
        "whole and set",
    );
    let other = folder.write("other.json", &serde_json::to_string(&linkage).expect("JSON"));
    refused(
        &format!("mass {arm} --pose {other}"),
        &["--pose: ", "another model", "four_bar.urdf", "\"shoulder"],
    );
    let mut less = linkage.clone();
    less["pose"].as_object_mut().expect("joints").remove("rocker_hinge");
    let less = folder.write("less.json", &less.to_string());
    refused(&format!("mass {crank} --pose {less}"), &["--pose: ", "another model", "\"rocker_hinge\""]);
    for (text, word) in [
        ("", "not JSON"),
        ("[1, 2]", "no JSON object"),
        ("{}", "names no joint"),
        ("{\"rows\": []}", "many poses"),
        ("{\"schema\": \"percuss.damp/1\"}", "no \"pose\""),
        ("{\"elbow\": null}", "a number, a list of numbers"),
        ("{\"elbow\": \"1m\"}", "expected an angle"),
        ("{\"elbow\": [1, 2]}", "2 values given"),
        ("{\"elbw\": 1}", "elbow"),
        ("{\"elbow\": \"x\"}", "joint \"elbow\""),
    ] {
        refused(&format!("mass {arm} --pose {}", folder.write("bad.json", text)), &["--pose", word]);
    }
    // A pose of another file with the same joints gives a warning, which --strict turns into an error.
    let text = std::fs::read_to_string(root().join("models/four_bar.urdf")).expect("a model");
    let copy = folder.write("copy.urdf", &format!("{text}\n"));
    let line = format!("mass {copy} --link coupler --point 0.35,0.1,0 --normal 0,1,0 --pose {other}");
    let outcome = percuss(&line);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(outcome.stderr.contains("was computed for models/four_bar.urdf"), "{}", outcome.stderr);
    assert_eq!(percuss(&format!("{line} --strict")).code, 2);
}

/// m (r_A/r_B)² with another mass, another position, and both.
#[test]
fn masses_and_their_centres_are_changed() {
    let expected = |m: f64, r: f64| m * (r / 0.8).powi(2);
    assert_same(mass(&format!("mass {PENDULUM} --link-mass bob=5000g")), expected(5.0, 0.5), "mass");
    assert_same(mass(&format!("mass {PENDULUM} --link-com bob=0,0,-100mm")), expected(2.0, 0.6), "com");
    let both = "--link-mass bob=5 --link-com bob=0,0,0.1";
    assert_same(mass(&format!("mass {PENDULUM} {both}")), expected(5.0, 0.4), "both");
    // The moment of inertia about the hinge adds J/r², also after a change of the mass.
    let turned = "--link-inertia bob=0.1,0.64,0.6";
    assert_same(mass(&format!("mass {PENDULUM} {turned}")), expected(2.0, 0.5) + 1.0, "inertia");
    let both = format!("--link-mass bob=5 {turned}");
    assert_same(mass(&format!("mass {PENDULUM} {both}")), expected(5.0, 0.5) + 1.0, "mass and inertia");
    // A massless link gets a point mass at its origin; the same in every command that loads a model.
    let more = "--link-mass rod=3 --link-com rod=0,0,-0.8";
    let heavier = expected(2.0, 0.5) + 3.0;
    assert_same(mass(&format!("mass {PENDULUM} {more}")), heavier, "rod");
    let damp =
        json(&format!("damp --mass-from {PENDULUM} {more} --stiffness 1e5 --restitution 0.3 --format json"));
    assert_same(damp["effective_mass"].as_f64().expect("a mass"), heavier, "damp");
    let swept = percuss(&format!("sweep {PENDULUM} {more} --vary hinge=0:1:2"));
    assert_same(Sweep::read(&swept.stdout).number(1, "effective_mass").expect("a mass"), heavier, "sweep");
    assert!(percuss(&format!("check models/point_mass_pendulum.urdf {more}")).stdout.contains("3 kg"));
    // The inertia of a body scales with its mass: doubling all masses doubles the result.
    let arm = "models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --set elbow=70deg";
    let doubled: String = json("check models/six_r_arm.urdf --format json")["links"]
        .as_array()
        .expect("links")
        .iter()
        .filter(|link| link["mass"].as_f64().is_some_and(|m| m > 0.0))
        .map(|link| {
            format!(
                " --link-mass {}={}",
                link["name"].as_str().unwrap(),
                2.0 * link["mass"].as_f64().unwrap()
            )
        })
        .collect();
    assert_same(mass(&format!("mass {arm} {doubled}")), 2.0 * mass(&format!("mass {arm}")), "doubled");
    for (flag, words) in [
        ("--link-mass bub=1", ["--link-mass", "\"bub\""]),
        ("--link-mass bob=-1", ["--link-mass", "0 or more"]),
        ("--link-mass bob", ["--link-mass", "LINK=KG"]),
        ("--link-mass bob=1m", ["--link-mass", "mass"]),
        ("--link-com rod=0,0,0", ["--link-com", "no mass"]),
        ("--link-com bob=0,0", ["--link-com", "3"]),
        ("--link-com bab=0,0,0", ["--link-com", "\"bab\""]),
        ("--link-inertia bob=1,1,2.1", ["--link-inertia", "sum of the other two"]),
        ("--link-inertia bob=1,1,nan", ["--link-inertia", "nan"]),
        ("--link-inertia bob=1,1", ["--link-inertia", "2 moments of inertia; expected 3"]),
        ("--link-inertia bob=1kg,1,1", ["--link-inertia", "kg m2"]),
        ("--link-inertia rod=1,1,1", ["--link-inertia", "no mass"]),
        ("--move lower_ball=0,0,5mm", ["--move", "is a URDF without hardpoints"]),
    ] {
        refused(&format!("mass {PENDULUM} {flag}"), &words);
    }
}

#[test]
fn a_point_is_moved_as_if_the_sheet_had_it_there() {
    let folder = Scratch::new("questions-move");
    let text =
        std::fs::read_to_string(root().join("models/suspensions/double-wishbone.toml")).expect("a sheet");
    let edited = text.replace("lower_ball = [5.0, 720.0, 180.0]", "lower_ball = [5.0, 720.0, 185.0]");
    assert_ne!(text, edited);
    let edited = folder.write("edited.toml", &edited);
    for more in ["", "--travel spindle:0,0,0:0,0,1=20mm", "--link-mass upright=10kg"] {
        let moved = mass(&format!("mass {} --move lower_ball=0,0,5mm {more}", sheet("double-wishbone")));
        assert_same(moved, mass(&format!("mass {edited} {STOP} {more}")), more);
        assert!((moved / mass(&format!("mass {} {more}", sheet("double-wishbone"))) - 1.0).abs() > 1e-4);
    }
    // A sheet gives the same result as the model imported from it.
    let model = folder.path("model.urdf");
    assert_eq!(percuss(&format!("import models/suspensions/double-wishbone.toml -o {model}")).code, 0);
    assert_same(
        mass(&format!("mass {model} {STOP}")),
        mass(&format!("mass {}", sheet("double-wishbone"))),
        "import",
    );
    refused(
        &format!("mass {} --move lower_bal=0,0,5mm", sheet("double-wishbone")),
        &["lower_bal", "did you mean lower_ball", "--move"],
    );
}

/// Each rate of an explanation, compared with central differences of the result; their error is of the order of the
/// squared step.
#[test]
fn explanations_are_the_rates_of_the_answer() {
    let arm = "models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --set elbow=70deg --set shoulder=-40deg";
    let lines = [
        arm.to_owned(),
        format!("{arm} --base floating --link-mass pedestal=30 --against-mass 3"),
        format!("{} --travel spindle:0,0,0:0,0,1=20mm", sheet("double-wishbone")),
        sheet("macpherson-strut"),
        "models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --set crank_hinge=1 --against crank".into(),
    ];
    let mut compared = 0;
    for line in &lines {
        let report = json(&format!("mass {line} --explain --format json"));
        let explained = &report["explanation"];
        let own = report["effective_mass"].as_f64().expect("a mass");
        let difference = |flag: &dyn Fn(f64) -> String, step: f64| {
            let at = |by: f64| {
                let change = flag(by);
                // The mass of a link is given once.
                let is_again = change.contains("--link-mass pedestal");
                let line = if is_again { line.replace("--link-mass pedestal=30", "") } else { line.clone() };
                mass(&format!("mass {line} {change}"))
            };
            (at(step) - at(-step)) / (2.0 * step)
        };
        let close = |rate: f64, other: f64, scale: f64, what: &str| {
            // Squared step, 1e-8, and the rounding error of m̄ divided by the step.
            let allowed = 1e-6 * rate.abs() + 1e-7 * scale;
            assert!((rate - other).abs() <= allowed, "{line}: {what}: {rate} {other}");
        };
        let of_model: Value = json(&format!("check {} --format json", line.split(' ').next().unwrap()));
        for link in explained["links"].as_array().expect("links").iter().take(4) {
            let (name, m) = (link["link"].as_str().unwrap(), link["mass"].as_f64().unwrap());
            let rate = link["per_kilogram"].as_f64().unwrap();
            close(rate, difference(&|by| format!("--link-mass {name}={}", m + by), 1e-4 * m), own / m, name);
            let listed = of_model["links"].as_array().unwrap().iter().find(|l| l["name"] == name).unwrap();
            // A link without an inertial has no centre of mass to move.
            let Some(com) = listed["com"].as_array() else { continue };
            let com: Vec<f64> = com.iter().map(|x| x.as_f64().unwrap()).collect();
            for axis in 0..3 {
                let moved = |by: f64| {
                    let at: Vec<String> =
                        (0..3).map(|i| (com[i] + if i == axis { by } else { 0.0 }).to_string()).collect();
                    format!("--link-com {name}={}", at.join(","))
                };
                let rate = link["per_metre_of_com"][axis].as_f64().unwrap();
                close(rate, difference(&moved, 1e-4), own, name);
            }
            compared += 1;
        }
        for rotor in explained["rotors"].as_array().expect("rotors").iter().take(3) {
            let rates = rotor["per_armature"].as_array().unwrap();
            if rates.len() == 1 {
                // Armatures are not negative: one-sided differences of second order.
                let name = rotor["joint"].as_str().unwrap();
                let at = |value: f64| mass(&format!("mass {line} --armature {name}={value:e}"));
                let step = 1e-7;
                let slope = (-3.0 * at(0.0) + 4.0 * at(step) - at(2.0 * step)) / (2.0 * step);
                let rate = rates[0].as_f64().unwrap();
                assert!((slope - rate).abs() <= 1e-4 * rate + 1e-4 * own, "{line}: {name}: {slope} {rate}");
                compared += 1;
            }
        }
        for point in explained["points"].as_array().expect("points").iter().skip(4).step_by(5) {
            let name = point["point"].as_str().unwrap();
            let along = |by: f64| format!("--move {name}=0,{by},{}", 2.0 * by);
            let rate =
                point["per_metre"][1].as_f64().unwrap() + 2.0 * point["per_metre"][2].as_f64().unwrap();
            close(rate, difference(&along, 2e-5), own, name);
            compared += 1;
        }
        // The change listed first is the strongest.
        let greatest =
            explained["links"].as_array().unwrap().iter().map(|l| l["per_kilogram"].as_f64().unwrap());
        assert_eq!(explained["most_per_kilogram"][0]["lowers_by"].as_f64(), greatest.reduce(f64::max));
    }
    assert!(compared > 20, "only {compared} rates");
    let text = percuss(&format!("mass {} --explain", sheet("double-wishbone"))).stdout;
    for words in
        ["most per kilogram    1 kg less of wheel: ", "most per millimetre  bump_stop_pad 1 mm along "]
    {
        assert!(text.contains(words), "{text}");
    }
}

/// m̄ = m (r_A/r_B)²: a tolerance of 2 % of m is 2 % of m̄; an offset δ of the centre of mass along the rod changes
/// m̄ by the fraction 2 δ/r_A.
#[test]
fn tolerances_are_those_of_the_closed_form() {
    let report =
        json(&format!("mass {PENDULUM} --tolerance mass=2%,com=1mm --samples 20000 --seed 7 --format json"));
    let (own, tolerance) = (0.78125, &report["tolerance"]);
    let [mass, com] = [0.02 * own, 2.0 * 0.001 / 0.5 * own];
    let number = |value: &Value| value.as_f64().expect("a number");
    assert_same(number(&tolerance["parts"]["mass"]), mass, "mass");
    assert_same(number(&tolerance["parts"]["com"]), com, "com");
    assert_same(number(&tolerance["root_sum_square"]), mass.hypot(com), "root sum square");
    assert_same(number(&tolerance["worst_case"]), mass + com, "worst case");
    // Uniform between ±δ: the standard deviation is δ/√3. For 20,000 samples, mean and deviation are accurate to
    // about half a per cent.
    let samples = &tolerance["samples"];
    let deviation = mass.hypot(com) / 3.0f64.sqrt();
    assert!((number(&samples["standard_deviation"]) / deviation - 1.0).abs() < 0.02, "{samples}");
    assert!((number(&samples["mean"]) - own).abs() < 0.03 * deviation, "{samples}");
    assert!(number(&samples["greatest"]) < own + 1.01 * (mass + com), "{samples}");
    assert!(number(&samples["least"]) > own - 1.01 * (mass + com), "{samples}");
    assert!(number(&samples["percentile_2_5"]) < number(&samples["percentile_97_5"]));
    let again =
        json(&format!("mass {PENDULUM} --tolerance mass=2%,com=1mm --samples 20000 --seed 7 --format json"));
    assert_eq!(again["tolerance"], report["tolerance"], "the same seed");
    // Tolerances of different quantities may be given one by one.
    let apart = json(&format!(
        "mass {PENDULUM} --tolerance mass=2% --tolerance com=1mm --samples 20000 --seed 7 --format json"
    ));
    assert_eq!(apart["tolerance"], report["tolerance"], "one by one");
    // --expect has its own tolerance.
    let both = format!("mass {PENDULUM} --expect 0.782 --tolerance 0.01 --tolerance mass=1%");
    assert_eq!(percuss(&both).code, 0);
    for (flags, words) in [
        ("--tolerance 0.1", ["--tolerance", "--expect"]),
        ("--tolerance mass=2kg", ["--tolerance", "mass=2%"]),
        ("--tolerance girth=2%", ["--tolerance", "girth"]),
        ("--tolerance point=1mm", ["--tolerance", "without hardpoints"]),
        ("--tolerance mass=1% --samples 1", ["--samples", "2 to"]),
        ("--tolerance mass=1% --tolerance mass=2%", ["--tolerance", "twice"]),
        ("--samples 10", ["--tolerance", "required"]),
    ] {
        refused(&format!("mass {PENDULUM} {flags}"), &words);
    }
}

/// Half way along the rod, the speed is half. An arm with six joints has no unique motion ratio.
#[test]
fn motion_ratios_are_unambiguous_or_say_so() {
    let ratios = |line: &str| json(&format!("mass {line} --format json"))["motion_ratios"].clone();
    let half = ratios(&format!("{PENDULUM} --ratio-at rod:0,0,-0.4:-2,0,0 --set hinge=0"));
    assert_same(half[0]["contact_per_wheel"].as_f64().unwrap(), -2.0, "rod");
    assert_eq!(half[0]["one_travel"], true);
    let still = ratios(&format!("{PENDULUM} --ratio-at rod:0,0,0:1,0,0"));
    assert_eq!(still[0]["contact_per_wheel"], Value::Null);
    let arm = "models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --set elbow=70deg";
    assert_eq!(ratios(&format!("{arm} --ratio-at tool:0,0,0"))[0]["one_travel"], false);
    assert_eq!(ratios(arm), Value::Array(vec![]), "no wheel");
    // Both wheels of an axle move independently: no ratio is determined by the contact.
    assert_eq!(ratios(AXLE), Value::Array(vec![]));
    refused(&format!("mass {PENDULUM} --ratio-at rid:0,0,0"), &["--ratio-at", "\"rid\""]);
    refused(&format!("mass {PENDULUM} --ratio-at rod:0,0,0:0,0,0"), &["--ratio-at", "no length"]);
    refused(&format!("mass {PENDULUM} --ratio-at rod"), &["--ratio-at", "LINK:X,Y,Z"]);
    let text = percuss(&format!("mass {}", sheet("double-wishbone"))).stdout;
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("motion ratio 0.4957 (contact per wheel travel): 33.86 kg / 0.4957²"), "{text}");
}
