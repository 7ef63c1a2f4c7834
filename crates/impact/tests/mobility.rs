//! Delassus matrices: against the responses, the recursion with unit wrenches, and closed forms. Friction at points that hardly slide.

use crate::cases::all;
use nalgebra::{Matrix3, Rotation3, SMatrix, Vector3};
use percuss_dynamics::{Base, Conditions, Contact, Direction, EffectiveMass, Frame, Pose, System};
use percuss_impact::{
    Delassus, FrictionLaw, JointRates, PhaseKind, RestitutionLaw, RigidImpact, frictional_collision,
};
use percuss_mechanism::{Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder};
use percuss_oracle::random;
use percuss_spatial::Twist;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::sync::Arc;

/// Wrench about the origin of the contact of the recursion by an impulse `f` at `arm`.
fn wrench(arm: &Vector3<f64>, f: &Vector3<f64>) -> [f64; 6] {
    let moment = arm.cross(f);
    [moment.x, moment.y, moment.z, f.x, f.y, f.z]
}

#[test]
fn the_matrix_agrees_with_responses_and_unit_wrenches() {
    let (mut compared, mut crossed) = (0, 0);
    for (number, case) in all(64).into_iter().enumerate() {
        let pose = &case.pose;
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let mut rng = StdRng::seed_from_u64(31 + number as u64);
        let (link, _, point, normal) = random::contact(&mut rng, &case.mechanism);
        let second = Contact { link, against: None, point, normal: Direction::Along(normal, Frame::World) };
        let first = Contact { against: None, ..case.contact };
        let located = [first, second].map(|contact| pose.locate(&contact).expect("a contact"));
        let Ok(delassus) = Delassus::new(pose, &located) else { continue };
        let w = delassus.matrix();
        let size = w.amax();
        // Rounding of points that cannot move.
        let total: f64 = case.mechanism.links().iter().map(|link| link.inertia().mass).sum();
        if size * total < 1e-9 {
            continue;
        }
        for (i, contact) in [first, second].iter().enumerate() {
            if let EffectiveMass::Finite(mass) = pose.respond(contact).expect("a response").effective_mass {
                let error = (w[(3 * i, 3 * i)] * mass - 1.0).abs();
                // Rounding of a light point relative to the largest mobility.
                assert!(error < 1e-9 * (1.0 + size * mass), "{}: {error:e}, {mass} kg, {w}", case.name);
                compared += 1;
            }
        }
        // Both links at the first point: the recursion gives the responses of both to wrenches on both.
        if located[0].link == located[1].link {
            continue;
        }
        let pair = Contact { against: Some(located[1].link), ..first };
        let Ok(pair) = pose.locate(&pair) else { continue };
        let Ok(inertia) = pose.inverse_operational_inertia(&pair) else { continue };
        let phi: &SMatrix<f64, 12, 12> = inertia.matrix();
        let at = |i: usize| pose.link_in_root(located[i].link).point(&located[i].point_link);
        let arms = [Vector3::zeros(), at(1) - at(0)];
        let mut rows = SMatrix::<f64, 6, 12>::zeros();
        for i in 0..2 {
            for k in 0..3 {
                let axis = delassus.axes(i).column(k).into_owned();
                let entries = wrench(&arms[i], &axis);
                (0..6).for_each(|c| rows[(3 * i + k, 6 * i + c)] = entries[c]);
            }
        }
        let expected = rows * phi * rows.transpose();
        let error = (w - expected).amax() / size;
        assert!(error < 1e-9, "{}: {error:e}", case.name);
        crossed += 1;
    }
    println!("{compared} masses, {crossed} pairs");
    assert!(compared > 200 && crossed > 60, "{compared} {crossed}");
}

#[test]
fn principal_masses_are_extreme() {
    let mut compared = 0;
    for case in all(24) {
        let pose = &case.pose;
        let located = pose.locate(&case.contact).expect("a contact");
        if !pose.rank().clear {
            continue;
        }
        let Ok(delassus) = Delassus::new(pose, std::slice::from_ref(&located)) else { continue };
        let masses = delassus.principal_masses(0);
        let block: Matrix3<f64> = delassus.block(0);
        if block.amax() == 0.0 {
            continue;
        }
        assert!(masses[0].0 <= masses[1].0 && masses[1].0 <= masses[2].0);
        // Along a principal direction the response is parallel to the impulse.
        for (mass, direction) in masses.iter().filter(|(mass, _)| mass.is_finite()) {
            let own = delassus.axes(0).transpose() * direction;
            let response = block * own * *mass;
            assert!((response - own).norm() < 1e-9 * (1.0 + mass * block.amax()), "{}", case.name);
            compared += 1;
        }
    }
    assert!(compared > 60, "{compared}");
}

