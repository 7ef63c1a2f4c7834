//! Conventions of positions and velocities: route C compared with the joint space from finite differences of poses, and
//! massless links with armatures.

use nalgebra::{DMatrix, DVector, Matrix4, Quaternion, UnitQuaternion, Vector3};
use percuss_mechanism::{JointDescription, JointKind, LinkDescription, Mechanism};
use percuss_oracle::alter::build;
use percuss_oracle::maximal::{Question, effective_mass, poses};
use percuss_oracle::{random, zoo};
use percuss_spatial::{Transform, plane_basis, rotation_about, rotation_from_quaternion, rotation_from_rpy};
use rand::{SeedableRng, rngs::StdRng};

/// Step of the central differences: their error is h² / 6 ≈ 2e-11 and ε / h ≈ 2e-11.
const H: f64 = 1e-5;

/// Quaternion `q` rotated by `h` about axis `i` of its own frame.
fn turned(q: &[f64], i: usize, h: f64) -> [f64; 4] {
    let q = UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3]));
    let q = q * UnitQuaternion::from_scaled_axis(Vector3::ith(i, h));
    [q.w, q.i, q.j, q.k]
}

/// Positions after a motion with unit velocity component `i` of the joint for the time `h`; mimics follow.
fn moved(mechanism: &Mechanism, positions: &[Vec<f64>], joint: usize, i: usize, h: f64) -> Vec<Vec<f64>> {
    let mut moved = positions.to_vec();
    let q = &mut moved[joint];
    match mechanism.joints()[joint].kind() {
        JointKind::Fixed => unreachable!("it has no velocity"),
        JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Planar => q[i] += h,
        JointKind::Spherical => *q = turned(q, i, h).to_vec(),
        JointKind::Floating if i < 3 => {
            let turned = turned(&q[3..], i, h);
            q[3..].copy_from_slice(&turned);
        }
        JointKind::Floating => {
            let along = rotation_from_quaternion([q[3], q[4], q[5], q[6]]).column(i - 3) * h;
            (0..3).for_each(|k| q[k] += along[k]);
        }
    }
    random::follow(mechanism, &mut moved);
    moved
}

fn rotation(x: &Matrix4<f64>) -> nalgebra::Matrix3<f64> {
    x.fixed_view::<3, 3>(0, 0).into_owned()
}

/// 1 / (j M⁻¹ jᵀ), with M and j from finite differences of poses.
fn by_differences(question: &Question) -> f64 {
    let mechanism = question.mechanism;
    let columns: Vec<(usize, usize)> = (0..mechanism.joints().len())
        .filter(|&joint| mechanism.joints()[joint].mimic().is_none())
        .flat_map(|joint| (0..mechanism.joints()[joint].kind().dofs()).map(move |i| (joint, i)))
        .collect();
    let x_wl = poses(mechanism, &question.positions);
    let p_w = x_wl[question.on.index()].transform_point(&question.point.into());
    let n = columns.len();
    let mut mass = DMatrix::<f64>::zeros(n, n);
    let mut contact = DVector::<f64>::zeros(n);
    let steps: Vec<[Vec<Matrix4<f64>>; 2]> = columns
        .iter()
        .map(|&(joint, i)| {
            [H, -H].map(|h| poses(mechanism, &moved(mechanism, &question.positions, joint, i, h)))
        })
        .collect();
    for (l, link) in mechanism.links().iter().enumerate() {
        let inertia = link.inertia();
        let point = x_wl[l].try_inverse().unwrap().transform_point(&p_w);
        // Twist in the axes of the link, at its origin, as for the ten inertia parameters.
        let mut angular = Vec::new();
        let mut linear = Vec::new();
        for (k, [plus, minus]) in steps.iter().enumerate() {
            let turn = rotation(&minus[l]).transpose() * rotation(&plus[l]);
            // Skew part of the rotation, sin θ times the axis; the angle from the trace would lose half of the digits.
            let sine = Vector3::new(turn.m32 - turn.m23, turn.m13 - turn.m31, turn.m21 - turn.m12) / 2.0;
            angular.push(sine / (2.0 * H));
            let shift = (plus[l] - minus[l]).fixed_view::<3, 1>(0, 3) / (2.0 * H);
            linear.push(rotation(&x_wl[l]).tr_mul(&shift));
            let velocity = (plus[l].transform_point(&point) - minus[l].transform_point(&point)) / (2.0 * H);
            let closing = question.normal.dot(&velocity);
            contact[k] += if l == question.on.index() { closing } else { 0.0 };
            contact[k] -= if question.against.is_some_and(|a| a.index() == l) { closing } else { 0.0 };
        }
        for a in 0..n {
            let moment = inertia.rotational * angular[a] + inertia.first_moment.cross(&linear[a]);
            let force = linear[a] * inertia.mass + angular[a].cross(&inertia.first_moment);
            for b in 0..n {
                mass[(a, b)] += moment.dot(&angular[b]) + force.dot(&linear[b]);
            }
        }
    }
    for (joint, own) in mechanism.joints().iter().enumerate() {
        for (i, armature) in own.armature().iter().enumerate() {
            let (master, ratio) = own.mimic().map_or((joint, 1.0), |m| (m.master.index(), m.multiplier));
            let k = columns.iter().position(|&c| c == (master, i)).unwrap();
            mass[(k, k)] += armature * ratio * ratio;
        }
    }
    1.0 / contact.dot(&mass.cholesky().expect("every body has mass").solve(&contact))
}

