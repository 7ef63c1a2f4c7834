//! Linkages from files with few decimals, compared with their exact twins: 208 linkages of the drawn family, each with
//! 12, 9, 7, 6, 5 and 4 decimals, at rest and driven.
//!
//! All bounds are fixed: the effect of a rounding of 10^-k on the result is at most some hundred times 10^-k, as route
//! C on the same files shows (`crates/oracle/tests/families.rs::rounded_twins_can_be_answered`). `PERCUSS_ALL=1` prints
//! every failure.

use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use percuss_oracle::linkage::family::{DECIMALS, Drawn, drawn};
use percuss_spatial::Vector3;
use percuss_tests::answer::{Answer, Answered, Model, PosedModel, Status};
use percuss_tests::tally::{Tally, over};
use std::collections::BTreeMap;
use std::sync::LazyLock;

const COUNT: u64 = 208;
/// Relative error of m̄ of a file with k decimals compared with the exact twin, in units of 10^-k.
const UNITS: f64 = 3e3;
/// Relative error of m̄ of the exact twin compared with route C.
const EXACT: f64 = 1e-9;
/// Difference of the angles at rest from the drawn angles, rad; slides relative to the size.
const STANDS: f64 = 0.01;
/// Rounding error of route C: closed forms show 2e-14.
const ORACLE: f64 = 1e-12;

const ASSEMBLES: &str = "assembles at zero";
const STANDS_THERE: &str = "stands where drawn";
const FREEDOMS: &str = "generic freedoms and redundant rows";
const FREEDOMS_HERE: &str = "freedoms at the pose";
const STATUS: &str = "status";
const STILL: &str = "immovable along the hinges where the exact twin is, or known to be uncertain";
const MASS: &str = "mass";
const ERROR: &str = "stated error is not exceeded";
const SET_ZERO: &str = "driver set to 0";
const SET: &str = "driver set aside";
const SET_MASS: &str = "mass with the driver set";
const ALL_RIGHT: &str = "nothing wrong";
const SET_ERROR: &str = "stated error with the driver set is not exceeded";

/// The exact twin with its results at driven positions.
struct Twin {
    drawn: Drawn,
    exact: Answered<Model>,
    /// m̄ of every contact by route C, per joint and value; `None` near a dead centre.
    expected: BTreeMap<(JointId, u64), Option<Vec<f64>>>,
    /// True if the library drives a joint of the exact twin to a value.
    reaches: BTreeMap<(JointId, u64), bool>,
}

impl Twin {
    fn reaches(&mut self, joint: JointId, value: f64) -> bool {
        let Self { exact, reaches, .. } = self;
        let there = || exact.as_ref().is_ok_and(|exact| exact.at(&[(joint, value)]).is_ok());
        *reaches.entry((joint, value.to_bits())).or_insert_with(there)
    }

    fn expected(&mut self, joint: JointId, value: f64) -> Option<Vec<f64>> {
        let Self { drawn, expected, .. } = self;
        let masses = || {
            let positions = drawn.at(joint, value)?;
            let of = |touch| drawn.mass_of(&drawn.mechanism, &positions, touch, None).finite();
            drawn.contacts.iter().map(of).collect()
        };
        expected.entry((joint, value.to_bits())).or_insert_with(masses).clone()
    }
}

fn judge(&seed: &u64, tally: &mut Tally) {
    let model = || Model::new(drawn(seed).mechanism);
    let mut twin =
        Twin { drawn: drawn(seed), exact: model(), expected: BTreeMap::new(), reaches: BTreeMap::new() };
    judge_file(&mut twin, model(), "exact", EXACT, tally);
    for decimals in DECIMALS {
        let file: Mechanism = twin.drawn.written(decimals);
        let bound = UNITS * 10f64.powi(-(decimals as i32));
        judge_file(&mut twin, Model::new(file), &format!("{decimals:2} decimals"), bound, tally);
    }
}

fn judge_file(twin: &mut Twin, model: Answered<Model>, column: &str, bound: f64, tally: &mut Tally) {
    let mut own = Tally::default();
    judge_everything(twin, model, column, bound, &mut own);
    let wrong = own.wrong();
    tally.merge(own);
    tally.check(ALL_RIGHT, column, wrong.is_empty(), || {
        format!("{}, {column}: {}", twin.drawn.label(), wrong.join("; "))
    });
}

