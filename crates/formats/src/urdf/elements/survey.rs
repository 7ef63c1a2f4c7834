//! Comparison of the file with the table of the dialect.

use crate::reading::document::grammar::{ElementRule, Treatment, listed_tags, tags};
use crate::reading::plugins::{changes_joint, keyed_value, unread_joint_message};
use crate::reading::report::{Place, Report, shortened};
use crate::reading::xml::{Node, text_of};
use crate::urdf::elements::dialect::GAZEBO_JOINT;
use percuss_mechanism::{Severity, near_names};

/// Namespaces of xacro macros.
const XACRO: [&str; 4] = [
    "http://www.ros.org/wiki/xacro",
    "http://ros.org/wiki/xacro",
    "http://wiki.ros.org/xacro",
    "http://www.ros.org/xacro",
];

/// Language of an element's tag.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Language {
    /// URDF: no namespace, or the namespace of the root element.
    Urdf,
    /// Extensions of Drake.
    Drake,
    /// Any other language.
    Foreign,
}

/// Language of a tag, from its namespace.
pub(crate) fn tag_language(node: Node<'_>) -> Language {
    match node.tag_name().namespace() {
        None => Language::Urdf,
        Some(uri)
            if node
                .ancestors()
                .filter(Node::is_element)
                .last()
                .is_some_and(|root| root.tag_name().namespace() == Some(uri)) =>
        {
            Language::Urdf
        }
        Some(uri) if uri.contains("drake") => Language::Drake,
        Some(_) => Language::Foreign,
    }
}

/// True if the element has this tag of the table; `drake:` is the prefix of Drake's namespace.
pub(crate) fn is_named(node: Node<'_>, tag: &str) -> bool {
    let local_name = node.tag_name().name();
    match tag.strip_prefix("drake:") {
        Some(name) => local_name == name && tag_language(node) == Language::Drake,
        None => local_name == tag && tag_language(node) == Language::Urdf,
    }
}

/// Child elements with this tag.
pub(crate) fn children<'a>(node: Node<'a>, tag: &'static str) -> impl Iterator<Item = Node<'a>> {
    node.children().filter(move |c| c.is_element() && is_named(*c, tag))
}

/// First child element with this tag.
pub(crate) fn child<'a>(node: Node<'a>, tag: &'static str) -> Option<Node<'a>> {
    children(node, tag).next()
}

/// True if a value has an unexpanded xacro expression, `${…}` or `$(…)`.
pub(crate) fn has_xacro_substitution(value: &str) -> bool {
    value.contains("${") || value.contains("$(")
}

/// Reports the first unexpanded xacro element; in a `<visual>` or `<collision>`, where it has no effect, as a warning.
pub(crate) fn report_xacro_elements(root: Node<'_>, report: &mut Report) {
    let is_macro = |n: &Node<'_>| n.tag_name().namespace().is_some_and(|uri| XACRO.contains(&uri));
    let in_shape = |n: &Node<'_>| n.ancestors().any(|n| is_named(n, "visual") || is_named(n, "collision"));
    let macros = || root.descendants().filter(|n| n.is_element() && is_macro(n));
    let tag = |node: Node<'_>| format!("<xacro:{}>", shortened(node.tag_name().name()));
    if let Some(node) = macros().find(|n| !in_shape(n)) {
        report.add_xacro_error(Place::Element(node), &tag(node));
    } else if let Some(node) = macros().next() {
        report.warning("xacro", Place::Element(node), || {
            format!("{} was not expanded by xacro; it is part of a shape, and is ignored", tag(node))
        });
    }
}

