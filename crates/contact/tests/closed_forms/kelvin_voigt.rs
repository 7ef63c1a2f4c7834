//! Relation of the Kelvin–Voigt law between damping ratio and restitution: reference values and limits.

#![allow(clippy::excessive_precision, reason = "figures stand as the other program gave them")]

use crate::support::relative_difference;
use percuss_contact::{CompliantContact, Damper, Law, Separation, kelvin_voigt};

const BOTH: [Separation; 2] = Separation::ALL;

/// ζ, C(ζ), e and 1 − e for a contact that ends when the force vanishes, from the definitions with 60 digits.
const REFERENCE: [(f64, f64, f64, f64); 21] = [
    (1e-12, 1.5707963267938966192, 0.99999999999685840735, 3.1415926535828583731e-12),
    (1e-9, 1.57079632579489662, 0.99999999685840735335, 3.1415926466549912466e-9),
    (1e-6, 1.5707953267956820167, 0.99999685841428119939, 3.1415857188006142238e-6),
    (0.001, 1.5697971115269818658, 0.9968653291490774144, 0.0031346708509225855999),
    (0.05, 1.5226800110860625384, 0.85875810177509182041, 0.14124189822490817959),
    (0.3, 1.3272372818926783031, 0.45097545289312849351, 0.54902454710687150649),
    (0.5, 1.2091995761561452337, 0.29843605919227488654, 0.70156394080772511346),
    (0.9, 1.0347264702353928957, 0.1552827475016816309, 0.8447172524983183691),
    (0.999, 1.0003334667238349325, 0.13551590485945108172, 0.86448409514054891828),
    (0.9999999, 1.0000000333333346491, 0.13533530128131885827, 0.86466469871868114173),
    (0.999999999999, 1.000000000000333326, 0.13533528323679313495, 0.86466471676320686505),
    (1.0, 1.0, 0.13533528323661269189, 0.86466471676338730811),
    (1.000000000001, 0.99999999999966663703, 0.13533528323643222881, 0.86466471676356777119),
    (1.0000001, 0.99999996666666798054, 0.13533526519190999413, 0.86466473480809000587),
    (1.001, 0.99966679994288256483, 0.13515501047828571353, 0.86484498952171428647),
    (1.5, 0.86081788192800807778, 0.075588309364956069159, 0.92441169063504393084),
    (3.0, 0.62322524014023051339, 0.023769514069357857355, 0.97623048593064214264),
    (10.0, 0.30083021498548185778, 0.0024379340486363733667, 0.99756206595136362663),
    (1e3, 0.0076009060099959437231, 2.4999822477937216557e-7, 0.99999975000177522063),
    (1e8, 1.9113827924512311712e-7, 2.4999999999999953465e-17, 0.999999999999999975),
    (1e100, 2.3095165647996451005e-98, 2.4999999999999999205e-201, 1.0),
];

/// e is the exponential of a number up to 461, which multiplies its rounding error by 461.
#[test]
fn the_functions_are_accurate_to_rounding() {
    let eps = f64::EPSILON;
    for (ratio, time, e, loss) in REFERENCE {
        let decrement = 2.0 * ratio * time;
        assert!(
            relative_difference(kelvin_voigt::compression_time(ratio).unwrap(), time) < 4.0 * eps,
            "C({ratio})"
        );
        let got = kelvin_voigt::restitution(ratio, Separation::ForceVanishes).unwrap();
        assert!(relative_difference(got, e) < (4.0 + 4.0 * decrement) * eps, "e({ratio}) = {got:?}");
        let got = kelvin_voigt::restitution_loss(ratio, Separation::ForceVanishes).unwrap();
        assert!(relative_difference(got, loss) < 8.0 * eps, "1 - e({ratio}) = {got:?}");
    }
}