#[test]
fn differences_of_poses_show_the_same_mass() {
    let mut rng = StdRng::seed_from_u64(41);
    let mut worst = 0.0f64;
    let mut cases = vec![zoo::every_joint(), zoo::mimic_gripper(), zoo::six_r_arm()];
    cases.extend((0..30).map(|i| random::mechanism(&mut rng, 3 + i % 6)));
    for mechanism in &cases {
        for _ in 0..3 {
            let positions = random::positions(&mut rng, mechanism);
            let (on, against, point, normal) = random::contact(&mut rng, mechanism);
            let question = Question { against, ..Question::new(mechanism, positions, on, point, normal) };
            let mass = effective_mass(&question).finite().expect("a general contact");
            worst = worst.max((by_differences(&question) / mass - 1.0).abs());
        }
    }
    println!("worst {worst:e}");
    // Error 1e-10 of the differences times the condition of M, up to some thousands.
    assert!(worst < 1e-8, "{worst:e}");
}

/// Massless link on one joint with an armature; compared with 1/m̄ by hand.
fn held_by_rotors(kind: JointKind, armature: &[f64], q: Vec<f64>, expected: impl Fn(&Frames) -> f64) {
    let axis = Vector3::new(0.3, -0.5, 0.8).normalize();
    let x_pj = Transform::new(rotation_from_rpy([0.4, 0.9, -1.3]), Vector3::new(0.3, -0.2, 0.5));
    let joint = JointDescription {
        armature: armature.to_vec(),
        axis,
        ..JointDescription::new("joint", kind, "ground", "shell").origin(x_pj)
    };
    let links = vec![LinkDescription::massless("ground"), LinkDescription::massless("shell")];
    let mechanism = build("held by rotors", links, vec![joint]);
    let point = Vector3::new(0.2, -0.4, 0.1);
    let normal = Vector3::new(-0.6, 0.1, 0.7).normalize();
    let on = mechanism.find_link("shell").unwrap();
    let mass = effective_mass(&Question::new(&mechanism, vec![q], on, point, normal)).finite().unwrap();
    let mobility = expected(&Frames { axis, n_j: x_pj.inverse_vector(&normal), point });
    assert!((mass * mobility - 1.0).abs() < 1e-13, "{kind:?}: {mass} against {}", 1.0 / mobility);
}

/// Input of the calculation by hand: axis and normal in the joint frame, point in the link frame.
struct Frames {
    axis: Vector3<f64>,
    n_j: Vector3<f64>,
    point: Vector3<f64>,
}

/// Σ aᵢ² / mᵢ.
fn mobility(arms: &Vector3<f64>, rotors: &[f64]) -> f64 {
    arms.iter().zip(rotors).map(|(arm, rotor)| arm * arm / rotor).sum()
}

