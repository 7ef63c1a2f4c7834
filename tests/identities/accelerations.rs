//! Forward dynamics: F/a of two calls equals m̄; accelerations match differences of poses; and d'Alembert's principle
//! holds for every virtual motion, which includes forces that cancel in F/a.

use nalgebra::Vector3;
use percuss_dynamics::{Accelerations, Base, EffectiveMass, PointForce, Pose, RouteError};
use percuss_mechanism::LinkId;
use percuss_tests::cases::{self, Case};
use percuss_tests::differences::{DIFFERENCE, link_twists, second_derivative};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::regular_condition;
use percuss_tests::motion::Motion;
use rand::{Rng, SeedableRng, rngs::StdRng};

/// All cases: models of the zoo and random models.
fn all_cases() -> Vec<Case> {
    [cases::of_the_zoo(6, 2), cases::at_random(6000, 200, 60)].concat()
}

#[test]
fn force_over_acceleration() {
    let mut rng = StdRng::seed_from_u64(22);
    let mut gauge = Gauge::new("F/a");
    let mut immovable = Gauge::new("F/a of an immovable gap");
    let mut refused = 0;
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        let motion = Motion::random(&mut rng, &system);
        let gravity = Vector3::new(0.3, -9.7, 1.4);
        let closing = |forces: &[PointForce]| -> Result<f64, RouteError> {
            let a = pose.accelerations(&motion.joints, &motion.base, &gravity, forces)?;
            let x_ro = pose.link(case.on);
            let at = x_ro.point(&case.point);
            let on = pose.point_acceleration(&a, case.on, &case.point).expect("a link of the pose");
            let other = case.against.map_or_else(Vector3::zeros, |link| {
                let point = pose.link(link).inverse_point(&at);
                pose.point_acceleration(&a, link, &point).expect("a link of the pose")
            });
            Ok(case.normal.dot(&(on - other)))
        };
        let response = pose.respond(&case.contact()).expect("an answer");
        let condition = if response.degrees_of_freedom == 0 { Some(1.0) } else { regular_condition(&pose) };
        let at_rest = match (closing(&[]), condition) {
            (Ok(a), Some(_)) => a,
            (Ok(a), None) => panic!("{}: a singular mass matrix, and yet {a} m/s²", case.name),
            (Err(RouteError::Bound { what: "mimics" }), _) => {
                assert!(case.has_moving_mimics(&system), "{}", case.name);
                refused += 1;
                continue;
            }
            (Err(RouteError::SingularPivot { .. }), None) => {
                refused += 1;
                continue;
            }
            (Err(error), condition) => panic!("{}: {error}, condition {condition:?}", case.name),
        };
        let (condition, m) = (condition.expect("regular"), response.effective_mass);
        // A force that dominates the existing accelerations, so that the difference keeps its digits.
        let heavy = if let EffectiveMass::Finite(m) = m { m } else { 1.0 };
        let push = heavy * (1.0 + at_rest.abs()) * 10.0;
        let mut forces = vec![PointForce { link: case.on, point: case.point, force: case.normal * push }];
        if let Some(link) = case.against {
            let at = pose.link(case.on).point(&case.point);
            let point = pose.link(link).inverse_point(&at);
            forces.push(PointForce { link, point, force: -case.normal * push });
        }
        let Ok(pushed) = closing(&forces) else { panic!("{}: a force changed the inertia", case.name) };
        match m {
            EffectiveMass::Finite(m) => {
                // A gap that hardly closes is a small difference of fast motions.
                let reach = case.mechanism.links().iter().map(percuss_mechanism::Link::extent).sum::<f64>();
                let fast = 1.0 + Motion::of(&response).size() * (reach + case.point.norm());
                let bound = (1e-12 * condition).min(1e-9) + 64.0 * f64::EPSILON * fast;
                gauge.relative(&case.name, push / (pushed - at_rest), m, bound);
            }
            EffectiveMass::Immovable => {
                // Scale: the acceleration of a free body with the total mass.
                let free = push / case.mechanism.total_mass();
                immovable.note(&case.name, (pushed - at_rest).abs() / (free + at_rest.abs()), 1e-9);
            }
            EffectiveMass::Massless => panic!("{}: massless, its mass matrix regular", case.name),
        }
    }
    gauge.report();
    immovable.report();
    assert!(refused > 0, "mimics and singular matrices never came");
}

