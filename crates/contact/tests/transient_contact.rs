//! The speed at which a robot may touch a person, against the undamped impact and against figures.

use crate::support::apart;
use percuss_contact::{
    BodyRegion, CompliantContact, Damper, Separation, TransientContact, standard_robot_mass,
};

/// The standard's force is the peak force of an undamped linear contact of the two masses.
#[test]
fn it_is_the_undamped_impact() {
    let mut struck = 0;
    for region in BodyRegion::all() {
        for robot in [0.4, 4.0, 15.0, 120.0] {
            let contact = TransientContact::new(region, robot).unwrap();
            let mass = region.mass * robot / (region.mass + robot);
            assert!(apart(contact.reduced_mass(), mass) < 4.0 * f64::EPSILON, "{region:?} {robot}");
            let safe = contact.speed_for_force(100.0).unwrap();
            let linear = CompliantContact::new(mass, region.stiffness).unwrap();
            let damper = Damper::kelvin_voigt(linear, 0.0, Separation::ForceVanishes).unwrap();
            let impact = damper.impact(linear, safe.speed).unwrap();
            assert!(apart(impact.peak_force, 100.0) < 8.0 * f64::EPSILON, "{region:?} {robot}: {impact:?}");
            assert!(apart(safe.energy, 0.5 * mass * safe.speed * safe.speed) < 8.0 * f64::EPSILON);
            assert!(apart(safe.energy, 1e4 / (2.0 * contact.stiffness())) < 4.0 * f64::EPSILON);
            assert!(apart(contact.force(safe.speed).unwrap(), 100.0) < 4.0 * f64::EPSILON);
            struck += 1;
        }
    }
    assert_eq!(struck, 48);
}

/// A pressure on an area is a force.
#[test]
fn a_pressure_is_a_force() {
    let contact = TransientContact::new(BodyRegion::from_name("hand").unwrap(), 8.0).unwrap();
    // 1.4 MPa on 1 cm² is 140 N.
    let by_pressure = contact.speed_for_pressure(1.4e6, 1e-4).unwrap();
    let by_force = contact.speed_for_force(140.0).unwrap();
    assert!(apart(by_pressure.speed, by_force.speed) < 4.0 * f64::EPSILON);
}

/// How much the robot's mass matters: from 15 kg, as M/2 + m_L may have it, to a reflected 4 kg.
#[test]
fn the_reflected_mass_matters_where_the_body_is_heavy() {
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

/// The least certain rows say so.
#[test]
fn the_rows_with_less_behind_them_have_a_note() {
    let noted: Vec<&str> =
        BodyRegion::all().iter().filter(|region| region.note.is_some()).map(|region| region.name).collect();
    assert_eq!(noted, ["face", "neck", "back"]);
}
