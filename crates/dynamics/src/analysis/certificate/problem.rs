//! Parts of a proof at a pose.

use super::load::Load;
use super::loops::{Closed, Closing, Loops};
use super::plan::{self, Plan};
use super::records::{NoCertificate, RangeProof};
use crate::analysis::pose::Pose;
use crate::kinematics::contact::Contact;
use crate::model::Model;
use percuss_mechanism::JointKind;
use percuss_spatial::Interval;
use std::f64::consts::FRAC_PI_2;

/// Parts of a proof at a pose.
pub(super) struct Problem<'a> {
    pub model: &'a Model,
    pub plan: Plan<Interval>,
    pub load: Load<Interval>,
    pub loops: Loops,
    /// Position of each coordinate with one.
    pub position_of: Vec<Option<usize>>,
    /// Coordinates with given positions.
    pub free: Vec<bool>,
    pub rank: usize,
    /// Positions of all joints as written; 0 for a spherical joint, relative to its rotation.
    pub q: Vec<Interval>,
}

impl<'a> Problem<'a> {
    pub fn new(pose: &'a Pose, contact: &Contact) -> Result<Self, NoCertificate> {
        pose.locate(contact)?;
        let model = pose.assembly.model();
        if model.coordinates.is_empty() {
            return Err(NoCertificate::Immovable);
        }
        let mut q = pose.positions().to_vec();
        let (plan, links, bodies) = Plan::of(model, &q);
        let load = Load::of(contact, &links, pose.base());
        let loops = Loops::of(model, &plan, &links, &bodies).ok_or(NoCertificate::Unsupported)?;
        if !loops.is_empty() && !pose.assembly.has_single_model() {
            return Err(NoCertificate::Unsupported);
        }
        let drivers = pose.loops().map_or(&[][..], |loops| &loops.drivers);
        let (mut position_of, mut free) = (Vec::new(), Vec::new());
        let grouped: Vec<usize> = model.groups.iter().flat_map(|group| group.coordinates.clone()).collect();
        for (index, coordinate) in model.coordinates.iter().enumerate() {
            let start = coordinate.joint.map(|joint| model.joint_q[joint.index()].start);
            position_of.push(match coordinate.joint.map(|joint| model.mechanism.joint(joint).kind()) {
                Some(JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic) => start,
                Some(JointKind::Planar | JointKind::Spherical) => {
                    start.map(|start| start + coordinate.component)
                }
                _ => None,
            });
            let given = coordinate.joint.is_none_or(|joint| drivers.contains(&joint));
            free.push(given || !grouped.contains(&index));
        }
        for (joint, range) in model.mechanism.joints().iter().zip(&model.joint_q) {
            if joint.kind() == JointKind::Spherical {
                q[range.clone()].fill(0.0);
            }
        }
        let rank = (0..model.groups.len()).map(|group| pose.assembly.expected_rank(group)).sum();
        Ok(Self {
            model,
            plan,
            load,
            loops,
            position_of,
            free,
            rank,
            q: q.into_iter().map(plan::position).collect(),
        })
    }

    /// Varies the point and the normal of the contact for the cone and the edges of a proof; returns the ranges of the further positions.
    pub fn vary_contact(&mut self, proof: &RangeProof) -> Result<Vec<(usize, f64, f64)>, NoCertificate> {
        if !proof.varies_contact() {
            return Ok(Vec::new());
        }
        let [from, to] = proof.cone;
        let first = self.q.len();
        let is_valid = 0.0 <= from
            && from <= to
            && to <= FRAC_PI_2
            && proof.edges.iter().flatten().all(|x| x.is_finite());
        let is_valid = is_valid && self.loops.is_empty();
        let varied = is_valid.then(|| self.load.vary(&mut self.plan, proof, first)).flatten();
        let varied = varied.ok_or(NoCertificate::VariedContact)?;
        self.q.extend(varied.iter().map(|(_, lower, upper)| Interval::point(0.5 * lower + 0.5 * upper)));
        Ok(varied)
    }

    pub fn closing(&self) -> Closing<'_> {
        Closing { plan: &self.plan, loops: &self.loops, position_of: &self.position_of, free: &self.free }
    }

    /// Proved assembly near the positions `q`, of which the given ones may be intervals.
    pub fn close(&self, q: &[Interval]) -> Result<Closed, NoCertificate> {
        if self.loops.is_empty() {
            return Ok(Closed { q: q.to_vec(), rows: Vec::new(), dependent: Vec::new() });
        }
        let closed = self.closing().close(q).ok_or(NoCertificate::NotClosed)?;
        let dependents = self.free.iter().filter(|free| !**free).count();
        if closed.rows.len() != self.rank || closed.dependent.len() != dependents {
            return Err(NoCertificate::ChangePoint);
        }
        Ok(closed)
    }

    /// Omitted rows without a proof that they are implied, with their residuals.
    pub fn omitted(&self, closed: &Closed) -> Vec<(String, f64)> {
        let residuals = self.loops.residuals(&self.plan, &closed.q);
        let omitted = (0..residuals.len()).filter(|row| !closed.rows.contains(row));
        omitted.map(|row| (self.loops.names[row].clone(), residuals[row].magnitude())).collect()
    }
}
