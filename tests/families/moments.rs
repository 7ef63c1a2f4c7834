//! Moments about an axis as contacts: closed forms, and comparisons on random trees and linkages (massless links, locks, armatures, held
//! points, floating bases, redundant loops) of both routes, maximal coordinates, and the angular block of the inverse operational inertia.

use nalgebra::{Matrix3, SVector, Vector3};
use percuss_dynamics::{
    Base, Conditions, Contact, ContactError, Direction, EffectiveMass, Frame, Pose, Route, RouteChoice,
    System,
};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_oracle::maximal::{Outcome, Question, solve};
use percuss_spatial::{Transform, plane_basis, rotation_about};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::{near_at, states_enough};
use percuss_tests::motion::Motion;
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::PI;
use std::sync::Arc;

/// Relative error of route C: its kernel of 6 · links rows is not scaled by masses.
const ORACLE: f64 = 1e-10;
/// Bound for two computations from the same few numbers: about ten roundings.
const EXACT: f64 = 1e-14;

fn any(rng: &mut StdRng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))
}

/// The subject's contact as a moment about a random axis, in each frame in turn.
fn as_moment(subject: &Subject, number: usize, rng: &mut StdRng) -> Contact {
    let frame = [Frame::Link, Frame::World, Frame::Against][number % 3];
    subject.contact.normal(Direction::About(any(rng), frame))
}

/// Number of results by outcome, and of excluded cases.
#[derive(Default, Debug)]
struct Count {
    finite: usize,
    immovable: usize,
    massless: usize,
    unclear: usize,
    inertias: usize,
}

/// Compares both routes, the workspace and Φ with maximal coordinates.
fn compare(subject: &Subject, gauge: &mut Gauge, count: &mut Count) {
    let (name, pose, contact) = (&subject.name, &subject.pose, subject.contact);
    let located = pose.locate(&contact).expect("a contact");
    assert!(located.is_moment);
    let question = Question { is_moment: true, normal: located.normal_world, ..subject.question() };
    let c = solve(&question);
    let least = c.singular_values.iter().copied().filter(|s| *s > c.threshold).fold(1.0, f64::min);
    if !pose.rank().clear || least < 1e-4 {
        count.unclear += 1;
        return;
    }
    let by = |choice| {
        pose.respond_by_route(&contact, choice).unwrap_or_else(|error| panic!("{name}: {choice:?}: {error}"))
    };
    let size = subject.mechanism().characteristic_length();
    for choice in [RouteChoice::Auto, RouteChoice::Only(Route::Dense), RouteChoice::Only(Route::Articulated)]
    {
        let response = by(choice);
        match (response.effective_mass, c.outcome) {
            (EffectiveMass::Finite(m), Outcome::Finite(expected)) => {
                // Large rates at unit closing speed are differences of large terms.
                let near = near_at(pose) + ORACLE + 1e-12 * Motion::of(&response).size();
                gauge.relative(name, m, expected, near);
                assert!(
                    states_enough(&response, expected, ORACLE + near_at(pose)),
                    "{name}: {m}, {expected}"
                );
                let contributions = response.contributions.as_ref().expect("finite");
                let sum: f64 = contributions.links.iter().sum::<f64>()
                    + contributions.rotors.iter().map(|(_, share)| share).sum::<f64>();
                assert!((sum - 1.0).abs() < near, "{name}: the contributions sum to {sum}");
            }
            (EffectiveMass::Immovable, Outcome::Immovable) | (EffectiveMass::Massless, Outcome::Massless) => {
            }
            (found, expected) => panic!("{name}, {choice:?}: {found:?}, route C {expected:?}"),
        }
    }
    count.finite += usize::from(matches!(c.outcome, Outcome::Finite(_)));
    count.immovable += usize::from(c.outcome == Outcome::Immovable);
    count.massless += usize::from(c.outcome == Outcome::Massless);
    let Outcome::Finite(expected) = c.outcome else { return };
    let mut workspace = pose.assembly().workspace();
    workspace.set_positions(pose.positions()).expect("positions");
    match workspace.effective_mass(&contact) {
        Ok(EffectiveMass::Finite(m)) => gauge.relative(name, m, expected, near_at(pose) + ORACLE),
        other => panic!("{name}: workspace {other:?}"),
    }
    // 1/m̄ = wᵀΦw with w = (â, 0, −â, 0).
    if let Ok(inertia) = pose.inverse_operational_inertia(&located) {
        let axis = pose.link_in_root(located.link).vector(&located.normal_link);
        let mut w = SVector::<f64, 12>::zeros();
        w.fixed_rows_mut::<3>(0).copy_from(&axis);
        if located.against.is_some() {
            w.fixed_rows_mut::<3>(6).copy_from(&-axis);
        }
        let inverse = w.dot(&(inertia.matrix() * w));
        // Bound for the cancellation between large responses of both links.
        let terms = inertia.matrix().fixed_view::<3, 3>(0, 0).norm()
            + inertia.matrix().fixed_view::<3, 3>(6, 6).norm();
        let near = 1e-11 * (1.0 + terms * expected) + near_at(pose);
        assert!((inverse * expected - 1.0).abs() < near, "{name}: Φ gives {inverse}, 1/m̄ {}", 1.0 / expected);
        count.inertias += 1;
    }
    assert!(size > 0.0);
}

