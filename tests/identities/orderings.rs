//! Monotonicity of m̄: added mass or constraints never reduce m̄; two sides of one tree are not two independent
//! mechanisms.

use percuss_dynamics::{Base, System};
use percuss_mechanism::LinkId;
use percuss_oracle::{alter, closed_form};
use percuss_tests::cases::{self, Case};
use percuss_tests::judge::mass_or_bound;
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

/// All cases: models of the zoo and random models.
fn all_cases() -> Vec<Case> {
    [cases::of_the_zoo(7, 2), cases::at_random(7000, 120, 40)].concat()
}

#[test]
fn two_sides_of_one_tree_are_no_two_mechanisms() {
    let mut different = 0;
    for case in all_cases() {
        let Some(other) = case.against else { continue };
        let system = case.system();
        if !share_a_moving_ancestor(&case, &system, other) {
            continue;
        }
        let pose = case.pose(&system);
        let point = pose.link(other).inverse_point(&pose.link(case.on).point(&case.point));
        let alone = |on, point| mass_or_bound(&Case { on, point, against: None, ..case.clone() }.response());
        let (one, two) = (alone(case.on, case.point), alone(other, point));
        let together = mass_or_bound(&case.response());
        // The sum of the inverses omits the cross terms; the oracle (`routes.rs`) includes them.
        if one.is_finite() && two.is_finite() && together.is_finite() && together > 0.0 {
            let dropped = closed_form::series(one, two);
            different += usize::from((dropped / together - 1.0).abs() > 1e-2);
        }
    }
    assert!(different > 20, "{different} cases tell the difference");
}

/// True if some moving joint is an ancestor of both sides.
fn share_a_moving_ancestor(case: &Case, system: &System, other: LinkId) -> bool {
    let above = |link: LinkId| {
        std::iter::successors(case.mechanism.parent_joint(link), |&joint| {
            case.mechanism.parent_joint(case.mechanism.joint(joint).parent())
        })
        .filter(|&joint| !system.is_locked(joint) && case.mechanism.joint(joint).kind().dofs() > 0)
        .collect::<Vec<_>>()
    };
    let of_other = above(other);
    above(case.on).iter().any(|joint| of_other.contains(joint)) || case.base == Base::Floating
}

#[test]
fn added_mass_never_reduces_the_mass() {
    let mut rng = StdRng::seed_from_u64(51);
    let (mut heavier, mut tried) = (0, 0);
    for case in all_cases() {
        let one = case.response();
        let slack = case.near();
        for _ in 0..3 {
            let link = rng.random_range(0..case.mechanism.links().len());
            let (mut links, joints) = alter::describe(&case.mechanism);
            let Some(inertial) = &mut links[link].inertial else { continue };
            inertial.mass *= 1.5;
            inertial.about_com *= 1.5;
            let mechanism = Arc::new(alter::build(case.mechanism.name(), links, joints));
            let two = Case { mechanism, ..case.clone() }.response();
            let (before, after) = (mass_or_bound(&one), mass_or_bound(&two));
            assert!(after >= before * (1.0 - slack), "{}: {before} kg, then {after} kg", case.name);
            tried += 1;
            // m̄ grows at most by the link's share (m̄ is concave in the masses), and does grow for a positive share.
            if let Some(contributions) = &one.contributions {
                let most = before * (1.0 + 0.5 * contributions.links[link]);
                assert!(after <= most * (1.0 + slack), "{}: {after} kg, at most {most} kg", case.name);
                if contributions.links[link] > 1e-3 {
                    assert!(after > before * (1.0 + 1e-8), "{}: {before} kg, then {after} kg", case.name);
                    heavier += 1;
                }
            }
        }
    }
    assert!(heavier > 50 && tried > heavier, "{heavier} of {tried}");
}

#[test]
fn constraints_never_reduce_the_mass() {
    let mut rng = StdRng::seed_from_u64(52);
    let (mut heavier, mut stopped) = (0, 0);
    for case in all_cases() {
        let one = case.response();
        let slack = case.near();
        let mut tied = Vec::new();
        for id in case.mechanism.joint_ids() {
            if !case.locks.contains(&id) && rng.random_bool(0.3) {
                let mut more = case.clone();
                more.locks.push(id);
                tied.push(more);
            }
        }
        if case.base == Base::Floating {
            tied.push(Case { base: Base::Fixed, ..case.clone() });
        }
        for more in tied {
            let (before, after) = (mass_or_bound(&one), mass_or_bound(&more.response()));
            assert!(after >= before * (1.0 - slack), "{}: {before} kg, then {after} kg", case.name);
            heavier += usize::from(after.is_finite() && after > before * 1.001);
            stopped += usize::from(before.is_finite() && after.is_infinite());
        }
    }
    assert!(heavier > 50 && stopped > 0, "{heavier} heavier, {stopped} stopped");
}
