//! Families of mechanisms: random trees, the specimens of every joint, linkages, the shipped models.

use crate::support::{Case, case, checked, compare, pose, request, run};
use percuss_dynamics::{Conditions, Contact, Direction, Frame, System};
use percuss_oracle::{linkage, random, zoo};
use rand::SeedableRng;
use rand::rngs::StdRng;
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
        let mut poses = (0..6).filter_map(|_| pose(&system, &random::positions(&mut rng, &mechanism).concat()));
        let first = poses.next().expect("a pose");
        let checked: Vec<_> = poses.filter_map(|p| checked(&p, &contact)).collect();
        let request = request(&format!("tree_{seed}"), &mechanism, first, contact);
        match case(&request, checked) {
            Ok(case) => cases.push(case),
            Err(error) => left_out.push(format!("{seed}: {error}")),
        }
    }
    let results = run("random_trees", &cases);
    let (finite, refused) = compare(&cases, &results);
    assert_eq!(refused, 0);
    println!("{finite} results, left out: {left_out:#?}");
    assert!(finite >= 100, "{finite}");
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
        let mut poses = (0..6).filter_map(|_| pose(&system, &random::positions(&mut rng, &mechanism).concat()));
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
    assert_eq!(refused, 0);
    println!("{finite} results, left out: {left_out:#?}");
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
    println!("{finite} results, {refused} refused, left out: {left_out:#?}");
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
        let loaded = percuss_formats::load(&source, &percuss_formats::LoadOptions::default()).expect("a model");
        let mechanism = Arc::new(loaded.mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact = drawn_contact(&mut rng, &mechanism);
        let first = system.pose(&system.configuration()).expect("a pose");
        let mut poses = vec![first.clone()];
        for _ in 0..8 {
            use rand::Rng;
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
    println!("{finite} results, {refused} refused, left out: {left_out:#?}");
}
