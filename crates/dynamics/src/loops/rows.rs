//! Residuals of closures and couplings, and their rows of A. All in metres: angles are taken times the
//! characteristic length.

use super::{Group, Held, Loop, seat_frame};
use crate::System;
use crate::kinematics::Kinematics;
use nalgebra::{DMatrix, Matrix3, Vector3};
use percuss_mechanism::ClosureKind;
use percuss_spatial::{Transform, Wrench};

/// One row: its residual, and the wrench (root axes, about the successor's loop origin) whose power on the relative
/// twist is the residual's rate.
struct Row {
    residual: f64,
    wrench: Wrench<f64>,
}

impl System {
    /// Residuals (m) of a group and its rows over the group's coordinates.
    pub(crate) fn group_rows(&self, kinematics: &Kinematics<f64>, group: &Group) -> (Vec<f64>, DMatrix<f64>) {
        let column = |c: usize| group.coordinates.partition_point(|&other| other < c);
        let mut residuals = Vec::with_capacity(group.rows(self));
        let mut matrix = DMatrix::zeros(group.rows(self), group.coordinates.len());
        for &l in &group.loops {
            let l = &self.loops[l];
            let (x_rp, x_rs) = (seat_frame(kinematics, &l.predecessor), seat_frame(kinematics, &l.successor));
            let rows = loop_rows(l, &x_rp, &x_rs, self.mechanism.characteristic_length());
            let first = residuals.len();
            residuals.extend(rows.iter().map(|r| r.residual));
            let (on, against) = (l.successor.body, l.predecessor.body);
            self.for_each_relative_twist(kinematics, on, against, &x_rs.translation, |v, twist| {
                if let Some(f) = self.follows[v] {
                    for (i, row) in rows.iter().enumerate() {
                        matrix[(first + i, column(f.index))] += row.wrench.power(&twist) * f.multiplier;
                    }
                }
            });
        }
        for &g in &group.gears {
            let gear = &self.gears[g];
            let row = residuals.len();
            residuals.push(gear.scale * gear.terms.iter().map(|(q, _, f)| f * kinematics.q[*q]).sum::<f64>());
            for (_, v, factor) in &gear.terms {
                if let Some(f) = v.and_then(|v| self.follows[v]) {
                    matrix[(row, column(f.index))] += gear.scale * factor * f.multiplier;
                }
            }
        }
        (residuals, matrix)
    }

    /// All rows of A over the coordinates: groups one after another, each scaled to an entry of at most 1 (so that its
    /// rank does not hang on the others'), then the held contacts.
    pub(crate) fn constraint_rows(&self, kinematics: &Kinematics<f64>) -> DMatrix<f64> {
        let count: usize = self.groups.iter().map(|g| g.rows(self)).sum();
        let held: usize = self.held.iter().map(Held::rows).sum();
        let mut matrix = DMatrix::zeros(count + held, self.coordinates);
        let mut first = 0;
        for group in &self.groups {
            let (_, rows) = self.group_rows(kinematics, group);
            let scaled = |at: usize| rows.column(at) / group.lengths[at];
            let largest = (0..group.lengths.len()).map(|at| scaled(at).amax()).fold(0.0, f64::max);
            let scale = if largest > 0.0 { 1.0 / largest } else { 1.0 };
            for (at, &c) in group.coordinates.iter().enumerate() {
                matrix.view_mut((first, c), (rows.nrows(), 1)).copy_from(&(rows.column(at) * scale));
            }
            first += rows.nrows();
        }
        for held in &self.held {
            let point = kinematics.link_frame(self, held.link).point(&held.point);
            let directions = held.directions();
            let body = self.seats[held.link.index()].body;
            self.for_each_relative_twist(kinematics, body, None, &point, |v, twist| {
                if let Some(f) = self.follows[v] {
                    for (i, direction) in directions.iter().enumerate() {
                        matrix[(first + i, f.index)] += direction.dot(&twist.linear) * f.multiplier;
                    }
                }
            });
            first += directions.len();
        }
        matrix
    }
}

impl Held {
    pub fn rows(&self) -> usize {
        if self.normal.is_some() { 1 } else { 3 }
    }

    /// Held directions in root axes.
    pub fn directions(&self) -> Vec<Vector3<f64>> {
        self.normal.map_or_else(|| vec![Vector3::x(), Vector3::y(), Vector3::z()], |n| vec![n])
    }
}

