//! Gradient of m̄ along the motion of a four-bar and of an arm, compared with differences of m̄.
//!
//! dm̄/dt = Σ g · q̇ for the velocities q̇ of all joints of an admissible motion. With loops, q̇ is that of the closed mechanism: here the
//! change of all positions from pose to pose. `cargo run -p percuss --example gradients`

use percuss::{Conditions, Contact, EffectiveMass, LoadOptions, Pose, Source, System, load};
use std::error::Error;

/// Step of the driving joint, rad.
const STEP: f64 = 1e-4;
/// Largest deviation relative to m̄ per radian: central differences deviate by the square of the step and by rounding over the step.
const TOLERANCE: f64 = 1e-6;

/// m̄, kg.
fn effective_mass(pose: &Pose, contact: &Contact) -> Result<f64, Box<dyn Error>> {
    match pose.respond(contact)?.effective_mass {
        EffectiveMass::Finite(mass) => Ok(mass),
        _ => Err("no finite mass".into()),
    }
}

/// Compares dm̄/dq of one driving joint, kg/rad.
fn compare(
    file: &str,
    text: &str,
    driver: &str,
    contact_of: (&str, [f64; 3], [f64; 3]),
) -> Result<(), Box<dyn Error>> {
    let mechanism = load(&Source::from_text(file, text), &LoadOptions::default())?.mechanism;
    let contact = Contact::new(mechanism.find_link(contact_of.0)?, contact_of.1, contact_of.2);
    let system = System::new(mechanism, &Conditions::new())?;
    let mut configuration = system.configuration();
    for angle in [0.1, 0.4, 0.7] {
        let mut pose_at = |q: f64| -> Result<Pose, Box<dyn Error>> {
            Ok(system.pose(configuration.replace(driver, &[q])?)?)
        };
        let (before, at, after) = (pose_at(angle - STEP)?, pose_at(angle)?, pose_at(angle + STEP)?);
        let gradient = at.effective_mass_gradient(&contact)?.ok_or("no gradient")?.joints.concat();
        // All joints of these models are hinges or fixed: velocities are rates of the positions.
        let rates = before.positions().iter().zip(after.positions()).map(|(a, b)| (b - a) / (2.0 * STEP));
        let exact: f64 = gradient.iter().zip(rates).map(|(g, rate)| g * rate).sum();
        let mass = effective_mass(&at, &contact)?;
        let difference =
            (effective_mass(&after, &contact)? - effective_mass(&before, &contact)?) / (2.0 * STEP);
        println!(
            "{file}, {driver} at {angle} rad: m̄ {mass:.6} kg, gradient {exact:.9}, difference {difference:.9} kg/rad"
        );
        if (exact - difference).abs() > TOLERANCE * mass {
            return Err(format!("{exact} and {difference} kg/rad differ").into());
        }
    }
    Ok(())
}

/// A mechanism with a loop, and one without.
pub fn main() -> Result<(), Box<dyn Error>> {
    let bar = include_str!("../../../models/four_bar.urdf");
    compare("four_bar.urdf", bar, "crank_hinge", ("coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]))?;
    let arm = include_str!("../../../models/six_r_arm.urdf");
    compare("six_r_arm.urdf", arm, "elbow", ("tool", [0.08, 0.0, 0.0], [0.0, 1.0, 0.0]))
}
