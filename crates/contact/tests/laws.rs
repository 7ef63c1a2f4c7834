//! All laws: names, conversion to a damper and back, and errors of the approximations.

use crate::support::integrated::IntegratedImpact;
use crate::support::relative_difference;
use percuss_contact::{CompliantContact, ContactLawError, Damper, Law, Separation};
use std::collections::BTreeSet;

/// Restitution of each approximation for the required e = 0.1, 0.2, …, 0.9, 0.95, and the largest error of the ten. Four
/// decimals, computed by another program from the formulas and the exact relation.
const ACHIEVED: [(Law, [f64; 10], f64); 12] = [
    (
        Law::HuntCrossley1975,
        [0.5158, 0.5469, 0.5813, 0.6197, 0.6630, 0.7120, 0.7680, 0.8329, 0.9090, 0.9524],
        0.416,
    ),
    (
        Law::HerbertMcwhannell,
        [0.4907, 0.5008, 0.5200, 0.5503, 0.5936, 0.6511, 0.7227, 0.8070, 0.9009, 0.9501],
        0.391,
    ),
    (Law::LeeWang, [0.6867, 0.7120, 0.7390, 0.7680, 0.7992, 0.8329, 0.8693, 0.9090, 0.9524, 0.9756], 0.587),
    (
        Law::LankaraniNikravesh,
        [0.6653, 0.6723, 0.6842, 0.7016, 0.7252, 0.7562, 0.7960, 0.8471, 0.9132, 0.9535],
        0.565,
    ),
    (Law::Gonthier, [0.1010, 0.2046, 0.3042, 0.3978, 0.4877, 0.5773, 0.6696, 0.7680, 0.8764, 0.9359], 0.032),
    (
        Law::ZhiyingQishao,
        [0.2175, 0.2664, 0.3267, 0.3988, 0.4826, 0.5769, 0.6796, 0.7874, 0.8959, 0.9489],
        0.118,
    ),
    (Law::Flores, [0.0694, 0.1555, 0.2562, 0.3629, 0.4704, 0.5773, 0.6832, 0.7885, 0.8939, 0.9468], 0.045),
    (
        Law::GharibHurmuzlu,
        [0.1000, 0.1970, 0.2819, 0.3524, 0.4107, 0.4595, 0.5008, 0.5362, 0.5668, 0.5807],
        0.369,
    ),
    (Law::HuGuo, [0.0741, 0.1656, 0.2707, 0.3797, 0.4877, 0.5936, 0.6973, 0.7992, 0.8999, 0.9500], 0.034),
    (
        Law::CarvalhoMartins,
        [0.1289, 0.2116, 0.3040, 0.4011, 0.5002, 0.6000, 0.7000, 0.8000, 0.9000, 0.9500],
        0.029,
    ),
    (
        Law::SafaeifarFarshidianfar,
        [0.0889, 0.1970, 0.3138, 0.4279, 0.5362, 0.6383, 0.7350, 0.8271, 0.9152, 0.9580],
        0.038,
    ),
    (
        Law::ExudynMixed,
        [0.1010, 0.2046, 0.3042, 0.4011, 0.5002, 0.6000, 0.7000, 0.8000, 0.9000, 0.9500],
        0.005,
    ),
];

const REQUIRED: [f64; 10] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95];

fn contact() -> CompliantContact<'static> {
    CompliantContact::new(1.3, 4.1e4).unwrap().with_exponent(1.5).unwrap()
}

#[test]
fn the_approximations_have_the_tabulated_errors() {
    let mut listed = 0;
    for (law, achieved, worst) in ACHIEVED {
        assert!(!law.is_exact(), "{law:?}");
        let mut most = 0.0_f64;
        for (required, expected) in REQUIRED.into_iter().zip(achieved) {
            let error = law.approximation_error(required).unwrap();
            assert_eq!(error.requested, required);
            assert!((error.achieved - expected).abs() < 6e-5, "{law:?} {required}: {error:?}");
            most = most.max(error.error().abs());
            // The damper has the predicted restitution.
            let damper = law.damper(contact(), required, Some(0.7), Separation::default()).unwrap();
            let e = damper.restitution(contact(), 0.7).unwrap();
            assert!(relative_difference(e, error.achieved) < 1e-14, "{law:?} {required}: {e}");
        }
        assert!((most - worst).abs() < 6e-4, "{law:?} misses by up to {most}");
        listed += 1;
    }
    assert_eq!(listed, Law::ALL.iter().filter(|law| !law.is_exact()).count());
}

/// For every law, the predicted restitution agrees with the integrated motion.
#[test]
fn every_laws_damper_gives_the_predicted_rebound() {
    let (contact, speed) = (contact(), 0.7);
    for law in Law::ALL {
        for required in [0.2, 0.5, 0.8] {
            let predicted = law.approximation_error(required).unwrap().achieved;
            let damper = law.damper(contact, required, Some(speed), Separation::default()).unwrap();
            let (k, p) = contact.power_law().expect("a spring");
            let force = |x: f64, rate: f64| match damper {
                Damper::KelvinVoigt { coefficient, .. } => k * x.powf(p) + coefficient * x.powf(0.25) * rate,
                Damper::HuntCrossley { dissipation } => k * x.powf(p) * (1.0 + dissipation * rate),
                Damper::LossFactor { .. } => damper.force(contact, x, rate),
            };
            let impact = IntegratedImpact {
                mass: contact.mass(),
                speed,
                length: (contact.mass() * speed * speed / k).powf(1.0 / (p + 1.0)),
                force: &force,
                ends_with_the_force: law == Law::KelvinVoigt,
            };
            let measured = impact.measure().restitution;
            // Tolerance as in integration.rs.
            assert!(
                relative_difference(measured, predicted) < 1e-11,
                "{law:?} {required}: {measured}, not {predicted}"
            );
        }
    }
}

