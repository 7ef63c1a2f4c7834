//! Vectors in lanes: rotations about coordinate axes, and rotations by rows.

use crate::Scalar;
use crate::lanes::Lanes;

/// The two axes after `z`, in cyclic order.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) const fn after(z: usize) -> (usize, usize) {
    ((z + 1) % 3, (z + 2) % 3)
}

/// Broadcasts a vector to all lanes. Hot paths use no closures and iterators: only code that is certainly
/// inlined is compiled for the instruction set.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn splat<T: Scalar>(v: &[f64; 3]) -> [T; 3] {
    [T::from_f64(v[0]), T::from_f64(v[1]), T::from_f64(v[2])]
}

/// Loads vector number `k` of a slice of vectors with lane width.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn number<T: Lanes>(from: &[f64], k: usize) -> T {
    T::load(&from[k * T::WIDTH..])
}

/// R v, with R given by rows.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn rotated<T: Lanes>(v: &[T; 3], r: &[[T; 3]; 3]) -> [T; 3] {
    let mut out = *v;
    each!(i in [0 1 2] {
        out[i] = r[i][0].mul_add(v[0], r[i][1].mul_add(v[1], r[i][2] * v[2]));
    });
    out
}

/// Rows of the rotation matrix of a unit quaternion [w, x, y, z].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn rotation_rows<T: Lanes>([w, x, y, z]: [T; 4]) -> [[T; 3]; 3] {
    let (dx, dy, dz) = (x + x, y + y, z + z);
    let (xx, yy, zz) = (dx * x, dy * y, dz * z);
    let one = T::one();
    [
        [one - (yy + zz), dx.mul_add(y, -(dz * w)), dx.mul_add(z, dy * w)],
        [dx.mul_add(y, dz * w), one - (xx + zz), dy.mul_add(z, -(dx * w))],
        [dx.mul_add(z, -(dy * w)), dy.mul_add(z, dx * w), one - (xx + yy)],
    ]
}

/// Rᵀ v, with R given by rows.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn rotate_back<T: Lanes>(v: &mut [T; 3], r: &[[T; 3]; 3]) {
    let [x, y, z] = *v;
    each!(k in [0 1 2] {
        v[k] = r[0][k].mul_add(x, r[1][k].mul_add(y, r[2][k] * z));
    });
}

/// Plane rotation (c x − s y, s x + c y).
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn turned<T: Lanes>(x: T, y: T, c: T, s: T) -> (T, T) {
    (c.mul_add(x, -(s * y)), s.mul_add(x, c * y))
}

/// Transforms a vector to a frame in which its present frame is rotated about axis `Z`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn turn_vector<T: Lanes, const Z: usize>(v: &mut [T; 3], c: T, s: T) {
    let (x, y) = after(Z);
    (v[x], v[y]) = turned(v[x], v[y], c, s);
}
