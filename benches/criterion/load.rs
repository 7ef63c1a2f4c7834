//! URDF of 1,000 links: the percuss loader with all checks, and urdf-rs for comparison.

use criterion::{Criterion, criterion_group, criterion_main};
use percuss_benches::{CpuTime, criterion};
use percuss_benches::{chain_urdf, loaded};
use std::hint::black_box;

fn load(criterion: &mut Criterion<CpuTime>) {
    let text = chain_urdf(1000);
    assert_eq!(loaded(&text).links().len(), 1000);
    criterion.bench_function("load/percuss", |b| b.iter(|| black_box(loaded(black_box(&text)))));
    criterion.bench_function("load/urdf-rs", |b| {
        b.iter(|| black_box(urdf_rs::read_from_string(black_box(&text)).expect("a good file")));
    });
}

criterion_group!(name = benches; config = criterion(); targets = load);
criterion_main!(benches);
