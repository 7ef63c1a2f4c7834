//! Reference mechanics of a mechanism at the design position, with dense matrices and 4×4 transforms. Only the data
//! of the crates under test are used, none of their algorithms.

use nalgebra::{DMatrix, DVector, Matrix4, Vector3};
use percuss_mechanism::{ClosureKind, JointKind, LinkId, LoopFrame, Mechanism};

/// X_wl of every link, all joints at 0; the world frame is the frame of the root link.
pub fn poses(mechanism: &Mechanism) -> Vec<Matrix4<f64>> {
    let mut poses = vec![Matrix4::identity(); mechanism.links().len()];
    for &link in mechanism.order() {
        if let Some(joint) = mechanism.parent_joint(link) {
            let joint = mechanism.joint(joint);
            let mut origin = Matrix4::identity();
            origin.fixed_view_mut::<3, 3>(0, 0).copy_from(&joint.origin().rotation);
            origin.fixed_view_mut::<3, 1>(0, 3).copy_from(&joint.origin().translation);
            poses[link.index()] = poses[joint.parent().index()] * origin;
        }
    }
    poses
}

/// Position of a link's origin.
pub fn place(mechanism: &Mechanism, name: &str) -> Vector3<f64> {
    let link = mechanism.find_link(name).unwrap();
    poses(mechanism)[link.index()].fixed_view::<3, 1>(0, 3).into_owned()
}

fn point(poses: &[Matrix4<f64>], frame: &LoopFrame) -> Vector3<f64> {
    let p = frame.frame.translation.push(1.0);
    let p = frame.link.map_or(p, |link| poses[link.index()] * p);
    p.xyz()
}

/// Opening of each closure, m.
pub fn residuals(mechanism: &Mechanism) -> Vec<f64> {
    let poses = poses(mechanism);
    let gap = |c: &percuss_mechanism::Closure| point(&poses, c.successor()) - point(&poses, c.predecessor());
    let open = |c: &percuss_mechanism::Closure| match c.kind() {
        ClosureKind::Spherical => gap(c).norm(),
        ClosureKind::Distance => (gap(c).norm() - c.distance().unwrap()).abs(),
        // Loop frames are parallel at the design position.
        ClosureKind::Cylindrical => gap(c).cross(c.axis()).norm(),
        other => panic!("no {other:?} is expected"),
    };
    assert!(mechanism.links().iter().zip(&poses).all(|(_, x)| x.fixed_view::<3, 3>(0, 0).is_identity(0.0)));
    mechanism.closures().iter().map(open).collect()
}

/// Response at a contact.
pub struct ContactResponse {
    /// m̄, kg.
    pub mass: f64,
    /// Number of velocities minus number of constraint rows, which must be independent.
    pub mobility: usize,
    /// Velocity of each link's origin at unit closing speed.
    pub speeds: Vec<Vector3<f64>>,
}

/// Unit motion of a joint: child link (its subtree moves too), angular part, point on the axis, linear part.
type Motion = (LinkId, Vector3<f64>, Vector3<f64>, Vector3<f64>);

/// Rows that are independent of those before, by orthogonalisation: a planar loop that a ball joint closes has a redundant row.
fn independent(rows: Vec<DVector<f64>>) -> Vec<DVector<f64>> {
    let (mut basis, mut kept) = (Vec::<DVector<f64>>::new(), Vec::new());
    for row in rows {
        let mut rest = row.clone();
        for _ in 0..2 {
            basis.iter().for_each(|e| rest -= e * e.dot(&rest));
        }
        // The rows of these linkages have parts of 0.1 m and more, or none but roundings.
        if rest.norm() > 1e-9 * row.norm() {
            basis.push(rest.normalize());
            kept.push(row);
        }
    }
    kept
}

