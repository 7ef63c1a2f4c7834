//! Linkages with couplings.

use super::Linkage;
use crate::alter::{CouplingForm, build_with_loops};
use crate::parts::{frame, ground, joint, lump};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, CouplingDescription, CurveDescription, Inertial, JointKind,
    LinkDescription, RelationDescription,
};
use std::f64::consts::PI;

use JointKind::{Continuous, Prismatic, Revolute};

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Coupling of two joints with a ratio.
fn coupling(name: &str, predecessor: &str, successor: &str, ratio: f64) -> CouplingForm {
    CouplingForm::Ratio(CouplingDescription {
        name: name.into(),
        predecessor: predecessor.into(),
        successor: successor.into(),
        ratio,
    })
}

/// Wheel with a given moment of inertia about z and its mass on the axis.
fn wheel(name: &str, mass: f64, moment: f64) -> LinkDescription {
    LinkDescription::new(
        name,
        Inertial::diagonal(mass, [0.0, 0.0, 0.02], [0.6 * moment, 0.6 * moment, moment]),
    )
}

/// Rack (1.5 kg along x) and pinion (0.0021 kg·m², radius 0.06 m): the ratio of the coupling has a unit. Driver
/// `rack`.
pub fn rack_and_pinion() -> Linkage {
    let links = vec![ground(), wheel("pinion", 0.8, 0.0021), lump("rack", 1.5, [0.1, 0.02, 0.0], 0.4)];
    let joints = vec![
        joint("pinion", Continuous, "ground", "pinion").at([0.0, 0.06, 0.0]).axis(Z),
        joint("rack", Prismatic, "ground", "rack"),
    ];
    let couplings = vec![coupling("mesh", "pinion", "rack", 0.06)];
    let mechanism = build_with_loops("rack_and_pinion", links, joints, Vec::new(), couplings);
    let start = [("rack", 0.1), ("pinion", 0.1 / 0.06)];
    Linkage::new(mechanism, "rack_and_pinion", [("rack", [-0.3, 0.3])], start)
}

/// Two parallel shafts, 0.02 and 0.005 kg·m², with the speed ratio −2.5. Driver `slow`.
pub fn geared_pair() -> Linkage {
    let links = vec![ground(), wheel("slow", 2.0, 0.02), wheel("fast", 0.7, 0.005)];
    let origin = frame([0.3, 0.2, -0.5], [0.1, 0.0, 0.2]);
    let joints = vec![
        joint("slow", Continuous, "ground", "slow").origin(origin).axis(Z),
        joint("fast", Continuous, "ground", "fast")
            .origin(origin * frame([0.0; 3], [0.14, 0.0, 0.0]))
            .axis(Z),
    ];
    let couplings = vec![coupling("mesh", "slow", "fast", -2.5)];
    let mechanism = build_with_loops("geared_pair", links, joints, Vec::new(), couplings);
    Linkage::new(mechanism, "geared_pair", [("slow", [-PI, PI])], [("slow", 0.3), ("fast", -0.75)])
}

/// Planetary gear with 24, 18 and 60 teeth: sun, one planet (0.4 kg at 0.063 m) and ring rotate on the carrier,
/// with two couplings for the gear meshes; a fixed closure connects the ring to the ground (five of its six
/// rows are redundant). Moments of inertia 0.004 (carrier), 0.0006, 0.0003 and 0.01 kg·m². Driver `carrier`, a
/// full turn.
pub fn planetary_gear() -> Linkage {
    let links = vec![
        ground(),
        wheel("carrier", 1.2, 0.004),
        wheel("sun", 0.5, 0.0006),
        LinkDescription::new("planet", Inertial::diagonal(0.4, [0.0; 3], [0.0002, 0.0002, 0.0003])),
        wheel("ring", 1.5, 0.01),
    ];
    let origin = frame([-0.4, 0.9, 0.1], [0.3, 0.1, -0.2]);
    let joints = vec![
        joint("carrier", Continuous, "ground", "carrier").origin(origin).axis(Z),
        joint("sun", Continuous, "carrier", "sun").axis(Z),
        joint("planet", Continuous, "carrier", "planet").at([0.063, 0.0, 0.0]).axis(Z),
        joint("ring", Continuous, "carrier", "ring").axis(Z),
    ];
    let hold = ClosureDescription {
        predecessor_frame: origin,
        ..ClosureDescription::new("housing", ClosureKind::Fixed, "ground", "ring")
    };
    let couplings = vec![
        coupling("outer_mesh", "sun", "planet", -24.0 / 18.0),
        coupling("inner_mesh", "planet", "ring", 18.0 / 60.0),
    ];
    let mechanism = build_with_loops("planetary_gear", links, joints, vec![hold], couplings);
    let turn = 0.2;
    let start = [("carrier", turn), ("ring", -turn), ("planet", -turn / 0.3), ("sun", turn * 2.5)];
    Linkage::new(mechanism, "planetary_gear", [("carrier", [-PI, PI])], start)
}

