//! Files of Suspension Explorer and rFactor have the values of the sheets with the same points and masses.

use crate::support::{Random, Scratch, done};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Points of a template, mm, each coordinate displaced by at most 5 mm.
fn points(folder: &Scratch, template: &str, random: &mut Random) -> BTreeMap<String, [f64; 3]> {
    let text = done(folder, &["template", template]);
    let section =
        text.split("\n[points]\n").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("points");
    let point = |line: &str| {
        let (key, rest) = line.split_once(" = [")?;
        let numbers: Vec<f64> =
            rest.split(']').next()?.split(", ").map(|x| x.parse().expect("a number")).collect();
        let at = [0, 1, 2].map(|k| ((numbers[k] + 5.0 * random.next()) * 1e3).round() / 1e3);
        Some((key.to_owned(), at))
    };
    section.lines().filter_map(point).collect()
}

/// Rows of a report.
fn rows(folder: &Scratch, words: &[&str]) -> Vec<Value> {
    let report: Value = serde_json::from_str(&done(folder, words)).expect("JSON");
    report["rows"].as_array().expect("rows").clone()
}

/// Name of Suspension Explorer for a point.
fn explorer_name(point: &str) -> Option<String> {
    let pairs = [
        ("lower_front", "lower_wishbone_inboard_front"),
        ("lower_back", "lower_wishbone_inboard_rear"),
        ("lower_ball", "lower_wishbone_outboard"),
        ("upper_front", "upper_wishbone_inboard_front"),
        ("upper_back", "upper_wishbone_inboard_rear"),
        ("upper_ball", "upper_wishbone_outboard"),
        ("tie_rod_inner", "trackrod_inboard"),
        ("tie_rod_outer", "trackrod_outboard"),
        ("damper_seat", "strut_bottom"),
        ("damper_chassis_seat", "strut_top"),
        ("strut_bottom", "strut_bottom"),
        ("strut_top", "strut_top"),
        ("arm_inner", "trailing_arm_pivot_a"),
        ("arm_outer", "trailing_arm_pivot_b"),
    ];
    if let Some((_, name)) = pairs.iter().find(|(known, _)| *known == point) {
        return Some((*name).to_owned());
    }
    let (link, end) = point.split_once("_link_").filter(|(link, _)| *link != "drop")?;
    let end = if end == "chassis" { "inboard" } else { "outboard" };
    Some(format!("{}_link_{end}", link.replace("back", "rear")))
}

