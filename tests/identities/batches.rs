//! Many configurations at once: each lane agrees with a pose within the errors stated by both, and is bitwise equal to
//! a single configuration for every instruction set.

use nalgebra::Vector3;
use percuss_dynamics::{
    Base, Batch, BatchAnswer, BatchError, BatchPositions, BatchRows, Conditions, Contact, Direction,
    EffectiveMass, Frame, GivenPositions, Pose, RemarkFlags, ResponseError, RowColumns, RowResults, System,
};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder, MimicDescription,
};
use percuss_oracle::zoo;
use percuss_spatial::lanes::Instructions;
use percuss_spatial::{Matrix3, Transform, rotation_about};
use percuss_tests::answer::answers;
use percuss_tests::judge::UNSTATED;
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::{FRAC_PI_2, PI};

const SETS: [Instructions; 3] = [Instructions::Baseline, Instructions::Avx2, Instructions::Avx512];

/// Tree with joints of all kinds, mostly hinges; axes at right angles and parallel, or arbitrary; masses over `decades`
/// decades. A joint with one degree of freedom mimics an earlier one of its kind with the probability `mimics`.
fn tree(rng: &mut StdRng, bodies: usize, square: bool, decades: f64, mimics: f64) -> Mechanism {
    let mut masters: Vec<(JointKind, String)> = Vec::new();
    let mut builder = MechanismBuilder::new("tree").link(link(rng, 0, decades));
    let bushy = rng.random_bool(0.4);
    for i in 1..=bodies {
        let parent = if bushy { rng.random_range(0..i) } else { rng.random_range(i.saturating_sub(2)..i) };
        let kind = match rng.random_range(0..15) {
            0..=6 => JointKind::Revolute,
            7 => JointKind::Continuous,
            8 | 9 => JointKind::Prismatic,
            10 => JointKind::Planar,
            11 => JointKind::Spherical,
            // A floating joint transmits no inertia of a child of 1e8 kg; the general recursion would classify
            // remainders below its rounding as massless.
            12 if decades < 10.0 => JointKind::Floating,
            _ => JointKind::Fixed,
        };
        let mut joint = JointDescription::new(format!("j{i}"), kind, format!("l{parent}"), format!("l{i}"));
        let axis = |rng: &mut StdRng| {
            let mut e = Vector3::zeros();
            e[rng.random_range(0..3)] = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
            e
        };
        joint.axis = if square { axis(rng) } else { any(rng).normalize() };
        let turn = if square {
            rotation_about(&axis(rng), FRAC_PI_2 * f64::from(rng.random_range(0..4)))
        } else {
            rotation_about(&any(rng).normalize(), rng.random_range(-PI..PI))
        };
        let place = if square { axis(rng) * rng.random_range(0.0..0.4) } else { any(rng) * 0.3 };
        joint.origin = Transform::new(turn, place);
        if kind.dofs() > 0 && rng.random_bool(0.3) {
            joint.armature = (0..kind.dofs()).map(|_| 10f64.powf(rng.random_range(-4.0..0.0))).collect();
        }
        let own: Vec<&String> =
            masters.iter().filter(|(other, _)| *other == kind).map(|(_, name)| name).collect();
        if kind.dofs() == 1 && mimics > 0.0 {
            if !own.is_empty() && rng.random_bool(mimics) {
                let master = own[rng.random_range(0..own.len())].clone();
                let multiplier = rng.random_range(0.2..2.0) * if rng.random_bool(0.5) { 1.0 } else { -1.0 };
                joint.mimic =
                    Some(MimicDescription { joint: master, multiplier, offset: rng.random_range(-0.2..0.2) });
            } else {
                masters.push((kind, joint.name.clone()));
            }
        }
        builder = builder.link(link(rng, i, decades)).joint(joint);
    }
    builder.build().expect("a tree").mechanism
}

fn any(rng: &mut StdRng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))
}

fn link(rng: &mut StdRng, i: usize, decades: f64) -> LinkDescription {
    let mass = 10f64.powf(rng.random_range(-decades / 2.0..=decades / 2.0));
    let [a, b, c] = [0; 3].map(|_| mass * rng.random_range(0.02f64..0.2).powi(2));
    let r = rotation_about(&any(rng).normalize(), rng.random_range(-PI..PI));
    let about_com = r * Matrix3::from_diagonal(&Vector3::new(b + c, a + c, a + b)) * r.transpose();
    let about_com = (about_com + about_com.transpose()) / 2.0;
    LinkDescription::new(format!("l{i}"), Inertial { mass, com: any(rng) * 0.2, about_com })
}

