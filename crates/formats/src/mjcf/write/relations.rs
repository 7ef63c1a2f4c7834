//! Mimics and couplings as equality constraints of joints.

use super::body_tree::BodyTree;
use super::rotors::{Rotor, armature, tendon_name, tendon_terms};
use crate::writing::changes::Change;
use crate::writing::xml_text::{append, escape_attribute, format_number, format_numbers};
use percuss_mechanism::JointId;

/// Writes all mimics and couplings.
pub(super) fn write_relations(tree: &mut BodyTree<'_>) {
    let mechanism = tree.mechanism;
    let name = |id| escape_attribute(mechanism.joint(id).name());
    for joint in mechanism.joints() {
        let Some(mimic) = joint.mimic() else { continue };
        if tree.rotors[joint.child().index()] == Some(Rotor::Follower) {
            continue;
        }
        append!(
            tree.equalities,
            "    <joint joint1=\"{}\" joint2=\"{}\" polycoef=\"{} 0 0 0\"/>\n",
            escape_attribute(joint.name()),
            name(mimic.master),
            format_numbers(&[mimic.offset, mimic.multiplier])
        );
    }
    write_rotors(tree);
    for (number, coupling) in mechanism.couplings().iter().enumerate() {
        if tree.rotors.contains(&Some(Rotor::Tendon(number))) {
            continue;
        }
        let own = escape_attribute(coupling.name());
        let constant = coupling.constant();
        let form = match (coupling.terms(), coupling.curve()) {
            ([(first, _), (second, _)], None) => format!(
                "an equality of the joints \"{}\" and \"{}\"",
                mechanism.joint(*first).name(),
                mechanism.joint(*second).name()
            ),
            _ => "an equality of fixed tendons".to_owned(),
        };
        let reason = "MJCF writes all relations of joints as equalities";
        tree.changes.push(Change::changed("coupling", coupling.name(), form, reason));
        if let ([(first, a), (second, b)], None) = (coupling.terms(), coupling.curve()) {
            append!(
                tree.equalities,
                "    <joint name=\"{own}\" joint1=\"{}\" joint2=\"{}\" polycoef=\"{} 0 0 0\"/>\n",
                name(*first),
                name(*second),
                format_numbers(&[constant / a, -b / a])
            );
            continue;
        }
        write_tendon(tree, &own, "", coupling.terms());
        let Some(curve) = coupling.curve() else {
            append!(
                tree.equalities,
                "    <tendon name=\"{own}\" tendon1=\"{own}\" polycoef=\"{} 0 0 0 0\"/>\n",
                format_number(constant)
            );
            continue;
        };
        let argument = format!("{own}/argument");
        write_tendon(tree, &argument, "", curve.terms());
        let shifted = shifted_coefficients(curve.offset(), curve.coefficients());
        let coefficients = [constant + shifted[0], shifted[1], shifted[2], shifted[3], shifted[4]];
        append!(
            tree.equalities,
            "    <tendon name=\"{own}\" tendon1=\"{own}\" tendon2=\"{argument}\" polycoef=\"{}\"/>\n",
            format_numbers(&coefficients)
        );
    }
}

/// Writes the tendons whose armatures are rotors.
fn write_rotors(tree: &mut BodyTree<'_>) {
    let mechanism = tree.mechanism;
    for link in mechanism.link_ids() {
        let (Some(rotor), Some(joint)) = (tree.rotors[link.index()], mechanism.parent_joint(link)) else {
            continue;
        };
        let own = mechanism.joint(joint);
        let (name, terms): (&str, Vec<(JointId, f64)>) = match (rotor, own.mimic()) {
            (Rotor::Tendon(number), _) => {
                let coupling = &mechanism.couplings()[number];
                (tendon_name(coupling), tendon_terms(coupling, joint).collect())
            }
            (Rotor::Follower, Some(mimic)) => (own.name(), vec![(mimic.master, mimic.multiplier)]),
            (Rotor::Follower | Rotor::Body, _) => continue,
        };
        let armature = format!(" armature=\"{}\"", format_number(armature(own)));
        write_tendon(tree, &escape_attribute(name), &armature, &terms);
    }
}

/// Writes a fixed tendon with the length Σ factor · q.
fn write_tendon(tree: &mut BodyTree<'_>, name: &str, attributes: &str, terms: &[(JointId, f64)]) {
    append!(tree.tendons, "    <fixed name=\"{name}\"{attributes}>\n");
    for (joint, factor) in terms.iter().filter(|(_, factor)| *factor != 0.0) {
        let (joint, factor) = (escape_attribute(tree.mechanism.joint(*joint).name()), format_number(*factor));
        append!(tree.tendons, "      <joint joint=\"{joint}\" coef=\"{factor}\"/>\n");
    }
    tree.tendons.push_str("    </fixed>\n");
}

/// Coefficients b₀ … b₄ of a₂ s² + a₃ s³ + a₄ s⁴ as a polynomial in x, with s = offset + x.
fn shifted_coefficients(offset: f64, [a2, a3, a4]: [f64; 3]) -> [f64; 5] {
    let o = offset;
    [
        o * o * (a2 + o * (a3 + o * a4)),
        o * (2.0 * a2 + o * (3.0 * a3 + o * 4.0 * a4)),
        a2 + o * (3.0 * a3 + o * 6.0 * a4),
        a3 + o * 4.0 * a4,
        a4,
    ]
}
