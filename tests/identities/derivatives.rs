//! Derivatives of m̄, loops included: with respect to positions along admissible motions, for every kind of normal, and with
//! respect to the mass of links.

use nalgebra::Vector3;
use percuss_dynamics::{
    Conditions, Contact, ContactResponse, Direction, EffectiveMass, Frame, PointVelocity, Remark, Route,
    RouteChoice, System,
};
use percuss_mechanism::{Inertial, JointDescription, JointKind, LinkDescription, LinkId};
use percuss_oracle::alter;
use percuss_spatial::{Transform, Twist};
use percuss_tests::differences::derivative_by;
use percuss_tests::gauge::Gauge;
use percuss_tests::motion::Motion;
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// Displacement of the fastest part in the longer step of a difference, relative to the mechanism's size.
const STEP: f64 = 2e-3;
/// Limit of response speed (mechanism sizes per unit closing speed): faster responses leave the differences too few
/// digits.
const FAST: f64 = 50.0;
/// Error of differences of poses, which the oracle closes to 1e-13 of the size, divided by the step; scales with the
/// squared speed.
const CLOSED: f64 = 1e-7;
/// Error of differences without loops, for exact positions.
const EXACT: f64 = 1e-8;
/// Added mass as a fraction of the effective mass at a point.
const STEP_OF_MASS: f64 = 1e-4;
/// Error of one-sided differences with respect to a mass: the squared step, and 1e-13 over the change of m̄.
const BY_MASS: f64 = 1e-5;

fn finite(subject: &Subject) -> Option<(ContactResponse, f64, f64)> {
    let response = subject.pose.respond_by_route(&subject.contact, RouteChoice::Only(Route::Articulated));
    let response = response.unwrap_or_else(|error| panic!("{}: {error}", subject.name));
    let EffectiveMass::Finite(m) = response.effective_mass else { return None };
    let fast = 1.0 + subject.mechanism().characteristic_length() * Motion::of(&response).size();
    let regular = fast < FAST && subject.pose.rank().clear && !response.singular_pose;
    regular.then_some((response, m, fast))
}

/// The subject's own contact, and the same contact with each other kind of normal.
fn with_other_normals(subject: &Subject, rng: &mut StdRng) -> Vec<Contact> {
    let own = subject.contact;
    let links: Vec<LinkId> = subject.mechanism().link_ids().collect();
    let mut vector = || Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
    let [direction, to] = [vector(), vector()];
    let far = links[rng.random_range(0..links.len())];
    let along = |frame| Direction::Along(direction, frame);
    let about = |frame| Direction::About(direction, frame);
    let kinds = [along(Frame::Link), along(Frame::World), along(Frame::Against)];
    let moments = [about(Frame::Link), about(Frame::World), about(Frame::Against)];
    let lines = [Direction::TurningToward(far, to), Direction::TurningAwayFrom(far, to)];
    let others = kinds.into_iter().chain(moments).chain(lines).map(|normal| own.normal(normal));
    // A line between points of one link, or too short, is refused.
    let valid = others.filter(|contact| subject.pose.locate(contact).is_ok());
    std::iter::once(own).chain(valid).collect()
}

fn along_motions(subjects: Vec<Subject>, what: &'static str, near: f64) -> usize {
    let mut slope = Gauge::new(what);
    let mut skipped = 0;
    for (i, mut subject) in subjects.into_iter().enumerate() {
        let mut rng = StdRng::seed_from_u64(71 + i as u64);
        let Some(motion) = subject.motion(&mut rng) else {
            skipped += 1;
            continue;
        };
        let name = subject.name.clone();
        for contact in with_other_normals(&subject, &mut rng) {
            subject.contact = contact;
            let Some((_, m, fast)) = finite(&subject) else {
                skipped += 1;
                continue;
            };
            let gradient = subject.pose.effective_mass_gradient(&contact).expect("a contact");
            // A mass with fewer than six digits has no gradient.
            let Some(gradient) = gradient else {
                skipped += 1;
                continue;
            };
            let got = gradient.rate(&motion.joints);
            let mut workspace = subject.pose.assembly().workspace();
            let mut all_finite = true;
            let size = motion.size() * fast;
            let expected = derivative_by(STEP / size, |h| {
                workspace.set_positions(&subject.positions_after(&motion, h)).expect("positions that fit");
                match workspace.effective_mass(&contact) {
                    Ok(EffectiveMass::Finite(m)) => m,
                    _ => {
                        all_finite = false;
                        0.0
                    }
                }
            });
            assert!(all_finite, "{name}: finite here, and not beside");
            slope.note(&format!("{name}, {:?}", contact.normal), (got - expected).abs() / (m * size), near);
        }
    }
    slope.report();
    println!("{skipped} skipped");
    slope.count()
}

#[test]
fn m_by_positions_on_trees() {
    assert!(along_motions(of_trees(12, 2, 120), "∂m̄/∂q, trees", EXACT) > 700);
}

#[test]
fn m_by_positions_on_linkages() {
    assert!(along_motions(of_linkages(400, 8), "∂m̄/∂q, linkages", CLOSED) > 200);
}