#[test]
fn both_routes_are_maximal_coordinates() {
    for (subjects, what) in [
        (of_trees(2900, 2, 300), "moments on trees = route C"),
        (of_linkages(2950, 24), "moments on linkages = route C"),
    ] {
        let (mut gauge, mut count) = (Gauge::new(what), Count::default());
        for (number, mut subject) in subjects.into_iter().enumerate() {
            let mut rng = StdRng::seed_from_u64(29_000 + number as u64);
            for k in 0..2 {
                subject.contact = as_moment(&subject, number + k, &mut rng);
                compare(&subject, &mut gauge, &mut count);
            }
        }
        gauge.report();
        println!("{what}: {count:?}");
        assert!(count.finite > 400 && count.immovable > 20 && count.inertias > 300, "{count:?}");
        assert!(10 * count.unclear < count.finite, "{count:?}");
    }
}

/// A single link on the ground, with a joint of `kind` about or along `axis`.
fn one_link(
    inertial: Inertial,
    kind: JointKind,
    origin: Transform<f64>,
    axis: Vector3<f64>,
) -> Arc<Mechanism> {
    let joint = JointDescription { axis, origin, ..JointDescription::new("joint", kind, "ground", "body") };
    let builder = MechanismBuilder::new("one link")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("body", inertial))
        .joint(joint);
    builder.build().expect("one link").mechanism.into()
}

fn inertial(rng: &mut StdRng) -> Inertial {
    let mass: f64 = 10.0_f64.powf(rng.random_range(-2.0..2.0));
    let turn = rotation_about(&any(rng).normalize(), rng.random_range(-PI..PI));
    // Sums of two squares: three positive numbers, each smaller than the sum of the others.
    let [a, b, c] = [0; 3].map(|_| rng.random_range(0.05..1.0_f64).powi(2));
    let principal = Matrix3::from_diagonal(&Vector3::new(b + c, a + c, a + b)) * mass;
    Inertial { mass, com: any(rng), about_com: turn * principal * turn.transpose() }
}

fn mass_at(pose: &Pose, contact: &Contact) -> EffectiveMass {
    pose.respond(contact).expect("a contact").effective_mass
}

fn finite(mass: EffectiveMass) -> f64 {
    match mass {
        EffectiveMass::Finite(mass) => mass,
        other => panic!("{other:?}"),
    }
}

/// A free body has m̄ = 1/(âᵀ I_c⁻¹ â). For a pendulum, m̄ is its moment of inertia about the hinge, divided by the square of the cosine
/// between both axes. A body on a prismatic joint is immovable.
#[test]
fn closed_forms() {
    let mut rng = StdRng::seed_from_u64(2910);
    for _ in 0..300 {
        let inertial = inertial(&mut rng);
        let axis = any(&mut rng);
        let unit = axis.normalize();
        let origin = Transform::new(
            rotation_about(&any(&mut rng).normalize(), rng.random_range(-PI..PI)),
            any(&mut rng),
        );
        let floating = Conditions::new().base(Base::Floating);
        let body = MechanismBuilder::new("free").link(LinkDescription::new("body", inertial));
        let free: Arc<Mechanism> = body.build().expect("a body").mechanism.into();
        let system = System::new(Arc::clone(&free), &floating).expect("a system");
        let pose = system.pose(&system.configuration()).expect("a pose");
        let contact = Contact::about_axis(free.root(), axis);
        let expected = 1.0 / unit.dot(&(inertial.about_com.try_inverse().expect("regular") * unit));
        // Tolerance for principal moments with a ratio of up to 100.
        let found = finite(mass_at(&pose, &contact));
        assert!((found / expected - 1.0).abs() < 1e-11, "{found}, {expected}");
        let alone = pose.free_body_mass(&contact).expect("a body");
        assert!((alone / expected - 1.0).abs() < 1e-11, "{alone}, {expected}");
        // The contact point and the length of the axis have no effect.
        let moved = Contact { point: any(&mut rng) * 100.0, ..contact }
            .normal(Direction::About(axis * 7.0, Frame::Link));
        assert!((finite(mass_at(&pose, &moved)) / found - 1.0).abs() < EXACT);

        let hinge_axis = any(&mut rng).normalize();
        let hinged = one_link(inertial, JointKind::Revolute, origin, hinge_axis);
        let link = hinged.find_link("body").expect("a link");
        let system = System::new(Arc::clone(&hinged), &Conditions::new()).expect("a system");
        let mut at = system.configuration();
        at.set("joint", &[rng.random_range(-3.0..3.0)]).expect("a hinge");
        let pose = system.pose(&at).expect("a pose");
        let arm = inertial.com - hinge_axis * hinge_axis.dot(&inertial.com);
        let about_hinge =
            hinge_axis.dot(&(inertial.about_com * hinge_axis)) + inertial.mass * arm.norm_squared();
        let own = finite(mass_at(&pose, &Contact::about_axis(link, hinge_axis)));
        assert!((own / about_hinge - 1.0).abs() < 1e-12, "{own}, {about_hinge}");
        let cosine = unit.dot(&hinge_axis);
        let oblique = finite(mass_at(&pose, &Contact::about_axis(link, axis)));
        // For an oblique axis, the closing speed per rate is the cosine.
        assert!((oblique * cosine * cosine / about_hinge - 1.0).abs() < 1e-12 / cosine.abs());

        let slides = one_link(inertial, JointKind::Prismatic, origin, hinge_axis);
        let system = System::new(Arc::clone(&slides), &Conditions::new()).expect("a system");
        let pose = system.pose(&system.configuration()).expect("a pose");
        let link = slides.find_link("body").expect("a link");
        assert_eq!(mass_at(&pose, &Contact::about_axis(link, axis)), EffectiveMass::Immovable);
    }
}