/// Contact response at a link's origin along a direction, with a fixed root and some joints locked:
/// M v + Aᵀλ + jᵀμ = 0, A v = 0, j v = 1; m̄ = vᵀMv = −μ.
pub fn respond(mechanism: &Mechanism, on: &str, along: Vector3<f64>, locked: &[&str]) -> ContactResponse {
    let poses = poses(mechanism);
    let places: Vec<Vector3<f64>> = poses.iter().map(|x| x.fixed_view::<3, 1>(0, 3).into_owned()).collect();
    let mut motions: Vec<Motion> = Vec::new();
    for joint in mechanism.joints().iter().filter(|j| !locked.contains(&j.name())) {
        let (link, at) = (joint.child(), places[joint.child().index()]);
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let turns = axes.map(|a| (link, a, at, Vector3::zeros()));
        match joint.kind() {
            JointKind::Fixed => {}
            JointKind::Revolute | JointKind::Continuous => {
                motions.push((link, *joint.axis(), at, Vector3::zeros()))
            }
            JointKind::Prismatic => motions.push((link, Vector3::zeros(), at, *joint.axis())),
            JointKind::Spherical => motions.extend(turns),
            JointKind::Floating => {
                motions.extend(turns);
                motions.extend(axes.map(|a| (link, Vector3::zeros(), at, a)));
            }
            JointKind::Planar => panic!("no planar joint is expected"),
        }
    }
    let n = motions.len();
    let carries = |above: LinkId, mut link: LinkId| loop {
        if link == above {
            return true;
        }
        match mechanism.parent_joint(link) {
            Some(joint) => link = mechanism.joint(joint).parent(),
            None => return false,
        }
    };
    let turning = |link: LinkId, v: usize| {
        if carries(motions[v].0, link) { motions[v].1 } else { Vector3::zeros() }
    };
    let moving = |link: LinkId, at: Vector3<f64>, v: usize| {
        let (above, angular, axis, linear) = motions[v];
        if carries(above, link) { linear + angular.cross(&(at - axis)) } else { Vector3::zeros() }
    };
    let mut mass_matrix = DMatrix::zeros(n, n);
    for (id, link) in mechanism.link_ids().zip(mechanism.links()) {
        let Some(inertial) = link.inertial() else { continue };
        let com = places[id.index()] + inertial.com;
        for (i, k) in (0..n).flat_map(|i| (0..n).map(move |k| (i, k))) {
            mass_matrix[(i, k)] += inertial.mass * moving(id, com, i).dot(&moving(id, com, k))
                + turning(id, i).dot(&(inertial.about_com * turning(id, k)));
        }
    }
    let mut rows: Vec<DVector<f64>> = Vec::new();
    for closure in mechanism.closures() {
        let [p, s] = [closure.predecessor(), closure.successor()];
        let [at_p, at_s] = [p, s].map(|frame| point(&poses, frame));
        let [p, s] = [p, s].map(|frame| frame.link.unwrap());
        let gap = |v| moving(s, at_s, v) - moving(p, at_p, v);
        let turn = |v| turning(s, v) - turning(p, v);
        let mut along = |a: Vector3<f64>| rows.push(DVector::from_fn(n, |v, _| a.dot(&gap(v))));
        match closure.kind() {
            ClosureKind::Spherical => [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().for_each(along),
            ClosureKind::Distance => along((at_s - at_p).normalize()),
            ClosureKind::Cylindrical => {
                let a = closure.axis();
                let first = a.cross(&Vector3::x()).normalize();
                for across in [first, a.cross(&first)] {
                    rows.push(DVector::from_fn(n, |v, _| across.dot(&gap(v))));
                    rows.push(DVector::from_fn(n, |v, _| across.dot(&turn(v))));
                }
            }
            other => panic!("no {other:?} is expected"),
        }
    }
    let mut rows = independent(rows);
    let mobility = n - rows.len();
    let struck = mechanism.find_link(on).unwrap();
    rows.push(DVector::from_fn(n, |v, _| along.dot(&moving(struck, places[struck.index()], v))));
    let m = rows.len();
    let mut saddle = DMatrix::zeros(n + m, n + m);
    saddle.view_mut((0, 0), (n, n)).copy_from(&mass_matrix);
    for (i, row) in rows.iter().enumerate() {
        saddle.view_mut((0, n + i), (n, 1)).copy_from(row);
        saddle.view_mut((n + i, 0), (1, n)).copy_from(&row.transpose());
    }
    let mut right = DVector::zeros(n + m);
    right[n + m - 1] = 1.0;
    let solution = saddle.lu().solve(&right).expect("independent rows");
    let speeds = mechanism
        .link_ids()
        .map(|id| (0..n).map(|v| moving(id, places[id.index()], v) * solution[v]).sum())
        .collect();
    ContactResponse { mass: -solution[n + m - 1], mobility, speeds }
}