/// Two links with point masses m₁ at the elbow and m₂ at the tip, struck along the second link: m̄ = m₂ + m₁/sin²q₂.
#[test]
fn gradient_of_two_links_with_point_masses() {
    let ([m1, m2], [l1, l2]) = ([2.5, 0.7], [0.4, 0.3]);
    let mass_at = |name: &str, mass: f64, x: f64| {
        LinkDescription::new(
            name,
            Inertial { mass, com: Vector3::x() * x, about_com: nalgebra::Matrix3::zeros() },
        )
    };
    let links = vec![mass_at("ground", 0.0, 0.0), mass_at("upper", m1, l1), mass_at("fore", m2, l2)];
    let hinge = |name: &str, parent: &str, child: &str, x: f64| JointDescription {
        axis: Vector3::z(),
        origin: Transform::from_translation(Vector3::x() * x),
        ..JointDescription::new(name, JointKind::Revolute, parent, child)
    };
    let joints = vec![hinge("shoulder", "ground", "upper", 0.0), hinge("elbow", "upper", "fore", l1)];
    let mechanism = alter::build("two links", links, joints);
    let contact = Contact::new(mechanism.find_link("fore").expect("a link"), [l2, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let system = System::new(mechanism, &Conditions::new()).expect("conditions that fit");
    let mut pose = system.pose(&system.configuration()).expect("a tree");
    for _ in 0..30 {
        pose = pose.advanced(&[vec![0.3], vec![1.0]], &Twist::zero(), 0.1).expect("velocities that fit");
        let q2 = pose.positions()[1];
        let gradient = pose.effective_mass_gradient(&contact).expect("a contact").expect("a finite mass");
        let expected = -2.0 * m1 * q2.cos() / q2.sin().powi(3);
        // Near q₂ = 0 and π both m̄ and v* grow with 1/sin²q₂, and with them the rounding.
        let bound = 1e-14 * (m2 + m1 / q2.sin().powi(4));
        assert!((gradient.joints[1][0] - expected).abs() < bound, "{q2}: {:?}, {expected}", gradient.joints);
        assert!(gradient.joints[0][0].abs() < bound, "{q2}: {:?}", gradient.joints);
    }
}

/// m̄ of the subject's mechanism with a point mass on a link.
fn with_mass(subject: &Subject, link: LinkId, at: Vector3<f64>, mass: f64) -> f64 {
    let mechanism = subject.mechanism();
    let (mut links, mut joints) = alter::describe(mechanism);
    let (closures, couplings) = alter::describe_loops(mechanism);
    let point = Inertial { mass, com: at, about_com: nalgebra::Matrix3::zeros() };
    links.push(LinkDescription::new("extra mass", point));
    let name = mechanism.link(link).name();
    joints.push(JointDescription::new("extra mass's joint", JointKind::Fixed, name, "extra mass"));
    let altered = alter::build_with_loops(mechanism.name(), links, joints, closures, couplings);
    let system = System::new(altered, &subject.conditions()).expect("conditions that fit");
    let mut workspace = system.workspace();
    workspace.set_positions(subject.pose.positions()).expect("positions that fit");
    match workspace.effective_mass(&subject.contact) {
        Ok(EffectiveMass::Finite(m)) => m,
        other => panic!("{}: {other:?} with a mass more", subject.name),
    }
}

fn by_masses(subjects: &[Subject]) -> usize {
    let mut differences = Gauge::new("∂m̄/∂mass, differences");
    for (i, subject) in subjects.iter().enumerate() {
        let Subject { name, pose, .. } = subject;
        let Some((response, m, _)) = finite(subject) else { continue };
        // A mass on a massless part changes the mechanism's kind.
        if response.remarks.iter().any(|r| matches!(r, Remark::MasslessMotions { .. })) {
            continue;
        }
        let mut rng = StdRng::seed_from_u64(81 + i as u64);
        let links: Vec<LinkId> = subject.mechanism().link_ids().collect();
        let link = links[rng.random_range(0..links.len())];
        let at = Vector3::from_fn(|_, _| rng.random_range(-0.5..0.5));
        let Some(PointVelocity::Known(v)) = pose.point_velocity_over_ground(&response, link, &at) else {
            panic!("{name}: v* is open without massless motions")
        };
        let expected = v.norm_squared();
        // Small relative to the effective mass of the link at that point in any direction.
        let own = Contact::new(link, at, Vector3::x());
        let own = subject.pose.locate(&own).expect("a contact");
        let response = subject.pose.inverse_operational_inertia(&own).expect("no motion without mass");
        let mass = STEP_OF_MASS / response.matrix().fixed_view::<3, 3>(3, 3).trace();
        if mass * expected > 1e-8 * m {
            let [one, two] = [1.0, 2.0].map(|k| with_mass(subject, link, at, k * mass));
            let slope = (4.0 * one - two - 3.0 * m) / (2.0 * mass);
            differences.relative(name, expected, slope, BY_MASS);
        }
    }
    differences.report();
    differences.count()
}

#[test]
fn m_by_masses_on_trees() {
    assert!(by_masses(&of_trees(13, 1, 80)) > 40);
}

#[test]
fn m_by_masses_on_linkages() {
    assert!(by_masses(&of_linkages(500, 4)) > 15);
}
