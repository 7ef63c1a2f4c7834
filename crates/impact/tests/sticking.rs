//! Plastic impacts with sticking points: rimless wheel, compass gait.

use crate::cases::all;
use nalgebra::{DVector, Matrix2, Matrix3, Vector2, Vector3};
use percuss_dynamics::{Base, Conditions, Contact, Direction, Frame, Pose, System};
use percuss_impact::{
    ContactsLaw, Delassus, DriverRate, ImpactError, JointRates, SimultaneousLaw, rates_from_drivers,
    simultaneous_impact, state_impact, sticking_impact,
};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::Twist;
use std::sync::Arc;

const ROUNDING: f64 = 1e-12;

fn pose_of(mechanism: &Arc<Mechanism>, base: Base, set: &[(&str, &[f64])]) -> Pose {
    let system = System::new(Arc::clone(mechanism), &Conditions::new().base(base)).expect("a system");
    let mut configuration = system.configuration();
    for (joint, value) in set {
        configuration.set(joint, value).expect("a position");
    }
    system.pose(&configuration).expect("a pose")
}

/// Foot on the ground below.
fn foot(mechanism: &Mechanism, link: &str, point: Vector3<f64>) -> Contact {
    let link = mechanism.find_link(link).expect("a link");
    Contact { link, against: None, point, normal: Direction::Along(-Vector3::y(), Frame::World) }
}

#[test]
fn the_rimless_wheel_keeps_the_cosine() {
    // Hub mass 1, spokes of length 1, inertia k²: ω⁺/ω⁻ = (k² + cos 2α)/(k² + 1).
    for k2 in [0.0_f64, 0.1, 0.5] {
        for alpha in [0.2_f64, 0.4, 0.7] {
            let about_com =
                Matrix3::from_diagonal(&Vector3::new(0.01 + 0.5 * k2, 0.01 + 0.5 * k2, k2.max(1e-14)));
            let hub = Inertial { mass: 1.0, com: Vector3::zeros(), about_com };
            let about_com = if k2 == 0.0 { Matrix3::zeros() } else { about_com };
            let builder = MechanismBuilder::new("wheel")
                .link(LinkDescription::new("hub", Inertial { about_com, ..hub }));
            let Ok(built) = builder.build() else { continue };
            let wheel = Arc::new(built.mechanism);
            let pose = pose_of(&wheel, Base::Floating, &[]);
            let (s, c) = alpha.sin_cos();
            let feet = [Vector3::new(s, -c, 0.0), Vector3::new(-s, -c, 0.0)];
            let contacts = feet.map(|at| pose.locate(&foot(&wheel, "hub", at)).expect("a contact"));
            // A point mass without inertia turns without mass: the front foot then transmits along the spoke only.
            let Ok(delassus) = Delassus::new(&pose, &contacts) else {
                assert!(k2 == 0.0);
                continue;
            };
            // It turns about the rear foot, clockwise.
            let angular = Vector3::new(0.0, 0.0, -2.0);
            let before =
                JointRates { joints: Vec::new(), base: Twist::new(angular, angular.cross(&-feet[1])) };
            let u = delassus.velocities(&pose, &before);
            assert!(u.rows(3, 3).amax() < ROUNDING && u[0] < 0.0);
            let impact = sticking_impact(&delassus, &u).expect("an impact");
            assert!(impact.contacts[0].sticks && !impact.contacts[1].sticks, "{impact:?}");
            assert_eq!(impact.consistent_subsets, 1);
            let change = delassus.rate_change(&pose, &impact.impulses);
            let after = before.base.angular.z + change.base.angular.z;
            let expected = -2.0 * (k2 + (2.0 * alpha).cos()) / (k2 + 1.0);
            assert!((after - expected).abs() < ROUNDING, "{k2} {alpha}: {after} {expected}");
            // The map gives the same rates.
            let rates =
                DVector::from_vec(vec![0.0, 0.0, -2.0, before.base.linear.x, before.base.linear.y, 0.0]);
            let mapped = &impact.map * rates;
            assert!((mapped[2] - expected).abs() < ROUNDING, "{mapped}");
            // Applied twice it changes nothing: the foot rests already.
            assert!((&impact.map * &impact.map - &impact.map).amax() < ROUNDING);
            let loss = 0.5 * (k2 + 1.0) * (4.0 - expected * expected);
            assert!((impact.energy_loss - loss).abs() < ROUNDING, "{} {loss}", impact.energy_loss);
        }
    }
}

