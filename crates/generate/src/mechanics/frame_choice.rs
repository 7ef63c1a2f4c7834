//! Choice of the body frames. The z-axis of every body lies along the axis of its joint, and the x-axis along the
//! common normal to the axis of the next joint (Denavit and Hartenberg). The constant part of a joint's transform is
//! then one rotation and one shift along x, and the variable part one rotation and one shift along z.

use super::tree::Tree;
use percuss_mechanism::JointKind;
use percuss_spatial::{Matrix3, Transform, Vector3, plane_basis};

/// Sine of the angle between two axes below which the axes count as parallel: rounding of unit vectors.
const PARALLEL: f64 = 1e-14;
/// Smallest sine for which the common normal is used: below, its foot is far away.
const WELL_CONDITIONED: f64 = 0.05;
/// Entries below this multiple of the scale are rounding errors of zero.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Constant part of a joint's transform, in the order of the steps: shifts (x, y, z), rotation about z by `turn`,
/// shift along x, rotation about x by `twist`, shift along z, rotation about z by `last`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ConstantPart {
    pub shift: [f64; 3],
    pub turn: f64,
    pub normal: f64,
    pub twist: f64,
    pub along: f64,
    pub last: f64,
}

/// Frame of a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChosenFrame {
    /// X_bc: chosen frame in the frame of the child link.
    pub frame: Transform<f64>,
    /// Rotation about z and shift along z that are part of the frame; they follow the joint's motion.
    pub turn: f64,
    pub along: f64,
}

/// True if the joint has an axis, which becomes the z-axis of its body.
fn has_axis(kind: JointKind) -> bool {
    match kind {
        JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Planar => true,
        JointKind::Fixed | JointKind::Spherical | JointKind::Floating => false,
    }
}

/// Frame whose z-axis is the joint's axis, in the child link; identity for joints without an axis.
pub(crate) fn axis_frame(kind: JointKind, axis: &Vector3<f64>) -> Transform<f64> {
    if !has_axis(kind) {
        return Transform::identity();
    }
    let (x, y) = plane_basis(axis);
    Transform::new(Matrix3::from_columns(&[x, y, *axis]), Vector3::zeros())
}

/// Rotation about z by an angle, then a shift along z.
fn screw(angle: f64, along: f64) -> Transform<f64> {
    let (sine, cosine) = sine_cosine(angle);
    Transform::new(
        Matrix3::new(cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0),
        Vector3::new(0.0, 0.0, along),
    )
}

/// Sine and cosine of a constant angle; rounding errors of 0 are removed.
pub(crate) fn sine_cosine(angle: f64) -> (f64, f64) {
    let (sine, cosine) = angle.sin_cos();
    if sine.abs() < ROUNDING {
        (0.0, cosine.signum())
    } else if cosine.abs() < ROUNDING {
        (sine.signum(), 0.0)
    } else {
        (sine, cosine)
    }
}

/// Removes rounding errors of zero.
fn cleaned(x: f64, scale: f64) -> f64 {
    if x.abs() <= ROUNDING * scale { 0.0 } else { x }
}

/// Chooses the frames of all bodies. `preferred`: bodies whose path is followed where a body has several children.
pub(crate) fn choose_frames(tree: &Tree, preferred: &[usize], scale: f64) -> Vec<ChosenFrame> {
    let mut sizes = vec![1usize; tree.bodies.len()];
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        if let Some(parent) = body.parent {
            sizes[parent] += sizes[i];
        }
    }
    let mut next: Vec<Option<usize>> = vec![None; tree.bodies.len()];
    for (i, body) in tree.bodies.iter().enumerate() {
        let Some(parent) = body.parent else { continue };
        let rank = |b: usize| (preferred.contains(&b), sizes[b]);
        if next[parent].is_none_or(|known| rank(i) > rank(known)) {
            next[parent] = Some(i);
        }
    }
    let choose = |i: usize| {
        let body = &tree.bodies[i];
        let base = axis_frame(body.kind, &body.axis);
        let (turn, along) = match next[i] {
            Some(child) if has_axis(body.kind) => {
                let child = &tree.bodies[child];
                let line = base.inverse() * child.origin * axis_frame(child.kind, &child.axis);
                toward_next_axis(&line, scale)
            }
            _ => (0.0, 0.0),
        };
        ChosenFrame { frame: base * screw(turn, along), turn, along }
    };
    (0..tree.bodies.len()).map(choose).collect()
}

