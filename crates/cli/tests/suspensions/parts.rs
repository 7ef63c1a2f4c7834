//! Rocker by its pivot, half shaft, travel of the rack per turn, rear linkages of bicycles and motorcycles; torsion bars and anti-roll bars: closed
//! forms of a trailing arm, derivatives of the force at the wheel, impacts in time.

use crate::support::{Random, Scratch, done, run_in as run};
use serde_json::Value;

/// Effective masses at all contacts of a sheet.
fn masses(folder: &Scratch, text: &str) -> Vec<f64> {
    folder.write("car.toml", text);
    let report = done(folder, &["mass", "car.toml", "--at", "all", "--format", "json"]);
    let report: Value = serde_json::from_str(&report).expect("JSON");
    let contacts = report["contacts"].as_array().expect("contacts");
    contacts.iter().map(|contact| contact["report"]["effective_mass"].as_f64().expect("a mass")).collect()
}

/// First row of the kinematics of a sheet.
fn row(folder: &Scratch, more: &[&str]) -> Value {
    let report = done(folder, &[&["kinematics", "car.toml", "--format", "json"], more].concat());
    let report: Value = serde_json::from_str(&report).expect("JSON");
    report["rows"][0].clone()
}

fn number(row: &Value, name: &str) -> f64 {
    row[name].as_f64().unwrap_or_else(|| panic!("{name} in {row}"))
}

