//! Named contacts: stops at the touch, lists, files.

use crate::support::{Scratch, Sweep, json, percuss, refused, root};
use serde_json::Value;

/// A bar of 2 kg on a hinge along y, with stops in front of its tip: a plane, a line that shortens, a line that grows.
const BAR: &str = r#"<robot name="bar"><link name="ground"/><link name="post"/>
  <link name="bar"><inertial><origin xyz="0 0 -0.3"/><mass value="2"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.1"/></inertial></link>
  <joint name="post" type="fixed"><parent link="ground"/><child link="post"/><origin xyz="1 0 -0.5"/></joint>
  <joint name="hinge" type="continuous"><parent link="ground"/><child link="bar"/><axis xyz="0 1 0"/></joint>
  <contact name="plane" type="stop"><body link="bar" xyz="0 0 -0.5"/><other link="world"/>
    <normal xyz="3 0 0"/><gap value="0.2"/></contact>
  <contact name="line" type="stop"><body link="bar" xyz="0 0 -0.5"/><other link="post"/>
    <toward xyz="0 0 0"/><gap value="0.2"/></contact>
  <contact name="rebound" type="stop"><body link="bar" xyz="0 0 -0.5"/><other link="post"/>
    <away xyz="0 0 0"/><gap value="0.2"/></contact>
  <contact name="far" type="stop"><body link="bar" xyz="0 0 -0.5"/><other link="world"/>
    <normal xyz="1 0 0"/><gap value="0.6"/></contact>
  <contact name="seat" type="spring"><body link="bar" xyz="0 0 -0.5"/><other link="post"/><toward xyz="0 0 0"/></contact>
</robot>"#;

/// Moment of inertia of the bar about its hinge, kg·m².
const INERTIA: f64 = 0.05 + 2.0 * 0.3 * 0.3;
const LENGTH: f64 = 0.5;

fn number(report: &Value, key: &str) -> f64 {
    report[key].as_f64().unwrap_or_else(|| panic!("{key} is {}", report[key]))
}

#[test]
fn stops_touch_where_the_closed_form_says() {
    let folder = Scratch::new("contacts-bar");
    let bar = folder.write("bar.urdf", BAR);
    let at = |name: &str| json(&format!("mass {bar} --at {name} --format json"));
    let angle = |report: &Value| report["pose"]["hinge"][0].as_f64().expect("an angle");
    // The tip is at L (−sin q, −cos q); the plane x = 0.2 is touched at sin q = −0.4. The lever is L cos q.
    let plane = at("plane");
    let q = -(0.2f64 / LENGTH).asin();
    assert!((angle(&plane) - q).abs() < 1e-12, "{plane}");
    let expected = INERTIA / (LENGTH * q.cos()).powi(2);
    assert!((number(&plane, "effective_mass") / expected - 1.0).abs() < 1e-11, "{plane}");
    // A line from the tip to (1, −0.5): its length is 1 as drawn, and 0.8 and 1.2 at the touch.
    for (name, length) in [("line", 0.8), ("rebound", 1.2)] {
        let report = at(name);
        let q = angle(&report);
        let (x, z) = (1.0 + LENGTH * q.sin(), -0.5 + LENGTH * q.cos());
        assert!((x.hypot(z) - length).abs() < 1e-12, "{name}: {}", x.hypot(z));
        // d(length)/dq = (x L cos q − z L sin q) / length.
        let lever = LENGTH * (x * q.cos() - z * q.sin()) / length;
        let found = number(&report, "effective_mass");
        assert!((found / (INERTIA / lever.powi(2)) - 1.0).abs() < 1e-11, "{name}: {found}");
        let contact = &report["named_contact"];
        assert_eq!(contact["brought_to_touch"], true);
        assert_eq!(contact["gap_as_drawn"], 0.2);
        assert!(number(contact, "gap").abs() < 1e-12);
    }
    // A seat always touches: the pose as drawn.
    let seat = at("seat");
    assert_eq!(angle(&seat), 0.0);
    assert_eq!(seat["named_contact"]["gap"], Value::Null);
}