/// Compass: two legs of length a + b with the mass m at a from the foot, and the hip mass on the first leg. Planar motion.
fn compass(m: f64, hip: f64, a: f64, b: f64) -> Arc<Mechanism> {
    let small = Matrix3::from_diagonal(&Vector3::new(0.1, 0.1, 0.0));
    let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let leg = |hip: f64| {
        // Centre and inertia about z of a point m at −b and a point of the hip mass at 0, on the leg's line y.
        let mass = m + hip;
        let com = -b * m / mass;
        let about = m * (b + com) * (b + com) + hip * com * com;
        let about_com = small + Matrix3::from_diagonal(&Vector3::new(about, 0.0, about));
        Inertial { mass, com: Vector3::new(0.0, com, 0.0), about_com }
    };
    let _ = a;
    let mut builder = MechanismBuilder::new("compass").link(LinkDescription::new("ground", none));
    builder = builder.link(LinkDescription::new("stance", leg(hip)));
    let mut plane = JointDescription::new("plane", JointKind::Planar, "ground", "stance");
    plane.axis = Vector3::z();
    builder = builder.joint(plane).link(LinkDescription::new("swing", leg(0.0)));
    let mut joint = JointDescription::new("hip", JointKind::Continuous, "stance", "swing");
    joint.axis = Vector3::z();
    Arc::new(builder.joint(joint).build().expect("a mechanism").mechanism)
}

#[test]
fn the_compass_gait_keeps_two_angular_momenta() {
    // Angular momentum of the whole about the new foot, and of the old stance leg about the hip (Goswami 1996).
    let (m, hip, a, b) = (5.0, 10.0, 0.5, 0.5);
    let (mechanism, length) = (compass(m, hip, a, b), a + b);
    let feet = ["swing", "stance"];
    let (mut steps, mut refused) = (0, 0);
    for alpha in [0.1_f64, 0.25, 0.4] {
        // Angles of the legs from the vertical: stance +α, swing −α; the leg points from the hip down.
        let pose =
            pose_of(&mechanism, Base::Fixed, &[("plane", &[0.0, 0.0, -alpha]), ("hip", &[2.0 * alpha])]);
        let contacts = feet.map(|leg| {
            pose.locate(&foot(&mechanism, leg, Vector3::new(0.0, -length, 0.0))).expect("a contact")
        });
        let delassus = Delassus::new(&pose, &contacts).expect("a mobility");
        let leg = |angle: f64| Vector2::new(angle.sin(), -angle.cos());
        let (old, new) = (leg(-alpha), leg(alpha));
        for (w_old, w_new) in
            [(-1.1, -0.4), (-0.8, -1.9), (-1.0, 0.5), (-1.0, 1.5), (-1.0, -1.0), (-1.5, 0.0)]
        {
            // Before: the hip turns with the stance leg about its foot.
            let across = |v: Vector2<f64>| Vector2::new(-v.y, v.x);
            let v_hip = across(-old * length) * w_old;
            let rates = [
                DriverRate {
                    joint: mechanism.find_joint("plane").expect("a joint"),
                    rates: vec![v_hip.x, v_hip.y, w_old],
                },
                DriverRate {
                    joint: mechanism.find_joint("hip").expect("a joint"),
                    rates: vec![w_new - w_old],
                },
            ];
            let before = rates_from_drivers(&pose, &rates, Twist::zero()).expect("rates");
            let u = delassus.velocities(&pose, &before);
            assert!(u.rows(3, 3).amax() < ROUNDING, "{u}");
            if u[0] >= 0.0 {
                assert!(sticking_impact(&delassus, &u).is_err());
                continue;
            }
            // For some rates the old foot neither rests nor lifts with unlimited friction.
            let impact = match sticking_impact(&delassus, &u) {
                Ok(impact) => impact,
                Err(error) => {
                    assert_eq!(error, ImpactError::NoConsistentSubset);
                    refused += 1;
                    continue;
                }
            };
            let after = &impact.contacts;
            assert!(after[0].sticks, "{impact:?}");
            if after[1].sticks {
                refused += 1;
                continue;
            }
            steps += 1;
            let change = delassus.rate_change(&pose, &impact.impulses);
            let found_old = w_old + change.joints[0][2];
            let found_new = w_new + change.joints[0][2] + change.joints[1][0];
            // Momenta as linear functions of (ω_old, ω_new), with the hip at rest on one foot.
            let cross = |p: Vector2<f64>, v: Vector2<f64>| p.x * v.y - p.y * v.x;
            let momenta = |stance: Vector2<f64>, is_new: bool| {
                let column = |w: Vector2<f64>| {
                    let of_stance = if is_new { w.y } else { w.x };
                    let hip_velocity = across(-stance * length) * of_stance;
                    let point = |leg: Vector2<f64>, rate: f64| hip_velocity + across(leg * b) * rate;
                    let (v_old, v_new) = (point(old, w.x), point(new, w.y));
                    // Positions relative to the new foot.
                    let from_foot = |p: Vector2<f64>| p - new * length;
                    let whole = hip * cross(from_foot(Vector2::zeros()), hip_velocity)
                        + m * cross(from_foot(old * b), v_old)
                        + m * cross(from_foot(new * b), v_new);
                    Vector2::new(whole, m * cross(old * b, v_old))
                };
                Matrix2::from_columns(&[column(Vector2::x()), column(Vector2::y())])
            };
            let expected = momenta(new, true).try_inverse().expect("regular")
                * momenta(old, false)
                * Vector2::new(w_old, w_new);
            let error = (expected - Vector2::new(found_old, found_new)).norm();
            assert!(error < ROUNDING, "{alpha}: {found_old} {found_new} {expected}");
            assert!(after[0].required_friction.expect("friction") > 0.0);
            assert!(impact.energy_loss > 0.0);
        }
    }
    println!("{steps} steps, {refused} without a lifting foot");
    assert!(steps >= 6, "{steps} steps, {refused} without a lifting foot");
}

