//! Share of the configurations of the shipped models that the compiled kernels answer.

use percuss_dynamics::{Base, Conditions};
use percuss_tests::coverage::{Coverage, OtherSide, coverage, read};
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

/// Configurations without a result of a kernel have too large a bound of the rounding error: nearly immovable contacts, and
/// axles on a floating base. The kernels answer none of the 48 configurations of the valve train, whose cam has no mass; the poses do.
/// On a processor without fused multiply-add, a few bounds differ.
#[test]
fn shipped_models() {
    let fixed = sum(Base::Fixed, OtherSide::Ground);
    assert!((fixed.mechanisms, fixed.regular) >= (40, 1310), "{fixed:?}");
    assert_eq!(fixed.wrong, 0);
    assert!(fixed.by_kernel >= 1210, "{fixed:?}");
    let floating = sum(Base::Floating, OtherSide::Ground);
    assert!((floating.mechanisms, floating.regular) >= (40, 1639), "{floating:?}");
    assert_eq!(floating.wrong, 0);
    assert!(floating.by_kernel >= 1540, "{floating:?}");
}

#[test]
fn contacts_between_links() {
    for (base, regular, least) in [(Base::Fixed, 1270, 1210), (Base::Floating, 1073, 980)] {
        let all = sum(base, OtherSide::Link);
        assert!(all.regular >= regular && all.wrong == 0, "{all:?}");
        assert!(all.by_kernel >= least, "{all:?}");
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
