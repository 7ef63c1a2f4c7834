//! Constraint rows of closures, couplings and held contacts.

use super::joints::JointInWorld;
use super::residual::{across, coupling_entries, distance, loop_frame_in_world};
use super::row::{Row, WORLD, com, rotation, translation, velocity_row};
use super::{Held, Question};
use nalgebra::{Matrix4, Vector3};
use percuss_mechanism::{Closure, ClosureKind, LinkId, Mechanism};

/// Rows of all closures, couplings and held contacts, in this order.
pub(super) fn rows(question: &Question, placed: &[JointInWorld], x_wl: &[Matrix4<f64>]) -> Vec<Row> {
    let mechanism = question.mechanism;
    let mut rows = Vec::new();
    for closure in mechanism.closures() {
        let of_closure = ClosureInWorld::new(closure, mechanism, x_wl).rows(closure);
        debug_assert_eq!(of_closure.len(), closure.kind().rows());
        rows.extend(of_closure);
    }
    for coupling in mechanism.couplings() {
        let rate = |row: Row, (joint, factor): (percuss_mechanism::JointId, f64)| {
            row.add_scaled(factor, &placed[joint.index()].rates().swap_remove(0))
        };
        rows.push(coupling_entries(coupling, &question.positions).into_iter().fold(Row::default(), rate));
    }
    for Held { link, point, normal } in &question.held {
        let arm = rotation(&x_wl[link.index()]) * (point - com(mechanism.link(*link)));
        let row = |n: &Vector3<f64>| velocity_row(link.index(), &arm, n);
        match normal {
            Some(normal) => rows.push(row(normal)),
            None => rows.extend(WORLD.iter().map(|n| row(&Vector3::from(*n)))),
        }
    }
    rows
}

/// Both ends of a closure in world axes; the world has no velocity and no entry in the rows.
struct ClosureInWorld {
    /// Predecessor, and vector from its centre of mass to the successor's loop frame.
    predecessor: Option<(LinkId, Vector3<f64>)>,
    /// Successor, and vector from its centre of mass to its loop frame.
    successor: Option<(LinkId, Vector3<f64>)>,
    /// Vector from the predecessor's to the successor's loop frame.
    gap: Vector3<f64>,
    /// Orientation of the predecessor's loop frame in the world.
    r_wp: nalgebra::Matrix3<f64>,
    /// Orientation of the successor's loop frame in the world.
    r_ws: nalgebra::Matrix3<f64>,
}

impl ClosureInWorld {
    fn new(closure: &Closure, mechanism: &Mechanism, x_wl: &[Matrix4<f64>]) -> Self {
        let x_wp = loop_frame_in_world(closure.predecessor(), x_wl);
        let x_ws = loop_frame_in_world(closure.successor(), x_wl);
        let gap = translation(&x_ws) - translation(&x_wp);
        let arm = |end: &percuss_mechanism::LoopFrame| {
            let link = end.link?;
            let from_com = end.frame.translation - com(mechanism.link(link));
            Some((link, rotation(&x_wl[link.index()]) * from_com))
        };
        Self {
            predecessor: arm(closure.predecessor()).map(|(link, arm)| (link, arm + gap)),
            successor: arm(closure.successor()),
            gap,
            r_wp: rotation(&x_wp),
            r_ws: rotation(&x_ws),
        }
    }

    /// n · (velocity of the successor's origin relative to the coincident point of the predecessor).
    fn linear(&self, n: &Vector3<f64>) -> Row {
        let side = |end: &Option<(LinkId, Vector3<f64>)>| {
            end.map_or_else(Row::default, |(link, arm)| velocity_row(link.index(), &arm, n))
        };
        side(&self.successor).add_scaled(-1.0, &side(&self.predecessor))
    }

    /// n · (angular velocity of the successor relative to the predecessor).
    fn angular(&self, n: &Vector3<f64>) -> Row {
        let side = |end: &Option<(LinkId, Vector3<f64>)>| {
            end.map_or_else(Row::default, |(link, _)| Row(vec![(link.index(), *n, Vector3::zeros())]))
        };
        side(&self.successor).add_scaled(-1.0, &side(&self.predecessor))
    }

    /// Time derivatives of the constraint functions of the kind, in the order of its table.
    fn rows(&self, closure: &Closure) -> Vec<Row> {
        let axis = self.r_wp * closure.axis();
        let sides = || across(closure.axis()).map(|e| self.r_wp * e);
        let world = WORLD.map(Vector3::from);
        let all_linear = || world.iter().map(|n| self.linear(n));
        let all_angular = || world.iter().map(|n| self.angular(n));
        let across_linear = || sides().map(|e| self.linear(&e));
        // The successor's axis has no component along e: (ω × a) · e = ω · (a × e) = 0.
        let no_tilt = || sides().map(|e| self.angular(&(self.r_ws * closure.axis()).cross(&e)));
        match closure.kind() {
            ClosureKind::Fixed => all_linear().chain(all_angular()).collect(),
            ClosureKind::Revolute => all_linear().chain(no_tilt()).collect(),
            ClosureKind::Prismatic => across_linear().into_iter().chain(all_angular()).collect(),
            ClosureKind::Cylindrical => across_linear().into_iter().chain(no_tilt()).collect(),
            ClosureKind::Universal => {
                // a · b = 0 with b on the successor: ω · (b × a) = 0.
                let pin = self.r_ws * closure.axis2();
                all_linear().chain([self.angular(&pin.cross(&axis))]).collect()
            }
            ClosureKind::Planar => [self.linear(&axis)].into_iter().chain(no_tilt()).collect(),
            ClosureKind::Spherical => all_linear().collect(),
            ClosureKind::Distance => {
                let length = distance(&self.gap);
                let along = if length > 0.0 { self.gap / length } else { Vector3::zeros() };
                vec![self.linear(&along)]
            }
        }
    }
}