#[test]
fn armatures_act_on_the_velocities_of_the_table() {
    let q = UnitQuaternion::from_euler_angles(0.5, -0.8, 1.9);
    let quaternion = [q.w, q.i, q.j, q.k];
    let r_jc = rotation_from_quaternion(quaternion);
    for kind in [JointKind::Revolute, JointKind::Continuous] {
        held_by_rotors(kind, &[0.3], vec![0.7], |f| {
            let arm = (rotation_about(&f.axis, 0.7) * f.point).cross(&f.n_j).dot(&f.axis);
            arm * arm / 0.3
        });
    }
    held_by_rotors(JointKind::Prismatic, &[1.7], vec![0.4], |f| f.n_j.dot(&f.axis).powi(2) / 1.7);
    let rotors = [0.5, 1.5, 0.07];
    held_by_rotors(JointKind::Planar, &rotors, vec![0.3, -0.6, 1.2], |f| {
        let (e1, e2) = plane_basis(&f.axis);
        let turn = (rotation_about(&f.axis, 1.2) * f.point).cross(&f.n_j).dot(&f.axis);
        mobility(&Vector3::new(f.n_j.dot(&e1), f.n_j.dot(&e2), turn), &rotors)
    });
    let rotors = [0.2, 0.03, 1.1];
    held_by_rotors(JointKind::Spherical, &rotors, quaternion.to_vec(), |f| {
        mobility(&f.point.cross(&r_jc.tr_mul(&f.n_j)), &rotors)
    });
    let rotors = [0.2, 0.03, 1.1, 5.0, 0.7, 2.0];
    let position = [&[0.3, -0.1, 0.9][..], &quaternion].concat();
    held_by_rotors(JointKind::Floating, &rotors, position, |f| {
        let n_c = r_jc.tr_mul(&f.n_j);
        mobility(&f.point.cross(&n_c), &rotors[..3]) + mobility(&n_c, &rotors[3..])
    });
}

#[test]
fn poses_are_those_of_the_table() {
    // Definitions of the table: X_pc = origin · motion(q); planar motions stay in the plane; the centre of a ball is fixed.
    let mut rng = StdRng::seed_from_u64(43);
    let mechanism = zoo::every_joint();
    let mut count = 0;
    for _ in 0..5 {
        let positions = random::positions(&mut rng, &mechanism);
        let x_wl = poses(&mechanism, &positions);
        for (joint, q) in mechanism.joints().iter().zip(&positions) {
            let pose = |l: percuss_mechanism::LinkId| {
                let x = &x_wl[l.index()];
                Transform::new(rotation(x), x.fixed_view::<3, 1>(0, 3).into_owned())
            };
            let x_jc = joint.origin().inverse() * pose(joint.parent()).inverse() * pose(joint.child());
            let (axis, zero) = (joint.axis(), Vector3::zeros());
            let (r, p) = match joint.kind() {
                JointKind::Fixed => (nalgebra::Matrix3::identity(), zero),
                JointKind::Revolute | JointKind::Continuous => (rotation_about(axis, q[0]), zero),
                JointKind::Prismatic => (nalgebra::Matrix3::identity(), axis * q[0]),
                JointKind::Planar => {
                    let (e1, e2) = plane_basis(axis);
                    (rotation_about(axis, q[2]), e1 * q[0] + e2 * q[1])
                }
                JointKind::Spherical => (rotation_from_quaternion([q[0], q[1], q[2], q[3]]), zero),
                JointKind::Floating => {
                    let p = Vector3::new(q[0], q[1], q[2]);
                    (rotation_from_quaternion([q[3], q[4], q[5], q[6]]), p)
                }
            };
            // Rounding of four consecutive products of numbers of order one.
            assert!((x_jc.rotation - r).amax() < 1e-14, "{}", joint.name());
            assert!((x_jc.translation - p).amax() < 1e-14, "{}", joint.name());
            count += 1;
        }
    }
    assert_eq!(count, 5 * mechanism.joints().len());
}
