//! Floating robots with held feet, some with more than 40 degrees of freedom: lanes agree with poses within the errors stated by both.

use nalgebra::Vector3;
use percuss_dynamics::{Base, BatchPositions, Conditions, Contact, EffectiveMass, RowResults, System};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::{Transform, rotation_about};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::PI;

const ROWS: usize = 9;

fn any(rng: &mut StdRng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))
}

fn link(rng: &mut StdRng, name: &str, mass: f64) -> LinkDescription {
    let inertial =
        Inertial { mass, com: any(rng) * 0.05, about_com: nalgebra::Matrix3::identity() * mass * 0.01 };
    LinkDescription::new(name, inertial)
}

/// Body with several limbs of hinges and some slides; `lightest` is the mass (kg) of the last link of a limb.
fn robot(rng: &mut StdRng, limbs: &[usize], lightest: f64) -> Mechanism {
    let mut builder = MechanismBuilder::new("robot").link(link(rng, "body", 15.0));
    for (limb, joints) in limbs.iter().enumerate() {
        let mut parent = String::from("body");
        for at in 0..*joints {
            let name = format!("limb_{limb}_{at}");
            let mass = 4.0 * (lightest / 4.0).powf(at as f64 / *joints as f64);
            let kind = if rng.random_bool(0.1) { JointKind::Prismatic } else { JointKind::Revolute };
            let mut joint = JointDescription::new(format!("joint_{limb}_{at}"), kind, &parent, &name);
            joint.axis = any(rng).normalize();
            joint.origin = Transform::new(
                rotation_about(&any(rng).normalize(), rng.random_range(-PI..PI)),
                any(rng) * 0.2,
            );
            builder = builder.link(link(rng, &name, mass)).joint(joint);
            parent = name;
        }
    }
    builder.build().expect("a robot").mechanism
}

#[test]
fn lanes_agree_with_poses() {
    let mut rng = StdRng::seed_from_u64(61);
    let (mut answers, mut in_lanes, mut worst, mut most) = (0, 0, 0.0_f64, 0);
    for k in 0..60 {
        let limbs: Vec<usize> = (0..rng.random_range(2..9)).map(|_| rng.random_range(2..10)).collect();
        let mechanism = robot(&mut rng, &limbs, [1.0, 1e-3][k % 2]);
        let mut conditions = Conditions::new().base(Base::Floating);
        for limb in 1..2 + k % limbs.len().min(3) {
            if let Some(joints) = limbs.get(limb) {
                let normal = rng.random_bool(0.3).then(|| any(&mut rng));
                conditions =
                    conditions.hold(format!("limb_{limb}_{}", joints - 1), any(&mut rng) * 0.1, normal);
            }
        }
        let foot = mechanism.find_link(&format!("limb_0_{}", limbs[0] - 1)).expect("a foot");
        let contact = Contact::new(foot, any(&mut rng) * 0.1, any(&mut rng));
        let system = System::new(mechanism, &conditions).expect("conditions that fit");
        let batch = system.reference_or_open().batch(&contact).expect("a contact that fits");
        let width: usize = limbs.iter().sum();
        most = most.max(width + 6);
        assert!(batch.has_lanes(), "robot {k} of {width} joints");
        let rows: Vec<f64> = (0..ROWS * width).map(|_| rng.random_range(-1.0..1.0)).collect();
        let positions = BatchPositions::Rows { values: &rows, stride: width };
        let mut results = RowResults::new(ROWS);
        batch.run(positions, results.columns(), ROWS).expect("enough numbers");
        in_lanes += results.remarks.iter().filter(|bits| **bits == batch.remarks().bits()).count();
        for (row, (mass, error)) in rows.chunks(width).zip(results.masses.iter().zip(&results.errors)) {
            let mut configuration = system.configuration();
            for (joint, x) in system.mechanism().joints().iter().zip(row) {
                configuration.set(joint.name(), &[*x]).expect("a position");
            }
            let response = system.pose(&configuration).expect("a tree").respond(&contact).expect("an answer");
            let EffectiveMass::Finite(expected) = response.effective_mass else { continue };
            answers += 1;
            // Rows that no lane computes state no error; those of poses are then allowed twice.
            let own = response.effective_mass_error().expect("an error");
            let allowed = if error.is_nan() { 2.0 * own + 1e-11 * expected } else { error + own };
            worst = worst.max((mass - expected).abs() / allowed);
            assert!(
                (mass - expected).abs() <= allowed,
                "robot {k}: {mass} for {expected}, allowed {allowed:e}"
            );
        }
    }
    println!(
        "{in_lanes} of {answers} rows in lanes, {most} coordinates at most, {worst:.1e} of the stated errors"
    );
    assert!(in_lanes * 10 > answers * 9 && most > 40, "{in_lanes} of {answers} rows in lanes, {most}");
}
