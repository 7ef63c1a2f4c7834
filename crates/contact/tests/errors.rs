//! Every error of this crate, with its message.

use percuss_contact::{
    BodyRegion, CompliantContact, ContactLawError, Damper, Law, Separation, TransientContact, hunt_crossley,
    kelvin_voigt, standard_robot_mass,
};
use std::fmt::Debug;

const NOT_NUMBERS: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn contact() -> CompliantContact<'static> {
    CompliantContact::new(2.0, 1e5).unwrap()
}

/// Asserts that the answer is `OutOfRange` with this quantity and this value.
fn assert_out_of_range<T: Debug>(answer: Result<T, ContactLawError>, quantity: &str, value: f64) {
    let error = answer.expect_err(quantity);
    let ContactLawError::OutOfRange { what, got, valid } = &error else { panic!("{quantity}: {error:?}") };
    assert_eq!(what.to_string(), quantity);
    assert!(got.to_bits() == value.to_bits() || got.is_nan() && value.is_nan(), "{error}");
    assert_eq!(error.to_string(), format!("{quantity}: {value:?} is out of range; expected {valid}"));
}

#[test]
fn contacts() {
    for bad in NOT_NUMBERS.into_iter().chain([0.0, -1.0, 1e-310]) {
        assert_out_of_range(CompliantContact::new(bad, 1.0), "effective mass, kg", bad);
        assert_out_of_range(CompliantContact::new(1.0, bad), "stiffness, N/m^p", bad);
    }
    for bad in NOT_NUMBERS.into_iter().chain([0.999, 10.001, 0.0, -1.5]) {
        assert_out_of_range(contact().with_exponent(bad), "exponent of the spring", bad);
    }
    assert_eq!(
        CompliantContact::new(-1.0, 1.0).unwrap_err().to_string(),
        "effective mass, kg: -1.0 is out of range; expected a finite number above 0"
    );
}

#[test]
fn restitutions() {
    for bad in NOT_NUMBERS.into_iter().chain([-1e-9, 1.0 + 1e-9]) {
        for law in Law::ALL {
            assert_out_of_range(
                law.damper(contact(), bad, Some(1.0), Separation::default()),
                "restitution",
                bad,
            );
            assert_out_of_range(law.approximation_error(bad), "restitution", bad);
        }
        assert_out_of_range(hunt_crossley::dissipation_number(bad), "restitution", bad);
        assert_out_of_range(hunt_crossley::dissipation_number_from_loss(bad), "1 - restitution", bad);
        for separation in Separation::ALL {
            assert_out_of_range(kelvin_voigt::ratio(bad, separation), "restitution", bad);
            assert_out_of_range(kelvin_voigt::ratio_from_loss(bad, separation), "1 - restitution", bad);
        }
    }
}

#[test]
fn a_restitution_of_zero_is_refused() {
    let message = |law: Law| {
        let error = law.damper(contact(), 0.0, Some(1.0), Separation::ForceVanishes).unwrap_err();
        assert!(matches!(error, ContactLawError::Unreachable { restitution: 0.0, .. }), "{error:?}");
        error.to_string()
    };
    assert_eq!(
        message(Law::KelvinVoigt),
        "kelvin-voigt: no damping gives the restitution 0.0: a contact that cannot pull approaches 0 only for \
         infinite damping (e = 1/(4 ratio^2)); use a small restitution, such as 0.01 (ratio 4.8)"
    );
    assert_eq!(
        message(Law::HuntCrossley),
        "hunt-crossley: no damping gives the restitution 0.0: the rebound speed approaches 1/d for large \
         dissipation d, and 0 only for d → ∞; use a small restitution, such as 0.01"
    );
    assert_eq!(
        message(Law::Gonthier),
        "gonthier: no damping gives the restitution 0.0: the damping becomes infinite for e → 0; use a small \
         restitution, such as 0.01"
    );
    for law in [Law::Flores, Law::HuGuo, Law::GharibHurmuzlu, Law::SafaeifarFarshidianfar, Law::ExudynMixed] {
        message(law);
    }
    // The damping of the other laws stays finite, so they do not reach e = 0.
    for law in [Law::LeeWang, Law::HuntCrossley1975, Law::CarvalhoMartins, Law::LankaraniNikravesh] {
        assert!(law.approximation_error(0.0).unwrap().achieved > 0.05, "{law:?}");
    }
    assert!(hunt_crossley::dissipation_number_from_loss(1.0).is_err());
    assert!(kelvin_voigt::ratio_from_loss(1.0, Separation::ForceVanishes).is_err());
}

#[test]
fn speeds() {
    for law in Law::ALL.into_iter().filter(|law| law.needs_speed()) {
        let error = law.damper(contact(), 0.5, None, Separation::default()).unwrap_err();
        assert_eq!(error, ContactLawError::SpeedNeeded { law: law.name() });
        let expected = "the damping depends on the closing speed: give the speed, in m/s";
        assert_eq!(error.to_string(), format!("{}: {expected}", law.name()));
    }
    for bad in NOT_NUMBERS.into_iter().chain([0.0, -1.0]) {
        assert_out_of_range(
            Law::HuntCrossley.damper(contact(), 0.5, Some(bad), Separation::default()),
            "closing speed, m/s",
            bad,
        );
        for damper in [
            Damper::hunt_crossley(0.1).unwrap(),
            Damper::kelvin_voigt(contact(), 0.1, Separation::default()).unwrap(),
        ] {
            assert_out_of_range(damper.impact(contact(), bad), "closing speed, m/s", bad);
            assert_out_of_range(damper.restitution(contact(), bad), "closing speed, m/s", bad);
            assert_out_of_range(damper.restitution_loss(contact(), bad), "closing speed, m/s", bad);
            assert_out_of_range(damper.history(contact(), bad, 10), "closing speed, m/s", bad);
        }
    }
}

