//! Mechanisms on the same ground are independent: results for one mechanism are bitwise equal with and without the
//! other, for any size and any inexactness of its loops.

use percuss_dynamics::{Contact, EffectiveMass, Route, RouteChoice};
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_oracle::alter::{on_common_ground, scaled};
use percuss_oracle::linkage::family::{Drawn, Kind, drawn_as};
use percuss_oracle::linkage::{self, contradicting};
use percuss_oracle::zoo;
use percuss_spatial::Vector3;
use percuss_tests::answer::{Answer, Answered, Model};
use percuss_tests::tally::{Tally, over};
use std::sync::LazyLock;

const SIZES: [f64; 5] = [1e-4, 1e-2, 1.0, 1e2, 1e4];
const FRACTIONS: [f64; 4] = [0.0, 1e-7, 1e-5, 1e-4];

const SOLVED_TOGETHER: &str = "same results together with the other and alone";
const POSITIONS: &str = "positions";
const MASS: &str = "mass";
const ERROR: &str = "stated error";
const STATUS: &str = "status";
const SINGULAR: &str = "singular pose";
const FREEDOMS: &str = "freedoms add up";
const GENERIC: &str = "generic freedoms and redundant rows add up";
const DENSE: &str = "mass and status by the dense route";
const TRUE_MASS: &str = "mass of route C, alone";
const TRUE_MASS_TOGETHER: &str = "mass of route C, together with the other";
/// Relative difference of the dense route's mass with and without a second mechanism: sums in another order.
const REORDERED: f64 = 1e-9;

/// Part of a mechanism with its contacts: link, point, normal, and m̄ of the exact twin by route C.
struct Part {
    what: String,
    mechanism: Mechanism,
    contacts: Vec<(String, Vector3<f64>, Vector3<f64>, f64)>,
    /// Permitted relative difference from route C.
    bound: f64,
}

impl Part {
    fn of_family(seed: u64, kind: Kind, size: f64, fraction: f64) -> Self {
        let exact: Drawn = drawn_as(seed, kind);
        let name = |link: LinkId| exact.mechanism.link(link).name().to_owned();
        let contacts = exact.contacts.iter();
        Self {
            what: format!("{kind:?} of {size:e} m, off by {fraction:e}"),
            mechanism: contradicting(seed, kind, size, fraction),
            contacts: contacts
                .map(|touch| (name(touch.link), touch.point * (size / exact.size), touch.normal, touch.mass))
                .collect(),
            bound: f64::max(1e-9, 1e3 * fraction),
        }
    }

    /// An open chain of a given size.
    fn chain(size: f64) -> Self {
        let mechanism = scaled(&zoo::double_pendulum(), size, 1.0);
        Self { what: format!("chain of {size:e} m"), mechanism, contacts: Vec::new(), bound: 0.0 }
    }
}

/// All results for a part.
struct Seen {
    generic: (usize, usize),
    freedoms: usize,
    positions: Vec<Vec<u64>>,
    answers: Vec<Answer>,
    /// Results of the dense route.
    dense: Vec<Answer>,
}

/// Results for a part of a mechanism, whose names have a prefix in the whole; mobility and rank refer to the whole.
fn solve_part(model: &Model, mechanism: &Mechanism, part: &Part, prefix: &str) -> Answered<Seen> {
    let zero = model.at(&[])?;
    let joints: Vec<JointId> = part
        .mechanism
        .joints()
        .iter()
        .map(|joint| mechanism.find_joint(&format!("{prefix}{}", joint.name())).expect("a joint"))
        .collect();
    let respond = |choice: RouteChoice| {
        let contacts = part.contacts.iter().map(move |(link, point, normal, _)| {
            let link = mechanism.find_link(&format!("{prefix}{link}")).expect("a link");
            (choice, Contact::new(link, *point, *normal))
        });
        contacts.map(|(choice, contact)| zero.respond_by(choice, &contact)).collect::<Answered<Vec<Answer>>>()
    };
    let answers = respond(RouteChoice::Auto)?;
    let dense = respond(RouteChoice::Only(Route::Dense))?;
    // A part without contacts is a chain: all its joints move.
    let freedoms = answers.first().map_or(joints.len(), |answer| answer.degrees_of_freedom);
    let bits = |id: &JointId| zero.joint(*id).iter().map(|q| q.to_bits()).collect();
    Ok(Seen {
        generic: model.generic()?,
        freedoms,
        positions: joints.iter().map(bits).collect(),
        answers,
        dense,
    })
}