/// ζ; e if the gap closes; e if the force vanishes, and for this end ω·duration, ω/v·penetration and
/// peak force/(v√(k m̄)). Confirmed by integration with event location in another program.
const TABLE: [(f64, f64, f64, f64, f64, f64); 14] = [
    (0.01, 0.969070903976, 0.969264750464, 3.121748411564, 0.984512443022, 0.984709378332),
    (0.05, 0.854467893007, 0.858758101775, 3.045360022172, 0.926692020995, 0.931344860811),
    (0.1, 0.729247614288, 0.744079397722, 2.956075324750, 0.862600369651, 0.880144344595),
    (0.2, 0.526620599330, 0.571740027585, 2.795354440735, 0.756134926838, 0.820918521756),
    (0.3, 0.372326104927, 0.450975452893, 2.654474563785, 0.671547059329, 0.813403183963),
    (0.4, 0.253826721980, 0.363526860769, 2.529755224782, 0.602931887338, 0.863510092838),
    (0.5, 0.163033534822, 0.298436059192, 2.418399152312, 0.546293015874, 1.0),
    (0.7, 0.045987910260, 0.210284564378, 2.227562281532, 0.458567949576, 1.4),
    (0.9, 0.001523755821, 0.155282747502, 2.069452940471, 0.394059319775, 1.8),
    (1.0, 0.0, 0.135335283237, 2.0, 0.367879441171, 2.0),
    (1.5, 0.0, 0.075588309365, 1.721635763856, 0.274933281661, 3.0),
    (2.0, 0.0, 0.047768732506, 1.520691992602, 0.218560592298, 4.0),
    (5.0, 0.0, 0.009284522147, 0.935881310104, 0.096356225265, 10.0),
    (10.0, 0.0, 0.002437934049, 0.601660429971, 0.049375439731, 20.0),
];

/// Compares with the table, which has twelve decimals.
#[test]
fn the_table_of_damping_ratios() {
    let (mass, stiffness, speed) = (2.5_f64, 4e4_f64, 0.7);
    let contact = CompliantContact::new(mass, stiffness).unwrap();
    let frequency = (stiffness / mass).sqrt();
    let near = |got: f64, expected: f64| (got - expected).abs() < 6e-13 * expected.max(1.0);
    for (ratio, e_gap, e_force, duration, penetration, force) in TABLE {
        let [by_force, by_gap] = BOTH.map(|separation| {
            let damper = Damper::kelvin_voigt(contact, ratio, separation).unwrap();
            damper.impact(contact, speed).unwrap()
        });
        assert!(near(by_gap.restitution, e_gap), "{ratio}: {by_gap:?}");
        assert!(near(by_force.restitution, e_force), "{ratio}: {by_force:?}");
        assert!(near(by_force.duration.unwrap() * frequency, duration), "{ratio}: {by_force:?}");
        assert!(near(by_force.time_of_max_penetration * frequency, 0.5 * duration), "{ratio}: {by_force:?}");
        match by_gap.duration {
            Some(time) => {
                let half_period = std::f64::consts::PI / (frequency * (1.0 - ratio * ratio).sqrt());
                assert!(ratio < 1.0 && near(time / half_period, 1.0), "{ratio}: {by_gap:?}");
            }
            None => assert!(ratio >= 1.0 && by_gap.rebound_speed == 0.0, "{ratio}: {by_gap:?}"),
        }
        for impact in [by_force, by_gap] {
            assert!(near(impact.max_penetration * frequency / speed, penetration), "{ratio}: {impact:?}");
            assert!(
                near(impact.peak_force / (speed * (stiffness * mass).sqrt()), force),
                "{ratio}: {impact:?}"
            );
        }
    }
}

