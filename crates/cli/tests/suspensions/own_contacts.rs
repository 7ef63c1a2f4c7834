//! Contacts that a sheet names itself; axes of a sheet; forces outside the data of a sheet.

use crate::support::{Scratch, done, run_in as run};
use serde_json::Value;

const CONTACTS: &str = "
[contact.skid]
point = [30.0, 600.0, 100.0]
on = \"lower_arm\"
direction = [0.0, 3.0, 4.0]
[contact.frame_stop]
point = [30.0, 600.0, 250.0]
on = \"lower_arm\"
direction = [0.0, 0.0, 2.0]
against = \"chassis\"
gap = 40.0
";

fn report(folder: &Scratch, words: &str) -> Value {
    let words: Vec<&str> = words.split_whitespace().chain(["--format", "json"]).collect();
    serde_json::from_str(&done(folder, &words)).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn mass(folder: &Scratch, words: &str) -> f64 {
    number(&report(folder, words)["effective_mass"])
}

/// Warnings of a command that succeeds, on one line.
fn told(folder: &Scratch, words: &str) -> String {
    let outcome = run(folder, &words.split_whitespace().collect::<Vec<_>>());
    assert_eq!(outcome.code, 0, "{words}: {}", outcome.stderr);
    outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A contact of the sheet is the contact of the same link, point and normal given by flags, on either side and in either axes.
#[test]
fn contacts_of_a_sheet_are_those_of_the_flags() {
    let folder = Scratch::new("own-contacts");
    let text = done(&folder, &["template", "double-wishbone"]) + CONTACTS;
    folder.write("car.toml", &text);
    // The frame of the arm is at the point lower_front of the template.
    let by_flags = "--link lower_arm --point -0.15,0.22,-0.09 --normal 0,0.6,0.8";
    let skid = mass(&folder, "mass car.toml --at skid");
    let flags = mass(&folder, &format!("mass car.toml {by_flags}"));
    assert!((skid / flags - 1.0).abs() < 1e-12, "{skid} and {flags}");
    let stop = report(&folder, "mass car.toml --at frame_stop");
    assert_eq!(stop["named_contact"]["kind"], "stop");
    assert!((number(&stop["contact"]["point_world"][2]) - 0.29).abs() < 1e-9, "the point rises by the gap");
    // The same car, turned by 180° about z.
    let turned = |line: &str| match line.split_once("= [").filter(|(key, _)| !key.starts_with('#')) {
        Some((key, numbers)) => {
            let (numbers, rest) = numbers.split_once(']').expect("a list");
            let mut n: Vec<f64> = numbers.split(',').map(|x| x.trim().parse().expect("a number")).collect();
            // Coordinates x and y, and the products of inertia xz and yz, change their signs.
            let flipped = match (key.contains("inertia"), n.len()) {
                (false, _) => 0..2,
                (true, 6) => 4..6,
                (true, _) => 0..0,
            };
            n[flipped].iter_mut().for_each(|x| *x = 0.0 - *x);
            format!("{key}= {n:?}{rest}")
        }
        None => line.replace("axes = \"iso\"", "axes = \"adams\""),
    };
    folder.write("turned.toml", &text.lines().map(turned).collect::<Vec<_>>().join("\n"));
    folder.write("both.toml", &text.replace("build = \"left\"", "build = \"both\""));
    for (file, contact) in [("turned.toml", "skid"), ("both.toml", "skid_left"), ("both.toml", "skid_right")]
    {
        let found = mass(&folder, &format!("mass {file} --at {contact}"));
        assert!((found / skid - 1.0).abs() < 1e-11, "{file} {contact}: {found} and {skid}");
    }
    let axle = done(&folder, &["template", "solid-axle-panhard"])
        + "\n[contact.link]\npoint = [0.0, 300.0, 200.0]\non = \"axle\"\ndirection = [0.0, 0.0, 1.0]\n";
    folder.write("axle.toml", &axle);
    let at = |side: &str| {
        let point = report(&folder, &format!("mass axle.toml --at link_{side}"));
        number(&point["contact"]["point_world"][1])
    };
    assert_eq!([at("left"), at("right")], [0.3, -0.3]);
    for (from, into, message) in [
        (
            "on = \"lower_arm\"\ndirection = [0.0, 3.0",
            "on = \"lower_am\"\ndirection = [0.0, 3.0",
            "did you mean lower_arm",
        ),
        ("point = [30.0, 600.0, 100.0]\n", "", "contact.skid.point: the key is missing"),
        ("gap = 40.0\n", "gab = 40.0\n", "did you mean \"contact.frame_stop.gap\""),
        ("[0.0, 3.0, 4.0]", "[0.0, 0.0, 0.0]", "the direction is zero"),
        ("against = \"chassis\"", "against = \"frame\"", "no link \"frame\""),
        ("[contact.skid]", "[contact.bump_stop]", "bump_stop"),
    ] {
        assert!(text.contains(from), "{from}");
        folder.write("wrong.toml", &text.replacen(from, into, 1));
        let outcome = run(&folder, &["mass", "wrong.toml", "--at", "frame_stop"]);
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && told.contains(message), "{into}: {told}");
    }
}

/// Templates without a point that lies in front of another one on every vehicle.
const AXLES_ON_LINKS: [&str; 4] =
    ["solid-axle-four-links", "solid-axle-panhard", "solid-axle-watt", "solid-axle-de-dion"];

/// A motion ratio is per travel of the wheel relative to the chassis, also for a contact against an arm that moves.
#[test]
fn ratios_of_contacts_against_moving_links_are_those_of_the_kinematics() {
    let folder = Scratch::new("moving-links");
    for slides in ["false", "true"] {
        let text = done(&folder, &["template", "double-wishbone"])
            .replace("slides = false", &format!("slides = {slides}"))
            + "
[contact.side]
point = [10.0, 700.0, 250.0]
on = \"upright\"
direction = [0.2, 1.0, 0.1]
against = \"lower_arm\"
gap = 25.0
";
        folder.write("car.toml", &text);
        let travel = "--travel wheel-travel=20mm";
        let listed = report(&folder, &format!("mass car.toml --at side {travel}"));
        let ratio = &listed["motion_ratios"][0];
        let rows = report(&folder, "kinematics car.toml --wheel-travel 20mm --columns side.motion_ratio");
        let expected = number(&rows["rows"][0]["motion_ratio_side"]);
        let found = number(&ratio["contact_per_wheel"]);
        assert!((found / expected - 1.0).abs() < 1e-9, "{slides}: {found}, {expected}");
        assert_eq!(ratio["held"].is_string(), slides == "true");
    }
}

/// Questions that have a right answer that the user did not mean are refused, and mistakes in a sheet are named.
#[test]
fn ambiguous_questions_are_refused() {
    let folder = Scratch::new("ambiguous");
    let text = done(&folder, &["template", "double-wishbone"]);
    folder.write("car.toml", &text);
    let search = "kinematics car.toml --solve tie_rod_inner.z --within 20mm --for";
    for (words, message) in [
        ("mass car.toml --at bump_stop --wheel-travel 30mm --heave 20mm".to_owned(), "both move the wheel"),
        (format!("{search} toe=0.01"), "write 0.01deg"),
        (format!("{search} scrub_radius=1"), "write 1mm"),
        (format!("{search} toe_gradient=-3deg"), "a number in deg/m is expected"),
        ("kinematics car.toml --solve spring_seat.z --for camber=1deg".to_owned(), "has no influence"),
        ("mass car.toml --at bump_stop,spring".to_owned(), "percuss compare MODEL --at bump_stop,spring"),
        ("sweep car.toml --at all --wheel-travel 0:10mm:2".to_owned(), "percuss compare MODEL --at all"),
    ] {
        let outcome = run(&folder, &words.split_whitespace().collect::<Vec<_>>());
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && told.contains(message), "{words}: {told}");
    }
    let gradient = report(&folder, &format!("{search} toe_gradient=-3deg/m"));
    assert!((number(&gradient["targets"][0]["reached"]).to_degrees() + 3.0).abs() < 1e-6, "{gradient}");
    let swapped = |one: &str, other: &str| {
        text.replace(&format!("\n{one} ="), "\n_ =")
            .replace(&format!("\n{other} ="), &format!("\n{one} ="))
            .replace("\n_ =", &format!("\n{other} ="))
    };
    let curve = |forces: &str| {
        text.replace("[bump_stop]\n", &format!("[bump_stop]\ndeflections = [0, 9, 30]\nforces = {forces}\n"))
    };
    for (changed, code, message) in [
        (swapped("tie_rod_inner", "tie_rod_outer"), 0, "nearer to the middle of the vehicle"),
        (curve("[0, 900, 800]"), 0, "the force decreases from 900 N to 800 N"),
        (curve("[0, -90, -800]"), 2, "numbers of 0 or more are expected"),
        (text.replace("[upright]\nmass = 5.6", "[upright]"), 2, "upright.mass: the key is missing"),
        (text.clone() + &CONTACTS.replace("contact.skid", "contact.all"), 2, "choose another name"),
        (text.clone() + &CONTACTS.replace("gap = 40.0", "gap = 0"), 0, "the gap is 0"),
        (
            text.clone() + &CONTACTS.replace("[30.0, 600.0, 100.0]", "[30.0, -600.0, 100.0]"),
            0,
            "is on the other side of the vehicle than the wheel",
        ),
    ] {
        assert!(changed != text, "{message}");
        folder.write("wrong.toml", &changed);
        let outcome = run(&folder, &["check", "wrong.toml"]);
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == code && told.contains(message), "{message}: {told}");
        assert!(!told.contains("upright.com"), "{told}");
    }
}

