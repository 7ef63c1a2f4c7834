//! Rocker by its pivot, half shaft, travel of the rack per turn, rear linkages of bicycles and motorcycles.

use crate::support::{Scratch, done, run_in as run};
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
