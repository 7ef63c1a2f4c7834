//! Articulated-body inertia in 21 numbers, transformed by rotations about coordinate axes and translations along them.

#[macro_use]
mod each;
mod twist;
mod vector;
mod wrench;

pub use twist::PackedTwist;
pub use vector::{rotate_back, rotated, rotation_rows, splat, turn_vector};
pub use wrench::PackedWrench;

use crate::lanes::{Lanes, Single};
use crate::{Scalar, SpatialInertia};
use vector::{after, number, turned};

/// Index of the entry (i, j) of a symmetric 3×3 matrix in its packed upper triangle.
#[cfg_attr(not(debug_assertions), inline(always))]
const fn at(i: usize, j: usize) -> usize {
    [[0, 1, 2], [1, 3, 4], [2, 4, 5]][i][j]
}

/// Symmetric 6×6 map from twist to wrench: moment = A ω + C v, force = Cᵀ ω + L v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedInertia<T> {
    /// A: upper triangle by rows, kg·m².
    pub angular: [T; 6],
    /// C: rows, kg·m.
    pub coupling: [[T; 3]; 3],
    /// L: upper triangle by rows, kg.
    pub linear: [T; 6],
}

/// Pivot of the elimination of one joint velocity: U and D.
#[derive(Clone, Copy, Debug)]
pub struct Pivot<T> {
    /// U = I s.
    pub u: PackedWrench<T>,
    /// D = sᵀ I s + armature.
    pub d: T,
    /// D⁻¹.
    pub inverse_d: T,
    /// Armature / D: after the elimination, U times this factor remains along s.
    pub armature_part: T,
}

impl<T: Lanes> Pivot<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(u: PackedWrench<T>, d: T, armature: T) -> Self {
        let over = T::one() / d;
        Self { u, d, inverse_d: over, armature_part: armature * over }
    }
}

impl PackedInertia<f64> {
    /// Inertia of a rigid body in its own frame.
    pub fn of_body(body: &SpatialInertia<f64>) -> Self {
        let (i, h, m) = (&body.rotational, &body.first_moment, body.mass);
        Self {
            angular: [i[(0, 0)], i[(0, 1)], i[(0, 2)], i[(1, 1)], i[(1, 2)], i[(2, 2)]],
            coupling: [[0.0, -h.z, h.y], [h.z, 0.0, -h.x], [-h.y, h.x, 0.0]],
            linear: [m, 0.0, 0.0, m, 0.0, m],
        }
    }

    /// Coefficients of d and d² of a shift by d (m) along axis `Z`: C changes linearly, A quadratically.
    pub fn shift_coefficients<const Z: usize>(&self) -> [Self; 2] {
        let (x, y) = after(Z);
        let (c, l) = (&self.coupling, &self.linear);
        let [mut slope, mut bend] = [Self::zero(); 2];
        each!(k in [0 1 2] {
            (slope.coupling[x][k], slope.coupling[y][k]) = (-l[at(y, k)], l[at(x, k)]);
        });
        let a = &mut slope.angular;
        (a[at(x, x)], a[at(y, y)], a[at(x, y)]) = (-2.0 * c[x][y], 2.0 * c[y][x], c[x][x] - c[y][y]);
        (a[at(x, Z)], a[at(y, Z)]) = (-c[Z][y], c[Z][x]);
        let a = &mut bend.angular;
        (a[at(x, x)], a[at(y, y)], a[at(x, y)]) = (l[at(y, y)], l[at(x, x)], -l[at(x, y)]);
        [slope, bend]
    }

    /// Converts the inertia to lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn cast<T: Scalar>(&self) -> PackedInertia<T> {
        let [a, b, c, d, e, f] = self.angular;
        let [x, y, z] = &self.coupling;
        let [g, h, i, j, k, l] = self.linear;
        let of = T::from_f64;
        PackedInertia {
            angular: [of(a), of(b), of(c), of(d), of(e), of(f)],
            coupling: [splat(x), splat(y), splat(z)],
            linear: [of(g), of(h), of(i), of(j), of(k), of(l)],
        }
    }
}

