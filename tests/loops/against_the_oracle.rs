//! Closed loops by both routes compared with route C: every linkage at many poses of its range, and random linkages;
//! one-sided and two-sided contacts, fixed and floating bases, with locks, held contacts and armatures.

use percuss_dynamics::{
    AssemblyError, Contact, Direction, EffectiveMass, Frame, Pose, Route, RouteChoice, System,
};
use percuss_mechanism::{ClosureKind, JointId, JointKind, Mechanism};
use percuss_oracle::maximal::{self, Answer, Outcome};
use percuss_oracle::{linkage, random};
use percuss_tests::gauge::Gauge;
use percuss_tests::imposed::Imposed;
use percuss_tests::judge::{near_at, states_enough};
use percuss_tests::motion::Motion;
use percuss_tests::rig::{Rig, positions, question};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

fn contact(rng: &mut StdRng, mechanism: &Mechanism) -> Contact {
    let (on, against, point, normal) = random::contact(rng, mechanism);
    let contact = Contact::new(on, point, normal).normal(Direction::Along(normal, Frame::World));
    against.map_or(contact, |other| contact.against(other))
}

/// Number of cases by outcome, and of excluded cases.
#[derive(Default, Debug)]
struct Count {
    finite: usize,
    immovable: usize,
    massless: usize,
    unclear: usize,
}

fn compare(
    (system, pose): (&System, &Pose),
    given: &Imposed,
    case: &str,
    rng: &mut StdRng,
    gauge: &mut Gauge,
    count: &mut Count,
) {
    let mechanism = system.mechanism();
    let contact = contact(rng, mechanism);
    let answer: Answer = maximal::solve(&given.ask(question(system, mechanism, pose, &contact)));
    let by = |choice| {
        pose.respond_by_route(&contact, choice).unwrap_or_else(|error| panic!("{case}, {choice:?}: {error}"))
    };
    let response = by(RouteChoice::Auto);
    let case = format!("{case}, {}", given.name);
    let rank = pose.rank();
    // Near a singular pose, or with a rank reduced by a lock or a hold, the routes may decide differently.
    let least = answer.singular_values.iter().copied().filter(|s| *s > answer.threshold).fold(1.0, f64::min);
    if !rank.clear || least < 1e-4 {
        count.unclear += 1;
        return;
    }
    assert_eq!(
        response.degrees_of_freedom, answer.degrees_of_freedom,
        "{case}: {:?}",
        answer.singular_values
    );
    if !response.singular_pose {
        assert_eq!(system.degrees_of_freedom(), answer.degrees_of_freedom, "{case}");
        assert_eq!(
            system.reference_or_open().redundant_constraints(),
            answer.redundant_constraints,
            "{case}: {rank:?} {:?}",
            answer.singular_values
        );
    }
    let routes = [Route::Dense, Route::Articulated].map(|route| by(RouteChoice::Only(route)));
    for response in [&response, &routes[0], &routes[1]] {
        let case = format!("{case}, {:?}", response.route);
        match (response.effective_mass, answer.outcome) {
            (EffectiveMass::Finite(a), Outcome::Finite(c)) => {
                // Rates that are fast at unit closing speed are differences of large terms.
                let fast = mechanism.characteristic_length() * Motion::of(response).size();
                gauge.relative(&case, a, c, near_at(pose) + 1e-12 * fast);
                let stated = response.effective_mass_error();
                let stated = stated.unwrap_or_else(|| panic!("{case}: {a} kg, {:?}", response.error)) / a;
                assert!(stated < 1e-5, "{case}: {stated:e}");
                // Route C has its own rounding error.
                assert!(states_enough(response, c, 1e-11), "{case}: {a} ± {stated:e}, route C {c}");
                count.finite += 1;
            }
            (EffectiveMass::Immovable, Outcome::Immovable) => count.immovable += 1,
            (EffectiveMass::Massless, Outcome::Massless) => count.massless += 1,
            (a, c) => panic!("{case}: {a:?}, route C {c:?}"),
        }
    }
}