/// The rows of one closure, in the order of the table at [`ClosureKind`].
fn loop_rows(l: &Loop, x_rp: &Transform<f64>, x_rs: &Transform<f64>, length: f64) -> Vec<Row> {
    let apart = x_rs.translation - x_rp.translation;
    // p along a direction fixed in the predecessor.
    let along = |e: &Vector3<f64>| {
        let direction = x_rp.vector(e);
        Row { residual: direction.dot(&apart), wrench: Wrench::new(Vector3::zeros(), direction) }
    };
    // The cosine between a direction of the predecessor and one of the successor.
    let cosine = |e: &Vector3<f64>, b: &Vector3<f64>| {
        let (e, b) = (x_rp.vector(e), x_rs.vector(b));
        Row { residual: length * e.dot(&b), wrench: Wrench::new(b.cross(&e) * length, Vector3::zeros()) }
    };
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let position = || axes.iter().map(along).collect::<Vec<_>>();
    let across = || l.normals.iter().map(along).collect::<Vec<_>>();
    let parallel = || aligned(l, x_rp, x_rs, length, cosine);
    let rotation = || {
        let angles = rotation_vector(&(x_rp.rotation.transpose() * x_rs.rotation));
        (0..3)
            .map(|k| Row {
                residual: length * angles[k],
                wrench: Wrench::new(x_rp.vector(&axes[k]) * length, Vector3::zeros()),
            })
            .collect::<Vec<_>>()
    };
    let join = |mut a: Vec<Row>, b: Vec<Row>| {
        a.extend(b);
        a
    };
    match l.kind {
        ClosureKind::Fixed => join(position(), rotation()),
        ClosureKind::Revolute => join(position(), parallel()),
        ClosureKind::Prismatic => join(across(), rotation()),
        ClosureKind::Cylindrical => join(across(), parallel()),
        ClosureKind::Universal => join(position(), vec![cosine(&l.axis, &l.axis2)]),
        ClosureKind::Planar => join(vec![along(&l.axis)], parallel()),
        ClosureKind::Spherical => position(),
        ClosureKind::Distance => {
            let norm = apart.norm();
            let direction = if norm > 0.0 { apart / norm } else { x_rp.vector(&Vector3::x()) };
            vec![Row { residual: norm - l.distance, wrench: Wrench::new(Vector3::zeros(), direction) }]
        }
    }
}

/// Two rows that turn the successor's axis onto the predecessor's: the components of the successor's axis along two
/// normals, where they point to one side; beyond 90° their length is stretched so that pointing the other way is no
/// solution.
fn aligned(
    l: &Loop,
    x_rp: &Transform<f64>,
    x_rs: &Transform<f64>,
    length: f64,
    cosine: impl Fn(&Vector3<f64>, &Vector3<f64>) -> Row,
) -> Vec<Row> {
    let mut rows: Vec<Row> = l.normals.iter().map(|e| cosine(e, &l.successor_axis)).collect();
    let along = x_rp.vector(&l.axis).dot(&x_rs.vector(&l.successor_axis));
    if along < 0.0 {
        let size = rows.iter().map(|r| r.residual * r.residual).sum::<f64>().sqrt();
        // sin θ becomes 2 − sin θ: it grows on to the opposite direction.
        let stretch = if size > 1e-9 * length { (2.0 * length - size) / size } else { 0.0 };
        if stretch > 0.0 {
            rows.iter_mut().for_each(|r| r.residual *= stretch);
        } else {
            rows[0].residual = 2.0 * length;
        }
    }
    rows
}

/// The rotation vector (axis times angle, rad) of a rotation matrix.
fn rotation_vector(r: &Matrix3<f64>) -> Vector3<f64> {
    let skew = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) / 2.0;
    let (sine, cosine) = (skew.norm(), (r.trace() - 1.0) / 2.0);
    let angle = sine.atan2(cosine);
    if sine > 1e-6 {
        return skew * (angle / sine);
    }
    if cosine > 0.0 {
        return skew;
    }
    // Half a turn: the axis is the column of R + 1 that is longest.
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
            // Near half a turn the sine has lost digits: √ε.
            assert!((v - axis * angle).norm() < 3e-8, "{angle}: {v}");
        }
        assert!(
            (rotation_vector(&rotation_about(&axis, std::f64::consts::PI)).norm() - std::f64::consts::PI)
                .abs()
                < 1e-7
        );
    }
}