#[test]
fn redundant_feet_leave_the_friction_open() {
    // A box falls on two feet: both stick; the normal impulses are determinate, the tangential ones are not.
    let inertial =
        Inertial { mass: 2.0, com: Vector3::zeros(), about_com: Matrix3::from_diagonal_element(0.1) };
    let builder = MechanismBuilder::new("box").link(LinkDescription::new("box", inertial));
    let body = Arc::new(builder.build().expect("a mechanism").mechanism);
    let pose = pose_of(&body, Base::Floating, &[]);
    let feet = [Vector3::new(0.5, -0.3, 0.0), Vector3::new(-0.5, -0.3, 0.0)];
    let contacts = feet.map(|at| pose.locate(&foot(&body, "box", at)).expect("a contact"));
    let delassus = Delassus::new(&pose, &contacts).expect("a mobility");
    let before =
        JointRates { joints: Vec::new(), base: Twist::new(Vector3::zeros(), Vector3::new(0.2, -1.0, 0.0)) };
    let impact = sticking_impact(&delassus, &delassus.velocities(&pose, &before)).expect("an impact");
    assert!(impact.contacts.iter().all(|c| c.sticks && c.tangential_impulse.is_none()), "{impact:?}");
    // All velocity is lost: Σ p_n = 2, and the moment about the feet's middle, 0.3 · 2 · 0.2, is that of the difference.
    let normal: Vec<f64> = impact.contacts.iter().map(|c| c.normal_impulse.expect("determinate")).collect();
    assert!((normal[0] + normal[1] - 2.0).abs() < ROUNDING);
    assert!(((normal[0] - normal[1]) * 0.5 - 0.3 * 2.0 * 0.2).abs() < ROUNDING, "{normal:?}");
    assert!((impact.energy_loss - 0.5 * 2.0 * 1.04).abs() < ROUNDING);
}

/// Three feet in a line leave the distribution of their normal impulses open, but not its resultant: if the resultant is beyond the outer
/// foot, two feet would pull in every distribution, and only the outer foot sticks.
#[test]
fn open_impulses_cannot_pull_in_every_distribution() {
    for (turning, expected) in [(0.2, 3), (0.9, 3), (1.5, 1), (3.0, 1)] {
        let inertial = Inertial { mass: 1.0, com: Vector3::zeros(), about_com: Matrix3::identity() };
        let builder = MechanismBuilder::new("bar").link(LinkDescription::new("bar", inertial));
        let bar = Arc::new(builder.build().expect("a mechanism").mechanism);
        let pose = pose_of(&bar, Base::Floating, &[]);
        let at =
            [-1.0, 0.0, 1.0].map(|x| pose.locate(&foot(&bar, "bar", Vector3::x() * x)).expect("a contact"));
        let delassus = Delassus::new(&pose, &at).expect("a mobility");
        let twist = Twist::new(Vector3::z() * turning, -Vector3::y());
        let before = JointRates { joints: Vec::new(), base: twist };
        let found = sticking_impact(&delassus, &delassus.velocities(&pose, &before)).expect("an impact");
        let sticks: Vec<bool> = found.contacts.iter().map(|contact| contact.sticks).collect();
        assert_eq!(sticks.iter().filter(|sticks| **sticks).count(), expected, "{turning}: {sticks:?}");
        // The bar turns about z, so that the foot at x = −1 hits first.
        assert!(sticks[0], "{turning}: {sticks:?}");
    }
}