/// Ratio of the dissipation number of each approximation to the exact one for e → 1 and for e → 0.
#[test]
fn the_limits_of_the_approximations() {
    use percuss_contact::hunt_crossley::dissipation_number;
    let share = |law: Law, e: f64| {
        let Damper::HuntCrossley { dissipation } =
            law.damper(contact(), e, Some(1.0), Separation::default()).unwrap()
        else {
            panic!("{law:?}")
        };
        dissipation / dissipation_number(e).unwrap()
    };
    let near_one = [
        (Law::HuntCrossley1975, 1.0),
        (Law::HerbertMcwhannell, 1.0),
        (Law::LeeWang, 0.5),
        (Law::LankaraniNikravesh, 1.0),
        (Law::Gonthier, 4.0 / 3.0),
        (Law::ZhiyingQishao, 1.0),
        (Law::Flores, 16.0 / 15.0),
        (Law::HuGuo, 1.0),
        (Law::CarvalhoMartins, 1.0),
        (Law::SafaeifarFarshidianfar, 5.0 / 6.0),
        (Law::ExudynMixed, 1.0),
    ];
    for (law, limit) in near_one {
        // At least first order in 1 − e.
        assert!((share(law, 1.0 - 1e-7) - limit).abs() < 1e-6, "{law:?}: {}", share(law, 1.0 - 1e-7));
    }
    let near_zero = [
        (Law::Gonthier, 1.0),
        (Law::GharibHurmuzlu, 1.0),
        (Law::HuGuo, 1.5),
        (Law::Flores, 1.6),
        (Law::SafaeifarFarshidianfar, 1.25),
        (Law::ExudynMixed, 1.0),
        (Law::HuntCrossley1975, 0.0),
        (Law::CarvalhoMartins, 0.0),
    ];
    for (law, limit) in near_zero {
        assert!((share(law, 1e-8) - limit).abs() < 1e-6, "{law:?}: {}", share(law, 1e-8));
    }
}

#[test]
fn the_exact_laws_reach_the_restitution() {
    for law in Law::ALL.into_iter().filter(|law| law.is_exact()) {
        for separation in Separation::ALL {
            for i in 1..=1000 {
                let e = f64::from(i) / 1000.0;
                let damper = law.damper(contact(), e, Some(2.5), separation).unwrap();
                let got = damper.restitution(contact(), 2.5).unwrap();
                // The force of the return, e² of that of the approach, is a difference from 1.
                let rounding = if law == Law::LossFactor { f64::EPSILON / (e * e) } else { 0.0 };
                assert!(relative_difference(got, e) < 1e-12 + rounding, "{law:?} {separation:?} {e}: {got}");
                assert_eq!(law.approximation_error(e).unwrap().achieved, e);
            }
        }
    }
}

#[test]
fn names_are_unique_and_are_parsed_back() {
    let mut names = BTreeSet::new();
    for law in Law::ALL {
        assert_eq!(Law::from_name(law.name()), Ok(law));
        assert_eq!(Law::from_name(&law.name().to_uppercase().replace('-', "_")), Ok(law));
        assert!(names.insert(law.name()), "{} twice", law.name());
        for text in [law.title(), law.formula(), law.source()] {
            assert!(!text.is_empty() && !text.contains("  "), "{law:?}: {text:?}");
        }
        assert_eq!(law.needs_speed(), ![Law::KelvinVoigt, Law::LossFactor].contains(&law));
    }
    assert_eq!(names.len(), Law::ALL.len());
    for alias in Law::ALIASES {
        assert_eq!(Law::from_name(alias.name), Ok(alias.law));
        assert!(names.insert(alias.name) && !alias.note.is_empty(), "{alias:?}");
    }
}

#[test]
fn separations_have_names() {
    for separation in Separation::ALL {
        assert_eq!(Separation::from_name(separation.name()), Some(separation));
    }
    assert_eq!(Separation::from_name("never"), None);
    assert_eq!(Separation::default(), Separation::ForceVanishes);
}

#[test]
fn an_unknown_name_lists_the_known() {
    let error = Law::from_name("hunt-crosley").unwrap_err();
    let ContactLawError::UnknownLaw { nearest, .. } = &error else { panic!("{error:?}") };
    assert_eq!(*nearest, Some("hunt-crossley"));
    let message = error.to_string();
    assert!(message.starts_with(
        "\"hunt-crosley\" is not a contact law, did you mean \"hunt-crossley\"?; known: kelvin-voigt, "
    ));
    assert!(message.ends_with(", ye"), "{message}");
    assert!(matches!(Law::from_name(""), Err(ContactLawError::UnknownLaw { nearest: None, .. })));
}

/// The damper of Tsuji and others is √5 ζ √(k m̄) x^(1/4) for the exponent 3/2.
#[test]
fn tsujis_coefficient() {
    let damper = Damper::kelvin_voigt(contact(), 0.3, Separation::default()).unwrap();
    let Damper::KelvinVoigt { coefficient, .. } = damper else { panic!("{damper:?}") };
    assert!(
        relative_difference(coefficient, 5f64.sqrt() * 0.3 * (4.1e4_f64 * 1.3).sqrt()) < 4.0 * f64::EPSILON
    );
}