/// Value of `ZERO` if no row is zero.
const NONE: usize = 3;

/// R M Rᵀ for a rotation about axis `Z`, cosine `c`, sine `s`. `ZERO`: row and column that is zero, or [`NONE`].
#[cfg_attr(not(debug_assertions), inline(always))]
fn turn_symmetric<T: Lanes, const Z: usize, const ZERO: usize>(m: &mut [T; 6], c: T, s: T) {
    let (x, y) = after(Z);
    let (xx, yy, xy, xz, yz) = (at(x, x), at(y, y), at(x, y), at(x, Z), at(y, Z));
    if ZERO == y {
        let g = s * m[xx];
        (m[yy], m[xy]) = (s * g, c * g);
        m[xx] = (-s).mul_add(g, m[xx]);
        (m[xz], m[yz]) = (c * m[xz], s * m[xz]);
        return;
    }
    let g = s.mul_add(m[xx] - m[yy], c * (m[xy] + m[xy]));
    m[xx] = (-s).mul_add(g, m[xx]);
    m[yy] = s.mul_add(g, m[yy]);
    m[xy] = c.mul_add(g, -m[xy]);
    if ZERO != Z {
        (m[xz], m[yz]) = turned(m[xz], m[yz], c, s);
    }
}

/// R M Rᵀ for a rotation by +90° about axis `Z`, without multiplications.
#[cfg_attr(not(debug_assertions), inline(always))]
fn turn_symmetric_right<T: Lanes, const Z: usize>(m: &mut [T; 6]) {
    let (x, y) = after(Z);
    let (xx, yy, xy, xz, yz) = (at(x, x), at(y, y), at(x, y), at(x, Z), at(y, Z));
    (m[xx], m[yy], m[xy]) = (m[yy], m[xx], -m[xy]);
    (m[xz], m[yz]) = (-m[yz], m[xz]);
}

/// R M Rᵀ of a symmetric matrix, packed as its upper triangle by rows, for a general rotation R given by rows.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn rotate_symmetric<T: Lanes>(m: &mut [T; 6], r: &[[T; 3]; 3]) {
    let mut half = *r;
    each!(i in [0 1 2] {
        half[i] = rotated(&[m[at(i, 0)], m[at(i, 1)], m[at(i, 2)]], r);
    });
    // Rows of M Rᵀ, then the upper triangle of R M Rᵀ.
    each!(i in [0 1 2] {
        each!(k in [0 1 2] {
            if k >= i {
                let (a, b, c) = (r[i][0], r[i][1], r[i][2]);
                m[at(i, k)] = a.mul_add(half[0][k], b.mul_add(half[1][k], c * half[2][k]));
            }
        });
    });
}

impl PackedInertia<Single> {
    /// Returns the inertia of a single lane as `f64`.
    pub fn plain(&self) -> PackedInertia<f64> {
        PackedInertia {
            angular: self.angular.map(Single::number),
            coupling: self.coupling.map(|row| row.map(Single::number)),
            linear: self.linear.map(Single::number),
        }
    }
}

impl<T: Scalar> PackedInertia<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn zero() -> Self {
        let o = T::zero();
        Self { angular: [o; 6], coupling: [[o; 3]; 3], linear: [o; 6] }
    }
}

impl<T: Lanes> PackedInertia<T> {
    /// Number of stored values.
    pub const NUMBERS: usize = 21;