/// The kinematics of a study begin at its pose; a wheel does not spin while it travels.
#[test]
fn kinematics_of_a_study_have_its_pose() {
    let folder = Scratch::new("kinematics-pose");
    let kerb = "[contact.kerb]\npoint = [150, 760, 40]\non = \"spindle\"\ndirection = [-0.5, 0, -1]\nagainst = \"ground\"\n";
    folder.write("car.toml", &(done(&folder, &["template", "double-wishbone"]) + kerb));
    let study = "[model]\npath = \"car.toml\"\n[contact]\nat = \"spring\"\n[pose]\ntravel = [\"wheel-travel=20mm\"]\n\
                 [kinematics]\nvary = \"steer=-5mm:5mm:3\"\noutput = \"rows.csv\"\n";
    folder.write("study.toml", study);
    done(&folder, &["run", "study.toml", "--force"]);
    let words = ["kinematics", "car.toml", "--wheel-travel", "20mm", "--steer=-5mm:5mm:3", "--format", "csv"];
    let rows = std::fs::read_to_string(folder.path("rows.csv")).expect("rows");
    assert_eq!(rows, done(&folder, &words));
    // With the spin locked, the motion of the wheel is the only one.
    let locked = report(&folder, "mass car.toml --at kerb --lock spin");
    let expected = number(&locked["motion_ratios"][0]["contact_per_wheel"]);
    told(&folder, "sweep car.toml --at kerb --wheel-travel 0:10mm:2 --output kerb.json");
    let swept = std::fs::read_to_string(folder.path("kerb.json")).expect("a report");
    let swept: Value = serde_json::from_str(&swept).expect("JSON");
    let found = number(&swept["rows"][0]["motion_ratio"]);
    assert!((found / expected - 1.0).abs() < 1e-9, "{found}, {expected}");
}