fn alone(part: &Part) -> Answered<Seen> {
    let mechanism = on_common_ground(&[("", &part.mechanism)]);
    solve_part(&Model::new(on_common_ground(&[("", &part.mechanism)]))?, &mechanism, part, "")
}

/// A pair of parts with questions about `y`.
struct Case {
    x: Part,
    y: Part,
    column: String,
    x_first: bool,
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

fn judge(case: &Case, tally: &mut Tally) {
    let Case { x, y, column, x_first } = case;
    let label = format!("{} beside {} (x first: {x_first})", y.what, x.what);
    let parts = [("x_", &x.mechanism), ("y_", &y.mechanism)];
    let parts = if *x_first { parts } else { [parts[1], parts[0]] };
    let together = on_common_ground(&parts);
    let pair = Model::new(on_common_ground(&parts)).and_then(|model| solve_part(&model, &together, y, "y_"));
    let (own, other) = (alone(y), alone(x));
    let (pair, own, other) = match (pair, own, other) {
        (Ok(pair), Ok(own), Ok(other)) => (pair, own, other),
        (pair, own, other) => {
            // The pair is refused exactly if one of its parts is refused.
            let holds = pair.is_ok() == (own.is_ok() && other.is_ok());
            let words = [pair, own, other].map(|seen| seen.map_or_else(|error| error, |_| "answered".into()));
            tally.check(SOLVED_TOGETHER, column, holds, || {
                format!("{label}: together, alone, the other: {words:?}")
            });
            return;
        }
    };
    tally.check(SOLVED_TOGETHER, column, true, String::new);
    let generic = (own.generic.0 + other.generic.0, own.generic.1 + other.generic.1);
    tally.check(GENERIC, column, pair.generic == generic, || {
        format!("{label}: {:?}, expected {:?} + {:?}", pair.generic, own.generic, other.generic)
    });
    let freedoms = own.freedoms + other.freedoms;
    tally.check(FREEDOMS, column, pair.freedoms == freedoms, || {
        format!("{label}: {}, expected {} + {}", pair.freedoms, own.freedoms, other.freedoms)
    });
    tally.check(POSITIONS, column, pair.positions == own.positions, || {
        let floats = |seen: &Seen| -> Vec<f64> {
            seen.positions.iter().flatten().map(|bits| f64::from_bits(*bits)).collect()
        };
        format!("{label}: {:?}, alone {:?}", floats(&pair), floats(&own))
    });
    for (number, (a, b)) in pair.dense.iter().zip(&own.dense).enumerate() {
        let holds = a.status == b.status && (a.mass.is_nan() || (a.mass / b.mass - 1.0).abs() <= REORDERED);
        tally.check(DENSE, column, holds, || format!("{label}, contact {number}: {a:?}, alone {b:?}"));
    }
    for (number, ((a, b), contact)) in pair.answers.iter().zip(&own.answers).zip(&y.contacts).enumerate() {
        let line = || format!("{label}, contact {number}: {a:?}, alone {b:?}");
        tally.check(STATUS, column, a.status == b.status, line);
        tally.check(SINGULAR, column, a.singular == b.singular, line);
        tally.check(MASS, column, same(a.mass, b.mass), line);
        tally.check(ERROR, column, same(a.error, b.error), line);
        for (asked, answer) in [(TRUE_MASS, b), (TRUE_MASS_TOGETHER, a)] {
            let off = (answer.mass / contact.3 - 1.0).abs();
            tally.check(asked, column, off <= y.bound, || format!("{}; route C {} kg", line(), contact.3));
        }
    }
}

/// Every size and inexactness, combined with every other size and inexactness, and with open chains.
fn cases() -> Vec<Case> {
    const KINDS: [(u64, Kind); 3] = [(5, Kind::FourBar), (11, Kind::Cranks(3)), (4, Kind::SliderCrank)];
    let mut cases = Vec::new();
    for y_size in SIZES {
        for y_fraction in FRACTIONS {
            for x_size in SIZES.into_iter().filter(|size| *size != y_size) {
                for x_fraction in FRACTIONS.map(Some).into_iter().chain([None]) {
                    let count = cases.len();
                    let (seed, kind) = KINDS[count % 3];
                    let y = Part::of_family(seed, kind, y_size, y_fraction);
                    let (seed, kind) = KINDS[count / 3 % 2];
                    let x = match x_fraction {
                        Some(fraction) => Part::of_family(seed, kind, x_size, fraction),
                        None => Part::chain(x_size),
                    };
                    let column = x_fraction
                        .map_or("beside a chain".into(), |fraction| format!("beside off by {fraction:e}"));
                    cases.push(Case { x, y, column, x_first: count % 2 == 0 });
                }
            }
        }
    }
    cases
}

static ALL: LazyLock<Tally> = LazyLock::new(|| over(&cases(), judge));

#[test]
fn a_pair_has_a_result_if_both_parts_have_one() {
    ALL.report(SOLVED_TOGETHER, 80);
}

#[test]
fn positions_are_the_same() {
    ALL.report(POSITIONS, 1);
}

#[test]
fn masses_are_the_same() {
    ALL.report(MASS, 1);
}

#[test]
fn stated_errors_are_the_same() {
    ALL.report(ERROR, 1);
}

#[test]
fn masses_by_the_dense_route_are_the_same() {
    ALL.report(DENSE, 1);
}

/// A parallelogram at a crossing of its branches: the limits along the branches do not depend on other mechanisms.
#[test]
fn limits_at_a_crossing_are_the_same() {
    let limits = |parts: &[(&str, &Mechanism)], link: &str, size: f64| {
        let mechanism = on_common_ground(parts);
        let link = mechanism.find_link(link).expect("a link");
        let contact = Contact::new(link, [0.31 * size, -0.12 * size, 0.0], [0.2, 0.9, 0.0]);
        let (limits, complete) = Model::new(mechanism)?.at(&[])?.limits(&contact)?;
        let value = |limit: EffectiveMass| match limit {
            EffectiveMass::Finite(m) => m,
            EffectiveMass::Immovable | EffectiveMass::Massless => f64::NAN,
        };
        Ok::<_, String>((limits.into_iter().map(value).collect::<Vec<f64>>(), complete))
    };
    for size in SIZES {
        let y = scaled(&linkage::parallelogram().mechanism, size, 1.0);
        let (own, complete) = limits(&[("y_", &y)], "y_coupler", size).expect("limits");
        assert!(own.len() == 2 && complete, "{size:e} m: {own:?}");
        for other in SIZES {
            for (x_first, fraction) in [(true, 1e-5), (false, 1e-4)] {
                let x = contradicting(11, Kind::Cranks(3), other, fraction);
                let parts = [("x_", &x), ("y_", &y)];
                let parts = if x_first { parts } else { [parts[1], parts[0]] };
                let label = format!("{size:e} m beside {other:e} m, off by {fraction:e}");
                let (got, complete) = limits(&parts, "y_coupler", size).expect("limits");
                assert!(got.len() == 2 && complete, "{label}: {got:?}, alone {own:?}");
                for (a, b) in got.iter().zip(&own) {
                    assert!((a / b - 1.0).abs() <= 1e-6, "{label}: {got:?}, alone {own:?}");
                }
            }
        }
    }
}

#[test]
fn statuses_are_the_same() {
    ALL.report(STATUS, 1);
}

#[test]
fn singular_poses_are_the_same() {
    ALL.report(SINGULAR, 1);
}

#[test]
fn freedoms_add_up() {
    ALL.report(FREEDOMS, 1);
}

#[test]
fn generic_freedoms_add_up() {
    ALL.report(GENERIC, 1);
}

#[test]
fn masses_alone_are_route_cs() {
    ALL.report(TRUE_MASS, 1);
}

#[test]
fn masses_beside_the_other_are_route_cs() {
    ALL.report(TRUE_MASS_TOGETHER, 1);
}

/// An exact loop of 1 mm and a loop of a metre that is off by 0.1 mm: with a shared threshold, a twentieth of a percent
/// of the large loop would exceed all singular values of the small loop.
#[test]
fn a_millimetre_beside_a_metre() {
    let mut tally = Tally::default();
    for seed in 0..24 {
        let kind = Kind::ALL[seed as usize % Kind::ALL.len()];
        let y = Part::of_family(seed, kind, 1e-3, 0.0);
        let x = Part::of_family(5, Kind::FourBar, 1.0, 1e-4);
        judge(&Case { x, y, column: "1 mm".into(), x_first: seed % 2 == 0 }, &mut tally);
    }
    for asked in
        [SOLVED_TOGETHER, GENERIC, FREEDOMS, POSITIONS, STATUS, SINGULAR, TRUE_MASS, TRUE_MASS_TOGETHER]
    {
        let result = std::panic::catch_unwind(|| tally.report(asked, 1));
        println!("{asked}: {}", if result.is_ok() { "all hold" } else { "FAILS" });
    }
    let wrong = tally.wrong();
    assert!(wrong.is_empty(), "{wrong:?}");
}
