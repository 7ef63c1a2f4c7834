//! Relative change of m̄ over the penetration for pendulums whose point B at radius r hits a wall. With the
//! closing distance δ = r sin θ,
//!
//! m̄(δ)/m̄(0) − 1 = 1/(1 − (δ/r)²) − 1.
//!
//! A depth of r or more is unreachable, because the pendulum is then at a dead centre.

use percuss_formats::{LoadOptions, Source};
use percuss_study::{ContactTable, DampingQuestion, FrameName, MassQuestion, Model, damp_contact};
use rand::{Rng, SeedableRng, rngs::StdRng};

const PENDULUMS: u64 = 40;
/// Tolerance of m̄ at the depth, relative, times 1 − (δ/r)². The depth has an error of about 1e-5, and m̄ is
/// unbounded at the dead centre.
const AGREEMENT: f64 = 1e-4;

/// Relative change of m̄ over a depth `part` · `radius`, the depth (m) at which the motion ends, and true if a
/// warning was given.
fn drift(radius: f64, part: f64, slide: bool) -> (Option<f64>, Option<f64>, bool) {
    // A free slide next to the hinge, without coupling to the contact, must not change the result.
    let beside = if slide {
        "<link name=\"other\"><inertial><mass value=\"1\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\"/></inertial></link>\
         <joint name=\"slide\" type=\"prismatic\"><parent link=\"ground\"/><child link=\"other\"/><axis xyz=\"0 0 1\"/></joint>"
    } else {
        ""
    };
    let moment = 0.1 * radius * radius;
    let text = format!(
        "<robot name=\"p\"><link name=\"ground\"/><link name=\"rod\"><inertial><origin xyz=\"0 0 {}\"/><mass value=\"2\"/>\
         <inertia ixx=\"{moment}\" iyy=\"{moment}\" izz=\"{moment}\"/></inertial></link><joint name=\"hinge\" type=\"continuous\">\
         <parent link=\"ground\"/><child link=\"rod\"/><axis xyz=\"0 1 0\"/></joint>{beside}</robot>",
        -0.5 * radius
    );
    let model =
        Model::from_source(&Source::from_text("p.urdf", text), &LoadOptions::default()).expect("a pendulum");
    let contact = ContactTable {
        normal_frame: Some(FrameName::World),
        ..ContactTable::at_point("rod", [0.0, 0.0, -radius], [1.0, 0.0, 0.0])
    };
    let question = MassQuestion { contact, ..MassQuestion::default() };
    let mass = 0.6;
    // Without energy loss the maximum penetration is v √(m/k).
    let damping = DampingQuestion {
        speed: Some((part * radius * (1e3_f64 / mass).sqrt()).into()),
        ..DampingQuestion::new(1.0, 1e3)
    };
    let report = damp_contact(&model, &question, &damping).expect("a damper");
    let drift = report.drift.expect("of a model");
    let warned = report.diagnostics.iter().any(|found| found.code == "penetration-unreachable");
    (drift.over_penetration, drift.ends_at, warned)
}

#[test]
fn a_drift_follows_the_motion_to_its_depth() {
    // With constant v* the changes would be +34.8, +107 and +277 %.
    for (part, expected) in [(0.533, 0.3968), (0.8026, 1.8106), (1.0288, f64::NAN)] {
        let (over, ends_at, warned) = drift(0.8, part, false);
        if part < 1.0 {
            assert!((over.expect("reached") - expected).abs() < 1e-3, "{over:?}");
            assert!(ends_at.is_none() && !warned);
        } else {
            assert!(over.is_none() && warned);
            assert!((ends_at.expect("a dead centre") / 0.8 - 1.0).abs() < 1e-3, "{ends_at:?}");
        }
    }
    let (mut reached, mut worst) = (0, 0.0_f64);
    for seed in 0..PENDULUMS {
        let rng = &mut StdRng::seed_from_u64(seed);
        let radius = 10f64.powf(rng.random_range(-2.0..2.0));
        let part = rng.random_range(0.001..1.3);
        if (part - 1.0_f64).abs() < 0.01 {
            continue;
        }
        let (over, ends_at, warned) = drift(radius, part, rng.random_bool(0.5));
        let label = format!("seed {seed}: radius {radius}, depth {part} of it: {over:?}, {ends_at:?}");
        assert_eq!(warned, part > 1.0, "{label}");
        if part < 1.0 {
            let off = ((over.expect(&label) + 1.0) * (1.0 - part * part) - 1.0) * (1.0 - part * part);
            worst = worst.max(off.abs());
            assert!(off.abs() < AGREEMENT, "{label}: off by {off:.1e}");
            reached += 1;
        } else {
            assert!(over.is_none() && (ends_at.expect(&label) / radius - 1.0).abs() < 1e-3, "{label}");
        }
    }
    println!("{reached} of {PENDULUMS} reached, worst {worst:.1e} of m̄");
    assert!(reached > PENDULUMS / 2);
}
