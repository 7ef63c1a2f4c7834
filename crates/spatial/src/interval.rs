//! Closed intervals of real numbers with outward rounding.

use crate::Scalar;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Interval [lo, hi] that contains every real value of the operations applied to its operands.
///
/// Each bound is rounded outward by 1 to 2 units in the last place. Operations that are exact stay exact: sums with 0, products with 0
/// and ±1, quotients by 1. A result beyond the range of `f64`, or of a division by an interval with 0, is [`Interval::ENTIRE`]. The
/// bounds are never NaN.
///
/// Source: Moore, Kearfott, Cloud 2009, §2; Rump 2010 (Acta Numerica), §5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

/// Lower bound of every real number that rounds to `x`.
///
/// The step |x| 2⁻⁵² is at least one unit in the last place of x; the smallest normal number replaces it where it underflows.
#[inline]
const fn down(x: f64) -> f64 {
    x - (x.abs() * f64::EPSILON + f64::MIN_POSITIVE)
}

/// Upper bound of every real number that rounds to `x`.
#[inline]
const fn up(x: f64) -> f64 {
    x + (x.abs() * f64::EPSILON + f64::MIN_POSITIVE)
}

impl Interval {
    /// All real numbers.
    pub const ENTIRE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Interval between two numbers, in either order; [`Interval::ENTIRE`] if one is NaN.
    #[inline]
    pub fn new(a: f64, b: f64) -> Self {
        if a <= b {
            Self { lo: a, hi: b }
        } else if b <= a {
            Self { lo: b, hi: a }
        } else {
            Self::ENTIRE
        }
    }

    /// One number.
    #[inline]
    pub fn point(x: f64) -> Self {
        Self::new(x, x)
    }

    /// Every number that differs from `x` by at most `units` · 2⁻⁵² · max(|x|, `size`). The numbers 0, 1 and −1 stay exact.
    pub fn around(x: f64, units: f64, size: f64) -> Self {
        if x == 0.0 || x.abs() == 1.0 {
            return Self::point(x);
        }
        let radius = units * f64::EPSILON * x.abs().max(size);
        Self { lo: down(x - radius), hi: up(x + radius) }
    }

    /// [−r, r].
    #[inline]
    pub fn symmetric(r: f64) -> Self {
        Self::new(-r, r)
    }

    /// Lower bound.
    #[inline]
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// Upper bound.
    #[inline]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// A number near the middle, inside the interval; 0 for an unbounded one.
    #[inline]
    pub fn mid(self) -> f64 {
        let mid = 0.5 * self.lo + 0.5 * self.hi;
        if mid.is_finite() { mid.clamp(self.lo, self.hi) } else { 0.0 }
    }

    /// Upper bound of the distance of a number of the interval from [`mid`](Self::mid).
    #[inline]
    pub fn radius(self) -> f64 {
        let mid = self.mid();
        if self.lo == self.hi { 0.0 } else { up(self.hi - mid).max(up(mid - self.lo)) }
    }

