//! Loads the files named and prints what was found in each: `cargo run -p percuss-formats --example diagnose -- FILE…`.
//! With `--accept` first, indefinite inertias are taken as they are.

use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions, Source, load};
use percuss_mechanism::Accept;

fn main() {
    let mut options = LoadOptions::default();
    for path in std::env::args().skip(1) {
        if path == "--accept" {
            options.accept = Accept { indefinite_inertia: true };
            continue;
        }
        let loaded = Source::read(&path, DEFAULT_MAX_SIZE).and_then(|source| load(&source, &options));
        let (outcome, diagnostics) = match loaded {
            Ok(loaded) => {
                let (links, mass) = (loaded.mechanism.links().len(), loaded.mechanism.total_mass());
                (format!("ok, {links} links, {mass} kg"), loaded.diagnostics)
            }
            Err(error) => ("refused".to_owned(), error.diagnostics),
        };
        println!("{path}: {outcome}");
        for diagnostic in diagnostics {
            println!("{diagnostic}");
        }
    }
}