/// Axes and side that are both wrong turn the car by 180°: masses remain, but caster and anti-dive change their signs.
#[test]
fn reversed_axes_are_warned_of() {
    let folder = Scratch::new("reversed-axes");
    let listed = done(&folder, &["template", "--list"]);
    let names =
        listed.lines().filter_map(|line| line.split_whitespace().next().filter(|_| !line.starts_with(' ')));
    let mut compared = 0;
    for template in names.filter(|name| !AXLES_ON_LINKS.contains(name)) {
        let text = done(&folder, &["template", template]);
        folder.write("car.toml", &text);
        let right = text.replace("side = \"left\"", "side = \"right\"");
        folder.write("turned.toml", &right.replace("axes = \"iso\"", "axes = \"adams\""));
        let as_written = told(&folder, "check car.toml");
        assert!(!as_written.contains("lies behind"), "{template}: {as_written}");
        let turned = told(&folder, "check turned.toml");
        let remedy = ["lies behind", "Write axes = \"iso\""];
        assert!(remedy.iter().all(|words| turned.contains(words)), "{template}: {turned}");
        let has_sides =
            !["swing-arm", "telescopic-fork"].contains(&template) && !template.starts_with("rear-");
        assert_eq!(turned.contains("side = \"left\""), has_sides, "{template}: {turned}");
        compared += 1;
    }
    // The links of a solid axle may lie before or behind the axle.
    assert_eq!(compared, 21 - AXLES_ON_LINKS.len());
}

