//! Residuals of closures and couplings, and the rows of A, all in metres. Angles are multiplied by the group's
//! characteristic length.

use crate::kinematics::frames::Kinematics;
use crate::model::{CompiledClosure, Constraint, Group, Model};
use crate::tolerances::{OPPOSED_AXES, SMALL_SINE};
use nalgebra::{DMatrix, Matrix3, Vector3};
use percuss_mechanism::ClosureKind;
use percuss_spatial::{Transform, Twist, Wrench};

/// Largest number of rows of one constraint.
pub(crate) const MOST: usize = 6;

/// Rows of a group at a pose, in blocks: for each constraint and each of its velocities, one number per row.
#[derive(Clone, Debug, Default)]
pub(crate) struct GroupRows {
    values: Vec<f64>,
}

impl GroupRows {
    /// Computes the rows of a group at the frames in `kinematics`.
    pub fn fill(&mut self, model: &Model, group: &Group, kinematics: &Kinematics) {
        self.values.clear();
        self.values.reserve(group.constraints.iter().map(|rows| rows.count * rows.terms.len()).sum());
        let length = group.size;
        for rows in &group.constraints {
            match rows.constraint {
                Constraint::Closure(i) => {
                    let closure = &model.closures[i];
                    let x_rp = kinematics.frame_of(&closure.predecessor);
                    let x_rs = kinematics.frame_of(&closure.successor);
                    let wrenches = closure_wrenches(closure, &x_rp, &x_rs, length);
                    for term in &rows.terms {
                        let twist = kinematics.column_at(model, term.body, term.component, &x_rs.translation);
                        let factor = term.factor * term.multiplier;
                        self.values.extend(wrenches[..rows.count].iter().map(|w| w.power(&twist) * factor));
                    }
                }
                Constraint::Coupling(i) => {
                    let coupling = &model.couplings[i];
                    let scale = coupling_scale(coupling.turns, group);
                    let [slope, _] = coupling.curve_derivatives(&kinematics.q);
                    let entry = |t: &crate::model::ConstraintTerm| {
                        scale * (t.factor - slope * t.argument) * t.multiplier
                    };
                    self.values.extend(rows.terms.iter().map(entry));
                }
                Constraint::Hold(i) => {
                    let hold = &model.holds[i];
                    let x_rl = kinematics.link_frame(model, hold.link);
                    let point = x_rl.point(&hold.point);
                    let directions = hold.directions();
                    for term in &rows.terms {
                        let twist = kinematics.column_at(model, term.body, term.component, &point);
                        let factor = term.factor * term.multiplier;
                        let held = directions[..rows.count].iter().map(|d| d.dot(&twist.linear) * factor);
                        self.values.extend(held);
                    }
                }
            }
        }
    }

    /// Number of entries that [`for_each`](Self::for_each) visits.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Visits the entries (row, column, value) of A over the group's coordinates. Mimics cause repeated entries,
    /// which must be summed.
    pub fn for_each(&self, group: &Group, mut visit: impl FnMut(usize, usize, f64)) {
        let mut values = self.values.iter();
        for rows in &group.constraints {
            for term in &rows.terms {
                for (row, value) in (rows.first..).zip(values.by_ref().take(rows.count)) {
                    visit(row, term.column, *value);
                }
            }
        }
    }

    /// A over the group's coordinates, rows × coordinates, row by row.
    pub fn dense_into(&self, group: &Group, dense: &mut Vec<f64>) {
        let columns = group.coordinates.len();
        dense.clear();
        dense.resize(group.rows * columns, 0.0);
        self.for_each(group, |row, column, value| dense[row * columns + column] += value);
    }
}

/// Factor that converts the row of a coupling to metres.
pub(crate) fn coupling_scale(turns: bool, group: &Group) -> f64 {
    if turns { group.size } else { 1.0 }
}

