//! Reference files of closed linkages, read from their own folders: percuss compared with the oracle's route C at
//! random poses.
//!
//! `percuss-reference SUITE FILE.urdf …` prints a line per file, the number of finite contacts of the suite solved by
//! the recursion, then `N passed, N failed`; a run without any test fails.

use percuss_dynamics::{Conditions, Contact, Direction, EffectiveMass, Frame, Pose, System};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions, Source, load};
use percuss_mechanism::{JointId, Mechanism};
use percuss_oracle::maximal::{Outcome, Question, solve};
use percuss_oracle::random;
use percuss_tests::motion::Motion;
use percuss_tests::routes::Routes;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::process::ExitCode;
use std::sync::Arc;

/// Configurations per file, and contacts per configuration.
const CONFIGURATIONS: usize = 50;
const CONTACTS: usize = 5;
/// Both results are accurate to 1e-11 or better on these files.
const TOLERANCE: f64 = 1e-9;
/// Relative rounding of a result with unit speed: a motion that, at unit closing speed, moves the mechanism's size at
/// unit speed.
const ROUNDINGS: f64 = 1e-14;
/// Factor from a file's inexactness (relative to its size) to the error of a result at unit speed.
const INEXACTNESSES: f64 = 10.0;
/// Limit of the least over the largest singular value of A: closer to a singular pose, other tests apply.
const REGULAR: f64 = 1e-4;

#[derive(Default)]
struct Tally {
    passed: usize,
    failed: usize,
    worst: f64,
    routes: Routes,
}

fn main() -> ExitCode {
    let mut total = Tally::default();
    let mut arguments = std::env::args().skip(1);
    let suite = arguments.next().unwrap_or_default();
    for path in arguments {
        match compare(&path, &mut total.routes) {
            Ok(tally) => {
                println!(
                    "{path}: {} agree, {} do not, worst {:.1e}",
                    tally.passed, tally.failed, tally.worst
                );
                total.passed += tally.passed;
                total.failed += tally.failed;
            }
            Err(message) => {
                println!("{path}: FAILED: {message}");
                total.failed += 1;
            }
        }
    }
    println!("\n{}\n{}\n", Routes::HEADER, total.routes.line(&suite));
    println!("{} passed, {} failed", total.passed, total.failed);
    if total.failed == 0 && total.passed > 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn compare(path: &str, routes: &mut Routes) -> Result<Tally, String> {
    let source = Source::read(path, DEFAULT_MAX_SIZE).map_err(|e| e.to_string())?;
    let mechanism = load(&source, &LoadOptions::default()).map_err(|e| e.to_string())?.mechanism;
    let mechanism = Arc::new(mechanism);
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).map_err(|e| e.to_string())?;
    let home = system.pose(&system.configuration()).map_err(|e| e.to_string())?;
    let drivers = drivers(&mechanism, &home);
    let mut rng = StdRng::seed_from_u64(2411);
    let mut tally = Tally::default();
    let mut posed = 0;
    for attempt in 0..40 * CONFIGURATIONS {
        if posed == CONFIGURATIONS {
            break;
        }
        // Half of the attempts stay near the initial pose, which every linkage can reach.
        let reach = if attempt % 2 == 0 { 0.3 } else { 1.5 };
        let mut configuration = system.configuration();
        for &joint in &drivers {
            let value = home.joint(joint)[0] + rng.random_range(-reach..reach);
            configuration.set(mechanism.joint(joint).name(), &[value]).map_err(|e| e.to_string())?;
        }
        let Ok(pose) = system.pose(&configuration) else { continue };
        let mut regular = true;
        for _ in 0..CONTACTS {
            regular &= contact(&mechanism, &pose, &mut rng, &mut tally);
        }
        posed += usize::from(regular);
    }
    routes.add(&tally.routes);
    if posed < CONFIGURATIONS {
        return Err(format!("only {posed} of {CONFIGURATIONS} configurations were reached"));
    }
    Ok(tally)
}

/// Driving joints with one position: drivers of the loops, and joints outside the loops.
fn drivers(mechanism: &Mechanism, home: &Pose) -> Vec<JointId> {
    let loops = home.loops();
    let in_loops = |id: &JointId| loops.is_none_or(|l| l.drivers.contains(id));
    mechanism
        .joint_ids()
        .filter(|id| mechanism.joint(*id).kind().positions() == 1 && mechanism.joint(*id).mimic().is_none())
        .filter(in_loops)
        .collect()
}

/// Compares one contact; false if the pose is too close to a singular pose.
fn contact(mechanism: &Arc<Mechanism>, pose: &Pose, rng: &mut StdRng, tally: &mut Tally) -> bool {
    let (on, against, point, normal) = random::contact(rng, mechanism);
    let positions: Vec<Vec<f64>> = mechanism.joint_ids().map(|id| pose.joint(id).to_vec()).collect();
    let mut question = Question::new(mechanism, positions, on, point, normal);
    question.against = against;
    let answer = solve(&question);
    let counted = answer.singular_values.iter().filter(|v| **v > answer.threshold);
    if counted.fold(1.0, |least: f64, v| least.min(*v)) < REGULAR {
        return false;
    }
    let ours = Contact { link: on, against, point, normal: Direction::Along(normal, Frame::World) };
    let response = match pose.respond(&ours) {
        Ok(response) => response,
        Err(error) => {
            println!("    {error}");
            tally.failed += 1;
            return true;
        }
    };
    tally.routes.count(&response);
    let deviation = match (response.effective_mass, answer.outcome) {
        (EffectiveMass::Finite(a), Outcome::Finite(c)) => (a / c - 1.0).abs(),
        (EffectiveMass::Immovable, Outcome::Immovable) | (EffectiveMass::Massless, Outcome::Massless) => 0.0,
        (a, c) => {
            println!("    {a:?} beside {c:?}");
            f64::INFINITY
        }
    };
    let same_freedom = response.degrees_of_freedom == answer.degrees_of_freedom;
    // The closing speed of a gap that hardly closes is a small difference of fast motions.
    let length = mechanism.characteristic_length();
    let fast = 1.0 + length * Motion::of(&response).size();
    let inexact = pose.loops().map_or(0.0, |l| l.inexactness) / length;
    let bound = TOLERANCE + fast * (ROUNDINGS + INEXACTNESSES * inexact);
    if deviation <= bound && same_freedom {
        tally.passed += 1;
    } else {
        println!(
            "    {deviation:.1e} off; {} and {} degrees of freedom",
            response.degrees_of_freedom, answer.degrees_of_freedom
        );
        tally.failed += 1;
    }
    tally.worst = tally.worst.max(deviation);
    true
}
