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
        Treatment::Silent => {
            findings.add_unread(id, || format!("<{}>", rule.tag));
            return;
        }
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

/// Reports attributes that are ignored, unsupported or unknown.
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
            Some(Treatment::Read) => {}
            Some(Treatment::Silent) => findings.add_unread(id, || format!("{name} of <{}>", rule.tag)),
            Some(Treatment::Warned(reason)) => {
                findings.add_once(Severity::Warning, "ignored", name, id, || reason.to_owned());
            }
            Some(Treatment::Refused(reason)) => {
                findings.attribute_error("unsupported", id, name, || format!("{name}: {reason}"));
            }
            None if rule.open => findings.add_unread(id, || format!("{} of <{}>", shortened(name), rule.tag)),
            None => findings.attribute_error("unknown-attribute", id, name, || {
                let guess = similar_name(name, rule.attributes.iter().map(|(known, _)| *known));
                format!("<{}> has no attribute \"{}\"{guess}", rule.tag, shortened(name))
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mjcf::document::grammar::Content;

    /// Rule of an element by its path below the root; `None` if it is unknown, and `Some(None)` below an element whose children are not
    /// examined.
    fn rule_of(path: &str) -> Option<Option<&'static ElementRule>> {
        let mut rule: &'static ElementRule = &ROOT;
        for step in path.split('/').skip(1) {
            let tag = if step == "(world)body" { "body" } else { step };
            let content = if step == "(world)body" { Content::Body } else { rule.content };
            let Some(rules) = content.rules() else { return Some(None) };
            rule = rules.iter().find(|rule| rule.tag == tag)?;
        }
        Some(Some(rule))
    }

    #[test]
    fn every_attribute_of_mujoco_has_a_treatment() {
        let schema = include_str!("../../../tests/mjcf/schema.txt");
        let mut missing = Vec::new();
        let (mut read, mut silent, mut refused, mut open) = (0, 0, 0, 0);
        for line in schema.lines().filter(|line| !line.starts_with('#')) {
            let (path, attributes) = line.split_once(':').expect("a path and its attributes");
            let Some(rule) = rule_of(path) else {
                missing.push(path.to_owned());
                continue;
            };
            for name in attributes.split_whitespace() {
                let known = rule.and_then(|rule| rule.attributes.iter().find(|(known, _)| *known == name));
                match (rule, known) {
                    (_, Some((_, Treatment::Read))) => read += 1,
                    (_, Some((_, Treatment::Silent))) => silent += 1,
                    (_, Some((_, Treatment::Warned(_) | Treatment::Refused(_)))) => refused += 1,
                    (None, None) => open += 1,
                    (Some(rule), None) if rule.open => open += 1,
                    (Some(_), None) => missing.push(format!("{path}: {name}")),
                }
            }
        }
        assert_eq!(missing, Vec::<String>::new());
        // Every attribute that changes the mechanism is in the table; those of an open element have no effect.
        assert!(
            read > 150 && silent > 80 && open > 500,
            "{read} read, {silent} silent, {refused} refused, {open} open"
        );
    }
}
