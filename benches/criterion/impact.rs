//! Rigid impacts with all reactions, and impacts in time.

use criterion::{Criterion, criterion_group, criterion_main};
use percuss_benches::{CpuTime, criterion, double_wishbone, subjects};
use percuss_dynamics::{Contact, Pose};
use percuss_impact::{ImpactWorkspace, JointRates, RigidImpact, TimeConditions, impact_in_time};
use std::hint::black_box;

/// Penetration of the contact in time at 1 m/s, m.
const DEPTH: f64 = 0.002;

fn measure(criterion: &mut Criterion<CpuTime>, name: &str, pose: &Pose, contact: &Contact) {
    let response = pose.respond(contact).expect("a contact");
    let rigid = RigidImpact::new(pose, &response, 1.0, 0.3, None).expect("an impact");
    assert!(rigid.reactions.residual < 1e-9);
    criterion.bench_function(&format!("{name}/impact"), |bencher| {
        bencher.iter(|| {
            let response = black_box(pose).respond(contact).expect("a contact");
            black_box(RigidImpact::new(pose, &response, 1.0, 0.3, None))
        });
    });
    let mut workspace = ImpactWorkspace::new(pose);
    let mut here = workspace.at(pose);
    let again = here.impact(contact, 1.0, 0.3).expect("an impact");
    assert!((again.impulse / rigid.impulse - 1.0).abs() < 1e-9);
    criterion.bench_function(&format!("{name}/impact_in_workspace"), |bencher| {
        bencher.iter(|| black_box(here.impact(black_box(contact), 1.0, 0.3)));
    });
    let mut reused = RigidImpact::none();
    criterion.bench_function(&format!("{name}/impact_in_reused_memory"), |bencher| {
        bencher.iter(|| black_box(here.impact_into(black_box(contact), 1.0, 0.3, &mut reused)));
    });
    criterion.bench_function(&format!("{name}/impact_at_new_pose"), |bencher| {
        bencher.iter(|| black_box(workspace.at(black_box(pose)).impact_into(contact, 1.0, 0.3, &mut reused)));
    });
    let mass = response.effective_mass.kilograms().expect("a mass");
    let stiffness = mass / (DEPTH * DEPTH);
    let star = JointRates { joints: response.joint_velocities.clone(), base: response.base_velocity };
    let conditions = TimeConditions { ends_without_force: true, ..TimeConditions::default() };
    let force = |x: f64, _: f64| stiffness * x;
    let run = || impact_in_time(black_box(pose), contact, 1.0, &star, &force, &conditions);
    let found = run().expect("an end");
    assert!((found.max_penetration / DEPTH - 1.0).abs() < 0.1, "{}", found.max_penetration);
    criterion.bench_function(&format!("{name}/in_time"), |bencher| bencher.iter(|| black_box(run())));
}

fn impacts(criterion: &mut Criterion<CpuTime>) {
    let (system, contact, _) = double_wishbone();
    let pose = system.pose(&system.configuration()).expect("the start is in reach");
    measure(criterion, "double_wishbone", &pose, &contact);
    let arm = subjects().into_iter().find(|subject| subject.name == "six_r_arm").expect("the arm");
    let mut configuration = arm.system.configuration();
    for (k, joint) in arm.system.mechanism().joints().iter().enumerate() {
        if joint.kind().dofs() == 1 {
            configuration.set(joint.name(), &[0.3 + 0.2 * k as f64]).expect("a position");
        }
    }
    let pose = arm.system.pose(&configuration).expect("a pose");
    measure(criterion, "six_r_arm", &pose, &arm.contact);
}

criterion_group!(name = benches; config = criterion(); targets = impacts);
criterion_main!(benches);
