//! Cables and joint stops as contacts, alone and beside others.

use crate::support::{json, percuss};
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
        ("elbow:upper --sticking", "can stick"),
    ] {
        let outcome = percuss(&format!("impact {ARM} --normal 0,1,0 {rates} --also {also}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{also}: {}", outcome.stderr);
    }
}