/// W of a moment and a contact point: its first diagonal entry is 1/m̄ of the moment, and the block of the moment is the angular part of
/// the inverse operational inertia.
#[test]
fn moments_are_rows_of_angular_velocities() {
    let mut compared = 0;
    for case in all(64) {
        let pose = &case.pose;
        if !pose.rank().clear || pose.constraint_groups().iter().any(|g| g.least_singular_value < 1e-4) {
            continue;
        }
        let (axis, frame) = case.contact.normal.vector().expect("a vector");
        let moment = case.contact.normal(Direction::About(axis, frame));
        let located = [moment, case.contact].map(|contact| pose.locate(&contact).expect("a contact"));
        let Ok(delassus) = Delassus::new(pose, &located) else { continue };
        let w = delassus.matrix();
        let EffectiveMass::Finite(mass) = pose.respond(&moment).expect("a response").effective_mass else {
            continue;
        };
        let size = delassus.block(0).norm();
        let error = (w[(0, 0)] * mass - 1.0).abs();
        // Rounding of a light axis relative to the largest mobility.
        assert!(error < 1e-9 * (1.0 + size * mass), "{}: {error:e}, {mass} kg·m²", case.name);
        let Ok(inertia) = pose.inverse_operational_inertia(&located[0]) else { continue };
        let block = |r: usize, c: usize| inertia.matrix().fixed_view::<3, 3>(r, c).into_owned();
        let mut angular: Matrix3<f64> = block(0, 0);
        if moment.against.is_some() {
            angular += block(6, 6) - block(0, 6) - block(6, 0);
        }
        let axes = delassus.axes(0);
        let expected = axes.transpose() * angular * axes;
        assert!((delassus.block(0) - expected).norm() < 1e-8 * (size + angular.norm()), "{}", case.name);
        compared += 1;
    }
    println!("{compared} compared");
    assert!(compared > 100, "{compared}");
}

/// Uniform free rod of length 2 and mass 1 that hits a plane with its end: `degrees` is the angle between the rod and the plane.
fn rod_on_plane(pose: &Pose, degrees: f64, sliding: f64, friction: f64, law: RestitutionLaw) -> RigidImpact {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    // Out of the rod into the plane, and a tangent.
    let (normal, tangent) = (Vector3::new(-sine, -cosine, 0.0), Vector3::new(cosine, -sine, 0.0));
    let contact = Contact::new(pose.mechanism().root(), -Vector3::x(), normal);
    let response = pose.respond(&contact).expect("a contact");
    let twist = Twist::new(Vector3::zeros(), normal + tangent * sliding);
    let before = JointRates { joints: Vec::new(), base: twist };
    let law = FrictionLaw { coefficient: friction, restitution: law };
    RigidImpact::with_friction(pose, &response, 1.0, 0.5, law, Some(before)).expect("an impact")
}

/// A rod end that does not slide: the contact sticks, or slides along the coupling, during the whole impact, and all laws agree:
/// p = (1+e) c/(a_nn − µ |a_nt|), or with a_nt²/a_tt in place of µ |a_nt| if it sticks. A small sliding speed s changes the impulses of the
/// process laws by the order of s, and those of the algebraic law too while s is rounding.
#[test]
fn a_point_that_does_not_slide_takes_no_direction_from_rounding() {
    let about_com = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0)) / 3.0;
    let inertial = Inertial { mass: 1.0, com: Vector3::zeros(), about_com };
    let builder = MechanismBuilder::new("rod").link(LinkDescription::new("rod", inertial));
    let rod = Arc::new(builder.build().expect("a mechanism").mechanism);
    let system = System::new(rod, &Conditions::new().base(Base::Floating)).expect("a system");
    let pose = system.pose(&system.configuration()).expect("a pose");
    for degrees in 0..=90 {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let (nn, nt, tt) = (1.0 + 3.0 * cosine * cosine, 3.0 * sine * cosine, 1.0 + 3.0 * sine * sine);
        for friction in [0.0, 0.1, 0.3, 0.45, 0.6, 1.0] {
            let sticks = friction * tt >= nt;
            let rate = if sticks { nn - nt * nt / tt } else { nn - friction * nt };
            let expected = 1.5 / rate;
            for law in RestitutionLaw::ALL {
                let at_rest = rod_on_plane(&pose, f64::from(degrees), 0.0, friction, law);
                let context = format!("{degrees}°, {friction}, {}", law.name());
                assert!((at_rest.impulse / expected - 1.0).abs() < 1e-12, "{context}: {}", at_rest.impulse);
                let of = at_rest.friction.expect("friction");
                assert_eq!(of.sliding_before.norm(), 0.0, "{context}");
                let is_edge = (friction * tt - nt).abs() < 1e-9;
                let kind = if sticks { PhaseKind::Stick } else { PhaseKind::Slip };
                let kinds: Vec<PhaseKind> = of.phases.iter().map(|phase| phase.kind).collect();
                let is_uniform = kinds.iter().all(|k| *k == kind)
                    && (kinds.len() == 2 || law == RestitutionLaw::Algebraic);
                assert!(is_edge || is_uniform, "{context}: {kinds:?}");
                for slow in [1e-15, -1e-15, 1e-12, -1e-12, 1e-10, -1e-10, 1e-8, -1e-8, 1e-6, -1e-6] {
                    if law == RestitutionLaw::Algebraic && f64::abs(slow) > 2e-10 {
                        continue;
                    }
                    let slides = rod_on_plane(&pose, f64::from(degrees), slow, friction, law).impulse;
                    let change = (slides / expected - 1.0).abs();
                    assert!(change < 1e-11 + 20.0 * f64::abs(slow), "{context}, {slow:e}: {change:e}");
                }
            }
        }
    }
}

