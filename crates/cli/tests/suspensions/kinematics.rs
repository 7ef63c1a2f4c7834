//! `percuss kinematics`: closed forms, differences of positions, symmetry, messages.

use crate::support::{Scratch, done, run_in as run};
use serde_json::Value;
use std::fmt::Write;

/// Rows of the report of a sheet.
pub fn rows(folder: &Scratch, sheet: &str, flags: &[&str]) -> Vec<Value> {
    let words = [&["kinematics", sheet, "--format", "json"], flags].concat();
    let report: Value = serde_json::from_str(&done(folder, &words)).expect("JSON");
    report["rows"].as_array().expect("rows").clone()
}

/// Value of a column.
#[track_caller]
pub fn value(row: &Value, name: &str) -> f64 {
    row[name].as_f64().unwrap_or_else(|| panic!("{name} is {} in {row}", row[name]))
}

/// Sheet of a template with some hardpoints (mm) replaced.
fn with_points(folder: &Scratch, template: &str, points: &[(&str, [f64; 3])]) -> String {
    let mut text = String::new();
    for line in done(folder, &["template", template]).lines() {
        let key = line.split(" =").next().unwrap_or_default();
        match points.iter().find(|(name, _)| *name == key) {
            Some((_, at)) => writeln!(text, "{key} = {at:?}").expect("a string"),
            None => writeln!(text, "{line}").expect("a string"),
        }
    }
    text
}

/// Roundings of the closing of the loops (1e-15 m) and of a linear system with condition 1e4, in m and rad.
const ROUNDING: f64 = 1e-10;

#[track_caller]
pub fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance * expected.abs().max(1.0), "{what}: {found}, {expected}");
}

/// Parallel arms of equal length move the wheel without camber, toe or a change of the kingpin; the roll centre is on the
/// ground at the pose at which the arms are horizontal.
#[test]
fn parallel_equal_arms_keep_the_camber() {
    let folder = Scratch::new("kinematics-parallel");
    let arm = |name: &'static str, x: f64, z: f64| (name, [x, 400.0, z]);
    let ball = |name: &'static str, x: f64, z: f64| (name, [x, 700.0, z]);
    let points = [
        arm("lower_front", 150.0, 200.0),
        arm("lower_back", -150.0, 200.0),
        ball("lower_ball", 0.0, 200.0),
        arm("upper_front", 150.0, 400.0),
        arm("upper_back", -150.0, 400.0),
        ball("upper_ball", -20.0, 400.0),
        arm("tie_rod_inner", -100.0, 300.0),
        ball("tie_rod_outer", -100.0, 300.0),
    ];
    folder.write("car.toml", &with_points(&folder, "double-wishbone", &points));
    for row in rows(&folder, "car.toml", &["--wheel-travel", "-60mm:60mm:7"]) {
        for name in ["camber", "toe", "camber_gradient", "toe_gradient", "kingpin_inclination"] {
            close(value(&row, name), 0.0, ROUNDING, name);
        }
        let (travel, length) = (value(&row, "wheel_travel"), 0.3f64);
        let inward = (length * length - travel * travel).sqrt() - length;
        close(value(&row, "half_track_change"), inward, ROUNDING, "half track");
        close(value(&row, "caster"), (0.02f64 / 0.2).atan(), ROUNDING, "caster");
        // The path is a circle: its normal passes through the centre of the arms.
        let slope = travel / (length + inward);
        close(value(&row, "roll_centre_height"), -slope * (0.76 + inward), ROUNDING, "roll centre");
        assert!(row["instant_centre_height"].is_null(), "at infinity");
    }
}

