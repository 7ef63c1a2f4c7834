//! Elements named by constraints and actuators.

use crate::mjcf::bodies::body::{Bodies, JointType, Site};
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::quoted;
use std::collections::HashMap;

/// Body and position in its list of joints.
pub(crate) type JointKey = (usize, usize);

/// Element that refers to another, and its attribute.
pub(crate) type Referrer = (ElementId, &'static str);

/// Search for named elements, with errors at the attribute for unknown names.
impl Bodies {
    /// True for a name that only elements within a `<replicate>` have, with a suffix.
    pub fn is_replicated(&self, name: &str) -> bool {
        self.replicated_names.contains_key(name)
    }

    /// Index of the body with a name.
    pub fn body_named(&self, name: &str, at: Referrer, findings: &mut Findings<'_>) -> Option<usize> {
        self.find_named(&self.body_by_name, "body", name, at, findings).copied()
    }

    /// Site with a name.
    pub fn site_named(&self, name: &str, at: Referrer, findings: &mut Findings<'_>) -> Option<&Site> {
        self.find_named(&self.sites, "site", name, at, findings)
    }

    /// Joint with a name.
    pub fn joint_named(&self, name: &str, at: Referrer, findings: &mut Findings<'_>) -> Option<JointKey> {
        self.find_named(&self.joint_by_name, "joint", name, at, findings).copied()
    }

    /// Hinge or slide with a name.
    pub fn scalar_joint_named(
        &self,
        name: &str,
        at: Referrer,
        findings: &mut Findings<'_>,
    ) -> Option<JointKey> {
        let key = self.joint_named(name, at, findings)?;
        if matches!(self.joint(key).kind, JointType::Hinge | JointType::Slide) {
            return Some(key);
        }
        findings.attribute_error("joint-kind", at.0, at.1, || {
            format!("the joint {} is neither a hinge nor a slide", quoted(name))
        });
        None
    }

    /// Entry of a table of elements of one kind.
    fn find_named<'b, T>(
        &self,
        table: &'b HashMap<String, T>,
        kind: &str,
        name: &str,
        (element, attribute): Referrer,
        findings: &mut Findings<'_>,
    ) -> Option<&'b T> {
        let found = table.get(name);
        if found.is_none() {
            findings.attribute_error("unknown-reference", element, attribute, || {
                let shown = quoted(name);
                if self.is_replicated(name) {
                    return format!(
                        "the {kind} {shown} is in a <replicate>; elements that refer to it are not replicated: write one for each \
                         copy, with its full name, such as {}",
                        quoted(&format!("{name}0"))
                    );
                }
                format!("the {kind} {shown} does not exist{}", similar_name(name, table.keys().map(String::as_str)))
            });
        }
        found
    }
}
