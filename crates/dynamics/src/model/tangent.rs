//! Rates of positions from velocities, and steps along velocities, for each kind of joint.

use nalgebra::Vector3;
use percuss_mechanism::JointKind;
use percuss_spatial::{quaternion_product, rotation_from_quaternion};

/// Writes the zero position; quaternions are set to identity.
pub(crate) fn zero_position(kind: JointKind, q: &mut [f64]) {
    q.fill(0.0);
    match kind {
        JointKind::Spherical => q[0] = 1.0,
        JointKind::Floating => q[3] = 1.0,
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Planar => {}
    }
}

/// q̇ of one joint at the velocities `v` (layouts of [`JointKind`]). The rate of a quaternion is ½ q ∘ (0, ω).
pub(crate) fn position_rates(kind: JointKind, q: &[f64], v: &[f64], rates: &mut [f64]) {
    let half = 0.5;
    let spin = |q: [f64; 4], w: &[f64]| quaternion_product(q, [0.0, w[0] * half, w[1] * half, w[2] * half]);
    match kind {
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Planar => rates.copy_from_slice(v),
        JointKind::Spherical => rates.copy_from_slice(&spin([q[0], q[1], q[2], q[3]], v)),
        JointKind::Floating => {
            let quaternion = [q[3], q[4], q[5], q[6]];
            let slide = rotation_from_quaternion(quaternion) * Vector3::new(v[3], v[4], v[5]);
            rates[..3].copy_from_slice(slide.as_slice());
            rates[3..].copy_from_slice(&spin(quaternion, &v[..3]));
        }
    }
}

/// q ⊕ h v of one joint, to second order in h, with quaternions normalised. Midpoint rule, because the translation
/// axes of a floating joint rotate.
pub(crate) fn advance(kind: JointKind, q: &mut [f64], v: &[f64], h: f64) {
    if !matches!(kind, JointKind::Spherical | JointKind::Floating) {
        // The rates are equal to the velocities at every position.
        return q.iter_mut().zip(v).for_each(|(q, v)| *q += h * v);
    }
    let (mut rates, mut middle) = ([0.0; 7], [0.0; 7]);
    let (rates, middle) = (&mut rates[..q.len()], &mut middle[..q.len()]);
    position_rates(kind, q, v, rates);
    middle.iter_mut().zip(&*q).zip(&*rates).for_each(|((m, q), r)| *m = q + h / 2.0 * r);
    normalise(kind, middle);
    position_rates(kind, middle, v, rates);
    q.iter_mut().zip(&*rates).for_each(|(q, r)| *q += h * r);
    normalise(kind, q);
}

/// Like [`advance`], into a new vector.
pub(crate) fn advanced(kind: JointKind, q: &[f64], v: &[f64], h: f64) -> Vec<f64> {
    let mut next = q.to_vec();
    advance(kind, &mut next, v, h);
    next
}

/// Velocities that move one joint from `from` to `to` in unit time, by the shorter rotation. Exact for joints with
/// rates equal to velocities and for spherical joints; of second order for floating joints.
pub(crate) fn displacement(kind: JointKind, from: &[f64], to: &[f64]) -> Vec<f64> {
    let turn = |a: &[f64], b: &[f64]| {
        let d = quaternion_product([a[0], -a[1], -a[2], -a[3]], [b[0], b[1], b[2], b[3]]);
        let axis = Vector3::new(d[1], d[2], d[3]) * if d[0] < 0.0 { -1.0 } else { 1.0 };
        let sine = axis.norm();
        if sine > 0.0 { axis * (2.0 * sine.atan2(d[0].abs()) / sine) } else { axis }
    };
    match kind {
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Planar => from.iter().zip(to).map(|(a, b)| b - a).collect(),
        JointKind::Spherical => turn(from, to).as_slice().to_vec(),
        JointKind::Floating => {
            let w = turn(&from[3..], &to[3..]);
            let slide = Vector3::new(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
            let half = advanced(JointKind::Spherical, &from[3..], (w / 2.0).as_slice(), 1.0);
            let v = rotation_from_quaternion([half[0], half[1], half[2], half[3]]).tr_mul(&slide);
            vec![w.x, w.y, w.z, v.x, v.y, v.z]
        }
    }
}

/// Scales the quaternion in `q` to unit norm.
pub(crate) fn normalise(kind: JointKind, q: &mut [f64]) {
    let quaternion = match kind {
        JointKind::Spherical => &mut q[..4],
        JointKind::Floating => &mut q[3..7],
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Planar => return,
    };
    let norm = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
    quaternion.iter_mut().for_each(|x| *x /= norm);
}
