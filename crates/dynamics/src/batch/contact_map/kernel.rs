//! SIMD evaluation of the contacts of a map.

use super::scale::InertiaFactor;
use crate::model::input::is_number;
use crate::tolerances::{MAP_TRUSTED_ERROR, SHORTEST_DIRECTION};
use nalgebra::{SMatrix, Vector3};
use percuss_kernel::WIDEST;
use percuss_spatial::lanes::{Lanes, Work};

/// Contacts by columns, in the frame of the contact link.
#[derive(Clone, Copy, Debug)]
pub struct ContactColumns<'a> {
    /// x, y and z of the points, m.
    pub points: [&'a [f64]; 3],
    /// x, y and z of the normals, out of the contact link, of any length.
    pub normals: [&'a [f64]; 3],
}

impl<'a> ContactColumns<'a> {
    /// Contacts `first` to `end`.
    pub(super) fn slice(self, first: usize, end: usize) -> Self {
        let [points, normals] = [self.points, self.normals].map(|c| c.map(|column| &column[first..end]));
        Self { points, normals }
    }

    /// Point and normal of contact `i`.
    pub(super) fn at(&self, i: usize) -> (Vector3<f64>, Vector3<f64>) {
        let [point, normal] = [self.points, self.normals].map(|c| Vector3::new(c[0][i], c[1][i], c[2][i]));
        (point, normal)
    }

    /// True if all coordinates of the points are finite and at most [`LARGEST_NUMBER`](crate::model::input::LARGEST_NUMBER).
    pub(super) fn has_points(&self) -> bool {
        self.points.iter().all(|column| column.iter().fold(true, |all, x| all & is_number(*x)))
    }

    /// True if contact `i` has a valid point and a valid direction.
    pub(super) fn is_direction(&self, i: usize) -> bool {
        let (point, normal) = self.at(i);
        let length = normal.norm();
        point.iter().all(|x| is_number(*x)) && length >= SHORTEST_DIRECTION && length.is_finite()
    }
}

/// Constants of a map.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    centre: [f64; 3],
    reach: f64,
    /// R, row by row from the diagonal.
    factor: [f64; 21],
    /// Error coefficient: the relative error is `error` · (|m|₁/reach + |n|₁)/|R w|.
    error: f64,
    /// Size of the square root of Φ (kg^-½).
    size: f64,
}

impl Constants {
    pub fn new(centre: Vector3<f64>, reach: f64) -> Self {
        Self { centre: centre.into(), reach, factor: [0.0; 21], error: 0.0, size: 0.0 }
    }

    pub fn centre(&self) -> Vector3<f64> {
        self.centre.into()
    }

    pub fn reach(&self) -> f64 {
        self.reach
    }

    pub fn set_factor(&mut self, factor: &InertiaFactor) {
        self.factor = factor.packed();
        self.size = factor.size();
    }

    /// Sets the relative error of a contact with |R w| equal to `size` · (|m|₁/reach + |n|₁).
    pub fn set_coefficient(&mut self, coefficient: f64) {
        self.error = coefficient * self.size;
    }

    pub fn coefficient(&self) -> f64 {
        self.error / self.size
    }

    /// Scaled size of the wrench w divided by |R w|: at least 1, and large for contacts much heavier than the
    /// lightest.
    pub fn stiffness(&self, arm: &Vector3<f64>, normal: &Vector3<f64>) -> f64 {
        let root_of_inverse = (self.project_forces(arm) * normal).norm();
        let moment = arm.cross(normal);
        self.size * (moment.lp_norm(1) / self.reach + normal.lp_norm(1)) / root_of_inverse
    }

    /// R applied to forces at a point, 6×3.
    pub fn project_forces(&self, arm: &Vector3<f64>) -> SMatrix<f64, 6, 3> {
        let mut whole = SMatrix::<f64, 6, 6>::zeros();
        let mut next = 0;
        for row in 0..6 {
            for column in row..6 {
                whole[(row, column)] = self.factor[next];
                next += 1;
            }
        }
        let moments = whole.fixed_columns::<3>(0) * arm.cross_matrix();
        moments + whole.fixed_columns::<3>(3)
    }
}

/// Computes effective masses and relative errors of contacts from Φ.
pub(super) struct Evaluate<'a> {
    pub constants: &'a Constants,
    pub contacts: ContactColumns<'a>,
    pub masses: &'a mut [f64],
    pub errors: &'a mut [f64],
    /// Set to true if an error is not small.
    pub doubt: &'a mut bool,
}