impl Model {
    /// A of a group over its coordinates.
    pub fn group_matrix(&self, kinematics: &Kinematics, group: &Group) -> DMatrix<f64> {
        let mut rows = GroupRows::default();
        rows.fill(self, group, kinematics);
        let mut matrix = DMatrix::zeros(group.rows, group.coordinates.len());
        rows.for_each(group, |row, column, value| matrix[(row, column)] += value);
        matrix
    }

    /// Residuals (m) of a group, one per row; 0 for held contacts.
    pub fn group_residuals_into(&self, kinematics: &Kinematics, group: &Group, residuals: &mut Vec<f64>) {
        residuals.clear();
        for rows in &group.constraints {
            match rows.constraint {
                Constraint::Closure(i) => {
                    let closure = &self.closures[i];
                    let x_rp = kinematics.frame_of(&closure.predecessor);
                    let x_rs = kinematics.frame_of(&closure.successor);
                    let all = closure_residuals(closure, &x_rp, &x_rs, group.size);
                    residuals.extend_from_slice(&all[..rows.count]);
                }
                Constraint::Coupling(i) => {
                    let coupling = &self.couplings[i];
                    residuals.push(coupling_scale(coupling.turns, group) * coupling.residual(&kinematics.q));
                }
                Constraint::Hold(_) => residuals.extend(std::iter::repeat_n(0.0, rows.count)),
            }
        }
    }

    /// Residuals (m) of a group.
    pub fn group_residuals(&self, kinematics: &Kinematics, group: &Group) -> Vec<f64> {
        let mut residuals = Vec::with_capacity(group.rows);
        self.group_residuals_into(kinematics, group, &mut residuals);
        residuals
    }

    /// Largest residual of a group, m, and its row.
    pub fn group_residual(&self, kinematics: &Kinematics, group: &Group) -> (f64, usize) {
        largest(&self.group_residuals(kinematics, group))
    }
}

/// Largest magnitude and its index; NaN counts as infinite.
pub(crate) fn largest(residuals: &[f64]) -> (f64, usize) {
    let size = |r: f64| if r.is_nan() { f64::INFINITY } else { r.abs() };
    residuals
        .iter()
        .enumerate()
        .fold((0.0, 0), |(most, at), (i, r)| if size(*r) > most { (size(*r), i) } else { (most, at) })
}

/// For each row of a closure: the wrench (root axes, about the successor's loop origin) whose power on the relative
/// twist is the rate of the residual. Rows of rotations are scaled by `length` (m). The order is that of the table at
/// [`ClosureKind`].
pub(crate) fn closure_wrenches(
    closure: &CompiledClosure,
    x_rp: &Transform<f64>,
    x_rs: &Transform<f64>,
    length: f64,
) -> [Wrench<f64>; MOST] {
    let mut wrenches = [Wrench::zero(); MOST];
    // Residual along a direction fixed in the predecessor.
    let along = |e: &Vector3<f64>| Wrench::new(Vector3::zeros(), x_rp.vector(e));
    // Residual of the cosine between a direction of the predecessor and a direction of the successor.
    let cosine = |e: &Vector3<f64>, b: &Vector3<f64>| {
        let (e, b) = (x_rp.vector(e), x_rs.vector(b));
        Wrench::new(b.cross(&e) * length, Vector3::zeros())
    };
    let turn = |e: &Vector3<f64>| Wrench::new(x_rp.vector(e) * length, Vector3::zeros());
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let [n1, n2] = &closure.normals;
    let b = &closure.successor_axis;
    match closure.kind {
        ClosureKind::Fixed => {
            for k in 0..3 {
                (wrenches[k], wrenches[3 + k]) = (along(&axes[k]), turn(&axes[k]));
            }
        }
        ClosureKind::Revolute => {
            wrenches[..3].copy_from_slice(&[0, 1, 2].map(|k| along(&axes[k])));
            wrenches[3..5].copy_from_slice(&[cosine(n1, b), cosine(n2, b)]);
        }
        ClosureKind::Prismatic => {
            wrenches[..2].copy_from_slice(&[along(n1), along(n2)]);
            wrenches[2..5].copy_from_slice(&[0, 1, 2].map(|k| turn(&axes[k])));
        }
        ClosureKind::Cylindrical => {
            wrenches[..4].copy_from_slice(&[along(n1), along(n2), cosine(n1, b), cosine(n2, b)]);
        }
        ClosureKind::Universal => {
            wrenches[..3].copy_from_slice(&[0, 1, 2].map(|k| along(&axes[k])));
            wrenches[3] = cosine(&closure.axis, &closure.axis2);
        }
        ClosureKind::Planar => {
            wrenches[..3].copy_from_slice(&[along(&closure.axis), cosine(n1, b), cosine(n2, b)]);
        }
        ClosureKind::Spherical => wrenches[..3].copy_from_slice(&[0, 1, 2].map(|k| along(&axes[k]))),
        ClosureKind::Distance => {
            // If the ends coincide, the direction is undefined: the row is zero instead of NaN.
            let apart = x_rs.translation - x_rp.translation;
            let square = apart.dot(&apart) + f64::MIN_POSITIVE;
            wrenches[0] = Wrench::new(Vector3::zeros(), apart * (1.0 / square.sqrt()));
        }
    }
    wrenches
}

