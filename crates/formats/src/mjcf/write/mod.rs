//! Writer of mechanisms as MJCF.

mod body_tree;
pub(crate) mod closures;
mod contacts;
mod error;
mod forms;
mod impact;
mod keyframe;
mod moments;
mod relations;
mod rotors;
mod shapes;

use crate::writing::changes::{ModelText, common_changes, lost_roles};
use crate::writing::parts::ModelParts;
use crate::writing::xml_text::{append, escape_attribute, xml_head};
use body_tree::BodyTree;
pub use error::MjcfError;
use forms::form_changes;
pub use impact::{ImpactContact, ImpactSurfaces, MjcfImpact};
use keyframe::Keyframe;
pub use moments::balance_inertia;

/// Writes MJCF for MuJoCo 3.2.3 and later, 3.3 and later with meshes: bodies with inertias, joints with limits and armatures, and all loops as equality
/// constraints. `heading`: comment at the head of the file, none if empty. Lengths in m, angles in rad; numbers are the shortest decimals
/// that read back as the same bits.
///
/// | mechanism | MJCF |
/// |---|---|
/// | root link | a body fixed to the world; the world itself if its name is `world` |
/// | massless link with one child | none: its joint belongs to the body of the child |
/// | planar joint; floating joint not on the root | slides and a hinge; slides and a ball joint |
/// | mimic, coupling | equality of two joints, or of a fixed tendon |
/// | fixed, spherical, distance closure | weld, connect, equality of a straight tendon |
/// | revolute closure | two connects on the axis |
/// | prismatic, cylindrical, planar, universal closure | joints to a second half of a link, which is welded to the first half |
/// | massless link at the end, joint with an armature and a relation (a rotor) | armature of a fixed tendon; over several branches a body with this mass (slide on the root) |
/// | shapes | geoms of the classes `visual` and `collision`, which add no mass; contact between joined bodies is excluded |
/// | named poses | keyframes |
///
/// Each half has half of the mass and inertia, so that the mechanism is the same. Moments of 0 (thin rods, point masses) become 1e-13 of
/// m·(size of the mechanism)², which is reported as a change: MuJoCo refuses 0. An excess C − A − B of the moments up to 1e-10 of C is removed; a larger one by
/// [`balance_inertia`].
///
/// # Errors
/// [`MjcfError`] for a massless link that moves and has none of these forms, for a moving body with moments A + B < C (MuJoCo
/// refuses both), for armatures that differ within a ball or free joint, and for names that MuJoCo reserves.
pub fn write_mjcf<'a>(model: impl Into<ModelParts<'a>>, heading: &str) -> Result<ModelText, MjcfError> {
    write_file(&model.into(), None, heading)
}

/// Writes MJCF of a mechanism and of an impact at one contact: the file of [`write_mjcf`], two geoms with a contact pair, and the
/// keyframe `impact` with the pose and the velocity at the touch. As the effective mass assumes, gravity is 0, joints have no springs, and joint limits and all other
/// contacts are disabled. The `<numeric>` `restitution` contains the expected restitution.
///
/// # Errors
/// As for [`write_mjcf`]; a contact at a link without a body in the file.
pub fn write_mjcf_impact<'a>(
    model: impl Into<ModelParts<'a>>,
    impact: &MjcfImpact,
    heading: &str,
) -> Result<ModelText, MjcfError> {
    write_file(&model.into(), Some(impact), heading)
}

/// Writes a file, with an impact or without.
fn write_file(
    parts: &ModelParts<'_>,
    impact: Option<&MjcfImpact>,
    heading: &str,
) -> Result<ModelText, MjcfError> {
    let mechanism = parts.mechanism;
    let mut tree = BodyTree::new(mechanism)?;
    let forms = form_changes(&tree);
    tree.changes.extend(forms);
    closures::write_closures(&mut tree)?;
    relations::write_relations(&mut tree);
    contacts::add_contacts(&mut tree);
    let shapes = shapes::add_shapes(parts, &mut tree, impact.is_none());
    impact.map_or(Ok(()), |impact| impact.add_contact(&mut tree))?;
    tree.has_springs = impact.is_none();
    let mut out = xml_head(heading);
    append!(out, "<mujoco model=\"{}\">\n", escape_attribute(mechanism.name()));
    out.push_str(
        "  <compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" boundinertia=\"0\"/>\n",
    );
    out.push_str(&impact.map_or_else(String::new, MjcfImpact::head));
    out.push_str(shapes.classes);
    append_section(&mut out, "asset", &shapes.assets);
    out.push_str("  <worldbody>\n");
    let coordinates = tree.append_bodies(&mut out)?;
    out.push_str("  </worldbody>\n");
    append_section(&mut out, "contact", &shapes.excludes);
    append_section(&mut out, "tendon", &tree.tendons);
    append_section(&mut out, "equality", &tree.equalities);
    let key = |state| Keyframe::new(&tree, &coordinates, state);
    let mut keys = String::new();
    for (name, state) in parts.poses {
        append!(keys, "    {}\n", key(state)?.element(&escape_attribute(name)));
    }
    if let Some(impact) = impact {
        out.push_str(&impact.pair());
        append!(keys, "    {}\n", key(&impact.state)?.element(impact::NAME));
    }
    append_section(&mut out, "keyframe", &keys);
    out.push_str("</mujoco>\n");
    let mut changes = tree.changes;
    changes.extend(lost_roles(mechanism, "MJCF"));
    changes.extend(common_changes(mechanism, |_| false, false));
    Ok(ModelText { text: out, changes })
}

/// Appends a section of the file; nothing if `lines` is empty.
fn append_section(out: &mut String, section: &str, lines: &str) {
    if !lines.is_empty() {
        append!(out, "  <{section}>\n{lines}  </{section}>\n");
    }
}
