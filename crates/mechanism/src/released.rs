//! The mechanism whose bushes move.

use crate::{Closure, Coupling, Joint, JointKind, Mechanism};
use percuss_spatial::Transform;
use std::collections::HashMap;

impl Mechanism {
    /// Mechanism at a pose whose joints with bushes are free, drawn at the pose: with all joints at 0, its links are where those of this
    /// mechanism are. Links and joints keep their numbers. A joint that a bush replaces is floating, or fixed if another joint of the same
    /// path is floating; closures that a bush replaces are missing. Limits of positions are dropped.
    ///
    /// `frames`: X_pc, the frame of the child in the parent, of every joint at the pose; `positions`: position of every joint with one
    /// degree of freedom, any value for others.
    pub fn released(&self, frames: &[Transform<f64>], positions: &[f64]) -> Mechanism {
        let mut free: HashMap<usize, JointKind> = HashMap::new();
        for bush in &self.bushes {
            for (i, joint) in bush.joints.iter().enumerate() {
                let is_last = i + 1 == bush.joints.len();
                free.insert(joint.index(), if is_last { JointKind::Floating } else { JointKind::Fixed });
            }
        }
        let mut joints = self.joints.clone();
        for (i, joint) in joints.iter_mut().enumerate() {
            joint.origin = frames[i];
            joint.limits = None;
            if let Some(mimic) = &mut joint.mimic {
                mimic.offset = 0.0;
            }
            if let Some(kind) = free.get(&i) {
                (joint.kind, joint.spring, joint.gear) = (*kind, None, None);
                joint.armature = vec![0.0; kind.dofs()];
            }
        }
        let mut couplings = self.couplings.clone();
        for coupling in &mut couplings {
            coupling.constant -= coupling.terms.iter().map(|(id, f)| f * positions[id.index()]).sum::<f64>();
            if let Some(curve) = &mut coupling.curve {
                curve.offset += curve.terms.iter().map(|(id, g)| g * positions[id.index()]).sum::<f64>();
            }
        }
        let replaced =
            |i: usize| self.bushes.iter().any(|bush| bush.closures.iter().any(|id| id.index() == i));
        let closures = self.closures.iter().enumerate().filter(|(i, _)| !replaced(*i));
        let closures = closures.map(|(_, closure)| closure.clone()).collect();
        self.with_parts(joints, closures, couplings)
    }

    /// Mechanism with the same links and other joints, closures and couplings.
    fn with_parts(&self, joints: Vec<Joint>, closures: Vec<Closure>, couplings: Vec<Coupling>) -> Mechanism {
        Mechanism {
            name: self.name.clone(),
            links: self.links.clone(),
            joints,
            closures,
            couplings,
            contacts: self.contacts.clone(),
            bushes: self.bushes.clone(),
            root: self.root,
            parent_joint: self.parent_joint.clone(),
            child_joints: self.child_joints.clone(),
            order: self.order.clone(),
            link_by_name: self.link_by_name.clone(),
            joint_by_name: self.joint_by_name.clone(),
            characteristic_length: self.characteristic_length,
        }
    }

    /// Mechanism whose joints are all floating, without closures and couplings.
    pub fn disjointed(&self) -> Mechanism {
        let mut joints = self.joints.clone();
        for joint in &mut joints {
            joint.kind = JointKind::Floating;
            joint.armature = vec![0.0; JointKind::Floating.dofs()];
            (joint.mimic, joint.limits, joint.spring, joint.gear) = (None, None, None, None);
        }
        self.with_parts(joints, Vec::new(), Vec::new())
    }
}
