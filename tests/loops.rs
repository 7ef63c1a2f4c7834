//! Closed loops by route A against route C: every linkage at many poses of its range, random linkages; one- and
//! two-sided, on the ground and flying, with locks, held contacts and armatures.

use percuss_dynamics::{
    AssemblyError, Base, Conditions, Contact, Direction, EffectiveMass, Frame, Pose, RouteChoice, System,
};
use percuss_mechanism::{ClosureKind, JointId, JointKind, Mechanism};
use percuss_oracle::maximal::{self, Answer, Held, Outcome};
use percuss_oracle::{linkage, random};
use percuss_tests::gauge::Gauge;
use percuss_tests::rig::{Rig, positions, question};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

/// Conditions and what the oracle is told of them.
struct Imposed {
    conditions: Conditions,
    name: String,
    locked: Vec<JointId>,
    armature: Vec<(JointId, Vec<f64>)>,
    held: Vec<Held>,
}

/// A mixture: base, locks, armatures and holds, each now and then.
fn imposed(rng: &mut StdRng, mechanism: &Mechanism, variant: usize) -> Imposed {
    let base = if variant % 2 == 1 { Base::Floating } else { Base::Fixed };
    let mut all = Imposed {
        conditions: Conditions::new().base(base),
        name: format!("{base:?}"),
        locked: vec![],
        armature: vec![],
        held: vec![],
    };
    let movable = |id: &JointId| mechanism.joint(*id).kind().dofs() > 0;
    let joints: Vec<_> = mechanism.joint_ids().filter(movable).collect();
    if variant / 2 % 2 == 1 {
        let id = joints[rng.random_range(0..joints.len())];
        all.conditions = all.conditions.lock(mechanism.joint(id).name());
        all.name += &format!(", {} locked", mechanism.joint(id).name());
        all.locked.push(id);
    }
    if variant / 4 % 2 == 1 {
        let id = joints[rng.random_range(0..joints.len())];
        let values: Vec<f64> =
            (0..mechanism.joint(id).kind().dofs()).map(|_| rng.random_range(0.01..2.0)).collect();
        all.conditions = all.conditions.armature(mechanism.joint(id).name(), values.clone());
        all.name += ", armature";
        all.armature.push((id, values));
    }
    if variant / 8 % 2 == 1 {
        let (link, _, point, normal) = random::contact(rng, mechanism);
        let normal = rng.random_bool(0.7).then_some(normal);
        all.conditions = all.conditions.hold(mechanism.link(link).name(), point, normal);
        all.name += ", held";
        all.held.push(Held { link, point, normal });
    }
    all
}

fn contact(rng: &mut StdRng, mechanism: &Mechanism) -> Contact {
    let (on, against, point, normal) = random::contact(rng, mechanism);
    let contact = Contact::new(on, point, normal).normal(Direction::Along(normal, Frame::World));
    against.map_or(contact, |other| contact.against(other))
}

/// How often each outcome came, and what was not compared.
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
    let question = maximal::Question {
        locked: given.locked.clone(),
        armature: given.armature.clone(),
        held: given.held.clone(),
        ..question(system, mechanism, pose, &contact)
    };
    let answer: Answer = maximal::solve(&question);
    let strike = system.strike(pose, &contact, RouteChoice::Auto).expect("an answer");
    let case = format!("{case}, {}", given.name);
    let rank = system.rank_at(pose);
    // Near a singular pose, or where a lock or a hold makes one, the routes may decide differently.
    let least = answer.singular_values.iter().copied().filter(|s| *s > answer.threshold).fold(1.0, f64::min);
    if !rank.clear || least < 1e-4 {
        count.unclear += 1;
        return;
    }
    assert_eq!(strike.degrees_of_freedom, answer.degrees_of_freedom, "{case}: {:?}", answer.singular_values);
    if !strike.singular_pose {
        assert_eq!(system.degrees_of_freedom(), answer.degrees_of_freedom, "{case}");
        assert_eq!(
            system.redundant_constraints(),
            answer.redundant_constraints,
            "{case}: {rank:?} {:?}",
            answer.singular_values
        );
    }
    match (strike.effective_mass, answer.outcome) {
        (EffectiveMass::Finite(a), Outcome::Finite(c)) => {
            let said = strike.effective_mass_error.expect("finite") / a;
            gauge.relative(&case, a, c, 1e-9f64.max(said));
            assert!(said < 1e-5, "{case}: {said:e}");
            count.finite += 1;
        }
        (EffectiveMass::Immovable, Outcome::Immovable) => count.immovable += 1,
        (EffectiveMass::Massless, Outcome::Massless) => count.massless += 1,
        (a, c) => panic!("{case}: {a:?}, route C {c:?}"),
    }
}

#[test]
fn every_linkage_over_its_range() {
    let mut gauge = Gauge::new("route A and route C, every linkage");
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
            // From the start: ranges may bulge inwards between other points.
            let case = format!("{} at {drivers:.2?}", rig.name);
            let pose = match rig.go(&start, &drivers) {
                Ok(pose) => pose,
                Err(error) => {
                    // A corner of the ranges may be out of reach: the oracle must see it so too.
                    assert!(oracle.go(&oracle.closed_start(), &drivers).is_err(), "{case}: {error}");
                    barred += 1;
                    continue;
                }
            };
            assert!(rig.open(&pose) <= 1e-12, "{case}: {:e}", rig.open(&pose));
            let plain = imposed(&mut rng, &rig.mechanism, 0);
            for _ in 0..2 {
                compare((&rig.system, &pose), &plain, &case, &mut rng, &mut gauge, &mut count);
            }
            if large && i % 5 > 0 {
                continue;
            }
            let given = imposed(&mut rng, &rig.mechanism, i % 16);
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
    assert!(count.finite > 1800 && count.immovable > 100, "{count:?}");
    assert!(count.unclear < 60, "{count:?}");
}

#[test]
fn random_linkages() {
    let mut gauge = Gauge::new("route A and route C, random linkages");
    let mut count = Count::default();
    let (mut kinds, mut spherical, mut mimics) = (Vec::new(), 0, 0);
    for i in 0..240 {
        let mut rng = StdRng::seed_from_u64(4000 + i);
        let (mechanism, start) = random::linkage(&mut rng, 4 + i as usize % 7, 1 + i as usize % 3);
        if mechanism.closures().is_empty() {
            continue;
        }
        let mechanism = Arc::new(mechanism);
        let given = imposed(&mut rng, &mechanism, i as usize % 16);
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
    assert!(count.finite > 300 && spherical > 20 && mimics > 20, "{count:?}");
}

/// The pose at positions that are closed: loops by guess, and everything that does not follow set there.
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
            // Not yet closed while others are at 0.
            Ok(_) | Err(_) => set = more,
        }
    }
    system.pose(&set)
}
