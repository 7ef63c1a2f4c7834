//! Comparison of a model with the table of elements.

use crate::reading::document::element_tree::ElementId;
use crate::reading::document::grammar::{ElementRule, Treatment, listed_tags, tags};
use crate::reading::findings::{Findings, similar_name};
use crate::reading::plugins::{changes_joint, keyed_value, unread_joint_message};
use crate::reading::report::{quoted, shortened};
use percuss_mechanism::Severity;

/// Applies the treatments to the children of an element. The recursion is bounded by the depth of the table.
pub(crate) fn check_children(parent: ElementId, rules: &'static [ElementRule], findings: &mut Findings<'_>) {
    let tree = findings.tree;
    let mut seen = Vec::new();
    for &child in tree.children(parent) {
        let tag = tree.tag(child);
        let Some((_, rule)) = tags(rules).find(|(known, _)| *known == tag) else {
            warn_unknown(child, rules, findings);
            continue;
        };
        if rule.single && seen.contains(&tag) {
            // Visual shapes have no effect on the masses.
            let (severity, which) = if tree.tag(parent) == "visual" {
                (Severity::Warning, "the first one is used, as in libsdformat")
            } else {
                (Severity::Error, "which of them counts is not defined")
            };
            findings.add(severity, "duplicate-element", child, || {
                format!("a second <{tag}>; only one is allowed, and {which}: delete one of them")
            });
        } else if rule.single {
            seen.push(tag);
        }
        match (rule.treatment.finding(""), rule.children) {
            (Some((Severity::Error, code, reason)), _) => findings.error(code, child, || reason.to_owned()),
            (Some((severity, code, reason)), _) => {
                findings.add_once(severity, code, tag, child, || reason.to_owned());
            }
            (None, Some(children)) => {
                // A value has an element of its own, such as <xyz> in <axis>.
                if !children.is_empty() && !tree.text(child).is_empty() {
                    findings.add_once(Severity::Warning, "stray-text", tag, child, || {
                        format!(
                            "the text {} between the elements of <{tag}> is ignored",
                            quoted(tree.text(child))
                        )
                    });
                }
                check_attributes(child, rule, findings);
                check_children(child, children, findings);
            }
            (None, None) if matches!(rule.treatment, Treatment::Silent) => {
                findings.add_unread(child, || format!("<{tag}> in <{}>", tree.tag(parent)));
                warn_unread_joint_values(child, findings);
            }
            (None, None) => {}
        }
    }
}

/// Warns about an unknown element, as libsdformat does. Elements with a prefix are extensions of other programs.
fn warn_unknown(element: ElementId, rules: &'static [ElementRule], findings: &mut Findings<'_>) {
    let tag = findings.tree.tag(element);
    if tag == "experimental:params" {
        findings.error("unsupported", element, || {
            "changes of an included model (experimental:params) are not read, and the answer without them would be wrong; write them \
             into the model"
                .to_owned()
        });
    } else if tag.contains(':') && !tag.starts_with("drake:") {
        findings.add_unread(element, || format!("<{}>", shortened(tag)));
        warn_unread_joint_values(element, findings);
    } else {
        findings.add_once(Severity::Warning, "unknown-element", tag, element, || {
            let guess = similar_name(tag, listed_tags(rules));
            format!("unknown element <{}> is ignored{guess}", shortened(tag))
        });
    }
}

/// Warns about armatures, inertias of rotors and couplings in a part that is not read.
fn warn_unread_joint_values(part: ElementId, findings: &mut Findings<'_>) {
    let tree = findings.tree;
    let holder = tree.tag(part);
    let mut open = vec![part];
    while let Some(element) = open.pop() {
        open.extend(tree.children(element));
        let attributes = tree.element(element).attributes.iter().map(|a| (&*a.name, &*a.value));
        let (tag, text) = (tree.tag(element), tree.text(element));
        let keyed = keyed_value(tag, |name| tree.attribute(element, name), text);
        let own = [(tag, text)].into_iter().chain(keyed);
        for (name, value) in attributes.filter(|(name, _)| *name != "name").chain(own) {
            if changes_joint(name, value, holder == "plugin") {
                let kind = format!("{holder} {name}");
                findings.add_once(Severity::Warning, "ignored", &kind, element, || {
                    unread_joint_message(name, holder)
                });
            }
        }
    }
}

/// Warns about unknown attributes.
fn check_attributes(element: ElementId, rule: &'static ElementRule, findings: &mut Findings<'_>) {
    let tag = findings.tree.tag(element);
    for attribute in &findings.tree.element(element).attributes {
        let name = attribute.name.as_str();
        if rule.attribute(name).is_none() {
            let kind = format!("{tag} {name}");
            findings.add_once(Severity::Warning, "unknown-attribute", &kind, element, || {
                let guess = similar_name(name, rule.attribute_names());
                format!("<{tag}>: unknown attribute \"{}\" is ignored{guess}", shortened(name))
            });
        }
    }
}
