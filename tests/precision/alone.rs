//! If the recursion's result is final, no route has a better result.
//!
//! The recursion bounds its own rounding by the terms of its pivots before the error budget is computed. If this bound
//! is small, m̄ is final for any error budget, and a workspace does not compute errors at all: the remaining error must
//! be the rounding of the data, which every route has. Up to eleven digits, the stated errors guarantee this; beyond,
//! only the bound has decided, and the dense route must not be better by more than that.

use super::percuss::Routes;
use super::{DIGITS, Family, Model, above, off};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Largest number of links of the tested mechanisms.
const MOST_LINKS: usize = 110;

/// Groups with a small bound but a better dense route: expected failures. A group without failures fails the test too,
/// until its name is removed.
const NOT_YET_ALONE: [&str; 0] = [];

#[derive(Default)]
struct Counts {
    asked: usize,
    alone: usize,
    /// Final results with an error budget above eleven digits: the bound decided.
    decided: usize,
    /// Worst true error of these results, and its excess over the dense route's error.
    worst: f64,
    excess: f64,
}

impl Counts {
    /// Complaint about one result, if any.
    fn take(&mut self, found: &Routes, reference: &str) -> Option<String> {
        self.asked += 1;
        self.alone += usize::from(found.is_alone);
        let mass = found.recursion.filter(|_| found.is_alone)?;
        let stated = found.rounding.filter(|stated| above(*stated, DIGITS))?;
        self.decided += 1;
        let truth = off(mass, reference);
        let dense = found.dense.map_or(0.0, |dense| off(dense, reference));
        self.worst = self.worst.max(truth);
        self.excess = self.excess.max(truth - dense);
        above(truth, dense + DIGITS).then(|| {
            format!("off by {truth:.1e}, the dense route by {dense:.1e}; stated {stated:.1e}, reference {reference}")
        })
    }
}

#[test]
fn no_route_is_more_accurate_than_final_recursion_results() {
    let files =
        ["slider_cranks", "decades", "chains", "hubs", "far", "dead_centres", "rings", "pivots", "spatial"];
    let (mut all, mut report, mut failures) = (Counts::default(), String::new(), Vec::new());
    let (mut beaten, mut by_lanes, mut linkages_by_lanes) = (BTreeSet::new(), 0, 0);
    let mut worst_by_lanes = 0.0f64;
    for file in files {
        let family = Family::read(&format!("{file}.json"));
        for (group, cases) in &family.groups {
            let mut counts = Counts::default();
            for case in cases {
                let rows = &family.mechanisms[case.of];
                let count = case.count.unwrap_or(rows.links.len() - 1);
                if count > MOST_LINKS {
                    continue;
                }
                let contacts: Vec<_> = case.contacts.iter().map(|(k, _)| family.contact(*k)).collect();
                let values = rows.values(count, &case.values, 0.0);
                let model = Model::new(&rows.urdf(count), case.floating);
                let routes = model.and_then(|model| model.ask_routes(&values, &contacts));
                let routes = routes.unwrap_or_else(|why| panic!("{group}, seed {}: {why}", case.seed));
                for ((k, reference), found) in case.contacts.iter().zip(&routes) {
                    let near = case.near.map_or(String::new(), |near| format!(", {near:e} from it"));
                    let place = format!("{group}, seed {}{near}, contact {k}", case.seed);
                    let Routes { first, second, auto, lanes, .. } = found;
                    let expected = lanes.map(|(mass, _)| mass).or(*auto);
                    if *first != expected || *second != expected {
                        failures.push(format!(
                            "{place}: a workspace says {first:?}, then {second:?}; a pose {auto:?}, lanes {lanes:?}"
                        ));
                    }
                    if let Some((mass, error)) = lanes {
                        by_lanes += 1;
                        linkages_by_lanes += usize::from(!rows.loops.is_empty());
                        // Rounding of a double: half a unit in the last place.
                        let truth = off(*mass, reference) - f64::EPSILON;
                        worst_by_lanes = worst_by_lanes.max(truth / (error / mass));
                        if above(truth, error / mass) {
                            failures.push(format!(
                                "{place}: lanes off by {truth:.1e}, stated {:.1e}, reference {reference}",
                                error / mass
                            ));
                        }
                    }
                    if let Some(complaint) = counts.take(found, reference) {
                        println!("  {place}: {complaint}");
                        beaten.insert(group.clone());
                    }
                }
            }
            let Counts { asked, alone, decided, worst, excess } = counts;
            let _ = writeln!(
                report,
                "{group:<40} {asked:>5} {alone:>5} {decided:>7} {worst:>6.0e} {excess:>6.0e}"
            );
            all.asked += asked;
            all.alone += alone;
            all.decided += decided;
        }
    }
    println!("group                                    asked alone decided  worst excess\n{report}");
    failures.iter().for_each(|failure| println!("  {failure}"));
    assert!(failures.is_empty(), "{} failures, printed above", failures.len());
    assert!(beaten.iter().eq(NOT_YET_ALONE), "the dense route is better in {beaten:?}");
    println!(
        "{by_lanes} of {} by lanes, {linkages_by_lanes} of linkages; worst {worst_by_lanes:.1e} of stated",
        all.asked
    );
    assert!(by_lanes > 400 && linkages_by_lanes > 70, "{by_lanes} by lanes, {linkages_by_lanes} of linkages");
    assert!(
        all.alone > 3000 && all.decided > 60,
        "{} of {} alone, {} decided",
        all.alone,
        all.asked,
        all.decided
    );
}
