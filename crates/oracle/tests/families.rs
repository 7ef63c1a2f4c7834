//! Families of linkages: their stated properties, and bounds for the tests of rounded files.

use nalgebra::Vector3;
use percuss_mechanism::{JointId, Mechanism};
use percuss_oracle::linkage::family::{DECIMALS, Drawn, Kind, Touch, drawn, drawn_as, drawn_open, gaps};
use percuss_oracle::linkage::{CrankRow, contradicting};
use percuss_oracle::maximal::{Question, close_as_far_as_possible, residual, solve};
use percuss_oracle::{alter, random};

const COUNT: u64 = 208;

fn at_zero(mechanism: &Mechanism) -> Vec<Vec<f64>> {
    random::zero_positions(mechanism)
}

#[test]
fn exact_twins_close_as_drawn_and_weigh_what_their_closed_forms_say() {
    let (mut worst, mut count) = (0.0, 0);
    for seed in 0..COUNT {
        let Drawn { mechanism, contacts, mobility, redundant, .. } = drawn(seed);
        let open = residual(&mechanism, &at_zero(&mechanism));
        assert!(open < 1e-14, "{}: {open:e}", mechanism.name());
        for touch in &contacts {
            let normal = Vector3::z();
            let question = Question::new(&mechanism, at_zero(&mechanism), touch.link, touch.point, normal);
            let answer = solve(&question);
            assert_eq!(answer.degrees_of_freedom, mobility, "{}", mechanism.name());
            assert_eq!(answer.redundant_constraints, redundant, "{}", mechanism.name());
            if let Some(expected) = touch.closed_form {
                worst = f64::max(worst, (touch.mass / expected - 1.0).abs());
                count += 1;
            }
        }
    }
    println!("{count} closed forms, worst {worst:e}");
    assert!(count > 250 && worst < 1e-11, "{count} {worst:e}");
}

#[test]
fn a_seed_gives_the_same_again() {
    for seed in 0..16 {
        let (one, two) = (drawn(seed), drawn(seed));
        assert_eq!(alter::describe(&one.mechanism), alter::describe(&two.mechanism));
        assert_eq!(alter::describe_loops(&one.mechanism), alter::describe_loops(&two.mechanism));
    }
    for kind in Kind::ALL {
        assert!((0..8).any(|seed| drawn(seed).kind == kind));
    }
}

/// The bounds that the tests require of the library are achievable: route C, with a rank threshold between the singular
/// values of the constraints and those of rounding, is well within them, and so is the least-squares pose with a
/// well-conditioned driver at 0.
#[test]
fn rounded_twins_can_be_answered() {
    for decimals in DECIMALS {
        let unit = 10f64.powi(-(decimals as i32));
        let (mut open, mut off, mut mass, mut set_mass, mut set) = (0.0f64, 0.0f64, 0.0f64, 0.0f64, 0);
        for seed in 0..COUNT {
            let drawn = drawn(seed);
            let twin = drawn.written(decimals);
            let zero = at_zero(&twin);
            open = open.max(residual(&twin, &zero) / unit);
            let conditioning = |id: &JointId| drawn.conditioning_of_driver(&zero, *id);
            let best =
                drawn.loop_joints.iter().copied().max_by(|a, b| conditioning(a).total_cmp(&conditioning(b)));
            let closed = driven(&drawn, &twin, best.expect("joints"), &zero);
            off = off.max(closed.concat().iter().fold(0.0, |most: f64, q| most.max(q.abs())) / unit);
            for touch in &drawn.contacts {
                let got = drawn.mass_of(&twin, &zero, touch, Some(1e-2)).finite().expect("finite");
                mass = mass.max((got / touch.mass - 1.0).abs() / unit);
            }
            if seed / 8 % 4 != 0 {
                continue;
            }
            for &driver in &drawn.loop_joints {
                for value in [-0.1, 0.1] {
                    let Some(exact) = drawn.at(driver, value) else { continue };
                    let positions = driven(&drawn, &twin, driver, &exact);
                    for touch in &drawn.contacts {
                        let exactly = drawn.mass_of(&drawn.mechanism, &exact, touch, None);
                        let got =
                            drawn.mass_of(&twin, &positions, touch, Some(1e-2)).finite().expect("finite");
                        let deviation = got / exactly.finite().expect("finite") - 1.0;
                        set_mass = set_mass.max(deviation.abs() / unit);
                        set += 1;
                    }
                }
            }
        }
        println!(
            "{decimals} decimals, in their units: open {open:.1} m, off {off:.1} rad, mass {mass:.1}; of {set} set, \
             {set_mass:.1}"
        );
        assert!(open < 10.0 && off < 100.0 && mass < 1e3 && set_mass < 1e3 && set > 500);
    }
}