/// Forces beyond the curve of a stop, and of a spring longer than its free length, are warned of with the first row.
#[test]
fn forces_beyond_the_data_of_a_sheet_are_warned_of() {
    let folder = Scratch::new("beyond-data");
    let text = done(&folder, &["template", "double-wishbone"]);
    let with = |sections: &[(&str, &str)]| {
        let add = |text: String, (section, keys): &(&str, &str)| {
            text.replacen(&format!("[{section}]\n"), &format!("[{section}]\n{keys}"), 1)
        };
        folder.write("car.toml", &sections.iter().fold(text.clone(), add));
    };
    let spring = |preload: f64| format!("rate = \"40 N/mm\"\npreload = {preload}\n");
    let stop = "deflections = [0.0, 5.0, 12.0]\nforces = [0.0, 300.0, 2500.0]\n";
    let travel = "kinematics car.toml --wheel-travel -100mm:90mm:20";
    with(&[("spring", &spring(800.0)), ("bump_stop", stop)]);
    let told_of = told(&folder, travel);
    let rows = report(&folder, travel);
    let value = |key: &str| -> Vec<(f64, f64)> {
        let rows = rows["rows"].as_array().expect("rows").iter();
        rows.map(|row| (number(&row["variable"]), number(&row[key]))).collect()
    };
    let pulling: Vec<_> = value("force_spring").into_iter().filter(|(_, force)| *force < 0.0).collect();
    let beyond: Vec<_> = value("force_bump_stop").into_iter().filter(|(_, force)| *force > 2500.0).collect();
    for (name, found) in [("spring", &pulling), ("bump_stop", &beyond)] {
        let (at, force) = found.first().expect("a row outside the data");
        let mut words = vec![format!("{name}: the force"), format!("{force:.0} N at {:.2} mm", 1e3 * at)];
        words.extend((found.len() > 1).then(|| format!("({} rows)", found.len())));
        words
            .iter()
            .map(|words| words.replace('-', "−"))
            .for_each(|words| assert!(told_of.contains(&words), "{words}: {told_of}"));
    }
    with(&[
        ("spring", &spring(8000.0)),
        ("bump_stop", "deflections = [0.0, 90.0]\nforces = [0.0, 90000.0]\n"),
    ]);
    assert!(!told(&folder, travel).contains("the force"), "no row is outside these data");
}

/// A roll of the pose stays beside a range of heave; a travel of the same motion does not.
#[test]
fn a_constant_roll_remains_beside_a_range_of_heave() {
    let folder = Scratch::new("roll-beside-heave");
    folder.write("axle.toml", &done(&folder, &["template", "solid-axle-panhard"]));
    let of_study = |travel: &str| {
        let study = format!(
            "[model]\npath = \"axle.toml\"\n[contact]\nat = \"spring_left\"\n[pose]\ntravel = [\"{travel}\"]\n\
             [sweep]\nvary = \"heave=-40mm:40mm:3\"\noutput = \"study.csv\"\n"
        );
        folder.write("study.toml", &study);
        let note = told(&folder, "run study.toml --force --notes");
        (std::fs::read_to_string(folder.path("study.csv")).expect("rows"), note)
    };
    let by_flags = |flags: &str| {
        let words = format!(
            "sweep axle.toml --at spring_left --heave -40mm:40mm:3 {flags} --output flags.csv --force"
        );
        told(&folder, &words);
        std::fs::read_to_string(folder.path("flags.csv")).expect("rows")
    };
    let (level, rolled) = (by_flags(""), by_flags("--travel roll=30mm"));
    assert!(level != rolled);
    assert_eq!(of_study("roll=30mm").0, rolled);
    let (rows, note) = of_study("heave=30mm");
    assert_eq!(rows, level);
    assert!(note.contains("[pose] travel = heave=0.03 applies to the contact at its pose"), "{note}");
}