/// All links in planes normal to x: the instant centre is the intersection of the lines of both arms.
#[test]
fn the_instant_centre_of_a_planar_linkage_is_that_of_the_lines_of_its_arms() {
    let folder = Scratch::new("kinematics-planar");
    let points = [
        ("lower_front", [150.0, 400.0, 200.0]),
        ("lower_back", [-150.0, 400.0, 200.0]),
        ("lower_ball", [0.0, 720.0, 180.0]),
        ("upper_front", [150.0, 450.0, 420.0]),
        ("upper_back", [-150.0, 450.0, 420.0]),
        ("upper_ball", [0.0, 680.0, 455.0]),
        // The tie rod is a copy of the lower arm: the wheel does not steer.
        ("tie_rod_inner", [-130.0, 400.0, 200.0]),
        ("tie_rod_outer", [-130.0, 720.0, 180.0]),
    ];
    folder.write("car.toml", &with_points(&folder, "double-wishbone", &points));
    let row = &rows(&folder, "car.toml", &[])[0];
    let (lower, upper) = (-20.0 / 320.0, 35.0 / 230.0);
    let y: f64 = (0.420 - 0.450 * upper - (0.200 - 0.400 * lower)) / (lower - upper);
    let z = 0.200 + lower * (y - 0.400);
    close(value(row, "instant_centre_distance"), 0.76 - y, ROUNDING, "distance");
    close(value(row, "instant_centre_height"), z, ROUNDING, "height");
    close(value(row, "roll_centre_height"), 0.76 * z / (0.76 - y), ROUNDING, "roll centre");
    close(value(row, "camber_gradient"), -1.0 / (0.76 - y), ROUNDING, "camber");
    close(value(row, "kingpin_inclination"), (40.0f64 / 275.0).atan(), ROUNDING, "inclination");
    close(value(row, "scrub_radius"), 0.76 - 0.72 - 0.18 * 40.0 / 275.0, ROUNDING, "scrub radius");
    close(value(row, "side_view_angle"), 0.0, ROUNDING, "side view");
}

/// A swing axle turns about its pivot.
#[test]
fn a_swing_axle_turns_about_its_pivot() {
    let folder = Scratch::new("kinematics-swing");
    folder.write("car.toml", &done(&folder, &["template", "swing-axle"]));
    let row = &rows(&folder, "car.toml", &[])[0];
    close(value(row, "camber_gradient"), -1.0 / 0.56, ROUNDING, "camber");
    close(value(row, "instant_centre_distance"), 0.56, ROUNDING, "distance");
    close(value(row, "instant_centre_height"), 0.33, ROUNDING, "height");
    close(value(row, "roll_centre_height"), 0.33 * 0.65 / 0.56, ROUNDING, "roll centre");
    assert!(row["caster"].is_null());
}

/// A solid axle does not tilt in heave, and tilts by the travel over half the track in roll.
#[test]
fn a_solid_axle_tilts_in_roll_only() {
    let folder = Scratch::new("kinematics-solid");
    folder.write("car.toml", &done(&folder, &["template", "solid-axle-four-links"]));
    let heave = &rows(&folder, "car.toml", &[])[0];
    let roll = &rows(&folder, "car.toml", &["--roll", "0:0:1"])[0];
    for side in ["left", "right"] {
        close(value(heave, &format!("camber_gradient_{side}")), 0.0, ROUNDING, "heave");
        close(value(roll, &format!("camber_gradient_{side}")), -1.0 / 0.76, ROUNDING, "roll");
        assert!(heave[&format!("instant_centre_height_{side}")].is_null());
        let (heave, roll) = (&format!("unsprung_mass_{side}"), (value(heave, "unsprung_mass_left"), roll));
        assert!(value(roll.1, heave) < roll.0, "less inertia in roll than half of the mass");
    }
    close(value(heave, "roll_centre_lateral"), 0.0, ROUNDING, "middle");
}