/// Least-squares closed position from `guess` with one joint held.
fn driven(drawn: &Drawn, twin: &Mechanism, driver: JointId, guess: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let followers: Vec<_> = drawn.loop_joints.iter().copied().filter(|id| *id != driver).collect();
    close_as_far_as_possible(twin, guess, &followers).0
}

#[test]
fn gaps_as_drawn_are_what_was_asked_for() {
    let mut closes = 0;
    for seed in 0..60 {
        for fraction in [0.0, 0.005, 0.04] {
            let open = drawn_open(seed, fraction);
            let expected_gap = fraction * open.closed.size;
            for (i, gap) in open.gaps.iter().enumerate() {
                let expected_gap = if i == open.moved { expected_gap } else { 0.0 };
                assert!(
                    (gap - expected_gap).abs() < 1e-14,
                    "{seed} {fraction}: {gap}, wanted {expected_gap}"
                );
            }
            let Some(closed) = &open.closes else { continue };
            closes += 1;
            assert!(gaps(&open.mechanism, closed).iter().all(|gap| *gap < 1e-12));
            let far = closed.concat().iter().fold(0.0, |most: f64, q| most.max(q.abs()));
            assert!(far < 40.0 * fraction + 1e-12, "{seed} {fraction}: {far}");
        }
    }
    println!("{closes} of 180 close");
    assert!(closes > 175, "{closes}");
}

#[test]
fn contradictions_are_as_large_as_asked_for() {
    for size in [1e-4, 1.0, 1e4] {
        for fraction in [0.0, 1e-7, 1e-5, 1e-4] {
            for (seed, kind) in [(5, Kind::FourBar), (11, Kind::Cranks(3)), (4, Kind::SliderCrank)] {
                let mechanism = contradicting(seed, kind, size, fraction);
                let loops: Vec<_> = mechanism.joint_ids().collect();
                let (_, open) = close_as_far_as_possible(&mechanism, &at_zero(&mechanism), &loops);
                let part = open / size;
                assert!(part <= 2.0 * fraction + 1e-14 && part >= 0.1 * fraction, "{part:e}");
                // The scaled exact twin has the same m̄ as the drawn linkage.
                let exact = drawn_as(seed, kind);
                for touch in &exact.contacts {
                    let touch = Touch { point: touch.point * (size / exact.size), ..touch.clone() };
                    let got = exact.mass_of(&mechanism, &at_zero(&mechanism), &touch, Some(1e-2));
                    let off = got.finite().expect("finite") / touch.mass - 1.0;
                    println!("{kind:?} {size:e} m, {fraction:e}: open {part:.1e}, mass off {off:.1e}");
                    assert!(off.abs() <= 100.0 * fraction + 1e-11, "{off:e}");
                }
            }
        }
    }
}

#[test]
fn crank_rows_weigh_what_they_say() {
    for turned in [false, true] {
        let row = CrankRow {
            count: 4,
            length: 0.3,
            spacing: 0.4,
            angle: 1.1,
            turned,
            distance_from_origin: 0.7,
            crank_mass: 0.7,
            platform_mass: 2.0,
        };
        let mechanism = row.mechanism();
        let on = mechanism.find_link("platform").expect("a link");
        let x = percuss_oracle::maximal::poses(&mechanism, &at_zero(&mechanism))[on.index()];
        let normal = x.fixed_view::<3, 3>(0, 0) * row.motion();
        let answer = solve(&Question::new(&mechanism, at_zero(&mechanism), on, Vector3::zeros(), normal));
        assert_eq!(answer.degrees_of_freedom, 1);
        let mass = answer.outcome.finite().expect("finite");
        assert!((mass / row.along_the_motion() - 1.0).abs() < 1e-12, "{mass}");
    }
}
