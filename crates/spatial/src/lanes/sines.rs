//! Sine and cosine in lanes, without tables and branches.

use super::lane::Lanes;

/// π/2 in three parts. The first two have 33 bits, so their products with integers of up to 20 bits are exact.
/// Source: argument reduction of fdlibm (Sun Microsystems 1993).
const HALF_PI: [f64; 3] = [
    f64::from_bits(0x3FF9_21FB_5440_0000),
    f64::from_bits(0x3DD0_B461_1A60_0000),
    f64::from_bits(0x3BA3_198A_2E03_7073),
];
/// Adding and subtracting this number rounds to an integer.
const ROUNDING: f64 = 6_755_399_441_055_744.0;
/// sin r = r + r³ (S₀ + S₁ r² + …), |r| ≤ π/4: fdlibm's minimax coefficients, error below 2⁻⁵⁸.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_007e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
/// cos r = 1 − r²/2 + r⁴ (C₀ + C₁ r² + …).
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// c₀ + c₁ z + … + c₅ z⁵.
#[inline(always)]
fn polynomial<T: Lanes>(c: &[f64; 6], z: T) -> T {
    let of = T::from_f64;
    let high = z.mul_add(z.mul_add(of(c[5]), of(c[4])), of(c[3]));
    let low = z.mul_add(z.mul_add(of(c[2]), of(c[1])), of(c[0]));
    (z * z * z).mul_add(high, low)
}

/// Largest angle (rad) for which sine and cosine in lanes are correct to two units in the last place or 1e-16.
pub const LARGEST_ANGLE: f64 = 1e5;

/// Sine and cosine of angles (rad) up to [`LARGEST_ANGLE`]; results for larger angles are invalid.
#[inline(always)]
pub fn sin_cos<T: Lanes>(angle: T) -> (T, T) {
    let of = T::from_f64;
    let quarters = angle.mul_add(of(std::f64::consts::FRAC_2_PI), of(ROUNDING)) - of(ROUNDING);
    let r = quarters.mul_add(of(-HALF_PI[0]), angle);
    let r = quarters.mul_add(of(-HALF_PI[1]), r);
    let r = quarters.mul_add(of(-HALF_PI[2]), r);
    let z = r * r;
    let sine = (r * z).mul_add(polynomial(&SINE, z), r);
    let half = of(0.5) * z;
    let w = T::one() - half;
    // Restores the rounding error of 1 − z/2.
    let cosine = w + (z * z).mul_add(polynomial(&COSINE, z), (T::one() - w) - half);
    // For j ∈ {−2, …, 2}: cos(j π/2) = 1 − |j| and sin(j π/2) = j (2 − |j|), without a comparison.
    let turns = quarters.mul_add(of(0.25), of(ROUNDING)) - of(ROUNDING);
    let j = turns.mul_add(of(-4.0), quarters);
    let (c, s) = (T::one() - j.abs(), j * (of(2.0) - j.abs()));
    (s.mul_add(cosine, c * sine), c.mul_add(cosine, -(s * sine)))
}

#[cfg(test)]
mod tests {
    use crate::lanes::{Instructions, Lanes, Work};

    /// Kernel that computes sines and cosines of a list of angles.
    struct Sines<'a> {
        angles: &'a [f64],
        sines: &'a mut [f64],
        cosines: &'a mut [f64],
    }

    impl Work for Sines<'_> {
        fn run<T: Lanes>(self) {
            for k in (0..self.angles.len()).step_by(T::WIDTH) {
                let (sine, cosine) = T::load(&self.angles[k..]).sin_cos();
                sine.store(&mut self.sines[k..]);
                cosine.store(&mut self.cosines[k..]);
            }
        }
    }

    /// 400,000 angles up to 1e5 and angles near multiples of π/2, to two units in the last place or 1e-16.
    #[test]
    fn sines_and_cosines_are_those_of_the_standard_library() {
        let golden = 0.618_033_988_749_894_9;
        let spread = (0..200_000).map(|k| ((f64::from(k) * golden).fract() - 0.5) * 2e5);
        let small = (0..100_000).map(|k| ((f64::from(k) * golden).fract() - 0.5) * 8.0);
        let near = (0..100_000).map(|k| {
            let right = f64::from(k % 60_000) * std::f64::consts::FRAC_PI_2;
            right + f64::from(k % 7 - 3) * right * f64::EPSILON
        });
        // Miri interprets: every angle would take hours.
        let step = if cfg!(miri) { 1000 } else { 1 };
        let angles: Vec<f64> = spread.chain(small).chain(near).step_by(step).collect();
        let off = |a: f64, b: f64| (a - b).abs() <= (2.0 * f64::EPSILON * b.abs()).max(1e-16);
        for set in [Instructions::Baseline, Instructions::Avx2, Instructions::Avx512] {
            for one in [false, true] {
                let (mut sines, mut cosines) = (vec![0.0; angles.len()], vec![0.0; angles.len()]);
                let work = Sines { angles: &angles, sines: &mut sines, cosines: &mut cosines };
                if one {
                    set.run_one(work)
                } else {
                    set.run(work)
                }
                for ((q, s), c) in angles.iter().zip(&sines).zip(&cosines) {
                    assert!(
                        off(*s, q.sin()) && off(*c, q.cos()),
                        "{q:e}: {s:e} {c:e}, {:e} {:e}",
                        q.sin(),
                        q.cos()
                    );
                }
            }
        }
    }
}
