//! Lanes in a register of an instruction set.

/// Lane type from the operations of a register. The operations are called only where the processor is known to support the set.
macro_rules! lanes {
    ($name:ident, $register:ty, $width:literal, $splat:ident, $load:ident, $store:ident, $add:ident, $sub:ident, $mul:ident,
        $div:ident, $sqrt:ident, $max:ident, |$n:ident| $neg:expr, |$x:ident| $abs:expr, |$a:ident, $b:ident, $c:ident| $mul_add:expr) => {
        #[derive(Clone, Copy, Debug)]
        struct $name($register);

        impl $name {
            #[inline(always)]
            fn numbers(self) -> [f64; $width] {
                let mut numbers = [0.0; $width];
                self.store(&mut numbers);
                numbers
            }
        }

        impl PartialEq for $name {
            fn eq(&self, other: &Self) -> bool {
                self.numbers() == other.numbers()
            }
        }

        lanes!(@operator $name, Add, add, AddAssign, add_assign, $add);
        lanes!(@operator $name, Sub, sub, SubAssign, sub_assign, $sub);
        lanes!(@operator $name, Mul, mul, MulAssign, mul_assign, $mul);
        lanes!(@operator $name, Div, div, DivAssign, div_assign, $div);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                let $n = self.0;
                // SAFETY: called only inside functions compiled for the set.
                Self(unsafe { $neg })
            }
        }

        impl Zero for $name {
            #[inline(always)]
            fn zero() -> Self {
                Self::from_f64(0.0)
            }
            fn is_zero(&self) -> bool {
                self.numbers() == [0.0; $width]
            }
        }

        impl One for $name {
            #[inline(always)]
            fn one() -> Self {
                Self::from_f64(1.0)
            }
        }

        impl Scalar for $name {
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                // SAFETY: called only inside functions compiled for the set.
                Self(unsafe { $splat(x) })
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                sin_cos(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: called only inside functions compiled for the set.
                Self(unsafe { $sqrt(self.0) })
            }
        }

        impl Lanes for $name {
            const WIDTH: usize = $width;
            #[inline(always)]
            fn load(from: &[f64]) -> Self {
                let from = &from[..$width];
                // SAFETY: the slice has at least WIDTH numbers; the load needs no alignment.
                Self(unsafe { $load(from.as_ptr()) })
            }
            #[inline(always)]
            fn store(self, to: &mut [f64]) {
                let to = &mut to[..$width];
                // SAFETY: the slice has at least WIDTH numbers; the store needs no alignment.
                unsafe { $store(to.as_mut_ptr(), self.0) }
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                let ($a, $b, $c) = (self.0, factor.0, addend.0);
                // SAFETY: called only inside functions compiled for the set.
                Self(unsafe { $mul_add })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                let $x = self.0;
                // SAFETY: called only inside functions compiled for the set.
                Self(unsafe { $abs })
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                // SAFETY: called only inside functions compiled for the set.
                Self(unsafe { $max(other.0, self.0) })
            }
        }
    };
    (@operator $name:ident, $trait:ident, $method:ident, $assign:ident, $assign_method:ident, $intrinsic:ident) => {
        impl $trait for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: called only inside functions compiled for the set.
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
        impl $assign for $name {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = (*self).$method(other);
            }
        }
    };
}

pub(super) use lanes;
