//! Springs, dampers and drives during an impact in time.

use super::{at, body, motion};
use nalgebra::Vector3;
use percuss_contact::DamperCurve;
use percuss_impact::{ImpactError, JointSpring, PointSpring, Support, TimeConditions, impact_in_time};
use percuss_mechanism::JointKind;
use std::sync::Arc;

/// A hinged bar with a spring between a point of the ground and a point of the bar, gravity, and a force curve: one freedom, so that
/// I q″ = −F(δ, δ̇) j + gravity + spring follows from the angle alone; then with a damper curve and a drive on the line of the spring, and a
/// drive at the hinge. The reference is integrated by the Runge-Kutta method of order 4 with steps of 1e-4 of the duration. The energies of
/// the motion are balanced to the tolerance of the steps.
#[test]
fn forces_between_points_act() {
    let (mass, speed, rate, free, q0) = (6.0, 1.4, 9e3, 0.9, 0.3);
    let mechanism = body(JointKind::Revolute, mass);
    let (pose, contact) = at(&mechanism, q0, Vector3::y());
    let (ground, bar) = (mechanism.root(), contact.link);
    let (anchor, seat) = (Vector3::new(0.2, 0.9, 0.0), Vector3::new(0.7, 0.0, 0.0));
    let alone = PointSpring::new([(ground, anchor), (bar, seat)], rate, Some(free));
    let gravity = Vector3::new(0.0, -9.81, 0.0);
    let curve = |x: f64| if x < 0.01 { 4e4 * x } else { 400.0 + 2e5 * (x - 0.01) };
    let force = |x: f64, v: f64| curve(x.max(0.0)) * (1.0 + 1.5 * v).max(0.0);
    let damper =
        DamperCurve::new(vec![-1.0, -0.1, 0.0, 0.2], vec![-400.0, -90.0, 0.0, 150.0]).expect("a curve");
    let with_damper = PointSpring { damper: Some(Arc::new(damper.clone())), drive: -120.0, ..alone.clone() };
    let before = motion(&pose, &contact, speed);
    let hinge = mechanism.find_joint("joint").expect("a joint");
    let mut restitutions = Vec::new();
    for (spring, torque, is_conservative) in [(&alone, 0.0, true), (&with_damper, 35.0, false)] {
        let drive = JointSpring {
            joint: hinge,
            other: None,
            stiffness: 0.0,
            damping: 0.0,
            free_position: None,
            drive: torque,
        };
        let conditions = TimeConditions {
            gravity,
            springs: vec![drive],
            point_springs: vec![spring.clone()],
            corners: vec![0.01],
            samples_within_steps: 9,
            ..TimeConditions::default()
        };
        let found = impact_in_time(&pose, &contact, speed, &before, &force, &conditions).expect("an impact");
        // State: angle, rate, penetration. The tip closes with j q′, j = cos q.
        let acceleration = |[q, u, x]: [f64; 3]| {
            let tip = |length: f64| Vector3::new(q.cos(), q.sin(), 0.0) * length;
            let arm = |length: f64| Vector3::new(-q.sin(), q.cos(), 0.0) * length;
            let line = tip(0.7) - anchor;
            let damping = spring
                .damper
                .as_ref()
                .map_or(0.0, |damper| damper.force(line.normalize().dot(&arm(0.7)) * u));
            let push = line.normalize() * (rate * (free - line.norm()) - damping + spring.drive);
            let weight = arm(0.5).dot(&gravity) * mass;
            let moment = arm(0.7).dot(&push) + weight + torque - q.cos() * force(x, q.cos() * u);
            moment / (mass / 3.0)
        };
        let rates = |y: [f64; 3]| [y[1], acceleration(y), y[0].cos() * y[1]];
        let along = |y: [f64; 3], d: [f64; 3], h: f64| [y[0] + h * d[0], y[1] + h * d[1], y[2] + h * d[2]];
        let h = found.duration * 1e-4;
        let (mut y, mut deepest) = ([q0, speed / q0.cos(), 0.0], 0.0f64);
        let end = loop {
            let a = rates(y);
            let b = rates(along(y, a, 0.5 * h));
            let c = rates(along(y, b, 0.5 * h));
            let d = rates(along(y, c, h));
            let mean = std::array::from_fn(|k| (a[k] + 2.0 * (b[k] + c[k]) + d[k]) / 6.0);
            let next = along(y, mean, h);
            if next[2] <= 0.0 && next[1] < 0.0 {
                let part = y[2] / (y[2] - next[2]);
                break along(y, mean, part * h);
            }
            deepest = deepest.max(next[2]);
            y = next;
        };
        // The kinks and the last step of the reference: (1e-4)².
        let restitution = -end[0].cos() * end[1] / speed;
        assert!((found.restitution - restitution).abs() < 1e-7, "{} {restitution}", found.restitution);
        assert!((found.max_penetration / deepest - 1.0).abs() < 1e-7, "{} {deepest}", found.max_penetration);
        let energy = found.energy;
        assert!(energy.residual().abs() < 1e-9 * energy.kinetic_before, "{energy:?}");
        // The bar is back at its first angle: gravity and springs have done no work.
        let work = energy.work_of_other_forces.abs() / energy.kinetic_before;
        assert_eq!(work < 1e-9, is_conservative, "{energy:?}");
        restitutions.push(restitution);
    }
    let without = TimeConditions { corners: vec![0.01], ..TimeConditions::default() };
    let without = impact_in_time(&pose, &contact, speed, &before, &force, &without).expect("an impact");
    restitutions.push(without.restitution);
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        assert!((restitutions[i] - restitutions[j]).abs() > 0.01, "{restitutions:?}");
    }
    for wrong in [PointSpring { rate: -1.0, ..alone.clone() }, PointSpring { drive: f64::NAN, ..alone }] {
        let wrong = TimeConditions { point_springs: vec![wrong], ..TimeConditions::default() };
        let refused = impact_in_time(&pose, &contact, speed, &before, &force, &wrong);
        assert!(matches!(refused, Err(ImpactError::PointSpring { .. })), "{refused:?}");
    }
}