#[test]
fn a_given_pose_is_kept_and_its_gap_is_stated() {
    let folder = Scratch::new("contacts-pose");
    let bar = folder.write("bar.urdf", BAR);
    // The only joint is set, so that nothing is free to close the gap: 0.2 − L sin 0.1 remains.
    let set = json(&format!("mass {bar} --at plane --set hinge=-0.1 --format json"));
    assert_eq!(set["named_contact"]["brought_to_touch"], false);
    assert!((number(&set["named_contact"], "gap") - (0.2 - LENGTH * 0.1f64.sin())).abs() < 1e-12);
    let travel = json(&format!("mass {bar} --at plane --travel bar:0,0,-0.5:1,0,0=0.3 --format json"));
    assert!((number(&travel["named_contact"], "gap") + 0.1).abs() < 1e-11, "a penetration of 0.1 m");
    let text = percuss(&format!("mass {bar} --at plane --travel bar:0,0,-0.5:1,0,0=0.3")).stdout;
    assert!(text.contains("pressed in by 100.00 mm"), "{text}");
    // The tip reaches x = 0.5 at most.
    let far = percuss(&format!("mass {bar} --at far"));
    assert_eq!(far.code, 1, "{}", far.stderr);
    assert!(far.stderr.contains("closes by 500.00 mm only, and 100.00 mm remain"), "{}", far.stderr);
}

/// Swing axle without an anti-roll bar, on a hinge along x.
const SWING_AXLE: &str = r#"template = "swing-axle"
unit = "m"
axes = "iso"
build = "both"
[points]
wheel_centre = [0, 0.7, 0.3]
pivot_front = [0.1, 0.2, 0.32]
pivot_back = [-0.1, 0.2, 0.32]
bump_stop_pad = [0, 0.45, 0.4]
bump_stop = [0, 0.44, 0.47]
rebound_stop_pad = [0, 0.5, 0.28]
rebound_stop = [0, 0.49, 0.2]
[bump_stop]
gap = 0.4
[rebound_stop]
gap = 0.7
[axle_tube]
mass = 6
com = [0, 0.4, 0.3]
inertia = [0.1, 0.02, 0.1]
[spindle]
mass = 4
inertia = [0.02, 0.03, 0.02]
"#;

