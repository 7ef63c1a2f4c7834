//! Speed limit of a robot that may hit a person, compared with the undamped impact and with numbers computed by hand.

use crate::support::relative_difference;
use percuss_contact::{
    BodyRegion, CompliantContact, Damper, Separation, TransientContact, standard_robot_mass,
};

/// The force of the standard is the peak force of an undamped linear contact between the two masses.
#[test]
fn the_force_is_that_of_the_undamped_impact() {
    let mut struck = 0;
    for region in BodyRegion::all() {
        for robot in [0.4, 4.0, 15.0, 120.0] {
            let contact = TransientContact::new(region, robot).unwrap();
            let mass = region.mass * robot / (region.mass + robot);
            assert!(
                relative_difference(contact.reduced_mass(), mass) < 4.0 * f64::EPSILON,
                "{region:?} {robot}"
            );
            let safe = contact.speed_for_force(100.0).unwrap();
            let linear = CompliantContact::new(mass, region.stiffness).unwrap();
            let damper = Damper::kelvin_voigt(linear, 0.0, Separation::ForceVanishes).unwrap();
            let impact = damper.impact(linear, safe.speed).unwrap();
            assert!(
                relative_difference(impact.peak_force, 100.0) < 8.0 * f64::EPSILON,
                "{region:?} {robot}: {impact:?}"
            );
            assert!(
                relative_difference(safe.energy, 0.5 * mass * safe.speed * safe.speed) < 8.0 * f64::EPSILON
            );
            assert!(relative_difference(safe.energy, 1e4 / (2.0 * contact.stiffness())) < 4.0 * f64::EPSILON);
            assert!(relative_difference(contact.force(safe.speed).unwrap(), 100.0) < 4.0 * f64::EPSILON);
            // The same speed by its energy and by its momentum.
            let by_energy = contact.speed_for_energy(safe.energy).unwrap();
            let by_momentum = contact.speed_for_momentum(mass * safe.speed).unwrap();
            for other in [by_energy, by_momentum] {
                assert!(relative_difference(other.speed, safe.speed) < 8.0 * f64::EPSILON);
                assert!(relative_difference(other.force, 100.0) < 16.0 * f64::EPSILON);
            }
            struck += 1;
        }
    }
    assert_eq!(struck, 48);
}

/// A limit of pressure on an area is a limit of force.
#[test]
fn a_pressure_is_a_force() {
    let contact = TransientContact::new(BodyRegion::from_name("hand").unwrap(), 8.0).unwrap();
    // 1.4 MPa on 1 cm² is 140 N.
    let by_pressure = contact.speed_for_pressure(1.4e6, 1e-4).unwrap();
    let by_force = contact.speed_for_force(140.0).unwrap();
    assert!(relative_difference(by_pressure.speed, by_force.speed) < 4.0 * f64::EPSILON);
}

/// Effect of the robot's mass: 15 kg, a typical M/2 + m_L, compared with an effective mass of 4 kg.
#[test]
fn the_robot_mass_matters_for_heavy_body_regions() {
    assert_eq!(standard_robot_mass(24.0, 3.0), Ok(15.0));
    for (name, ratio) in [("chest", 1.732), ("hand", 1.052), ("lower-leg", 1.814)] {
        let region = BodyRegion::from_name(name).unwrap();
        let [standard, reflected] = [15.0, 4.0]
            .map(|mass| TransientContact::new(region, mass).unwrap().speed_for_force(100.0).unwrap().speed);
        assert!((reflected / standard - ratio).abs() < 6e-4, "{name}: {}", reflected / standard);
    }
}

#[test]
fn nothing_moves_at_rest() {
    let contact = TransientContact::with_body(1.0, 1e4, 2.0).unwrap();
    assert_eq!(contact.force(0.0), Ok(0.0));
}

/// The most uncertain rows of the table have a note.
#[test]
fn uncertain_regions_have_a_note() {
    let noted: Vec<&str> =
        BodyRegion::all().iter().filter(|region| region.note.is_some()).map(|region| region.name).collect();
    assert_eq!(noted, ["face", "neck", "back"]);
}
