//! Share of the configurations of the shipped models that the compiled kernels answer.

use percuss_dynamics::{Base, Conditions};
use percuss_tests::coverage::{Coverage, OtherSide, coverage, coverage_of, families, read};
use std::path::Path;

fn sum(base: Base, other: OtherSide) -> Coverage {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let mut files: Vec<String> = ["", "suspensions"]
        .iter()
        .flat_map(|sub| std::fs::read_dir(folder.join(sub)).expect("a folder"))
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| match path.extension().and_then(|ending| ending.to_str()) {
            Some("urdf") => true,
            Some("toml") => path.parent().is_some_and(|parent| parent.ends_with("suspensions")),
            _ => false,
        })
        .map(|path| path.to_string_lossy().into_owned())
        .collect();
    files.sort();
    let mut all = Coverage::default();
    for file in files {
        all += coverage(
            &read(&file).unwrap_or_else(|error| panic!("{file}: {error}")),
            &Conditions::new().base(base),
            other,
        );
    }
    println!("{base:?}, {other:?}: {all:?}");
    all
}

/// Configurations without a result of a kernel have too large a bound of the rounding error: contacts that are nearly immovable. On a
/// processor without fused multiply-add, a few bounds differ.
#[test]
fn shipped_models() {
    let fixed = sum(Base::Fixed, OtherSide::Ground);
    assert!((fixed.mechanisms, fixed.regular) >= (40, 1310), "{fixed:?}");
    assert_eq!(fixed.wrong, 0);
    assert!(fixed.by_kernel >= 1305, "{fixed:?}");
    let floating = sum(Base::Floating, OtherSide::Ground);
    assert!((floating.mechanisms, floating.regular) >= (40, 1639), "{floating:?}");
    assert_eq!(floating.wrong, 0);
    assert!(1000 * floating.by_kernel >= 993 * floating.regular, "{floating:?}");
}

#[test]
fn contacts_between_links() {
    for (base, regular) in [(Base::Fixed, 1270), (Base::Floating, 1073)] {
        let all = sum(base, OtherSide::Link);
        assert!(all.regular >= regular && all.wrong == 0, "{all:?}");
        assert!(1000 * all.by_kernel >= 993 * all.regular, "{all:?}");
    }
}

/// A floating root without mass follows its only child freely, unless a contact of the root is held.
#[test]
fn held_roots_without_mass() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let point = [0.1, -0.2, 0.3];
    for (name, root) in
        [("double_pendulum", "ground"), ("physical_pendulum", "ground"), ("six_r_arm", "pedestal")]
    {
        let path = folder.join(format!("{name}.urdf"));
        let mechanism = read(&path.to_string_lossy()).expect("a shipped model");
        for normal in [None, Some([0.6, 0.0, 0.8].into())] {
            let held = Conditions::new().base(Base::Floating).hold(root, point, normal);
            let counts = coverage(&mechanism, &held, OtherSide::Ground);
            assert!(counts.regular >= 16 && counts.wrong == 0, "{name}, {normal:?}: {counts:?}");
            println!("{name}: {counts:?}");
        }
    }
}

/// Smallest share that the kernels answer in each generated family, over all kinds of contacts, per cent. The others are nearly immovable or
/// nearly singular, have a massless motion, or a normal along a short line.
const LEAST_SHARES: [(&str, usize); 8] = [
    ("trees", 98),
    ("trees with mimics", 99),
    ("specimens of joints", 96),
    ("trees with a held point", 97),
    ("linkages of all closures", 99),
    ("linkages with relations", 99),
    ("planar linkages", 99),
    ("known linkages", 98),
];

/// Generated trees and linkages with contacts of all kinds.
#[test]
fn generated_families() {
    let mut sum = Coverage::default();
    for ((name, subjects), (expected, least)) in families(1).into_iter().zip(LEAST_SHARES) {
        assert_eq!(name, expected);
        for other in [OtherSide::Ground, OtherSide::Link, OtherSide::Line, OtherSide::Moment] {
            let mut all = Coverage::default();
            subjects.iter().for_each(|subject| all += coverage_of(subject, other));
            println!("{name}, {other:?}: {all:?}");
            assert!(all.regular >= 300 && all.wrong == 0, "{name}, {other:?}: {all:?}");
            assert!(100 * all.by_kernel >= least * all.regular, "{name}, {other:?}: {all:?}");
            sum += all;
        }
    }
    assert!(1000 * sum.by_kernel >= 994 * sum.regular, "{sum:?}");
}