/// The kinematics of a YAML file are those of the sheet with the same points, for the left side, the right side, and a side of an axle.
#[test]
fn files_of_suspension_explorer_are_their_sheets() {
    let folder = Scratch::new("explorer-files");
    let mut random = Random(7);
    let mut compared = 0;
    for (kind, template, on) in [
        ("double_wishbone", "double-wishbone", "lower_wishbone"),
        ("macpherson", "macpherson-strut", ""),
        ("multi_link", "five-link", "lower_rear_link"),
        ("trailing_arm", "semi-trailing-arm", ""),
    ] {
        for case in 0..5 {
            let points = points(&folder, template, &mut random);
            let [camber, toe, offset] = [2.0, 0.5, 20.0].map(|most| most * random.next());
            let (c, t): (f64, f64) = (camber.to_radians(), toe.to_radians());
            let along = [t.sin() * c.cos(), t.cos() * c.cos(), -c.sin()];
            let wheel = points["wheel_centre"];
            let axle = |by: f64| [0, 1, 2].map(|k| wheel[k] + by * along[k]);
            let is_macpherson = kind == "macpherson";
            let mut listed: Vec<(String, [f64; 3])> = points
                .iter()
                // The strut of this type is spring and damper in one.
                .filter(|(name, _)| !is_macpherson || !name.starts_with("damper"))
                .filter_map(|(name, at)| Some((explorer_name(name)?, *at)))
                .collect();
            listed.extend([
                ("axle_inboard".to_owned(), axle(offset - 90.0)),
                ("axle_outboard".to_owned(), axle(offset)),
            ]);
            let is_right = case == 1;
            let flip = if is_right { -1.0 } else { 1.0 };
            let block = |indent: &str, flip: f64| {
                listed.iter().fold(String::new(), |mut text, (name, [x, y, z])| {
                    let _ = writeln!(
                        text,
                        "{indent}{name}: {{x: {x:?}, y: {:?}, z: {z:?}}}  # a point",
                        flip * y
                    );
                    text
                })
            };
            let wheel_keys = format!(
                "steering: {{type: rack}}\n  wheel:\n    offset: {offset:?}\n    tire:\n      aspect_ratio: 0.55\n      section_width: 205\n      rim_diameter: 16"
            );
            let mount = if on.is_empty() {
                String::new()
            } else {
                format!("actuation:\n  type: direct\n  mount: {on}\n")
            };
            let head = format!(
                "# car\ntype: {kind}\nname: \"car\"\nversion: \"0.0.1\"\nunits: millimeters\n{mount}spring:\n  type: coilover\n"
            );
            let text = if case == 2 {
                format!(
                    "{head}scope: axle\naxle_config:\n  {wheel_keys}\nhardpoints:\n  left:\n{}  right:\n{}",
                    block("    ", 1.0),
                    block("    ", -1.0)
                )
            } else {
                let side = if is_right { "right" } else { "left" };
                format!(
                    "{head}side: {side}\nconfig:\n  {wheel_keys}\n  wheelbase: 2500.0\nhardpoints:\n{}",
                    block("  ", flip)
                )
            };
            folder.write("car.yaml", &text);
            let mut sheet = format!("template = \"{template}\"\nunit = \"mm\"\naxes = \"iso\"\n[points]\n");
            let is_used = |name: &str| {
                explorer_name(name).is_some() && !(is_macpherson && name.starts_with("damper"))
                    || name == "wheel_centre"
            };
            for (name, at) in points.iter().filter(|(name, _)| is_used(name)) {
                let _ = writeln!(sheet, "{name} = {at:?}");
                if name.starts_with("damper") {
                    let _ = writeln!(sheet, "{} = {at:?}", name.replace("damper", "spring"));
                }
            }
            let _ = writeln!(
                sheet,
                "[wheel]\nradius = {:?}\ncamber = \"{camber} deg\"\ntoe = \"{toe} deg\"",
                12.7 * 16.0 + 0.55 * 205.0
            );
            if !on.is_empty() {
                let link = if on == "lower_wishbone" { "lower_arm" } else { "lower_back_link" };
                let _ = writeln!(sheet, "[spring]\non = \"{link}\"\n[damper]\non = \"{link}\"");
            }
            folder.write("car.toml", &sheet);
            let of = |file: &str| {
                rows(&folder, &["kinematics", file, "--wheel-travel", "-20mm:20mm:3", "--format", "json"])
            };
            let (found, expected) = (of("car.yaml"), of("car.toml"));
            for (found, expected) in found.iter().zip(&expected) {
                for (name, value) in expected.as_object().expect("an object") {
                    let Some(value) = value.as_f64() else { continue };
                    let own = found[name].as_f64().unwrap_or_else(|| panic!("{kind} {case}: {name}"));
                    // The right side is the mirror image: only the lateral position of the roll centre changes its sign.
                    let own = if is_right && name == "roll_centre_lateral" { -own } else { own };
                    // The points differ by roundings of some 1e-13 m, which closing amplifies.
                    assert!(
                        (own - value).abs() <= 1e-9 * value.abs().max(1.0),
                        "{kind} {case}: {name} {own} {value}"
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 20 * 3 * 15, "{compared}");
}

/// The effective masses of a `.pm` are those of the sheet with the same bars and bodies, for each corner.
#[test]
fn suspensions_of_rfactor_are_their_sheets() {
    let folder = Scratch::new("rfactor-files");
    let mut random = Random(11);
    for template in ["five-link", "double-wishbone-rods"] {
        for case in 0..6 {
            let points = points(&folder, template, &mut random);
            let (is_right, is_rear) = (case % 2 == 1, case % 3 == 2);
            let corner = format!("{}{}", if is_rear { 'r' } else { 'f' }, if is_right { 'r' } else { 'l' });
            let sign = if is_right { -1.0 } else { 1.0 };
            // x left, y up, z backward, in metres.
            let at = |p: [f64; 3]| format!("({:?},{:?},{:?})", sign * p[1] / 1e3, p[2] / 1e3, -p[0] / 1e3);
            let [m_spindle, m_wheel] = [9.0, 18.0].map(|m| m * (1.0 + 0.2 * random.next()));
            let upright = [2.0, 690.0, 300.0];
            let bars: Vec<[&str; 2]> = if template == "five-link" {
                ["upper_front", "upper_back", "lower_front", "lower_back"]
                    .iter()
                    .map(|link| match *link {
                        "upper_front" => ["upper_front_link_chassis", "upper_front_link_outer"],
                        "upper_back" => ["upper_back_link_chassis", "upper_back_link_outer"],
                        "lower_front" => ["lower_front_link_chassis", "lower_front_link_outer"],
                        _ => ["lower_back_link_chassis", "lower_back_link_outer"],
                    })
                    .collect()
            } else {
                vec![
                    ["upper_front", "upper_ball"],
                    ["upper_back", "upper_ball"],
                    ["lower_front", "lower_ball"],
                    ["lower_back", "lower_ball"],
                ]
            };
            let wheel = points["wheel_centre"];
            let mut text = format!(
                "// a car\n[BODY]\nname=body mass=(0.0) inertia=(0.0,0.0,0.0)\npos=(0.0,0.0,0.0) ori=(0.0,0.0,0.0)\n\
                 [BODY]\nname={corner}_spindle mass=({m_spindle:?}) inertia=(0.0275,0.026,0.0245)\npos={} ori=(0.0,0.0,0.0)\n\
                 [BODY]\nName={corner}_wheel mass=({m_wheel:?}) inertia=(1.2,0.7,0.65)\npos={} ori=(0.0,0.0,0.0)\n\
                 [JOINT&HINGE]\nposbody={corner}_wheel negbody={corner}_spindle pos={corner}_wheel axis=(-0.7,0.0,0.0)\n",
                at(upright),
                at(wheel)
            );
            for (k, [inner, outer]) in bars.iter().enumerate() {
                let (inner, outer) = (at(points[*inner]), at(points[*outer]));
                let ends = if k == 1 {
                    format!("posbody={corner}_spindle negbody=body pos={outer} neg={inner}")
                } else {
                    format!("posbody=body negbody={corner}_spindle pos={inner} neg={outer}")
                };
                let _ = writeln!(text, "[BAR] // a rod\n{ends}");
            }
            let (inner, outer) = (at(points["tie_rod_inner"]), at(points["tie_rod_outer"]));
            let _ = writeln!(
                text,
                "[BAR]\nname={corner}_steering posbody=body negbody={corner}_spindle pos={inner} neg={outer}"
            );
            folder.write("car.pm", &text);
            let mut sheet = format!(
                "template = \"{template}\"\nunit = \"mm\"\naxes = \"iso\"\nbuild = \"{}\"\n[points]\n",
                if is_right { "right" } else { "left" }
            );
            let of_file = |name: &str| {
                name == "wheel_centre"
                    || name.starts_with("tie_rod")
                    || bars.iter().flatten().any(|bar| *bar == name)
            };
            for (name, at) in points.iter().filter(|(name, _)| of_file(name)) {
                let _ = writeln!(sheet, "{name} = {at:?}");
            }
            let _ = writeln!(
                sheet,
                "[upright]\nmass = {m_spindle:?}\ncom = {upright:?}\ninertia = [0.0245, 0.0275, 0.026]\n[spindle]\nmass = 0\ninertia = [0, 0, 0]\n\
                 [wheel]\nmass = {m_wheel:?}\ninertia = [0.65, 1.2, 0.7]"
            );
            folder.write("car.toml", &sheet);
            let rear = if is_rear { "worksheet = \"rear\"\n" } else { "" };
            let side = if is_right { "side = \"right\"\n" } else { "" };
            folder.write("pm.toml", &format!("points = \"car.pm\"\n{rear}{side}"));
            let mass = |file: &str| -> f64 {
                let words = [
                    "mass",
                    file,
                    "--link",
                    "wheel_centre",
                    "--point",
                    "0.1,0.05,-0.2",
                    "--normal",
                    "0.2,0.3,1",
                    "--format",
                    "json",
                ];
                let report: Value = serde_json::from_str(&done(&folder, &words)).expect("JSON");
                report["effective_mass"].as_f64().expect("a mass")
            };
            let (found, expected) = (mass("pm.toml"), mass("car.toml"));
            // The points differ by roundings of some 1e-16 m.
            assert!((found / expected - 1.0).abs() < 1e-9, "{template} {case}: {found} {expected}");
            if !is_right && !is_rear {
                assert!((mass("car.pm") / expected - 1.0).abs() < 1e-9, "{template} {case}");
            }
        }
    }
}
