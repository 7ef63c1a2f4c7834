//! Writer of mechanisms as SDFormat.

mod bodies;
mod closures;
mod error;
mod joints;

use crate::xml_text::{ModelText, append, escape_attribute, xml_head};
use bodies::Bodies;
pub use error::SdfError;
use joints::Axes;
use percuss_mechanism::Mechanism;

/// Writes SDFormat 1.7, or 1.11 if a joint follows another: links with inertias, joints with limits, and the joints that close loops.
/// `heading`: comment at the head of the file, none if empty. Lengths in m, angles in rad; numbers are the shortest decimals that read
/// back as the same bits, and rotations are converted to roll, pitch and yaw, which are accurate to a few roundings.
///
/// | mechanism | SDFormat |
/// |---|---|
/// | root link | a link fixed to the world; the world itself if its name is `world` |
/// | massless link that is fixed to its parent | a frame |
/// | massless link within a chain of joints | none: the pose of a joint, or a universal, revolute2 or screw joint |
/// | floating joint | none: a link without a joint floats |
/// | mimic, coupling of two joints | mimic |
/// | fixed, revolute, prismatic, spherical, universal closure | a joint, placed as drawn |
/// | armature of a joint with one degree of freedom | `drake:rotor_inertia`, which only Drake reads |
///
/// # Errors
/// [`SdfError`] for planar joints, cylindrical, planar and distance closures, closures that are open as drawn, couplings of more than two
/// joints, armatures of other joints, and names that SDFormat reserves.
pub fn write_sdf(mechanism: &Mechanism, heading: &str) -> Result<ModelText, SdfError> {
    let mut bodies = Bodies::new(mechanism)?;
    let axes = Axes::new(mechanism, &mut bodies)?;
    let joints = axes.write_joints(mechanism, &mut bodies)?;
    let closures = closures::write_closures(mechanism, &mut bodies)?;
    let mut out = xml_head(heading, mechanism, "SDFormat");
    let version = if axes.has_mimics() { "1.11" } else { "1.7" };
    let drake = if axes.has_rotors() { " xmlns:drake=\"http://drake.mit.edu\"" } else { "" };
    append(&mut out, format_args!("<sdf version=\"{version}\"{drake}>\n"));
    append(
        &mut out,
        format_args!("  <model name=\"{}\">\n", escape_attribute(&bodies::model_name(mechanism))),
    );
    bodies.append_links(mechanism, &mut out);
    out.push_str(&joints);
    out.push_str(&closures);
    out.push_str("  </model>\n</sdf>\n");
    if axes.has_rotors() {
        bodies.notes.push("armatures are written as drake:rotor_inertia, which only Drake reads".to_owned());
    }
    let lost = mechanism.contacts().iter();
    let lost = lost.map(|contact| format!("contact \"{}\": SDFormat has no named contacts", contact.name()));
    Ok(ModelText { text: out, notes: bodies.notes.into_iter().chain(lost).collect() })
}
