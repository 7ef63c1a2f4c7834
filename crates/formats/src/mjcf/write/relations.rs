//! Mimics and couplings as equality constraints of joints.

use super::closures::Sections;
use crate::xml_text::{append, escape_attribute, format_number};
use percuss_mechanism::Mechanism;

/// Writes all mimics and couplings.
pub(super) fn write_relations(mechanism: &Mechanism) -> Sections {
    let mut sections = Sections::default();
    let name = |id| escape_attribute(mechanism.joint(id).name());
    for joint in mechanism.joints() {
        let Some(mimic) = joint.mimic() else { continue };
        append(
            &mut sections.equalities,
            format_args!(
                "    <joint joint1=\"{}\" joint2=\"{}\" polycoef=\"{} {} 0 0 0\"/>\n",
                escape_attribute(joint.name()),
                name(mimic.master),
                format_number(mimic.offset),
                format_number(mimic.multiplier)
            ),
        );
    }
    for coupling in mechanism.couplings() {
        let own = escape_attribute(coupling.name());
        if let [(first, a), (second, b)] = coupling.terms() {
            append(
                &mut sections.equalities,
                format_args!(
                    "    <joint name=\"{own}\" joint1=\"{}\" joint2=\"{}\" polycoef=\"0 {} 0 0 0\"/>\n",
                    name(*first),
                    name(*second),
                    format_number(-b / a)
                ),
            );
            continue;
        }
        append(&mut sections.tendons, format_args!("    <fixed name=\"{own}\">\n"));
        for (joint, factor) in coupling.terms() {
            append(
                &mut sections.tendons,
                format_args!(
                    "      <joint joint=\"{}\" coef=\"{}\"/>\n",
                    name(*joint),
                    format_number(*factor)
                ),
            );
        }
        sections.tendons.push_str("    </fixed>\n");
        append(&mut sections.equalities, format_args!("    <tendon name=\"{own}\" tendon1=\"{own}\"/>\n"));
    }
    sections
}