/// Applies the table to an element, its attributes and its descendants. The depth of recursion is the depth of the table. `tag`: tag of
/// the element in the table.
pub(crate) fn check_element(node: Node<'_>, (tag, rule): (&'static str, &ElementRule), report: &mut Report) {
    check_attributes(node, (tag, rule), report);
    let children = rule.children.unwrap_or_default();
    let mut seen = Vec::new();
    for child in node.children() {
        if child.is_text() {
            warn_stray_text(node, child, report);
        }
        if !child.is_element() {
            continue;
        }
        let Some((found_tag, found)) = tags(children).find(|(tag, _)| is_named(child, tag)) else {
            match tag_language(child) {
                Language::Urdf | Language::Drake => warn_unknown_element(child, (tag, rule), report),
                Language::Foreign
                    if child.tag_name().namespace().is_some_and(|uri| uri.contains("XInclude")) =>
                {
                    report.warning("unknown-element", Place::Element(child), || {
                        "an <include> of another file is not read: write its contents into this file"
                            .to_owned()
                    });
                }
                Language::Foreign => {
                    report.add_unread(Place::Element(child), || {
                        format!("<{}> of another program", shortened(child.tag_name().name()))
                    });
                    warn_unread_joint_values(child, report);
                }
            }
            continue;
        };
        if found.single && seen.contains(&found_tag) {
            report_duplicate(node, child, report);
        } else if found.single {
            seen.push(found_tag);
        }
        apply_treatment(child, (found_tag, found), report);
    }
}

/// Reports a second element where only one is allowed; a warning if it has no effect, or is accepted.
fn report_duplicate(parent: Node<'_>, second: Node<'_>, report: &mut Report) {
    let tag = second.tag_name().name();
    let is_inertial = tag == "inertial";
    let (severity, remedy) = if is_inertial && report.accepted().second_inertial {
        (Severity::Warning, "; the first one is taken (accepted)")
    } else if is_fixed_joint(parent) && tag != "origin" && tag != "parent" && tag != "child" {
        (Severity::Warning, "; the joint is fixed, and it has no effect")
    } else if is_inertial {
        (Severity::Error, "; remove one, or take the first with --accept second-inertial")
    } else {
        (Severity::Error, "")
    };
    report.add(severity, "duplicate-element", Place::Element(second), || {
        format!("a second <{tag}>; only one is allowed, and which of them counts is not said{remedy}")
    });
}

/// True for a `<joint>` without motion.
pub(crate) fn is_fixed_joint(node: Node<'_>) -> bool {
    is_named(node, "joint") && node.attribute("type") == Some("fixed")
}

/// Applies the treatment of the table to an element.
fn apply_treatment(node: Node<'_>, (tag, rule): (&'static str, &ElementRule), report: &mut Report) {
    let place = Place::Element(node);
    match (rule.treatment.finding(text_of(node).unwrap_or_default()), rule.treatment) {
        (Some((Severity::Error, code, reason)), _) => report.error(code, place, || reason.to_owned()),
        (Some((severity, code, reason)), _) => {
            let lead = if severity == Severity::Warning { format!("<{tag}>: ") } else { String::new() };
            report.add_once(severity, code, tag.to_owned(), place, || format!("{lead}{reason}"));
        }
        (None, Treatment::Read) => {
            if tag == "gazebo" {
                check_gazebo_joints(node, report);
            }
            check_element(node, (tag, rule), report);
        }
        (None, Treatment::Silent) if ["visual", "collision"].contains(&tag) => {
            list_unread_children(node, report);
        }
        (None, Treatment::Silent | Treatment::Unlisted) => {
            report.add_unread(place, || format!("<{tag}> in <{}>", parent_tag(node)));
            warn_unread_joint_values(node, report);
        }
        (None, Treatment::Unexamined) if tag == "axis" => warn_unread_joint_values(node, report),
        (None, _) => {}
    }
}

/// Warns about armatures, inertias of rotors and couplings in a part that is not read: elements, attributes and named parameters.
fn warn_unread_joint_values(part: Node<'_>, report: &mut Report) {
    // `simulator_couplings.rs` reads the mimics of both.
    let in_plugin = is_named(part, "plugin") || is_named(part, "axis");
    for node in part.descendants().filter(Node::is_element) {
        let text = text_of(node).unwrap_or_default();
        let parameter = keyed_value(node.tag_name().name(), |name| node.attribute(name), text);
        let own = (node != part).then_some((node.tag_name().name(), text));
        let attributes = node.attributes().filter(|a| a.name() != "name").map(|a| (a.name(), a.value()));
        for (name, value) in attributes.chain(own).chain(parameter) {
            if changes_joint(name, value, in_plugin) {
                let holder = part.tag_name().name();
                report.add_once(
                    Severity::Warning,
                    "ignored",
                    format!("{holder} {name}"),
                    Place::Element(node),
                    || unread_joint_message(name, holder),
                );
            }
        }
    }
}

