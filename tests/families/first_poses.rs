//! Properties of a file's loops before the first requested pose: the first closed pose, and the floor of the rank
//! decisions.

use nalgebra::{Rotation3, Unit, Vector3};
use percuss_dynamics::{Conditions, Contact, Direction, EffectiveMass, System};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use percuss_oracle::alter;
use percuss_oracle::linkage::family::drawn;
use percuss_spatial::Transform;
use percuss_tests::rig::mass;
use std::sync::Arc;

const COUNT: u64 = 120;

fn system(mechanism: Mechanism) -> System {
    System::new(Arc::new(mechanism), &Conditions::new()).expect("a system")
}

/// Linkage of a seed with a loop hinge drawn rotated, and another loop joint declared as driver: closed with the driver
/// at 0, but not with all joints at 0. `None` if the mobility differs or two such joints do not exist.
fn drawn_turned(seed: u64) -> Option<Mechanism> {
    let drawn = drawn(seed);
    let turns = |id: &JointId| drawn.mechanism.joint(*id).kind() == JointKind::Continuous;
    let mut hinges = drawn.loop_joints.iter().filter(|id| turns(id));
    let (driver, turned) = (hinges.next()?, hinges.next()?);
    if drawn.mobility != 1 {
        return None;
    }
    let (links, mut joints) = alter::describe(&drawn.mechanism);
    joints[driver.index()].independent = Some(true);
    let hinge = &mut joints[turned.index()];
    let turn = Rotation3::from_axis_angle(&Unit::new_normalize(hinge.axis), 0.3).into_inner();
    hinge.origin = hinge.origin * Transform::new(turn, Vector3::zeros());
    let (closures, couplings) = alter::describe_loops(&drawn.mechanism);
    Some(alter::build_with_loops("turned", links, joints, closures, couplings))
}

/// A new workspace has the positions of the first closed pose; with all joints at 0 the loops are open.
#[test]
fn a_new_workspace_is_at_the_closed_pose() {
    let (mut asked, mut others) = (0, 0);
    for (seed, mechanism) in (0..COUNT).filter_map(|seed| Some((seed, drawn_turned(seed)?))) {
        let links: Vec<_> = mechanism.link_ids().skip(1).collect();
        let system = system(mechanism);
        let Ok(pose) = system.pose(&system.configuration()) else { continue };
        let (mut fresh, mut zero) = (system.workspace(), system.workspace());
        zero.set_positions(&vec![0.0; pose.positions().len()]).expect("as many");
        for link in links {
            let contact = Contact::new(link, [0.1, 0.2, 0.05], [0.3, 0.9, 0.2]);
            let there = pose.respond(&contact).expect("an answer").effective_mass;
            let answers = [&mut fresh, &mut zero].map(|workspace| workspace.effective_mass(&contact));
            let (EffectiveMass::Finite(there), [Ok(first), at_zero]) = (there, answers) else { continue };
            let EffectiveMass::Finite(first) = first else { panic!("seed {seed}: {first:?}, {there} kg") };
            assert!((first / there - 1.0).abs() < 1e-6, "seed {seed}: {first} kg, at the pose {there} kg");
            asked += 1;
            let same = matches!(at_zero, Ok(EffectiveMass::Finite(m)) if (m / there - 1.0).abs() < 1e-3);
            others += usize::from(!same);
        }
    }
    assert!(asked > 100 && others > 50, "{others} of {asked} are others with all joints at 0");
}

/// Poses of a rounded file are inexact by different amounts; one floor, from the worst pose, decides all ranks.
#[test]
fn ranks_of_rounded_files_are_those_of_their_exact_twins() {
    let mut asked = 0;
    for seed in 0..60 {
        let drawn = drawn(seed);
        let ranks = |mechanism| system(mechanism).reference_or_open().group_ranks();
        let exact = ranks(drawn.written(15));
        for decimals in [9, 7, 6, 5, 4] {
            let file = system(drawn.written(decimals));
            let assembly = file.reference_or_open();
            assert_eq!(assembly.group_ranks(), exact, "{}, {decimals} decimals", drawn.label());
            assert_eq!(
                assembly.degrees_of_freedom(),
                drawn.mobility,
                "{}, {decimals} decimals",
                drawn.label()
            );
            assert_eq!(
                assembly.redundant_constraints(),
                drawn.redundant,
                "{}, {decimals} decimals",
                drawn.label()
            );
            // The rank at the pose itself.
            let pose = file.pose(&file.configuration()).expect("a pose");
            assert_eq!(
                pose.rank().rank,
                exact.iter().sum::<usize>(),
                "{}, {decimals} decimals",
                drawn.label()
            );
            asked += 1;
        }
    }
    assert_eq!(asked, 300);
}

/// A normal along a line of 1 µm turns with the full misfit of its ends: the file part of the error includes this.
#[test]
fn the_error_of_a_short_line_is_that_of_its_ends() {
    let (mut asked, mut measured, mut wrong) = (0, 0, 0);
    for seed in 0..40 {
        let drawn = drawn(seed);
        let (exact, file) = (system(drawn.written(15)), system(drawn.written(6)));
        let [exact_pose, file_pose] = [&exact, &file].map(|s| s.pose(&s.configuration()).expect("a pose"));
        for touch in &drawn.contacts {
            // Towards the root, at a distance of a micrometre and of a metre.
            let root = drawn.mechanism.root();
            let at =
                exact_pose.locate(&Contact::new(touch.link, touch.point, touch.normal)).expect("a contact");
            let toward = |length: f64| {
                let end = at.point_world + at.normal_world * length;
                Contact::new(touch.link, touch.point, touch.normal)
                    .normal(Direction::TurningToward(root, end))
            };
            let long = file_pose.respond(&toward(1.0)).expect("an answer");
            let short = file_pose.respond(&toward(1e-6)).expect("an answer");
            let twin = exact_pose.respond(&toward(1e-6)).expect("an answer");
            let finite =
                |r: &percuss_dynamics::ContactResponse| matches!(r.effective_mass, EffectiveMass::Finite(_));
            if ![&long, &short, &twin].into_iter().all(finite) {
                continue;
            }
            let part =
                |r: &percuss_dynamics::ContactResponse| r.error.and_then(|e| e.file).map(|e| e / mass(r));
            let (Some(of_long), Some(of_short)) = (part(&long), part(&short)) else { continue };
            asked += 1;
            if file_pose.loops().is_some_and(|l| l.inexactness > 0.0) {
                measured += 1;
                assert!(of_short > 1e3 * of_long, "{}: {of_short:e} and {of_long:e}", drawn.label());
            }
            let known = short.effective_mass_error().unwrap_or(f64::INFINITY);
            wrong += usize::from((mass(&short) - mass(&twin)).abs() > known + 1e-9 * mass(&twin));
        }
    }
    assert!(
        asked > 50 && measured > 50 && wrong == 0,
        "{asked} asked, {measured} measured, {wrong} exceeded"
    );
}
