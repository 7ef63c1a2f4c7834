//! Inertia at the stop of a joint, on random trees, four-bars and slider-cranks: percuss against route C of the
//! oracle.

use nalgebra::Vector3;
use percuss_dynamics::{Conditions, Contact, EffectiveMass, RemarkFlags, System};
use percuss_formats::{LoadOptions, Source};
use percuss_mechanism::{JointId, JointKind, Limits, Mechanism};
use percuss_oracle::alter::{build_with_loops, describe, describe_loops};
use percuss_oracle::closed_form::{Crossing, FourBar, PlanarBody, SliderCrank};
use percuss_oracle::linkage::{Linkage, four_bar_of, slider_crank_of};
use percuss_oracle::maximal::{self, Outcome, Question};
use percuss_oracle::random;
use percuss_study::{
    DampingQuestion, GivenPosition, JointStop, MassQuestion, Model, PoseTable, StopEnd, damp_stop, mass,
    pose_at_stop,
};
use percuss_suspension::{TemplateOptions, template_sheet};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::PI;
use std::sync::Arc;

const TREES: usize = 40;
const LINKAGES: usize = 20;
/// Relative tolerance of the inertia. Both methods solve linear systems with condition numbers up to a few
/// thousand.
const AGREEMENT: f64 = 1e-9;

/// Model of the mechanism with limits at a joint.
fn limited(mechanism: &Mechanism, joint: &str, limits: Limits) -> Model {
    let (links, mut joints) = describe(mechanism);
    let of = joints.iter_mut().find(|j| j.name == joint).expect("a joint");
    of.limits = Some(limits);
    if of.kind == JointKind::Continuous {
        of.kind = JointKind::Revolute;
    }
    let (closures, couplings) = describe_loops(mechanism);
    let mechanism = build_with_loops("limited", links, joints, closures, couplings);
    Model {
        mechanism: Arc::new(mechanism),
        inputs: Vec::new(),
        shapes: Arc::default(),
        poses: Arc::default(),
        diagnostics: Vec::new(),
        origin: percuss_study::Origin::default(),
    }
}

/// Inertia by route C of the oracle: the effective mass of a random point of the child link against the parent
/// link, times the squared distance from the axis. The speed of the point is the distance times the joint rate.
fn by_the_oracle(
    rng: &mut StdRng,
    mechanism: &Mechanism,
    positions: &[Vec<f64>],
    joint: JointId,
    up: bool,
) -> Outcome {
    let joint = mechanism.joint(joint);
    let axis = if up { *joint.axis() } else { -joint.axis() };
    let anywhere = Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
    let (point, way, lever) = match joint.kind() {
        JointKind::Prismatic => (anywhere, axis, 1.0),
        _ => {
            let beside = axis.cross(&anywhere);
            let along = axis * rng.random_range(-0.5..0.5);
            (beside + along, axis.cross(&beside).normalize(), beside.norm())
        }
    };
    let turn =
        maximal::poses(mechanism, positions)[joint.child().index()].fixed_view::<3, 3>(0, 0).into_owned();
    let mut question = Question::new(mechanism, positions.to_vec(), joint.child(), point, turn * way);
    question.against = Some(joint.parent());
    match maximal::effective_mass(&question) {
        Outcome::Finite(mass) => Outcome::Finite(mass * lever * lever),
        other => other,
    }
}

/// Joint positions of percuss's result, in the oracle's layout.
fn positions_of(model: &Model, question: &MassQuestion) -> Vec<Vec<f64>> {
    let report = mass(model, question).expect("an answer");
    let mut positions = random::zero_positions(&model.mechanism);
    for (name, numbers) in report.pose.iter() {
        let joint = model.mechanism.find_joint(name).expect("a joint");
        positions[joint.index()] = numbers.to_vec();
    }
    positions
}

/// Question with positions and guesses of joints.
fn posed(set: Vec<(String, GivenPosition)>, guess: Vec<(String, GivenPosition)>) -> MassQuestion {
    MassQuestion { pose: PoseTable { set, guess, ..PoseTable::default() }, ..MassQuestion::default() }
}

fn set(name: &str, numbers: &[f64]) -> (String, GivenPosition) {
    (name.to_owned(), GivenPosition::from_numbers(numbers).expect("a position"))
}

