//! Extremes over ranges of joints: command `extremes`.

use crate::support::{Scratch, json, percuss, root};
use serde_json::Value;

/// Rounding of a few operations.
const ROUNDING: f64 = 1e-12;

#[test]
fn extremes_of_an_arm() {
    let command = "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --normal-frame world \
                   --range shoulder=-180deg:180deg --range elbow=20deg:160deg";
    let report = json(&format!("{command} --format json"));
    for key in ["least", "most"] {
        let found = &report[key];
        // The mass at the positions of the extreme, by percuss mass.
        let position = |i: usize| found["positions"][i]["position"].as_f64().expect("a position");
        let mass = json(&format!(
            "mass models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --normal-frame world --set shoulder={} \
             --set elbow={} --format json",
            position(0),
            position(1)
        ));
        let (a, b) = (found["effective_mass"].as_f64().expect("a mass"), mass["effective_mass"].as_f64());
        assert!((a / b.expect("a mass") - 1.0).abs() < 1e-9, "{key}: {found}");
        // The search compares masses: positions are accurate to the square root of rounding, times the curvature.
        assert!(found["residual"].as_f64().expect("a residual") < 1e-5, "{found}");
        assert!(found["agreeing"].as_u64().expect("a number") > 1, "{found}");
    }
    // Over all normals of the plane the smallest mass is smaller and the largest larger.
    let plane = json(&format!("{command} --normals across:0,0,1 --format json"));
    let mass = |report: &Value, key: &str| report[key]["effective_mass"].as_f64().expect("a mass");
    let ratio = |key: &str| mass(&plane, key) / mass(&report, key);
    assert!(ratio("least") <= 1.0 + ROUNDING && ratio("most") >= 1.0 - ROUNDING);
    assert!(plane["most"]["normal_world"][2].as_f64().expect("a number").abs() < ROUNDING);
    assert!(report["most"]["normal_world"].is_null());
    let text = percuss(&format!("{command} --normals across:0,0,1")).stdout;
    assert!(text.contains("up to its sign"), "{text}");
    let wrong = percuss(&format!("{command} --normals across:0,0"));
    assert!(wrong.code == 2 && wrong.stderr.contains("across:X,Y,Z"), "{}", wrong.stderr);
    let text = percuss(command).stdout;
    assert!(text.contains("starts agree") && text.contains("no proof"), "{text}");
    for (more, words) in [
        ("--range nope=0:1", "--range"),
        ("--range elbow=1:0", "--range"),
        ("--range elbow=0:1m", "--range"),
        ("--range elbow", "--range"),
    ] {
        let arm = "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0";
        let outcome = percuss(&format!("{arm} {more}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{more}: {}", outcome.stderr);
    }
    // The message about a follower lists the joints that drive.
    let follower = percuss(
        "extremes models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --range rocker_hinge=0:0.1",
    );
    assert!(follower.code == 2 && follower.stderr.contains("expected one of"), "{}", follower.stderr);
    assert!(follower.stderr.contains("crank_hinge"), "{}", follower.stderr);
    // With a held direction of the tip the masses are those of percuss mass; held in all directions, every pose is immovable.
    let arm = "--link outer --point 0.4,0,0 --normal 1,0,0 --hold outer:0.4,0,0";
    let ranges = "--range elbow=0.8:1.2 --range shoulder=-0.3:0.1 --format json";
    let held = json(&format!("extremes models/planar_2r.urdf {arm}:0,1,0 {ranges}"));
    for key in ["least", "most"] {
        let at = |i: usize| held[key]["positions"][i]["position"].as_f64().expect("a position");
        let there = format!("--set elbow={} --set shoulder={}", at(0), at(1));
        let mass = json(&format!("mass models/planar_2r.urdf {arm}:0,1,0 {there} --format json"));
        let exact = mass["effective_mass"].as_f64().expect("a mass");
        assert!((held[key]["effective_mass"].as_f64().expect("a mass") / exact - 1.0).abs() < 1e-9, "{held}");
        // A scan of the ranges finds nothing beyond.
        for (elbow, shoulder) in [(0.8, -0.3), (0.8, 0.1), (1.2, -0.3), (1.2, 0.1), (1.0, -0.1)] {
            let there = format!("--set elbow={elbow} --set shoulder={shoulder}");
            let mass = json(&format!("mass models/planar_2r.urdf {arm}:0,1,0 {there} --format json"));
            let other = mass["effective_mass"].as_f64().expect("a mass");
            let is_beyond =
                if key == "least" { other < exact * (1.0 - 1e-9) } else { other > exact * (1.0 + 1e-9) };
            assert!(!is_beyond, "{key}: {exact}, {other} at {there}");
        }
    }
    let fixed = json(&format!("extremes models/planar_2r.urdf {arm} {ranges}"));
    assert_eq!(
        (&fixed["least"]["status"], &fixed["most"]["status"]),
        (&"immovable".into(), &"immovable".into())
    );
    // Without limits and ranges nothing varies.
    let refused = percuss(
        "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --against-mass 2",
    );
    assert!(refused.code == 2 && refused.stderr.contains("--against-mass"), "{}", refused.stderr);
    let outcome = percuss("extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0");
    assert!(outcome.code == 2 && outcome.stderr.contains("no joint varies"), "{}", outcome.stderr);
}

/// The extremes of an inertia and of a bearing impulse agree with impacts at the reported positions.
#[test]
fn extremes_of_other_quantities() {
    let contact = "models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0";
    let range = "--range elbow=20deg:160deg --format json";
    for (quantity, unit) in
        [("held:shoulder", "kg·m²"), ("reflected:shoulder", "kg·m²"), ("bearing:elbow", "kg")]
    {
        let report = json(&format!("extremes {contact} {range} --quantity {quantity}"));
        assert_eq!(report["unit"], unit);
        assert!(report["least"]["effective_mass"].is_null());
        for end in ["least", "most"] {
            let value = report[end]["value"].as_f64().expect("a value");
            let elbow = report[end]["positions"][0]["position"].as_f64().expect("a position");
            let impact = json(&format!(
                "impact {contact} --set elbow={elbow} --restitution 0 --speed 1 --reflected shoulder --format json"
            ));
            let expected = match quantity {
                "held:shoulder" => impact["reflected_inertia"][0]["held"].as_f64(),
                "reflected:shoulder" => impact["reflected_inertia"][0]["free"].as_f64(),
                _ => {
                    let reactions = impact["reactions"].as_array().expect("reactions");
                    let elbow = reactions.iter().find(|r| r["name"] == "elbow").expect("the elbow");
                    let force = elbow["force"].as_array().expect("a force");
                    Some(force.iter().filter_map(|x| x.as_f64()).map(|x| x * x).sum::<f64>().sqrt())
                }
            };
            let expected = expected.expect("a number");
            assert!(
                (value - expected).abs() < 1e-6 * (1.0 + expected),
                "{quantity} {end}: {value} {expected}"
            );
        }
    }
    for (more, words) in [
        ("--quantity held:nothing", "--quantity"),
        ("--quantity weight", "bearing:JOINT"),
        ("--quantity held:shoulder --normals any", "does not depend on the contact"),
        ("--quantity peak:shoulder", "stiffness"),
        ("--quantity peak:shoulder --stiffness 1e5", "speed"),
        ("--stiffness 1e5 --restitution 0.2 --speed 1", "peak:JOINT"),
        ("--quantity peak:shoulder --stiffness 1e5 --restitution 0.2 --speed 1rad/s", "m/s"),
        ("--quantity bearing:nothing", "nothing"),
    ] {
        let outcome = percuss(&format!("extremes {contact} --range elbow=20deg:160deg {more}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{more}: {}", outcome.stderr);
    }
}

/// Peak force in a joint, a closure and the ground: at the reported positions, the command `impact` gives the same peak force, and all
/// impacts over the range have peak forces between the two extremes.
#[test]
fn extremes_of_peak_forces_are_those_of_impacts() {
    let contact =
        "models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 1,0,0 --normal-frame world";
    let law = "--stiffness 2e5 --restitution 0.3 --speed 2";
    let norm = |values: &Value| {
        let values = values.as_array().expect("a force").iter().filter_map(Value::as_f64);
        values.map(|x| x * x).sum::<f64>().sqrt()
    };
    let peak_at = |crank: f64, bearing: &str| {
        let impact = json(&format!("impact {contact} --set crank_hinge={crank} {law} --format json"));
        let reactions = impact["reactions"].as_array().expect("reactions");
        let place = if bearing == "ground" { "place" } else { "name" };
        norm(&reactions.iter().find(|r| r[place] == bearing).expect("the bearing")["peak_force"])
    };
    for bearing in ["rocker_hinge", "rocker_pin", "ground"] {
        let report = json(&format!(
            "extremes {contact} --range crank_hinge=0.2:0.9 --quantity peak:{bearing} {law} --format json"
        ));
        assert_eq!((&report["unit"], &report["quantity"]), (&"N".into(), &"bearing_peak_force".into()));
        let [least, most] = ["least", "most"].map(|end| {
            let value = report[end]["value"].as_f64().expect("a value");
            let crank = report[end]["positions"][0]["position"].as_f64().expect("a position");
            let there = peak_at(crank, bearing);
            assert!((there / value - 1.0).abs() < 1e-9, "{bearing} {end}: {value} {there}");
            value
        });
        for k in 0..=14 {
            let peak = peak_at(0.2 + 0.05 * f64::from(k), bearing);
            assert!(peak > least * (1.0 - 1e-9) && peak < most * (1.0 + 1e-9), "{bearing} {k}: {peak}");
        }
    }
    let text =
        percuss(&format!("extremes {contact} --range crank_hinge=0.2:0.9 --quantity peak:rocker_pin {law}"));
    assert!(text.stdout.contains("N (peak force in rocker_pin)"), "{}", text.stdout);
    // Centres of percussion of the closure and of the ground: an impact at the reported point has the reported remaining impulse.
    for bearing in ["rocker_pin", "ground"] {
        let flags = format!(
            "impact {contact} --set crank_hinge=0.5 --restitution 0 --speed 1 --percussion {bearing}"
        );
        let found = json(&format!("{flags} --format json"))["percussion"][0].clone();
        let point: Vec<String> =
            found["point_link"].as_array().expect("a point").iter().map(Value::to_string).collect();
        let moved = flags.replace("--point 0.35,0.1,0", &format!("--point {}", point.join(",")));
        let there = json(&format!("{moved} --format json"))["percussion"][0].clone();
        let [remaining, given] =
            [&found["remaining_ratio"], &there["given_ratio"]].map(|x| x.as_f64().expect("a ratio"));
        assert!((remaining - given).abs() < 1e-9, "{bearing}: {found} {there}");
    }
}

/// Only the joints with a range vary; the others are listed. A given position excludes a joint from the default ranges and contradicts a
/// range.
#[test]
fn extremes_list_the_held_joints() {
    let arm = "extremes models/six_r_arm.urdf --link tool --point 0,0,0 --normal 0,0,1 --starts 2";
    let one = json(&format!("{arm} --range shoulder=-1:1 --set elbow=0.5 --format json"));
    assert_eq!(one["ranges"].as_array().expect("ranges").len(), 1);
    let held = one["held"].as_array().expect("held joints");
    assert!(held.len() == 5 && held.contains(&serde_json::json!(["elbow", [0.5]])), "{held:?}");
    assert!(one["diagnostics"].as_array().expect("findings").is_empty());
    let all = json(&format!("{arm} --set elbow=0.5 --format json"));
    assert_eq!(all["ranges"].as_array().expect("ranges").len(), 5);
    assert_eq!(all["held"], serde_json::json!([["elbow", [0.5]]]));
    let text = percuss(&format!("{arm} --range shoulder=-1:1 --set elbow=0.5")).stdout;
    assert!(text.contains("held") && text.contains("elbow at 0.5"), "{text}");
    let both = percuss(&format!("{arm} --range elbow=-1:1 --set elbow=0.5"));
    assert!(both.code == 2 && both.stderr.contains("has a range and a given position"), "{}", both.stderr);
    let outside = percuss(&format!("{arm} --range shoulder=-10:10"));
    assert!(outside.code == 0 && outside.stderr.contains("leaves the limits −2 to 2"), "{}", outside.stderr);
}

/// Gap of a bump stop at the extremes: open at the drawn position of the arm, and the same as that of the table of contacts there.
#[test]
fn an_open_stop_is_marked() {
    let sheet = "extremes models/suspensions/double-wishbone.toml --at bump_stop --starts 2";
    let open = percuss(&format!("{sheet} --range upper_arm_hinge=-0.02:0.02"));
    assert!(
        open.code == 0 && open.stdout.matches("the stop is open").count() == 2,
        "{}{}",
        open.stdout,
        open.stderr
    );
    let report = json(&format!("{sheet} --range upper_arm_hinge=-0.02:0.02 --format json"));
    assert!(report["least"]["gap"].as_f64().expect("a gap") > 0.0, "{}", report["least"]);
    let plain = json(
        "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --range elbow=0.4:1 --format json",
    );
    assert!(plain["least"]["gap"].is_null());
}

/// A kept tool point: at the extremes the point is where `--set` puts it, and the masses equal those of `percuss mass`.
#[test]
fn a_kept_point_stays_in_place() {
    let set = "--set shoulder=-40deg --set elbow=70deg";
    let contact = "models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --normal-frame world";
    let place = json(&format!("mass {contact} {set} --format json"));
    let own = place["effective_mass"].as_f64().expect("a mass");
    for keep in ["tool:0.08,0,0", "tool:0.08,0,0:0,0,1"] {
        let report = json(&format!("extremes {contact} {set} --keep {keep} --starts 4 --format json"));
        assert_eq!(report["ranges"].as_array().expect("ranges").len(), 6);
        assert_eq!(report["kept"][0]["link"], "tool");
        for key in ["least", "most"] {
            let found = &report[key];
            assert!(found["kept_error"].as_f64().expect("an error") < 1e-9, "{found}");
            let at: Vec<String> = found["positions"]
                .as_array()
                .expect("positions")
                .iter()
                .map(|p| format!("--set {}={}", p["joint"].as_str().expect("a name"), p["position"]))
                .collect();
            let mass = json(&format!("mass {contact} {} --format json", at.join(" ")));
            let (a, b) = (found["effective_mass"].as_f64(), mass["effective_mass"].as_f64());
            let (a, b) = (a.expect("a mass"), b.expect("a mass"));
            assert!((a / b - 1.0).abs() < 1e-9, "{key}: {a} {b}");
            assert!(if key == "least" { a <= own } else { a >= own }, "{key}: {a} {own}");
            let axes = if keep.ends_with(":0,0,1") { vec![2] } else { vec![0, 1, 2] };
            for k in axes {
                let coordinate =
                    |report: &Value| report["contact"]["point_world"][k].as_f64().expect("a number");
                assert!((coordinate(&mass) - coordinate(&place)).abs() < 1e-9, "{key} {k}");
            }
        }
    }
    let text = percuss(&format!("extremes {contact} {set} --keep tool:0.08,0,0 --starts 2")).stdout;
    assert!(text.contains("optimality residual") && text.contains("tool: point (0.08, 0, 0) m"), "{text}");
    // With a kept link, an arm with six hinges has no self-motion, except at a singular wrist (pitch 0).
    let none = percuss(&format!("extremes {contact} {set} --set wrist_pitch=30deg --keep tool"));
    assert!(none.code == 2 && none.stderr.contains("the kept points leave"), "{}", none.stderr);
    for (keep, words) in
        [("tool:1,2", "--keep"), ("nope:0,0,0", "nope"), ("tool:0,0,0:0,0,0", "no direction")]
    {
        let outcome = percuss(&format!("extremes {contact} --keep {keep}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{keep}: {}", outcome.stderr);
    }
}

/// Paths of a travel and of the range of a joint: the extremes are at least as extreme as all rows of a fine sweep, and differ from its
/// best row by less than 1e-4.
#[test]
fn extremes_along_a_path() {
    let sheet = "models/suspensions/double-wishbone.toml --at spring";
    let paths = [
        ("--wheel-travel=-70mm:70mm:9", "--wheel-travel=-70mm:70mm:281"),
        ("--path wheel-travel=-70mm:70mm:9", "--wheel-travel=-70mm:70mm:281"),
        ("--path lower_arm_hinge=-8deg:8deg:3", "--vary lower_arm_hinge=-8deg:8deg:321"),
    ];
    for (path, rows) in paths {
        let report = json(&format!("extremes {sheet} {path} --format json"));
        assert!(report["ranges"].as_array().expect("a list").is_empty() && report["path"]["unreached"] == 0);
        let sweep = percuss(&format!("sweep {sheet} {rows}")).stdout;
        let masses: Vec<f64> =
            sweep.lines().skip(1).filter_map(|line| line.split(',').nth(3)?.parse().ok()).collect();
        assert!(masses.len() > 200, "{sweep}");
        let of = |key: &str| report[key]["effective_mass"].as_f64().expect("a mass");
        let least = masses.iter().copied().fold(f64::INFINITY, f64::min);
        let most = masses.iter().copied().fold(0.0, f64::max);
        assert!(of("least") <= least * (1.0 + 1e-9) && of("least") > least * (1.0 - 1e-4), "{path} {least}");
        assert!(of("most") >= most * (1.0 - 1e-9) && of("most") < most * (1.0 + 1e-4), "{path} {most}");
        assert!(report["most"]["row"].as_f64().expect("a row") <= 8.0);
    }
    let text = percuss(&format!("extremes {sheet} --wheel-travel=-70mm:70mm:9")).stdout;
    assert!(text.contains("place") && text.contains("path                 9 rows of"), "{text}");
    for (more, words) in [
        ("--path heave=-1mm:1mm:3 --range lower_arm_hinge=0:0.1", "--range"),
        ("--path nothing.txt", "nothing.txt"),
        ("--path missing.csv", "missing.csv"),
        ("--path lower_arm_hinge=0:0.1:3 --wheel-travel=-1mm:1mm:3", "one path"),
        ("--ignore time", "--path"),
    ] {
        let outcome = percuss(&format!("extremes {sheet} {more}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{more}: {}", outcome.stderr);
    }
}

/// `--at` accepts the texts of `--also`: point with normal, cable, stop of a joint. Commands: mass, impact, sweep, extremes.
#[test]
fn every_command_takes_a_contact_in_one_text() {
    let mass = |command: &str| json(&format!("mass {command} --format json"));
    let value = |report: &Value| report["effective_mass"].as_f64().expect("a mass");
    let arm = "models/planar_2r.urdf";
    let point = mass(&format!("{arm} --at outer:0.4,0,0:0,1,0 --set elbow=0.7"));
    let given = "--link outer --point 0.4,0,0 --normal 0,1,0 --normal-frame world --set elbow=0.7";
    assert_eq!(value(&point), value(&mass(&format!("{arm} {given}"))));
    let cable = mass(&format!("{arm} --at outer:0.4,0,0=ground:0,1,0 --set elbow=0.7"));
    let given = "--link outer --point 0.4,0,0 --along-line ground:0,1,0 --cable --set elbow=0.7";
    assert_eq!(value(&cable), value(&mass(&format!("{arm} {given}"))));
    // The stop of a hinge: the inertia of the damper of this stop, in all commands.
    let robot = "models/six_r_arm.urdf";
    let stop = mass(&format!("{robot} --at elbow:upper"));
    let damper = json(&format!(
        "damp --mass-from {robot} --limit elbow:upper --restitution 0.3 --stiffness 500 --format json"
    ));
    assert_eq!(stop["effective_mass"], damper["effective_mass"]);
    assert_eq!(stop["joint_stop"], serde_json::json!({"joint": "elbow", "motion": "turn"}));
    assert_eq!((&stop["unit"], &stop["contact"]["is_moment"]), (&"kg·m²".into(), &true.into()));
    assert!(!stop["diagnostics"].to_string().contains("far-point"));
    let limit = stop["pose"]["elbow"][0].as_f64().expect("a position");
    assert_eq!(limit, 2.6);
    let text = percuss(&format!("mass {robot} --at elbow:upper")).stdout;
    assert!(text.contains("kg·m²") && text.contains("at the stop of elbow"), "{text}");
    let impact = json(&format!("impact {robot} --at elbow:upper --restitution 0.2 --speed 2 --format json"));
    assert!(impact["sticking_mass"].is_null() && impact["mass_states"] == serde_json::json!([]), "{impact}");
    let expected = 1.2 * 2.0 * value(&stop);
    assert!((impact["impulse"].as_f64().expect("an impulse") / expected - 1.0).abs() < 1e-12);
    // The jump of the rate of the joint is (1+e) times its speed.
    let rates = impact["rates"].as_array().expect("rates");
    let elbow = rates.iter().find(|rate| rate["joint"] == "elbow").expect("the elbow");
    let jump = elbow["after"][0].as_f64().expect("a rate") - elbow["before"][0].as_f64().expect("a rate");
    assert!((jump + 1.2 * 2.0).abs() < 1e-12, "{elbow}");
    let text = percuss(&format!("impact {robot} --at elbow:upper --restitution 0.2 --speed 2")).stdout;
    assert!(text.contains("N·m·s") && text.contains("rad/s, restitution 0.2"), "{text}");
    assert!(!text.contains(" kg\n") && !text.contains(" N·s\n"), "{text}");
    let rows = percuss(&format!("sweep {robot} --at elbow:upper --vary wrist_pitch=0:1:3")).stdout;
    assert_eq!(rows.lines().count(), 4, "{rows}");
    let extremes = json(&format!("extremes {robot} --at elbow:upper --range wrist_pitch=0:1 --format json"));
    assert!(extremes["least"]["effective_mass"].as_f64().expect("a mass") > 0.0);
    assert_eq!(extremes["unit"], "kg·m²");
    for (command, words) in [
        ("mass models/six_r_arm.urdf --at nope:upper", "nope"),
        ("mass models/six_r_arm.urdf --at tool:0,0,0", "--at"),
        ("mass models/planar_2r.urdf --at elbow:upper", "has no <limit>"),
        ("mass models/six_r_arm.urdf --at elbow:upper --against-mass 2", "--against-mass"),
        (
            "impact models/six_r_arm.urdf --at elbow:upper --restitution 0 --speed 1 --friction 0.2",
            "--friction",
        ),
        (
            "impact models/six_r_arm.urdf --at elbow:upper --restitution 0 --speed 1 --sticking",
            "stop of a joint",
        ),
    ] {
        let outcome = percuss(command);
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{command}: {}", outcome.stderr);
    }
}

/// The table `[extremes]` of a study gives the output of the command; the file of a path is relative to the study.
#[test]
fn a_study_searches_for_extremes() {
    let folder = Scratch::new("extremes-study");
    let model = root().join("models/planar_2r.urdf");
    let file = folder.write("path.csv", "shoulder,elbow,time\n0,0.4,0\n0.3,1.2,1\n-0.2,2.0,2\n");
    let contact = "--link outer --point 0.4,0,0 --normal 0,1,0";
    for (table, flags) in [
        ("range = [\"elbow=0.4:2\"]\nstarts = 4\n".to_owned(), "--range elbow=0.4:2 --starts 4".to_owned()),
        ("path = \"path.csv\"\nignore = \"time\"\n".to_owned(), format!("--path {file} --ignore time")),
    ] {
        let study = folder.write(
            "study.toml",
            &format!(
                "[model]\npath = {:?}\n[contact]\nlink = \"outer\"\npoint = [0.4, 0, 0]\nnormal = [0, 1, 0]\n[extremes]\n{table}",
                model.to_string_lossy()
            ),
        );
        let of_study = percuss(&format!("run {study}"));
        let of_command = percuss(&format!("extremes models/planar_2r.urdf {contact} {flags}"));
        assert_eq!((of_study.code, of_command.code), (0, 0), "{}{}", of_study.stderr, of_command.stderr);
        assert!(of_study.stdout.ends_with(&of_command.stdout), "{}", of_study.stdout);
    }
    let study = folder.write(
        "study.toml",
        "[model]\npath = \"x.urdf\"\n[extremes]\npath = \"path.csv\"\nrange = [\"elbow=0:1\"]\n",
    );
    assert_eq!(percuss(&format!("run {study}")).code, 2);
}
