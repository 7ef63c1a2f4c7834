//! Frequency and reasons of the automatic choice of the dense route instead of the recursion.
//!
//! `cargo test --workspace --test suites -- --ignored --nocapture fallbacks` prints the table.

use percuss_dynamics::{EffectiveMass, ResponseError, Route, RouteChoice, RouteError};
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use std::collections::BTreeMap;

/// Counts of a suite.
#[derive(Default)]
struct Row {
    finite_results: usize,
    dense: usize,
    /// Counts by reason; for a stated error, by its decade.
    reasons: BTreeMap<String, usize>,
    /// Cases in which the dense result was rejected because its own error is no smaller.
    kept: usize,
    /// Largest deviation of the rejected recursion results.
    worst: f64,
    examples: Vec<String>,
}

fn count(row: &mut Row, subject: &Subject) {
    let by = |choice| subject.pose.respond_by_route(&subject.contact, choice);
    let auto = by(RouteChoice::Auto).unwrap_or_else(|error| panic!("{}: {error}", subject.name));
    let recursive = by(RouteChoice::Only(Route::Articulated));
    row.finite_results += 1;
    let part = |response: &percuss_dynamics::ContactResponse| match response.effective_mass {
        EffectiveMass::Finite(m) => response.error.and_then(|e| e.rounding).map(|e| e / m),
        EffectiveMass::Immovable | EffectiveMass::Massless => None,
    };
    if auto.route == Route::Articulated {
        if part(&auto).is_some_and(|stated| stated > 1e-11) {
            row.kept += 1;
            row.examples.push(format!("{}: vague and kept, {:?}", subject.name, auto.error));
        }
        return;
    }
    row.dense += 1;
    let reason = match &recursive {
        Err(ResponseError::Route(RouteError::Indefinite)) => "a pivot below zero".into(),
        Err(error) => error.to_string(),
        Ok(response) => match (response.effective_mass, part(response)) {
            (EffectiveMass::Finite(m), Some(stated)) => {
                if let EffectiveMass::Finite(dense) = auto.effective_mass {
                    row.worst = row.worst.max((m / dense - 1.0).abs());
                }
                format!("states an error of 1e{:.0}", stated.log10().floor())
            }
            (mass, _) => format!("{mass:?} by recursion, {:?}", auto.effective_mass),
        },
    };
    row.examples.push(format!("{}: {reason}", subject.name));
    *row.reasons.entry(reason).or_default() += 1;
}

#[test]
#[ignore = "prints a table"]
fn fallbacks() {
    let suites = [
        ("zoo and random trees", of_trees(14, 8, 400)),
        ("linkages under all conditions", of_linkages(600, 48)),
    ];
    for (name, subjects) in suites {
        let mut row = Row::default();
        subjects.iter().for_each(|subject| count(&mut row, subject));
        let Row { finite_results, dense, reasons, kept, worst, examples } = row;
        println!(
            "{name}: {finite_results} finite results, {dense} by the dense route, {kept} uncertain and kept"
        );
        println!("    the recursion was off by {worst:.1e} at most where it was left");
        reasons.iter().for_each(|(reason, count)| println!("    {count:5} {reason}"));
        examples.iter().take(10).for_each(|line| println!("        {line}"));
    }
}

/// The recursion solves most mechanisms; few need the dense route.
#[test]
fn the_recursion_is_seldom_left() {
    let subjects = of_trees(15, 2, 120).into_iter().chain(of_linkages(700, 8));
    let mut row = Row::default();
    subjects.for_each(|subject| count(&mut row, &subject));
    println!("{} of {} by the dense route: {:?}", row.dense, row.finite_results, row.reasons);
    assert!(
        row.finite_results > 400 && 10 * row.dense < row.finite_results,
        "{} of {}",
        row.dense,
        row.finite_results
    );
}
