//! The recursions hold over any scalar: dual numbers give ∂M (∂m̄ is in `derivatives.rs`), and each SIMD lane is
//! bitwise equal to its scalar result, loops included.

use nalgebra::DMatrix;
use num_traits::{One, Zero};
use percuss_dynamics::{
    Conditions, Contact, EffectiveMass, Pose, ResponseError, RouteError, ScalarWorkspace, System,
};
use percuss_mechanism::{Inertial, JointKind, LinkDescription, LinkId, Mechanism};
use percuss_oracle::{alter, linkage, zoo};
use percuss_spatial::{Scalar, dual::Dual64};
use percuss_tests::cases::{self, Case};
use percuss_tests::differences::{DIFFERENCE, derivative};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::{self, regular_condition};
use percuss_tests::motion::Motion;
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{SeedableRng, rngs::StdRng};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Four numbers in parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lanes([f64; 4]);

macro_rules! lane_by_lane {
    ($($op:ident $method:ident $assign:ident $assign_method:ident),*) => {$(
        impl $op for Lanes {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Lanes(std::array::from_fn(|i| self.0[i].$method(other.0[i])))
            }
        }

        impl $assign for Lanes {
            fn $assign_method(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

lane_by_lane!(Add add AddAssign add_assign, Sub sub SubAssign sub_assign);
lane_by_lane!(Mul mul MulAssign mul_assign, Div div DivAssign div_assign);

impl Neg for Lanes {
    type Output = Self;
    fn neg(self) -> Self {
        Lanes(self.0.map(Neg::neg))
    }
}

impl Zero for Lanes {
    fn zero() -> Self {
        Lanes([0.0; 4])
    }

    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Lanes {
    fn one() -> Self {
        Lanes([1.0; 4])
    }
}

impl Scalar for Lanes {
    fn from_f64(x: f64) -> Self {
        Lanes([x; 4])
    }

    fn sin_cos(self) -> (Self, Self) {
        let both = self.0.map(f64::sin_cos);
        (Lanes(both.map(|x| x.0)), Lanes(both.map(|x| x.1)))
    }

    fn sqrt(self) -> Self {
        Lanes(self.0.map(f64::sqrt))
    }
}

/// Workspace over another scalar; `None` for a massless contact.
fn over<T: Scalar>(pose: &Pose, contact: &Contact) -> Option<ScalarWorkspace<T>> {
    match pose.workspace_over(contact) {
        Ok(workspace) => Some(workspace),
        Err(ResponseError::Route(RouteError::MasslessMotion)) => None,
        Err(error) => panic!("{error}"),
    }
}

/// All cases: models of the zoo and random models.
fn all_cases() -> Vec<Case> {
    [cases::of_the_zoo(3, 2), cases::at_random(3000, 80, 30)].concat()
}

#[test]
fn dual_numbers_differentiate_the_mass_matrix() {
    let mut rng = StdRng::seed_from_u64(31);
    let mut value = Gauge::new("M over dual numbers");
    let mut slope = Gauge::new("∂M");
    let mut moved = Vec::new();
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        // All joints at once: single joints would identify an error more directly, but not test mixed terms.
        let motion = Motion::random(&mut rng, &system);
        let rates = system.position_rates(pose.positions(), &motion.joints).expect("velocities that fit");
        let seeded: Vec<Dual64> =
            pose.positions().iter().zip(&rates).map(|(&q, &rate)| Dual64::new(q, rate)).collect();
        let Some(mut workspace) = over::<Dual64>(&pose, &case.contact()) else { continue };
        workspace.set_positions(&seeded).expect("positions that fit");
        let dual = workspace.mass_matrix();
        let plain = pose.mass_matrix();
        if plain.is_empty() {
            continue;
        }
        let size = plain.amax();
        // The dual product may round differently from the plain product: the same sum in another order.
        value.note(&case.name, (dual.map(|x| x.re) - &plain).amax() / size.max(1e-300), 1e-13);
        let expected: DMatrix<f64> = derivative(&motion, |h| {
            pose.advanced(&motion.joints, &motion.base, h).expect("velocities that fit").mass_matrix()
        });
        // M is quadratic in positions that are rotated by the whole chain: its derivative is as large as M times the
        // rates.
        let bound = 2.0 * DIFFERENCE * size * motion.size();
        let deviation = (dual.map(|x| x.eps) - expected).amax();
        if bound > 0.0 {
            slope.note(&case.name, deviation / (size * motion.size()), bound / (size * motion.size()));
            let kinds = case.mechanism.joint_ids().filter(|&id| !system.is_locked(id));
            moved.extend(kinds.map(|id| case.mechanism.joint(id).kind()));
        }
    }
    value.report();
    slope.report();
    for kind in JointKind::ALL {
        assert!(moved.contains(&kind), "{kind:?} never moved");
    }
}

fn together(four: &[Vec<f64>; 4]) -> Vec<Lanes> {
    (0..four[0].len()).map(|k| Lanes(std::array::from_fn(|lane| four[lane][k]))).collect()
}

/// Four configurations of a subject: its own, and three nearby along an admissible motion, for which its decisions
/// hold.
fn nearby_configurations(subject: &Subject, motion: &Motion) -> [Vec<f64>; 4] {
    let step = |lane: usize| match lane {
        0 => subject.pose.positions().to_vec(),
        _ => subject.positions_after(motion, [1e-3, -2e-3, 5e-3][lane - 1] / motion.size()),
    };
    std::array::from_fn(step)
}

#[test]
fn every_lane_is_the_plain_answer_to_the_last_bit() {
    let (mut entries, mut answers, mut decided_otherwise) = (0, 0, Vec::new());
    let subjects = of_trees(3, 2, 80).into_iter().chain(of_linkages(320, 16));
    for (i, subject) in subjects.enumerate() {
        let Subject { name, pose, contact, .. } = &subject;
        let mut rng = StdRng::seed_from_u64(32 + i as u64);
        let Some(motion) = subject.motion(&mut rng) else { continue };
        let four = nearby_configurations(&subject, &motion);
        let Some(mut lanes) = over::<Lanes>(pose, contact) else { continue };
        lanes.set_positions(&together(&four)).expect("positions that fit");
        let (matrices, inverses) = (lanes.mass_matrix(), lanes.inverse_effective_mass());
        let mut scalar = pose.workspace_over::<f64>(contact).expect("a contact");
        let mut workspace = pose.assembly().workspace();
        // True if the workspace uses the SIMD kernel for this contact.
        let in_lanes = pose.assembly().batch(contact).is_ok_and(|batch| batch.has_lanes());
        // The lanes follow the recursion, even if the dense route is preferred.
        let response = pose.respond(contact);
        let by_recursion = response.as_ref().is_ok_and(|r| r.dense_reason.is_none() && !r.is_energy_value);
        for (lane, positions) in four.iter().enumerate() {
            scalar.set_positions(positions).expect("positions that fit");
            let plain = scalar.mass_matrix();
            for (a, b) in matrices.iter().zip(&plain) {
                assert_eq!(a.0[lane].to_bits(), b.to_bits(), "{name}, lane {lane}");
                entries += 1;
            }
            let inverse = scalar.inverse_effective_mass();
            assert_eq!(inverses.0[lane].to_bits(), inverse.to_bits(), "{name}, lane {lane}");
            if !by_recursion {
                continue;
            }
            if let (0, Ok(EffectiveMass::Finite(m))) = (lane, response.as_ref().map(|r| r.effective_mass)) {
                assert_eq!((1.0 / inverse).to_bits(), m.to_bits(), "{name}: {} and {m} kg", 1.0 / inverse);
                answers += 1;
            }
            workspace.set_positions(positions).expect("positions that fit");
            let Ok(EffectiveMass::Finite(m)) = workspace.effective_mass(contact) else { continue };
            if (1.0 / inverse).to_bits() == m.to_bits() {
                answers += 1;
                continue;
            }
            // Another coordinate was chosen as dependent: the same result by other operations.
            let near = (inverse * m - 1.0).abs();
            if in_lanes {
                assert!(near < 1e-11, "{name}, lane {lane}: {} and {m} kg", 1.0 / inverse);
                continue;
            }
            assert!(lane > 0 && near < 1e-9, "{name}, lane {lane}: {} and {m} kg", 1.0 / inverse);
            decided_otherwise.push(name.clone());
        }
    }
    println!("{entries} entries of M, {answers} answers; decided otherwise: {}", decided_otherwise.len());
    decided_otherwise.iter().for_each(|name| println!("    {name}"));
    assert!(entries > 0 && answers > 1000, "{entries} and {answers}");
    assert!(20 * decided_otherwise.len() < answers, "{} of {answers}", decided_otherwise.len());
}

/// In trees without mimics, the configuration decides at most the elimination order of a joint's velocities: lanes may
/// have any positions.
#[test]
fn lanes_of_trees_may_have_any_positions() {
    let mut answers = 0;
    for (i, case) in all_cases().into_iter().enumerate() {
        let system = case.system();
        let pose = case.pose(&system);
        if case.has_moving_mimics(&system) || regular_condition(&pose).is_none() {
            continue;
        }
        let mut rng = StdRng::seed_from_u64(34 + i as u64);
        let four: [Vec<f64>; 4] =
            std::array::from_fn(|_| percuss_oracle::random::positions(&mut rng, &case.mechanism).concat());
        let Some(mut lanes) = over::<Lanes>(&pose, &case.contact()) else { continue };
        lanes.set_positions(&together(&four)).expect("positions that fit");
        let inverses = lanes.inverse_effective_mass();
        let mut plain = pose.workspace_over::<f64>(&case.contact()).expect("a contact");
        let mut workspace = system.workspace();
        for (lane, positions) in four.iter().enumerate() {
            plain.set_positions(positions).expect("positions that fit");
            let inverse = plain.inverse_effective_mass();
            assert_eq!(inverses.0[lane].to_bits(), inverse.to_bits(), "{}, lane {lane}", case.name);
            workspace.set_positions(positions).expect("positions that fit");
            if let Ok(EffectiveMass::Finite(m)) = workspace.effective_mass(&case.contact()) {
                // The workspace may eliminate the velocities of a joint in another order.
                let off = (m * inverse - 1.0).abs();
                assert!(off < judge::NEAR, "{}, lane {lane}: {off:e}", case.name);
                answers += 1;
            }
        }
    }
    assert!(answers > 500, "{answers}");
}

/// Four values of one joint, with the other joints at the given positions.
fn four_at(positions: &[f64], joint: usize, values: [f64; 4]) -> Vec<Lanes> {
    let at = |k: usize, value: f64| if k == joint { value } else { positions[k] };
    (0..positions.len()).map(|k| Lanes(values.map(|value| at(k, value)))).collect()
}

fn link(mechanism: &Mechanism, name: &str) -> LinkId {
    mechanism.find_link(name).expect("a link")
}

/// A lane reports decisions of its pose that do not hold: a vanishing pivot of the mass or of the constraints.
#[test]
fn lanes_report_vanished_pivots() {
    // A point mass on a massless arm, folded back onto the shoulder.
    let (_, mut joints) = alter::describe(&zoo::double_pendulum());
    let names: Vec<String> = ["ground", "arm", "tip"].map(String::from).into();
    for (i, joint) in joints.iter_mut().enumerate() {
        (joint.parent, joint.child) = (names[i].clone(), names[i + 1].clone());
        joint.armature.clear();
        joint.origin.translation = percuss_spatial::Vector3::new(0.5 * i as f64, 0.0, 0.0);
    }
    let links = vec![
        LinkDescription::massless("ground"),
        LinkDescription::massless("arm"),
        LinkDescription::new("tip", Inertial::point(2.0, [0.5, 0.0, 0.0])),
    ];
    let folded = alter::build("folded", links, joints);
    let contact = Contact::new(
        link(&folded, "arm"),
        [0.5, 0.1, 0.0],
        folded.joints()[1].axis().cross(&percuss_spatial::Vector3::x()),
    );
    let system = System::new(folded, &Conditions::new()).expect("a chain");
    let pose = system
        .pose(system.configuration().set(system.mechanism().joints()[1].name(), &[0.8]).expect("a joint"));
    let pose = pose.expect("a tree poses");
    let mut lanes = pose.workspace_over::<Lanes>(&contact).expect("an answer");
    lanes
        .set_positions(&four_at(pose.positions(), 1, [0.8, 1.9, std::f64::consts::PI, 2.5]))
        .expect("positions that fit");
    let inverses = lanes.inverse_effective_mass().0;
    let losses = lanes.pivot_loss().0;
    assert!(losses[0].max(losses[1]).max(losses[3]) < 1e-12, "{losses:?}, {inverses:?}");
    assert!(losses[2].is_nan() || losses[2] >= 1.0, "{losses:?}, {inverses:?}");

    // A parallelogram: its branches cross in the flat pose.
    let (mechanism, start) = {
        let l = linkage::parallelogram();
        (l.mechanism, l.start)
    };
    let crank = link(&mechanism, "coupler");
    let contact = Contact::new(crank, [0.31, -0.12, 0.0], [0.2, 0.9, 0.0]);
    let system = System::new(mechanism, &Conditions::new()).expect("loops that close");
    let mut near = system.configuration();
    for (joint, value) in &start {
        near.guess(joint, value).expect("a joint");
    }
    near.set("crank_hinge", &[1.2]).expect("a driver");
    let pose = system.pose(&near).expect("closed");
    let from = |angle: f64| {
        let mut there = system.configuration();
        there.set("crank_hinge", &[angle]).expect("a driver");
        system.pose_from(&pose, &there).expect("along the branch").positions().to_vec()
    };
    let four = [1.2, 0.6, 0.0, 1e-3].map(from);
    let mut lanes = pose.workspace_over::<Lanes>(&contact).expect("an answer");
    lanes.set_positions(&together(&four)).expect("positions that fit");
    let inverses = lanes.inverse_effective_mass().0;
    let losses = lanes.pivot_loss().0;
    assert!(losses[0].max(losses[1]).max(losses[3]) < 1e-6, "{losses:?}, {inverses:?}");
    assert!(losses[2].is_nan() || losses[2] >= 1.0, "{losses:?}, {inverses:?}");
}

#[test]
fn contacts_without_an_inverse_mass_are_refused() {
    let refused = |mechanism: Mechanism, name: &str, point: [f64; 3], normal: [f64; 3]| {
        let contact = Contact::new(link(&mechanism, name), point, normal);
        let system = System::new(mechanism, &Conditions::new()).expect("conditions that fit");
        let pose = system.pose(&system.configuration()).expect("a tree poses");
        pose.workspace_over::<Dual64>(&contact).expect_err("refused")
    };
    let massless = refused(zoo::massless_tip(), "feeler", [0.2, 0.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(massless, ResponseError::Route(RouteError::MasslessMotion));
    let (mut links, joints) = alter::describe(&zoo::massless_tip());
    links[2].inertial = Some(Inertial::diagonal(0.0, [0.0; 3], [-0.1; 3]));
    let negative = alter::build("negative", links, joints);
    let negative = refused(negative, "arm", [0.3, 0.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(negative, ResponseError::Route(RouteError::Indefinite));
}

#[test]
fn positions_one_after_another_are_those_of_the_pose() {
    let mut rng = StdRng::seed_from_u64(33);
    let mut different = 0;
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        let Some(mut workspace) = over::<f64>(&pose, &case.contact()) else { continue };
        assert_eq!(workspace.mass_matrix(), pose.mass_matrix(), "{}", case.name);
        let here = workspace.inverse_effective_mass();
        // Entries of mimics are not read.
        let mut positions = pose.positions().to_vec();
        let mut first = 0;
        for joint in case.mechanism.joints() {
            if joint.mimic().is_some() {
                positions[first] = rand::Rng::random_range(&mut rng, -9.0..9.0);
                different += 1;
            }
            first += joint.kind().positions();
        }
        workspace.set_positions(&positions).expect("positions that fit");
        assert_eq!(workspace.mass_matrix(), pose.mass_matrix(), "{}", case.name);
        assert_eq!(workspace.inverse_effective_mass().to_bits(), here.to_bits(), "{}", case.name);
    }
    assert!(different > 0, "no mimic came");
}
