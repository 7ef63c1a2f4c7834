//! Composite rigid body algorithm: mass matrix of the tree.

use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use nalgebra::DMatrix;
use percuss_spatial::SpatialInertia;

/// M over the tree velocities (mimics not yet folded). Each entry is computed in the coordinates of the upper body.
///
/// Featherstone 2008, table 6.2: the composite inertias Iᶜ are summed towards the root. The force of column i, Iᶜᵢ
/// Sᵢ, is propagated up the chain, M_ji = Sⱼᵀ ʲF.
fn tree_mass_matrix(model: &Model, kinematics: &Kinematics) -> DMatrix<f64> {
    let composites = composites(model, kinematics);
    let n = model.velocity_coordinates.len();
    let mut mass = DMatrix::from_element(n, n, 0.0);
    for (i, body) in model.bodies.iter().enumerate() {
        for (k, column) in body.v.clone().enumerate() {
            let mut force = composites[i].momentum(&kinematics.column(model, i, k));
            for (l, row) in body.v.clone().enumerate() {
                mass[(row, column)] = force.power(&kinematics.column(model, i, l));
            }
            mass[(column, column)] += body.armature[k];
            let mut j = i;
            while let Some(parent) = model.bodies[j].parent {
                force = kinematics.parent_transforms[j].wrench(&force);
                j = parent;
                for (l, row) in model.bodies[j].v.clone().enumerate() {
                    let entry = force.power(&kinematics.column(model, j, l));
                    mass[(row, column)] = entry;
                    mass[(column, row)] = entry;
                }
            }
        }
    }
    mass
}

/// For every tree velocity: sum of the term magnitudes of the diagonal entry of M. An entry below ε times this sum is
/// rounding.
fn diagonal_sizes(model: &Model, kinematics: &Kinematics) -> Vec<f64> {
    let composites = composites(model, kinematics);
    let mut sizes = vec![0.0; model.velocity_coordinates.len()];
    for (i, body) in model.bodies.iter().enumerate() {
        for (k, v) in body.v.clone().enumerate() {
            let s = kinematics.column(model, i, k);
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

/// Composite inertia of every body and its subtree, in the body's axes about its origin.
fn composites(model: &Model, kinematics: &Kinematics) -> Vec<SpatialInertia<f64>> {
    let mut composites: Vec<SpatialInertia<f64>> = model.bodies.iter().map(|b| b.inertia).collect();
    for i in (0..composites.len()).rev() {
        if let Some(parent) = model.bodies[i].parent {
            let in_parent = kinematics.parent_transforms[i].inertia(&composites[i]);
            composites[parent] += in_parent;
        }
    }
    composites
}

impl Model {
    /// Sums the rows and columns of a matrix over tree velocities into a matrix over the coordinates: GᵀMG.
    pub fn reduce(&self, tree: DMatrix<f64>) -> DMatrix<f64> {
        if !self.has_active_mimics {
            return tree;
        }
        let n = self.coordinates.len();
        let mut reduced = DMatrix::from_element(n, n, 0.0);
        for (c, to_c) in self.velocity_coordinates.iter().enumerate() {
            for (r, to_r) in self.velocity_coordinates.iter().enumerate() {
                if let (Some(a), Some(b)) = (to_r, to_c) {
                    let factor = a.multiplier * b.multiplier;
                    reduced[(a.index, b.index)] += tree[(r, c)] * factor;
                }
            }
        }
        reduced
    }

    /// M over the coordinates, n×n.
    pub fn mass_matrix(&self, kinematics: &Kinematics) -> DMatrix<f64> {
        self.reduce(tree_mass_matrix(self, kinematics))
    }

    /// For every coordinate: sum of the term magnitudes of the diagonal entry of M.
    pub fn mass_sizes(&self, kinematics: &Kinematics) -> Vec<f64> {
        self.reduce_vector(&diagonal_sizes(self, kinematics), |multiplier| multiplier * multiplier)
    }
}
