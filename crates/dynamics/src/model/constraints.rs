//! Compilation of closures, couplings and held contacts.

use super::Model;
use super::body::LinkFrame;
use super::compile::ZeroFrames;
use super::constraint::{CompiledClosure, CompiledCoupling, CouplingTerm};
use crate::model::conditions::CompiledHold;
use crate::tolerances::REVERSED_AXES;
use percuss_mechanism::{ClosureKind, JointId, LoopFrame};
use percuss_spatial::Transform;
use std::collections::HashMap;

impl Model {
    /// Compiles the closures, couplings and held contacts, after the bodies are numbered.
    pub(super) fn compile_constraints(&mut self, holds: &[CompiledHold]) {
        let mechanism = std::sync::Arc::clone(&self.mechanism);
        if mechanism.closures().is_empty() && mechanism.couplings().is_empty() {
            self.holds = holds.to_vec();
            return;
        }
        let zero = ZeroFrames::of(self);
        for closure in mechanism.closures() {
            let (axis, axis2) = (*closure.axis(), *closure.axis2());
            let (e1, e2) = percuss_spatial::plane_basis(&axis);
            let [predecessor, successor] =
                [closure.predecessor(), closure.successor()].map(|end| self.loop_frame(end));
            let [x_rp, x_rs] = [&predecessor, &successor].map(|end| zero.frame_of(end));
            let distance = closure.distance();
            let aligned = matches!(
                closure.kind(),
                ClosureKind::Revolute | ClosureKind::Cylindrical | ClosureKind::Planar
            );
            let opposite = x_rp.vector(&axis).dot(&x_rs.vector(&axis)) < REVERSED_AXES * axis.norm_squared();
            self.closures.push(CompiledClosure {
                name: closure.name().to_owned(),
                kind: closure.kind(),
                predecessor,
                successor,
                axis,
                successor_axis: if aligned && opposite { -axis } else { axis },
                normals: [e1, e2],
                axis2,
                distance: distance.unwrap_or_else(|| (x_rs.translation - x_rp.translation).norm()),
                measured_distance: distance.is_none(),
            });
        }
        for coupling in mechanism.couplings() {
            let curve = coupling.curve();
            let argument: HashMap<JointId, f64> =
                curve.iter().flat_map(|curve| curve.terms()).copied().collect();
            let term = |&(joint, factor): &(JointId, f64)| {
                let body = self.body_of_joint[joint.index()]?;
                let q = self.joint_q[joint.index()].start;
                let argument = argument.get(&joint).copied().unwrap_or(0.0);
                Some(CouplingTerm { q, body, factor, argument })
            };
            let first = coupling.terms().first();
            self.couplings.push(CompiledCoupling {
                name: coupling.name().to_owned(),
                terms: coupling.terms().iter().filter_map(term).collect(),
                turns: first.is_some_and(|(j, _)| mechanism.joint(*j).kind().turns(0)),
                constant: coupling.constant(),
                offset: curve.map_or(0.0, |curve| curve.offset()),
                curve: curve.map(|curve| curve.coefficients()),
            });
        }
        self.holds = holds.to_vec();
    }

    /// Loop frame of a closure's end on its body.
    fn loop_frame(&self, end: &LoopFrame) -> LinkFrame {
        let ground = LinkFrame { body: None, frame: Transform::identity() };
        let of_link = end.link.map_or(ground, |link| self.link_frames[link.index()].clone());
        LinkFrame { body: of_link.body, frame: of_link.frame * end.frame }
    }
}
