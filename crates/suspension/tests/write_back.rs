//! Files of other programs with moved points: the same text apart from the numbers of the points, and the moved points after reading.

use nalgebra::Vector3;
use percuss_formats::Source;
use percuss_suspension::{ImportOptions, Imported, changed_file, import};

/// Own files, each with comments and a layout of its own.
const FILES: [(&str, &str); 5] = [
    ("car.pm", FIVE_LINK_PM),
    ("arms.pm", ARMS_PM),
    ("car.yaml", CORNER_YAML),
    ("axle.yaml", AXLE_YAML),
    ("car.json", include_str!("../../../models/suspensions/double-wishbone-chrono.json")),
];

const FIVE_LINK_PM: &str = "// a car, front left corner\n[BODY]\nname=body mass=(0.0) inertia=(0.0,0.0,0.0)\npos=(0.0,0.0,0.0) ori=(0.0,0.0,0.0)\n\n\
[BODY] // carrier\nname=fl_spindle mass=(9.5) inertia=(0.0275,0.026,0.0245)\npos=(0.69,0.30,-0.002) ori=(0.0,0.0,0.0)\n\
[BODY]\nname=fl_wheel mass=(18.0) inertia=(1.2,0.7,0.65)\npos=(0.76,0.300,0.0) ori=(0.0,0.0,0.0)\n\n\
[JOINT&HINGE]\nposbody=fl_wheel negbody=fl_spindle pos=fl_wheel axis=(-0.7,0.0,0.0)\n\n\
[BAR] // upper, front\nposbody=body negbody=fl_spindle pos=(0.45,0.44,-0.12) neg=(0.682,0.455,-0.02)\n\
[BAR] // upper, rear\nposbody=fl_spindle negbody=body pos=(0.678,0.452,0.045) neg=(0.46,0.43,0.17)\n\
[BAR] // lower, front\nposbody=body negbody=fl_spindle pos=( 0.38, 0.19, -0.18 ) neg=(0.722,0.180,-0.04)\n\
[BAR] // lower, rear\nposbody=body negbody=fl_spindle pos=(0.39,0.20,0.21) neg=(0.718,0.178,0.05)\n\
[BAR]\nname=fl_steering posbody=body negbody=fl_spindle pos=(0.40,0.24,0.13) neg=(0.70,0.235,0.145) // tie rod\n";

const ARMS_PM: &str = "// two arms of two rods, shared ball joints\n[BODY]\nname=body mass=(0.0) inertia=(0.0,0.0,0.0) pos=(0.0,0.0,0.0) ori=(0.0,0.0,0.0)\n\
[BODY]\nname=fl_spindle mass=(9.5) inertia=(0.0275,0.026,0.0245)\npos=(0.69,0.30,-0.002) ori=(0.0,0.0,0.0)\n\
[BODY]\nname=fl_wheel mass=(18.0) inertia=(1.2,0.7,0.65)\npos=(0.76,0.3,0.0) ori=(0.0,0.0,0.0)\n\
[JOINT&HINGE]\nposbody=fl_wheel negbody=fl_spindle pos=(0.76,0.3,0.0) axis=(-0.7,0.0,0.0)\n\
[BAR]\nposbody=body negbody=fl_spindle pos=(0.45,0.44,-0.12) neg=(0.68,0.455,0.015)\n\
[BAR]\nposbody=body negbody=fl_spindle pos=(0.46,0.43,0.17) neg=(0.68,0.455,0.015)\n\
[BAR]\nposbody=body negbody=fl_spindle pos=(0.38,0.19,-0.18) neg=(0.72,0.18,-0.005)\n\
[BAR]\nposbody=body negbody=fl_spindle pos=(0.39,0.2,0.21) neg=(0.72,0.18,-0.005)\n\
[BAR]\nname=fl_steering posbody=body negbody=fl_spindle pos=(0.40,0.24,0.13) neg=(0.70,0.235,0.145)\n";