    /// Largest absolute value.
    #[inline]
    pub fn magnitude(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// True if `x` is inside.
    #[inline]
    pub fn contains(self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// True if the interval is inside the open interval of `other`.
    #[inline]
    pub fn is_inside(self, other: Self) -> bool {
        other.lo < self.lo && self.hi < other.hi
    }

    /// Smallest interval that contains both.
    #[inline]
    pub fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// Common part; `None` if the intervals are disjoint.
    #[inline]
    pub fn intersection(self, other: Self) -> Option<Self> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(Self { lo, hi })
    }

    /// Square; never negative.
    #[inline]
    pub fn square(self) -> Self {
        let product = self * self;
        if self.lo < 0.0 && self.hi > 0.0 {
            Self { lo: 0.0, hi: product.hi }
        } else {
            Self { lo: product.lo.max(0.0), hi: product.hi }
        }
    }

    /// Interval rounded outward from the rounded bounds of a result.
    #[inline]
    fn outward(lo: f64, hi: f64) -> Self {
        let rounded = Self { lo: down(lo), hi: up(hi) };
        if rounded.lo.is_finite() && rounded.hi.is_finite() { rounded } else { Self::ENTIRE }
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Self::outward(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        for (a, b) in [(self, other), (other, self)] {
            if a.lo == a.hi {
                if a.lo == 0.0 {
                    return Self::zero();
                }
                if a.lo == 1.0 {
                    return b;
                }
                if a.lo == -1.0 {
                    return -b;
                }
            }
        }
        // A product of an infinite bound is infinite: the other operand has a bound that is not 0.
        let (a, b) = (self.lo * other.lo, self.lo * other.hi);
        let (c, d) = (self.hi * other.lo, self.hi * other.hi);
        Self::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

impl Div for Interval {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        if other.lo <= 0.0 && other.hi >= 0.0 {
            return Self::ENTIRE;
        }
        if self.is_zero() || other.is_one() {
            return self;
        }
        if !(self.magnitude().is_finite() && other.magnitude().is_finite()) {
            return Self::ENTIRE;
        }
        let (a, b) = (self.lo / other.lo, self.lo / other.hi);
        let (c, d) = (self.hi / other.lo, self.hi / other.hi);
        Self::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

impl AddAssign for Interval {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Interval {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Interval {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl DivAssign for Interval {
    #[inline]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl Zero for Interval {
    #[inline]
    fn zero() -> Self {
        Self { lo: 0.0, hi: 0.0 }
    }
    #[inline]
    fn is_zero(&self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }
}

impl One for Interval {
    #[inline]
    fn one() -> Self {
        Self { lo: 1.0, hi: 1.0 }
    }
    #[inline]
    fn is_one(&self) -> bool {
        self.lo == 1.0 && self.hi == 1.0
    }
}

impl Scalar for Interval {
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::point(x)
    }

    /// Sine and cosine: hull of the values at the bounds, with ±1 for each extreme between them.
    fn sin_cos(self) -> (Self, Self) {
        let all = Self { lo: -1.0, hi: 1.0 };
        // Beyond this magnitude the reduction is not exact; a full turn has all values.
        if self.magnitude() > LARGEST_ANGLE || self.hi - self.lo > 6.3 {
            return (all, all);
        }
        let (mut sine, mut cosine) = sin_cos_of(self.lo);
        if self.lo < self.hi {
            let (s, c) = sin_cos_of(self.hi);
            (sine, cosine) = (sine.hull(s), cosine.hull(c));
            // Multiples of π/2 in the interval. The slack is above the rounding of the quotients, and an extreme within 1e-9 of a
            // bound raises the hull by 1e-18 at most.
            let first = (self.lo * std::f64::consts::FRAC_2_PI - 1e-9).ceil() as i64;
            let last = (self.hi * std::f64::consts::FRAC_2_PI + 1e-9).floor() as i64;
            for quarter in first..=last {
                let extreme = Self::point(if quarter.rem_euclid(4) < 2 { 1.0 } else { -1.0 });
                if quarter % 2 == 0 {
                    cosine = cosine.hull(extreme);
                } else {
                    sine = sine.hull(extreme);
                }
            }
        }
        (sine, cosine)
    }

    #[inline]
    fn sqrt(self) -> Self {
        if self.hi < 0.0 || !self.hi.is_finite() {
            return Self::ENTIRE;
        }
        if self.is_zero() || self.is_one() {
            return self;
        }
        let bounds = Self::outward(self.lo.max(0.0).sqrt(), self.hi.sqrt());
        Self { lo: bounds.lo.max(0.0), hi: bounds.hi }
    }
}

/// Largest angle (rad) of the reduction: multiples k of π/2 with k < 2²⁰, so that the products of k and the parts of π/2 are exact.
const LARGEST_ANGLE: f64 = 1.6e6;
/// π/2 in parts of 33 bits, and the remainder (fdlibm, `e_rem_pio2.c`): π/2 − the three parts is between 8.478e-32 and 8.479e-32.
const QUARTER: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21];
const REST: Interval = Interval { lo: 8.478e-32, hi: 8.479e-32 };
/// Bound of the error of [`sin_cos_of`] on |r| ≤ 0.79, relative to |r| for the sine and absolute for the cosine. Taylor remainders are
/// below 0.79¹⁷/17! < 6e-17; the roundings of the Horner form and its last sum are below 2 units of 2⁻⁵³.
const TAYLOR_ERROR: f64 = 2.0 * f64::EPSILON;

/// Sine and cosine of one number, |x| ≤ [`LARGEST_ANGLE`]: reduction x = k π/2 + r by parts, Taylor polynomial of r.
fn sin_cos_of(x: f64) -> (Interval, Interval) {
    if x == 0.0 {
        return (Interval::zero(), Interval::one());
    }
    let k = (x * std::f64::consts::FRAC_2_PI).round();
    let reduced = QUARTER.iter().fold(Interval::point(x), |r, part| r - Interval::point(k * part));
    let reduced = reduced - Interval::point(k) * REST;
    let r = reduced.mid();
    let z = r * r;
    let horner = |coefficients: [f64; 7]| coefficients.into_iter().rev().fold(0.0, |sum, c| sum * z + c);
    let sine = r + r * z * horner(SINE);
    let cosine = 1.0 - 0.5 * z + z * z * horner(COSINE);
    // The derivatives of both functions are at most 1: the radius of r is added.
    let [of_sine, of_cosine] = [r.abs(), 1.0].map(|size| up(TAYLOR_ERROR * size + reduced.radius()));
    let all = Interval { lo: -1.0, hi: 1.0 };
    let value = |x: f64, error: f64| {
        let interval = Interval { lo: down(x - error), hi: up(x + error) };
        interval.intersection(all).filter(|_| r.abs() < 0.79).unwrap_or(all)
    };
    let (s, c) = (value(sine, of_sine), value(cosine, of_cosine));
    match (k as i64).rem_euclid(4) {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// Coefficients of r³, r⁵, … r¹⁵ of the sine.
const SINE: [f64; 7] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
];
/// Coefficients of r⁴, r⁶, … r¹⁶ of the cosine.
const COSINE: [f64; 7] = [
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Unevaluated sum of two numbers with about 106 bits: the reference of these tests.
    type Double = (f64, f64);

    fn sum(a: Double, b: Double) -> Double {
        let s = a.0 + b.0;
        let v = s - a.0;
        let low = (a.0 - (s - v)) + (b.0 - v) + (a.1 + b.1);
        (s + low, low - ((s + low) - s))
    }

    fn product(a: Double, b: Double) -> Double {
        let p = a.0 * b.0;
        let low = a.0.mul_add(b.0, -p) + (a.0 * b.1 + a.1 * b.0);
        (p + low, low - ((p + low) - p))
    }

    /// Sine and cosine by the Taylor series of x/1024 and ten doublings: no reduction modulo π/2.
    fn reference_sin_cos(x: f64) -> (Double, Double) {
        let small = (x / 1024.0, 0.0);
        let mut term = (1.0, 0.0);
        // versine 1 − cos keeps its digits in the doublings.
        let (mut sine, mut versine) = ((0.0, 0.0), (0.0, 0.0));
        for n in 1..30 {
            let n_inverse =
                (1.0 / f64::from(n), (-f64::from(n)).mul_add(1.0 / f64::from(n), 1.0) / f64::from(n));
            term = product(product(term, small), n_inverse);
            let signed = if (n / 2) % 2 == 0 { term } else { (-term.0, -term.1) };
            if n % 2 == 1 {
                sine = sum(sine, signed);
            } else {
                versine = sum(versine, (-signed.0, -signed.1));
            }
        }
        for _ in 0..10 {
            let cosine = sum((1.0, 0.0), (-versine.0, -versine.1));
            let square = product(sine, sine);
            sine = product(product(sine, cosine), (2.0, 0.0));
            versine = (2.0 * square.0, 2.0 * square.1);
        }
        (sine, sum((1.0, 0.0), (-versine.0, -versine.1)))
    }

    /// True if the exact number is inside; `slack` is the error of the reference.
    fn encloses(interval: Interval, exact: Double, slack: f64) -> bool {
        let below = sum(exact, (-interval.lo, 0.0)).0;
        let above = sum((interval.hi, 0.0), (-exact.0, -exact.1)).0;
        below >= -slack && above >= -slack
    }

    /// Deterministic numbers of many magnitudes.
    fn numbers(count: usize) -> impl Iterator<Item = f64> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        (0..count).map(move |_| {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let fraction = (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
            fraction * 10_f64.powi((state % 13) as i32 - 6)
        })
    }

    #[test]
    fn operations_enclose_the_exact_results() {
        let pairs = numbers(20_000).zip(numbers(20_003).skip(3));
        for (x, y) in pairs {
            let (a, b) = (Interval::point(x), Interval::point(y));
            assert!(encloses(a + b, sum((x, 0.0), (y, 0.0)), 0.0), "{x} + {y}");
            assert!(encloses(a - b, sum((x, 0.0), (-y, 0.0)), 0.0), "{x} − {y}");
            assert!(encloses(a * b, product((x, 0.0), (y, 0.0)), 0.0), "{x} · {y}");
            // q is above x/y by the sign of q y − x.
            let quotient = a / b;
            let residual = |q: f64| q.mul_add(y, -x) * y.signum();
            assert!(residual(quotient.lo) <= 0.0 && residual(quotient.hi) >= 0.0, "{x} / {y}");
            let root = Interval::point(x.abs()).sqrt();
            assert!(root.lo.mul_add(root.lo, -x.abs()) <= 0.0 && root.hi.mul_add(root.hi, -x.abs()) >= 0.0);
            // Each bound is within 3 roundings of the rounded result.
            for (found, rounded) in [(a + b, x + y), (a * b, x * y), (quotient, x / y)] {
                assert!(found.radius() <= 3.0 * f64::EPSILON * rounded.abs() + 1e-300, "{x} {y}");
            }
        }
    }

    #[test]
    fn sines_and_cosines_enclose_the_exact_values() {
        // Ten doublings amplify the error 1e-32 of the reference, relative to |x|.
        let slack = |x: f64| 1e-27 * (1.0 + x.abs());
        let turns = (-40..40).map(|k| f64::from(k) * std::f64::consts::FRAC_PI_4);
        let angles: Vec<f64> = numbers(20_000).map(|x| x % 60.0).chain(turns).collect();
        for &x in &angles {
            let (s, c) = Interval::point(x).sin_cos();
            let (sine, cosine) = reference_sin_cos(x);
            assert!(encloses(s, sine, slack(x)) && encloses(c, cosine, slack(x)), "{x}");
            assert!(s.radius() < 1.5e-15 && c.radius() < 1.5e-15, "{x}");
        }
        for pair in angles.windows(2) {
            let wide = Interval::new(pair[0], pair[0] + pair[1].abs().min(7.0));
            let (s, c) = wide.sin_cos();
            for k in 0..=8 {
                let x = wide.lo + (wide.hi - wide.lo) * f64::from(k) / 8.0;
                let (sine, cosine) = reference_sin_cos(x);
                assert!(encloses(s, sine, slack(x)) && encloses(c, cosine, slack(x)), "{wide:?} {x}");
            }
        }
        let (s, c) = Interval::new(1.0, 2.0).sin_cos();
        assert!(s.hi == 1.0 && c.lo < -0.41 && c.lo > -0.42, "{s:?} {c:?}");
        assert_eq!(Interval::point(3e6).sin_cos().0, Interval::new(-1.0, 1.0));
    }

    #[test]
    fn special_numbers_give_no_nan() {
        let all = [
            0.0,
            1.0,
            -1.0,
            5e-324,
            -3.0,
            1e308,
            -1e308,
            f64::MAX,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
        ];
        for (&x, &y) in all.iter().flat_map(|x| all.iter().map(move |y| (x, y))) {
            let (a, b) = (Interval::new(x, y), Interval::point(y));
            for found in
                [a + b, a - b, a * b, a / b, a.sqrt(), a.square(), a.sin_cos().0, a.sin_cos().1, b * a]
            {
                assert!(found.lo <= found.hi, "{x} {y}: {found:?}");
            }
        }
        let (zero, third) = (Interval::zero(), Interval::one() / Interval::point(3.0));
        assert_eq!((zero * third, zero + third, third * Interval::point(-1.0)), (zero, third, -third));
        assert_eq!(Interval::new(-1.0, 2.0).square(), Interval::new(0.0, up(4.0)));
        assert_eq!(Interval::ENTIRE / Interval::new(-1.0, 1.0), Interval::ENTIRE);
    }
}