fn judge_everything(twin: &mut Twin, model: Answered<Model>, column: &str, bound: f64, tally: &mut Tally) {
    let label = format!("{}, {column}", twin.drawn.label());
    let model = match model {
        Ok(model) => model,
        Err(error) => {
            tally.check(ASSEMBLES, column, false, || format!("{label}: {error}"));
            return;
        }
    };
    let zero = model.at(&[]);
    let failure = zero.as_ref().err().cloned();
    tally.check(ASSEMBLES, column, failure.is_none(), || format!("{label}: {}", failure.unwrap_or_default()));
    let wanted = (twin.drawn.mobility, twin.drawn.redundant);
    let got = model.generic();
    tally.check(FREEDOMS, column, got.as_ref() == Ok(&wanted), || {
        format!("{label}: {got:?}, expected {wanted:?}")
    });
    let Ok(zero) = zero else { return };
    let off = off(&twin.drawn, &zero);
    tally.check(STANDS_THERE, column, off.1 <= STANDS, || format!("{label}: {} off by {:.3e}", off.0, off.1));
    for (number, touch) in twin.drawn.contacts.iter().enumerate() {
        let line = format!("{label} contact {number}");
        let answer = zero.respond(touch.link, touch.point, touch.normal);
        compare(tally, column, [STATUS, MASS, ERROR], &line, &answer, touch.mass, bound);
        if let Ok(answer) = answer {
            let (got, wanted) = (answer.degrees_of_freedom, twin.drawn.mobility);
            tally.check(FREEDOMS_HERE, column, got == wanted && !answer.singular, || {
                format!("{line}: {got}, expected {wanted}; singular {}", answer.singular)
            });
        }
    }
    for (number, touch) in twin.drawn.contacts.iter().enumerate() {
        let Some(axis) = hinge_of(&twin.drawn.mechanism, touch.link) else { continue };
        let exact = twin.exact.as_ref().ok().and_then(|exact| exact.at(&[]).ok());
        let expected = exact.and_then(|exact| exact.respond(touch.link, touch.point, axis).ok());
        if expected.is_some_and(|answer| answer.status == Status::Immovable) {
            let answer = zero.respond(touch.link, touch.point, axis);
            let holds = answer
                .as_ref()
                .is_ok_and(|answer| answer.status == Status::Immovable || answer.nearly_immovable);
            tally.check(STILL, column, holds, || {
                format!("{label} contact {number} along its axis: {answer:?}")
            });
        }
    }
    for driver in zero.drivers() {
        for value in [0.0, 0.1, -0.1] {
            let what = if value == 0.0 { SET_ZERO } else { SET };
            let Some(expected) = twin.expected(driver, value) else {
                tally.skip(what, column);
                continue;
            };
            let name = twin.drawn.mechanism.joint(driver).name().to_owned();
            let line = format!("{label} {name}={value}");
            let stand = model.at(&[(driver, value)]);
            if column != "exact" && !twin.reaches(driver, value) {
                tally.skip(what, column);
                continue;
            }
            let failure = stand.as_ref().err().cloned();
            tally.check(what, column, failure.is_none(), || {
                format!("{line}: {}", failure.unwrap_or_default())
            });
            let Ok(stand) = stand else { continue };
            for (number, (touch, expected)) in twin.drawn.contacts.iter().zip(&expected).enumerate() {
                let answer = stand.respond(touch.link, touch.point, touch.normal);
                let line = format!("{line} contact {number}");
                compare(tally, column, [STATUS, SET_MASS, SET_ERROR], &line, &answer, *expected, bound);
            }
        }
    }
}

/// Axis of the hinge to a link's parent, in the link's frame.
fn hinge_of(mechanism: &Mechanism, link: LinkId) -> Option<Vector3<f64>> {
    let turns = [JointKind::Revolute, JointKind::Continuous];
    let joint = mechanism.joints().iter().find(|joint| joint.child() == link)?;
    turns.contains(&joint.kind()).then(|| *joint.axis())
}