/// Stops of two wheels with gaps that are too long: the smallest gap of a pad on a hinge is a closed form.
#[test]
fn the_remaining_gap_of_two_wheels_is_that_of_the_closed_form() {
    let folder = Scratch::new("contacts-remaining");
    let file = folder.write("axle.toml", SWING_AXLE);
    let pivot = [0.2, 0.32];
    for (stop, gap, pad, face) in
        [("bump_stop", 0.4, [0.45, 0.4], [0.44, 0.47]), ("rebound_stop", 0.7, [0.5, 0.28], [0.49, 0.2])]
    {
        // The pad at r from the hinge turns in the plane x = 0: n · r is at most |r| there, for a unit normal n.
        let [r, line]: [[f64; 2]; 2] =
            [[pad, pivot], [face, pad]].map(|[to, from]| [to[0] - from[0], to[1] - from[1]]);
        let closed = r[0].hypot(r[1]) - (r[0] * line[0] + r[1] * line[1]) / line[0].hypot(line[1]);
        let remaining = 1e3 * (gap - closed);
        let outcome = percuss(&format!("mass {file} --at {stop}_left"));
        let text = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(outcome.code, 1, "{text}");
        assert!(text.contains(&format!("and {remaining:.2} mm remain")), "{stop}: {remaining} mm: {text}");
        assert_remaining_gap(&file, &format!("{stop}_left"), gap - closed);
    }
    // Two bars of different lengths, each in front of its own plane: the shorter one reaches its largest distance first.
    let bar = |side: &str, length: f64, y: f64| {
        format!(
            r#"<link name="bar_{side}"><inertial><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.05" iyz="0"
            izz="0.1"/></inertial></link><joint name="hinge_{side}" type="continuous"><parent link="ground"/>
            <child link="bar_{side}"/><origin xyz="0 {y} 0"/><axis xyz="0 1 0"/></joint>
            <contact name="stop_{side}" type="stop"><body link="bar_{side}" xyz="0 0 -{length}"/><other link="world"/>
            <normal xyz="1 0 0"/><gap value="0.6"/></contact>"#
        )
    };
    let bars = [bar("left", 0.5, 1.0), bar("right", 0.7, -1.0)].concat();
    let bars =
        folder.write("bars.urdf", &format!(r#"<robot name="bars"><link name="ground"/>{bars}</robot>"#));
    for side in ["left", "right"] {
        let outcome = percuss(&format!("mass {bars} --at stop_{side}"));
        let text = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains("closes by 500.00 mm only, and 100.00 mm remain"), "{side}: {text}");
        assert_remaining_gap(&bars, &format!("stop_{side}"), 0.1);
    }
}

/// The smallest gap in the list of the contacts, m. The search for the smallest gap ends at 1 nm.
fn assert_remaining_gap(file: &str, stop: &str, expected: f64) {
    let list = json(&format!("mass {file} --at all --format json"));
    let contacts = list["contacts"].as_array().expect("a list");
    let contact = contacts.iter().find(|contact| contact["name"] == stop).expect("the stop");
    let found = number(contact, "remaining_gap");
    assert!((found - expected).abs() < 1e-9, "{stop}: {found}, {expected}");
}

#[test]
fn the_list_has_every_contact_and_the_reason_of_a_missing_one() {
    let folder = Scratch::new("contacts-list");
    let bar = folder.write("bar.urdf", BAR);
    let list = json(&format!("mass {bar} --at all --format json"));
    let contacts = list["contacts"].as_array().expect("a list");
    let names: Vec<&str> = contacts.iter().filter_map(|c| c["name"].as_str()).collect();
    assert_eq!(names, ["plane", "line", "rebound", "far", "seat"]);
    for contact in contacts {
        let name = contact["name"].as_str().expect("a name");
        if name == "far" {
            assert!(contact["problem"].as_str().expect("a reason").contains("cannot be reached"));
            continue;
        }
        let alone = json(&format!("mass {bar} --at {name} --format json"));
        assert_eq!(contact["report"]["effective_mass"], alone["effective_mass"], "{name}");
    }
    let text = percuss(&format!("mass {bar} --at all")).stdout;
    let far = text.lines().find(|line| line.starts_with("far  ")).expect("a row");
    assert!(far.contains(" none ") && text.contains("\nfar: the stop"), "{text}");
    let rows = percuss(&format!("mass {bar} --at all --format csv")).stdout;
    assert_eq!(rows.lines().count(), 6, "{rows}");
    refused(&format!("mass {bar} --at all --explain"), &["--explain", "--at"]);
    refused(&format!("mass {bar} --at plain"), &["--at", "did you mean \"plane\""]);
    refused("mass models/six_r_arm.urdf --at all", &["--at", "names no contact", "<contact>"]);
    refused(&format!("mass {bar} --at plane --link bar"), &["--at", "--link"]);
}

#[test]
fn damp_and_studies_take_named_contacts() {
    let folder = Scratch::new("contacts-damp");
    let bar = folder.write("bar.urdf", BAR);
    let options = "--restitution 0.3 --stiffness 2e5 --speed 1 --format json";
    let damp = json(&format!("damp --mass-from {bar} --at plane {options}"));
    let mass = json(&format!("mass {bar} --at plane --format json"));
    assert_eq!(damp["effective_mass"], mass["effective_mass"]);
    assert_eq!(damp["named_contact"], mass["named_contact"]);
    let study = folder.write("s.toml", "[model]\npath = \"bar.urdf\"\n[contact]\nat = \"plane\"\n");
    let run = json(&format!("run {study} --format json"));
    assert_eq!(run["effective_mass"], mass["effective_mass"]);
    let both =
        folder.write("b.toml", "[model]\npath = \"bar.urdf\"\n[contact]\nat = \"plane\"\nlink = \"bar\"\n");
    refused(&format!("run {both}"), &["contact.at", "remove link"]);
}

/// A left and a right stop on one joint: the joint closes the gap of the contact of the question, and no gap is left open.
#[test]
fn one_joint_drives_the_stops_of_both_sides() {
    let folder = Scratch::new("contacts-sides");
    let both = BAR.replace("\"plane\"", "\"stop_left\"").replace("\"line\"", "\"stop_right\"");
    let bar = folder.write("bar.urdf", &both);
    let plane = json(&format!("mass {bar} --at stop_left --format json"));
    assert_eq!(plane["named_contact"]["brought_to_touch"], true, "{plane}");
    assert!(number(&plane["named_contact"], "gap").abs() < 1e-12);
    let line = json(&format!("mass {bar} --at stop_right --format json"));
    assert_eq!(line["named_contact"]["brought_to_touch"], true, "{line}");
}

/// Link that the key `on` in the section of a contact names.
fn stated_body(sheet: &str, contact: &str) -> Option<String> {
    let text = std::fs::read_to_string(root().join(sheet)).expect("a sheet");
    let section = contact.trim_end_matches("_left").trim_end_matches("_right");
    let rest = text.split(&format!("\n[{section}]\n")).nth(1)?;
    let line =
        rest.lines().take_while(|line| !line.starts_with('[')).find(|line| line.starts_with("on = "))?;
    Some(line.split('"').nth(1)?.to_owned())
}

/// For every shipped sheet and stop: the gap is closed, the mass is that of the same contact given by link, point and
/// normal at the same positions, and the imported URDF gives the same.
#[test]
fn stops_of_every_sheet_touch_and_survive_the_import() {
    let folder = Scratch::new("contacts-sheets");
    let (mut stops, mut bodies) = (0, 0);
    for entry in std::fs::read_dir(root().join("models/suspensions")).expect("a folder") {
        let file = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        if !file.ends_with(".toml") {
            continue;
        }
        let sheet = format!("models/suspensions/{file}");
        let urdf = folder.path("car.urdf");
        assert_eq!(percuss(&format!("import {sheet} -o {urdf} --force")).code, 0, "{sheet}");
        let list = json(&format!("mass {sheet} --at all --format json"));
        let imported = json(&format!("mass {urdf} --at all --format json"));
        let both = list["contacts"]
            .as_array()
            .expect("a list")
            .iter()
            .zip(imported["contacts"].as_array().expect("a list"));
        for (contact, again) in both {
            let name = contact["name"].as_str().expect("a name");
            assert_eq!(contact["name"], again["name"], "{sheet}");
            let carrier = contact["report"]["named_contact"]["on"].as_str().expect("a body");
            if let Some(stated) = stated_body(&sheet, name) {
                let side = ["_left", "_right"].into_iter().find(|side| carrier.ends_with(side));
                assert_eq!(carrier.trim_end_matches(side.unwrap_or_default()), stated, "{sheet}: {name}");
                bodies += 1;
            }
            let [report, again] = [contact, again].map(|contact| &contact["report"]);
            assert!(!report.is_null(), "{sheet}: {name}: {}", contact["problem"]);
            let [mass, of_urdf] = [report, again].map(|report| number(report, "effective_mass"));
            assert!((mass / of_urdf - 1.0).abs() < 1e-9, "{sheet}: {name}: {mass}, {of_urdf}");
            if contact["kind"] != "stop" {
                continue;
            }
            stops += 1;
            let named = &report["named_contact"];
            assert!(number(named, "gap").abs() < 1e-10, "{sheet}: {name}");
            assert_eq!(named["brought_to_touch"], true, "{sheet}: {name}");
            // On an axle, both wheels have the same travel.
            let pose = folder.write("pose.json", &report.to_string());
            let side = ["_left", "_right"].into_iter().find(|side| name.ends_with(side)).unwrap_or_default();
            let stop = name.trim_end_matches(side);
            let line = format!(
                "mass {sheet} --pose {pose} --link {stop}_pad{side} --point 0,0,0 --normal {} --normal-frame world \
                 --against chassis --format json",
                report["contact"]["normal_world"].to_string().trim_matches(['[', ']']).replace(' ', "")
            );
            let by_hand = number(&json(&line), "effective_mass");
            assert!((mass / by_hand - 1.0).abs() < 1e-9, "{line}: {mass}, {by_hand}");
        }
    }
    // Seventeen sheets with one side, five axles and a third spring with both; two stops on each side.
    assert_eq!(stops, 2 * 17 + 4 * 6);
    assert!(bodies > 2 * stops - 20, "{bodies}");
}

/// Heave and roll move each wheel by the sum and the difference, at one pose and in a sweep.
#[test]
fn wheels_heave_and_roll() {
    let mass = |line: &str| number(&json(&format!("mass {line} --format json")), "effective_mass");
    let axle = "models/suspensions/solid-axle-panhard.toml --at spring_left";
    let travel = |left: f64, right: f64| {
        let of = |side: &str, by: f64| format!("--travel wheel_centre_{side}:0,0,0:0,0,1={by}");
        mass(&format!("{axle} {} {}", of("left", left), of("right", right)))
    };
    for (heave, roll) in [(0.03, 0.0), (0.0, 0.02), (0.02, -0.01), (-0.04, 0.015)] {
        let found = mass(&format!("{axle} --heave {heave} --roll {roll}"));
        let expected = travel(heave + roll, heave - roll);
        assert!((found / expected - 1.0).abs() < 1e-10, "{heave} {roll}: {found}, {expected}");
    }
    // A range of one motion beside a constant of the other, in any order of the rows.
    for (ranged, constant, from, to) in [("heave", "roll", -0.04, 0.04), ("roll", "heave", 0.03, -0.03)] {
        let rows = percuss(&format!("sweep {axle} --{ranged} {from}:{to}:5 --{constant} 15mm"));
        assert_eq!(rows.code, 0, "{}", rows.stderr);
        let rows = crate::support::Sweep::read(&rows.stdout);
        for row in 0..5 {
            let value = rows.number(row, ranged).expect("a value");
            let single = mass(&format!("{axle} --{ranged} {value} --{constant} 15mm"));
            let found = rows.number(row, "effective_mass").expect("finite");
            assert!((found / single - 1.0).abs() < 1e-9, "{ranged} {value}: {found}, {single}");
        }
    }
    // Rows of a sweep are the single poses, in any order.
    for (motion, from, to) in [("heave", -0.05, 0.05), ("roll", 0.03, -0.03)] {
        let rows = percuss(&format!("sweep {axle} --{motion} {from}:{to}:5"));
        assert_eq!(rows.code, 0, "{}", rows.stderr);
        let by_name = percuss(&format!("sweep {axle} --vary {motion}={from}:{to}:5"));
        assert_eq!(rows.stdout, by_name.stdout);
        let mut lines = rows.stdout.lines();
        let column = lines.next().expect("a header").split(',').position(|name| name == "effective_mass");
        for line in lines {
            let cells: Vec<&str> = line.split(',').collect();
            let single = mass(&format!("{axle} --{motion} {}", cells[1]));
            let row: f64 = cells[column.expect("a column")].parse().expect("a mass");
            assert!((row / single - 1.0).abs() < 1e-10, "{motion} {}: {row}, {single}", cells[1]);
        }
    }
    let corner = "models/suspensions/double-wishbone.toml --at spring";
    let by_point = mass(&format!("{corner} --travel wheel_centre:0,0,0:0,0,1=25mm"));
    assert_eq!(mass(&format!("{corner} --wheel-travel 25mm")), by_point);
    assert_eq!(mass(&format!("{corner} --heave 25mm")), by_point);
    refused(&format!("mass {corner} --roll 1mm"), &["roll", "both sides"]);
    refused(&format!("mass {axle} --wheel-travel 1mm"), &["wheel-travel", "heave", "roll"]);
    refused(&format!("mass {corner} --heave 0:1:2"), &["--heave", "percuss sweep"]);
    refused(&format!("mass {corner} --heave 1deg"), &["--heave"]);
    refused(
        "mass models/four_bar.urdf --link coupler --point 0,0,0 --normal 0,1,0 --heave 1mm",
        &["wheel_centre"],
    );
    refused(&format!("sweep {corner} --heave 1mm"), &["no range"]);
    refused(&format!("mass {corner} --steer 1mm"), &["the rack is fixed", "rack.slides"]);
}

/// The damper for the mass at the touch, in an impact with the mass over the penetration. The bar of these tests has the
/// equation of motion of its angle; `crates/contact/tests/varying_mass.rs` integrates it.
#[test]
fn the_impact_over_the_stroke_follows_the_mass() {
    let folder = Scratch::new("contacts-stroke");
    let bar = folder.write("bar.urdf", BAR);
    // At 48 m/s the impact ends 0.034 m before the dead centre at 0.3 m.
    for speed in [3, 48] {
        let damp = json(&format!(
            "damp --mass-from {bar} --at plane --restitution 0.5 --stiffness 2e4 --speed {speed} --format json"
        ));
        let stroke = &damp["over_stroke"];
        // m̄ = I / (L cos q)² with sin q = −(0.2 + δ)/L.
        let depth = number(stroke, "max_penetration");
        let sine = (0.2 + depth) / LENGTH;
        let expected = INERTIA / (LENGTH * LENGTH * (1.0 - sine * sine));
        let found = number(stroke, "mass_at_max_penetration");
        // The motion over the penetration is accurate to four digits of the depth.
        assert!((found / expected - 1.0).abs() < 3e-4, "{stroke}, {expected}");
        assert!(found > 1.02 * number(&damp, "effective_mass"), "the mass grows: {stroke}");
        assert!(
            (number(stroke, "restitution") - 0.5).abs() > 1e-4,
            "a constant mass would give 0.5: {stroke}"
        );
    }
}

/// Both stops of an axle touch together. In the motion in which they close at the same speed, the impulses are those of W p = 1
/// with the inverse masses of `percuss impact`.
#[test]
fn stops_that_touch_together_state_both_masses() {
    let axle = "models/suspensions/solid-axle-panhard.toml --at bump_stop_left";
    let report = json(&format!("mass {axle} --format json"));
    let named = &report["named_contact"];
    assert_eq!(named["touching"][0], "bump_stop_right");
    let impact =
        json(&format!("impact {axle} --also bump_stop_right --speed 1 --restitution 0 --format json"));
    let delassus = &impact["simultaneous"]["delassus"];
    let entry = |row: usize, column: usize| delassus[row][column].as_f64().expect("an inverse mass");
    let (own, other, both) = (entry(0, 0), entry(3, 3), entry(0, 3));
    let expected = (other - both) / (own * other - both * both);
    assert!((number(named, "effective_mass_together") / expected - 1.0).abs() < 1e-11, "{named}");
    assert!(expected < number(&report, "effective_mass"), "the stop alone turns the axle");
    let corner = json("mass models/suspensions/double-wishbone.toml --at bump_stop --format json");
    assert!(corner["named_contact"]["effective_mass_together"].is_null());
}

/// The contact patch is the lowest point of the wheel at the pose, in `mass`, `sweep` and `kinematics`.
#[test]
fn the_contact_patch_is_the_lowest_point_at_the_pose() {
    let sheet = "models/suspensions/semi-trailing-arm.toml";
    let kinematics = json(&format!("kinematics {sheet} --wheel-travel -80mm:80mm:3 --format json"));
    let swept = percuss(&format!("sweep {sheet} --at contact_patch --wheel-travel -80mm:80mm:3"));
    let swept = Sweep::read(&swept.stdout);
    for (row, travel) in [-80, 0, 80].into_iter().enumerate() {
        let unsprung = number(&kinematics["rows"][row], "unsprung_mass");
        let swept = swept.number(row, "effective_mass").expect("a mass");
        let report =
            json(&format!("mass {sheet} --at contact_patch --wheel-travel {travel}mm --format json"));
        // The rows close the loops on another way; a closed pose is exact to 1e-12.
        assert!((swept / unsprung - 1.0).abs() < 1e-10, "{travel}: {swept}, {unsprung}");
        assert!((number(&report, "effective_mass") / unsprung - 1.0).abs() < 1e-10, "{travel}: {report}");
    }
}
