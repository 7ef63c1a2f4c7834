//! Closures of every kind with general frames, closed at a given position of the tree.

use super::Linkage;
use crate::alter::{build, build_with_loops};
use crate::closures::{admissible_relative_pose, complete_closure};
use crate::parts::{frame, joint, lump};
use percuss_mechanism::{ClosureDescription, ClosureKind, JointDescription, JointKind, LinkDescription};
use percuss_spatial::Vector3;

use JointKind::{Prismatic, Revolute};

/// Chain of `count` bodies below `base` with general frames and axes; every fourth joint is prismatic. Names
/// are `{prefix}_1` …; `seed` varies the chains.
fn chain(prefix: &str, base: &str, count: usize, seed: f64) -> (Vec<LinkDescription>, Vec<JointDescription>) {
    let wave = |i: usize, k: usize| (seed * 1.7 + i as f64 * 2.3 + k as f64 * 4.1).sin();
    let (mut links, mut joints) = (Vec::new(), Vec::new());
    let mut parent = base.to_owned();
    for i in 1..=count {
        let name = format!("{prefix}_{i}");
        let com = [0.1 * wave(i, 1), 0.1 * wave(i, 2), 0.1 * wave(i, 3)];
        links.push(lump(&name, 1.0 + 0.7 * wave(i, 4), com, 0.4));
        let kind = if i % 4 == 3 { Prismatic } else { Revolute };
        let turn = [1.5 * wave(i, 5), 1.5 * wave(i, 6), 1.5 * wave(i, 7)];
        let origin = [0.3 * wave(i, 8), 0.3 * wave(i, 9), 0.2 + 0.1 * wave(i, 10)];
        joints.push(joint(&name, kind, &parent, &name).origin(frame(turn, origin)).axis([
            wave(i, 11),
            wave(i, 12),
            0.7,
        ]));
        parent = name;
    }
    (links, joints)
}

/// All kinds of closure on one base that has mass and can float. For each kind there is a chain with one joint
/// more than the closure has rows, in general position: each chain has one degree of freedom and no redundant
/// row.
///
/// The universal closure connects its chain to the world; the spherical closure connects its chain to a link of
/// the chain of the fixed closure; the planar closure connects the end of its chain to the second link, an
/// ancestor. Drivers: the first joint of every chain, ±0.08.
pub fn every_closure() -> Linkage {
    let mut links = vec![lump("base", 9.0, [0.1, 0.05, -0.1], 0.9)];
    let mut joints = Vec::new();
    for (i, kind) in ClosureKind::ALL.into_iter().enumerate() {
        // The planar chain has two more joints, above the ancestor.
        let ancestor = if kind == ClosureKind::Planar { 2 } else { 0 };
        let (more_links, more_joints) =
            chain(kind.name(), "base", kind.rows() + 1 + ancestor, 1.0 + i as f64);
        links.extend(more_links);
        joints.extend(more_joints);
    }
    let tree = build("every_closure", links.clone(), joints.clone());
    let value = |i: usize| 0.5 * (i as f64 * 1.9 + 2.3).sin();
    let positions: Vec<Vec<f64>> = (0..joints.len()).map(|i| vec![value(i)]).collect();
    let closures = ClosureKind::ALL.into_iter().enumerate().map(|(i, kind)| {
        let last = joints.iter().rfind(|j| j.name.starts_with(kind.name()));
        let Some(last) = last else { unreachable!("every kind has a chain") };
        let predecessor = match kind {
            ClosureKind::Universal => "world",
            ClosureKind::Spherical => "fixed_2",
            ClosureKind::Planar => "planar_2",
            ClosureKind::Fixed
            | ClosureKind::Revolute
            | ClosureKind::Prismatic
            | ClosureKind::Cylindrical
            | ClosureKind::Distance => "base",
        };
        let wave = |k: usize| (2.7 * i as f64 + 1.3 * k as f64 + 7.3).sin();
        let axis = Vector3::new(wave(1), wave(2), wave(3)).normalize();
        let closure = ClosureDescription {
            predecessor_frame: frame([wave(4), wave(5), wave(6)], [0.4 * wave(7), 0.4 * wave(8), 0.3]),
            axis,
            ..ClosureDescription::new(
                format!("{}_closure", kind.name()),
                kind,
                predecessor,
                last.name.as_str(),
            )
        };
        let displacement = Vector3::new(0.3 + 0.1 * wave(9), 0.2 * wave(10), 0.2 * wave(11));
        complete_closure(
            &tree,
            &positions,
            closure,
            admissible_relative_pose(kind, &axis, displacement, [wave(12), 0.7 * wave(13), wave(14)]),
        )
    });
    let closures = closures.collect();
    driven_by("every_closure", links, joints, closures, &positions, |name| {
        name.ends_with("_1") || name == "planar_2" || name == "planar_3"
    })
}

/// Leg of five joints below a base that can float; a spherical closure connects the foot to the world. Two
/// degrees of freedom on the ground, eight with a floating base. Drivers `leg_1` and `leg_2`, ±0.08.
pub fn foot_on_the_world() -> Linkage {
    let mut links = vec![lump("base", 4.0, [0.0, 0.1, 0.1], 0.6)];
    let (more, joints) = chain("leg", "base", 5, 21.0);
    links.extend(more);
    let tree = build("foot_on_the_world", links.clone(), joints.clone());
    let positions: Vec<Vec<f64>> = (0..5).map(|i| vec![0.3 * (1.0 + i as f64).sin()]).collect();
    let foot = ClosureDescription {
        predecessor_frame: frame([0.3, 0.2, -0.5], [0.1, -0.2, 0.4]),
        ..ClosureDescription::new("foot", ClosureKind::Spherical, "world", "leg_5")
    };
    let fit =
        admissible_relative_pose(ClosureKind::Spherical, &Vector3::x(), Vector3::zeros(), [0.4, 0.5, 0.6]);
    let foot = complete_closure(&tree, &positions, foot, fit);
    driven_by("foot_on_the_world", links, joints, vec![foot], &positions, |name| {
        name == "leg_1" || name == "leg_2"
    })
}

/// Linkage that starts at `positions`, with the joints selected by `drives` as drivers within ±0.08.
fn driven_by(
    name: &'static str,
    links: Vec<LinkDescription>,
    joints: Vec<JointDescription>,
    closures: Vec<ClosureDescription>,
    positions: &[Vec<f64>],
    drives: impl Fn(&str) -> bool,
) -> Linkage {
    const DRIVER_RANGE: f64 = 0.08;
    let start: Vec<(String, f64)> =
        joints.iter().zip(positions).map(|(j, q)| (j.name.clone(), q[0])).collect();
    let mechanism = build_with_loops(name, links, joints, closures, Vec::new());
    let start = start.iter().map(|(name, value)| (name.as_str(), *value));
    let drivers = start.clone().filter(|(name, _)| drives(name));
    let drivers = drivers.map(|(name, value)| (name, [value - DRIVER_RANGE, value + DRIVER_RANGE]));
    Linkage::new(mechanism, name, drivers, start)
}