/// A massless link on a hinge: massless about the hinge, immovable about a perpendicular axis, and finite with an armature.
#[test]
fn a_massless_link_has_all_outcomes() {
    let nothing = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let free = one_link(nothing, JointKind::Revolute, Transform::identity(), Vector3::z());
    let link = free.find_link("body").expect("a link");
    let system = System::new(Arc::clone(&free), &Conditions::new()).expect("a system");
    let pose = system.pose(&system.configuration()).expect("a pose");
    assert_eq!(mass_at(&pose, &Contact::about_axis(link, [0.0, 0.0, 2.0])), EffectiveMass::Massless);
    assert_eq!(mass_at(&pose, &Contact::about_axis(link, [1.0, 0.0, 0.0])), EffectiveMass::Immovable);
    let rotor = System::new(free, &Conditions::new().armature("joint", vec![0.03])).expect("a system");
    let pose = rotor.pose(&rotor.configuration()).expect("a pose");
    let found = finite(mass_at(&pose, &Contact::about_axis(link, [0.0, 0.0, -1.0])));
    assert!((found / 0.03 - 1.0).abs() < EXACT);
}

/// The stop of a hinge has the same m̄ as a contact of child and parent at a point 1 m from the axis.
#[test]
fn stops_of_hinges_are_points_at_one_metre() {
    let (mut compared, mut outcomes) = (0, 0);
    let subjects = of_trees(2920, 1, 150).into_iter().chain(of_linkages(2930, 3));
    for subject in subjects {
        let (mechanism, pose) = (subject.mechanism(), &subject.pose);
        for id in mechanism.joint_ids() {
            let joint = mechanism.joint(id);
            let is_hinge = matches!(joint.kind(), JointKind::Revolute | JointKind::Continuous);
            let Some(stop) = Contact::joint_stop(mechanism, id, true).filter(|_| is_hinge) else { continue };
            let across = plane_basis(joint.axis()).0;
            let point =
                Contact::new(joint.child(), across, joint.axis().cross(&across)).against(joint.parent());
            let [stop, point] = [stop, point].map(|contact| pose.respond(&contact).expect("a contact"));
            match (stop.effective_mass, point.effective_mass) {
                (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) => {
                    // Both are within their stated errors.
                    let stated = [&stop, &point].map(|r| r.effective_mass_error().unwrap_or(1e-6 * a));
                    let near = stated[0] + stated[1] + 1e-12 * a;
                    assert!((a - b).abs() <= near, "{}, {}: {a}, {b}", subject.name, joint.name());
                    compared += 1;
                }
                (a, b) => {
                    assert_eq!(a, b, "{}, {}", subject.name, joint.name());
                    outcomes += 1;
                }
            }
        }
    }
    println!("{compared} finite, {outcomes} others");
    assert!(compared > 500 && outcomes > 20);
}

#[test]
fn invalid_moments_are_refused() {
    let inertial = Inertial { mass: 1.0, com: Vector3::zeros(), about_com: Matrix3::identity() };
    let body = one_link(inertial, JointKind::Revolute, Transform::identity(), Vector3::z());
    let link = body.find_link("body").expect("a link");
    let system = System::new(body, &Conditions::new()).expect("a system");
    let pose = system.pose(&system.configuration()).expect("a pose");
    let message =
        |axis: [f64; 3]| pose.respond(&Contact::about_axis(link, axis)).expect_err("refused").to_string();
    assert!(message([0.0; 3]).starts_with("the axis has length 0e0"), "{}", message([0.0; 3]));
    assert!(message([f64::NAN, 0.0, 1.0]).starts_with("the contact axis has a component NaN"));
    let response = pose.respond(&Contact::about_axis(link, [0.0, 0.0, 1.0])).expect("a contact");
    assert!(matches!(response.against_mass(2.0), Err(ContactError::MassOfMoment { .. })));
}
