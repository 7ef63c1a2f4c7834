//! Linkage with exact and with rounded numbers.

use super::Linkage;
use super::planar::{link, pin};
use crate::alter::build_with_loops;
use crate::closed_form::{Crossing, FourBar, PlanarBody};
use crate::parts::{frame, ground, joint};
use percuss_mechanism::JointKind::Continuous;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

/// Four-bar with exact frames, and its twin with frames rounded as by different programs: angles of the crank's
/// hinge to 4 decimals, angles and position of the rocker's hinge to 6. The redundant rows of the twin
/// contradict each other by some micrometres, so the twin closes only in the least-squares sense
/// ([`close_as_far_as_possible`](crate::maximal::close_as_far_as_possible)).
///
/// Crank 0.28, coupler 0.66, rocker 0.52, ground 0.75 m; links `crank`, `coupler`, `rocker`. Driver
/// `crank_hinge`, 0.3 to 2.6, start at 1.2.
pub fn rounded_four_bar() -> (Linkage, Linkage) {
    // The pivots are on the plane's x-axis, at 30° about the vertical.
    let position = [0.75 * FRAC_PI_6.cos(), 0.75 * FRAC_PI_6.sin(), 0.0];
    let angles = [FRAC_PI_2, 0.0, FRAC_PI_6];
    let exact = twin("exact_four_bar", [angles; 2], position);
    let files = [angles.map(|x| rounded(x, 4)), angles.map(|x| rounded(x, 6))];
    let rounded = twin("rounded_four_bar", files, position.map(|x| rounded(x, 6)));
    (exact, rounded)
}

/// Number rounded to the given decimals.
fn rounded(x: f64, decimals: i32) -> f64 {
    let unit = 10f64.powi(decimals);
    (x * unit).round() / unit
}

/// Linkage with given roll, pitch and yaw of the two ground hinges, and the position of the rocker hinge.
fn twin(name: &'static str, [crank, rocker]: [[f64; 3]; 2], position: [f64; 3]) -> Linkage {
    let bar = FourBar { ground: 0.75, crank: 0.28, coupler: 0.66, rocker: 0.52 };
    let links = vec![
        ground(),
        link("crank", &PlanarBody::new(1.8, [0.12, 0.0], 0.02)),
        link("coupler", &PlanarBody::new(4.1, [0.31, 0.06], 0.19)),
        link("rocker", &PlanarBody::new(2.7, [0.24, 0.0], 0.07)),
    ];
    let z = [0.0, 0.0, 1.0];
    let joints = vec![
        joint("crank_hinge", Continuous, "ground", "crank").origin(frame(crank, [0.0; 3])).axis(z),
        joint("crank_pin", Continuous, "crank", "coupler").at([bar.crank, 0.0, 0.0]).axis(z),
        joint("rocker_hinge", Continuous, "ground", "rocker").origin(frame(rocker, position)).axis(z),
    ];
    let closure = pin("rocker_pin", ("coupler", [bar.coupler, 0.0]), ("rocker", [bar.rocker, 0.0]));
    let mechanism = build_with_loops(name, links, joints, vec![closure], Vec::new());
    let theta = 1.2;
    let Some([_, coupler, rocker]) = bar.poses(theta, Crossing::Left) else { panic!("it does not assemble") };
    let start =
        [("crank_hinge", theta), ("crank_pin", coupler.angle - theta), ("rocker_hinge", rocker.angle)];
    debug_assert!(start.iter().all(|(_, value)| value.abs() < PI));
    Linkage::new(mechanism, name, [("crank_hinge", [0.3, 2.6])], start)
}
