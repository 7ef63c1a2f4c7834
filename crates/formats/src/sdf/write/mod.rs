//! Writer of mechanisms as SDFormat.

mod bodies;
mod closures;
mod error;
mod joints;
mod shapes;

use crate::writing::changes::{Change, ModelText, common_changes, lost_poses, lost_roles};
use crate::writing::parts::ModelParts;
use crate::writing::xml_text::{append, escape_attribute, xml_head};
use bodies::Bodies;
pub use error::SdfError;
use joints::Axes;
use percuss_mechanism::Joint;

/// Writes SDFormat: links with inertias, joints with limits, and the joints that close loops. The version is 1.7; 1.8 if a shape is a
/// capsule; 1.11 if a joint follows another. `heading`: comment at the head of the file, none if empty. Lengths in m, angles in rad; numbers are the shortest decimals that read
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
/// | shapes | visuals and collisions; shapes of a link that becomes a frame are written in the link to which the frame is attached |
/// | armature of a joint with one degree of freedom | `drake:rotor_inertia`, which only Drake reads |
///
/// # Errors
/// [`SdfError`] for planar joints, cylindrical, planar and distance closures, closures that are open as drawn, couplings of more than two
/// joints, armatures of other joints, and names that SDFormat reserves.
pub fn write_sdf<'a>(model: impl Into<ModelParts<'a>>, heading: &str) -> Result<ModelText, SdfError> {
    let parts = model.into();
    let mechanism = parts.mechanism;
    let mut bodies = Bodies::new(mechanism)?;
    let axes = Axes::new(&mut bodies)?;
    let joints = axes.write_joints(&mut bodies)?;
    let closures = closures::write_closures(&mut bodies)?;
    let mut out = xml_head(heading);
    let shapes = shapes::write_shapes(&parts, &mut bodies);
    let version = match (axes.has_mimics(), shapes.has_capsules) {
        (true, _) => "1.11",
        (false, true) => "1.8",
        (false, false) => "1.7",
    };
    let drake = if axes.has_rotors { " xmlns:drake=\"http://drake.mit.edu\"" } else { "" };
    append!(out, "<sdf version=\"{version}\"{drake}>\n");
    append!(out, "  <model name=\"{}\">\n", escape_attribute(&bodies::model_name(mechanism)));
    bodies.append_links(&shapes.lines, &mut out);
    out.push_str(&joints);
    out.push_str(&closures);
    out.push_str("  </model>\n</sdf>\n");
    if axes.has_rotors {
        let with_armature = |joint: &&Joint| joint.armature().iter().any(|armature| *armature != 0.0);
        bodies.changes.extend(mechanism.joints().iter().filter(with_armature).map(|joint| {
            let what = "its armature is a drake:rotor_inertia";
            Change::changed(
                "joint",
                joint.name(),
                what,
                "SDFormat has no armature; only Drake reads this element",
            )
        }));
    }
    let mut changes = bodies.changes;
    let model_name = bodies::model_name(mechanism);
    if !mechanism.name().is_empty() && model_name != mechanism.name() {
        changes.push(bodies::changed_name("model", mechanism.name(), &model_name));
    }
    changes.extend(mechanism.contacts().iter().map(|contact| {
        Change::lost("contact", contact.name(), "the contact", "SDFormat has no named contacts")
    }));
    changes.extend(lost_roles(mechanism, "SDFormat"));
    changes.extend(lost_poses(&parts, "SDFormat"));
    changes.extend(common_changes(mechanism, |_| false, false));
    Ok(ModelText { text: out, changes })
}
