//! Comparison of a model with the grammar.

use crate::mjcf::document::grammar::{ElementRule, ROOT, Treatment};
use crate::reading::element_tree::{ElementId, ElementTree};
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::shortened;
use percuss_mechanism::Severity;

/// Applies the treatments of the grammar to all elements of a model.
pub(crate) fn check_grammar(tree: &ElementTree, root: ElementId, findings: &mut Findings<'_>) {
    check_element(tree, root, &ROOT, findings);
}

/// Applies the treatments to an element, its attributes and its descendants.
fn check_element(tree: &ElementTree, id: ElementId, rule: &'static ElementRule, findings: &mut Findings<'_>) {
    match rule.treatment {
        Treatment::Read => {}
        Treatment::Silent => return,
        Treatment::Warned(reason) => {
            findings.add_once(Severity::Warning, "ignored", rule.tag, id, || reason.to_owned());
            return;
        }
        Treatment::Refused(reason) => {
            findings.error("unsupported", id, || format!("<{}>: {reason}", rule.tag));
            return;
        }
    }
    check_attributes(tree, id, rule, findings);
    let Some(rules) = rule.content.rules() else { return };
    for &child in tree.children(id) {
        let tag = tree.tag(child);
        match rules.iter().find(|rule| rule.tag == tag) {
            Some(rule) => check_element(tree, child, rule, findings),
            None => findings.error("unknown-element", child, || {
                let guess = similar_name(tag, rules.iter().map(|rule| rule.tag));
                format!("<{}> is unknown in <{}>{guess}", shortened(tag), shortened(tree.tag(id)))
            }),
        }
    }
}

fn check_attributes(
    tree: &ElementTree,
    id: ElementId,
    rule: &'static ElementRule,
    findings: &mut Findings<'_>,
) {
    for attribute in &tree.element(id).attributes {
        let name = attribute.name.as_str();
        let treatment = rule.attributes.iter().find(|(known, _)| *known == name).map(|(_, t)| *t);
        match treatment {
            Some(Treatment::Read | Treatment::Silent) => {}
            Some(Treatment::Warned(reason)) => {
                findings.add_once(Severity::Warning, "ignored", name, id, || reason.to_owned());
            }
            Some(Treatment::Refused(reason)) => {
                findings.attribute_error("unsupported", id, name, || format!("{name}: {reason}"));
            }
            None if rule.open => {}
            None => findings.attribute_error("unknown-attribute", id, name, || {
                let guess = similar_name(name, rule.attributes.iter().map(|(known, _)| *known));
                format!("<{}> has no attribute \"{}\"{guess}", rule.tag, shortened(name))
            }),
        }
    }
}