    /// Transforms to a frame in which the present frame is rotated about axis `Z`, with cosine `c` and sine `s`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn turn<const Z: usize>(&mut self, c: T, s: T) {
        turn_symmetric::<T, Z, NONE>(&mut self.linear, c, s);
        self.turn_coupling::<Z, NONE>(c, s);
        turn_symmetric::<T, Z, NONE>(&mut self.angular, c, s);
    }

    /// A [`turn`](Self::turn) by +90° about axis `Z`, without multiplications.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn turn_right<const Z: usize>(&mut self) {
        let (x, y) = after(Z);
        turn_symmetric_right::<T, Z>(&mut self.linear);
        turn_symmetric_right::<T, Z>(&mut self.angular);
        let m = &mut self.coupling;
        (m[x][x], m[y][y]) = (m[y][y], m[x][x]);
        (m[x][y], m[y][x]) = (-m[y][x], -m[x][y]);
        (m[x][Z], m[y][Z]) = (-m[y][Z], m[x][Z]);
        (m[Z][x], m[Z][y]) = (-m[Z][y], m[Z][x]);
    }

    /// Transforms to parallel axes, with the present origin at r = `d` (m) along `Z`: C = C₀ + \[r\]L, A = A₀ − C₀\[r\] + \[r\]Cᵀ.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn shift<const Z: usize>(&mut self, d: T) {
        let before = self.shift_coupling::<Z>(d);
        self.shift_angular::<Z, NONE>(&before, d);
    }

    /// A [`turn`](Self::turn) followed by a [`shift`](Self::shift) along the same axis.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn screw<const Z: usize>(&mut self, c: T, s: T, d: T) {
        self.screw_without::<Z, NONE>(c, s, d);
    }

    /// [`screw`](Self::screw) if row `ZERO` of A and C is zero, as after the elimination of a hinge without armature.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn screw_without<const Z: usize, const ZERO: usize>(&mut self, c: T, s: T, d: T) {
        turn_symmetric::<T, Z, NONE>(&mut self.linear, c, s);
        self.turn_coupling::<Z, ZERO>(c, s);
        let before = self.shift_coupling::<Z>(d);
        turn_symmetric::<T, Z, ZERO>(&mut self.angular, c, s);
        self.shift_angular::<Z, ZERO>(&before, d);
    }

    /// Transforms to a frame in which the present frame is rotated by R, given by rows: R A Rᵀ, R C Rᵀ, R L Rᵀ.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rotate(&mut self, r: &[[T; 3]; 3]) {
        rotate_symmetric(&mut self.linear, r);
        rotate_symmetric(&mut self.angular, r);
        let mut half = self.coupling;
        each!(i in [0 1 2] {
            half[i] = rotated(&self.coupling[i], r);
        });
        each!(k in [0 1 2] {
            let column = rotated(&[half[0][k], half[1][k], half[2][k]], r);
            each!(i in [0 1 2] {
                self.coupling[i][k] = column[i];
            });
        });
    }

    /// R C Rᵀ for a rotation about axis `Z`; see [`turn_symmetric`] for `ZERO`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn turn_coupling<const Z: usize, const ZERO: usize>(&mut self, c: T, s: T) {
        let (x, y) = after(Z);
        let m = &mut self.coupling;
        if ZERO == y {
            let g = s.mul_add(m[x][x], c * m[x][y]);
            m[x][x] = (-s).mul_add(g, m[x][x]);
            m[y][y] = s * g;
            (m[x][y], m[y][x]) = (c * g, c.mul_add(g, -m[x][y]));
            (m[x][Z], m[y][Z]) = (c * m[x][Z], s * m[x][Z]);
            (m[Z][x], m[Z][y]) = turned(m[Z][x], m[Z][y], c, s);
            return;
        }
        let g = s.mul_add(m[x][x] - m[y][y], c * (m[x][y] + m[y][x]));
        m[x][x] = (-s).mul_add(g, m[x][x]);
        m[y][y] = s.mul_add(g, m[y][y]);
        (m[x][y], m[y][x]) = (c.mul_add(g, -m[y][x]), c.mul_add(g, -m[x][y]));
        (m[x][Z], m[y][Z]) = turned(m[x][Z], m[y][Z], c, s);
        if ZERO != Z {
            (m[Z][x], m[Z][y]) = turned(m[Z][x], m[Z][y], c, s);
        }
    }

    /// C ← C + \[r\]L for r = d along `Z`. With x, y the next axes: returns xx, xy, yx, yy of the old C.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shift_coupling<const Z: usize>(&mut self, d: T) -> [T; 4] {
        let (x, y) = after(Z);
        let (c, l) = (&mut self.coupling, &self.linear);
        let before = [c[x][x], c[x][y], c[y][x], c[y][y]];
        each!(k in [0 1 2] {
            c[x][k] = (-d).mul_add(l[at(y, k)], c[x][k]);
            c[y][k] = d.mul_add(l[at(x, k)], c[y][k]);
        });
        before
    }

    /// A ← A − C\[r\] + \[r\]Cᵀ for r = d along `Z`, after [`shift_coupling`](Self::shift_coupling), which returned `before`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shift_angular<const Z: usize, const ZERO: usize>(&mut self, before: &[T; 4], d: T) {
        let (x, y) = after(Z);
        let (c, a) = (&self.coupling, &mut self.angular);
        a[at(x, x)] = (-d).mul_add(before[1] + c[x][y], a[at(x, x)]);
        a[at(y, y)] = d.mul_add(before[2] + c[y][x], a[at(y, y)]);
        a[at(x, y)] = d.mul_add(before[0] - c[y][y], a[at(x, y)]);
        if ZERO != Z {
            a[at(x, Z)] = (-d).mul_add(c[Z][y], a[at(x, Z)]);
            a[at(y, Z)] = d.mul_add(c[Z][x], a[at(y, Z)]);
        }
    }

    /// Trace of A, kg·m²: bound of the entries of A if A is positive semi-definite.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn moment_size(&self) -> T {
        self.angular[0] + self.angular[3] + self.angular[5]
    }

    /// Trace of L, kg.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn mass_size(&self) -> T {
        self.linear[0] + self.linear[3] + self.linear[5]
    }

    /// Pivot of a rotation about axis `Z`; armature in kg·m².
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn turn_pivot<const Z: usize>(&self, armature: T) -> Pivot<T> {
        let a = &self.angular;
        let u = PackedWrench { moment: [a[at(0, Z)], a[at(1, Z)], a[at(2, Z)]], force: self.coupling[Z] };
        let d = u.moment[Z] + armature;
        Pivot::new(u, d, armature)
    }

    /// Pivot of a translation along axis `Z`; armature in kg.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn slide_pivot<const Z: usize>(&self, armature: T) -> Pivot<T> {
        let (c, l) = (&self.coupling, &self.linear);
        let u = PackedWrench {
            moment: [c[0][Z], c[1][Z], c[2][Z]],
            force: [l[at(0, Z)], l[at(1, Z)], l[at(2, Z)]],
        };
        let d = u.force[Z] + armature;
        Pivot::new(u, d, armature)
    }

    /// Eliminates a rotation about axis `Z`: I ← I − U D⁻¹ Uᵀ. Row `Z` becomes U · armature/D. `over_d`: U D⁻¹.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn eliminate_turn<const Z: usize>(&mut self, pivot: &Pivot<T>, over_d: &PackedWrench<T>) {
        self.subtract_dyad(&pivot.u, over_d);
        each!(k in [0 1 2] {
            self.angular[at(k, Z)] = pivot.u.moment[k] * pivot.armature_part;
            self.coupling[Z][k] = pivot.u.force[k] * pivot.armature_part;
        });
    }

    /// Eliminates a rotation without armature about axis `Z`; row `Z` of A and of C is then zero.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn eliminate_bare_turn<const Z: usize>(&mut self, pivot: &Pivot<T>, over_d: &PackedWrench<T>) {
        self.subtract_dyad(&pivot.u, over_d);
        self.clear_row::<Z>();
    }

    /// Sets row `Z` of A and C, already zero, to the constant 0, so that the compiler removes the dependent operations.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn clear_row<const Z: usize>(&mut self) {
        each!(k in [0 1 2] {
            self.angular[at(k, Z)] = T::zero();
            self.coupling[Z][k] = T::zero();
        });
    }

    /// I − U D⁻¹ Uᵀ for a motion along several axes. `over_d`: U D⁻¹.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn subtract_dyad(&mut self, u: &PackedWrench<T>, over_d: &PackedWrench<T>) {
        self.subtract_angular::<3>(u, over_d);
        self.subtract_coupling::<3, 3>(u, over_d);
        self.subtract_linear::<3>(u, over_d);
    }

    /// Eliminates a translation along axis `Z`; see [`eliminate_turn`](Self::eliminate_turn).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn eliminate_slide<const Z: usize>(&mut self, pivot: &Pivot<T>, over_d: &PackedWrench<T>) {
        self.subtract_angular::<3>(&pivot.u, over_d);
        self.subtract_coupling::<3, Z>(&pivot.u, over_d);
        self.subtract_linear::<Z>(&pivot.u, over_d);
        each!(k in [0 1 2] {
            self.coupling[k][Z] = pivot.u.moment[k] * pivot.armature_part;
            self.linear[at(k, Z)] = pivot.u.force[k] * pivot.armature_part;
        });
    }

    /// A − U_m D⁻¹ U_mᵀ for the moment U_m of `u`; row and column `BUT` stay unchanged (3: none).
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn subtract_angular<const BUT: usize>(&mut self, u: &PackedWrench<T>, over_d: &PackedWrench<T>) {
        each!(i in [0 1 2] {
            each!(k in [0 1 2] {
                if k >= i && i != BUT && k != BUT {
                    let a = &mut self.angular[at(i, k)];
                    *a = (-u.moment[i]).mul_add(over_d.moment[k], *a);
                }
            });
        });
    }

    /// C − U_m D⁻¹ U_fᵀ; moment U_m and force U_f of `u`; row `ROW` and column `COLUMN` stay unchanged (3: none).
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn subtract_coupling<const ROW: usize, const COLUMN: usize>(
        &mut self,
        u: &PackedWrench<T>,
        over_d: &PackedWrench<T>,
    ) {
        each!(i in [0 1 2] {
            each!(k in [0 1 2] {
                if i != ROW && k != COLUMN {
                    let c = &mut self.coupling[i][k];
                    *c = (-u.moment[i]).mul_add(over_d.force[k], *c);
                }
            });
        });
    }

    /// L − U_f D⁻¹ U_fᵀ for the force U_f of `u`; row and column `BUT` stay unchanged (3: none).
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn subtract_linear<const BUT: usize>(&mut self, u: &PackedWrench<T>, over_d: &PackedWrench<T>) {
        each!(i in [0 1 2] {
            each!(k in [0 1 2] {
                if k >= i && i != BUT && k != BUT {
                    let l = &mut self.linear[at(i, k)];
                    *l = (-u.force[i]).mul_add(over_d.force[k], *l);
                }
            });
        });
    }

    /// Stores the 21 numbers in sequence, each with lane width.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn store(&self, to: &mut [f64]) {
        let to = &mut to[..Self::NUMBERS * T::WIDTH];
        each!(k in [0 1 2 3 4 5] {
            self.angular[k].store(&mut to[k * T::WIDTH..]);
            self.linear[k].store(&mut to[(15 + k) * T::WIDTH..]);
        });
        each!(i in [0 1 2] {
            each!(k in [0 1 2] {
                self.coupling[i][k].store(&mut to[(6 + 3 * i + k) * T::WIDTH..]);
            });
        });
    }

    /// Loads an inertia written by [`store`](Self::store).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn load(from: &[f64]) -> Self {
        let from = &from[..Self::NUMBERS * T::WIDTH];
        let mut packed = Self::zero();
        each!(k in [0 1 2 3 4 5] {
            packed.angular[k] = number(from, k);
            packed.linear[k] = number(from, 15 + k);
        });
        each!(i in [0 1 2] {
            each!(k in [0 1 2] {
                packed.coupling[i][k] = number(from, 6 + 3 * i + k);
            });
        });
        packed
    }

    /// Adds another inertia.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add(&mut self, other: &Self) {
        each!(k in [0 1 2 3 4 5] {
            self.angular[k] += other.angular[k];
            self.linear[k] += other.linear[k];
        });
        each!(i in [0 1 2] {
            each!(k in [0 1 2] {
                self.coupling[i][k] += other.coupling[i][k];
            });
        });
    }

    /// Adds a rigid body's inertia, which has nine zero entries.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_rigid(&mut self, body: &PackedInertia<f64>) {
        each!(k in [0 1 2 3 4 5] {
            self.angular[k] += T::from_f64(body.angular[k]);
        });
        let mass = T::from_f64(body.linear[0]);
        each!(k in [0 1 2] {
            let (x, y) = after(k);
            self.linear[at(k, k)] += mass;
            let h = T::from_f64(body.coupling[y][x]);
            self.coupling[x][y] -= h;
            self.coupling[y][x] += h;
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ArticulatedInertia, Transform, Vector3, Wrench, rotation_about};
    use nalgebra::Matrix3;

    type One = Single;

    fn value(x: One) -> f64 {
        x.number()
    }

    fn body() -> SpatialInertia<f64> {
        let inertia = Matrix3::new(0.5, 0.03, -0.02, 0.03, 0.6, 0.05, -0.02, 0.05, 0.4);
        SpatialInertia::about_com(1.7, Vector3::new(0.2, -0.4, 0.1), inertia)
    }

    /// Compares all entries of two maps as 6×6 matrices.
    fn assert_same(packed: &PackedInertia<One>, full: &ArticulatedInertia<f64>) {
        for i in 0..3 {
            for k in 0..3 {
                let pairs = [
                    (packed.angular[at(i, k)], full.angular[(i, k)]),
                    (packed.coupling[i][k], full.coupling[(i, k)]),
                    (packed.linear[at(i, k)], full.linear[(i, k)]),
                ];
                for (a, b) in pairs {
                    // A few roundings of numbers of order one.
                    assert!((value(a) - b).abs() < 4e-15, "{i} {k}: {} {b}", value(a));
                }
            }
        }
    }

    fn moved<const Z: usize>() {
        let axis = Vector3::from_fn(|i, _| if i == Z { 1.0 } else { 0.0 });
        let (angle, d) = (0.7f64, -0.35);
        let mut packed: PackedInertia<One> = PackedInertia::of_body(&body()).cast();
        let mut at_once = packed;
        at_once.screw::<Z>(One::from_f64(angle.cos()), One::from_f64(angle.sin()), One::from_f64(d));
        packed.turn::<Z>(One::from_f64(angle.cos()), One::from_f64(angle.sin()));
        packed.shift::<Z>(One::from_f64(d));
        assert_eq!(packed, at_once);
        right::<Z>(packed);
        along::<Z>();
        let x = Transform::new(rotation_about(&axis, angle), axis * d);
        assert_same(&packed, &ArticulatedInertia::from(&x.inertia(&body())));
        let f = Wrench::new(Vector3::new(0.3, -0.8, 0.5), Vector3::new(1.0, 0.2, -0.4));
        let of = |v: &Vector3<f64>| [v.x, v.y, v.z].map(One::from_f64);
        let mut wrench = PackedWrench { moment: of(&f.moment), force: of(&f.force) };
        wrench.turn::<Z>(One::from_f64(angle.cos()), One::from_f64(angle.sin()));
        wrench.shift::<Z>(One::from_f64(d));
        let there = x.wrench(&f);
        for k in 0..3 {
            assert!((value(wrench.moment[k]) - there.moment[k]).abs() < 1e-15);
            assert!((value(wrench.force[k]) - there.force[k]).abs() < 1e-15);
        }
    }

    /// I + d I₁ + d² I₂ equals I shifted by d.
    fn along<const Z: usize>() {
        let at_rest = PackedInertia::of_body(&body());
        let d = -0.35;
        let mut shifted: PackedInertia<One> = at_rest.cast();
        let pivot = shifted.turn_pivot::<0>(One::from_f64(0.1));
        let over_d = pivot.u.scaled(pivot.inverse_d);
        shifted.eliminate_turn::<0>(&pivot, &over_d);
        let left = shifted.plain();
        shifted.shift::<Z>(One::from_f64(d));
        let [slope, bend] = left.shift_coefficients::<Z>();
        let terms = [left, slope, bend].map(|term| numbers(&term.cast()).collect::<Vec<_>>());
        for (k, number) in numbers(&shifted).enumerate() {
            let sum = terms[0][k] + d * (terms[1][k] + d * terms[2][k]);
            // A few roundings of numbers of order one.
            assert!((sum - number).abs() < 1e-15, "{k}: {sum} {number}");
        }
    }

    /// The rotation by 90° equals a general rotation to the last bit; so does the variant with a zero row.
    fn right<const Z: usize>(packed: PackedInertia<One>) {
        let of = One::from_f64;
        let f = PackedWrench { moment: [of(0.3), of(-0.8), of(0.5)], force: [of(1.0), of(0.2), of(-0.4)] };
        let (mut by_angle, mut exact) = ((packed, f), (packed, f));
        by_angle.0.turn::<Z>(of(0.0), of(1.0));
        by_angle.1.turn::<Z>(of(0.0), of(1.0));
        exact.0.turn_right::<Z>();
        exact.1.turn_right::<Z>();
        assert_eq!(by_angle.1, exact.1);
        for (a, b) in numbers(&by_angle.0).zip(numbers(&exact.0)) {
            // x − (x − y) equals y within one rounding of x.
            assert!((a - b).abs() < 4e-16, "{a} {b}");
        }
        let (mut general, mut left_out) = (packed, packed);
        let pivot = packed.turn_pivot::<2>(of(0.0));
        let over_d = pivot.u.scaled(pivot.inverse_d);
        general.eliminate_turn::<2>(&pivot, &over_d);
        left_out.eliminate_bare_turn::<2>(&pivot, &over_d);
        assert_eq!(general, left_out);
        let (c, s, d) = (of(0.7f64.cos()), of(0.7f64.sin()), of(-0.35));
        general.screw::<2>(c, s, d);
        left_out.screw_without::<2, 2>(c, s, d);
        assert_eq!(general, left_out);
        general.screw::<0>(c, s, d);
        left_out.screw_without::<0, 2>(c, s, d);
        assert_eq!(general, left_out);
    }

    fn numbers(packed: &PackedInertia<One>) -> impl Iterator<Item = f64> {
        let mut all = [0.0; PackedInertia::<One>::NUMBERS];
        packed.store(&mut all);
        all.into_iter()
    }

    #[test]
    fn turns_and_shifts_are_those_of_a_transform() {
        moved::<0>();
        moved::<1>();
        moved::<2>();
    }

    #[test]
    fn what_is_eliminated_has_no_mass_left() {
        let mut packed: PackedInertia<One> = PackedInertia::of_body(&body()).cast();
        let pivot = packed.turn_pivot::<1>(One::from_f64(0.0));
        packed.eliminate_turn::<1>(&pivot, &pivot.u.scaled(pivot.inverse_d));
        let again = packed.turn_pivot::<1>(One::from_f64(0.0));
        assert_eq!(value(again.d), 0.0);
        assert!(again.u.moment.iter().chain(&again.u.force).all(|u| value(*u) == 0.0));
    }
}
