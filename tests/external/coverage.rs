//! Prints which share of the regular configurations the compiled kernels answer: `percuss-coverage [--links] FILE...`, for URDF files and
//! suspension sheets; with `--links` for contacts between two links. Files that do not load are named.

use percuss_dynamics::{Base, Conditions};
use percuss_tests::coverage::{Coverage, OtherSide, coverage, read};

fn main() {
    let mut all = [Coverage::default(); 2];
    let (flags, paths): (Vec<_>, Vec<_>) = std::env::args().skip(1).partition(|word| word == "--links");
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
        let Coverage { mechanisms, regular, by_kernel, wrong } = sum;
        println!(
            "{base} base: {mechanisms} mechanisms, {by_kernel} of {regular} ({:.1} %); {wrong} differ from the pose by more than the \
             stated errors",
            sum.per_cent()
        );
    }
}
