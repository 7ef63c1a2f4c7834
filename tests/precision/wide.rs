//! Floating-point numbers of 320 bits, 96 decimal digits: the arithmetic of the reference.
//!
//! Results are truncated, not rounded: the error of an operation is at most two units in the last bit.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Words per mantissa.
const WORDS: usize = 5;
/// Bits per mantissa.
const BITS: i64 = 64 * WORDS as i64;

/// Number ± 0.mantissa · 2^exponent, with the mantissa's highest bit set, or zero.
#[derive(Clone, Copy, Debug)]
pub struct Wide {
    negative: bool,
    exponent: i64,
    /// Least significant word first; all zero for zero.
    mantissa: [u64; WORDS],
}

impl Wide {
    pub const ZERO: Self = Self { negative: false, exponent: 0, mantissa: [0; WORDS] };

    /// The exact value of a double.
    pub fn new(x: f64) -> Self {
        assert!(x.is_finite(), "{x} is no number");
        if x == 0.0 {
            return Self::ZERO;
        }
        let bits = x.abs().to_bits();
        let (stored, fraction) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
        let whole = if stored == 0 { fraction } else { fraction | 1 << 52 };
        let mut mantissa = [0; WORDS];
        let shift = whole.leading_zeros();
        mantissa[WORDS - 1] = whole << shift;
        Self { negative: x < 0.0, exponent: stored.max(1) - 1075 + 64 - i64::from(shift), mantissa }
    }

    pub fn is_zero(&self) -> bool {
        self.mantissa[WORDS - 1] == 0
    }

    pub fn abs(self) -> Self {
        Self { negative: false, ..self }
    }

    /// Nearest double, to one unit in the last place.
    pub fn to_f64(self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        let [.., low, high] = self.mantissa;
        let value = high as f64 + low as f64 * 2f64.powi(-64);
        let power = (self.exponent - 64) as i32;
        // In two steps: a single power of two may underflow.
        let scaled = value * 2f64.powi(power / 2) * 2f64.powi(power - power / 2);
        if self.negative { -scaled } else { scaled }
    }

    /// The number times 2^power.
    pub fn shifted(self, power: i64) -> Self {
        if self.is_zero() { self } else { Self { exponent: self.exponent + power, ..self } }
    }

    fn larger_mantissa(&self, other: &Self) -> Ordering {
        self.mantissa.iter().rev().cmp(other.mantissa.iter().rev())
    }

    fn compare_sizes(&self, other: &Self) -> Ordering {
        match (self.is_zero(), other.is_zero()) {
            (true, true) => Ordering::Equal,
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
            _ => self.exponent.cmp(&other.exponent).then_with(|| self.larger_mantissa(other)),
        }
    }

    /// Mantissa shifted right by `by` bits.
    fn aligned(&self, by: i64) -> [u64; WORDS] {
        let mut shifted = [0; WORDS];
        if by >= BITS {
            return shifted;
        }
        let (words, bits) = ((by / 64) as usize, (by % 64) as u32);
        for i in 0..WORDS - words {
            let low = self.mantissa[i + words] >> bits;
            let above = if bits > 0 && i + words + 1 < WORDS {
                self.mantissa[i + words + 1] << (64 - bits)
            } else {
                0
            };
            shifted[i] = low | above;
        }
        shifted
    }

    fn normalized(mut self) -> Self {
        let Some(top) = self.mantissa.iter().rposition(|word| *word != 0) else { return Self::ZERO };
        let bits = self.mantissa[top].leading_zeros();
        let words = WORDS - 1 - top;
        let mut shifted = [0; WORDS];
        for i in (0..=top).rev() {
            let below = if bits > 0 && i > 0 { self.mantissa[i - 1] >> (64 - bits) } else { 0 };
            shifted[i + words] = self.mantissa[i] << bits | below;
        }
        self.mantissa = shifted;
        self.exponent -= 64 * words as i64 + i64::from(bits);
        self
    }

    /// Sum of the magnitudes of two numbers, the larger first.
    fn sum_of_sizes(large: &Self, small: &Self) -> Self {
        let other = small.aligned(large.exponent - small.exponent);
        let (mut mantissa, mut carry) = (large.mantissa, false);
        for (word, add) in mantissa.iter_mut().zip(other) {
            let (sum, first) = word.overflowing_add(add);
            let (sum, second) = sum.overflowing_add(u64::from(carry));
            (*word, carry) = (sum, first | second);
        }
        let mut exponent = large.exponent;
        if carry {
            for i in 0..WORDS {
                let above = if i + 1 < WORDS { mantissa[i + 1] << 63 } else { 1 << 63 };
                mantissa[i] = mantissa[i] >> 1 | above;
            }
            exponent += 1;
        }
        Self { negative: large.negative, exponent, mantissa }
    }

    /// Difference of the magnitudes of two numbers, the larger first.
    fn difference_of_sizes(large: &Self, small: &Self) -> Self {
        let other = small.aligned(large.exponent - small.exponent);
        let (mut mantissa, mut borrow) = (large.mantissa, false);
        for (word, take) in mantissa.iter_mut().zip(other) {
            let (rest, first) = word.overflowing_sub(take);
            let (rest, second) = rest.overflowing_sub(u64::from(borrow));
            (*word, borrow) = (rest, first | second);
        }
        Self { negative: large.negative, exponent: large.exponent, mantissa }.normalized()
    }