/// Positions of all joints, one configuration after another; some positions are far from zero.
fn rows(rng: &mut StdRng, mechanism: &Mechanism, count: usize) -> Vec<f64> {
    let mut rows = Vec::new();
    for _ in 0..count {
        let far = rng.random_bool(0.1);
        for joint in mechanism.joints() {
            match joint.kind() {
                JointKind::Fixed => {}
                JointKind::Prismatic => rows.push(rng.random_range(-0.5..0.5)),
                JointKind::Revolute | JointKind::Continuous => {
                    rows.push(rng.random_range(-PI..PI) * if far { 1e4 } else { 1.0 });
                }
                JointKind::Planar => {
                    rows.extend([0; 2].map(|_| rng.random_range(-0.5..0.5)));
                    rows.push(rng.random_range(-PI..PI));
                }
                JointKind::Spherical => rows.extend(quaternion(rng)),
                JointKind::Floating => {
                    rows.extend([0; 3].map(|_| rng.random_range(-0.5..0.5)));
                    rows.extend(quaternion(rng));
                }
            }
        }
    }
    rows
}

fn quaternion(rng: &mut StdRng) -> [f64; 4] {
    let q = nalgebra::Vector4::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
    [q.x, q.y, q.z, q.w]
}

/// Pose at a row of positions.
fn pose_at(system: &System, row: &[f64]) -> Pose {
    let mut configuration = system.configuration();
    let mut at = 0;
    for joint in system.mechanism().joints() {
        let count = joint.kind().positions();
        if count > 0 && joint.mimic().is_none() {
            configuration.set(joint.name(), &row[at..at + count]).expect("a position");
        }
        at += count;
    }
    system.pose(&configuration).expect("a tree")
}

fn by_columns(rows: &[f64], width: usize) -> Vec<f64> {
    let count = rows.len() / width;
    (0..width * count).map(|i| rows[(i % count) * width + i / count]).collect()
}

fn same(a: &BatchAnswer, b: &BatchAnswer) -> bool {
    let bits = |answer: &BatchAnswer| match answer.mass {
        Some(EffectiveMass::Finite(m)) => Some(m.to_bits()),
        _ => None,
    };
    a.mass.map(|m| std::mem::discriminant(&m)) == b.mass.map(|m| std::mem::discriminant(&m))
        && bits(a) == bits(b)
}

/// Statistics of a test.
#[derive(Default, Debug)]
struct Seen {
    answers: usize,
    /// Results with a stated error.
    stated: usize,
    /// Poses without a stated error.
    unstated: usize,
    /// Largest difference as a fraction of the sum of both errors.
    worst: f64,
    /// Largest relative error stated.
    largest: f64,
}