/// The joint with the largest position, and the position: rad, or relative to the size for slides.
fn off(drawn: &Drawn, stand: &PosedModel) -> (String, f64) {
    let of = |id: JointId| {
        let joint = drawn.mechanism.joint(id);
        let unit = if joint.kind() == JointKind::Prismatic { drawn.size } else { 1.0 };
        let most = stand.joint(id).iter().fold(0.0, |most: f64, q| most.max((q / unit).abs()));
        (joint.name().to_owned(), most)
    };
    let all = drawn.mechanism.joint_ids().map(of);
    all.max_by(|a, b| a.1.total_cmp(&b.1)).expect("a joint")
}

fn compare(
    tally: &mut Tally,
    column: &str,
    [status, mass, error]: [&'static str; 3],
    line: &str,
    answer: &Answered<Answer>,
    expected: f64,
    bound: f64,
) {
    let finite = answer.as_ref().ok().filter(|answer| answer.status == Status::Finite);
    if !tally
        .check(status, column, finite.is_some(), || format!("{line}: {answer:?}, expected {expected} kg"))
    {
        return;
    }
    let Some(answer) = finite else { return };
    let off = (answer.mass / expected - 1.0).abs();
    tally.check(mass, column, off <= bound, || {
        format!("{line}: got {} kg, expected {expected} kg, off by {off:.2e}, bound {bound:.0e}", answer.mass)
    });
    let far = (answer.mass - expected).abs();
    tally.check(error, column, far <= answer.error + ORACLE * expected, || {
        format!(
            "{line}: got {} kg ± {:.2e}, expected {expected} kg, off by {far:.2e} kg",
            answer.mass, answer.error
        )
    });
}

static ALL: LazyLock<Tally> = LazyLock::new(|| over(&(0..COUNT).collect::<Vec<u64>>(), judge));

#[test]
fn every_file_assembles() {
    ALL.report(ASSEMBLES, COUNT as usize);
}

#[test]
fn every_file_closes_near_its_drawing() {
    ALL.report(STANDS_THERE, 1);
}

#[test]
fn every_file_has_the_freedoms_of_its_exact_twin() {
    ALL.report(FREEDOMS, COUNT as usize);
}

#[test]
fn every_file_has_them_at_its_pose() {
    ALL.report(FREEDOMS_HERE, 1);
}

#[test]
fn every_contact_is_answered_by_a_number() {
    ALL.report(STATUS, 1);
}

#[test]
fn contacts_without_motion_are_immovable_or_uncertain() {
    ALL.report(STILL, 1);
}

#[test]
fn masses_are_those_of_the_exact_twin() {
    ALL.report(MASS, 1);
}

#[test]
fn stated_errors_are_not_exceeded() {
    ALL.report(ERROR, 1);
}

#[test]
fn drivers_can_be_set_to_zero() {
    ALL.report(SET_ZERO, 1);
}

#[test]
fn drivers_reach_the_positions_of_the_exact_twin() {
    ALL.report(SET, 1);
}

#[test]
fn masses_with_a_driver_set_are_those_of_the_exact_twin() {
    ALL.report(SET_MASS, 1);
}

#[test]
fn stated_errors_with_a_driver_set_are_not_exceeded() {
    ALL.report(SET_ERROR, 1);
}
/// Total: files without any failure.
#[test]
fn every_file_is_right_in_everything() {
    ALL.report(ALL_RIGHT, COUNT as usize);
}

/// Prints a file of the family: `PERCUSS_FAMILY="17 6" cargo test --workspace --test suites -- --ignored
/// --nocapture write_one` prints number 17 with 6 decimals (without decimals: the exact file), and its contacts.
#[test]
#[ignore = "prints a file"]
fn write_one() {
    let asked = std::env::var("PERCUSS_FAMILY").unwrap_or_else(|_| "0".into());
    let mut words = asked.split_whitespace().map(|word| word.parse::<usize>().expect("a number"));
    let drawn = drawn(words.next().expect("a seed") as u64);
    let file = words.next().map(|decimals| drawn.written(decimals));
    println!("{}", percuss_formats::write_urdf(file.as_ref().unwrap_or(&drawn.mechanism)));
    for touch in &drawn.contacts {
        let (link, p, n) = (drawn.mechanism.link(touch.link).name(), touch.point, touch.normal);
        println!(
            "<?percuss mass --link {link} --point={},{},{} --normal={},{},{} --expect {}?>",
            p.x, p.y, p.z, n.x, n.y, n.z, touch.mass
        );
    }
}