    /// 1/x by Newton's method from a double.
    fn inverse(self) -> Self {
        assert!(!self.is_zero(), "1/0");
        let near = Self { negative: false, exponent: 0, ..self };
        let two = Self::new(2.0);
        let mut inverse = Self::new(1.0 / near.to_f64());
        for _ in 0..3 {
            inverse = inverse * (two - near * inverse);
        }
        Self { negative: self.negative, ..inverse.shifted(-self.exponent) }
    }

    /// √x by Newton's method for 1/√x.
    pub fn sqrt(self) -> Self {
        if self.is_zero() {
            return self;
        }
        assert!(!self.negative, "the root of a negative number");
        let half = self.exponent.div_euclid(2);
        let near = Self { exponent: self.exponent - 2 * half, ..self };
        let three = Self::new(3.0);
        let mut inverse = Self::new(1.0 / near.to_f64().sqrt());
        for _ in 0..3 {
            inverse = (inverse * (three - near * inverse * inverse)).shifted(-1);
        }
        (near * inverse).shifted(half)
    }

    /// Sine and cosine of a double: series of a small fraction of the angle, then repeated doubling.
    pub fn sin_cos(angle: f64) -> (Self, Self) {
        const HALVINGS: i64 = 24;
        let x = Self::new(angle).shifted(-HALVINGS);
        let square = x * x;
        // 1 − cos x, which keeps its digits.
        let (mut sin, mut versine) = (x, Self::ZERO);
        let (mut term, mut k) = (x, 1.0);
        while !term.is_zero() && term.exponent > x.exponent - BITS {
            let even = term * x * Self::new(k + 1.0).inverse();
            versine = if (k as i64 / 2) % 2 == 0 { versine + even } else { versine - even };
            term = term * square * Self::new((k + 1.0) * (k + 2.0)).inverse();
            sin = if (k as i64 / 2) % 2 == 0 { sin - term } else { sin + term };
            k += 2.0;
        }
        let one = Self::new(1.0);
        for _ in 0..HALVINGS {
            let next = (sin * (one - versine)).shifted(1);
            versine = (sin * sin).shifted(1);
            sin = next;
        }
        (sin, one - versine)
    }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (large, small) = if self.compare_sizes(&other).is_ge() { (self, other) } else { (other, self) };
        if small.is_zero() {
            large
        } else if large.negative == small.negative {
            Self::sum_of_sizes(&large, &small)
        } else {
            Self::difference_of_sizes(&large, &small)
        }
    }
}

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self { negative: !self.negative, ..self }
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let mut product = [0u64; 2 * WORDS];
        for i in 0..WORDS {
            let mut carry = 0u128;
            for k in 0..WORDS {
                let sum = u128::from(self.mantissa[i]) * u128::from(other.mantissa[k])
                    + u128::from(product[i + k])
                    + carry;
                product[i + k] = sum as u64;
                carry = sum >> 64;
            }
            product[i + WORDS] = carry as u64;
        }
        let mut mantissa = [0; WORDS];
        mantissa.copy_from_slice(&product[WORDS..]);
        let mut exponent = self.exponent + other.exponent;
        if mantissa[WORDS - 1] >> 63 == 0 {
            for i in (0..WORDS).rev() {
                let below = if i > 0 { mantissa[i - 1] >> 63 } else { product[WORDS - 1] >> 63 };
                mantissa[i] = mantissa[i] << 1 | below;
            }
            exponent -= 1;
        }
        Self { negative: self.negative != other.negative, exponent, mantissa }
    }
}

impl Div for Wide {
    type Output = Self;

    #[expect(clippy::suspicious_arithmetic_impl, reason = "a quotient is the product with the inverse")]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}

impl AddAssign for Wide {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Wide {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl PartialEq for Wide {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Wide {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let sizes = self.compare_sizes(other);
        Some(match (self.negative && !self.is_zero(), other.negative && !other.is_zero()) {
            (false, true) => Ordering::Greater,
            (true, false) => Ordering::Less,
            (false, false) => sizes,
            (true, true) => sizes.reverse(),
        })
    }
}

#[test]
fn arithmetic_keeps_ninety_digits() {
    let of = Wide::new;
    let tiny = |x: Wide| x.is_zero() || x.exponent < -300;
    for x in [3.0, 0.1, 7e-9, -2.5e17, 1.0 / 3.0] {
        let wide = of(x);
        assert_eq!(wide.to_f64(), x);
        assert!(tiny(of(1.0) / wide * wide - of(1.0)));
        let root = wide.abs().sqrt();
        assert!(tiny((root * root - wide.abs()) / wide));
        let angle = x % 3.0;
        let (sin, cos) = Wide::sin_cos(angle);
        assert!(tiny(sin * sin + cos * cos - of(1.0)));
        assert!((sin.to_f64() - angle.sin()).abs() < 1e-15 && (cos.to_f64() - angle.cos()).abs() < 1e-15);
    }
    // Addition theorem: sin 2x = 2 sin x cos x.
    let ((sin, cos), (twice, _)) = (Wide::sin_cos(0.7), Wide::sin_cos(1.4));
    assert!(tiny(twice - (sin * cos).shifted(1)));
    // A cancelling sum keeps small terms.
    assert_eq!((of(1e18) + of(1e-18) - of(1e18)).to_f64(), 1e-18);
}