/// Gradients, motion ratios and wheel rates are the derivatives of camber, toe, compression and wheel force: differences of
/// fourth order over positions, for every template.
#[test]
fn derivatives_are_those_of_the_positions() {
    let folder = Scratch::new("kinematics-differences");
    let listed = done(&folder, &["template", "--list"]);
    let names =
        listed.lines().filter(|line| !line.starts_with(' ')).filter_map(|l| l.split_whitespace().next());
    for template in names {
        let text = done(&folder, &["template", template]);
        let text = text.replacen("[spring]\n", "[spring]\nrate = \"30 N/mm\"\npreload = 2500\n", 1);
        let curve = "[bump_stop]\ndeflections = [0, 100]\nforces = [0, 30000]\n";
        let text = text.replacen("[bump_stop]\n", curve, 1);
        folder.write("car.toml", &text);
        let motions: &[&str] =
            if text.contains("build = \"both\"") { &["--heave", "--roll"] } else { &["--heave"] };
        for motion in motions {
            let side = if text.contains("build = \"both\"") { "_left" } else { "" };
            // Five rows at a distance h = 0.25 mm: the error of fourth order is h⁴ f⁽⁵⁾/30, below 1e-7 of the value for levers
            // of 40 mm; travels are met to 1e-12 m, 1e-8 of h.
            let rows = rows(&folder, "car.toml", &[motion, "11.5mm:12.5mm:5"]);
            let column = |name: &str| -> Vec<f64> {
                rows.iter().map(|row| value(row, &format!("{name}{side}"))).collect()
            };
            let slope = |y: &[f64]| (y[0] - 8.0 * y[1] + 8.0 * y[3] - y[4]) / (12.0 * 0.00025);
            for name in ["camber", "toe"] {
                let expected = slope(&column(name));
                close(
                    column(&format!("{name}_gradient"))[2],
                    expected,
                    1e-6,
                    &format!("{template} {motion} {name}"),
                );
            }
            let [force, ratio] = ["force_spring", "motion_ratio_spring"].map(column);
            close(ratio[2], slope(&force) / 30e3, 1e-6, &format!("{template} {motion} ratio"));
            // The stop does not touch here; the springs of an axle count half for each wheel, and both sides are alike.
            let product: Vec<f64> = force.iter().zip(&ratio).map(|(f, i)| f * i).collect();
            let rate = column("wheel_rate")[2];
            let single = slope(&product);
            if side.is_empty() {
                close(rate, single, 1e-6, &format!("{template} {motion} rate"));
            } else {
                assert!((rate / single - 1.0).abs() < 0.05, "{template} {motion}: {rate} {single}");
            }
        }
    }
}

/// In roll, the right side of an independent suspension is the mirror image of the left side at the opposite travel.
#[test]
fn both_sides_are_mirror_images() {
    let folder = Scratch::new("kinematics-sides");
    let text = done(&folder, &["template", "macpherson-strut"]);
    folder.write("car.toml", &text.replace("build = \"left\"", "build = \"both\""));
    let rows = rows(&folder, "car.toml", &["--roll", "-20mm:20mm:3"]);
    for name in
        ["camber", "toe", "caster", "scrub_radius", "motion_ratio_spring", "unsprung_mass", "camber_gradient"]
    {
        for (row, other) in rows.iter().zip(rows.iter().rev()) {
            let [left, right] = [value(row, &format!("{name}_left")), value(other, &format!("{name}_right"))];
            close(left, right, ROUNDING, name);
        }
    }
    close(value(&rows[1], "roll_centre_lateral"), 0.0, ROUNDING, "middle");
    close(
        value(&rows[0], "roll_centre_lateral"),
        -value(&rows[2], "roll_centre_lateral"),
        ROUNDING,
        "lateral",
    );
}

/// The unsprung mass and the motion ratio are those of `percuss mass` at the named contacts.
#[test]
fn masses_and_ratios_are_those_of_the_named_contacts() {
    let folder = Scratch::new("kinematics-contacts");
    folder.write("car.toml", &done(&folder, &["template", "double-wishbone"]));
    let row = &rows(&folder, "car.toml", &["--wheel-travel", "20mm"])[0];
    let mass = |at: &str| -> Value {
        let words = ["mass", "car.toml", "--at", at, "--wheel-travel", "20mm", "--format", "json"];
        serde_json::from_str(&done(&folder, &words)).expect("JSON")
    };
    let patch = mass("contact_patch");
    close(value(row, "unsprung_mass"), patch["effective_mass"].as_f64().expect("a mass"), ROUNDING, "mass");
    let ratio = mass("spring")["motion_ratios"][0]["contact_per_wheel"].as_f64().expect("a ratio");
    close(value(row, "motion_ratio_spring"), ratio, ROUNDING, "ratio");
}