/// Rotation about z and shift along z that bring the x-axis onto the common normal to the next axis.
fn toward_next_axis(line: &Transform<f64>, scale: f64) -> (f64, f64) {
    let (o, a) = (line.translation, line.rotation * Vector3::z());
    let sine = a.x.hypot(a.y);
    if sine < PARALLEL {
        let turn = if o.x.hypot(o.y) > ROUNDING * scale { o.y.atan2(o.x) } else { 0.0 };
        return (turn, cleaned(o.z, scale));
    }
    let turn = a.x.atan2(-a.y);
    if sine < WELL_CONDITIONED {
        return (turn, cleaned(o.z, scale));
    }
    let along = (o.z - o.dot(&a) * a.z) / (sine * sine);
    (turn, cleaned(along, scale))
}

/// Decomposes the constant transform to the axis frame of a child.
pub(crate) fn decompose(constant: &Transform<f64>, scale: f64) -> ConstantPart {
    let (r, t) = (&constant.rotation, &constant.translation);
    let a = r * Vector3::z();
    let sine = a.x.hypot(a.y);
    let (turn, twist) = if sine < PARALLEL {
        (0.0, if a.z > 0.0 { 0.0 } else { std::f64::consts::PI })
    } else {
        (a.x.atan2(-a.y), sine.atan2(a.z))
    };
    // A rotation by π about z leads to the opposite angle about x.
    let opposite = (turn.abs() - std::f64::consts::PI).abs() * sine < ROUNDING;
    let (turn, twist) = if opposite { (0.0, -twist) } else { (turn, twist) };
    // An error of the turn moves the axis by its product with the sine; the last rotation absorbs the rest.
    let turn = if turn.abs() * sine < ROUNDING { 0.0 } else { turn };
    let (sine_turn, cosine_turn) = sine_cosine(turn);
    let (sine_twist, cosine_twist) = sine_cosine(twist);
    // R = Rz(turn) Rx(twist) Rz(last): the first column of Rx⁻¹ Rz⁻¹ R.
    let x = Vector3::new(r[(0, 0)], r[(1, 0)], r[(2, 0)]);
    let flat = Vector3::new(cosine_turn * x.x + sine_turn * x.y, -sine_turn * x.x + cosine_turn * x.y, x.z);
    let last = (cosine_twist * flat.y + sine_twist * flat.z).atan2(flat.x);
    let last = if last.abs() < ROUNDING { 0.0 } else { last };
    let mut part = ConstantPart { turn, twist, last, ..ConstantPart::default() };
    if sine_twist == 0.0 {
        // Parallel axes: the shifts along both axes are one.
        part.normal = cosine_turn * t.x + sine_turn * t.y;
        part.shift = [0.0, 0.0, t.z];
        let aside = -sine_turn * t.x + cosine_turn * t.y;
        if aside.abs() > ROUNDING * scale {
            (part.shift, part.normal) = ([t.x, t.y, t.z], 0.0);
        }
    } else if sine >= WELL_CONDITIONED {
        part.normal = cosine_turn * t.x + sine_turn * t.y;
        let across = -sine_turn * t.x + cosine_turn * t.y;
        part.along = -across / sine_twist;
        part.shift = [0.0, 0.0, t.z - part.along * cosine_twist];
    } else {
        part.shift = [t.x, t.y, t.z];
    }
    part.normal = cleaned(part.normal, scale);
    part.along = cleaned(part.along, scale);
    part.shift = part.shift.map(|x| cleaned(x, scale));
    part
}

#[cfg(test)]
mod tests {
    use super::*;
    use percuss_spatial::{rotation_about, rotation_from_rpy};

    fn composed(part: &ConstantPart) -> Transform<f64> {
        let shift = |x, y, z| Transform::from_translation(Vector3::new(x, y, z));
        let turn = |axis: Vector3<f64>, angle| Transform::new(rotation_about(&axis, angle), Vector3::zeros());
        shift(part.shift[0], part.shift[1], part.shift[2])
            * turn(Vector3::z(), part.turn)
            * shift(part.normal, 0.0, 0.0)
            * turn(Vector3::x(), part.twist)
            * shift(0.0, 0.0, part.along)
            * turn(Vector3::z(), part.last)
    }

    #[test]
    fn constant_parts_compose_to_the_transform() {
        use std::f64::consts::{FRAC_PI_2, PI};
        let angles = [0.0, 0.3, -2.0, FRAC_PI_2, PI, -FRAC_PI_2, 1e-9, 1.570_796_325];
        for roll in angles {
            for pitch in angles {
                for yaw in angles {
                    let x =
                        Transform::new(rotation_from_rpy([roll, pitch, yaw]), Vector3::new(0.3, -0.2, 0.7));
                    let found = composed(&decompose(&x, 1.0));
                    // Rounding of products of numbers of order one; the shifts grow with 1/sin, at most 20.
                    assert!((found.rotation - x.rotation).norm() < 4e-15, "{roll} {pitch} {yaw}");
                    assert!((found.translation - x.translation).norm() < 2e-14, "{roll} {pitch} {yaw}");
                }
            }
        }
    }
}
