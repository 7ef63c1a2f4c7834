//! Prints which share of the regular configurations the compiled kernels answer: `percuss-coverage FILE...`, for URDF files and
//! suspension sheets. Files that do not load are named.

use percuss_dynamics::{Base, Conditions};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions, Source, load};
use percuss_mechanism::Mechanism;
use percuss_suspension::{ImportOptions, import};
use percuss_tests::coverage::coverage;
use std::sync::Arc;

fn read(path: &str) -> Result<Mechanism, String> {
    let source = Source::read(path, DEFAULT_MAX_SIZE).map_err(|error| error.to_string())?;
    if path.ends_with(".urdf") {
        return load(&source, &LoadOptions::default()).map(|read| read.mechanism).map_err(|e| e.to_string());
    }
    import(&source, &ImportOptions::default()).map(|read| read.mechanism).map_err(|e| e.to_string())
}

fn main() {
    let mut all = [(0, 0, 0); 2];
    for path in std::env::args().skip(1) {
        let mechanism = match read(&path) {
            Ok(mechanism) => Arc::new(mechanism),
            Err(error) => {
                println!("{path}: not loaded: {}", error.lines().next().unwrap_or_default());
                continue;
            }
        };
        for (base, sum) in [Base::Fixed, Base::Floating].into_iter().zip(&mut all) {
            let own = coverage(&mechanism, &Conditions::new().base(base), 1);
            println!("{path} {base:?}: {} of {} ({:.1} %)", own.by_kernel, own.regular, own.per_cent());
            *sum = (sum.0 + own.mechanisms, sum.1 + own.regular, sum.2 + own.by_kernel);
        }
    }
    for (base, (mechanisms, regular, by_kernel)) in ["fixed", "floating"].into_iter().zip(all) {
        println!("{base} base: {mechanisms} mechanisms, {by_kernel} of {regular} configurations");
    }
}
