//! Contact row: closing speed of the gap per tree velocity. Jacobians of the velocity of a point and of the angular velocity of a link.

use crate::kinematics::contact::LocatedContact;
use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::LinkId;

impl Model {
    /// Contact row over the tree velocities, with the size of the summed terms of each entry. Joints that move both
    /// sides equally are left out: their contributions cancel.
    pub fn contact_row(&self, kinematics: &Kinematics, contact: &LocatedContact) -> ContactRow {
        let mut row = ContactRow::default();
        self.contact_row_into(kinematics, contact, &mut row);
        row
    }

    /// Computes [`contact_row`](Self::contact_row) in place.
    pub fn contact_row_into(&self, kinematics: &Kinematics, contact: &LocatedContact, row: &mut ContactRow) {
        row.entries.clear();
        row.is_moment = contact.is_moment;
        row.length = if contact.is_moment { self.mechanism.characteristic_length() } else { 0.0 };
        let against = contact.against.and_then(|link| self.body_of(link));
        self.for_each_support(self.body_of(contact.link), against, |i, sign| {
            let arm = (contact.point_root - kinematics.frames[i].translation).norm();
            for (component, velocity) in self.bodies[i].v.clone().enumerate() {
                let turns = self.bodies[i].motion.turns(component);
                let (velocity_of_contact, size) = match contact.is_moment {
                    true => self.angular_column(kinematics, i, component),
                    false => self.velocity_column(kinematics, i, component, &contact.point_root),
                };
                let value = sign * contact.normal_root.dot(&velocity_of_contact);
                row.entries.push(RowEntry { velocity, body: i, value, size, turns });
                if turns && !contact.is_moment {
                    row.length = row.length.max(arm);
                }
            }
        });
        if row.length == 0.0 {
            row.length = 1.0;
        }
    }

    /// Velocity of the point `at` (root frame) at unit velocity `k` of body `i`, and the sum of the magnitudes of its
    /// terms.
    fn velocity_column(
        &self,
        kinematics: &Kinematics,
        i: usize,
        k: usize,
        at: &Vector3<f64>,
    ) -> (Vector3<f64>, f64) {
        let frame = &kinematics.frames[i];
        let column = kinematics.column(self, i, k);
        let (omega, slide) = (frame.vector(&column.angular), frame.vector(&column.linear));
        let arm = at - frame.translation;
        (slide + omega.cross(&arm), slide.norm() + omega.norm() * arm.norm())
    }

    /// Angular velocity at unit velocity `k` of body `i` (root axes), and its magnitude.
    fn angular_column(&self, kinematics: &Kinematics, i: usize, k: usize) -> (Vector3<f64>, f64) {
        let omega = kinematics.frames[i].vector(&kinematics.column(self, i, k).angular);
        (omega, omega.norm())
    }

    /// Jacobian of a point (m, link frame) of a link over the coordinates, 3×n, in root axes.
    pub fn point_jacobian(
        &self,
        kinematics: &Kinematics,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> DMatrix<f64> {
        let at = kinematics.link_frame(self, link).point(point);
        self.jacobian_of(link, |i, k| self.velocity_column(kinematics, i, k, &at).0)
    }

    /// Jacobian of the angular velocity of a link over the coordinates, 3×n, in root axes.
    pub fn angular_jacobian(&self, kinematics: &Kinematics, link: LinkId) -> DMatrix<f64> {
        self.jacobian_of(link, |i, k| self.angular_column(kinematics, i, k).0)
    }

    /// Jacobian of a velocity of a link over the coordinates, 3×n. `column(i, k)`: this velocity at unit velocity `k` of body `i`.
    fn jacobian_of(&self, link: LinkId, column: impl Fn(usize, usize) -> Vector3<f64>) -> DMatrix<f64> {
        let mut jacobian = DMatrix::zeros(3, self.coordinates.len());
        self.for_each_support(self.body_of(link), None, |i, _| {
            for (k, v) in self.bodies[i].v.clone().enumerate() {
                if let Some(f) = self.velocity_coordinates[v] {
                    let mut target = jacobian.column_mut(f.index);
                    target += column(i, k) * f.multiplier;
                }
            }
        });
        jacobian
    }
}

/// Entry of the contact row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowEntry {
    /// Index among the tree velocities.
    pub velocity: usize,
    pub body: usize,
    pub value: f64,
    /// Sum of the magnitudes of the terms of `value`.
    pub size: f64,
    pub turns: bool,
}

/// Contact row over the tree velocities, without the structural zeros.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContactRow {
    pub entries: Vec<RowEntry>,
    /// Characteristic length of the contact, m: the largest distance of the contact point from a rotating joint on
    /// its path; 1 without such a joint. For a moment: characteristic length of the mechanism.
    pub length: f64,
    /// True for a moment about an axis.
    pub is_moment: bool,
}

impl ContactRow {
    /// m̄ of a mass of 1 kg at the characteristic length: 1 kg, or length² kg·m² for a moment.
    pub fn unit_mass(&self) -> f64 {
        if self.is_moment { self.length * self.length } else { 1.0 }
    }
}
