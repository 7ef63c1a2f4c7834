//! Paths of drivers in SIMD lanes: each row has the pose and the result of the general method.

use percuss_dynamics::{Conditions, Contact, Direction, EffectiveMass, PathAnswer, Pose, System};
use percuss_formats::{LoadOptions, Source, load};
use percuss_mechanism::{Inertial, JointDescription, JointId, JointKind, LinkDescription};
use percuss_oracle::alter;
use percuss_oracle::linkage::Linkage;
use percuss_tests::rig::Rig;
use percuss_tests::subjects::{Subject, of_linkages};

/// Statistics of a family.
#[derive(Debug, Default)]
struct Seen {
    linkages: usize,
    rows: usize,
    in_lanes: usize,
    answered: usize,
    /// Largest difference as a fraction of the sum of both errors.
    worst: f64,
    /// Largest residual, m.
    open: f64,
}

/// Steps of a driver with one position, forwards and backwards, small and large.
fn rows(start: f64) -> Vec<f64> {
    let steps = (1..=40).map(|k| 1e-3 * f64::from(k)).chain((1..=12).map(|k| 0.04 - 0.01 * f64::from(k)));
    steps.chain([0.3, -0.3, 0.31]).map(|step| start + step).collect()
}

fn driver(pose: &Pose) -> Option<JointId> {
    let of_one = |id: &&JointId| pose.joint(**id).len() == 1;
    pose.loops()?.drivers.iter().find(of_one).copied()
}

/// The pose at one more row, by the general method.
fn general(subject: &Subject, pose: &Pose, joint: JointId, value: f64) -> Option<Pose> {
    let mut configuration = subject.system.configuration();
    let in_loops = &pose.loops()?.drivers;
    for id in pose.mechanism().joint_ids().filter(|id| pose.joint(*id).len() == 1) {
        let mover = pose.mechanism().joint(id);
        let stays = in_loops.contains(&id) || !subject.system.is_bound(id) && mover.mimic().is_none();
        if stays {
            let at = if id == joint { value } else { pose.joint(id)[0] };
            configuration.set(mover.name(), &[at]).ok()?;
        }
    }
    pose.assembly().pose_from(pose, &configuration).ok()
}

fn check(subject: &Subject, seen: &mut Seen) {
    let Subject { name, pose, contact, .. } = subject;
    let Some(joint) = driver(pose) else { return };
    let Some(mut path) = pose.driven_path(contact, &[joint]).expect("a contact that fits") else { return };
    seen.linkages += 1;
    let rows = rows(pose.joint(joint)[0]);
    let (mut here, mut done) = (pose.clone(), 0);
    while done < rows.len() {
        let (mut answers, mut positions) = (Vec::new(), Vec::new());
        let followed = path.follow(&rows[done..], &mut answers, &mut positions);
        assert_eq!(followed, answers.len());
        for (answer, own) in answers.iter().zip(positions.chunks(pose.positions().len())) {
            let Some(next) = general(subject, &here, joint, rows[done]) else {
                panic!("{name}, {}: the general way does not get there", rows[done])
            };
            compare(name, &next, answer, own, contact, seen);
            (here, done) = (next, done + 1);
        }
        seen.rows += followed;
        seen.in_lanes += followed;
        if done == rows.len() {
            break;
        }
        seen.rows += 1;
        // The uncertain row, by the general method from the last pose of the path.
        match general(subject, &path.pose(), joint, rows[done]) {
            Some(next) if path.restart(&next) => here = next,
            _ => return,
        }
        done += 1;
    }
}

fn compare(
    name: &str,
    pose: &Pose,
    answer: &PathAnswer,
    positions: &[f64],
    contact: &percuss_dynamics::Contact,
    seen: &mut Seen,
) {
    let Some((mass, error)) = answer.mass else { return };
    let response = pose.respond(contact).expect("an answer");
    let EffectiveMass::Finite(expected) = response.effective_mass else {
        panic!("{name}: {answer:?} for {:?}", response.effective_mass)
    };
    seen.open = seen.open.max(answer.residual);
    seen.answered += 1;
    let allowed = error + response.effective_mass_error().expect("an error");
    seen.worst = seen.worst.max((mass - expected).abs() / allowed);
    assert!((mass - expected).abs() <= allowed, "{name}: {answer:?} for {expected}, allowed {allowed:e}");
    for (joint, own) in pose.mechanism().joint_ids().zip(ranges(pose)) {
        // Balls may spin freely about their rods, and the spin depends on the steps.
        if pose.joint(joint).len() == 1 {
            let (got, wanted) = (positions[own.start], pose.joint(joint)[0]);
            assert!((got - wanted).abs() < 1e-9, "{name}: {got} for {wanted}");
        }
    }
}