/// Rover: a body that can float, two rockers coupled by a differential (ratio −1), a bogie on each rocker, six
/// wheels. Drivers: one rocker, the bogies, the wheels.
pub fn rocker_bogie() -> Linkage {
    let mut links = vec![lump("body", 25.0, [0.02, 0.0, 0.1], 0.8)];
    let mut joints = Vec::new();
    let y = [0.0, 1.0, 0.0];
    let mut drivers = vec![("left_rocker".to_owned(), [-0.5, 0.5])];
    for (side, origin) in [("left", 0.4), ("right", -0.4)] {
        let name = |part: &str| format!("{side}_{part}");
        links.push(lump(&name("rocker"), 2.2, [0.1, 0.0, -0.05], 0.5));
        links.push(lump(&name("bogie"), 1.1, [-0.05, 0.0, -0.03], 0.3));
        joints
            .push(joint(&name("rocker"), Revolute, "body", &name("rocker")).at([0.05, origin, 0.0]).axis(y));
        joints.push(
            joint(&name("bogie"), Revolute, &name("rocker"), &name("bogie")).at([-0.35, 0.0, -0.15]).axis(y),
        );
        drivers.push((name("bogie"), [-0.6, 0.6]));
        for (wheel, of, x) in [("front", "rocker", 0.45), ("middle", "bogie", 0.2), ("rear", "bogie", -0.2)] {
            let wheel = name(wheel);
            links.push(lump(&wheel, 0.9, [0.0, 0.01, 0.0], 0.15));
            joints.push(
                joint(&wheel, Continuous, &name(of), &wheel).at([x, 0.05, -0.2]).axis(y).armature(0.01),
            );
            drivers.push((wheel, [-1.0, 1.0]));
        }
    }
    let couplings = vec![coupling("differential", "left_rocker", "right_rocker", -1.0)];
    let mechanism = build_with_loops("rocker_bogie", links, joints, Vec::new(), couplings);
    let start = [("left_rocker", 0.2), ("right_rocker", -0.2), ("left_bogie", -0.3), ("right_bogie", 0.1)];
    let drivers = drivers.iter().map(|(name, range)| (name.as_str(), *range));
    Linkage::new(mechanism, "rocker_bogie", drivers, start)
}

/// Relations of joint positions: a follower (1.5 kg) on a cam (0.02 kg·m²), y = 0.02 + 0.1 θ + 0.05 s² − 0.02 s³ + 0.01 s⁴ with
/// s = 0.1 + θ, and two arms with a counter-shaft, first + 2 second − 1.5 counter = 0.1. Drivers: cam and arms.
pub fn cam_and_sum() -> Linkage {
    let links = vec![
        ground(),
        wheel("cam", 0.8, 0.02),
        lump("follower", 1.5, [0.1, 0.02, 0.0], 0.4),
        lump("first", 1.1, [0.2, 0.0, 0.05], 0.3),
        lump("second", 0.7, [0.1, 0.1, 0.0], 0.2),
        wheel("counter", 0.5, 0.004),
    ];
    let origin = frame([0.3, 0.2, -0.5], [0.1, 0.0, 0.2]);
    let joints = vec![
        joint("cam", Continuous, "ground", "cam").origin(origin).axis(Z),
        joint("follower", Prismatic, "ground", "follower").origin(origin),
        joint("first", Revolute, "ground", "first").at([0.0, -0.3, 0.1]).axis([0.2, 1.0, 0.1]),
        joint("second", Revolute, "first", "second").at([0.4, 0.0, 0.0]).axis([1.0, 0.3, 0.0]),
        joint("counter", Continuous, "ground", "counter").at([-0.2, 0.0, 0.0]).axis(Z),
    ];
    let terms =
        |of: &[(&str, f64)]| of.iter().map(|(joint, factor)| ((*joint).to_owned(), *factor)).collect();
    let relations = vec![
        RelationDescription {
            name: "cam".into(),
            terms: terms(&[("follower", 1.0), ("cam", -0.1)]),
            constant: 0.02,
            curve: Some(CurveDescription {
                terms: terms(&[("cam", 1.0)]),
                offset: 0.1,
                coefficients: [0.05, -0.02, 0.01],
            }),
        },
        RelationDescription {
            name: "sum".into(),
            terms: terms(&[("first", 1.0), ("second", 2.0), ("counter", -1.5)]),
            constant: 0.1,
            curve: None,
        },
    ];
    let relations = relations.into_iter().map(CouplingForm::Relation).collect();
    let mechanism = build_with_loops("cam_and_sum", links, joints, Vec::new(), relations);
    let drivers = [("cam", [-1.0, 1.0]), ("first", [-0.5, 0.5]), ("second", [-0.5, 0.5])];
    let start =
        [("cam", 0.3), ("follower", 0.056_976), ("first", 0.2), ("second", -0.1), ("counter", -0.1 / 1.5)];
    Linkage::new(mechanism, "cam_and_sum", drivers, start)
}