/// One motion ratio, contact per wheel with its sign: in `kinematics`, `mass`, the table of contacts and `sweep`, with a rack that
/// slides or not.
#[test]
fn every_command_has_the_same_motion_ratio() {
    let folder = Scratch::new("kinematics-ratios");
    for (template, rack) in [
        ("double-wishbone", "true"),
        ("macpherson-strut", "false"),
        ("pushrod-rocker", "true"),
        ("five-link", "true"),
    ] {
        let text = done(&folder, &["template", template]);
        folder.write("car.toml", &text.replace("slides = false", &format!("slides = {rack}")));
        let at = ["--wheel-travel", "20mm"];
        let row = &rows(&folder, "car.toml", &at)[0];
        let list = done(&folder, &["mass", "car.toml", "--at", "all", at[0], at[1], "--format", "json"]);
        let list: Value = serde_json::from_str(&list).expect("JSON");
        for contact in ["spring", "damper", "bump_stop", "rebound_stop"] {
            let expected = value(row, &format!("motion_ratio_{contact}"));
            let what = format!("{template} {contact}");
            let listed = list["contacts"].as_array().expect("a list").iter().find(|c| c["name"] == contact);
            let ratios = &listed.expect("the contact")["report"]["motion_ratios"];
            close(ratios[0]["contact_per_wheel"].as_f64().expect("a ratio"), expected, ROUNDING, &what);
            let words = [
                "sweep",
                "car.toml",
                "--at",
                contact,
                "--wheel-travel",
                "10mm:20mm:2",
                "--output",
                "rows.json",
                "--force",
            ];
            done(&folder, &words);
            let swept = std::fs::read_to_string(folder.path("rows.json")).expect("rows");
            let swept: Value = serde_json::from_str(&swept).expect("JSON");
            close(swept["rows"][1]["motion_ratio"].as_f64().expect("a ratio"), expected, ROUNDING, &what);
        }
    }
}

/// Support angles and frequencies: closed forms from the columns; missing data are named.
#[test]
fn vehicle_data_give_support_and_frequencies() {
    let folder = Scratch::new("kinematics-vehicle");
    let text = done(&folder, &["template", "double-wishbone"]);
    folder.write("car.toml", &text.replacen("[spring]\n", "[spring]\nrate = \"100 N/mm\"\n", 1));
    let flags = "--axle front --brake-bias 60% --drive-share 40% --cg-height 500mm --wheelbase 2.5m --inboard-drive \
                 --sprung-mass 300 --tyre-rate 200N/mm";
    let row = &rows(&folder, "car.toml", &flags.split_whitespace().collect::<Vec<_>>())[0];
    close(value(row, "anti_dive"), 0.6 * 5.0 * value(row, "side_view_angle").tan(), ROUNDING, "anti-dive");
    let lift = 0.4 * 5.0 * value(row, "side_view_angle_centre").tan();
    close(value(row, "anti_lift_driving"), lift, ROUNDING, "anti-lift");
    let ratio = value(row, "motion_ratio_spring");
    let (k, kt, ms, mu) = (value(row, "wheel_rate"), 200e3, 300.0, value(row, "unsprung_mass"));
    close(k, 100e3 * ratio * ratio, ROUNDING, "wheel rate");
    for name in ["body_frequency", "wheel_hop_frequency"] {
        let w2 = (value(row, name) * std::f64::consts::TAU).powi(2);
        let determinant = (k - ms * w2) * (k + kt - mu * w2) - k * k;
        close(determinant / (k * kt), 0.0, ROUNDING, name);
    }
    let missing = run(&folder, &["kinematics", "car.toml", "--axle", "rear", "--wheelbase", "2.5m"]).stdout;
    for words in [
        "anti_squat: missing: --drive-share,",
        "anti_lift_braking: missing: --brake-bias,",
        "side view angle",
    ] {
        assert!(missing.contains(words), "{words}: {missing}");
    }
}

/// A rack that slides stays on the way of the wheel: the angles are those with a fixed rack, also if no default driver of the
/// loops moves the rack.
#[test]
fn a_sliding_rack_stays_on_the_way() {
    let folder = Scratch::new("kinematics-rack");
    for (template, mass) in [("double-wishbone-rods", "0"), ("double-wishbone-rods", "2"), ("five-link", "0")]
    {
        let text = done(&folder, &["template", template]);
        folder.write("fixed.toml", &text);
        let sliding = text.replace("slides = false", "slides = true");
        folder.write("sliding.toml", &sliding.replace("mass = 2.5 ", &format!("mass = {mass} ")));
        for travel in ["30mm", "-30mm"] {
            let [fixed, sliding] =
                ["fixed.toml", "sliding.toml"].map(|sheet| rows(&folder, sheet, &["--wheel-travel", travel]));
            for name in ["camber", "toe", "half_track_change", "motion_ratio_spring", "wheel_travel"] {
                close(
                    value(&sliding[0], name),
                    value(&fixed[0], name),
                    ROUNDING,
                    &format!("{template} {name}"),
                );
            }
        }
    }
}

