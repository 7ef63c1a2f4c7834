//! Families of mechanisms: random trees, the specimens of every joint, linkages, the shipped models.

use crate::support::{Case, case, checked, compare, pose, request, run};
use percuss_dynamics::{Conditions, Contact, Direction, Frame, System};
use percuss_oracle::{linkage, random, zoo};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::sync::Arc;

fn drawn_contact(rng: &mut StdRng, mechanism: &percuss_mechanism::Mechanism) -> Contact {
    let (link, against, point, normal) = random::contact(rng, mechanism);
    let normal = Direction::Along(normal, Frame::World);
    Contact { link, against, point, normal }
}

#[test]
fn random_trees() {
    let mut cases: Vec<Case> = Vec::new();
    let mut left_out = Vec::new();
    for seed in 0..24 {
        let mut rng = StdRng::seed_from_u64(seed);
        let mechanism = Arc::new(random::mechanism(&mut rng, 2 + seed as usize % 9));
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact = drawn_contact(&mut rng, &mechanism);
        let mut poses =
            (0..6).filter_map(|_| pose(&system, &random::positions(&mut rng, &mechanism).concat()));
        let first = poses.next().expect("a pose");
        let checked: Vec<_> = poses.filter_map(|p| checked(&p, &contact)).collect();
        let request = request(&format!("tree_{seed}"), &mechanism, first, contact);
        match case(&request, checked) {
            Ok(case) => cases.push(case),
            Err(error) => left_out.push(format!("{seed}: {error}")),
        }
    }
    let results = run("random_trees", &cases);
    assert!(left_out.is_empty(), "{left_out:#?}");
    assert_eq!(compare(&cases, &results), (120, 0));
}