/// Children of `<geometry>` that `shapes.rs` reads.
const SOLIDS: [&str; 5] = ["box", "sphere", "cylinder", "capsule", "mesh"];

/// Adds the children of a `<visual>` or `<collision>` that are not read, such as `<material>`, to the list of unread parts.
fn list_unread_children(holder: Node<'_>, report: &mut Report) {
    for part in holder.children().filter(Node::is_element) {
        let tag = part.tag_name().name();
        let unread = match tag {
            "origin" => None,
            "geometry" => part
                .children()
                .filter(Node::is_element)
                .find(|shape| !SOLIDS.contains(&shape.tag_name().name())),
            _ => Some(part),
        };
        if let Some(unread) = unread {
            let (tag, parent) = (unread.tag_name().name(), parent_tag(unread));
            report.add_unread(Place::Element(unread), || format!("<{}> in <{parent}>", shortened(tag)));
        }
    }
}

/// Tag of the parent of an element.
fn parent_tag<'a>(node: Node<'a>) -> &'a str {
    node.parent_element().map_or("", |parent| parent.tag_name().name())
}

/// Applies the treatments of the table to the attributes of an element.
fn check_attributes(node: Node<'_>, (tag, rule): (&'static str, &ElementRule), report: &mut Report) {
    for attribute in node.attributes() {
        let (name, value) = (attribute.name(), attribute.value());
        let place = Place::Attribute(node, name);
        let treatment = rule.attribute(name);
        if attribute.namespace().is_some() {
            if matches!(treatment, Some(Treatment::Read)) {
                report.add_once(Severity::Warning, "unknown-attribute", format!("{tag}:{name}"), place, || {
                    format!("the attribute {name} of another language is read as {name} of URDF: remove its prefix, or the attribute")
                });
            } else if changes_joint(name, value, false) {
                report.add_once(Severity::Warning, "ignored", format!("{tag}:{name}"), place, || {
                    unread_joint_message(name, tag)
                });
            }
            continue;
        }
        match (treatment.and_then(|treatment| treatment.finding(value)), treatment) {
            (Some((Severity::Warning, code, reason)), _) => {
                report.warning(code, place, || format!("{name}=\"{}\": {reason}", shortened(value)));
            }
            (Some((severity, code, reason)), _) => report.add(severity, code, place, || reason.to_owned()),
            (None, Some(Treatment::Read)) if has_xacro_substitution(value) => {
                report.add_xacro_error(place, &format!("{name}=\"{}\"", shortened(value)));
            }
            (None, Some(Treatment::Silent)) => report.add_unread(place, || format!("{name} of <{tag}>")),
            (None, Some(_)) => {}
            (None, None) => {
                let shown = shortened(name);
                let kind = format!("{tag} {shown}");
                report.add_once(Severity::Warning, "unknown-attribute", kind, place, || {
                    let near = near_names(name, rule.attribute_names());
                    let guess = near.first().map(|n| format!("; did you mean \"{n}\"?")).unwrap_or_default();
                    format!("unknown attribute \"{shown}\" is ignored{guess}")
                });
            }
        }
    }
}

/// Warns about an element that the table does not contain, with a similar name.
fn warn_unknown_element(node: Node<'_>, (parent, rule): (&'static str, &ElementRule), report: &mut Report) {
    let name = node.tag_name().name();
    let prefix = if tag_language(node) == Language::Drake { "drake:" } else { "" };
    let shown = format!("{prefix}{}", shortened(name));
    let kind = format!("{parent} {shown}");
    report.add_once(Severity::Warning, "unknown-element", kind, Place::Element(node), || {
        let known = listed_tags(rule.children.unwrap_or_default()).filter(|n| !n.starts_with("drake:"));
        let guess =
            near_names(name, known).first().map(|n| format!("; did you mean <{n}>?")).unwrap_or_default();
        format!("unknown element <{shown}> is ignored{guess}")
    });
}

