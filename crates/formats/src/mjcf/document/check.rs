//! Comparison of a model with the grammar.

use crate::reading::document::element_tree::ElementId;
use crate::reading::document::grammar::{ElementRule, Treatment, listed_tags, tags};
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::shortened;
use percuss_mechanism::Severity;

/// Applies the treatments to an element, its attributes and its descendants.
pub(crate) fn check_element(id: ElementId, rule: &'static ElementRule, findings: &mut Findings<'_>) {
    let tree = findings.tree;
    let tag = tree.tag(id);
    match rule.treatment.finding("") {
        Some((Severity::Error, code, reason)) => findings.error(code, id, || format!("<{tag}>: {reason}")),
        Some((severity, code, reason)) => findings.add_once(severity, code, tag, id, || reason.to_owned()),
        None if matches!(rule.treatment, Treatment::Silent) => findings.add_unread(id, || format!("<{tag}>")),
        None => {
            check_attributes(id, rule, findings);
            let Some(rules) = rule.children else { return };
            for &child in tree.children(id) {
                let tag = tree.tag(child);
                match tags(rules).find(|(known, _)| *known == tag) {
                    Some((_, rule)) => check_element(child, rule, findings),
                    None => findings.error("unknown-element", child, || {
                        let guess = similar_name(tag, listed_tags(rules));
                        format!("<{}> is unknown in <{}>{guess}", shortened(tag), shortened(tree.tag(id)))
                    }),
                }
            }
        }
    }
}

/// Reports attributes that are ignored, unsupported or unknown.
fn check_attributes(id: ElementId, rule: &'static ElementRule, findings: &mut Findings<'_>) {
    let tag = findings.tree.tag(id);
    for attribute in &findings.tree.element(id).attributes {
        let name = attribute.name.as_str();
        let treatment = rule.attribute(name);
        match treatment.and_then(|treatment| treatment.finding(&attribute.value)) {
            Some((Severity::Error, code, reason)) => {
                findings.attribute_error(code, id, name, || format!("{name}: {reason}"));
            }
            Some((severity, code, reason)) => {
                findings.add_once(severity, code, name, id, || reason.to_owned());
            }
            None if treatment.is_none() && !rule.open => {
                findings.attribute_error("unknown-attribute", id, name, || {
                    let guess = similar_name(name, rule.attribute_names());
                    format!("<{tag}> has no attribute \"{}\"{guess}", shortened(name))
                });
            }
            None if matches!(treatment, None | Some(Treatment::Silent)) => {
                findings.add_unread(id, || format!("{} of <{tag}>", shortened(name)));
            }
            None => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mjcf::document::grammar::{IN_BODY, ROOT};

    /// Rule of an element by its path below the root; `None` if it is unknown, and `Some(None)` below an element whose children are not
    /// examined.
    fn rule_of(path: &str) -> Option<Option<&'static ElementRule>> {
        let mut rule: &'static ElementRule = &ROOT;
        for step in path.split('/').skip(1) {
            let tag = if step == "(world)body" { "body" } else { step };
            let children = if step == "(world)body" { Some(&IN_BODY[..]) } else { rule.children };
            let Some(rules) = children else { return Some(None) };
            rule = tags(rules).find(|(known, _)| *known == tag)?.1;
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
                let known = rule.and_then(|rule| rule.attribute(name));
                match (rule, known) {
                    (_, Some(Treatment::Read)) => read += 1,
                    (_, Some(Treatment::Silent)) => silent += 1,
                    (_, Some(_)) => refused += 1,
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
