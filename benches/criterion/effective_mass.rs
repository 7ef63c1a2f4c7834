//! m̄ at a new configuration per call: the recursion in a workspace, and the dense route with contributions.

use criterion::{Criterion, criterion_group, criterion_main};
use percuss_benches::subjects;
use percuss_benches::{CpuTime, criterion};
use percuss_dynamics::{EffectiveMass, Route, RouteChoice};
use std::hint::black_box;

fn routes(criterion: &mut Criterion<CpuTime>) {
    for subject in subjects() {
        let (system, contact) = (&subject.system, &subject.contact);
        let mut workspace = system.workspace();
        // Compare the values of both routes once, before timing.
        workspace.set_positions(&subject.positions[0]).expect("positions that fit");
        assert!(matches!(workspace.effective_mass(contact), Ok(EffectiveMass::Finite(m)) if m > 0.0));
        let mut next = subject.positions.iter().cycle();
        criterion.bench_function(&format!("{}/recursion", subject.name), |bencher| {
            bencher.iter(|| {
                workspace
                    .set_positions(black_box(next.next().expect("a cycle has no end")))
                    .expect("positions that fit");
                black_box(workspace.effective_mass(black_box(contact)))
            });
        });
        let pose = system.pose(&system.configuration()).expect("a tree poses");
        criterion.bench_function(&format!("{}/dense", subject.name), |bencher| {
            bencher.iter(|| {
                black_box(black_box(&pose).respond_by_route(contact, RouteChoice::Only(Route::Dense)))
            });
        });
    }
}

criterion_group!(name = benches; config = criterion(); targets = routes);
criterion_main!(benches);
