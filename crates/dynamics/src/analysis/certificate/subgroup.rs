//! Loops whose motions form a subgroup of the displacements: rows of a closure that are zero at all positions.
//!
//! | joints of the tree along the loop | constant in every link | implied |
//! |---|---|---|
//! | hinges along one direction a, slides | a | a is parallel to itself |
//! | and slides normal to a, with offsets along a of sum zero | distance along a | this distance is zero |
//! | hinges with axes through one point | the point | the point coincides with itself |
//!
//! Assumption: equal `f64` numbers of the loaded model are equal quantities. Products are compared by their factors, so the comparison adds
//! no rounding.
//!
//! Source: Hervé 1999 (Mechanism and Machine Theory 34).

use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::{Closure, Joint, JointKind, LoopFrame, Mechanism};

/// Joints of the tree from the two ends of a closure to their common link.
pub(super) struct Circuit<'a> {
    closure: &'a Closure,
    sides: [Vec<&'a Joint>; 2],
}

impl<'a> Circuit<'a> {
    /// `None` if the loop contains the motion of a floating root link.
    pub fn new(mechanism: &'a Mechanism, closure: &'a Closure, floats: bool) -> Option<Self> {
        let is_relative = closure.predecessor().link.is_some() == closure.successor().link.is_some();
        (is_relative || !floats).then_some(())?;
        let to_root = |end: &LoopFrame| {
            let above = |link| mechanism.parent_joint(link).map(|id| mechanism.joint(id));
            let first = end.link.and_then(above);
            std::iter::successors(first, |joint| above(joint.parent())).collect::<Vec<_>>()
        };
        let mut sides = [closure.predecessor(), closure.successor()].map(to_root);
        while let [Some(a), Some(b)] = sides.each_ref().map(|side| side.last())
            && std::ptr::eq(*a, *b)
        {
            sides.iter_mut().for_each(|side| side.truncate(side.len() - 1));
        }
        Some(Self { closure, sides })
    }

    /// `Some` if a direction, given in both loop frames, is the same in all links; true if all points keep their distance along it.
    pub fn keeps_direction(&self, directions: [&Vector3<f64>; 2]) -> Option<bool> {
        let ends = [self.closure.predecessor(), self.closure.successor()];
        let (mut offset, mut is_planar) = (Vec::new(), true);
        let mut at_top = [Vector3::zeros(); 2];
        for (k, sign) in [1.0, -1.0].into_iter().enumerate() {
            let mut a = turned(&ends[k].frame.rotation, directions[k])?;
            add_products(&mut offset, &a, &ends[k].frame.translation, sign);
            for joint in &self.sides[k] {
                match joint.kind() {
                    JointKind::Fixed => {}
                    JointKind::Revolute | JointKind::Continuous | JointKind::Planar => {
                        (*joint.axis() == a || *joint.axis() == -a).then_some(())?;
                    }
                    JointKind::Prismatic => {
                        let mut along = Vec::new();
                        add_products(&mut along, &a, joint.axis(), 1.0);
                        is_planar &= along.is_empty();
                    }
                    JointKind::Spherical | JointKind::Floating => return None,
                }
                a = turned(&joint.origin().rotation, &a)?;
                add_products(&mut offset, &a, &joint.origin().translation, sign);
            }
            at_top[k] = a;
        }
        (at_top[0] == at_top[1]).then_some(is_planar && offset.is_empty())
    }

    /// True if the origins of the loop frames are one point at all positions.
    pub fn keeps_origin(&self) -> bool {
        let at_top = |end: &LoopFrame, joints: &[&Joint]| {
            let mut p = end.frame.translation;
            for joint in joints {
                let is_kept = match joint.kind() {
                    JointKind::Fixed => true,
                    JointKind::Revolute | JointKind::Continuous => {
                        let axis = joint.axis();
                        let is_coordinate = axis.iter().filter(|a| **a != 0.0).count() == 1;
                        p == Vector3::zeros()
                            || is_coordinate && p.iter().zip(axis).all(|(p, a)| *p == 0.0 || *a != 0.0)
                    }
                    JointKind::Spherical => p == Vector3::zeros(),
                    JointKind::Prismatic | JointKind::Planar | JointKind::Floating => false,
                };
                let (p1, p2) = (turned(&joint.origin().rotation, &p)?, joint.origin().translation);
                (is_kept && p1.component_mul(&p2) == Vector3::zeros()).then_some(())?;
                p = p1 + p2;
            }
            Some(p)
        };
        let [left, right] = &self.sides;
        let left = at_top(self.closure.predecessor(), left);
        left.is_some() && left == at_top(self.closure.successor(), right)
    }
}

/// R v, if each component is zero or one product with a factor ±1.
fn turned(rotation: &Matrix3<f64>, v: &Vector3<f64>) -> Option<Vector3<f64>> {
    let mut sum = Vector3::zeros();
    for (i, k) in (0..3).flat_map(|i| [(i, 0), (i, 1), (i, 2)]) {
        let (r, x) = (rotation[(i, k)], v[k]);
        if r != 0.0 && x != 0.0 {
            (sum[i] == 0.0 && (r.abs() == 1.0 || x.abs() == 1.0)).then_some(())?;
            sum[i] = r * x;
        }
    }
    Some(sum)
}

/// Adds the products aᵢ pᵢ, times a sign, to a sum of products; products that cancel are left out.
fn add_products(sum: &mut Vec<[f64; 2]>, a: &Vector3<f64>, p: &Vector3<f64>, sign: f64) {
    for (a, p) in a.iter().zip(p).filter(|(a, p)| **a != 0.0 && **p != 0.0) {
        let [small, large] = [a.abs().min(p.abs()), a.abs().max(p.abs()) * sign * a.signum() * p.signum()];
        match sum.iter().position(|other| *other == [small, -large]) {
            Some(other) => {
                sum.swap_remove(other);
            }
            None => sum.push([small, large]),
        }
    }
}