/// The same continuity in space, with random mobilities, and with mobilities in which the point cannot move in one tangential direction.
#[test]
fn small_sliding_speeds_change_little_in_space() {
    let mut rng = StdRng::seed_from_u64(8);
    let mut compared = 0;
    for number in 0..150 {
        let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), rng.random_range(0.0..6.0));
        // Every third point cannot move in one tangential direction, nor slide in it.
        let is_free = number % 3 > 0;
        let third = if is_free { 1.0 } else { 0.0 };
        let root = turn
            * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, third))
            * Matrix3::from_fn(|_, _| rng.random_range(-1.0..1.0));
        let w = root * root.transpose() + Matrix3::identity() * (0.05 * third);
        if w[(0, 0)] < 0.05 * w.norm() {
            continue;
        }
        let friction = rng.random_range(0.0..1.0);
        let angle: f64 = rng.random_range(0.0..6.0);
        let direction =
            if is_free { Vector3::new(0.0, angle.cos(), angle.sin()) } else { turn * Vector3::y() };
        let impulse = |slide: f64, law| {
            let before = direction * slide - Vector3::x();
            frictional_collision(&w, &before, friction, 0.6, law).map(|found| found.impulse)
        };
        for law in RestitutionLaw::ALL {
            let Ok(at_rest) = impulse(0.0, law) else { continue };
            for slide in [1e-16, 1e-12, 3e-10, 1e-8, 1e-6] {
                if law == RestitutionLaw::Algebraic && slide > 5e-10 {
                    continue;
                }
                let found = impulse(slide, law).expect("an impact");
                let change = (found - at_rest).norm() / at_rest.norm();
                assert!(change < 1e-9 + 1e3 * slide, "{number}, {}, {slide:e}: {change:e} {w}", law.name());
                compared += 1;
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// All laws at a contact of one relative motion, a rod on a hinge, in closed form: the normal impulses, and the separation speeds.
#[test]
fn all_laws_have_closed_forms_for_one_relative_motion() {
    let about_com = Matrix3::from_diagonal(&Vector3::new(0.01, 1.0, 1.0)) / 12.0;
    let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let rod = Inertial { mass: 1.0, com: Vector3::x() * 0.5, about_com };
    let mut hinge = JointDescription::new("hinge", JointKind::Continuous, "ground", "rod");
    hinge.axis = Vector3::z();
    let builder = MechanismBuilder::new("rod").link(LinkDescription::new("ground", none));
    let built = builder.link(LinkDescription::new("rod", rod)).joint(hinge).build().expect("a mechanism");
    let system = System::new(Arc::new(built.mechanism), &Conditions::new()).expect("a system");
    let pose = system.pose(&system.configuration()).expect("a pose");
    let link = pose.mechanism().find_link("rod").expect("a link");
    let (speed, e) = (1.3, 0.6);
    for slope in [0.0_f64, 0.3, 1.0, 2.5] {
        // The end moves along y; the normal is turned by the angle whose tangent is the slope.
        let response = pose.respond(&Contact::new(link, Vector3::x(), Vector3::new(slope, 1.0, 0.0)));
        let response = response.expect("a contact");
        let momentum = response.effective_mass.kilograms().expect("a mass") * speed;
        for friction in [0.0, 0.2, 0.35, 0.9] {
            let law = FrictionLaw { coefficient: friction, restitution: RestitutionLaw::Energetic };
            let impact =
                RigidImpact::with_friction(&pose, &response, speed, e, law, None).expect("an impact");
            let product = friction * slope;
            let wedged = product >= 1.0;
            let [plus, minus] = [1.0 + product, 1.0 - product];
            for found in impact.friction.expect("friction").laws {
                let (impulse, separation) = match found.law {
                    RestitutionLaw::Algebraic => ((1.0 + e) / plus, e),
                    _ if wedged => (1.0 / plus, 0.0),
                    RestitutionLaw::Energetic => {
                        (1.0 / plus + e / (plus * minus).sqrt(), e * (minus / plus).sqrt())
                    }
                    RestitutionLaw::Poisson => ((1.0 + e) / plus, e * minus / plus),
                    RestitutionLaw::Newton => (1.0 / plus + e / minus, e),
                };
                let context = format!("{slope} {friction} {found:?}");
                assert!(
                    (found.normal_impulse / momentum - impulse).abs() < 1e-12 * impulse,
                    "{context} {impulse}"
                );
                assert!(
                    (found.separation_speed / speed - separation).abs() < 1e-12,
                    "{context} {separation}"
                );
            }
        }
    }
}
