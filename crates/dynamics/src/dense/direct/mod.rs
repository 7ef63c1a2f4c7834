//! Dense route: direct solution of the least-energy problem. Reference for the recursion, and fallback for mechanisms
//! that the recursion declines.

mod least_energy;
mod mass_matrix;

pub(crate) use least_energy::{LeastEnergy, LeastEnergySolution, Minimum, condition_of};

use crate::kinematics::contact::LocatedContact;
use crate::kinematics::frames::Kinematics;
use crate::mobility::GroupMobility;
use crate::model::{Group, Model};
use nalgebra::DMatrix;

impl Model {
    /// All rows of A over the coordinates, group after group. Each group is scaled to a largest entry of 1, so that
    /// ranks of groups do not depend on one another.
    pub fn constraint_matrix(&self, kinematics: &Kinematics) -> DMatrix<f64> {
        let count: usize = self.groups.iter().map(|g| g.rows).sum();
        let mut matrix = DMatrix::zeros(count, self.coordinates.len());
        let mut first = 0;
        for group in &self.groups {
            let rows = self.group_matrix(kinematics, group);
            let scale = 1.0 / largest_scaled(&rows, group);
            for (at, &c) in group.coordinates.iter().enumerate() {
                matrix.view_mut((first, c), (rows.nrows(), 1)).copy_from(&(rows.column(at) * scale));
            }
            first += rows.nrows();
        }
        matrix
    }

    /// Independent rows of A as decided for each group, group after group. Each row is scaled to a largest entry of 1
    /// over the group's scaled coordinates. Groups share no coordinates, so all rows together are as independent as
    /// the rows of each group.
    fn independent_constraint_rows(&self, kinematics: &Kinematics, groups: &[GroupMobility]) -> DMatrix<f64> {
        let count = groups.iter().map(|known| known.pivots.rows.len()).sum();
        let mut matrix = DMatrix::zeros(count, self.coordinates.len());
        let mut next = 0;
        for (group, known) in self.groups.iter().zip(groups) {
            let rows = self.group_matrix(kinematics, group);
            for &r in &known.pivots.rows {
                let row = rows.row(r);
                let largest =
                    (0..row.len()).map(|at| (row[at] / group.lengths[at]).abs()).fold(0.0, f64::max);
                for (at, &c) in group.coordinates.iter().enumerate() {
                    matrix[(next, c)] = row[at] / largest;
                }
                next += 1;
            }
        }
        matrix
    }

    /// For every coordinate: displacement of a point at distance `length` (m) at unit rate: `length` for rotations, 1
    /// for translations.
    pub fn coordinate_lengths(&self, length: f64) -> Vec<f64> {
        self.coordinates.iter().map(|c| if c.turns { length } else { 1.0 }).collect()
    }

    /// Least kinetic energy at unit closing speed.
    pub fn least_energy(
        &self,
        kinematics: &Kinematics,
        groups: &[GroupMobility],
        contact: &LocatedContact,
    ) -> LeastEnergySolution {
        let row = self.contact_row(kinematics, contact);
        let (mut values, mut sizes) =
            (vec![0.0; self.velocity_coordinates.len()], vec![0.0; self.velocity_coordinates.len()]);
        for entry in &row.entries {
            (values[entry.velocity], sizes[entry.velocity]) = (entry.value, entry.size);
        }
        LeastEnergy {
            mass: &self.mass_matrix(kinematics),
            mass_size: &self.mass_sizes(kinematics),
            constraints: &self.independent_constraint_rows(kinematics, groups),
            row: &self.reduce_vector(&values, |multiplier| multiplier),
            row_size: &self.reduce_vector(&sizes, f64::abs),
            lengths: &self.coordinate_lengths(row.length),
        }
        .solve()
    }
}

/// Largest entry of a group's rows over its scaled coordinates; 1 if all are zero.
fn largest_scaled(rows: &DMatrix<f64>, group: &Group) -> f64 {
    let scaled = |at: usize| rows.column(at).amax() / group.lengths[at];
    let largest = (0..group.lengths.len()).map(scaled).fold(0.0, f64::max);
    if largest > 0.0 { largest } else { 1.0 }
}