/// A fork slides along its line: every motion ratio is that of the line, and caster and trail are those of the steering head.
#[test]
fn a_telescopic_fork_slides_along_its_line() {
    let folder = Scratch::new("kinematics-fork");
    folder.write("car.toml", &done(&folder, &["template", "telescopic-fork"]));
    let (rise, back) = (595.0f64, 265.0f64);
    let cosine = rise / rise.hypot(back);
    for row in rows(&folder, "car.toml", &["--wheel-travel", "-40mm:40mm:3"]) {
        close(value(&row, "unsprung_mass"), 29.0 / (cosine * cosine), ROUNDING, "mass");
        close(value(&row, "side_view_angle"), -(back / rise).atan(), ROUNDING, "path");
        let travel = value(&row, "wheel_travel");
        close(value(&row, "forward_displacement"), -travel * back / rise, ROUNDING, "displacement");
        close(value(&row, "caster"), (61.0f64 / 137.0).atan(), ROUNDING, "caster");
        // The steering head stays, the contact point moves.
        let trail = 0.061 / 0.137 * (0.750 - travel) - 0.256 + travel * back / rise;
        close(value(&row, "mechanical_trail"), trail, ROUNDING, "trail");
        close(value(&row, "scrub_radius"), 0.0, ROUNDING, "scrub radius");
        assert!(row["roll_centre_height"].is_null() && row["instant_centre_height"].is_null());
    }
    let words = ["mass", "car.toml", "--at", "bump_stop", "--format", "json"];
    let stop: Value = serde_json::from_str(&done(&folder, &words)).expect("JSON");
    assert!(value(&stop, "effective_mass") >= 29.0);
}

/// A swing arm is a lever: ratios of the distances from the pivot along x at the design position.
#[test]
fn a_swing_arm_turns_about_its_pivot() {
    let folder = Scratch::new("kinematics-swing-arm");
    let text = done(&folder, &["template", "swing-arm"]);
    folder.write("car.toml", &text);
    let row = &rows(&folder, "car.toml", &[])[0];
    let (dx, dz) = (55.0, 255.0f64);
    let along = [dx / f64::hypot(dx, dz), dz / f64::hypot(dx, dz)];
    let expected = (along[1] * (560.0 - 395.0) + along[0] * (385.0 - 365.0)) / 560.0;
    close(value(row, "motion_ratio_spring"), expected, ROUNDING, "spring");
    close(value(row, "side_view_angle_centre"), (-55.0f64 / 560.0).atan(), ROUNDING, "path");
    close(value(row, "camber_gradient"), 0.0, ROUNDING, "camber");
    for (words, change) in [
        ("middle plane: y = 0", ("wheel_centre = [0.0, 0.0,", "wheel_centre = [0.0, 5.0,")),
        ("middle plane: there is one side", ("build = \"left\"", "build = \"both\"")),
    ] {
        assert!(text.contains(change.0));
        folder.write("changed.toml", &text.replace(change.0, change.1));
        let outcome = run(&folder, &["kinematics", "changed.toml"]);
        assert!(outcome.stderr.replace("\n  ", " ").contains(words), "{}", outcome.stderr);
    }
    assert!(run(&folder, &["kinematics", "car.toml", "--roll", "1mm"]).stderr.contains("both sides"));
}

