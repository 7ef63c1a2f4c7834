//! Impacts of double pendulums with a force curve, three dampings of it, a spring with a preload, a damper curve and gravity, against the
//! integration of equations that are written here for two freedoms.

use super::motion;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use percuss_contact::DamperCurve;
use percuss_dynamics::{Conditions, Contact, Direction, Frame, System};
use percuss_impact::{ImpactError, PointSpring, TimeConditions, impact_in_time};
use percuss_mechanism::{Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder};
use percuss_spatial::Transform;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Steps of the reference in the time of an undamped linear contact with the penetration of the curve: the corners of the curves cost 1e-8.
const STEPS: f64 = 20_000.0;

/// Two arms in the plane x, y: masses, distances of their centres from the hinges, inertias about the centres, length of the first.
struct Arms {
    mass: [f64; 2],
    centre: [f64; 2],
    inertia: [f64; 2],
    length: f64,
}

impl Arms {
    fn random(rng: &mut StdRng) -> Self {
        let mut two = |low: f64, high: f64| [rng.random_range(low..high), rng.random_range(low..high)];
        let (mass, centre, inertia) = (two(0.5, 8.0), two(0.05, 0.3), two(0.005, 0.1));
        Self { mass, centre, inertia, length: two(0.2, 0.6)[0] }
    }

    /// Point at the distance `x` along an arm, and its motion per rate.
    fn point(&self, q: Vector2<f64>, arm: usize, x: f64) -> (Vector2<f64>, Matrix2<f64>) {
        let along = |angle: f64| Vector2::new(angle.cos(), angle.sin());
        let across = |angle: f64| Vector2::new(-angle.sin(), angle.cos());
        if arm == 0 {
            return (along(q.x) * x, Matrix2::from_columns(&[across(q.x) * x, Vector2::zeros()]));
        }
        let both = q.x + q.y;
        let of_second = across(both) * x;
        let columns = [across(q.x) * self.length + of_second, of_second];
        (along(q.x) * self.length + along(both) * x, Matrix2::from_columns(&columns))
    }

    fn mass_matrix(&self, q: Vector2<f64>) -> Matrix2<f64> {
        let turns = [Matrix2::new(1.0, 0.0, 0.0, 0.0), Matrix2::new(1.0, 1.0, 1.0, 1.0)];
        (0..2).fold(Matrix2::zeros(), |sum, arm| {
            let motion = self.point(q, arm, self.centre[arm]).1;
            sum + motion.transpose() * motion * self.mass[arm] + turns[arm] * self.inertia[arm]
        })
    }

    /// Generalised forces of the centripetal accelerations and of gravity.
    fn bias(&self, q: Vector2<f64>, u: Vector2<f64>, gravity: f64) -> Vector2<f64> {
        let towards = |angle: f64, rate: f64| Vector2::new(angle.cos(), angle.sin()) * (-rate * rate);
        let (first, second) = (towards(q.x, u.x), towards(q.x + q.y, u.x + u.y));
        let centripetal = [first * self.centre[0], first * self.length + second * self.centre[1]];
        (0..2).fold(Vector2::zeros(), |sum, arm| {
            let motion = self.point(q, arm, self.centre[arm]).1;
            let push = -centripetal[arm] - Vector2::new(0.0, gravity);
            sum + motion.transpose() * push * self.mass[arm]
        })
    }
}

/// Force of a curve by points, with lines between and beyond them.
fn on_lines(points: &[(f64, f64)], x: f64) -> f64 {
    let i = points.partition_point(|(at, _)| *at <= x).clamp(1, points.len() - 1);
    let ((x0, f0), (x1, f1)) = (points[i - 1], points[i]);
    f0 + (x - x0) * (f1 - f0) / (x1 - x0)
}

