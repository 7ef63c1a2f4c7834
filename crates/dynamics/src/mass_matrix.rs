//! Composite rigid body algorithm: the mass matrix of the tree.

use crate::System;
use crate::kinematics::Kinematics;
use nalgebra::DMatrix;
use percuss_spatial::{Scalar, SpatialInertia};

/// M over the velocities of the tree (mimics not yet folded), each pair in the coordinates of the upper body.
///
/// Featherstone 2008, table 6.2: composites Iᶜ are summed towards the root; column i is Iᶜᵢ Sᵢ carried up the
/// chain, M_ji = Sⱼᵀ ʲF.
pub(crate) fn over_tree<T: Scalar>(system: &System, kinematics: &Kinematics<T>) -> DMatrix<T> {
    let composites = composites(system, kinematics);
    let n = system.follows.len();
    let mut mass = DMatrix::from_element(n, n, T::zero());
    for (i, body) in system.bodies.iter().enumerate() {
        for (k, column) in body.v.clone().enumerate() {
            let mut force = composites[i].momentum(&kinematics.column(system, i, k));
            for (l, row) in body.v.clone().enumerate() {
                mass[(row, column)] = force.power(&kinematics.column(system, i, l));
            }
            mass[(column, column)] += T::from_f64(body.armature[k]);
            let mut j = i;
            while let Some(parent) = system.bodies[j].parent {
                force = kinematics.steps[j].wrench(&force);
                j = parent;
                for (l, row) in system.bodies[j].v.clone().enumerate() {
                    let entry = force.power(&kinematics.column(system, j, l));
                    mass[(row, column)] = entry;
                    mass[(column, row)] = entry;
                }
            }
        }
    }
    mass
}

/// For every velocity of the tree, the size of the terms whose sum is its diagonal entry of M: below ε times this,
/// the entry is rounding.
pub(crate) fn diagonal_sizes(system: &System, kinematics: &Kinematics<f64>) -> Vec<f64> {
    let composites = composites(system, kinematics);
    let mut sizes = vec![0.0; system.follows.len()];
    for (i, body) in system.bodies.iter().enumerate() {
        for (k, v) in body.v.clone().enumerate() {
            let s = kinematics.column(system, i, k);
            let (turn, slide) = (s.angular.norm(), s.linear.norm());
            let composite = &composites[i];
            sizes[v] = turn * turn * composite.rotational.amax()
                + 2.0 * turn * slide * composite.first_moment.amax()
                + slide * slide * composite.mass.abs()
                + body.armature[k];
        }
    }
    sizes
}

/// Inertia of every body and all it carries, in its own axes about its own origin.
fn composites<T: Scalar>(system: &System, kinematics: &Kinematics<T>) -> Vec<SpatialInertia<T>> {
    let mut composites: Vec<SpatialInertia<T>> = system.bodies.iter().map(|b| b.inertia.cast()).collect();
    for i in (0..composites.len()).rev() {
        if let Some(parent) = system.bodies[i].parent {
            let carried = kinematics.steps[i].inertia(&composites[i]);
            composites[parent] += carried;
        }
    }
    composites
}