/// Compares one stop. Returns true if there is a finite inertia.
fn compare(rng: &mut StdRng, model: &Model, stop: &JointStop, conditions: MassQuestion, case: &str) -> bool {
    let (question, _) = stop.question(model, conditions.clone()).expect(case);
    let positions = positions_of(model, &question);
    let joint = model.mechanism.find_joint(&stop.joint).expect("a joint");
    if let (Some(end), Some(limits)) = (stop.end, model.mechanism.joint(joint).limits()) {
        let at = if end == StopEnd::Lower { limits.lower } else { limits.upper };
        assert!((positions[joint.index()][0] - at).abs() < 1e-12, "{case}: not at its stop");
    }
    let up = stop.end != Some(StopEnd::Lower);
    let theirs = by_the_oracle(rng, &model.mechanism, &positions, joint, up);
    let Outcome::Finite(theirs) = theirs else {
        assert!(
            damp_stop(model, stop, conditions, &DampingQuestion::new(0.5, 1.0)).is_err(),
            "{case}: {theirs:?}"
        );
        return false;
    };
    let report = damp_stop(model, stop, conditions, &DampingQuestion::new(0.5, 1.0)).expect(case);
    let off = report.effective_mass / theirs - 1.0;
    assert!(
        off.abs() < AGREEMENT,
        "{case}: {} by percuss, {theirs} by route C: {off:e}",
        report.effective_mass
    );
    true
}

/// Both ends of the range of a joint.
fn ends(joint: &str) -> [JointStop; 2] {
    [StopEnd::Lower, StopEnd::Upper].map(|end| JointStop { joint: joint.to_owned(), end: Some(end) })
}

#[test]
fn trees_of_all_joints() {
    let mut rng = StdRng::seed_from_u64(20_261_122);
    let (mut turns, mut slides) = (0, 0);
    for number in 0..TREES {
        let bodies = rng.random_range(2..8);
        let tree = random::mechanism(&mut rng, bodies);
        let positions = random::positions(&mut rng, &tree);
        for id in tree.joint_ids() {
            let joint = tree.joint(id);
            let stops = matches!(joint.kind(), JointKind::Revolute | JointKind::Prismatic);
            if !stops || joint.mimic().is_some() {
                continue;
            }
            let limits = Limits { lower: rng.random_range(-1.5..0.0), upper: rng.random_range(0.0..1.5) };
            let model = limited(&tree, joint.name(), limits);
            let others: Vec<_> = tree
                .joint_ids()
                .filter(|other| *other != id && tree.joint(*other).mimic().is_none())
                .filter(|other| tree.joint(*other).kind().dofs() > 0)
                .map(|other| set(tree.joint(other).name(), &positions[other.index()]))
                .collect();
            for stop in ends(joint.name()) {
                let case = format!("tree {number}, {stop:?}");
                let conditions = posed(others.clone(), Vec::new());
                if compare(&mut rng, &model, &stop, conditions, &case) {
                    *if joint.kind() == JointKind::Prismatic { &mut slides } else { &mut turns } += 1;
                }
            }
        }
    }
    assert!(turns >= 60 && slides >= 20, "{turns} turns, {slides} slides");
}

fn body(rng: &mut StdRng) -> PlanarBody {
    let com = [(); 2].map(|()| rng.random_range(-0.2..0.4));
    PlanarBody::new(rng.random_range(0.5..6.0), com, rng.random_range(0.005..0.2))
}

/// Compares the crank at both ends of its range, and the follower joint at a random crank angle, stopped in the
/// positive direction. Returns the number of comparisons.
fn stopped(rng: &mut StdRng, linkage: &Linkage, follower: &str, case: &str) -> usize {
    let given = |name: &str| linkage.start.iter().find(|(of, _)| *of == name).expect("a joint").1[0];
    let theta = given("crank_hinge");
    let limits =
        Limits { lower: theta - rng.random_range(0.1..1.0), upper: theta + rng.random_range(0.1..1.0) };
    let model = limited(&linkage.mechanism, "crank_hinge", limits);
    let others = linkage.start.iter().filter(|(name, _)| *name != "crank_hinge");
    let guess: Vec<_> = others.map(|(name, numbers)| set(name, numbers)).collect();
    let mut compared = 0;
    for stop in ends("crank_hinge") {
        let conditions = posed(Vec::new(), guess.clone());
        compared += usize::from(compare(rng, &model, &stop, conditions, &format!("{case}, {stop:?}")));
    }
    let stop = JointStop { joint: follower.to_owned(), end: None };
    let at = vec![set("crank_hinge", &[rng.random_range(limits.lower..limits.upper)])];
    let conditions = posed(at, guess);
    compared + usize::from(compare(rng, &model, &stop, conditions, &format!("{case}, {stop:?}")))
}

