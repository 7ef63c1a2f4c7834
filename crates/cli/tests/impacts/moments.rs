//! Moments about an axis: inertias in kg·m² in every command, and refusals with a remedy.

use crate::support::{json, percuss};
use serde_json::Value;

/// Bound for the rounding of about ten operations on values of order 1.
const ROUNDING: f64 = 1e-12;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Inertia of the outer link of models/planar_2r.urdf about z, against the ground: det M/(M₁₁ − 2 M₁₂ + M₂₂), since j = (1, 1).
fn inertia(elbow: f64) -> f64 {
    let (a, b, c) = (5.0 / 6.0, 8.0 / 75.0, 0.2 * elbow.cos());
    let (m11, m12, m22) = (a + b + 2.0 * c + 0.3, b + c, b + 0.1);
    (m11 * m22 - m12 * m12) / (m11 - 2.0 * m12 + m22)
}

const OUTER: &str = "models/planar_2r.urdf --link outer --about-axis 0,0,2";

#[test]
fn masses_have_the_closed_form() {
    let report = json(&format!("mass {OUTER} --set elbow=0.7 --format json"));
    assert!((number(&report["effective_mass"]) / inertia(0.7) - 1.0).abs() < ROUNDING, "{report}");
    assert_eq!((&report["unit"], &report["contact"]["is_moment"]), (&"kg·m²".into(), &true.into()));
    assert_eq!(report["contact"]["normal_world"], serde_json::json!([0.0, 0.0, 1.0]));
    // Against the inner link: the inertia reflected to the elbow, equal to the effective inertia at the stop of the elbow.
    let against = json(&format!("mass {OUTER} --against inner --set elbow=0.7 --format json"));
    let stop = json("mass models/planar_2r.urdf --at elbow:upper --set elbow=0.7 --format json");
    let at_elbow = json(&format!(
        "impact {OUTER} --set elbow=0.7 --restitution 0 --speed 1 --reflected elbow --format json"
    ));
    let reflected = number(&at_elbow["reflected_inertia"][0]["free"]);
    for found in [&against, &stop] {
        assert!((number(&found["effective_mass"]) / reflected - 1.0).abs() < ROUNDING, "{found}");
    }
    // A pendulum about its hinge: m r². About a perpendicular axis it is immovable.
    let rod = "models/point_mass_pendulum.urdf --link rod";
    let pendulum = json(&format!("mass {rod} --about-axis 0,3,0 --expect 0.5 --format json"));
    assert!((number(&pendulum["effective_mass"]) - 0.5).abs() < ROUNDING);
    let text = percuss(&format!("mass {rod} --about-axis 1,0,0")).stdout;
    assert!(text.contains("immovable  no motion of the mechanism turns the link about"), "{text}");
    let text = percuss(&format!("mass {OUTER} --set elbow=0.7")).stdout;
    let words = "kg·m²  effective inertia of outer about (0, 0, 1), against the ground";
    assert!(text.contains(words), "{text}");
    // The frame of the axis.
    let tilted = "mass models/planar_2r.urdf --link outer --about-axis 1,0,1 --frame world --set elbow=0.7 --format json";
    assert!((number(&json(tilted)["effective_mass"]) / (2.0 * inertia(0.7)) - 1.0).abs() < ROUNDING);
}

