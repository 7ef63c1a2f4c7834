//! The rank of the constraints: clear on ideal mechanisms, unclear near singular poses, and the remarks of a response.

use percuss_dynamics::{Remark, Singularity};
use percuss_oracle::linkage;
use percuss_tests::gauge::Gauge;
use percuss_tests::rig::{Rig, in_plane, mass};

#[test]
fn ideal_mechanisms_have_a_clear_rank() {
    let mut least = f64::INFINITY;
    for linkage in linkage::all() {
        let rig = Rig::new(linkage);
        let gap = rig.system.reference_or_open().rank_gap().expect("constraints");
        assert!(gap > 1e12 && rig.system.reference_or_open().rank_is_clear(), "{}: {gap:e}", rig.name);
        least = least.min(gap);
        let mut pose = rig.closed();
        for i in 0..5 {
            pose = rig.reach(&pose, &rig.at(0.1 + 0.2 * f64::from(i)));
            let here = pose.rank();
            assert!(
                here.clear && !here.singular && here.gap.is_some_and(|g| g > 1e11),
                "{}: {here:?}",
                rig.name
            );
            assert!(pose.loops().is_some_and(|l| l.singularities.iter().all(|s| *s == Singularity::None)));
            assert_eq!(pose.degrees_of_freedom(), rig.system.degrees_of_freedom(), "{}", rig.name);
        }
    }
    println!("least gap {least:e}");
}

/// Clear, then unclear, then singular, and never back.
#[test]
fn a_change_point_is_neared() {
    for linkage in [linkage::parallelogram(), linkage::antiparallelogram()] {
        let rig = Rig::new(linkage);
        let contact = rig.contact("coupler", [0.31, -0.12, 0.0], in_plane([0.6, 0.8].into()));
        let mut pose = rig.closed();
        let mut stages = Vec::new();
        for tenth in 30..=130 {
            let theta = if tenth == 130 { 0.0 } else { 10f64.powf(-f64::from(tenth) / 10.0) };
            pose = rig.reach(&pose, &[theta]);
            let rank = pose.rank();
            let response = rig.respond(&pose, &contact);
            let warned = response.remarks.iter().any(|r| matches!(r, Remark::UnclearRank { .. }));
            assert_eq!(warned, !rank.clear, "{} at {theta:e}", rig.name);
            assert_eq!(response.singular_pose, rank.singular, "{} at {theta:e}", rig.name);
            let stage = match (rank.clear, rank.singular) {
                (true, false) => "clear",
                (false, false) => "in doubt",
                (false, true) => "singular, in doubt",
                (true, true) => "singular",
            };
            if theta >= 3e-8 {
                assert_eq!(stage, "clear", "{} at {theta:e}: {rank:?}", rig.name);
            }
            if stages.last() != Some(&stage) {
                println!("{} from {theta:e}: {stage}, {rank:?}", rig.name);
                stages.push(stage);
            }
        }
        assert_eq!(stages, ["clear", "in doubt", "singular, in doubt", "singular"], "{}", rig.name);
    }
}

/// The lower bound at the crossing; m̄ near the crossing is not such a bound.
#[test]
fn the_lower_bound_holds_only_at_the_crossing() {
    let rig = Rig::new(linkage::parallelogram());
    let contact = rig.contact("coupler", [0.31, -0.12, 0.0], in_plane([0.6, 0.8].into()));
    let start = rig.closed();
    let limit = mass(&rig.respond(&rig.reach(&start, &[1e-3]), &contact));
    let bound = mass(&rig.respond(&rig.reach(&start, &[0.0]), &contact));
    assert!(bound < 0.9 * limit, "{bound} {limit}");
    let mut gauge = Gauge::new("the last clear answers");
    for theta in [1e-4, 1e-5, 1e-6, 1e-7] {
        let response = rig.respond(&rig.reach(&start, &[theta]), &contact);
        gauge.relative(&format!("{theta:e}"), mass(&response), limit, 1e-2);
    }
    gauge.report();
}