/// Impacts of states are those of the Delassus matrix, by all subsets of sticking contacts: on random mechanisms with up to five points of
/// a link, with equal and with different normals. Without constraints, M and W are factorised with pivots of at least 1e-6: of 16 digits,
/// the rates keep nine.
#[test]
fn impacts_of_states_are_those_of_all_subsets() {
    let (mut all_stick, mut some_stick, mut refused, mut opened) = (0, 0, 0, 0);
    for (number, case) in all(30).into_iter().enumerate() {
        let Ok(response) = case.pose.respond(&case.contact) else { continue };
        let scale = if number % 7 == 0 { -1.0 } else { 1.0 };
        let rates = JointRates { joints: response.joint_velocities.clone(), base: response.base_velocity };
        let rates = JointRates::at_rest(case.pose.mechanism()).plus_scaled(&rates, scale);
        let contacts: Vec<_> = (0..1 + number % 5)
            .map(|k| {
                // Points far from the first, and with the opposite normal, may let go.
                let far = if number % 3 == 0 { 1.0 } else { 30.0 };
                let shift = far * Vector3::new(0.03 * k as f64, 0.05 * (k % 2) as f64, 0.02 * (k % 3) as f64);
                let mut contact = Contact { point: case.contact.point + shift, ..case.contact };
                if let (Some((normal, frame)), true) =
                    (contact.normal.vector(), number % 4 == 1 && k % 2 == 1)
                {
                    contact.normal = Direction::Along(-normal, frame);
                }
                case.pose.locate(&contact).expect("a contact")
            })
            .collect();
        let context = &case.name;
        let found = state_impact(&case.pose, &contacts, &rates, ContactsLaw::Sticking, &[], true);
        let Ok(delassus) = Delassus::new(&case.pose, &contacts) else {
            assert!(found.is_err(), "{context}");
            refused += 1;
            continue;
        };
        let before = delassus.velocities(&case.pose, &rates);
        let expected = match sticking_impact(&delassus, &before) {
            Ok(expected) => expected,
            Err(ImpactError::ClosingSpeed { .. }) => {
                let found = found.expect(context);
                assert!(found.impulses.amax() == 0.0 && found.after == rates, "{context}");
                opened += 1;
                continue;
            }
            Err(error) => {
                assert_eq!(found.err(), Some(error), "{context}");
                refused += 1;
                continue;
            }
        };
        let found = found.expect(context);
        let sticks: Vec<bool> = expected.contacts.iter().map(|contact| contact.sticks).collect();
        let normal: Vec<_> = expected.contacts.iter().map(|contact| contact.normal_impulse).collect();
        let change = delassus.rate_change(&case.pose, &expected.impulses);
        let after = rates.plus_scaled(&change, 1.0);
        let size = change.joints.iter().flatten().fold(1.0_f64, |size, rate| size.max(rate.abs()));
        assert_eq!(found.sticks, sticks, "{context}");
        for (a, b) in found.after.joints.iter().flatten().zip(after.joints.iter().flatten()) {
            assert!((a - b).abs() < 1e-9 * size, "{context}: {a} {b}");
        }
        let largest = expected.impulses.amax();
        for (a, b) in found.normal_impulses.iter().zip(&normal) {
            assert_eq!(a.is_some(), b.is_some(), "{context}");
            assert!((a.unwrap_or(0.0) - b.unwrap_or(0.0)).abs() < 1e-9 * largest, "{context}: {a:?} {b:?}");
        }
        assert!((found.impulses - &expected.impulses).amax() < 1e-9 * largest, "{context}");
        assert!((found.energy_loss - expected.energy_loss).abs() < 1e-9 * expected.energy_loss, "{context}");
        let map = found.map.expect("a map");
        assert!((&map - &expected.map).amax() < 1e-9 * (1.0 + map.amax()), "{context}");
        *(if sticks.iter().all(|sticks| *sticks) { &mut all_stick } else { &mut some_stick }) += 1;
        let law = SimultaneousLaw::Newton;
        let e = vec![0.4; contacts.len()];
        let speeds = DVector::from_fn(contacts.len(), |i, _| before[3 * i]);
        let stiffness = percuss_impact::ContactStiffness { ratios: vec![1.0; e.len()], exponent: 1.0 };
        let expected = simultaneous_impact(&delassus, &speeds, &e, law, &stiffness);
        let found = state_impact(&case.pose, &contacts, &rates, ContactsLaw::Simultaneous(law), &e, false);
        let (Ok(found), Ok(expected)) = (&found, &expected) else {
            assert_eq!(found.as_ref().err(), expected.as_ref().err(), "{context}");
            continue;
        };
        let largest = expected.solution.amax();
        for (a, b) in found.normal_impulses.iter().zip(&expected.impulses) {
            assert_eq!(a.is_some(), b.is_some(), "{context}");
            assert!((a.unwrap_or(0.0) - b.unwrap_or(0.0)).abs() < 1e-9 * largest, "{context}: {a:?} {b:?}");
        }
    }
    println!("{all_stick} stick, {some_stick} with contacts that let go, {refused} refused, {opened} open");
    assert!(all_stick > 40 && opened > 5, "{all_stick} {some_stick} {refused} {opened}");
}