fn check(name: &str, system: &System, contact: &Contact, rows: &[f64], seen: &mut Seen) {
    let width: usize = system.mechanism().joints().iter().map(|j| j.kind().positions()).sum();
    let count = rows.len() / width;
    let mut batch = system.reference_or_open().batch(contact).expect("a contact that fits");
    let columns = by_columns(rows, width);
    let by_itself: Vec<BatchAnswer> =
        rows.chunks(width).map(|row| batch.effective_mass(row).expect("positions")).collect();
    for (row, answer) in rows.chunks(width).zip(&by_itself) {
        seen.answers += 1;
        let response = pose_at(system, row).respond(contact).expect("an answer");
        let (Some(EffectiveMass::Finite(m)), Some(error)) = (answer.mass, answer.error) else {
            match (answer.mass, response.effective_mass) {
                (Some(EffectiveMass::Finite(a)), EffectiveMass::Finite(b)) => {
                    // Twice the error of a pose, plus 1e-11, below which a workspace omits terms.
                    let error = response.effective_mass_error();
                    seen.unstated += usize::from(error.is_none());
                    let allowed = 2.0 * error.unwrap_or(UNSTATED * b) + 1e-11 * b;
                    assert!((a - b).abs() <= allowed, "{name}, asked again: {a} {b}, allowed {allowed:e}");
                }
                (a, b) => assert_eq!(a, Some(b), "{name}, asked again"),
            }
            continue;
        };
        seen.stated += 1;
        let EffectiveMass::Finite(expected) = response.effective_mass else {
            panic!("{name}: {m} kg for {:?}", response.effective_mass)
        };
        let allowed = error + response.effective_mass_error().expect("an error");
        seen.worst = seen.worst.max((m - expected).abs() / allowed);
        seen.largest = seen.largest.max(error / m);
        assert!((m - expected).abs() <= allowed, "{name}: {m} for {expected}, allowed {allowed:e}");
    }
    for set in SETS.into_iter().filter(|set| set.is_available()) {
        let batch = batch.clone().with_instructions(set);
        let mut one = batch.clone();
        let expected: Vec<BatchAnswer> =
            rows.chunks(width).map(|row| one.effective_mass(row).expect("positions")).collect();
        for positions in [
            BatchPositions::Rows { values: rows, stride: width },
            BatchPositions::Columns { values: &columns, stride: count },
        ] {
            let mut results = RowResults::new(count);
            one.run(positions, results.columns(), usize::MAX).expect("enough");
            let in_blocks = answers(&batch, positions, count, 7).expect("enough");
            for (at, (a, b)) in in_blocks.iter().zip(&expected).enumerate() {
                assert!(same(a, b), "{name}, {}: {a:?}, alone {b:?}", set.name());
                let found = results.answer(at);
                assert!(same(&found, a) && found.error == a.error, "{name}: {found:?} at once, {a:?}");
                let is_finite = matches!(a.mass, Some(EffectiveMass::Finite(_)));
                assert_eq!(is_finite, results.masses[at].is_finite(), "{name}");
            }
        }
    }
}

fn contact_on(rng: &mut StdRng, mechanism: &Mechanism) -> Contact {
    let links: Vec<_> = mechanism.link_ids().collect();
    let link = links[rng.random_range(1..links.len())];
    let contact = Contact::new(link, any(rng) * 0.3, Vector3::x());
    let direction = any(rng);
    let normal = |frame| Direction::Along(direction, frame);
    match rng.random_range(0..5) {
        0 => contact.normal(normal(Frame::Link)),
        1 => contact.normal(normal(Frame::World)),
        kind => {
            let frame = [Frame::Link, Frame::Against, Frame::World][kind - 2];
            let contact = contact.normal(normal(frame));
            let others: Vec<_> = links.iter().filter(|other| **other != link).collect();
            contact.against(*others[rng.random_range(0..others.len())])
        }
    }
}

fn family(decades: f64, seed: u64, mimics: f64) -> Seen {
    let mut rng = StdRng::seed_from_u64(seed);
    let mut seen = Seen::default();
    for k in 0..120 {
        let bodies = rng.random_range(1..14);
        let mechanism = tree(&mut rng, bodies, k % 2 == 0, decades, mimics);
        let mut conditions = Conditions::new();
        if k % 3 == 0 {
            conditions = conditions.base(Base::Floating);
        }
        if k % 5 == 0
            && let Some(joint) = mechanism.joints().iter().find(|j| j.kind().dofs() == 1)
        {
            conditions = conditions.lock(joint.name());
        }
        let rows = rows(&mut rng, &mechanism, 11);
        if rows.is_empty() {
            continue;
        }
        let contact = contact_on(&mut rng, &mechanism);
        let system = System::new(mechanism, &conditions).expect("conditions that fit");
        check(&format!("{decades} decades, {k}"), &system, &contact, &rows, &mut seen);
    }
    println!("{decades} decades: {seen:?}");
    seen
}

#[test]
fn lanes_agree_with_poses() {
    let seen = family(2.0, 1, 0.0);
    assert!(seen.stated * 10 > seen.answers * 7, "{seen:?}");
}

#[test]
fn lanes_state_their_error_for_masses_over_many_decades() {
    for (decades, seed) in [(9.0, 2), (18.0, 3), (18.0, 4)] {
        let seen = family(decades, seed, 0.0);
        assert!(seen.stated * 10 > seen.answers, "{seen:?}");
    }
}

#[test]
fn lanes_with_mimics_agree_with_poses() {
    // Contacts between links of one cluster are often immovable.
    for (decades, seed, tenths) in [(2.0, 5, 5), (9.0, 6, 2), (18.0, 7, 1)] {
        let seen = family(decades, seed, 0.4);
        assert!(seen.stated * 10 > seen.answers * tenths, "{seen:?}");
    }
}