#[test]
fn impacts_have_units_of_rotation() {
    let run = format!("impact {OUTER} --set elbow=0.7 --restitution 0.25 --speed 3rad/s");
    let report = json(&format!("{run} --format json"));
    assert!((number(&report["impulse"]) / (1.25 * 3.0 * inertia(0.7)) - 1.0).abs() < ROUNDING);
    // The sum of the rates is the angular velocity; the impact multiplies it by −e.
    let rates = report["rates"].as_array().expect("rates");
    let sum = |when: &str| rates.iter().map(|rate| number(&rate[when][0])).sum::<f64>();
    assert!((sum("before") - 3.0).abs() < ROUNDING && (sum("after") + 0.75).abs() < ROUNDING, "{report}");
    assert_eq!(report["mass_states"], serde_json::json!([]));
    assert!(report["sticking_mass"].is_null() && report["sticking_status"].is_null());
    let text = percuss(&run).stdout;
    for words in ["N·m·s  impulse", "rad/s, restitution 0.25", "effective inertia", "kg·m²  "] {
        assert!(text.contains(words), "{words}: {text}");
    }
    for words in ["sticking", "sliding", " kg  ", " m/s, restitution", " N·s  impulse"] {
        assert!(!text.contains(words), "{words}: {text}");
    }
    let text = percuss(&format!("{run} --stiffness 200Nm/rad --in-time")).stdout;
    for words in ["peak moment (Kelvin–Voigt, 200 N·m/rad)", " mrad ", "  contact time"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    // One freedom, a linear spring and no change of m̄: peak moment ω √(k m̄).
    let pendulum = "impact models/point_mass_pendulum.urdf --link rod --about-axis 0,1,0 --restitution 1 --speed 0.1 \
                    --stiffness 200 --in-time --format json";
    let report = json(pendulum);
    let expected = 0.1 * (200.0_f64 * 0.5).sqrt();
    assert!((number(&report["contact_law"]["peak_force"]) / expected - 1.0).abs() < 1e-9, "{report}");
    assert!((number(&report["in_time"]["peak_force"]) / expected - 1.0).abs() < 1e-6, "{report}");
}

#[test]
fn extremes_are_those_of_the_closed_form() {
    let report = json(&format!("extremes {OUTER} --range elbow=0:3.1 --format json"));
    let all: Vec<f64> = (0..=31_000).map(|k| inertia(1e-4 * f64::from(k))).collect();
    let (least, most) = all.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), m| (a.min(*m), b.max(*m)));
    assert!((number(&report["least"]["value"]) / least - 1.0).abs() < 1e-7, "{report}");
    assert!((number(&report["most"]["value"]) / most - 1.0).abs() < 1e-7, "{report}");
    assert_eq!((&report["unit"], &report["is_moment"]), (&"kg·m²".into(), &true.into()));
    let text = percuss(&format!("extremes {OUTER} --range elbow=0:3.1")).stdout;
    assert!(text.contains("kg·m²") && !text.contains(" kg\n"), "{text}");
    let bearing =
        percuss(&format!("extremes {OUTER} --range elbow=0.5:3.1 --quantity bearing:shoulder")).stdout;
    assert!(bearing.contains("N·s in shoulder per rad/s"), "{bearing}");
    // Any axis: the arm turns about z only.
    let any = json(&format!("extremes {OUTER} --range elbow=0.5:1 --normals any --format json"));
    assert!(number(&any["least"]["normal_world"][2]).abs() > 1.0 - 1e-9, "{any}");
}

#[test]
fn other_commands_follow() {
    let rows = percuss(&format!("sweep {OUTER} --vary elbow=0:1:3")).stdout;
    for (line, elbow) in rows.lines().skip(1).zip([0.0, 0.5, 1.0]) {
        let mass: f64 = line.split(',').nth(3).expect("a mass").parse().expect("a number");
        assert!((mass / inertia(elbow) - 1.0).abs() < ROUNDING, "{line}");
    }
    let named = percuss(&format!("sweep {OUTER} --vary elbow=0deg:60deg:3 --unit deg")).stdout;
    assert!(named.lines().next().expect("a header").contains("effective_mass_kg·m²"), "{named}");
    let damper = percuss(&format!(
        "damp --mass-from {OUTER} --set elbow=0.7 --stiffness 200Nm/rad --restitution 0.3 --speed 1rad/s"
    ));
    for words in ["effective inertia", "kg·m²", "N·m·s/rad", "rad/s", "mrad"] {
        assert!(damper.stdout.contains(words), "{words}: {}", damper.stdout);
    }
    assert!(!damper.stdout.contains("contact link alone"), "{}", damper.stdout);
    let stop = percuss(
        "damp --mass-from models/planar_2r.urdf --limit elbow --set elbow=0.7 --stiffness 200Nm/rad --restitution 0.3",
    );
    assert_eq!(stop.code, 0, "{}", stop.stderr);
    let compare = percuss(
        "compare models/planar_2r.urdf models/planar_2r.urdf --link outer --about-axis 0,0,1 --set elbow=0.7",
    );
    assert!(compare.stdout.contains("kg·m²"), "{}{}", compare.stdout, compare.stderr);
}
