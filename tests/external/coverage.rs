//! Prints which share of the regular configurations the compiled kernels answer: `percuss-coverage [--links] FILE...`, for URDF files and
//! suspension sheets; with `--links` for contacts between two links. Files that do not load are named. `percuss-coverage --families SIZE`:
//! for generated families, with contacts of all kinds; mechanisms without full coverage are listed with `--each`.

use percuss_dynamics::{Base, Conditions};
use percuss_tests::coverage::{Coverage, OtherSide, coverage, coverage_of, families, read};

fn main() {
    let mut all = [Coverage::default(); 2];
    let (flags, paths): (Vec<_>, Vec<_>) = std::env::args().skip(1).partition(|word| word.starts_with("--"));
    if flags.iter().any(|flag| flag == "--families") {
        let size = paths.first().and_then(|size| size.parse().ok()).unwrap_or(1);
        return print_families(size, flags.iter().any(|flag| flag == "--each"));
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