/// Rates of [`closure_wrenches`] if the bodies of the two loop frames move with the given twists (root axes, about the origin to
/// which the frames refer). The change of the reference point, which moves with the successor, is not included.
pub(crate) fn closure_wrench_rates(
    closure: &CompiledClosure,
    x_rp: &Transform<f64>,
    x_rs: &Transform<f64>,
    length: f64,
    predecessor: &Twist<f64>,
    successor: &Twist<f64>,
) -> [Wrench<f64>; MOST] {
    let mut rates = closure_wrenches(closure, x_rp, x_rs, length);
    let turn = |omega: &Vector3<f64>, wrench: &Wrench<f64>| {
        Wrench::new(omega.cross(&wrench.moment), omega.cross(&wrench.force))
    };
    // Directions fixed in the predecessor.
    for rate in &mut rates {
        *rate = turn(&predecessor.angular, rate);
    }
    // b × e with e fixed in the predecessor and b fixed in the successor.
    let cosine = |e: &Vector3<f64>, b: &Vector3<f64>| {
        let (e, b) = (x_rp.vector(e), x_rs.vector(b));
        let rate = successor.angular.cross(&b).cross(&e) + b.cross(&predecessor.angular.cross(&e));
        Wrench::new(rate * length, Vector3::zeros())
    };
    let parallel = closure.normals.map(|e| cosine(&e, &closure.successor_axis));
    match closure.kind {
        ClosureKind::Fixed | ClosureKind::Prismatic | ClosureKind::Spherical => {}
        ClosureKind::Revolute => rates[3..5].copy_from_slice(&parallel),
        ClosureKind::Cylindrical => rates[2..4].copy_from_slice(&parallel),
        ClosureKind::Planar => rates[1..3].copy_from_slice(&parallel),
        ClosureKind::Universal => rates[3] = cosine(&closure.axis, &closure.axis2),
        ClosureKind::Distance => {
            let apart = x_rs.translation - x_rp.translation;
            let square = apart.norm_squared() + f64::MIN_POSITIVE;
            let speed = successor.velocity_at(&x_rs.translation) - predecessor.velocity_at(&x_rp.translation);
            let across = speed - apart * (apart.dot(&speed) / square);
            rates[0] = Wrench::new(Vector3::zeros(), across / square.sqrt());
        }
    }
    rates
}

