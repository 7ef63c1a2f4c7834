//! Double wishbone: m̄ at a closed pose, and a step of a sweep from the previous pose.

use criterion::{Criterion, criterion_group, criterion_main};
use percuss_benches::double_wishbone;
use percuss_benches::{CpuTime, criterion};
use percuss_dynamics::EffectiveMass;
use std::hint::black_box;

/// Steps of 1 mrad, forwards and backwards.
const STEPS: usize = 200;

fn linkage(criterion: &mut Criterion<CpuTime>) {
    let (system, contact, driver) = double_wishbone();
    let at = |step: usize| {
        let step = (step % (2 * STEPS)) as f64;
        let angle = 1e-3 * (step - 2.0 * (step - STEPS as f64).max(0.0) - STEPS as f64 / 2.0);
        let mut configuration = system.configuration();
        configuration.set(driver, &[angle]).expect("the lower arm drives");
        configuration
    };
    let mut poses = vec![system.pose(&at(0)).expect("the start is in reach")];
    for step in 1..2 * STEPS {
        let next = system.pose_from(&poses[step - 1], &at(step)).expect("the range is in reach");
        poses.push(next);
    }
    let response = poses[STEPS / 2].respond(&contact).expect("a contact");
    assert!(matches!(response.effective_mass, EffectiveMass::Finite(m) if (20.0..500.0).contains(&m)));

    let mut next = poses.iter().cycle();
    criterion.bench_function("double_wishbone/response", |bencher| {
        bencher.iter(|| {
            let pose = next.next().expect("a cycle has no end");
            black_box(black_box(pose).respond(&contact))
        });
    });
    let mut workspace = poses[0].assembly().workspace();
    let mut next = poses.iter().cycle();
    criterion.bench_function("double_wishbone/workspace", |bencher| {
        bencher.iter(|| {
            workspace
                .set_positions(black_box(next.next().expect("a cycle has no end").positions()))
                .expect("positions that fit");
            black_box(workspace.effective_mass(&contact))
        });
    });
    let mut pose = poses[0].clone();
    let configurations: Vec<_> = (0..2 * STEPS).map(at).collect();
    let mut next = configurations.iter().cycle().skip(1);
    criterion.bench_function("double_wishbone/step", |bencher| {
        bencher.iter(|| {
            let configuration = next.next().expect("a cycle has no end");
            pose = system.pose_from(&pose, black_box(configuration)).expect("the range is in reach");
        });
    });
}

criterion_group!(name = benches; config = criterion(); targets = linkage);
criterion_main!(benches);
