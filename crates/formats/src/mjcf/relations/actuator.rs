//! Armatures of actuators and tendons, reflected to the joints.

use crate::mjcf::bodies::body::Bodies;
use crate::mjcf::relations::references::{JointKey, References};
use crate::mjcf::relations::tendon::{Tendon, TendonPath};
use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::classes::{Classes, DefaultKind};
use crate::reading::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::report::quoted;
use std::collections::HashMap;

/// Armature added to a joint, kg·m² or kg.
pub(crate) type AddedArmature = (JointKey, f64);

/// Armatures of all actuators and tendons. An actuator adds gear² · armature to all velocities of its joint; a tendon with one joint
/// adds coefficient² · armature.
pub(crate) fn reflected_armatures(
    tree: &ElementTree,
    classes: &Classes,
    bodies: &Bodies,
    tendons: &HashMap<String, Tendon>,
    findings: &mut Findings<'_>,
) -> Vec<AddedArmature> {
    let references = References { bodies };
    let mut added = Vec::new();
    for tendon in tendons.values().filter(|tendon| tendon.armature != 0.0) {
        added.extend(tendon_armature(tendon, tendon.armature, tendon.element, findings));
    }
    for element in tree.in_sections("actuator") {
        let actuator = Attributes::with_class(tree, element, DefaultKind::Actuator, classes, None, findings);
        let armature = actuator.number("armature", findings).unwrap_or(0.0);
        if armature == 0.0 {
            continue;
        }
        let gear = match actuator.text("gear") {
            Some(_) => actuator.list("gear", 6, findings).and_then(|gear| gear.first().copied()),
            None => Some(1.0),
        };
        let Some(gear) = gear else { continue };
        let reflected = gear * gear * armature;
        let joint =
            ["joint", "jointinparent"].into_iter().find_map(|name| Some((name, actuator.text(name)?)));
        if let Some((attribute, name)) = joint {
            let joint = references.joint(name, element, attribute, findings);
            added.extend(joint.map(|joint| (joint, reflected)));
        } else if let Some(name) = actuator.text("tendon") {
            match tendons.get(name) {
                Some(tendon) => added.extend(tendon_armature(tendon, reflected, element, findings)),
                None => findings.attribute_error("unknown-reference", element, "tendon", || {
                    format!("the tendon {} does not exist", quoted(name))
                }),
            }
        } else {
            findings.attribute_error("unsupported", element, "armature", || {
                "the armature of an actuator without a joint or tendon is not read, and the answer without it would be wrong".to_owned()
            });
        }
    }
    added
}

/// Armature of a tendon with one joint; an error for another tendon.
fn tendon_armature(
    tendon: &Tendon,
    armature: f64,
    element: ElementId,
    findings: &mut Findings<'_>,
) -> Option<AddedArmature> {
    if let TendonPath::Fixed(terms) = &tendon.path
        && let [(joint, coefficient)] = terms[..]
    {
        return Some((joint, coefficient * coefficient * armature));
    }
    findings.error("unsupported", element, || {
        "the armature of a tendon over several joints or sites is not read, and the answer without it would be wrong; tendons of one \
         joint are read"
            .to_owned()
    });
    None
}
