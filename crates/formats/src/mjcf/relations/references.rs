//! Elements named by constraints and actuators.

use crate::mjcf::bodies::body::{Bodies, JointType, Site};
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::quoted;
use std::collections::HashMap;

/// Body and position in its list of joints.
pub(crate) type JointKey = (usize, usize);

/// Search for named elements, with errors for unknown names.
pub(crate) struct References<'b> {
    pub bodies: &'b Bodies,
}

impl<'b> References<'b> {
    /// True for a name that only elements within a `<replicate>` have, with a suffix.
    pub fn is_replicated(&self, name: &str) -> bool {
        self.bodies.replicated_names.contains_key(name)
    }

    /// Index of the body with a name; an unknown name is an error at `attribute`, as for the other elements.
    pub fn body(
        &self,
        name: &str,
        element: ElementId,
        attribute: &'static str,
        findings: &mut Findings<'_>,
    ) -> Option<usize> {
        self.find((&self.bodies.body_by_name, "body"), name, (element, attribute), findings).copied()
    }

    /// Site with a name.
    pub fn site(
        &self,
        name: &str,
        element: ElementId,
        attribute: &'static str,
        findings: &mut Findings<'_>,
    ) -> Option<&'b Site> {
        self.find((&self.bodies.sites, "site"), name, (element, attribute), findings)
    }

    /// Joint with a name.
    pub fn joint(
        &self,
        name: &str,
        element: ElementId,
        attribute: &'static str,
        findings: &mut Findings<'_>,
    ) -> Option<JointKey> {
        self.find((&self.bodies.joint_by_name, "joint"), name, (element, attribute), findings).copied()
    }

    /// Entry of a table of elements of one kind.
    fn find<T>(
        &self,
        (table, kind): (&'b HashMap<String, T>, &str),
        name: &str,
        (element, attribute): (ElementId, &'static str),
        findings: &mut Findings<'_>,
    ) -> Option<&'b T> {
        let found = table.get(name);
        if found.is_none() {
            let names = table.keys().map(String::as_str);
            self.report_unknown(kind, name, element, attribute, names, findings);
        }
        found
    }

    /// Hinge or slide with a name.
    pub fn scalar_joint(
        &self,
        name: &str,
        element: ElementId,
        attribute: &'static str,
        findings: &mut Findings<'_>,
    ) -> Option<JointKey> {
        let key = self.joint(name, element, attribute, findings)?;
        if matches!(self.bodies.joint(key).kind, JointType::Hinge | JointType::Slide) {
            return Some(key);
        }
        findings.attribute_error("joint-kind", element, attribute, || {
            format!("the joint {} is neither a hinge nor a slide", quoted(name))
        });
        None
    }

    fn report_unknown<'n>(
        &self,
        kind: &str,
        name: &str,
        element: ElementId,
        attribute: &'static str,
        names: impl Iterator<Item = &'n str>,
        findings: &mut Findings<'_>,
    ) {
        let is_replicated = self.is_replicated(name);
        findings.attribute_error("unknown-reference", element, attribute, || {
            if is_replicated {
                return format!(
                    "the {kind} {} is in a <replicate>; elements that refer to it are not replicated: write one for each copy, \
                     with its full name, such as {}",
                    quoted(name),
                    quoted(&format!("{name}0"))
                );
            }
            format!("the {kind} {} does not exist{}", quoted(name), similar_name(name, names))
        });
    }
}