#[test]
fn specimens_of_every_joint() {
    let mut cases: Vec<Case> = Vec::new();
    let mut left_out = Vec::new();
    for (name, mechanism) in zoo::all() {
        let mut rng = StdRng::seed_from_u64(5);
        let mechanism = Arc::new(mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact = drawn_contact(&mut rng, &mechanism);
        let mut poses =
            (0..6).filter_map(|_| pose(&system, &random::positions(&mut rng, &mechanism).concat()));
        let first = poses.next().expect("a pose");
        let checked: Vec<_> = poses.filter_map(|p| checked(&p, &contact)).collect();
        let name = name.replace([' ', '-'], "_");
        let request = request(&format!("zoo_{name}"), &mechanism, first, contact);
        match case(&request, checked) {
            Ok(case) => cases.push(case),
            Err(error) => left_out.push(format!("{name}: {error}")),
        }
    }
    let results = run("specimens", &cases);
    let (finite, refused) = compare(&cases, &results);
    assert!(finite >= 60 && refused == 0, "{finite} {refused}");
    // The root of the specimen of one body does not move on the ground.
    assert!(left_out.len() == 1 && left_out[0].starts_with("single_body: no motion"), "{left_out:#?}");
}

#[test]
fn linkages() {
    let mut cases: Vec<Case> = Vec::new();
    let mut left_out = Vec::new();
    for one in linkage::all() {
        let mut rng = StdRng::seed_from_u64(11);
        let positions: Vec<Vec<Vec<f64>>> = one.sweep(6);
        let name = one.name.replace([' ', '-'], "_");
        let mechanism = Arc::new(one.mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact = drawn_contact(&mut rng, &mechanism);
        let mut poses = positions.iter().filter_map(|p| pose(&system, &p.concat()));
        let Some(first) = poses.next() else {
            left_out.push(format!("{name}: no pose"));
            continue;
        };
        let checked: Vec<_> = poses.filter_map(|p| checked(&p, &contact)).collect();
        let request = request(&format!("linkage_{name}"), &mechanism, first, contact);
        match case(&request, checked) {
            Ok(case) => cases.push(case),
            Err(error) => left_out.push(format!("{name}: {error}")),
        }
    }
    let results = run("linkages", &cases);
    let (finite, refused) = compare(&cases, &results);
    assert!(finite >= 95 && refused == 0, "{finite} {refused}");
    assert!(left_out.is_empty(), "{left_out:#?}");
}

#[test]
fn shipped_models() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let mut cases: Vec<Case> = Vec::new();
    let mut left_out = Vec::new();
    let mut files: Vec<_> = std::fs::read_dir(folder).expect("models").flatten().map(|e| e.path()).collect();
    files.sort();
    for path in files.iter().filter(|p| p.extension().is_some_and(|e| e == "urdf")) {
        let mut rng = StdRng::seed_from_u64(3);
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let source = percuss_formats::Source::read(&path.to_string_lossy(), 1 << 24).expect("a file");
        let loaded =
            percuss_formats::load(&source, &percuss_formats::LoadOptions::default()).expect("a model");
        let mechanism = Arc::new(loaded.mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact = drawn_contact(&mut rng, &mechanism);
        let first = system.pose(&system.configuration()).expect("a pose");
        let mut poses = vec![first.clone()];
        for _ in 0..8 {
            let mut q = first.positions().to_vec();
            let tree = mechanism.closures().is_empty();
            let size = if tree { 2.0 } else { 0.2 };
            let mut at = 0;
            for joint in mechanism.joints() {
                let positions = joint.kind().positions();
                if positions == 1 {
                    q[at] += size * rng.random_range(-1.0..1.0);
                }
                at += positions;
            }
            poses.extend(pose(&system, &q));
        }
        let checked: Vec<_> = poses.iter().filter_map(|p| checked(p, &contact)).collect();
        let request = request(&name, &mechanism, first, contact);
        match case(&request, checked) {
            Ok(case) => cases.push(case),
            Err(error) => left_out.push(format!("{name}: {error}")),
        }
    }
    let results = run("shipped", &cases);
    let (finite, refused) = compare(&cases, &results);
    assert!(finite >= 150 && refused == 0, "{finite} {refused}");
    // Its root is the ground unless the base floats.
    assert!(left_out.len() == 1 && left_out[0].starts_with("floating_body: no motion"), "{left_out:#?}");
}

/// Random loops of all closures: some are rigid, some have redundant rows.
#[test]
fn random_linkages() {
    let mut cases: Vec<Case> = Vec::new();
    let mut left_out = Vec::new();
    for seed in 0..30 {
        let mut rng = StdRng::seed_from_u64(100 + seed);
        let bodies = 3 + seed as usize % 5;
        let (mechanism, closed) = random::linkage(&mut rng, bodies, 1 + seed as usize % 2);
        let mechanism = Arc::new(mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact = drawn_contact(&mut rng, &mechanism);
        let Some(first) = pose(&system, &closed.concat()) else {
            left_out.push(format!("{seed}: no pose"));
            continue;
        };
        let mut poses = vec![first.clone()];
        for _ in 0..4 {
            let mut q = first.positions().to_vec();
            let mut at = 0;
            for joint in mechanism.joints() {
                if joint.kind().positions() == 1 {
                    q[at] += rng.random_range(-0.05..0.05);
                }
                at += joint.kind().positions();
            }
            poses.extend(pose(&system, &q));
        }
        let checked: Vec<_> = poses.iter().filter_map(|p| checked(p, &contact)).collect();
        let request = request(&format!("loops_{seed}"), &mechanism, first, contact);
        match case(&request, checked) {
            Ok(case) => cases.push(case),
            Err(error) => left_out.push(format!("{seed}: {error}")),
        }
    }
    let results = run("random_linkages", &cases);
    let (finite, refused) = compare(&cases, &results);
    assert!(finite >= 135 && refused == 0, "{finite} {refused}");
    assert!(left_out.len() == 1 && left_out[0].contains("no motion"), "{left_out:#?}");
}

/// Locks, armatures, held points, floating bases and free bodies on the other side.
#[test]
fn conditions() {
    let mut cases: Vec<Case> = Vec::new();
    let mechanism = Arc::new(zoo::six_r_arm());
    let names: Vec<String> = mechanism.joints().iter().map(|joint| joint.name().to_owned()).collect();
    let tool = mechanism.links().last().expect("a link").name().to_owned();
    let point = [0.05, 0.02, -0.1];
    let normal = nalgebra::Vector3::new(0.3, -0.2, 0.9);
    let plain = Conditions::new;
    let all: [(&str, Conditions, bool); 5] = [
        ("locked", plain().lock(&names[1]), false),
        ("armature", plain().armature(&names[2], [0.7]), false),
        ("floating", plain().base(percuss_dynamics::Base::Floating), false),
        ("held", plain().hold(&tool, point, Some(normal)), true),
        (
            "held_floating",
            plain().base(percuss_dynamics::Base::Floating).hold(&tool, point, Some(normal)),
            true,
        ),
    ];
    for (name, conditions, is_held) in all {
        let mut rng = StdRng::seed_from_u64(8);
        let system = System::new(Arc::clone(&mechanism), &conditions).expect("a system");
        let link = mechanism.find_link(&tool).expect("the tool");
        let mut contact = Contact::new(link, [0.1, 0.0, 0.05], [0.2, -0.7, 0.4]);
        if name == "floating" {
            contact = contact.normal(Direction::Along(normal, Frame::World));
        }
        let poses: Vec<_> =
            (0..6).filter_map(|_| pose(&system, &random::positions(&mut rng, &mechanism).concat())).collect();
        let checked: Vec<_> = poses.iter().filter_map(|p| checked(p, &contact)).collect();
        let mut request = request(name, &mechanism, poses[0].clone(), contact);
        request.system = system;
        if name == "armature" {
            request.armatures = vec![(mechanism.find_joint(&names[2]).expect("a joint"), vec![0.7])];
        }
        if is_held {
            request.holds =
                vec![percuss_generate::HeldPoint { link, point: point.into(), normal: Some(normal) }];
        }
        cases.push(case(&request, checked).unwrap_or_else(|error| panic!("{name}: {error}")));
    }
    let results = run("conditions", &cases);
    assert_eq!(compare(&cases, &results), (30, 0));
}

/// Reasons for a refusal name the joint or the contact.
#[test]
fn refusals_name_the_cause() {
    use percuss_generate::GenerateError;
    let mechanism = Arc::new(zoo::double_pendulum());
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let first = pose(&system, &[0.1, 0.2]).expect("a pose");
    let link = mechanism
        .links()
        .last()
        .map(|link| mechanism.find_link(link.name()).expect("a link"))
        .expect("links");
    // Both hinges have parallel axes: no motion along the axis.
    let axis = *mechanism.joints()[0].axis();
    let along = Contact::new(link, [0.0, 0.0, -0.3], axis);
    let made = |contact: Contact, additions| {
        let mut request = request("refused", &mechanism, first.clone(), contact);
        request.additions = additions;
        percuss_generate::generate(&request)
    };
    let none = percuss_generate::Additions::default();
    assert_eq!(made(along, none).err(), Some(GenerateError::Immovable));
    let root = mechanism.root();
    let across = axis.cross(&nalgebra::Vector3::new(0.3, 0.5, 0.7));
    let toward = Contact::new(link, [0.0, 0.0, -0.3], across).normal(Direction::Toward(root, across));
    assert_eq!(made(toward, none).err(), Some(GenerateError::LimitedLine));
    let close = percuss_generate::Additions { close: true, ..none };
    assert_eq!(made(Contact::new(link, [0.0, 0.0, -0.3], across), close).err(), Some(GenerateError::NoLoops));
}

/// At a change point the loops have less than their rank: the code returns a status, never a number.
#[test]
fn change_points_are_reported() {
    let mut cases: Vec<Case> = Vec::new();
    for one in [linkage::parallelogram(), linkage::antiparallelogram()] {
        let positions = one.sweep(3);
        let driver = one.drivers[0].clone();
        let mechanism = Arc::new(one.mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let first = pose(&system, &positions[1].concat()).expect("a pose");
        let moved = mechanism.links().last().expect("a link").name();
        let link = mechanism.find_link(moved).expect("the link");
        let contact = Contact::new(link, [0.1, 0.05, 0.0], [0.3, 0.8, 0.0]);
        let mut checked = Vec::new();
        for angle in [0.0, std::f64::consts::PI] {
            let mut configuration = system.configuration();
            configuration.set(&driver, &[angle]).expect("a driver");
            let Ok(pose) = system.pose_from(&first, &configuration) else { continue };
            let Ok(response) = pose.respond(&contact) else { continue };
            if response.singular_pose {
                let inputs = crate::support::inputs(&pose);
                checked.push(crate::support::Checked {
                    inputs,
                    outcome: response.effective_mass,
                    error: 0.0,
                });
            }
        }
        let request = request(&format!("change_{}", cases.len()), &mechanism, first, contact);
        cases.push(case(&request, checked).unwrap_or_else(|error| panic!("{error}")));
    }
    let results = run("change_points", &cases);
    let statuses: Vec<i32> = results.iter().flatten().map(|(status, _)| *status).collect();
    assert!(!statuses.is_empty() && statuses.iter().all(|s| [2, 4].contains(s)), "{statuses:?}");
}
