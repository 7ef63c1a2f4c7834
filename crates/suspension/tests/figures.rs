//! Effective masses of real cars, compared with independently computed values (the first also with MuJoCo).

use super::mechanics::{place, respond};
use super::models::{hmmwv, sedan};
use super::{imported, on};
use nalgebra::Vector3;
use percuss_mechanism::Mechanism;
use percuss_suspension::Side;

/// Direction of the spring force at the lower seat.
fn spring_line(mechanism: &Mechanism) -> Vector3<f64> {
    (place(mechanism, "spring_chassis_seat") - place(mechanism, "spring_seat")).normalize()
}

#[test]
fn a_spring_feels_the_mass_of_a_real_wishbone() {
    // The reference values have nine digits.
    for (keys, mass, ratio) in [(hmmwv(), 207.342164, 2.21478924), (sedan(), 12.5797194, 1.92543335)] {
        for side in [Side::Left, Side::Right] {
            let mechanism = imported("DoubleWishbone", &keys, &on(side)).mechanism;
            let found = respond(&mechanism, "spring_seat", spring_line(&mechanism), &[]);
            assert!((found.mass / mass - 1.0).abs() < 5e-9, "{} and {mass}", found.mass);
            let spindle = mechanism.find_link("spindle").unwrap();
            let speed = found.speeds[spindle.index()];
            assert!((speed.z / ratio - 1.0).abs() < 5e-9, "{} and {ratio}", speed.z);
        }
    }
}

#[test]
fn the_axle_counts_when_the_spin_is_locked() {
    let mechanism = imported("DoubleWishbone", &hmmwv(), &on(Side::Left)).mechanism;
    let found = respond(&mechanism, "spring_seat", spring_line(&mechanism), &["spin"]);
    assert!((found.mass - 208.1525).abs() < 5e-5, "{}", found.mass);
    assert_eq!(found.mobility, 1);
}

#[test]
fn a_wishbone_of_rods_is_the_wishbone_without_its_arms() {
    // The linkage is the same: with massless arms, both models have the same effective mass.
    let weightless = super::models::changed(
        &hmmwv(),
        &[
            ("Upper Control Arm/Mass", "0"),
            ("Upper Control Arm/Moments of Inertia", "[0, 0, 0]"),
            ("Lower Control Arm/Mass", "0"),
            ("Lower Control Arm/Moments of Inertia", "[0, 0, 0]"),
        ],
    );
    let reduced = super::models::changed(
        &super::models::double_wishbone_reduced(),
        &hmmwv()
            .into_iter()
            .filter(|(key, _)| {
                let section = key.split('/').next().unwrap();
                !section.ends_with("Arm")
                    && section != "Spring"
                    && !key.contains("Moments")
                    && !key.contains("Products")
                    || key.contains("Arm/Location")
            })
            .filter(|(key, _)| !key.starts_with("Spring") && !key.starts_with("Shock"))
            .chain([("Upright/Inertia", "[0.1656, 0.1934, 0.04367]")])
            .collect::<Vec<_>>(),
    );
    let mass = |template, keys: &[(&str, &str)]| {
        let mechanism = imported(template, keys, &on(Side::Left)).mechanism;
        respond(&mechanism, "wheel_centre", Vector3::new(0.1, 0.2, 0.9).normalize(), &[]).mass
    };
    let (full, rods) = (mass("DoubleWishbone", &weightless), mass("DoubleWishboneReduced", &reduced));
    assert!((full / rods - 1.0).abs() < 1e-10, "{full} and {rods}");
}
