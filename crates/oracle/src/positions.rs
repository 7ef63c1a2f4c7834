//! Dependent positions: the zero position, and mimics.

use percuss_mechanism::{JointKind, Mechanism};

/// Zero position: quaternions 1,0,0,0; mimics at their offsets.
pub fn zero_positions(mechanism: &Mechanism) -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = Vec::with_capacity(mechanism.joints().len());
    for joint in mechanism.joints() {
        all.push(match joint.kind() {
            JointKind::Spherical => vec![1.0, 0.0, 0.0, 0.0],
            JointKind::Floating => vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
            kind @ (JointKind::Fixed
            | JointKind::Revolute
            | JointKind::Continuous
            | JointKind::Prismatic
            | JointKind::Planar) => vec![0.0; kind.positions()],
        });
    }
    follow(mechanism, &mut all);
    all
}

/// Sets the position of every mimic from its master.
pub fn follow(mechanism: &Mechanism, positions: &mut [Vec<f64>]) {
    for (i, joint) in mechanism.joints().iter().enumerate() {
        if let Some(mimic) = joint.mimic() {
            positions[i] = vec![mimic.multiplier * positions[mimic.master.index()][0] + mimic.offset];
        }
    }
}