#[test]
fn dampers() {
    let coefficient = "damping coefficient, N s/m^((p+1)/2)";
    for bad in NOT_NUMBERS.into_iter().chain([-1.0]) {
        for separation in Separation::ALL {
            assert_out_of_range(Damper::kelvin_voigt(contact(), bad, separation), "damping ratio", bad);
            assert_out_of_range(
                Damper::kelvin_voigt_from_coefficient(contact(), bad, separation),
                coefficient,
                bad,
            );
            assert_out_of_range(kelvin_voigt::restitution(bad, separation), "damping ratio", bad);
            assert_out_of_range(kelvin_voigt::restitution_loss(bad, separation), "damping ratio", bad);
            // Built field by field, without the checks of the constructors.
            let damper = Damper::KelvinVoigt { ratio: 0.1, coefficient: bad, separation };
            assert_out_of_range(damper.impact(contact(), 1.0), coefficient, bad);
        }
        assert_out_of_range(kelvin_voigt::compression_time(bad), "damping ratio", bad);
        assert_out_of_range(hunt_crossley::restitution(bad), "dissipation number", bad);
        assert_out_of_range(hunt_crossley::restitution_loss(bad), "dissipation number", bad);
        assert_out_of_range(Damper::hunt_crossley(bad), "dissipation, s/m", bad);
        assert_out_of_range(
            Damper::HuntCrossley { dissipation: bad }.impact(contact(), 1.0),
            "dissipation, s/m",
            bad,
        );
    }
}

#[test]
fn numbers_of_samples() {
    let damper = Damper::hunt_crossley(0.1).unwrap();
    for bad in [0, 1, 1_000_001, usize::MAX] {
        assert_out_of_range(damper.history(contact(), 1.0, bad), "number of samples", bad as f64);
    }
}

#[test]
fn overflow_is_an_error() {
    let not_representable = |answer: Result<_, ContactLawError>, quantity: &str| {
        let error = answer.expect_err(quantity);
        assert!(
            matches!(&error, ContactLawError::NotRepresentable { what } if *what == quantity),
            "{error:?}"
        );
        let expected = "too large or too small for a 64-bit float (about 1e-308 to 1e308); check the units";
        assert_eq!(error.to_string(), format!("{quantity}: {expected}"));
    };
    let extreme = CompliantContact::new(1e300, 1e300).unwrap();
    let gap = Separation::GapCloses;
    let ratio = Damper::kelvin_voigt(extreme, 1e10, gap).map(|_| ());
    not_representable(ratio, "damping coefficient, N s/m^((p+1)/2)");
    let damper = Damper::kelvin_voigt(contact(), 0.1, gap).unwrap();
    not_representable(damper.impact(contact(), 1e200).map(|_| ()), "energy lost, J");
    not_representable(
        damper.impact(CompliantContact::new(1e300, 1e-300).unwrap(), 1e200).map(|_| ()),
        "compression, m",
    );
    let stiff = Damper::hunt_crossley(1e200).unwrap();
    not_representable(stiff.impact(contact(), 1e150).map(|_| ()), "dissipation times closing speed");
}

#[test]
fn regions_and_robots() {
    let error = BodyRegion::from_name("lower_leg ").map(|region| region.name);
    assert_eq!(error, Ok("lower-leg"));
    let error = BodyRegion::from_name("cheast").unwrap_err();
    assert_eq!(
        error.to_string(),
        "\"cheast\" is not a region of the body in the table, did you mean \"chest\"?; known: skull, face, neck, back, \
         chest, abdomen, pelvis, upper-arm, lower-arm, hand, thigh, lower-leg"
    );
    assert!(matches!(
        BodyRegion::from_name("xyz"),
        Err(ContactLawError::UnknownRegion { nearest: None, .. })
    ));
    let chest = BodyRegion::from_name("chest").unwrap();
    let contact = TransientContact::new(chest, 10.0).unwrap();
    for bad in NOT_NUMBERS.into_iter().chain([0.0, -1.0]) {
        assert_out_of_range(TransientContact::new(chest, bad), "mass of the robot, kg", bad);
        assert_out_of_range(TransientContact::with_body(bad, 1.0, 1.0), "mass of the body's region, kg", bad);
        assert_out_of_range(
            TransientContact::with_body(1.0, bad, 1.0),
            "stiffness of the body's region, N/m",
            bad,
        );
        assert_out_of_range(contact.speed_for_force(bad), "greatest force, N", bad);
        assert_out_of_range(contact.speed_for_pressure(bad, 1.0), "greatest pressure, Pa", bad);
        assert_out_of_range(contact.speed_for_pressure(1.0, bad), "area of the contact, m^2", bad);
        assert_out_of_range(standard_robot_mass(bad, 1.0), "mass of the moving parts, kg", bad);
    }
    for bad in NOT_NUMBERS.into_iter().chain([-1.0]) {
        assert_out_of_range(contact.force(bad), "relative speed, m/s", bad);
        assert_out_of_range(standard_robot_mass(1.0, bad), "load, kg", bad);
    }
}
