//! Aligned buffers for SIMD: loads and stores of whole registers do not cross a cache line.

use std::ops::{Deref, DerefMut};

/// Bytes of the widest register, and of a cache line.
const LINE: usize = 64;
/// Numbers per cache line.
const NUMBERS: usize = LINE / size_of::<f64>();

/// Buffer of numbers that begins at the start of a cache line.
#[derive(Debug)]
pub struct Aligned {
    /// The numbers, with padding before and after.
    values: Vec<f64>,
    first: usize,
    count: usize,
}

impl Aligned {
    /// Buffer of `count` zeros.
    pub fn zeros(count: usize) -> Self {
        let values = vec![0.0; count + NUMBERS];
        let first = values.as_ptr().align_offset(LINE).min(NUMBERS);
        Self { values, first, count }
    }
}

impl Deref for Aligned {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.values[self.first..][..self.count]
    }
}

impl DerefMut for Aligned {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.values[self.first..][..self.count]
    }
}

impl Clone for Aligned {
    fn clone(&self) -> Self {
        let mut clone = Self::zeros(self.count);
        clone.copy_from_slice(self);
        clone
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clone_has_the_same_values_and_alignment() {
        for count in 0..40 {
            let mut buffer = Aligned::zeros(count);
            buffer.iter_mut().enumerate().for_each(|(k, x)| *x = k as f64);
            let clone = buffer.clone();
            assert_eq!(buffer[..], clone[..]);
            assert_eq!((clone.len(), clone.as_ptr().addr() % LINE), (count, 0));
        }
    }
}