/// Residuals of a closure, m, in the order of its rows.
fn closure_residuals(
    closure: &CompiledClosure,
    x_rp: &Transform<f64>,
    x_rs: &Transform<f64>,
    length: f64,
) -> [f64; MOST] {
    let mut residuals = [0.0; MOST];
    let apart = x_rs.translation - x_rp.translation;
    let p = x_rp.inverse_vector(&apart);
    let rotation = || rotation_vector(&(x_rp.rotation.transpose() * x_rs.rotation)) * length;
    let parallel = || misalignment(closure, x_rp, x_rs, length);
    let [n1, n2] = &closure.normals;
    match closure.kind {
        ClosureKind::Fixed => {
            residuals[..3].copy_from_slice(p.as_slice());
            residuals[3..].copy_from_slice(rotation().as_slice());
        }
        ClosureKind::Revolute => {
            residuals[..3].copy_from_slice(p.as_slice());
            residuals[3..5].copy_from_slice(&parallel());
        }
        ClosureKind::Prismatic => {
            residuals[..2].copy_from_slice(&[n1.dot(&p), n2.dot(&p)]);
            residuals[2..5].copy_from_slice(rotation().as_slice());
        }
        ClosureKind::Cylindrical => {
            residuals[..2].copy_from_slice(&[n1.dot(&p), n2.dot(&p)]);
            residuals[2..4].copy_from_slice(&parallel());
        }
        ClosureKind::Universal => {
            residuals[..3].copy_from_slice(p.as_slice());
            residuals[3] = length * x_rp.vector(&closure.axis).dot(&x_rs.vector(&closure.axis2));
        }
        ClosureKind::Planar => {
            residuals[0] = closure.axis.dot(&p);
            residuals[1..3].copy_from_slice(&parallel());
        }
        ClosureKind::Spherical => residuals[..3].copy_from_slice(p.as_slice()),
        ClosureKind::Distance => residuals[0] = apart.norm() - closure.distance,
    }
    residuals
}

/// Two residuals that vanish if the successor's axis has the direction of the predecessor's axis: the components of
/// the successor's axis along two normals. Beyond 90° the residuals are stretched, so that the opposite direction is
/// not a solution.
fn misalignment(
    closure: &CompiledClosure,
    x_rp: &Transform<f64>,
    x_rs: &Transform<f64>,
    length: f64,
) -> [f64; 2] {
    let b = x_rs.vector(&closure.successor_axis);
    let mut residuals = closure.normals.map(|e| length * x_rp.vector(&e).dot(&b));
    if x_rp.vector(&closure.axis).dot(&b) < 0.0 {
        let size = residuals[0].hypot(residuals[1]);
        // sin θ is replaced by 2 − sin θ, which increases up to the opposite direction.
        let stretch = if size > OPPOSED_AXES * length { (2.0 * length - size) / size } else { 0.0 };
        if stretch > 0.0 {
            residuals.iter_mut().for_each(|r| *r *= stretch);
        } else {
            residuals[0] = 2.0 * length;
        }
    }
    residuals
}

/// Rotation vector (axis times angle, rad) of a rotation matrix.
fn rotation_vector(r: &Matrix3<f64>) -> Vector3<f64> {
    let skew = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) / 2.0;
    let (sine, cosine) = (skew.norm(), (r.trace() - 1.0) / 2.0);
    let angle = sine.atan2(cosine);
    if sine > SMALL_SINE {
        return skew * (angle / sine);
    }
    if cosine > 0.0 {
        return skew;
    }
    // Rotation by π: the axis is the longest column of R + 1.
    let symmetric = r + Matrix3::identity();
    let column = (0..3).max_by(|&a, &b| symmetric[(a, a)].total_cmp(&symmetric[(b, b)])).unwrap_or(0);
    symmetric.column(column).normalize() * angle
}

#[cfg(test)]
mod tests {
    use super::*;
    use percuss_spatial::rotation_about;

    #[test]
    fn rotation_vectors_are_found_at_every_angle() {
        let axis = Vector3::new(0.3, -0.5, 0.8).normalize();
        for angle in [0.0, 1e-9, 1e-4, 0.7, 2.0, 3.1, std::f64::consts::PI - 1e-8] {
            let v = rotation_vector(&rotation_about(&axis, angle));
            // Near a rotation by π the sine loses digits: √ε.
            assert!((v - axis * angle).norm() < 3e-8, "{angle}: {v}");
        }
        assert!(
            (rotation_vector(&rotation_about(&axis, std::f64::consts::PI)).norm() - std::f64::consts::PI)
                .abs()
                < 1e-7
        );
    }
}
