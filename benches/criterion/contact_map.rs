//! Many contacts on one link at one pose: time per contact, and time to create the map.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use percuss_benches::{CpuTime, criterion, double_wishbone, subjects};
use percuss_dynamics::{Contact, ContactColumns, ContactStatus, MapAnswers, Pose};
use percuss_spatial::lanes::Instructions;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::hint::black_box;

/// Contacts per call, as on the surface of a link. The data fit into the second-level cache.
const CONTACTS: usize = 4096;

fn columns() -> [Vec<f64>; 6] {
    let mut rng = StdRng::seed_from_u64(9);
    std::array::from_fn(|column| {
        let size = if column < 3 { 0.1 } else { 1.0 };
        (0..CONTACTS).map(|_| rng.random_range(-size..size)).collect()
    })
}

fn of_pose(criterion: &mut Criterion<CpuTime>, name: &str, pose: &Pose, contact: &Contact) {
    let columns = columns();
    let [x, y, z, nx, ny, nz] = columns.each_ref().map(|c| &c[..]);
    let contacts = ContactColumns { points: [x, y, z], normals: [nx, ny, nz] };
    let map = pose.contact_map(contact.link, contact.against, [0.0; 3], 0.2).expect("a region");
    assert!(map.is_by_inertia(), "{name}");
    let (mut masses, mut errors) = (vec![0.0; CONTACTS], vec![0.0; CONTACTS]);
    let mut statuses = vec![ContactStatus::Finite; CONTACTS];
    let mut group = criterion.benchmark_group("contact_map");
    group.throughput(Throughput::Elements(CONTACTS as u64));
    for set in [Instructions::Baseline, Instructions::Avx2, Instructions::Avx512] {
        if !set.is_available() {
            continue;
        }
        let map = map.clone().with_instructions(set);
        group.bench_function(format!("{name}/{}", set.name()), |bencher| {
            bencher.iter(|| {
                let mut answers =
                    MapAnswers { masses: &mut masses, relative_errors: &mut errors, statuses: &mut statuses };
                map.fill_answers(black_box(contacts), &mut answers).expect("columns of one length");
            });
        });
    }
    group.throughput(Throughput::Elements(1));
    group.bench_function(format!("{name}/made"), |bencher| {
        bencher.iter(|| black_box(pose.contact_map(contact.link, contact.against, black_box([0.0; 3]), 0.2)));
    });
    group.finish();
    let finite = statuses.iter().filter(|s| **s == ContactStatus::Finite).count();
    assert!(finite > CONTACTS / 2 && masses.iter().all(|m| m.is_nan() || *m >= 0.0), "{name}: {finite}");
}

fn contact_maps(criterion: &mut Criterion<CpuTime>) {
    for subject in subjects() {
        let mut configuration = subject.system.configuration();
        for joint in subject.system.mechanism().joints().iter().filter(|j| j.kind().dofs() == 1) {
            configuration.set(joint.name(), &[0.3]).expect("a joint of one freedom");
        }
        let pose = subject.system.pose(&configuration).expect("a tree");
        of_pose(criterion, subject.name, &pose, &subject.contact);
    }
    let (system, contact, _) = double_wishbone();
    let pose = system.pose(&system.configuration()).expect("the start is in reach");
    of_pose(criterion, "double_wishbone", &pose, &contact);
}

criterion_group!(name = benches; config = criterion(); targets = contact_maps);
criterion_main!(benches);
