//! Suspensions with unequal sides: each side has the values of a sheet of its own points, in every form of input.

use crate::support::{Random, Scratch, done, run_in as run};
use serde_json::Value;
use std::collections::BTreeMap;

type Points = BTreeMap<String, [f64; 3]>;

/// Points of a template, mm, each coordinate displaced by at most `most`.
fn points(folder: &Scratch, template: &str, random: &mut Random, most: f64) -> Points {
    let text = done(folder, &["template", template]);
    let section =
        text.split("\n[points]\n").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("points");
    let point = |line: &str| {
        let (key, rest) = line.split_once(" = [")?;
        let numbers: Vec<f64> =
            rest.split(']').next()?.split(", ").map(|x| x.parse().expect("a number")).collect();
        let at = [0, 1, 2].map(|k| ((numbers[k] + most * random.next()) * 1e3).round() / 1e3);
        Some((key.to_owned(), at))
    };
    section.lines().filter_map(point).collect()
}

/// The template's example with these points, for one side.
fn sheet(text: &str, points: &Points, build: &str) -> String {
    let (head, rest) = text.split_once("\n[points]\n").expect("points");
    let (_, bodies) = rest.split_once("\n\n").expect("bodies");
    let rows: String = points.iter().map(|(name, at)| format!("{name} = {at:?}\n")).collect();
    let head = head.replace("build = \"left\"", &format!("build = \"{build}\""));
    let spring = bodies
        .replace("[spring]\n", "[spring]\nrate = \"25 N/mm\"\npreload = 2500\n")
        .replace("[anti_roll_bar]\n", "[anti_roll_bar]\nstiffness = \"700 N·m/rad\"\n");
    format!("{head}\n[points]\n{rows}\n{spring}")
}

fn mirrored(at: [f64; 3]) -> [f64; 3] {
    [at[0], -at[1], at[2]]
}

fn rows(folder: &Scratch, file: &str, more: &[&str]) -> Vec<Value> {
    let words = [&["kinematics", file, "--format", "json"], more].concat();
    let report: Value = serde_json::from_str(&done(folder, &words)).expect("JSON");
    report["rows"].as_array().expect("rows").clone()
}

/// Effective masses at all contacts by name.
fn masses(folder: &Scratch, file: &str) -> BTreeMap<String, f64> {
    let report = done(folder, &["mass", file, "--at", "all", "--format", "json"]);
    let report: Value = serde_json::from_str(&report).expect("JSON");
    let contacts = report["contacts"].as_array().expect("contacts").iter();
    contacts
        .filter_map(|one| Some((one["name"].as_str()?.to_owned(), one["report"]["effective_mass"].as_f64()?)))
        .collect()
}

/// Names of quantities of both sides, or of the motion of both sides.
fn is_of_axle(name: &str) -> bool {
    name.starts_with("roll_centre") || name.starts_with("anti_roll_bar") || name == "unsprung_mass"
}