/// Acceleration of a link in the root link's axes: angular, and of its centre of mass. The field a(p) is affine in p;
/// the skew part of its gradient is the angular acceleration, for any angular velocity.
fn link_acceleration(
    case: &Case,
    pose: &Pose,
    a: &Accelerations,
    link: LinkId,
) -> (Vector3<f64>, Vector3<f64>) {
    let at = |p: Vector3<f64>| pose.point_acceleration(a, link, &p).expect("a link of the pose");
    let rotation = pose.link(link).rotation;
    let origin = at(Vector3::zeros());
    let angular = (0..3).map(|i| {
        let e: Vector3<f64> = Vector3::ith(i, 1.0);
        (rotation * e).cross(&(at(e) - origin)) / 2.0
    });
    let com = case.mechanism.link(link).inertial().map_or_else(Vector3::zeros, |inertial| inertial.com);
    (angular.sum(), at(com))
}

#[test]
fn every_virtual_motion_does_no_work() {
    let mut rng = StdRng::seed_from_u64(62);
    let mut gauge = Gauge::new("d'Alembert");
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        let motion = Motion::random(&mut rng, &system);
        let mut vector = || Vector3::from_fn(|_, _| rng.random_range(-5.0..5.0));
        let (gravity, force) = (vector(), vector());
        let push = PointForce { link: case.on, point: case.point, force };
        let Ok(a) = pose.accelerations(&motion.joints, &motion.base, &gravity, &[push]) else {
            continue;
        };
        let condition = regular_condition(&pose).unwrap_or(1.0);
        let velocities = link_twists(&pose, &motion);
        for _ in 0..2 {
            let virtual_motion = Motion::random(&mut rng, &system);
            let twists = link_twists(&pose, &virtual_motion);
            let (mut work, mut size) = (0.0, 0.0);
            let mut add = |term: f64| {
                work += term;
                size += term.abs();
            };
            for id in case.mechanism.link_ids() {
                let (twist, rotation) = (twists[id.index()], pose.link(id).rotation);
                if let Some(inertial) = case.mechanism.link(id).inertial() {
                    let (alpha, a_c) = link_acceleration(&case, &pose, &a, id);
                    let (alpha, a_c) = (rotation.tr_mul(&alpha), rotation.tr_mul(&a_c));
                    let fall = rotation.tr_mul(&gravity);
                    let omega = velocities[id.index()].angular;
                    let spin = omega.cross(&(inertial.about_com * omega));
                    let v_c = twist.velocity_at(&inertial.com);
                    add(inertial.mass * v_c.dot(&a_c));
                    add(-inertial.mass * v_c.dot(&fall));
                    add(twist.angular.dot(&(inertial.about_com * alpha)));
                    add(twist.angular.dot(&spin));
                }
                if id == case.on {
                    add(-rotation.tr_mul(&force).dot(&twist.velocity_at(&case.point)));
                }
            }
            for id in case.mechanism.joint_ids() {
                let (rates, virtual_rates) = (&a.joints[id.index()], &virtual_motion.joints[id.index()]);
                for ((rotor, rate), v) in case.armature(id).iter().zip(rates).zip(virtual_rates) {
                    add(rotor * rate * v);
                }
            }
            // Virtual velocities have the error of differences; accelerations have the rounding of a recursion.
            if size > 0.0 {
                let fast = virtual_motion.size().max(motion.size());
                let bound = (DIFFERENCE * (1.0 + fast) + 1e-13 * condition).min(1e-7);
                gauge.note(&case.name, work.abs() / size, bound);
            }
        }
    }
    gauge.report();
}

#[test]
fn accelerations_are_those_of_the_poses() {
    let mut rng = StdRng::seed_from_u64(63);
    let mut gauge = Gauge::new("acceleration of a point");
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        // The acceleration of a floating base is not given; models with floating joints cover this case.
        let motion = Motion::random(&mut rng, &system);
        if system.base() == Base::Floating || motion.size() == 0.0 {
            continue;
        }
        let gravity = Vector3::new(0.3, -9.7, 1.4);
        let Ok(a) = pose.accelerations(&motion.joints, &motion.base, &gravity, &[]) else {
            continue;
        };
        let expected = second_derivative(&motion, &a.joints, |velocities, h| {
            let later = pose.advanced(velocities, &motion.base, h).expect("velocities that fit");
            later.link(case.on).point(&case.point)
        });
        let got = pose.point_acceleration(&a, case.on, &case.point).expect("a link of the pose");
        let reach = case.mechanism.links().iter().map(percuss_mechanism::Link::extent).sum::<f64>();
        let rates = a.joints.iter().flatten().map(|rate| rate.abs()).sum::<f64>();
        let size = (motion.size().powi(2) + rates) * (1.0 + reach);
        gauge.note(&case.name, (got - expected).norm() / size, 1e-9);
    }
    gauge.report();
}