/// A block on a slide with a support of an inner point by the ground across it, on which it stands with a force at the touch: the support is left
/// during the contact, or not. The reference is integrated by the Runge-Kutta method of order 4.
#[test]
fn a_support_is_left() {
    let (mass, speed, k) = (40.0, 1.2, 9e4);
    let mechanism = body(JointKind::Prismatic, mass);
    let (pose, contact) = at(&mechanism, 0.2, Vector3::x());
    let force = |x: f64, v: f64| (k * x.max(0.0) + 600.0 * v).max(0.0);
    let before = motion(&pose, &contact, speed);
    for (rate, damping, load, is_balanced) in [
        (2.1e5, 300.0, 1500.0, true),
        (2.1e5, 300.0, 1500.0, false),
        (3e4, 0.0, 4e3, true),
        (3e4, 900.0, 0.0, true),
    ] {
        let support = Support {
            link: contact.link,
            point: Vector3::new(0.3, 0.1, 0.0),
            direction: Vector3::x(),
            rate,
            damping,
            force: load,
            is_balanced,
        };
        let conditions =
            TimeConditions { supports: vec![support], ends_without_force: true, ..TimeConditions::default() };
        let found = impact_in_time(&pose, &contact, speed, &before, &force, &conditions).expect("an impact");
        let rates = |[x, v]: [f64; 2]| {
            let of_support = (load - rate * x - damping * v).max(0.0) - if is_balanced { load } else { 0.0 };
            [v, (of_support - force(x, v)) / mass]
        };
        let along = |y: [f64; 2], d: [f64; 2], h: f64| [y[0] + h * d[0], y[1] + h * d[1]];
        let h = found.duration * 1e-5;
        let (mut y, mut deepest) = ([0.0, speed], 0.0f64);
        let end = loop {
            let a = rates(y);
            let b = rates(along(y, a, 0.5 * h));
            let c = rates(along(y, b, 0.5 * h));
            let d = rates(along(y, c, h));
            let next: [f64; 2] =
                std::array::from_fn(|i| y[i] + h * (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0);
            if next[1] < 0.0 && force(next[0], next[1]) <= 0.0 {
                let (f, g) = (force(y[0], y[1]), k * next[0] + 600.0 * next[1]);
                break y[1] + f / (f - g) * (next[1] - y[1]);
            }
            deepest = deepest.max(next[0]);
            y = next;
        };
        // Steps of the reference across the kink: 1e-5 of the duration, squared, times the change of the slope.
        assert!((found.restitution + end / speed).abs() < 1e-8, "{} {}", found.restitution, -end / speed);
        assert!((found.max_penetration / deepest - 1.0).abs() < 1e-8, "{} {deepest}", found.max_penetration);
        assert!(found.energy.residual().abs() < 1e-9 * found.energy.kinetic_before, "{:?}", found.energy);
    }
    let wrong = Support {
        link: contact.link,
        point: Vector3::zeros(),
        direction: Vector3::new(2.0, 0.0, 0.0),
        rate: 1.0,
        damping: 0.0,
        force: 0.0,
        is_balanced: true,
    };
    let wrong = TimeConditions { supports: vec![wrong], ..TimeConditions::default() };
    let refused = impact_in_time(&pose, &contact, speed, &before, &force, &wrong);
    assert!(matches!(refused, Err(ImpactError::Support { .. })), "{refused:?}");
}