fn ranges(pose: &Pose) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
    let mut next = 0;
    pose.mechanism().joints().iter().map(move |joint| {
        let start = next;
        next += joint.kind().positions();
        start..next
    })
}

/// The double wishbone of the distribution over its travel, with the contact of its bump stop along a line: the path
/// follows every row.
#[test]
fn the_shipped_wishbone_is_followed() {
    let text = include_str!("../../models/double_wishbone.urdf");
    let source = Source::from_text("double_wishbone.urdf", text);
    let mechanism = load(&source, &LoadOptions::default()).expect("a good file").mechanism;
    let link = |name: &str| mechanism.find_link(name).expect("a link of the model");
    let contact = Contact::new(link("bump_stop_pad"), [0.0; 3], [0.0, 0.0, 1.0])
        .against(link("chassis"))
        .normal(Direction::TurningToward(link("bump_stop"), [0.0; 3].into()));
    let joint = mechanism.find_joint("lower_arm_hinge").expect("a joint of the model");
    let system = System::new(mechanism, &Conditions::new()).expect("default conditions fit");
    let pose = system.pose(&system.configuration()).expect("closed");
    let mut path = pose.driven_path(&contact, &[joint]).expect("a contact that fits").expect("a linkage");
    let rows: Vec<f64> = (0..400).map(|k| f64::from(k) * 5e-4).collect();
    let (mut answers, mut positions) = (Vec::new(), Vec::new());
    assert_eq!(path.follow(&rows, &mut answers, &mut positions), rows.len());
    let answered = answers.iter().filter(|answer| answer.mass.is_some()).count();
    println!("{answered} of {} rows answered in lanes", rows.len());
}

/// Random linkages along a driver: SIMD rows have the poses of the general method from row to row.
#[test]
fn rows_in_lanes_have_the_poses_of_the_general_method() {
    let mut seen = Seen::default();
    for subject in of_linkages(47, 120) {
        check(&subject, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.linkages > 60 && seen.in_lanes * 2 > seen.rows, "{seen:?}");
}

/// Mimics of a driver or of a dependent joint follow their master in every row.
#[test]
fn mimics_follow_in_lanes() {
    let four_bar = percuss_oracle::linkage::branching(1).linkage;
    let (mut links, mut joints) = alter::describe(&four_bar.mechanism);
    let (closures, couplings) = alter::describe_loops(&four_bar.mechanism);
    for (name, parent, master, factor, offset) in
        [("needle", "crank", "crank_hinge", 2.0, 0.3), ("pointer", "rocker", "rocker_hinge", -0.7, 0.1)]
    {
        links.push(LinkDescription::new(name, Inertial::diagonal(0.3, [0.1, 0.02, 0.0], [1e-3, 2e-3, 2e-3])));
        let joint = JointDescription::new(format!("{name}_hinge"), JointKind::Continuous, parent, name);
        joints.push(joint.at([0.05, 0.0, 0.0]).axis([0.0, 0.0, 1.0]).mimic(master, factor, offset));
    }
    let mechanism = alter::build_with_loops("mimics", links, joints, closures, couplings);
    let rig = Rig::new(Linkage { mechanism, ..four_bar });
    let start = rig.closed();
    let value = rig.start_drivers()[0];
    let contact = rig.contact("rocker", [0.1, 0.05, 0.0], [0.3, 0.8, 0.1].into());
    let path = start.driven_path(&contact, &[rig.joint("crank_hinge")]).expect("a contact");
    let mut path = path.expect("a linkage in lanes");
    let rows: Vec<f64> = (0..40).map(|k| value + 1e-3 * f64::from(k)).collect();
    let (mut answers, mut positions) = (Vec::new(), Vec::new());
    assert_eq!(path.follow(&rows, &mut answers, &mut positions), rows.len());
    for (row, own) in rows.iter().zip(positions.chunks(start.positions().len())) {
        let pose = rig.reach(&start, &[*row]);
        for (got, wanted) in own.iter().zip(pose.positions()) {
            assert!((got - wanted).abs() < 1e-11, "{row}: {own:?} for {:?}", pose.positions());
        }
    }
}
