//! Shafts and sliders in space with closed-form results.

use super::{Linkage, plane};
use crate::alter::build_with_loops;
use crate::closed_form::hooke_output_angle;
use crate::parts::{frame, ground, joint};
use percuss_mechanism::{ClosureDescription, ClosureKind, Inertial, JointKind, LinkDescription};
use std::f64::consts::PI;

use JointKind::{Continuous, Prismatic, Spherical};

/// Two shafts at the angle `beta` with a universal closure, which has three redundant rows of four. `input`
/// rotates about the z-axis of [`plane`]; its pin is in the plane of the shafts at angle 0. Moments of inertia
/// about the shafts are 0.03 and 0.08 kg·m². Driver `input`, a full turn.
pub fn hooke_shaft(beta: f64) -> Linkage {
    let shaft = |name: &str, mass: f64, moment: f64| {
        LinkDescription::new(
            name,
            Inertial::diagonal(mass, [0.0, 0.0, 0.2], [0.6 * moment, 0.7 * moment, moment]),
        )
    };
    let links = vec![ground(), shaft("input", 3.0, 0.03), shaft("output", 5.0, 0.08)];
    let z = [0.0, 0.0, 1.0];
    let joints = vec![
        joint("input", Continuous, "ground", "input").origin(plane()).axis(z),
        joint("output", Continuous, "ground", "output")
            .origin(plane() * frame([0.0, beta, 0.0], [0.0; 3]))
            .axis(z),
    ];
    let cross = ClosureDescription::new("cross", ClosureKind::Universal, "input", "output");
    let mechanism = build_with_loops("hooke_shaft", links, joints, vec![cross], Vec::new());
    let start = [("input", 0.4), ("output", hooke_output_angle(beta, 0.4))];
    Linkage::new(mechanism, "hooke_shaft", [("input", [-PI, PI])], start)
}

/// Masses of the two sliders of the trammels, kg, and the length of the rod, m.
pub const TRAMMEL: ([f64; 2], f64) = ([1.4, 2.3], 0.85);

/// Elliptic trammel; its rod is a link if `rod` is true, otherwise a distance closure.
fn trammel_of(name: &'static str, rod: bool) -> Linkage {
    let ([first, second], length) = TRAMMEL;
    let slider = |name: &str, mass: f64| {
        LinkDescription::new(name, Inertial::diagonal(mass, [0.02, 0.01, 0.03], [0.01, 0.012, 0.015]))
    };
    let mut links = vec![ground(), slider("first", first), slider("second", second)];
    let mut joints = vec![
        joint("first", Prismatic, "ground", "first").origin(plane()),
        joint("second", Prismatic, "ground", "second").origin(plane()).axis([0.0, 1.0, 0.0]),
    ];
    let x = 0.5;
    let y = (length * length - x * x).sqrt();
    let start = vec![("first", x), ("second", y)];
    let mut linkage_start: Vec<(String, Vec<f64>)> = Vec::new();
    let closure = if rod {
        links.push(LinkDescription::massless("rod"));
        joints.push(joint("first_ball", Spherical, "first", "rod"));
        // The rod's x-axis points to the second slider.
        let half = f64::atan2(y, -x) / 2.0;
        linkage_start.push(("first_ball".into(), vec![half.cos(), 0.0, 0.0, half.sin()]));
        ClosureDescription::new("second_ball", ClosureKind::Spherical, "rod", "second")
            .at([length, 0.0, 0.0], [0.0; 3])
    } else {
        ClosureDescription::new("rod", ClosureKind::Distance, "first", "second").distance(length)
    };
    let mechanism = build_with_loops(name, links, joints, vec![closure], Vec::new());
    let mut linkage = Linkage::new(mechanism, name, [("first", [0.2, 0.75])], start);
    linkage.start.extend(linkage_start);
    linkage
}

/// Elliptic trammel with [`TRAMMEL`]; the rod is a distance closure. Driver `first`, 0.2 to 0.75 m.
pub fn trammel() -> Linkage {
    trammel_of("trammel", false)
}

/// Elliptic trammel with a massless link as rod, between a spherical joint and a spherical closure. The free
/// rotation of the rod about its axis is one more degree of freedom, without mass. Driver `first`, 0.2 to 0.75
/// m.
pub fn trammel_with_rod() -> Linkage {
    trammel_of("trammel_with_rod", true)
}
