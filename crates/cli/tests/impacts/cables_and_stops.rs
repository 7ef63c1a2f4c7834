//! Cables and joint stops as contacts, alone and beside others.

use crate::support::{Scratch, json, percuss, root};
use serde_json::Value;

/// Rounding of some ten operations on values of order 1.
const ROUNDING: f64 = 1e-10;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Rate of a joint after an impact.
fn rate_after(rates: &Value, joint: &str) -> f64 {
    let all = rates.as_array().expect("rates");
    number(&all.iter().find(|rate| rate["joint"] == joint).expect("the joint")["after"][0])
}

/// Arm with links of 0.5 and 0.4 m at the angles 0 and 40°: position of the tip, and its velocity at given rates.
fn tip([shoulder, elbow]: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let (s, c) = 40_f64.to_radians().sin_cos();
    let at = [0.5 + 0.4 * c, 0.4 * s];
    let both = shoulder + elbow;
    (at, [-0.4 * s * both, 0.5 * shoulder + 0.4 * c * both])
}

const ARM: &str = "models/planar_2r.urdf --link outer --point 0.4,0,0 --set elbow=40deg";

/// A cable from the tip to a point of the ground: it closes while it gets longer, pulls, and keeps its length after a plastic impact.
#[test]
fn a_cable_keeps_its_length_and_pulls() {
    let end = [-0.3, 0.9];
    let [shoulder, elbow] = [-1.0, 0.5];
    let line = format!("--along-line ground:{},{},0 --cable", end[0], end[1]);
    let report = json(&format!(
        "impact {ARM} {line} --restitution 0 --rates shoulder={shoulder} --rates elbow={elbow} --format json"
    ));
    let (at, before) = tip([shoulder, elbow]);
    let from_end = [at[0] - end[0], at[1] - end[1]];
    let length = from_end[0].hypot(from_end[1]);
    let along = |v: [f64; 2]| (v[0] * from_end[0] + v[1] * from_end[1]) / length;
    assert!((number(&report["closing_speed"]) - along(before)).abs() < ROUNDING, "{report}");
    let after = ["shoulder", "elbow"].map(|joint| rate_after(&report["rates"], joint));
    assert!(along(tip(after).1).abs() < ROUNDING, "{after:?}");
    // The impulse −p n̂ on the arm points to the far end.
    let normal = report["mass"]["contact"]["normal_world"].as_array().expect("a normal");
    assert!((number(&normal[0]) - from_end[0] / length).abs() < ROUNDING, "{normal:?}");
    assert!(number(&report["impulse"]) > 0.0);
    // The effective mass is that of the same line under pressure.
    let pushed = line.replace("--cable", "--turning-normal");
    let masses = [&line, &pushed]
        .map(|line| number(&json(&format!("mass {ARM} {line} --format json"))["effective_mass"]));
    assert!((masses[0] / masses[1] - 1.0).abs() < ROUNDING, "{masses:?}");
    // A cable that gets shorter is slack.
    let slack =
        percuss(&format!("impact {ARM} {line} --restitution 0 --rates shoulder=1 --rates elbow=-0.5"));
    assert!(slack.code == 2 && slack.stderr.contains("open the gap"), "{}", slack.stderr);
    for (flags, words) in [
        (format!("mass {ARM} --normal 0,1,0 --cable"), "--along-line"),
        (format!("mass {ARM} {pushed} --cable"), "--turning-normal"),
    ] {
        let outcome = percuss(&flags);
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{flags}: {}", outcome.stderr);
    }
}

