//! Relation of the Hunt–Crossley law between dissipation and restitution: reference values and limits.

#![allow(clippy::excessive_precision, reason = "figures stand as the other program gave them")]

use crate::support::relative_difference;
use percuss_contact::{CompliantContact, Damper, Law, Separation, hunt_crossley};

/// a, e and 1 − e from the implicit relation with 60 digits; from a = 100 on, e = 1/a to all digits of a float.
const REFERENCE: [(f64, f64, f64); 17] = [
    (1e-12, 0.99999999999933333333, 6.6666666666622220881e-13),
    (1e-9, 0.99999999933333333378, 6.6666666622222226407e-10),
    (1e-6, 0.99999933333377777745, 6.6666622222254811772e-7),
    (1e-4, 0.99993333777745187753, 0.000066662222548122474446),
    (0.01, 0.99337745439876736327, 0.0066225456012326367339),
    (0.1, 0.93747557994990506052, 0.062524420050094939484),
    (0.3, 0.83286979226560167021, 0.16713020773439832979),
    (0.5, 0.74843493159743415812, 0.25156506840256584188),
    (0.9, 0.61973646608197512881, 0.38026353391802487119),
    (1.0, 0.59362426004004009232, 0.40637573995995990768),
    (2.0, 0.4107196860610394467, 0.5892803139389605533),
    (3.0, 0.30689679829096211452, 0.69310320170903788548),
    (5.0, 0.19698024528051888505, 0.80301975471948111495),
    (10.0, 0.099981624752943886879, 0.90001837524705611312),
    (20.0, 0.049999999203831142392, 0.95000000079616885761),
    (100.0, 0.01, 0.99),
    (1e100, 1e-100, 1.0),
];

#[test]
fn the_functions_are_accurate_to_rounding() {
    for (a, e, loss) in REFERENCE {
        let got = hunt_crossley::restitution(a).unwrap();
        assert!(relative_difference(got, e) < 8.0 * f64::EPSILON, "e({a}) = {got:?}");
        let got = hunt_crossley::restitution_loss(a).unwrap();
        assert!(relative_difference(got, loss) < 8.0 * f64::EPSILON, "1 - e({a}) = {got:?}");
    }
}

/// e and a, for the floats nearest to these e, with 50 digits.
const TABLE: [(f64, f64); 12] = [
    (0.1, 9.9981593974956673),
    (0.2, 4.9191667157907862),
    (0.3, 3.0870819811296244),
    (0.4, 2.0824981641470068),
    (0.5, 1.432750533271375),
    (0.6, 0.97487171081326537),
    (0.7, 0.63482828126641687),
    (0.8, 0.37314620336505357),
    (0.9, 0.16648195068530806),
    (0.95, 0.078926605287415305),
    (0.99, 0.015151362109441019),
    (1.0, 0.0),
];

#[test]
fn the_table_of_restitutions() {
    for (e, a) in TABLE {
        let got = hunt_crossley::dissipation_number(e).unwrap();
        assert!((got - a).abs() <= 6.0 * f64::EPSILON * a, "{e}: {got:?}");
    }
}

#[test]
fn the_implicit_relation_holds() {
    for i in 1..1000 {
        let e = f64::from(i) / 1000.0;
        let a = hunt_crossley::dissipation_number(e).unwrap();
        // 1 − e a is a difference: its relative error grows as 1/(1 − e a), which is e^a for small e.
        let left = a * (1.0 + e);
        let right = ((1.0 + a) / (1.0 - e * a)).ln();
        let rounding = 4.0 * f64::EPSILON * (left + 1.0 / (1.0 - e * a) + 1.0);
        assert!(a < 30.0 || e < 0.04);
        assert!(1.0 - e * a < 1e-15 || (left - right).abs() < rounding, "{e}: {left:?} {right:?}");
    }
}

#[test]
fn conversions_are_inverse() {
    let mut restitutions: Vec<f64> = (1..1000).map(|i| f64::from(i) / 1000.0).collect();
    restitutions.extend([1e-2, 1e-6, 1e-12, 1e-100, 1e-300, 1.0 - 1e-6, 1.0 - 1e-9, 1.0 - 1e-12]);
    for e in restitutions {
        let a = hunt_crossley::dissipation_number(e).unwrap();
        let back = hunt_crossley::restitution(a).unwrap();
        assert!(relative_difference(back, e) < 1e-14, "{e}: {a:?} gives {back:?}");
    }
    for loss in [1e-300, 1e-20, 1e-12, 1e-9, 1e-3, 0.5] {
        let a = hunt_crossley::dissipation_number_from_loss(loss).unwrap();
        let back = hunt_crossley::restitution_loss(a).unwrap();
        assert!(relative_difference(back, loss) < 1e-14, "1 - {loss:e}: {a:?} gives {back:?}");
    }
}