/// A third spring works in heave and not in roll; its share of the wheel rate is half of k i².
#[test]
fn a_third_spring_works_in_heave_alone() {
    let folder = Scratch::new("kinematics-third-spring");
    let text = done(&folder, &["template", "pushrod-third-spring"]);
    let with = |more: &str| text.replacen("[third_spring]\n", &format!("[third_spring]\n{more}\n"), 1);
    folder.write("car.toml", &with("rate = \"50 N/mm\""));
    let heave = &rows(&folder, "car.toml", &[])[0];
    let roll = &rows(&folder, "car.toml", &["--roll", "0:0:1"])[0];
    let ratio = value(heave, "motion_ratio_third_spring_left");
    close(value(heave, "wheel_rate_left"), 0.5 * 50e3 * ratio * ratio, ROUNDING, "heave");
    close(value(roll, "motion_ratio_third_spring_left"), 0.0, ROUNDING, "roll");
    // The ratio is the slope of the length between both seats.
    let rows = rows(&folder, "car.toml", &["--heave", "-0.5mm:0.5mm:5"]);
    assert!(rows.iter().all(|row| row["force_third_spring_left"].is_null()), "without a preload");
    folder.write("car.toml", &with("rate = \"50 N/mm\"\npreload = 100"));
    let force: Vec<f64> = self::rows(&folder, "car.toml", &["--heave", "-0.5mm:0.5mm:5"])
        .iter()
        .map(|row| value(row, "force_third_spring_left"))
        .collect();
    close(force[2], 100.0, ROUNDING, "preload");
    let slope = (force[0] - 8.0 * force[1] + 8.0 * force[3] - force[4]) / (12.0 * 0.00025);
    close(slope / 50e3, ratio, 1e-6, "slope");
    folder.write("left.toml", &text.replace("build = \"both\"", "build = \"left\""));
    let outcome = run(&folder, &["mass", "left.toml", "--at", "all", "--notes"]);
    assert!(outcome.code == 0 && !outcome.stdout.contains("third_spring"), "{}", outcome.stdout);
    assert!(outcome.stderr.contains("needs both sides"), "{}", outcome.stderr);
}

/// Massless rods alone are an ordinary suspension: stops and travels are those of rods with a negligible mass.
#[test]
fn massless_rods_alone_drive_the_wheel() {
    let folder = Scratch::new("massless-rods");
    for template in ["double-wishbone-rods", "five-link", "three-link", "solid-axle-panhard"] {
        let text = done(&folder, &["template", template]);
        // Without the anti-roll bar; rods of a given mass, or massless.
        let is_bar = |line: &str| ["anti_roll_bar_", "drop_link_"].iter().any(|key| line.starts_with(key));
        let with_rods = |mass: Option<&str>| {
            let (mut kept, mut section) = (String::new(), String::new());
            for line in text.lines().filter(|line| !is_bar(line)) {
                if line.starts_with('[') {
                    line.trim_matches(['[', ']']).clone_into(&mut section);
                }
                let is_rod = section.ends_with("_rod") || section.ends_with("_link");
                let is_removed =
                    ["anti_roll_bar", "drop_link"].contains(&section.as_str()) || is_rod && mass.is_none();
                match mass {
                    _ if is_removed => {}
                    Some(mass) if is_rod && line.starts_with("mass") => kept += &format!("mass = {mass}\n"),
                    _ => kept += &format!("{line}\n"),
                }
            }
            kept
        };
        folder.write("massless.toml", &with_rods(None));
        folder.write("light.toml", &with_rods(Some("1e-9")));
        let side = if template.starts_with("solid") { "_left" } else { "" };
        let travel = if side.is_empty() { "--wheel-travel" } else { "--heave" };
        let (stop, spring) = (format!("bump_stop{side}"), format!("spring{side}"));
        for flags in [vec!["--at", &stop], vec!["--at", &spring, travel, "20mm"]] {
            let mass = |sheet| -> f64 {
                let words = [&["mass", sheet, "--format", "json"], &flags[..]].concat();
                let report: Value = serde_json::from_str(&done(&folder, &words)).expect("JSON");
                value(&report, "effective_mass")
            };
            close(mass("massless.toml") / mass("light.toml"), 1.0, 1e-7, &format!("{template} {flags:?}"));
        }
    }
}

