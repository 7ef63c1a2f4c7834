//! Reactions and changes of the rates compared with multipliers of all rows in maximal coordinates.

use crate::cases::{Case, all};
use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{Direction, EffectiveMass};
use percuss_impact::{Component, Reaction, Reactions, reactions_to_unit_impulse};
use percuss_oracle::maximal::{ImpactReactions, PlaceReaction, reactions};

/// Numbers of compared values.
#[derive(Debug, Default)]
struct Count {
    cases: usize,
    redundant: usize,
    determinate: usize,
    indeterminate: usize,
    skipped: usize,
    worst: f64,
}

/// Limit for a determinate component, relative to the unit impulse and the size of the mechanism. Both computations
/// solve systems whose condition is that of the constraint rows (up to 1e4 in these families) times that of the mass
/// matrix (up to 1e3), with rounding 1e-16.
const CLOSE: f64 = 1e-9;

/// Derivative along the kernel above which the oracle finds a component open. Singular values up to 1e-10 of the
/// largest count as zero, so the kernel is accurate to about 1e-10 · condition.
const OPEN: f64 = 1e-7;

fn compare(case: &Case, what: &str, reaction: &Reaction, oracle: &PlaceReaction, count: &mut Count) {
    let size = case.mechanism.characteristic_length().max(1.0);
    let axes: Matrix3<f64> = reaction.frame.rotation;
    let off = (reaction.frame.translation - oracle.point).norm();
    assert!(off < 1e-9 * size, "{}: {what}: the point is {off:e} m away", case.name);
    // Fast massless or light parts give large reactions: the error is relative to the largest of the case.
    let largest = oracle.wrench.norm().max(1.0);
    for (first, scale, components) in [(3, 1.0, &reaction.force), (0, size, &reaction.moment)] {
        let of = |w: &dyn Fn(usize) -> f64, k: usize| {
            axes.column(k).dot(&Vector3::new(w(first), w(first + 1), w(first + 2)))
        };
        for (k, component) in components.iter().enumerate() {
            let open: f64 =
                (0..oracle.open.ncols()).map(|z| of(&|i| oracle.open[(i, z)], k).powi(2)).sum::<f64>().sqrt();
            let label = format!("{}: {what}, component {k} of {first}: {component:?}", case.name);
            match component {
                Component::Determinate(value) => {
                    let expected = of(&|i| oracle.wrench[i], k);
                    let error = (value - expected).abs() / (largest * scale);
                    count.worst = count.worst.max(error);
                    assert!(error < CLOSE, "{label}, oracle {expected}, error {error:e}");
                    assert!(open < OPEN * scale, "{label}: the oracle finds it open, {open:e}");
                    count.determinate += 1;
                }
                Component::Indeterminate => {
                    assert!(open > OPEN, "{label}: the oracle finds it determinate, {open:e}");
                    assert!(!reaction.loops.is_empty(), "{label}: no loop is named");
                    count.indeterminate += 1;
                }
            }
        }
    }
}

/// Compares all reactions of a case.
fn compare_all(case: &Case, found: &Reactions, oracle: &ImpactReactions, count: &mut Count) {
    if let Some(ground) = &found.ground {
        compare(case, "ground", ground, &oracle.ground, count);
    }
    for (joint, expected) in found.joints.iter().zip(&oracle.joints) {
        let what = case.mechanism.joint(joint.joint).name();
        compare(case, what, &joint.reaction, expected, count);
    }
    for (i, (closure, expected)) in found.closures.iter().zip(&oracle.closures).enumerate() {
        compare(case, case.mechanism.closures()[i].name(), closure, expected, count);
    }
    for (hold, expected) in found.holds.iter().zip(&oracle.holds) {
        compare(case, "hold", hold, expected, count);
    }
}

#[test]
fn reactions_are_those_of_maximal_coordinates() {
    let count = compare_cases(all(400));
    println!("{count:?}");
    assert!(count.cases >= 1_000 && count.redundant > 400, "{count:?}");
    assert!(count.determinate > 10_000 && count.indeterminate > 1_000, "{count:?}");
}

/// As above, for moments about an axis.
#[test]
fn reactions_to_moments_are_those_of_maximal_coordinates() {
    let mut cases = all(120);
    for case in &mut cases {
        let (axis, frame) = case.contact.normal.vector().expect("a vector");
        case.contact.normal = Direction::About(axis, frame);
    }
    let count = compare_cases(cases);
    println!("{count:?}");
    assert!(count.cases >= 250 && count.redundant > 100, "{count:?}");
    assert!(count.determinate > 2_500 && count.indeterminate > 250, "{count:?}");
}

/// Compares the reactions of all cases with a finite m̄ and a clear rank.
fn compare_cases(cases: Vec<Case>) -> Count {
    let mut count = Count::default();
    for case in cases {
        let response = case.pose.respond(&case.contact).expect("a contact");
        let EffectiveMass::Finite(_) = response.effective_mass else {
            count.skipped += 1;
            continue;
        };
        let question = case.question();
        let Some(oracle) = reactions(&question) else {
            count.skipped += 1;
            continue;
        };
        // Rank decisions near their threshold may differ between the two computations.
        let rank = case.pose.rank();
        let groups = case.pose.constraint_groups();
        let least = groups.iter().map(|g| g.least_singular_value).fold(1.0, f64::min);
        if !rank.clear || least < 1e-4 || oracle.imbalance > 1e-11 {
            count.skipped += 1;
            continue;
        }
        let found = reactions_to_unit_impulse(&case.pose, &response).expect("reactions");
        assert!(found.residual < 1e-9, "{}: residual {:e}", case.name, found.residual);
        count.cases += 1;
        count.redundant += usize::from(oracle.redundant > 0);
        compare_all(&case, &found, &oracle, &mut count);
    }
    count
}