const CORNER_YAML: &str = "# geometry of a corner\ntype: double_wishbone\nname: \"car\"\nversion: \"0.0.1\"\nunits: millimeters\nside: left\n\
actuation:\n  type: direct\n  mount: lower_wishbone\nspring:\n  type: coilover\nconfig:\n  steering: {type: rack}\n  wheel:\n    offset: 20.0\n    tire:\n      \
aspect_ratio: 0.55\n      section_width: 205\n      rim_diameter: 16\n  wheelbase: 2500.0\nhardpoints:\n  \
lower_wishbone_inboard_front: {x: 180.0, y: 380.0, z: 190.0}  # bush\n  lower_wishbone_inboard_rear: {x: -210.0, y: 390.0, z: 200.0}\n  \
lower_wishbone_outboard: {x: 5.0, y: 720.0, z: 180.0}\n  upper_wishbone_inboard_front:\n    x: 120.0\n    y: 450.0   # lateral\n    z: 440.0\n  \
upper_wishbone_inboard_rear: {x: -170.0, y: 460.0, z: 430.0}\n  upper_wishbone_outboard: {x: -15.0, y: 680.0, z: 455.0}\n  \
trackrod_inboard: {x: -130.0, y: 400.0, z: 240.0}\n  trackrod_outboard: {x: -145.0, y: 700.0, z: 235.0}\n  \
strut_bottom: {x: 0.0, y: 590.0, z: 200.0}\n  strut_top: {x: -12.0, y: 505.0, z: 600.0}\n  axle_inboard: {x: 0.0, y: 690.0, z: 300.0}\n  \
axle_outboard: {x: 0.0, y: 780.0, z: 300.0}\n";

const AXLE_YAML: &str = "type: multi_link\nname: \"axle\"\nunits: millimeters\nscope: axle\naxle_config:\n  steering: {type: rack}\n  wheel:\n    offset: 20.0\n    \
tire:\n      aspect_ratio: 0.55\n      section_width: 205\n      rim_diameter: 16\nhardpoints:\n  left:\n    \
upper_front_link_inboard: {x: 120.0, y: 450.0, z: 440.0}\n    upper_front_link_outboard: {x: 20.0, y: 682.0, z: 455.0}\n    \
upper_rear_link_inboard: {x: -170.0, y: 460.0, z: 430.0}\n    upper_rear_link_outboard: {x: -45.0, y: 678.0, z: 452.0}\n    \
lower_front_link_inboard: {x: 180.0, y: 380.0, z: 190.0}\n    lower_front_link_outboard: {x: 40.0, y: 722.0, z: 180.0}\n    \
lower_rear_link_inboard: {x: -210.0, y: 390.0, z: 200.0}\n    lower_rear_link_outboard: {x: -50.0, y: 718.0, z: 178.0}\n    \
trackrod_inboard: {x: -130.0, y: 400.0, z: 240.0}\n    trackrod_outboard: {x: -145.0, y: 700.0, z: 235.0}\n    \
axle_inboard: {x: 0.0, y: 690.0, z: 300.0}\n    axle_outboard: {x: 0.0, y: 780.0, z: 300.0}\n  right:\n    \
upper_front_link_inboard: {x: 120.0, y: -450.0, z: 443.5}  # higher than on the left\n    upper_front_link_outboard: {x: 20.0, y: -682.0, z: 455.0}\n    \
upper_rear_link_inboard: {x: -170.0, y: -460.0, z: 430.0}\n    upper_rear_link_outboard: {x: -45.0, y: -678.0, z: 452.0}\n    \
lower_front_link_inboard: {x: 180.0, y: -380.0, z: 190.0}\n    lower_front_link_outboard: {x: 40.0, y: -722.0, z: 180.0}\n    \
lower_rear_link_inboard: {x: -210.0, y: -390.0, z: 200.0}\n    lower_rear_link_outboard: {x: -50.0, y: -718.0, z: 178.0}\n    \
trackrod_inboard: {x: -130.0, y: -400.0, z: 240.0}\n    trackrod_outboard: {x: -145.0, y: -700.0, z: 235.0}\n    \
axle_inboard: {x: 0.0, y: -690.0, z: 300.0}\n    axle_outboard: {x: 0.0, y: -780.0, z: 300.0}\n";

