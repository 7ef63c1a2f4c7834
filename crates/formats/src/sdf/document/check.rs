//! Comparison of a model with the table of elements.

use crate::reading::element_tree::{ElementId, ElementTree};
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::shortened;
use crate::sdf::document::grammar::{ElementRule, Treatment};
use percuss_mechanism::Severity;

/// Applies the treatments to the children of an element. The recursion is bounded by the depth of the table.
pub(crate) fn check_children(
    tree: &ElementTree,
    parent: ElementId,
    rules: &'static [ElementRule],
    findings: &mut Findings<'_>,
) {
    let mut seen = 0u64;
    for &child in tree.children(parent) {
        let tag = tree.tag(child);
        let Some(index) = rules.iter().position(|rule| rule.tag == tag) else {
            warn_unknown(tree, child, rules, findings);
            continue;
        };
        let rule = &rules[index];
        if rule.single && seen & (1 << index) != 0 {
            // Visual shapes have no effect on the masses.
            let (severity, which) = if tree.tag(parent) == "visual" {
                (Severity::Warning, "the first one is used, as in libsdformat")
            } else {
                (Severity::Error, "which of them counts is not defined")
            };
            findings.add(severity, "duplicate-element", child, || {
                format!("a second <{tag}>; only one is allowed, and {which}: delete one of them")
            });
        }
        seen |= 1 << index;
        match rule.treatment {
            Treatment::Read => {}
            Treatment::Silent => {
                findings.add_unread(child, || format!("<{tag}> in <{}>", tree.tag(parent)));
                continue;
            }
            Treatment::Warned(reason) => {
                findings.add_once(Severity::Warning, "ignored", rule.tag, child, || reason.to_owned());
                continue;
            }
            Treatment::Refused(reason) => {
                findings.error("unsupported", child, || reason.to_owned());
                continue;
            }
        }
        if let Some(children) = rule.children {
            check_attributes(tree, child, rule, findings);
            check_children(tree, child, children, findings);
        }
    }
}

/// Warns about an unknown element, as libsdformat does. Elements with a prefix are extensions of other programs.
fn warn_unknown(
    tree: &ElementTree,
    element: ElementId,
    rules: &'static [ElementRule],
    findings: &mut Findings<'_>,
) {
    let tag = tree.tag(element);
    if tag == "experimental:params" {
        findings.error("unsupported", element, || {
            "changes of an included model (experimental:params) are not read, and the answer without them would be wrong; write them \
             into the model"
                .to_owned()
        });
    } else if tag.contains(':') {
        findings.add_unread(element, || format!("<{}>", shortened(tag)));
    } else {
        findings.add_once(Severity::Warning, "unknown-element", tag, element, || {
            let guess = similar_name(tag, rules.iter().map(|rule| rule.tag));
            format!("unknown element <{}> is ignored{guess}", shortened(tag))
        });
    }
}

/// Warns about unknown attributes.
fn check_attributes(
    tree: &ElementTree,
    element: ElementId,
    rule: &'static ElementRule,
    findings: &mut Findings<'_>,
) {
    for attribute in &tree.element(element).attributes {
        let name = attribute.name.as_str();
        if !rule.attributes.contains(&name) {
            let kind = format!("{} {name}", rule.tag);
            findings.add_once(Severity::Warning, "unknown-attribute", &kind, element, || {
                let guess = similar_name(name, rule.attributes.iter().copied());
                format!("<{}>: unknown attribute \"{}\" is ignored{guess}", rule.tag, shortened(name))
            });
        }
    }
}
