//! Linkages with open loops as drawn: a pickup point is off by 0, 0.5 or 4 % of the size. They close near the drawn
//! pose.

use percuss_oracle::linkage::family::{DrawnOpen, drawn_open, gaps};
use percuss_tests::answer::Model;
use percuss_tests::tally::{Tally, over};
use std::sync::LazyLock;

const ASSEMBLES: &str = "assembles where the oracle does";
const CLOSED: &str = "is closed there";
const NEAR: &str = "stays near";

fn judge(&(seed, fraction): &(u64, f64), tally: &mut Tally) {
    let DrawnOpen { closed, mechanism, gaps: as_drawn, closes, .. } = drawn_open(seed, fraction);
    let column = format!("{} %", fraction * 100.0);
    let label = format!("{}, open by {as_drawn:.1?} m", closed.label());
    let model = Model::new(mechanism).expect("conditions that fit");
    if closes.is_none() {
        tally.skip(ASSEMBLES, &column);
        return;
    }
    let zero = model.at(&[]);
    let failure = zero.as_ref().err().cloned();
    tally
        .check(ASSEMBLES, &column, failure.is_none(), || format!("{label}: {}", failure.unwrap_or_default()));
    let Ok(zero) = zero else { return };
    let mechanism = drawn_open(seed, fraction).mechanism;
    let positions: Vec<Vec<f64>> = mechanism.joint_ids().map(|id| zero.joint(id).to_vec()).collect();
    let open = gaps(&mechanism, &positions).into_iter().fold(0.0, f64::max);
    tally.check(CLOSED, &column, open <= 1e-11 * closed.size, || format!("{label}: still {open:.1e} m"));
    let most = positions.iter().flatten().fold(0.0, |most: f64, q| most.max(q.abs()));
    // Limit: the oracle's shortest motion, with a margin for another driver.
    tally.check(NEAR, &column, most <= 60.0 * fraction + 1e-9, || format!("{label}: moved by {most:.2e}"));
}

static ALL: LazyLock<Tally> = LazyLock::new(|| {
    let all = [0.0, 0.005, 0.04].into_iter().flat_map(|fraction| (0..60).map(move |seed| (seed, fraction)));
    over(&all.collect::<Vec<_>>(), judge)
});

#[test]
fn every_linkage_assembles() {
    ALL.report(ASSEMBLES, 55);
}

#[test]
fn every_linkage_is_closed() {
    ALL.report(CLOSED, 50);
}

#[test]
fn every_linkage_stays_near() {
    ALL.report(NEAR, 50);
}