fn imported(name: &str, text: &str) -> Imported {
    let options = ImportOptions {
        masses_optional: true,
        side: name.starts_with("axle").then_some(percuss_suspension::Side::Both),
        ..ImportOptions::default()
    };
    import(&Source::from_text(name, text), &options).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"))
}

/// Text without the characters of numbers.
fn without_numbers(text: &str) -> String {
    text.replace(|c: char| c.is_ascii_digit() || "-+.e".contains(c), "")
}

/// Each point that has numbers of its own in the file is moved, alone: the text differs in numbers only, and only the point has moved.
#[test]
fn moved_points_are_written_and_read_again() {
    let mut written = Vec::new();
    for (name, text) in FILES {
        let before = imported(name, text);
        let axes = before.understood.axes;
        for (i, (point, _)) in before.understood.coordinates.iter().enumerate() {
            let by = [0.0013, -0.0021 * (1.0 + i as f64 / 7.0), 0.0008].map(|x| (x * 1e6f64).round() / 1e6);
            let source = Source::from_text(name, text);
            let options = ImportOptions {
                masses_optional: true,
                side: name.starts_with("axle").then_some(percuss_suspension::Side::Both),
                ..ImportOptions::default()
            };
            let changed = match changed_file(&source, &options, &[(point.clone(), by)]) {
                Ok(changed) => String::from_utf8(changed.bytes).expect("a text"),
                Err(why) => {
                    assert!(
                        why.contains("no coordinates of its own") || why.contains("one point"),
                        "{name} {point}: {why}"
                    );
                    continue;
                }
            };
            assert_ne!(changed, text, "{name} {point}");
            assert_eq!(without_numbers(&changed), without_numbers(text), "{name} {point}");
            let lines = changed.lines().zip(text.lines()).filter(|(new, old)| new != old).count();
            assert!(lines <= 3, "{name} {point}: {lines} lines");
            let after = imported(name, &changed);
            assert_eq!(after.understood.points, before.understood.points, "{name} {point}");
            for ((other, at), (_, old)) in
                after.understood.coordinates.iter().zip(&before.understood.coordinates)
            {
                let expected = if other == point { Vector3::from(by) } else { Vector3::zeros() };
                let moved = Vector3::from(*at) - Vector3::from(*old);
                // Thirteen digits of numbers below 1000 mm; the coordinates are compared in the axes of the file.
                assert!(
                    (moved - expected).amax() < 1e-12,
                    "{name} {point}: {other} {moved:?} in {}",
                    axes.name()
                );
            }
            written.push(format!("{name} {point}"));
        }
    }
    let count = |file: &str| written.iter().filter(|one| one.starts_with(file)).count();
    // All points of the bars and the wheel of `.pm`; of YAML all but the wheel centre and the ends of the coil-over, which are those of the damper.
    assert_eq!((count("car.pm"), count("arms.pm")), (11, 9), "{written:?}");
    assert_eq!((count("car.yaml"), count("axle.yaml")), (8, 11), "{written:?}");
    assert!(count("car.json") >= 9, "{written:?}");
}

/// A shared joint that the file repeats with other digits is not changed by half.
#[test]
fn repeated_points_with_other_digits_are_refused() {
    let text = ARMS_PM.replacen("neg=(0.68,0.455,0.015)", "neg=(0.68000001,0.455,0.015)", 1);
    let source = Source::from_text("arms.pm", &text);
    let options = ImportOptions::default();
    let upward = [("upper_ball".to_owned(), [0.0, 0.001, 0.0])];
    assert!(changed_file(&source, &options, &upward).is_ok());
    let lateral = [("upper_ball".to_owned(), [0.001, 0.0, 0.0])];
    let refused = changed_file(&source, &options, &lateral);
    assert!(refused.is_err_and(|why| why.contains("no plain number")), "{text}");
}