#[test]
fn double_pendulums_are_those_of_their_own_equations() {
    let mut rng = StdRng::seed_from_u64(52);
    let mut lasting = 0;
    for case in 0..9 {
        let arms = Arms::random(&mut rng);
        let q0 = Vector2::new(rng.random_range(-1.2..1.2), rng.random_range(-1.2..1.2));
        let (tip, angle) = (rng.random_range(0.15..0.5), rng.random_range(0.0..TAU));
        let (normal, speed) = (Vector2::new(angle.cos(), angle.sin()), rng.random_range(0.3..2.0));
        let (start, tip_motion) = arms.point(q0, 1, tip);
        let row = tip_motion.transpose() * normal;
        let response = arms.mass_matrix(q0).try_inverse().expect("a mass") * row;
        let mass = 1.0 / row.dot(&response);
        let (depth, energy) = (rng.random_range(2e-3..1.5e-2), 0.5 * mass * speed * speed);
        let last = 2.0 * energy / depth * rng.random_range(0.8..2.5);
        let curve = [(0.0, 0.0), (0.3 * depth, 0.1 * last), (0.7 * depth, 0.4 * last), (depth, last)];
        let stiffness = last / depth;
        let (kind, size) = (case % 3, rng.random_range(0.1..1.0));
        let damping = size * 0.8 * (stiffness * mass).sqrt();
        let (dissipation, hysteresis) = (2.0 * size / speed, 0.4 * size);
        let force = |x: f64, v: f64| {
            let spring = if x < 0.0 { 0.0 } else { on_lines(&curve, x) };
            match kind {
                0 => spring + damping * v,
                1 => spring * (1.0 + dissipation * v).max(0.0),
                _ => spring * (1.0 + if v == 0.0 { 0.0 } else { hysteresis.copysign(v) }),
            }
        };
        let (seat, anchor) = (rng.random_range(0.1..0.4), Vector2::new(rng.random_range(-0.5..0.5), 1.1));
        let (rate, gravity) =
            (stiffness * rng.random_range(0.01..0.1), if case % 2 == 0 { 9.81 } else { 0.0 });
        let free =
            (arms.point(q0, 1, seat).0 - anchor).norm() + 0.01 * last / rate * rng.random_range(-0.5..1.0);
        let (eye, foot) = (rng.random_range(0.1..0.3), Vector2::new(rng.random_range(-0.5..0.5), -1.1));
        let unit = mass * speed / 0.05 * rng.random_range(0.05..0.3);
        let damper = [(-0.5, -3.0 * unit), (-0.1, -unit), (0.0, 0.0), (0.15, 2.0 * unit), (1.0, 4.0 * unit)];

        // percuss.
        let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
        let mut builder = MechanismBuilder::new("arms").link(LinkDescription::new("ground", none));
        for (arm, (name, parent)) in [("a", "ground"), ("b", "a")].into_iter().enumerate() {
            let inertial = Inertial {
                mass: arms.mass[arm],
                com: Vector3::x() * arms.centre[arm],
                about_com: Matrix3::identity() * arms.inertia[arm],
            };
            let mut hinge =
                JointDescription::new(format!("hinge of {name}"), JointKind::Continuous, parent, name);
            hinge.axis = Vector3::z();
            hinge.origin =
                Transform::from_translation(Vector3::x() * if arm == 0 { 0.0 } else { arms.length });
            builder = builder.link(LinkDescription::new(name, inertial)).joint(hinge);
        }
        let mechanism = Arc::new(builder.build().expect("a mechanism").mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let mut configuration = system.configuration();
        configuration.set("hinge of a", &[q0.x]).expect("a position");
        configuration.set("hinge of b", &[q0.y]).expect("a position");
        let pose = system.pose(&configuration).expect("a pose");
        let link = |name: &str| mechanism.find_link(name).expect("a link");
        let in_space = |v: Vector2<f64>| Vector3::new(v.x, v.y, 0.0);
        let contact = Contact {
            link: link("b"),
            against: None,
            point: Vector3::x() * tip,
            normal: Direction::Along(in_space(normal), Frame::World),
        };
        let (speeds, forces) = damper.iter().copied().unzip();
        let curve_of_damper = Some(Arc::new(DamperCurve::new(speeds, forces).expect("a curve")));
        let ground = mechanism.root();
        let conditions = TimeConditions {
            gravity: Vector3::new(0.0, -gravity, 0.0),
            point_springs: vec![
                PointSpring::new(
                    [(link("b"), Vector3::x() * seat), (ground, in_space(anchor))],
                    rate,
                    Some(free),
                ),
                PointSpring {
                    damper: curve_of_damper,
                    ..PointSpring::new([(link("a"), Vector3::x() * eye), (ground, in_space(foot))], 0.0, None)
                },
            ],
            ends_without_force: kind == 0,
            jumps_at_reversal: kind == 2,
            corners: curve[1..].iter().map(|(x, _)| *x).collect(),
            samples_within_steps: 9,
            ..TimeConditions::default()
        };
        let before = motion(&pose, &contact, speed);
        let found = match impact_in_time(&pose, &contact, speed, &before, &force, &conditions) {
            Ok(found) => found,
            // Spring and weight press the sides together.
            Err(ImpactError::EndlessContact { .. }) => continue,
            Err(error) => panic!("{case}: {error}"),
        };
        assert!(
            found.energy.residual().abs() < 1e-9 * found.energy.kinetic_before,
            "{case}: {:?}",
            found.energy
        );

        // Reference: the force of one direction between the reversals, which end a step.
        let mut closes = true;
        let contact_of = |q: Vector2<f64>, u: Vector2<f64>| {
            let (at, motion) = arms.point(q, 1, tip);
            (normal.dot(&(at - start)), normal.dot(&(motion * u)), motion.transpose() * normal)
        };
        let of_phase = |closes: bool, x: f64, v: f64| match kind {
            2 => force(x, if closes { 1.0 } else { -1.0 }),
            _ => force(x, v),
        };
        let rates = |closes: bool, (q, u): (Vector2<f64>, Vector2<f64>)| {
            let (x, v, row) = contact_of(q, u);
            let line = |arm: usize, along: f64, other: Vector2<f64>| {
                let (at, motion) = arms.point(q, arm, along);
                (motion.transpose() * (at - other).normalize(), (at - other).norm())
            };
            let ((spring, length), (strut, _)) = (line(1, seat, anchor), line(0, eye, foot));
            let others = spring * (rate * (free - length)) - strut * on_lines(&damper, strut.dot(&u));
            let pushes = others + arms.bias(q, u, gravity) - row * of_phase(closes, x, v);
            (u, arms.mass_matrix(q).try_inverse().expect("a mass") * pushes)
        };
        let step = |closes: bool, (q, u): (Vector2<f64>, Vector2<f64>), h: f64| {
            let along = |d: (Vector2<f64>, Vector2<f64>), h: f64| (q + d.0 * h, u + d.1 * h);
            let a = rates(closes, (q, u));
            let b = rates(closes, along(a, 0.5 * h));
            let c = rates(closes, along(b, 0.5 * h));
            let d = rates(closes, along(c, h));
            along(((a.0 + (b.0 + c.0) * 2.0 + d.0) / 6.0, (a.1 + (b.1 + c.1) * 2.0 + d.1) / 6.0), h)
        };
        let h = PI * depth / speed / STEPS;
        let mut y = (q0, response * (mass * speed));
        let (mut deepest, mut peak) = (0.0f64, force(0.0, speed));
        let end = loop {
            let next = step(closes, y, h);
            let ((x0, v0, _), (x, v, _)) = (contact_of(y.0, y.1), contact_of(next.0, next.1));
            if kind == 2 && (if closes { v < 0.0 } else { v > 0.0 }) {
                // The speed is linear over a step to 1e-8.
                y = step(closes, y, h * v0 / (v0 - v));
                let (x, _, _) = contact_of(y.0, y.1);
                (deepest, peak) = (deepest.max(x), peak.max(of_phase(closes, x, 0.0)));
                closes = !closes;
                continue;
            }
            let remaining = |x: f64, v: f64| if kind == 0 { force(x, v) } else { x };
            if v < 0.0 && (remaining(x, v) <= 0.0 || x <= 0.0) {
                let (before, after) = (remaining(x0, v0), remaining(x, v));
                break step(closes, y, h * before / (before - after));
            }
            y = next;
            (deepest, peak) = (deepest.max(x), peak.max(of_phase(closes, x, v)));
        };
        let restitution = -contact_of(end.0, end.1).1 / speed;
        let what =
            format!("{case}: {restitution} {deepest} {peak} {:?}", (found.restitution, found.peak_force));
        assert!((found.restitution - restitution).abs() < 1e-6, "{what}");
        assert!((found.max_penetration / deepest - 1.0).abs() < 1e-5, "{} {what}", found.max_penetration);
        assert!((found.peak_force / peak - 1.0).abs() < 1e-5, "{what}");
        lasting += usize::from(found.separates);
    }
    assert!(lasting >= 7, "{lasting} impacts with an end");
}