/// Selected columns are those of the whole table, in the order of the names; pictures have a panel per quantity; a study has the same
/// columns in its table, its file and its report.
#[test]
fn columns_are_selected_and_drawn() {
    let folder = Scratch::new("kinematics-columns");
    let text = done(&folder, &["template", "double-wishbone"]);
    folder.write("car.toml", &text.replace("build = \"left\"", "build = \"both\""));
    let range = ["--heave", "-20mm:20mm:5"];
    let all = rows(&folder, "car.toml", &range);
    let columns = "toe_left,camber,bump_stop.motion_ratio";
    let names = [
        "toe_left",
        "camber_left",
        "camber_right",
        "motion_ratio_bump_stop_left",
        "motion_ratio_bump_stop_right",
    ];
    let chosen = rows(&folder, "car.toml", &[&range[..], &["--columns", columns]].concat());
    for (row, of_all) in chosen.iter().zip(&all) {
        let keys: Vec<&String> = row.as_object().expect("a row").keys().collect();
        assert_eq!(keys.len(), names.len() + 2, "{keys:?}");
        names.iter().for_each(|name| assert_eq!(row[*name], of_all[*name], "{name}"));
    }
    let ratios = rows(&folder, "car.toml", &[&range[..], &["--columns", "motion_ratio"]].concat());
    let ratios = ratios[0].as_object().expect("a row").keys().filter(|key| key.starts_with("motion_ratio_"));
    assert_eq!(ratios.count(), 8);
    let csv = done(
        &folder,
        &["kinematics", "car.toml", range[0], range[1], "--columns", columns, "--format", "csv"],
    );
    let header = "heave_mm,toe_left_deg,camber_left_deg,camber_right_deg,motion_ratio_bump_stop_left,motion_ratio_bump_stop_right";
    assert_eq!(csv.lines().next(), Some(header));
    done(&folder, &["kinematics", "car.toml", range[0], range[1], "--columns", columns, "-o", "all.svg"]);
    let drawn = std::fs::read_to_string(folder.path("all.svg")).expect("a picture");
    for word in
        [">toe (deg)<", ">camber (deg)<", ">motion ratio, contact/wheel<", ">bump stop left<", ">heave (mm)<"]
    {
        assert!(drawn.contains(word), "{word}");
    }
    done(&folder, &["kinematics", "car.toml", range[0], range[1], "-o", "usual.svg"]);
    let usual = std::fs::read_to_string(folder.path("usual.svg")).expect("a picture");
    assert!(usual.contains(">roll centre height (mm)<") && !usual.contains(">caster (deg)<"));
    for (words, told) in
        [("car.toml --columns cambr", "did you mean"), ("car.toml -o one.svg", "a picture shows a range")]
    {
        let outcome = run(&folder, &[&["kinematics"], &words.split(' ').collect::<Vec<_>>()[..]].concat());
        assert!(outcome.code == 2 && outcome.stderr.contains(told), "{words}: {}", outcome.stderr);
    }
    let study = |output: &str| {
        format!(
            "[model]\npath = \"car.toml\"\n[kinematics]\nvary = \"heave=-20mm:20mm:5\"\ncolumns = [\"toe_left\", \"camber\", \
             \"bump_stop.motion_ratio\"]\n{output}"
        )
    };
    folder.write("file.toml", &study("output = \"rows.csv\"\n"));
    done(&folder, &["run", "file.toml"]);
    assert_eq!(std::fs::read_to_string(folder.path("rows.csv")).expect("rows"), csv);
    folder.write("study.toml", &study(""));
    let printed = done(&folder, &["run", "study.toml"]);
    assert!(printed.contains("toe left") && printed.contains("camber right"), "{printed}");
    done(&folder, &["run", "study.toml", "--report", "page.html"]);
    let page = std::fs::read_to_string(folder.path("page.html")).expect("a page");
    for word in ["Kinematics</h2>", ">camber (deg)<", ">camber, deg, left<", "derivatives along heave"] {
        assert!(page.contains(word), "{word}");
    }
    for (from, to, told) in [
        ("heave=", "bounce=", "kinematics.vary"),
        ("\"camber\"", "\"cambr\"", "did you mean"),
        ("columns", "colums", "columns"),
    ] {
        folder.write("wrong.toml", &study("").replacen(from, to, 1));
        let outcome = run(&folder, &["run", "wrong.toml"]);
        assert!(outcome.code == 2 && outcome.stderr.contains(told), "{to}: {}", outcome.stderr);
    }
}
