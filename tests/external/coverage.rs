//! Prints which share of the regular configurations the compiled kernels answer: `percuss-coverage FILE...`, for URDF files and
//! suspension sheets. Files that do not load are named.

use percuss_dynamics::{Base, Conditions};
use percuss_tests::coverage::{Coverage, coverage, read};

fn main() {
    let mut all = [Coverage::default(); 2];
    for path in std::env::args().skip(1) {
        let mechanism = match read(&path) {
            Ok(mechanism) => mechanism,
            Err(error) => {
                println!("{path}: not loaded: {error}");
                continue;
            }
        };
        for (base, sum) in [Base::Fixed, Base::Floating].into_iter().zip(&mut all) {
            let own = coverage(&mechanism, &Conditions::new().base(base));
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
