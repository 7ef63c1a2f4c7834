//! The full response on dual numbers, loops included: derivatives of m̄ with respect to positions along admissible
//! motions, and with respect to the mass of every link.

use nalgebra::Vector3;
use percuss_dynamics::{
    Contact, ContactResponse, EffectiveMass, PointVelocity, Remark, Route, RouteChoice, System,
};
use percuss_mechanism::{Inertial, JointDescription, JointKind, LinkDescription, LinkId};
use percuss_oracle::alter;
use percuss_spatial::dual::Dual64;
use percuss_spatial::{Scalar, SpatialInertia};
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
/// Error of a dual number compared with a closed form.
const FORMULA: f64 = 1e-9;
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

fn along_motions(subjects: &[Subject], what: &'static str, near: f64) -> usize {
    let mut value = Gauge::new("1/m̄ over dual numbers");
    let mut slope = Gauge::new(what);
    let mut skipped = 0;
    for (i, subject) in subjects.iter().enumerate() {
        let Subject { name, pose, system, .. } = subject;
        let mut rng = StdRng::seed_from_u64(71 + i as u64);
        let (Some((_, m, fast)), Some(motion)) = (finite(subject), subject.motion(&mut rng)) else {
            skipped += 1;
            continue;
        };
        let rates = system.position_rates(pose.positions(), &motion.joints).expect("velocities that fit");
        let seeded = pose.positions().iter().zip(&rates).map(|(q, rate)| Dual64::new(*q, *rate));
        let mut dual = pose.workspace_over::<Dual64>(&subject.contact).expect("a contact");
        dual.set_positions(&seeded.collect::<Vec<_>>()).expect("positions that fit");
        let got = dual.inverse_effective_mass();
        value.relative(name, got.re, 1.0 / m, 1e-10);
        let mut workspace = pose.assembly().workspace();
        let mut all_finite = true;
        let size = motion.size() * fast;
        let expected = derivative_by(STEP / size, |h| {
            workspace.set_positions(&subject.positions_after(&motion, h)).expect("positions that fit");
            match workspace.effective_mass(&subject.contact) {
                Ok(EffectiveMass::Finite(m)) => 1.0 / m,
                _ => {
                    all_finite = false;
                    0.0
                }
            }
        });
        assert!(all_finite, "{name}: finite here, and not beside");
        slope.note(name, (got.eps - expected).abs() * m / size, near);
    }
    value.report();
    slope.report();
    println!("{skipped} of {} skipped", subjects.len());
    slope.count()
}

#[test]
fn m_by_positions_on_trees() {
    assert!(along_motions(&of_trees(12, 2, 120), "∂(1/m̄)/∂q, trees", EXACT) > 150);
}

#[test]
fn m_by_positions_on_linkages() {
    assert!(along_motions(&of_linkages(400, 16), "∂(1/m̄)/∂q, linkages", CLOSED) > 100);
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

fn by_masses(subjects: &[Subject]) -> (usize, usize) {
    let mut formula = Gauge::new("∂m̄/∂mass, v*ᵀ(∂M)v*");
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
        let chosen = links[rng.random_range(0..links.len())];
        for link in links {
            let at = Vector3::from_fn(|_, _| rng.random_range(-0.5..0.5));
            let Some(PointVelocity::Known(v)) = pose.point_velocity_over_ground(&response, link, &at) else {
                panic!("{name}: v* is open without massless motions")
            };
            let expected = v.norm_squared();
            let unit = SpatialInertia::point_mass(Dual64::new(0.0, 1.0), at.map(Dual64::from_f64));
            let mut dual = pose.workspace_over::<Dual64>(&subject.contact).expect("a contact");
            dual.add_inertia(link, &unit).expect("a link of the pose");
            let inverse = dual.inverse_effective_mass();
            let got = -inverse.eps * m * m;
            // Size of the terms of v* that cancel at the point: the rates, relative to the size.
            let size =
                Motion::of(&response).size() * (at.norm() + subject.mechanism().characteristic_length());
            formula.note(
                &format!("{name}, link {}", link.index()),
                (got - expected).abs() / (1.0 + size * size),
                FORMULA,
            );
            if link != chosen {
                continue;
            }
            // Small relative to the effective mass of the link at that point in any direction.
            let own = Contact::new(link, at, Vector3::x());
            let own = subject.pose.locate(&own).expect("a contact");
            let response = subject.pose.inverse_operational_inertia(&own).expect("no motion without mass");
            let mass = STEP_OF_MASS / response.matrix().fixed_view::<3, 3>(3, 3).trace();
            if mass * expected > 1e-8 * m {
                let [one, two] = [1.0, 2.0].map(|k| with_mass(subject, link, at, k * mass));
                let slope = (4.0 * one - two - 3.0 * m) / (2.0 * mass);
                differences.relative(name, got, slope, BY_MASS);
            }
        }
    }
    formula.report();
    differences.report();
    (formula.count(), differences.count())
}

#[test]
fn m_by_masses_on_trees() {
    let (formulas, differences) = by_masses(&of_trees(13, 1, 80));
    assert!(formulas > 500 && differences > 40, "{formulas} and {differences}");
}

#[test]
fn m_by_masses_on_linkages() {
    let (formulas, differences) = by_masses(&of_linkages(500, 4));
    assert!(formulas > 100 && differences > 15, "{formulas} and {differences}");
}
