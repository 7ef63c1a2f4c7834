//! Largest forces in bearings at corners of force curves and of damper curves.

use super::{at, body, motion};
use nalgebra::Vector3;
use percuss_contact::DamperCurve;
use percuss_impact::{PointSpring, TimeConditions, impact_in_time};
use percuss_mechanism::JointKind;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::sync::Arc;

/// Steps of the reference in the duration of the contact: a smooth maximum has the error (π/STEPS)²/8.
const STEPS: f64 = 1e4;
/// Speeds of the damper curve, m/s.
const KNOTS: [f64; 5] = [-2.0, -0.15, 0.0, 0.1, 3.0];

/// A hinged bar hits a force curve of random points with a damper, and has a damper curve between two points. Reference: I q″ and the hinge force
/// m a − m g + F n̂ − P by the Runge-Kutta method of order 4, with a step that ends at each point of the curves.
#[test]
fn hinge_forces_have_their_peaks_at_corners() {
    let mut rng = StdRng::seed_from_u64(14_360);
    let (mut at_corners, mut checked) = (0, 0);
    for case in 0..30 {
        let (mass, speed, q0): (f64, f64, f64) =
            (rng.random_range(2.0..9.0), rng.random_range(0.4..2.0), rng.random_range(-0.9..0.9));
        let mechanism = body(JointKind::Continuous, mass);
        let (pose, contact) = at(&mechanism, q0, Vector3::y());
        let depth: f64 = rng.random_range(0.004..0.02);
        // A slope that falls at a corner gives a peak there.
        let mut slope = mass / 3.0 * (speed / depth).powi(2) * rng.random_range(1.0..4.0);
        let first = slope;
        let mut points = vec![(0.0, 0.0)];
        for _ in 0..rng.random_range(2..6) {
            let (x, f) = points[points.len() - 1];
            let width = depth * rng.random_range(0.1..0.4);
            points.push((x + width, f + slope * width));
            slope = first * rng.random_range(0.02..1.2);
        }
        let last = points[points.len() - 1];
        points.push((last.0 + depth, last.1 + slope * depth));
        let curve = |points: &[(f64, f64)], x: f64| {
            let i = points.partition_point(|(at, _)| *at <= x).clamp(1, points.len() - 1);
            let ((x0, f0), (x1, f1)) = (points[i - 1], points[i]);
            f0 + (x - x0) * (f1 - f0) / (x1 - x0)
        };
        let damping: f64 = rng.random_range(0.0..0.5) * (first * mass / 3.0).sqrt();
        let unit = if case % 2 == 0 { 0.0 } else { 0.1 * first * depth };
        let forces = [-1.5 * unit, -unit, 0.0, 0.7 * unit, 1.2 * unit];
        let damper = DamperCurve::new(KNOTS.to_vec(), forces.to_vec()).expect("a curve");
        let (anchor, seat) = (Vector3::new(0.3, 1.0, 0.0), Vector3::new(0.6, 0.0, 0.0));
        let ends = [(mechanism.root(), anchor), (contact.link, seat)];
        let line =
            PointSpring { damper: Some(Arc::new(damper.clone())), ..PointSpring::new(ends, 0.0, None) };
        let gravity = Vector3::new(1.0, -9.81, 0.0);
        let before = motion(&pose, &contact, speed);
        let run = |points: &[(f64, f64)]| {
            let conditions = TimeConditions {
                gravity,
                point_springs: if case % 2 == 0 { Vec::new() } else { vec![line.clone()] },
                corners: points[1..].iter().map(|(x, _)| *x).collect(),
                samples_within_steps: 9,
                ..TimeConditions::default()
            };
            let force = |x: f64, v: f64| curve(points, x) + damping * v;
            let found = impact_in_time(&pose, &contact, speed, &before, &force, &conditions);
            found.ok().filter(|found| found.separates)
        };
        let Some(mut found) = run(&points) else { continue };
        if case % 3 == 0 {
            // A point that the penetration passes shortly before its maximum.
            let x = found.max_penetration * (1.0 - 10.0_f64.powf(rng.random_range(-7.0..-1.0)));
            let f = curve(&points, x);
            points.retain(|(at, _)| *at < x);
            points.extend([(x, f), (x + depth, f + 5.0 * first * depth)]);
            found = run(&points).expect("an impact");
        }
        let force = |x: f64, v: f64| curve(&points, x) + damping * v;
        let tip = |q: f64, length: f64| Vector3::new(q.cos(), q.sin(), 0.0) * length;
        let arm = |q: f64, length: f64| Vector3::new(-q.sin(), q.cos(), 0.0) * length;
        // Acceleration and size of the hinge force.
        let state = |[q, u, x]: [f64; 3]| {
            let line = (tip(q, 0.6) - anchor).normalize();
            let push = line * -damper.force(line.dot(&arm(q, 0.6)) * u);
            let stop = force(x, q.cos() * u);
            let moment = arm(q, 0.6).dot(&push) + arm(q, 0.5).dot(&gravity) * mass - q.cos() * stop;
            let change = moment / (mass / 3.0);
            let of_com = arm(q, 0.5) * change - tip(q, 0.5) * (u * u);
            (change, ((of_com - gravity) * mass + Vector3::y() * stop - push).norm())
        };
        let rates = |y: [f64; 3]| [y[1], state(y).0, y[0].cos() * y[1]];
        let along = |y: [f64; 3], d: [f64; 3], h: f64| [y[0] + h * d[0], y[1] + h * d[1], y[2] + h * d[2]];
        let step = |y: [f64; 3], h: f64| {
            let a = rates(y);
            let b = rates(along(y, a, 0.5 * h));
            let c = rates(along(y, b, 0.5 * h));
            let d = rates(along(y, c, h));
            along(y, std::array::from_fn(|k| (a[k] + 2.0 * (b[k] + c[k]) + d[k]) / 6.0), h)
        };
        // Distances from the corners of both curves, and the penetration.
        let distances = |y: [f64; 3]| {
            let speed = (tip(y[0], 0.6) - anchor).normalize().dot(&arm(y[0], 0.6)) * y[1];
            let of_curve = points[1..].iter().map(|(x, _)| y[2] - x);
            let knots = if unit > 0.0 { &KNOTS[1..4] } else { &[] };
            of_curve.chain(knots.iter().map(|v| speed - v)).chain([y[2]]).collect::<Vec<f64>>()
        };
        // Part of a step after which a distance changes its sign.
        let part = |y: [f64; 3], h: f64, i: usize| {
            let (mut low, mut high, sign) = (0.0, h, distances(y)[i].signum());
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if distances(step(y, middle))[i] * sign > 0.0 { low = middle } else { high = middle }
            }
            high
        };
        let h = found.duration / STEPS;
        let mut y = step([q0, speed / q0.cos(), 0.0], 1e-9 * h);
        let (mut peak, mut is_at_corner) = (state(y).1, false);
        loop {
            let (now, next) = (distances(y), distances(step(y, h)));
            let changes = (0..now.len()).filter(|i| now[*i] * next[*i] < 0.0);
            let first = changes.map(|i| (part(y, h, i), i)).min_by(|a, b| a.0.total_cmp(&b.0));
            y = step(y, first.map_or(h, |(h, _)| h));
            if state(y).1 > peak {
                (peak, is_at_corner) = (state(y).1, first.is_some());
            }
            if first.is_some_and(|(_, i)| i + 1 == now.len()) {
                break;
            }
        }
        let [hinge, ground] = found.bearing_peaks[..] else { panic!("two bearings") };
        assert!((hinge.0 / peak - 1.0).abs() < 1e-7, "{case}: {hinge:?} {peak} {is_at_corner}");
        // The damper curve acts between the bar and the ground too.
        assert!(case % 2 == 1 || (ground.0 / peak - 1.0).abs() < 1e-7, "{case}: {}", ground.0);
        let largest = found.samples.iter().map(|s| s.reactions.determinate_forces()[0]).fold(0.0, f64::max);
        assert!(hinge.0 >= largest && hinge.1 <= found.duration, "{case}: {largest} {hinge:?}");
        checked += 1;
        at_corners += usize::from(is_at_corner);
    }
    assert!(checked >= 25 && at_corners >= 8, "{at_corners} of {checked} peaks at corners");
}