fn assert_same(found: &[f64], expected: &[f64], what: &str) {
    assert!(found.len() == expected.len() && !found.is_empty(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        // Two sheets of one mechanism differ by roundings, which closing amplifies.
        assert!((found / expected - 1.0).abs() < 1e-10, "{what}: {found} {expected}");
    }
}

/// The pivot with a direction, and the pivot with the plane of the points of the rocker, give the axis through two points.
#[test]
fn a_rocker_may_be_given_by_its_pivot() {
    let folder = Scratch::new("rocker-pivot");
    let text = done(&folder, &["template", "pushrod-rocker"]);
    let line = |key: &str| {
        text.lines().find(|line| line.starts_with(&format!("{key} = ["))).expect("a point").to_owned()
    };
    let (front, back) = (line("rocker_front"), line("rocker_back"));
    let without = |text: &str| {
        text.replace(&format!("{front}\n"), "rocker_pivot = [30.0, 265.0, 450.0]\n")
            .replace(&format!("{back}\n"), "")
    };
    let by_axis = without(&text).replace("[rocker]\n", "[rocker]\naxis = [60, 0, -2]\n");
    assert_same(&masses(&folder, &by_axis), &masses(&folder, &text), "axis");
    // Pivot, pushrod (−5, 300, 480) and damper (0, 235, 505): arms (−35, 35, 30) and (−30, −30, 55); their product is normal to both.
    let [a, b] = [[-35.0, 35.0, 30.0], [-30.0, -30.0, 55.0f64]];
    let normal = [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
    let second = [0, 1, 2].map(|k| [30.0, 265.0, 450.0][k] + normal[k] / 100.0);
    let of_plane = text.replace(&back, &format!("rocker_back = {second:?}"));
    assert_same(&masses(&folder, &without(&text)), &masses(&folder, &of_plane), "plane");
    // The right side, in other axes.
    let right = done(&folder, &["template", "pushrod-rocker", "--axes", "adams"]);
    let pivot =
        right.replace("rocker_front = [-30.0, -265.0, 450.0]", "rocker_pivot = [-30.0, -265.0, 450.0]");
    let pivot: String = pivot
        .lines()
        .filter(|line| !line.starts_with("rocker_back"))
        .map(|line| format!("{line}\n"))
        .collect();
    assert!(pivot.contains("rocker_pivot"), "{right}");
    assert_same(
        &masses(&folder, &pivot.replace("[rocker]\n", "[rocker]\naxis = [-60, 0, -2]\n")),
        &masses(&folder, &right),
        "adams",
    );
    for (changed, words) in [
        (text.replace("[rocker]\n", "[rocker]\naxis = [1, 0, 0]\n"), "rocker.axis"),
        (
            by_axis.replace("rocker_pivot = ", "rocker_back = [0, 265, 450]\nrocker_pivot = "),
            "both points of the axis",
        ),
        (by_axis.replace("axis = [60, 0, -2]", "axis = [0, 0, 0]"), "rocker.axis"),
    ] {
        folder.write("car.toml", &changed);
        let outcome = run(&folder, &["check", "car.toml"]);
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && told.contains(words), "{words}: {told}");
    }
}

/// Half of the mass of the half shaft is a point mass on the spindle: at the wheel centre that of a heavier wheel, at another point that of a
/// spindle with this mass.
#[test]
fn half_of_a_half_shaft_moves_with_the_wheel() {
    let folder = Scratch::new("half-shaft");
    for template in ["double-wishbone", "semi-trailing-arm", "solid-axle-de-dion"] {
        let text = done(&folder, &["template", template]);
        let wheel = text.replace("[wheel]\nmass = 18.5", "[wheel]\nmass = 21.5");
        assert_ne!(wheel, text);
        let shaft = |more: &str| format!("{text}\n[half_shaft]\nmass = 6\n{more}");
        assert_same(&masses(&folder, &shaft("")), &masses(&folder, &wheel), template);
    }
    // 3 kg at 100 mm inside of the wheel centre along y, and the spindle at the centre: the inertia of two points about the common centre.
    let text = done(&folder, &["template", "double-wishbone"]);
    let centre = [0.0, 760.0, 300.0];
    assert!(text.contains(&format!("wheel_centre = {centre:?}")), "{text}");
    let section = text.split("[spindle]\n").nth(1).expect("a spindle");
    let value = |key: &str| {
        section
            .lines()
            .find_map(|line| line.strip_prefix(&format!("{key} = ")))
            .expect("a key")
            .split('#')
            .next()
            .expect("a value")
            .trim()
            .to_owned()
    };
    let mass: f64 = value("mass").parse().expect("a number");
    let moments: Vec<f64> =
        value("inertia").trim_matches(['[', ']']).split(", ").map(|x| x.parse().expect("a number")).collect();
    let (total, reduced) = (mass + 3.0, mass * 3.0 / (mass + 3.0) * 0.01);
    let com = [0.0, 760.0 - 100.0 * 3.0 / total, 300.0];
    let changed = text
        .replace(
            &format!("[spindle]\nmass = {}", value("mass")),
            &format!("[spindle]\ncom = {com:?}\nmass = {total:?}"),
        )
        .replacen(
            &format!("inertia = {}", value("inertia")),
            &format!("inertia = {:?}", [moments[0] + reduced, moments[1], moments[2] + reduced]),
            1,
        );
    assert_ne!(changed, text);
    let shaft = format!("{text}\n[half_shaft]\nmass = 6\nouter = [0, 660, 300]\n");
    assert_same(&masses(&folder, &shaft), &masses(&folder, &changed), "outer");
}

/// The steering ratio is 2π per turn over the change of the steer angle per travel of the rack at a constant height of the wheel.
#[test]
fn the_steering_ratio_is_that_of_the_rack() {
    let folder = Scratch::new("steering-ratio");
    for template in ["double-wishbone", "macpherson-strut", "five-link"] {
        let text = done(&folder, &["template", template]);
        folder.write("car.toml", &text.replace("[rack]\n", "[rack]\ntravel_per_turn = 52\n"));
        let here = row(&folder, &[]);
        let [ahead, behind] = ["0.05mm", "-0.05mm"].map(|rack| row(&folder, &["--steer", rack]));
        let slope = |name: &str| (number(&ahead, name) - number(&behind, name)) / 1e-4;
        let steer = slope("toe") - number(&here, "toe_gradient") * slope("wheel_travel");
        let expected = (2.0 * std::f64::consts::PI / (0.052 * steer)).abs();
        // The error of a difference over 0.1 mm: (1e-4/0.1)²/24, the distance of the tie rod from the axis being some 0.1 m.
        assert!((number(&here, "steering_ratio") / expected - 1.0).abs() < 1e-6, "{template}: {here}");
        folder.write("car.toml", &text);
        assert!(row(&folder, &[])["steering_ratio"].is_null());
        folder.write("car.toml", &text.replace("[rack]\n", "[rack]\ntravel_per_turn = 0\n"));
        assert_eq!(run(&folder, &["kinematics", "car.toml"]).code, 2);
    }
}

/// Rear linkages in closed form: with the instantaneous centre of the four-bar, and by differences of the lengths of the shock absorber.
#[test]
fn leverage_ratios_are_those_of_the_linkage() {
    let folder = Scratch::new("leverage");
    let text = done(&folder, &["template", "rear-four-bar"]);
    folder.write("car.toml", &text);
    // The line of the lower link is z = 345; that of the rocker's arm passes (480, 640) and (350, 665).
    let centre = [480.0 + (345.0 - 640.0) * (350.0 - 480.0) / (665.0 - 640.0), 345.0f64];
    // Rates per angle of the rear triangle about this centre: the wheel's height, and the rocker's angle.
    let lift = centre[0] - 0.0;
    let rocker = (centre[0] - 350.0) / (480.0 - 350.0);
    let (dx, dz) = (556.0 - 540.0, 430.0 - 632.0f64);
    let seat = [(632.0 - 640.0), -(540.0 - 480.0)].map(|x: f64| -rocker * x);
    let closing = (seat[0] * dx + seat[1] * dz) / f64::hypot(dx, dz);
    let ratio = number(&row(&folder, &[]), "leverage_ratio_spring");
    assert!((ratio.abs() / (lift / closing).abs() - 1.0).abs() < 1e-12, "{ratio} {}", lift / closing);
    for template in ["rear-four-bar", "rear-rocker-on-frame", "rear-rocker-on-arm"] {
        let text = done(&folder, &["template", template]);
        let sprung = text.replace("[spring]\n", "[spring]\nrate = \"50 N/mm\"\npreload = 1000\n");
        folder.write("car.toml", &sprung);
        for travel in [-40.0, 0.0, 35.0f64] {
            let at = |by: f64| row(&folder, &["--wheel-travel", &format!("{}mm", travel + by)]);
            let here = at(0.0);
            let force = |by: f64| number(&at(by), "force_spring");
            // A force of 50 N/mm is the compression; a difference of fourth order over 0.5 mm.
            let slope =
                (force(-0.5) - 8.0 * force(-0.25) + 8.0 * force(0.25) - force(0.5)) / (3.0 * 1e-3) / 50e3;
            let ratio = number(&here, "leverage_ratio_spring");
            assert!((ratio * slope - 1.0).abs() < 1e-8, "{template} {travel}: {ratio} {slope}");
            assert!((ratio * number(&here, "motion_ratio_spring") - 1.0).abs() < 1e-14, "{template}");
        }
    }
}

fn report(folder: &Scratch, words: &[&str]) -> Value {
    serde_json::from_str(&done(folder, &[words, &["--format", "json"]].concat())).expect("JSON")
}

fn rows(folder: &Scratch, more: &[&str]) -> Vec<Value> {
    let report = report(folder, &[&["kinematics", "car.toml"], more].concat());
    report["rows"].as_array().expect("rows").clone()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

/// Sheet of a semi-trailing arm with these points (mm) and no spring, and the section of a torsion bar.
fn trailing_arm(folder: &Scratch, [outer, inner, wheel]: [[f64; 3]; 3], bar: &str) -> String {
    let text = done(folder, &["template", "semi-trailing-arm"]);
    let is_kept = |line: &&str| {
        !["spring_", "damper_", "arm_", "wheel_centre", "anti_roll", "drop_link", "bump_", "rebound_"]
            .iter()
            .any(|key| line.starts_with(key))
    };
    let head = text.split("\n[anti_roll_bar]\n").next().expect("a head");
    let kept: String = head.lines().filter(is_kept).map(|line| format!("{line}\n")).collect();
    let points =
        format!("[points]\narm_outer = {outer:?}\narm_inner = {inner:?}\nwheel_centre = {wheel:?}\n");
    let wheel = "[wheel]\nmass = 18.5\ninertia = [0.62, 1.05, 0.62]\nradius = 300\n";
    let (head, bodies) = kept.split_once("\n[points]\n").expect("points");
    format!("{head}\n{points}{bodies}{wheel}{bar}")
}

/// The motion ratio, the moment and the wheel rate of a bar on a trailing arm are those of a wheel on a circle: with the height z(θ) of the wheel
/// centre and the moment T = T₀ + k (θ − θ₀), they are 1/z′, T and k/z′² − T z″/z′³.
#[test]
fn bars_on_trailing_arms_have_closed_forms() {
    let folder = Scratch::new("torsion-arms");
    let mut random = Random(5);
    for case in 0..12 {
        let mut by = |most: f64| most * random.next();
        let outer = [380.0 + by(40.0), 620.0 + by(30.0), 330.0 + by(30.0)];
        let inner = [300.0 + by(60.0), 300.0 + by(30.0), 320.0 + by(30.0)];
        let wheel = [by(20.0), 740.0 + by(20.0), 300.0 + by(5.0)];
        let (rate, preload) = (40.0 + by(20.0), 800.0 + by(300.0));
        // The points of the left side, or of the right side in the axes of Adams/Car.
        let is_right = case % 3 == 1;
        let bar = format!("[torsion_bar]\nrate = \"{rate} N·m/deg\"\npreload = {preload:?}\n");
        let of_file = |p: [f64; 3]| if is_right { [-p[0], p[1], p[2]] } else { p };
        let mut text = trailing_arm(&folder, [outer, inner, wheel].map(of_file), &bar);
        if is_right {
            text = text
                .replace("axes = \"iso\"", "axes = \"adams\"")
                .replace("side = \"left\"", "side = \"right\"");
            text = text.replace("build = \"left\"", "build = \"right\"");
            let com = text.lines().find(|line| line.starts_with("com = [")).expect("a centre of mass");
            text = text.replace(com, "com = [-180.0, 600.0, 310.0]");
        }
        folder.write("car.toml", &text);
        let metres = |p: [f64; 3]| p.map(|x| x / 1e3);
        let (outer, inner, wheel) = (metres(outer), metres(inner), metres(wheel));
        let axis = [0, 1, 2].map(|k| inner[k] - outer[k]);
        let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        let axis = axis.map(|x| x / length);
        let arm = [0, 1, 2].map(|k| wheel[k] - outer[k]);
        let (first, along) = (cross(axis, arm), (0..3).map(|k| axis[k] * arm[k]).sum::<f64>());
        let across = [0, 1, 2].map(|k| arm[k] - along * axis[k]);
        // z(θ) = z₀ + a sin θ + b cos θ; θ is positive in bump.
        let sign = first[2].signum();
        let (a, b) = (sign * first[2], across[2]);
        let k = rate.to_degrees();
        for (row, travel) in
            rows(&folder, &["--wheel-travel", "-60mm:60mm:5"]).iter().zip([-0.06, -0.03, 0.0, 0.03, 0.06])
        {
            let mut angle = 0.0f64;
            for _ in 0..50 {
                angle -=
                    (a * angle.sin() + b * angle.cos() - b - travel) / (a * angle.cos() - b * angle.sin());
            }
            let (slope, bend) = (a * angle.cos() - b * angle.sin(), -a * angle.sin() - b * angle.cos());
            let moment = preload + k * angle;
            let wheel_rate = k / (slope * slope) - moment * bend / slope.powi(3);
            for (name, expected) in [
                ("motion_ratio_torsion_bar", 1.0 / slope),
                ("moment_torsion_bar", moment),
                ("wheel_rate", wheel_rate),
            ] {
                let found = number(row, name);
                // The loop-free arm is at the travel to 1e-12 m, which the moment of some 40 N·m/deg amplifies.
                assert!(
                    (found - expected).abs() < 1e-8 * expected.abs().max(1.0),
                    "{case} {name}: {found} {expected}"
                );
            }
        }
    }
}

/// Springs and the bar on every template: the wheel rate is the derivative of the force at the wheel, the sum of force times motion ratio. A bar on
/// each side has mirrored values.
#[test]
fn wheel_rates_are_derivatives_of_the_force() {
    let folder = Scratch::new("torsion-rates");
    for (template, on) in [
        ("double-wishbone", "lower_arm"),
        ("double-wishbone", "upper_arm"),
        ("macpherson-strut", "lower_arm"),
        ("pushrod-rocker", "rocker"),
        ("multi-link", "upper_arm"),
        ("swing-axle", "axle_tube"),
        ("swing-arm", "swing_arm"),
        ("rear-four-bar", "rocker"),
    ] {
        let text = done(&folder, &["template", template]);
        let both = text.replace("build = \"left\"", "build = \"both\"");
        let text = if ["swing-arm", "rear-four-bar"].contains(&template) { text } else { both };
        let spring = "[spring]\nrate = \"20 N/mm\"\npreload = 1500\n";
        let bar = format!("[torsion_bar]\non = \"{on}\"\nrate = \"900 N·m/rad\"\npreload = 350\n");
        folder.write("car.toml", &(text.replace("[spring]\n", spring) + &bar));
        for travel in [-25.0, 0.0, 20.0f64] {
            let force = |row: &Value, side: &str| {
                number(row, &format!("force_spring{side}"))
                    * number(row, &format!("motion_ratio_spring{side}"))
                    + number(row, &format!("moment_torsion_bar{side}"))
                        * number(row, &format!("motion_ratio_torsion_bar{side}"))
            };
            let range = format!("{}mm:{}mm:5", travel - 0.5, travel + 0.5);
            let found = rows(&folder, &["--heave", &range]);
            for side in ["", "_left", "_right"] {
                if found[0][format!("wheel_rate{side}")].is_null() {
                    continue;
                }
                let f: Vec<f64> = found.iter().map(|row| force(row, side)).collect();
                let slope = (f[0] - 8.0 * f[1] + 8.0 * f[3] - f[4]) / (12.0 * 0.25e-3);
                let rate = number(&found[2], &format!("wheel_rate{side}"));
                // Differences of fourth order over 0.25 mm of forces of some 2 kN, exact to 1e-9.
                assert!((rate / slope - 1.0).abs() < 1e-6, "{template} {on} {travel} {side}: {rate} {slope}");
            }
        }
        // Positive in bump on every template, whatever the sense of the axis of the hinge.
        let sides = rows(&folder, &[]);
        let ratios =
            ["", "_left", "_right"].map(|side| sides[0][format!("motion_ratio_torsion_bar{side}")].as_f64());
        assert!(ratios.iter().flatten().all(|ratio| *ratio > 0.5), "{template} {ratios:?}");
    }
}

/// In an impact in time the bar is the spring of its hinge, given by a flag, with the whole moment too.
#[test]
fn bars_act_in_impacts_in_time() {
    let folder = Scratch::new("torsion-impacts");
    let text = done(&folder, &["template", "double-wishbone"]);
    folder.write("plain.toml", &text);
    let bar = |preload: &str| {
        format!("{text}\n[torsion_bar]\non = \"lower_arm\"\nrate = \"2500 N·m/rad\"\n{preload}")
    };
    let impact = |file: &str, more: &[&str]| report(&folder, &impact_in_time(file, more))["in_time"].clone();
    folder.write("car.toml", &bar(""));
    let (found, given) =
        (impact("car.toml", &[]), impact("plain.toml", &["--joint-spring", "lower_arm_hinge=2500"]));
    let peak = |record: &Value| number(record, "peak_force");
    assert!((peak(&found) / peak(&given) - 1.0).abs() < 1e-12, "{found}");
    assert!((peak(&found) / peak(&impact("plain.toml", &[])) - 1.0).abs() > 1e-4);
    // The whole moment: in bump the lower arm turns about x backward, in the negative sense of its hinge.
    let hinge = rows(&folder, &[])[0]["motion_ratio_torsion_bar"].as_f64().expect("a ratio");
    assert!(hinge > 0.0);
    let full = ["--springs", "full"];
    let outcome = run(&folder, &impact_in_time("car.toml", &full));
    assert!(outcome.code == 2 && outcome.stderr.contains("torsion_bar"), "{}", outcome.stderr);
    folder.write("car.toml", &bar("preload = \"400 N·m\"\n"));
    let found = impact("car.toml", &full);
    let at_touch = found["joint_springs"][0]["force_at_touch"].as_f64().expect("a moment");
    // At the touch the wheel is higher: the moment pushes the arm down, more than as drawn.
    let drawn = number(&rows(&folder, &[])[0], "moment_torsion_bar");
    assert!((drawn - 400.0).abs() < 1e-9 && at_touch.abs() > 400.0, "{drawn} {at_touch}");
    let free = format!("lower_arm_hinge=2500,0,{:?}rad", at_touch.signum() * 400.0 / 2500.0);
    let given = impact("plain.toml", &["--joint-spring", &free, "--springs", "full"]);
    assert!((peak(&found) / peak(&given) - 1.0).abs() < 1e-12, "{found} {given}");
}

/// Words of an impact of the bump stop in time.
fn impact_in_time<'a>(file: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let words =
        ["--at", "bump_stop", "--speed", "1", "--restitution", "0.5", "--stiffness", "3e5", "--in-time"];
    [&["impact", file], &words[..], more].concat()
}

/// The rate of an anti-roll bar: in roll 2 k (dq/ds)² with the hinge angle q of one half over the travel s of its wheel, for one side k (dq/ds)²,
/// in heave 0.
#[test]
fn anti_roll_bars_have_a_rate_at_the_wheel() {
    let folder = Scratch::new("roll-bar-rate");
    let text = done(&folder, &["template", "double-wishbone"])
        .replace("[anti_roll_bar]\n", "[anti_roll_bar]\nstiffness = \"800 N·m/rad\"\n");
    folder.write("car.toml", &text);
    let single = number(&rows(&folder, &[])[0], "anti_roll_bar_rate");
    folder.write("car.toml", &text.replace("build = \"left\"", "build = \"both\""));
    let name = "anti_roll_bar_rate_left";
    let found = rows(&folder, &["--roll", "-0.25mm:0.25mm:3"]);
    assert!((number(&found[1], name) / single - 2.0).abs() < 1e-9, "{single} {}", found[1]);
    let heave = rows(&folder, &["--heave", "0mm:20mm:2"]);
    assert!(number(&heave[1], name).abs() < 1e-9 * single, "{}", heave[1]);
    // The angle of the hinge over the travel, by differences.
    folder.write("one.toml", &text);
    let words = ["sweep", "one.toml", "--at", "contact_patch", "--wheel-travel", "-0.1mm:0.1mm:3"];
    let table = done(&folder, &words);
    let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = lines.next().expect("a header");
    let column = head.iter().position(|name| *name == "anti_roll_bar_hinge").expect("a hinge");
    let angles: Vec<f64> = lines.map(|cells| cells[column].parse().expect("an angle")).collect();
    let slope = (angles[2] - angles[0]) / 2e-4;
    // The error of a difference over 0.1 mm on an arm of 0.26 m.
    assert!((single / (800.0 * slope * slope) - 1.0).abs() < 1e-6, "{single} {slope}");
}

/// Bars that are not described completely, or are on no hinge, are refused.
#[test]
fn incomplete_bars_are_refused() {
    let folder = Scratch::new("torsion-refused");
    let text = done(&folder, &["template", "double-wishbone"]);
    for (bar, words) in [
        ("rate = \"40 N·m/deg\"", "torsion_bar.on"),
        ("on = \"upright\"\nrate = \"40 N·m/deg\"", "no link on a hinge"),
        ("on = \"lower_arm\"", "torsion_bar.rate"),
        ("on = \"lower_arm\"\nrate = 40", "torsional stiffness with its unit"),
        ("on = \"lower_arm\"\nrate = \"40 N/mm\"", "torsional stiffness with its unit"),
        ("on = \"lower_arm\"\nrate = \"-40 N·m/deg\"", "above 0"),
        ("on = \"lower_arm\"\nrate = \"40 N·m/deg\"\npreload = \"2 kN\"", "moment"),
    ] {
        folder.write("car.toml", &format!("{text}\n[torsion_bar]\n{bar}\n"));
        let outcome = run(&folder, &["check", "car.toml"]);
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && told.contains(words), "{bar}: {told}");
    }
}
