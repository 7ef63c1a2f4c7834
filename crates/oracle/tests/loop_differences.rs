//! Rows of closures and couplings compared with finite differences of poses and of residuals.

use faer::Mat;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_mechanism::{ClosureKind, JointId, JointKind, Mechanism};
use percuss_oracle::maximal::{Question, moved, poses, residual, residuals, solve};
use percuss_oracle::{linkage, random};
use rand::{SeedableRng, rngs::StdRng};

fn question<'a>(mechanism: &'a Mechanism, positions: &[Vec<f64>], rng: &mut StdRng) -> Question<'a> {
    let (on, against, point, normal) = random::contact(rng, mechanism);
    Question { against, ..Question::new(mechanism, positions.to_vec(), on, point, normal) }
}

/// Velocities of the tree, without those of mimics.
fn velocities(mechanism: &Mechanism) -> Vec<(JointId, usize)> {
    let own = |id: &JointId| mechanism.joint(*id).mimic().is_none();
    let dofs = |id: JointId| (0..mechanism.joint(id).kind().dofs()).map(move |i| (id, i));
    mechanism.joint_ids().filter(own).flat_map(dofs).collect()
}

/// m̄ in joint space, from finite differences of poses and residuals alone: kernel of the constraints, M and j on the
/// kernel, and 1/(j M⁻¹ jᵀ). `None` if no admissible motion closes the contact.
fn by_differences(question: &Question) -> (usize, Option<f64>) {
    const H: f64 = 1e-5;
    let mechanism = question.mechanism;
    let columns = velocities(mechanism);
    let length = mechanism.characteristic_length();
    let flat = |q: &[Vec<f64>]| residuals(mechanism, q).concat();
    let n = columns.len();
    let m = flat(&question.positions).len();
    let mut a = Mat::<f64>::zeros(m, n);
    let mut steps = Vec::new();
    for (k, &(joint, i)) in columns.iter().enumerate() {
        let [plus, minus] = [H, -H].map(|h| moved(mechanism, &question.positions, joint, i, h));
        let slides = mechanism.joint(joint).kind() == JointKind::Prismatic;
        let unit = if slides { 1.0 } else { length };
        for (row, (p, q)) in flat(&plus).iter().zip(flat(&minus)).enumerate() {
            a[(row, k)] = (p - q) / (2.0 * H * unit);
        }
        steps.push((poses(mechanism, &plus), poses(mechanism, &minus), unit));
    }
    // In metres per metre: the differences have an error of 1e-11.
    let svd = a.svd().unwrap();
    let values: Vec<f64> = svd.S().column_vector().iter().copied().collect();
    let rank = values.iter().filter(|s| **s > 1e-7).count();
    let kernel = DMatrix::from_fn(n, n - rank, |i, k| svd.V()[(i, rank + k)]);

    let x_wl = poses(mechanism, &question.positions);
    let p_w = x_wl[question.on.index()].transform_point(&question.point.into());
    let mut mass = DMatrix::<f64>::zeros(n, n);
    let mut contact = DVector::<f64>::zeros(n);
    for (l, link) in mechanism.links().iter().enumerate() {
        let (inertia, x) = (link.inertia(), &x_wl[l]);
        let local = x.try_inverse().unwrap().transform_point(&p_w);
        let r_wl = x.fixed_view::<3, 3>(0, 0).into_owned();
        let mut motions = Vec::new();
        for (k, (plus, minus, unit)) in steps.iter().enumerate() {
            let [p, q] = [plus, minus].map(|poses| poses[l].fixed_view::<3, 3>(0, 0).into_owned());
            let turn = q.transpose() * p;
            let sine = Vector3::new(turn.m32 - turn.m23, turn.m13 - turn.m31, turn.m21 - turn.m12) / 2.0;
            let shift = (plus[l] - minus[l]).fixed_view::<3, 1>(0, 3).into_owned();
            motions.push((sine / (2.0 * H * unit), r_wl.tr_mul(&shift) / (2.0 * H * unit)));
            let velocity = plus[l].transform_point(&local) - minus[l].transform_point(&local);
            let closing = question.normal.dot(&velocity) / (2.0 * H * unit);
            contact[k] += if l == question.on.index() { closing } else { 0.0 };
            contact[k] -= if question.against.is_some_and(|a| a.index() == l) { closing } else { 0.0 };
        }
        for (i, (w_i, v_i)) in motions.iter().enumerate() {
            let momentum = v_i * inertia.mass + w_i.cross(&inertia.first_moment);
            let spin = inertia.rotational * w_i + inertia.first_moment.cross(v_i);
            for (k, (w_k, v_k)) in motions.iter().enumerate() {
                mass[(i, k)] += momentum.dot(v_k) + spin.dot(w_k);
            }
        }
    }
    for (id, joint) in mechanism.joint_ids().zip(mechanism.joints()) {
        for (i, armature) in joint.armature().iter().enumerate().filter(|(_, a)| **a > 0.0) {
            let (master, ratio) = joint.mimic().map_or((id, 1.0), |m| (m.master, m.multiplier));
            let k = columns.iter().position(|c| *c == (master, i)).unwrap();
            mass[(k, k)] += armature * (ratio / steps[k].2).powi(2);
        }
    }
    let (mass, contact) = (kernel.tr_mul(&(mass * &kernel)), kernel.tr_mul(&contact));
    let finite = contact.norm() > 1e-8;
    let mobility = mass.cholesky().filter(|_| finite).map(|c| contact.dot(&c.solve(&contact)));
    (n - rank, mobility.map(|mobility| 1.0 / mobility))
}

#[test]
fn rows_are_derivatives_of_residuals() {
    let mut rng = StdRng::seed_from_u64(11);
    let (mut worst, mut compared) = (0.0f64, 0);
    let mut check = |mechanism: &Mechanism, positions: &[Vec<f64>], rng: &mut StdRng| {
        let question = question(mechanism, positions, rng);
        let answer = solve(&question);
        let (degrees, mass) = by_differences(&question);
        assert_eq!(answer.degrees_of_freedom, degrees, "{}: {:?}", mechanism.name(), answer.singular_values);
        if let (Some(mass), Some(expected)) = (mass, answer.outcome.finite()) {
            let error = (mass / expected - 1.0).abs();
            assert!(error < 1e-5, "{}: {error:e}, {:?}", mechanism.name(), answer.singular_values);
            worst = worst.max(error);
            compared += 1;
        }
    };
    // Massless rotations make M singular; these linkages are tested against closed forms.
    for linkage in linkage::all().iter().filter(|l| l.name != "trammel_with_rod") {
        check(&linkage.mechanism, &linkage.closed_start(), &mut rng);
    }
    let mut kinds = Vec::new();
    for i in 0..60 {
        let (mechanism, positions) = random::linkage(&mut rng, 4 + i % 6, 1 + i % 3);
        assert!(residual(&mechanism, &positions) < 1e-14);
        kinds.extend(mechanism.closures().iter().map(|c| c.kind()));
        check(&mechanism, &positions, &mut rng);
    }
    for kind in ClosureKind::ALL {
        assert!(kinds.contains(&kind), "{kind:?} never came");
    }
    println!("worst {worst:e} of {compared}");
    assert!(compared > 60, "{compared}");
}