#[test]
fn every_linkage_over_its_range() {
    let mut gauge = Gauge::new("both routes and route C, every linkage");
    let mut count = Count::default();
    let mut kinds = Vec::new();
    let mut barred = 0;
    for (number, (linkage, oracle)) in linkage::all().into_iter().zip(linkage::all()).enumerate() {
        let mut rng = StdRng::seed_from_u64(100 + number as u64);
        let rig = Rig::new(linkage);
        kinds.extend(rig.mechanism.closures().iter().map(|c| c.kind()));
        let start = rig.closed();
        let large = rig.mechanism.links().len() > 30;
        for i in 0..50 {
            let drivers: Vec<f64> = rig.range.iter().map(|r| rng.random_range(r[0]..r[1])).collect();
            // From the start pose: the range may bulge inwards between other points.
            let case = format!("{} at {drivers:.2?}", rig.name);
            let pose = match rig.move_drivers(&start, &drivers) {
                Ok(pose) => pose,
                Err(error) => {
                    // A corner of the range may be out of reach; the oracle must agree.
                    assert!(
                        oracle.move_drivers(&oracle.closed_start(), &drivers).is_err(),
                        "{case}: {error}"
                    );
                    barred += 1;
                    continue;
                }
            };
            assert!(rig.open(&pose) <= 1e-12, "{case}: {:e}", rig.open(&pose));
            let plain = Imposed::at_random(&mut rng, &rig.mechanism, 0);
            for _ in 0..2 {
                compare((&rig.system, &pose), &plain, &case, &mut rng, &mut gauge, &mut count);
            }
            if large && i % 5 > 0 {
                continue;
            }
            let given = Imposed::at_random(&mut rng, &rig.mechanism, i % 16);
            let system = rig.with(&given.conditions);
            let same =
                system.pose(&rig.guessed(&drivers, &positions(&rig.mechanism, &pose))).expect("closed");
            for (a, b) in pose.positions().iter().zip(same.positions()) {
                assert!((a - b).abs() < 1e-9, "{case}: {a} and {b}");
            }
            compare((&system, &same), &given, &case, &mut rng, &mut gauge, &mut count);
        }
    }
    for kind in ClosureKind::ALL {
        assert!(kinds.contains(&kind), "{kind:?} is missing");
    }
    gauge.report();
    println!("{count:?}, {barred} barred");
    assert!(barred < 25, "{barred}");
    assert!(count.finite > 3 * 1800 && count.immovable > 3 * 100, "{count:?}");
    assert!(count.unclear < 60, "{count:?}");
}

#[test]
fn random_linkages() {
    let mut gauge = Gauge::new("both routes and route C, random linkages");
    let mut count = Count::default();
    let (mut kinds, mut spherical, mut mimics) = (Vec::new(), 0, 0);
    for i in 0..240 {
        let mut rng = StdRng::seed_from_u64(4000 + i);
        let (mechanism, start) = random::linkage(&mut rng, 4 + i as usize % 7, 1 + i as usize % 3);
        if mechanism.closures().is_empty() {
            continue;
        }
        let mechanism = Arc::new(mechanism);
        let given = Imposed::at_random(&mut rng, &mechanism, i as usize % 16);
        let system = System::new(Arc::clone(&mechanism), &given.conditions).expect("conditions that fit");
        let case = format!("random linkage {i}");
        let pose = at_start(&system, &mechanism, &start).unwrap_or_else(|error| panic!("{case}: {error}"));
        let off = positions(&mechanism, &pose)
            .concat()
            .iter()
            .zip(start.concat())
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(off < 1e-6, "{case}: it left its start by {off:e}");
        kinds.extend(mechanism.closures().iter().map(|c| c.kind()));
        let bound = |kind| mechanism.joints().iter().filter(|j| j.kind() == kind).count();
        spherical += bound(JointKind::Spherical);
        mimics += mechanism.joints().iter().filter(|j| j.mimic().is_some()).count();
        for _ in 0..3 {
            compare((&system, &pose), &given, &case, &mut rng, &mut gauge, &mut count);
        }
    }
    for kind in ClosureKind::ALL {
        assert!(kinds.contains(&kind), "{kind:?} never came");
    }
    gauge.report();
    println!("{count:?}, {spherical} spherical joints, {mimics} mimics");
    assert!(count.finite > 3 * 300 && spherical > 20 && mimics > 20, "{count:?}");
}

/// The pose at closed positions: loops from guesses, with all independent joints set.
fn at_start(system: &System, mechanism: &Mechanism, start: &[Vec<f64>]) -> Result<Pose, AssemblyError> {
    let mut guesses = system.configuration();
    let own = |id: &JointId| mechanism.joint(*id).mimic().is_none() && mechanism.joint(*id).kind().dofs() > 0;
    for id in mechanism.joint_ids().filter(own) {
        guesses.guess(mechanism.joint(id).name(), &start[id.index()]).expect("a position that fits");
    }
    let mut set = guesses.clone();
    for id in mechanism.joint_ids().filter(own) {
        let mut more = set.clone();
        more.set(mechanism.joint(id).name(), &start[id.index()]).expect("a position that fits");
        match system.pose(&more) {
            Err(AssemblyError::Dependent { .. }) => {}
            // Not yet closed while other joints are at 0.
            Ok(_) | Err(_) => set = more,
        }
    }
    system.pose(&set)
}