/// Warns about text between elements. URDF gives values in attributes; `<mass>5</mass>` belongs to other formats.
fn warn_stray_text(parent: Node<'_>, text: Node<'_>, report: &mut Report) {
    let words = text.text().unwrap_or_default().trim_ascii();
    if !words.is_empty() {
        let kind = parent.tag_name().name().to_owned();
        report.add_once(Severity::Warning, "stray-text", kind, Place::Element(parent), || {
            format!("the text \"{}\" is ignored; URDF gives values in attributes", shortened(words))
        });
    }
}

/// Checks the joints in a `<gazebo>`, which close loops. Other settings of simulators have no effect here.
fn check_gazebo_joints(gazebo: Node<'_>, report: &mut Report) {
    for joint in children(gazebo, "joint") {
        if is_gazebo_joint(joint) {
            check_element(joint, ("joint", &GAZEBO_JOINT), report);
        } else {
            refuse_gazebo_joint(joint, report, || {
                "it belongs in a <gazebo> of <robot> that has no attribute \"reference\"".to_owned()
            });
        }
    }
}

/// True for a `<joint>` in a `<gazebo>` of the whole robot. Only such joints are read.
pub(crate) fn is_gazebo_joint(node: Node<'_>) -> bool {
    let of_robot = |gazebo: Node<'_>| {
        is_named(gazebo, "gazebo")
            && !gazebo.has_attribute("reference")
            && gazebo.parent().is_some_and(|robot| robot.parent().is_some_and(|root| root.is_root()))
    };
    is_named(node, "joint") && node.parent().is_some_and(of_robot)
}

/// Reports an unreadable joint as an error: without the joint, the mechanism would be a different one.
pub(crate) fn refuse_gazebo_joint(node: Node<'_>, report: &mut Report, reason: impl FnOnce() -> String) {
    report.error("gazebo-joint", Place::Element(node), || {
        format!(
            "this joint inside <gazebo> closes a loop and is not read: {}. Correct it, or write the loop \
             as a <loop> and \
             remove it here",
            reason()
        )
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::urdf::elements::dialect::ROBOT;

    /// Messages of the warnings about a text, each with its XML path.
    fn warnings(text: &str) -> Vec<String> {
        let document = roxmltree::Document::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let mut report = Report::default();
        check_element(document.root_element(), ("robot", &ROBOT), &mut report);
        let found = report.finish("", text).into_iter().filter(|d| d.severity == Severity::Warning);
        found.map(|d| d.message).collect()
    }

    /// Inserts every element and attribute with a warning, and an unknown one, below the elements of `path`; counts them.
    fn insert_names(path: &[&str], rule: &ElementRule, count: &mut usize) {
        let mut insert = |name: &str, element: &str| {
            let holders = path[1..].iter().map(|tag| format!("<{tag}>")).collect::<String>();
            let ends = path[1..].iter().rev().map(|tag| format!("</{tag}>")).collect::<String>();
            let text =
                format!("<robot xmlns:drake=\"http://drake.mit.edu\">{holders}{element}{ends}</robot>");
            assert!(
                warnings(&text).iter().any(|message| message.contains(name)),
                "{text}: {:?}",
                warnings(&text)
            );
            *count += 1;
        };
        insert("unheard_of", "<unheard_of/>");
        let is_warned =
            |treatment: Treatment| matches!(treatment.finding("1"), Some((Severity::Warning, ..)));
        let is_read = |rule: &ElementRule| matches!(rule.treatment, Treatment::Read);
        let children = rule.children.unwrap_or_default();
        for (tag, child) in tags(children) {
            if is_warned(child.treatment) {
                insert(tag, &format!("<{tag}>1</{tag}>"));
            }
            if is_read(child) {
                insert("unheard_of", &format!("<{tag} unheard_of=\"1\"/>"));
            }
            for name in child.attribute_names() {
                if child.attribute(name).is_some_and(is_warned) {
                    insert(name, &format!("<{tag} {name}=\"1\"/>"));
                }
            }
        }
        for (tag, child) in tags(children).filter(|(_, child)| is_read(child)) {
            insert_names(&[path, &[tag]].concat(), child, count);
        }
    }

    #[test]
    fn every_name_without_effect_here_is_in_a_warning() {
        let mut count = 0;
        insert_names(&["robot"], &ROBOT, &mut count);
        insert_names(&["robot", "gazebo", "joint"], &GAZEBO_JOINT, &mut count);
        assert!(count > 120, "{count}");
    }
}