/// Both sides of the file have the kinematics of `left` and `right`, over the travel in heave.
fn assert_sides(folder: &Scratch, file: &str, [left, right]: [&str; 2], what: &str) {
    let range = ["--heave", "-20mm:20mm:3"];
    let both = rows(folder, file, &range);
    let mut compared = 0;
    for (side, own) in [("left", left), ("right", right)] {
        for (row, own) in both.iter().zip(rows(folder, own, &range)) {
            for (name, value) in own.as_object().expect("a row") {
                let Some(value) = value.as_f64().filter(|_| !is_of_axle(name) && name != "variable") else {
                    continue;
                };
                let found = row[format!("{name}_{side}")].as_f64();
                let found = found.unwrap_or_else(|| panic!("{what}: {name}_{side} in {row}"));
                // Two mechanisms of the same points, closed to some 1e-13 m.
                assert!(
                    (found - value).abs() <= 1e-8 * value.abs().max(1.0),
                    "{what} {name}_{side}: {found} {value}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 60, "{what}: {compared}");
}

/// A family of unequal sides: a section `[points.right]`, columns beside each other, names with their side, the sheet of the right side, other
/// axes; against two sheets of one side each.
#[test]
fn each_side_has_the_values_of_its_own_sheet() {
    let folder = Scratch::new("unequal-sides");
    let mut random = Random(23);
    let mut count = 0;
    for template in [
        "double-wishbone",
        "macpherson-strut",
        "multi-link",
        "five-link",
        "pushrod-rocker",
        "semi-trailing-arm",
    ] {
        let text = done(&folder, &["template", template]);
        let left = points(&folder, template, &mut random, 4.0);
        let mut right = points(&folder, template, &mut random, 4.0);
        // Some points are mirror images.
        for (name, at) in right.iter_mut().step_by(3) {
            *at = left[name];
        }
        folder.write("left.toml", &sheet(&text, &left, "left"));
        folder.write("right.toml", &sheet(&text, &right, "left"));
        let differs = |name: &str| left[name] != right[name];
        // A section of the other side.
        let own: String = right
            .iter()
            .filter(|(name, _)| differs(name))
            .map(|(name, at)| format!("{name} = {:?}\n", mirrored(*at)))
            .collect();
        let both = sheet(&text, &left, "both");
        folder.write("section.toml", &format!("{both}\n[points.right]\n{own}"));
        assert_sides(&folder, "section.toml", ["left.toml", "right.toml"], &format!("{template} section"));
        // The masses of each side alone are those of its own sheet: the chassis is fixed, and the rack too.
        let [of_left, of_right, of_both] =
            ["left.toml", "right.toml", "section.toml"].map(|file| masses(&folder, file));
        for (side, own) in [("left", &of_left), ("right", &of_right)] {
            for (name, mass) in own {
                let found = of_both[&format!("{name}_{side}")];
                assert!((found / mass - 1.0).abs() < 1e-9, "{template} {name}_{side}: {found} {mass}");
            }
        }
        assert!((of_left["contact_patch"] / of_right["contact_patch"] - 1.0).abs() > 1e-6, "{template}");
        // Columns beside each other, and the points of the sheet on the right side.
        let cells = |[x, y, z]: [f64; 3]| format!("{x:?},{y:?},{z:?}");
        let line = |(name, at): (&String, &[f64; 3])| {
            format!("{name},{},{}\n", cells(*at), cells(mirrored(right[name])))
        };
        let table: String = left.iter().map(line).collect();
        folder.write("table.csv", &format!("name,XL,YL,ZL,XR,YR,ZR\n{table}"));
        let with_table = |side: &str, build: &str, table: &str| {
            let (head, rest) = both.split_once("\n[points]\n").expect("points");
            let (_, bodies) = rest.split_once("\n\n").expect("bodies");
            let head = head
                .replacen("\ntemplate =", &format!("\npoints = \"{table}\"\ntemplate ="), 1)
                .replace("side = \"left\"", &format!("side = \"{side}\""))
                .replace("build = \"both\"", &format!("build = \"{build}\""));
            // Centres of mass of the left side.
            let mirror =
                |line: &str| match line.strip_prefix("com = [").and_then(|rest| rest.split_once(", ")) {
                    Some((x, rest)) if side == "right" => format!("com = [{x}, -{}", rest.trim_start()),
                    _ => line.to_owned(),
                };
            let mirror_inertia =
                |line: String| match line.strip_prefix("inertia = [").and_then(|rest| rest.split(']').next())
                {
                    Some(list) if side == "right" && list.split(", ").count() == 6 => {
                        let n: Vec<f64> = list.split(", ").map(|x| x.parse().expect("a number")).collect();
                        format!("inertia = {:?}", [n[0], n[1], n[2], -n[3], n[4], -n[5]])
                    }
                    _ => line,
                };
            let bodies: String = bodies.lines().map(|line| mirror_inertia(mirror(line)) + "\n").collect();
            format!("{head}\n{bodies}")
        };
        for side in ["left", "right"] {
            folder.write("table.toml", &with_table(side, "both", "table.csv"));
            assert_sides(
                &folder,
                "table.toml",
                ["left.toml", "right.toml"],
                &format!("{template} columns {side}"),
            );
        }
        // Names with their side.
        let named: String = left
            .iter()
            .flat_map(|(name, at)| {
                [format!("{name} L,{}\n", cells(*at)), format!("{name} R,{}\n", cells(mirrored(right[name])))]
            })
            .collect();
        folder.write("named.csv", &format!("name,x,y,z\n{named}"));
        folder.write("named.toml", &with_table("left", "both", "named.csv"));
        assert_sides(&folder, "named.toml", ["left.toml", "right.toml"], &format!("{template} names"));
        // One side only: a warning in place of the other side.
        folder.write("one.toml", &with_table("left", "left", "table.csv"));
        let outcome = run(&folder, &["kinematics", "one.toml"]);
        assert!(
            outcome.code == 0 && outcome.stderr.contains("build = \"both\" uses these points"),
            "{}",
            outcome.stderr
        );
        count += 1;
    }
    assert_eq!(count, 6);
}

/// The roll centre of unequal sides is the intersection of the lines from the contact points to the instant centres of both wheels.
#[test]
fn the_roll_centre_is_that_of_both_instant_centres() {
    let folder = Scratch::new("unequal-roll-centre");
    let mut random = Random(29);
    for case in 0..4 {
        let text = done(&folder, &["template", "double-wishbone"]);
        let left = points(&folder, "double-wishbone", &mut random, 6.0);
        let right = points(&folder, "double-wishbone", &mut random, 6.0);
        let own: String = right.iter().map(|(name, at)| format!("{name} = {:?}\n", mirrored(*at))).collect();
        folder.write("car.toml", &format!("{}\n[points.right]\n{own}", sheet(&text, &left, "both")));
        let row = &rows(&folder, "car.toml", &[])[0];
        let number = |name: &str| row[name].as_f64().unwrap_or_else(|| panic!("{name} in {row}"));
        // Slopes dz/dy of the lines, inward positive; the contact points are below the wheel centres by the radius of 300 mm.
        let line = |side: &str, points: &Points, sign: f64| {
            let slope = number(&format!("instant_centre_height_{side}"))
                / number(&format!("instant_centre_distance_{side}"));
            let wheel = points["wheel_centre"];
            (sign * wheel[1] / 1e3, (wheel[2] - 300.0) / 1e3, -sign * slope)
        };
        let (yl, zl, sl) = line("left", &left, 1.0);
        let (yr, zr, sr) = line("right", &right, -1.0);
        let y = (zr - zl + sl * yl - sr * yr) / (sl - sr);
        let z = zl + sl * (y - yl);
        let ground = zl + (y - yl) * (zr - zl) / (yr - yl);
        assert!((number("roll_centre_lateral") - y).abs() < 1e-9 * y.abs().max(1.0), "{case} {y} {row}");
        assert!((number("roll_centre_height") - (z - ground)).abs() < 1e-9, "{case} {z} {row}");
        // The track is the sum of both distances.
        let check = done(&folder, &["import", "car.toml", "-o", "car.urdf", "--force"]);
        let track = format!("{:.1}", left["wheel_centre"][1] + right["wheel_centre"][1]);
        assert!(check.contains(&track), "{track}: {check}");
    }
}

/// Moves of a point of the other side, the search for it and the changed file act on this side alone; mirror images change nothing.
#[test]
fn points_of_the_other_side_are_moved_and_written() {
    let folder = Scratch::new("unequal-moves");
    let text = done(&folder, &["template", "double-wishbone"]);
    let mut random = Random(31);
    let left = points(&folder, "double-wishbone", &mut random, 0.0);
    let base = sheet(&text, &left, "both");
    folder.write("equal.toml", &base);
    let all: String = left.iter().map(|(name, at)| format!("{name} = {:?}\n", mirrored(*at))).collect();
    folder.write("mirrored.toml", &format!("{base}\n[points.right]\n{all}"));
    assert_eq!(rows(&folder, "mirrored.toml", &[]), rows(&folder, "equal.toml", &[]));
    let mut at = mirrored(left["upper_ball"]);
    at[2] += 3.0;
    folder.write(
        "car.toml",
        &format!("{base}\n# the right side\n[points.right]\nupper_ball = {at:?}  # longer\n"),
    );
    let found = rows(&folder, "car.toml", &["--columns", "camber_gradient"]);
    let moved =
        rows(&folder, "car.toml", &["--columns", "camber_gradient", "--move", "right.upper_ball=0,0,-3mm"]);
    let equal = rows(&folder, "equal.toml", &["--columns", "camber_gradient"]);
    let [of_found, of_moved, of_equal] = [&found, &moved, &equal].map(|rows| {
        ["left", "right"].map(|side| rows[0][format!("camber_gradient_{side}")].as_f64().expect("a value"))
    });
    assert!(
        (of_found[0] - of_equal[0]).abs() < 1e-9 && (of_found[1] - of_equal[1]).abs() > 1e-3,
        "{of_found:?}"
    );
    assert!((of_moved[1] - of_equal[1]).abs() < 1e-9, "{of_moved:?} {of_equal:?}");
    // The search writes the section of the right side alone.
    let target = format!("camber_gradient_right={:?}deg/m", of_equal[1].to_degrees());
    done(
        &folder,
        &["kinematics", "car.toml", "--solve", "right.upper_ball.z", "--for", &target, "-o", "new.toml"],
    );
    let [old, new] =
        ["car.toml", "new.toml"].map(|file| std::fs::read_to_string(folder.path(file)).expect("a text"));
    let changed: Vec<&str> =
        new.lines().zip(old.lines()).filter(|(new, old)| new != old).map(|(new, _)| new).collect();
    assert!(changed.len() == 1 && changed[0].ends_with("  # longer"), "{changed:?}");
    let again = rows(&folder, "new.toml", &["--columns", "camber_gradient"]);
    // The accuracy of the search, 1e-8 of a degree per metre.
    assert!((again[0]["camber_gradient_right"].as_f64().expect("a value") - of_equal[1]).abs() < 1e-8);
    for (section, words) in [
        ("lower_bal = [0, -700, 180]", "no point \"lower_bal\" of a side; did you mean lower_ball?"),
        ("lower_ball = [5, 720, 180]", "change the sign"),
        ("lower_ball = [5, -720]", "3 expected"),
    ] {
        folder.write("car.toml", &format!("{base}\n[points.right]\n{section}\n"));
        let outcome = run(&folder, &["check", "car.toml"]);
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && told.contains(words), "{section}: {told}");
    }
}
