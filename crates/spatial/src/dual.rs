//! Dual numbers: value and derivative in one direction. The only module that uses `num-dual`.

use crate::Scalar;
pub use num_dual::Dual64;
use num_dual::DualNum;

impl Scalar for Dual64 {
    fn from_f64(x: f64) -> Self {
        Dual64::from_re(x)
    }

    fn sin_cos(self) -> (Self, Self) {
        DualNum::sin_cos(&self)
    }

    fn sqrt(self) -> Self {
        DualNum::sqrt(&self)
    }
}
