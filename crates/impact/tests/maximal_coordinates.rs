//! Reactions and changes of the rates compared with multipliers of all rows in maximal coordinates.

use crate::cases::{Case, all, coupled};
use nalgebra::{DVector, Matrix3, Vector3};
use percuss_dynamics::{Direction, EffectiveMass, Pose};
use percuss_impact::{Component, JointConstraint, Reaction, Reactions, reactions_to_unit_impulse};
use percuss_mechanism::{Coupling, JointId};
use percuss_oracle::maximal::{ImpactReactions, PlaceReaction, RowReaction, reactions};

/// Numbers of compared values.
#[derive(Debug, Default)]
struct Count {
    cases: usize,
    redundant: usize,
    determinate: usize,
    indeterminate: usize,
    /// Numbers of determinate and of open impulses: of locks, mimics and couplings, and sums on the joints.
    drives: [usize; 2],
    /// Number of determinate sums of open impulses.
    sums: usize,
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

/// Entries of the row of a coupling at a pose: joint and entry.
fn coupling_entries(coupling: &Coupling, pose: &Pose) -> Vec<(JointId, f64)> {
    let curve = coupling.curve();
    let of_curve: Vec<(JointId, f64)> = curve.map_or(Vec::new(), |curve| curve.terms().to_vec());
    let positions = of_curve.iter().map(|(joint, g)| g * pose.joint(*joint)[0]);
    let s = curve.map_or(0.0, |curve| curve.offset()) + positions.sum::<f64>();
    let [a2, a3, a4] = curve.map_or([0.0; 3], |curve| curve.coefficients());
    let slope = s * (2.0 * a2 + s * (3.0 * a3 + s * 4.0 * a4));
    let entry = |&(joint, f): &(JointId, f64)| {
        let g = of_curve.iter().filter(|(own, _)| *own == joint).map(|(_, g)| g).sum::<f64>();
        (joint, f - slope * g)
    };
    coupling.terms().iter().map(entry).collect()
}

/// Compares the impulse of each lock, mimic and coupling, and the sum of these impulses on each joint velocity.
fn compare_drives(case: &Case, found: &Reactions, oracle: &ImpactReactions, count: &mut Count) {
    let mechanism = &case.mechanism;
    let wrenches = oracle.joints.iter().map(|place| place.wrench.norm());
    let rows = oracle.locks.iter().flatten().chain(oracle.mimics.iter().flatten()).chain(&oracle.couplings);
    let size = mechanism.characteristic_length().max(1.0);
    let largest = wrenches.chain(rows.map(|row| row.value.abs())).fold(size, f64::max);
    let mut compare = |what: String, component: Component, expected: &RowReaction, is_named: bool| {
        let open = expected.open.norm();
        let label = format!("{}: {what}: {component:?}", case.name);
        match component {
            Component::Determinate(value) => {
                let error = (value - expected.value).abs() / largest;
                count.worst = count.worst.max(error);
                assert!(error < CLOSE, "{label}, oracle {}, error {error:e}", expected.value);
                assert!(open < OPEN * size, "{label}: the oracle finds it open, {open:e}");
                count.drives[0] += 1;
            }
            Component::Indeterminate => {
                assert!(open > OPEN, "{label}: the oracle finds it determinate, {open:e}");
                assert!(is_named, "{label}: no constraint is named");
                count.drives[1] += 1;
            }
        }
    };
    // Parts of the sum on each velocity of a joint.
    let mut parts: Vec<Vec<Vec<RowReaction>>> =
        mechanism.joints().iter().map(|joint| vec![Vec::new(); joint.kind().dofs()]).collect();
    let times =
        |row: &RowReaction, factor: f64| RowReaction { value: factor * row.value, open: &row.open * factor };
    for found in &found.joint_constraints {
        let expected: Vec<(JointId, usize, RowReaction)> = match found.constraint {
            JointConstraint::Lock(joint) => {
                let rows = oracle.locks[joint.index()].iter().enumerate();
                rows.map(|(k, row)| (joint, k, row.clone())).collect()
            }
            JointConstraint::Mimic(follower) => {
                let mimic = mechanism.joint(follower).mimic().expect("a mimic");
                let row = oracle.mimics[follower.index()].as_ref().expect("a row");
                vec![(follower, 0, times(row, 1.0)), (mimic.master, 0, times(row, -mimic.multiplier))]
            }
            JointConstraint::Coupling(i) => {
                let entries = coupling_entries(&mechanism.couplings()[i], &case.pose);
                let of_joint = |(joint, entry)| (joint, 0, times(&oracle.couplings[i], entry));
                entries.into_iter().map(of_joint).collect()
            }
        };
        assert_eq!(found.impulses.len(), expected.len(), "{}: {found:?}", case.name);
        for (&(joint, k, value), (of_joint, of_k, expected)) in found.impulses.iter().zip(expected) {
            assert_eq!((joint, k), (of_joint, of_k), "{}: {found:?}", case.name);
            compare(format!("{:?}", found.constraint), value, &expected, !found.open_by.is_empty());
            parts[joint.index()][k].push(expected);
        }
    }
    let locks = oracle.locks.iter().filter(|rows| !rows.is_empty()).count();
    let rows = locks + oracle.mimics.iter().flatten().count() + oracle.couplings.len();
    assert_eq!(found.joint_constraints.len(), rows, "{}", case.name);
    for joint in &found.joints {
        for (k, drive) in joint.drives.iter().enumerate() {
            let own = &parts[joint.joint.index()][k];
            let zero = RowReaction { value: 0.0, open: DVector::zeros(oracle.redundant) };
            let sum = own.iter().fold(zero, |sum, part| RowReaction {
                value: sum.value + part.value,
                open: sum.open + &part.open,
            });
            let name = mechanism.joint(joint.joint).name();
            compare(format!("sum {k} on {name}"), drive.constraint, &sum, true);
            let is_open = own.iter().any(|part| part.open.norm() > OPEN);
            count.sums += usize::from(is_open && drive.constraint.value().is_some());
        }
    }
}

#[test]
fn reactions_are_those_of_maximal_coordinates() {
    let count = compare_cases(all(400));
    println!("{count:?}");
    assert!(count.cases >= 1_000 && count.redundant > 400, "{count:?}");
    assert!(count.determinate > 10_000 && count.indeterminate > 1_000, "{count:?}");
}

/// Mechanisms with locked joints of mimics and couplings, and with redundant couplings: the sum of the impulses on a joint can be
/// determinate if the single impulses are open.
#[test]
fn reactions_of_locked_couplings_are_those_of_maximal_coordinates() {
    let count = compare_cases(coupled(600));
    println!("{count:?}");
    assert!(count.cases >= 300 && count.redundant > 100, "{count:?}");
    assert!(count.drives[0] > 2_000 && count.drives[1] > 200 && count.sums > 100, "{count:?}");
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
        compare_drives(&case, &found, &oracle, &mut count);
    }
    count
}