/// a = (3/2)ε + (3/2)ε² + (27/20)ε³ + (6/5)ε⁴ + (759/700)ε⁵ + …, ε = 1 − e.
#[test]
fn the_series_near_no_loss() {
    for loss in [1e-12, 1e-9, 1e-6, 1e-4, 1e-3] {
        let series = loss * (1.5 + loss * (1.5 + loss * (1.35 + loss * (1.2 + loss * (759.0 / 700.0)))));
        let a = hunt_crossley::dissipation_number_from_loss(loss).unwrap();
        // The next term is ε⁵ of the first.
        assert!(relative_difference(a, series) < 8.0 * f64::EPSILON + loss.powi(5), "{loss:e}: {a:?}");
        // Inverse series: e = 1 − (2/3)a + (4/9)a² − (44/135)a³ + ….
        let back = a * (2.0 / 3.0 - a * (4.0 / 9.0 - a * (44.0 / 135.0 - a * (104.0 / 405.0))));
        assert!(relative_difference(back, loss) < 8.0 * f64::EPSILON + a.powi(4), "{loss:e}: {back:?}");
    }
}

/// a → 1/e, and the rebound speed stays below 1/d.
#[test]
fn the_limit_near_no_rebound() {
    for e in [1e-2, 1e-6, 1e-12, 1e-300] {
        let a = hunt_crossley::dissipation_number(e).unwrap();
        assert!(relative_difference(a, 1.0 / e) < 4.0 * f64::EPSILON, "{e:e}: {a:?}");
    }
    for a in [0.1, 1.0, 10.0, 30.0] {
        assert!(hunt_crossley::restitution(a).unwrap() * a < 1.0);
    }
}

/// The relation does not contain k, m̄ or p.
#[test]
fn the_restitution_depends_on_dissipation_times_speed_alone() {
    for (mass, stiffness, exponent, speed) in
        [(0.1, 1e3, 1.0, 0.01), (1.0, 1e5, 1.5, 1.0), (50.0, 1e7, 3.0, 5.0)]
    {
        let contact = CompliantContact::new(mass, stiffness).unwrap().with_exponent(exponent).unwrap();
        let damper = Damper::hunt_crossley(1.0 / speed).unwrap();
        let e = damper.restitution(contact, speed).unwrap();
        assert!(relative_difference(e, 0.59362426004004009232) < 1e-15, "{contact:?}: {e:?}");
    }
}

/// 2 √π Γ(1 + 1/(p+1))/Γ(1/2 + 1/(p+1)) X/v, with 50 digits.
#[test]
fn the_duration_without_damping() {
    let durations = [
        (1.0, std::f64::consts::PI),
        (1.5, 2.9432751843247046574),
        (2.0, 2.8043642106509085224),
        (3.0, 2.6220575542921198105),
        (10.0, 2.2415340078377519519),
    ];
    for (p, expected) in durations {
        let contact = CompliantContact::new(1.0, 0.5 * (p + 1.0)).unwrap().with_exponent(p).unwrap();
        for damper in [
            Damper::hunt_crossley(0.0).unwrap(),
            Damper::hunt_crossley(1e-15).unwrap(),
            Damper::hunt_crossley(1e-30).unwrap(),
            Damper::kelvin_voigt(contact, 0.0, Separation::ForceVanishes).unwrap(),
            Damper::kelvin_voigt(contact, 1e-16, Separation::GapCloses).unwrap(),
        ] {
            let impact = damper.impact(contact, 1.0).unwrap();
            // Required agreement of two successive steps of the quadrature.
            assert!(
                relative_difference(impact.duration.unwrap(), expected) < 1e-13,
                "p={p} {damper:?}: {impact:?}"
            );
            assert!(relative_difference(impact.max_penetration, 1.0) < 1e-14, "p={p} {damper:?}: {impact:?}");
        }
    }
}

#[test]
fn light_damping_dissipates_the_predicted_energy() {
    let contact = CompliantContact::new(2.0, 1e4).unwrap().with_exponent(1.5).unwrap();
    for dissipation in [1e-9, 1e-16, 1e-100] {
        let damper = Damper::hunt_crossley(dissipation).unwrap();
        // ½ m̄ v² (1 − e²) = ½ m̄ v² (4/3) d v for small d v.
        let lost = damper.impact(contact, 3.0).unwrap().energy_lost;
        let expected = 9.0 * 4.0 / 3.0 * dissipation * 3.0;
        assert!(
            relative_difference(lost, expected) < 1e-15 + 2.0 * dissipation * 3.0,
            "{dissipation:e}: {lost:e}"
        );
    }
    let damper = Law::HuntCrossley.damper(contact, 1.0, Some(3.0), Separation::ForceVanishes).unwrap();
    assert_eq!(damper, Damper::HuntCrossley { dissipation: 0.0 });
    assert_eq!(damper.impact(contact, 3.0).unwrap().energy_lost, 0.0);
}
