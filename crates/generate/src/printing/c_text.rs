//! Constant parts of the C code.

/// Sine and cosine without a library. `@` is the prefix of the names.
pub(crate) const SINE_COSINE: &str = "\
/* Sine and cosine, without tables and branches, so that loops over angles are vectorised. Reduction by multiples of
   pi/2 in three parts (the first two have 33 bits, so that their products are exact), then the polynomials of fdlibm
   (Sun Microsystems 1993). Error: at most 2 units in the last place or 1e-16, for angles up to 1e5 rad. */
static inline void @_sine_cosine(double angle, double *sine, double *cosine)
{
    const double rounding = 6755399441055744.0; /* adding and subtracting it rounds to an integer */
    const double quarters = (angle*0.6366197723675814 + rounding) - rounding;
    const double r = ((angle - quarters*1.5707963267341256) - quarters*6.077100506303966e-11)
        - quarters*2.0222662487959506e-21;
    const double z = r*r;
    const double turns = (quarters*0.25 + rounding) - rounding;
    const double j = quarters - 4.0*turns; /* -2, -1, 0, 1, 2 */
    const double size = fabs(j);
    const double z3 = z*z*z;
    const double sine_low = (-0.16666666666666632 + z*0.00833333333332249)
        + z*z*(-0.0001984126982985795);
    const double sine_high = (2.755731370707007e-06 + z*(-2.5050760253406863e-08)) + z*z*1.58969099521155e-10;
    const double cosine_low = (0.0416666666666666 + z*(-0.001388888888887411)) + z*z*2.480158728947673e-05;
    const double cosine_high = (-2.7557314351390663e-07 + z*2.087572321298175e-09)
        + z*z*(-1.1359647557788195e-11);
    const double s = r + r*z*(sine_low + z3*sine_high);
    const double half = 0.5*z;
    const double w = 1.0 - half;
    const double c = w + (((1.0 - w) - half) + z*z*(cosine_low + z3*cosine_high));
    const double c0 = 1.0 - size;
    const double s0 = j*(2.0 - size);
    *sine = s0*c + c0*s;
    *cosine = c0*c - s0*s;
}
";

/// Refusal of options that break the checks.
pub(crate) const NO_FAST_MATH: &str = "\
#if defined(__FAST_MATH__)
#error \"the checks of this file need IEEE arithmetic: compile it without -ffast-math\"
#endif
";
