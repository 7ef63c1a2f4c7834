//! Linkages of any size.

use super::Linkage;
use super::planar::{link, on_ground, pin};
use crate::alter::build_with_loops;
use crate::closed_form::{Crossing, FourBar, PlanarBody};
use crate::parts::{ground, joint};
use percuss_mechanism::JointKind::Continuous;

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// `n` four-bars in a row; the rocker of each is the crank of the next: n loops in one group, one degree of freedom.
///
/// The pivots of `link_0` … `link_n` are 1 m apart. Couplers `coupler_1` … `coupler_n` of 1 m connect pins at a
/// radius of 0.4 m; the angle between the two pins of a link is alternately +0.3 and −0.3 rad. So every loop is
/// a parallelogram, all links rotate by the same angle, and the couplers translate. With the moment of inertia
/// J of every link about its pivot (0.07 kg·m²; mass 1.2 kg) and the coupler mass μ (0.8 kg), 2T = ((n + 1) J +
/// 0.16 n μ) θ̇². Driver `hinge_0`, 0.5 to 2.0.
pub fn ladder(n: usize) -> Linkage {
    let arm = 0.4;
    let mut links = vec![ground()];
    let (mut joints, mut closures) = (Vec::new(), Vec::new());
    // The link frames have their x-axis to the incoming pin.
    let mut angle = 1.0;
    let mut start = Vec::new();
    let moment = 0.07 - 1.2 * (0.1f64.powi(2) + 0.05f64.powi(2));
    for i in 0..=n {
        let name = format!("link_{i}");
        links.push(link(&name, &PlanarBody::new(1.2, [0.1, 0.05], moment)));
        let hinge = format!("hinge_{i}");
        joints.push(joint(&hinge, Continuous, "ground", &name).origin(on_ground(i as f64, 0.0)).axis(Z));
        if i > 0 {
            let ahead: f64 = if i % 2 == 1 { 0.3 } else { -0.3 };
            let coupler = format!("coupler_{i}");
            let (before, pinned) = (format!("link_{}", i - 1), format!("pin_{i}"));
            links.push(link(&coupler, &PlanarBody::new(0.8, [0.5, 0.03], 0.07)));
            let out = [arm * ahead.cos(), arm * ahead.sin(), 0.0];
            joints.push(joint(&pinned, Continuous, &before, &coupler).at(out).axis(Z));
            start.push((pinned, -angle));
            angle += ahead;
            closures.push(pin(&format!("loop_{i}"), (&coupler, [1.0, 0.0]), (&name, [arm, 0.0])));
        }
        start.push((hinge, angle));
    }
    let mechanism = build_with_loops("ladder", links, joints, closures, Vec::new());
    let start = start.iter().map(|(name, value)| (name.as_str(), *value));
    Linkage::new(mechanism, "ladder", [("hinge_0", [0.5, 2.0])], start)
}

/// `n` independent crank-rockers of increasing size: n groups, n degrees of freedom. Drivers `crank_hinge_1` …,
/// 0.2 to 2.2.
pub fn separate(n: usize) -> Linkage {
    let mut links = vec![ground()];
    let (mut joints, mut closures) = (Vec::new(), Vec::new());
    let (mut start, mut drivers) = (Vec::new(), Vec::new());
    for i in 1..=n {
        let size = 1.0 + 0.1 * i as f64;
        let bar = FourBar { ground: 0.9 * size, crank: 0.25 * size, coupler: 0.8 * size, rocker: 0.6 * size };
        let name = |part: &str| format!("{part}_{i}");
        let [crank, coupler, rocker] = ["crank", "coupler", "rocker"].map(name);
        let y = 2.0 * i as f64;
        links.push(link(&crank, &PlanarBody::new(1.3, [0.08, -0.02], 0.011)));
        links.push(link(&coupler, &PlanarBody::new(2.1 * size, [0.38, 0.11], 0.13)));
        links.push(link(&rocker, &PlanarBody::new(1.7, [0.27, -0.05], 0.06 * size)));
        let hinge = name("crank_hinge");
        joints.push(joint(&hinge, Continuous, "ground", &crank).origin(on_ground(0.0, y)).axis(Z));
        joints
            .push(joint(&name("crank_pin"), Continuous, &crank, &coupler).at([bar.crank, 0.0, 0.0]).axis(Z));
        let far = on_ground(bar.ground, y);
        joints.push(joint(&name("rocker_hinge"), Continuous, "ground", &rocker).origin(far).axis(Z));
        closures.push(pin(&name("rocker_pin"), (&coupler, [bar.coupler, 0.0]), (&rocker, [bar.rocker, 0.0])));
        let theta = 0.5 + 0.2 * (i % 5) as f64;
        let Some([_, b, c]) = bar.poses(theta, Crossing::Left) else { panic!("it does not assemble") };
        start.push((name("crank_pin"), b.angle - theta));
        start.push((name("rocker_hinge"), c.angle));
        start.push((hinge.clone(), theta));
        drivers.push((hinge, [0.2, 2.2]));
    }
    let mechanism = build_with_loops("separate", links, joints, closures, Vec::new());
    let start = start.iter().map(|(name, value)| (name.as_str(), *value));
    let drivers = drivers.iter().map(|(name, range)| (name.as_str(), *range));
    Linkage::new(mechanism, "separate", drivers, start)
}