#[test]
fn four_bars_and_slider_cranks() {
    let mut rng = StdRng::seed_from_u64(20_261_123);
    let mut compared = 0;
    for number in 0..LINKAGES {
        let crank = rng.random_range(0.1..0.3);
        let theta = rng.random_range(-PI..PI);
        let bodies = [(); 3].map(|()| body(&mut rng));
        // The crank is less than half as long as the other bars, so the crank turns fully.
        let [ground, coupler, rocker] = [(); 3].map(|()| crank * rng.random_range(2.2..3.0));
        let crossing = if rng.random_bool(0.5) { Crossing::Left } else { Crossing::Right };
        let bar = FourBar { ground, crank, coupler, rocker };
        let four_bar = four_bar_of("four_bar", bar, bodies, crossing, theta, [-PI, PI]);
        compared += stopped(&mut rng, &four_bar, "rocker_hinge", &format!("four-bar {number}"));

        let bodies = [(); 3].map(|()| body(&mut rng));
        let engine = SliderCrank {
            crank,
            rod: crank * rng.random_range(1.6..3.0),
            offset: crank * rng.random_range(-0.4..0.4),
        };
        let engine = slider_crank_of("slider_crank", engine, bodies);
        compared += stopped(&mut rng, &engine, "guide", &format!("slider-crank {number}"));
    }
    assert_eq!(compared, 6 * LINKAGES);
}

/// The pose at a stop has the mass of the command and a closed gap; as drawn the gap is open, in the response of the pose, in a workspace, in a
/// batch and on a path of the drivers.
#[test]
fn the_pose_at_a_stop_is_that_of_the_question() {
    let (mut stops, mut paths) = (0, 0);
    for template in ["double-wishbone", "macpherson-strut", "semi-trailing-arm"] {
        let sheet = template_sheet(template, &TemplateOptions::default()).expect("a template");
        let model = Model::from_source(&Source::from_text("corner.toml", sheet), &LoadOptions::default());
        let model = model.expect("a model");
        let system = System::new(Arc::clone(&model.mechanism), &Conditions::default()).expect("a system");
        for stop in
            model.mechanism.contacts().iter().filter(|contact| contact.gap().is_some_and(|gap| gap > 0.0))
        {
            let question = MassQuestion::default().at_contact(stop.name());
            let expected = mass(&model, &question).expect("a touch");
            let (touch, contact) =
                pose_at_stop(&system, &system.configuration(), stop.name()).expect("a touch");
            let response = touch.respond(&contact).expect("a contact");
            let EffectiveMass::Finite(found) = response.effective_mass else {
                panic!("{template}: {response:?}")
            };
            assert_eq!(Some(found), expected.effective_mass, "{template}: {}", stop.name());
            assert_eq!(contact, Contact::named(stop, model.mechanism.root()));
            let drawn = system.pose(&system.configuration()).expect("a pose");
            let drivers = drawn.loops().map_or_else(Vec::new, |loops| loops.drivers.clone());
            for (pose, is_open) in [(&touch, false), (&drawn, true)] {
                let expected = if is_open { RemarkFlags::OPEN_GAP } else { RemarkFlags::NONE };
                let own =
                    |flags: RemarkFlags| RemarkFlags::from_bits(flags.bits() & RemarkFlags::OPEN_GAP.bits());
                assert_eq!(own(pose.respond(&contact).expect("a contact").remark_flags()), expected);
                let mut workspace = pose.assembly().workspace();
                workspace.set_positions(pose.positions()).expect("positions");
                let _ = workspace.effective_mass(&contact).expect("a contact");
                assert_eq!(own(workspace.remarks()), expected);
                let mut batch = pose.assembly().batch(&contact).expect("a contact");
                assert_eq!(own(batch.effective_mass(pose.positions()).expect("positions").remarks), expected);
                if let Some(mut path) = pose.driven_path(&contact, &drivers).expect("a contact") {
                    let values: Vec<f64> = drivers.iter().map(|joint| pose.joint(*joint)[0]).collect();
                    let (mut answers, mut positions) = (Vec::new(), Vec::new());
                    assert_eq!(path.follow(&values, &mut answers, &mut positions), 1);
                    assert_eq!(own(answers[0].remarks), expected);
                    paths += 1;
                }
            }
            stops += 1;
        }
    }
    assert!(stops >= 3 && paths >= 1, "{stops} stops, {paths} paths");
}