/// e, ζ if the gap closes, ζ if the force vanishes.
const INVERSE: [(f64, f64, f64); 13] = [
    (0.99, 0.00319910489126, 0.00320564684954),
    (0.95, 0.01632498691666, 0.01649823092017),
    (0.9, 0.03351844910568, 0.03426520412623),
    (0.8, 0.07085030019537, 0.07435509709764),
    (0.7, 0.11280845069358, 0.12221474778772),
    (0.6, 0.16049304666428, 0.18085830836414),
    (0.5, 0.21545376196625, 0.25527563764865),
    (0.4, 0.27999799333504, 0.35450771580309),
    (0.3, 0.35785713050332, 0.49723939469929),
    (0.2, 0.45594981076913, 0.73124692678045),
    (0.1, 0.59115503379890, 1.24318785101378),
    (0.05, 0.69010673055982, 1.94534618440771),
    (0.01, 0.82608505461396, 4.80694180177966),
];

#[test]
fn the_table_of_restitutions() {
    for (e, gap, force) in INVERSE {
        for (separation, expected) in [(Separation::GapCloses, gap), (Separation::ForceVanishes, force)] {
            let got = kelvin_voigt::ratio(e, separation).unwrap();
            assert!((got - expected).abs() < 6e-15 * (1.0 + expected), "{e} {separation:?}: {got:?}");
        }
    }
}

/// Restitution in a simulator without adhesion for a damping ratio from the half-period formula of textbooks.
#[test]
fn the_half_period_ratio_gives_a_larger_restitution_without_adhesion() {
    for (required, got) in [(0.2, 0.324863), (0.5, 0.550283), (0.8, 0.808099)] {
        let ratio = kelvin_voigt::ratio(required, Separation::GapCloses).unwrap();
        let e = kelvin_voigt::restitution(ratio, Separation::ForceVanishes).unwrap();
        assert!((e - got).abs() < 6e-7, "{required}: {e}");
    }
}

#[test]
fn conversions_are_inverse() {
    let mut restitutions: Vec<f64> = (1..1000).map(|i| f64::from(i) / 1000.0).collect();
    restitutions.extend([1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1.0 - 1e-6, 1.0 - 1e-9, 1.0 - 1e-12]);
    let critical = (-2.0_f64).exp();
    restitutions.extend([critical * (1.0 - 1e-9), critical, critical * (1.0 + 1e-9)]);
    for separation in BOTH {
        for &e in &restitutions {
            let ratio = kelvin_voigt::ratio(e, separation).unwrap();
            let back = kelvin_voigt::restitution(ratio, separation).unwrap();
            assert!(relative_difference(back, e) < 1e-12, "{e} {separation:?}: {ratio:?} gives {back:?}");
        }
        for loss in [1e-300, 1e-20, 1e-12, 1e-9, 1e-3, 0.5] {
            let ratio = kelvin_voigt::ratio_from_loss(loss, separation).unwrap();
            let back = kelvin_voigt::restitution_loss(ratio, separation).unwrap();
            assert!(
                relative_difference(back, loss) < 1e-14,
                "1 - {loss:e} {separation:?}: {ratio:?} gives {back:?}"
            );
        }
    }
}

/// ζ = ε/π (1 + ε/2 + 2ε/π²) + O(ε³) for e = 1 − ε without adhesion: −ln e = ε + ε²/2, ζ = (L/π)(1 + 2L/π²).
#[test]
fn the_series_near_no_loss() {
    let pi = std::f64::consts::PI;
    for loss in [1e-9, 1e-6] {
        let series = loss / pi * (1.0 + 0.5 * loss + 2.0 * loss / (pi * pi));
        let ratio = kelvin_voigt::ratio_from_loss(loss, Separation::ForceVanishes).unwrap();
        // The next term of the series is of the order ε².
        assert!(relative_difference(ratio, series) < 4.0 * f64::EPSILON + loss * loss, "{loss:e}: {ratio:?}");
    }
    // The float nearest to 1 − 1e-9 differs from it by 2.8e-17: the exact difference is used.
    let e = 1.0 - 1e-9;
    let direct = kelvin_voigt::ratio(e, Separation::ForceVanishes).unwrap();
    let by_loss = kelvin_voigt::ratio_from_loss(1.0 - e, Separation::ForceVanishes).unwrap();
    assert!(relative_difference(direct, by_loss) < 4.0 * f64::EPSILON);
}

