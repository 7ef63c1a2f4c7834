//! Four parallel cranks of any length at any distance: one degree of freedom, and a closed form of m̄.

use percuss_oracle::linkage::CrankRow;
use percuss_spatial::Vector3;
use percuss_tests::answer::{Model, Status};
use percuss_tests::tally::Tally;

const ASSEMBLES: &str = "assembles";
const FREEDOMS: &str = "freedoms";
const STANDS: &str = "stands where drawn";
const MASS: &str = "mass";

/// Length of the cranks and distance between them, m.
const ROWS: [(f64, f64); 14] = [
    (1.0, 1.0),
    (1e-3, 1e-2),
    (1e-5, 1e-2),
    (1e-7, 1e-2),
    (1e-9, 1e-2),
    (1e-11, 1e-2),
    (1e-13, 1e-2),
    (1e-13, 1e-13),
    (1e-9, 1e-9),
    (1e2, 1e-2),
    (1e4, 1e-2),
    (1e6, 1e-2),
    (1e6, 1.0),
    (1e6, 1e6),
];

#[test]
fn rows_of_cranks() {
    let mut tally = Tally::default();
    let mut warned = 0;
    for (column, turned, distance_from_origin) in [
        ("in the plane of x and y", false, 0.0),
        ("in a plane askew", true, 0.0),
        ("a metre away", true, 1.0),
    ] {
        for (length, spacing) in ROWS {
            // Positions have an error of an ulp of the largest coordinate.
            let far = f64::max(length, 3.0 * spacing) + distance_from_origin;
            let rounding = 30.0 * f64::EPSILON * far / f64::min(length, spacing);
            if rounding > 1e-2 {
                continue;
            }
            let row = CrankRow {
                count: 4,
                length,
                spacing,
                angle: 1.1,
                turned,
                distance_from_origin,
                crank_mass: 0.7,
                platform_mass: 2.0,
            };
            let label = format!("cranks of {length:e} m, {spacing:e} m apart, {column}");
            let mechanism = row.mechanism();
            let link = mechanism.find_link("platform").expect("a link");
            let joints: Vec<_> = mechanism.joint_ids().collect();
            let model = Model::new(mechanism).expect("conditions that fit");
            let generic = model.generic();
            let clear = model.rank_is_clear();
            tally.check(FREEDOMS, column, generic == Ok((1, 11)) || !clear, || {
                format!("{label}: {generic:?}, wanted (1, 11)")
            });
            let zero = model.at(&[]);
            let failure = zero.as_ref().err().cloned();
            tally.check(ASSEMBLES, column, failure.is_none(), || {
                format!("{label}: {}", failure.unwrap_or_default())
            });
            let Ok(zero) = zero else { continue };
            let most =
                joints.iter().flat_map(|id| zero.joint(*id)).fold(0.0, |most: f64, q| most.max(q.abs()));
            tally.check(STANDS, column, most <= 1e-9 + rounding, || format!("{label}: off by {most:e} rad"));
            let expected = row.along_the_motion();
            let answer = zero.respond(link, Vector3::zeros(), row.motion());
            let bound = 1e-9 + rounding;
            // Correct, or with a warning: cranks of a millionth of their surroundings lose digits.
            let holds = answer.as_ref().is_ok_and(|answer| {
                answer.status == Status::Finite && (answer.mass / expected - 1.0).abs() <= bound
                    || answer.warned
            });
            warned += usize::from(answer.as_ref().is_ok_and(|answer| answer.warned));
            tally.check(MASS, column, holds, || {
                format!("{label}: {answer:?}, expected {expected} kg to {bound:.0e}")
            });
        }
    }
    for asked in [ASSEMBLES, FREEDOMS, STANDS, MASS] {
        let _ = std::panic::catch_unwind(|| tally.report(asked, ROWS.len() - 4));
    }
    // Warnings are limited to extremes: at least half of the rows have none.
    assert!(warned <= 20, "{warned} of 40 are warned of");
    let wrong = tally.wrong();
    assert!(wrong.is_empty(), "{wrong:?}");
}
