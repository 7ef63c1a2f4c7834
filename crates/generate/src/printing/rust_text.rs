//! Constant parts of the Rust code.

/// Sine and cosine without a library.
pub(crate) const SINE_COSINE: &str = "\
/// Sine and cosine, without tables and branches. Reduction by multiples of pi/2 in three parts, then the polynomials of
/// fdlibm (Sun Microsystems 1993). Error: at most 2 units in the last place or 1e-16, for angles up to 1e5 rad.
#[inline(always)]
fn sine_cosine(angle: f64) -> (f64, f64) {
    // Adding and subtracting this number rounds to an integer.
    let rounding = 6755399441055744.0;
    let quarters = (angle*0.6366197723675814 + rounding) - rounding;
    let r = ((angle - quarters*1.5707963267341256) - quarters*6.077100506303966e-11) - quarters*2.0222662487959506e-21;
    let z = r*r;
    let turns = (quarters*0.25 + rounding) - rounding;
    // -2, -1, 0, 1, 2.
    let j = quarters - 4.0*turns;
    let size = if j < 0.0 { -j } else { j };
    let z3 = z*z*z;
    let sine_low = (-0.16666666666666632 + z*0.00833333333332249) + z*z*(-0.0001984126982985795);
    let sine_high = (2.755731370707007e-06 + z*(-2.5050760253406863e-08)) + z*z*1.58969099521155e-10;
    let cosine_low = (0.0416666666666666 + z*(-0.001388888888887411)) + z*z*2.480158728947673e-05;
    let cosine_high = (-2.7557314351390663e-07 + z*2.087572321298175e-09) + z*z*(-1.1359647557788195e-11);
    let s = r + r*z*(sine_low + z3*sine_high);
    let half = 0.5*z;
    let w = 1.0 - half;
    let c = w + (((1.0 - w) - half) + z*z*(cosine_low + z3*cosine_high));
    let c0 = 1.0 - size;
    let s0 = j*(2.0 - size);
    (s0*c + c0*s, c0*c - s0*s)
}
";

/// Square root without a library.
pub(crate) const SQUARE_ROOT: &str = "\
/// Square root by Newton's iteration from an estimate of the exponent; error: 1 unit in the last place.
fn square_root(x: f64) -> f64 {
    if !(x > 0.0 && x < f64::INFINITY) {
        return if x == 0.0 || x == f64::INFINITY { x } else { f64::NAN };
    }
    let mut root = f64::from_bits((x.to_bits() >> 1) + (1023 << 51));
    for _ in 0..6 {
        root = 0.5*(root + x/root);
    }
    root
}
";
