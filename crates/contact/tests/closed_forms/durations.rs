//! Times of an impact, which are computed as integrals: light and heavy damping, and large exponents.

#![allow(clippy::excessive_precision, reason = "figures stand as the other program gave them")]

use crate::support::relative_difference;
use percuss_contact::{CompliantContact, Damper, Separation};

/// p, ζ, the time of the largest penetration and the duration until the force vanishes, in units of X/v, from the
/// integral of the trajectory with 40 digits.
const KELVIN_VOIGT: [(f64, f64, f64, f64); 18] = [
    (1.5, 1e-6, 1.47163700107834933, 2.94324851437268602),
    (1.5, 0.01, 1.4657623636794526, 2.90864866014437978),
    (1.5, 0.3, 1.32107051699589059, 2.54024708831670782),
    (1.5, 0.999999, 1.09489561259987948, 2.0946683712705547),
    (1.5, 1.0, 1.09489536600864954, 2.0946679021354946),
    (1.5, 1.000001, 1.09489511941758055, 2.09466743300075742),
    (1.5, 3.0, 0.789337362542412129, 1.51862005085830587),
    (1.5, 1e4, 0.00585470291592444093, 0.0115969801249425055),
    (1.5, 1e20, 4.31347677852243069e-15, 8.60913527430956229e-15),
    (10.0, 1e-6, 1.12076706856223454, 2.14952906630757916),
    (10.0, 0.01, 1.121409339289118, 1.76689401403688355),
    (10.0, 0.3, 1.13703148241711358, 1.56974296806443252),
    (10.0, 0.999999, 1.15991557122572409, 1.61349621112649423),
    (10.0, 1.0, 1.15991559454987647, 1.61349628656537884),
    (10.0, 1.000001, 1.15991561787400913, 1.61349636200424647),
    (10.0, 3.0, 1.18398992015688883, 1.72102698113159977),
    (10.0, 1e4, 0.752146499866373048, 1.34705481503165723),
    (10.0, 1e20, 0.00365567238461658793, 0.00711749415631341241),
];

/// As above with a = d v, with 40 digits; intermediate results have 320 digits for p = 10.
const HUNT_CROSSLEY: [(f64, f64, f64, f64); 19] = [
    (1.0, 1e-6, 1.57079599346173985, 3.14159265358992414),
    (1.0, 0.01, 1.56748053210926847, 3.1416056569554817),
    (1.0, 0.7, 1.39710202225091747, 3.18608369271816791),
    (1.0, 0.9, 1.3616194047331885, 3.20951434842378582),
    (1.0, 10.0, 0.861158951651976373, 5.02755590745099576),
    (1.0, 1e3, 0.185684970922691403, 44.7747362984318916),
    (1.0, 1e8, 0.00140056469571593531, 14142.1357924674435),
    (1.5, 1e-6, 1.47163735693831122, 2.94327538054311132),
    (1.5, 0.01, 1.46929721365172356, 2.94524343428341946),
    (1.5, 0.7, 1.34756092182182554, 3.10202403595021704),
    (1.5, 0.9, 1.32181235796645159, 3.15283910063694545),
    (1.5, 10.0, 0.938798563153534795, 5.90665623549867296),
    (1.5, 1e3, 0.296516396558860414, 83.3547333289044204),
    (1.5, 1e8, 0.0067952495081484617, 83255.3217339790663),
    (10.0, 1e-6, 1.12076697624928454, 2.24153461916519533),
    (10.0, 0.7, 1.10601959158349574, 2.66948229277141863),
    (10.0, 0.9, 1.10291593726074005, 2.79372682215994956),
    (10.0, 10.0, 1.05373433755716811, 9.59015569952809641),
    (10.0, 1e8, 0.531223038462835597, 19956925.7097136002),
];

/// Two successive steps of the quadrature agree to 1e-13, so the error of the second is smaller. The remainder is
/// cancellation in the trajectory.
const TOLERANCE: f64 = 1e-12;

/// Contact with X = 1 at the speed 1.
fn unit(exponent: f64) -> CompliantContact<'static> {
    CompliantContact::new(1.0, 0.5 * (exponent + 1.0)).unwrap().with_exponent(exponent).unwrap()
}

fn check(damper: Damper, exponent: f64, compression: f64, duration: f64) -> f64 {
    let impact = damper.impact(unit(exponent), 1.0).unwrap();
    let errors = [
        relative_difference(impact.time_of_max_penetration, compression),
        relative_difference(impact.duration.unwrap(), duration),
    ];
    for error in errors {
        assert!(error < TOLERANCE, "{damper:?} p={exponent}: {impact:?} off by {error:e}");
    }
    errors[0].max(errors[1])
}

#[test]
fn kelvin_voigt() {
    let worst = KELVIN_VOIGT.into_iter().map(|(exponent, ratio, compression, duration)| {
        let damper = Damper::kelvin_voigt(unit(exponent), ratio, Separation::ForceVanishes).unwrap();
        check(damper, exponent, compression, duration)
    });
    println!("{:e}", worst.fold(0.0, f64::max));
}

#[test]
fn hunt_crossley() {
    let worst = HUNT_CROSSLEY.into_iter().map(|(exponent, number, compression, duration)| {
        check(Damper::hunt_crossley(number).unwrap(), exponent, compression, duration)
    });
    println!("{:e}", worst.fold(0.0, f64::max));
}