impl Work for Evaluate<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self { constants, contacts, masses, errors, doubt } = self;
        let lanes = LaneConstants::<T>::of(constants);
        let count = masses.len();
        let mut excess = T::zero();
        let mut at = 0;
        while at + T::WIDTH <= count {
            let point = load::<T>(&contacts.points, at);
            let normal = load::<T>(&contacts.normals, at);
            let (mass, error) = lanes.effective_mass(point, normal);
            mass.store(&mut masses[at..]);
            error.store(&mut errors[at..]);
            excess += error.max(lanes.trusted) - lanes.trusted;
            at += T::WIDTH;
        }
        if at < count {
            // Unused lanes repeat the last contact.
            let mut buffers = [[0.0; WIDEST]; 6];
            let mut column = 0;
            while column < 6 {
                let from = if column < 3 { contacts.points[column] } else { contacts.normals[column - 3] };
                let mut lane = 0;
                while lane < T::WIDTH {
                    let i = if at + lane < count { at + lane } else { count - 1 };
                    buffers[column][lane] = from[i];
                    lane += 1;
                }
                column += 1;
            }
            let point = [T::load(&buffers[0]), T::load(&buffers[1]), T::load(&buffers[2])];
            let normal = [T::load(&buffers[3]), T::load(&buffers[4]), T::load(&buffers[5])];
            let (mass, error) = lanes.effective_mass(point, normal);
            mass.store(&mut buffers[0]);
            error.store(&mut buffers[1]);
            let left = count - at;
            masses[at..].copy_from_slice(&buffers[0][..left]);
            errors[at..].copy_from_slice(&buffers[1][..left]);
            excess += error.max(lanes.trusted) - lanes.trusted;
        }
        let mut sums = [0.0; WIDEST];
        excess.store(&mut sums);
        let mut lane = 0;
        while lane < T::WIDTH {
            // NaN also sets the flag.
            *doubt |= sums[lane] != 0.0;
            lane += 1;
        }
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn load<T: Lanes>(columns: &[&[f64]; 3], at: usize) -> [T; 3] {
    [T::load(&columns[0][at..]), T::load(&columns[1][at..]), T::load(&columns[2][at..])]
}

/// Constants of a map in all lanes.
struct LaneConstants<T> {
    centre: [T; 3],
    factor: [T; 21],
    error: T,
    per_reach: T,
    trusted: T,
}

impl<T: Lanes> LaneConstants<T> {
    /// Copies the constants to all lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of(constants: &Constants) -> Self {
        let mut factor = [T::zero(); 21];
        let mut i = 0;
        while i < 21 {
            factor[i] = T::from_f64(constants.factor[i]);
            i += 1;
        }
        let [x, y, z] = constants.centre;
        Self {
            centre: [T::from_f64(x), T::from_f64(y), T::from_f64(z)],
            factor,
            error: T::from_f64(constants.error),
            per_reach: T::from_f64(1.0 / constants.reach),
            trusted: T::from_f64(MAP_TRUSTED_ERROR),
        }
    }

    /// m̄ = |n|²/|R w|² and its relative error.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn effective_mass(&self, point: [T; 3], n: [T; 3]) -> (T, T) {
        let c = &self.factor;
        let x = [point[0] - self.centre[0], point[1] - self.centre[1], point[2] - self.centre[2]];
        let m = [
            x[1].mul_add(n[2], -(x[2] * n[1])),
            x[2].mul_add(n[0], -(x[0] * n[2])),
            x[0].mul_add(n[1], -(x[1] * n[0])),
        ];
        let low = c[5].mul_add(n[2], c[4].mul_add(n[1], c[3] * n[0]));
        let first = c[2].mul_add(m[2], c[1].mul_add(m[1], c[0].mul_add(m[0], low)));
        let low = c[10].mul_add(n[2], c[9].mul_add(n[1], c[8] * n[0]));
        let second = c[7].mul_add(m[2], c[6].mul_add(m[1], low));
        let low = c[14].mul_add(n[2], c[13].mul_add(n[1], c[12] * n[0]));
        let third = c[11].mul_add(m[2], low);
        let fourth = c[17].mul_add(n[2], c[16].mul_add(n[1], c[15] * n[0]));
        let fifth = c[19].mul_add(n[2], c[18] * n[1]);
        let sixth = c[20] * n[2];
        let upper = third.mul_add(third, second.mul_add(second, first * first));
        let lower = sixth.mul_add(sixth, fifth.mul_add(fifth, fourth * fourth));
        let over = T::one() / (upper + lower);
        let square = n[2].mul_add(n[2], n[1].mul_add(n[1], n[0] * n[0]));
        let moment = m[0].abs() + m[1].abs() + m[2].abs();
        let force = n[0].abs() + n[1].abs() + n[2].abs();
        let size = moment.mul_add(self.per_reach, force);
        (square * over, self.error * size * over.sqrt())
    }
}