/// Bodies near the ground are light compared with their subtrees.
#[test]
fn lanes_of_thousands_of_bodies_agree_with_poses() {
    let mut rng = StdRng::seed_from_u64(11);
    let mut seen = Seen::default();
    for k in 0..6 {
        let mechanism = tree(&mut rng, 4_000, k % 2 == 0, 2.0, 0.0);
        let contact = contact_on(&mut rng, &mechanism);
        let rows = rows(&mut rng, &mechanism, 3);
        let system = System::new(mechanism, &Conditions::new()).expect("fits");
        check(&format!("long {k}"), &system, &contact, &rows, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.stated * 2 > seen.answers, "{seen:?}");
}

/// Light bracket between heavy links in line: its reduced inertia is the rounding of the inertia of its subtree.
#[test]
fn lanes_report_light_links_with_heavy_subtrees() {
    let mut rng = StdRng::seed_from_u64(5);
    let mut seen = Seen::default();
    for k in 0..200 {
        let light = 10f64.powf(rng.random_range(-12.0..0.0));
        let tilt = 10f64.powf(rng.random_range(-9.0..0.0));
        let mut builder = MechanismBuilder::new("bracket").link(LinkDescription::massless("l0"));
        for i in 1..=4 {
            let mass = if i % 2 == 1 { 1.0 } else { light };
            let inertial = Inertial {
                mass,
                com: any(&mut rng) * 0.2,
                about_com: Matrix3::from_diagonal(&Vector3::new(2e-2, 3e-2, 4e-2)) * mass,
            };
            let mut joint = JointDescription::new(
                format!("j{i}"),
                JointKind::Continuous,
                format!("l{}", i - 1),
                format!("l{i}"),
            );
            joint.axis = (Vector3::z() + any(&mut rng) * tilt).normalize();
            joint.origin = Transform::new(Matrix3::identity(), any(&mut rng) * tilt);
            builder = builder.link(LinkDescription::new(format!("l{i}"), inertial)).joint(joint);
        }
        let system =
            System::new(builder.build().expect("a tree").mechanism, &Conditions::new()).expect("fits");
        let rows = rows(&mut rng, system.mechanism(), 5);
        let contact = contact_on(&mut rng, system.mechanism());
        check(&format!("bracket {k}, {light:.1e}, {tilt:.1e}"), &system, &contact, &rows, &mut seen);
    }
    println!("{seen:?}");
    // The family has certain and uncertain masses.
    assert!(seen.stated > 100 && seen.largest > 1e-6, "{seen:?}");
}

/// By lanes or one by one: the results equal the results of a workspace, each with its own status. A finite m̄ has an error, unless that
/// of the pose is above m̄.
#[test]
fn every_mechanism_is_answered_as_by_a_workspace() {
    let subjects = of_trees(6, 2, 20).into_iter().chain(of_linkages(40, 6));
    let contacts = subjects.flat_map(|Subject { name, pose, contact, .. }| {
        let about = Contact::about_axis(contact.link, [0.3, -0.5, 0.8]);
        let moment = Contact { against: contact.against, ..about };
        let to_root = Direction::TurningToward(pose.mechanism().root(), [0.7, -1.1, 1.9].into());
        let line = Contact { against: None, ..contact }.normal(to_root);
        [("", contact), (", moment", moment), (", line", line)]
            .map(|(kind, contact)| (format!("{name}{kind}"), pose.clone(), contact))
    });
    let mut one_by_one = 0;
    for (name, pose, contact) in contacts {
        let batch = pose.assembly().batch(&contact).expect("a contact that fits");
        let values = pose.positions().repeat(3);
        let width = pose.positions().len();
        let rows = BatchPositions::Rows { values: &values, stride: width };
        let answers = answers(&batch, rows, 3, 2).expect("enough");
        let mut workspace = pose.assembly().workspace();
        workspace.set_positions(pose.positions()).expect("positions");
        let expected = workspace.effective_mass(&contact).ok();
        for answer in answers {
            match (answer.mass, expected) {
                (Some(EffectiveMass::Finite(a)), Some(EffectiveMass::Finite(b))) => {
                    assert!((a - b).abs() <= answer.error.unwrap_or(0.0) + 1e-11 * b, "{name}: {a} {b}");
                    one_by_one += usize::from(!batch.has_lanes());
                    let of_pose = || pose.respond(&contact).expect("a contact").effective_mass_error();
                    assert!(answer.error.is_some() || of_pose() > Some(b), "{name}: {answer:?}");
                }
                (a, b) => assert_eq!(a, b, "{name}"),
            }
        }
    }
    assert!(one_by_one > 0, "{one_by_one}");
}

/// Linkages at closed poses: each instruction set is bitwise equal to a single configuration, and agrees with a pose
/// within both errors. An open lane or a NaN lane does not affect other lanes.
#[test]
fn linkages_in_lanes_agree_with_poses() {
    let (mut seen, mut linkages, mut open) = (Seen::default(), 0, 0);
    for (k, subject) in of_linkages(43, 24).into_iter().enumerate() {
        let Subject { name, pose, contact, .. } = &subject;
        let mut batch = pose.assembly().batch(contact).expect("a contact that fits");
        if !batch.has_lanes() {
            continue;
        }
        linkages += 1;
        let mut rng = StdRng::seed_from_u64(k as u64);
        let width = pose.positions().len();
        let mut rows = pose.positions().to_vec();
        if let Some(motion) = subject.motion(&mut rng) {
            for step in [1e-3, -2e-3, 5e-3, -1e-2] {
                rows.extend(subject.positions_after(&motion, step / motion.size()));
            }
        }
        // Two rows that do not close.
        for bad in [1.0, f64::NAN] {
            let start = rows.len();
            rows.extend(pose.positions());
            rows[start + rng.random_range(0..width)] += bad;
        }
        let count = rows.len() / width;
        let answer = batch.effective_mass(pose.positions()).expect("positions");
        seen.answers += 1;
        if let (Some(EffectiveMass::Finite(m)), Some(error)) = (answer.mass, answer.error) {
            seen.stated += 1;
            let response = pose.respond(contact).expect("an answer");
            let EffectiveMass::Finite(expected) = response.effective_mass else {
                panic!("{name}: {m} kg for {:?}", response.effective_mass)
            };
            // Only the rounding part of the pose's error: both use the same positions.
            let allowed = error + response.error.and_then(|e| e.rounding).expect("an error");
            seen.worst = seen.worst.max((m - expected).abs() / allowed);
            seen.largest = seen.largest.max(error / m);
            assert!((m - expected).abs() <= allowed, "{name}: {m} for {expected}, allowed {allowed:e}");
        } else if matches!(answer.mass, Some(EffectiveMass::Finite(_))) {
            seen.unstated += 1;
        }
        let columns = by_columns(&rows, width);
        for set in SETS.into_iter().filter(|set| set.is_available()) {
            let batch = batch.clone().with_instructions(set);
            let mut one = batch.clone();
            let expected: Vec<BatchAnswer> =
                rows.chunks(width).map(|row| one.effective_mass(row).expect("positions")).collect();
            open += expected[count - 2..].iter().filter(|answer| answer.error.is_none()).count();
            for positions in [
                BatchPositions::Rows { values: &rows, stride: width },
                BatchPositions::Columns { values: &columns, stride: count },
            ] {
                let answers = answers(&batch, positions, count, 4).expect("enough");
                for (a, b) in answers.iter().zip(&expected) {
                    assert!(same(a, b), "{name}, {}: {a:?}, alone {b:?}", set.name());
                }
            }
        }
    }
    println!("{linkages} linkages: {seen:?}, {open} doubted because they are open");
    assert!(linkages > 75 && seen.stated * 10 > seen.answers * 4, "{linkages} linkages: {seen:?}");
    assert_eq!(seen.unstated, 0, "{seen:?}");
    assert!(open > linkages, "{open} doubted");
}

/// A massless, immovable or NaN lane has its own status and does not affect other lanes.
#[test]
fn lanes_are_independent() {
    let system = System::new(zoo::six_r_arm(), &Conditions::new()).expect("fits");
    let link = *system.mechanism().order().last().expect("links");
    let contact = Contact::new(link, [0.05, -0.02, 0.03], [0.3, -0.5, 0.8]);
    let mut batch = system.reference_or_open().batch(&contact).expect("fits");
    assert!(batch.has_lanes());
    let mut rng = StdRng::seed_from_u64(6);
    let rows = rows(&mut rng, system.mechanism(), 64);
    let mut spoilt = rows.clone();
    for (k, bad) in [f64::NAN, f64::INFINITY, 1e300, -1e17].into_iter().enumerate() {
        spoilt[6 * (5 + 9 * k) + k] = bad;
    }
    let spoilt = BatchPositions::Rows { values: &spoilt, stride: 6 };
    for (c, answer) in answers(&batch, spoilt, 64, 64).expect("enough").iter().enumerate() {
        if c % 9 != 5 || c > 32 {
            assert!(same(answer, &batch.effective_mass(&rows[6 * c..6 * c + 6]).expect("six")), "{c}");
        } else if c <= 14 {
            assert!(answer.mass.is_none() && answer.error.is_none(), "{c}: {answer:?}");
        } else {
            assert!(!matches!(answer.mass, Some(EffectiveMass::Finite(m)) if m.is_nan()), "{c}: {answer:?}");
        }
    }
}

/// A massless link on a hinge off the contact path does not change the mass, and the lanes remain in use; as contact
/// link, it is massless.
#[test]
fn massless_links_beside_the_contact_do_not_matter() {
    let hinge = |name: &str, parent: &str, child: &str| {
        JointDescription::new(name, JointKind::Continuous, parent, child).axis([0.0, 1.0, 0.0])
    };
    let system = |builder: MechanismBuilder| {
        System::new(builder.build().expect("a tree").mechanism, &Conditions::new()).expect("fits")
    };
    let arm = || {
        MechanismBuilder::new("arm")
            .link(LinkDescription::massless("ground"))
            .link(LinkDescription::new("upper", Inertial::point(3.0, [0.4, 0.0, 0.1])))
            .link(LinkDescription::new("lower", Inertial::point(2.0, [0.3, 0.1, 0.0])))
            .joint(hinge("shoulder", "ground", "upper"))
            .joint(hinge("elbow", "upper", "lower").at([0.5, 0.0, 0.0]))
    };
    let plain = system(arm());
    let with_flag = system(
        arm()
            .link(LinkDescription::massless("flag"))
            .joint(hinge("pole", "lower", "flag").at([0.1, 0.2, 0.0])),
    );
    let ask = |system: &System, link: &str, q: &[f64]| {
        let link = system.mechanism().find_link(link).expect("there");
        let contact = Contact::new(link, [0.3, 0.0, 0.2], [0.4, 0.0, 1.0]);
        system.reference_or_open().batch(&contact).expect("fits").effective_mass(q).expect("positions")
    };
    let (a, b) = (ask(&plain, "lower", &[0.3, -0.8]), ask(&with_flag, "lower", &[0.3, -0.8, 0.5]));
    let (Some(EffectiveMass::Finite(m)), Some(EffectiveMass::Finite(other))) = (a.mass, b.mass) else {
        panic!("{a:?} {b:?}")
    };
    // The flag's axis rotates the frame of the lower arm: a few roundings.
    assert!(a.error.is_some() && b.error.is_some() && (m / other - 1.0).abs() < 4e-15, "{a:?} {b:?}");
    let massless = RemarkFlags::MASSLESS_MOTIONS | RemarkFlags::UNDETERMINED_MOTION;
    assert_eq!([a.remarks, b.remarks], [RemarkFlags::NONE, massless]);
    assert_eq!(ask(&with_flag, "flag", &[0.3, -0.8, 0.5]).mass, Some(EffectiveMass::Massless));
}

#[test]
fn wrong_shapes_are_errors() {
    let system = System::new(zoo::six_r_arm(), &Conditions::new()).expect("fits");
    let link = *system.mechanism().order().last().expect("links");
    let contact = Contact::new(link, [0.0; 3], [0.0, 0.0, 1.0]);
    let batch = system.reference_or_open().batch(&contact).expect("fits");
    let values = vec![0.1; 6 * 5000];
    for (positions, expected) in [
        (BatchPositions::Rows { values: &values[..29_999], stride: 6 }, "30000"),
        (BatchPositions::Columns { values: &values[..29_999], stride: 5000 }, "30000"),
        (BatchPositions::Rows { values: &values, stride: 5 }, "at least 6"),
        (BatchPositions::Columns { values: &values, stride: 4999 }, "at least 5000"),
        (BatchPositions::Rows { values: &values, stride: usize::MAX }, "need"),
    ] {
        let error = answers(&batch, positions, 5000, 512).expect_err("too few");
        assert!(error.to_string().contains(expected), "{error}");
    }
    assert_eq!(answers(&batch, BatchPositions::Rows { values: &[], stride: 6 }, 0, 1), Ok(Vec::new()));
    // A NaN row has no answer; it differs from an immovable row.
    let mut spoilt = values[..12].to_vec();
    spoilt[9] = f64::NAN;
    let rows = BatchPositions::Rows { values: &spoilt, stride: 6 };
    let found = answers(&batch, rows, 2, 2).expect("enough");
    assert!(found[0].error.is_some() && found[1].mass.is_none(), "{found:?}");
    // Rows of numbers only; rows that give the fourth position only.
    let finite_only = BatchRows { finite_only: true, ..rows.into() };
    let refused = answers(&batch, finite_only, 2, 1).expect_err("a NaN");
    assert!(
        matches!(refused, BatchError::NotFinite { configuration: 1, number: 3, value } if value.is_nan())
    );
    let fourth = BatchPositions::Columns { values: &[0.1, 0.7], stride: 2 };
    let given = Some(GivenPositions { indices: &[3], others: &values[..6] });
    let found = answers(&batch, BatchRows { given, ..fourth.into() }, 2, 1).expect("enough");
    let mut alone = batch.clone();
    for (x, found) in [0.1, 0.7].into_iter().zip(&found) {
        assert!(same(found, &alone.effective_mass(&[0.1, 0.1, 0.1, x, 0.1, 0.1]).expect("six")), "{found:?}");
    }
    for given in [
        GivenPositions { indices: &[6], others: &values[..6] },
        GivenPositions { indices: &[3], others: &values[..5] },
    ] {
        let refused = answers(&batch, BatchRows { given: Some(given), ..fourth.into() }, 2, 2);
        assert!(matches!(refused, Err(BatchError::GivenPositions { width: 6, .. })), "{refused:?}");
    }
    let mut workspace = system.reference_or_open().workspace();
    for (row, is_number) in [(&spoilt[..6], true), (&spoilt[6..], false), (&spoilt[..6], true)] {
        workspace.set_positions(row).expect("six");
        match workspace.effective_mass(&contact) {
            Err(ResponseError::NotFinite { index: 3, value }) => assert!(value.is_nan() && !is_number),
            other => assert!(is_number && matches!(other, Ok(EffectiveMass::Finite(_))), "{other:?}"),
        }
    }
    // Columns of different lengths, and fewer numbers than needed.
    let rows = BatchPositions::Rows { values: &values[..12], stride: 6 };
    let mut results = RowResults::new(2);
    let uneven = RowColumns { errors: &mut [0.0; 3], ..results.columns() };
    assert_eq!(batch.run(rows, uneven, 2), Err(BatchError::Columns { masses: 2, other: 3 }));
    let short = answers(&batch, rows, 3, 3);
    assert!(matches!(short, Err(BatchError::Short { needed: 18, got: 12, .. })), "{short:?}");
}

/// Sine and cosine in lanes, compared with the standard library: a point mass on a hinged arm, whose m̄ along a fixed
/// normal is m/sin² of the angle between arm and normal.
#[test]
fn sines_hold_up_to_the_largest_angles() {
    let mechanism = zoo::point_mass_pendulum(2.0, 0.5);
    let system = System::new(mechanism, &Conditions::new()).expect("fits");
    let link = *system.mechanism().order().last().expect("links");
    let contact = Contact::new(link, [0.0; 3], [1.0, 0.0, 0.0])
        .normal(Direction::Along(Vector3::new(0.4, 0.3, 0.5), Frame::World));
    let mut batch: Batch = system.reference_or_open().batch(&contact).expect("fits");
    let mut rng = StdRng::seed_from_u64(8);
    let mut by_lanes = 0;
    for k in 0..20_000 {
        let q = rng.random_range(-1.0..1.0) * 10f64.powf(rng.random_range(-3.0..5.0));
        let answer = batch.effective_mass(&[q]).expect("one");
        let mut workspace = system.workspace();
        workspace.set_positions(&[q]).expect("one");
        let Ok(EffectiveMass::Finite(expected)) = workspace.effective_mass(&contact) else { continue };
        let Some(EffectiveMass::Finite(m)) = answer.mass else { panic!("{q}: {answer:?}") };
        by_lanes += usize::from(answer.error.is_some());
        // A small projection of the normal has the error of a few roundings of its terms.
        let relative = 8.0 * f64::EPSILON * (1.0 + (expected / 2.0).sqrt());
        assert!((m / expected - 1.0).abs() < relative, "{k}, {q}: {m} {expected}");
    }
    assert!(by_lanes > 19_000, "{by_lanes}");
}
