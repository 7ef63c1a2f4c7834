//! Armatures of actuators and tendons, reflected to the joints.

use crate::mjcf::bodies::body::Bodies;
use crate::mjcf::relations::equality::REPLICATED_TENDON;
use crate::mjcf::relations::references::JointKey;
use crate::mjcf::relations::tendon::{Tendon, TendonPath};
use crate::mjcf::values::classes::DefaultKind;
use crate::mjcf::values::models::Models;
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::Findings;
use crate::reading::report::quoted;
use std::collections::HashMap;

/// Armature added to a joint, kg·m² or kg.
pub(crate) type AddedArmature = (JointKey, f64);

/// Armatures of the joints and of tendons over several joints.
#[derive(Debug, Default)]
pub(crate) struct Armatures {
    pub joints: Vec<AddedArmature>,
    pub rotors: Vec<TendonRotor>,
}

/// Rotor that turns with the length of a fixed tendon: its inertia adds a · JᵀJ to M, with the coefficients J of the joints.
#[derive(Clone, Debug)]
pub(crate) struct TendonRotor {
    pub element: ElementId,
    /// Name of the tendon; empty if absent.
    pub name: String,
    /// Sum of the armatures of the tendon and of its actuators, kg or kg·m².
    pub armature: f64,
    pub terms: Vec<(JointKey, f64)>,
}

impl Armatures {
    /// Adds the armature of a tendon: coefficient² · armature for one joint, else a rotor. An error for a spatial tendon.
    fn add_tendon(
        &mut self,
        tendon: &Tendon,
        armature: f64,
        element: ElementId,
        findings: &mut Findings<'_>,
    ) {
        if matches!(tendon.path, TendonPath::Replicated) {
            findings.error("unsupported", element, || REPLICATED_TENDON.to_owned());
            return;
        }
        let TendonPath::Fixed(terms) = &tendon.path else {
            findings.error("unsupported", element, || {
                "the armature of a spatial tendon is not read, and the answer without it would be wrong; fixed tendons are read"
                    .to_owned()
            });
            return;
        };
        if let [(joint, coefficient)] = terms[..] {
            self.joints.push((joint, coefficient * coefficient * armature));
            return;
        }
        match self.rotors.iter_mut().find(|rotor| rotor.element == tendon.element) {
            Some(rotor) => rotor.armature += armature,
            None => self.rotors.push(TendonRotor {
                element: tendon.element,
                name: tendon.name.clone(),
                armature,
                terms: terms.clone(),
            }),
        }
    }

    /// Warns about a rotor over joints of different branches, which MuJoCo treats in another way.
    fn warn_of_branches(&self, bodies: &Bodies, findings: &mut Findings<'_>) {
        for rotor in &self.rotors {
            let mut of_terms: Vec<usize> = rotor.terms.iter().map(|((body, _), _)| *body).collect();
            // Bodies are numbered depth first, so that ancestors come first.
            of_terms.sort_unstable();
            let is_chain = of_terms.windows(2).all(|pair| bodies.is_ancestor(pair[0], pair[1]));
            if !is_chain {
                findings.warning("tendon-armature", rotor.element, || {
                    "the armature of this tendon couples joints of different branches; MuJoCo leaves these entries of the mass \
                     matrix out, the result here has them"
                        .to_owned()
                });
            }
        }
    }
}

/// Armatures of all actuators and tendons. An actuator adds gear² · armature to all velocities of its joint, or to its tendon.
pub(crate) fn reflected_armatures(
    models: &Models<'_>,
    bodies: &Bodies,
    tendons: &HashMap<String, Tendon>,
    findings: &mut Findings<'_>,
) -> Armatures {
    let tree = findings.tree;
    let mut added = Armatures::default();
    let mut with_armature: Vec<&Tendon> = tendons.values().filter(|tendon| tendon.armature != 0.0).collect();
    with_armature.sort_by_key(|tendon| tendon.element.0);
    for tendon in with_armature {
        added.add_tendon(tendon, tendon.armature, tendon.element, findings);
    }
    for element in tree.in_sections("actuator") {
        let actuator = models.attributes(element, DefaultKind::Actuator, None, findings);
        findings.add_unread(element, || format!("actuator <{}>, except its armature", tree.tag(element)));
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
            let joint = bodies.joint_named(name, (element, attribute), findings);
            added.joints.extend(joint.map(|joint| (joint, reflected)));
        } else if let Some(name) = actuator.text("tendon") {
            match tendons.get(name) {
                Some(tendon) => added.add_tendon(tendon, reflected, element, findings),
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
    added.warn_of_branches(bodies, findings);
    added
}