/// A cable and a joint stop beside a contact point: their masses are those of the cable alone and of the reflected inertia, their closing
/// speeds the rates of the length and of the joint; after the impact by Newton's law nothing closes.
#[test]
fn cables_and_stops_are_further_contacts() {
    let rates = "--restitution 0 --rates shoulder=0.4 --rates elbow=0.5";
    let report = json(&format!(
        "impact {ARM} --normal 0,1,0 {rates} --also outer:0.2,0,0=ground:0.6,-1,0 --also elbow:upper --reflected elbow --format json"
    ));
    let contacts = report["simultaneous"]["contacts"].as_array().expect("contacts");
    assert_eq!(contacts.len(), 3, "{report}");
    assert_eq!(
        (&contacts[1]["name"], &contacts[2]["name"]),
        (&"cable outer to ground".into(), &"stop of elbow".into())
    );
    let alone = json(
        "mass models/planar_2r.urdf --link outer --point 0.2,0,0 --set elbow=40deg --along-line ground:0.6,-1,0 --cable --format json",
    );
    assert!(
        (number(&contacts[1]["effective_mass"]) / number(&alone["effective_mass"]) - 1.0).abs() < ROUNDING
    );
    let reflected = number(&report["reflected_inertia"][0]["free"]);
    assert!((number(&contacts[2]["effective_mass"]) / reflected - 1.0).abs() < ROUNDING, "{reflected}");
    assert!((number(&contacts[2]["closing_speed"]) - 0.5).abs() < ROUNDING);
    // The diagonal of W has the reciprocal masses.
    let w = &report["simultaneous"]["delassus"];
    for (i, contact) in contacts.iter().enumerate() {
        let product = number(&w[3 * i][3 * i]) * number(&contact["effective_mass"]);
        assert!((product - 1.0).abs() < ROUNDING, "{i}: {product}");
    }
    let laws = report["simultaneous"]["laws"].as_array().expect("laws");
    for law in laws {
        let elbow = rate_after(&law["rates"], "elbow");
        // Opening of the stop: minus the rate of the joint. The energetic law ends at closing speeds of 1e-10.
        assert!((number(&law["opening_speeds"][2]) + elbow).abs() < 1e-9, "{law}");
        assert!(elbow < 1e-9, "{law}");
    }
    // A stop against the other direction opens.
    let lower = json(&format!("impact {ARM} --normal 0,1,0 {rates} --also elbow:lower --format json"));
    assert!((number(&lower["simultaneous"]["contacts"][1]["closing_speed"]) + 0.5).abs() < ROUNDING);
    for (also, words) in [
        ("elbows:upper", "elbow"),
        ("outer:0.2,0,0=nowhere:0,0,0", "nowhere"),
        ("outer:0.2,0,0=ground:0,0,0:1,0,0", "cable"),
        ("elbow:upper --sticking", "sticking contact point"),
    ] {
        let outcome = percuss(&format!("impact {ARM} --normal 0,1,0 {rates} --also {also}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{also}: {}", outcome.stderr);
    }
}

/// Points against another link and moments can be further contacts. Their masses are equal to those of the same contacts given by flags.
/// For the moment about the axis of a hinge, against the parent link, the closing speed is the rate of the hinge.
#[test]
fn points_between_links_and_moments_are_further_contacts() {
    let rates = "--restitution 0.3 --rates shoulder=0.4 --rates elbow=0.5";
    let also = "--also outer:0.4,0,0:0.6,0.8,0=inner --also outer:about:0,0,1=inner --also outer:about:0,0,2";
    let report = json(&format!("impact {ARM} --normal 0,1,0 {rates} {also} --format json"));
    let contacts = report["simultaneous"]["contacts"].as_array().expect("contacts");
    let flags = [
        "--point 0.4,0,0 --normal 0.6,0.8,0 --normal-frame world --against inner",
        "--about-axis 0,0,1 --against inner",
        "--about-axis 0,0,1",
    ];
    let names = ["outer against inner", "moment on outer against inner", "moment on outer"];
    for ((contact, flags), name) in contacts[1..].iter().zip(flags).zip(names) {
        let alone =
            json(&format!("mass models/planar_2r.urdf --link outer --set elbow=40deg {flags} --format json"));
        let ratio = number(&contact["effective_mass"]) / number(&alone["effective_mass"]);
        assert!((ratio - 1.0).abs() < ROUNDING, "{name}: {ratio}");
        assert_eq!((&contact["name"], &contact["is_moment"]), (&name.into(), &alone["contact"]["is_moment"]));
    }
    // Closing speeds: the rate of the hinge for the moment between the links, and the sum of both rates for the moment against the ground.
    assert!((number(&contacts[2]["closing_speed"]) - 0.5).abs() < ROUNDING, "{report}");
    assert!((number(&contacts[3]["closing_speed"]) - 0.9).abs() < ROUNDING, "{report}");
    // The same texts describe the first contact.
    for (text, flags) in also.split(" --also ").map(|text| text.trim_start_matches("--also ")).zip(flags) {
        let set = "models/planar_2r.urdf --set elbow=40deg";
        let at = json(&format!("mass {set} --at {text} --format json"));
        let given = json(&format!("mass {set} --link outer {flags} --format json"));
        let ratio = number(&at["effective_mass"]) / number(&given["effective_mass"]);
        assert!((ratio - 1.0).abs() < ROUNDING && at["unit"] == given["unit"], "{text}: {ratio}");
    }
    for (also, words) in [
        ("outer:0.4,0,0:0,1,0=nowhere", "nowhere"),
        ("outer:0.4,0,0:0,1,0=", "other side"),
        ("outer:about:0,0,1=inner:0,0,0", "other side"),
        ("outer:about:0,0", "LINK:about:X,Y,Z"),
        ("outer:about:0,0,0", "--also"),
        ("outer:about:0,0,1 --sticking", "a moment about an axis"),
        ("outer:0.2,0,0=ground:0.6,-1,0 --sticking", "a cable"),
    ] {
        let outcome = percuss(&format!("impact {ARM} --normal 0,1,0 {rates} --also {also}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{also}: {}", outcome.stderr);
    }
}

/// The position of the hinge follows from the loop, so the driving hinge moves it to its stop, on the branch of the drawing. A bisection
/// over positions of the driver finds the same pose.
#[test]
fn the_stop_of_a_dependent_joint_is_reached_by_the_driver() {
    let folder = Scratch::new("dependent-stop");
    let text = std::fs::read_to_string(root().join("models/four_bar.urdf")).expect("a model");
    let limited = |upper: f64| {
        let (before, after) = text.split_once("<joint name=\"rocker_hinge\"").expect("the joint");
        let limit = format!("<limit lower=\"-0.1\" upper=\"{upper}\" effort=\"1\" velocity=\"1\"/></joint>");
        let after = after.replacen("</joint>", &limit, 1).replacen("continuous", "revolute", 1);
        folder.write("limited.urdf", &format!("{before}<joint name=\"rocker_hinge\"{after}"))
    };
    let file = limited(0.3);
    let position = |report: &Value, joint: &str| report["pose"][joint][0].as_f64().expect("a position");
    for (end, limit) in [("upper", 0.3), ("lower", -0.1)] {
        let stop = json(&format!("mass {file} --at rocker_hinge:{end} --format json"));
        assert!((position(&stop, "rocker_hinge") - limit).abs() < 1e-10, "{stop}");
        let at = |crank: f64| {
            json(&format!(
                "mass {file} --link coupler --point 0.35,0.1,0 --normal 0,1,0 --set crank_hinge={crank} --format json"
            ))
        };
        let (mut low, mut high) = if limit > 0.0 { (0.0, 1.2) } else { (0.0, -0.4) };
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            let is_beyond = position(&at(middle), "rocker_hinge").abs() > f64::abs(limit);
            if is_beyond { high = middle } else { low = middle }
        }
        assert!((position(&stop, "crank_hinge") - low).abs() < 1e-9, "{end}: {low} {stop}");
        let set = json(&format!("mass {file} --at rocker_hinge:{end} --set crank_hinge={low} --format json"));
        let ratio = number(&set["effective_mass"]) / number(&stop["effective_mass"]);
        assert!(
            (ratio - 1.0).abs() < 1e-8 && !set["diagnostics"].to_string().contains("stop-not-reached"),
            "{ratio}"
        );
        let impact =
            json(&format!("impact {file} --at rocker_hinge:{end} --restitution 0.2 --speed 2 --format json"));
        assert_eq!(impact["mass"]["effective_mass"], stop["effective_mass"]);
    }
    let elsewhere =
        percuss(&format!("mass {file} --at rocker_hinge:upper --set crank_hinge=0.1 --format json"));
    assert!(elsewhere.stdout.contains("stop-not-reached"), "{}", elsewhere.stdout);
    let beyond = limited(2.9);
    let outcome = percuss(&format!("mass {beyond} --at rocker_hinge:upper"));
    assert!(
        outcome.code == 1 && outcome.stderr.contains("does not reach its stop at 2.9 rad"),
        "{}",
        outcome.stderr
    );
    assert!(outcome.stderr.contains("crank_hinge"), "{}", outcome.stderr);
    // One driver moves the rocker of the rover; two drivers move the cage of a differential.
    let rover = json("mass models/rocker_bogie.urdf --at right_rocker:upper --format json");
    let [left, right] = ["left_rocker", "right_rocker"].map(|joint| position(&rover, joint));
    assert!(right > 0.0 && (left + right).abs() < 1e-10, "{left} {right}");
    let link = |name: &str| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/><inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" \
             iyz=\"0\"/></inertial></link><joint name=\"{name}_hinge\" type=\"revolute\" independent=\"{}\"><parent link=\"ground\"/>\
             <child link=\"{name}\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"0.5\" effort=\"1\" velocity=\"1\"/></joint>",
            name != "cage"
        )
    };
    let links = ["left", "cage", "right"].map(link).concat();
    let relation = "<relation name=\"differential\"><joint name=\"left_hinge\" factor=\"0.5\"/>\
                    <joint name=\"cage_hinge\" factor=\"-1\"/><joint name=\"right_hinge\" factor=\"0.5\"/></relation>";
    let file = folder.write(
        "differential.urdf",
        &format!("<robot name=\"r\"><link name=\"ground\"/>{links}{relation}</robot>"),
    );
    let open = percuss(&format!("mass {file} --at cage_hinge:upper"));
    assert!(
        open.code == 2 && open.stderr.contains("left_hinge, right_hinge; set all of them except one"),
        "{}",
        open.stderr
    );
    let one = json(&format!("mass {file} --at cage_hinge:upper --set left_hinge=0.2 --format json"));
    assert!((position(&one, "right_hinge") - 0.8).abs() < 1e-10, "{one}");
}
