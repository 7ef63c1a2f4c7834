//! Prints which share of the regular configurations the compiled kernels answer: `percuss-coverage [--links] FILE...`, for URDF files and
//! suspension sheets; with `--links` for contacts between two links. Files that do not load are named. `percuss-coverage --families SIZE`:
//! for generated families, with contacts of all kinds; mechanisms without full coverage are listed with `--each`, times with `--times`.

use percuss_dynamics::{Base, BatchPositions, Conditions, Pose, RowResults};
use percuss_tests::coverage::{
    Coverage, OtherSide, Subject, coverage, coverage_of, families, for_each_contact, read,
};
use std::hint::black_box;
use std::time::Instant;

/// Number of runs, of which the fastest counts.
const RUNS: usize = 25;
/// Number of rows of a batch: the poses of a contact, repeated.
const ROWS: usize = 64;

fn main() {
    let mut all = [Coverage::default(); 2];
    let (flags, paths): (Vec<_>, Vec<_>) = std::env::args().skip(1).partition(|word| word.starts_with("--"));
    let has = |flag: &str| flags.iter().any(|given| given == flag);
    if has("--families") {
        let size = paths.first().and_then(|size| size.parse().ok()).unwrap_or(1);
        return if has("--times") { print_times(size) } else { print_families(size, has("--each")) };
    }
    let other = if flags.is_empty() { OtherSide::Ground } else { OtherSide::Link };
    for path in paths {
        let mechanism = match read(&path) {
            Ok(mechanism) => mechanism,
            Err(error) => {
                println!("{path}: not loaded: {error}");
                continue;
            }
        };
        for (base, sum) in [Base::Fixed, Base::Floating].into_iter().zip(&mut all) {
            let own = coverage(&mechanism, &Conditions::new().base(base), other);
            println!("{path} {base:?}: {} of {} ({:.1} %)", own.by_kernel, own.regular, own.per_cent());
            *sum += own;
        }
    }
    for (base, sum) in ["fixed", "floating"].into_iter().zip(all) {
        let Coverage { mechanisms, regular, by_kernel, wrong, .. } = sum;
        println!(
            "{base} base: {mechanisms} mechanisms, {by_kernel} of {regular} ({:.1} %); {wrong} differ from the pose by more than the \
             stated errors",
            sum.per_cent()
        );
    }
}

/// Prints the coverage of each family and each kind of contact.
fn print_families(size: u64, each: bool) {
    let kinds = [OtherSide::Ground, OtherSide::Link, OtherSide::Line, OtherSide::Moment];
    let mut all = Coverage::default();
    for (name, subjects) in families(size) {
        for kind in kinds {
            let mut sum = Coverage::default();
            for subject in &subjects {
                let own = coverage_of(subject, kind);
                if each && own.by_kernel < own.regular {
                    let (regular, answered) = (own.regular, own.by_kernel);
                    println!(
                        "  {} {:?}: {answered} of {regular}, {} without kernel, {} ill-conditioned",
                        subject.mechanism.name(),
                        subject.conditions,
                        own.unsupported,
                        own.ill_conditioned
                    );
                }
                sum += own;
            }
            let Coverage { regular, by_kernel, wrong, unsupported, ill_conditioned, .. } = sum;
            println!(
                "{name}, {kind:?}: {by_kernel} of {regular} ({:.1} %), {unsupported} without kernel, {ill_conditioned} ill-conditioned, \
                 {wrong} wrong",
                sum.per_cent()
            );
            all += sum;
        }
    }
    println!("all: {} of {} ({:.2} %), {} wrong", all.by_kernel, all.regular, all.per_cent(), all.wrong);
}

/// Prints the time of m̄ in each family, ns: one configuration, a row of a batch, and one configuration by the recursion, with v*.
fn print_times(size: u64) {
    for (name, subjects) in families(size) {
        let (mut sums, mut contacts) = ([0.0; 3], 0);
        for subject in &subjects {
            add_times(subject, &mut sums, &mut contacts);
        }
        let [single, row, recursion] = sums.map(|sum| sum / f64::from(contacts.max(1)));
        println!(
            "{name}: {single:.0}, {row:.0}, {recursion:.0}; ratios {:.1}, {:.1}",
            recursion / single,
            recursion / row
        );
    }
}

/// Adds the times of the contacts of a subject with the ground whose configurations all have a finite m̄.
fn add_times(subject: &Subject, sums: &mut [f64; 3], contacts: &mut u32) {
    for_each_contact(subject, OtherSide::Ground, |batch, contact, poses| {
        let finite =
            |pose: &Pose| pose.respond(contact).is_ok_and(|found| found.effective_mass.kilograms().is_some());
        let Some(first) = poses.first().filter(|_| poses.iter().all(finite)) else { return };
        let (width, count) = (first.positions().len(), poses.len());
        let rows: Vec<f64> = (0..ROWS).flat_map(|row| poses[row % count].positions().to_vec()).collect();
        let (mut workspace, mut velocities) = (first.assembly().workspace(), Vec::new());
        let mut results = RowResults::new(ROWS);
        let single = least_time(count, || {
            for pose in poses {
                _ = black_box(batch.effective_mass(pose.positions()));
            }
        });
        let row = least_time(ROWS, || {
            let rows = BatchPositions::Rows { values: &rows, stride: width };
            _ = black_box(batch.run(rows, results.columns(), ROWS));
        });
        let recursion = least_time(count, || {
            for pose in poses {
                _ = workspace.set_positions(pose.positions());
                _ = black_box(workspace.respond(contact, &mut velocities));
            }
        });
        sums.iter_mut().zip([single, row, recursion]).for_each(|(sum, time)| *sum += time);
        *contacts += 1;
    });
}

/// Shortest time of some runs for one of `count` configurations, ns.
fn least_time(count: usize, mut run: impl FnMut()) -> f64 {
    let mut time = || {
        let start = Instant::now();
        run();
        start.elapsed().as_nanos() as f64 / count as f64
    };
    (0..RUNS).map(|_| time()).fold(f64::INFINITY, f64::min)
}