/// ζ → ½ e^(−1/2) for small e.
#[test]
fn the_limit_near_no_rebound() {
    for e in [1e-6_f64, 1e-12, 1e-100, 1e-300] {
        let ratio = kelvin_voigt::ratio(e, Separation::ForceVanishes).unwrap();
        // ln e = −2 ln(2ζ) − (2 ln(2ζ) − 1)/(2ζ²) + …: relative error of about e |ln e|.
        assert!(
            relative_difference(ratio, 0.5 / e.sqrt()) < 2.0 * e * e.ln().abs() + 2e-13,
            "{e:e}: {ratio:e}"
        );
    }
}

#[test]
fn the_ends_of_the_range() {
    for separation in BOTH {
        assert_eq!(kelvin_voigt::ratio(1.0, separation), Ok(0.0));
        assert_eq!(kelvin_voigt::restitution(0.0, separation), Ok(1.0));
    }
    assert_eq!(kelvin_voigt::ratio(0.0, Separation::GapCloses), Ok(1.0));
    assert_eq!(kelvin_voigt::restitution(1.0, Separation::GapCloses), Ok(0.0));
    assert_eq!(kelvin_voigt::restitution(7.0, Separation::GapCloses), Ok(0.0));
    assert!(kelvin_voigt::ratio(0.0, Separation::ForceVanishes).is_err());
    let elastic = Law::KelvinVoigt;
    let contact = CompliantContact::new(1.0, 1.0).unwrap();
    let damper = elastic.damper(contact, 1.0, None, Separation::ForceVanishes).unwrap();
    let impact = damper.impact(contact, 1.0).unwrap();
    assert_eq!((impact.energy_lost, impact.rebound_speed), (0.0, 1.0));
    assert!(relative_difference(impact.duration.unwrap(), std::f64::consts::PI) < 2.0 * f64::EPSILON);
    assert!(relative_difference(impact.peak_force, 1.0) < 2.0 * f64::EPSILON);
}

/// With increasing damping the peak force first decreases, then increases: the minimum is at ζ = 0.264932.
#[test]
fn the_least_peak_force() {
    let contact = CompliantContact::new(1.0, 1.0).unwrap();
    let peak = |ratio: f64| {
        let damper = Damper::kelvin_voigt(contact, ratio, Separation::ForceVanishes).unwrap();
        damper.impact(contact, 1.0).unwrap().peak_force
    };
    assert!((peak(0.2649320861) - 0.8101247520).abs() < 1e-10);
    assert!(peak(0.2549320861) > 0.81013 && peak(0.2749320861) > 0.81013);
}

/// On another contact the coefficient c determines the force, not the damping ratio on the first contact.
#[test]
fn the_coefficient_is_the_damper() {
    let [first, heavier] = [1.5, 6.0].map(|mass| CompliantContact::new(mass, 1e5).unwrap());
    let damper = Law::KelvinVoigt.damper(first, 0.5, None, Separation::ForceVanishes).unwrap();
    let Damper::KelvinVoigt { ratio, coefficient, separation } = damper else { panic!("{damper:?}") };
    assert!(relative_difference(coefficient, 2.0 * ratio * (1e5_f64 * 1.5).sqrt()) < 1e-15);
    let expected = kelvin_voigt::restitution(0.5 * ratio, separation).unwrap();
    assert!(relative_difference(damper.restitution(heavier, 1.0).unwrap(), expected) < 1e-15);
    let again = Damper::kelvin_voigt_from_coefficient(first, coefficient, separation).unwrap();
    assert!(relative_difference(again.restitution(first, 1.0).unwrap(), 0.5) < 1e-15);
}
